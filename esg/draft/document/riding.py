"""Who rides is on what he rides, and held there: nobody stands beside the bicycle he rides."""

from __future__ import annotations

from collections import Counter
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.bearing import bears, comes_off
from esg.draft.discourse.jointed import articulation_of
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.scene import LIMBED, SPEEDS, Scene
from esg.graph.joints import FOOT, PILLION, SEAT
from esg.graph.models import EdgeEvent, Joint, NodeEvent

_RIDDEN = lex.word_set("straddled or stood on")
_RIDES = lex.word_set("rides")
_WALKS = lex.word_set("afoot (references)")
_GAITS = frozenset({"canter", "gallop", "trot"})
_VEHICLES = frozenset({"vehicle", "cart", "watercraft", "flyer"})
_MEETS = (NodeEvent.COLLISION, NodeEvent.MISS)
_DRIVERS = frozenset({"driver", "motorist", "chauffeur"})
_DRIVEN = (EdgeEvent.UNIFORM_MOTION, EdgeEvent.ACCELERATED_MOTION, EdgeEvent.TURN, EdgeEvent.BRAKE)
_GETS_OUT = re.compile(
    r"\b(?:gets?|got|steps?|stepped|climbs?|climbed|jumps?|jumped|hops?|leaps?|falls?|crawls?)\s+"
    r"(?:out|off)\b|\b(?:exits?|exited|alights?|alighted|ejected|thrown out)\b",
    re.IGNORECASE,
)
_OPEN = lex.word_set("open vehicles")
SEATED_CM = 110.0
"""Height of a vehicle in which somebody may sit out of sight [cm]."""
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
        if comes_off(scene, rider):
            continue
        _hand_over(scene, rider, mount)
        if rider not in scene.timeline.tracks:
            first = all(j.parent != mount for j in scene.joints)
            _hold(scene, rider, mount, SEAT if first else PILLION)
    _hold_borne(scene)


def _hold(scene: Scene, rider: str, mount: str, at: str | None) -> None:
    """Joins a rider's feet to what he rides, until a jolt throws him off.

    Args:
        scene: Places and motions of the prompt; changed in place.
        rider, mount: Who rides what.
        at: The mount there at which he is; None where the layout puts him.
    """
    mass = scene.world.entities[rider].noun.mass_kg
    scene.joints.append(seat(rider, mount, at, round(THROWN_OFF_MPS * mass, 1)))


def seat(rider: str, bearer: str, at: str | None, impulse: float) -> Joint:
    """What holds the foot of something to what it is on.

    Args:
        rider, bearer: Node ids.
        at: The mount of the bearer; None where the layout puts it.
        impulse: Which parts them [N s].
    """
    return Joint(
        id=f"{rider}_seat",
        kind="fixed",
        child=rider,
        child_mount=FOOT,
        parent=bearer,
        parent_mount=at,
        break_impulse=impulse,
    )


def _hold_borne(scene: Scene) -> None:
    """Lets who is on what turns, swings, drives or is towed keep hold of it.

    A swing has one place to sit; on a roundabout or a trailer it is the layout's to choose.
    """
    held = {j.child for j in scene.joints}
    for rider, bearer in scene.supported_by.items():
        if rider in held or rider in scene.timeline.tracks or comes_off(scene, rider):
            continue
        if bearer in scene.world.entities and _is_rider(scene, rider) and bears(scene, bearer):
            row = articulation_of(scene, scene.text, scene.world.entities[bearer])
            swings = row is not None and row.drawn is not None
            _hold(scene, rider, bearer, SEAT if swings else None)


def put_into_cars(scene: Scene) -> None:
    """Draws the vehicle of a driver who goes somewhere and has none: nobody swerves on foot.

    What he runs into, or gets by, is not his.

    Args:
        scene: Places and motions of the prompt; changed in place.
    """
    entities = scene.world.entities
    driven = {e.id for e in entities.values() if e.noun.kind in _VEHICLES}
    for e in [*entities.values()]:
        *before, last = e.head.split()
        if driven - _met(scene, e.id) or _afoot(scene, e.id):
            continue
        alone = e.noun.name == "person" and e.id not in scene.supported_by
        if not alone or not _goes(scene, e.id) or comes_off(scene, e.id):
            continue
        if last == "rider":
            _mount(scene, e)
        if last not in _DRIVERS:
            continue
        named = (" ".join(before[k:]) for k in range(len(before)))
        kinds = (lex.nouns()[name] for name in (*named, *e.adjectives) if name in lex.nouns())
        e.noun = next((n for n in kinds if n.kind == "vehicle"), lex.nouns()["car"])
        for k, x in enumerate(scene.timeline.edges):
            if x.actor == e.id and x.params.speed == SPEEDS["person"]:
                params = x.params.model_copy(update={"speed": SPEEDS["vehicle"]})
                scene.timeline.edges[k] = x.model_copy(update={"params": params})
        motion = scene.timeline.tracks[e.id].motion
        if motion is not None and motion.speed == SPEEDS["person"]:
            motion.speed = SPEEDS["vehicle"]


def _afoot(scene: Scene, driver: str) -> bool:
    """ "A driver walks past a bus": and who "runs into" one does not run."""
    told = [c.frame for c in scene.clauses if driver in c.movers]
    return any(f.verb.lemma in _WALKS and f.phrase("into") is None for f in told)


def _met(scene: Scene, driver: str) -> set[str]:
    """Whom somebody runs into or gets by."""
    met = (n.participants for n in scene.timeline.nodes if n.event in _MEETS)
    return {i for who in met if driver == who[0] for i in who[1:]}


def board(scene: Scene) -> None:
    """Leaves out who is in a closed vehicle all the time: behind its windows nobody is seen.

    Args:
        scene: Places and motions of the prompt; changed in place.
    """
    entities = scene.world.entities
    if _GETS_OUT.search(scene.text):
        return
    drives = Counter(v for who, v in scene.aboard.items() if who in scene.timeline.tracks)
    for who, vehicle in scene.aboard.items():
        if drives[vehicle] > 1:
            continue  # "two women in a van pass a bus"
        if who not in entities or vehicle not in entities or who in scene.supported_by:
            continue
        if entities[who].noun.kind != "person":
            continue  # a dog that drives is to be seen
        noun = entities[vehicle].noun
        closed = noun.kind in ("vehicle", "flyer") and noun.dimensions_cm[2] > SEATED_CM
        if not closed or noun.name in _RIDDEN | _OPEN or comes_off(scene, who):
            continue
        _hand_over(scene, who, vehicle)
        acts = who in scene.timeline.tracks
        if acts or any(who in n.participants for n in scene.timeline.nodes):
            continue
        label = entities.pop(who).label
        scene.relations = [r for r in scene.relations if who not in (r.source, r.target)]
        scene.warnings.append(f"The {label} is inside the {entities[vehicle].label}, out of sight.")


def _mount(scene: Scene, e: Entity) -> None:
    """A rider of whom nothing says what he rides: a horse where he gallops, else a motorcycle."""
    told = {c.frame.verb.lemma for c in scene.clauses if e.id in c.movers}
    on_a_horse = bool(told & _GAITS) or any(n.noun.kind == "animal" for n in _others(scene, e))
    e.noun = lex.nouns()["horse rider" if on_a_horse else "motorcyclist"]
    if not told & _GAITS:
        drawn = "a horse" if on_a_horse else "a motorcycle"
        scene.warnings.append(f'What "{e.head}" rides is not said: {drawn} is drawn.')


def _others(scene: Scene, e: Entity) -> list[Entity]:
    return [x for x in scene.world.entities.values() if x.id != e.id]


def _hand_over(scene: Scene, rider: str, mount: str) -> None:
    """Lets the mount do what is told of its rider: "a girl on a skateboard passes a bench"."""
    timeline = scene.timeline
    if mount in timeline.tracks or not _goes(scene, rider):
        return
    timeline.hand_over(rider, mount)
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
    return e is not None and e.noun.kind in LIMBED and not e.static


def _is_ridden(scene: Scene, node: str) -> bool:
    e = scene.world.entities.get(node)
    return e is not None and e.noun.name in _RIDDEN and not e.static


def _goes(scene: Scene, node: str) -> bool:
    """Whether something goes by itself on the ground, and is told to do nothing else."""
    track = scene.timeline.tracks.get(node)
    own = [x for x in scene.timeline.edges if x.actor == node]
    if track is None or any(x.event not in _DRIVEN for x in own):
        return False
    mode = "" if track.motion is None else track.motion.mode
    return mode in ("own", "turn", "brake") or (mode in ("", "coast") and bool(own))
