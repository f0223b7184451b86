"""LeRobot v3.0: an episode a clip, frames in Parquet, films in MP4, both many episodes to a file.

A frame's `observation.state` has position, attitude and velocities of every body, padded to the
scene with the most; `observation.mask` says which places are bodies. Nobody acts, so there is no
action. The format: `lerobot/datasets/{lerobot_dataset,utils}.py` of LeRobot, `CODEBASE_VERSION`
v3.0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.dataset.layouts import statistics
from esg.dataset.layouts.building import LayoutFolder
from esg.dataset.layouts.motion import states_of
from esg.dataset.layouts.source import Sample, Source, splits
from esg.outcomes import UserError

if TYPE_CHECKING:
    import pyarrow as pa

VERSION = "v3.0"
CHUNK_FILES = 1000
DATA_FILE_MB, VIDEO_FILE_MB = 100, 200
FILE = "chunk-{chunk_index:03d}/file-{file_index:03d}"
DATA = f"data/{FILE}.parquet"
VIDEO = f"videos/{{video_key}}/{FILE}.mp4"
EPISODES = f"meta/episodes/{FILE}.parquet"
FILM, STATE, MASK = "observation.images.rgb", "observation.state", "observation.mask"
_NUMBERS = ("timestamp", "frame_index", "episode_index", "index", "task_index")
_OF_A_BODY = (
    "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw", "vx_mps", "vy_mps", "vz_mps", "wx_radps",
    "wy_radps", "wz_radps",
)  # fmt: skip


@dataclass(frozen=True)
class Episode:
    """Where a clip is among all frames and files.

    Args:
        index: Of the episode.
        split, prompt: Of the scene.
        film: Its file, below the dataset's folder.
        film_bytes: Size of it.
        frames: Number of frames.
        first: Index of its first frame among all.
        bodies: Number of bodies.
    """

    index: int
    split: str
    prompt: str
    film: str
    film_bytes: int
    frames: int
    first: int
    bodies: int


@dataclass(frozen=True)
class Plan:
    """What all episodes together decide.

    Args:
        episodes: In order.
        tasks: Index by prompt, in the order of their first episodes.
        fps: Frames a second.
        size: Height and width [px].
        films, data: Episodes of every video and data file.
    """

    episodes: Sequence[Episode]
    tasks: dict[str, int]
    fps: int
    size: tuple[int, int]
    films: Sequence[Sequence[Episode]]
    data: Sequence[Sequence[Episode]]

    @property
    def bodies(self) -> int:
        """Places for bodies in a state."""
        return max(e.bodies for e in self.episodes)


def write(source: Source, folder: LayoutFolder) -> dict[str, Any]:
    """Writes films, frames and what LeRobot wants to know of them; returns counts."""
    plan = _plan(source)
    for number, episodes in enumerate(plan.films):
        files = [source.folder / e.film for e in episodes]
        name = VIDEO.format(video_key=FILM, **_place(number))
        folder.add(name, partial(_join, files, [e.frames for e in episodes], plan.fps))
    rows, totals = _frames(source, folder, plan)
    folder.add("meta/tasks.parquet", partial(_write, _tasks(plan)))
    # One file: a row an episode and statistics of it are some kilobytes.
    name = EPISODES.format(chunk_index=0, file_index=0)
    folder.add(name, partial(_write, _episode_table(plan, rows)))
    folder.add_json("meta/stats.json", totals)
    folder.add_json("meta/info.json", _info(plan))
    return {"episodes": len(plan.episodes), "frames": sum(e.frames for e in plan.episodes)}


def _plan(source: Source) -> Plan:
    episodes: list[Episode] = []
    tasks: dict[str, int] = {}
    kinds: set[tuple[float, int, int]] = set()
    first = 0
    wanted = ("prompt", "n_frames", "fps", "height", "width", "objects", "files", "scene_id")
    for split in splits():
        for row in source.clips(split, wanted):
            film = next((f for f in row["files"] if f["channel"] == "rgb"), None)
            if film is None:
                raise UserError(f"layout lerobot: clip {row['scene_id']} has no channel rgb")
            kinds.add((row["fps"], row["height"], row["width"]))
            tasks.setdefault(row["prompt"], len(tasks))
            episodes.append(
                Episode(
                    len(episodes), split, row["prompt"], film["path"], film["bytes"],
                    row["n_frames"], first, len(row["objects"]),
                )
            )  # fmt: skip
            first += row["n_frames"]
    if len(kinds) != 1:
        raise UserError(f"layout lerobot: clips have several sizes or rates: {sorted(kinds)}")
    fps, height, width = kinds.pop()
    if fps != int(fps):
        raise UserError(f"layout lerobot: {fps:g} frames a second; LeRobot knows whole numbers")
    most = max(e.bodies for e in episodes)
    frame_bytes = 4 * (len(_OF_A_BODY) + 1) * most + 40
    return Plan(
        episodes, tasks, int(fps), (height, width),
        _grouped(episodes, [e.film_bytes for e in episodes], VIDEO_FILE_MB * 10**6),
        _grouped(episodes, [e.frames * frame_bytes for e in episodes], DATA_FILE_MB * 10**6),
    )  # fmt: skip


def _grouped(episodes: Sequence[Episode], sizes: Sequence[int], most: int) -> list[list[Episode]]:
    out: list[list[Episode]] = [[]]
    size = 0
    for episode, weight in zip(episodes, sizes, strict=True):
        if out[-1] and size + weight > most:
            out.append([])
            size = 0
        out[-1].append(episode)
        size += weight
    return out


def _place(number: int) -> dict[str, int]:
    return {"chunk_index": number // CHUNK_FILES, "file_index": number % CHUNK_FILES}


def _join(paths: Sequence[Path], frames: Sequence[int], fps: int, path: Path) -> None:
    """Films one after the other in one file, as they are encoded."""
    import av

    options = {"movflags": "+faststart", "fflags": "+bitexact"}
    with av.open(str(path), "w", format="mp4", options=options) as joined:
        stream: Any = None
        start = 0
        for source, count in zip(paths, frames, strict=True):
            with av.open(str(source)) as container:
                film: Any = container.streams.video[0]
                if stream is None:
                    stream = joined.add_stream_from_template(film)
                for packet in container.demux(film):
                    if packet.dts is None or packet.pts is None:
                        continue  # the end
                    packet.pts += start
                    packet.dts += start
                    packet.stream = stream
                    joined.mux(packet)
                start += round(count / fps / film.time_base)


def _frames(
    source: Source, folder: LayoutFolder, plan: Plan
) -> tuple[list[dict[str, Any]], dict[str, Any]]:
    """Writes the data files; returns statistics by episode, flat, and of all."""
    rows: list[dict[str, Any]] = []
    total = statistics.Total()
    samples = _samples(source)
    for number, episodes in enumerate(plan.data):
        tables: list[pa.Table] = []
        for episode in episodes:
            values = _values(plan, episode, next(samples))
            found = statistics.of_arrays(values)
            found[FILM] = statistics.of_film(source.folder / episode.film)
            total.add(found)
            rows.append(statistics.flat(found))
            tables.append(_table(values))
        folder.add(DATA.format(**_place(number)), partial(_write_episodes, tables))
    return rows, total.stats()


def _samples(source: Source) -> Iterator[Sample]:
    for split in splits():
        yield from source.samples(split, ("trajectories",))


def _values(plan: Plan, episode: Episode, sample: Sample) -> dict[str, NDArray[Any]]:
    """Columns of an episode's frames."""
    n, frame = episode.frames, np.arange(episode.frames)
    states = states_of(sample)
    state = np.zeros((n, plan.bodies, len(_OF_A_BODY)), np.float32)
    state[:, : episode.bodies] = states
    mask = np.zeros((n, plan.bodies), bool)
    mask[:, : episode.bodies] = True
    return {
        STATE: state.reshape(n, -1),
        MASK: mask,
        "timestamp": (frame / plan.fps).astype(np.float32),
        "frame_index": frame,
        "episode_index": np.full(n, episode.index),
        "index": episode.first + frame,
        "task_index": np.full(n, plan.tasks[episode.prompt]),
    }


def _table(values: dict[str, NDArray[Any]]) -> pa.Table:
    import pyarrow as pa

    def column(array: NDArray[Any]) -> pa.Array:
        flat = pa.array(np.ascontiguousarray(array).ravel())
        wide = array.ndim > 1 and array.shape[1] > 1  # LeRobot reads a list of one as a number
        return pa.FixedSizeListArray.from_arrays(flat, array.shape[1]) if wide else flat

    return pa.table({name: column(array) for name, array in values.items()})


def _write_episodes(tables: Sequence[pa.Table], path: Path) -> None:
    """A row group an episode: readers fetch one without the others."""
    import pyarrow.parquet as pq

    with pq.ParquetWriter(str(path), tables[0].schema, compression="zstd") as writer:
        for table in tables:
            writer.write_table(table)


def _write(table: pa.Table, path: Path) -> None:
    import pyarrow.parquet as pq

    pq.write_table(table, str(path), compression="zstd")


def _tasks(plan: Plan) -> pa.Table:
    """Prompts as the index of a pandas frame, as which LeRobot reads them."""
    import pyarrow as pa

    kinds = (("task_index", "int64", "int64"), ("task", "unicode", "object"))
    columns = [
        {"name": n, "field_name": n, "pandas_type": p, "numpy_type": k, "metadata": None}
        for n, p, k in kinds
    ]
    facts = {"index_columns": ["task"], "column_indexes": [], "columns": columns}
    table = pa.table({"task_index": list(plan.tasks.values()), "task": list(plan.tasks)})
    return table.replace_schema_metadata({b"pandas": json.dumps(facts).encode()})


def _episode_table(plan: Plan, stats: Sequence[dict[str, Any]]) -> pa.Table:
    import pyarrow as pa

    places = {e.index: (f"videos/{FILM}", n) for n, group in enumerate(plan.films) for e in group}
    data = {e.index: n for n, group in enumerate(plan.data) for e in group}
    begins = {group[0].index: group[0].first for group in plan.films}
    rows: list[dict[str, Any]] = []
    begin = 0
    for episode, found in zip(plan.episodes, stats, strict=True):
        begin = begins.get(episode.index, begin)
        key, film = places[episode.index]
        seconds = (episode.first - begin) / plan.fps
        rows.append(
            {
                "episode_index": episode.index,
                "tasks": [episode.prompt],
                "length": episode.frames,
                "split": episode.split,
                "dataset_from_index": episode.first,
                "dataset_to_index": episode.first + episode.frames,
                **{f"data/{k}": v for k, v in _place(data[episode.index]).items()},
                **{f"{key}/{k}": v for k, v in _place(film).items()},
                f"{key}/from_timestamp": seconds,
                f"{key}/to_timestamp": seconds + episode.frames / plan.fps,
                "meta/episodes/chunk_index": 0,
                "meta/episodes/file_index": 0,
                **found,
            }
        )
    return pa.Table.from_pylist(rows)


def _info(plan: Plan) -> dict[str, Any]:
    height, width = plan.size
    names = [f"body_{k}.{part}" for k in range(plan.bodies) for part in _OF_A_BODY]
    film = {
        "dtype": "video",
        "shape": [height, width, 3],
        "names": ["height", "width", "channels"],
        "info": {
            "video.height": height, "video.width": width, "video.channels": 3,
            "video.fps": plan.fps, "video.codec": "h264", "video.pix_fmt": "yuv420p",
            "video.is_depth_map": False, "has_audio": False,
        },
    }  # fmt: skip
    bodies = [f"body_{k}" for k in range(plan.bodies)]
    features: dict[str, Any] = {
        FILM: film,
        STATE: {"dtype": "float32", "shape": [len(names)], "names": names},
        MASK: {"dtype": "bool", "shape": [len(bodies)], "names": bodies},
    }
    for name in _NUMBERS:
        kind = "float32" if name == "timestamp" else "int64"
        features[name] = {"dtype": kind, "shape": [1], "names": None}
    bounds: dict[str, tuple[int, int]] = {}
    for e in plan.episodes:
        bounds[e.split] = (bounds.get(e.split, (e.index, 0))[0], e.index + 1)
    return {
        "codebase_version": VERSION,
        "robot_type": None,
        "total_episodes": len(plan.episodes),
        "total_frames": sum(e.frames for e in plan.episodes),
        "total_tasks": len(plan.tasks),
        "chunks_size": CHUNK_FILES,
        "data_files_size_in_mb": DATA_FILE_MB,
        "video_files_size_in_mb": VIDEO_FILE_MB,
        "fps": plan.fps,
        "splits": {split: f"{a}:{b}" for split, (a, b) in bounds.items()},
        "data_path": DATA,
        "video_path": VIDEO,
        "features": features,
    }
