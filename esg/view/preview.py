"""The contact sheet of a scene: before, at every event, after, from the replayed trajectory."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
import os
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.engines.breaking import shown
from esg.engines.scene import Rollout, SimScene
from esg.graph.models import EsgDocument
from esg.view.camera import Camera
from esg.view.director.acting import Action
from esg.view.director.staging import azimuth_of
from esg.view.director.told import told_of
from esg.view.film.encoding import NoFilmError
from esg.view.film.shooting import write_scene_film
from esg.view.filmed import said_take
from esg.view.framing import (
    PANEL_PX,
    camera_of_moment,
    corners_of,
    frame_at,
    pose,
    told_side,
    viewpoint,
)
from esg.view.moments import as_seen, failures, moments_of
from esg.view.parts import ground_parts
from esg.view.pieces import clocked
from esg.view.render import SAMPLES, Renderer
from esg.view.ropes import ropes_at
from esg.view.scenery import scenery_of, seen_from
from esg.view.sheet import Panel, draw_ropes, draw_trail, write_sheet
from esg.view.surroundings import surroundings_of
from esg.workers import usable_cores

if TYPE_CHECKING:
    from esg.metrics.models import SceneVerdict

FILM = "preview.mp4"


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
    lost: Callable[[], Sequence[str]] = tuple,
) -> Path:
    """Writes `preview.png`, the scene before, at every completed event and after.

    Args:
        scene: The bodies.
        rollout: The replay; its first world is drawn.
        verdict: Events with their times; None or no events draws before and after only.
        doc: Asset configurations (meshes) and the prompt.
        folder: Where the files go.
        note: A line under the prompt, e.g. the outcome.
        lost: What the sheet has to say at its foot of other files: why there is no film.

    Returns:
        Path of the sheet.
    """
    scene = as_seen(scene, doc)
    moments = moments_of(scene, rollout, verdict, doc)
    scenery = scenery_of(scene, rollout, doc)
    finder = Renderer(scenery.parts, scenery.n_bodies, *PANEL_PX)
    said = said_take(doc, scene, rollout, PANEL_PX[0] / PANEL_PX[1])
    if said is None:
        view = viewpoint(scene, rollout, moments, finder, told_side(doc))
        cameras = [camera_of_moment(scene, rollout, m, view, finder) for m in moments]
    else:
        cameras = said.at([m.time for m in moments]).cameras
        view = (azimuth_of(said), 0.0)
    frames = [frame_at(rollout, moment.time) for moment in moments]
    shots = [Shot(frame, camera) for frame, camera in zip(frames, cameras, strict=True)]
    seen = seen_from(scenery, [shot.camera for shot in shots], scene, rollout)
    renderer = Renderer(seen.parts, seen.n_bodies, *PANEL_PX, seen.surroundings)
    renderer.light(view[0])
    renderers = [renderer, *(renderer.twin() for _ in range(1, _threads()))]
    images = [
        draw_ropes(image, shot.camera, ropes_at(scene, rollout, shot.frame))
        for shot, image in zip(
            shots,
            _render(renderers, shown(scene, rollout), clocked(scene, rollout), shots),
            strict=True,
        )
    ]
    panels: list[Panel] = []
    since = 0.0
    for moment, shot, image in zip(moments, shots, images, strict=True):
        held = {scene.index(j.child) for j in scene.joints if j.kind == "fixed"}
        paths = [i for i in moment.focus if i not in held]
        trails = _trails(rollout, paths, since, moment.time)
        specks = [] if panels else [corners_of(scene, rollout, shot.frame, i) for i in moment.focus]
        image = draw_trail(image, shot.camera, trails, specks)
        panels.append(Panel(image, moment.title, moment.caption))
        since = moment.time
    return write_sheet(
        folder / "preview.png",
        panels,
        title=doc.scene_definition.original_description,
        note=note,
        footnotes=[*failures(scene, verdict), *lost()],
    )


def film(
    scene: SimScene,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    doc: EsgDocument,
    folder: Path,
) -> list[str]:
    """Writes `preview.mp4`; in a line, what it does not show, or why there is none.

    Args:
        scene, rollout, verdict, doc, folder: As of `preview`.
    """
    around = surroundings_of(doc, scene, rollout)
    # Films draw ropes as lines.
    bodies = [p for p in scenery_of(scene, rollout, doc).parts if p.strand is None]
    parts = [*bodies, *ground_parts(rollout, around)]
    try:
        action = Action(scene, rollout, verdict, doc)
        told = told_of(scene, rollout, verdict, doc)
        lacking = write_scene_film(action, doc, parts, folder / FILM, told)
    except NoFilmError as error:
        return [f"no film: {error}"]
    if not lacking:
        return []
    names = ", ".join(scene.bodies[one.body].label or scene.names[one.body] for one in lacking)
    return [f"too small in the film, or hidden: {names}"]


def _threads() -> int:
    """Pictures drawn at once: the tracer runs on one core, so two draw where two are free."""
    limit = os.environ.get("OMP_NUM_THREADS", "")
    return max(1, min(2, usable_cores(), int(limit) if limit.isdigit() else 2))


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
