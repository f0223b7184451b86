"""What a person wears beyond the dress of his kind, as his appearance states it.

An outfit says what takes the place of coat, trousers and shoes, and what is drawn besides; a person
of whom nothing is stated has an empty one. `FITS` has one function a kind of the table of garments.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from esg.assets.appearance import Wear
from esg.assets.builders.common import shade
from esg.assets.builders.living import bodies, clothes
from esg.assets.builders.living.headwear import (
    HEADWEAR,
    Piece,
    named,
    piece,
)
from esg.assets.geometry.sketch import DARK, Color, Sketch, rgb
from esg.assets.lazy import forms

_LIGHT, _BRIGHT = rgb(226, 226, 220), rgb(214, 232, 80)
_HATS = frozenset(
    {"hard_hat", "brim_helmet", "helmet", "sport_helmet", "peaked_cap", "cap", "toque", "wide_hat",
     "cone_hat", "crown", "great_helm", "space_helmet"}
)  # fmt: skip
_TOPS = frozenset(
    {"coat", "shirt", "tie", "tabard", "bib", "bare", "robe", "bands", "bands_thin", "chest_band",
     "buttons", "buttons_large", "apron", "badge", "ruff", "cape"}
)  # fmt: skip
_LOWER = frozenset({"skirt", "shorts", "shorts_own", "robe"})
_OWN_HATS = {
    "hat": (("toque", "chef hat"), ("cone_hat", "witch hat")),
    "helmet": (("hard_hat", "hard hat"), ("brim_helmet", "hard hat")),
}
"""What a hat is of those whose trade has one of its own, by the marks of their dress."""
_OF_A_TRADE = frozenset(
    {"peaked_cap", "helmet", "brim_helmet", "toque", "space_helmet", "chest_band", "coat", "bib"}
)
"""Marks of those who wear a uniform already."""
OnTrunk = Callable[[Sketch, bool], None]
OnHead = Callable[[Sketch], None]


@dataclass
class Outfit:
    """What takes the place of a dress, and what is drawn besides.

    Args:
        marks: Of the dress, without what gives way.
        skin: Of the body.
        color: Of the dress's coat.
        top: In place of the coat.
        sleeves: "long", "short" or "none"; "" as the dress has them.
        hips: In place of what covers the hips.
        legs: In place of trousers.
        shorts: Short trousers over bare legs.
        bare_legs: Whether legs show.
        socks, shoes, hands: In place of the usual ones.
        boot: How far up shoes reach beyond the ankle [cm]; None as the dress has it.
        barefoot: Whether nothing is on the feet.
        padded: Whether hands are in boxing gloves.
        hems: What of it hems the steps: robe, skirt, coat.
        hair: Its colour.
        style: Of the hair; "" as it comes.
        hair_name: How the drawn hair is called.
        on_trunk, on_head: What else is drawn.
    """

    marks: set[str]
    skin: Color
    color: Color
    top: Piece | None = None
    sleeves: str = ""
    hips: Piece | None = None
    legs: Piece | None = None
    shorts: Piece | None = None
    bare_legs: bool = False
    socks: Piece | None = None
    shoes: Piece | None = None
    hands: Piece | None = None
    boot: float | None = None
    barefoot: bool = False
    padded: bool = False
    hems: set[str] = field(default_factory=set[str])
    hair: Color | None = None
    style: str = ""
    hair_name: str = "hairdo"
    on_trunk: list[OnTrunk] = field(default_factory=list[OnTrunk])
    on_head: list[OnHead] = field(default_factory=list[OnHead])

    def over(self, name: str, draw: OnTrunk) -> None:
        """Something on the trunk whose parts are called by a name."""
        self.on_trunk.append(lambda s, seated: named(s, name, lambda q: draw(q, seated)))

    def dressed(self, top: Piece, sleeves: str) -> None:
        """A top in place of what the dress has; bare feet stay bare."""
        if "bare" in self.marks:
            self.barefoot = True
        self.marks -= _TOPS
        self.top, self.sleeves = top, sleeves

    def trousered(self, legs: Piece) -> None:
        """Trousers in place of what the dress has."""
        self.marks -= _LOWER
        self.legs, self.bare_legs, self.shorts = legs, False, None


def outfit(wears: Iterable[Wear], marks: frozenset[str], skin: Color, color: Color) -> Outfit:
    """What is worn over the dress of a kind.

    Args:
        wears: What is stated.
        marks: Of the dress.
        skin, color: Of the body and of its coat.
    """
    out = Outfit({*marks}, skin, color)
    for w in sorted(wears, key=lambda w: _ORDER.get(w.kind, 1)):
        fit = FITS.get(w.kind)
        if fit is not None:
            fit(out, w)
    return out


def _top(sleeves: str) -> Callable[[Outfit, Wear], None]:
    def fit(o: Outfit, w: Wear) -> None:
        o.dressed(piece(w), sleeves)
        _striped(o, w)

    return fit


def _striped(o: Outfit, w: Wear) -> None:
    if not w.striped:
        return
    p = piece(w)
    tone = _LIGHT if max(p.color) - min(p.color) > 0.2 or max(p.color) < 0.6 else rgb(34, 42, 68)

    def stripes(s: Sketch, _: bool) -> None:
        for z in range(100, 138, 8):
            clothes.band(s, z, z + 4, tone, p.surface, f"{p.name}_stripes", 0.9)

    o.on_trunk.append(stripes)


def _collared(o: Outfit, w: Wear) -> None:
    """A shirt: collar, placket and buttons."""
    p = piece(w)
    o.dressed(p, "long")
    _striped(o, w)

    def draw(s: Sketch, _: bool) -> None:
        tone = shade(p.color, 0.82)
        strip = [(-1.1, 100), (1.1, 100), (1.1, 143), (-1.1, 143)]
        clothes.front(s, strip, 98, 144, 1.0, tone, p.surface, "placket")
        for side in (-1, 1):
            tip = [(side * 0.6, 144), (side * 6.0, 144), (side * 5.6, 138.5)]
            clothes.front(s, tip, 136, 145, 1.5, shade(p.color, 0.9), p.surface, "collar")
        for z in (106, 114, 122, 130, 138):
            s.ball(0.55, (10.2 - 0.0016 * (z - 122) ** 2, 0, z), shade(p.color, 0.45), detail=2,
                   of="plastic_hard", name="button")  # fmt: skip

    o.over(p.name, draw)


def _knitted(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.dressed(p, "long")
    o.marks -= {"belt"}
    _striped(o, w)

    def draw(s: Sketch, _: bool) -> None:
        clothes.band(s, 86, 90, shade(p.color, 0.78), p.surface, "hem", 1.3)
        if w.kind == "hoodie":
            hood = [(-6.5, -9.0, 145.0), (-11.0, -5.0, 142.5), (-12.6, 0, 140.5),
                    (-11.0, 5.0, 142.5), (-6.5, 9.0, 145.0)]  # fmt: skip
            s.add(lambda: forms.tube(forms.smooth_path(hood, 14), 3.4, 12), p.color, of=p.surface,
                  name="hood")  # fmt: skip
            pouch = [(-9, 92), (9, 92), (9, 97), (6.4, 104), (-6.4, 104), (-9, 97)]
            clothes.front(s, pouch, 90, 106, 1.6, shade(p.color, 0.86), p.surface, "pouch")

    o.over(p.name, draw)


def _jacket(o: Outfit, w: Wear) -> None:
    """An open jacket over what else is worn."""
    p, inner = piece(w), o.top or Piece("shirt", _LIGHT)
    o.dressed(p, "long")
    o.marks -= {"belt"}

    def draw(s: Sketch, _: bool) -> None:
        strip = [(-3.4, 88), (3.4, 88), (4.6, 144), (-4.6, 144)]
        for side in (-1, 1):
            lapel = [(side * 3.8, 112), (side * 4.8, 144), (side * 8.4, 141), (side * 7.6, 132)]
            clothes.front(
                s, lapel, 108, 145, 1.7, shade(p.color, 0.84), p.surface, f"{p.name}_lapel"
            )
        clothes.band(s, 86.2, 89, shade(p.color, 0.84), p.surface, f"{p.name}_hem", 1.5)
        clothes.front(s, strip, 86, 144.5, 1.6, inner.color, inner.surface, inner.name)

    o.on_trunk.append(draw)


def _coat(low: float) -> Callable[[Outfit, Wear], None]:
    def fit(o: Outfit, w: Wear) -> None:
        p, inner = piece(w), o.top or Piece("shirt", _LIGHT)
        o.dressed(p, "long")
        o.marks -= {"belt"}
        o.hems.add("coat")

        def draw(s: Sketch, seated: bool) -> None:
            clothes.hang(s, 122, 84 if seated else low, (13.6, 19), p.color, p.name, p.surface)
            opening = [(-0.4, 112), (0.4, 112), (4.6, 144), (-4.6, 144)]
            clothes.front(s, opening, 108, 144.5, 1.6, inner.color, inner.surface, inner.name)
            for side in (-1, 1):
                lapel = [(side * 0.6, 112), (side * 4.8, 144), (side * 9.0, 141), (side * 8, 130)]
                clothes.front(s, lapel, 108, 145, 2.0, shade(p.color, 0.8), p.surface,
                              f"{p.name}_lapel")  # fmt: skip
            if w.kind == "raincoat":
                hood = [(-6.5, -9.0, 145.0), (-12.0, 0, 141), (-6.5, 9.0, 145.0)]
                s.add(lambda: forms.tube(forms.smooth_path(hood, 12), 3.4, 12), p.color,
                      of=p.surface, name=f"{p.name}_hood")  # fmt: skip

        o.on_trunk.append(draw)

    return fit


def _vest(o: Outfit, w: Wear) -> None:
    """A sleeveless jacket: with bright bands, buttoned, or padded."""
    p = piece(w)
    o.marks -= {"bands", "chest_band", "bands_thin", "tabard", "bib"}
    grow = 2.8 if w.kind == "life jacket" else 1.6
    if o.top is None and max(abs(a - b) for a, b in zip(o.color, p.color, strict=True)) < 0.28:
        o.top = Piece("shirt", rgb(104, 116, 130))  # else nobody would see it
    inner = o.top.color if o.top else o.color

    def draw(s: Sketch, _: bool) -> None:
        s.add(lambda: bodies.trunk(95, 141.5, grow), p.color, of=p.surface, name=p.name)
        if w.kind == "waistcoat":
            opening = [(-5.0, 144), (5.0, 144), (0.6, 118), (-0.6, 118)]
            clothes.front(s, opening, 116, 141.4, grow + 0.3, _LIGHT, "linen", "shirt_front")
            for z in (100, 106, 112):
                s.ball(0.7, (10.6, 0, z), shade(p.color, 0.4), of="plastic_hard", detail=2,
                       name="button")  # fmt: skip
            return
        seam = [(-0.7, 95), (0.7, 95), (0.7, 130), (3.6, 142), (-3.6, 142), (-0.7, 130)]
        tone = inner if max(abs(a - b) for a, b in zip(inner, p.color, strict=True)) > 0.2 else DARK
        clothes.front(s, seam, 94, 141.4, grow + 0.3, tone, "textile", "opening")
        tone = DARK if w.kind == "life jacket" else _BRIGHT
        for z in (103, 119):
            clothes.band(s, z, z + 4, tone, "paint", "band", grow + 0.4)

    o.over(p.name, draw)


def _cape(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.marks -= {"cape", "pack", "big_pack"}
    o.over(p.name, lambda s, seated: clothes.cape(s, p.color, seated))


def _apron(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.marks -= {"apron"}

    def draw(s: Sketch, seated: bool) -> None:
        clothes.apron(s, p.color, seated)
        bib = [(-8.5, 100), (8.5, 100), (7, 130), (-7, 130)]
        clothes.front(s, bib, 98, 132, 1.7, p.color, p.surface, "bib")
        for side in (-1, 1):
            strap = [(side * 5.6, 129), (side * 7, 129), (side * 6.4, 143), (side * 5, 143)]
            clothes.front(s, strap, 127, 144, 1.4, p.color, p.surface, "strap")

    o.over(p.name, draw)


def _gowned(low: float, half: tuple[float, float], sleeves: str) -> Callable[[Outfit, Wear], None]:
    """A dress that hangs from the waist to a hem."""

    def fit(o: Outfit, w: Wear) -> None:
        p = piece(w)
        o.dressed(p, sleeves)
        o.marks -= _LOWER | {"belt"}
        o.legs, o.bare_legs = None, True
        o.hips = p
        o.hems.add("robe" if low < 30 else "skirt")
        _striped(o, w)

        def draw(s: Sketch, seated: bool) -> None:
            hem, wide = (80 if seated else low), ((15.0, 20.0) if seated else half)
            clothes.hang(s, 106, hem, wide, p.color, f"{p.name}_skirt", p.surface)
            clothes.band(s, 104, 107, shade(p.color, 0.8), p.surface, f"{p.name}_waist", 1.4)

        o.on_trunk.append(draw)

    return fit


def _robe(o: Outfit, w: Wear) -> None:
    p = piece(w)
    beard = o.marks & {"beard"}
    o.dressed(p, "long")
    o.marks -= _LOWER
    o.marks |= beard | {"belt"}
    o.hips, o.legs = p, Piece(f"{p.name}_legs", p.color, p.surface)
    o.hems.add("robe")
    o.on_trunk.append(
        lambda s, seated: clothes.hang(s, 122, 78 if seated else 3, (14.6, 20), p.color,
                                       f"{p.name}_cloth", p.surface)
    )  # fmt: skip


def _suit(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.dressed(p, "long")
    o.trousered(Piece(f"{p.name}_trousers", p.color, p.surface))
    o.marks -= {"belt"} | _HATS
    o.barefoot, o.shoes = False, o.shoes or Piece("shoe", DARK, "leather")
    worn = {"shirt"} if w.kind == "tuxedo" else {"shirt", "tie"}
    o.over(p.name, lambda s, _: clothes.trimmings(s, frozenset(worn), p.color))
    if w.kind == "tuxedo":
        bow = Piece("bow_tie", DARK)
        o.over(p.name, lambda s, _: HEADWEAR["bow tie"](s, bow))


def _uniform(o: Outfit, w: Wear) -> None:
    """What one of his trade wears; of another, a belted jacket with cap, tie and badge."""
    p = piece(w)
    if o.marks & _OF_A_TRADE:
        tone = w.color or o.color
        o.top = Piece(p.name, tone)
        if w.color is not None:
            o.legs = Piece(f"{p.name}_trousers", shade(tone, 0.85))
            o.color = tone
        return
    o.dressed(p, "long")
    o.trousered(Piece(f"{p.name}_trousers", shade(p.color, 0.8), p.surface))
    o.barefoot, o.shoes = False, Piece("shoe", DARK, "leather")
    o.marks -= _HATS
    o.marks |= {"belt", "badge", "tie"}
    o.on_head.append(
        lambda s: named(s, p.name, lambda q: clothes.hats(q, frozenset({"peaked_cap"}), p.color,
                                                          p.color))
    )  # fmt: skip


def _overalls(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.trousered(Piece(p.name, p.color, p.surface))
    o.marks -= {"bib", "belt", "apron", "tabard"}
    o.over(p.name, lambda s, seated: clothes.coats(s, frozenset({"bib"}), p.color, seated))


def _one_piece(sleeves: str, *, barefoot: bool) -> Callable[[Outfit, Wear], None]:
    """Top and trousers of one colour."""

    def fit(o: Outfit, w: Wear) -> None:
        p = piece(w)
        o.dressed(p, sleeves)
        o.trousered(Piece(f"{p.name}_legs", p.color, p.surface))
        o.marks -= {"belt"}
        o.hips, o.barefoot = p, barefoot
        _striped(o, w)

        def zipped(s: Sketch, _: bool) -> None:
            seam = [(-0.5, 90), (0.5, 90), (0.5, 144), (-0.5, 144)]
            clothes.front(s, seam, 88, 144.5, 1.2, shade(p.color, 0.55), "textile", "zip")

        o.over(p.name, zipped)

    return fit


def _swimsuit(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.dressed(Piece("chest", o.skin, "skin"), "none")
    o.marks -= _LOWER | {"belt"}
    o.bare_legs, o.barefoot, o.legs = True, True, None
    low, high = (118.0, 128.0) if w.kind == "bikini" else (90.0, 128.5)
    o.hips = Piece(p.name, p.color, p.surface)

    def draw(s: Sketch, _: bool) -> None:
        clothes.band(s, low, high, p.color, p.surface, p.name, 0.9)
        for side in (-1, 1):
            strap = [(side * 6.4, 127), (side * 8.6, 127), (side * 8.0, 142), (side * 6.4, 142)]
            clothes.front(s, strap, 125, 143, 0.9, p.color, p.surface, f"{p.name}_strap")
        if w.striped:
            for z in range(96, 126, 8):
                clothes.band(s, z, z + 4, _LIGHT, p.surface, f"{p.name}_stripes", 1.1)

    o.on_trunk.append(draw)


def _trunks(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.dressed(Piece("chest", o.skin, "skin"), "none")
    o.marks -= _LOWER | {"belt"}
    o.bare_legs, o.barefoot, o.legs, o.hips, o.shorts = True, True, None, p, p


def _clothes(o: Outfit, w: Wear) -> None:
    """The dress as it is, in one colour."""
    p = piece(w)
    o.color = p.color
    o.top = Piece(p.name, p.color, p.surface)
    if not o.marks & {"skirt", "shorts", "shorts_own", "bare"}:
        o.legs = Piece(f"{p.name}_legs", shade(p.color, 0.9), p.surface)


def _skirt(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.marks -= _LOWER | {"belt"}
    o.legs, o.bare_legs, o.hips = None, True, p
    o.hems.add("skirt")
    o.on_trunk.append(
        lambda s, seated: clothes.hang(s, 104, 80 if seated else 52, (15, 20), p.color, p.name,
                                       p.surface)
    )  # fmt: skip


def _shorts(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.marks -= _LOWER
    o.legs, o.bare_legs, o.shorts, o.hips = None, True, p, p


def _trousers(o: Outfit, w: Wear) -> None:
    o.trousered(piece(w))


def _shoes(o: Outfit, w: Wear) -> None:
    o.shoes, o.barefoot = piece(w), False
    o.boot = {"boots": 15.0, "rain boots": 20.0}.get(w.kind, 0.0)


def _socks(o: Outfit, w: Wear) -> None:
    o.socks = piece(w)


def _gloves(o: Outfit, w: Wear) -> None:
    o.hands, o.padded = piece(w), w.kind == "boxing gloves"


def _backpack(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.marks -= {"pack", "big_pack"}

    def draw(s: Sketch, _: bool) -> None:
        s.add(lambda: forms.cushion((9, 25, 36), (-15.0, 0, 120), plan=5, side=0.35), p.color,
              of=p.surface, name="bag")  # fmt: skip
        s.add(lambda: forms.cushion((3.4, 18, 15), (-20.0, 0, 112), plan=5, side=0.35),
              shade(p.color, 0.8), of=p.surface, name="pocket")  # fmt: skip
        clothes.straps(s, shade(p.color, 0.7))

    o.over(p.name, draw)


def _belt(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.marks -= {"belt"}

    def draw(s: Sketch, _: bool) -> None:
        clothes.band(s, 96.0, 100.5, p.color, p.surface, p.name, 1.9)
        s.add(lambda: forms.cushion((1.4, 5.4, 4.6), (10.6, 0, 98.3), plan=5, side=0.3),
              rgb(214, 176, 60), of="brass", name=f"{p.name}_buckle")  # fmt: skip

    o.on_trunk.append(draw)


def _tie(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.marks -= {"tie"}
    o.over(p.name, lambda s, _: clothes.tie(s, p.color))


def _neck(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.over(p.name, lambda s, _: HEADWEAR[w.kind](s, p))
    if w.kind == "scarf":
        tail = [(2.4, 142), (8.0, 142), (8.6, 112), (3.0, 112)]
        grow = 2.6 if o.top is not None else 1.8
        o.over(p.name, lambda s, _: clothes.front(s, tail, 110, 143, grow, shade(p.color, 0.92),
                                                  p.surface, "end"))  # fmt: skip


def _headwear(o: Outfit, w: Wear) -> None:
    p = piece(w)
    draw = HEADWEAR[
        next((own for mark, own in _OWN_HATS.get(w.kind, ()) if mark in o.marks), w.kind)
    ]
    o.marks -= _HATS
    o.marks -= {"wig"} if w.kind in ("hood", "headscarf") else set()
    o.on_head.append(lambda s: named(s, p.name, lambda q: draw(q, p)))


def _face(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.marks -= {"goggles", "great_helm", "space_helmet"}
    o.on_head.append(lambda s: named(s, p.name, lambda q: HEADWEAR[w.kind](q, p)))


def _hair(style: str) -> Callable[[Outfit, Wear], None]:
    def fit(o: Outfit, w: Wear) -> None:
        o.marks -= {"wig"}
        if style:
            o.style = style
        o.hair_name = piece(w).name if o.hair_name == "hairdo" or style else o.hair_name
        o.hair = w.color or o.hair

    return fit


def _beard(o: Outfit, w: Wear) -> None:
    p = piece(w)
    o.marks -= {"beard"}
    o.on_head.append(
        lambda s: named(s, p.name, lambda q: clothes.face_marks(
            q, frozenset({w.kind}), w.color or o.hair or rgb(84, 56, 36)))
    )  # fmt: skip


def _bare_chest(o: Outfit, w: Wear) -> None:
    o.dressed(Piece(piece(w).name, o.skin, "skin"), "none")
    o.barefoot = False


def _bare_feet(o: Outfit, _: Wear) -> None:
    o.barefoot = True


FITS: dict[str, Callable[[Outfit, Wear], None]] = {
    "t-shirt": _top("short"),
    "tank top": _top("none"),
    "shirt": _collared,
    "sweater": _knitted,
    "hoodie": _knitted,
    "vest": _vest,
    "waistcoat": _vest,
    "life jacket": _vest,
    "jacket": _jacket,
    "coat": _coat(54),
    "lab coat": _coat(58),
    "raincoat": _coat(66),
    "cape": _cape,
    "apron": _apron,
    "dress": _gowned(48, (16, 20.5), "short"),
    "gown": _gowned(4, (25, 27), "none"),
    "robe": _robe,
    "suit": _suit,
    "tuxedo": _suit,
    "uniform": _uniform,
    "overalls": _overalls,
    "jumpsuit": _one_piece("long", barefoot=False),
    "wetsuit": _one_piece("long", barefoot=True),
    "leotard": _swimsuit,
    "swimsuit": _swimsuit,
    "bikini": _swimsuit,
    "swim trunks": _trunks,
    "clothes": _clothes,
    "skirt": _skirt,
    "shorts": _shorts,
    "trousers": _trousers,
    "jeans": _trousers,
    "leggings": _trousers,
    "boots": _shoes,
    "rain boots": _shoes,
    "shoes": _shoes,
    "socks": _socks,
    "gloves": _gloves,
    "boxing gloves": _gloves,
    "backpack": _backpack,
    "belt": _belt,
    "tie": _tie,
    **dict.fromkeys(("scarf", "bow tie", "bandana"), _neck),
    **dict.fromkeys(("glasses", "sunglasses", "goggles", "face mask"), _face),
    **dict.fromkeys(
        ("hat", "cowboy hat", "straw hat", "top hat", "cap", "beanie", "party hat", "santa hat",
         "witch hat", "chef hat", "beret", "turban", "headscarf", "headband", "crown", "helmet",
         "hard hat", "headphones", "hood"),
        _headwear,
    ),
    "hair": _hair(""),
    "short hair": _hair("short"),
    "long hair": _hair("flowing"),
    "ponytail": _hair("long"),
    "bun": _hair("bun"),
    "bald head": _hair("none"),
    "beard": _beard,
    "moustache": _beard,
    "bare chest": _bare_chest,
    "bare feet": _bare_feet,
}  # fmt: skip
"""How each kind of the table of garments is worn by a person."""
_ORDER = {
    **dict.fromkeys(("clothes", "uniform", "suit", "tuxedo", "dress", "gown", "robe", "jumpsuit",
                     "wetsuit", "leotard", "swimsuit", "bikini", "swim trunks", "hair",
                     "bare chest"), 0),
    **dict.fromkeys(("vest", "waistcoat", "life jacket", "jacket", "coat", "lab coat", "raincoat",
                     "overalls"), 2),
    **dict.fromkeys(("apron", "cape", "belt", "scarf", "tie", "bow tie", "bandana", "backpack",
                     "bare feet"), 3),
}  # fmt: skip
"""What goes below the rest (0) and what over it (2, 3)."""
