"""Chunks of data inside a page: JSON and arrays, compressed, as base64 text.

Layout before compression (gzip): a little-endian uint32, the length of the JSON; the JSON (UTF-8),
whose `arrays` say name, type, shape, offset and quantization; the arrays' bytes. `web/src/data.js`
reads it.
"""

from __future__ import annotations

import base64
from dataclasses import dataclass, field
import gzip
import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

_LEVEL = 6


@dataclass
class Chunk:
    """Collects one chunk.

    Args:
        head: JSON of the chunk.
    """

    head: dict[str, Any] = field(default_factory=dict)
    _arrays: list[dict[str, Any]] = field(default_factory=list)
    _bytes: bytearray = field(default_factory=bytearray)

    def integers(self, name: str, values: NDArray[Any], kind: str) -> None:
        """Adds integers as they are; kind `u2` or `u4`."""
        self._add(name, np.ascontiguousarray(values, f"<{kind}"), kind, {})

    def quantized(self, name: str, values: NDArray[Any], *, delta: bool = False) -> None:
        """Adds reals as 16-bit steps between the least and the greatest value of each column.

        Args:
            name: Of the array.
            values: Shape [n, k].
            delta: Store differences along the first axis: smooth series compress better.
        """
        table = np.asarray(values, float)
        table = np.where(np.isfinite(table), table, 0.0).reshape(len(table), -1)
        low = table.min(0) if len(table) else np.zeros(table.shape[1])
        span = (table.max(0) if len(table) else low) - low
        step = np.where(span > 0, span / 65535.0, 1.0)
        codes = np.rint((table - low) / step).astype(np.int64)
        if delta and len(codes):
            codes = np.diff(codes, axis=0, prepend=0)
        # Columns one after the other: neighbours in the file are neighbours in time.
        packed = np.ascontiguousarray((codes & 0xFFFF).astype("<u2").T)
        scale = {"low": [float(v) for v in low], "step": [float(v) for v in step], "delta": delta}
        self._add(name, packed, "u2", scale, shape=table.shape)

    def _add(
        self,
        name: str,
        array: NDArray[Any],
        kind: str,
        more: dict[str, Any],
        shape: tuple[int, ...] | None = None,
    ) -> None:
        self._bytes += b"\0" * (-len(self._bytes) % 4)
        entry = {"name": name, "type": kind, "shape": list(shape or array.shape)}
        self._arrays.append({**entry, "offset": len(self._bytes), **more})
        self._bytes += array.tobytes()

    def text(self) -> str:
        """The chunk as base64; equal data give equal text."""
        head = {**self.head, "arrays": self._arrays}
        data = json.dumps(head, separators=(",", ":"), ensure_ascii=True, allow_nan=False).encode()
        data += b" " * (-len(data) % 4)
        raw = struct.pack("<I", len(data)) + data + bytes(self._bytes)
        return base64.b64encode(gzip.compress(raw, _LEVEL, mtime=0)).decode("ascii")
