"""What every reading of a verb needs: entities, places, quantities and events."""

from __future__ import annotations

from esg.draft.elements import Mention
from esg.draft.entities import Entity
from esg.draft.frames import Frame, Phrase
from esg.draft.quantities import Amount
from esg.draft.scene import MAX_TIME_S, Scene
from esg.draft.shares import dealt
from esg.draft.timeline import TimelineBuilder
from esg.draft.world import World
from esg.graph.models import NodeEvent, Quantity

Time = tuple[Quantity, Amount, str]
"""A stated time, its amount in the prompt, and "at" (absolute) or "after"."""


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
        self._ways: tuple[int, set[str]] = (-1, set())
        """A sentence, and what its clauses go along or through."""
        self._reasons: set[str] = set()
        """What something is done for ("brakes for a cow")."""
        self._stood: dict[int, list[str]] = {}
        """What the first clause of a sentence is about: its lone object, else its subject."""
        self._mains: dict[int, tuple[list[str], list[str]]] = {}
        """Subject of a sentence's last main clause, and of a subordinate clause after it."""
        self.upon_it: set[int] = set()
        """Mentions of what another thing carries ("a cart with a box on it")."""
        self.mentions: list[Mention] = []
        self.told: list[Frame] = []
        """All clauses, in order of time."""
        self.framed: set[int] = set()
        """Noun phrases that are arguments of a verb."""
        self.pending: dict[str, tuple[NodeEvent, Frame, str | None, Time | None]] = {}
        """Arrivals ("walks to the door") and falls that a later event may replace."""
        self._patient: list[str] = []
        self._patient_at = -1
        self._last_subject: list[str] = []
        self._subject_before: list[str] = []
        """The subject before the present one."""
        self._last_moving: list[str] = []
        """What the prompt last said to move by itself."""
        self._launched: list[str] = []
        """What the clause before throws, kicks or drops."""
        self._dropped = False
        self._lead: dict[int, str] = {}
        """By sentence, the one thing it tells to move; "" if it tells of more."""
        self.stated: dict[str, Amount] = {}
        """Speeds stated with the noun ("a car at 50 km/h")."""
        self._topic: tuple[int, list[str]] | None = None
        """Sentence and subject of the last description of a state."""
        self.own_speed: dict[str, Amount] = {}
        """Speeds stated one for each ("two trains at 20 m/s and 30 m/s")."""
        self.telling: tuple[int, int, str] = (-1, -1, "")
        """Sentence and sense of the present clause, and where the verb before it stands."""
        self.came_down: set[str] = set()
        """What has dropped or fallen onto something."""
        self.rolling: set[str] = set()
        """What the prompt says rolls or slides."""
        self.flying: set[str] = set()
        """What flies by its own power."""
        self.taxiing: set[str] = set()
        """What moves on wheels, also if it could fly."""
        self.gap: Amount | None = None
        """Time until the next event ("brakes 2 seconds before ...")."""
        self.gap_of: Frame | None = None
        """The clause that tells it, whose own events do not end it."""
        self.waiting: dict[str, Amount] = {}
        """How long an actor waits before it moves (on)."""
        self.before_fall: tuple[Frame, str | None] | None = None
        """A clause that tells a fall and a landing, and what was told before it."""
        self.leaning: set[str] = set()
        """What leans on something, so that it tips over when it falls."""
        self.told_hits: set[tuple[int, str, str]] = set()
        """Collisions by the clause that tells them."""
        self.of_frame: list[tuple[Frame, str]] = []
        """Point events in the order told, with the clauses that tell them."""
        self.before: dict[str, str | None] = {}
        """By point event, what was told last before it."""
        self.at_once = -1
        """The sentence whose events all happen at the same moment."""
        self._rereading: set[tuple[int, str]] = set()
        """Frames with the senses they have been read as."""
        self.rates: dict[str, tuple[Amount, float]] = {}
        """Stated rate of braking and the speed it starts from [cm/s]."""
        self.still: dict[str, int] = {}
        """What is said not to move, and where the prompt says so."""
        self.pairs: dict[str, str] = {}
        """ "each ball hits a pin": the object of every subject."""
        self.instead = False
        """Whether the clause tells what happens in place of what was aimed at."""
        self.each: set[str] = set()
        """Members of a plural that the current clause names one by one ("both bricks")."""
        self.mounts: dict[int, list[str]] = {}
        """What the person of a subject phrase rides or drives."""
        self.thrown: dict[int, list[str]] = {}
        """What the person of a subject phrase launched last."""
        self.launched_by: dict[str, list[str]] = {}
        """What each person launched last."""

        self.attached: list[tuple[Mention, Phrase]] = []
        """Noun phrases with a place or a property."""
        self._stand_there: dict[int, list[Mention]] = {}
        """What stands at the place that a phrase names."""
        world.facts = self._facts

    def _facts(self, node: str) -> list[Amount]:
        """The quantities that the prompt tells of a node, in the order of the text."""
        out: list[Amount] = []
        for m, p in self.attached:
            listed = [p.mention, *p.mention.coordinated] if p.mention is not None else []
            told = [a for x in listed if x.attribute for a in x.amounts]
            told += [p.amount] if p.amount is not None else []
            if told and node in m.entities:
                out += dealt(told, len(m.entities))[m.entities.index(node)]
        for f in self.told:
            ids = f.subject.entities if f.subject is not None else []
            if node in ids:
                out += dealt([a for _, a in self.amounts(f)], len(ids))[ids.index(node)]
        return out

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
        out = [(p, part) for p, a in out for part in a.shares or (a,)]
        told = [(p, a) for p, a in out if a.dimension != "time" or a.high <= MAX_TIME_S]
        return [(p, a) for p, a in told if a.measure != "period"]  # "every second": what recurs

    def quantity(self, f: Frame, dimension: str) -> tuple[str, Amount] | None:
        return next(((p, a) for p, a in self.amounts(f) if a.dimension == dimension), None)
