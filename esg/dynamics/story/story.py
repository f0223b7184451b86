"""The timeline read as a story: who moves, in which phases, and which events follow from which."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import itertools
import math

from esg.graph.models import (
    EdgeEvent,
    EsgDocument,
    ForceDirection,
    NodeEvent,
    Quantity,
    Role,
    SequenceGraph,
    TimelineEdge,
    TimelineNode,
)

OWN_POWER = (
    EdgeEvent.UNIFORM_MOTION,
    EdgeEvent.ACCELERATED_MOTION,
    EdgeEvent.TURN,
    EdgeEvent.BRAKE,
)
ON_THE_SPOT = (EdgeEvent.GUIDE, EdgeEvent.SPIN, EdgeEvent.DRIVE, EdgeEvent.RELEASE)
"""Who does so does not set out for anywhere."""
CRUISES = (EdgeEvent.UNIFORM_MOTION, EdgeEvent.TURN)
"""Segments at one speed."""
UNDISTURBED = (NodeEvent.TRIGGER, NodeEvent.HEADING_REACHED, NodeEvent.MISS)
"""Events that change no speed: what goes on after them begins with the speed it had."""
POWERED = (EdgeEvent.UNIFORM_MOTION, EdgeEvent.ACCELERATED_MOTION)


@dataclass(frozen=True)
class Phase:
    """One motion segment of one active actor."""

    edge: TimelineEdge
    start: TimelineNode
    end: TimelineNode


@dataclass(frozen=True)
class Story:
    """A timeline in causal order.

    Args:
        nodes: Point events by id, in topological order.
        before: For each node id, ids of the point events it directly follows.
        phases: Per active actor, its motion segments in order.
        force: Force direction per active actor.
        groups: Members of every plural, by group name.
        group_of: Group name by node id.
    """

    nodes: dict[str, TimelineNode]
    before: dict[str, tuple[str, ...]]
    phases: dict[str, tuple[Phase, ...]]
    force: dict[str, ForceDirection]
    groups: dict[str, tuple[str, ...]]
    group_of: dict[str, str]

    def expand(self, name: str) -> tuple[str, ...]:
        """The object itself, or all members of its group: any of them counts as a hit."""
        group = self.group_of.get(name)
        return self.groups[group] if group else (name,)

    @property
    def outcomes(self) -> tuple[TimelineNode, ...]:
        """Events that physics must bring about, in causal order."""
        skip = (NodeEvent.SCENE_START, NodeEvent.TRIGGER)
        return tuple(n for n in self.nodes.values() if n.event not in skip)

    def is_active(self, name: str) -> bool:
        return name in self.phases

    def guided(self, actor: str) -> bool:
        """Whether it starts on its support and something outside of the scene takes it up."""
        first = self.phases[actor][0]
        return first.edge.event is EdgeEvent.GUIDE and first.end.event is not NodeEvent.TRIGGER

    def flies(self, actor: str) -> bool:
        """Thrown, dropped, held up or flying: it starts in the air."""
        jumps = self.phases[actor][0].end.event is NodeEvent.JUMP
        if self.phases[actor][0].edge.event is EdgeEvent.DRIVE:
            return False  # along its joint
        return self.force[actor] is ForceDirection.ANY_3D and not (jumps or self.guided(actor))

    def soars(self, actor: str) -> bool:
        """Whether it flies under its own power: held against gravity until its last hold ends."""
        powered = self.flies(actor) and self.phases[actor][0].edge.event in OWN_POWER
        return powered and not self.takes_off(actor)

    def takes_off(self, actor: str) -> bool:
        """Whether it drives at first and is launched later: a car that flies off a ramp."""
        if not self.flies(actor) or self.phases[actor][0].edge.event not in OWN_POWER:
            return False
        later = [p.edge for p in self.phases[actor][1:] if p.edge.event is EdgeEvent.TOWARD]
        return any(e.params.speed is not None for e in later)

    def tips(self, phase: Phase) -> bool:
        """Whether a phase tips its own actor over where it is: a domino, a cart at a fence."""
        actor = phase.edge.actor
        itself = phase.end.event is NodeEvent.TOPPLE and actor in phase.end.participants
        if not itself or self.flies(actor):
            return False
        if phase.edge.event is EdgeEvent.TOWARD:
            return True
        return phase.edge.event in POWERED and phase is not self.phases[actor][0]

    def reverses(self, actor: str) -> bool:
        """Whether an actor starts by driving backwards."""
        return self.phases[actor][0].edge.params.backward is True

    def meet_again(self, node: TimelineNode) -> bool:
        """Whether the bodies of an event hit each other later: who passes is run into after it."""
        told = list(self.nodes.values())
        later = told[told.index(node) + 1 :]
        both = set(node.participants)
        return any(n.event is NodeEvent.COLLISION and set(n.participants) == both for n in later)

    def topples(self, name: str | None) -> bool:
        """Whether the story tips an object over; never so for None."""
        return name is not None and self._befalls(NodeEvent.TOPPLE, name)

    def falls(self, name: str) -> bool:
        """Whether the story has an object fall off something."""
        return self._befalls(NodeEvent.FALL, name)

    def breaks_after(self, node_id: str, name: str) -> bool:
        """Whether an event leads to an object's breaking."""
        later = (n for n in self.after(node_id) if n.event is NodeEvent.BREAK)
        return any(name in n.participants for n in later)

    def _befalls(self, event: NodeEvent, name: str) -> bool:
        return any(n.event is event and name in n.participants for n in self.nodes.values())

    def after(self, node_id: str) -> list[TimelineNode]:
        """All events that this one leads to, in causal order."""
        return [n for n in self.nodes.values() if node_id in self.ancestors(n.id)]

    def ancestors(self, node_id: str) -> set[str]:
        """All events that lead to this one."""
        seen: set[str] = set()
        stack = list(self.before.get(node_id, ()))
        while stack:
            current = stack.pop()
            if current not in seen:
                seen.add(current)
                stack.extend(self.before.get(current, ()))
        return seen

    def previous_outcomes(self, node_id: str) -> list[str]:
        """All physics events this one follows, in causal order."""
        before = self.ancestors(node_id)
        return [n.id for n in self.outcomes if n.id in before]

    def previous_outcome(self, node_id: str) -> str | None:
        """The last of the physics events this one follows, or None."""
        return next(reversed(self.previous_outcomes(node_id)), None)


def read_story(doc: EsgDocument) -> Story:
    """Reads a verified document's timeline; a static scene gives an empty story."""
    timeline = doc.timeline_system
    graph = doc.spatial_relation_graph
    members: dict[str, list[str]] = {}
    for name, node in graph.nodes.items():
        if node.group:
            members.setdefault(node.group, []).append(name)
    groups = {g: tuple(m) for g, m in members.items() if _is_plural(doc, m)}
    group_of = {name: g for g, m in groups.items() for name in m}
    if timeline is None:
        return Story({}, {}, {}, {}, groups, group_of)
    by_id = {n.id: n for n in timeline.sequence_graph.nodes}
    edges = timeline.sequence_graph.edges
    before = _before(timeline.sequence_graph)
    order = _topological(list(by_id), before)
    nodes = {i: by_id[i] for i in order}
    rank = {i: k for k, i in enumerate(order)}
    phases: dict[str, tuple[Phase, ...]] = {}
    force: dict[str, ForceDirection] = {}
    for name, actor in timeline.actors.items():
        if actor.role is not Role.ACTIVE:
            continue
        own = [e for e in edges if e.actor == name and e.event is not EdgeEvent.INERTIAL_CONNECTOR]
        own.sort(key=lambda e: (rank[e.from_], rank[e.to]))
        if own:
            phases[name] = tuple(Phase(e, by_id[e.from_], by_id[e.to]) for e in own)
            force[name] = actor.force_direction or ForceDirection.HORIZONTAL_PLANE
    return Story(nodes, {k: tuple(v) for k, v in before.items()}, phases, force, groups, group_of)


def _before(graph: SequenceGraph) -> dict[str, list[str]]:
    """Ids of the events that each one directly follows: by a segment, or because it is timed so."""
    before: dict[str, list[str]] = {n.id: [] for n in graph.nodes}
    for edge in graph.edges:
        if edge.from_ not in before[edge.to]:
            before[edge.to].append(edge.from_)
    # "1.5 seconds later" follows what it is timed from, whoever takes part in it.
    for node in graph.nodes:
        for c in node.constraints:
            if c.since is None or c.since not in before or c.since in before[node.id]:
                continue
            if not _leads(before, node.id, c.since):
                before[node.id].append(c.since)
    return before


def _is_plural(doc: EsgDocument, members: list[str]) -> bool:
    """Named individuals ("ball A", "front car") that share a group are not interchangeable.

    Neither are members that move by themselves: each has a path of its own.
    """
    labels = {doc.spatial_relation_graph.nodes[m].label for m in members}
    if len(members) < 2 or len(labels) > 1:
        return False
    if doc.timeline_system is None:
        return True
    graph = doc.timeline_system.sequence_graph
    carried = EdgeEvent.INERTIAL_CONNECTOR
    if any(e.actor in members and e.event is not carried for e in graph.edges):
        return False
    # One that is struck and carried on stands for all; several that are named are individuals.
    moves = any(e.actor in members for e in graph.edges)
    return not (moves and len({p for n in graph.nodes for p in n.participants if p in members}) > 1)


def _leads(before: dict[str, list[str]], earlier: str, later: str) -> bool:
    """Whether one event is among those another one follows from."""
    seen, stack = set[str](), [later]
    while stack:
        current = stack.pop()
        if current == earlier:
            return True
        if current not in seen:
            seen.add(current)
            stack.extend(before[current])
    return False


def _topological(ids: list[str], before: dict[str, list[str]]) -> list[str]:
    done: list[str] = []
    pending = list(ids)
    while pending:
        ready = [i for i in pending if all(b in done for b in before[i])]
        if not ready:
            return done + pending
        done.append(ready[0])
        pending.remove(ready[0])
    return done


def hits(doc: EsgDocument, story: Story) -> list[tuple[TimelineNode, str, str]]:
    """Hits of two objects as (hit, mover, target)."""
    nodes = doc.spatial_relation_graph.nodes
    out: list[tuple[TimelineNode, str, str]] = []
    for node in story.nodes.values():
        if node.event is not NodeEvent.COLLISION or len(node.participants) < 2:
            continue
        a, b = node.participants[:2]
        if story.is_active(b) and not story.is_active(a):
            a, b = b, a
        if a in nodes and b in nodes:
            out.append((node, a, b))
    return out


def is_climb(phase: Phase) -> bool:
    """Whether a phase leads its actor along the surface of something."""
    return phase.edge.event is EdgeEvent.GUIDE and phase.edge.params.climbs is not None


def is_posture(phase: Phase) -> bool:
    """Whether in a phase its actor does nothing but change its posture."""
    return phase.edge.event is EdgeEvent.GUIDE and phase.edge.params.posture is not None


def climbed_before(story: Story, node: TimelineNode) -> TimelineNode | None:
    """The end of the climb from which an event's actor comes down; None if it has not climbed."""
    for phases in story.phases.values():
        for before, phase in itertools.pairwise(phases):
            if phase.end.id == node.id and is_climb(before):
                return before.end
    return None


def _begins_at_a_wall(phase: Phase, is_fixed: Callable[[str], bool]) -> bool:
    """Whether an actor is driven on from its hit of something fixed."""
    actor, start = phase.edge.actor, phase.start
    if phase.edge.event not in POWERED or start.event is not NodeEvent.COLLISION:
        return False
    others = [p for p in start.participants if p != actor]
    return actor in start.participants and bool(others) and all(is_fixed(p) for p in others)


def turns_back(story: Story, phase: Phase, is_fixed: Callable[[str], bool]) -> bool:
    """Whether an actor goes the other way along its axis from the start of a phase on.

    It drives forward from what it has backed into, and which cannot move; or it came forward and
    backs away ("stops at a gate and reverses").
    """
    actor, backward = phase.edge.actor, phase.edge.params.backward is True
    if story.reverses(actor):
        return not backward and _begins_at_a_wall(phase, is_fixed)
    phases = story.phases[actor]
    before = [p for p in phases[: phases.index(phase)] if p.edge.event in POWERED]
    came = before[-1].edge.params.backward is True if before else backward
    return phase.edge.event in POWERED and came is not backward


def rebounds(story: Story, phase: Phase, is_fixed: Callable[[str], bool]) -> bool:
    """Whether a phase begins with a hit of something fixed and ends with the start of braking.

    "Hits the kerb and stops": pressed on against the kerb it would already be at rest when its
    brake sets in, so that it rolls back freely until then.

    Args:
        story: The story.
        phase: One of its phases.
        is_fixed: Whether a body cannot move.
    """
    actor, end = phase.edge.actor, phase.end
    if end.event is not NodeEvent.TRIGGER or not _begins_at_a_wall(phase, is_fixed):
        return False
    if turns_back(story, phase, is_fixed):
        return False
    return any(
        p.edge.event is EdgeEvent.BRAKE and p.start.id == end.id for p in story.phases[actor]
    )


def stranded(story: Story, phase: Phase, is_fixed: Callable[[str], bool]) -> bool:
    """Whether a phase begins with a hit of something fixed and ends when another actor arrives.

    "The truck crashes into a sign, then a taxi rams the truck": pressed on against the sign it
    would go through it; it stays where its hit left it.

    Args:
        story: The story.
        phase: One of its phases.
        is_fixed: Whether a body cannot move.
    """
    actor, end = phase.edge.actor, phase.end
    if end.event is not NodeEvent.COLLISION or actor not in end.participants:
        return False
    if not _begins_at_a_wall(phase, is_fixed):
        return False
    return any(
        p.end.id == end.id
        for a, ps in story.phases.items()
        for p in ps
        if a != actor and a in end.participants
    )


def bounds(value: Quantity | None, default: tuple[float, float]) -> tuple[float, float, bool]:
    """Lower bound, upper bound and whether the quantity is fixed."""
    if value is None:
        return (*default, False)
    if isinstance(value, (int, float)):
        return float(value), float(value), True
    low, high = float(value[0]), float(value[1])
    return low, high, high - low < 1e-9


def middle(low: float, high: float) -> float:
    """A plausible value of an interval: the geometric mean where both ends are positive."""
    return math.sqrt(low * high) if low > 0.0 else 0.5 * (low + high)


def turn_of(phase: Phase) -> tuple[float, float]:
    """Degrees and sign (left = +1) of a Turn phase, from the edge or its end node."""
    params, node = phase.edge.params, phase.end
    low, high, _ = bounds(params.turn_degrees, (90.0, 90.0))
    degrees = 0.5 * (low + high) if params.turn_degrees is not None else (node.turn_degrees or 90.0)
    side = params.turn_direction or node.turn_direction or "left"
    return degrees, 1.0 if side == "left" else -1.0
