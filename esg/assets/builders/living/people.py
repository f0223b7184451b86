"""People: one body, dressed by what they are and posed by what they do; all face +X.

Every dress and pose has the same proxies, those of a standing body, so that a cook falls as a guard
does: who somebody is and what he does changes the picture and nothing else.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
import math
from typing import Any

from esg.assets.appearance import Appearance
from esg.assets.builders import builder
from esg.assets.builders.common import shade
from esg.assets.builders.living import bodies, clothes
from esg.assets.builders.living.clothes import SHIRT
from esg.assets.builders.living.headwear import Piece
from esg.assets.builders.living.outfits import Outfit, outfit
from esg.assets.builders.living.poses import Pose, Skeleton, pose_of, skeleton
from esg.assets.geometry.sketch import (
    DARK,
    ORANGE,
    RED,
    STEEL,
    WHITE,
    YELLOW,
    Color,
    Limb,
    Sketch,
    rgb,
)
from esg.assets.lazy import forms
from esg.lexicon.gestures import MARK

_PALE, _FAIR, _TAN, _BROWN = (
    rgb(228, 190, 162),
    rgb(214, 172, 140),
    rgb(176, 126, 90),
    rgb(118, 78, 54),
)
_BLACK_HAIR, _BROWN_HAIR, _FAIR_HAIR, _GREY_HAIR = (
    rgb(36, 30, 28),
    rgb(84, 56, 36),
    rgb(196, 156, 88),
    rgb(168, 166, 162),
)
_JEANS, _NAVY = rgb(50, 60, 90), rgb(34, 42, 68)
_STRIDE = 10.0
"""Swing of a leg [deg] from which on a skirt is in its way."""
_CUTS = ("short", "short", "short", "bald")
SIDES = ("left", "right")
_FOLK = (
    (_FAIR, _BROWN_HAIR),
    (_PALE, _FAIR_HAIR),
    (_TAN, _BLACK_HAIR),
    (_BROWN, _BLACK_HAIR),
    (rgb(92, 60, 42), _BLACK_HAIR),
    (_PALE, rgb(128, 62, 32)),
    (_FAIR, _GREY_HAIR),
)
_TROUSERS = (_JEANS, rgb(44, 46, 52), rgb(120, 104, 80), rgb(70, 84, 108), rgb(88, 92, 74))


@dataclass(frozen=True)
class Dress:
    """What somebody wears over a coat of the asset's own colour.

    Args:
        skin: Of face and hands.
        hair: Of the head.
        legs: Trousers, stockings or shorts; None takes the asset's colour.
        marks: Hats, coats and what else `clothes` draws.
        shoes: Of both feet.
        hat: Of whatever is on the head; None takes the asset's colour.
    """

    skin: Color
    hair: Color
    legs: Color | None
    marks: frozenset[str]
    shoes: Color = DARK
    hat: Color | None = None


def _dress(
    skin: Color,
    hair: Color,
    legs: Color | None,
    marks: str = "",
    shoes: Color = DARK,
    hat: Color | None = None,
) -> Dress:
    return Dress(skin, hair, legs, frozenset(marks.split()), shoes, hat)


DRESSES: dict[str, Dress] = {
    "plain": _dress(_FAIR, _BROWN_HAIR, _JEANS, "belt"),
    "worker": _dress(_TAN, _BLACK_HAIR, _JEANS, "hard_hat bands", rgb(110, 78, 44), YELLOW),
    "mechanic": _dress(_FAIR, _BLACK_HAIR, None, "cap bib", DARK),
    "chef": _dress(_PALE, _BROWN_HAIR, rgb(60, 62, 66), "toque apron buttons", DARK, WHITE),
    "officer": _dress(_BROWN, _BLACK_HAIR, _NAVY, "peaked_cap belt badge tie"),
    "soldier": _dress(_FAIR, _BROWN_HAIR, None, "helmet belt pack", rgb(58, 44, 30)),
    "firefighter": _dress(_FAIR, _BROWN_HAIR, rgb(46, 46, 50), "coat brim_helmet bands", DARK, RED),
    "knight": _dress(
        _PALE, _BROWN_HAIR, rgb(150, 153, 158), "great_helm belt tabard", STEEL, STEEL
    ),
    "astronaut": _dress(_FAIR, _BROWN_HAIR, None, "space_helmet pack badge", rgb(150, 153, 158)),
    "athlete": _dress(_BROWN, _BLACK_HAIR, SHIRT, "shorts chest_band", SHIRT),
    "sportsman": _dress(
        _PALE, _FAIR_HAIR, rgb(40, 42, 50), "sport_helmet goggles bands_thin", DARK
    ),
    "woman": _dress(_TAN, _BROWN_HAIR, _TAN, "skirt long_hair", rgb(150, 40, 44)),
    "robe": _dress(_PALE, _GREY_HAIR, None, "robe belt beard"),
    "royal": _dress(_PALE, _GREY_HAIR, None, "robe crown beard cape"),
    "wizard": _dress(_PALE, _GREY_HAIR, None, "robe cone_hat beard belt"),
    "doctor": _dress(_TAN, _BLACK_HAIR, rgb(92, 150, 160), "coat shirt", rgb(230, 230, 226)),
    "suit": _dress(_FAIR, _BLACK_HAIR, None, "shirt tie"),
    "countryman": _dress(
        _TAN, _BROWN_HAIR, _JEANS, "wide_hat belt", rgb(96, 60, 34), rgb(150, 108, 62)
    ),
    "hiker": _dress(_PALE, _FAIR_HAIR, rgb(132, 112, 76), "cap belt big_pack", rgb(96, 60, 34)),
    "clown": _dress(_PALE, ORANGE, rgb(44, 98, 190), "wig ruff red_nose buttons_large", RED),
    "child": _dress(_FAIR, _BROWN_HAIR, rgb(52, 74, 120), "", rgb(230, 230, 226)),
    "bather": _dress(_FAIR, _BROWN_HAIR, _FAIR, "bare shorts_own", _FAIR),
}


@dataclass(frozen=True)
class _Drawer:
    """Where parts go: onto a posed body, by what they are fixed to."""

    s: Sketch
    skeleton: Skeleton
    size: float = 1.0

    def on(self, move: Callable[[Any], Any], draw: Callable[[Sketch], None]) -> None:
        """Draws what a straight body wears and leads it along with the pose."""
        flat = Sketch(material=self.s.material, appearance=self.s.appearance)
        draw(flat)
        for part in flat.parts:
            self.s.parts.append(replace(part, mesh=self._led(part.mesh, move)))

    def add(self, make: Callable[[], Any], c: Color, of: str, name: str) -> None:
        """Draws what follows the joints by itself."""
        self.s.add(lambda: self._placed(make()), c, of=of, name=name)

    def limb(
        self,
        name: str,
        joints: Any,
        since: int,
        tip: int | None = None,
        pitch: float = 0.0,
        reach: float = 1.0,
    ) -> None:
        """Says that what was drawn from a part on is a limb through joints of the skeleton."""
        placed = bodies.at_rest(joints, self.skeleton) * self.size
        a, b, c = ((float(x), float(y), float(z)) for x, y, z in placed)
        self.s.limb(Limb(name, (a, b, c), pitch, reach), since, tip=tip)

    def _led(self, make: Callable[[], Any], move: Callable[[Any], Any]) -> Callable[[], Any]:
        if self.skeleton.pose.seated or self.skeleton.pose.lies:
            return lambda: self._placed(bodies.posed(make(), move))
        return lambda: bodies.on_ground(self._placed(bodies.posed(make(), move)))

    def _placed(self, mesh: Any) -> Any:
        return bodies.scaled(bodies.raised(mesh, self.skeleton), self.size)


def _legs(body: _Drawer, marks: frozenset[str], d: Dress, c: Color, o: Outfit) -> None:
    legs = o.legs or Piece("trousers", d.legs or c)
    bare = o.bare_legs or bool(marks & {"shorts", "skirt", "shorts_own"})
    for k, word in enumerate(SIDES):
        joints, since = body.skeleton.legs[k], len(body.s.parts)
        if bare:
            body.add(
                lambda j=joints: bodies.limb(j, (8.4, 8.0, 6.6, 5.4, 5.9, 4.8, 3.5)),
                d.skin,
                "skin",
                f"leg_{word}",
            )
        else:
            body.add(
                lambda j=joints: bodies.limb(j, (9.2, 8.9, 7.8, 6.7, 6.7, 6.3, 5.9)),
                legs.color,
                legs.surface,
                f"{legs.name}_{word}",
            )
        if o.shorts is not None or marks & {"shorts", "shorts_own"}:
            own = (d.legs or c) if "shorts" in marks else c
            short = o.shorts or Piece("shorts", own)
            body.add(
                lambda j=joints: bodies.limb(bodies.between(j, 0, 0.34), (9.4, 9.3, 9.2, 9.0)),
                short.color,
                short.surface,
                f"{short.name}_{word}",
            )
        if o.socks is not None or "shorts" in marks:
            sock = o.socks or Piece("sock", c, "knit")
            body.add(
                lambda j=joints: bodies.limb(bodies.between(j, 0.66, 0.97), (6.2, 6.1, 5.2, 4.3)),
                sock.color,
                sock.surface,
                f"{sock.name}_{word}",
            )
        tip = len(body.s.parts)
        _foot(body, k, marks, d, o)
        body.limb(f"leg_{word}", joints, since, tip, body.skeleton.feet[k], _hem(marks | o.hems))


def _foot(body: _Drawer, k: int, marks: frozenset[str], d: Dress, o: Outfit) -> None:
    """What is on a foot, or the foot."""
    word, ankle, pitch = SIDES[k], body.skeleton.legs[k][2], body.skeleton.feet[k]
    if o.barefoot or ("bare" in marks and o.shoes is None):
        name = "bare_feet" if o.barefoot else "foot"
        body.add(lambda: bodies.foot(ankle, pitch), d.skin, "skin", f"{name}_{word}")
        return
    shoe = o.shoes or Piece("shoe", d.shoes, "leather")
    booted = bool(marks & {"hard_hat", "helmet", "brim_helmet", "great_helm", "space_helmet"})
    boot = o.boot if o.boot is not None else 9.0 * booted
    body.add(
        lambda: bodies.shoe(ankle, pitch, boot), shoe.color, shoe.surface, f"{shoe.name}_{word}"
    )
    if boot > 9.0:
        shaft = bodies.between(body.skeleton.legs[k], 0.97 - 0.012 * boot, 1.0)
        body.add(
            lambda: bodies.limb(shaft, (7.6, 7.4, 7.0, 6.7)),
            shoe.color,
            shoe.surface,
            f"{shoe.name}_{word}",
        )
    body.add(
        lambda: bodies.sole(ankle, pitch),
        shade(shoe.color, 0.6) if max(shoe.color) > 0.5 else rgb(196, 194, 188),
        "rubber",
        f"sole_{word}",
    )
    if shoe.name == "rain_boots":
        return
    body.add(
        lambda: bodies.laces(ankle, pitch),
        rgb(226, 224, 218) if max(shoe.color) < 0.5 else DARK,
        "textile",
        f"laces_{word}",
    )


def _arms(body: _Drawer, marks: frozenset[str], d: Dress, top: Piece, o: Outfit) -> None:
    short = bool(marks & {"shorts", "skirt"}) or (
        body.s.appearance.pick("sleeves", 3) == 1 and marks == DRESSES["plain"].marks
    )
    bare = "bare" in marks
    if o.sleeves:
        short, bare = o.sleeves == "short", o.sleeves == "none"
    grip = body.skeleton.pose.grip
    for k, word in enumerate(SIDES):
        _, elbow, wrist = joints = body.skeleton.arms[k]
        since = len(body.s.parts)
        side = 1 if k == 0 else -1
        sleeve = f"{top.name}_sleeve_{word}" if o.top is not None else f"sleeve_{word}"
        if bare or short:
            body.add(
                lambda j=joints: bodies.limb(j, (5.2, 4.7, 4.2, 3.7, 3.9, 3.2, 2.6), 12),
                d.skin,
                "skin",
                f"arm_{word}",
            )
        if short and not bare:
            body.add(
                lambda j=joints: bodies.limb(bodies.between(j, 0, 0.3), (5.8, 5.9, 5.6, 5.5), 12),
                top.color,
                top.surface,
                sleeve,
            )
        elif not bare:
            body.add(
                lambda j=joints: bodies.limb(j, (5.6, 5.7, 5.2, 4.7, 4.7, 4.2, 3.8), 12),
                top.color,
                top.surface,
                sleeve,
            )
        glove = {
            "great_helm": Piece("hand", STEEL, "steel"),
            "space_helmet": Piece("hand", shade(top.color, 0.8)),
        }
        usual = next((v for m, v in glove.items() if m in marks), Piece("hand", d.skin, "skin"))
        worn = o.hands or usual
        body.add(
            lambda w=wrist, e=elbow, q=side: bodies.hand(w, e, q, grip),
            worn.color,
            worn.surface,
            f"{worn.name}_{word}",
        )
        if o.hands is not None:
            _gloved(body, joints, o.hands, word, padded=o.padded)
        body.limb(f"arm_{word}", joints, since)


def _gloved(body: _Drawer, joints: Any, glove: Piece, word: str, *, padded: bool) -> None:
    """The cuff of a glove, and the padding of a boxer's."""
    body.add(
        lambda: bodies.limb(bodies.between(joints, 0.88, 1.0), (4.6, 4.4, 4.0, 3.6), 12),
        shade(glove.color, 0.85),
        glove.surface,
        f"{glove.name}_cuff_{word}",
    )
    if padded:
        _, elbow, wrist = joints
        fist = wrist + 7.5 * (wrist - elbow) / max(float(((wrist - elbow) ** 2).sum()) ** 0.5, 1e-9)
        body.add(
            lambda: forms.cushion((15, 12.5, 15), tuple(fist), plan=2.2, side=0.9),
            glove.color,
            glove.surface,
            f"{glove.name}_{word}",
        )


def _head(flat: Sketch, marks: frozenset[str], d: Dress, style: str, hair: str) -> None:
    covered = marks & {"great_helm", "space_helmet"}
    bald = style == "none"
    name = hair if bald else "head"
    flat.add(lambda: forms.copied(bodies.head()), d.skin, of="skin", name=name)
    if covered:
        return
    flat.add(lambda: forms.copied(bodies.eyes()[0]), rgb(240, 238, 234), of="ceramic", name="eyes")
    flat.add(lambda: forms.copied(bodies.eyes()[1]), rgb(52, 36, 26), of="ceramic", name="irises")
    flat.add(lambda: forms.copied(bodies.mouth()), shade(d.skin, 0.66), of="skin", name="mouth")
    flat.add(lambda: forms.copied(bodies.brows()), shade(d.hair, 0.8), of="hair", name="brows")
    if "wig" not in marks and not bald:
        flat.add(lambda: forms.copied(bodies.hair(style)), d.hair, of="hair", name=hair)
    clothes.face_marks(flat, marks, d.hair)


def _varied(d: Dress, a: Appearance) -> Dress:
    """The dress on somebody else: another skin, another hair, other trousers if they are plain."""
    if a.seed is None:
        return d
    skin, hair = _FOLK[a.pick("folk", len(_FOLK))]
    young = d is DRESSES["child"] and hair == _GREY_HAIR
    hair = d.hair if young or d.hair in (ORANGE, _GREY_HAIR) else hair
    legs = d.legs
    if legs is _JEANS:
        legs = _TROUSERS[a.pick("legs", len(_TROUSERS))]
    elif legs in (d.skin, None):
        legs = skin if legs is not None else None
    shoes = skin if d.shoes == d.skin else d.shoes
    return replace(d, skin=skin, hair=hair, legs=legs, shoes=shoes)


def _hem(marks: frozenset[str]) -> float:
    """Share of the usual step that what is worn allows."""
    return 0.3 if "robe" in marks else 0.5 if marks & {"skirt", "coat"} else 1.0


def _in_hem(pose: Pose, marks: frozenset[str]) -> Pose:
    """The pose with steps as short as what is worn allows."""
    share = _hem(marks)
    stride = max(abs(leg.swing) for leg in pose.legs)
    if share == 1.0 or pose.gathers or stride < _STRIDE:
        return pose
    left, right = (
        replace(leg, swing=share * leg.swing, bend=share * leg.bend) for leg in pose.legs
    )
    return replace(pose, legs=(left, right))


def draw_person(
    s: Sketch, d: Dress, c: Color, pose: str, size: float = 1.0, head_size: float = 1.0
) -> None:
    """Draws somebody in a dress and a pose.

    Args:
        s: Receives the parts.
        d: What is worn.
        c: Of coat or dress.
        pose: A name of `POSES`, maybe with a gesture.
        size: Of the body against an adult of 172 cm.
        head_size: Of the head against that of such a body.
    """
    young = d is DRESSES["child"]
    d = _varied(d, s.appearance)
    o = outfit(s.appearance.wears, d.marks, d.skin, c)
    marks, c = frozenset(o.marks), o.color
    d = replace(d, hair=o.hair or d.hair)
    body = _Drawer(s, skeleton(_in_hem(pose_of(pose), marks | o.hems), head_size), size)
    seated = body.skeleton.pose.gathers
    _legs(body, marks, d, c, o)
    top = o.top or (Piece("chest", d.skin, "skin") if "bare" in marks else Piece("shirt", c))
    lower = o.legs.color if o.legs else d.legs or c
    hips = o.hips or Piece("hips", c if marks & {"skirt", "shorts_own"} else lower)
    tucked = bool(marks & {"belt", "shirt", "skirt", "shorts", "bare"})

    def trunk(flat: Sketch) -> None:
        flat.add(lambda: bodies.trunk(79, 101, 0.5), hips.color, of=hips.surface, name=hips.name)
        if top.surface == "skin":
            flat.add(lambda: bodies.trunk(98, 146), top.color, of="skin", name=top.name)
        elif tucked:
            flat.add(lambda: bodies.trunk(97, 145.4, 0.6), top.color, of=top.surface, name=top.name)
        else:
            flat.add(
                lambda: bodies.trunk(86, 145.4, 0.6, 0.9), top.color, of=top.surface, name=top.name
            )
        if top.surface != "skin" and not marks & {"ruff", "shirt", "space_helmet", "great_helm"}:
            loop = [
                (6.4 * math.cos(t) - 2.2, 6.6 * math.sin(t), 145.2 - 1.2 * math.cos(t))
                for t in (math.pi * k / 12 for k in range(24))
            ]
            flat.add(
                lambda: forms.tube(loop, 0.9, 8, closed=True),
                shade(top.color, 0.82),
                of="knit",
                name="collar",
            )
        clothes.coats(flat, marks, c, seated)
        clothes.trimmings(flat, marks, c)
        for draw in o.on_trunk:
            draw(flat, seated)

    since = len(s.parts)
    body.on(body.skeleton.trunk, trunk)
    body.limb("trunk", body.skeleton.spine, since)
    _arms(body, marks, d, top, o)
    style = o.style or (
        "long" if "long_hair" in marks else _CUTS[s.appearance.pick("cut", len(_CUTS))]
    )
    if (young or o.hair is not None) and style == "bald":
        style = "short"

    def head(flat: Sketch) -> None:
        _head(flat, marks, d, style, o.hair_name)
        clothes.hats(flat, marks, d.hat or c, c)
        for draw in o.on_head:
            draw(flat)

    since = len(s.parts)
    body.on(body.skeleton.head, head)
    body.limb("trunk", body.skeleton.spine, since)


def posed_by(pose: str, usual: str) -> str:
    """The name of a pose; one without a name, or a gesture without a pose, is the usual one."""
    return usual + pose if pose.startswith(MARK) else pose or usual


@builder("figure")
def figure(s: Sketch, L: float, W: float, H: float, c: Color, dress: str = "plain") -> None:
    """Person of 30 x 50 x 172, dressed as `DRESSES` say and posed as the appearance says."""
    d = DRESSES[dress]
    usual = "laden" if d.marks & {"pack", "big_pack"} else "stand"
    draw_person(s, d, c, posed_by(s.appearance.pose, usual))
    s.proxy_slab((-15, 15), (-20, 20), (0, 2), 4)
    s.proxy_slab((-9, 9), (-18, 18), (2, 86), 0.8)
    s.proxy_slab((-12, 12), (-25, 25), (86, 142), 0.9)
    s.proxy_cylinder(9, (142, 172), 0.8)
