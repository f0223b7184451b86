"""Riders together with what they ride, one body: a cyclist, a skateboarder, somebody on a horse."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
import math
from typing import Any

from esg.assets.appearance import RIDDEN, Appearance
from esg.assets.builders import BUILDERS, builder
from esg.assets.builders.common import shift
from esg.assets.builders.living.people import DRESSES, draw_person
from esg.assets.geometry.sketch import DARK, STEEL, Color, Finish, Sketch, rgb
from esg.graph.models import Vec3


@dataclass(frozen=True)
class Mount:
    """What somebody rides, and how.

    Args:
        builder: Draws it.
        size: Extents it is drawn at [cm].
        color: Its own colour; the rider wears that of the whole.
        seat: What the rider sits or stands on [cm].
        pose: How (`poses`).
        params: Of the builder.
        turned: The rider against the way ahead, to the left [deg].
        loose: A part that is folded up or left out while it is ridden.
        middle: Of the two together, where the mount's is 0 [cm].
    """

    builder: str
    size: Vec3
    color: Color
    seat: Vec3
    pose: str
    params: tuple[tuple[str, str], ...] = ()
    turned: float = 0.0
    loose: str = ""
    middle: tuple[float, float] = (0.0, 0.0)


_WOOD = Finish(rgb(91, 58, 140), "oak")
MOUNTS: dict[str, Mount] = {
    "bicycle": Mount(
        "bicycle", (175, 60.5, 104.2), rgb(31, 95, 168), (-27, 0, 95), "ride", loose="kickstand"
    ),
    "motorcycle": Mount(
        "motorcycle",
        (210, 80, 112),
        rgb(180, 22, 28),
        (-26, 0, 87),
        "straddle",
        loose="side_stand",
        middle=(1.5, 0),
    ),
    "scooter": Mount("scooter", (100, 45, 100), rgb(48, 50, 54), (-6, 0, 12), "hold"),
    "skateboard": Mount(
        "skateboard", (80, 20, 12), _WOOD, (0, 0, 10), "board", turned=-80, middle=(5.5, -7)
    ),
    "snowboard": Mount(
        "board_sport",
        (152, 29, 4.8),
        rgb(47, 60, 126),
        (0, 0, 4.8),
        "board",
        (("kind", "snowboard"),),
        -80,
        middle=(0, -7),
    ),
    "surfboard": Mount(
        "board_sport",
        (184, 52, 7.2),
        rgb(240, 234, 216),
        (0, 0, 7.2),
        "board",
        (("kind", "surfboard"),),
        -80,
        middle=(0, -5.5),
    ),
    "skis": Mount(
        "board_sport", (168, 24, 7), rgb(200, 55, 45), (-2, 0, 5), "ski", (("kind", "skis"),)
    ),
    "skates": Mount("", (30, 20, 5), STEEL, (0, 0, 5), "skate", middle=(3.5, 2)),
    "horse": Mount(
        "quadruped",
        (238.7, 58.8, 193.8),
        rgb(122, 74, 42),
        (-10, 0, 146),
        "astride",
        (("kind", "horse"),),
        middle=(7.5, 0),
    ),
}


def draw_rider(s: Sketch, mount: Mount, dress: str, c: Color) -> None:
    """Puts somebody on what is drawn.

    Args:
        s: Receives the parts: nothing that is simulated.
        mount: What he rides.
        dress: A name of `DRESSES`.
        c: Of his coat.
    """
    own = replace(s.appearance, pose="", color=None)
    rider = Sketch(material="textile", appearance=own)
    draw_person(rider, DRESSES[dress], c, mount.pose)
    if mount.turned:
        rider.parts[:] = [replace(p, mesh=_turned(p.mesh, mount.turned)) for p in rider.parts]
    shift(rider, *mount.seat)
    s.parts[:] = [p for p in s.parts if not mount.loose or p.name != mount.loose]
    s.parts += rider.parts


def ridden(s: Sketch, kind: str) -> None:
    """Somebody on a vehicle that goes by itself, where the appearance says so."""
    if s.appearance.pose == RIDDEN:
        coats = (rgb(58, 95, 134), rgb(156, 74, 62), rgb(84, 88, 94), rgb(77, 122, 82))
        coat = coats[s.appearance.pick("coat", len(coats))]
        draw_rider(s, MOUNTS[kind], "sportsman", coat)


def _turned(make: Callable[[], Any], degrees: float) -> Callable[[], Any]:
    a = math.radians(degrees)
    about_z = [
        [math.cos(a), -math.sin(a), 0, 0],
        [math.sin(a), math.cos(a), 0, 0],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
    ]

    def mesh() -> Any:
        out = make()
        out.apply_transform(about_z)
        return out

    return mesh


@builder("mounted")
def mounted(
    s: Sketch,
    L: float,
    W: float,
    H: float,
    c: Color,
    mount: str = "bicycle",
    dress: str = "sportsman",
) -> None:
    """Somebody in the saddle, on a board or on skates, with what carries him; facing +X."""
    m = MOUNTS[mount]
    look, s.appearance = s.appearance, Appearance(seed=s.appearance.seed)
    if m.builder:
        BUILDERS[m.builder](s, *m.size, m.color, **dict(m.params))
    else:
        _skates(s)
    s.appearance = look
    draw_rider(s, m, dress, c)
    _collides(s, m)
    shift(s, -m.middle[0], -m.middle[1])


def _collides(s: Sketch, m: Mount) -> None:
    """The rider's own proxies."""
    x, _, z = m.seat
    if m.pose in _SEATED:
        s.proxy_slab((x - 14, x + 20), (-22, 22), (z, z + 62), 0.9)
        s.proxy_cylinder(10, (z + 62, z + 88), 0.8, (x + 18, 0))
        return
    s.proxy_slab((x - 12, x + 12), (-14, 14), (z, z + 80), 0.8)
    s.proxy_slab((x - 12, x + 16), (-24, 24), (z + 80, z + 134), 0.9)
    s.proxy_cylinder(10, (z + 134, z + 160), 0.8, (x + 4, 0))


_SEATED = frozenset({"ride", "straddle", "astride"})


def _skates(s: Sketch) -> None:
    """A runner under each foot."""
    for y in (-9.5, 9.5):
        s.slab((-14, 16), (y - 0.4, y + 0.4), (0, 3), STEEL, name="runner")
        for x in (-8, 9):
            s.slab((x - 2, x + 2), (y - 1.6, y + 1.6), (3, 5), DARK, name="runner_post")
    s.proxy_slab((-15, 17), (-11, 11), (0, 5), 1.0)
