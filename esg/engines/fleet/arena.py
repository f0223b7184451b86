"""Memory of many scenes: a few large buffers instead of dozens of small arrays per scene."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

_ALIGN = 64

Numbers = NDArray[np.int64]


class Buffer:
    """Memory that results are written to before they are read; simulating again reuses it.

    Args:
        array: Bytes, shape [n].
    """

    def __init__(self, array: NDArray[np.uint8]) -> None:
        self.array = array
        self.used = 0

    def take(self, shape: tuple[int, ...]) -> tuple[int, NDArray[np.float32]]:
        """Room for single precision numbers: its offset in bytes and the array itself."""
        n = 4 * int(np.prod(shape))
        at = -(-self.used // _ALIGN) * _ALIGN
        if at + n > len(self.array):
            raise MemoryError(f"results need more than {len(self.array)} bytes")
        self.used = at + n
        return at, self.array[at : at + n].view(np.float32).reshape(shape)


class Arena:
    """Arrays of one kind of all scenes, in one device buffer, and the structs that name them."""

    def __init__(self, wp: Any, device: str) -> None:
        self.wp, self.device = wp, device
        self.sizes: dict[str, int] = {"data": 0, "zero": 0, "minus": 0}
        self.parts: list[tuple[int, NDArray[Any]]] = []
        self.patches: list[tuple[str, Any, str, Numbers]] = []

    def _place(self, kind: str, sizes: Numbers) -> Numbers:
        padded = -(-np.maximum(sizes, 4) // _ALIGN) * _ALIGN
        ends = np.cumsum(padded)
        start = self.sizes[kind] + ends - padded
        self.sizes[kind] += int(ends[-1])
        return start

    def data(self, records: Any, name: str, arrays: list[NDArray[Any]], inner: int) -> None:
        """Host arrays, one per scene, whose last `inner` axes make up one element."""
        sizes = np.array([a.nbytes for a in arrays], np.int64)
        start = self._place("data", sizes)
        self.parts += zip(start.tolist(), arrays, strict=True)
        shapes = np.array([a.shape[: a.ndim - inner] for a in arrays], np.int64)
        element = arrays[0].itemsize * int(np.prod(arrays[0].shape[arrays[0].ndim - inner :]))
        self._describe("data", records, name, start, shapes, element)

    def zeros(
        self, records: Any, name: str, shapes: list[Any], element: int, fill: str = "zero"
    ) -> None:
        """Device arrays; `shapes` holds one number or array of numbers per axis."""
        n = len(records)
        table = np.stack([np.broadcast_to(np.asarray(s, np.int64), n) for s in shapes], axis=1)
        start = self._place(fill, table.prod(axis=1) * element)
        self._describe(fill, records, name, start, table, element)

    def _describe(
        self, kind: str, records: Any, name: str, start: Numbers, shapes: Numbers, element: int
    ) -> None:
        ndim = shapes.shape[1]
        field = records[name]
        field["shape"][:, :ndim] = shapes
        stride = np.full(len(records), element, np.int64)
        for axis in range(ndim - 1, -1, -1):
            field["strides"][:, axis] = stride
            stride = stride * shapes[:, axis]
        field["ndim"] = ndim
        self.patches.append((kind, records, name, start))

    def upload(self) -> list[Any]:
        """Allocates and fills the buffers and completes the structs; returns what to keep."""
        wp = self.wp
        host = np.zeros(max(_ALIGN, self.sizes["data"]), np.uint8)
        for at, array in self.parts:
            host[at : at + array.nbytes] = array.reshape(-1).view(np.uint8)
        # Elements of 64 bytes: the number of elements of an array is limited.
        blocks = {k: max(1, n // _ALIGN) for k, n in self.sizes.items()}
        made = {
            "data": wp.array(
                host.view(np.float32).reshape(-1, 4, 4), dtype=wp.mat44, device=self.device
            ),
            "zero": wp.zeros(blocks["zero"], dtype=wp.mat44, device=self.device),
            "minus": wp.full(16 * blocks["minus"], -1, dtype=int, device=self.device),
        }
        for kind, records, name, start in self.patches:
            records[name]["data"] = made[kind].ptr + start
        return list(made.values())
