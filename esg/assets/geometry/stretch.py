"""Sketches at other sizes: scaled as a whole, or stretched where a builder cannot go.

Builders with "free" extents count on some room: a frame of 5 cm does not fit a door of 1 cm. Such
sizes are drawn near the entry's usual size and brought to the wanted one afterwards.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
import itertools
import math
from typing import Any

import numpy as np

from esg.assets.geometry.massprops import mass_properties
from esg.assets.geometry.rotations import IDENTITY
from esg.assets.geometry.sketch import Axle, Sketch
from esg.graph.models import Proxy, ProxyKind, Vec3
from esg.units import quat_rotate

_SIDES = 16
"""Corners of a round proxy that was stretched unevenly."""
_THINNEST = 1e-5
"""Thinnest part of a sound sketch, relative to its longest extent."""


def stretched(sketch: Sketch, factors: Vec3) -> Sketch:
    """The same sketch with each axis multiplied by its factor, about the origin."""
    if all(abs(f - 1.0) < 1e-9 for f in factors):
        return sketch

    def vec(v: Any) -> Any:
        return tuple(f * c for f, c in zip(factors, v, strict=True))

    def flat(v: Any) -> Any:
        return (factors[0] * v[0], factors[1] * v[1])

    def grown(make: Callable[[], Any]) -> Callable[[], Any]:
        def mesh() -> Any:
            out = make()
            out.vertices = np.asarray(out.vertices) * factors
            return out

        return mesh

    weighed = sketch.weighed
    # A wheel that is no circle any more does not turn.
    turns = abs(factors[0] - factors[2]) < 1e-9 * factors[2]
    return Sketch(
        parts=[
            replace(p, mesh=grown(p.mesh), axle=p.axle if turns else None) for p in sketch.parts
        ],
        proxies=[_proxy(p, factors) for p in sketch.proxies],
        densities=list(sketch.densities),
        surfaces=[
            s.model_copy(
                update={
                    "center_cm": vec(s.center_cm),
                    "half_extents_cm": flat(s.half_extents_cm),
                }
            )
            for s in sketch.surfaces
        ],
        regions=[
            r.model_copy(
                update={
                    "center_cm": vec(r.center_cm),
                    "half_extents_cm": vec(r.half_extents_cm),
                }
            )
            for r in sketch.regions
        ],
        weighed=None if weighed is None else [_proxy(p, factors) for p in weighed],
        mounts=[
            m.model_copy(update={"position_cm": vec(m.position_cm), "axis": vec(m.axis)})
            for m in sketch.mounts
        ],
        axles=[Axle(vec(a.point), a.radius * factors[2]) for a in sketch.axles if turns],
        limbs=[replace(m, joints=tuple(vec(j) for j in m.joints)) for m in sketch.limbs],
    )


def _proxy(proxy: Proxy, factors: Vec3) -> Proxy:
    """A proxy stretched; one that loses its shape becomes the hull of its corners."""
    a, b, c = factors
    middle = tuple(f * v for f, v in zip(factors, proxy.position_cm, strict=True))
    straight = proxy.orientation_xyzw == IDENTITY
    hull = proxy.kind is ProxyKind.CONVEX
    even = max(factors) - min(factors) < 1e-9 * max(factors)
    if even or (
        straight
        and (
            proxy.kind is ProxyKind.BOX
            or hull
            or (proxy.kind is ProxyKind.CYLINDER and abs(a - b) < 1e-9 * a)
        )
    ):
        update: dict[str, Any] = {
            "size_cm": tuple(f * v for f, v in zip(factors, proxy.size_cm, strict=True)),
            "position_cm": middle,
        }
        if hull:
            update["vertices_cm"] = tuple((a * x, b * y, c * z) for x, y, z in proxy.vertices_cm)
        return proxy.model_copy(update=update)
    points = quat_rotate(proxy.orientation_xyzw, _corners(proxy)) * factors
    return Proxy(
        kind=ProxyKind.CONVEX,
        size_cm=tuple(float(v) for v in np.ptp(points, axis=0) / 2),  # type: ignore[arg-type]
        position_cm=middle,  # type: ignore[arg-type]
        vertices_cm=tuple(tuple(float(v) for v in p) for p in points),  # type: ignore[arg-type]
    )


def _corners(proxy: Proxy) -> Any:
    """Points [n, 3] whose hull is the proxy, about its centre and before its rotation."""
    a, b, c = proxy.size_cm
    if proxy.kind is ProxyKind.CONVEX:
        return np.array(proxy.vertices_cm)
    if proxy.kind is ProxyKind.BOX:
        return np.array(list(itertools.product((-a, a), (-b, b), (-c, c))))
    turns = [2 * math.pi * k / _SIDES for k in range(_SIDES)]
    if proxy.kind is ProxyKind.CYLINDER:
        rings = [(a, -c), (a, c)]
    else:
        tube = 0.0 if proxy.kind is ProxyKind.SPHERE else c
        tilts = [math.radians(v) for v in (-90, -60, -30, 0, 0, 30, 60, 90)]
        rings = [
            (a * math.cos(v), a * math.sin(v) + (tube if k > 3 else -tube))
            for k, v in enumerate(tilts)
        ]
    return np.array([(r * math.cos(t), r * math.sin(t), z) for r, z in rings for t in turns])


def sound(sketch: Sketch) -> bool:
    """Whether every part has an extent and mass properties are those of a body."""
    shapes = [*sketch.proxies, *(sketch.weighed or ())]
    if not shapes:
        return True
    sizes = np.array([p.size_cm for p in shapes])
    places = np.array([p.position_cm for p in shapes])
    halves = [v for s in (*sketch.surfaces, *sketch.regions) for v in s.half_extents_cm]
    if not np.isfinite(sizes).all() or not np.isfinite(places).all() or min(halves, default=1) <= 0:
        return False
    if sizes.min() <= _THINNEST * sizes.max():
        return False
    if (places[:, 2] < -_THINNEST * sizes.max()).any():
        return False  # a part below the ground
    _, (xx, yy, zz, xy, xz, yz) = mass_properties(
        sketch.weighed or sketch.proxies, 1.0, sketch.densities
    )
    moments = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return bool(moments[0] > 0 and moments[0] + moments[1] >= moments[2] * (1 - 1e-6))


def scaled(sketch: Sketch, factor: float) -> Sketch:
    """The same sketch, uniformly scaled about the origin."""
    return stretched(sketch, (factor, factor, factor))
