"""Meshes of what shines, burns, falls from the sky and sways, moved by the time alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.assets.shows import FLAME, named, sketched
from esg.engines.scene import Body, Rollout, Shine, SimScene
from esg.engines.wheels import STEADY, phase_of, shining
from esg.lexicon.shown import Sway, Weather, weather_of
from esg.units import CM_PER_M
from esg.view.pieces import Act, Part
from esg.view.seeing.gestures import with_gestures
from esg.view.seeing.plumes import plume_parts

if TYPE_CHECKING:
    import trimesh

    from esg.graph.models import EsgDocument

Floats = NDArray[np.float64]

GLOW, HALO_GLOW, HALO_ALPHA = 1.6, 0.9, 0.3
"""Of what shines, and of the halo around it."""
HALO, HALO_M = 1.3, (0.02, 0.25)
"""Radius of a halo by that of what shines; and in metres: what is larger has none."""
SKIN, SKIN_M = 0.02, 0.002
"""What shines is drawn around the part that does, so much larger by its size and in metres."""
TONGUES, TONGUE_M = 5, (0.025, 1.4)
"""Flames on something, and the radius of one [m]."""
INNER = Look("", (1.0, 0.93, 0.6), 1.0, glow=1.5)
"""The bright middle of a flame."""
STRIPS = 28
"""What waves is cut into so many along its length."""
LAP, WAVES = 0.15, 7.0
"""They lap over by this share of one, and by so much lags the last behind the first [rad]."""
BOX_M, TOP_M, MOST = 9.0, 9.0, 4000
"""What falls is drawn so far around the action and so high [m], in so many pieces."""
COARSE_M = 8.0
"""Pieces are drawn larger where the action is wider than this: smaller ones are not seen."""
SEED = 20


def shown(scene: SimScene) -> bool:
    """Whether anything of a scene shines, sways, makes gestures or falls from the sky."""
    return bool(scene.weather) or any(
        b.shines or b.sways or b.gestures or b.gives_off for b in scene.bodies
    )


def with_shows(
    parts: Sequence[Part], scene: SimScene, rollout: Rollout, doc: EsgDocument
) -> list[Part]:
    """Parts of bodies with what shines and sways of them, and what falls around them.

    Args:
        parts: Of bodies, in their frames.
        scene: The bodies.
        rollout: Their motion.
        doc: Whose events tell when lights change.
    """
    if not shown(scene):
        return list(parts)
    events = event_times(doc, scene, rollout)
    time = np.asarray(rollout.time, float)
    parts = with_gestures(parts, scene, time, events, doc)
    out = [swayed for p in parts for swayed in _swaying(p, scene)]
    for index, body in enumerate(scene.bodies):
        lamps = any(shine.part != FLAME for shine in body.shines)
        drawn = sketched(doc, body.name) if lamps else []
        for shine in body.shines:
            own = [p.mesh() for p in named(drawn, shine.part)]
            out += _shining(index, body, shine, own, there(shine, time, events))
    out += plume_parts(scene, rollout, events)
    for noun in scene.weather:
        found = weather_of(noun)
        if found is not None and found[0].falls_mps:
            out.append(_falling(*found, rollout))
    return out


def shown_parts(
    parts: Sequence[Part], scene: SimScene, rollout: Rollout, doc: EsgDocument
) -> tuple[Part, ...]:
    """What exports add to the meshes of the bodies: of one that is redrawn, all of its parts.

    Args:
        parts, scene, rollout, doc: As of `with_shows`.
    """
    whole = [p for p in parts if p.body >= 0 and redrawn(scene.bodies[p.body])]
    return tuple(
        p if p.act is not None else replace(p, act=Act())
        for p in with_shows(whole, scene, rollout, doc)
    )


def redrawn(body: Body) -> bool:
    """Whether parts of a body's model move by the time alone."""
    return body.sways is not None or bool(body.gestures)


def event_times(doc: EsgDocument, scene: SimScene, rollout: Rollout) -> dict[str, float | None]:
    """When the events happened at which lights change and gestures begin and end [s]."""
    told = [s.event for b in scene.bodies for s in b.shines]
    told += [e for b in scene.bodies for g in b.gestures for e in (g.begins, g.ends)]
    told += [g.begins for b in scene.bodies for g in b.gives_off]
    if not any(told):
        return {}
    from esg.compile.scene import document_program
    from esg.metrics.expectations import expectations_from_timeline
    from esg.metrics.judging import judge

    asked = expectations_from_timeline(doc, scene).model_copy(update={"statements": ()})
    found = judge(scene, document_program(doc, scene), rollout, asked)
    return {e.id: e.time_s if e.completed else None for e in found.events}


def there(
    shine: Shine, time: Floats, events: Mapping[str, float | None]
) -> tuple[tuple[float, float], ...]:
    """The intervals in which a light shines [s], to a thousandth of a second."""
    fine = np.arange(0.0, float(time[-1]) + 0.5, 1e-3)
    on = np.concatenate([[False], shining(shine, fine, events), [False]]).astype(int)
    begins, ends = np.flatnonzero(np.diff(on) > 0), np.flatnonzero(np.diff(on) < 0)
    last = math.inf
    return tuple(
        (float(fine[a]), float(fine[b]) if b < len(fine) else last)
        for a, b in zip(begins, ends, strict=True)
    )


def _shining(
    index: int,
    body: Body,
    shine: Shine,
    meshes: Sequence[trimesh.Trimesh],
    when: tuple[tuple[float, float], ...],
) -> list[Part]:
    if shine.part == FLAME:
        return _flames(index, body, shine, when)
    look = Look("", shine.color, 0.6, glow=GLOW)
    halo = Look("", shine.color, 1.0, alpha=HALO_ALPHA, glow=HALO_GLOW)
    act = Act(there=when)
    out: list[Part] = []
    for drawn in meshes:
        mesh = drawn.copy()
        mesh.vertices = mesh.vertices / CM_PER_M + np.asarray(body.origin_offset)
        mesh.merge_vertices()
        large = max(SKIN_M, SKIN * 0.5 * float(np.ptp(mesh.vertices, axis=0).min()))
        skin = mesh.vertices + large * mesh.vertex_normals
        out.append(_plain(index, skin, mesh.faces, look, "light", act))
        for ball in _balls(mesh):
            out.append(_plain(index, ball.vertices, ball.faces, halo, "halo", act))
    return out


def _balls(mesh: trimesh.Trimesh) -> list[trimesh.Trimesh]:
    """A ball around each piece of a mesh that lies apart from the others."""
    import trimesh

    out: list[trimesh.Trimesh] = []
    boxes: list[Floats] = []
    for piece in mesh.split(only_watertight=False):
        low, high = piece.bounds
        near = next(
            (
                k
                for k, b in enumerate(boxes)
                if np.all(low < b[1] + 0.02) and np.all(high > b[0] - 0.02)
            ),
            -1,
        )
        if near < 0:
            boxes.append(np.array([low, high]))
        else:
            boxes[near] = np.array(
                [np.minimum(boxes[near][0], low), np.maximum(boxes[near][1], high)]
            )
    for low, high in boxes:
        radius = max(HALO * 0.5 * float(np.sort(high - low)[1:].mean()), HALO_M[0])
        if radius > HALO_M[1]:
            continue
        ball = trimesh.creation.icosphere(subdivisions=2, radius=radius)
        ball.apply_translation(0.5 * (low + high))
        out.append(ball)
    return out


def _plain(
    index: int, vertices: Floats, faces: NDArray[np.int64], look: Look, name: str, act: Act
) -> Part:
    return Part(
        index,
        np.asarray(vertices, float),
        np.asarray(faces),
        look.color,
        None,
        look,
        name=name,
        act=act,
    )


def _flames(
    index: int, body: Body, shine: Shine, when: tuple[tuple[float, float], ...]
) -> list[Part]:
    """Tongues on top of a body, that lean to and fro."""
    import trimesh

    size = 2.0 * np.asarray(body.half_extents)
    long, wide = float(size[:2].max()), float(size[:2].min())
    radius = float(np.clip(max(0.3 * wide, 0.07 * long), *TONGUE_M))
    count = 1 if long < 0.15 else TONGUES
    rng = np.random.default_rng([SEED, *body.name.encode()])
    spread = 0.3 * size[:2] * (count > 1)
    along = int(np.argmax(size[:2]))
    middle = np.zeros(2)
    if long > 4.0 * wide and count > 1:  # a stick burns at its end
        middle[along], spread[along] = 0.32 * long, 0.12 * long
    base = np.asarray(body.origin_offset)
    profile = np.array([(0.0, 0.0), (0.75, 0.25), (1.0, 0.7), (0.72, 1.5), (0.3, 2.4), (0.0, 3.2)])
    out: list[Part] = []
    for k in range(count):
        r = radius * float(rng.uniform(0.75, 1.1))
        at = np.append(middle + rng.uniform(-1.0, 1.0, 2) * spread, size[2] - 0.15 * r) + base
        x, y, z = (float(v) for v in at)
        period = float(rng.uniform(0.25, 0.5))
        act = Act(there=when, period_s=period, phase=2.4 * k, angle=0.2, pivot=(x, y, z))
        outer = Look("", shine.color, 1.0, alpha=0.6, glow=1.1)  # the inner one is seen through it
        for scale, lift, look in ((1.0, 0.15, outer), (0.6, 0.25, INNER)):
            flame = trimesh.creation.revolve(profile * r * scale, sections=10)
            lifted = flame.vertices + at + np.array([0.0, 0.0, lift * r])
            out.append(_plain(index, lifted, flame.faces, look, "flame", act))
    return out


def _swaying(part: Part, scene: SimScene) -> list[Part]:
    """A part as it sways; as it is where its body does not."""
    sways = scene.bodies[part.body].sways if part.body >= 0 else None
    if sways is None or (sways.parts and not part.name.startswith(sways.parts)):
        return [part]
    body = scene.bodies[part.body]
    angle, phase = math.radians(sways.degrees), phase_of(body)
    if sways.how == "bends":
        act = Act(
            period_s=sways.period_s,
            phase=phase,
            angle=(1.0 - STEADY) * angle,
            lean=STEADY * angle,
            pivot=body.origin_offset,
        )
        return [replace(part, act=act)]
    return _strips(part, body, sways, phase)


def _strips(part: Part, body: Body, sways: Sway, phase: float) -> list[Part]:
    """What waves, in strips: each moves across, more the farther it is from where it is held."""
    import trimesh

    low, high = part.box
    along = int(np.argmax((high - low)[:2]))
    length = float((high - low)[along])
    near = low[along] if abs(low[along]) < abs(high[along]) else high[along]
    toward = np.zeros(3)
    toward[along] = 1.0 if near == low[along] else -1.0
    across = np.roll(np.abs(toward[:2]), 1) * length * math.sin(math.radians(sways.degrees))
    mesh = trimesh.Trimesh(part.vertices, part.faces, process=False)
    look = None if part.look is None else replace(part.look, texture=None)
    out: list[Part] = []
    for k in range(STRIPS):
        begin, end = (length * (k + d) / STRIPS for d in (-LAP, 1.0 + LAP))
        strip = mesh
        for way, at in ((toward, begin), (-toward, end)):
            origin = np.zeros(3)
            origin[along] = near + toward[along] * at
            strip = strip.slice_plane(origin, way)
        if not len(strip.faces):
            continue
        share = (k + 0.5) / STRIPS
        x, y = (float(v) * share for v in across)
        act = Act(period_s=sways.period_s, phase=phase - WAVES * share, shift=(x, y, 0.0))
        vertices = np.asarray(strip.vertices, float)
        out.append(
            replace(part, vertices=vertices, faces=np.asarray(strip.faces), normals=None, uvs=None,
                    look=look, act=act)
        )  # fmt: skip
    return out


def _falling(row: Weather, much: float, rollout: Rollout) -> Part:
    """What falls all around the action: one mesh that repeats itself in the way it falls."""
    at = rollout.position[0].reshape(-1, 3)
    at = at[np.isfinite(at).all(axis=1) & (np.abs(at) < 200.0).all(axis=1)]
    low, high = (at.min(axis=0), at.max(axis=0)) if len(at) else (np.zeros(3), np.zeros(3))
    box = np.maximum(high - low, 0.0)[:2] + 2.0 * BOX_M
    coarse = float(np.clip(max(box) / (2.0 * BOX_M + COARSE_M), 1.0, 4.0))
    count = min(MOST, int(row.per_m3 * much * box.prod() * TOP_M / coarse**2))
    rng = np.random.default_rng([SEED, *row.name.encode()])
    start = 0.5 * (low + high)[:2] - 0.5 * box
    drops = np.append(start, 0.0) + rng.uniform(size=(count, 3)) * np.append(box, TOP_M)
    fall = np.array([row.drifts_mps, 0.3 * row.drifts_mps, -row.falls_mps])
    period = TOP_M / row.falls_mps
    way = fall / np.linalg.norm(fall)
    length, width = (0.005 * v * coarse for v in row.size_cm)
    vertices: list[Floats] = []
    for side in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)):
        across = np.cross(way, side)
        across = across / max(float(np.linalg.norm(across)), 1e-9)
        corners = np.array(
            [
                -way * length - across * width,
                -way * length + across * width,
                way * length + across * width,
                way * length - across * width,
            ]
        )
        # Once more above: what has left below comes in there.
        for lift in (0.0, 1.0):
            vertices.append((drops - lift * fall * period)[:, None] + corners)
    points = np.concatenate(vertices).reshape(-1, 3)
    first = 4 * np.arange(len(points) // 4)[:, None]
    quad = np.array([0, 1, 2, 0, 2, 3, 2, 1, 0, 3, 2, 0])
    faces = (first + quad).reshape(-1, 3)
    look = Look("", row.color, 1.0, glow=0.4)
    return Part(
        -1,
        points,
        faces,
        row.color,
        None,
        look,
        name=f"weather/{row.name}",
        act=Act(period_s=period, drift=(float(fall[0]), float(fall[1]), float(fall[2]))),
    )
