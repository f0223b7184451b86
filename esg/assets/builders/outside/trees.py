"""Trees: a trunk that forks, and a crown of clumps with leaves on them."""

from __future__ import annotations

from functools import lru_cache
import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.geometry.sketch import Color, Sketch, rgb
from esg.assets.lazy import forms
from esg.graph.models import ProxyKind

_BARK = rgb(96, 74, 54)
_CLUMPS = (
    (0, 0, 372, 96),
    (66, 26, 322, 70),
    (-62, 36, 330, 72),
    (14, -70, 326, 70),
    (-40, -48, 386, 66),
    (50, -30, 396, 66),
    (10, 56, 400, 68),
    (-8, 4, 442, 58),
    (-86, -20, 316, 52),
    (84, -22, 344, 50),
    (-20, 88, 324, 50),
    (56, 70, 348, 50),
)
"""Middle and radius of the clumps of a crown [cm]."""


@lru_cache(maxsize=8)
def _leafy(variant: int) -> tuple[Any, Any]:
    """The clumps of a crown, and the leaves that stand out from them."""
    import numpy as np
    import trimesh

    rng = np.random.default_rng(40 + variant)
    clumps, twigs = [], []
    base = trimesh.creation.icosphere(subdivisions=2)
    for x, y, z, r in _CLUMPS:
        d = np.asarray(base.vertices)
        waves = rng.normal(size=(5, 3)) * 3.2
        bumps = 1 + 0.07 * np.sin(d @ waves.T + rng.uniform(0, 6.3, 5)).sum(1)
        at = np.array([x, y, z]) + rng.uniform(-6, 6, 3)
        clumps.append(
            trimesh.Trimesh(
                d * (r * 0.90 * bumps)[:, None] * [1, 1, 0.9] + at, base.faces, process=False
            )
        )
        n = round(0.028 * r * r)
        out = rng.normal(size=(n, 3))
        out /= np.linalg.norm(out, axis=1, keepdims=True)
        twigs.append(
            np.concatenate([at + out * r * rng.uniform(0.86, 1.06, (n, 1)) * [1, 1, 0.92], out], 1)
        )
    crown, leaves = forms.gather(clumps), _leaves(np.concatenate(twigs), rng)
    _fitted([crown, leaves])
    return crown, leaves


def _fitted(meshes: list[Any]) -> None:
    """Brings meshes together to the crown's extents: 300 x 300, up to 500 [cm]."""
    import numpy as np

    points = np.concatenate([np.asarray(m.vertices) for m in meshes])
    low, high = points.min(0), points.max(0)
    scale = np.array([298.0, 298.0, 499.0 - low[2]]) / (high - low)
    for mesh in meshes:
        v = np.asarray(mesh.vertices)
        mesh.vertices = (v - [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]]) * scale + [
            0,
            0,
            low[2],
        ]


def _leaves(places: Any, rng: Any) -> Any:
    """A flat four-sided sliver at every place, shape [n, 6] of positions and outward directions."""
    import numpy as np
    import trimesh

    at, out = places[:, :3], places[:, 3:]
    n = len(at)
    along = out + rng.normal(size=(n, 3)) * 0.7 - [0, 0, 0.35]
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    across = np.cross(along, rng.normal(size=(n, 3)))
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    up = np.cross(along, across)
    long, wide = rng.uniform(13, 22, (n, 1)), rng.uniform(5, 8.5, (n, 1))
    corners = np.stack(
        [
            at - 0.4 * long * along,
            at + across * wide + up * 1.6,
            at + 0.6 * long * along,
            at - across * wide + up * 1.6,
        ],
        1,
    )
    faces = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
    vertices = corners.reshape(-1, 3)
    every = (faces[None] + 4 * np.arange(n)[:, None, None]).reshape(-1, 3)
    mesh = trimesh.Trimesh(vertices, every, process=False)
    return mesh if mesh.volume > 0 else trimesh.Trimesh(vertices, every[:, ::-1], process=False)


def _trunk(variant: int) -> Any:
    """A trunk with a root flare and boughs that reach into the clumps."""
    import numpy as np

    rng = np.random.default_rng(70 + variant)
    stem = [(0, 0, 0), (0, 0, 14), (1.2, -1, 46), (-2, 1.5, 120), (1, -1, 210), (2, 0, 330)]
    fine = forms.smooth_path(stem, 18)
    radii = np.interp(fine[:, 2], [0, 8, 26, 120, 330], [22, 17.5, 13.5, 11.5, 6])
    out = [forms.tube(fine, radii, 14, round_ends=False)]
    for x, y, z, _ in _CLUMPS[1:8]:
        start = rng.uniform(165, 235)
        path = [
            (0, 0, start),
            (0.35 * x, 0.35 * y, start + 0.5 * (z - start)),
            (0.8 * x, 0.8 * y, z - 12),
        ]
        out.append(forms.tube(forms.smooth_path(path, 9), np.linspace(6.4, 2.6, 9), 8))
    return forms.gather(out)


def _fir(count: int = 9) -> Any:
    """Tiers of drooping boughs, each a jagged cone."""
    import numpy as np

    n = 44
    turn = 2 * math.pi * np.arange(n) / n
    out = []
    for k in range(count):
        t = k / (count - 1)
        reach, low = 150 * (1 - t) ** 0.85 + 16 * t, 112 + 330 * t**0.92
        high = low + 120 - 56 * t
        jag = 1 - 0.17 * (np.arange(n) % 2) - 0.09 * np.cos(5 * turn + 2.1 * k)
        rings = []
        for u, droop in ((1.0, 0.0), (0.96, 7.0), (0.62, 0.36), (0.30, 0.68), (0.05, 1.0)):
            q = reach * u * (jag if u > 0.5 else 1 - (1 - jag) * 0.4)
            z = np.full(n, low + (droop if droop > 1 else droop * (high - low)))
            z -= np.where(np.arange(n) % 2 == 0, 6.0 * u, 0.0)
            rings.append(np.c_[q * np.cos(turn), q * np.sin(turn), z])
        under = np.c_[0.3 * reach * np.cos(turn), 0.3 * reach * np.sin(turn), np.full(n, low + 16)]
        out.append(forms.loft(np.array([under, *rings])))
    boughs = forms.gather(out)
    _fitted([boughs])
    return boughs


@builder("tree")
def tree(s: Sketch, L: float, W: float, H: float, c: Color, crown: str = "round") -> None:
    """Tree, drawn at 300 x 300 x 500; rooted, so it never moves."""
    variant = s.appearance.pick("tree", 4)
    if crown == "cone":
        s.add(
            lambda: forms.tube(
                [(0, 0, 0), (0, 0, 12), (0, 0, 60), (0, 0, 460)],
                [19, 14, 12, 3],
                14,
                round_ends=False,
            ),
            _BARK,
            of="bark",
            name="trunk",
        )
        s.proxy_cylinder(14, (0, 250), 3)
        s.add(lambda: _fir(), c, of="leaves", name="boughs")
        s.proxy(ProxyKind.CYLINDER, (90, 90, 120), (0, 0, 240), 0.1)
        s.proxy(ProxyKind.CYLINDER, (45, 45, 70), (0, 0, 430), 0.1)
        return
    s.add(lambda: _trunk(variant), _BARK, of="bark", name="trunk")
    s.proxy_cylinder(14, (0, 250), 3)
    s.add(lambda: forms.copied(_leafy(variant)[0]), shade(c, 0.78), of="leaves", name="crown")
    s.add(lambda: forms.copied(_leafy(variant)[1]), shade(c, 1.12), of="leaves", name="twigs")
    s.proxy(ProxyKind.SPHERE, (145, 145, 145), (0, 0, 350), 0.1)
