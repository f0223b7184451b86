"""MCAP logs, read back with the mcap reader."""

from __future__ import annotations

import errno
import json
from pathlib import Path

from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory
import numpy as np
import pytest

from esg import files
from esg.engines.program import SetVelocity
from esg.engines.scene import Shape
from esg.store.mcap_log import write_mcap
from tests.metrics.test_events import CHAIN
from tests.metrics.worlds import body
from tests.store.samples import world

CUBE = tuple((float(x), float(y), float(z)) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))


def stage():
    made = world()
    made.add(body("capsule_1", Shape("capsule", (0.1, 0.1, 0.2))), y=2.0)
    made.add(body("drum_1", Shape("cylinder", (0.3, 0.3, 0.4))), y=4.0)
    made.add(body("rock_1", Shape("convex", (1, 1, 1), vertices=CUBE)), y=7.0)
    made.add(body("road_1", shapes=(), static=True), y=9.0)
    return made.run(SetVelocity("ball_1", 0.0, (2.0, 0.0, 0.0)))


def write(path: Path, **more: object) -> None:
    made = stage()
    verdict = made.judge(CHAIN)
    write_mcap(path, made.scene, made.program, made.rollout(), verdict, b'{"esg": 1}', **more)  # type: ignore[arg-type]


def test_channels_messages_attachments(tmp_path):
    path = tmp_path / "a.mcap"
    write(path)
    with path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        summary = reader.get_summary()
        assert summary is not None and summary.statistics is not None
        found = {
            c.topic: (
                summary.schemas[c.schema_id].name,
                summary.statistics.channel_message_counts[c.id],
            )
            for c in summary.channels.values()
        }
        assert found == {
            "/scene": ("foxglove.SceneUpdate", 1),
            "/tf": ("foxglove.FrameTransforms", 181),
            "/events": ("esg.Event", 4),
            "/log": ("foxglove.Log", 4),
        }
        attachments = {a.name: a.data for a in reader.iter_attachments()}
        assert attachments["esg.json"] == b'{"esg": 1}'
        assert json.loads(attachments["manifest.json"])["format"] == "esg-manifest"
        assert json.loads(attachments["verdict.json"])["completed"] == 2
        metadata = {m.name: m.metadata for m in reader.iter_metadata()}
        assert metadata["scene"]["events"] == "2/2"
        decoded = list(reader.iter_decoded_messages(topics=["/tf"]))
        last = decoded[-1].decoded_message.transforms[0]
        assert last.child_frame_id == "ball_1"
        assert last.translation.x == pytest.approx(0.8, abs=1e-6)
        assert decoded[-1].message.log_time == 3 * 10**9


def test_shapes_are_drawn_from_the_proxies(tmp_path):
    path = tmp_path / "a.mcap"
    write(path)
    with path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        update = next(reader.iter_decoded_messages(topics=["/scene"])).decoded_message
    entities = {e.id: e for e in update.entities}
    assert entities["ball_1"].spheres[0].size.x == pytest.approx(0.2)
    assert (len(entities["capsule_1"].cylinders), len(entities["capsule_1"].spheres)) == (1, 2)
    assert entities["drum_1"].cylinders[0].size.z == pytest.approx(0.8)
    rock = entities["rock_1"].triangles[0]
    assert (len(rock.points), len(rock.indices)) == (8, 36)
    points = np.array([[p.x, p.y, p.z] for p in rock.points])
    for a, b, c in np.array(rock.indices).reshape(-1, 3):
        normal = np.cross(points[b] - points[a], points[c] - points[a])
        assert normal @ points[a] > 0  # faces look outwards
    assert entities["road_1"].cubes


def test_events_carry_verdicts_and_hits_in_order(tmp_path):
    path = tmp_path / "a.mcap"
    write(path)
    with path.open("rb") as file:
        reader = make_reader(file)
        messages = [(m.log_time, json.loads(m.data)) for _, _, m in reader.iter_messages("/events")]
        schema = next(s for s in reader.get_summary().schemas.values() if s.name == "esg.Event")  # type: ignore[union-attr]
    assert [t for t, _ in messages] == sorted(t for t, _ in messages)
    assert [m["kind"] for _, m in messages] == ["hit", "event", "hit", "event"]
    assert messages[1][1]["id"] == "e1"
    import jsonschema

    for _, message in messages:
        jsonschema.validate(message, json.loads(schema.data))


def test_same_replay_same_bytes(tmp_path):
    write(tmp_path / "a.mcap")
    write(tmp_path / "b.mcap")
    assert (tmp_path / "a.mcap").read_bytes() == (tmp_path / "b.mcap").read_bytes()


def test_frame_rate_can_be_chosen(tmp_path):
    write(tmp_path / "a.mcap", fps=10.0)
    with (tmp_path / "a.mcap").open("rb") as file:
        messages = list(make_reader(file).iter_messages("/tf"))
    assert len(messages) == 31


def test_a_full_disk_leaves_no_file(tmp_path, monkeypatch):
    def full(path: Path) -> None:
        raise OSError(errno.ENOSPC, "No space left on device", str(path))

    monkeypatch.setattr(files, "sync_file", full)
    with pytest.raises(OSError, match="free some space"):
        write(tmp_path / "a.mcap")
    assert list(tmp_path.iterdir()) == []
