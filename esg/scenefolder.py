"""The scene folder: everything about one scene, put together aside and renamed into place."""

from __future__ import annotations

import contextlib
import errno
import json
import os
from pathlib import Path
import shutil
import tempfile
import time

from esg.files import explained, make_folder, refused, safe_name, sync_folder, sync_tree
from esg.outcomes import UserError
from esg.pipeline import STAGES, SceneState
from esg.stages import DOCUMENT, ROLLOUT
from esg.strangers.sums import seal

_DOCUMENT_STAGES = ("draft", "resolve", "cast", "layout", "optimize", "dress")
_MARKS = ("prompt.txt", "log.jsonl")
"""Files that tell a scene folder from a folder of the user's."""
_ATTEMPTS = 20
"""Of putting a folder into place while others do the same."""


def publish(state: SceneState, out: Path) -> Path:
    """Writes the folder of a scene, complete or as far as the scene came.

    Args:
        state: A scene that has ended.
        out: Folder that receives it; created if need be.

    Returns:
        Path of the scene folder. An older folder of the same scene is replaced.

    Raises:
        UserError: If `out` cannot be written, or a folder of that name is no scene folder.
    """
    target = out / folder_name(state)
    if _is_anothers(target):
        raise UserError(
            f"{target} exists and is not a scene folder; move it or choose another --out"
        )
    try:
        make_folder(out)
        work = Path(tempfile.mkdtemp(prefix=f".{target.name}.", suffix=".tmp", dir=out))
    except OSError as error:
        raise UserError(f"cannot write to --out {out}: {explained(error, out).strerror}") from None
    try:
        with refused(target):
            _fill(state, work)
            seal(work)
            work.chmod(0o755)
            sync_tree(work)
            _replace(work, target)
    except BaseException:
        shutil.rmtree(work, ignore_errors=True)
        raise
    return target


def _replace(work: Path, target: Path) -> None:
    """Puts a folder in the place of another, also while other commands do the same there."""
    for attempt in range(_ATTEMPTS):
        retired = Path(tempfile.mkdtemp(prefix=f".{target.name}.", suffix=".tmp", dir=work.parent))
        try:
            with contextlib.suppress(FileNotFoundError):
                target.rename(retired / "old")
            work.rename(target)
        except OSError as error:
            # Another command may have published the same scene between the two steps.
            if error.errno not in (errno.ENOTEMPTY, errno.EEXIST) or attempt == _ATTEMPTS - 1:
                with contextlib.suppress(OSError):
                    (retired / "old").rename(target)
                raise
        else:
            sync_folder(work.parent)
            return
        finally:
            shutil.rmtree(retired, ignore_errors=True)


def is_scene_folder(path: Path) -> bool:
    """Whether `path` is a folder that `publish` wrote."""
    return path.is_dir() and all((path / mark).is_file() for mark in _MARKS)


def _is_anothers(target: Path) -> bool:
    """Whether something else than a scene folder is there, and stays there when looked at again.

    While another command replaces the folder it is gone for a moment.
    """
    for _ in range(_ATTEMPTS):
        if not target.exists() or is_scene_folder(target):
            return False
        time.sleep(0.005)
    return True


def folder_name(state: SceneState) -> str:
    """The request's name, else the document's scene id; only characters safe in file names."""
    name = state.request.name
    if not name and "draft" in state.artifacts:
        document = json.loads((state.artifact("draft") / DOCUMENT).read_bytes())
        name = document["scene_definition"]["scene_id"]
    return safe_name(name) or "scene"


def _fill(state: SceneState, folder: Path) -> None:
    (folder / "prompt.txt").write_text(state.request.prompt + "\n", encoding="utf-8")
    stages = folder / "stages"
    stages.mkdir()
    for stage in _DOCUMENT_STAGES:
        if stage in state.artifacts:
            number = STAGES.index(stage) + 1
            source = state.artifact(stage) / DOCUMENT
            shutil.copyfile(source, stages / f"{number}-{stage}.json")
            shutil.copyfile(source, folder / DOCUMENT)
    if "draft" in state.artifacts:
        violations = state.artifact("draft") / "violations.json"
        if violations.stat().st_size > 3:
            shutil.copyfile(violations, folder / "violations.json")
    for stage in ("compile", "judge", "record"):
        if stage in state.artifacts:
            _copy(state.artifact(stage), folder)
    if "replay" in state.artifacts:
        number = STAGES.index("replay") + 1
        shutil.copyfile(state.artifact("replay") / "replay.json", stages / f"{number}-replay.json")
        shutil.copyfile(state.artifact("replay") / ROLLOUT, folder / ROLLOUT)
    with (folder / "log.jsonl").open("w", encoding="utf-8") as log:
        for entry in state.log:
            log.write(json.dumps(entry, ensure_ascii=False) + "\n")
        end = {"outcome": state.outcome.value if state.outcome else None, "reason": state.reason}
        log.write(json.dumps(end, ensure_ascii=False) + "\n")


def _copy(source: Path, folder: Path) -> None:
    for path in sorted(source.rglob("*")):
        relative = path.relative_to(source)
        if path.is_dir():
            (folder / relative).mkdir(exist_ok=True, parents=True)
        else:
            (folder / relative).parent.mkdir(exist_ok=True, parents=True)
            shutil.copyfile(path, folder / relative)


def check_writable(out: Path) -> None:
    """Finds out early, leaving no trace, whether scene folders can be written to `out`.

    Raises:
        UserError: If not, with the reason.
    """
    existing = out
    while not existing.exists() and existing != existing.parent:
        existing = existing.parent
    if not existing.is_dir():
        raise UserError(f"cannot write to --out {out}: {existing} is not a folder")
    try:
        probe = tempfile.mkdtemp(prefix=".esg-probe-", dir=existing)
        os.rmdir(probe)
    except OSError as error:
        why = explained(error, existing).strerror
        raise UserError(f"cannot write to --out {out}: {why}") from None
