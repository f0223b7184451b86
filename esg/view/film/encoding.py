"""Frames into a file that browsers play: H.264 in MP4, the same bytes for the same frames."""

from __future__ import annotations

from collections.abc import Iterable
import os
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from esg.view.film.cutting import FPS

CODEC = "libx264"
OPTIONS = {
    "preset": "veryfast",
    "crf": "25",
    "threads": "1",
    "g": "24",
    "bf": "2",
    # Decisions about bits that the encoder takes from memory it never wrote: films of the same
    # pictures differed.
    "x264-params": "mbtree=0:aq-mode=0:weightp=0",
}
"""One thread, or frames would be split differently from machine to machine."""
CONTAINER = {"movflags": "+faststart", "fflags": "+bitexact"}


class NoFilmError(Exception):
    """Why there is no film."""


def check_encoder() -> None:
    """Finds out, before anything is drawn, whether films can be written.

    Raises:
        NoFilmError: If PyAV is missing or has no H.264.
    """
    try:
        from av.codec import Codec

        Codec(CODEC, "w")
    except ImportError as error:
        raise NoFilmError(f"PyAV cannot be imported ({error})") from None
    except ValueError:  # PyAV's error for a name it does not know
        raise NoFilmError(f"PyAV was built without {CODEC}") from None


def write_film(path: Path, frames: Iterable[NDArray[np.uint8]], size: tuple[int, int]) -> Path:
    """Writes frames as a film; the file appears whole or not at all.

    Args:
        path: Of the file, which ends in mp4.
        frames: Each of shape [height, width, 3].
        size: Width and height, both even [px].

    Raises:
        NoFilmError: If PyAV is missing or has no H.264, or the disk does not take the file.
    """
    check_encoder()
    import av
    from av.codec.context import Flags
    from av.error import FFmpegError

    partial = path.with_suffix(".partial.mp4")
    try:
        with av.open(str(partial), "w", options=CONTAINER) as container:
            stream = container.add_stream(CODEC, rate=FPS, options=OPTIONS)
            stream.width, stream.height = size
            stream.pix_fmt = "yuv420p"
            stream.codec_context.thread_count = 1
            stream.codec_context.flags |= Flags.bitexact
            for frame in frames:
                picture = av.VideoFrame.from_ndarray(np.ascontiguousarray(frame), format="rgb24")
                container.mux(stream.encode(picture))
            container.mux(stream.encode())
        os.replace(partial, path)
    except (OSError, ValueError, FFmpegError) as error:
        partial.unlink(missing_ok=True)
        raise NoFilmError(f"the film could not be written ({error})") from None
    return path
