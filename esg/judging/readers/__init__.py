"""One reader a format, by the end of a file's name."""

from __future__ import annotations

from importlib import import_module
import os
from pathlib import Path

from esg.judging.recording import Faults, Frame, Reader, Recording, checked
from esg.outcomes import UserError

_HOME = {
    ".csv": "tables:read_csv",
    ".parquet": "tables:read_parquet",
    ".npz": "arrays:read_npz",
    ".json": "kubric:read_metadata",
    ".mcap": "mcap:read_mcap",
    ".glb": "gltf:read_glb_file",
    ".usd": "usd:read_usd",
    ".usda": "usd:read_usd",
    ".usdc": "usd:read_usd",
    ".usdz": "usd:read_usd",
}
"""Where the reader of a format is, imported when it is used."""
FORMATS = tuple(_HOME)
MOST_BYTES = 2**30
"""Of a file that is read."""


def reader_of(path: Path) -> Reader:
    """The reader of a file.

    Raises:
        UserError: If its name ends in none of the formats.
    """
    suffix = path.suffix.lower()
    if suffix not in _HOME:
        raise UserError(
            f"{path}: its name ends in {suffix!r}; trajectories are {', '.join(FORMATS)}"
        )
    module, _, name = _HOME[suffix].partition(":")
    return getattr(import_module(f"{__name__}.{module}"), name)


def read_recording(path: Path, frame: Frame, faults: Faults) -> Recording:
    """What a file tells of how things moved.

    Args:
        path: The file.
        frame: Units and axes, where the format states none.
        faults: Of this file.

    Raises:
        UserError: With everything that is wrong with it.
    """
    read = reader_of(path)
    try:
        size = os.stat(path).st_size
    except OSError as error:
        raise UserError(f"{path} cannot be read: {error.strerror}") from None
    if not path.is_file():
        raise UserError(f"{path} is no file")
    if size > MOST_BYTES:
        raise UserError(f"{path} has {size} bytes, at most {MOST_BYTES} are read")
    return checked(read(path, frame, faults), faults)
