"""Device memory of jobs: a few large buffers instead of dozens of small arrays per scene."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

_ALIGN = 64

Numbers = NDArray[np.int64]


class Records:
    """Structs of the kernels, one per job, as rows of numbers.

    Args:
        struct: `wp.struct` of arrays and plain numbers.
        n: Jobs.
    """

    def __init__(self, struct: Any, n: int) -> None:
        self.struct = struct
        self.rows: Any = np.zeros(n, struct.numpy_dtype())

    def place(self, name: str, start: Numbers, shapes: Numbers) -> None:
        """Says where dense arrays lie: addresses [jobs] and shapes [jobs, axes]."""
        field, ndim = self.rows[name], shapes.shape[1]
        field["data"], field["ndim"] = start, ndim
        field["shape"][:, :ndim] = shapes
        stride = np.full(len(field), self.element(name)[0], np.int64)
        for axis in range(ndim - 1, -1, -1):
            field["strides"][:, axis] = stride
            stride = stride * shapes[:, axis]

    def element(self, name: str) -> tuple[int, int]:
        """Bytes of an element of an array, and its axes: 0 for numbers, 1 for vectors."""
        from warp.types import type_size_in_bytes

        dtype = self.struct.vars[name].type.dtype
        return type_size_in_bytes(dtype), len(getattr(dtype, "_shape_", ()))


class Arena:
    """Arrays of one kind of all jobs, in one device buffer, and the structs that name them."""

    def __init__(self, wp: Any, device: str) -> None:
        self.wp, self.device = wp, device
        self.sizes: dict[str, int] = {"data": 0, "zero": 0, "minus": 0}
        self.parts: list[tuple[int, NDArray[Any]]] = []
        self.patches: list[tuple[str, Records, str]] = []

    def _reserve(self, kind: str, sizes: Numbers) -> Numbers:
        padded = -(-np.maximum(sizes, 4) // _ALIGN) * _ALIGN
        ends = np.cumsum(padded)
        start = self.sizes[kind] + ends - padded
        self.sizes[kind] += int(ends[-1])
        return start

    def data(self, records: Records, name: str, arrays: Sequence[NDArray[Any]]) -> None:
        """Host arrays, one per job."""
        start = self._reserve("data", np.array([a.nbytes for a in arrays], np.int64))
        self.parts += zip(start.tolist(), arrays, strict=True)
        inner = records.element(name)[1]
        shapes = np.array([a.shape[: a.ndim - inner] for a in arrays], np.int64)
        records.place(name, start, shapes)
        self.patches.append(("data", records, name))

    def fill(
        self, records: Records, names: Sequence[str], shape: Sequence[Any], kind: str = "zero"
    ) -> None:
        """Device arrays of 0 or (`minus`) -1; `shape` holds a number or numbers [jobs] per axis."""
        n = len(records.rows)
        table = np.stack([np.broadcast_to(np.asarray(s, np.int64), n) for s in shape], axis=1)
        for name in names:
            start = self._reserve(kind, table.prod(axis=1) * records.element(name)[0])
            records.place(name, start, table)
            self.patches.append((kind, records, name))

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
        for kind, records, name in self.patches:
            records.rows[name]["data"] += made[kind].ptr
        return list(made.values())


def view(wp: Any, struct: Any, record: Any, device: str) -> Any:
    """An instance of a struct whose arrays lie where its record says.

    Args:
        wp: Warp.
        struct: `wp.struct` of arrays and plain numbers.
        record: One element of an array of `struct.numpy_dtype()` after `Arena.upload`.
        device: Warp device.
    """
    made = struct()
    for name, variable in struct.vars.items():
        value = record[name]
        if isinstance(variable.type, wp.array):
            n = int(value["ndim"])
            value = wp.array(
                ptr=int(value["data"]), dtype=variable.type.dtype, device=device,
                shape=tuple(value["shape"][:n].tolist()),
                strides=tuple(value["strides"][:n].tolist()),
            )  # fmt: skip
        elif value.ndim == 0:
            value = value.item()
        setattr(made, name, value)
    return made
