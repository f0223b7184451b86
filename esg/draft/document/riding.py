"""Who rides is on what he rides, and held there: nobody stands beside the bicycle he rides."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.scene import Scene
from esg.graph.joints import FOOT, SEAT
from esg.graph.models import Joint, NodeEvent

_RIDDEN = lex.word_set("straddled or stood on")
_RIDES = lex.word_set("rides")
_RIDERS = ("person", "animal", "robot")
_LEAVES = (NodeEvent.FALL, NodeEvent.JUMP, NodeEvent.TOPPLE)
THROWN_OFF_MPS = 3.0
"""A change of speed within a step that takes a rider off: of a jolt at twice a walker's pace.
Estimate of ours; nobody holds more than a few times his weight for so short a time."""


def seat_riders(scene: Scene) -> None:
    """Puts riders on what they ride and joins them to it, until a jolt throws them off.

    Args:
        scene: Places and motions of the prompt; changed in place.
    """
    for rider, mount in _rides(scene).items():
        scene.supported_by[rider] = mount
        pair = {rider, mount}
        scene.relations = [r for r in scene.relations if {r.source, r.target} != pair]
        e = scene.world.entities[rider]
        if e.noun.name in lex.word_set("riders drawn with what they ride"):
            e.noun = lex.nouns()["person"]
        if not _leaves(scene, rider):
            impulse = round(THROWN_OFF_MPS * e.noun.mass_kg, 1)
            scene.joints.append(
                Joint(
                    id=f"{rider}_seat",
                    kind="fixed",
                    child=rider,
                    child_mount=FOOT,
                    parent=mount,
                    parent_mount=SEAT,
                    break_impulse=impulse,
                )
            )


def _rides(scene: Scene) -> dict[str, str]:
    """Who rides what: told as where he is, or by a verb."""
    entities = scene.world.entities
    found = {
        rider: mount
        for rider, mount in scene.supported_by.items()
        if _is_rider(scene, rider) and _is_ridden(scene, mount)
    }
    for clause in scene.clauses:
        f = clause.frame
        riders = [] if f.subject is None else f.subject.entities
        mount = next((m for m in clause.movers if _is_ridden(scene, m)), None)
        if f.verb.lemma not in _RIDES or f.verb.passive or mount is None:
            continue
        for rider in riders:
            held = scene.supported_by.get(rider, mount) != mount or rider in scene.inside_of
            if rider in entities and _is_rider(scene, rider) and not held and rider != mount:
                found.setdefault(rider, mount)
    return found


def _is_rider(scene: Scene, node: str) -> bool:
    e = scene.world.entities.get(node)
    return e is not None and e.noun.kind in _RIDERS and not e.static


def _is_ridden(scene: Scene, node: str) -> bool:
    e = scene.world.entities.get(node)
    return e is not None and e.noun.name in _RIDDEN and not e.static


def _leaves(scene: Scene, rider: str) -> bool:
    """Whether he moves by himself, or comes off it, in the course of the scene."""
    told = any(x.actor == rider for x in scene.timeline.edges)
    return told or any(n.event in _LEAVES and rider in n.participants for n in scene.timeline.nodes)
