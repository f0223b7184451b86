"""The pages on which finished scenes play."""

from __future__ import annotations

from collections.abc import Sequence
import contextlib
from functools import lru_cache
import importlib
from pathlib import Path
import tempfile

from esg.outcomes import UserError
from esg.studio.jobs import Job

KEPT_PAGES = 64
"""Of a megabyte or two each."""
_NEEDS = ("esg.report.page", "esg.view.surroundings", "esg.assets.geometry.mesh")


def folder_of(root: Path, job: Job) -> Path:
    """The scene folder of a job.

    Args:
        root: The studio's folder.
        job: The job.

    Raises:
        UserError: If it has none, or files in it may not be opened.
    """
    from esg.strangers.folders import admitted

    folder = root / job.folder
    if not job.folder or not folder.is_dir():
        raise UserError(f"job {job.id} has no scene: {job.reason or job.status}")
    return admitted(folder)


def page_of(folder: Path) -> bytes:
    """The player's page of a scene folder.

    Args:
        folder: Its files are linked to as `files/NAME`.
    """
    return _page(folder, (folder / "log.jsonl").stat().st_mtime_ns)


@lru_cache(maxsize=KEPT_PAGES)
def _page(folder: Path, stamp: int) -> bytes:
    from esg.report import write_report
    from esg.report.run import load_run

    with tempfile.TemporaryDirectory() as work:
        path = Path(work) / "scene.html"
        write_report(load_run(folder), path, files="files")
        return path.read_bytes()


def warm(root: Path, jobs: Sequence[Job]) -> None:
    """Imports what pages need, and makes those of the newest scenes, while nobody waits for them.

    Args:
        root: The studio's folder.
        jobs: Its jobs, the oldest first.
    """
    for name in _NEEDS:
        importlib.import_module(name)
    for job in [j for j in reversed(jobs) if j.folder][: KEPT_PAGES // 4]:
        with contextlib.suppress(UserError, OSError):  # told to whoever asks for it
            page_of(folder_of(root, job))
