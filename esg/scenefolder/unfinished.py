"""Scene folders whose pictures follow: the mark that says so, and waiting for them.

A command that answers first leaves `.finishing` in its scene folder: which process draws what. The
folder is finished once it has its `SHA256SUMS`; whoever needs all of it waits for that here.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
import contextlib
from dataclasses import asdict, dataclass, replace
import json
import os
from pathlib import Path
import time

from esg.files import atomic_file, read_limited
from esg.notices import warn
from esg.outcomes import UserError
from esg.scenereading import REMEDY
from esg.strangers.folders import file_in
from esg.strangers.sums import FINISHING, SUMS

WAIT_S = 300.0
"""So long somebody waits for pictures: a hundred times what they take on idle cores."""
_POLL_S = 0.05
_MOST_BYTES = 65536


@dataclass(frozen=True)
class Mark:
    """That a folder lacks its pictures.

    Args:
        pid: Process that draws them.
        started: When that process started, as the system counts [ticks since its start].
        place: The system and the space of process numbers in which it has that number.
        files: What it draws.
        failed: Why they could not be drawn; empty while they may come.
    """

    pid: int
    started: int
    place: str
    files: tuple[str, ...]
    failed: str = ""

    @property
    def names(self) -> str:
        """Of the files, for people."""
        return " and ".join(self.files)[:200]


def announce(folder: Path, files: Sequence[str]) -> None:
    """Marks a folder as one whose pictures this process draws.

    Args:
        folder: Of the scene.
        files: That follow.
    """
    pid = os.getpid()
    _write(folder, Mark(pid, _started(pid) or 0, _place(), tuple(files)))


def give_up(folder: Path, why: str) -> None:
    """Notes in a folder's mark why its pictures do not follow; does nothing where there is none.

    Args:
        folder: Of the scene.
        why: In one line.
    """
    found = read(folder)
    if found is not None:
        _write(folder, replace(found, failed=" ".join(why.split())[:300]))


def read(folder: Path) -> Mark | None:
    """The mark of a folder that lacks its pictures; None if it is finished."""
    path = file_in(folder, FINISHING)
    if path is None or (folder / SUMS).exists():
        return None
    try:
        value = json.loads(read_limited(path, _MOST_BYTES))
        mark = Mark(int(value["pid"]), int(value["started"]), str(value["place"]),
                    tuple(map(str, value["files"])), str(value["failed"]))  # fmt: skip
    except FileNotFoundError:  # it has just been finished
        return None
    except (OSError, UserError, ValueError, TypeError, KeyError, RecursionError):
        return Mark(0, 0, "", ("pictures",), "its mark cannot be read")
    return mark


def settled(folder: Path, wait_s: float = WAIT_S) -> str:
    """Waits until a folder's pictures are there.

    Args:
        folder: Of a scene.
        wait_s: At most so long [s].

    Returns:
        Empty once they are, which they mostly are at once; else that they are missing, why, and
        what to do.
    """
    deadline = time.monotonic() + wait_s
    told = False
    while (mark := read(folder)) is not None:
        lacking = f"{folder} lacks {mark.names}"
        if mark.failed:
            return f"{lacking}: {mark.failed}; {REMEDY}"
        if not _at_work(mark, folder):
            if read(folder) is None:  # it ended because it was done
                return ""
            return f"{lacking}: the process that drew them has ended; {REMEDY}"
        if time.monotonic() >= deadline:
            return f"{lacking}: process {mark.pid} still draws them; wait for it, or end it"
        if not told:
            warn([f"waiting for {mark.names} of {folder}, which process {mark.pid} draws"])
            told = True
        time.sleep(_POLL_S)
    return ""


def all_settled(folders: Iterable[Path], wait_s: float = WAIT_S) -> list[str]:
    """Waits for the pictures of several folders, so long for all of them together.

    Args:
        folders: Of scenes.
        wait_s: At most so long [s].

    Returns:
        What is missing, as `settled` tells it.
    """
    deadline = time.monotonic() + wait_s
    told = [settled(folder, max(0.0, deadline - time.monotonic())) for folder in folders]
    return [problem for problem in told if problem]


def _at_work(mark: Mark, folder: Path) -> bool:
    """Whether the process of a mark lives; of one that cannot be seen, whether it may."""
    if mark.place == _place():
        return mark.pid > 0 and _started(mark.pid) == mark.started
    with contextlib.suppress(OSError):
        return time.time() - (folder / FINISHING).stat().st_mtime < WAIT_S
    return False


def _place() -> str:
    """What tells this system, its start and its space of process numbers from others."""
    try:
        start = Path("/proc/sys/kernel/random/boot_id").read_text().strip()
        return f"{start} {os.readlink('/proc/self/ns/pid')}"
    except OSError:
        return ""


def _started(pid: int) -> int | None:
    """When a process started, as the system counts; None if there is none, or it has ended."""
    try:
        # After the name, in brackets, come the state and the rest.
        told = Path(f"/proc/{pid}/stat").read_text("utf-8", "replace").rpartition(")")[2].split()
        return None if told[0] in "ZX" else int(told[19])
    except (OSError, ValueError, IndexError):
        return None


def _write(folder: Path, mark: Mark) -> None:
    with atomic_file(folder / FINISHING) as file:
        file.write(json.dumps(asdict(mark)).encode() + b"\n")
