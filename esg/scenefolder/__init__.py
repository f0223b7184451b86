"""The scene folder: everything about one scene, put together aside and renamed into place."""

from __future__ import annotations

from collections.abc import Generator, Mapping
import contextlib
from dataclasses import dataclass
import errno
import hashlib
import json
import os
from pathlib import Path
import shutil
import tempfile
import time

from esg.files import (
    atomic_file,
    explained,
    make_folder,
    refused,
    safe_name,
    sha256_of,
    sync_folder,
    sync_tree,
)
from esg.outcomes import UserError
from esg.pipeline import STAGES, SceneState, Unfinished
from esg.scenefolder.unfinished import announce, settled
from esg.stages import DOCUMENT, PICTURES, ROLLOUT
from esg.strangers.sums import FINISHING, digests, seal, write_sums

_DOCUMENT_STAGES = ("draft", "resolve", "cast", "layout", "optimize", "dress")
LOG = "log.jsonl"
_DRAWN = tuple({name.partition(".")[0] + "." for name in PICTURES})
"""Beginnings of the names of pictures, unfinished ones included."""
_MARKS = ("prompt.txt", LOG)
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
    with _placed(state, out) as work:
        _fill(state, work)
        seal(work)
    return out / folder_name(state)


@dataclass(frozen=True)
class Owed:
    """A scene folder in its place that lacks its pictures.

    Args:
        folder: Its path when it was written.
        handle: Descriptor of the folder, which follows it wherever it is moved.
        sums: SHA-256 of what was written, by file.
    """

    folder: Path
    handle: int
    sums: Mapping[str, str]

    @property
    def here(self) -> Path:
        """The folder wherever it is now; in one that is gone nothing can be written."""
        return Path(f"/proc/self/fd/{self.handle}")


def publish_unfinished(rest: Unfinished, out: Path) -> Owed:
    """Writes the folder of a scene but for its pictures, with a mark (esg.scenefolder.unfinished).

    Args:
        rest: Of the scene's record.
        out: As of `publish`.

    Raises:
        UserError: As `publish`.
    """
    with _placed(rest.state, out) as work:
        _fill(rest.state, work, rest.folder)
        sums = digests(work)
        announce(work, PICTURES)
        handle = os.open(work, os.O_RDONLY)
    return Owed(out / folder_name(rest.state), handle, sums)


def complete(owed: Owed, state: SceneState) -> None:
    """Adds pictures and the finished log to a folder, each whole; then its list, the mark goes.

    Args:
        owed: The folder.
        state: The scene, its record in the store.

    Raises:
        OSError: If the folder is gone, or cannot be written.
    """
    record, sums = state.artifact(STAGES[-1]), dict(owed.sums)
    for name in PICTURES:
        if (record / name).is_file():
            with atomic_file(owed.here / name) as file:
                file.write((record / name).read_bytes())
            sums[name] = sha256_of(owed.here / name)
    log = _log(state)
    with atomic_file(owed.here / LOG) as file:
        file.write(log)
    sums[LOG] = hashlib.sha256(log).hexdigest()
    write_sums(owed.here, sums)
    (owed.here / FINISHING).unlink(missing_ok=True)


@contextlib.contextmanager
def _placed(state: SceneState, out: Path) -> Generator[Path]:
    """A folder aside for the body to fill, which is then put into the place of the scene's.

    Raises:
        UserError: As `publish`.
    """
    target = out / folder_name(state)
    if _is_anothers(target):
        raise UserError(
            f"{target} exists and is not a scene folder; move it or choose another --out"
        )
    settled(target)  # nobody writes any more into what is to be replaced
    try:
        make_folder(out)
        work = Path(tempfile.mkdtemp(prefix=f".{target.name}.", suffix=".tmp", dir=out))
    except OSError as error:
        raise UserError(f"cannot write to --out {out}: {explained(error, out).strerror}") from None
    try:
        with refused(target):
            yield work
            work.chmod(0o755)
            sync_tree(work)
            _replace(work, target)
    except BaseException:
        shutil.rmtree(work, ignore_errors=True)
        raise


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


def _fill(state: SceneState, folder: Path, record: Path | None = None) -> None:
    """Writes a scene as far as it came.

    Args:
        state: The scene.
        folder: Empty.
        record: What there is of its record, if that lacks its pictures.
    """
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
        if stage == "record" and record is not None:
            _copy(record, folder, pictures=False)
        elif stage in state.artifacts:
            _copy(state.artifact(stage), folder)
    if "replay" in state.artifacts:
        number = STAGES.index("replay") + 1
        shutil.copyfile(state.artifact("replay") / "replay.json", stages / f"{number}-replay.json")
        shutil.copyfile(state.artifact("replay") / ROLLOUT, folder / ROLLOUT)
    (folder / LOG).write_bytes(_log(state))


def _log(state: SceneState) -> bytes:
    """Lines of `log.jsonl`: one a stage, and how the scene ended."""
    end = {"outcome": state.outcome.value if state.outcome else None, "reason": state.reason}
    lines = [json.dumps(entry, ensure_ascii=False) for entry in (*state.log, end)]
    return "".join(f"{line}\n" for line in lines).encode()


def _copy(source: Path, folder: Path, *, pictures: bool = True) -> None:
    for path in sorted(source.rglob("*")):
        relative = path.relative_to(source)
        if path.is_dir():
            (folder / relative).mkdir(exist_ok=True, parents=True)
        elif pictures or not path.name.startswith(_DRAWN):
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
