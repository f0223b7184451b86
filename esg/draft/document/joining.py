"""Jointed things: what a prompt names becomes one part, the part that it is joined to is added.

Which things, of what parts and how they move is `esg/lexicon/articulations.csv`.
"""

from __future__ import annotations

from dataclasses import replace
import math

from esg.draft import lexicon as lex
from esg.draft.discourse.jointed import articulation_of
from esg.draft.discourse.referents.entities import Entity, head_of
from esg.draft.discourse.referents.parts import parts_of
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.scene import Scene
from esg.graph.joints import FOOT
from esg.graph.models import EdgeEvent, Joint, NodeEvent
from esg.lexicon.articulations import Articulation

_OPEN = {"open": 1.0, "opened": 1.0, "wide-open": 1.0, "half-open": 0.5, "ajar": 0.25}
"""Share of how far a thing opens at which it starts, by what it is called."""

GIVES_WAY_MPS = 1e-3
"""Change of speed that a snapped rope still bears: far less than gravity's in a step."""
JOLT_MPS = 0.3
"""A change of speed within a step after which what sits on a seesaw is held by its weight alone."""
_MOTIONS = (EdgeEvent.DRIVE, EdgeEvent.RELEASE)


def join_parts(scene: Scene) -> list[str]:
    """Makes jointed things of a scene's doors, pendulums, drawers; one reason per part added.

    What hangs on something that the prompt names, what is a part of it ("the door of a car") and
    what something else enters stays as it is.
    """
    reasons: list[str] = []
    acting = {i for n in scene.timeline.nodes for i in n.participants}
    entered = {n.extra.get("region") for n in scene.timeline.nodes}
    for e in list(scene.world.entities.values()):
        row = articulation_of(scene, scene.text, e)
        fixed = e.id in scene.attached and e.id not in acting  # nothing happens to it
        if row is None or e.whole or fixed or f"{e.id}/inside" in entered:
            continue
        ratio = _become(e, row.becomes)
        if e.id in scene.attached:
            held = _joint(scene, row, e, scene.world.entities[scene.attached[e.id]], 1, ratio)
            scene.joints.append(held.model_copy(update={"parent_mount": None}))
            continue
        added = _served(scene, row, e)
        for _ in range(row.count - len(added)):
            noun = lex.part(row.with_part)
            part = add_entity(scene.world, noun, noun.name, mentioned=False)
            reasons.append(f"{noun.name} added: {e.label} is joined to it")
            added.append(part)
        for n, part in enumerate(added, start=1):
            part.dimensions_cm = [
                d * r for d, r in zip(part.noun.dimensions_cm, ratio, strict=True)
            ]
            part.implied = not part.mentioned
            for places in (scene.supported_by, scene.inside_of, scene.marked):
                if places.get(e.id) == part.id:
                    del places[e.id]  # "a pendulum on a stand" hangs there
                elif e.id in places:
                    places.setdefault(part.id, places[e.id])
            scene.joints.append(_joint(scene, row, e, part, n, ratio))
        if row.carries == "becomes":
            _hand_over(scene, e.id, added[0].id)
    _seat_on_seesaws(scene)
    return reasons


def _seat_on_seesaws(scene: Scene) -> None:
    """Holds what sits on the low end of a tipped seesaw there until the board jolts it."""
    for node, board in scene.supported_by.items():
        row = articulation_of(scene, scene.text, scene.world.entities[board])
        if row is None or not row.tips or not scene.openings.get(board):
            continue
        e = scene.world.entities[node]
        mass = e.mass_kg or e.noun.mass_kg
        scene.joints.append(
            Joint(
                id=f"{node}_seat",
                kind="fixed",
                child=node,
                child_mount=FOOT,
                parent=board,
                parent_mount="front end",
                break_impulse=round(JOLT_MPS * mass, 4),
            )
        )


def _hand_over(scene: Scene, named: str, part: str) -> None:
    """Lets the part that turns do what is told of the whole: a chest opens, a cradle swings."""
    timeline = scene.timeline
    if not any(x.actor == named and x.event in _MOTIONS for x in timeline.edges):
        return
    timeline.tracks[part] = timeline.tracks.pop(named)
    timeline.edges[:] = [
        x.model_copy(update={"actor": part}) if x.actor == named else x for x in timeline.edges
    ]
    for node in timeline.nodes:
        node.participants = tuple(part if p == named else p for p in node.participants)


def _become(e: Entity, name: str) -> list[float]:
    """Makes a part of an entity; returns its size over that part's usual one, by axis."""
    usual, part = e.noun.dimensions_cm, lex.part(name)
    if e.dimensions_cm is not None:
        told = zip(e.dimensions_cm, usual, part.dimensions_cm, strict=True)
        e.dimensions_cm = [d / was * now for d, was, now in told]
    kept = e.noun.traits - {"fixed", "structural"}
    e.noun = replace(
        part,
        kind=e.noun.kind,
        material=e.noun.material,
        shape=e.noun.shape,
        traits=kept | part.traits,
    )
    e.part = True
    return [d / u for d, u in zip(dimensions_of(e), part.dimensions_cm, strict=True)]


def _served(scene: Scene, row: Articulation, named: Entity) -> list[Entity]:
    """What of the prompt serves as the other part, made that; empty if there is nothing."""
    parts = parts_of(scene.world, named)
    for part in parts:
        _become(part, row.with_part)
        part.group = part.pattern = None
        _not_placed(scene, part.id)
    if parts:
        return parts
    taken = {name for j in scene.joints for name in (j.child, j.parent)}
    for e in scene.world.entities.values():
        if head_of(e) in row.serves and e.id not in taken and row.count == 1:
            _become(e, row.with_part)
            return [e]
    return []


def _not_placed(scene: Scene, node: str) -> None:
    """Forgets where a part is said to be: its joint says so."""
    scene.relations = [r for r in scene.relations if node not in (r.source, r.target)]
    for places in (scene.supported_by, scene.inside_of, scene.marked):
        places.pop(node, None)


def _joint(
    scene: Scene, row: Articulation, named: Entity, added: Entity, n: int, ratio: list[float]
) -> Joint:
    parent, child = (named, added) if row.carries == "becomes" else (added, named)
    size = math.prod(ratio) ** (1.0 / 3.0)
    turns = row.kind in ("hinge", "ball")
    long = 1.0 if turns else size
    words = (*named.adjectives, *named.head.lower().split())
    start = max((_OPEN.get(a, 0.0) for a in words), default=0.0)
    start = (row.opened or 0.0) * start or row.start

    # of several, the first is let go and meets the others, unless the prompt says which
    opening = scene.openings.get(named.id, start) if n == 1 else row.start
    opening = scene.openings.get(added.id, opening)

    # what hangs and falls: whatever held it gives way under its weight as the scene starts
    comes_down = row.hangs or (row.kind == "rope" and row.carries == "with")
    falls = comes_down and any(
        n.event is NodeEvent.FALL and child.id in n.participants for n in scene.timeline.nodes
    )
    gives_way = GIVES_WAY_MPS * (child.mass_kg or child.noun.mass_kg)

    def sized(value: float | None) -> float | None:
        return None if value is None else round(value * long, 3)

    return Joint(
        id=f"{child.id}_{row.kind}",
        kind=row.kind,
        child=child.id,
        child_mount=row.child_mount,
        parent=parent.id,
        parent_mount=row.parent_mount.format(n=n),
        lower=sized(row.lower),
        upper=sized(row.upper),
        position=opening if row.kind == "rope" else sized(opening) or 0.0,
        stiffness=row.stiffness,
        damping=_grown(row.damping, size ** (5 if turns else 3)),
        friction=_grown(row.friction, size ** (4 if turns else 3)),
        break_impulse=float(f"{gives_way:.6g}") if falls else None,
    )


def _grown(value: float | None, factor: float) -> float | None:
    """What resists a thing of another size: friction as its weight grows, damping its inertia."""
    return None if value is None else float(f"{value * factor:.6g}")
