"""Standing figures: children, statues, snowmen, scarecrows, robots; all face +X."""

from __future__ import annotations

import math

from esg.assets.builders import builder
from esg.assets.builders.common import bone, shade, shift
from esg.assets.builders.living.people import DRESSES, draw_person, posed_by
from esg.assets.geometry.sketch import (
    CHROME,
    DARK,
    ORANGE,
    RED,
    RUBBER,
    STEEL,
    WOOD,
    Color,
    Sketch,
    rgb,
)


@builder("child_figure")
def child_figure(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Child, drawn 118 cm tall."""
    pose = posed_by(s.appearance.pose, "play")
    draw_person(s, DRESSES["child"], c, pose, 0.645, 1.32)
    s.proxy_slab((-13, 15), (-15, 15), (0, 1.5), 4)
    s.proxy_slab((-8, 12), (-12, 12), (1.5, 50), 0.8)
    s.proxy_slab((-10, 10), (-20, 20), (50, 94), 0.9)
    s.proxy_cylinder(10, (94, 118), 0.8)
    shift(s, -1)


@builder("snowman")
def snowman(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Three snowballs, a carrot, coal and a hat; 150 cm."""
    for z, r in ((37, 37), (86, 28), (120, 19)):
        s.ball(r, (0, 0, z), c, rough=0.95)
    s.lathe([(0, 0), (39, 0), (34, 7), (0, 8)], c, rough=0.95)
    bone(s, (17, 0, 120), 3, (34, 0, 118), 0.6, ORANGE)
    for side in (-1, 1):
        s.ball(2, (16.6, side * 6.4, 126), DARK, detail=2)
        s.rod(1.4, (0, side * 24, 92), (4, side * 56, 108), WOOD, sections=10)
        s.rod(0.9, (3, side * 46, 103), (10, side * 52, 114), WOOD, sections=8)
    for z in (72, 84, 96):
        s.ball(2.2, (27.6 - abs(z - 84) * 0.15, 0, z), DARK, detail=2)
    s.torus(15.5, 3.4, (0, 0, 106), RED)
    s.rod(20, (0, 0, 135), (0, 0, 137), DARK)
    s.rod(13, (0, 0, 137), (0, 0, 156), DARK)
    s.proxy_cylinder(36, (0, 62), 1.0)
    s.proxy_cylinder(26, (62, 106), 1.0)
    s.proxy_cylinder(17, (106, 156), 0.7)


@builder("robot")
def robot(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Wheeled service robot with a screen face and two arms, 100 cm."""
    s.rod(27, (0, 0, 8), (0, 0, 26), DARK)
    s.lathe([(0, 26), (24, 26), (20, 34), (15, 60), (17, 76), (0, 80)], c, smooth=40, rough=0.3)
    for side in (-1, 1):
        s.rod(10, (0, side * 22, 10), (0, side * 28, 10), RUBBER, sections=28)
        s.wheel((0, side * 25, 10), 10)
        s.rod(5, (side * 20, 0, 5), (side * 20, 0.01 + 4, 5), RUBBER, sections=20)
        bone(s, (0, side * 17, 70), 3.6, (8, side * 23, 50), 3, shade(c, 0.7))
        bone(s, (8, side * 23, 50), 3, (24, side * 21, 46), 2.6, shade(c, 0.7))
        s.ball(3.4, (26, side * 21, 46), DARK)
    s.rod(5, (0, 0, 78), (0, 0, 84), STEEL)
    s.slab((-11, 11), (-15, 15), (83, 102), c, rough=0.3)
    s.slab((10.6, 11.6), (-13, 13), (85, 100), DARK, of="glass_dark")
    for side in (-1, 1):
        s.rod(2.4, (11.4, side * 5.4, 94), (12.2, side * 5.4, 94), rgb(90, 210, 240), of="lamp")
    s.rod(0.7, (0, 8, 102), (0, 8, 110), STEEL, sections=8)
    s.ball(1.4, (0, 8, 110), RED, detail=2)
    s.proxy_cylinder(27, (0, 26), 2.0)
    s.proxy_cylinder(18, (26, 83), 0.8)
    s.proxy_slab((-11, 12), (-15, 15), (83, 102), 0.6)


@builder("robot_vacuum")
def robot_vacuum(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Round robot vacuum, 34 cm across."""
    s.lathe([(0, 0.8), (15.5, 0.8), (17, 2), (17, 7.4), (16, 8.4), (0, 8.6)], c, rough=0.35)
    s.lathe([(0, 8.5), (4.6, 8.5), (4.4, 9.6), (0, 9.7)], shade(c, 1.8), center=(-6, 0, 0))
    s.slab((4, 8), (-2, 2), (8.5, 8.9), CHROME)
    s.extrude(
        [
            (17.0 * math.cos(math.radians(a)), 17.0 * math.sin(math.radians(a)))
            for a in range(-80, 81, 10)
        ]
        + [
            (17.6 * math.cos(math.radians(a)), 17.6 * math.sin(math.radians(a)))
            for a in range(80, -81, -10)
        ],
        (2.4, 6.8),
        DARK,
        plane="xy",
    )
    for side in (-1, 1):
        s.rod(3, (0, side * 11, 3), (0, side * 13, 3), RUBBER, sections=20)
        s.wheel((0, side * 12, 3), 3)
    s.proxy_cylinder(17.2, (0, 8.6), 1.0)
    s.proxy_cylinder(4.5, (8.6, 9.7), 0.5, (-6, 0))


@builder("robot_arm")
def robot_arm(s: Sketch, L: float, W: float, H: float, c: Color) -> None:
    """Six-axis industrial arm on a base plate with a gripper, 110 cm."""
    s.slab((-26, 26), (-26, 26), (0, 4), DARK)
    s.rod(19, (0, 0, 4), (0, 0, 20), c)
    s.rod(15, (0, 0, 20), (0, 0, 34), shade(c, 0.8))
    s.rod(12, (0, -15, 40), (0, 15, 40), c)
    bone(s, (0, 0, 40), 10, (-8, 0, 96), 8, c)
    s.rod(9.5, (-8, -12, 98), (-8, 12, 98), shade(c, 0.8))
    bone(s, (-8, 0, 100), 7.4, (46, 0, 92), 5.4, c)
    s.rod(6, (46, -6.5, 92), (46, 6.5, 92), DARK)
    s.rod(4, (46, 0, 92), (46, 0, 78), STEEL)
    s.slab((42, 50), (-9, 9), (75, 79), DARK)
    for side in (-1, 1):
        s.slab((44, 48), (side * 8 - 1.2, side * 8 + 1.2), (62, 75), STEEL)
    s.proxy_slab((-26, 26), (-26, 26), (0, 4), 3.0)
    s.proxy_cylinder(18, (4, 36), 1.2)
    s.proxy_slab((-17, 10), (-12, 12), (36, 107), 0.6)
    s.proxy_slab((10, 52), (-8, 8), (86, 104), 0.4)
    s.proxy_slab((41, 51), (-9, 9), (62, 86), 0.3)
    shift(s, -13)
