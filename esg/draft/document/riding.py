"""Who rides is on what he rides, and held there: nobody stands beside the bicycle he rides."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.scene import Scene
from esg.graph.joints import FOOT, SEAT
from esg.graph.models import EdgeEvent, Joint, NodeEvent

_RIDDEN = lex.word_set("straddled or stood on")
_RIDES = lex.word_set("rides")
_RIDERS = ("person", "animal", "robot")
_DRIVEN = (EdgeEvent.UNIFORM_MOTION, EdgeEvent.ACCELERATED_MOTION, EdgeEvent.TURN, EdgeEvent.BRAKE)
_LEAVES = (NodeEvent.FALL, NodeEvent.JUMP, NodeEvent.TOPPLE)
"""Events of a rider after which he is not on it."""
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
        if _comes_off(scene, rider):
            continue
        _hand_over(scene, rider, mount)
        if all(x.actor != rider for x in scene.timeline.edges):
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


def _hand_over(scene: Scene, rider: str, mount: str) -> None:
    """Lets the mount do what is told of its rider: "a girl on a skateboard passes a bench"."""
    timeline = scene.timeline
    own = [x for x in timeline.edges if x.actor == rider]
    if not own or mount in timeline.tracks or any(x.event not in _DRIVEN for x in own):
        return
    if rider not in timeline.tracks:
        return
    timeline.tracks[mount] = timeline.tracks.pop(rider)
    timeline.edges[:] = [
        x.model_copy(update={"actor": mount}) if x.actor == rider else x for x in timeline.edges
    ]
    for node in timeline.nodes:
        node.participants = tuple(mount if p == rider else p for p in node.participants)
    for clause in scene.clauses:
        clause.movers[:] = [mount if m == rider else m for m in clause.movers]


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


def _comes_off(scene: Scene, rider: str) -> bool:
    """Whether he leaves what he rides in the course of the scene."""
    return any(n.event in _LEAVES and rider in n.participants for n in scene.timeline.nodes)
