"""What every reading of a verb needs: entities, places, quantities and events."""

from __future__ import annotations

from typing import Any

from esg.draft.frames import Frame
from esg.draft.quantities import Amount
from esg.draft.scene import Relation, Scene, pocket_name
from esg.draft.syntax import Mention
from esg.draft.timeline import START, TimelineBuilder
from esg.draft.world import Entity, World
from esg.graph.models import EventConstraint, NodeEvent, Quantity, Role

Time = tuple[Quantity, Amount, str]
"""A stated time, its amount in the prompt, and "at" (absolute) or "after"."""
RELATION_PREPS: dict[str, str] = {
    "on": "on",
    "onto": "on",
    "upon": "on",
    "atop": "on",
    "under": "under",
    "beneath": "under",
    "below": "under",
    "underneath": "under",
    "in front of": "in_front_of",
    "behind": "behind",
    "left of": "left_of",
    "right of": "right_of",
    "near": "near",
    "beside": "adjacent",
    "next to": "adjacent",
    "by": "near",
    "alongside": "adjacent",
    "far from": "far_from",
    "above": "above",
    "over": "above",
    "inside": "inside_of",
    "in": "inside_of",
    "within": "inside_of",
    "against": "adjacent",
    "around": "near",
    "at": "near",
    "in the middle of": "center_of",
    "opposite": "near",
    "between": "between",
    "among": "near",
    "across": "near",
    "outside": "near",
    "along": "near",
    "close": "near",
}


class Core:
    """Access to the scene under construction."""

    def __init__(self, world: World, text: str) -> None:
        self.world = world
        self.text = text
        self.tl = TimelineBuilder()
        self.scene = Scene(world, self.tl)
        self.aim: dict[str, str] = {}
        """Last thing an actor moves towards."""
        self.last_hit: tuple[str, str] | None = None
        self.mentions: list[Mention] = []
        self.framed: set[int] = set()
        """Noun phrases that are arguments of a verb."""
        self.pending: dict[str, tuple[NodeEvent, Frame, str | None, Time | None]] = {}
        """Arrivals ("walks to the door") and falls that a later event may replace."""
        self._patient: list[str] = []
        self._last_subject: list[str] = []
        self.stated: dict[str, Amount] = {}
        """Speeds stated with the noun ("a car at 50 km/h")."""
        self._topic: tuple[int, list[str]] | None = None
        """Sentence and subject of the last description of a state."""
        self.own_speed: dict[str, Amount] = {}
        """Speeds stated one for each ("two trains at 20 m/s and 30 m/s")."""
        self.rolling: set[str] = set()
        """What the prompt says rolls or slides."""
        self.gap: Amount | None = None
        """Time until the next event ("brakes 2 seconds before ...")."""
        self.mounts: dict[int, list[str]] = {}
        """What the person of a subject phrase rides or drives."""
        self.thrown: dict[int, list[str]] = {}
        """What the person of a subject phrase launched last."""

    def e(self, node: str) -> Entity:
        return self.world.entities[node]

    def kind(self, node: str) -> str:
        return self.e(node).noun.kind

    def structural(self, node: str) -> bool:
        return "structural" in self.e(node).noun.traits

    def _aimable(self, node: str) -> bool:
        return not self.structural(node) and self.kind(node) != "region"

    def movable(self, node: str) -> bool:
        return self.e(node).movable

    def use(self, item: Amount | Frame | Mention | None, note: str) -> None:
        if item is None:
            return
        if isinstance(item, Frame):
            self.scene.used[(item.verb.start, item.verb.end)] = note
        else:
            self.scene.used[(item.start, item.end)] = note

    def describe(self, f: Frame) -> str:
        ends = [f.verb.end]
        starts = [f.verb.start]
        for m in (f.subject, f.object):
            if m is not None:
                starts.append(m.start)
                ends.append(m.end)
        for p in f.phrases:
            if p.mention is not None:
                ends.append(p.mention.end)
            if p.amount is not None:
                ends.append(p.amount.end)
        if max(ends) - min(starts) > 160:
            return self.text[f.verb.start : f.verb.end]
        return self.text[min(starts) : max(ends)]

    def ids(
        self, m: Mention | None, subject: bool = False, avoid: list[str] | None = None
    ) -> list[str]:
        if m is None:
            return []
        return self.world.resolve(m, subject=subject, avoid=avoid)

    def amounts(self, f: Frame) -> list[tuple[str, Amount]]:
        """(preposition, amount) of a frame, those inside attribute phrases included."""
        out: list[tuple[str, Amount]] = []
        for p in f.phrases:
            if p.amount is not None:
                out.append((p.prep, p.amount))
            if p.mention is not None:
                out += [(p.prep, a) for a in p.mention.amounts if p.mention.attribute]
                for m in p.mention.coordinated:
                    out += [(p.prep, a) for a in m.amounts if m.attribute]
        for m in (f.object, f.object2):
            if m is not None and m.attribute:
                out += [("", a) for a in m.amounts]
        if f.subject is not None:
            out += [("", a) for a in f.subject.amounts if a.dimension == "speed"]
        return out

    def quantity(self, f: Frame, dimension: str) -> tuple[str, Amount] | None:
        return next(((p, a) for p, a in self.amounts(f) if a.dimension == dimension), None)

    def place(
        self,
        things: list[str],
        others: list[str],
        prep: str,
        part: str = "",
        distance: Quantity | None = None,
    ) -> None:
        """Records where things are with respect to others."""
        kind = RELATION_PREPS.get(prep)
        if kind is None or not others:
            return
        if part:
            words = part.split()
            if (
                words[-1] in ("edge", "corner", "rim", "end")
                and "support" in self.e(others[0]).noun.traits
            ):
                kind = "on"
            elif words[-1] in ("middle", "center", "centre"):
                kind = "center_of"
            elif words[-1] in ("side", "front", "back", "end", "left", "right") and kind in (
                "on",
                "near",
                "inside_of",
            ):
                kind = {"front": "in_front_of", "back": "behind"}.get(words[-1], "adjacent")
            elif words[-1] in ("bottom", "foot", "base") and kind != "on":
                kind = "near"
        other = others[0]
        for t in things:
            if t == other or t not in self.world.entities:
                continue
            if self.structural(t):
                continue
            if self.structural(other):
                self.scene.relations.append(Relation(t, other, "structural", text=prep))
                continue
            if kind == "inside_of" and not self._holds(other):
                kind = "on" if "support" in self.e(other).noun.traits else "near"
            if kind == "on" and self.kind(other) in ("ball", "billiard"):
                kind = "near"
            if self._towers(t) and kind in ("above", "on", "under"):
                continue  # "on the wall above the sofa": what hangs there is above, not the wall
            if kind == "on" and self.kind(t) == "wallhung" and self._towers(other):
                self.scene.attached[t] = other
                self.scene.relations.append(Relation(t, other, "attached_vertical"))
                continue
            if kind == "between" and len(others) < 2 and len(things) >= 1:
                kind = "near"
            if kind == "between":
                self.scene.relations.append(Relation(t, others[0], "between", text=others[1]))
                continue
            if kind == "on":
                if t in self.scene.supported_by or self._rests_on(other, t):
                    continue
                self.scene.supported_by[t] = other
            elif kind == "inside_of":
                if t in self.scene.supported_by or self._rests_on(other, t):
                    continue
                self.scene.supported_by[t] = other
                self.scene.inside_of[t] = other
            self.scene.relations.append(Relation(t, other, kind, distance))

    def _towers(self, node: str) -> bool:
        """Walls and buildings: fixed, and taller than things are stacked."""
        return self.kind(node) in ("wall", "building") and not self.movable(node)

    def _rests_on(self, a: str, b: str) -> bool:
        seen: set[str] = set()
        while a in self.scene.supported_by and a not in seen:
            seen.add(a)
            a = self.scene.supported_by[a]
            if a == b:
                return True
        return a == b

    def _holds(self, node: str) -> bool:
        return bool({"container", "goal"} & self.e(node).noun.traits)

    def _elevated(self, node: str) -> bool:
        noun = self.e(node).noun
        return not self.structural(node) and (
            "support" in noun.traits
            or noun.kind
            in (
                "box",
                "building",
                "wall",
                "plant",
                "block",
                "vehicle",
                "statue",
                "barrel",
                "appliance",
                "cart",
                "furniture",
                "seat",
            )
        )

    def _free(self, nodes: list[str]) -> None:
        for node in nodes:
            if not self.structural(node):
                self.e(node).freed = True

    def _representatives(self, targets: list[str], movers: list[str]) -> list[str]:
        """A plural counts as one target: its first member."""
        out: list[str] = []
        seen: set[str] = set()
        for t in targets:
            group = self.e(t).group
            if t in movers:
                continue
            if group is not None and not self.e(t).letter and not self.e(t).place:
                if group in seen:
                    continue
                seen.add(group)
            out.append(t)
        return out

    def _time(self, f: Frame) -> Time | None:
        for p, a in self.amounts(f):
            if a.dimension == "time" and self._precedes(a):
                continue
            if a.dimension == "time" and p in (
                "after",
                "in",
                "within",
                "at",
                "by",
                "",
                "exactly",
                "about",
                "around",
                "before",
                "later",
            ):
                value: Quantity = a.value
                if p == "within" or a.bound == "max" or p == "before":
                    value = (0.05 * a.high, a.high)
                elif a.bound == "min":
                    value = (a.low, 2.0 * a.low + 1.0)
                mode = "at" if p == "at" else "after"
                return value, a, mode
        return None

    def event(
        self,
        kind: NodeEvent,
        participants: tuple[str, ...],
        f: Frame,
        time: Time | None,
        **extra: Any,
    ) -> str:
        """Adds a point event with the stated time, absolute or relative."""
        mover = participants[0]
        if extra.get("stem") != "brake":
            self._settle(mover, kind, participants[1] if len(participants) > 1 else None)
        stop_timed = kind is NodeEvent.STOP
        previous = self.tl.last_event
        node_id = ""
        if time is not None and (time[1].start, time[1].end) in self.scene.used:
            time = None
        if time is not None and (previous is None or time[2] == "at") and not stop_timed:
            node_id = self.tl.event(
                kind, participants, self.describe(f), time=time[0], prescribed=True, **extra
            )
        else:
            node_id = self.tl.event(kind, participants, self.describe(f), **extra)
        draft = self.tl.node(node_id)
        assert draft is not None
        if time is not None:
            self.use(time[1], f"time of {node_id}")
            if stop_timed:
                braked = any(e.to == node_id and e.event.value == "Brake" for e in self.tl.edges)
                if braked:
                    draft.constraints.append(
                        EventConstraint(quantity="time_to_stop", object=mover, value=time[0])
                    )
                elif previous is None:
                    draft.time, draft.time_prescribed = time[0], True
                else:
                    draft.constraints.append(
                        EventConstraint(
                            quantity="time_since",
                            object=mover,
                            value=time[0],
                            since=previous,
                        )
                    )
            elif previous is not None and time[2] != "at":
                draft.constraints.append(
                    EventConstraint(
                        quantity="time_since", object=mover, value=time[0], since=previous
                    )
                )
        if self.gap is not None and previous is not None and kind is not NodeEvent.TRIGGER:
            draft.constraints.append(
                EventConstraint(
                    quantity="time_since", object=mover, value=self.gap.value, since=previous
                )
            )
            self.use(self.gap, f"time of {node_id}")
            self.gap = None
        lasting = next(
            (
                e.params.duration
                for e in self.tl.edges
                if e.to == node_id and e.from_ == START and e.actor == mover and e.params.duration
            ),
            None,
        )
        if lasting is not None and draft.time is None and kind is not NodeEvent.STOP:
            draft.time, draft.time_prescribed = lasting, True  # "rolls for 2 s and then hits"
        travelled = self.scene.travel.pop(mover, None)
        if travelled is not None:
            draft.constraints.append(
                EventConstraint(quantity="distance", object=mover, value=travelled.value)
            )
        self.use(f, node_id)
        return node_id

    def _settle(self, actor: str | None, kind: NodeEvent | None, target: str | None = None) -> None:
        """Turns a pending arrival or landing into an event, unless a stronger event replaces it."""
        for name in list(self.pending):
            if actor is not None and name != actor:
                continue
            event, f, other, time = self.pending.pop(name)
            if event is NodeEvent.FALL and f.verb.sense == "fall":
                self.event(event, (name,), f, time)
                continue
            if event in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION) and other is not None:
                self._land_aim(f, name, other, kind, target, time)
                continue
            replaced = kind in (
                NodeEvent.COLLISION,
                NodeEvent.ENTER_REGION,
                NodeEvent.REACH,
                NodeEvent.TOPPLE,
                NodeEvent.FALL,
            ) and (event is NodeEvent.FALL or target in (other, None))
            if replaced or (event is NodeEvent.REACH and kind is NodeEvent.STOP):
                continue
            participants = (name,) if other is None else (name, other)
            self.event(event, participants, f, time)

    def _land_aim(
        self,
        f: Frame,
        name: str,
        other: str,
        kind: NodeEvent | None,
        target: str | None,
        time: Time | None,
    ) -> None:
        """What was thrown at something hits it, unless it does something else with it instead."""
        group = self.e(other).group
        same = target == other or (
            target is not None and group is not None and self.e(target).group == group
        )
        blocked = self._enterable(other) and kind is not None
        if kind in (NodeEvent.MISS, NodeEvent.ENTER_REGION) or same or blocked:
            return
        track = self.tl.tracks.get(name)
        if track is None or track.motion is None or track.closed:
            return
        if self._enterable(other):
            self.enter(f, name, other, None, time)
        else:
            self.event(NodeEvent.COLLISION, (name, other), f, time)
            self.last_hit = (name, other)

    def _enterable(self, node: str) -> bool:
        noun = self.e(node).noun
        return noun.kind in ("region", "goal", "hole", "hoop", "water") or "goal" in noun.traits

    def _precedes(self, a: Amount) -> bool:
        """Whether a time says how long before the next event: "2 seconds before B hits"."""
        return self.text[a.end : a.end + 8].lower().startswith(" before ")

    def _read_as(self, sense: str, f: Frame, s: list[str], o: list[str]) -> None:
        """Reads the frame as if its verb had another sense."""
        getattr(self, f"_do_{sense}")(f, s, o)

    def _start_height(self, things: list[str], a: Amount) -> None:
        """Things start this high above the ground."""
        for t in things:
            self.scene.heights[t] = a.value
            self.tl.start_constraints.append(
                EventConstraint(quantity="height", object=t, value=a.value)
            )
        self.use(a, "start height")

    def _speed_after(self, body: str, a: Amount) -> bool:
        for draft in reversed(self.tl.nodes):
            if draft.event is NodeEvent.COLLISION and body in draft.participants:
                draft.constraints.append(
                    EventConstraint(quantity="speed_after", object=body, value=a.value)
                )
                self.use(a, f"speed after {draft.id}")
                return True
        return False

    def _moved_by_others(self, actor: str) -> bool:
        track = self.tl.tracks.get(actor)
        return track is not None and track.hit and track.role is Role.PASSIVE

    def _airborne(self, actor: str) -> bool:
        track = self.tl.tracks.get(actor)
        if track is None:
            return False
        if track.motion is not None and track.motion.mode in ("throw", "drop", "fly"):
            return True
        return any(e.actor == actor and e.params.elevation_deg is not None for e in self.tl.edges)

    def enter(
        self,
        f: Frame,
        actor: str,
        other: str,
        m: Mention | None,
        time: Time | None,
    ) -> None:
        noun = self.e(other).noun
        if noun.kind == "region":
            host = next(
                (i for i, e in self.world.entities.items() if e.noun.kind == "billiardtable"), ""
            )
            region = f"{host or 'billiard_table_1'}/{pocket_name(self.e(other).adjectives)}"
            self.scene.needs.append(("billiard_table", actor))
        else:
            region = f"{other}/inside"
        node = self.event(NodeEvent.ENTER_REGION, (actor,), f, time, region=region)
        draft = self.tl.node(node)
        if draft is not None:
            draft.extra["region"] = region
