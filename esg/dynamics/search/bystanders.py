"""Bodies that no event is about: the reference engine holds them still until they are touched.

What rests where it starts, and is neither in the timeline nor near anything that is, changes
nothing unless it is touched. So worlds are played with such bodies fixed; a world in which one of
them is touched is played again with everything that can move. So is, once, what a search found.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.plan import Plan
from esg.engines.program import batch_programs
from esg.engines.rest import at_rest, close_pairs
from esg.engines.scene import Rollout, SimScene

CLEAR_M = 0.05
"""Nearer than this to what takes part, a body takes part itself."""
WORTH_SHAPES = 16
"""With fewer parts than this to hold still, playing the whole scene at the end costs more."""

Bools = NDArray[np.bool_]


def bystanders(plan: Plan) -> Bools:
    """Bodies that may be held still, shape [B]: none where that would not pay."""
    scene = plan.scene
    moves = np.array([b.collides and not b.static for b in scene.bodies], bool)
    cast = _cast(plan) | (moves & ~at_rest(scene))
    near = close_pairs(scene, CLEAR_M) & moves[None]
    while (more := cast | near[cast].any(axis=0)).sum() > cast.sum():
        cast = more
    idle = moves & ~cast
    parts = sum(len(b.shapes) for b, still in zip(scene.bodies, idle, strict=True) if still)
    return idle if parts >= WORTH_SHAPES else np.zeros_like(idle)


def held(scene: SimScene, still: Bools) -> SimScene:
    """The scene with some bodies fixed."""
    bodies = zip(scene.bodies, still, strict=True)
    return scene.with_bodies(tuple(replace(b, static=True) if s else b for b, s in bodies))


def touched(rollout: Rollout, still: Bools) -> Bools:
    """Worlds in which something touched a body that was held still, shape [W]."""
    log = rollout.contacts
    between = log.b >= 0
    hit = between & (still[log.a] != still[np.where(between, log.b, log.a)])
    out = np.zeros(len(rollout.valid), bool)
    out[log.world[hit]] = True
    return out


def _cast(plan: Plan) -> Bools:
    """Bodies that the timeline or the program names, shape [B]."""
    scene, story = plan.scene, plan.story
    names = set(story.phases)
    for node in story.nodes.values():
        named = [*node.participants, *(c.object for c in node.constraints)]
        named += [c.to for c in node.constraints if c.to]
        if node.region:
            named.append(node.region.split("/")[0])
        names.update(member for name in named for member in story.expand(name))
    batch = batch_programs([plan.compile(plan.initial())], scene.names)
    out = np.array([b.name in names or b.active for b in scene.bodies], bool)
    out[batch.body[batch.body >= 0]] = True
    return out | batch.until.any(axis=0)
