"""Device memory of jobs: a few large buffers instead of dozens of small arrays per scene."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

_ALIGN = 64
_AXES = 4
"""Most axes of a Warp array."""
_WORDS = 13
"""Of Warp's description of an array in 32 bits each: address and that of its gradient (2 each),
shape and strides (4 each), number of axes."""

Numbers = NDArray[np.int64]


@dataclass(frozen=True)
class _Field:
    """An array of a struct: its place in a row [32 bits], bytes of an element, and an element's
    axes: 0 for numbers, 1 for vectors."""

    word: int
    size: int
    inner: int


@cache
def _layout(struct: Any) -> tuple[np.dtype[Any], dict[str, _Field]]:
    """Rows of a struct, and its arrays."""
    import warp as wp
    from warp.types import type_size_in_bytes

    dtype = np.dtype(struct.numpy_dtype())
    fields: dict[str, _Field] = {}
    for name, variable in struct.vars.items():
        if isinstance(variable.type, wp.array):
            element = variable.type.dtype
            inner = len(getattr(element, "_shape_", ()))
            offset = (dtype.fields or {})[name][1]
            fields[name] = _Field(offset // 4, type_size_in_bytes(element), inner)
    return dtype, fields


class Records:
    """Structs of the kernels, one per job, as rows of numbers.

    Args:
        struct: `wp.struct` of arrays and plain numbers.
        n: Jobs.
    """

    def __init__(self, struct: Any, n: int) -> None:
        self.struct = struct
        dtype, self.fields = _layout(struct)
        self.rows: Any = np.zeros(n, dtype)


class Arena:
    """Arrays of one kind of all jobs, in one device buffer, and the structs that name them.

    All arrays are named first; `upload` then lays out, allocates and describes them at once, since
    numbers of one job are too few for arithmetic array by array.
    """

    def __init__(self, wp: Any, device: str) -> None:
        self.wp, self.device = wp, device
        self._named: list[tuple[Records, str, str, Numbers]] = []
        self._hosts: list[Sequence[NDArray[Any]]] = []

    def data(self, records: Records, arrays: Mapping[str, Sequence[NDArray[Any]]]) -> None:
        """Host arrays by name, one per job each."""
        for name, own in arrays.items():
            inner = records.fields[name].inner
            shapes = np.array([a.shape[: a.ndim - inner] for a in own], np.int64)
            self._named.append((records, name, "data", shapes))
            self._hosts.append(own)

    def fill(
        self, records: Records, names: Sequence[str], shape: Sequence[Any], kind: str = "zero"
    ) -> None:
        """Device arrays of 0 or (`minus`) -1; `shape` holds a number or numbers [jobs] per axis."""
        table = np.empty((len(records.rows), len(shape)), np.int64)
        for axis, size in enumerate(shape):
            table[:, axis] = size
        self._named += [(records, name, kind, table) for name in names]

    def place(self, records: Records, array: Any, name: str, shape: Sequence[Any]) -> None:
        """An array of all jobs, one dense part each; `shape` as in `fill`."""
        self.fill(records, [name], shape, f"at {int(array.ptr)}")

    def upload(
        self, tables: Sequence[Records], columns: Sequence[tuple[NDArray[Any], Any]]
    ) -> tuple[list[Any], list[Any]]:
        """Allocates and fills the buffers and completes the structs.

        Args:
            tables: All records.
            columns: Other arrays of one axis and their Warp types.

        Returns:
            What to keep as long as the arrays are used, and the tables and columns on the device.
        """
        wp, device = self.wp, self.device
        words, sizes = self._describe()
        starts, ends = self._starts(sizes)
        rows = [(t.rows, t.struct) for t in tables] + list(columns)
        extra = _padded(np.array([a.nbytes for a, _ in rows])).cumsum()
        at = (ends["data"] + np.append(0, extra[:-1])).tolist()
        n_bytes = ends["data"] + int(extra[-1])
        # Elements of 64 bytes: the number of elements of an array is limited.
        made = {
            "data": wp.empty(n_bytes // _ALIGN, dtype=wp.mat44, device=device),
            "zero": wp.zeros(max(1, ends["zero"] // _ALIGN), dtype=wp.mat44, device=device),
            "minus": wp.full(max(16, ends["minus"] // 4), -1, dtype=int, device=device),
        }
        address = {kind: int(array.ptr) for kind, array in made.items()}
        kinds = [kind for _, _, kind, _ in self._named]
        base = [int(k[3:]) if k.startswith("at ") else address[k] for k in kinds]
        words[:, :, :2] = (starts + np.array(base)[:, None]).view(np.int32).reshape(*sizes.shape, 2)
        for t in tables:
            own = [k for k, (records, *_) in enumerate(self._named) if records is t]
            if own:
                first = np.array([t.fields[self._named[k][1]].word for k in own])
                where = first[:, None] + np.arange(_WORDS)
                t.rows.view(np.int32).reshape(len(t.rows), -1)[:, where] = words[own].swapaxes(0, 1)
        host = np.zeros(n_bytes, np.uint8)
        data = [k for k, kind in enumerate(kinds) if kind == "data"]
        flat = [a for own in self._hosts for a in own] + [a for a, _ in rows]
        for first, array in zip(starts[data].reshape(-1).tolist() + at, flat, strict=True):
            host[first : first + array.nbytes] = array.reshape(-1).view(np.uint8)
        made["data"].assign(host.view(np.float32).reshape(-1, 4, 4))
        placed = [
            wp.array(ptr=address["data"] + first, dtype=dtype, shape=len(a), device=device)
            for first, (a, dtype) in zip(at, rows, strict=True)
        ]
        return list(made.values()), placed

    def _describe(self) -> tuple[NDArray[np.int32], Numbers]:
        """Descriptions of all K arrays but their addresses, [K, jobs, _WORDS]; bytes, [K, jobs]."""
        k, n = len(self._named), len(self._named[0][3])
        words = np.zeros((k, n, _WORDS), np.int32)
        ndim = np.array([shape.shape[1] for *_, shape in self._named])
        words[:, :, -1] = ndim[:, None]
        shapes = np.ones((k, n, _AXES), np.int64)
        for row, (*_, shape) in zip(shapes, self._named, strict=True):
            row[:, : shape.shape[1]] = shape
        size = np.array([r.fields[name].size for r, name, _, _ in self._named])[:, None]
        for axis in range(_AXES - 1, -1, -1):
            has = (axis < ndim)[:, None]
            words[:, :, 4 + axis] = shapes[:, :, axis] * has
            words[:, :, 4 + _AXES + axis] = size * has
            size = size * shapes[:, :, axis]
        return words, size

    def _starts(self, sizes: Numbers) -> tuple[Numbers, dict[str, int]]:
        """Where in the buffer of its kind each array lies, [K, jobs], and the buffers' lengths."""
        starts, ends = np.zeros_like(sizes), {"data": 0, "zero": 0, "minus": 0}
        kinds = np.array([kind for _, _, kind, _ in self._named])
        for kind in dict.fromkeys(kinds.tolist()):
            own = np.nonzero(kinds == kind)[0]
            # Arrays that lie in one of somebody else's follow each other densely.
            padded = _padded(sizes[own]) if kind in ends else sizes[own]
            stop = padded.cumsum()
            starts[own] = stop.reshape(padded.shape) - padded
            if kind in ends:
                ends[kind] = int(stop[-1])
        return starts, ends


def _padded(sizes: Numbers) -> Numbers:
    """Bytes that arrays of these sizes take, at least one block each."""
    return np.maximum(sizes + (_ALIGN - 1), _ALIGN) // _ALIGN * _ALIGN


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
