"""Hats, glasses and what is worn about a neck: drawn on an upright human head, led onto others.

Everything is drawn on a head about `bodies.HEAD`; animals wear the same, moved and scaled onto
their own heads (`Anchor`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
import math
from typing import Any

from esg.assets.appearance import Wear
from esg.assets.builders.common import shade
from esg.assets.builders.living import bodies, clothes
from esg.assets.geometry.sketch import DARK, WHITE, Color, Sketch, rgb
from esg.assets.lazy import forms
from esg.assets.materials import MATERIALS
from esg.graph.models import Vec3
from esg.lexicon.garments import garments

Draw = Callable[[Sketch], None]
_EYES_X, _EYES_Y, _EYES_Z = 7.75, 3.3, 0.9
"""Of a human head, from its middle [cm]."""


@dataclass(frozen=True)
class Piece:
    """What is drawn: the name of its parts, their colour and material."""

    name: str
    color: Color
    surface: str = "textile"


def piece(w: Wear) -> Piece:
    """A garment with its stated colour and material, or the usual ones."""
    from esg.assets.library.catalogue import parse_hex

    known = garments()[w.kind.replace("-", " ")]
    usual = parse_hex(known.color) if known.color else rgb(120, 122, 126)
    if w.surface not in ("", "textile"):
        usual = MATERIALS[w.surface].color  # a leather jacket is brown
    return Piece(slug(w.kind), w.color or usual, w.surface or known.surface)


def slug(kind: str) -> str:
    """The name of a kind's drawn parts."""
    return kind.replace(" ", "_").replace("-", "_")


def named(s: Sketch, name: str, draw: Draw) -> None:
    """Draws parts that are called by what is worn, each with its own name behind."""
    first = len(s.parts)
    draw(s)
    s.parts[first:] = [
        p if p.name == name else replace(p, name=f"{name}_{p.name}") for p in s.parts[first:]
    ]


def _marked(mark: str) -> Callable[[Sketch, Piece], None]:
    """What `clothes` draws for a mark."""
    return lambda s, p: clothes.hats(s, frozenset({mark}), p.color, p.color)


def _top_hat(s: Sketch, p: Piece) -> None:
    brim = [(8.6, 0), (14.2, 0.2), (14.6, 0.8), (14.2, 1.2), (9.4, 1.4), (9.2, 15), (8.8, 15.8)]
    s.add(lambda: forms.turned(brim, (-0.6, 0, 165.6), 36), p.color, of=p.surface, name=p.name)
    ribbon = [(9.5, 1.4), (9.6, 4.0), (9.0, 4.0), (9.0, 1.4), (9.5, 1.4)]
    tone = shade(p.color, 0.5) if max(p.color) > 0.3 else rgb(120, 24, 34)
    s.add(lambda: forms.turned(ribbon, (-0.6, 0, 165.6), 36), tone, of="textile", name="ribbon")


def _beanie(s: Sketch, p: Piece) -> None:
    turn = [math.radians(a) for a in range(0, 91, 9)]
    dome = [(9.0, 0), *((10.4 * math.cos(a), 11.4 * math.sin(a)) for a in turn)]
    s.add(lambda: forms.turned(dome, (-0.6, 0, 162.0), 32), p.color, of=p.surface, name=p.name)
    rim = [(9.8, 0), (11.2, 0.6), (11.3, 3.6), (10.4, 4.4), (9.8, 0)]
    tone = shade(p.color, 0.8)
    s.add(lambda: forms.turned(rim, (-0.6, 0, 161.2), 32), tone, of=p.surface, name="rim")
    s.ball(2.6, (-0.6, 0, 175.0), shade(p.color, 1.25), of="fur", detail=3, name="bobble")


def _cone(s: Sketch, p: Piece) -> None:
    def ring(low: float, high: float, grow: float) -> list[tuple[float, float]]:
        return [(6.6 * (1 - h / 21.0) + grow, h) for h in (low, high)]

    cone = [(6.6, 0), (0.5, 20.0)]
    at = (-0.6, 0, 169.0)
    s.add(lambda: forms.turned(cone, at, 32), p.color, of=p.surface, name=p.name)
    pale = WHITE if max(p.color) - min(p.color) > 0.15 or max(p.color) < 0.6 else rgb(216, 67, 154)
    for low in (3.4, 10.0):
        stripe = [(0.5, low), *ring(low, low + 2.6, 0.2), (0.5, low + 2.6)]
        s.add(lambda q=stripe: forms.turned(q, at, 32), pale, of="paper", name="stripe")
    s.ball(2.3, (-0.6, 0, 189.4), pale, of="fur", detail=3, name="bobble")


def _santa(s: Sketch, p: Piece) -> None:
    path = [(-0.6, 0, 163.5), (-1.5, 0, 170), (-5.0, 1.5, 176), (-10, 4.5, 176.5), (-13, 7.5, 171)]
    radii = [10.6, 9.0, 5.8, 3.6, 1.6]
    s.add(lambda: forms.tube(forms.smooth_path(path, 14), _fine(radii, 14), 24), p.color,
          of=p.surface, name=p.name)  # fmt: skip
    rim = [(9.6, 0), (11.6, 0.8), (11.8, 4.0), (10.4, 5.0), (9.6, 0)]
    s.add(lambda: forms.turned(rim, (-0.6, 0, 162.0), 32), WHITE, of="fur", name="rim")
    s.ball(2.8, (-13.4, 8.0, 169.6), WHITE, of="fur", detail=3, name="bobble")


def _fine(radii: list[float], count: int) -> Any:
    import numpy as np

    return np.interp(np.linspace(0, 1, count), np.linspace(0, 1, len(radii)), radii)


def _witch(s: Sketch, p: Piece) -> None:
    outline = [(9, 0), (16.4, 0), (16.6, 0.8), (9.8, 1.4), (7.2, 9), (4, 19), (0.5, 27)]
    s.add(lambda: forms.turned(outline, (-0.8, 0, 164.6), 36), p.color, of=p.surface, name=p.name)
    ribbon = [(10.2, 1.4), (9.4, 4.2), (8.8, 4.2), (9.4, 1.4), (10.2, 1.4)]
    s.add(lambda: forms.turned(ribbon, (-0.8, 0, 164.6), 36), rgb(112, 60, 140), of="textile",
          name="ribbon")  # fmt: skip


def _beret(s: Sketch, p: Piece) -> None:
    s.add(
        lambda: forms.cushion((24, 25, 6.4), (-1.6, 1.6, 169.6), plan=2.0, side=0.7),
        p.color,
        of=p.surface,
        name=p.name,
    )
    s.ball(0.8, (-1.6, 1.6, 173.0), shade(p.color, 0.8), of=p.surface, detail=2, name="stalk")


def _turban(s: Sketch, p: Piece) -> None:
    for k, (z, major, minor) in enumerate(
        ((164.5, 8.2, 3.2), (168.6, 7.2, 3.4), (172.0, 4.6, 3.2))
    ):
        lean = 1.2 if k % 2 else -1.2
        loop = [
            (major * math.cos(t) - 0.8, major * math.sin(t), z + lean * math.sin(t))
            for t in (math.pi * j / 14 for j in range(28))
        ]
        tone = shade(p.color, 1.0 if k % 2 else 0.9)
        s.add(lambda q=loop, r=minor: forms.tube(q, r, 12, closed=True), tone, of=p.surface,
              name=p.name)  # fmt: skip
    s.ball(6.0, (-0.8, 0, 171.0), shade(p.color, 0.9), of=p.surface, detail=3, name="top")


def _headscarf(s: Sketch, p: Piece) -> None:
    s.add(lambda: bodies.hair("covered"), p.color, of=p.surface, name=p.name)
    drape = [(5.2, 0), (8.6, 0.4), (10.6, 5), (9.4, 10.5), (6.4, 13.4)]
    s.add(lambda: forms.turned([(r, h) for r, h in drape], (-2.2, 0, 138.6), 32), p.color,
          of=p.surface, name="drape")  # fmt: skip


def _hood(s: Sketch, p: Piece) -> None:
    s.add(lambda: bodies.hair("hooded"), p.color, of=p.surface, name=p.name)
    drape = [(6.0, 0), (13.0, 0.2), (11.6, 5), (9.8, 11), (6.4, 14.0)]
    s.add(lambda: forms.turned(drape, (-2.4, 0, 138.0), 32), p.color, of=p.surface, name="drape")


def _headband(s: Sketch, p: Piece) -> None:
    ring = [(9.9, 0), (10.5, 0.6), (10.5, 3.2), (9.9, 3.8), (9.4, 3.4), (9.4, 0.4), (9.9, 0)]

    def make() -> Any:
        out = forms.turned(ring, (0, 0, 0), 32)
        out.vertices = out.vertices * [0.99, 0.84, 1.0] + [-0.8, 0.0, 164.0]
        return out

    s.add(make, p.color, of=p.surface, name=p.name)


def _headphones(s: Sketch, p: Piece) -> None:
    bow = [(-1.2, 9.2 * math.cos(t), 160.5 + 12.6 * math.sin(t))
           for t in (math.pi * k / 12 for k in range(13))]  # fmt: skip
    s.add(lambda: forms.tube(bow, 0.9, 10), p.color, of=p.surface, name=p.name)
    for side in (-1, 1):
        s.add(
            lambda y=side * 8.8: forms.cushion(
                (6.6, 3.6, 8.0), (-1.2, y, 158.6), plan=2.2, side=0.6
            ),
            p.color,
            of=p.surface,
            name="cushion",
        )


def _lenses(s: Sketch, p: Piece, *, dark: bool) -> None:
    """Two rims about the eyes, panes and temples."""
    x, z = bodies.HEAD[0] + 9.9, bodies.HEAD[2] + _EYES_Z
    across, up = 2.9, 2.4

    def rims() -> Any:
        out = []
        for side in (-1, 1):
            loop = [
                (
                    x - 0.1 * abs(math.cos(t)),
                    side * 3.7 + across * math.cos(t),
                    z + up * math.sin(t),
                )
                for t in (math.pi * k / 10 for k in range(20))
            ]
            out.append(forms.tube(loop, 0.42, 8, closed=True))
            back = [(x, side * 6.6, z + 0.6), (x - 5, side * 8.0, z + 0.9),
                    (x - 11, side * 8.4, z + 0.4)]  # fmt: skip
            out.append(forms.tube(back, 0.4, 8))
        bridge = [(x, -1.0, z + 0.4), (x + 0.5, 0, z + 0.8), (x, 1.0, z + 0.4)]
        return forms.gather([*out, forms.tube(bridge, 0.4, 8)])

    def panes() -> Any:
        return forms.gather([
            forms.cushion((0.6, 2 * across, 2 * up), (x - 0.05, side * 3.7, z), plan=2, side=0.9,
                          sections=20, levels=9)
            for side in (-1, 1)
        ])  # fmt: skip

    s.add(rims, p.color, of=p.surface, name=p.name)
    if dark:
        tone = p.color if max(p.color) < 0.35 else shade(p.color, 0.35)
        s.add(panes, tone, of="plastic_hard", rough=0.15, name="lenses")
    else:
        s.add(panes, rgb(214, 228, 234), of="glass", alpha=0.25, name="lenses")


def _goggles(s: Sketch, p: Piece) -> None:
    clothes.face_marks(s, frozenset({"goggles"}), p.color)
    s.parts[-1] = replace(s.parts[-1], color=p.color)
    strap = [(9.2 * math.cos(t) - 0.4, 8.0 * math.sin(t), 159.6)
             for t in (math.pi * k / 14 for k in range(28))]  # fmt: skip
    s.add(lambda: forms.tube(strap, 0.8, 8, closed=True), DARK, of="textile", name="strap")


def _face_mask(s: Sketch, p: Piece) -> None:
    x, _, z = bodies.HEAD

    def make() -> Any:
        from shapely.geometry import Polygon

        shell = bodies.skull(0.9)
        outline = Polygon([(-6.4, -1.2), (6.4, -1.2), (6.6, -5.0), (4.6, -9.6), (-4.6, -9.6),
                           (-6.6, -5.0)])  # fmt: skip
        tool = forms.prism(outline, (2.0, 30.0), "yz")
        for mesh in tool:
            mesh.apply_translation([x, 0, z])
        cover = forms.inlay(shell, tool)
        nose = forms.cushion((3.4, 4.6, 5.0), (x + 9.9, 0, z - 3.4), plan=2.2, side=0.9)
        return forms.gather([cover, nose])

    s.add(make, p.color, of=p.surface, name=p.name)


def _scarf(s: Sketch, p: Piece) -> None:
    for lift, minor in ((0.0, 2.5), (3.2, 2.3)):
        loop = [(6.8 * math.cos(t) - 2.0, 7.0 * math.sin(t), 144.6 + lift - 0.8 * math.cos(t))
                for t in (math.pi * k / 12 for k in range(24))]  # fmt: skip
        s.add(lambda q=loop, r=minor: forms.tube(q, r, 10, closed=True), p.color, of=p.surface,
              name=p.name)  # fmt: skip


def _bow_tie(s: Sketch, p: Piece) -> None:
    def make() -> Any:
        out = [forms.cushion((2.0, 2.0, 2.2), (6.6, 0, 143.4), plan=2.4, side=0.8)]
        for side in (-1, 1):
            wing = [(6.4, side * 0.8, 143.4), (6.2, side * 3.2, 143.4), (5.4, side * 5.6, 143.4)]
            out.append(forms.tube(wing, [0.9, 1.7, 2.5], 12, flat=0.5))
        return forms.gather(out)

    s.add(make, p.color, of=p.surface, name=p.name)


def _bandana(s: Sketch, p: Piece) -> None:
    loop = [(6.2 * math.cos(t) - 2.2, 6.6 * math.sin(t), 144.8 - 1.4 * math.cos(t))
            for t in (math.pi * k / 12 for k in range(24))]  # fmt: skip
    s.add(lambda: forms.tube(loop, 1.3, 10, closed=True), p.color, of=p.surface, name=p.name)

    def corner() -> Any:
        return forms.tube([(5.6, 0, 143.0), (8.2, 0, 138.5), (9.6, 0, 133.0)], [5.4, 4.0, 0.6], 12,
                          flat=0.25)  # fmt: skip

    s.add(corner, p.color, of=p.surface, name=f"{p.name}_corner")


def _collar(s: Sketch, p: Piece) -> None:
    loop = [(6.2 * math.cos(t) - 2.4, 6.4 * math.sin(t), 145.0)
            for t in (math.pi * k / 12 for k in range(24))]  # fmt: skip
    s.add(lambda: forms.tube(loop, 1.3, 10, closed=True), p.color, of=p.surface, name=p.name)
    s.ball(1.0, (5.0, 0, 143.2), rgb(214, 176, 60), of="brass", detail=2, name="tag")


HEADWEAR: dict[str, Callable[[Sketch, Piece], None]] = {
    "hat": _marked("wide_hat"),
    "cowboy hat": _marked("wide_hat"),
    "straw hat": _marked("wide_hat"),
    "top hat": _top_hat,
    "cap": _marked("cap"),
    "beanie": _beanie,
    "party hat": _cone,
    "santa hat": _santa,
    "witch hat": _witch,
    "chef hat": _marked("toque"),
    "beret": _beret,
    "turban": _turban,
    "headscarf": _headscarf,
    "headband": _headband,
    "crown": lambda s, p: clothes.crown(s, p.color),
    "helmet": _marked("sport_helmet"),
    "hard hat": _marked("hard_hat"),
    "headphones": _headphones,
    "hood": _hood,
    "glasses": lambda s, p: _lenses(s, p, dark=False),
    "sunglasses": lambda s, p: _lenses(s, p, dark=True),
    "goggles": _goggles,
    "face mask": _face_mask,
    "scarf": _scarf,
    "bow tie": _bow_tie,
    "bandana": _bandana,
    "collar": _collar,
}
"""What is drawn on an upright head and about its neck, by kind."""
NECKS = frozenset({"scarf", "bow tie", "bandana", "collar"})
"""Kinds that are worn about the neck."""
FACES = frozenset({"glasses", "sunglasses", "goggles", "face mask"})
"""Kinds that are worn before the face."""


@dataclass(frozen=True)
class Anchor:
    """Where an animal wears what a person wears on head, face and neck [cm].

    Args:
        head: Middle of the head.
        radius: Of the head.
        neck: Where a collar goes, and its radius.
        neck_radius: Of the neck there.
        eyes: From the middle of the head to one eye: ahead, aside and up.
        rise: Pitch of the neck's axis against upright, forwards [deg].
    """

    head: Vec3
    radius: float
    neck: Vec3
    neck_radius: float
    eyes: Vec3
    rise: float = 0.0


def adorn(s: Sketch, at: Anchor) -> None:
    """Draws what an animal wears on head, face and neck, as its appearance says."""
    for w in s.appearance.wears:
        draw = HEADWEAR.get(w.kind)
        if draw is None:
            continue
        flat = Sketch(material=s.material, appearance=s.appearance)
        p = piece(w)
        named(flat, p.name, lambda q, d=draw, o=p: d(q, o))
        place = _placing(w.kind, at)
        for part in flat.parts:
            s.parts.append(replace(part, mesh=_led(part.mesh, place)))


def _placing(kind: str, at: Anchor) -> Callable[[Any], Any]:
    """How points of a human head get to where an animal has the like."""
    import numpy as np

    tilt = 0.0
    if kind in NECKS:
        k, tilt = at.neck_radius / 5.2, at.rise
        origin, goal, scale = np.array([-2.3, 0.0, 145.0]), at.neck, (k, k, 0.8 * k)
    elif kind in FACES:
        k, (ahead, _, up) = at.eyes[1] / _EYES_Y, at.eyes
        origin = bodies.HEAD + np.array([_EYES_X, 0.0, _EYES_Z])
        goal, scale = (at.head[0] + ahead, at.head[1], at.head[2] + up), (0.65 * k, k, 1.1 * k)
    else:
        k = at.radius / 9.4
        origin = bodies.HEAD + np.array([0.0, 0.0, 5.0])
        goal = (at.head[0] - 0.1 * at.radius, at.head[1], at.head[2] + 0.62 * at.radius)
        scale = (0.86 * k, 0.92 * k, k)
    a = math.radians(tilt)
    pitch = np.array([[math.cos(a), 0, math.sin(a)], [0, 1, 0], [-math.sin(a), 0, math.cos(a)]])
    return lambda points: ((points - origin) * np.array(scale)) @ pitch.T + np.array(goal)


def _led(make: Callable[[], Any], place: Callable[[Any], Any]) -> Callable[[], Any]:
    return lambda: bodies.posed(make(), place)
