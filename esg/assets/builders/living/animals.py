"""Four-legged animals, all from one plan: trunk, neck, head, legs, tail and what marks the kind.

They stand on four boxes, carry a box for the trunk and one for the head; the trunk's top is the
surface "back", so that something can ride on it. The pose of their appearance says how the drawn
legs are held (`GAITS`); what collides stands.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
import math
from typing import Any

import numpy as np

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored, shade, shift
from esg.assets.builders.living.beasts import BEASTS, GAITS, Beast
from esg.assets.builders.living.coats import NECKED, anchor, clothe, sleeves, trunk
from esg.assets.builders.living.headwear import adorn
from esg.assets.builders.living.marks import HAIR, MARKS
from esg.assets.builders.living.poses import turned_about
from esg.assets.builders.living.wild_marks import BLACK, WILD_MARKS
from esg.assets.geometry.sketch import DARK, Color, Limb, Sketch, rgb
from esg.assets.lazy import forms
from esg.lexicon.gestures import Gesture, State, told_by


def _swung(
    path: list[tuple[float, float, float]], held: tuple[float, float], ground: float
) -> list[tuple[float, float, float]]:
    """The path of a leg, from its top to the foot, swung about its top.

    Args:
        path: Points [cm].
        held: Swing of the leg and of its lower half, forwards [deg].
        ground: Height of the last point where the foot is on the ground [cm].
    """
    swing, fold = (math.radians(v) for v in held)
    (x0, _, z0), middle = path[0], 2

    def turned(
        point: tuple[float, float, float], at: tuple[float, float], angle: float
    ) -> tuple[float, float, float]:
        dx, down = point[0] - at[0], at[1] - point[2]
        cos, sin = math.cos(angle), math.sin(angle)
        return at[0] + dx * cos + down * sin, point[1], at[1] - down * cos + dx * sin

    out = [turned(p, (x0, z0), swing) for p in path]
    if fold:
        knee = (out[middle][0], out[middle][2])
        return [*out[: middle + 1], *(turned(p, knee, fold) for p in out[middle + 1 :])]
    reach = (z0 - ground) / (z0 - out[-1][2])
    return [(x0 + (x - x0) * reach, y, z0 - (z0 - z) * reach) for x, y, z in out]


def _legs(s: Sketch, b: Beast, c: Color) -> None:
    rear, front, across, top, foot = b.legs
    gait = GAITS.get(s.appearance.pose, {})
    sleeve = sleeves(s.appearance)
    for row, x, z, hock in (("rear", rear, b.trunk[0], 1.0), ("front", front, b.trunk[1], -0.45)):
        for side, word in ((-1, "right"), (1, "left")):
            y = side * across
            name = f"{row}_{word}"
            low = 0.5 * (top + foot)
            if "sprawl" in b.marks:
                path = [
                    (x, y * 0.5, z * 0.8),
                    (x + 0.2 * top, y * 0.95, z * 0.62),
                    (x + 0.4 * top, y, foot),
                ]
                radii = [top, 0.8 * top, foot]
            else:
                # Hind legs go forward at the knee and back at the hock, fore legs the other way.
                path = [
                    (x, y * 0.72, z - 0.1 * b.trunk[2]),
                    (x + 0.35 * top * hock, y * 0.9, z * 0.66),
                    (x + 0.2 * top * hock, y, z * 0.46),
                    (x - 0.55 * foot * hock, y, z * 0.26),
                    (x - 0.2 * foot, y, 1.6 * foot),
                ]
                thigh = 1.18 if row == "rear" else 1.0
                radii = [
                    1.05 * top * thigh,
                    0.98 * top * thigh,
                    0.72 * low,
                    0.86 * foot,
                    0.82 * foot,
                ]
                if name in gait:
                    path = _swung(path, gait[name], path[-1][2])
                if s.appearance.pose in RESTING and (row == "rear" or s.appearance.pose == "lie"):
                    hip = z - _drop(b) if s.appearance.pose == "lie" else 0.9 * b.trunk[2]
                    path = _folded(path, foot, row, hip)
            since = len(s.parts)
            toe, lifted = path[-1][0] + 0.2 * foot, path[-1][2] - 1.6 * foot
            if "sprawl" in b.marks or (name not in gait and s.appearance.pose not in RESTING):
                toe, lifted = x, 0.0
            s.add(
                lambda p=path, r=radii: _curved(p, r, 12, 12, 0.8),
                c,
                of=_coat(b),
                name=f"leg_{name}",
            )
            if sleeve is not None and row == "front":
                s.add(
                    lambda p=path, r=radii: _curved(p[:4], [1.12 * q for q in r[:4]], 9, 12, 0.8),
                    sleeve.color,
                    of=sleeve.surface,
                    name=f"{sleeve.name}_sleeve_{word}",
                )
            if "hooves" in b.marks:
                hoof = [(1.25 * foot, 0.0), (1.05 * foot, 1.5 * foot), (0.8 * foot, 1.7 * foot)]
                s.add(
                    lambda h=hoof, at=(toe, y, lifted): forms.turned(h, at, 18),
                    DARK,
                    of="horn",
                    name=f"hoof_{name}",
                )
            else:
                tone = shade(c, 0.35) if "socks" in b.marks else c
                s.add(
                    lambda at=(toe, y, lifted): _paw(at, foot),
                    tone,
                    of=_coat(b),
                    name=f"paw_{name}",
                )
            middle = len(path) // 2
            s.limb(Limb(f"leg_{name}", (path[0], path[middle], path[-1])), since)


RESTING = frozenset({"lie", "sit"})
"""Poses in which the hind legs are folded under the trunk; who sits stands on the fore legs."""
_SITS_DEG = 32.0
"""How far the trunk of who sits is raised."""


def _folded(
    path: list[tuple[float, float, float]], foot: float, row: str, hip: float
) -> list[tuple[float, float, float]]:
    """A leg folded beside the trunk, its foot ahead on the ground.

    Args:
        path: Of the leg that stands [cm].
        foot: Its radius there [cm].
        row: rear or front.
        hip: Height of the trunk's axis above it, at rest [cm].
    """
    (x, y, top), out, low = path[0], path[2][1], path[-1][2]
    long = top - low
    back = -0.1 if row == "front" else 0.26
    return [
        (x, y, hip),
        (x + 0.6 * back * long, 1.15 * out, 0.62 * hip),
        (x + back * long, 1.3 * out, low + 0.3 * hip),
        (x + 0.06 * long, 1.3 * out, low),
        (x + (0.4 if row == "front" else 0.3) * long, 1.25 * out, low),
    ]


def _drop(b: Beast) -> float:
    """How much lower the trunk of who lies is [cm]."""
    belly = min(b.trunk[0] - 0.86 * b.trunk[2], b.trunk[1] - 0.86 * b.trunk[3])
    return belly - 0.3 * b.legs[4]


def _rests(s: Sketch, b: Beast) -> None:
    """Lowers what is drawn of a beast that lies, or that sits with its trunk raised."""
    rear, front = b.legs[:2]
    if s.appearance.pose == "lie":
        _moved(s, lambda v, name: v - [0.0, 0.0, 0.0 if _is_low(name, "") else _drop(b)])
        return
    angle, about = math.radians(_SITS_DEG), (rear, 0.0, b.trunk[0])
    cos, sin = math.cos(angle), math.sin(angle)
    sunk = b.trunk[0] - 1.0 * b.trunk[2]
    shoulder = cos * (front - rear) - sin * (b.trunk[1] - b.trunk[0]) + rear

    def raised(v: Any, name: str) -> Any:
        if _is_low(name, "rear"):
            return v
        if _is_low(name, "front"):
            height = sin * (front - rear) + b.trunk[1] - sunk
            return v * [1.0, 1.0, height / b.trunk[1]] + [shoulder - front, 0.0, 0.0]
        x, z = v[:, 0] - about[0], v[:, 2] - about[2]
        v = v.copy()
        v[:, 0], v[:, 2] = about[0] + cos * x - sin * z, about[2] + sin * x + cos * z - sunk
        return v

    _moved(s, raised)


_BODILY = ("body", "tail", "leg", "paw", "hoof", "fleece", "cushion", "drape", "fringe", "spots")
"""How the names of parts begin that go with no head, wherever they are."""


def _gestures(s: Sketch, b: Beast, gesture: Gesture, state: State) -> None:
    """Turns head, neck and tail of a beast as a gesture has them."""
    x, z = b.neck[:2]
    nape = (x - 0.5 * b.head[0], z - 0.2 * b.head[0])
    withers = (b.legs[1] - 0.1 * b.trunk[3], b.trunk[1] + 0.1 * b.trunk[3])
    rump = (b.legs[0] - 0.6 * b.trunk[2], b.trunk[0] + 0.4 * b.trunk[2])

    def turned(v: Any, name: str) -> Any:
        own = "tail" if name.startswith("tail") else ""
        if not name.startswith(_BODILY) and "sleeve" not in name:
            middle = float(v[:, 0].mean())
            own = "head" if middle > nape[0] and name != "neck" else own
            own = own or ("neck" if middle > withers[0] else "")
        if own == "head":
            v = turned_about(v, np.array([nape[0], 0.0, nape[1]]), *by["head"])
        if own in ("head", "neck"):
            v = turned_about(v, np.array([withers[0], 0.0, withers[1]]), *by["neck"])
        if own == "tail":
            v = turned_about(v, np.array([rump[0], 0.0, rump[1]]), *by["tail"])
        return v

    by = {
        joint: tuple(gesture.angles(state, f"{joint}.{way}", 0.0) for way in ("pitch", "yaw"))
        for joint in ("head", "neck", "tail")
    }
    _moved(s, turned)


def _is_low(name: str, row: str) -> bool:
    return name.startswith((f"leg_{row}", f"paw_{row}", f"hoof_{row}"))


def _moved(s: Sketch, move: Callable[[Any, str], Any]) -> None:
    """Moves the corners of all parts, by their names."""

    def led(make: Callable[[], Any], name: str) -> Callable[[], Any]:
        def mesh() -> Any:
            out = make()
            at = np.array(move(np.asarray(out.vertices), name))
            at[:, 2] = np.maximum(at[:, 2], 0.0)  # what hangs lies on the ground
            out.vertices = at
            return out

        return mesh

    s.parts[:] = [replace(p, mesh=led(p.mesh, p.name)) for p in s.parts]


def _coat(b: Beast) -> str:
    return "skin" if b.bare else "fur"


def _curved(path: Any, radii: Any, count: int, sections: int, flat: float = 1.0) -> Any:
    """A tube along a smooth curve through points, its radius changing smoothly."""
    share = np.linspace(0, 1, len(radii))
    fine = forms.profile(np.c_[share, radii])(np.linspace(0, 1, count))
    return forms.tube(forms.smooth_path(path, count), fine, sections, flat=flat)


def _paw(at: tuple[float, float, float], foot: float) -> Any:
    x, y, z = at
    size = (2.7 * foot, 2.3 * foot, 1.9 * foot)
    toes = [
        forms.cushion(
            (1.5 * foot, 0.72 * foot, 1.0 * foot),
            (x + 1.15 * foot, y + k * 0.62 * foot, z + 0.5 * foot),
            plan=2,
            side=0.8,
            sections=8,
            levels=5,
        )
        for k in (-1, 0, 1)
    ]
    return forms.gather(
        [
            forms.cushion(
                size,
                (x + 0.2 * foot, y, z + 0.95 * foot),
                plan=2.4,
                side=0.7,
                sections=14,
                levels=7,
            ),
            *toes,
        ]
    )


def _ears(s: Sketch, b: Beast, c: Color) -> None:
    kind, length = b.ears
    x, z = b.neck[:2]
    r = b.head[0]
    if kind == "none":
        return
    for side, word in ((-1, "right"), (1, "left")):
        root = (x - 0.35 * r, side * 0.58 * r, z + 0.66 * r)

        def ear(side: int = side, root: Any = root) -> Any:
            if kind == "point":
                tip = (x - 0.5 * r, side * 0.85 * r, z + 0.6 * r + length)
                return _leaf(root, tip, 0.34 * length, 0.13 * length, (0.16, 0.3, 0.24, 0.05), side)
            if kind == "long":
                tip = (x - 0.8 * r, side * 0.75 * r, z + 0.8 * r + length)
                return _leaf(root, tip, 0.17 * length, 0.08 * length, (0.5, 1.0, 1.0, 0.5), side)
            if kind == "flop":
                tip = (x - 0.25 * r, side * 0.98 * r, z + 0.45 * r - 0.7 * length)
                bulge = (x - 0.35 * r, side * 1.1 * r, z + 0.62 * r)
                return _curved(
                    [root, bulge, tip], [0.16 * length, 0.26 * length, 0.12 * length], 12, 14, 0.5
                )
            if kind == "fan":
                size = (0.24 * length, length, 1.24 * length)
                at = (x - 0.7 * r, side * (0.75 * r + 0.3 * length), z + 0.1 * r)
                return forms.cushion(size, at, plan=2.2, side=0.9, sections=24, levels=15)
            size = {"disc": (0.5, 1.2, 1.4), "round": (1.0, 1.5, 1.9)}[kind]
            up = 0.4 * length if kind == "disc" else 0.0
            at = (root[0], root[1] * 1.2, root[2] + up)
            return forms.cushion(
                [length * v for v in size], at, plan=2, side=0.9, sections=18, levels=11
            )

        tone = {"disc": 1.2, "flop": 0.72, "long": 0.92}.get(kind, 0.86)
        skin = BLACK if "dark_ears" in b.marks else shade(c, tone)
        s.add(ear, skin, of=_coat(b), name=f"ear_{word}")


def _leaf(root: Any, tip: Any, wide: float, thick: float, widths: Any, side: int) -> Any:
    """A flat ear that tapers from root to tip, turned a little outwards."""
    a, b = np.asarray(root, float), np.asarray(tip, float)
    t = np.linspace(0, 1, 11)
    q = forms.profile(np.c_[np.linspace(0, 1, len(widths)), widths])(t) / max(widths)
    across = np.array([0.5, side * 0.86, 0.0])
    deep = np.array([0.86, -side * 0.5, 0.1])
    ring = forms.superellipse(14, 2.0)
    bend = np.sin(t * np.pi)[:, None] * across * 0.12 * wide
    rings = [
        a
        + (b - a) * v
        + o
        + ring[:, :1] * across * wide * w
        + ring[:, 1:] * deep * thick * (0.4 + 0.6 * w)
        for v, w, o in zip(t, q, bend, strict=True)
    ]
    return forms.loft(np.array(rings))


def _tail(s: Sketch, b: Beast, c: Color) -> None:
    length, droop, root, tip = b.tail
    level = max(0.0, 1 - abs(droop))
    start = (b.legs[0] - 0.8 * b.trunk[2], 0.0, b.trunk[0] + 0.5 * b.trunk[2])
    end = (start[0] - length * level - 2, 0.0, start[2] - length * droop)
    if end[2] < tip:
        end = (end[0], 0.0, tip)
    sag = 0.16 * length * (1 if droop >= 0 else -1)
    inside = (start[0] + 0.5 * b.trunk[2], 0.0, start[2] - 0.1 * b.trunk[2])
    middle = (
        0.55 * start[0] + 0.45 * end[0] - 0.3 * abs(sag),
        0.0,
        max(0.5 * (start[2] + end[2]) - 0.5 * sag, 0.275 * (start[2] + end[2])),
    )
    path, radii = [inside, start, middle, end], [root, root, 0.55 * (root + tip), tip]
    s.add(lambda: _curved(path, radii, 18, 12), c, of=_coat(b), name="tail")
    if b.marks & {"tip", "tuft"}:
        tone = rgb(240, 236, 228) if "tip" in b.marks else rgb(96, 58, 28)
        s.ball(1.3 * tip, end, tone, detail=3, of="fur", name="tail_tip")


def _body(s: Sketch, b: Beast, c: Color) -> None:
    front, (zf, rf) = b.legs[1], (b.trunk[1], b.trunk[3])
    x, z, thick, thin = b.neck
    r, reach, drop, muzzle = b.head
    coat = _coat(b)
    s.add(lambda: trunk(b), c, of=coat, name="body")
    nape = [
        (front - 0.25 * rf, 0, zf + 0.1 * (rf - thick)),
        (front + 0.45 * (x - front) * 0.6, 0, zf + 0.5 * (rf - thick) + 0.34 * (z - zf)),
        (x - 0.35 * r, 0, z - 0.05 * r),
    ]
    s.add(
        lambda: _curved(nape, [thick, 0.5 * (thick + thin), thin], 10, 16, 0.86),
        c,
        of=coat,
        name="neck",
    )
    s.add(lambda: _skull(b), c, of=coat, name="head")
    tip = (x + reach + 0.98 * muzzle, 0.0, z + drop + 0.36 * muzzle)
    s.add(
        lambda: forms.cushion(
            (0.68 * muzzle, 1.0 * muzzle, 0.68 * muzzle),
            tip,
            plan=2.4,
            side=0.8,
            sections=14,
            levels=9,
        ),
        DARK,
        of="leather",
        name="nose",
    )
    gape = [
        (x + reach - 0.1 * muzzle, 0.82 * muzzle, z + drop - 0.4 * muzzle),
        (x + reach + 0.5 * muzzle, 0.62 * muzzle, z + drop - 0.36 * muzzle),
        (x + reach + 1.2 * muzzle, 0.0, z + drop - 0.2 * muzzle),
    ]
    mouth = [*gape, *((p, -q, v) for p, q, v in reversed(gape[:-1]))]
    s.add(
        lambda: _curved(mouth, [0.07 * muzzle] * 5, 17, 6), shade(c, 0.3), of="skin", name="mouth"
    )
    for side, word in ((-1, "right"), (1, "left")):
        at = (x + 0.58 * r, side * 0.53 * r, z + 0.34 * r)
        s.ball(0.16 * r, at, DARK, of="glass_dark", alpha=1.0, detail=2, name=f"eye_{word}")
        lid = (at[0] - 0.03 * r, at[1] - side * 0.02 * r, at[2] + 0.14 * r)
        s.add(
            lambda lid=lid: forms.cushion(
                (0.4 * r, 0.3 * r, 0.16 * r), lid, plan=2, side=0.8, sections=12, levels=7
            ),
            shade(c, 0.82),
            of=coat,
            name=f"lid_{word}",
        )


def _skull(b: Beast) -> Any:
    """Brow, cheeks and muzzle; the brow stands above the muzzle by a step."""
    x, z = b.neck[:2]
    r, reach, drop, muzzle = b.head
    path = [
        (x - 0.62 * r, 0, z - 0.04 * r),
        (x - 0.1 * r, 0, z + 0.02 * r),
        (x + 0.5 * r, 0, z - 0.08 * r),
        (x + 0.55 * (reach + 0.5 * r), 0, z + 0.72 * drop),
        (x + reach, 0, z + drop),
        (x + reach + 0.45 * muzzle, 0, z + drop),
    ]
    middle = max(muzzle * 1.02, 0.5 * (0.8 * r + muzzle))
    return _curved(path, [0.78 * r, r, 0.84 * r, middle, muzzle, 0.8 * muzzle], 18, 18, 0.88)


def _proxies(s: Sketch, b: Beast) -> None:
    rear, front, across, top, _ = b.legs
    zr, zf, rr, rf = b.trunk
    x, z = b.neck[:2]
    r, reach, drop, muzzle = b.head
    low = max(min(zr - 0.7 * rr, zf - 0.7 * rf), 0.2 * zr)
    high = max(zr + 0.85 * rr, zf + 0.85 * rf)
    half = max(0.8 * top, 0.35 * across)
    for px in (rear, front):
        for side in (-1, 1):
            s.proxy_slab(
                (px - half, px + half),
                mirrored(side, across - half, across + half),
                (0, low),
                0.8,
            )
    back = (rear - 0.8 * rr, front + 0.8 * rf)
    wide = 0.88 * max(rr, rf)
    s.proxy_slab(back, (-wide, wide), (low, high), 1.0)
    top_z = z + 0.9 * r
    face = min(low if z - 1.2 * r < high else high, z - 0.9 * r)
    near = max(back[1], x - 0.9 * r)
    s.proxy_slab(
        (near, max(x + reach + 0.8 * muzzle, near + r)),
        (-0.75 * r, 0.75 * r),
        (max(face, z + drop - 1.2 * muzzle), top_z),
        0.7,
    )
    if top_z - 1.8 * r > high:
        s.proxy_slab((front - 0.4 * rf, x + 0.6 * r), (-0.6 * r, 0.6 * r), (high, top_z), 0.4)
    s.surface(
        "back", high, (0.32 * (back[1] - back[0]), 0.6 * wide), (0.5 * (back[0] + back[1]), 0)
    )


@builder("quadruped")
def quadruped(s: Sketch, L: float, W: float, H: float, c: Color, kind: str = "dog") -> None:
    """A four-legged animal facing +X, drawn in the proportions of its kind."""
    b = BEASTS[kind]
    pose, gesture, state = told_by(s.appearance.pose, "beasts")
    s.appearance = replace(s.appearance, pose=pose)
    worn = {w.kind for w in s.appearance.wears}
    limb = rgb(58, 50, 46) if b.marks & {"wool", "dark_limbs"} else c
    _legs(s, b, limb)
    _tail(s, b, HAIR if kind == "horse" else c)
    _body(s, b, c)
    _ears(s, b, c)
    for mark, draw in (MARKS | WILD_MARKS).items():
        if mark in b.marks and not (mark == "collar" and worn & NECKED):
            draw(s, b, c)
    clothe(s, b)
    adorn(s, anchor(b))
    if gesture is not None:
        _gestures(s, b, gesture, state)
    if pose in RESTING:
        _rests(s, b)
    _proxies(s, b)
    shift(s, b.move)
