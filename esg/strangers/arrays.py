"""Archives of arrays and zip files: what they say they hold, before anything is made for it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any
import zipfile

MOST_ENTRIES = 100_000


def check_archive(archive: zipfile.ZipFile, most_bytes: int) -> None:
    """Makes sure that a zip file unpacks to a bearable size.

    Args:
        archive: Opened.
        most_bytes: Of all files in it together.

    Raises:
        ValueError: If it says that it holds more.
    """
    entries = archive.infolist()
    if len(entries) > MOST_ENTRIES:
        raise ValueError(f"it holds {len(entries)} files, at most {MOST_ENTRIES} are unpacked")
    total = sum(entry.file_size for entry in entries)
    if total > most_bytes:
        raise ValueError(f"it unpacks to {total} bytes, at most {most_bytes} are unpacked")


def check_npz(path: Path, most_bytes: int) -> None:
    """Makes sure that the arrays of an `.npz` file are as large as they say, and not too large.

    Raises:
        ValueError: If not.
        zipfile.BadZipFile: If it is no zip file.
        OSError: If it cannot be read.
    """
    import numpy as np

    with zipfile.ZipFile(path) as archive:
        check_archive(archive, most_bytes)
        for entry in archive.infolist():
            with archive.open(entry) as file:
                version = np.lib.format.read_magic(file)
                read: Any = {
                    (1, 0): np.lib.format.read_array_header_1_0,
                    (2, 0): np.lib.format.read_array_header_2_0,
                }.get(version)
                if read is None:
                    raise ValueError(f"{entry.filename} has version {version}")
                shape, _, dtype = read(file)
                if dtype.hasobject:
                    raise ValueError(f"{entry.filename} holds objects")
                said = math.prod(int(n) for n in shape) * dtype.itemsize
                if said != entry.file_size - file.tell():
                    raise ValueError(f"{entry.filename} says it has {said} bytes, and has others")
