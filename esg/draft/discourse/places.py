"""Where things are with respect to each other."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, movable, structural
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import Relation
from esg.graph.models import Quantity

RELATION_PREPS: dict[str, str] = {
    "on": "on",
    "onto": "on",
    "upon": "on",
    "atop": "on",
    "under": "under",
    "beneath": "under",
    "below": "under",
    "underneath": "under",
    "in front of": "in_front_of",
    "behind": "behind",
    "left of": "left_of",
    "right of": "right_of",
    "near": "near",
    "beside": "adjacent",
    "next to": "adjacent",
    "by": "near",
    "alongside": "adjacent",
    "far from": "far_from",
    "above": "above",
    "over": "above",
    "inside": "inside_of",
    "in": "inside_of",
    "within": "inside_of",
    "against": "adjacent",
    "around": "surround",
    "at": "near",
    "in the middle of": "center_of",
    "opposite": "near",
    "between": "between",
    "among": "near",
    "across": "near",
    "outside": "near",
    "along": "near",
    "close": "near",
}


_WALL_THINGS = lex.word_set("wall things")
_TABLE_KINDS = lex.word_set("table kinds")


def place(
    d: Discourse,
    things: list[str],
    others: list[str],
    prep: str,
    part: str = "",
    distance: Quantity | None = None,
) -> None:
    """Records where things are with respect to others."""
    kind = RELATION_PREPS.get(prep)
    if kind is None or not others:
        return
    if part:
        words = part.split()
        if (
            words[-1] in ("edge", "corner", "rim", "end")
            and "support" in entity_of(d, others[0]).noun.traits
        ):
            kind = "on"
        elif words[-1] in ("middle", "center", "centre"):
            kind = "center_of"
        elif words[-1] in ("side", "front", "back", "end", "left", "right") and kind in (
            "on",
            "near",
            "inside_of",
        ):
            kind = {"front": "in_front_of", "back": "behind"}.get(words[-1], "adjacent")
        elif words[-1] in ("bottom", "foot", "base") and kind != "on":
            kind = "near"
    other = others[0]
    many = len([t for t in things if t != other]) > 1
    if kind == "surround" and (not many or structural(d, other)):
        kind = "near"
    for t in things:
        if t == other or t not in d.world.entities:
            continue
        if structural(d, t):
            continue
        if kind_of(d, other) == "ceiling":
            if kind in ("on", "near", "adjacent", "under") and not towers(d, t):
                hang(d, t, other)
            continue
        if structural(d, other):
            if kind in ("on", "inside_of"):
                d.scene.marked[t] = other
            d.scene.relations.append(Relation(t, other, "structural", text=prep))
            continue
        if kind == "inside_of" and not holds(d, other):
            kind = "on" if "support" in entity_of(d, other).noun.traits else "near"
        if kind == "on" and kind_of(d, other) in ("ball", "billiard"):
            kind = "near"
        if towers(d, t) and kind in ("above", "on", "under"):
            continue  # "on the wall above the sofa": what hangs there is above, not the wall
        if kind == "on" and _wall_thing(d, t) and towers(d, other):
            hang(d, t, other)
            continue
        if kind == "surround":
            if _set_on(d, t, other):
                d.scene.supported_by.setdefault(t, other)
            d.scene.relations.append(Relation(t, other, "surround"))
            continue
        if kind == "between" and len(others) < 2 and len(things) >= 1:
            kind = "near"
        if kind == "between":
            d.scene.relations.append(Relation(t, others[0], "between", text=others[1]))
            continue
        if kind == "on":
            if t in d.scene.supported_by or _rests_on(d, other, t):
                continue
            d.scene.supported_by[t] = other
        elif kind == "inside_of":
            if t in d.scene.supported_by or _rests_on(d, other, t):
                continue
            d.scene.supported_by[t] = other
            d.scene.inside_of[t] = other
        d.scene.relations.append(Relation(t, other, kind, distance))


def hang(d: Discourse, thing: str, host: str) -> None:
    """Fixes a thing to a wall's face or below a ceiling."""
    kind = "attached_horizontal" if kind_of(d, host) == "ceiling" else "attached_vertical"
    d.scene.attached[thing] = host
    d.scene.relations.append(Relation(thing, host, kind))


def _wall_thing(d: Discourse, node: str) -> bool:
    """What "on the wall" hangs; anything else stands on top of it."""
    return kind_of(d, node) == "wallhung" or entity_of(d, node).noun.name in _WALL_THINGS


def _set_on(d: Discourse, thing: str, host: str) -> bool:
    """ "Plates around a table" are on it: small things of the table, not what stands around."""
    noun = entity_of(d, thing).noun
    if kind_of(d, host) != "table" or kind_of(d, thing) not in _TABLE_KINDS:
        return False
    table, size = entity_of(d, host).noun.dimensions_cm, noun.dimensions_cm
    return max(size[:2]) < 0.5 * min(table[:2]) and size[2] < 60.0


def towers(d: Discourse, node: str) -> bool:
    """Walls and buildings: fixed, and taller than things are stacked."""
    return kind_of(d, node) in ("wall", "building") and not movable(d, node)


def _rests_on(d: Discourse, a: str, b: str) -> bool:
    seen: set[str] = set()
    while a in d.scene.supported_by and a not in seen:
        seen.add(a)
        a = d.scene.supported_by[a]
        if a == b:
            return True
    return a == b


def holds(d: Discourse, node: str) -> bool:
    return bool({"container", "goal"} & entity_of(d, node).noun.traits)


def elevated(d: Discourse, node: str) -> bool:
    noun = entity_of(d, node).noun
    return not structural(d, node) and (
        "support" in noun.traits
        or noun.kind
        in (
            "box",
            "generic",
            "building",
            "wall",
            "plant",
            "block",
            "vehicle",
            "statue",
            "barrel",
            "appliance",
            "cart",
            "furniture",
            "seat",
        )
    )


def carries(d: Discourse, host: str, thing: str) -> bool:
    """Whether something lighter and smaller can have lain on it ("off a stepladder")."""
    if structural(d, host) or "round" in entity_of(d, host).noun.traits or host == thing:
        return False
    mine, other = entity_of(d, thing).noun, entity_of(d, host).noun
    return mine.mass_kg < 2.0 * other.mass_kg and other.kind not in ("region", "water", "hole")


def fits_on(d: Discourse, node: str, host: str) -> bool:
    """Whether something movable can share a table top or shelf."""
    top = entity_of(d, host).noun
    if "support" not in top.traits or "incline" in top.traits or not movable(d, node):
        return False
    if kind_of(d, node) in ("person", "vehicle") or structural(d, node):
        return False
    size = entity_of(d, node).dimensions_cm or entity_of(d, node).noun.dimensions_cm
    return max(size) <= 0.5 * max(top.dimensions_cm[:2])


def set_free(d: Discourse, nodes: list[str]) -> None:
    for node in nodes:
        if not structural(d, node):
            entity_of(d, node).freed = True


def enterable(d: Discourse, node: str) -> bool:
    noun = entity_of(d, node).noun
    return noun.kind in ("region", "goal", "hole", "hoop", "water") or "goal" in noun.traits
