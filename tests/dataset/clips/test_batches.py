"""Rendering with the batches of a dataset: resuming, failures, full disks, finished datasets."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
import errno
import json
from pathlib import Path
import tarfile

import numpy as np
import pytest

from esg import stages
from esg.commands.datasets import adding as adding_command
from esg.commands.datasets.adding import render_dataset
from esg.commands.datasets.clips import BatchOptions, RenderOptions
from esg.dataset import running as module
from esg.dataset.batch import make_batch
from esg.dataset.clips import adding as adding_module
from esg.dataset.clips import subjects
from esg.dataset.clips.encoding import ChannelFile
from esg.dataset.clips.reading import read_clips
from esg.dataset.clips.rendering import Replay
from esg.dataset.finish import finish
from esg.dataset.folder import DatasetFolder
from esg.dataset.job import BatchJob, BatchResult
from esg.dataset.layouts.building import add_layouts, missing_layouts, want_layouts
from esg.dataset.plan import DatasetSpec, Prompt, RenderSpec, plan_scenes
from esg.dataset.running import mark_dead
from esg.engines.scene import Rollout
from esg.outcomes import UserError
from esg.store.tables import part_files, read_table
from tests.dataset import fakes
from tests.dataset.clips import stand_ins
from tests.dataset.clips.stand_ins import FRAMES, SPEC, media
from tests.dataset.test_batch import below, dataset


@pytest.fixture(autouse=True)
def quick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Fake stages and replays, in this process."""
    for name in fakes.STAGES:
        monkeypatch.setitem(stages.SPECS, name, stages.SPECS[name])
    monkeypatch.setattr(stages, "conclude", stages.conclude)
    monkeypatch.setenv("ESG_TEST_CALLS", str(tmp_path / "calls"))
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.setattr(module, "PAUSES_S", (0.0, 0.0))
    monkeypatch.setattr(module, "_compile_together", nothing)
    monkeypatch.setattr(stages, "load_doc", nothing)
    monkeypatch.setattr(adding_command, "make_batches", one_by_one)
    fakes.install()
    stand_ins.install(monkeypatch)
    yield


def nothing(_: object) -> None:
    return None


def one_by_one(jobs: list[BatchJob], *_: object) -> list[BatchResult]:
    return [make_batch(job) for job in jobs]


def build(out: Path, texts: list[str], render: RenderSpec | None = SPEC) -> None:
    jobs = dataset(out, texts, render=render)
    results = {job.number: make_batch(job) for job in jobs}
    finish(DatasetFolder(out), jobs[0].spec, results)


def failures(out: Path) -> dict[str, tuple[str, str]]:
    path = out / "failures.jsonl"
    rows = [json.loads(t) for t in path.read_text().splitlines()] if path.exists() else []
    return {r["prompt"]: (r["outcome"], r["stage"]) for r in rows}


def test_every_replayed_scene_gets_its_clips(tmp_path: Path) -> None:
    out = tmp_path / "a"
    build(out, ["balls", "a bug"])
    clips = list(read_clips(out))
    assert [(c.record.scene_id, c.record.camera) for c in clips] == [("0000000", 0), ("0000000", 1)]
    assert failures(out) == {"a bug": ("crashed", "layout")}
    record = clips[0].record
    assert (record.n_frames, record.width, record.height) == (FRAMES, 32, 24)
    assert record.time_s == pytest.approx(np.arange(FRAMES) / 4)
    assert [o.id for o in record.objects] == [2, 3, 4]
    for clip in clips:
        assert all(len(clip.frames(f.channel)) == FRAMES for f in clip.record.files)
    assert "--render rgb,depth" in (out / "README.md").read_text()
    assert not list(out.rglob("*.tmp"))
    assert json.loads((out / "meta" / "timings.json").read_text())["seconds"]["render"] > 0


def test_channels_fit_together(tmp_path: Path) -> None:
    """Depth, camera and poses say where the pixels' surfaces are: so do all other channels."""
    out = tmp_path / "a"
    build(out, ["balls"])
    clip = next(read_clips(out))
    r, k = clip.record, clip.record.intrinsics
    depth, ids = clip.frames("depth").astype(float), clip.frames("segmentation")
    x, y = np.meshgrid(np.arange(r.width) + 0.5, np.arange(r.height) + 0.5)
    rays = np.stack([(x - k.cx) / k.fx, (y - k.cy) / k.fy, np.ones_like(x)], axis=-1)
    places, normal = clip.frames("object_coordinates"), clip.frames("normal")
    forward, backward = clip.frames("flow"), clip.frames("backward_flow")
    assert np.isnan(forward[-1]).all() and np.isnan(backward[0]).all()
    met = 0
    for at in range(FRAMES):
        turn = _matrix(r.camera_quaternion_xyzw[at])
        world = (rays * depth[at][..., None]) @ turn.T + r.camera_position_m[at]
        for index, thing in enumerate(r.objects):
            mask = ids[at] == thing.id
            met += int(mask.sum())
            offset = world[mask] - r.object_position_m[at, index]
            # Spheres of 0.1 m, of 320 faces: their surface is up to 2 mm inside.
            assert np.abs(np.linalg.norm(offset, axis=-1) - 0.1).max(initial=0.0) < 3e-3
            cosine = (normal[at][mask] * offset).sum(axis=-1) / 0.1
            assert cosine.min(initial=1.0) > 0.9
            low, high = r.object_bounds_m[index]
            local = low + places[at][mask] * (high - low)
            back = offset @ _matrix(r.object_quaternion_xyzw[at, index])
            assert np.abs(local - back).max(initial=0.0) < 1e-3
            if at + 1 < FRAMES:
                later = r.object_position_m[at + 1, index] + offset
                moved = (later - r.camera_position_m[at + 1]) @ _matrix(
                    r.camera_quaternion_xyzw[at + 1]
                )
                pixels = moved[:, :2] / moved[:, 2:] * (k.fx, k.fy) + (k.cx, k.cy)
                here = np.stack([x, y], axis=-1)[mask]
                assert np.abs(forward[at][mask] - (pixels - here)).max(initial=0.0) < 0.05
    assert met >= 50
    assert (forward[0][ids[0] == 1] == 0).all() and not np.isnan(forward[:-1]).any()
    ways = [(np.nansum(forward[:-1], axis=(0, 1, 2)), np.nansum(backward[1:], axis=(0, 1, 2)))]
    assert np.sign(ways[0][0][0]) == -np.sign(ways[0][1][0]) != 0


def _matrix(q: np.ndarray) -> np.ndarray:
    from scipy.spatial.transform import Rotation

    return Rotation.from_quat(q).as_matrix()


def test_boxes_and_tracks_lie_on_what_is_seen(tmp_path: Path) -> None:
    out = tmp_path / "a"
    build(out, ["balls"])
    clip = next(read_clips(out))
    ids = clip.frames("segmentation")
    for box in clip.record.boxes2d:
        mask = ids[box["frame"]] == box["id"]
        assert mask.sum() == box["visible_px"]
        rows, columns = np.nonzero(mask)
        found = (columns.min(), rows.min(), columns.max() + 1, rows.max() + 1)
        assert found == (box["x0"], box["y0"], box["x1"], box["y1"])
    r = clip.record
    assert len(r.boxes3d) == FRAMES * 3 and r.track_xy_px.shape == (FRAMES, 48, 2)
    for at, point in zip(*np.nonzero(r.track_visible), strict=True):
        x, y = np.floor(r.track_xy_px[at, point]).astype(int)
        assert ids[at, y, x] == r.track_ids[point]
    assert r.track_visible.any()


@pytest.mark.parametrize("after", range(1, 4))
def test_killed_while_rendering_it_goes_on_to_the_same_bytes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, after: int
) -> None:
    texts = ["balls", "more balls"]
    build(tmp_path / "whole", texts)
    jobs = dataset(tmp_path / "cut", texts, render=SPEC)
    closed, real = [0], ChannelFile.close

    def dies(self: ChannelFile) -> None:
        closed[0] += 1
        if closed[0] == 10 * after:
            raise KeyboardInterrupt
        real(self)

    with monkeypatch.context() as patch:
        patch.setattr(ChannelFile, "close", dies)
        with pytest.raises(KeyboardInterrupt):
            make_batch(jobs[0])
    rendered = stand_ins.note_scenes(monkeypatch)
    results = {0: make_batch(jobs[0])}
    finish(DatasetFolder(tmp_path / "cut"), jobs[0].spec, results)
    assert rendered == (texts if after < 3 else texts[1:])
    assert media(tmp_path / "cut") == media(tmp_path / "whole")
    assert below(tmp_path / "cut") == below(tmp_path / "whole")


def test_a_scene_that_cannot_be_rendered_is_told_and_stops_nobody(tmp_path: Path) -> None:
    out = tmp_path / "a"
    build(out, ["blind balls", "balls"])
    assert failures(out) == {"blind balls": ("not_rendered", "render")}
    assert "no mesh for a unicorn" in (out / "failures.jsonl").read_text()
    assert "ValueError" in (out / "meta" / "crashes.jsonl").read_text()
    assert {c.record.scene_id for c in read_clips(out)} == {"0000001"}
    rows = [r for p in part_files(out, "scenes") for r in read_table(p).to_pylist()]
    assert [r["outcome"] for r in rows] == ["solved", "solved"]


def test_a_scene_that_ends_its_worker_while_rendered_is_left_out(tmp_path: Path) -> None:
    (job,) = dataset(tmp_path / "a", ["balls", "more balls"], render=SPEC)
    job.work.mkdir(parents=True)
    (job.work / "reached").write_text("render")
    mark_dead(job, 1, "it died")
    result = make_batch(job)
    assert [(f["scene"], f["stage"], f["reason"]) for f in result.failures] == [
        ("0000001", "render", "it died")
    ]
    assert result.outcomes == {"solved": 2}


def test_a_full_disk_leaves_finished_batches_and_nothing_half_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    texts = [f"balls {k}" for k in range(8)]
    first, second = dataset(tmp_path / "a", texts, render=SPEC)
    make_batch(first)
    before = media(tmp_path / "a")

    def full(self: ChannelFile, frames: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(ChannelFile, "add", full)
        with pytest.raises(OSError, match="free some space"):
            make_batch(second)
    assert media(tmp_path / "a") == before
    assert not list((tmp_path / "a" / "clips").glob(".*"))
    assert make_batch(second).failures == []


def told(monkeypatch: pytest.MonkeyPatch) -> None:
    """Replays out of tables, without the place, which these documents do not have."""
    real = subjects.rollout_of

    def play(folder: Path, row: dict[str, object]) -> Replay:
        (moved,) = [
            r for p in part_files(folder, "trajectories") for r in read_table(p).to_pylist()
            if r["scene_key"] == row["scene_key"]
        ]  # fmt: skip
        scene = stand_ins.chain(0.4, 0.8).scene
        return Replay(scene, real(moved), None, stand_ins.document(str(row["prompt"])))

    monkeypatch.setattr(subjects, "_told", play)


OPTIONS = RenderOptions(",".join(SPEC.channels), 2, "32x24", 4.0, camera="around")


def add(out: Path, options: RenderOptions = OPTIONS, **more: object) -> int:
    batches = BatchOptions(batch=2, **more)  # type: ignore[arg-type]
    return render_dataset(str(out), options, batches, "cpu", {}, as_json=False)


@pytest.mark.slow
def test_a_finished_dataset_gets_the_clips_it_would_have_had(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    texts = [f"balls {k}" for k in range(5)]
    build(tmp_path / "whole", texts)
    build(tmp_path / "later", texts, render=None)
    told(monkeypatch)
    assert add(tmp_path / "later") == 0
    assert "5 of 5 scenes rendered by 2 cameras" in capsys.readouterr().out
    for one, two in zip(*(read_clips(tmp_path / n) for n in ("whole", "later")), strict=True):
        assert one.record.scene_id == two.record.scene_id
        assert np.array_equal(one.frames("depth"), two.frames("depth"))
        assert np.array_equal(one.frames("rgb"), two.frames("rgb"))
    info = json.loads((tmp_path / "later" / "meta" / "info.json").read_text())
    assert info["rows"]["clips"] == 10 and info["rows"]["scenes"] == 5
    assert not (tmp_path / "later" / "rendering").exists()
    # Nothing is left to do, and another camera is.
    rendered = stand_ins.note_scenes(monkeypatch)
    assert add(tmp_path / "later") == 0 and rendered == []
    assert add(tmp_path / "later", replace(OPTIONS, cameras=3)) == 0
    assert len(rendered) == 5 and len(list(read_clips(tmp_path / "later"))) == 15


def test_layouts_are_of_the_clips_that_a_dataset_has_now(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Tar files that were written before there was a third camera would lack it for ever."""
    out = tmp_path / "a"
    build(out, ["balls", "more balls"])
    want_layouts(out, ["webdataset"])
    add_layouts(out, ["webdataset"], print)
    told(monkeypatch)
    assert add(out, replace(OPTIONS, cameras=3)) == 0
    assert missing_layouts(out, ["webdataset"]) == []
    names: list[str] = []
    for path in (out / "layouts" / "webdataset").glob("*.tar"):
        with tarfile.open(path) as shard:
            names += shard.getnames()
    assert {n.partition(".")[0] for n in names} == {
        f"000000{scene}_camera_{camera}" for scene in (0, 1) for camera in (0, 1, 2)
    }


@pytest.mark.slow
@pytest.mark.parametrize("moment", ["render", "putting in"])
def test_adding_clips_goes_on_after_a_kill(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, moment: str
) -> None:
    texts = [f"balls {k}" for k in range(4)]
    for name in ("whole", "cut"):
        build(tmp_path / name, texts, render=None)
    told(monkeypatch)
    add(tmp_path / "whole")
    out = tmp_path / "cut"
    with monkeypatch.context() as patch:
        if moment == "render":
            calls = iter([False, False, False, True])
            real = subjects._told

            def dies(folder: Path, row: dict[str, object]) -> Replay:
                if next(calls):
                    raise KeyboardInterrupt
                return real(folder, row)

            patch.setattr(subjects, "_told", dies)
        else:
            patch.setattr(adding_module, "assemble_tables", _killed)
        with pytest.raises(KeyboardInterrupt):
            add(out)
    with pytest.raises(UserError, match="add --resume"):
        add(out)
    with pytest.raises(UserError, match="other settings"):
        add(out, replace(OPTIONS, fps=8.0), resume=True)
    rendered = stand_ins.note_scenes(monkeypatch)
    assert add(out, resume=True) == 0
    assert rendered == (["balls 3"] if moment == "render" else [])
    assert media(out) == media(tmp_path / "whole")
    assert below(out) == below(tmp_path / "whole")


def _killed(*_: object, **__: object) -> None:
    raise KeyboardInterrupt


def test_adding_tells_what_failed_and_forgets_what_works_now(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "a"
    build(out, ["blind balls", "balls", "wrong"])
    told(monkeypatch)
    assert set(failures(out)) == {"blind balls", "wrong"}
    assert add(out) == 0
    assert failures(out) == {"wrong": ("not_as_stated", "judge")}
    assert len(list(read_clips(out))) == 6


def test_mistakes_are_told_all_at_once(tmp_path: Path) -> None:
    bad = RenderOptions("rgb,dpeth", 0, "33x20", 24.0, "crayon")
    own = {"--out": True, "--seed": False}
    with pytest.raises(UserError) as told:
        render_dataset(str(tmp_path), bad, BatchOptions(shard="3/2"), "cpu", own, as_json=False)
    text = str(told.value)
    for word in ("dpeth", "--cameras 0", "even width", "crayon", "--shard", "--out: only"):
        assert word in text
    assert told.value.exit_code == 2


def test_only_finished_datasets_get_clips(tmp_path: Path) -> None:
    dataset(tmp_path / "a", ["balls"])
    with pytest.raises(UserError, match="not finished"):
        add(tmp_path / "a")


def test_clips_are_part_of_what_a_resumed_run_must_repeat(tmp_path: Path) -> None:
    with_clips = DatasetSpec(source="prompts", n=1, render=SPEC)
    without = DatasetSpec(source="prompts", n=1)
    assert with_clips.name() != without.name() and "render" not in without.canonical()
    (difference,) = with_clips.differences(without)
    assert difference.startswith("render: ")
    assert len(plan_scenes(with_clips, [Prompt(prompt="balls")])) == 1


def test_frames_that_a_recording_lacks_lie_between_those_it_has() -> None:
    """24 a second out of 60 a second, evenly; 24 out of 240 as they are."""
    from esg.view.seeing.witness import at_rate

    world = stand_ins.chain(0.4, 0.8)
    rollout: Rollout = world.rollout()
    assert at_rate(rollout, 24.0) is rollout
    coarse = subjects.rollout_of(_row(rollout, 4))
    even = at_rate(coarse, 24.0)
    assert np.diff(even.time) == pytest.approx(np.full(72, 1 / 24))
    fine = rollout.position[0, ::10]
    assert np.abs(even.position[0] - fine).max() < 2.0 / 60


def _row(rollout: Rollout, step: int) -> dict[str, object]:
    from esg.store.rows import trajectory_row

    thin = replace(
        rollout,
        time=rollout.time[::step],
        position=rollout.position[:, ::step],
        quaternion=rollout.quaternion[:, ::step],
        linear_velocity=rollout.linear_velocity[:, ::step],
        angular_velocity=rollout.angular_velocity[:, ::step],
    )
    return trajectory_row({}, "train", "physx", thin, ("ball_1", "ball_2", "ball_3"))
