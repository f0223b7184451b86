"""Builds the sequence graph: actors, point events, segments, and time windows.

Every actor carries the event it was last part of and how it moves since; each new event closes the
segments of those who take part in it. Windows are planned last, in topological order, from the
stated times and plausible durations (the paper's timeline prompt, step 4).
"""

from __future__ import annotations

from typing import Any

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.registry import unique
from esg.draft.discourse.tracks import Motion, Track
from esg.draft.discourse.windows import START, Draft, plan_times
from esg.graph.models import (
    Actor,
    EdgeEvent,
    EventConstraint,
    ForceDirection,
    MotionParams,
    NodeEvent,
    Quantity,
    Role,
    SequenceGraph,
    TimelineEdge,
    TimelineNode,
    TimelineSystem,
)

_EDGES: dict[str, EdgeEvent] = {
    "own": EdgeEvent.UNIFORM_MOTION,
    "accelerate": EdgeEvent.ACCELERATED_MOTION,
    "brake": EdgeEvent.BRAKE,
    "turn": EdgeEvent.TURN,
    "roll": EdgeEvent.TOWARD,
    "slide": EdgeEvent.TOWARD,
    "throw": EdgeEvent.TOWARD,
    "drop": EdgeEvent.TOWARD,
    "fly": EdgeEvent.TOWARD,
    "guide": EdgeEvent.GUIDE,
    "jump": EdgeEvent.TOWARD,
    "spin": EdgeEvent.SPIN,
    "drive": EdgeEvent.DRIVE,
    "release": EdgeEvent.RELEASE,
}
_STEADY = frozenset({EdgeEvent.UNIFORM_MOTION, EdgeEvent.TOWARD})
Gaps = dict[frozenset[str], Quantity]
LAUNCHES = lex.word_set("launches")
_NAMES = {
    NodeEvent.ENTER_REGION: "enter", NodeEvent.HEADING_REACHED: "turn_end",
    NodeEvent.POSITION_AT: "position", NodeEvent.COLLISION: "collision",
    NodeEvent.TRIGGER: "trigger", NodeEvent.STOP: "stop", NodeEvent.TOPPLE: "topple",
    NodeEvent.PICKED_UP: "picked_up", NodeEvent.PLACED: "placed", NodeEvent.BOUNCE: "bounce",
    NodeEvent.JUMP: "jump", NodeEvent.SPIN: "spin",
    NodeEvent.OPEN: "open", NodeEvent.CLOSE: "close", NodeEvent.SWING: "swing",
    NodeEvent.BREAK: "break",
    NodeEvent.FALL: "fall", NodeEvent.REACH: "reach", NodeEvent.MISS: "miss",
}  # fmt: skip
"""Last words of the ids of point events."""
_ENDING = (NodeEvent.STOP, NodeEvent.PICKED_UP, NodeEvent.PLACED, NodeEvent.SPIN, NodeEvent.JUMP)
"""Events with which a motion is over: what comes next is told anew."""
_LEGS = {"own": "drive", "drive": "moved", "throw": "flight", "fly": "flight"}
"""Last words of the ids of segments, where they differ from the mode."""
SETS_OFF_S = (0.0, 1.5)
"""How long after an event somebody who has waited for it sets off [s]."""
_FREEDOM = (
    ForceDirection.ALONG_FORWARD_ONLY,
    ForceDirection.ALONG_FORWARD_OR_BACKWARD,
    ForceDirection.HORIZONTAL_PLANE,
    ForceDirection.ANY_3D,
)


class TimelineBuilder:
    """Collects motions and events in order of time."""

    def __init__(self) -> None:
        self.tracks: dict[str, Track] = {}
        self.nodes: list[Draft] = []
        self.edges: list[TimelineEdge] = []
        self.start_constraints: list[EventConstraint] = []
        """Stated initial conditions, such as the height of a drop."""
        self.last_event: str | None = None
        """Most recent point event that "after N seconds" can refer to."""

    def track(self, actor: str) -> Track:
        return self.tracks.setdefault(actor, Track())

    def node(self, node_id: str) -> Draft | None:
        return next((n for n in self.nodes if n.id == node_id), None)

    # -- motions ---------------------------------------------------------------------------------

    def move(self, actor: str, motion: Motion, direction: ForceDirection) -> None:
        """Starts a motion of an active actor; a motion under way gets the new speed or target."""
        track = self.track(actor)
        previous = track.motion
        if previous is not None and not track.closed and previous.mode == motion.mode:
            if motion.prescribed:
                previous.speed, previous.prescribed = motion.speed, True
            previous.target = motion.target or previous.target
            previous.params.update(motion.params)
            return
        steered = previous is not None and previous.mode in ("own", "accelerate", "brake")
        if steered and not track.closed:
            self.trigger(actor, f"{actor} changes its motion")
        track.motion, track.role, track.closed = motion, Role.ACTIVE, False
        track.launched = track.launched or motion.mode in LAUNCHES
        known = direction if track.direction is None else track.direction
        track.direction = max(known, direction, key=_FREEDOM.index)

    def carry(self, actor: str, node_id: str) -> None:
        """Lets a hit of what bears a passive body move the body too."""
        track = self.track(actor)
        track.at, track.hit, track.closed = node_id, True, True

    def trigger(
        self, actor: str, description: str, time: Quantity | None = None, prescribed: bool = False
    ) -> str:
        """A point at which the actor changes what it does."""
        return self.event(
            NodeEvent.TRIGGER, (actor,), description, time=time, prescribed=prescribed
        )

    # -- events ----------------------------------------------------------------------------------

    def event(
        self,
        event: NodeEvent,
        participants: tuple[str, ...],
        description: str,
        *,
        time: Quantity | None = None,
        prescribed: bool = False,
        stem: str = "",
        **extra: Any,
    ) -> str:
        """Adds a point event and the segments that lead its participants there; returns its id."""
        name = stem or _NAMES.get(event, "event")
        node_id = unique("_".join([*participants, name]), (n.id for n in self.nodes))
        draft = Draft(node_id, event, participants, description, time, prescribed, extra=extra)
        moving = [a for a in participants if a in self.tracks and self.tracks[a].under_way]
        if not moving and self.last_event is not None:
            draft.after.append(self.last_event)
        for k, actor in enumerate(participants):
            if k > 0 and self.track(actor).role is Role.PASSIVE:
                continue  # what is hit again need not travel to the hit
            if actor in moving:
                other = next((p for p in participants if p != actor), None)
                self._edge(actor, node_id, other if k == 0 else None)
        led = any(e.to == node_id and e.from_ == self.last_event for e in self.edges)
        if self.last_event is not None and event is not NodeEvent.TRIGGER and not led:
            draft.after.append(self.last_event)
        self.nodes.append(draft)
        for actor in participants:
            track = self.track(actor)
            if event is NodeEvent.COLLISION and track.role is Role.PASSIVE:
                track.hit = True
            if actor in moving or event is NodeEvent.COLLISION:
                track.at = node_id
                track.closed = True
            if event in _ENDING:
                track.motion = None
        self.last_event = node_id
        return node_id

    def undone(self, actor: str, event: NodeEvent) -> Draft | None:
        """Takes back what was told last, if that is an event of an actor by its own motion.

        Args:
            actor: Who.
            event: Of which kind.

        Returns:
            The event, for `told_again`; None where something else was told last.
        """
        last = self.nodes[-1] if self.nodes else None
        lead = next((e for e in self.edges if last is not None and e.to == last.id), None)
        mine = last is not None and last.event is event and last.participants == (actor,)
        if last is None or lead is None or not mine or self.track(actor).role is Role.PASSIVE:
            return None
        self.nodes.remove(last)
        self.edges.remove(lead)
        track = self.track(actor)
        track.at, track.motion, track.closed = lead.from_, None, True
        self.last_event = self.nodes[-1].id if self.nodes else None
        return last

    def told_again(self, draft: Draft) -> None:
        """Tells an event that was taken back after what has been told since."""
        draft.after = [self.last_event] if self.last_event is not None else []
        for actor in draft.participants:
            self._edge(actor, draft.id, None)
            self.track(actor).at, self.track(actor).closed = draft.id, True
        self.nodes.append(draft)
        self.last_event = draft.id

    def _edge(self, actor: str, to: str, target: str | None) -> None:
        """Adds the segment of an actor that leads to an event, by how it moves."""
        track = self.track(actor)
        if track.at == to:
            return
        motion, passive = track.motion, track.role is Role.PASSIVE
        event, params, name = EdgeEvent.INERTIAL_CONNECTOR, MotionParams(), "carried"
        if not passive:
            assert motion is not None
            event, params, name = self._segment(motion)
        aim = target or (motion.target if motion is not None else None)
        free = ("brake", "coast")
        self.edges.append(
            TimelineEdge(
                id=unique(f"{actor}_{name}", (e.id for e in self.edges)),
                from_=track.at,
                to=to,
                event=event,
                actor=actor,
                target=aim if aim != actor else None,
                params=params,
                speed_is_prescribed=motion is not None
                and not passive
                and motion.prescribed
                and motion.mode not in free,
            )
        )
        if motion is not None and motion.mode in LAUNCHES and not passive:
            track.motion = Motion("coast", target=None)
        elif motion is not None and motion.mode == "turn":
            track.motion = Motion("own", motion.speed, False)
        elif motion is not None and motion.mode == "own" and motion.prescribed:
            track.motion = Motion("own", motion.speed, motion.prescribed)

    @staticmethod
    def _segment(motion: Motion) -> tuple[EdgeEvent, MotionParams, str]:
        if motion.mode == "coast":
            return EdgeEvent.TOWARD, MotionParams(), "coast"
        params = dict(motion.params)
        if motion.speed is not None and motion.mode != "brake":
            params["speed"] = motion.speed
        if motion.duration is not None:
            params["duration"] = motion.duration
        return _EDGES[motion.mode], MotionParams(**params), _LEGS.get(motion.mode, motion.mode)

    def stated_speed(self, actor: str) -> Quantity | None:
        """The speed that the prompt gives an actor at first, if it does."""
        for e in self.edges:
            if e.actor == actor and e.speed_is_prescribed and e.params.speed is not None:
                return e.params.speed
        track = self.tracks.get(actor)
        if track is not None and track.motion is not None and track.motion.prescribed:
            return track.motion.speed
        return None

    def set_speed(self, actor: str, speed: Quantity, *, prescribed: bool) -> None:
        """Gives every launch and drive of an actor this speed [cm/s]."""
        for k, e in enumerate(self.edges):
            driven = e.event in (EdgeEvent.UNIFORM_MOTION, EdgeEvent.TOWARD)
            if e.actor == actor and driven and e.params.speed not in (None, 0.0):
                self.edges[k] = e.model_copy(
                    update={
                        "params": e.params.model_copy(update={"speed": speed}),
                        "speed_is_prescribed": prescribed,
                    }
                )
        track = self.tracks.get(actor)
        if track is not None and track.motion is not None and track.motion.mode != "coast":
            track.motion.speed, track.motion.prescribed = speed, prescribed

    def forget_duration(self, node_id: str) -> None:
        """Leaves open how long the segments up to an event last."""
        for k, e in enumerate(self.edges):
            if e.to == node_id and e.params.duration is not None:
                params = e.params.model_copy(update={"duration": None})
                self.edges[k] = e.model_copy(update={"params": params})

    def hand_over(self, told: str, does: str) -> None:
        """Lets a node do and meet what was told of another one: the mount of its rider."""
        self.tracks[does] = self.tracks.pop(told)
        self.edges[:] = [
            x.model_copy(update={"actor": does}) if x.actor == told else x for x in self.edges
        ]
        for node in self.nodes:
            node.participants = tuple(does if p == told else p for p in node.participants)

    def finish(self) -> None:
        """Leads every motion that no event closed to a Trigger (the end of the action)."""
        for actor, track in list(self.tracks.items()):
            if track.role is Role.ACTIVE and not track.closed and track.motion is not None:
                keep, told = self.last_event, f"{actor} ends its described motion"
                if track.after is not None and track.at == START:
                    self._wait_for(actor, track, track.after)
                self.event(NodeEvent.TRIGGER, (actor,), told, stem="motion_end")
                self.last_event = keep
        self._back_away_at_last()

    def _back_away_at_last(self) -> None:
        """Keeps tail first, of what came forward, for a last motion only: no other has its way."""
        ends = {n.id for n in self.nodes if n.event is NodeEvent.TRIGGER}
        last = {e.actor: e.id for e in self.edges if e.to in ends}
        came_so = {e.actor for e in self.edges if e.params.backward and e.from_ == START}
        for k, e in enumerate(self.edges):
            if e.params.backward and e.actor not in came_so and last.get(e.actor) != e.id:
                params = e.params.model_copy(update={"backward": None})
                self.edges[k] = e.model_copy(update={"params": params})

    def _wait_for(self, actor: str, track: Track, node_id: str) -> None:
        """Puts a wait until an event that it takes no part in before an actor's first motion."""
        going, track.motion = track.motion, Motion("own", 0.0)
        node = self.node(self.trigger(actor, f"{actor} sets off"))
        assert node is not None
        self._comes_after(node, node_id)
        track.motion, track.closed = going, False

    def _comes_after(self, node: Draft, node_id: str) -> None:
        """Lets an actor set off soon after somebody else's event."""
        node.after.append(node_id)
        soon = EventConstraint(
            quantity="time_since", object=node.participants[0], value=SETS_OFF_S, since=node_id
        )
        node.constraints.append(soon)

    def hold(self, actor: str, node_id: str) -> None:
        """Lets an actor wait before its first motion for an event that it takes no part in.

        What is told later leads a motion that is still open to its end (`finish`); one that has
        led to an event is put off here. What is in the air is not: nothing would hold it there.
        """
        self.track(actor).after = node_id
        first = next((e for e in self.edges if e.actor == actor and e.from_ == START), None)
        ids = [n.id for n in self.nodes]
        if first is None or ids.index(first.to) < ids.index(node_id):
            return
        airborne = first.params.elevation_deg is not None
        met = self.node(node_id)
        involved = met is not None and first.target in met.participants
        leads_to = self.node(first.to)
        timed = leads_to is not None and (leads_to.time is not None or leads_to.constraints)
        if first.event not in _STEADY or airborne or first.params.speed == 0.0 or involved or timed:
            return
        name = unique(f"{actor}_trigger", ids)
        node = Draft(name, NodeEvent.TRIGGER, (actor,), f"{actor} sets off")
        self._comes_after(node, node_id)
        self.nodes.insert(ids.index(node_id) + 1, node)
        k = self.edges.index(first)
        waits = TimelineEdge(
            id=unique(f"{actor}_wait", (e.id for e in self.edges)),
            from_=START,
            to=name,
            event=EdgeEvent.UNIFORM_MOTION,
            actor=actor,
            params=MotionParams(speed=0.0),
        )
        self.edges[k : k + 1] = [waits, first.model_copy(update={"from_": name})]

    # -- result ----------------------------------------------------------------------------------

    def _expect(self, gaps: Gaps) -> None:
        """How long the first motions take whose way and speed are stated."""
        for n in self.nodes:
            if n.event is not NodeEvent.COLLISION or len(n.participants) != 2:
                continue
            lead = {e.actor: e for e in self.edges if e.to == n.id}
            speeds = [
                e.params.speed
                for e in lead.values()
                if e.from_ == START and e.speed_is_prescribed and e.event in _STEADY
            ]
            way = gaps.get(frozenset(n.participants))
            if way is None:
                stated = [c.value for c in n.constraints if c.quantity == "distance" and not c.to]
                way = stated[0] if stated and len(lead) == 1 else None
            fixed = [v for v in speeds if isinstance(v, float | int) and v > 0.0]
            if way is None or not fixed or len(fixed) != len(lead):
                continue
            long = 0.5 * sum(way) if isinstance(way, tuple) else way
            n.usual = round(long / sum(fixed), 4)

    def build(self, gaps: Gaps | None = None) -> TimelineSystem | None:
        """The timeline system, or None if nothing moves.

        Args:
            gaps: Stated distances of pairs at the start [cm].
        """
        self.finish()
        if not self.nodes:
            return None
        involved = {p for n in self.nodes for p in n.participants}
        actors = {
            name: Actor(role=t.role, force_direction=t.direction if t.role is Role.ACTIVE else None)
            for name, t in self.tracks.items()
            if name in involved and (t.role is Role.ACTIVE or t.hit)
        }
        edges = [self._repair(e, actors) for e in self.edges if e.actor in actors]
        self._expect(gaps or {})
        spans = plan_times(self.nodes, edges)
        nodes = [
            TimelineNode(
                id=START,
                event=NodeEvent.SCENE_START,
                timestamp=0.0,
                description="Scene start",
                constraints=tuple(self.start_constraints),
            )
        ]
        for draft in self.nodes:
            low, high = spans[draft.id]
            fixed = draft.time_prescribed and low == high
            nodes.append(
                TimelineNode(
                    id=draft.id,
                    event=draft.event,
                    participants=draft.participants,
                    timestamp=low if fixed else None,
                    window=None if fixed else (low, high),
                    time_is_prescribed=draft.time_prescribed,
                    constraints=tuple(draft.constraints),
                    description=draft.description,
                    **draft.extra,
                )
            )
        return TimelineSystem(
            actors=actors, sequence_graph=SequenceGraph(nodes=tuple(nodes), edges=tuple(edges))
        )

    @staticmethod
    def _repair(edge: TimelineEdge, actors: dict[str, Actor]) -> TimelineEdge:
        """A body that later moves by itself cannot have inertial connectors: it coasts instead."""
        if edge.event is EdgeEvent.INERTIAL_CONNECTOR and actors[edge.actor].role is Role.ACTIVE:
            return edge.model_copy(update={"event": EdgeEvent.TOWARD})
        return edge
