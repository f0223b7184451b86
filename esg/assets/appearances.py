"""What the things of a scene look like where its prompt leaves it open: poses, liveries, colours.

Chosen at drawing time from the document and its seed, and from nothing else: the same scene of the
same seed always looks the same, two things of one kind differ, and what the prompt says stays as it
says. Nothing of it is stored, so that documents, physics and verdicts keep their bytes.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass, replace
from functools import cache
import hashlib
from pathlib import Path
import re

from esg.assets.appearance import FLYING, RIDDEN, USUAL, Appearance, Wear
from esg.assets.builders.living.beasts import GAITS
from esg.assets.colors import COLORS, find_color
from esg.assets.configuration import parametric_entry, stated_material
from esg.assets.library.catalogue import Entry, normalize, parse_hex
from esg.assets.looks import Color
from esg.assets.materials import MATERIALS
from esg.assets.postures import changes_posture
from esg.graph.casting import effective
from esg.graph.models import AssetRequirement, CoverageItem, EsgDocument, NodeEvent, Predicate
from esg.lexicon.garments import read
from esg.lexicon.places import surfaces

_DATA = Path(__file__).parent / "data"
_PEOPLE = frozenset({"figure", "child_figure"})
_WINGED = frozenset({"bird", "insect", "plumed"})
_RIDDEN = frozenset({"bicycle", "motorcycle", "scooter"})
"""Builders that draw somebody on what goes by itself."""
_NOBODY = re.compile(
    r"\b(?:rider-?less|driver-?less|unmanned|unridden|runaway|empty|ghost|toy|model|self-driving"
    r"|by itself|on its own|(?:without|no) (?:a |any )?(?:rider|driver|one|body)|nobody)\b",
    re.IGNORECASE,
)
_GOES = ("UniformMotion", "Accelerate", "AcceleratedMotion", "Turn", "Brake")
"""Segments of what goes under its own power."""
_INDIVIDUALS = _PEOPLE | {"tree", "billiard_ball"}
_NEAR = 0.28
"""Largest difference in a channel at which two colours pass for one."""
_LIVERIES: dict[str, Color] = {
    "police_car": parse_hex("#f0f0ee"),
    "taxi": parse_hex("#ecb51e"),
    "ambulance": parse_hex("#f4f4f0"),
    "fire_truck": parse_hex("#c01c1c"),
}
"""What a vehicle serves as, by category, and its usual colour."""
_SLOPES = frozenset({"slope", "hill", "hillside", "bank", "embankment", "dune"})
_LAND = frozenset({"grass", "snow", "sand", "soil"})
"""Grounds of which hills are made, by material."""
_NODE = re.compile(r"/spatial_relation_graph/nodes/([^/]+)")


@dataclass(frozen=True)
class _Postures:
    on: dict[str, str]
    does: dict[str, str]
    plays: frozenset[str]
    played: dict[str, str]


@cache
def _postures() -> _Postures:
    tables: dict[str, dict[str, str]] = {"on": {}, "does": {}, "plays": {}, "played": {}}
    with (_DATA / "postures.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            tables[row["says"]] |= dict.fromkeys(row["words"].split(";"), row["pose"])
    plays = frozenset(tables["plays"])
    return _Postures(tables["on"], tables["does"], plays, tables["played"])


@cache
def _palettes() -> dict[str, tuple[Color, ...]]:
    out: dict[str, tuple[Color, ...]] = {}
    with (_DATA / "palettes.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            colors = tuple(parse_hex(c) for c in row["colors"].split(";"))
            out |= dict.fromkeys(row["kinds"].split(";"), colors)
    return out


@cache
def _typical_colors() -> dict[str, Color]:
    out: dict[str, Color] = {}
    with (_DATA / "typical_colors.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            out |= dict.fromkeys(row["nouns"].split(";"), parse_hex(row["color"]))
    return out


def typical_color(requirement: AssetRequirement | None) -> Color | None:
    """The colour of what the words name, where it is not that of the kind that is drawn for them.

    A lemon has the body of an orange, and a school bus that of a bus.

    Args:
        requirement: What the document asks for.
    """
    if requirement is None:
        return None
    return next(
        (_typical_colors()[e] for e in _endings(requirement) if e in _typical_colors()), None
    )


def _endings(requirement: AssetRequirement) -> list[str]:
    """What the words name, and what is left of it without its first words."""
    said, colon, _ = requirement.asset_description.partition(":")
    words = normalize(said if colon else requirement.asset_category).split()
    return [" ".join(words[start:]) for start in range(len(words))]


def _of_ground(doc: EsgDocument, asset: str, entry: Entry, own: Appearance) -> Appearance:
    """A slope that is a piece of the land looks like the ground around it; others as they are."""
    asked = doc.asset_requirement.get(asset)
    if doc.dressing is None or asked is None or _colored(doc, asset, entry) or own.material:
        return own
    ground = surfaces().get(doc.dressing.ground or "")
    if ground is None or ground.material not in _LAND or not _SLOPES.intersection(_endings(asked)):
        return own
    return replace(
        own, material=ground.material, color=ground.rgb or MATERIALS[ground.material].color
    )


def appearances(doc: EsgDocument) -> dict[str, Appearance]:
    """How every node of a resolved document looks, by its id."""
    doc = effective(doc)
    seed = next((p.seed for p in doc.provenance if p.stage == "resolve"), 0)
    prompt = doc.scene_definition.original_description
    poses, wears = _poses(doc), _wears(doc)
    taken = _stated_colors(doc)
    out: dict[str, Appearance] = {}
    for name, node in doc.spatial_relation_graph.nodes.items():
        config = doc.asset_configurations.get(node.asset_id)
        entry = None if config is None else parametric_entry(config)
        if config is None or entry is None:
            out[name] = USUAL
            continue
        which = name if _differs(entry) else node.asset_id
        digest = hashlib.sha256(f"{seed}/{prompt}/{which}".encode()).digest()
        own = Appearance(
            pose=poses.get(name, ""),
            livery=config.category if config.category in _LIVERIES else "",
            seed=int.from_bytes(digest[:6], "big"),
            material=_material(doc, node.asset_id, entry),
            wears=wears.get(name, ()),
        )
        if own.livery and not _colored(doc, node.asset_id, entry):
            out[name] = replace(own, color=_LIVERIES[own.livery])
            continue
        landed = _of_ground(doc, node.asset_id, entry, own)
        if landed is not own:
            out[name] = landed
            continue
        typical = typical_color(doc.asset_requirement.get(node.asset_id))
        if typical is not None and not _colored(doc, node.asset_id, entry):
            out[name] = replace(own, color=typical)
            continue
        color = None if own.livery else _free_color(doc, node.asset_id, entry, own, taken)
        if color is not None:
            own = replace(own, color=color)
            taken = (*taken, color)
        out[name] = own
    return out


def wear_of(phrase: str) -> Wear | None:
    """What a phrase of a statement dresses somebody in; None if nothing is drawn for it.

    Args:
        phrase: "black t-shirt", "long red hair".
    """
    worn = read(phrase, COLORS)
    if worn is None:
        return None
    color = find_color(worn.color)
    return Wear(worn.garment.kind, color, worn.surface, worn.pattern == "striped")


def _wears(doc: EsgDocument) -> dict[str, tuple[Wear, ...]]:
    """What the statements say that each node wears, and how its hair is."""
    out: dict[str, tuple[Wear, ...]] = {}
    for s in doc.statements or ():
        if s.predicate in (Predicate.WEARS, Predicate.LOOKS):
            worn = wear_of(s.noun or "")
            if worn is None:
                continue
            for name in s.object:
                if worn not in out.get(name, ()):
                    out[name] = (*out.get(name, ()), worn)
    return out


def _material(doc: EsgDocument, asset: str, entry: Entry) -> str:
    asked = doc.asset_requirement.get(asset)
    stated = None if asked is None else stated_material(entry, asked)
    return "" if stated is None else stated.name


def _palette(entry: Entry) -> tuple[Color, ...] | None:
    kind = dict(entry.params).get("kind")
    return _palettes().get(f"{entry.builder}:{kind}") or _palettes().get(entry.builder)


def _differs(entry: Entry) -> bool:
    """Whether two nodes with one asset of a kind look different: cars do, bowling pins do not."""
    return entry.builder in _INDIVIDUALS or _palette(entry) is not None


def _stated_colors(doc: EsgDocument) -> tuple[Color, ...]:
    """Colours that the prompt gives to something: no other thing is to be taken for it."""
    found = (find_color(r.color) for r in doc.asset_requirement.values())
    return tuple(c for c in found if c is not None)


def _free_color(
    doc: EsgDocument, asset: str, entry: Entry, own: Appearance, taken: tuple[Color, ...]
) -> Color | None:
    """A colour of the kind's palette that nothing else has; None where the prompt states one."""
    palette = _palette(entry)
    if (
        palette is None
        or _colored(doc, asset, entry)
        or dict(entry.params).get("dress", "plain") != "plain"
    ):
        return None
    free = [c for c in palette if not any(_alike(c, other) for other in taken)] or list(palette)
    return free[own.pick("color", len(free))]


def _colored(doc: EsgDocument, asset: str, entry: Entry) -> bool:
    """Whether the prompt states a colour, or a material that has one."""
    asked = doc.asset_requirement.get(asset)
    stated = asked is not None and bool(asked.color)
    return stated or entry.color_rgb != doc.asset_configurations[asset].color_rgb


def _alike(a: Color, b: Color) -> bool:
    return max(abs(p - q) for p, q in zip(a, b, strict=True)) < _NEAR


def first_of_asset(doc: EsgDocument, looks: dict[str, Appearance]) -> dict[str, Appearance]:
    """The appearance of every asset: that of its first node."""
    out: dict[str, Appearance] = {}
    for name, node in doc.spatial_relation_graph.nodes.items():
        out.setdefault(node.asset_id, looks.get(name, USUAL))
    return out


def _poses(doc: EsgDocument) -> dict[str, str]:
    """Poses of the people and animals of a document, and of what is ridden, by node."""
    nodes = doc.spatial_relation_graph.nodes
    kinds: dict[str, str] = {}
    builders: dict[str, str] = {}
    for name, node in nodes.items():
        config = doc.asset_configurations.get(node.asset_id)
        entry = None if config is None else parametric_entry(config)
        if entry is not None:
            kinds[name] = entry.name
            builders[name] = entry.builder
    people = {n for n, b in builders.items() if b in _PEOPLE}
    beasts = {n for n, b in builders.items() if b == "quadruped"}
    ridden = _ridden(doc, {n for n, b in builders.items() if b in _RIDDEN}, people)
    ridden |= _flying(doc, {n for n, b in builders.items() if b in _WINGED})
    if not people | beasts:
        return ridden
    going = _moving(doc, people | beasts)
    done = _doing(doc, people | beasts)
    # A dog that catches a ball walks or runs, or it stands.
    done = {n: pose for n, pose in done.items() if n in people or pose in GAITS}
    found = ridden | going | done | _loaded(doc, people)
    elsewhere = changes_posture(doc)  # drawn as another body while they sit
    regions, leaping = doc.spatial_relation_graph.semantic_regions, _leaping(doc)
    for name in sorted(people):
        region = regions.get(nodes[name].semantic_region or "")
        below = None if region is None else kinds.get(region.parent_object)
        posture = _postures().on.get(below or "")
        if name in elsewhere:
            continue
        if posture == "sit" and name in leaping:
            found[name] = done.get(name, "run")  # who jumps off a bench does not sit on it
        elif posture is not None:
            found[name] = posture
    return found


def _leaping(doc: EsgDocument) -> set[str]:
    """Who leaps."""
    if doc.timeline_system is None:
        return set()
    nodes = doc.timeline_system.sequence_graph.nodes
    return {n.participants[0] for n in nodes if n.event is NodeEvent.JUMP}


def _ridden(doc: EsgDocument, mounts: set[str], people: set[str]) -> dict[str, str]:
    """Two-wheelers that go by themselves, with nobody of the document on them: one is drawn."""
    if doc.timeline_system is None or _NOBODY.search(doc.scene_definition.original_description):
        return {}
    edges = doc.timeline_system.sequence_graph.edges
    nodes, regions = doc.spatial_relation_graph.nodes, doc.spatial_relation_graph.semantic_regions
    gone = {e.actor for e in edges if e.event.value in _GOES}
    under = (regions.get(nodes[n].semantic_region or "") for n in people)
    taken = {region.parent_object for region in under if region is not None}
    return dict.fromkeys(sorted((gone & mounts) - taken), RIDDEN)


def _flying(doc: EsgDocument, birds: set[str]) -> dict[str, str]:
    """Birds and insects of which it is told that they are in the air: they spread their wings."""
    aloft = (s for s in doc.statements or () if s.predicate is Predicate.AIRBORNE)
    return dict.fromkeys(sorted(birds & {i for s in aloft for i in s.object}), FLYING)


def _moving(doc: EsgDocument, walkers: set[str]) -> dict[str, str]:
    """Those who go somewhere by themselves walk."""
    if doc.timeline_system is None:
        return {}
    edges = doc.timeline_system.sequence_graph.edges
    gone = {e.actor for e in edges if e.event.value in ("UniformMotion", "Accelerate", "Toward")}
    return dict.fromkeys(sorted(gone & walkers), "walk")


def _loaded(doc: EsgDocument, people: set[str]) -> dict[str, str]:
    """Those on whom something lies carry it on their heads."""
    nodes, regions = doc.spatial_relation_graph.nodes, doc.spatial_relation_graph.semantic_regions
    under = {
        regions[n.semantic_region].parent_object
        for n in nodes.values()
        if n.semantic_region in regions
    }
    borne = (s for s in doc.statements or () if s.predicate is Predicate.CARRIED_BY)
    told = {i for s in borne for i in s.target}
    return dict.fromkeys(sorted(under & people & (told | under)), "bear")


def _doing(doc: EsgDocument, actors: set[str]) -> dict[str, str]:
    """What the prompt says that somebody does: the pose of the last such verb of his."""
    prompt = doc.scene_definition.original_description
    items = sorted(doc.coverage.items, key=lambda item: item.start)
    out: dict[str, str] = {}
    for k, item in enumerate(items):
        if item.kind != "event":
            continue
        words = item.text.lower().split()
        pose = next((p for w in words if (p := pose_of(w))), None)
        before = next((i for i in reversed(items[:k]) if i.kind == "object"), None)
        after = next((i for i in items[k + 1 :] if i.kind == "object"), None)
        if any(_postures().plays.intersection(stems_of(w)) for w in words):
            pose = _played(doc, after) or pose
        passive = after is not None and re.search(r"\bby\b", prompt[item.end : after.start])
        for name in _named(doc, after if passive else before):
            if pose is not None and name in actors:
                out[name] = pose
    return out


def _played(doc: EsgDocument, item: CoverageItem | None) -> str | None:
    """The pose of who plays with what an item of the prompt became; None where any would do."""
    nodes, configs = doc.spatial_relation_graph.nodes, doc.asset_configurations
    kinds = [configs[nodes[n].asset_id].category for n in _named(doc, item)]
    return next((_postures().played[k] for k in kinds if k in _postures().played), None)


def _named(doc: EsgDocument, item: CoverageItem | None) -> list[str]:
    """The node that an item of the prompt became, and those of its group."""
    found = None if item is None else _NODE.match(item.pointer)
    nodes = doc.spatial_relation_graph.nodes
    if found is None or found[1] not in nodes:
        return []
    group = nodes[found[1]].group
    return [n for n in nodes if n == found[1] or (group is not None and nodes[n].group == group)]


@cache
def pose_of(word: str) -> str | None:
    """The pose that a form of a verb asks for: "throws", "throwing", "threw"; None if none does."""
    table = _postures().does
    return next((table[s] for s in stems_of(word) if s in table), None)


def stems_of(word: str) -> tuple[str, ...]:
    """What a form of a verb may be a form of."""
    irregular = {
        "threw": "throw",
        "thrown": "throw",
        "ran": "run",
        "held": "hold",
        "shot": "shoot",
        "struck": "strike",
        "swung": "swing",
        "flung": "fling",
        "fled": "flee",
    }
    word = irregular.get(word, word)
    stems = [word]
    for ending in ("s", "es", "d", "ed", "ing"):
        if word.endswith(ending):
            stem = word[: -len(ending)]
            stems += [stem, stem + "e", stem[:-1] if stem[-2:-1] == stem[-1:] else stem]
    return tuple(stems)
