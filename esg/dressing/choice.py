"""Which place, which light and which ground: from the document's environment, words and things."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
import re

import numpy as np

from esg.assets.postures import plan_drawn
from esg.dressing.clearance import WATER, WATERS
from esg.engines.scene import SimScene
from esg.graph.models import EsgDocument, Predicate
from esg.lexicon import kinds, singular
from esg.lexicon.places import Place, SkyRow, places, skies, surfaces

WHERE = 10.0
BARE = 2.0
OF_A_THING = 1.0
"""Weight of a place's noun after a preposition of place, without one, and in a thing's name."""
GENERIC = "generic"
"""The environment of a prompt that says nothing of where it is: not even indoors or outdoors."""
TOO_LARGE = 6.0
"""Weight against a room that would have to be larger than such rooms are."""
MOST_OF_KINDS = 7.0
"""The things of a scene together weigh no more: less than words that say where it is."""
LUCK = 1.0
"""Greatest weight of chance: among places of about equal right one by the seed."""
TOY_SHARE = 0.25
"""What is shorter than this share of such things says nothing of where it is."""
STREETLIKE = 2.0
"""A road is a street if it is so many times as long as it is wide."""
_BEFORE = (
    r"(?:in|on|at|across|through|along|down|into|inside|onto|over|around|outside|near|by|from|to"
    r"|towards?|off|past|beside)"
)
_ARTICLE = r"(?:an?|the|his|her|their|our|its|this|that|some)?"
_PREPOSED = r"\b" + _BEFORE + r"\s+" + _ARTICLE + r"\s*(?:[\w-]+\s+){{0,2}}?{}\b"


@dataclass(frozen=True)
class Choice:
    """What was chosen, and why.

    Args:
        place: The place.
        sky: The light.
        ground: Name of the surface of its ground.
        reasons: What speaks for each.
    """

    place: Place
    sky: SkyRow
    ground: str
    reasons: tuple[str, ...]


def choose(doc: EsgDocument, scene: SimScene, extent: float, rng: np.random.Generator) -> Choice:
    """Place, sky and ground of a scene.

    Args:
        doc: The document.
        scene: Its bodies.
        extent: Greatest extent along X or Y of what they sweep [m].
        rng: Draws what nothing speaks for.
    """
    text = _said_of_places(doc).lower()
    ashore = _ashore(doc, scene)
    place, why = _place(doc, scene, text, extent, rng, ashore=ashore)
    sky, light = _sky(place, text, rng)
    ground, below = _ground(doc, place, text)
    if ground == WATER and ashore:
        ground, below = place.surface, ""
    return Choice(place, sky, ground, tuple(r for r in (why, light, below) if r))


def _said_of_places(doc: EsgDocument) -> str:
    """The prompt without what vessels are filled with: a bowl of water stands in no lake."""
    text = doc.scene_definition.original_description
    for s in doc.statements or ():
        if s.predicate is Predicate.FILLED_WITH:
            text = text[: s.start] + " " * (s.end - s.start) + text[s.end :]
    return text


@cache
def _usual_cm() -> dict[str, float]:
    """The usual longest extent of things [cm], by category."""
    return {k.name.replace(" ", "_"): max(k.dimensions_cm) for k in kinds() if k.dimensions_cm}


def categories(scene: SimScene) -> set[str]:
    """What there is in a scene; no road that is no street but a yard, and no toys of things."""
    found: set[str] = set()
    for body in scene.bodies:
        a, b = sorted(body.half_extents[:2])
        if 200.0 * max(body.half_extents) < TOY_SHARE * _usual_cm().get(body.category, 0.0):
            continue  # boats of 20 cm in a bathtub are on no lake
        if body.category == "road" and not body.collides and b < STREETLIKE * a:
            continue
        found.add(body.category)
    return found


_AIRY = frozenset({Predicate.WEATHER, Predicate.SWAYS})
"""Weather and wind: they are in no room, unless words say so."""


def _ashore(doc: EsgDocument, scene: SimScene) -> bool:
    """Whether somebody walks or drives on the ground beside a water of the scene."""
    graph = doc.spatial_relation_graph
    if not any(b.category in WATERS and not b.collides for b in scene.bodies):
        return False
    for body in scene.bodies:
        node = graph.nodes.get(body.name)
        if node is None or body.static or not (plan_drawn(doc, body.name) or body.wheels):
            continue
        region = graph.semantic_regions.get(node.semantic_region or "")
        below = None if region is None else graph.nodes.get(region.parent_object)
        if below is None or below.is_structural:
            return True
    return False


def _place(
    doc: EsgDocument,
    scene: SimScene,
    text: str,
    extent: float,
    rng: np.random.Generator,
    *,
    ashore: bool,
) -> tuple[Place, str]:
    told = doc.scene_definition.scene_parameters
    found = categories(scene)
    airy = any(s.predicate in _AIRY for s in doc.statements or ())
    best: tuple[float, Place, str] | None = None
    for row in places().values():
        luck = LUCK * float(rng.random())
        if row.needs and not row.needs & found:
            continue
        preset = row.presets.get(told.environment, 0.0)
        said, word = _said(row.said_as, text)
        things = {name: weight for name, weight in row.kinds.items() if name in found}
        score = preset + said + min(MOST_OF_KINDS, sum(things.values()))
        if score <= 0.0 and row.name not in ("meadow", "room"):
            continue
        if airy and row.setting == "indoor" and said < WHERE:
            continue
        if ashore and row.surface == WATER:
            continue
        if row.setting != told.scene_type and told.environment != GENERIC and said < WHERE:
            continue
        if row.most_m and extent > row.most_m:
            score -= TOO_LARGE
        if best is None or score + luck > best[0]:
            because = [f'"{word}"'] if word else []
            because += [f"environment {told.environment}"] if preset else []
            because += sorted(things)
            best = (score + luck, row, f"{row.name}: {', '.join(because) or 'nothing is said'}")
    assert best is not None  # meadow and room are always there
    return best[1], best[2]


def _said(words: Iterable[str], text: str) -> tuple[float, str]:
    """How strongly a text says that it is in one of some places, and by which word."""
    best = (0.0, "")
    for word in words:
        for match in re.finditer(rf"\b{re.escape(word)}\b", text):
            before = text[: match.end()]
            if any(before.endswith(longer) for longer in _longer(word)):
                continue
            placed = re.search(_PREPOSED.format(re.escape(word)) + "$", before)
            weight = WHERE if placed else BARE
            if _of_a_thing(text[match.end() :]):
                weight = OF_A_THING
            best = max(best, (weight, word))
    return best


@cache
def _longer(word: str) -> tuple[str, ...]:
    """Nouns of places that end with a word: a car park is no park."""
    known = (noun for place in places().values() for noun in place.said_as)
    return tuple(sorted(noun for noun in known if noun.endswith(f" {word}")))


def _of_a_thing(rest: str) -> bool:
    """Whether a word is followed by the name of a thing: a beach ball, a park bench."""
    following = re.match(r"[\s-]+([a-z]+)", rest)
    return following is not None and singular(following[1]) in _things()


@cache
def _things() -> frozenset[str]:
    told = ((kind.name, *kind.said_as) for kind in kinds() if kind.kind != "ground")
    return frozenset(name for names in told for name in names)


def _sky(place: Place, text: str, rng: np.random.Generator) -> tuple[SkyRow, str]:
    rows = [row for row in skies().values() if row.setting == place.setting]
    # "A rainy night" is a night.
    for row, words in [(r, r.said_as) for r in rows] + [(r, r.not_shown) for r in rows]:
        for word in words:
            if re.search(rf"\b{re.escape(word)}\b", text):
                return row, f'{row.name} sky: "{word}"'
    weights = np.array([row.weight for row in rows])
    return rows[int(rng.choice(len(rows), p=weights / weights.sum()))], ""


def _ground(doc: EsgDocument, place: Place, text: str) -> tuple[str, str]:
    """The surface that words ask for, else the place's own; where it is wet, as that looks."""
    told = doc.scene_definition.wording
    said = None if told is None else told.surface
    if said is not None and said in surfaces():
        return said, f"ground: {said}"
    dry, why = _dry_ground(doc, place, text)
    looks = f"{said}_{dry}"
    return (looks, f"ground: {said}") if looks in surfaces() else (dry, why)


def _dry_ground(doc: EsgDocument, place: Place, text: str) -> tuple[str, str]:
    """The surface that words ask for, else the place's own; a room's floor outdoors never."""
    told = doc.scene_definition
    configs = doc.asset_configurations
    solid = {
        name.rpartition("_")[0].replace("_", " ")
        for name, node in doc.spatial_relation_graph.nodes.items()
        if node.asset_id in configs and configs[node.asset_id].proxies
    }
    natural = {"snow", "ice", "sand", "grass", "soil", "gravel", "water"}
    for name, row in surfaces().items():
        if place.setting == "indoor" and name in natural:
            continue
        if told.scene_parameters.environment.replace("_", " ") in row.said_as:
            return name, f"ground: environment {told.scene_parameters.environment}"
        # What one bumps into is a thing, not the ground: the boards of a rink.
        strong, word = _said((w for w in row.said_as if singular(w) not in solid), text)
        snowed = name == "snow" and strong > 0.0
        if strong >= WHERE or snowed:
            return name, f'ground: "{word}"'
    return place.surface, ""


def weighted(weights: Mapping[str, float], rng: np.random.Generator) -> str:
    """One name by its weight."""
    names = sorted(weights)
    total = sum(weights.values())
    return names[int(rng.choice(len(names), p=[weights[n] / total for n in names]))]
