"""The contact sheet of a scene: before, at every event, after, from the replayed trajectory."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
import itertools
import math
import os
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Rollout, SimScene
from esg.graph.models import EsgDocument, RelationType
from esg.view.camera import Camera, box_corners, frame_points
from esg.view.parts import scene_parts
from esg.view.render import SAMPLES, Renderer
from esg.view.sheet import Panel, draw_trail, write_loop, write_sheet

if TYPE_CHECKING:
    from esg.metrics.models import EventVerdict, SceneVerdict

PANEL_PX = (480, 320)
LOOP_PX = (240, 160)
LOOP_FPS = 10
LOOP_FRAMES = 20
LOOP_LEAD_S = 0.8
"""The loop starts so long before the first event."""
ACTION_LEAD_S, ACTION_TAIL_S = 0.6, 0.4
"""Fixed cameras keep in view what happens so long before the first event and after the last."""
MAX_EVENTS = 7
REACH, FAR_REACH = 4.5, 14.0
"""Company joins the picture of an event, or the first and the last one, if the picture is then at
most so many times as wide as what must be seen."""
ROOM_ALONE = 0.9
"""Room on every side of a single body, in its own sizes."""
_UNITS = {"mps": "m/s", "m": "m", "s": "s", "deg": "deg", "ns": "N s", "kg": "kg"}


@dataclass(frozen=True)
class Shot:
    """One picture to take: frame of the rollout, camera, size [px] and rays a pixel."""

    frame: int
    camera: Camera
    size: tuple[int, int] = PANEL_PX
    samples: int = SAMPLES


@dataclass(frozen=True)
class _Moment:
    """One panel to draw: when, whom to frame, what to say."""

    time: float
    focus: tuple[int, ...]
    """Bodies that must be seen."""
    company: tuple[int, ...]
    """Bodies that are seen if they do not widen the picture too much."""
    title: str
    caption: str
    reach: float = REACH


def preview(
    scene: SimScene,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    doc: EsgDocument,
    folder: Path,
    *,
    note: str = "",
    loop: bool = True,
) -> Path:
    """Writes `preview.png`, the scene before, at every completed event and after, and a loop of it.

    Args:
        scene: The bodies.
        rollout: The replay; its first world is drawn.
        verdict: Events with their times; None or no events draws before and after only.
        doc: Asset configurations (meshes) and the prompt.
        folder: Where the files go.
        note: A line under the prompt, e.g. the outcome.
        loop: Also write `preview.webp`, the same action as a short animation.

    Returns:
        Path of the sheet.
    """
    moments = _moments(scene, rollout, verdict, doc)
    parts = scene_parts(scene, rollout, doc)
    renderers = [Renderer(parts, len(scene.bodies), *PANEL_PX) for _ in range(_threads())]
    view = _viewpoint(scene, rollout, moments, renderers[0])
    for renderer in renderers:
        renderer.light(view[0])
    shots: list[Shot] = []
    for moment in moments:
        frame = _frame(rollout, moment.time)
        shots.append(Shot(frame, _camera(scene, rollout, moment, frame, *view)))
    film = loop_shots(scene, rollout, moments, view) if loop else []
    images = _render(renderers, rollout, [*shots, *film])
    panels: list[Panel] = []
    since = 0.0
    for moment, shot, image in zip(moments, shots, images[: len(shots)], strict=True):
        trails = _trails(rollout, moment.focus, since, moment.time)
        image = draw_trail(image, shot.camera, trails)
        panels.append(Panel(image, moment.title, moment.caption))
        since = moment.time
    if loop:
        write_loop(folder / "preview.webp", images[len(shots) :], round(1000 / LOOP_FPS))
    return write_sheet(
        folder / "preview.png",
        panels,
        title=doc.scene_definition.original_description,
        note=note,
        footnotes=_failures(verdict),
    )


def _threads() -> int:
    """Pictures drawn at once: the tracer runs on one core, so two draw where two are free."""
    limit = os.environ.get("OMP_NUM_THREADS", "")
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1
    return max(1, min(2, cores, int(limit) if limit.isdigit() else 2))


def _render(
    renderers: Sequence[Renderer], rollout: Rollout, shots: Sequence[Shot]
) -> list[NDArray[np.uint8]]:
    """One picture a shot, dealt out to the renderers; which one draws makes no difference."""

    def draw(k: int) -> list[NDArray[np.uint8]]:
        out: list[NDArray[np.uint8]] = []
        for shot in shots[k :: len(renderers)]:
            _pose(renderers[k], rollout, shot.frame)
            out.append(renderers[k].color(shot.camera, shot.size, shot.samples))
        return out

    if len(renderers) == 1:
        return draw(0)
    # Kernels are compiled at their first launch: not by two threads at once.
    first = shots[0]
    _pose(renderers[0], rollout, first.frame)
    renderers[0].color(first.camera, (8, 8), first.samples)
    with ThreadPoolExecutor(len(renderers)) as pool:
        dealt = list(pool.map(draw, range(len(renderers))))
    return [dealt[i % len(renderers)][i // len(renderers)] for i in range(len(shots))]


def loop_shots(
    scene: SimScene, rollout: Rollout, moments: Sequence[_Moment], view: tuple[float, float]
) -> list[Shot]:
    """Frames of the loop: from shortly before the first event to shortly after the last.

    The camera goes smoothly from one moment's framing to the next.
    """
    start, end = moments[0].time, moments[-1].time
    if len(moments) > 2:
        start = max(start, moments[1].time - LOOP_LEAD_S)
    count = int(min(LOOP_FRAMES, max(2, round((end - start) * LOOP_FPS))))
    times = np.linspace(start, end, count)
    stops = moments[1:] if len(moments) > 2 else moments
    cameras = [_camera(scene, rollout, m, _frame(rollout, m.time), *view) for m in stops]
    marks = np.array([m.time for m in stops])
    shots: list[Shot] = []
    for time in times:
        eye, target = (
            tuple(
                float(np.interp(time, marks, [getattr(c, key)[axis] for c in cameras]))
                for axis in range(3)
            )
            for key in ("eye", "target")
        )
        camera = Camera(eye, target)  # type: ignore[arg-type]  # three floats each
        shots.append(Shot(_frame(rollout, float(time)), camera, LOOP_PX, 2))
    return shots


def _moments(
    scene: SimScene, rollout: Rollout, verdict: SceneVerdict | None, doc: EsgDocument
) -> list[_Moment]:
    events = [e for e in verdict.events if e.completed and e.time_s is not None] if verdict else []
    events = sorted(events, key=lambda e: e.time_s or 0.0)[:MAX_EVENTS]
    cast = _cast(scene, rollout, verdict)
    company = _company(scene, doc, cast)
    end = float(rollout.time[-1])
    if events:
        # A moment after the last event, not the end of a long tail in which everything is still.
        end = min(end, (events[-1].time_s or 0.0) + 1.0)
    moments = [_Moment(0.0, cast, company, "start", "before anything moves", FAR_REACH)]
    for number, event in enumerate(events, 1):
        bodies = tuple(scene.index(b) for b in event.bodies if b in scene.names) or cast
        mates = tuple(i for i in company if len(bodies) < 2 or _same_group(scene, i, bodies))
        moments.append(
            _Moment(
                event.time_s or 0.0,
                bodies,
                mates,
                f"{number}  {_title(scene, event)}",
                _measurements(event),
            )
        )
    moments.append(_Moment(end, cast, company, "after", f"t = {end:.2f} s", FAR_REACH))
    return moments


def _same_group(scene: SimScene, body: int, others: Sequence[int]) -> bool:
    group = scene.bodies[body].group
    return bool(group) and any(scene.bodies[i].group == group for i in others)


def _company(scene: SimScene, doc: EsgDocument, cast: tuple[int, ...]) -> tuple[int, ...]:
    """Who belongs to the cast: its groups, what it stands on, what else the prompt names.

    What is flat belongs to nobody.
    """
    names = {scene.bodies[i].name for i in cast}
    nodes = doc.spatial_relation_graph.nodes
    regions = doc.spatial_relation_graph.semantic_regions
    supports = {
        edge.to
        for edge in doc.spatial_relation_graph.edges.binary_relations
        if edge.relation_type in (RelationType.ON, RelationType.INSIDE_OF) and edge.from_ in names
    }
    for name in names & set(nodes):
        region = regions.get(nodes[name].semantic_region or "")
        supports |= {region.parent_object} if region else set()
    return tuple(
        i
        for i, b in enumerate(scene.bodies)
        if i not in cast
        and b.collides
        and (b.mentioned or _same_group(scene, i, cast) or b.name in supports)
    )


def _cast(scene: SimScene, rollout: Rollout, verdict: SceneVerdict | None) -> tuple[int, ...]:
    """Bodies the picture is about: event participants, else movers, else what the prompt names."""
    names = [b for e in verdict.events for b in e.bodies] if verdict else []
    cast = {scene.index(n) for n in names if n in scene.names}
    if not cast and verdict is not None:
        cast = {scene.index(b) for v in verdict.bindings.values() for b in v if b in scene.names}
    if not cast:
        travelled = np.linalg.norm(rollout.position[0, -1] - rollout.position[0, 0], axis=-1)
        cast = {i for i, b in enumerate(scene.bodies) if not b.static and travelled[i] > 0.3}
    if not cast:
        cast = {i for i, b in enumerate(scene.bodies) if b.mentioned and b.collides}
    return tuple(sorted(cast)) or tuple(range(len(scene.bodies)))


def _name(scene: SimScene, name: str) -> str:
    if name not in scene.names:
        return name
    return scene.body(name).label or name.replace("_", " ")


def _title(scene: SimScene, event: EventVerdict) -> str:
    who = [_name(scene, b) for b in event.bodies]
    joiner = " x " if event.type == "collision" else ", "
    shown = joiner.join(who[:2]) + (f" +{len(who) - 2}" if len(who) > 2 else "")
    return f"{event.type}: {shown}"


def _measurements(event: EventVerdict) -> str:
    """Time and what was measured, in the units of the measurement's name; zeros say nothing."""
    parts = [f"t = {event.time_s:.2f} s"]
    for key, value in event.measured.items():
        name, _, unit = key.rpartition("_")
        if name in ("", "time") or unit not in _UNITS or round(abs(value), 2) == 0.0:
            continue
        parts.append(f"{name.replace('_', ' ')} {_number(value)} {_UNITS[unit]}")
    return "   ".join(parts[:4])


def _number(value: float) -> str:
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def _failures(verdict: SceneVerdict | None) -> list[str]:
    if verdict is None:
        return []
    lines = [
        f"{e.type} {' x '.join(e.bodies)}: not completed ({e.reason or 'no reason given'})"
        for e in verdict.events
        if not e.completed
    ]
    layout = verdict.layout
    lines += [f"missing: {m}" for m in layout.missing]
    lines += [f"overlap: {o.a} and {o.b}, {100 * o.depth_m:.1f} cm" for o in layout.overlaps]
    return lines


def _frame(rollout: Rollout, time: float) -> int:
    return int(np.argmin(np.abs(rollout.time - time)))


def _pose(renderer: Renderer, rollout: Rollout, frame: int) -> None:
    renderer.pose(rollout.position[0, frame], rollout.quaternion[0, frame])


def _corners(scene: SimScene, rollout: Rollout, frame: int, body: int) -> NDArray[np.float64]:
    b = scene.bodies[body]
    return box_corners(
        rollout.position[0, frame, body],
        rollout.quaternion[0, frame, body],
        b.half_extents,
        np.asarray(b.origin_offset),
    )


def _frame_set(
    scene: SimScene, rollout: Rollout, moment: _Moment, frame: int
) -> NDArray[np.float64]:
    """Points to keep in the picture: the focus, then its company while the picture stays close.

    Of a large focus, bodies that have flown off are left out in the same way.
    """
    boxes = {i: _corners(scene, rollout, frame, i) for i in (*moment.focus, *moment.company)}
    movers = [i for i in moment.focus if not scene.bodies[i].static] or list(moment.focus)
    middle = np.median([boxes[i].mean(axis=0) for i in movers], axis=0)

    def nearest_first(bodies: Sequence[int]) -> list[int]:
        return sorted(bodies, key=lambda i: (float(np.linalg.norm(boxes[i].mean(0) - middle)), i))

    order = nearest_first(moment.focus)
    keep = order if len(order) <= 4 else order[:2]
    points = np.concatenate([boxes[i] for i in keep])
    limit = moment.reach * float(np.ptp(points, axis=0).max())
    for i in [*(j for j in order if j not in keep), *nearest_first(moment.company)]:
        wider = np.concatenate([points, boxes[i]])
        if float(np.ptp(wider, axis=0).max()) <= limit:
            points = wider
    return points


def _camera(
    scene: SimScene,
    rollout: Rollout,
    moment: _Moment,
    frame: int,
    azimuth: float,
    elevation: float,
) -> Camera:
    points = _frame_set(scene, rollout, moment, frame)
    span = float(np.ptp(points, axis=0).max())
    # A little room around the action, so that one sees where it happens.
    low, high = points.min(axis=0), points.max(axis=0)
    pad = (ROOM_ALONE if len(points) == 8 else 0.06) * span
    low = np.array([low[0] - pad, low[1] - pad, max(0.0, low[2] - pad)])
    high = high + np.array([pad, pad, 0.0])
    corners = np.array(list(itertools.product(*zip(low, high, strict=True))))
    return frame_points(corners, azimuth, elevation, PANEL_PX[0] / PANEL_PX[1])


def _viewpoint(
    scene: SimScene, rollout: Rollout, moments: list[_Moment], renderer: Renderer
) -> tuple[float, float]:
    """Azimuth and elevation from which the cast is seen best over all moments.

    The natural place is beside the motion, on the viewer's (+Y) side; other directions compete by
    how much of every framed body is visible at every moment.
    """
    side = _beside(_motion_direction(scene, rollout, moments))
    best, best_score = (side, math.radians(24)), -math.inf
    # First, last and the middle moment stand for all: this is half of the work otherwise.
    moments = [moments[k] for k in sorted({0, len(moments) // 2, len(moments) - 1})]
    for turn in (0, 30, -30, 60, -60, 180):
        for elevation in (24, 42):
            view = (side + math.radians(turn), math.radians(elevation))
            seen = []
            for moment in moments:
                frame = _frame(rollout, moment.time)
                _pose(renderer, rollout, frame)
                camera = _camera(scene, rollout, moment, frame, *view)
                seen.append(_visibility(scene, rollout, moment, frame, camera, renderer))
            preference = 0.0015 * abs(turn) + 0.004 * abs(elevation - 24)
            score = min(seen) + 0.5 * sum(seen) / len(seen) - preference
            if score > best_score + 1e-9:
                best, best_score = view, score
    return best


def _visibility(
    scene: SimScene,
    rollout: Rollout,
    moment: _Moment,
    frame: int,
    camera: Camera,
    renderer: Renderer,
) -> float:
    """Mean over the focus of visible pixels over those of its projected box, capped at 1."""
    width, height = 72, 48
    counts = renderer.visible(camera, moment.focus, width)
    shares = []
    for body in moment.focus:
        pixels, ahead = camera.project(_corners(scene, rollout, frame, body), width, height)
        if not ahead.all():
            shares.append(0.0)
            continue
        area = float(np.prod(np.maximum(np.ptp(pixels, axis=0), 1.0)))
        shares.append(min(1.0, counts[body] / (0.45 * area)))
    return sum(shares) / max(1, len(shares))


def _motion_direction(
    scene: SimScene, rollout: Rollout, moments: list[_Moment]
) -> NDArray[np.float64]:
    last = _frame(rollout, moments[-1].time)
    moved = rollout.position[0, last] - rollout.position[0, 0]
    focus = sorted({i for m in moments for i in m.focus})
    longest = max(focus, key=lambda i: float(np.linalg.norm(moved[i, :2])))
    if float(np.linalg.norm(moved[longest, :2])) > 0.2:
        return moved[longest, :2].astype(float)
    centers = rollout.position[0, 0, focus, :2].astype(float)
    if len(focus) > 1:
        spread = centers - centers.mean(axis=0)
        return np.linalg.svd(spread)[2][0]
    return np.array([1.0, 0.0])


def action_points(
    scene: SimScene,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    doc: EsgDocument,
    steps: int,
) -> NDArray[np.float64]:
    """Corners of what the scene is about at `steps` instants around its events.

    Without events, from the start to the end.

    Args:
        scene: The bodies.
        rollout: Their motion.
        verdict: Events, whose participants count.
        doc: Relations, for what the participants stand on.
        steps: Number of instants.

    Returns:
        World points [m], shape [n, 3].
    """
    moments = _moments(scene, rollout, verdict, doc)
    first, start, end = moments[0], moments[0].time, moments[-1].time
    if len(moments) > 2:
        start = max(start, moments[1].time - ACTION_LEAD_S)
        end = min(end, moments[-2].time + ACTION_TAIL_S)
    points = [
        _frame_set(scene, rollout, replace(first, reach=REACH), _frame(rollout, float(time)))
        for time in np.linspace(start, end, steps)
    ]
    return np.concatenate(points)


def facing_side(
    scene: SimScene, rollout: Rollout, verdict: SceneVerdict | None, doc: EsgDocument
) -> float:
    """Azimuth beside the motion, on the viewer's (+Y) side [rad]."""
    return _beside(_motion_direction(scene, rollout, _moments(scene, rollout, verdict, doc)))


def _beside(along: NDArray[np.float64]) -> float:
    side = math.atan2(along[1], along[0]) + math.pi / 2
    return side + math.pi if math.sin(side) < -1e-6 else side


def _trails(
    rollout: Rollout, bodies: Sequence[int], start: float, end: float
) -> list[NDArray[np.float64]]:
    a, b = _frame(rollout, start), _frame(rollout, end)
    trails = []
    for body in bodies:
        path = rollout.position[0, a : b + 1, body].astype(float)
        if len(path) > 1 and float(np.linalg.norm(path[-1] - path[0])) > 0.15:
            trails.append(path)
    return trails
