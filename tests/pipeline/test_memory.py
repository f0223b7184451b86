"""Free memory goes back to the system, and circles of objects go (`esg.machine.memory`)."""

from __future__ import annotations

import ctypes
import gc
import multiprocessing
import os
from pathlib import Path
import sys
import weakref

import pytest

from esg.machine.memory import give_back

BLOCK, COUNT = 60_000, 2000


class _Circle:
    def __init__(self) -> None:
        self.me = self


def resident_mib() -> float:
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def _with_holes(tell) -> None:
    """What a process holds before, with, and without the blocks that lie between others."""
    gc.disable()  # as if there were so many objects that nobody looks
    give_back()
    before = resident_mib()
    blocks = [bytes(BLOCK) for _ in range(COUNT)]
    blocks = blocks[::20]
    full = resident_mib()
    circle = weakref.ref(_Circle())
    there = circle() is not None
    give_back()
    tell.send((before, full, resident_mib(), there, circle() is None, gc.get_freeze_count()))


@pytest.mark.skipif(
    sys.platform != "linux" or not hasattr(ctypes.CDLL(None), "malloc_trim"), reason="of glibc"
)
def test_holes_and_circles_go_and_what_stays_is_not_looked_through_again() -> None:
    context = multiprocessing.get_context("spawn")
    hear, tell = context.Pipe(duplex=False)
    process = context.Process(target=_with_holes, args=(tell,))
    process.start()
    before, full, after, there, gone, frozen = hear.recv()
    process.join()
    whole = BLOCK * COUNT / 2**20
    assert full - before > 0.6 * whole
    assert after - before < 0.3 * whole
    assert there and gone
    assert frozen > 1000


def test_in_the_process_of_a_command_nothing_is_frozen() -> None:
    frozen = gc.get_freeze_count()
    give_back()
    assert gc.get_freeze_count() == frozen
