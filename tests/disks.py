"""Disks that are nearly full."""

from __future__ import annotations

from collections.abc import Generator
import contextlib
import resource


@contextlib.contextmanager
def small_files(size: int) -> Generator[None]:
    """No file may grow beyond `size` bytes, as on a disk that is nearly full."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
