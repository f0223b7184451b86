"""PNG with 16 bits a channel, which Pillow cannot write for more than one channel."""

from __future__ import annotations

import struct
from typing import Any
import zlib

import numpy as np
from numpy.typing import NDArray

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_GRAY, _RGB = 0, 2
_MOST_BYTES = 2**29


def encode(image: NDArray[Any], level: int = 4) -> bytes:
    """A picture as PNG.

    Args:
        image: Shape [H, L] or [H, L, 3], uint8 or uint16.
        level: Of compression, 0 to 9.

    Raises:
        ValueError: If shape or type are others.
    """
    if image.dtype.str[1:] not in ("u1", "u2") or image.shape[2:] not in ((), (3,)):
        raise ValueError(f"cannot write {image.dtype} of shape {image.shape} as PNG")
    height, width = image.shape[:2]
    bits = 8 * image.dtype.itemsize
    rows = np.ascontiguousarray(image, f">u{image.dtype.itemsize}").view(np.uint8)
    rows = rows.reshape(height, -1)
    # Filter "up": the difference to the row above compresses rendered pictures well.
    filtered = np.diff(rows, axis=0, prepend=np.zeros((1, rows.shape[1]), np.uint8))
    data = np.concatenate([np.full((height, 1), 2, np.uint8), filtered], axis=1)
    kind = _RGB if image.ndim == 3 else _GRAY
    head = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, 0)
    chunks = [(b"IHDR", head), (b"IDAT", zlib.compress(data.tobytes(), level)), (b"IEND", b"")]
    return _SIGNATURE + b"".join(_chunk(name, body) for name, body in chunks)


def _chunk(name: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))


def decode(data: bytes) -> NDArray[Any]:
    """Reads what `encode` wrote, shape [H, L] or [H, L, 3].

    Raises:
        ValueError: If it is a PNG of another kind.
    """
    if data[:8] != _SIGNATURE:
        raise ValueError("not a PNG file")
    at, packed, head = 8, b"", (0, 0, 0, 0, 0, 0, 0)
    while at < len(data):
        (length,) = struct.unpack_from(">I", data, at)
        name, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + length]
        if name == b"IHDR":
            head = struct.unpack(">IIBBBBB", body)
        elif name == b"IDAT":
            packed += body
        at += 12 + length
    width, height, bits, kind = head[:4]
    channels = 3 if kind == _RGB else 1
    size = height * (1 + width * channels * bits // 8)
    if not 0 < size <= _MOST_BYTES:
        raise ValueError(f"{width} x {height} pixels of {bits} bits are not read")
    unpacked = zlib.decompressobj().decompress(packed, size + 1)
    if len(unpacked) != size:
        raise ValueError("a PNG that does not hold what it says")
    raw = np.frombuffer(unpacked, np.uint8).reshape(height, -1)
    if kind not in (_GRAY, _RGB) or (raw[:, 0] != 2).any():
        raise ValueError("not a PNG that this module wrote")
    rows = np.cumsum(raw[:, 1:], axis=0, dtype=np.uint8)
    image = rows.view(f">u{bits // 8}").astype(f"u{bits // 8}")
    return image.reshape(height, width, 3) if channels == 3 else image.reshape(height, width)
