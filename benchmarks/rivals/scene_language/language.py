"""Scene Language's `helper.py` in `exposed` mode: what a program may call, without its renderers.

After github.com/zzyunzhi/scene-language at 0942b1a (MIT, `published/LICENSE.md`): same names,
arguments and results; shapes are lists of primitives with a matrix, and each remembers the calls
that made it. Boxes come from the primitives' corners instead of a renderer.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from functools import wraps
import itertools
import math
import random
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

Shape = list[dict[str, Any]]
P = Any
T = Any
MOST_PRIMITIVES, MOST_FRAMES, MOST_CALLS = 20_000, 240, 200_000

library: dict[str, dict[str, Any]] = {}
animations: list[Callable[..., Generator[Shape, None, None]]] = []
_calls = itertools.count()


def register(
    docstring: str | None = None,
) -> Callable[[Callable[..., Shape]], Callable[..., Shape]]:
    """Registers a function; every primitive of its result remembers the call."""

    def decorator(function: Callable[..., Shape]) -> Callable[..., Shape]:
        @wraps(function)
        def wrapper(*args: Any, **kwargs: Any) -> Shape:
            made = concat_shapes(function(*args, **kwargs))
            number = next(_calls)
            if number > MOST_CALLS:
                raise RuntimeError(f"more than {MOST_CALLS} calls")
            mark = (function.__name__, number)
            return [{**item, "stack": (mark, *item["stack"])} for item in made]

        library[function.__name__] = {"target": wrapper, "docstring": docstring or ""}
        return wrapper

    return decorator


def register_animation(docstring: str | None = None) -> Callable[[Any], Any]:
    """Registers the function that yields frames; as published, the first one counts."""

    def decorator(function: Any) -> Any:
        animations.append(function)
        return function

    return decorator


def library_call(func_name: str, **kwargs: Any) -> Shape:
    """Calls a registered function by its name or docstring; an unknown one gives nothing."""
    found = library.get(func_name)
    if found is None:
        found = next((f for f in library.values() if f["docstring"] == func_name), None)
    return [] if found is None else found["target"](**kwargs)


def primitive_call(
    name: Literal["cube", "sphere", "cylinder", "cone"],
    shape_kwargs: dict[str, Any] | None = None,
    color: tuple[float, float, float] = (1.0, 1.0, 1.0),
    **more: Any,
) -> Shape:
    """A primitive; sizes as keyword arguments too, as the published animated example has them."""
    given = {**(shape_kwargs or {}), **more}
    at, size, turn = np.zeros(3), np.ones(3), np.eye(3)
    if name == "cube":
        size = np.broadcast_to(np.asarray(given.get("scale", 1.0), float), (3,)).copy()
    elif name == "sphere":
        scale = np.asarray(given.get("scale", 1.0), float)
        radius = float(given["radius"]) if "radius" in given else float(scale.mean()) / 2
        size = np.full(3, 2.0 * radius)
        at = np.asarray(given.get("center", (0.0, 0.0, 0.0)), float)
    elif name in ("cylinder", "cone"):
        start = np.asarray(given.get("p0", (0.0, 0.0, 0.0)), float)
        end = np.asarray(given.get("p1", (0.0, 1.0, 0.0)), float)
        length = float(np.linalg.norm(end - start))
        radius = float(given.get("radius", 0.5))
        at, size = (start + end) / 2, np.array([2 * radius, 2 * radius, length])
        turn = _z_to((end - start) / length if length > 0 else np.array([0.0, 1.0, 0.0]))
    else:
        raise ValueError(f"Invalid name {name}")
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn * size, at
    kind = {"cone": "cylinder"}.get(name, name)
    rgb = [float(c) for c in np.broadcast_to(np.asarray(color, float), (3,))]
    return [{"kind": kind, "matrix": matrix, "color": rgb, "stack": ()}]


def _z_to(way: NDArray[np.float64]) -> NDArray[np.float64]:
    """A rotation that turns Z into a unit vector."""
    side = np.cross((0.0, 1.0, 0.0) if abs(way[1]) < 0.9 else (1.0, 0.0, 0.0), way)
    side /= np.linalg.norm(side)
    return np.stack([side, np.cross(way, side), way], axis=1)


def loop(n: int, fn: Callable[[int], Shape]) -> Shape:
    """The shapes of n calls together."""
    return concat_shapes(*(fn(i) for i in range(int(n))))


def concat_shapes(*shapes: Any) -> Shape:
    """Shapes together."""
    out: Shape = []
    for shape in shapes:
        out += [shape] if isinstance(shape, dict) else list(shape)
    if len(out) > MOST_PRIMITIVES:
        raise RuntimeError(f"more than {MOST_PRIMITIVES} primitives")
    return out


def transform_shape(shape: Shape, pose: T) -> Shape:
    """A shape moved by a matrix."""
    matrix = np.asarray(pose, float)
    return [{**item, "matrix": matrix @ item["matrix"]} for item in concat_shapes(shape)]


def translation_matrix(offset: P) -> T:
    """A shift."""
    out = np.eye(4)
    out[:3, 3] = np.asarray(offset, float)
    return out


def rotation_matrix(angle: float, direction: P, point: P = (0.0, 0.0, 0.0)) -> T:
    """A turn by an angle [rad] about an axis through a point."""
    x, y, z = np.asarray(direction, float) / np.linalg.norm(direction)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn = np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    out = np.eye(4)
    out[:3, :3] = turn
    out[:3, 3] = np.asarray(point, float) - turn @ np.asarray(point, float)
    return out


def scale_matrix(scale: float, origin: P = (0.0, 0.0, 0.0)) -> T:
    """A scaling about a point."""
    out = np.eye(4)
    sizes = np.broadcast_to(np.asarray(scale, float), (3,))
    out[:3, :3] = np.diag(sizes)
    out[:3, 3] = np.asarray(origin, float) * (1 - sizes)
    return out


def reflection_matrix(point: P, normal: P) -> T:
    """A mirror plane."""
    n = np.asarray(normal, float) / np.linalg.norm(normal)
    out = np.eye(4)
    out[:3, :3] -= 2 * np.outer(n, n)
    out[:3, 3] = 2 * (np.asarray(point, float) @ n) * n
    return out


def identity_matrix() -> T:
    """No motion."""
    return np.eye(4)


_CORNERS = np.array(list(itertools.product((-0.5, 0.5), repeat=3)))


def bounds(shape: Shape) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Corners of the box around a shape, shape [3] each."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for item in concat_shapes(shape):
        turn, at = item["matrix"][:3, :3], item["matrix"][:3, 3]
        if item["kind"] == "sphere":
            half = 0.5 * np.linalg.norm(turn, axis=1)
        elif item["kind"] == "cylinder":
            half = 0.5 * (np.linalg.norm(turn[:, :2], axis=1) + np.abs(turn[:, 2]))
        else:
            half = np.abs(_CORNERS @ turn.T).max(axis=0)
        low, high = np.minimum(low, at - half), np.maximum(high, at + half)
    return (low, high) if np.isfinite(low).all() else (np.zeros(3), np.zeros(3))


def compute_shape_center(shape: Shape) -> P:
    """The middle of the box."""
    low, high = bounds(shape)
    return (low + high) / 2


def compute_shape_min(shape: Shape) -> P:
    """Its lower corner."""
    return bounds(shape)[0]


def compute_shape_max(shape: Shape) -> P:
    """Its upper corner."""
    return bounds(shape)[1]


def compute_shape_sizes(shape: Shape) -> P:
    """Its size along x, y, z."""
    low, high = bounds(shape)
    return high - low


NAMES: dict[str, Any] = {
    "np": np, "math": math, "random": random, "Shape": Shape, "P": P, "T": T, "Any": Any,
    "NamedTuple": NamedTuple, "Callable": Callable, "Literal": Literal, "Generator": Generator,
    "List": list, "Tuple": tuple, "Dict": dict, "Optional": Any,
    **{f.__name__: f for f in (
        register, register_animation, library_call, primitive_call, loop, concat_shapes,
        transform_shape, translation_matrix, rotation_matrix, scale_matrix, reflection_matrix,
        identity_matrix, compute_shape_center, compute_shape_min, compute_shape_max,
        compute_shape_sizes,
    )},
}  # fmt: skip
"""What `from helper import *` gives."""
