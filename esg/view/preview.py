"""The contact sheet of a scene: before, at every event, after, from the replayed trajectory."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
import os
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.engines.joints import joint_ends, joint_poses
from esg.engines.scene import Rollout, SimScene
from esg.engines.wheels import scene_angles
from esg.graph.models import EsgDocument
from esg.thresholds import PIECE_GAP_M
from esg.view.camera import Camera
from esg.view.framing import (
    PANEL_PX,
    camera_for,
    camera_of_moment,
    corners_of,
    frame_at,
    pose,
    viewpoint,
)
from esg.view.moments import Moment, failures, moments_of
from esg.view.render import SAMPLES, Renderer
from esg.view.scenery import scenery_of, seen_from
from esg.view.sheet import Panel, draw_ropes, draw_trail, write_loop, write_sheet

if TYPE_CHECKING:
    from esg.metrics.models import SceneVerdict

LOOP_PX = (240, 160)
LOOP_FPS = 10
LOOP_FRAMES = 20
LOOP_LEAD_S = 0.8
"""The loop starts so long before the first event."""


@dataclass(frozen=True)
class Shot:
    """One picture to take: frame of the rollout, camera, size [px] and rays a pixel."""

    frame: int
    camera: Camera
    size: tuple[int, int] = PANEL_PX
    samples: int = SAMPLES


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
    moments = moments_of(scene, rollout, verdict, doc)
    scenery = scenery_of(scene, rollout, doc)
    finder = Renderer(scenery.parts, scenery.n_bodies, *PANEL_PX)
    view = viewpoint(scene, rollout, moments, finder)
    shots: list[Shot] = []
    for moment in moments:
        frame = frame_at(rollout, moment.time)
        shots.append(Shot(frame, camera_of_moment(scene, rollout, moment, view, finder)))
    film = loop_shots(scene, rollout, moments, view) if loop else []
    seen = seen_from(scenery, [shot.camera for shot in (*shots, *film)], scene, rollout)
    renderers = [
        Renderer(seen.parts, seen.n_bodies, *PANEL_PX, seen.surroundings) for _ in range(_threads())
    ]
    for renderer in renderers:
        renderer.light(view[0])
    images = [
        draw_ropes(image, shot.camera, ropes_at(scene, rollout, shot.frame))
        for shot, image in zip(
            [*shots, *film],
            _render(renderers, rollout, scene_angles(scene, rollout), [*shots, *film]),
            strict=True,
        )
    ]
    panels: list[Panel] = []
    since = 0.0
    for moment, shot, image in zip(moments, shots, images[: len(shots)], strict=True):
        trails = _trails(rollout, moment.focus, since, moment.time)
        specks = [] if panels else [corners_of(scene, rollout, shot.frame, i) for i in moment.focus]
        image = draw_trail(image, shot.camera, trails, specks)
        panels.append(Panel(image, moment.title, moment.caption))
        since = moment.time
    if loop:
        write_loop(folder / "preview.webp", images[len(shots) :], round(1000 / LOOP_FPS))
    return write_sheet(
        folder / "preview.png",
        panels,
        title=doc.scene_definition.original_description,
        note=note,
        footnotes=failures(scene, verdict),
    )


def ropes_at(scene: SimScene, rollout: Rollout, frame: int) -> list[NDArray[np.float64]]:
    """Ends [m] of the ropes and springs that hold at a frame of the first world, each [2, 3]."""
    p, q = rollout.position[0, frame], rollout.quaternion[0, frame]
    out: list[NDArray[np.float64]] = []
    for joint in scene.joints:
        if not joint.flexible:
            continue
        ends = np.array(joint_ends(joint, *joint_poses(scene, joint, p, q)))
        slack = joint.upper if joint.kind == "rope" and joint.upper is not None else np.inf
        if float(np.linalg.norm(ends[1] - ends[0])) <= slack + PIECE_GAP_M:
            out.append(ends)
    return out


def _threads() -> int:
    """Pictures drawn at once: the tracer runs on one core, so two draw where two are free."""
    limit = os.environ.get("OMP_NUM_THREADS", "")
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1
    return max(1, min(2, cores, int(limit) if limit.isdigit() else 2))


def _render(
    renderers: Sequence[Renderer],
    rollout: Rollout,
    angles: NDArray[np.float64],
    shots: Sequence[Shot],
) -> list[NDArray[np.uint8]]:
    """One picture a shot, dealt out to the renderers; which one draws makes no difference."""

    def draw(k: int) -> list[NDArray[np.uint8]]:
        out: list[NDArray[np.uint8]] = []
        for shot in shots[k :: len(renderers)]:
            pose(renderers[k], rollout, shot.frame, angles)
            out.append(renderers[k].color(shot.camera, shot.size, shot.samples))
        return out

    if len(renderers) == 1:
        return draw(0)
    # Kernels are compiled at their first launch: not by two threads at once.
    first = shots[0]
    pose(renderers[0], rollout, first.frame)
    renderers[0].color(first.camera, (8, 8), first.samples)
    with ThreadPoolExecutor(len(renderers)) as pool:
        dealt = list(pool.map(draw, range(len(renderers))))
    return [dealt[i % len(renderers)][i // len(renderers)] for i in range(len(shots))]


def loop_shots(
    scene: SimScene, rollout: Rollout, moments: Sequence[Moment], view: tuple[float, float]
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
    cameras = [camera_for(scene, rollout, m, frame_at(rollout, m.time), *view) for m in stops]
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
        shots.append(Shot(frame_at(rollout, float(time)), camera, LOOP_PX, 2))
    return shots


def _trails(
    rollout: Rollout, bodies: Sequence[int], start: float, end: float
) -> list[NDArray[np.float64]]:
    a, b = frame_at(rollout, start), frame_at(rollout, end)
    trails = []
    for body in bodies:
        path = rollout.position[0, a : b + 1, body].astype(float)
        if len(path) > 1 and float(np.linalg.norm(path[-1] - path[0])) > 0.15:
            trails.append(path)
    return trails
