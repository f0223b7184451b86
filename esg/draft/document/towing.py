"""What is drawn along: a trailer on its hitch, a log on a rope."""

from __future__ import annotations

from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.scene import Scene
from esg.graph.joints import FRONT, HITCH_CM, REAR, hitch_cm
from esg.graph.models import Joint

_STIFF = frozenset({"coupler", "coupling", "drawbar", "hitch", "towbar"})
"""Of the links those that are no rope."""
ROPE_CM = (20.0, 400.0)
"""Length of a rope: tow ropes for cars are sold at 4 m, what is smaller has one of its length."""
HELD = 0.6
"""Length of what a person draws a wagon by, over his height: a handle of 1 m."""
SNAPS_MPS2 = 0.8
"""A rope that is to snap bears what draws a thing along and speeds it up no faster than this."""
ROLLS_MPS2, SLIDES_MPS2 = 2.2, 6.0
"""What slows a thing down that is let go: on wheels as scenes have them (a trailer stands after
4.6 s from 10 m/s), or rubbed by the ground with a friction of 0.6."""
HITCH_DEG = 60.0
"""A trailer turns so far to both sides of what draws it (ISO 1103: 60 degrees)."""


def tie_tows(scene: Scene) -> None:
    """Joins what is drawn along to what draws it; ropes that the prompt names become joints.

    Args:
        scene: With its tows; changed in place.
    """
    entities = scene.world.entities
    for node, tow in scene.tows.items():
        drawn, draws = entities.get(node), entities.get(tow.by)
        if drawn is None or draws is None:
            continue
        for places in (scene.supported_by, scene.marked):
            if places.get(node) == tow.by:
                del places[node]
        stiff = tow.link in entities and entities[tow.link].head in _STIFF
        by_hand = draws.noun.kind == "person"
        rope = (bool(tow.link) and not stiff) or by_hand or not _couples(drawn, draws)
        loosed = node in scene.loosed
        turns = None if rope or loosed else HITCH_DEG  # what may break is held by ties alone
        joint = Joint(
            id=f"{node}_{'rope' if rope else 'hitch'}",
            kind="rope" if rope else "hinge",
            child=node,
            child_mount=FRONT,
            parent=tow.by,
            parent_mount=REAR,
            lower=None if turns is None else -turns,
            upper=_rope_cm(draws) if rope else turns,
            break_impulse=_gives_way(drawn) if loosed else None,
        )
        scene.joints.append(joint)
    for link in scene.links:
        entities.pop(link, None)


def _rope_cm(draws: Entity) -> float:
    """Length of a rope to what draws; a person holds one that reaches down from his hand [cm]."""
    length, _, height = dimensions_of(draws)
    low, high = ROPE_CM
    return min(max(length, height * (draws.noun.kind == "person") * HELD, low), high)


def _gives_way(drawn: Entity) -> float:
    """What breaks a joint within 1/60 s: the pull of who draws and speeds up, no even one [N s]."""
    rolls = {"wheeled", "round"} & drawn.noun.traits
    pull = SNAPS_MPS2 + (ROLLS_MPS2 if rolls else SLIDES_MPS2)
    return float(f"{(drawn.mass_kg or drawn.noun.mass_kg) * pull / 60.0:.6g}")


def _couples(drawn: Entity, draws: Entity) -> bool:
    """Whether both are high enough for a coupling, and what is drawn goes on wheels."""
    heights = (hitch_cm(dimensions_of(e)[2]) for e in (drawn, draws))
    return "wheeled" in drawn.noun.traits and all(h >= HITCH_CM for h in heights)
