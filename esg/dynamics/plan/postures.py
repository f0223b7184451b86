"""Postures as bodies of the physical scene (SI), and when one takes the place of another."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np

from esg.assets.postures import Held, at_first, held, taken
from esg.dynamics.story.stagecraft import top_surface
from esg.dynamics.story.story import Phase
from esg.engines.program import ChangeBody, Vec
from esg.engines.scene import Body, Shape, SimScene, stand_in
from esg.graph.casting import effective
from esg.graph.models import EsgDocument
from esg.lexicon.postures import STANDS
from esg.units import quat_rotate, yaw_from_quat

HALTS_MPS2 = 6.0
"""How fast who sits, lies or kneels down comes to a halt before."""
HALTED_S = 0.35
"""How long that takes [s]."""
FIRST_S = 0.8
"""How long somebody is as he was at first who does nothing but change that [s]."""
CLEAR_M = 0.06
"""Gap between who has got up and what he sat on."""


def with_postures(doc: EsgDocument, scene: SimScene) -> SimScene:
    """A scene with a body more for every posture that one of its bodies takes."""
    own = taken(doc)
    if not own:
        return scene
    out: list[Body] = []
    more: list[Body] = []
    for body in scene.bodies:
        mine = own.get(body.name, ()) if body.shapes and not body.static else ()
        joined = any(body.name in (j.child, j.parent) for j in scene.joints)
        if joined or body.fragments:
            mine = ()
        more += [_in_posture(body, h) for h in mine]
        out.append(replace(body, postures=tuple(h.name for h in mine)))
    return scene.with_bodies((*out, *more))


def _in_posture(body: Body, h: Held) -> Body:
    """A body as a box of the size of its posture, its lowest point where that of the body is."""
    x, y, z = body.half_extents
    standing = (2.0 * x, 2.0 * y, 2.0 * z)
    size = h.row.size(standing)
    a, b, c = half = (0.5 * size[0], 0.5 * size[1], 0.5 * size[2])
    ahead = h.row.middle(standing)
    foot = np.array(body.origin_offset)
    middle = foot + np.array([ahead, 0.0, c])
    at = np.array(body.position) + quat_rotate(np.array(body.quaternion), middle)
    share = body.mass / 3.0
    moments = (share * (b * b + c * c), share * (a * a + c * c), share * (a * a + b * b))
    return stand_in(
        body,
        name=h.name,
        shapes=(Shape("box", half),),
        inertia=((moments[0], 0.0, 0.0), (0.0, moments[1], 0.0), (0.0, 0.0, moments[2])),
        position=_vec(at),
        origin_offset=(-ahead, 0.0, -c),
        half_extents=half,
        mesh=h.mesh,
        drawn=(),
    )


def first_postures(doc: EsgDocument, scene: SimScene) -> tuple[ChangeBody, ...]:
    """The changes with which a scene begins: those who do not stand at the start."""
    found = at_first(effective(doc))
    return tuple(ChangeBody(n, 0.0, h.name) for n, h in found.items() if h.name in scene.names)


def change(
    doc: EsgDocument, scene: SimScene, phase: Phase, start: float, now: str | None
) -> ChangeBody | None:
    """The change of a phase; None where its actor has no such posture.

    Args:
        doc: The document.
        scene: Its physical scene.
        phase: In which somebody takes a posture.
        start: When [s].
        now: What he is on till then, that is no ground.
    """
    actor, target = phase.edge.actor, phase.edge.target
    if target is None and phase.edge.params.posture == STANDS:
        return risen(doc, scene, actor, start, now)
    found = held(doc, actor, phase.edge.params.posture or "", target)
    if found is None or found.name not in scene.names:
        return None
    body = scene.body(actor)
    foot = np.array(body.origin_offset)
    if target in scene.names and target != now:
        seat, top = scene.body(target), top_surface(doc, target)
        middle = np.array(top.center_cm) / 100.0 + np.array(seat.origin_offset)
        at = np.array(seat.position) + quat_rotate(np.array(seat.quaternion), middle)
        heading = float(yaw_from_quat(seat.quaternion))
        if found.row.posture == "lies" and top.half_extents_cm[1] > top.half_extents_cm[0]:
            heading += 0.5 * math.pi  # along a sofa
        return ChangeBody(actor, start, found.name, _standing(at, heading, foot), heading)
    return ChangeBody(actor, start, found.name)


def risen(
    doc: EsgDocument, scene: SimScene, actor: str, start: float, now: str | None
) -> ChangeBody | None:
    """The change of who gets up: where he is, or off what he is on to the ground before it.

    Args:
        doc, scene, start, now: As of `change`.
        actor: Who.
    """
    body = scene.body(actor)
    if not body.postures:
        return None
    foot = np.array(body.origin_offset)
    if now is not None and now in scene.names:
        seat, heading = scene.body(now), float(yaw_from_quat(body.quaternion))
        ahead = np.array([math.cos(heading), math.sin(heading), 0.0])
        far = _reach(seat, ahead) + body.half_extents[0] + CLEAR_M
        at = np.array([*np.array(seat.position)[:2], 0.0])
        across = np.array([-ahead[1], ahead[0], 0.0])
        aside = float((np.array(body.position) - np.array(seat.position)) @ across)
        at = at + far * ahead + aside * across
        return ChangeBody(actor, start, actor, _standing(at, heading, foot), heading)
    return ChangeBody(actor, start, actor)


def _standing(at: np.ndarray, heading: float, foot: np.ndarray) -> Vec:
    """Where the centre of mass is of a body that stands at a place."""
    turn = np.array([0.0, 0.0, math.sin(0.5 * heading), math.cos(0.5 * heading)])
    return _vec(at - quat_rotate(turn, foot))


def _reach(body: Body, way: np.ndarray) -> float:
    """How far a body reaches one way from its centre of mass [m]."""
    x, y, z = body.half_extents
    middle = quat_rotate(
        np.array(body.quaternion), np.array(body.origin_offset) + np.array([0.0, 0.0, z])
    )
    axes = quat_rotate(np.array(body.quaternion), np.diag([x, y, z]))
    return float(middle @ way + np.abs(axes @ way).sum())


def _vec(v: np.ndarray) -> Vec:
    return (float(v[0]), float(v[1]), float(v[2]))
