"""`failures.jsonl`: a line for every scene of an output folder that did not end well."""

from __future__ import annotations

from collections.abc import Generator, Sequence
import contextlib
import json
import os
from pathlib import Path
from typing import Any

from esg.files import atomic_file
from esg.paths import cache_dir
from esg.pipeline import SceneState, failures
from esg.scenefolder import is_scene_folder

FILE = "failures.jsonl"


def report_failures(
    states: Sequence[SceneState],
    folders: Sequence[Path],
    out: Path,
    *,
    adding: bool = False,
    strict: bool = False,
) -> None:
    """Writes the file; without failures there is none.

    Args:
        states: Scenes that have ended.
        folders: Where each of them was published.
        out: The output folder.
        adding: Whether the lines of other scenes that are still in the folder stay: single scenes
            gather there, while a suite is one run.
        strict: Whether what is `partial` or not plausible counts as a failure.
    """
    rows = [
        row | {"scene": folder.name}
        for state, folder in zip(states, folders, strict=True)
        for row in failures([state], strict=strict)
    ]
    path = out / FILE
    with _alone(out):
        if adding:
            fresh = {folder.name for folder in folders}
            rows = [r for r in _kept(path) if r["scene"] not in fresh] + rows
        if not rows:
            path.unlink(missing_ok=True)
            return
        with atomic_file(path) as file:
            for row in rows:
                file.write(json.dumps(row, ensure_ascii=False).encode() + b"\n")


def _kept(path: Path) -> list[dict[str, Any]]:
    """Earlier lines whose scenes are still there; a damaged line is dropped."""
    rows: list[dict[str, Any]] = []
    try:
        lines = path.read_bytes().splitlines()
    except OSError:
        return rows
    for line in lines:
        with contextlib.suppress(ValueError, TypeError, KeyError):
            row = json.loads(line)
            if is_scene_folder(path.parent / str(row["scene"])):
                rows.append(row)
    return rows


@contextlib.contextmanager
def _alone(folder: Path) -> Generator[None]:
    """Waits until no other command of this machine's user rewrites the file."""
    import hashlib

    from filelock import FileLock

    name = hashlib.sha256(os.fsencode(folder.resolve())).hexdigest()[:16]
    place = cache_dir() / "locks" / f"failures-{name}.lock"
    place.parent.mkdir(parents=True, exist_ok=True)
    with FileLock(place):
        yield
