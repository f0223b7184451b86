"""Which way something moves: of the viewer, of its own, or by something else."""

from __future__ import annotations

from collections.abc import Callable
import itertools
import math

import numpy as np

from esg.metrics.binding import Binding
from esg.metrics.events.space import inside_volume, volumes
from esg.metrics.geometry import gets_ahead
from esg.metrics.replay import Floats, Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.metrics.support import bounds, local_position, touching
from esg.thresholds import (
    ACROSS_LENGTHS,
    ACROSS_SHARE,
    ALONG_M,
    AROUND_DEG,
    BEND_DEG,
    CUT_SHORT_LENGTHS,
    DIRECTION_DEG,
    MOST,
    ON_WATER_M,
    PASS_M,
    PASS_SIZES,
    ROUND_DEG,
    SLOPE_GRADE,
    SLOPE_SHARE,
    STILL_M,
    WIDE_M,
)
from esg.units import quat_rotate

_VIEWER: dict[str, tuple[float, float, float]] = {
    "left": (1.0, 0.0, 0.0),
    "right": (-1.0, 0.0, 0.0),
    "front": (0.0, 1.0, 0.0),
    "back": (0.0, -1.0, 0.0),
    "up": (0.0, 0.0, 1.0),
    "down": (0.0, 0.0, -1.0),
}
"""Left is +X and front +Y: the viewer stands at +Y."""


def moves(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its displacement goes the stated way."""
    path = replay.position[q.window.frames, body]
    direction = q.statement.direction
    assert direction is not None
    way = float(np.linalg.norm(path - path[0], axis=1).max())
    if way < STILL_M:
        reason = f"moves by {100 * way:.0f} cm; less than {100 * STILL_M:.0f} cm is no motion"
        return Kept(False, {"moved_m": way}, reason)
    return _MEASURES[direction](replay, q, body, path)


Measure = Callable[[Replay, StatementQuery, int, Floats], Kept]


def _off(shift: Floats, off_deg: float, words: str) -> Kept:
    return Kept.when(
        off_deg <= DIRECTION_DEG,
        f"moves {off_deg:.0f} degrees off {words} ({_towards(shift)}); limit {DIRECTION_DEG:.0f}",
        off_deg=off_deg,
        moved_m=float(np.linalg.norm(shift)),
    )


def _towards(shift: Floats) -> str:
    """The viewer's word for a displacement."""
    names = {"up": "upwards", "down": "downwards", "front": "to the front", "back": "to the back"}
    best = max(_VIEWER, key=lambda d: float(shift @ np.array(_VIEWER[d])))
    return names.get(best, f"to the {best}")


def angle_deg(a: Floats, b: Floats) -> float:
    """Angle between two vectors [degrees]; 180 if one of them is zero."""
    size = float(np.linalg.norm(a) * np.linalg.norm(b))
    if size == 0.0:
        return 180.0
    return math.degrees(math.acos(min(1.0, max(-1.0, float(a @ b) / size))))


def _level(v: Floats) -> Floats:
    return v * np.array([1.0, 1.0, 0.0])


def _of_viewer(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Left, right, front and back: what it falls or climbs meanwhile does not count."""
    direction = q.statement.direction or ""
    shift = _level(path[-1] - path[0])
    return _off(shift, angle_deg(shift, np.array(_VIEWER[direction])), repr(direction))


def _of_own(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Forward and backward: by its own heading at the start.

    A round thing has none: forward is the way that it sets off, and backward says nothing.
    """
    direction = q.statement.direction or ""
    if direction == "backward" and replay.scene.bodies[body].roll_radius > 0:
        return Kept(None, reason="a round thing has no back to move to")
    yaw = float(replay.heading(body)[0])
    sign = 1.0 if direction == "forward" else -1.0
    wanted = sign * np.array([math.cos(yaw), math.sin(yaw), 0.0])
    shift = _level(path[-1] - path[0])
    return _off(shift, angle_deg(shift, wanted), f"its own {direction!r}")


def _upright(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Up to its highest point, or down to its lowest; up or down something, along with it.

    What touches something most of the way goes along a slope, however flat: it gains height.
    """
    direction = q.statement.direction or ""
    sign = 1.0 if direction == "up" else -1.0
    rise = sign * path[:, 2]
    # Where it first comes so far: of a bounce, a frame is up to some centimetres above the ground.
    turn = int(np.argmax(rise >= rise.max() - STILL_M))
    shift = path[turn] - path[0]
    slopes = [j for j in q.target.bodies if j != body]
    if not slopes and touching(replay, body)[q.window.frames][: turn + 1].mean() >= MOST:
        gained, level = sign * float(shift[2]), float(np.hypot(*shift[:2]))
        if gained >= max(STILL_M, SLOPE_GRADE * level):
            return Kept(True, {"rises_m": sign * gained})
    if not slopes:
        return _off(shift, angle_deg(shift, np.array(_VIEWER[direction])), repr(direction))
    boxes = [bounds(replay, j, q.window.first) for j in slopes]
    need = SLOPE_SHARE * min(float(high[2] - low[2]) for low, high in boxes)
    gained = sign * float(shift[2])
    verb = "rises" if direction == "up" else "sinks"
    reason = f"{verb} by {gained:.2f} m on {q.goal}; needs {need:.2f} m"
    return Kept.when(gained >= need, reason, rises_m=sign * gained)


def _boxes(replay: Replay, q: StatementQuery, body: int, frame: int) -> list[tuple[Floats, Floats]]:
    """Lowest and highest corners of what the direction is of."""
    out = [bounds(replay, j, frame) for j in q.target.bodies if j != body]
    for k in q.target.regions:
        points = np.concatenate([c.points for c in replay.placed_region(k, frame)])
        out.append((points.min(axis=0), points.max(axis=0)))
    if q.target.point is not None:
        out.append((np.array(q.target.point), np.array(q.target.point)))
    if q.target.ground:
        out.append((np.array([-np.inf, -np.inf, 0.0]), np.array([np.inf, np.inf, 0.0])))
    return out


def off_box(start: Floats, shift: Floats, low: Floats, high: Floats) -> float:
    """Angle between a displacement and the nearest way from a start to a box [degrees].

    What moves over level ground is measured on the map.

    Args:
        start, shift: Where it starts and how far it goes [m], shape [3].
        low, high: Corners of the box [m], shape [3].
    """
    if float(np.hypot(*shift[:2])) >= abs(float(shift[2])):
        start, shift, low, high = (_level(np.clip(v, -1e6, 1e6)) for v in (start, shift, low, high))
    low, high = np.clip(low, -1e6, 1e6), np.clip(high, -1e6, 1e6)
    center = 0.5 * (low + high)
    nearest = np.clip(start, low, high)
    if np.array_equal(nearest, start):
        return angle_deg(shift, center - start)
    corners = np.array(list(itertools.product(*zip(low, high, strict=True))))
    # The nearest point of the box to the ray is found by going back and forth between the two.
    u = shift / np.linalg.norm(shift)
    point = nearest
    for _ in range(20):
        point = np.clip(start + u * max(float((point - start) @ u), 0.0), low, high)
    return min(angle_deg(shift, p - start) for p in (center, nearest, point, *corners))


def _toward(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Toward: until it is nearest. It comes nearer, and the way there leads to it."""
    best = Kept(False, reason=f"comes no nearer to {q.goal}")
    for low, high in _boxes(replay, q, body, q.window.first):
        apart = np.linalg.norm(path - np.clip(path, low, high), axis=1)
        if apart[0] == 0.0:
            apart = np.linalg.norm(path - 0.5 * (low + high), axis=1)
        near = int(np.argmax(apart <= apart.min() + 1e-3))
        shift = path[near] - path[0]
        if apart[0] - apart[near] < STILL_M:
            continue
        found = _off(shift, off_box(path[0], shift, low, high), f"the way to {q.goal}")
        best = best if best.kept else found
    return _out_on_water(replay, q, body, path, best) if best.kept else best


WATER = "pool"
"""Category of all water that lies in the open."""
DEEP_M = 4.0
"""Narrower water is a puddle or a ford."""
_ASHORE = ("legs", "road", "track")


def _out_on_water(replay: Replay, q: StatementQuery, body: int, path: Floats, found: Kept) -> Kept:
    """Who goes toward the sea stops at the shore: water bears nobody who walks or drives."""
    from esg.metrics.plausibility.limits import motion_of  # the judge is above it

    bodies, own = replay.scene.bodies, replay.scene.bodies[body]
    ashore = motion_of(own.label, own.category).moves in _ASHORE
    waters = [i for i in q.target.bodies if bodies[i].category == WATER and not bodies[i].collides]
    for low, high in (bounds(replay, i, q.window.first) for i in waters if ashore):
        if float((high - low)[:2].min()) < DEEP_M:
            continue
        over = np.all((low[:2] <= path[:, :2]) & (path[:, :2] <= high[:2]), axis=1)
        steps = np.linalg.norm(np.diff(path[:, :2], axis=0), axis=1)
        out = float(steps[over[1:]].sum())
        if out > ON_WATER_M and not over[0]:
            reason = f"goes {out:.1f} m out on {q.goal}; limit {ON_WATER_M:g} m"
            return Kept(False, {"on_water_m": out}, reason)
    return found


def _away_from(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Away from: until it is farthest. Backwards, that way leads to where it came from."""
    best = Kept(False, reason=f"comes no farther away from {q.goal}")
    for low, high in _boxes(replay, q, body, q.window.first):
        apart = np.linalg.norm(path - np.clip(path, low, high), axis=1)
        far = int(np.argmax(apart))
        shift = path[far] - path[0]
        if apart[far] - apart[0] < STILL_M:
            continue
        # What leaves something from its top may leave by any side.
        inside = bool(np.all((low[:2] <= path[0, :2]) & (path[0, :2] <= high[:2])))
        off = 0.0 if inside else off_box(path[0], -shift, low, high)
        found = _off(shift, off, f"the way from {q.goal}")
        best = best if best.kept else found
    return best


def _bodies(replay: Replay, q: StatementQuery, body: int) -> list[int]:
    """What the direction is of; of a region ("the lane"), what has it."""
    regions = (replay.scene.regions[k].parent for k in q.target.regions)
    named = [*q.target.bodies] or [replay.scene.index(name) for name in regions]
    return [j for j in dict.fromkeys(named) if j != body]


def _along(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Along: the long way of the target, and beside or on it."""
    best = Kept(False, reason=f"{q.goal} has no length to move along")
    size = 2.0 * max(replay.scene.bodies[body].half_extents)
    for other in _bodies(replay, q, body):
        b = replay.scene.bodies[other]
        half = np.array(b.half_extents[:2])
        shift = _level(path[-1] - path[0])
        turn = replay.quaternion[q.window.first, other]
        axes = quat_rotate(turn, np.eye(3)[:2])
        # A square has two long ways.
        long = axes[half >= half.max() / 1.2]
        off = min(min(angle_deg(shift, s * _level(a)) for s in (1, -1)) for a in long)
        local = local_position(replay, body, other)[q.window.frames] - np.array(b.origin_offset)
        beyond = np.maximum(np.abs(local[:, :2]) - half, 0.0)
        aside = float(np.median(np.linalg.norm(beyond, axis=1)))
        found = _off(shift, off, f"the length of {q.goal}")
        if found.kept and aside > max(ALONG_M, size):
            reason = f"keeps {aside:.1f} m off {q.goal}; limit {max(ALONG_M, size):.1f} m"
            found = Kept(False, {**found.measured, "aside_m": aside}, reason)
        best = best if best.kept else found
    return best


def _past(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Past: what was ahead of it is behind it, and was not far aside."""
    reason, measured = f"does not get past {q.goal}", dict[str, float]()
    for other in _bodies(replay, q, body):
        limit = max(PASS_M, PASS_SIZES * 2.0 * max(replay.scene.bodies[other].half_extents))
        offset = path - replay.position[q.window.frames, other]
        velocity = replay.velocity[q.window.frames, body]
        ahead = (offset * velocity)[:, :2].sum(axis=1)
        moving = replay.speed[q.window.frames, body] > STILL_M
        passes = np.flatnonzero(gets_ahead(ahead, moving))
        if not len(passes):
            continue
        k = int(passes[0])
        low, high = bounds(replay, other, q.window.first + k)
        aside = float(np.linalg.norm((path[k] - np.clip(path[k], low, high))[:2]))
        measured = {"aside_m": aside, "time_s": float(replay.time[q.window.first + k])}
        if aside <= limit:
            return Kept(True, measured)
        reason = f"passes {q.goal} {aside:.1f} m away; limit {limit:.1f} m"
    return Kept(False, measured, reason)


def _across(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Across: over much of its outline, from side to side."""
    most, size = 0.0, 2.0 * max(replay.scene.bodies[body].half_extents)
    for other in _bodies(replay, q, body):
        b = replay.scene.bodies[other]
        half = np.array(b.half_extents[:2])
        centre = np.array(b.origin_offset[:2])
        local = local_position(replay, body, other)[q.window.frames, :2] - centre
        within = local[np.all(np.abs(local) <= half, axis=1)]
        if len(within) < 2:
            continue
        way = within[-1] - within[0]
        length = float(np.linalg.norm(way))
        if length == 0.0:
            continue
        with np.errstate(divide="ignore"):
            chord = float(np.min(2.0 * half * length / np.abs(way)))
        # Of a floor or a field nobody crosses the half: several lengths of its own will do.
        wide = b.static and 2.0 * float(half.min()) > WIDE_M
        lengths = CUT_SHORT_LENGTHS if _is_cut_short(q) else ACROSS_LENGTHS
        enough = min(chord, lengths * size / ACROSS_SHARE) if wide else chord
        most = max(most, length / enough)
    reason = f"goes over {100 * most:.0f}% of {q.goal}; limit {100 * ACROSS_SHARE:.0f}%"
    return Kept.when(most >= ACROSS_SHARE, reason, share=most)


def _is_cut_short(q: StatementQuery) -> bool:
    """Whether an event ends the time it is about: a slide across the floor that hits something."""
    _, dots, last = q.statement.when.partition("..")
    return bool(dots) and last in q.times


def _passages(replay: Replay, target: Binding) -> list[tuple[int | None, int | None]]:
    """What is gone through: the opening of a gateway, and of the frame that a leaf turns in."""
    frames = {j.child: j.parent for j in replay.scene.joints if j.kind == "hinge"}
    out: list[tuple[int | None, int | None]] = []
    for region, container in volumes(replay, target):
        name = "" if container is None else replay.scene.bodies[container].name
        owners = (name, frames.get(name))
        openings = [
            (i, None)
            for i, r in enumerate(replay.scene.regions)
            if container is not None and r.parent in owners and r.name.endswith("/inside")
        ]
        out += openings or [(region, container)]
    return list(dict.fromkeys(out))


def _through(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Through: into it, and out on another side; through a street is along it."""
    reason = f"never is inside {q.goal}"
    lanes = {r.parent for r in replay.scene.regions if r.kind == "lane"}
    if any(replay.scene.bodies[j].name in lanes for j in _bodies(replay, q, body)):
        return _along(replay, q, body, path)
    for region, container in _passages(replay, q.target):
        if container == body:
            continue
        inside = inside_volume(replay, body, region, container)[0][q.window.frames]
        frames = np.flatnonzero(inside)
        if not len(frames):
            continue
        first, last = int(frames[0]), int(frames[-1])
        if first == 0 or last == len(inside) - 1:
            where = "starts" if first == 0 else "ends"
            reason = f"{where} inside {q.goal}"
            continue
        parent = container if region is None else replay.scene.index(
            replay.scene.regions[region].parent
        )  # fmt: skip
        assert parent is not None
        local = local_position(replay, body, parent)[q.window.frames]
        middle = local[first : last + 1].mean(axis=0)
        turned = angle_deg(middle - local[first - 1], local[last + 1] - middle)
        if turned <= 90.0:
            return Kept(True, {"time_s": float(replay.time[q.window.first + first])})
        reason = f"comes out of {q.goal} where it went in"
    return Kept(False, reason=reason)


def _around(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Around: it sees the target turn by much, on a course that bends; of the ground: it bends."""
    best = Kept(False, reason=f"does not move around {q.goal}")
    velocity = replay.velocity[q.window.frames, body, :2]
    fast = np.hypot(velocity[:, 0], velocity[:, 1]) > STILL_M
    course = np.unwrap(np.arctan2(velocity[fast, 1], velocity[fast, 0]))
    bend = float(np.degrees(np.ptp(course))) if len(course) else 0.0
    if q.target.ground or any(_within(replay, j, path) for j in q.target.bodies):
        reason = f"its course bends by {bend:.0f} degrees; limit {ROUND_DEG:.0f}"
        return Kept.when(bend >= ROUND_DEG, reason, bend_deg=bend)
    for other in (j for j in q.target.bodies if j != body):
        offset = path - replay.position[q.window.frames, other]
        bearing = np.unwrap(np.arctan2(offset[:, 1], offset[:, 0]))
        sweep = float(np.degrees(np.ptp(bearing)))
        reason = (
            f"goes {sweep:.0f} degrees around {q.goal}, its course bending by {bend:.0f}; "
            f"limits {AROUND_DEG:.0f} and {BEND_DEG:.0f}"
        )
        kept = sweep >= AROUND_DEG and bend >= BEND_DEG
        found = Kept.when(kept, reason, sweep_deg=sweep, bend_deg=bend)
        best = best if best.kept else found
    return best


def _within(replay: Replay, body: int, path: Floats) -> bool:
    """Whether a way lies on something flat from end to end: the ground, a yard."""
    half, at = replay.scene.bodies[body].half_extents, replay.position[0, body]
    flat = not replay.scene.bodies[body].collides
    return flat and bool((np.abs(path[:, :2] - at[:2]) <= np.array(half[:2])).all())


def _between(replay: Replay, q: StatementQuery, body: int, path: Floats) -> Kept:
    """Between: it crosses the line from one of the target to another."""
    others = [j for j in q.target.bodies if j != body]
    if len(others) < 2:
        return Kept(False, reason=f"{q.goal} are not two things")
    for i, j in itertools.combinations(others, 2):
        a = replay.position[q.window.frames, i, :2]
        b = replay.position[q.window.frames, j, :2]
        line, own = b - a, path[:, :2] - a
        side = line[:, 0] * own[:, 1] - line[:, 1] * own[:, 0]
        share = (own * line).sum(axis=1) / np.maximum((line * line).sum(axis=1), 1e-12)
        crosses = (side[:-1] * side[1:] <= 0) & (share[1:] > 0) & (share[1:] < 1)
        crosses &= side[:-1] != side[1:]
        if crosses.any():
            k = int(np.argmax(crosses)) + 1
            return Kept(
                True, {"time_s": float(replay.time[q.window.first + k]), "share": float(share[k])}
            )
    return Kept(False, reason=f"never crosses the line between {q.goal}")


_MEASURES: dict[str, Measure] = {
    "left": _of_viewer,
    "right": _of_viewer,
    "front": _of_viewer,
    "back": _of_viewer,
    "up": _upright,
    "down": _upright,
    "forward": _of_own,
    "backward": _of_own,
    "toward": _toward,
    "away_from": _away_from,
    "along": _along,
    "past": _past,
    "across": _across,
    "through": _through,
    "around": _around,
    "between": _between,
}
