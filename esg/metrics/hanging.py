"""What hangs in the air at the start although nothing the suite says lets it fall."""

from __future__ import annotations

import numpy as np

from esg.engines.rest import at_rest
from esg.metrics.binding import Binding
from esg.metrics.geometry import Core, compound_distance
from esg.metrics.joined import held, joined
from esg.metrics.models import SuiteScene
from esg.metrics.replay import Replay
from esg.thresholds import HANGS_M, MEETS_M

WATCH_S = 0.25
"""It falls if it does sink so far within this time (free fall: 31 cm), unless set in motion."""
BELOW_M = 0.1
"""What a falling body is said to meet lies below it, its outline not farther aside than this."""


def hanging(
    replay: Replay, suite_scene: SuiteScene, bindings: dict[str, Binding]
) -> tuple[str, ...]:
    """Names of bodies that start in the air and fall before anything happens.

    A body may start there if the program launches or holds it, if the suite lets it fall (from
    nothing, or from something it starts above), or if an event lets it meet something that it
    starts above: a stone dropped onto a bottle. Static bodies never fall.
    """
    last = replay.frame_at(WATCH_S)
    sunk = replay.position[0, :, 2] - replay.position[: last + 1, :, 2].min(axis=0)
    rests = at_rest(replay.scene)
    joints = joined(replay)
    out: list[str] = []
    for i, body in enumerate(replay.scene.bodies):
        if (
            body.static
            or not body.collides
            or replay.absent[0, i]
            or rests[i]
            or not sunk[i] > HANGS_M
        ):
            continue
        if (
            any(c.time <= WATCH_S for c in replay.motions(i))
            or held(joints, i, len(replay.time))[0]
        ):
            continue
        if _is_free_below(replay, i) and not _may_fall(replay, suite_scene, bindings, i):
            out.append(body.name)
    return tuple(out)


def _is_free_below(replay: Replay, i: int) -> bool:
    if replay.lowest(i, 0) < HANGS_M:
        return False
    lower = tuple(Core(c.points - (0.0, 0.0, HANGS_M), c.radius) for c in replay.placed(i, 0))
    return all(
        compound_distance(lower, replay.placed(j, 0), cutoff=0.0) >= -MEETS_M
        for j in range(len(replay.scene.bodies))
        if j != i and replay.cores[j] and not replay.absent[0, j]
    )


def _may_fall(
    replay: Replay, suite_scene: SuiteScene, bindings: dict[str, Binding], i: int
) -> bool:
    """Whether the suite says of a body that it falls."""
    for event in suite_scene.events:
        mine = [p for p in event.movers if i in bindings[p].bodies]
        others = [bindings[p] for p in event.participants if p not in mine]
        if not mine:
            continue
        if event.type == "falls" and event.from_ is None:
            return True
        if any(b.ground or b.point for b in others):
            return True
        if any(_is_above(replay, i, j) for b in others for j in _owners(replay, b)):
            return True
    return False


def _owners(replay: Replay, binding: Binding) -> set[int]:
    """The bodies that a phrase means, or whose regions it means."""
    parents = {replay.scene.regions[r].parent for r in binding.regions}
    return {*binding.bodies, *(replay.scene.index(p) for p in parents)}


def _is_above(replay: Replay, i: int, j: int) -> bool:
    """Whether a body starts over another one's outline, its lowest point above its middle."""
    (low, high), (base, top) = _box(replay, i), _box(replay, j)
    aside = np.maximum(base - high, low - top)[:2]
    return bool(np.all(aside <= BELOW_M) and low[2] >= 0.5 * (base[2] + top[2]))


def _box(replay: Replay, i: int) -> tuple[np.ndarray, np.ndarray]:
    cores = replay.placed_solid(i, 0)
    low = np.min([c.points.min(axis=0) - c.radius for c in cores], axis=0)
    return low, np.max([c.points.max(axis=0) + c.radius for c in cores], axis=0)
