"""Gestures as they are drawn: the parts that move, once in every state, each there in its time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.assets import build_mesh
from esg.assets.appearances import appearances
from esg.assets.postures import config_of, taken
from esg.engines.scene import SimScene
from esg.engines.wheels import gesturing
from esg.graph.casting import effective
from esg.lexicon.gestures import NONE, posed
from esg.units import CM_PER_M
from esg.view.pieces import Act, Part
from esg.view.seeing.geometries import mesh_parts

if TYPE_CHECKING:
    from esg.engines.scene import Body
    from esg.graph.models import EsgDocument

Floats = NDArray[np.float64]
STEP_S = 1.0 / 120.0
"""Times at which states are asked for."""
MOVED_M = 1e-4
"""A part of which no corner is farther from its place than this does not move."""
_Drawn = tuple[str, int, int]
"""A gesture and its state."""
_REST: _Drawn = ("", *NONE)


def with_gestures(
    parts: Sequence[Part],
    scene: SimScene,
    time: Floats,
    events: Mapping[str, float | None],
    doc: EsgDocument,
) -> list[Part]:
    """Parts of bodies with those that gestures move drawn in each of their states.

    Who steps has his gestures in the tracks of his arms.

    Args:
        parts: Of bodies, in their frames.
        scene: The bodies.
        time: Of the frames [s].
        events: Times of the events [s].
        doc: What the bodies are.
    """
    limbed = {p.body for p in parts if p.act is not None and p.act.track is not None}
    making = {i: b for i, b in enumerate(scene.bodies) if b.gestures and i not in limbed}
    if not making:
        return list(parts)
    out = [p for p in parts if p.body not in making]
    for index, body in making.items():
        own = [p for p in parts if p.body == index]
        if own:
            out += _in_states(own, body, _intervals(body, time, events), doc)
    return out


def _intervals(
    body: Body, time: Floats, events: Mapping[str, float | None]
) -> dict[_Drawn, tuple[tuple[float, float], ...]]:
    """When each state is there [s]."""
    fine = np.arange(0.0, float(time[-1]) + 0.5, STEP_S)
    drawn: list[_Drawn] = [_REST] * len(fine)
    for gesture in body.gestures:
        for k, (ease, sweep) in enumerate(gesturing(gesture, fine, events)):
            if ease:
                drawn[k] = (gesture.name, int(ease), int(sweep))
    out: dict[_Drawn, list[tuple[float, float]]] = {}
    begins = 0
    for k in range(1, len(fine) + 1):
        if k == len(fine) or drawn[k] != drawn[begins]:
            end = math.inf if k == len(fine) else float(fine[k])
            out.setdefault(drawn[begins], []).append((float(fine[begins]), end))
            begins = k
    return {state: tuple(when) for state, when in out.items()}


def _in_states(
    own: list[Part],
    body: Body,
    when: dict[_Drawn, tuple[tuple[float, float], ...]],
    doc: EsgDocument,
) -> list[Part]:
    """Parts of a body, those that move once for each state."""
    doc = effective(doc)
    held = {h.name: h for of in taken(doc).values() for h in of}
    posture = held.get(body.name)
    node = body.name if posture is None else posture.node
    look = appearances(doc)[node]
    look = look if posture is None else posture.drawn(look)
    config = config_of(doc, node)
    at_rest = {p.name: p for p in own}
    offset = np.array(body.origin_offset)
    states: dict[_Drawn, dict[str, Part]] = {}
    moved: set[str] = set()
    for state in when:
        if state == _REST:
            continue
        name, *steps = state
        mesh = build_mesh(config, replace(look, pose=posed(look.pose, name, (steps[0], steps[1]))))
        states[state] = {}
        for piece in mesh_parts(mesh, body.color):
            rest = at_rest.get(piece.name)
            if rest is None:
                continue
            vertices = piece.vertices / CM_PER_M + offset
            states[state][piece.name] = replace(
                rest, vertices=vertices, faces=piece.faces, normals=piece.normals, uvs=piece.uvs
            )
            same = vertices.shape == rest.vertices.shape
            if not same or float(np.abs(vertices - rest.vertices).max()) > MOVED_M:
                moved.add(piece.name)
    out = [p for p in own if p.name not in moved]
    if _REST in when:
        out += [replace(p, act=Act(there=when[_REST])) for p in own if p.name in moved]
    for state, drawn in states.items():
        act = Act(there=when[state])
        out += [replace(p, act=act) for name, p in drawn.items() if name in moved]
    return out
