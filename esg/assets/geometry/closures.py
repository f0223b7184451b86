"""What a closure that draws a part depends on, so that an equal one need not draw it again."""

from __future__ import annotations

from dataclasses import fields
from enum import Enum
import hashlib
from types import BuiltinFunctionType, CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

Key = tuple[tuple[CodeType, ...], bytes]

_PLAIN = (bool, int, float, str, bytes, type(None), np.floating, np.integer)
_COMMON = frozenset({bool, int, float, str, type(None)})
"""Most of what closures enclose, none of it an `Enum`."""


class _Opaque(Exception):
    """A value of which nobody can tell whether it is equal to another."""


def key_of(make: Any) -> Key | None:
    """Equal for functions that draw the same: of equal code, with equal values enclosed.

    Args:
        make: Takes nothing, and depends on nothing that changes but what it encloses.

    Returns:
        None for what encloses a value that cannot be compared: it has to be called.
    """
    codes: list[CodeType] = []
    told: list[str] = []
    try:
        _tell(make, codes, told)
    except (_Opaque, ValueError, RecursionError):  # an empty cell, a circle
        return None
    text = "\0".join(told).encode("utf-8", "surrogatepass")
    return tuple(codes), hashlib.blake2b(text, digest_size=16).digest()


def _tell(value: Any, codes: list[CodeType], told: list[str]) -> None:
    """Adds what tells a value from others: codes of functions, and texts of all else."""
    kind = type(value)
    if kind in _COMMON:
        told.append(f"{kind.__name__} {value!r}")
        return
    if type(value) is tuple and _COMMON.issuperset(map(type, value)):
        told.append(f"tuple {value!r}")  # which writes no two of these values alike
        return
    if isinstance(value, Enum):
        inside = [value.value]
    elif isinstance(value, _PLAIN):
        told.append(f"{kind.__name__} {value!r}")
        return
    elif isinstance(value, FunctionType):
        codes.append(value.__code__)
        told.append(f"function {value.__module__}")
        cells = [cell.cell_contents for cell in value.__closure__ or ()]
        inside = [*cells, value.__defaults__, value.__kwdefaults__]
    elif isinstance(value, (BuiltinFunctionType, type, ModuleType, np.ufunc)):
        told.append(f"named {getattr(value, '__module__', '')} {value!r}")
        return
    elif isinstance(value, (tuple, list)):
        inside = [*value, getattr(value, "__dict__", None)]
    elif kind is dict:
        inside = [part for item in value.items() for part in item]
    elif isinstance(value, np.ndarray) and value.dtype != object:
        told.append(f"array {value.dtype} {value.shape} {value.tobytes().hex()}")
        return
    elif _is_frozen(kind):
        inside = [getattr(value, field.name) for field in fields(kind)]
    else:
        raise _Opaque
    told.append(f"{kind.__module__}.{kind.__qualname__} {len(inside)}")
    for part in inside:
        _tell(part, codes, told)


def _is_frozen(kind: Any) -> bool:
    """Whether a class is a dataclass whose values do not change."""
    how: Any = vars(kind).get("__dataclass_params__")
    return how is not None and bool(how.frozen)
