"""Shooting a scene: takes of the director, drawn frame by frame, with the time in a corner."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.textures import maps
from esg.view.director.acting import Action
from esg.view.director.review import Viewfinder
from esg.view.director.staging import direct
from esg.view.director.takes import Take
from esg.view.director.told import Told
from esg.view.film.cutting import Cut, cuts_of, told, whole_cut
from esg.view.film.encoding import check_encoder, write_film
from esg.view.film.inserts import Shot, with_inserts
from esg.view.filmed import said_rate, said_take
from esg.view.lettering import font
from esg.view.pieces import Part
from esg.view.ropes import ropes_at
from esg.view.scan.drawer import Scan
from esg.view.sheet import draw_ropes
from esg.view.surroundings import GROUND, surroundings_of, thing_of

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument

SIZE_PX = (384, 216)
TEXTURE_PX = 128
SHORTEST_S = 0.2
"""Events closer together than this are not parted by a cut."""
CORNER_PX = 12
"""Size of the letters in the corner."""


def viewfinder(action: Action, doc: EsgDocument, parts: Sequence[Part]) -> Viewfinder:
    """A scene as films draw it, in pictures of `SIZE_PX`.

    Args:
        action: What happens in it.
        doc: Its place.
        parts: Meshes of its bodies and of the ground.
    """
    around = surroundings_of(doc, action.scene, action.rollout)
    standing = [part for part in around.parts if thing_of(part) != GROUND]
    scan = Scan(
        [*parts, *standing],
        len(action.scene.bodies),
        SIZE_PX,
        sky=around.sky,
        still=action.still,
        textures=_base_colors,
    )
    return Viewfinder(action, scan, around=standing)


def _base_colors(name: str) -> NDArray[np.uint8]:
    return maps(name, TEXTURE_PX).base_color


def shots_of(
    finder: Viewfinder, seed: int = 0, said: Take | None = None, rate: float = 1.0
) -> list[Shot]:
    """The film of a scene: every stretch has a take of its own.

    Args:
        finder: Of the scene.
        seed: Of lenses, sides and angles.
        said: The only take, where the prompt says how it is filmed.
        rate: Seconds of the scene in a second of film, where the prompt says how fast it passes.
    """
    if said is not None or rate != 1.0:
        cut = whole_cut(finder.action.beats, float(finder.action.time[-1]), rate)
        if said is None:
            return _shots(finder, cut, seed)
        return [Shot(cut, said.at(cut.time_s), finder.action)]
    cuts = cuts_of(finder.action.beats, float(finder.action.time[-1]))
    return [shot for cut in cuts for shot in _shots(finder, cut, seed)]


def _shots(finder: Viewfinder, cut: Cut, seed: int) -> list[Shot]:
    """One take of a stretch; one before and one after a cut where that shows more events."""
    take = direct(finder, float(cut.time_s[0]), float(cut.time_s[-1]), seed=seed)
    seen = finder.review(take)
    whole = [Shot(cut, take.at(cut.time_s), finder.action)]
    times = [s.beat.time_s for s in seen]
    gaps = np.diff(times)
    if all(s.good for s in seen) or not len(gaps) or float(gaps.max()) < SHORTEST_S:
        return whole
    k = int(np.argmax(gaps))
    split = int(np.searchsorted(cut.time_s, 0.5 * (times[k] + times[k + 1])))
    parts = (slice(None, split), slice(split, None))
    halves = [Cut(cut.time_s[part], cut.speed[part]) for part in parts]
    parted = [shot for half in halves for shot in _shots(finder, half, seed)]
    shown = sum(s.good for shot in parted for s in finder.review(shot.take))
    return parted if shown > sum(s.good for s in seen) else whole


def write_scene_film(
    action: Action,
    doc: EsgDocument,
    parts: Sequence[Part],
    path: Path,
    told: Sequence[Told] = (),
    seed: int = 0,
) -> list[Told]:
    """Directs, draws and writes the film of a scene.

    Args:
        action: What happens.
        doc: Its place.
        parts: Meshes of its bodies and of the ground.
        path: Of the file.
        told: What must be seen beside the events; the film cuts to it.
        seed: Of lenses, sides and angles.

    Returns:
        What is told and in no frame large enough.

    Raises:
        NoFilmError: If it cannot be written.
    """
    check_encoder()
    finder = viewfinder(action, doc, parts)
    said = said_take(doc, action.scene, action.rollout, SIZE_PX[0] / SIZE_PX[1])
    rate = said_rate(doc)
    shots, lacking = shots_of(finder, seed, said, rate), list[Told]()
    if said is None and rate == 1.0:
        shots, lacking = with_inserts(finder, shots, told, seed)
    write_film(path, frames_of(finder, shots), SIZE_PX)
    return lacking


def frames_of(finder: Viewfinder, shots: Sequence[Shot]) -> Iterator[NDArray[np.uint8]]:
    """The finished pictures of all shots, one after the other."""
    scan = finder.scan
    finder.expect([float(t) for shot in shots for t in shot.cut.time_s])
    for shot in shots:
        take, action = shot.take, shot.action
        finder.turn_to(action)
        finder.dress(take)
        arms = np.linalg.norm(take.eye - take.target, axis=1)
        middle = 0.5 * (take.target.min(axis=0) + take.target.max(axis=0))
        roam = 0.5 * float(np.ptp(take.target, axis=0).max())
        scan.light(middle, roam + 1.1 * float(arms.max()))
        for k, time in enumerate(shot.cut.time_s):
            finder.pose(float(time))
            camera = take.camera(k)
            image = scan.color(camera)
            image = draw_ropes(image, camera, ropes_at(action.scene, action.rollout, finder.frame))
            yield _lettered(image, told(float(time), float(shot.cut.speed[k])))


def _lettered(image: NDArray[np.uint8], text: str) -> NDArray[np.uint8]:
    """Text in the lower left corner, on a shadow of its own."""
    from PIL import Image, ImageDraw

    strip = image[-(CORNER_PX + 10) :]
    picture: Any = Image.fromarray(strip)
    draw = ImageDraw.Draw(picture)
    for x, color in ((9, (20, 24, 28)), (8, (250, 250, 248))):
        draw.text((x, x - 6), text, fill=color, font=font(CORNER_PX))
    out = image.copy()
    out[-(CORNER_PX + 10) :] = np.asarray(picture)
    return out
