"""Where things are with respect to each other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, movable, structural
from esg.draft.discourse.jointed import behind_doors, has_a_door, is_flap
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import Entity, is_toy
from esg.draft.discourse.referents.record import links
from esg.draft.discourse.referents.wholes import has_pans, tips
from esg.draft.discourse.scene import LIMBED, Relation
from esg.graph.models import Quantity

_PREPS = {
    "on": "on onto upon atop",
    "under": "under beneath below underneath",
    "near": "near by at opposite among across outside along close",
    "adjacent": "beside alongside against",
    "above": "above over",
    "inside_of": "inside in within",
    "behind": "behind",
    "surround": "around",
    "between": "between",
}
RELATION_PREPS: dict[str, str] = {p: k for k, words in _PREPS.items() for p in words.split()} | {
    "in front of": "in_front_of", "left of": "left_of", "right of": "right_of",
    "next to": "adjacent", "far from": "far_from", "in the middle of": "center_of",
}  # fmt: skip
"""Spatial relations by preposition."""
_ENDS = ("end", "side")
_LEVEL = frozenset({"adjacent", "near", "left_of", "right_of", "in_front_of", "behind", "between"})
"""Relations of things at one height."""
_RAISED_CM = 20.0
TOPS = lex.word_set("tops of slopes")
"""Parts of a slope from which things come down it."""
_HANDS = {"left side": "left_of", "right side": "right_of"}
"""Sides of a thing that are the viewer's."""
_AFLOAT = lex.word_set("afloat")
_OPEN = frozenset({"watercraft", "cart", "sliding"})
"""Kinds of what is ridden in, and has no roof."""
_CARRIES_ON_ITS_BACK = frozenset({"animal", "vehicle", "cart"})
_RAISED = lex.word_set("raised kinds")
_CLIMBED = lex.word_set("climbed")
_WALL_THINGS = lex.word_set("wall things")


_MOUNTS = frozenset({"animal", "sliding", "toyvehicle", "vehicle"})
"""Kinds of what each of several riders has one of."""


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
    if kind is None or not others or d.scene.links & {*things, *others}:
        return
    if prep == "on" and len(things) == len(others) > 1 and kind_of(d, others[0]) in _MOUNTS:
        for thing, mount in zip(things, others, strict=True):  # "two people on bicycles"
            place(d, [thing], [mount], prep, part)
        return
    if prep in ("in", "inside") and kind_of(d, others[0]) in ("vehicle", "flyer"):
        d.scene.aboard.update((t, others[0]) for t in things if kind_of(d, t) == "person")
    carried = d.scene.supported_by  # "left of them" is beside the lower one of two
    other = next((o for o in others if carried.get(o) not in others), others[0])
    end = kind == "on" and bool(part) and part.split()[-1] in _ENDS
    if (end and tips(entity_of(d, other))) or has_pans(entity_of(d, other), part):
        _seat(d, things, other)
        return
    if part:
        kind = _at_part(d, kind, part, other)
    kind = _as_many(kind, things, others, other)
    text = others[1] if kind == "between" else ""
    stated = distance if kind not in ("between", "surround") else None
    for t in things:
        if t == other or t not in d.world.entities or structural(d, t):
            continue
        if structural(d, other):
            _lay_on_the_floor(d, t, other, kind, prep)
            continue
        if kind == "under" and is_flap(d.scene, d.text, t):
            d.scene.supported_by.setdefault(other, t)  # "a trapdoor opens under a crate"
        kind = _holding(d, kind, t, other)
        if _settles(d, t, other, kind):
            d.scene.relations.append(Relation(t, other, kind, stated, text))


def at_the_wheel(d: Discourse, who: list[str], vehicle: str) -> None:
    """Puts who drives or parks a vehicle beside it, and aboard if it is no toy."""
    place(d, who, [vehicle], "near")
    if not is_toy(entity_of(d, vehicle)):
        d.scene.aboard.update((i, vehicle) for i in who)


def _seat(d: Discourse, things: list[str], other: str) -> None:
    """ "Two children sit on the ends of a seesaw": it carries them there."""
    seated = [t for t in things if t in d.world.entities and t not in d.scene.supported_by]
    d.scene.supported_by.update(dict.fromkeys(seated, other))
    d.scene.at_ends += seated


def _as_many(kind: str, things: list[str], others: list[str], other: str) -> str:
    """What one thing, or a single other, leaves of "around" and "between"."""
    several = len([t for t in things if t != other]) > 1
    if (kind == "surround" and not several) or (kind == "between" and len(others) < 2):
        return "near"
    return kind


def _lay_on_the_floor(d: Discourse, thing: str, floor: str, kind: str, prep: str) -> None:
    """Where something is on what everything stands on: a road, a lane, the ground."""
    if kind in ("on", "inside_of", "center_of"):
        d.scene.marked[thing] = floor
    d.scene.relations.append(Relation(thing, floor, "structural", text=prep))


def _settles(d: Discourse, thing: str, other: str, kind: str) -> bool:
    """Notes what carries, holds or hangs a thing; whether a relation to it is left to tell."""
    if towers(d, thing) and kind in ("above", "on", "under"):
        return False  # "on the wall above the sofa": what hangs there is above, not the wall
    if kind == "on" and _wall_thing(d, thing) and towers(d, other):
        hang(d, thing, other)
        return False
    if kind == "center_of" and elevated(d, other) and fits_on(d, thing, other):
        d.scene.supported_by.setdefault(thing, other)  # "in the middle of a table"
    if kind not in ("on", "inside_of"):
        return True
    if thing in d.scene.supported_by or _rests_on(d, other, thing):
        return False
    d.scene.supported_by[thing] = other
    d.scene.relations = [  # "a cart with a box in it"
        r for r in d.scene.relations if (r.source, r.target, r.kind) != (thing, other, "near")
    ]
    if kind == "inside_of":
        d.scene.inside_of[thing] = other
    return True


def share_tops(d: Discourse) -> None:
    """ "A cup stands on a table. A plate lies next to it": on the table, too, if it fits there.

    So does what something on a table stands between; what is told to be on the ground stays there.
    """
    scene = d.scene
    grounded = {r.source for r in scene.relations if r.kind == "structural"}
    taken = grounded | {*scene.attached, *scene.hung, *scene.inside_of, *d.timeline.tracks}
    for r in [*scene.relations]:
        if r.kind not in _LEVEL:
            continue
        others = [r.target, r.text] if r.kind == "between" else [r.target]
        mates = [m for o in others for m in d.world.groups.get(_group(d, o), [o])]
        near = [i for i in (r.source, *mates) if i in d.world.entities]
        near = [i for i in near if kind_of(d, i) not in LIMBED and not links(d.world, [i])]
        hosts = [scene.supported_by[i] for i in near if i in scene.supported_by]
        host = next((h for h in hosts if h not in near and raised(d, h)), None)
        for i in near if host is not None and {*hosts} == {host} else []:
            if host is not None and i not in taken | {*scene.supported_by} and fits_on(d, i, host):
                place(d, [i], [host], "on")


def raised(d: Discourse, host: str) -> bool:
    """Whether a thing has a top over the floor: a table, and no rug."""
    e = entity_of(d, host)
    height = (e.dimensions_cm or e.noun.dimensions_cm)[2]
    return elevated(d, host) and height >= _RAISED_CM


def _group(d: Discourse, node: str) -> str:
    """The plural that a thing is of; "" for none."""
    return (d.world.entities[node].group or "") if node in d.world.entities else ""


def _at_part(d: Discourse, kind: str, part: str, other: str) -> str:
    """The relation to a thing of what is at one of its parts ("at the edge of the table")."""
    word, side = part.split()[-1], _HANDS.get(part, "")
    if word in TOPS and kind in ("on", "near") and "incline" in entity_of(d, other).noun.traits:
        return "on"  # "at the top of a ramp"
    sided = part in ("left side", "right side", "front side", "back side")
    if sided and kind == "on" and "support" in entity_of(d, other).noun.traits:
        return "on" if not structural(d, other) else kind  # "on the left side of a table"
    if side and "support" not in entity_of(d, other).noun.traits:
        return side if kind in ("on", "near") else kind  # "on the right side of a laptop"
    if word in ("edge", "corner", "rim", "end") and "support" in entity_of(d, other).noun.traits:
        return "on"
    if word == "back" and kind == "on" and kind_of(d, other) in _CARRIES_ON_ITS_BACK:
        return "on"  # "a monkey on the back of an elephant"
    if word in ("side", "front", "back", "end", "left", "right"):
        beside = {"front": "in_front_of", "back": "behind"}.get(word, "adjacent")
        return beside if kind in ("on", "near", "inside_of") else kind
    return "near" if word in ("bottom", "foot", "base") and kind != "on" else kind


def _holding(d: Discourse, kind: str, thing: str, other: str) -> str:
    """ "In" what holds nothing is on it or near it, and nothing stays on a ball."""
    if kind == "inside_of" and other in behind_doors(d.scene, d.text):
        return kind
    if kind == "inside_of" and not holds(d, other):
        if has_a_door(entity_of(d, other)):
            d.scene.shut_in[thing] = other
        loaded = kind_of(d, thing) in LIMBED or (movable(d, thing) and carries(d, other, thing))
        if kind_of(d, other) in _OPEN and loaded:
            return "on"  # "in a boat", "in a cart"
        kind = "on" if "support" in entity_of(d, other).noun.traits else "near"
    return "near" if kind == "on" and kind_of(d, other) in ("ball", "billiard") else kind


def hang(d: Discourse, thing: str, host: str) -> None:
    """Fixes a thing to a wall's face or below a ceiling."""
    kind = "attached_horizontal" if kind_of(d, host) == "ceiling" else "attached_vertical"
    d.scene.attached[thing] = host
    d.scene.relations.append(Relation(thing, host, kind))


def _wall_thing(d: Discourse, node: str) -> bool:
    """What "on the wall" hangs; anything else stands on top of it."""
    return kind_of(d, node) == "wallhung" or entity_of(d, node).noun.name in _WALL_THINGS


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
    raised = noun.kind in _RAISED or noun.name in _CLIMBED
    return not structural(d, node) and ("support" in noun.traits or raised)


def carries(d: Discourse, host: str, thing: str) -> bool:
    """Whether something lighter and smaller can have lain on it ("off a stepladder")."""
    if structural(d, host) or "round" in entity_of(d, host).noun.traits or host == thing:
        return False
    mine, other = entity_of(d, thing).noun, entity_of(d, host).noun
    if other.kind == "water":
        return mine.kind == "watercraft" or entity_of(d, thing).head in _AFLOAT
    return mine.mass_kg < 2.0 * other.mass_kg and other.kind not in ("region", "hole")


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


def told_by_side(entities: Mapping[str, Entity]) -> Iterator[tuple[str, str]]:
    """Two of a kind that are told from each other by their sides: "the left plate, the right one".

    Args:
        entities: Things by node.

    Yields:
        The nodes of the one on the left and of the one on the right.
    """
    told = {side: [e for e in entities.values() if e.label.startswith(f"{side} ")]
            for side in ("left", "right")}  # fmt: skip
    for one in told["left"]:
        fellows = [e for e in told["right"] if e.head == one.head]
        if len(fellows) == 1 and not one.part and "structural" not in one.noun.traits:
            yield one.id, fellows[0].id
