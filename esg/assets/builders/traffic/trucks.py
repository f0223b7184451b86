"""Lorries that are told by what they carry: hoppers, tanks, drums, ladders, booms.

All have the cab and the frame of the box truck (`draw_lorry`). Proxies: the frame down to the
ground, the cab, and the body in one or two boxes; open bodies are hollow.
"""

from __future__ import annotations

import math
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import mirrored, shade, shift
from esg.assets.builders.traffic.coachwork import TRIM
from esg.assets.builders.traffic.lorries import SIDES, draw_lorry
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    GLASS,
    ORANGE,
    RED,
    RUBBER,
    STEEL,
    WHITE,
    YELLOW,
    Color,
    Sketch,
    finish,
    rgb,
)
from esg.assets.lazy import forms, shapes

Span = tuple[float, float]
ALUMINIUM = finish("aluminium")
AMBER, BLUE_LIGHT = finish("lamp", rgb(245, 150, 20)), finish("lamp", rgb(30, 80, 230))
TANDEM, SHORT_GUARD = (-170, -280), (-105, 180)


def _under(s: Sketch, rear: float = -380, density: float = 1.0) -> None:
    """Proxies of frame and cab."""
    s.proxy_slab((rear, 379), (-120, 120), (0, 96), density)
    s.proxy_slab((212, 379), (-120, 120), (96, 272), 0.35)


def _hopper(s: Sketch, c: Color, low: float = 112.0, high: float = 250.0) -> None:
    """Open tipping body with ribs, its floor rising to the rear, and a shield over the cab."""
    side = [(204, low), (204, high), (-378, high - 22), (-378, low + 45), (-310, low)]

    def walls() -> Any:
        return forms.gather(
            [shapes.extrude(side, mirrored(sign, 112, 118), "xz") for sign in (-1, 1)]
        )

    s.add(walls, c, of="sheet_painted", name="hopper_sides")
    s.slab((-312, 204), (-114, 114), (low - 6, low + 2), shade(c, 0.8), of="steel", name="floor")

    def tail() -> Any:
        points = [(-312, low - 6), (-312, low + 2), (-378, low + 39), (-378, low + 47)]
        return shapes.hull([(x, y, z) for x, z in points for y in (-114, 114)])

    s.add(tail, shade(c, 0.8), of="steel", name="floor_tail")
    s.slab((-382, -376), (-116, 116), (low + 43, high - 20), c, of="steel", name="tailgate")
    s.slab((198, 206), (-118, 118), (low - 6, 292), c, of="steel", name="headboard")
    s.slab((200, 345), (-112, 112), (286, 294), c, of="steel", name="cab_shield")
    s.slab((339, 346), (-112, 112), (286, 304), c, of="steel", name="shield_lip")

    def ribs() -> Any:
        bars = []
        for sign in (-1, 1):
            for k in range(8):
                x = 180 - 72 * k
                foot = low + max(0.0, (-310 - x) * 0.66)
                top = high - 22 * (204 - x) / 582
                bars.append(shapes.box((11, 7, top - foot), (x, sign * 121, (top + foot) / 2)))
            rail = [(204, high - 9), (204, high + 2), (-380, high - 20), (-380, high - 31)]
            bars.append(shapes.extrude(rail, mirrored(sign, 112, 125), "xz"))
        bars += [shapes.box((6, 8, 90), (-384, y, low + 82)) for y in (-80, 0, 80)]
        return forms.gather(bars)

    s.add(ribs, shade(c, 0.82), of="steel", name="ribs")
    s.add(lambda: shapes.rod(9, (120, 0, 74), (160, 0, low - 2), 16), CHROME, name="hydraulic_ram")


def _hopper_proxies(s: Sketch, low: float = 114.0, high: float = 250.0) -> None:
    s.proxy_slab((-312, 206), (-118, 118), (96, low), 0.3)
    s.proxy_hull(
        [
            (x, y, z)
            for x, z in ((-312, low - 8), (-312, low), (-380, low + 35), (-380, low + 43))
            for y in (-118, 118)
        ],
        0.3,
    )
    for sign in (-1, 1):
        s.proxy_slab((-376, 206), mirrored(sign, 112, 120), (low, high - 10), 0.3)
    s.proxy_slab((-384, -376), (-112, 112), (low + 40, high - 20), 0.3)
    s.proxy_slab((198, 206), (-112, 112), (low, 292), 0.3)
    s.surface("bed", low, (235, 105), (-55, 0))
    s.region("inside", (-370, 198), (-110, 110), (low, high))


@builder("dump_truck")
def dump_truck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Three-axle tipper with an open body, drawn at 768 x 254 x 304."""
    draw_lorry(s, c, lambda s: _hopper(s, c), TANDEM, SHORT_GUARD)
    _under(s)
    _hopper_proxies(s)
    shift(s, 4)


@builder("snow_plough")
def snow_plough(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Gritting lorry with a blade in front, drawn at 853 x 300 x 318."""

    def load(s: Sketch) -> None:
        _hopper(s, c)
        s.slab((-370, 196), (-110, 110), (150, 224), rgb(226, 222, 214), of="gravel", name="grit")

    draw_lorry(s, c, load, TANDEM, SHORT_GUARD)

    def blade() -> Any:
        arc = [(30 - 34 * math.sin(a), 52 - 50 * math.cos(a)) for a in _turns(0.0, 2.4, 9)]
        inner = [(x + 4 if k else x + 5, z) for k, (x, z) in enumerate(arc)]
        ring = [(410 + x, z) for x, z in [*arc, *inner[::-1]]]
        return shapes.extrude(ring, (-150, 150), "xz")

    s.add(blade, finish("paint", rgb(232, 150, 20)), name="blade")
    for y in (-110, -37, 37, 110):
        s.slab((402, 407), (y - 4, y + 4), (14, 92), DARK, name="blade_rib")
    for y in (-45, 45):
        s.rod(6, (370, y, 48), (408, y, 48), DARK, sections=12, name="blade_arm")
    s.add(
        lambda: forms.cushion((30, 60, 14), (330, 0, 304), sections=20, levels=7),
        AMBER,
        name="beacon",
    )
    _under(s)
    s.proxy_slab((206, 345), (-112, 112), (286, 296), 0.1)
    s.proxy_slab((-380, 206), (-122, 122), (96, 240), 0.4)
    s.proxy_slab((379, 420), (-60, 60), (30, 70), 0.4)
    s.proxy_slab((404, 440), (-150, 150), (0, 100), 0.6)
    s.surface("load", 240, (220, 100), (-90, 0))
    shift(s, -29)


def _turns(start: float, end: float, n: int) -> list[float]:
    return [start + (end - start) * k / (n - 1) for k in range(n)]


def _ladder(s: Sketch, x: Span, z: Span, rungs: int) -> None:
    """Ladder lying on a roof along X, rising from `z[0]` to `z[1]`."""

    def mesh() -> Any:
        rails = [shapes.rod(4.5, (x[0], y, z[0]), (x[1], y, z[1]), 10) for y in (-34, 34, -24, 24)]
        steps = []
        for k in range(rungs):
            t = (k + 0.5) / rungs
            at, up = x[0] + t * (x[1] - x[0]), z[0] + t * (z[1] - z[0])
            steps.append(shapes.rod(2.6, (at, -34, up), (at, 34, up), 8))
        return forms.gather([*rails, *steps])

    s.add(mesh, ALUMINIUM, name="ladder")


def _fire_body(s: Sketch, c: Color) -> None:
    s.add(
        lambda: forms.cushion(
            (583, 240, 190), (-87.5, 0, 188), plan=60, side=0.05, sections=20, levels=7
        ),
        c,
        of="car_body",
        name="body",
    )
    for sign, word in SIDES:
        s.slab((128, 196), mirrored(sign, 119.6, 120.8), (176, 250), GLASS, name=f"crew_{word}")
        s.slab((-376, 202), mirrored(sign, 119.7, 121), (132, 148), WHITE, name=f"stripe_{word}")
        s.slab((-376, 202), mirrored(sign, 119.7, 121), (122, 131), YELLOW, name=f"band_{word}")
        for k in range(3):
            x = 96 - 158 * k
            s.slab(
                (x - 146, x),
                mirrored(sign, 119.4, 121.2),
                (154, 262),
                ALUMINIUM,
                name=f"shutter_{k}_{word}",
            )

            def slats(x: float = x, sign: int = sign) -> Any:
                return forms.gather(
                    [
                        shapes.box((146, 1.6, 1.4), (x - 73, sign * 121, 164 + 11 * j))
                        for j in range(9)
                    ]
                )

            s.add(slats, shade(ALUMINIUM, 0.6), name=f"slats_{k}_{word}")
    s.slab((-380, -377), (-80, 80), (150, 262), ALUMINIUM, name="rear_shutter")
    s.slab((-381, -377), (-116, 116), (112, 142), YELLOW, name="rear_band")
    s.torus(26, 7, (120, 0, 296), RED, axis="y")
    _ladder(s, (-372, 360), (292, 316), 22)
    for x in (-340, -60, 190):
        s.slab((x - 5, x + 5), (-40, 40), (282, 290 + 24 * (x + 372) / 732), DARK, name="rack")
    s.add(
        lambda: forms.gather(
            [forms.cushion((26, 62, 15), (340, y, 281), sections=20, levels=7) for y in (-62, 62)]
        ),
        BLUE_LIGHT,
        name="blue_lights",
    )
    s.slab((330, 350), (-30, 30), (273, 285), WHITE, name="light_bar")
    s.slab((378.2, 379.4), (-100, 100), (150, 166), WHITE, name="front_stripe")


@builder("fire_truck")
def fire_truck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Fire engine with lockers, blue lights and a ladder on its roof, drawn at 761 x 254 x 323."""
    draw_lorry(s, c, lambda s: _fire_body(s, c))
    _under(s)
    s.proxy_slab((-380, 205), (-120, 120), (96, 283), 0.4)
    s.proxy_slab((-376, 360), (-38, 38), (283, 320), 0.05)
    s.surface("roof", 320, (300, 30), (-8, 0))


def _refuse_body(s: Sketch, c: Color) -> None:
    s.add(
        lambda: forms.cushion(
            (420, 246, 226), (-6, 0, 206), plan=40, side=0.16, sections=24, levels=9
        ),
        c,
        of="car_body",
        name="refuse_body",
    )
    for sign, word in SIDES:
        s.add(
            lambda sign=sign: forms.gather(
                [shapes.box((8, 6, 190), (180 - 62 * k, sign * 123, 200)) for k in range(7)]
            ),
            shade(c, 0.75),
            of="steel",
            name=f"ribs_{word}",
        )

    def tail() -> Any:
        outline = [(-214, 316), (-296, 316), (-366, 226), (-372, 96), (-330, 66), (-214, 84)]
        mouth = [(-318, 232), (-420, 232), (-420, 118), (-340, 118)]
        return forms.carved(
            shapes.extrude(outline, (-122, 122), "xz"),
            [shapes.extrude(mouth, (-104, 104), "xz")],
        )

    s.add(tail, shade(c, 0.85), of="car_body", name="loader")
    s.slab((-342, -338), (-103, 103), (118, 230), DARK, name="mouth")
    for sign, word in SIDES:
        s.rod(6, (-250, sign * 126, 300), (-352, sign * 126, 190), CHROME, name=f"ram_{word}")
        s.slab((-376, -366), mirrored(sign, 104, 122), (110, 226), YELLOW, name=f"edge_{word}")


def _hung_bin(s: Sketch) -> None:
    """A wheelie bin on the lift behind a refuse lorry."""
    body = finish("plastic", rgb(40, 90, 170))
    low, high = (-424, -384), (-434, -378)
    points = [(x, y, 74) for x in low for y in (-22, 22)]
    points += [(x, y, 168) for x in high for y in (-29, 29)]
    s.add(lambda: shapes.hull(points), body, name="bin")
    s.slab((-437, -376), (-31, 31), (168, 174), shade(body, 0.7), name="bin_lid")
    for y in (-26, 26):
        s.rod(9, (-392, y - 3, 70), (-392, y + 3, 70), RUBBER, name="bin_wheel")
    s.slab((-380, -368), (-40, 40), (150, 160), DARK, name="lift")
    s.proxy_slab((-436, -378), (-28, 28), (64, 172), 0.1)


@builder("garbage_truck")
def garbage_truck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Refuse lorry that is loaded from the rear, a bin on its lift, drawn at 816 x 258 x 322."""

    def load(s: Sketch) -> None:
        _refuse_body(s, c)
        _hung_bin(s)

    draw_lorry(s, WHITE if c[1] > 0.9 else c, load, (-200,), (-105, 180))
    _under(s, -372)
    s.proxy_slab((-372, 205), (-122, 122), (96, 226), 0.35)
    s.proxy_slab((-296, 205), (-122, 122), (226, 318), 0.35)
    s.surface("roof", 318, (230, 100), (-40, 0))
    shift(s, 29)


def _tank(s: Sketch, c: Color) -> None:
    tank = finish("chrome", rgb(206, 210, 214))
    profile = [(0, -376), (60, -373), (88, -364), (98, -346), (100, -330)]
    profile += [(q, -172 - x) for q, x in profile[::-1]]
    s.add(lambda: forms.turned(profile, (0, 0, 206), 40, "x"), tank, of="steel", name="tank")

    def bands() -> Any:
        return forms.gather(
            [
                forms.turned(
                    [(99, x - 4), (102.5, x - 4), (102.5, x + 4), (99, x + 4), (99, x - 4)],
                    (0, 0, 206),
                    40,
                    "x",
                )
                for x in (-330, -209, -88, 33, 158)
            ]
        )

    s.add(bands, shade(STEEL, 0.7), name="bands")

    def stripe() -> Any:
        skin = forms.turned(
            [(0, -328), (101.2, -328), (101.2, 156), (0, 156)], (0, 0, 206), 40, "x"
        )
        return forms.inlay(skin, [shapes.box((600, 260, 34), (-86, 0, 206))])

    s.add(stripe, c, of="paint", name="stripe")
    s.slab((-330, 158), (-26, 26), (304, 309), DARK, name="walkway")
    for x in (-270, -148, -28, 96):
        s.rod(19, (x, 0, 306), (x, 0, 318), STEEL, sections=20, name="hatch")
        s.rod(21, (x, 0, 317), (x, 0, 320), shade(STEEL, 0.7), sections=20, name="hatch_lid")
    for x in (-290, -88, 120):
        points = [(-84, 90), (84, 90), (72, 140), (-72, 140)]
        s.extrude(points, (x - 8, x + 8), TRIM, plane="yz", name="saddle")
    for y in (-22, 22):
        s.rod(2.2, (-381, y, 84), (-381, y, 300), STEEL, sections=10, name="ladder_rail")
        s.rod(2.2, (-381, y, 300), (-330, y, 312), STEEL, sections=10, name="ladder_top")
    for k in range(8):
        z = 100 + 26 * k
        s.rod(1.6, (-381, -22, z), (-381, 22, z), STEEL, sections=8, name="ladder_rung")
    for sign, word in SIDES:
        s.slab((-60, -20), mirrored(sign, 112, 114), (78, 104), ORANGE, name=f"placard_{word}")
        s.rod(7, (-150, sign * 104, 70), (20, sign * 104, 70), DARK, name=f"hose_{word}")


@builder("tanker_truck")
def tanker_truck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Tank lorry, drawn at 762 x 250 x 320."""
    draw_lorry(s, c, lambda s: _tank(s, c), TANDEM, SHORT_GUARD)
    _under(s)
    points = [
        (x, 100 * math.cos(a), 206 + 100 * math.sin(a))
        for x in (-360, 190)
        for a in _turns(0.0, 2 * math.pi * 15 / 16, 16)
    ]
    s.proxy_hull(points, 0.5)
    s.proxy_slab((-330, 158), (-60, 60), (96, 130), 0.2)


DRUM = ((0, -232), (44, -232), (50, -222), (60, -190), (116, -40), (120, 40), (74, 190), (0, 196))
DRUM_AT, DRUM_TILT = (-62.0, 0.0, 214.0), math.radians(13)


def _tilted(mesh: Any) -> Any:
    """A mesh about the origin turned so that its rear rises, and moved to the drum's place."""
    c, n = math.cos(DRUM_TILT), math.sin(DRUM_TILT)
    x, y, z = DRUM_AT
    mesh.apply_transform([[c, 0, n, x], [0, 1, 0, y], [-n, 0, c, z], [0, 0, 0, 1]])
    return mesh


def _drum(s: Sketch, c: Color) -> None:
    white = finish("paint", rgb(232, 232, 228))
    s.add(lambda: _tilted(forms.turned(DRUM, (0, 0, 0), 40, "x")), white, name="drum")

    def spiral(phase: float) -> Any:
        radius = forms.profile([(x, q) for q, x in DRUM[2:-1]])
        path = []
        for k in range(61):
            x = -215 + 395 * k / 60
            a, q = phase + 2 * math.pi * 1.6 * k / 60, float(radius(x)) - 1
            path.append((x, q * math.cos(a), q * math.sin(a)))
        return _tilted(forms.tube(path, 7.5, 8))

    for k in range(2):
        s.add(lambda k=k: spiral(math.pi * k), c, of="paint", name=f"spiral_{k}")
    s.add(
        lambda: _tilted(
            forms.turned(
                [(60, 118), (104, 118), (104, 132), (60, 132), (60, 118)], (0, 0, 0), 40, "x"
            )
        ),
        STEEL,
        name="drum_ring",
    )
    s.slab((150, 192), (-70, 70), (90, 190), c, of="car_body", name="drum_drive")
    s.slab((160, 200), (-112, 112), (190, 232), STEEL, of="aluminium", name="water_tank")
    for sign in (-1, 1):
        points = [(-300, 90), (-262, 90), (-272, 216), (-290, 216)]
        s.extrude(points, mirrored(sign, 50, 62), TRIM, name="stand")
        s.rod(4, (-372, sign * 52, 90), (-296, sign * 52, 230), TRIM, name="stay")
    s.slab((-296, -276), (-62, 62), (190, 214), TRIM, name="cradle")

    def funnel() -> Any:
        low = [(x, y, 272) for x in (-318, -292) for y in (-26, 26)]
        high = [(x, y, 340) for x in (-372, -282) for y in (-56, 56)]
        return shapes.hull([*low, *high])

    s.add(funnel, c, of="steel", name="funnel")
    chute = [(-318, 190), (-308, 182), (-396, 112), (-402, 122)]
    s.extrude(chute, (-26, 26), STEEL, name="chute")
    for sign in (-1, 1):
        side = [(-318, 190), (-314, 206), (-402, 134), (-402, 122)]
        s.extrude(side, mirrored(sign, 22, 28), shade(STEEL, 0.8), name="chute_side")


@builder("concrete_mixer")
def concrete_mixer(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Lorry with a tilted drum, a funnel and a chute, drawn at 782 x 250 x 372."""
    draw_lorry(s, c, lambda s: _drum(s, c), TANDEM, SHORT_GUARD)
    _under(s)
    cos, sin = math.cos(DRUM_TILT), math.sin(DRUM_TILT)
    points = []
    for q, x in DRUM[1:-1]:
        for a in _turns(0.0, 2 * math.pi * 11 / 12, 12):
            y, z = q * math.cos(a), q * math.sin(a)
            points.append((DRUM_AT[0] + cos * x + sin * z, y, DRUM_AT[2] - sin * x + cos * z))
    s.proxy_hull(points, 0.5)
    s.proxy_slab((-372, -282), (-50, 50), (280, 340), 0.1)
    s.proxy_slab((150, 200), (-110, 110), (96, 230), 0.3)
    s.proxy_slab((-380, -280), (-50, 50), (96, 180), 0.2)
    shift(s, 11)


def _deck(s: Sketch, rear: float = -378) -> None:
    s.slab((rear, 205), (-122, 122), (90, 102), TRIM, of="steel", name="deck_frame")
    s.add(
        lambda: forms.gather(
            [
                shapes.box((205 - rear, 21.5, 6), ((205 + rear) / 2, -111 + 22.2 * k, 105))
                for k in range(11)
            ]
        ),
        finish("pine", rgb(176, 134, 84)),
        name="deck_planks",
    )
    for sign, word in SIDES:
        s.slab((rear, 205), mirrored(sign, 121, 125), (88, 108), RED, name=f"rail_{word}")


def _headboard(s: Sketch) -> None:
    for y in (-120, -40, 40, 120):
        s.slab((197, 205), (y - 4, y + 4), (108, 230), TRIM, name="headboard_post")
    for k in range(5):
        z = 122 + 25 * k
        s.slab((198, 204), (-122, 122), (z - 5, z + 5), TRIM, name="headboard_bar")


@builder("flatbed_truck")
def flatbed_truck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Lorry with a flat wooden deck and nothing on it, drawn at 758 x 264 x 273."""

    def load(s: Sketch) -> None:
        _deck(s)
        _headboard(s)

    draw_lorry(s, c, load, TANDEM, SHORT_GUARD)
    _under(s)
    s.proxy_slab((-378, 205), (-125, 125), (96, 108), 0.6)
    s.proxy_slab((197, 205), (-122, 122), (108, 232), 0.1)
    s.surface("bed", 108, (285, 120), (-90, 0))


def _wrecker(s: Sketch, c: Color) -> None:
    s.slab((-330, 205), (-118, 118), (90, 104), c, of="car_body", name="deck")
    for sign, word in SIDES:
        s.slab(
            (-20, 200), mirrored(sign, 62, 120), (104, 168), c, of="car_body", name=f"locker_{word}"
        )
        s.slab((-15, 195), mirrored(sign, 119.5, 121), (112, 160), ALUMINIUM, name=f"door_{word}")
        for k in range(6):
            x = 180 - 36 * k
            s.slab(
                (x - 9, x + 9),
                mirrored(sign, 119, 120.8),
                (92, 103),
                YELLOW if k % 2 else DARK,
                name=f"mark_{word}",
            )
    s.slab((70, 150), (-40, 40), (104, 190), TRIM, of="steel", name="winch_tower")
    s.rod(20, (96, -50, 176), (96, 50, 176), STEEL, name="winch")
    for y in (-32, 32):
        s.rod(10, (110, y, 180), (-356, y * 0.45, 306), c, sections=14, of="car_body", name="boom")
        s.rod(6, (60, y, 110), (-160, y * 0.7, 250), CHROME, sections=12, name="ram")
    for t in (0.25, 0.5, 0.75):
        x, z, y = 110 - 466 * t, 180 + 126 * t, 32 * (1 - 0.55 * t)
        s.rod(6, (x, -y, z), (x, y, z), c, sections=10, of="car_body", name="brace")
    s.rod(16, (-358, -9, 306), (-358, 9, 306), DARK, sections=24, name="pulley")
    s.rod(1.8, (-373, 0, 304), (-373, 0, 196), STEEL, sections=8, name="cable")
    hook = [(0, 18), (0, 2), (-9, -9), (-2, -20), (9, -16), (11, -6)]
    s.add(
        lambda: forms.tube([(-373 + x, 0, 180 + z) for x, z in hook], 4.2, 10),
        YELLOW,
        name="hook",
    )
    s.rod(9, (-300, 0, 82), (-420, 0, 46), DARK, sections=14, name="wheel_lift")
    s.rod(8, (-420, -82, 46), (-420, 82, 46), DARK, sections=14, name="crossbar")
    for y in (-80, 80):
        s.rod(6, (-420, y, 46), (-462, y, 40), DARK, sections=12, name="fork")
    s.add(
        lambda: forms.cushion((28, 150, 15), (320, 0, 281), plan=8, sections=24, levels=7),
        AMBER,
        name="light_bar",
    )


@builder("tow_truck")
def tow_truck(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Recovery lorry with a boom, a hook and a wheel lift, drawn at 847 x 250 x 322."""
    draw_lorry(s, c, lambda s: _wrecker(s, c), (-215,), (-110, 180))
    _under(s)
    s.proxy_slab((-20, 205), (-120, 120), (96, 168), 0.4)
    s.proxy_slab((-330, -20), (-118, 118), (96, 104), 0.6)
    s.proxy_hull(
        [
            (x, y, z)
            for x, z in ((120, 110), (60, 104), (110, 190), (-366, 318), (-366, 296))
            for y in (-22, 22)
        ],
        0.15,
    )
    s.proxy_slab((-460, -380), (-84, 84), (36, 56), 0.3)
    s.surface("deck", 104, (60, 100), (-260, 0))
    shift(s, 41)
