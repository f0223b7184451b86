"""One channel of one clip as a video file, and back again.

Colours are H.264 that browsers play, or lossless on request; all other channels are FFV1, an open
lossless codec that FFmpeg, and so PyAV, OpenCV and VLC, read. One thread encodes a file, and
nothing of the machine goes into it: equal frames give equal bytes.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.outcomes import UserError

Pictures = NDArray[np.uint8] | NDArray[np.uint16]

PICTURES = (
    "rgb",
    "depth",
    "flow",
    "backward_flow",
    "segmentation",
    "normal",
    "object_coordinates",
)
"""Channels that are files; `tracks` and `boxes` are columns of table `clips`."""
CHANNELS = (*PICTURES, "tracks", "boxes")

_SAME = {"threads": "1"}
_X264 = "mbtree=0:aq-mode=0:weightp=0"
"""Decisions that the encoder takes from memory it never wrote (esg.view.film.encoding)."""
_COLORS = "colorprim=smpte170m:transfer=smpte170m:colormatrix=smpte170m"
"""What the conversion to yuv420p is, or players guess it by the picture's height."""


@dataclass(frozen=True)
class Codec:
    """How a channel becomes a file.

    Args:
        name: Of FFmpeg's encoder.
        frames: Pixel format of the frames given: rgb24, gray16le or gbrp16le.
        stored: Pixel format of the file.
        suffix: Of the file.
        options: Of the encoder.
    """

    name: str
    frames: str
    stored: str
    suffix: str
    options: dict[str, str]


_FFV1 = {**_SAME, "level": "3", "coder": "1", "context": "0", "slicecrc": "1"}
"""The larger of its two contexts takes a tenth longer and is no smaller on clips of seconds."""
_GRAY = Codec("ffv1", "gray16le", "gray16le", ".mkv", _FFV1)
_PLANAR = "gbrp16le"
_COLOR = Codec("ffv1", _PLANAR, _PLANAR, ".mkv", _FFV1)
_H264 = Codec(
    "libx264", "rgb24", "yuv420p", ".mp4",
    {**_SAME, "preset": "veryfast", "crf": "18", "g": "12", "bf": "2",
     "x264-params": f"{_X264}:{_COLORS}"},
)  # fmt: skip
_H264_LOSSLESS = Codec(
    "libx264rgb", "rgb24", "rgb24", ".mp4",
    {**_SAME, "preset": "veryfast", "crf": "0", "g": "12", "x264-params": _X264},
)  # fmt: skip
CODECS = {
    "rgb": _H264,
    "depth": _GRAY,
    "segmentation": _GRAY,
    "flow": _COLOR,
    "backward_flow": _COLOR,
    "normal": _COLOR,
    "object_coordinates": _COLOR,
}


def codec_of(channel: str, *, lossless: bool = False) -> Codec:
    """How a channel is written."""
    return _H264_LOSSLESS if lossless and channel == "rgb" else CODECS[channel]


def check_encoders(channels: Iterable[str], *, lossless: bool = False) -> None:
    """Finds out, before anything is drawn, whether all channels can be written.

    Raises:
        UserError: If PyAV is missing or lacks an encoder.
    """
    wanted = {codec_of(c, lossless=lossless).name for c in channels if c in PICTURES}
    try:
        from av.codec import Codec as Encoder

        for name in sorted(wanted):
            Encoder(name, "w")
    except ImportError as error:
        raise UserError(f"clips need PyAV, which cannot be imported ({error})") from None
    except ValueError as error:  # PyAV's error for a name it does not know
        raise UserError(
            f"PyAV here was built without an encoder ({error}); pip install --force-reinstall av"
        ) from None


class ChannelFile:
    """A channel of a clip that is being written, frame after frame.

    Args:
        path: Of the file; its suffix is that of the codec.
        codec: Of the channel.
        size: Width and height [px].
        fps: Frames a second.
    """

    def __init__(self, path: Path, codec: Codec, size: tuple[int, int], fps: float) -> None:
        import av
        from av.codec.context import Flags

        self._codec = codec
        options = {"fflags": "+bitexact"}
        if path.suffix == ".mp4":
            options["movflags"] = "+faststart"
        path.parent.mkdir(parents=True, exist_ok=True)
        self._container: Any = av.open(str(path), "w", options=options)
        rate = Fraction(fps).limit_denominator(1001)
        stream: Any = self._container.add_stream(codec.name, rate=rate, options=codec.options)
        stream.width, stream.height = size
        stream.pix_fmt = codec.stored
        stream.codec_context.thread_count = 1
        stream.codec_context.flags |= Flags.bitexact
        self._stream = stream
        self._open = True

    def add(self, frame: Pictures) -> None:
        """Encodes a frame, shape [H, L] or [H, L, 3].

        Raises:
            OSError: If the disk does not take it.
        """
        self._container.mux(self._stream.encode(self._picture(frame)))

    def _picture(self, frame: Pictures) -> Any:
        """A frame as the encoder takes it."""
        import av

        if self._codec.frames != _PLANAR:
            whole: Any = np.ascontiguousarray(frame)
            return av.VideoFrame.from_ndarray(whole, format=self._codec.frames)
        height, width, _ = frame.shape
        picture = av.VideoFrame(width, height, _PLANAR)
        # PyAV takes six times as long to part the colours.
        for plane, color in zip(picture.planes, (1, 2, 0), strict=True):
            rows = np.frombuffer(memoryview(plane), "<u2").reshape(height, -1)
            rows[:, :width] = frame[..., color]
        return picture

    def close(self) -> None:
        """Writes what is left; does nothing the second time.

        Raises:
            OSError: If the disk does not take it.
        """
        if not self._open:
            return
        self._open = False
        try:
            self._container.mux(self._stream.encode())
        finally:
            self._container.close()


def decoded(path: Path) -> Pictures:
    """All frames of a file, as they were given: shape [n, H, L] or [n, H, L, 3].

    Raises:
        UserError: If it is missing or damaged.
    """
    import av
    from av.error import FFmpegError

    kind = "rgb24" if path.suffix == ".mp4" else None
    try:
        with av.open(str(path)) as container:
            container.streams.video[0].thread_type = "AUTO"
            frames: Any = [f.to_ndarray(format=kind) for f in container.decode(video=0)]
            return np.stack(frames)
    except (FFmpegError, OSError, IndexError, ValueError) as error:
        raise UserError(f"{path} is missing or damaged ({error}); render it again") from None
