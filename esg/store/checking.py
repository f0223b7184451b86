"""Data that knows when it is damaged: digests of tables, checksums of recordings, the whole of it.

Every page of a Parquet file has a checksum, and its footer the digest of all that the file says: a
flipped bit in a footer changes types, counts or places without touching a page. The footer itself
is sealed by its hash, which stands before it where no reader looks: Arrow ends the process over
some damaged footers instead of telling.
"""

from __future__ import annotations

from collections.abc import Iterator
import hashlib
import os
from pathlib import Path
import struct
from typing import TYPE_CHECKING, Any
import zlib

from esg.outcomes import UserError
from esg.store.columns import type_text

if TYPE_CHECKING:
    import pyarrow as pa

DIGEST_KEY = b"esg.digest"
_MAGIC = b"\x89MCAP0\r\n"
_FOOTER, _ATTACHMENT = 0x02, 0x09
_SEAL, _PARQUET = b"ESGFOOT1", b"PAR1"
_SEAL_BYTES = len(_SEAL) + 32


def content_digest(data: pa.Table) -> bytes:
    """Digest of what a table says: names, types, values and gaps, however its memory is arranged.

    Args:
        data: The table.

    Returns:
        64 hex digits.
    """
    digest = hashlib.sha256()
    for name, column in zip(data.column_names, data.columns, strict=True):
        # Parquet has its own name for what a list holds.
        digest.update(f"{name}: {type_text(column.type)}, {len(column)}\n".encode())
        _update(digest, column.combine_chunks())
    return digest.hexdigest().encode()


def _update(digest: Any, values: pa.Array) -> None:
    import numpy as np
    import pyarrow as pa
    import pyarrow.compute

    pc: Any = pyarrow.compute  # its functions are made at run time
    if isinstance(values, pa.ChunkedArray):  # of a column without rows, or a very long one
        for chunk in values.chunks:
            _update(digest, chunk)
        return
    gaps, kind = values.null_count, values.type
    # Filling gaps where there are none, and reading what is but gaps, took half of the time.
    empty = gaps == len(values)
    digest.update(values.is_null().to_numpy(zero_copy_only=False) if gaps else bytes(len(values)))
    if pa.types.is_list(kind):
        lengths = pc.list_value_length(values)
        digest.update((pc.fill_null(lengths, -1) if gaps else lengths).to_numpy())
        _update(digest, values.flatten())
    elif pa.types.is_struct(kind):
        for field in values.flatten():
            _update(digest, field)
    elif pa.types.is_string(kind) or pa.types.is_binary(kind):
        lengths = pc.binary_length(values)
        digest.update((pc.fill_null(lengths, -1) if gaps else lengths).to_numpy())
        if empty:
            return
        whole = values.cast(pa.large_binary())
        whole = pc.fill_null(whole, b"") if gaps else whole
        ends = np.frombuffer(whole.buffers()[1], np.int64)[whole.offset :][: len(whole) + 1]
        digest.update(memoryview(whole.buffers()[2] or b"")[ends[0] : ends[-1]])
    elif empty:
        digest.update(bytes(gaps * max(1, kind.bit_width // 8)))
    else:
        plain = values.cast(pa.int64()) if pa.types.is_timestamp(kind) else values
        zero = False if pa.types.is_boolean(kind) else 0
        filled = pc.fill_null(plain, pa.scalar(zero, plain.type)) if gaps else plain
        digest.update(filled.to_numpy(zero_copy_only=False))


def seal_footer(path: Path) -> None:
    """Puts the hash of a Parquet file's footer before it; readers of Parquet skip over it."""
    with path.open("r+b") as file:
        place, footer = _footer(file)
        file.seek(place)
        size = struct.pack("<I", len(footer))
        file.write(_SEAL + hashlib.sha256(footer).digest() + footer + size + _PARQUET)


def check_footer(path: Path) -> None:
    """Compares a Parquet file's footer with its hash; a file without one passes.

    Raises:
        ValueError: If it does not fit, or the file is no Parquet.
    """
    with path.open("rb") as file:
        place, footer = _footer(file)
        file.seek(max(0, place - _SEAL_BYTES))
        seal = file.read(min(place, _SEAL_BYTES))
    if seal.startswith(_SEAL) and seal[len(_SEAL) :] != hashlib.sha256(footer).digest():
        raise ValueError("the hash of its footer does not fit")


def _footer(file: Any) -> tuple[int, bytes]:
    """Where the footer of an open Parquet file begins, and the footer."""
    end = file.seek(0, os.SEEK_END) - 8
    file.seek(max(0, end))
    tail = file.read(8)
    size = struct.unpack("<I", tail[:4])[0] if len(tail) == 8 else 0
    if tail[4:] != _PARQUET or not 0 < size <= end:
        raise ValueError("it is cut off, or no Parquet")
    file.seek(end - size)
    return end - size, file.read(size)


def check_recording(path: Path) -> None:
    """Reads all checksums of an MCAP: of its chunks, its attachments and its summary.

    Raises:
        UserError: If one does not fit, or the file cannot be read as a recording.
    """
    from mcap.stream_reader import StreamReader

    try:
        data = path.read_bytes()
        for kind, content in _records(data):
            if kind == _ATTACHMENT and _crc(content[-4:]) not in (0, zlib.crc32(content[:-4])):
                raise ValueError("the checksum of an attachment does not fit")
        place = len(data) - len(_MAGIC) - 29  # of the footer: kind, size, two places, a checksum
        start, wanted = struct.unpack_from("<Q", data, place + 9)[0], data[place + 25 : place + 29]
        if data[place] != _FOOTER or _crc(wanted) not in (0, zlib.crc32(data[start : place + 25])):
            raise ValueError("the checksum of the summary does not fit")
        with path.open("rb") as file:
            for _ in StreamReader(file, validate_crcs=True).records:
                pass
    except OSError as error:
        raise UserError(f"{path} cannot be read: {error.strerror}") from None
    except Exception as error:  # decoders of damaged data raise what they please
        remedy = "make it again (esg export SCENE --to mcap)"
        raise UserError(f"{path} is damaged ({error}); {remedy}") from None


def _crc(four: bytes) -> int:
    return struct.unpack("<I", four)[0]


def _records(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Kind and content of every record outside of chunks."""
    if not data.startswith(_MAGIC) or not data.endswith(_MAGIC):
        raise ValueError("it is cut off, or no MCAP")
    at, end = len(_MAGIC), len(data) - len(_MAGIC)
    while at < end:
        kind, size = struct.unpack_from("<BQ", data, at)
        at += 9
        if at + size > end:
            raise ValueError("a record is longer than the file")
        yield kind, data[at : at + size]
        at += size
