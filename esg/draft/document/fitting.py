"""Sizes of what is told to lie in a vessel, or under one, and of rocks to stand on: they fit.

A ball, a box and a block come in any size, so that one which no number is told of is as small as
the cup that holds or covers it asks for. So does a rock, which is as large as whoever stands or
leaps on it needs, and a tree's trunk as long as who climbs it asks for. All else keeps the size of
its kind.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
import math
import re

from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.sizes import dimensions_of, grows
from esg.draft.discourse.scene import LIVING, Scene

_ANY_SIZE = frozenset({"ball", "box", "block"})
"""Kinds of things that come in any size."""
_LIES_IN = 1.5
"""Width of a box over the diagonal of whom it holds, at least."""
_FREE = 0.6
"""Share of a vessel's width that what lies in it or under it takes up at most."""
_FULL = 0.8
"""Share of a vessel's width up to which a thing fits as it is."""
_CROWN = 0.55
"""Share of a rock's length that its flat crown has (`rock` of the parametric library)."""
_STANDS = 0.75
"""Share of its length that an animal's feet take up."""
_TRUNK = 0.4
"""Share of a tree's height that is bare trunk."""
_TRUNKS, _ROOM_CM, _TALLEST_CM = 2.6, 80.0, 1100.0
"""Trunk that who climbs it needs: so many times its longest side, and as much; no taller tree."""
_OVER = re.compile(r"\bover an? |\bover the ", re.IGNORECASE)
"""Says that a vessel covers a thing, which "above" does not."""


def fit(scene: Scene, leapt_on: Mapping[str, str], climbed: Mapping[str, str]) -> None:
    """Makes what vessels hold or cover small enough, and rocks large enough to stand on.

    Args:
        scene: Everything that has been read; sizes of its things are changed where they are free.
        leapt_on: Who leaps on what, or climbs onto it, by node.
        climbed: Who climbs up or down what, by node.
    """
    _fit_rocks(scene, leapt_on)
    _fit_trees(scene, climbed)
    for body, vessel, covered in _held(scene):
        if body.noun.kind in LIVING and not covered and grows(vessel):
            room = dimensions_of(vessel)
            need = _LIES_IN * math.hypot(*dimensions_of(body)[:2])
            wide = [max(x, need) for x in room[:2]]
            vessel.dimensions_cm = [*wide, room[2]]
        free = body.noun.kind in _ANY_SIZE and not body.dimensions_prescribed
        stacked = body.noun.name == vessel.noun.name  # crates of a stack
        lid = covered and vessel.noun.kind in _ANY_SIZE
        if not free or stacked or lid or "container" not in vessel.noun.traits:
            continue
        mine, room = dimensions_of(body), dimensions_of(vessel)
        factor = _FREE * min(room[:2]) / max(mine[:2])
        if covered:
            factor = min(factor, _FREE * room[2] / mine[2])
        if factor < _FREE / _FULL:
            body.dimensions_cm = [factor * x for x in mine]


def _fit_rocks(scene: Scene, leapt_on: Mapping[str, str]) -> None:
    things = scene.world.entities
    for body, host in (*scene.supported_by.items(), *leapt_on.items()):
        who, rock = things.get(body), things.get(host)
        if who is None or rock is None or rock.noun.kind != "rock" or rock.dimensions_prescribed:
            continue
        if who.noun.kind in LIVING:
            mine, room = dimensions_of(who), dimensions_of(rock)
            factor = _STANDS * max(mine[:2]) / (_CROWN * room[0])
            if factor > 1.0:
                rock.dimensions_cm = [factor * x for x in room]


def _fit_trees(scene: Scene, climbed: Mapping[str, str]) -> None:
    """A tree that somebody climbs has so long a trunk."""
    things = scene.world.entities
    for body, host in climbed.items():
        who, tree = things.get(body), things.get(host)
        if who is None or tree is None or tree.noun.name != "tree" or tree.dimensions_prescribed:
            continue
        room = dimensions_of(tree)
        high = (_TRUNKS * max(dimensions_of(who)) + _ROOM_CM) / _TRUNK
        factor = min(high, _TALLEST_CM) / room[2]
        if factor > 1.0:
            tree.dimensions_cm = [factor * x for x in room]


def _held(scene: Scene) -> Iterator[tuple[Entity, Entity, bool]]:
    """A thing, the vessel that holds or covers it, and whether that covers it."""
    things = scene.world.entities
    pairs = [(body, host, False) for body, host in scene.inside_of.items()]
    for r in scene.relations:
        if r.kind == "under":
            pairs.append((r.source, r.target, True))
        if r.kind == "above" and _OVER.search(scene.text):
            pairs.append((r.target, r.source, True))
    for body, host, covered in pairs:
        if body in things and host in things:
            yield things[body], things[host], covered
