"""Where scenes take place: tables of places, of what stands in them, of skies and of surfaces.

`esg.dressing` reads them all; the verifier knows names by them.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

from esg.lexicon.cells import words

_FOLDER = Path(__file__).parent
Span = tuple[float, float]
Rgb = tuple[float, float, float]
Setting = Literal["indoor", "outdoor"]
SkyKind = Literal["clear", "cloudy", "dusk", "night", "indoor"]
_SKY_KINDS: dict[str, SkyKind] = {
    "clear": "clear",
    "cloudy": "cloudy",
    "dusk": "dusk",
    "night": "night",
    "indoor": "indoor",
}
USUAL = 8.0
"""Weight of a preset or noun that names a place, where its row gives none."""


@dataclass(frozen=True)
class Surface:
    """What a ground, wall or line is made of.

    Args:
        name: Unique.
        said_as: Nouns and adjectives of a prompt that say that the ground is so.
        material: Its row in the table of materials (`esg/assets/materials.csv`).
        rgb: Its usual colour, sRGB in [0, 1]; None for the material's.
        roughness: In [0, 1]; None for the material's.
    """

    name: str
    said_as: tuple[str, ...]
    material: str
    rgb: Rgb | None
    roughness: float | None


@dataclass(frozen=True)
class SkyRow:
    """One light.

    Args:
        name: Unique.
        setting: Of the places that have it.
        said_as: Words that ask for it, and that it shows.
        not_shown: Words that ask for it and say more than it shows: rain falls from no sky of ours.
        kind: What is seen of it (`esg.view.surroundings.Sky`).
        weight: Of the draw where nothing is said; 0 only if it is asked for.
        elevation_deg: Of the sun.
        sun_rgb, ambient_rgb: Linear irradiance.
        zenith, horizon: Linear colours.
    """

    name: str
    setting: Setting
    said_as: tuple[str, ...]
    not_shown: tuple[str, ...]
    kind: SkyKind
    weight: float
    elevation_deg: Span
    sun_rgb: Rgb
    ambient_rgb: Rgb
    zenith: Rgb
    horizon: Rgb


@dataclass(frozen=True)
class Place:
    """One kind of place.

    Args:
        name: Unique.
        setting: indoor or outdoor.
        presets: Names of environments that mean it, with weights.
        said_as: Nouns that name it.
        kinds: Categories of things that are at home in it, with weights.
        needs: Categories one of which must be there; none if empty.
        surface: Of its ground.
        axis: Category of the thing along which it is laid out; "" for the world's axes.
        clear_m: From the action to its walls, or to the first things outdoors.
        most_m: Greatest extent of the action that such a place has room for; 0 for any.
        least_m: Smallest extents of a room, or of the action's rectangle.
        height_m: Of its walls, at least.
    """

    name: str
    setting: Setting
    presets: dict[str, float]
    said_as: tuple[str, ...]
    kinds: dict[str, float]
    needs: frozenset[str]
    surface: str
    axis: str
    clear_m: float
    most_m: float
    least_m: tuple[float, float]
    height_m: float


@dataclass(frozen=True)
class Standing:
    """Something that stands in places.

    Args:
        places: Names of them.
        item: Entry of the parametric library, or builder of `esg.dressing`.
        where: rail (here and there along a side), run (end to end along a side), ring (anywhere
            around), water (afloat on what is drawn as water), wall (a wall of the room), against
            (with its back to a wall), hung (on a wall without windows).
        sides: all, long, ends, back (the one farthest from the viewer) or rest (all but the
            viewer's).
        away_m: Least and greatest distance from the action (`against`: from the wall).
        count: Least and greatest number; of a run the number of lengths it may have at most.
        chance: That there is any.
        size_m: Ranges of depth, width and height; none: the usual size, 10% more or less.
        surfaces: One of these; none: as it is made.
        colors: One of these; none: the usual one.
        gap_m: Between neighbours of a run, and to everything else.
        facing: in, out, along or any: where its front points.
    """

    places: tuple[str, ...]
    item: str
    where: str
    sides: str
    away_m: Span
    count: tuple[int, int]
    chance: float
    size_m: tuple[Span, Span, Span] | None
    surfaces: tuple[str, ...]
    colors: tuple[Rgb, ...]
    gap_m: float
    facing: str


@dataclass(frozen=True)
class Drawn:
    """Something flat that is drawn on the ground of places, along the sides of the action.

    Args:
        places: Names of them.
        surface: Row of the table of surfaces.
        sides: As of `Standing`; or middle, along the action's longer side; or axis and beside, in
            front and on both sides of the thing along which the place is laid out.
        away_m: From the action's edge to the marking's nearer edge.
        width_m: Across the side.
        length_m: Along it; 0 for as long as the place, and beyond.
        line_cm: Width of its outline; 0 for all of it.
        repeat: How many beside each other along the side.
        shape: rectangle or ellipse.
        layer: The greater covers the smaller.
    """

    places: tuple[str, ...]
    surface: str
    sides: str
    away_m: float
    width_m: float
    length_m: float
    line_cm: float
    repeat: int
    shape: Literal["rectangle", "ellipse"]
    layer: int


@cache
def surfaces() -> dict[str, Surface]:
    """Every row of `surfaces.csv` by name."""
    return {
        row["name"]: Surface(
            name=row["name"],
            said_as=words(row["said_as"]),
            material=row["material"],
            rgb=hex_rgb(row["color"]) if row["color"] else None,
            roughness=float(row["roughness"]) if row["roughness"] else None,
        )
        for row in _rows("surfaces.csv")
    }


@cache
def skies() -> dict[str, SkyRow]:
    """Every row of `skies.csv` by name."""
    return {
        row["name"]: SkyRow(
            name=row["name"],
            setting=_setting(row),
            said_as=words(row["said_as"]),
            not_shown=words(row["not_shown"]),
            kind=_SKY_KINDS[row["kind"]],
            weight=float(row["weight"]),
            elevation_deg=_span(row["elevation_deg"]),
            sun_rgb=_rgb(row["sun_rgb"]),
            ambient_rgb=_rgb(row["ambient_rgb"]),
            zenith=_rgb(row["zenith"]),
            horizon=_rgb(row["horizon"]),
        )
        for row in _rows("skies.csv")
    }


@cache
def sky_words(setting: Setting) -> tuple[frozenset[str], frozenset[str]]:
    """Words for light and weather: what the skies of a setting show, and what no picture shows.

    Snow that lies on the ground is shown, as a surface.
    """
    shown = {w for row in skies().values() if row.setting == setting for w in row.said_as}
    asked = {w for row in skies().values() for w in (*row.said_as, *row.not_shown)}
    lying = {"snow", "snowy"} & {*surfaces()["snow"].said_as}
    return frozenset(shown | lying), frozenset(asked - shown - lying)


@cache
def places() -> dict[str, Place]:
    """Every row of `places.csv` by name."""
    return {
        row["name"]: Place(
            name=row["name"],
            setting=_setting(row),
            presets=_weights(row["presets"]),
            said_as=words(row["said_as"]),
            kinds=_weights(row["kinds"], 1.0),
            needs=frozenset(words(row["needs"])),
            surface=row["surface"],
            axis=row["axis"],
            clear_m=float(row["clear_m"]),
            most_m=float(row["most_m"]),
            least_m=_pair(row["least_m"]),
            height_m=float(row["height_m"]),
        )
        for row in _rows("places.csv")
    }


@cache
def standing(place: str) -> tuple[Standing, ...]:
    """What may stand in a place, in the order in which it is put there."""
    return tuple(_standing(r) for r in _rows("place_items.csv") if place in words(r["places"]))


@cache
def things() -> frozenset[str]:
    """Everything that some place has."""
    return frozenset(row["item"] for row in _rows("place_items.csv"))


@cache
def drawn(place: str) -> tuple[Drawn, ...]:
    """What is drawn on the ground of a place."""
    return tuple(_drawn(r) for r in _rows("place_markings.csv") if place in words(r["places"]))


def hex_rgb(text: str) -> Rgb:
    """Colour from "#rrggbb"."""
    r, g, b = (int(text[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return (r, g, b)


@cache
def _rows(name: str) -> tuple[dict[str, str], ...]:
    with open(_FOLDER / name, encoding="utf-8", newline="") as file:
        return tuple(csv.DictReader(file))


def _standing(row: dict[str, str]) -> Standing:
    size = [_span(text) for text in row["size_m"].split("x")] if row["size_m"] else None
    low, high = _span(row["count"])
    return Standing(
        places=words(row["places"]),
        item=row["item"],
        where=row["where"],
        sides=row["sides"],
        away_m=_span(row["away_m"]),
        count=(int(low), int(high)),
        chance=float(row["chance"]),
        size_m=None if size is None else (size[0], size[1], size[2]),
        surfaces=words(row["surfaces"]),
        colors=tuple(hex_rgb(text) for text in words(row["colors"])),
        gap_m=float(row["gap_m"]),
        facing=row["facing"],
    )


def _drawn(row: dict[str, str]) -> Drawn:
    return Drawn(
        places=words(row["places"]),
        surface=row["surface"],
        sides=row["sides"],
        away_m=float(row["away_m"]),
        width_m=float(row["width_m"]),
        length_m=float(row["length_m"]),
        line_cm=float(row["line_cm"]),
        repeat=int(row["repeat"]),
        shape="ellipse" if row["shape"] == "ellipse" else "rectangle",
        layer=int(row["layer"]),
    )


def _weights(text: str, usual: float = USUAL) -> dict[str, float]:
    pairs = (word.partition(":") for word in words(text))
    return {name: float(weight) if weight else usual for name, _, weight in pairs}


def _span(text: str) -> Span:
    low, _, high = text.partition("..")
    return (float(low), float(high or low))


def _pair(text: str) -> Span:
    length, _, width = text.partition("x")
    return (float(length), float(width))


def _rgb(text: str) -> Rgb:
    r, g, b = (float(x) for x in text.split())
    return (r, g, b)


def _setting(row: dict[str, str]) -> Setting:
    return "indoor" if row["setting"] == "indoor" else "outdoor"
