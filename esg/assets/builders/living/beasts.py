"""Proportions of the four-legged animals that `animals` draws."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Beast:
    """Proportions of a four-legged animal [cm].

    Args:
        legs: x of rear and front legs, half their distance across, radius at the trunk and foot.
        trunk: Height of its axis at the rear and at the front, radius rear and front.
        neck: x and z of the head's middle, radius of the neck at the trunk and at the head.
        head: Radius, then reach, drop and radius of the muzzle.
        ears: Kind (point, flop, round, long) and length.
        tail: Length, droop (1 = straight down, 0 = level, -1 = up), thickness at root and tip.
        move: Offset that centres the drawing on the origin.
        marks: What else is drawn.
        waist: Share by which the belly is drawn in before the haunches.
        bare: Skin instead of fur.
    """

    legs: tuple[float, float, float, float, float]
    trunk: tuple[float, float, float, float]
    neck: tuple[float, float, float, float]
    head: tuple[float, float, float, float]
    ears: tuple[str, float]
    tail: tuple[float, float, float, float]
    move: float = 0.0
    marks: frozenset[str] = frozenset()
    waist: float = 0.04
    bare: bool = False


Gait = dict[str, tuple[float, float]]

GAITS: dict[str, Gait] = {
    "walk": {
        "rear_right": (18.0, 0.0),
        "rear_left": (-20.0, 0.0),
        "front_right": (-16.0, 0.0),
        "front_left": (20.0, -34.0),
    },
    "run": {
        "rear_right": (-38.0, 0.0),
        "rear_left": (-24.0, 0.0),
        "front_right": (30.0, 0.0),
        "front_left": (46.0, -58.0),
    },
}
"""How each leg is held: its swing about hip or shoulder, forwards, and the lower half's own [deg].

A walk with one leg in the air (Muybridge, Animals in Motion, 1899), and a gallop at full stretch. A
leg that is not bent reaches the ground.
"""


def _kind(*values: object, marks: str = "", waist: float = 0.04, bare: bool = False) -> Beast:
    return Beast(*values, marks=frozenset(marks.split()), waist=waist, bare=bare)  # type: ignore[arg-type]


BEASTS: dict[str, Beast] = {
    "dog": _kind(
        (-26, 22, 8, 5.5, 3),
        (43, 44, 9.5, 11.5),
        (38, 62, 8, 6.5),
        (8.6, 12, -3, 4.6),
        ("flop", 11),
        (30, -0.5, 3, 1.2),
        -1.6,
        marks="collar",
        waist=0.24,
    ),
    "cat": _kind(
        (-13, 12, 4.4, 3.1, 1.7),
        (18, 18.5, 5.4, 5.6),
        (21, 25, 4, 4.2),
        (5.4, 4, -1.2, 2.6),
        ("point", 5),
        (26, -0.8, 1.7, 1.1),
        -1.1,
        marks="whiskers",
        waist=0.1,
    ),
    "horse": _kind(
        (-62, 56, 18, 15, 6.5),
        (112, 114, 26, 27),
        (96, 172, 25, 13),
        (13.5, 36, -20, 9),
        ("point", 13),
        (62, 0.95, 7, 9),
        -16,
        marks="mane hooves forelock",
        waist=0.08,
    ),
    "zebra": _kind(
        (-56, 50, 17, 13, 6),
        (98, 100, 24, 25),
        (88, 148, 23, 12),
        (12.5, 32, -18, 8),
        ("point", 15),
        (50, 0.95, 5, 7),
        -15,
        marks="mane hooves stripes",
        waist=0.08,
    ),
    "cow": _kind(
        (-66, 60, 21, 14, 7),
        (96, 97, 32, 33),
        (104, 124, 26, 18),
        (17, 27, -15, 11),
        ("flop", 16),
        (64, 0.97, 5, 4),
        -21.7,
        marks="horns hooves patches udder",
    ),
    "sheep": _kind(
        (-30, 27, 12, 6, 3.2),
        (52, 53, 20, 21),
        (50, 72, 12, 8),
        (8.6, 13, -6, 5.4),
        ("flop", 10),
        (12, 0.6, 5, 4),
        -5,
        marks="wool",
    ),
    "pig": _kind(
        (-36, 34, 13, 9, 5),
        (42, 42, 23, 24),
        (66, 48, 20, 15),
        (15, 16, -4, 7),
        ("point", 13),
        (13, -0.3, 2, 1),
        -11,
        marks="snout",
        bare=True,
    ),
    "deer": _kind(
        (-42, 38, 11, 9, 3.2),
        (88, 90, 16, 18),
        (62, 126, 12, 7.5),
        (9, 17, -6, 4.6),
        ("point", 14),
        (13, 0.4, 5, 3),
        -8,
        marks="antlers",
        waist=0.16,
    ),
    "elephant": _kind(
        (-105, 92, 48, 40, 30),
        (178, 190, 84, 88),
        (190, 232, 70, 56),
        (56, 34, -30, 26),
        ("fan", 86),
        (110, 0.97, 8, 4),
        -47.8,
        marks="trunk",
        bare=True,
    ),
    "rabbit": _kind(
        (-9, 9, 4.6, 4.4, 2),
        (11, 11, 8, 6),
        (13, 19.5, 4.6, 4.4),
        (4.8, 3.4, -1, 2.8),
        ("long", 8),
        (2, 0, 3, 3),
        1,
        waist=0.0,
    ),
    "bear": _kind(
        (-58, 52, 24, 20, 13),
        (72, 76, 36, 36),
        (92, 92, 28, 22),
        (22, 20, -6, 10),
        ("round", 8),
        (8, 0.2, 6, 5),
        -13,
    ),
    "fox": _kind(
        (-22, 20, 6, 4, 2),
        (32, 32, 7, 8),
        (33, 42, 6, 5),
        (6.6, 12, -3.5, 2.2),
        ("point", 9),
        (36, 0.25, 4, 6.5),
        9,
        marks="socks tip",
        waist=0.2,
    ),
    "wolf": _kind(
        (-32, 28, 8, 5.5, 3),
        (52, 53, 11, 13),
        (46, 66, 10, 8),
        (9.6, 15, -5, 4),
        ("point", 10),
        (42, 0.7, 4, 4.5),
        -4,
        waist=0.22,
    ),
    "lion": _kind(
        (-66, 58, 18, 13, 8),
        (72, 74, 20, 24),
        (92, 92, 18, 15),
        (16, 18, -6, 9),
        ("round", 6),
        (80, 0.75, 4, 3),
        -6,
        marks="ruff tuft",
        waist=0.2,
    ),
    "tiger": _kind(
        (-66, 58, 18, 13, 8),
        (70, 72, 20, 23),
        (92, 86, 17, 14),
        (16, 17, -5, 9),
        ("round", 6),
        (84, 0.35, 4, 3.5),
        11.6,
        marks="bands",
        waist=0.18,
    ),
    "giraffe": _kind(
        (-62, 52, 24, 17, 8),
        (196, 220, 34, 38),
        (124, 420, 32, 13),
        (15, 36, -12, 9),
        ("point", 18),
        (80, 0.97, 5, 4),
        -36,
        marks="spots ossicones hooves",
        waist=0.1,
    ),
    "camel": _kind(
        (-70, 58, 20, 16, 9),
        (124, 126, 32, 34),
        (132, 190, 17, 12),
        (13, 26, -6, 9),
        ("round", 8),
        (54, 0.95, 4, 4),
        -32,
        marks="hump",
    ),
    "mouse": _kind(
        (-3.4, 3, 1.5, 1.2, 0.5),
        (2.6, 2.5, 2.4, 2.0),
        (5.2, 3.0, 1.7, 1.4),
        (1.7, 2.1, -0.4, 0.5),
        ("disc", 1.7),
        (8, 0.05, 0.5, 0.2),
        3.2,
    ),
    "crocodile": _kind(
        (-62, 46, 26, 10, 7),
        (25, 25, 17, 19),
        (86, 26, 15, 14),
        (14, 58, -8, 8),
        ("none", 0),
        (150, 0.08, 15, 2.5),
        32.7,
        marks="scutes sprawl",
        bare=True,
    ),
    "rhino": _kind(
        (-100, 86, 34, 28, 18),
        (108, 112, 54, 56),
        (146, 112, 44, 34),
        (34, 36, -22, 20),
        ("point", 24),
        (60, 0.95, 5, 3),
        -20,
        marks="nose_horn",
        bare=True,
    ),
}
