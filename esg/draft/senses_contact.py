"""Verbs of contact: hit, strike, collide, crash, trip, catch."""

from __future__ import annotations

import re

from esg.draft.acts import WAYS
from esg.draft.core import Time
from esg.draft.frames import Frame, Phrase
from esg.draft.quantities import Amount
from esg.draft.scene import SELF_POWERED
from esg.draft.senses_fall import FallSenses
from esg.graph.models import EventConstraint, NodeEvent

_MEETING = frozenset({"collide", "crash", "meet", "smash", "bump", "make", "come", "connect"})
_NO_THINGS = frozenset(
    {"way", "path", "course", "air", "speed", "time", "sky", "direction", "limit"}
)
"""Objects of "blocks", "hits" and the like that nothing touches."""
_PLACES_HIT = frozenset(
    {"middle", "center", "centre", "mark", "target", "side", "end", "back", "top"}
)
_AHEAD = frozenset({"in front of", "before"})
_STUMBLING = frozenset({"trip", "stumble"})
_BESIDE = re.compile(
    r"\s*(?:,\s*)?(?:\(|at|with\s+(?:an?\s+)?(?:constant\s+)?(?:speed|velocity)\s+of|doing|going"
    r"|(?:which\s+is\s+|that\s+is\s+)?(?:moving|travell?ing|driving|rolling|sliding|coming)"
    r"(?:\s+\w+){0,4}\s+(?:at|with))\s*",
    re.IGNORECASE,
)
"""What may stand between a thing and its own speed."""
_CATCHING = frozenset({"catch", "block", "intercept", "parry", "deflect"})


_FELLING = frozenset({"flatten", "take", "mow", "level", "floor", "demolish"})
"""Hits that skittles and dominoes do not stand."""


class ContactSenses(FallSenses):
    """Collisions."""

    def _do_hit(self, f: Frame, s: list[str], o: list[str]) -> None:
        struck = s if f.verb.passive else o
        out = f.verb.lemma != "take" or "out" in self.text[f.verb.start : f.verb.end + 5].split()
        felled = f.verb.lemma in _FELLING and out and bool(struck)
        if felled and self.kind(struck[0]) in ("pin", "domino"):
            self._read_as("knock", f, s, o)  # "takes out eight pins"
            for pin in struck if len(struck) <= 3 else struck[:1]:
                self.event(NodeEvent.TOPPLE, (pin,), f, None)
            return
        time = self._time(f)
        if f.object is not None and f.object.attribute and not o:
            o = []
        if f.verb.passive and f.verb.extra.get("motion") and f.phrase("by") is None:
            f.verb.passive = False  # "is reversed into a lamp post"
            o = [i for i in o if i not in s]
        if f.verb.passive and f.verb.lemma == "stick" and o and f.phrase("by") is None:
            f.verb.passive = False  # "gets stuck in a bush"
        if f.verb.passive and self._caught(f, s):
            return
        if f.verb.passive:
            by = f.phrase("by")
            by = by or f.phrase("with")
            movers = by.mention.entities if by is not None and by.mention is not None else []
            if not movers:
                movers = self._whose_way(f, s)
            if not movers:
                movers = [
                    a for a, t in self.tl.tracks.items() if t.motion is not None and a not in s
                ][-1:]
            if not movers and s:
                if self.quantity(f, "angle") is not None:
                    self._motion_of_things(f, s, "throw")
                else:
                    self._motion(f, s, None)  # "a cue ball is struck at 3 m/s"
                return
            targets = s
        else:
            movers, targets = s, self._hit_targets(f, s, o)
            if f.verb.lemma in _CATCHING and not set(targets) & set(self.pending):
                targets = list(self.pending)[-1:] or targets  # "but the keeper catches it"
            if not s and o and f.subject is None:
                # imperative "hit the ball into the goal": a launch
                self._do_launch(f, s, o)
                return
        if (
            movers
            and all(self.kind(m) == "person" for m in movers)
            and targets
            and (not f.verb.passive or f.reduced)
            and f.verb.lemma in ("hit", "strike", "tap", "smack", "whack")
            and self.kind(targets[0]) in ("ball", "billiard", "sliding")
        ):
            self._launch_by(f, movers, targets)
            return
        host = f.phrase("on", "in", "at")
        if (
            len(movers) >= 2
            and host is not None
            and host.mention is not None
            and targets == host.mention.entities
        ):
            self.place(movers, targets, host.prep)
            targets = []
        over = self.text[f.verb.start : f.verb.end].lower().endswith("over")
        if over and targets and all(map(self._enterable, targets)):
            self._motion(f, movers, None)  # "runs over the hole": a path
            return
        flat = all(map(self.structural, targets))
        if flat and movers and not f.verb.passive and self._crashes_down(f, movers):
            return
        encounter = f.verb.lemma == "meet" and all(self.kind(m) in SELF_POWERED for m in movers)
        opposed = any("each other" in g.adverbs for g in self.told if g.sentence <= f.sentence)
        if encounter and not targets and not opposed and not {"head-on", "hard"} & set(f.adverbs):
            self._motion(f, movers, None)  # "two trains meet at a bridge"
            return
        if not targets and len(movers) >= 2:
            self._mutual(f, movers, time)
            return
        rim = f.object is not None and f.object.head in ("cushion", "rail") and f.object.attribute
        if rim and not targets:
            for mover in movers:
                self._ensure_mover(f, mover, None)
                self.scene.needs.append(("billiard_table", mover))
            self.scene.ignored[(f.verb.start, f.verb.end)] = "a part that every ball touches"
            return
        if not targets and movers and f.object is None and self._names_something(f):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "what is hit was not understood"
            return
        if not targets and f.object is not None and f.object.head in _NO_THINGS:
            self.scene.ignored[(f.verb.start, f.verb.end)] = "what is hit is no thing"
            return
        if not targets and f.verb.lemma in _STUMBLING:
            self.use(f, "stumbles")
            return
        named = f.object is not None and f.object.attribute and f.object.head not in _PLACES_HIT
        if not targets and named and not f.verb.passive and f.object.determiner in ("a", "an"):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "what is hit was not understood"
            return
        if not targets and movers:
            aimed = self.aim.get(movers[0]) or self._aim_of_mates(movers[0])
            if aimed is not None and aimed != movers[0]:
                targets = [aimed]
            else:
                targets = [
                    i
                    for ids in reversed(self.world.salience)
                    for i in ids
                    if i not in movers and not self.structural(i)
                ][:1]
        self._comes_too(f, movers, targets)
        self._kinematics(f, movers, targets)
        if f.verb.extra.get("motion") == "reverse":
            self._reverse(movers)
        for m in movers if f.verb.lemma == "run" else ():
            if self._moved_by_others(m) and self.kind(m) in ("person", "animal"):
                self._start_motion(f, [m], "own", next(iter(targets), None))
        changing = [m for m in movers if self._brakes_now(m) or self._comes_down_a_slope(m)]
        nodes = self._hit(f, movers, targets, time)
        self._speed_at_hit(f, nodes, changing)
        self._after_hit(f, nodes, targets)
        if not o and not f.verb.passive:
            seen = list(targets)
            for p in f.phrases:
                if (
                    (p.prep in ("into", "against", "through") or self._meets_with(f, p))
                    and p.mention is not None
                    and not p.mention.attribute
                ):
                    extra = [
                        i
                        for i in p.mention.entities
                        if i not in seen and i not in movers and not self.structural(i)
                    ]
                    seen += extra
                    self._hit(f, movers, extra)
        tail = f.phrase("off")
        if tail is not None and tail.mention is not None and targets:
            self._outcomes(f, targets[:1])
        elif o and f.phrase("into", "onto", "toward", "towards", "against") is not None and nodes:
            self._knock_on(f, targets[:1])

    def _whose_way(self, f: Frame, struck: list[str]) -> list[str]:
        """ "gets in the way of a tram and is hit", "runs in front of a bus": by that."""
        now = next((k for k, x in enumerate(self.told) if x.verb is f.verb), 0)
        for g in reversed(self.told[:now]):
            if g.sentence < f.sentence - 1:
                break
            about = g.subject is not None and set(g.subject.entities) & {*struck}
            for p in [Phrase("", g.object), *g.phrases] if about else ():
                m = p.mention
                if m is not None and m.head in WAYS and m.possessor is not None:
                    m = m.possessor  # "in a bus's way"
                elif m is None or (m.part not in WAYS and p.prep not in _AHEAD):
                    continue
                if set(m.entities) - {*struck}:
                    return [i for i in m.entities if i not in struck and self.movable(i)][:1]
        return []

    def _comes_too(self, f: Frame, movers: list[str], targets: list[str]) -> None:
        """ "A car at 10 m/s collides with a truck at 15 m/s": both have a speed, so both move."""
        end = max((m.end for m in self.mentions if set(m.entities) & {*targets}), default=-1)
        told = [p for p in f.phrases if self._speed_in(p) is not None]
        own = [p for p in told if p is told[0] and len(told) > 1]
        known = own or any(m in self.stated or m in self.own_speed for m in movers)
        last = self._speed_in(told[-1]) if told else None
        if last is not None and known and len(targets) == 1 and not f.verb.passive:
            between = self.text[end : last.start] if end < last.start else ""
            if end > f.verb.end and _BESIDE.fullmatch(between):
                self.stated[targets[0]] = last
                f.phrases = [p for p in f.phrases if p is not told[-1]]
        for t in targets if not f.verb.passive else ():
            track = self.tl.tracks.get(t)
            still = track is None or (track.motion is None and not track.hit)
            going = track.motion if track is not None else None
            if t in self.stated and going is not None and not going.prescribed:
                going.speed, going.prescribed = self.stated[t].value, True
                self.use(self.stated[t], "speed")
            if t in self.stated and still and self.movable(t) and t not in movers:
                head_on = "head-on" in f.adverbs and bool(movers)
                self.own_speed[t] = self.stated[t]
                self._start_motion(f, [t], None, movers[0] if head_on else None)

    @staticmethod
    def _speed_in(p: Phrase) -> Amount | None:
        """The speed that a phrase tells: "at 15 m/s", "with a speed of 1 m/s"."""
        found = next((a for a in p.told if a.dimension == "speed"), None)
        return found if found is not None and not found.shares else None

    def _caught(self, f: Frame, s: list[str]) -> bool:
        """ "is squeezed between it and the wall", "is pinned against a wall by a car"."""
        between, against = f.phrase("between"), f.phrase("against")
        p = between or against
        if p is None or p.mention is None or len(s) != 1:
            return False
        others = [i for i in p.mention.entities if i != s[0]]
        by = f.phrase("by")
        if between is None:
            others = [*(by.mention.entities if by and by.mention else []), *others]
        movers = [i for i in others if self.movable(i) and self.kind(i) in SELF_POWERED]
        moving = [i for i in movers if i in self.tl.tracks] or movers
        if len(others) != 2 or not moving:
            return False
        self._hit(f, moving[:1], s, self._time(f))
        self._hit(f, s, [i for i in others if i != moving[0]])
        return True

    @staticmethod
    def _meets_with(f: Frame, p: Phrase) -> bool:
        """ "collides with a van", not "hits the hurdle with his knee"."""
        return p.prep == "with" and f.verb.lemma in _MEETING

    def _crashes_down(self, f: Frame, movers: list[str]) -> bool:
        """ "crashes to the floor": a fall from where it stands."""
        p = f.phrase("to", "onto", "on", "down")
        if p is None or p.mention is None or not all(map(self.structural, p.mention.entities)):
            return False
        for mover in movers:
            fresh = mover not in self.tl.tracks and self.kind(mover) not in SELF_POWERED
            if fresh and p.prep == "to":
                self._place_where_hit(mover)  # "strikes a shelf; a crate crashes to the ground"
            if mover in self.scene.supported_by or (fresh and p.prep == "to"):
                self.event(NodeEvent.FALL, (mover,), f, self._time(f))
        return any(m in self.scene.supported_by for m in movers)

    def _aim_of_mates(self, mover: str) -> str | None:
        """ "The first stone misses the can. The second one hits.": the can."""
        kind = self.e(mover).noun.name
        like = [a for a in self.aim if a in self.world.entities and self.e(a).noun.name == kind]
        return self.aim[like[-1]] if like else None

    def _names_something(self, f: Frame) -> bool:
        """Whether an article follows the verb, so that there is an object that was not read."""
        after = self.text[f.verb.end : f.verb.end + 12].lower().split()
        return bool(after) and after[0] in ("a", "an", "the", "its", "his", "her")

    def _brakes_now(self, actor: str) -> bool:
        track = self.tl.tracks.get(actor)
        return track is not None and track.motion is not None and track.motion.mode == "brake"

    def _speed_at_hit(self, f: Frame, nodes: list[str], changing: list[str]) -> None:
        """ "brakes and hits the barrier at 4 m/s": the speed left, not the one driven before."""
        found = self.quantity(f, "speed")
        draft = self.tl.node(nodes[0]) if nodes else None
        if found is None or draft is None or draft.participants[0] not in changing:
            return
        draft.constraints.append(
            EventConstraint(
                quantity="speed_before", object=draft.participants[0], value=found[1].value
            )
        )
        self.use(found[1], f"speed before {draft.id}")

    def _hit_targets(self, f: Frame, s: list[str], o: list[str]) -> list[str]:
        if o:
            return o
        p = f.phrase("with", "through", "into", "against", "at", "on", "onto", "to", "in")
        if f.verb.lemma in _STUMBLING:
            p = f.phrase("over", "on", "into", "against") or p
        if p is not None and p.mention is not None and not (p.prep == "in" and p.mention.attribute):
            found = [i for i in p.mention.entities if i not in s]
            if found:
                return found
        return []

    def _after_hit(self, f: Frame, nodes: list[str], targets: list[str]) -> None:
        """Angles and the like stated with a hit."""
        angle = self.quantity(f, "angle")
        if angle is not None and nodes:
            draft = self.tl.node(nodes[0])
            if draft is not None:
                draft.constraints.append(
                    EventConstraint(
                        quantity="angle", object=draft.participants[0], value=angle[1].value
                    )
                )
                self.use(angle[1], f"angle of {nodes[0]}")

    def _mutual(self, f: Frame, movers: list[str], time: Time | None) -> None:
        """ "Two cars collide": who moves, who is hit."""
        a, b = movers[0], movers[1]
        latest = self.tl.node(self.tl.last_event or "")
        if (
            latest is not None
            and latest.event is NodeEvent.COLLISION
            and set(latest.participants) == {a, b}
            and time is None
        ):
            self.use(f, latest.id)  # "they meet and collide"
            return
        ta, tb = self.tl.tracks.get(a), self.tl.tracks.get(b)
        if (
            self.e(a).place == "front"
            or (self.e(b).place == "rear")
            or (ta is None and tb is not None)
        ):
            a, b = b, a
        moving = [
            m
            for m in (a, b)
            if (t := self.tl.tracks.get(m)) is not None and (t.motion is not None or t.hit)
        ]
        if not moving:
            driven = any(self.kind(m) in SELF_POWERED for m in (a, b))
            driven = driven or all(m in self.stated or m in self.own_speed for m in (a, b))
            for m in (a, b) if driven else (a,):
                if self.movable(m):
                    self._start_motion(f, [m], None, b if m == a else a)
        self._hit(f, [a], [b], time)
