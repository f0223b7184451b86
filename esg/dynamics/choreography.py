"""Choreography: where the participants of a timeline start, and with which nominal parameters.

Before anything is simulated, the story is told once with closed-form kinematics in a frame of its
own: an actor runs along its path, meets its target after a plausible (or prescribed) time, sets it
in motion, and the next target is put where the motion leads. The result is a set of constellations
for the layout stage and a nominal value for every control parameter, where the search starts.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
import math
import zlib

import numpy as np

from esg.dynamics.kinematics import (
    Frame,
    Track,
    braking_distance,
    frame_mapping,
    half_along,
    impact_speed,
    sliding_distance,
    stopping_damping,
)
from esg.dynamics.stagecraft import (
    Prop,
    approach_distance,
    coasting_drag,
    default_speed,
    fit_to_surface,
    min_hit_speed,
    pocket_shot,
    prop,
    push_speed,
    release_height,
    slide,
    support_of,
    target_yaw,
)
from esg.dynamics.story import Phase, Story, bounds, middle, read_story
from esg.graph.models import (
    EdgeEvent,
    EsgDocument,
    ForceDirection,
    NodeEvent,
    TimelineNode,
)
from esg.layout.hints import Constellation, Corridor, Placement, StartHints

CLEARANCE_M = 0.35
RUN_OUT_M = 1.0
MAX_APPROACH_M = 45.0
REACH_BRAKE_DAMPING = 9.0
"""Linear damping [1/s] with which a body stops that reaches a place without a hit."""


@dataclass(frozen=True)
class Choreography:
    """Start hints and nominal parameters ("edge id/speed" -> SI value)."""

    hints: StartHints
    nominal: dict[str, float]


def start_hints(doc: EsgDocument, *, seed: int = 0) -> StartHints:
    """Start constellations of the timeline's participants; empty for static scenes."""
    return choreograph(doc, seed=seed).hints


def choreograph(doc: EsgDocument, *, seed: int = 0) -> Choreography:
    """Tells the story once in closed form.

    Args:
        doc: A document with assets resolved.
        seed: Varies approach distances, lateral offsets and times.
    """
    story = read_story(doc)
    text = doc.scene_definition.original_description
    rng = np.random.default_rng([seed, zlib.crc32(text.encode())])
    constellations: list[Constellation] = []
    nominal: dict[str, float] = {}
    for component in _components(doc, story):
        stage = _Stage(doc, story, component, rng.spawn(1)[0]).play()
        constellations.append(stage.constellation())
        nominal.update(stage.nominal)
        nominal.update({f"{k}/event_time": t for k, t in stage.time.items()})
    return Choreography(StartHints(tuple(c for c in constellations if c.placements)), nominal)


def _components(doc: EsgDocument, story: Story) -> list[set[str]]:
    """Sets of objects whose motions touch each other."""
    groups: list[set[str]] = []
    links = [set(n.participants) | _region_parent(n) for n in story.nodes.values()]
    links += [
        {e.edge.actor, *([e.edge.target] if e.edge.target else [])}
        for p in story.phases.values()
        for e in p
    ]
    for link in [s for s in links if s]:
        touching = [g for g in groups if g & link]
        merged = link.union(*touching)
        groups = [g for g in groups if g not in touching] + [merged]
    return [g for g in groups if any(story.is_active(n) for n in g)]


def _region_parent(node: TimelineNode) -> set[str]:
    return {node.region.split("/")[0]} if node.region else set()


class _Stage:
    """One constellation being choreographed; all lengths in metres, in the component's frame."""

    def __init__(
        self, doc: EsgDocument, story: Story, names: set[str], rng: np.random.Generator
    ) -> None:
        self.doc, self.story, self.names, self.rng = doc, story, names, rng
        self.nominal: dict[str, float] = {}
        self.time: dict[str, float] = {}
        self.places: dict[str, tuple[float, float, float | None]] = {}
        self.heights: dict[str, float] = {}
        self.tracks = {a: Track() for a in story.phases if a in names}
        self.frames: dict[str, Frame] = {}
        self.moving: dict[str, Track] = {}
        self.next_phase = {a: 0 for a in self.tracks}
        self.tight = 1.0
        actors = sorted(
            self.tracks, key=lambda a: list(story.nodes).index(story.phases[a][0].start.id)
        )
        self.lead = actors[0]
        self.anchor = support_of(doc, self.lead)
        if self.anchor and story.force[self.lead] is ForceDirection.ANY_3D:
            self.anchor = None

    # -- telling the story -------------------------------------------------------------------

    def play(self) -> _Stage:
        pocket = self._pocket_event()
        if pocket is not None:
            self._play_pocket(pocket)
            return self
        stage = self
        for _ in range(8):
            stage._tell()
            if stage.anchor is None or fit_to_surface(stage.doc, stage.anchor, stage.places):
                break
            tighter = _Stage(self.doc, self.story, self.names, self.rng)
            tighter.tight = stage.tight * 0.7
            stage = tighter
        return stage

    def _tell(self) -> None:
        for node in self.story.nodes.values():
            if node.event is NodeEvent.SCENE_START:
                self.time[node.id] = 0.0
            elif set(node.participants) & self.names or _region_parent(node) & self.names:
                self._event(node)
        for actor in self.tracks:
            if actor not in self.frames:
                self._enter_beside(actor)

    def _event(self, node: TimelineNode) -> None:
        handler = {
            NodeEvent.TRIGGER: self._controlled,
            NodeEvent.HEADING_REACHED: self._turned,
            NodeEvent.COLLISION: self._collision,
            NodeEvent.REACH: self._collision,
            NodeEvent.MISS: self._collision,
            NodeEvent.ENTER_REGION: self._enters,
        }.get(node.event, self._plain)
        handler(node)

    def _incoming(self, node: TimelineNode) -> list[tuple[str, Phase]]:
        out: list[tuple[str, Phase]] = []
        for actor in self.tracks:
            phases = self.story.phases[actor]
            k = self.next_phase[actor]
            while k < len(phases) and phases[k].end.id != node.id and self._skippable(phases[k]):
                k += 1
            if k < len(phases) and phases[k].end.id == node.id:
                self.next_phase[actor] = k + 1
                track = self.tracks[actor]
                track.time = max(track.time, self.time.get(phases[k].start.id, 0.0))
                out.append((actor, phases[k]))
        return out

    def _skippable(self, phase: Phase) -> bool:
        return phase.end.id in self.time

    def _controlled(self, node: TimelineNode) -> None:
        prescribed = self._prescribed_time(node)
        arrived: list[float] = []
        for actor, phase in self._incoming(node):
            track = self.tracks[actor]
            if prescribed is not None:
                duration = max(0.2, prescribed - track.time)
            else:
                duration = float(self.rng.uniform(1.2, 1.8)) * self.tight
            self._advance(actor, phase, duration)
            arrived.append(track.time)
        if not arrived:
            low, high = node.window or (1.0, 1.0)
            arrived = [prescribed if prescribed is not None else max(low, min(high, low + 0.5))]
        self.time[node.id] = max(arrived)
        self.nominal[f"{node.id}/time"] = self.time[node.id]

    def _turned(self, node: TimelineNode) -> None:
        for actor, phase in self._incoming(node):
            track = self.tracks[actor]
            speed = self._speed(actor, phase) if phase.edge.params.speed else track.speed
            track.speed = speed or self._speed(actor, phase)
            self.nominal[f"{phase.edge.id}/speed"] = track.speed
            low, high, fixed = bounds(phase.edge.params.turn_rate_deg_s, (25.0, 70.0))
            rate = math.radians(low if fixed else min(max(45.0, low), high))
            degrees, sign = turn_of(phase)
            self.nominal[f"{phase.edge.id}/turn_rate"] = rate
            track.arc(sign * math.radians(degrees), rate)
        times = [self.tracks[a].time for a in self.tracks if a in node.participants]
        self.time[node.id] = max(times, default=1.0)

    def _plain(self, node: TimelineNode) -> None:
        """Stop, Topple, Fall, PositionAt: what remains of the actors' motion, nothing to place."""
        prescribed = self._prescribed_time(node)
        for actor, phase in self._incoming(node):
            track = self.tracks[actor]
            duration = self._stop_time(node) if node.event is NodeEvent.STOP else 2.0
            if prescribed is not None:
                duration = max(0.3, prescribed - track.time)
            self._advance(actor, phase, duration)
        times = [self.tracks[p].time for p in node.participants if p in self.tracks]
        before = [self.time.get(b, 0.0) for b in self.story.before.get(node.id, ())]
        self.time[node.id] = prescribed or max([*times, *(t + 0.5 for t in before)], default=1.0)
        if node.event is NodeEvent.FALL:
            self._place_for_fall(node)

    def _collision(self, node: TimelineNode) -> None:
        if len(node.participants) < 2:
            self._plain(node)
            return
        a, b = self._key(node.participants[0]), self._key(node.participants[1])
        incoming = dict(self._incoming(node))
        if a not in incoming and b in incoming:
            a, b = b, a
        if a in incoming and b in incoming:
            self._meeting(node, a, incoming[a], b, incoming[b])
        elif a in incoming:
            self._approach(node, a, incoming[a], b)
        else:
            self._chain(node, a, b)
        self._impact(node, a, b)

    def _approach(self, node: TimelineNode, a: str, phase: Phase, b: str) -> None:
        """An active body runs, rolls or flies at a target that waits."""
        track, pa, pb = self.tracks[a], self._prop(a), self._prop(b)
        if (
            phase.edge.event is EdgeEvent.TOWARD
            and bounds(phase.edge.params.speed, (1, 1))[1] <= 1.0
        ):
            self._drop(node, a, b)
            return
        prescribed = self._prescribed_time(node)
        least = min_hit_speed(pa, pb)
        if self._goes_on(node, b):
            least = max(least, push_speed(pa, pb))
        speed = self._speed(a, phase, least)
        if phase.edge.event is EdgeEvent.BRAKE:
            speed = track.speed or speed
            distance, duration, left = self._brake_into(phase, speed, prescribed, track.time)
        elif self._slides(a, phase):
            wait = None if prescribed is None else max(0.15, prescribed - track.time)
            free = not self._fixed(phase)
            speed, distance, duration, left = slide(pa, speed, wait, self.rng, adjustable=free)
            self.nominal[f"{phase.edge.id}/speed"] = speed
        else:
            duration = (
                max(0.15, prescribed - track.time)
                if prescribed is not None
                else approach_distance(pa, speed, self.rng) * self.tight / speed
            )
            distance = speed * duration
            left = speed
            if distance > MAX_APPROACH_M and not self._fixed(phase):
                speed = left = MAX_APPROACH_M / duration
                distance = MAX_APPROACH_M
            self.nominal[f"{phase.edge.id}/speed"] = speed
        track.straight(distance, duration, left)
        if self.story.force[a] is ForceDirection.ANY_3D:
            self.heights[a] = release_height(pa, pb)
            self.nominal[f"{phase.edge.id}/flight_time"] = duration
        self._join(a, b, node)

    def _goes_on(self, node: TimelineNode, b: str) -> bool:
        """Whether more is said of the target after this hit."""
        later = [n for n in self.story.nodes.values() if node.id in self.story.ancestors(n.id)]
        return any(b in map(self._key, n.participants) for n in later)

    def _brake_into(
        self, phase: Phase, speed: float, prescribed: float | None, now: float
    ) -> tuple[float, float, float]:
        """Braking that still ends in a hit: at most half of the speed is left."""
        low, high, _ = bounds(phase.edge.params.damping, (0.3, 6.0))
        left = 0.38
        duration = (
            max(0.2, prescribed - now)
            if prescribed is not None
            else float(self.rng.uniform(0.7, 1.0))
        )
        damping = min(max(-math.log(left) / duration, low), high)
        self.nominal[f"{phase.edge.id}/damping"] = damping
        distance = braking_distance(speed, damping, duration)
        return distance, duration, speed * math.exp(-damping * duration)

    def _join(self, a: str, b: str, node: TimelineNode) -> None:
        """Puts the end of a's track at b's surface, by placing whichever is still free."""
        track, pa = self.tracks[a], self._prop(a)
        if b not in self.places:
            frame = self.frames.setdefault(a, Frame() if not self.places else self._free_frame(a))
            x, y = frame.apply(track.x, track.y)
            self._place_target(a, b, x, y, track.heading + frame.angle, pa, node)
        elif a not in self.frames:
            bx, by, byaw = self.places[b]
            heading = self._free_heading(bx, by)
            pb = self._prop(b)
            reach = pa.half_length + half_along(pb.length, pb.width, heading - (byaw or 0.0))
            end = (bx - reach * math.cos(heading), by - reach * math.sin(heading))
            self.frames[a] = frame_mapping((track.x, track.y), track.heading, end, heading)
        x, y = self.frames[a].apply(0.0, 0.0)
        self.places[a] = (x, y, self.frames[a].angle + self._reverse(a))

    def _place_target(
        self, a: str, b: str, x: float, y: float, heading: float, pa: Prop, node: TimelineNode
    ) -> None:
        pb = self._prop(b)
        yaw = target_yaw(pb, heading, self.rng)
        lateral = float(self.rng.uniform(-0.12, 0.12)) * min(
            pb.half_lateral(yaw - heading), pa.half_width
        )
        front = pa.half_length + half_along(pb.length, pb.width, yaw - heading)
        if node.event is NodeEvent.MISS:
            lateral = pa.half_width + pb.half_lateral(yaw - heading) + 0.25
            front = 0.0
        if node.event is NodeEvent.REACH:
            # Room to come to rest after the hold ends.
            front += 0.15 + self.tracks[a].speed / REACH_BRAKE_DAMPING
            self.nominal[f"{node.id}/time"] = self.tracks[a].time
        cx = x + front * math.cos(heading) - lateral * math.sin(heading)
        cy = y + front * math.sin(heading) + lateral * math.cos(heading)
        self.places[b] = (cx, cy, yaw)
        self._bring_support(b, cx, cy, heading)

    def _bring_support(self, b: str, x: float, y: float, heading: float) -> None:
        """A target that stands on a table is met near the table's edge: the table comes along."""
        support = support_of(self.doc, self._member(b))
        if support is None or support == self.anchor or support in self.places:
            return
        ps = self._prop(support)
        yaw = target_yaw(ps, heading, self.rng)
        inset = max(
            0.0, half_along(ps.length, ps.width, yaw - heading) - self._prop(b).half_length - 0.08
        )
        self.places[support] = (x + inset * math.cos(heading), y + inset * math.sin(heading), yaw)

    def _chain(self, node: TimelineNode, a: str, b: str) -> None:
        """A passive body set in motion by an earlier hit runs on into the next one."""
        if a not in self.moving and b in self.moving:
            a, b = b, a
        track = self.moving.get(a)
        if track is None or b in self.places:
            return
        pa, pb = self._prop(a), self._prop(b)
        gap = self._coasting_gap(pa, track.speed) * self.tight
        prescribed = self._prescribed_time(node)
        if prescribed is not None:
            gap = max(0.1, track.speed * (prescribed - track.time))
        yaw = target_yaw(pb, track.heading, self.rng)
        jitter = float(self.rng.uniform(-0.3, 0.3)) * pb.half_lateral(yaw - track.heading)
        reach = gap + pa.half_length + half_along(pb.length, pb.width, yaw - track.heading)
        c, s = math.cos(track.heading), math.sin(track.heading)
        self.places[b] = (track.x + reach * c - jitter * s, track.y + reach * s + jitter * c, yaw)
        self._bring_support(b, self.places[b][0], self.places[b][1], track.heading)
        track.straight(gap, gap / max(track.speed, 0.1), track.speed)

    def _coasting_gap(self, body: Prop, speed: float) -> float:
        reach = 50.0 if body.rolls else sliding_distance(speed, 0.5 * (body.friction + 0.7))
        preferred = float(self.rng.uniform(0.28, 0.36)) * speed
        return max(0.05, min(preferred, 0.4 * reach, 2.5))

    def _meeting(self, node: TimelineNode, a: str, pa: Phase, b: str, pb: Phase) -> None:
        """Two active bodies meet: one catches up with the other, or they run at each other."""
        braking = [p.edge.event is EdgeEvent.BRAKE for p in (pa, pb)]
        rear = braking[0] != braking[1] or self._same_direction(a, b)
        if rear:
            front, behind = (a, b) if braking[0] or self._is_front(a) else (b, a)
            phases = {a: pa, b: pb}
            self._rear_end(node, behind, phases[behind], front, phases[front])
            return
        time = self._prescribed_time(node)
        start = max(self.tracks[a].time, self.tracks[b].time)
        for actor, phase in ((a, pa), (b, pb)):
            speed = self._speed(actor, phase)
            self.nominal[f"{phase.edge.id}/speed"] = speed
            if time is None:
                time = start + approach_distance(self._prop(actor), speed, self.rng) / speed
            track = self.tracks[actor]
            duration = max(0.2, time - track.time)
            track.straight(speed * duration, duration, speed)
        frame = self.frames.setdefault(a, Frame())
        ta, tb = self.tracks[a], self.tracks[b]
        heading = ta.heading + frame.angle
        x, y = frame.apply(ta.x, ta.y)
        reach = self._prop(a).half_length + self._prop(b).half_length
        meet = (x + reach * math.cos(heading), y + reach * math.sin(heading))
        self.frames[b] = frame_mapping((tb.x, tb.y), tb.heading, meet, heading + math.pi)
        for actor in (a, b):
            ox, oy = self.frames[actor].apply(0.0, 0.0)
            self.places[actor] = (ox, oy, self.frames[actor].angle)

    def _rear_end(
        self, node: TimelineNode, behind: str, chase: Phase, front: str, lead: Phase
    ) -> None:
        rear, ahead = self.tracks[behind], self.tracks[front]
        speed = self._speed(behind, chase)
        began = ahead.time
        time = self._prescribed_time(node) or began + float(self.rng.uniform(1.0, 1.4))
        if lead.edge.event is EdgeEvent.BRAKE:
            distance, _, left = self._brake_into(lead, ahead.speed, time, began)
        else:
            left = self._speed(front, lead)
            if left >= 0.85 * speed:
                if self._fixed(chase):
                    left = 0.6 * speed
                else:
                    speed = left / 0.6
            self.nominal[f"{lead.edge.id}/speed"] = left
            distance = left * (time - began)
        self.nominal[f"{chase.edge.id}/speed"] = speed
        ahead.straight(distance, time - began, left)
        rear.straight(speed * (time - rear.time), time - rear.time, speed)
        gap = max(rear.x - ahead.x, 0.3)
        reach = self._prop(behind).half_length + self._prop(front).half_length
        self.frames[behind] = Frame()
        self.frames[front] = Frame(gap + reach, 0.0, 0.0)
        self.places[behind] = (0.0, 0.0, 0.0)
        self.places[front] = (gap + reach, 0.0, 0.0)

    def _same_direction(self, a: str, b: str) -> bool:
        words = " ".join(self.doc.spatial_relation_graph.nodes[n].label.lower() for n in (a, b))
        return any(w in words.split() for w in ("front", "rear", "lead", "leading", "following"))

    def _is_front(self, a: str) -> bool:
        words = self.doc.spatial_relation_graph.nodes[a].label.lower().split()
        return any(w in words for w in ("front", "lead", "leading"))

    def _drop(self, node: TimelineNode, a: str, b: str) -> None:
        pb = self._prop(b)
        self.places.setdefault(b, (0.0, 0.0, 0.0))
        x, y, _ = self.places[b]
        height = next(
            (bounds(c.value, (1, 1))[0] / 100 for c in node.constraints if c.quantity == "height"),
            1.0,
        )
        self.places[a] = (x, y, 0.0)
        self.frames[a] = Frame(x, y, 0.0)
        self.heights[a] = pb.height + height
        self.tracks[a].time += math.sqrt(2.0 * height / 9.81)

    def _enters(self, node: TimelineNode) -> None:
        """The target region's owner is put in the way, its opening towards the mover."""
        mover = self._key(node.participants[0])
        owner = (node.region or "/").split("/")[0]
        incoming = dict(self._incoming(node))
        if owner not in self.doc.spatial_relation_graph.nodes:
            return
        if mover in incoming:
            self._approach(node, mover, incoming[mover], owner)
        elif mover in self.moving:
            self._chain(node, mover, owner)
        if owner in self.places:
            x, y, _ = self.places[owner]
            track = self.moving.get(mover) or self.tracks.get(mover)
            heading = (
                track.heading + (self.frames[mover].angle if mover in self.frames else 0.0)
                if track
                else 0.0
            )
            self.places[owner] = (x, y, heading + math.pi)
            self.time[node.id] = track.time if track else 1.0
        self.time.setdefault(node.id, 1.0)

    def _impact(self, node: TimelineNode, a: str, b: str) -> None:
        """After the hit, b runs on along a's heading and a keeps the rest of the momentum."""
        if a in self.tracks and a in self.frames:
            source, frame = self.tracks[a], self.frames[a]
        else:
            source, frame = self.moving.get(a, Track()), Frame()
        self.time[node.id] = source.time
        if node.event is not NodeEvent.COLLISION or b in self.tracks:
            return
        pa, pb = self._prop(a), self._prop(b)
        if pb.fixed or b not in self.places:
            return
        speed = impact_speed(
            pa.mass, pb.mass, source.speed, 0.5 * (pa.restitution + pb.restitution)
        )
        x, y, _ = self.places[b]
        heading = source.heading + frame.angle
        self.moving[b] = Track(x, y, heading, speed, source.time, [(x, y)])
        source.speed = max(0.05, source.speed - pb.mass / pa.mass * speed)

    # -- helpers -----------------------------------------------------------------------------

    def _advance(self, actor: str, phase: Phase, duration: float) -> None:
        """Moves an actor through a phase whose end is set by time."""
        track, edge = self.tracks[actor], phase.edge
        if edge.event is EdgeEvent.BRAKE:
            speed = track.speed or self._speed(actor, phase)
            low, high, fixed = bounds(edge.params.damping, (0.3, 8.0))
            stop = phase.end.event is NodeEvent.STOP
            if stop:
                damping = stopping_damping(speed, duration, coasting_drag(self._prop(actor)))
            else:
                damping = -math.log(0.4) / duration
            damping = low if fixed else min(max(damping, low), high)
            self.nominal[f"{edge.id}/damping"] = damping
            distance = braking_distance(speed, damping, duration)
            track.straight(distance, duration, speed * math.exp(-damping * duration))
            return
        speed = self._speed(actor, phase)
        if edge.event is EdgeEvent.ACCELERATED_MOTION:
            low, high, fixed = bounds(edge.params.acceleration, (100.0, 400.0))
            rate = (low if fixed else middle(low, high) if low > 0 else 0.5 * (low + high)) / 100.0
            start = (
                track.speed if track.time > 0 else (speed if edge.params.speed is not None else 0.5)
            )
            self.nominal[f"{edge.id}/acceleration"] = rate
            self.nominal[f"{edge.id}/speed"] = start
            end = max(0.0, start + rate * duration)
            track.straight(0.5 * (start + end) * duration, duration, end)
            return
        self.nominal[f"{edge.id}/speed"] = speed
        track.straight(speed * duration, duration, speed)

    def _slides(self, actor: str, phase: Phase) -> bool:
        """Pushed or slid along the ground, so that friction takes its speed."""
        body = self._prop(actor)
        flat = self.story.force[actor] is not ForceDirection.ANY_3D
        return phase.edge.event is EdgeEvent.TOWARD and flat and not (body.rolls or body.wheeled)

    def _speed(self, actor: str, phase: Phase, least: float = 0.0) -> float:
        """A plausible speed [m/s] of at least `least` within the segment's bounds."""
        preferred = max(default_speed(self._prop(actor)), least)
        if phase.edge.params.speed is None:
            return self.tracks[actor].speed or preferred
        low, high, fixed = bounds(phase.edge.params.speed, (100.0, 1000.0))
        if fixed:
            return low / 100.0
        inner = 0.1 * (high - low)
        return min(max(preferred, (low + inner) / 100.0), (high - inner) / 100.0)

    def _fixed(self, phase: Phase) -> bool:
        return bounds(phase.edge.params.speed, (1.0, 2.0))[2]

    def _prescribed_time(self, node: TimelineNode) -> float | None:
        """Absolute time [s] the prompt asks for, or None."""
        for c in node.constraints:
            if c.quantity == "time_since" and c.since in self.time:
                low, high, _ = bounds(c.value, (1.0, 1.0))
                return self.time[c.since] + 0.5 * (low + high)
        if node.time_is_prescribed and node.timestamp is not None:
            return node.timestamp
        if node.time_is_prescribed and node.window is not None:
            return 0.5 * (node.window[0] + node.window[1])
        return None

    def _stop_time(self, node: TimelineNode) -> float:
        for c in node.constraints:
            if c.quantity == "time_to_stop":
                low, high, _ = bounds(c.value, (2.0, 2.0))
                return 0.5 * (low + high)
        return 2.0

    def _reverse(self, actor: str) -> float:
        """Yaw added for a body that drives backwards."""
        low = self.story.phases[actor][0].edge.params.speed
        return math.pi if isinstance(low, (int, float)) and low < 0 else 0.0

    def _free_frame(self, actor: str) -> Frame:
        """A start beside everything placed so far, for an unrelated second path."""
        _ = actor
        return Frame(0.0, max(y for _, y, _ in self.places.values()) + 4.0, 0.0)

    def _free_heading(self, x: float, y: float) -> float:
        """An approach direction towards (x, y) far from those already in use."""
        used = [
            math.atan2(y - f.apply(0, 0)[1], x - f.apply(0, 0)[0]) for f in self.frames.values()
        ]
        used += [t.heading for t in self.moving.values()]
        used += [t.heading + math.pi for t in self.moving.values()]
        options = [math.pi, math.pi / 2, -math.pi / 2, 0.75 * math.pi, -0.75 * math.pi, 0.0]
        return max(options, key=lambda o: min([abs(_wrap(o - u)) for u in used], default=1.0))

    def _enter_beside(self, actor: str) -> None:
        frame = Frame() if not self.places else self._free_frame(actor)
        self.frames[actor] = frame
        x, y = frame.apply(0.0, 0.0)
        self.places[actor] = (x, y, frame.angle)
        if self.story.force[actor] is ForceDirection.ANY_3D:
            self.heights[actor] = 1.0

    def _place_for_fall(self, node: TimelineNode) -> None:
        """What shall fall off its support starts near the edge that its motion leads to."""
        if self.anchor is None or not node.participants:
            return
        name = self._key(node.participants[0])
        config = self.doc.asset_configurations[
            self.doc.spatial_relation_graph.nodes[self.anchor].asset_id
        ]
        if name not in self.places or not config.support_surfaces:
            return
        surface = config.support_surfaces[0]
        across = surface.half_extents_cm[1] < surface.half_extents_cm[0]
        edge = surface.half_extents_cm[1 if across else 0] / 100.0
        x, y, _ = self.places[name]
        angle = math.pi / 2 if across else 0.0
        shift = edge - 0.6 * self._prop(name).half_length - 0.05 - x
        moved = {k: (px + shift, py - y, yaw) for k, (px, py, yaw) in self.places.items()}
        turn = Frame(angle=angle)
        for key, (px, py, yaw) in moved.items():
            cx, cy = surface.center_cm[0] / 100.0, surface.center_cm[1] / 100.0
            tx, ty = turn.apply(px, py)
            self.places[key] = (cx + tx, cy + ty, None if yaw is None else yaw + angle)
        self.frames = {a: Frame(*self.places[a][:2], self.places[a][2] or 0.0) for a in self.frames}

    def _key(self, name: str) -> str:
        group = self.story.group_of.get(name)
        patterned = group and self.doc.spatial_relation_graph.nodes[name].group_pattern
        return f"group:{group}" if group and patterned else name

    def _member(self, key: str) -> str:
        return self.story.groups[key[6:]][0] if key.startswith("group:") else key

    def _prop(self, key: str) -> Prop:
        found = prop(self.doc, self._member(key))
        return replace(found, grouped=True) if key.startswith("group:") else found

    # -- billiards and other pockets ---------------------------------------------------------

    def _pocket_event(self) -> TimelineNode | None:
        for node in self.story.nodes.values():
            owner = (node.region or "").split("/")[0]
            inside = node.event is NodeEvent.ENTER_REGION and owner == self.anchor
            if inside and owner and self._concerns(node):
                return node
        return None

    def _play_pocket(self, event: TimelineNode) -> None:
        """A shot planned backwards from the pocket: ball, ghost ball, cue ball."""
        assert self.anchor is not None and event.region is not None
        chain = self._chain_to(event)
        spots = pocket_shot(self.doc, self.anchor, event.region, chain, self.rng)
        time = 0.0
        for name, (x, y, yaw) in spots.items():
            self.places[name] = (x, y, yaw)
            if name in self.tracks:
                self.frames[name] = Frame(x, y, yaw)
        for node in self.story.nodes.values():
            for actor, phase in self._incoming(node):
                speed = min(self._speed(actor, phase), 2.5)
                if self._fixed(phase):
                    speed = self._speed(actor, phase)
                self.nominal[f"{phase.edge.id}/speed"] = speed
            if node.event is not NodeEvent.SCENE_START and set(node.participants) & self.names:
                time += 0.5
            self.time[node.id] = time

    def _concerns(self, node: TimelineNode) -> bool:
        return bool(set(node.participants) & self.names)

    def _chain_to(self, event: TimelineNode) -> list[str]:
        """Bodies from the one that enters back to the active one that starts it."""
        chain = [event.participants[0]]
        hits = [n for n in self.story.nodes.values() if n.event is NodeEvent.COLLISION]
        while not self.story.is_active(chain[-1]):
            source = next(
                (
                    p
                    for n in hits
                    if chain[-1] in n.participants
                    for p in n.participants
                    if p not in chain
                ),
                None,
            )
            if source is None:
                break
            chain.append(source)
        return chain

    # -- result ------------------------------------------------------------------------------

    def constellation(self) -> Constellation:
        placements = tuple(
            Placement(
                node=key,
                x_cm=100.0 * x,
                y_cm=100.0 * y,
                yaw_deg=None if yaw is None else math.degrees(yaw),
                z_cm=100.0 * self.heights[key] if key in self.heights else None,
            )
            for key, (x, y, yaw) in self.places.items()
        )
        everyone = tuple(self.places)
        corridors: list[Corridor] = []
        for name, track in {**self.tracks, **self.moving}.items():
            frame = self.frames.get(name, Frame()) if name in self.tracks else Frame()
            points = [frame.apply(*p) for p in track.points]
            end = track.heading + frame.angle
            run_out = RUN_OUT_M * self.tight
            points.append(
                (points[-1][0] + run_out * math.cos(end), points[-1][1] + run_out * math.sin(end))
            )
            width = self._prop(name).half_width + CLEARANCE_M * self.tight
            corridors.append(
                Corridor(tuple((100.0 * x, 100.0 * y) for x, y in points), 100.0 * width, everyone)
            )
        return Constellation(placements, tuple(corridors), anchor=self.anchor)


def turn_of(phase: Phase) -> tuple[float, float]:
    """Degrees and sign (left = +1) of a Turn phase, from the edge or its end node."""
    params, node = phase.edge.params, phase.end
    low, high, _ = bounds(params.turn_degrees, (90.0, 90.0))
    degrees = 0.5 * (low + high) if params.turn_degrees is not None else (node.turn_degrees or 90.0)
    side = params.turn_direction or node.turn_direction or "left"
    return degrees, 1.0 if side == "left" else -1.0


def _wrap(angle: float) -> float:
    return (angle + math.pi) % (2.0 * math.pi) - math.pi
