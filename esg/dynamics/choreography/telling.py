"""Choreography: where the participants of a timeline start, and with which nominal parameters.

Before anything is simulated, the story is told once with closed-form kinematics in a frame of its
own: an actor runs along its path, meets its target after a plausible (or prescribed) time, sets it
in motion, and the next target is put where the motion leads. The result is a set of constellations
for the layout stage and a nominal value for every control parameter, where the search starts. It is
told when the scene is cast; the document keeps it (`record`), and it is read from then on.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from esg.dynamics.choreography.courses.from_sides import go_from_side_to_side
from esg.dynamics.choreography.courses.passages import lead_through, let_go_down, ways_through
from esg.dynamics.choreography.courses.tops import reaches
from esg.dynamics.choreography.falling.throws import stand_behind
from esg.dynamics.choreography.handling import bounced, jumped, spun, taken, tell_guided
from esg.dynamics.choreography.meetings import collision, enters
from esg.dynamics.choreography.moves import controlled, plain, shattered, turned
from esg.dynamics.choreography.parts import carried_along, to_its_part
from esg.dynamics.choreography.placing import enter_beside
from esg.dynamics.choreography.pockets import play_pocket, pocket_event
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.choreography.swings import moved_by_joint, swung
from esg.dynamics.choreography.ways import (
    crossing_together,
    pairs_passed,
    place_by_the_way,
    state_course,
    ways_stated,
)
from esg.dynamics.story.stagecraft import fit_to_surface
from esg.dynamics.story.story import Story, read_story
from esg.graph import models
from esg.graph.canonical import entropy
from esg.graph.casting import effective
from esg.graph.models import EsgDocument, NodeEvent, TimelineNode
from esg.layout.problem.hints import Constellation, StartHints, stored_hints

HANDLERS = {
    NodeEvent.TRIGGER: controlled,
    NodeEvent.HEADING_REACHED: turned,
    NodeEvent.COLLISION: collision,
    NodeEvent.REACH: collision,
    NodeEvent.MISS: collision,
    NodeEvent.ENTER_REGION: enters,
    NodeEvent.PICKED_UP: taken,
    NodeEvent.PLACED: taken,
    NodeEvent.BOUNCE: bounced,
    NodeEvent.JUMP: jumped,
    NodeEvent.SPIN: spun,
    NodeEvent.SWING: swung,
    NodeEvent.OPEN: moved_by_joint,
    NodeEvent.CLOSE: moved_by_joint,
    NodeEvent.BREAK: shattered,
}
"""How each event is told; all others are told by `plain`."""
ATTEMPTS = 12
"""How often a choreography that does not fit on its table is told again with less room."""


@dataclass(frozen=True)
class Choreography:
    """Start hints (none for static scenes) and nominal parameters ("edge id/speed" -> SI value)."""

    hints: StartHints
    nominal: dict[str, float]


def choreograph(doc: EsgDocument, *, seed: int = 0) -> Choreography:
    """Tells the story once in closed form.

    Args:
        doc: A document with assets resolved.
        seed: Varies approach distances, lateral offsets and times.
    """
    story = read_story(doc)
    rng = np.random.default_rng([seed, entropy(doc)])
    constellations: list[Constellation] = []
    nominal: dict[str, float] = {}
    told: dict[str, float] = tell_guided(story, {})
    components = _in_order(story, _components(doc, story))
    for component, lane in zip(components, _lanes(doc, story, components), strict=True):
        stage = _play(Stage(doc, story, component, rng.spawn(1)[0], elsewhere=dict(told)), lane)
        told.update(stage.time)
        constellations.append(stage.constellation())
        nominal.update(stage.nominal)
        nominal.update({f"{k}/event_time": t for k, t in stage.time.items()})
    guided = tell_guided(story, told)
    nominal.update({f"{k}/event_time": t for k, t in guided.items()})
    return Choreography(StartHints(tuple(c for c in constellations if c.placements)), nominal)


def _components(doc: EsgDocument, story: Story) -> list[set[str]]:
    """Sets of objects whose motions touch each other."""
    groups: list[set[str]] = []
    # What is carried starts where it stands and ends where that leads; nothing is placed for it.
    carried = {a for a in story.phases if story.guided(a)}
    links = [
        set(n.participants) | _region_parent(n)
        for n in story.nodes.values()
        if not carried & set(n.participants)
    ]
    links += [{c.object, c.to} for n in story.nodes.values() for c in n.constraints if c.to]
    links += [
        {e.edge.actor, *([e.edge.target] if e.edge.target else [])}
        for a, p in story.phases.items()
        for e in p
        if a not in carried
    ]
    links += [{s.object[0], s.target[0]} for s in ways_stated(doc, story)]
    links += [{s.object[0], *s.target} for s in pairs_passed(doc, story)]
    links += crossing_together(doc)
    links += [{s.object[0], passage.owner} for s, passage in ways_through(doc, story)]
    for link in [s for s in links if s]:
        touching = [g for g in groups if g & link]
        merged = link.union(*touching)
        groups = [g for g in groups if g not in touching] + [merged]
    return [g for g in groups if any(story.is_active(n) for n in g)]


def _in_order(story: Story, components: list[set[str]]) -> list[set[str]]:
    """The components so that one whose events are timed from those of another comes after it."""
    done: list[set[str]] = []
    pending = list(components)
    while pending:
        ready = [c for c in pending if not _waits_for(story, c, pending)]
        done.append((ready or pending)[0])
        pending.remove(done[-1])
    return done


def _waits_for(story: Story, component: set[str], pending: list[set[str]]) -> bool:
    """Whether an event of a component is timed from one of a component that is still pending."""
    for node in story.nodes.values():
        if not set(node.participants) & component:
            continue
        for c in node.constraints:
            since = set(story.nodes[c.since].participants) if c.since in story.nodes else set()
            if since and not since & component and any(since & p for p in pending):
                return True
    return False


def _region_parent(node: TimelineNode) -> set[str]:
    return {node.region.split("/")[0]} if node.region else set()


def _play(stage: Stage, lane: tuple[int, int] = (0, 1)) -> Stage:
    """Tells a component's story; on a table, in ever less room until it fits.

    What fits nowhere is left to the layout: the stage that is returned is then empty.
    """
    pocket = pocket_event(stage)
    if pocket is not None:
        play_pocket(stage, pocket)
        return stage
    for _ in range(ATTEMPTS):
        _tell(stage)
        if stage.anchor is not None and stage.leaves_its_support():
            if stage.start_at_edge(lane):
                break
        elif stage.anchor is None:
            break
        else:
            reached, before = _reached(stage), dict(stage.places)
            if fit_to_surface(stage.doc, stage.anchor, stage.places, reached, lane):
                if lane == (0, 1):
                    to_its_part(stage, carried_along(reached, before, stage.places))
                break
        stage = stage.tighter()
    if stage.anchor is None:
        stand_behind(stage)
    return stage


def _reached(stage: Stage) -> list[tuple[str, float, float, float]]:
    """Where those get that stay on their table: key, x, y [m], heading [rad]."""
    actors = [actor for actor in stage.tracks if actor in stage.places]
    return [(actor, *p) for actor in actors for p in reaches(stage, actor)]


def _lanes(doc: EsgDocument, story: Story, components: list[set[str]]) -> list[tuple[int, int]]:
    """Which lane each component takes on its table, of how many, for those that share one."""
    rng = np.random.default_rng(0)
    anchors = [Stage(doc, story, c, rng).anchor for c in components]
    shares = [a is not None and anchors.count(a) > 1 for a in anchors]
    return [
        (anchors[:k].count(a), anchors.count(a)) if shared else (0, 1)
        for k, (a, shared) in enumerate(zip(anchors, shares, strict=True))
    ]


def _tell(stage: Stage) -> None:
    for node in stage.story.nodes.values():
        if node.event is NodeEvent.SCENE_START:
            stage.time[node.id] = 0.0
        elif stage.concerns(node) or _region_parent(node) & stage.names:
            HANDLERS.get(node.event, plain)(stage, node)
    for actor in stage.tracks:
        if actor not in stage.frames:
            enter_beside(stage, actor)
    let_go_down(stage)
    lead_through(stage)
    go_from_side_to_side(stage)
    state_course(stage)
    place_by_the_way(stage)


def record(doc: EsgDocument, *, seed: int = 0) -> models.Choreography:
    """Tells the story of an effective document, as the document keeps it.

    Args:
        doc: A document with assets, its casting applied.
        seed: Of the choreography.
    """
    told = choreograph(doc, seed=seed)
    return models.Choreography.model_validate(
        {
            "constellations": told.hints.constellations,
            "nominal": dict(sorted(told.nominal.items())),
        },
        from_attributes=True,
    )


def choreography_of(doc: EsgDocument, *, seed: int = 0) -> Choreography:
    """The choreography that a document holds; told with `seed` where it holds none.

    Nothing in it depends on the layout: it is the same before and after.
    """
    if doc.choreography is None:
        return choreograph(effective(doc), seed=seed)
    return Choreography(stored_hints(doc.choreography), dict(doc.choreography.nominal))
