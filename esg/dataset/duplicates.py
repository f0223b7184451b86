"""Near-duplicates: scenes that move alike and are told alike (docs/dataset/variety.md).

A replay becomes a path: the bodies that move farthest, each at the same number of instants, moved
and turned about the vertical so that the first starts at the origin and leaves along +X, and
divided by how far they reach. Two scenes are near if their paths, reaches and lengths agree and
their prompts mean the same to the sentence embedder. Scenes are gone through in the order of their
keys, and each is compared with those that are no duplicates themselves: what is found depends
neither on shards nor on batches. The two sides of a counterfactual pair are never duplicates of
each other: that they are alike is their use.
"""

from __future__ import annotations

from array import array
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.workers import usable_cores

if TYPE_CHECKING:
    import pyarrow as pa

INSTANTS = 24
MOVERS = 4
"""So many bodies make a path: those that move farthest."""
MOVED_M = 0.05
"""What moves less stands."""
PATH_TOLERANCE = 0.02
"""Root mean square between two paths, as a share of their reach: less than what one frame of a
replay of half a second makes."""
REACH_TOLERANCE = 0.05
LENGTH_TOLERANCE = 0.05
"""Relative differences of two reaches and of two lengths in time."""
TEXT_COSINE = 0.9
"""Of two prompts (MiniLM): another wording or number has 0.85 to 0.97, another colour, place or
target 0.7 to 0.91 (measured on prompts of the grammar)."""
_ROWS = 16
"""Replays in memory at once."""


@dataclass(frozen=True)
class Way:
    """What a replay is compared by.

    Args:
        scene_key: Of its scene.
        points: Normalized, shape [movers, INSTANTS, 3].
        reach_m: Largest extent of the movers' ways together [m].
        length_s: Of the replay [s].
    """

    scene_key: str
    points: NDArray[np.float32]
    reach_m: float
    length_s: float


@dataclass(frozen=True)
class Duplicate:
    """A scene that is near to an earlier one.

    Args:
        scene_key: Of the scene.
        duplicate_of: Key of the earlier one.
        path_distance: Root mean square of the difference of their paths, by their reach.
        text_cosine: Of their prompts.
    """

    scene_key: str
    duplicate_of: str
    path_distance: float
    text_cosine: float


def path_of(scene_key: str, time_s: NDArray[Any], position_m: NDArray[Any]) -> Way | None:
    """The path of a replay; None if nothing moves in it.

    Args:
        scene_key: Of its scene.
        time_s: Of its frames, shape [n].
        position_m: Of the bodies, shape [n, bodies, 3].
    """
    ways = np.linalg.norm(np.diff(position_m, axis=0), axis=-1).sum(axis=0)
    ways = np.where(np.isfinite(ways), ways, 0.0)
    order = [int(b) for b in np.argsort(-ways, kind="stable")[:MOVERS] if ways[b] > MOVED_M]
    if not order or len(time_s) < 2:
        return None
    wanted = np.linspace(time_s[0], time_s[-1], INSTANTS)
    points = np.stack(
        [
            np.stack([np.interp(wanted, time_s, position_m[:, b, k]) for k in range(3)], axis=-1)
            for b in order
        ]
    )
    points -= points[0, 0]
    extent = points.reshape(-1, 3)
    reach = float(np.linalg.norm(extent.max(axis=0) - extent.min(axis=0)))
    c, s = _turn(points)
    x, y = points[..., 0].copy(), points[..., 1].copy()
    points[..., 0], points[..., 1] = c * x + s * y, c * y - s * x
    length = float(time_s[-1] - time_s[0])
    return Way(scene_key, (points / reach).astype(np.float32), reach, length)


def _turn(points: NDArray[Any]) -> tuple[float, float]:
    """Cosine and sine of the first mover's heading, or of where the others are if it only falls."""
    away = points[0] - points[0, 0]
    if np.linalg.norm(away[:, :2], axis=-1).max() < MOVED_M and len(points) > 1:
        away = points[1]
    flat = away[int(np.argmax(np.linalg.norm(away[:, :2], axis=-1))), :2]
    length = float(np.linalg.norm(flat))
    return (1.0, 0.0) if length < 1e-6 else (float(flat[0] / length), float(flat[1] / length))


def paths_in(files: Iterable[Path]) -> Iterator[Way]:
    """Paths of all replays in files of the table `trajectories`, a few in memory at a time."""
    from esg.store.tables import iter_batches

    columns = ["scene_key", "bodies", "n_frames", "time_s", "position_m"]
    for batch in iter_batches(files, columns, rows=_ROWS):
        for i in range(batch.num_rows):
            key, bodies, n = (batch[k][i].as_py() for k in columns[:3])
            time, flat = (batch[k][i].values.to_numpy() for k in columns[3:])
            if n and bodies and len(flat) == 3 * n * len(bodies):
                where = flat.reshape(n, len(bodies), 3).astype(float)
                found = path_of(key, time.astype(float), where)
                if found is not None:
                    yield found


def find_duplicates(
    paths: Iterable[Way], prompts: Mapping[str, str], pairs: Mapping[str, str]
) -> list[Duplicate]:
    """Scenes that are near to an earlier one that is no duplicate itself, in order of their keys.

    Args:
        paths: Of the scenes, in any order.
        prompts: By scene key.
        pairs: Counterfactual pair by scene key, of those that are in one.
    """
    ways = sorted(paths, key=lambda p: p.scene_key)
    said = _embedded(ways, prompts, pairs)
    kept, out = _Shelves(pairs), list[Duplicate]()
    for way in ways:
        found = _nearest(way, kept.near(way), prompts, said)
        if found is None:
            kept.add(way)
        else:
            out.append(found)
    return out


@dataclass
class _Shelf:
    """Scenes that reach about as far, and what is compared first, in arrays."""

    ways: list[Way] = field(default_factory=list)
    reach_m: array[float] = field(default_factory=lambda: array("d"))
    length_s: array[float] = field(default_factory=lambda: array("d"))


class _Shelves:
    """Scenes by how far they reach, so that few are compared with each other.

    Args:
        pairs: Counterfactual pair by scene key, of those that are in one.
    """

    def __init__(self, pairs: Mapping[str, str]) -> None:
        self._pairs = pairs
        self._shelves: dict[tuple[int, int], _Shelf] = defaultdict(_Shelf)

    def add(self, way: Way) -> None:
        shelf = self._shelves[_place(way)]
        shelf.ways.append(way)
        shelf.reach_m.append(way.reach_m)
        shelf.length_s.append(way.length_s)

    def near(self, way: Way) -> list[tuple[float, Way]]:
        """Those that move as it does, the nearest first, with their distance."""
        movers, place = _place(way)
        pair = self._pairs.get(way.scene_key)
        found: list[tuple[float, Way]] = []
        for step in (-1, 0, 1):
            shelf = self._shelves.get((movers, place + step))
            if shelf is None:
                continue
            reach = np.frombuffer(shelf.reach_m) / way.reach_m
            length = np.frombuffer(shelf.length_s) / max(way.length_s, 1e-9)
            alike = np.flatnonzero(
                (np.abs(np.log(reach)) <= math.log1p(REACH_TOLERANCE))
                & (np.abs(length - 1) <= LENGTH_TOLERANCE)
            )
            others = [shelf.ways[k] for k in alike]
            others = [o for o in others if not pair or pair != self._pairs.get(o.scene_key)]
            if others:
                difference = np.stack([o.points for o in others]) - way.points
                distance = np.sqrt((difference.astype(float) ** 2).sum(axis=-1).mean(axis=(1, 2)))
                found += [
                    (float(d), o)
                    for d, o in zip(distance, others, strict=True)
                    if d <= PATH_TOLERANCE
                ]
        return sorted(found, key=lambda f: (f[0], f[1].scene_key))


def _place(way: Way) -> tuple[int, int]:
    return len(way.points), math.floor(math.log(way.reach_m) / math.log1p(REACH_TOLERANCE))


def _embedded(
    ways: Sequence[Way], prompts: Mapping[str, str], pairs: Mapping[str, str]
) -> dict[str, NDArray[np.float32]]:
    """Embeddings of the prompts of all scenes that move as another one does, made on all cores."""
    from esg.assets.library.embed import embed

    earlier, wanted = _Shelves(pairs), dict[str, None]()
    for way in ways:
        for _, other in earlier.near(way):
            wanted[prompts[way.scene_key]] = wanted[prompts[other.scene_key]] = None
        earlier.add(way)
    embed(list(wanted)[:1])  # the model is loaded once
    with ThreadPoolExecutor(usable_cores()) as threads:
        found = threads.map(embed, [[text] for text in wanted])
        return {text: vectors[0] for text, vectors in zip(wanted, found, strict=True)}


def _nearest(
    way: Way,
    others: Sequence[tuple[float, Way]],
    prompts: Mapping[str, str],
    said: Mapping[str, NDArray[np.float32]],
) -> Duplicate | None:
    """The nearest of the scenes that move as it does whose prompt means the same."""
    for distance, other in others:
        cosine = float(said[prompts[way.scene_key]] @ said[prompts[other.scene_key]])
        if cosine >= TEXT_COSINE:
            return Duplicate(way.scene_key, other.scene_key, round(distance, 5), round(cosine, 4))
    return None


def duplicates_in(folder: Path) -> list[Duplicate]:
    """Near-duplicates among the scenes of a folder with tables, or with their parts.

    Args:
        folder: With `scenes` and `trajectories`.
    """
    from esg.store.tables import part_files, read_table

    prompts: dict[str, str] = {}
    pairs: dict[str, str] = {}
    for file in part_files(folder, "scenes"):
        rows = read_table(file, ["scene_key", "prompt", "pair"]).to_pylist()
        prompts |= {r["scene_key"]: r["prompt"] for r in rows}
        pairs |= {r["scene_key"]: r["pair"] for r in rows if r["pair"]}
    return find_duplicates(paths_in(part_files(folder, "trajectories")), prompts, pairs)


def marking(found: Sequence[Duplicate]) -> Callable[[str, pa.Table], pa.Table]:
    """What fills column `duplicate_of` of table `scenes`, for `assemble_tables`.

    Args:
        found: The duplicates.
    """
    import pyarrow as pa

    earlier = {row.scene_key: row.duplicate_of for row in found}

    def changed(table: str, data: pa.Table) -> pa.Table:
        if table != "scenes" or not earlier:
            return data
        marks = [earlier.get(key) for key in data["scene_key"].to_pylist()]
        place = data.schema.get_field_index("duplicate_of")
        return data.set_column(place, data.schema.field(place), pa.array(marks, pa.string()))

    return changed
