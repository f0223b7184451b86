"""Verbs of what a hit leads to: knock, send, give, topple, scatter."""

from __future__ import annotations

from esg.draft.entities import OTHER
from esg.draft.frames import Frame
from esg.draft.senses_contact import ContactSenses
from esg.graph.models import NodeEvent

_LOW_CM = 40.0
"""Height of a pallet or a platform: what hits it hits what stands on it."""

_OF_ONES_OWN = frozenset({"brake", "stop", "slow", "swerve", "avoid", "wait", "accelerate"})
"""What somebody does who is forced to, and no blow does to him."""


class ToppleSenses(ContactSenses):
    """Bodies that are knocked on or over."""

    def _do_knock(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive:
            by = f.phrase("by")
            movers = by.mention.entities if by is not None and by.mention is not None else []
            s, o = list(movers), s
        if not o:
            p = f.phrase("into", "against", "on")
            if p is not None and p.mention is not None and s:
                self._do_hit(f, s, [])
            elif len(s) == 2 and not f.phrases and f.verb.lemma in ("knock", "bang", "crack"):
                self._mutual(f, s, self._time(f))  # "slide together and knock"
            return
        if self._already_hit(f, s, o):
            self.use(f, "consequence of the collision")
        elif s:
            self._kinematics(f, s, o)
            self._hit(f, s, o, self._time(f))
        self._topples_too(f, s, o)
        self._knock_on(f, o)
        self._consequence(f, o)

    def _topples_too(self, f: Frame, s: list[str], o: list[str]) -> None:
        """A member of a row that knocks over the next one falls over itself."""
        for a in s[:1]:
            group = self.e(a).group
            fallen = any(n.event is NodeEvent.TOPPLE and a in n.participants for n in self.tl.nodes)
            upright = self.kind(a) in ("domino", "pin") or "topples" in self.e(a).noun.traits
            if group is None or fallen or not upright or not self._moved_by_others(a):
                continue
            if any(self.e(b).group == group for b in o):
                self.event(NodeEvent.TOPPLE, (a,), f, None)

    def _do_cause(self, f: Frame, s: list[str], o: list[str]) -> None:
        self.use(f, "consequence")
        if f.verb.passive:
            o, s = s, []
        if not o:
            return
        if (
            f.verb.lemma in ("send", "force")
            and s
            and not self._already_hit(f, s, o)
            and f.causer is None
        ):
            if any(g.causer is f and g.verb.sense in _OF_ONES_OWN for g in self.told):
                return  # "forces a cyclist to brake": by being in the way
            if self.kind(s[0]) != "person":
                self._hit(f, s, o, self._time(f))
            else:
                self._start_motion(f, o)
        if f.verb.lemma in ("send", "force"):
            self._knock_on(f, o)
            self._consequence(f, o)
        self.world.note(o)

    def _do_lead(self, f: Frame, s: list[str], o: list[str]) -> None:
        self.use(f, "consequence")

    def _do_give(self, f: Frame, s: list[str], o: list[str]) -> None:
        body = o
        if not body:
            p = f.phrase("to")
            body = p.mention.entities if p is not None and p.mention is not None else []
        found = self.quantity(f, "speed")
        body = body or s if f.verb.passive else body  # "is given a speed of 4 m/s"
        if found is not None and body and not self._speed_after(body[0], found[1]):
            self.stated[body[0]] = found[1]
        self.use(f, "speed after the collision")

    def _do_topple(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.extra.get("down") and not any(map(self._upright, s)):
            self._motion(f, s, None)  # what goes down need not topple
            return
        off = f.phrase("off", "out of")
        if off is not None and not o and s and not f.verb.passive:
            self._read_as("fall", f, s, o)  # "a pallet tips off a forklift"
            return
        self._free(o or s)
        if (
            f.subject is not None
            and f.subject.determiner in ("each", "every")
            and f.object is not None
            and "next" in f.object.adjectives
            and s
        ):
            mates = self.world.groups.get(self.e(s[0]).group or "", s)
            s, o = (mates[:1], mates[1:2]) if len(mates) > 1 else (s, o)
        if f.verb.passive:
            by = f.phrase("by")
            agent = list(by.mention.entities) if by is not None and by.mention is not None else []
            knocked = f.verb.extra.get("contact") and not self._moved_by_others(s[0] if s else "")
            o, s = s, agent or (self._whose_way(f, s) if knocked else [])
        if o:
            bodies = self._representatives(o, s)
            movers = [m for m in s if self.kind(m) != "person"] or s
            if f.verb.lemma == "tip" and all(self.kind(m) == "person" for m in movers):
                movers = []  # tipping a thing over is no blow
            if movers and not self._already_hit(f, movers, o):
                self._hit(f, movers[:1], o, self._time(f))
            self._topples_too(f, s, bodies)
        else:
            bodies = self._representatives(s, []) if not f.verb.passive else []
        for b in bodies:
            if not self.movable(b) or (len(s) > 1 and self._has_toppled(b)):
                continue  # "a bike falls over, and all the bikes fall over": once
            self._struck_before(f, b)
            if b not in self.tl.tracks and not o:
                self._shaken(f, b)
                b = self._passed_on(f, b)
                b = self._collapsing(b) if b not in self.tl.tracks else b
            tipped = f.verb.lemma == "tip" and bool(o)
            if tipped and b not in self.tl.tracks:
                self._free([b])
            if b not in self.tl.tracks or (
                self.tl.tracks[b].motion is None and not self.tl.tracks[b].hit
            ):
                self._start_motion(f, [b], "slide")
            self.event(NodeEvent.TOPPLE, (b,), f, self._time(f))
        self._knock_on(f, bodies)

    def _passed_on(self, f: Frame, body: str) -> str:
        """Who topples first of a plural one of which was hit.

        "Hits the head pin, and every pin goes down": the head pin. "Hits the first domino; the
        remaining ones fall over": the next one, to which the row passes the blow on.
        """
        e, hit, m = self.e(body), self.last_hit, f.subject
        mates = self.world.groups.get(e.group or "", [])
        if hit is None or hit[1] not in mates or hit[1] == body or m is None:
            return body
        every = m.determiner in ("every", "all", "each") or m.pronoun in ("all", "they", "each")
        down = any(n.event is NodeEvent.TOPPLE and hit[1] in n.participants for n in self.tl.nodes)
        if every and not OTHER & {*m.adjectives} and not down:
            return hit[1]
        if e.pattern == "row" and body != mates[-1]:
            self._carried_along(body)
        return body

    def _collapsing(self, body: str) -> str:
        """The top member of a stack that nothing has touched: the bottom one rarely tips."""
        e = self.e(body)
        mates = self.world.groups.get(e.group or "", [])
        tracked = any(i in self.tl.tracks for i in mates)
        return mates[-1] if e.pattern == "stack" and mates and not tracked else body

    def _shaken(self, f: Frame, body: str) -> None:
        """ "hits the pallet and the stack of boxes collapses": the blow reaches the stack."""
        last = self.tl.node(self.tl.last_event or "")
        e = self.e(body)
        if last is None or self.last_hit is None or last.event is not NodeEvent.COLLISION:
            return
        mates = self.world.groups.get(e.group or "", [])
        striker, host = self.last_hit
        if e.pattern != "stack" or self.last_hit != last.participants or {striker, host} & {*mates}:
            return
        if body not in self.scene.supported_by and self._fits_on(body, host):
            self.place(mates, [host], "on")
        low = (self.e(host).dimensions_cm or self.e(host).noun.dimensions_cm)[2] <= _LOW_CM
        if low and self.scene.supported_by.get(body) == host:
            self._carried_along(body)

    def _upright(self, node: str) -> bool:
        traits = self.e(node).noun.traits
        return "topples" in traits or self.kind(node) in ("domino", "pin", "plant", "post", "wall")

    def _do_scatter(self, f: Frame, s: list[str], o: list[str]) -> None:
        bodies = o or s
        if o and s and not self._already_hit(f, s, o):
            self._hit(f, s[:1], o, self._time(f))
        if bodies and self.kind(bodies[0]) in ("pin", "domino"):
            self.event(NodeEvent.TOPPLE, (self._representatives(bodies, [])[0],), f, None)
        self.use(f, "scatter")
