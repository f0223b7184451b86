"""LeRobot v3.0, read by pandas, datasets and PyAV; by LeRobot where it is installed."""

from __future__ import annotations

import json
from pathlib import Path

import av
import numpy as np
import pyarrow.parquet as pq
import pytest

from esg.dataset.layouts.source import Sample, Source, splits
from esg.outcomes import UserError
from tests.dataset.layouts.sets import FRAMES, SIZE

FILM = "observation.images.rgb"


@pytest.fixture
def root(whole: Path) -> Path:
    return whole / "layouts" / "lerobot"


def samples(whole: Path) -> list[Sample]:
    return [s for split in splits() for s in Source(whole).samples(split, ("trajectories",))]


def read(path: Path) -> list[dict]:
    return pq.read_table(path).to_pylist()


def test_the_index_leads_to_every_episode(root, whole):
    info = json.loads((root / "meta" / "info.json").read_text())
    found = samples(whole)
    assert info["codebase_version"] == "v3.0"
    assert (info["total_episodes"], info["total_frames"]) == (len(found), len(found) * FRAMES)
    assert info["splits"] == {"train": "0:6", "validation": "6:8", "test": "8:10"}
    episodes = read(root / "meta/episodes/chunk-000/file-000.parquet")
    tasks = read(root / "meta/tasks.parquet")
    assert [t["task_index"] for t in tasks] == list(range(info["total_tasks"]))
    for episode, sample in zip(episodes, found, strict=True):
        record = sample.clip.record
        assert episode["tasks"] == [record.prompt]
        place = {k.split("/")[-1]: v for k, v in episode.items() if k.startswith("data/")}
        rows = read(root / info["data_path"].format(**place))
        rows = [r for r in rows if r["episode_index"] == episode["episode_index"]]
        assert [r["index"] for r in rows] == list(
            range(episode["dataset_from_index"], episode["dataset_to_index"])
        )
        assert tasks[rows[0]["task_index"]]["task"] == record.prompt
        assert np.allclose([r["timestamp"] for r in rows], np.arange(FRAMES) / 24.0)
        state = np.array([r["observation.state"] for r in rows]).reshape(FRAMES, -1, 13)
        assert np.array_equal(state[..., :3].astype(np.float32), record.object_position_m)
        assert all(r["observation.mask"] == [True] * 3 for r in rows)


def test_velocities_are_those_of_the_replay_at_the_times_of_the_frames(root):
    """Ball 1 rolls at 2 m/s until it hits at 0.4 s."""
    row = read(root / "data/chunk-000/file-000.parquet")[2]
    state = np.array(row["observation.state"]).reshape(-1, 13)
    assert state[0, 7:10] == pytest.approx([2.0, 0.0, 0.0], abs=1e-5)
    assert state[1, 7:10] == pytest.approx([0.0, 0.0, 0.0], abs=1e-5)


def test_films_are_the_clips_frame_by_frame(root, whole):
    info = json.loads((root / "meta" / "info.json").read_text())
    episodes = read(root / "meta/episodes/chunk-000/file-000.parquet")
    frames: dict[Path, dict[float, np.ndarray]] = {}
    for episode, sample in zip(episodes, samples(whole), strict=True):
        place = {k.split("/")[-1]: episode[k] for k in episode if k.startswith(f"videos/{FILM}/")}
        path = root / info["video_path"].format(video_key=FILM, **place)
        if path not in frames:
            with av.open(str(path)) as film:
                shown = [(f.time, f.to_ndarray(format="rgb24")) for f in film.decode(video=0)]
            frames[path] = {round(time, 4): picture for time, picture in shown}
            assert len(frames[path]) == len(shown) == info["total_frames"]
        own = sample.clip.frames("rgb")
        for k in range(FRAMES):
            time = round(episode[f"videos/{FILM}/from_timestamp"] + k / 24.0, 4)
            assert np.array_equal(frames[path][time], own[k])


def test_statistics_are_those_of_all_frames(root):
    stats = json.loads((root / "meta" / "stats.json").read_text())
    state = np.array(
        [r["observation.state"] for r in read(root / "data/chunk-000/file-000.parquet")]
    )
    for name in ("min", "max", "mean", "std"):
        expected = getattr(np, name)(state.astype(np.float64), axis=0)
        assert stats["observation.state"][name] == pytest.approx(expected, abs=1e-9)
    assert np.array(stats[FILM]["mean"]).shape == (3, 1, 1)
    assert stats[FILM]["count"] == [10]


def test_datasets_and_pandas_read_it(root):
    datasets = pytest.importorskip("datasets")
    pandas = pytest.importorskip("pandas")
    tasks = pandas.read_parquet(root / "meta" / "tasks.parquet")
    assert tasks.index.name == "task"
    assert tasks.iloc[2].name == "Ball 2 of scene 0000002 hits ball 2."
    info = json.loads((root / "meta" / "info.json").read_text())
    features = {
        name: datasets.Value(f["dtype"])
        if f["shape"] == [1]
        else datasets.Sequence(datasets.Value(f["dtype"]), length=f["shape"][0])
        for name, f in info["features"].items()
        if f["dtype"] != "video"
    }
    files = [str(p) for p in sorted(root.glob("data/*/*.parquet"))]
    found = datasets.Dataset.from_parquet(files, features=datasets.Features(features))
    assert len(found) == info["total_frames"]


def test_lerobot_reads_it(root):
    pytest.importorskip("lerobot", reason="LeRobot is not installed: it needs torch")
    from lerobot.datasets.lerobot_dataset import LeRobotDataset

    found = LeRobotDataset("local/set", root=root, video_backend="pyav")
    item = found[FRAMES + 1]
    assert found.num_episodes == 10
    assert tuple(item[FILM].shape) == (3, SIZE[1], SIZE[0])
    assert item["task"] == "Ball 0 of scene 0000000 hits ball 2."


def test_what_lerobot_cannot_hold_is_told(whole, tmp_path, monkeypatch):
    from esg.dataset.layouts import lerobot

    rows = list(
        Source(whole).clips(
            "train",
            ("prompt", "n_frames", "fps", "height", "width", "objects", "files", "scene_id"),
        )
    )
    for change, told in (
        ({"files": []}, "has no channel rgb"),
        ({"fps": 12.5}, "several sizes or rates"),
    ):
        changed = [{**rows[0], **change}, *rows[1:]]
        monkeypatch.setattr(Source, "clips", lambda self, split, columns, c=changed: c)
        with pytest.raises(UserError, match=told):
            lerobot._plan(Source(whole))
