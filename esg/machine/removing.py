"""Folders that nobody needs any more, removed while other work goes on.

A journalled file system may take 3 ms to remove a folder, whatever is in it: a batch of a dataset
has some 800, and its worker would wait for them with a core idle.
"""

from __future__ import annotations

import itertools
import os
from pathlib import Path
import shutil
import threading

_numbers = itertools.count()
_removing: list[threading.Thread] = []


def remove_beside(folder: Path) -> None:
    """Takes a folder away under its name at once, and removes it in a thread of its own.

    One folder at a time: it waits for the one before. A process does not end before its folders
    are gone; one that is killed leaves a `.gone-…` where the folder was.

    Args:
        folder: May be missing. What cannot be removed stays, as `shutil.rmtree` leaves it.
    """
    gone = folder.with_name(f".gone-{os.getpid()}-{next(_numbers)}")
    try:
        folder.rename(gone)
    except OSError:  # missing, or held by somebody
        shutil.rmtree(folder, ignore_errors=True)
        return
    wait_removed()
    thread = threading.Thread(target=shutil.rmtree, args=(gone, True), name="removing")
    thread.start()
    _removing.append(thread)


def wait_removed() -> None:
    """Waits until all that was handed over is gone."""
    while _removing:
        _removing.pop().join()
