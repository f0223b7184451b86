"""What is compared: a check gives residuals of one clip, in its unit (docs/dataset/truth.md)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from esg.dataset.clips.records import FIRST_BODY
from esg.dataset.crosscheck.frames import Floats, Seen

PIXELS = 2000
"""Of a frame: half of them on objects, where there are so many."""
SAME_SURFACE = 0.02
"""Neighbours belong to one smooth surface if their distances differ by less than this share of
them: elsewhere what lies between two pixels cannot be told."""


@dataclass(frozen=True)
class Residuals:
    """What a check found.

    Args:
        values: Non-negative, one a sample, shape [n].
        where: Frame and id of the object (0: none) of every sample, shape [n, 2].
    """

    values: Floats
    where: NDArray[np.int64]

    @staticmethod
    def joined(parts: list[Residuals]) -> Residuals:
        """Those of several frames, without what is not finite."""
        if not parts:
            return Residuals(np.zeros(0), np.zeros((0, 2), np.int64))
        values = np.concatenate([p.values for p in parts])
        where = np.concatenate([p.where for p in parts])
        known = np.isfinite(values)
        return Residuals(values[known], where[known])


@dataclass(frozen=True)
class Check:
    """One kind of check.

    Args:
        unit: Of its residuals.
        limit: That the 99th percentile must not exceed.
        channels: Files that it needs.
        columns: Columns of the clip that it needs.
        run: Residuals of a clip; draws its sample from the generator.
    """

    unit: str
    limit: float
    channels: tuple[str, ...]
    columns: tuple[str, ...]
    run: Callable[[Seen, np.random.Generator], Residuals]

    def applies(self, seen: Seen) -> bool:
        """Whether a clip has what it needs."""
        return seen.has(*self.channels) and all(
            len(getattr(seen.record, name)) > 0 for name in self.columns
        )


@dataclass(frozen=True)
class _Sample:
    """Pixels of one frame: rows, columns, ids, centres [px], distances and world points [m]."""

    rows: NDArray[np.int64]
    columns: NDArray[np.int64]
    ids: NDArray[Any]
    places: Floats
    depth: Floats
    points: Floats

    def of(self, kept: NDArray[np.bool_]) -> _Sample:
        return _Sample(*(v[kept] for v in vars(self).values()))


def _sample(seen: Seen, frame: int, rng: np.random.Generator) -> _Sample:
    ids, depth = seen.ids(frame), seen.depth(frame)
    chosen = []
    for among in (ids >= FIRST_BODY, (ids > 0) & (ids < FIRST_BODY)):
        spots = np.flatnonzero(among & np.isfinite(depth))
        chosen.append(rng.permutation(spots)[: PIXELS // 2])
    rows, columns = np.unravel_index(np.sort(np.concatenate(chosen)), ids.shape)
    x, y, far = columns + 0.5, rows + 0.5, depth[rows, columns]
    points = seen.unprojected(frame, x, y, far)
    return _Sample(rows, columns, ids[rows, columns], np.stack([x, y], -1), far, points)


def _rigid(seen: Seen, frame: int, rng: np.random.Generator) -> tuple[_Sample, Floats]:
    """Pixels of what moves rigidly, and where they are in the axes of their objects."""
    sample = _sample(seen, frame, rng)
    local = seen.into(frame, sample.ids, sample.points)
    kept = seen.rigid(sample.ids, local)
    return sample.of(kept), local[kept]


def _steps(seen: Seen) -> Iterator[tuple[int, int]]:
    """Pairs of frames that follow each other."""
    yield from ((a, b) for a, b in zip(seen.frames, seen.frames[1:], strict=False) if b == a + 1)


def _found(frame: int, sample: _Sample, values: Floats) -> Residuals:
    where = np.stack([np.full(len(values), frame), sample.ids.astype(np.int64)], axis=-1)
    return Residuals(values, where)


def _flow_channel(channel: str, seen: Seen, rng: np.random.Generator) -> Residuals:
    """A flow against depth, poses of the objects and poses of the camera."""
    parts: list[Residuals] = []
    for a, b in _steps(seen):
        here, there = (a, b) if channel == "flow" else (b, a)
        sample, local = _rigid(seen, here, rng)
        moved, _ = seen.projected(there, seen.out_of(there, sample.ids, local))
        told = seen.shift(channel, here)[sample.rows, sample.columns]
        off = np.linalg.norm(sample.places + told - moved, axis=-1)
        parts.append(_found(here, sample, off))
    return Residuals.joined(parts)


def _flow(seen: Seen, rng: np.random.Generator) -> Residuals:
    return _flow_channel("flow", seen, rng)


def _backward_flow(seen: Seen, rng: np.random.Generator) -> Residuals:
    return _flow_channel("backward_flow", seen, rng)


@dataclass(frozen=True)
class _Between:
    """Four pixels around places in a picture, and their weights.

    Args:
        rows, columns: Shape [n, 4].
        weights: Bilinear, shape [n, 4].
        smooth: Whether all four show the same object, as one surface, shape [n].
    """

    rows: NDArray[np.int64]
    columns: NDArray[np.int64]
    weights: Floats
    smooth: NDArray[np.bool_]

    def value(self, picture: Floats) -> Floats:
        """The picture between its pixels, shape [n, ...]."""
        found = picture[self.rows, self.columns]
        weights = self.weights.reshape(*self.weights.shape, *[1] * (found.ndim - 2))
        return (found * weights).sum(axis=1)


def _between(seen: Seen, frame: int, places: Floats, ids: NDArray[Any]) -> _Between:
    there, depth = seen.ids(frame), seen.depth(frame)
    height, width = there.shape
    at = np.nan_to_num(places, nan=-9.0, posinf=-9.0, neginf=-9.0) - 0.5
    corner = np.floor(np.clip(at, -9, 1e6)).astype(np.int64)
    share = at - corner
    inside = (corner >= 0).all(axis=1) & (corner[:, 0] + 1 < width) & (corner[:, 1] + 1 < height)
    corner[~inside] = 0
    columns = corner[:, :1] + np.array([0, 1, 0, 1])
    rows = corner[:, 1:] + np.array([0, 0, 1, 1])
    u, v = share[:, 0], share[:, 1]
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v], axis=-1)
    near = depth[rows, columns]
    spread = (np.max(near, axis=1) - np.min(near, axis=1)) / np.min(near, axis=1)
    smooth = inside & (there[rows, columns] == ids[:, None]).all(axis=1) & (spread < SAME_SURFACE)
    return _Between(rows, columns, weights, smooth)


def _there_and_back(seen: Seen, rng: np.random.Generator) -> Residuals:
    """Forward and then backward flow lead back to the pixel, where nothing comes between."""
    parts: list[Residuals] = []
    for a, b in _steps(seen):
        sample, _ = _rigid(seen, a, rng)
        ahead = seen.shift("flow", a)[sample.rows, sample.columns]
        place = sample.places + ahead
        between = _between(seen, b, place, sample.ids)
        back = between.value(seen.shift("backward_flow", b))
        # What came before it in the meantime has another flow: it is another surface.
        shown = between.smooth & _same_surface(seen, (a, b), sample, between)
        shown &= _all_rigid(seen, b, between, sample.ids)
        off = np.linalg.norm(ahead + back, axis=-1)
        parts.append(_found(a, sample.of(shown), off[shown]))
    return Residuals.joined(parts)


def _moved_depth(seen: Seen, step: tuple[int, int], sample: _Sample) -> Floats:
    """How far the surfaces of one picture are from the camera of the next [m]."""
    local = seen.into(step[0], sample.ids, sample.points)
    return seen.projected(step[1], seen.out_of(step[1], sample.ids, local))[1]


def _same_surface(
    seen: Seen, step: tuple[int, int], sample: _Sample, between: _Between
) -> NDArray[np.bool_]:
    inverse = between.value(1.0 / seen.depth(step[1]))
    return np.abs(_moved_depth(seen, step, sample) * inverse - 1.0) < SAME_SURFACE


def _all_rigid(seen: Seen, frame: int, between: _Between, ids: NDArray[Any]) -> NDArray[np.bool_]:
    """Whether none of the four pixels is on a wheel."""
    if not seen.wheels:
        return np.ones(len(ids), bool)
    rows, columns, four = between.rows.ravel(), between.columns.ravel(), np.repeat(ids, 4)
    depth = np.nan_to_num(seen.depth(frame)[rows, columns])
    points = seen.unprojected(frame, columns + 0.5, rows + 0.5, depth)
    rigid = seen.rigid(four, seen.into(frame, four, points)).reshape(-1, 4)
    return np.asarray(rigid.all(axis=1))


def _depth_after(seen: Seen, rng: np.random.Generator) -> Residuals:
    """The next picture's depth where the flow leads, against the surface moved there.

    Between pixels the inverse of depth is linear on a plane. What is hidden by then is left out:
    what is nearer than the moved surface by more than SAME_SURFACE hides it.
    """
    parts: list[Residuals] = []
    for a, b in _steps(seen):
        sample, _ = _rigid(seen, a, rng)
        place = sample.places + seen.shift("flow", a)[sample.rows, sample.columns]
        between = _between(seen, b, place, sample.ids)
        found = 1.0 / between.value(1.0 / seen.depth(b))
        off = found / _moved_depth(seen, (a, b), sample) - 1.0
        shown = between.smooth & (off > -SAME_SURFACE)
        parts.append(_found(a, sample.of(shown), np.abs(off)[shown]))
    return Residuals.joined(parts)


def _boxes2d(seen: Seen, _rng: np.random.Generator) -> Residuals:
    """Tight boxes and numbers of pixels, against those of the segmentation."""
    parts: list[Residuals] = []
    for frame in seen.frames:
        ids = seen.ids(frame)
        told = {b["id"]: b for b in seen.record.boxes2d if b["frame"] == frame}
        there = {int(i) for i in np.unique(ids[ids >= FIRST_BODY])}
        for number in sorted(there | set(told)):
            rows, columns = np.nonzero(ids == number)
            if number not in told or not len(rows):
                off = float(max(ids.shape))
            else:
                box = told[number]
                real = (columns.min(), rows.min(), columns.max() + 1, rows.max() + 1, len(rows))
                names = ("x0", "y0", "x1", "y1", "visible_px")
                off = max(abs(float(box[n]) - float(r)) for n, r in zip(names, real, strict=True))
            parts.append(Residuals(np.array([off]), np.array([[frame, number]])))
    return Residuals.joined(parts)


def _boxes3d(seen: Seen, rng: np.random.Generator) -> Residuals:
    """How far outside its oriented box the visible surface of an object is [m]."""
    parts: list[Residuals] = []
    for frame in seen.frames:
        sample = _sample(seen, frame, rng)
        for box in (b for b in seen.record.boxes3d if b["frame"] == frame):
            mine = sample.of(sample.ids == box["id"])
            turn = Rotation.from_quat([box[k] for k in ("qx", "qy", "qz", "qw")])
            center = np.array([box[k] for k in ("x_m", "y_m", "z_m")])
            half = np.array([box[k] for k in ("half_x_m", "half_y_m", "half_z_m")])
            away = np.abs(turn.inv().apply(mine.points - center)) - half
            off = np.linalg.norm(np.maximum(away, 0.0), axis=-1)
            parts.append(_found(frame, mine, off))
    return Residuals.joined(parts)


def _tracks(seen: Seen, _rng: np.random.Generator) -> Residuals:
    """Pixels of tracked points, against their places on the objects and the poses."""
    record = seen.record
    parts: list[Residuals] = []
    for frame in seen.frames:
        points = seen.out_of(frame, record.track_ids, record.track_point_m.astype(float))
        place, ahead = seen.projected(frame, points)
        off = np.linalg.norm(place - record.track_xy_px[frame], axis=-1)
        # What is behind the camera has no pixel to be compared.
        where = np.stack([np.full(len(off), frame), record.track_ids.astype(np.int64)], axis=-1)
        parts.append(Residuals(np.where(ahead > 0.05, off, np.nan), where))
    return Residuals.joined(parts)


def _track_depth(seen: Seen, _rng: np.random.Generator) -> Residuals:
    """Of visible tracked points: their distance, against the depth of the pixel they are in."""
    record = seen.record
    parts: list[Residuals] = []
    for frame in seen.frames:
        shown = record.track_visible[frame].astype(bool)
        ids = record.track_ids[shown]
        points = seen.out_of(frame, ids, record.track_point_m[shown].astype(float))
        ahead = seen.projected(frame, points)[1]
        x, y = np.floor(record.track_xy_px[frame, shown].astype(float)).astype(np.int64).T
        height, width = seen.ids(frame).shape
        inside = (x >= 0) & (y >= 0) & (x < width) & (y < height)
        x, y = np.where(inside, x, 0), np.where(inside, y, 0)
        own = inside & (seen.ids(frame)[y, x] == ids)
        off = np.where(own, np.abs(seen.depth(frame)[y, x] / ahead - 1.0), 1.0)
        where = np.stack([np.full(len(off), frame), ids.astype(np.int64)], axis=-1)
        parts.append(Residuals(off, where))
    return Residuals.joined(parts)


def _object_coordinates(seen: Seen, rng: np.random.Generator) -> Residuals:
    """Places on objects, against depth and poses [m]."""
    parts: list[Residuals] = []
    for frame in seen.frames:
        sample, local = _rigid(seen, frame, rng)
        on = sample.ids >= FIRST_BODY
        sample, local = sample.of(on), local[on]
        if not on.any():
            continue
        bounds = seen.record.object_bounds_m[[seen.place_of(int(i)) for i in sample.ids]]
        low, high = bounds[:, 0].astype(float), bounds[:, 1].astype(float)
        told = low + seen.shares(frame)[sample.rows, sample.columns] * (high - low)
        parts.append(_found(frame, sample, np.linalg.norm(told - local, axis=-1)))
    return Residuals.joined(parts)


_MOVES = ("depth", "segmentation")
CHECKS: dict[str, Check] = {
    "flow": Check("px", 0.1, (*_MOVES, "flow"), (), _flow),
    "backward_flow": Check("px", 0.1, (*_MOVES, "backward_flow"), (), _backward_flow),
    "there_and_back": Check("px", 0.1, (*_MOVES, "flow", "backward_flow"), (), _there_and_back),
    "depth_after": Check("share", 0.01, (*_MOVES, "flow"), (), _depth_after),
    "boxes2d": Check("px", 0.0, ("segmentation",), ("boxes2d",), _boxes2d),
    "boxes3d": Check("m", 0.02, _MOVES, ("boxes3d",), _boxes3d),
    "tracks": Check("px", 0.1, (), ("track_ids",), _tracks),
    "track_depth": Check("share", 0.05, _MOVES, ("track_ids",), _track_depth),
    "object_coordinates": Check(
        "m", 0.01, (*_MOVES, "object_coordinates"), (), _object_coordinates
    ),
}
"""All checks of a clip by name; `contacts` is one of a replay (esg.dataset.crosscheck.contacts)."""
