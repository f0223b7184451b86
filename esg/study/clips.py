"""The clips of a study: films of the same scenes, made in several ways."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
import hashlib
from pathlib import Path

from esg.notices import warn
from esg.outcomes import UserError
from esg.scenefolder import is_scene_folder
from esg.scenefolder.unfinished import all_settled
from esg.strangers.folders import file_in

FILM = "preview.mp4"
MOST_FILM_BYTES = 32 * 2**20
MOST_BYTES = 512 * 2**20
"""Of all films: a page that holds more does not open everywhere."""
MOST_PROMPT = 8000


@dataclass(frozen=True)
class Clip:
    """One film.

    Args:
        id: What the page and the answers call it: it does not tell the variant.
        scene: Name of the scene's folder, the same in every variant.
        variant: How it was made.
        prompt: What was asked for.
        film: Path of the film.
    """

    id: str
    scene: str
    variant: str
    prompt: str
    film: Path


def find_clips(run: Path, variants: Sequence[str], scenes: int, seed: int) -> list[Clip]:
    """The clips of a run: RUN/VARIANT/SCENE/preview.mp4, the scenes that every variant has.

    Args:
        run: Folder with a folder a variant (`esg bench --ablations` makes one).
        variants: Names of those folders.
        scenes: At most so many scenes, chosen by the seed; 0 for all.
        seed: Of the choice and of the ids.

    Raises:
        UserError: With everything that is missing.
    """
    problems = [
        f"--variants {name!r}: {run / name} is no folder of scenes"
        for name in variants
        if not name or "/" in name or not (run / name).is_dir()
    ]
    for name in sorted({v for v in variants if list(variants).count(v) > 1}):
        problems.append(f"--variants names {name!r} several times")
    if not run.is_dir():
        problems = [f"{run} is no folder"]
    if problems:
        raise UserError("\n".join(problems))
    found = {name: _films(run / name) for name in variants}
    common = sorted(set.intersection(*(set(films) for films in found.values())))
    if not common:
        listed = ", ".join(f"{name} has {len(films)}" for name, films in found.items())
        raise UserError(
            f"{run}: no scene has a film ({FILM}) in every variant ({listed}); make the variants "
            "with esg bench SUITE --ablations"
        )
    if 0 < scenes < len(common):
        drawn = {_digest(seed, scene): scene for scene in common}
        common = sorted(drawn[digest] for digest in sorted(drawn)[:scenes])
    clips: list[Clip] = []
    for scene in common:
        prompts = {_prompt(run / name / scene) for name in variants}
        if len(prompts) > 1:
            problems.append(f"{scene} has another prompt in another variant")
        for name in variants:
            ident = _digest(seed, scene, name)[:12]
            clips.append(Clip(ident, scene, name, prompts.copy().pop(), found[name][scene]))
    size = sum(clip.film.stat().st_size for clip in clips)
    if size > MOST_BYTES:
        problems.append(
            f"the films have {size / 2**20:.0f} MiB, a page holds {MOST_BYTES // 2**20}: choose "
            "fewer with --scenes"
        )
    if problems:
        raise UserError("\n".join(problems))
    return clips


def _films(folder: Path) -> dict[str, Path]:
    """Films of the scenes in a folder, by the name of the scene's folder."""
    out: dict[str, Path] = {}
    scenes = sorted(folder.iterdir())
    warn(all_settled(scenes))
    for scene in scenes:
        film = file_in(folder, f"{scene.name}/{FILM}") if is_scene_folder(scene) else None
        if film is not None and film.stat().st_size <= MOST_FILM_BYTES:
            out[scene.name] = film
    return out


def _prompt(folder: Path) -> str:
    path = folder / "prompt.txt"
    return path.read_bytes()[:MOST_PROMPT].decode("utf-8", "replace").strip()


def _digest(seed: int, *words: str) -> str:
    return hashlib.sha256("\0".join((str(seed), *words)).encode()).hexdigest()
