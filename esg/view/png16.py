"""PNG with 16 bits a channel, which Pillow cannot write for more than one channel: FFmpeg does."""

from __future__ import annotations

from fractions import Fraction
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

_FORMATS = {(2, "u1"): "gray", (3, "u1"): "rgb24", (2, "u2"): "gray16be", (3, "u2"): "rgb48be"}
_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_MOST_BYTES = 2**29


def encode(image: NDArray[Any], level: int = 4) -> bytes:
    """A picture as PNG.

    Args:
        image: Shape [H, L] or [H, L, 3], uint8 or uint16.
        level: Of compression, 0 to 9.

    Raises:
        ValueError: If shape or type are others.
    """
    import av

    form = _FORMATS.get((image.ndim, image.dtype.str[1:]))
    if form is None or image.shape[2:] not in ((), (3,)):
        raise ValueError(f"cannot write {image.dtype} of shape {image.shape} as PNG")
    coder = av.VideoCodecContext.create("png", "w")
    coder.height, coder.width = image.shape[:2]
    coder.pix_fmt, coder.time_base = form, Fraction(1)
    # The difference to the row above compresses rendered pictures well.
    coder.options = {"pred": "up", "compression_level": str(level)}
    frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(image), format=form)
    return b"".join(bytes(packet) for packet in (*coder.encode(frame), *coder.encode(None)))


def decode(data: bytes) -> NDArray[Any]:
    """A picture that `encode` wrote, shape [H, L] or [H, L, 3].

    Raises:
        ValueError: If it is damaged, too large, or a PNG of another kind.
    """
    import av
    from av.error import FFmpegError

    if data[:8] != _SIGNATURE or len(data) < 24:
        raise ValueError("not a PNG file")
    width, height = struct.unpack_from(">II", data, 16)
    if not 0 < 6 * width * height <= _MOST_BYTES:
        raise ValueError(f"{width} x {height} pixels are not read")
    coder = av.VideoCodecContext.create("png", "r")
    coder.options = {"err_detect": "crccheck+explode"}
    try:
        (frame,) = (*coder.decode(av.Packet(data)), *coder.decode(None))
    except (FFmpegError, ValueError) as error:
        raise ValueError(f"a PNG that does not hold what it says: {error}") from error
    if frame.format.name not in _FORMATS.values():
        raise ValueError(f"a PNG of another kind: {frame.format.name}")
    return frame.to_ndarray()
