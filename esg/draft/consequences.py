"""What a hit does to what is hit: knocked on, off or over, carried along."""

from __future__ import annotations

from esg.draft.acts import Acts
from esg.draft.events import PUSHING
from esg.draft.frames import Frame, Phrase
from esg.graph.models import NodeEvent


class Consequences(Acts):
    """Bodies after a hit."""

    def _knock_on(self, f: Frame, bodies: list[str]) -> None:
        """ "hits the ball into the pocket": what happens to the body that was hit."""
        bodies = self._representatives(bodies, [])
        for p in f.phrases:
            if (
                p.mention is not None
                and p.mention.part in ("edge", "side", "end", "rim")
                and not p.mention.entities
            ):
                if p.prep in ("over", "off"):
                    for body in bodies:
                        self.event(NodeEvent.FALL, (body,), f, None)
                continue
            if p.mention is None or p.mention.attribute:
                continue
            others = [i for i in p.mention.entities if i not in bodies]
            if p.prep == "to" and others and self._aimable(others[0]) and not p.mention.part:
                for body in bodies:
                    if f.verb.lemma in PUSHING:
                        self.pending[body] = (NodeEvent.REACH, f, others[0], None)
                continue
            if p.prep in ("to", "onto", "on") and others and self.structural(others[0]):
                for body in bodies:
                    self._down(f, body)
                continue
            if p.prep in ("into", "onto", "in", "against", "off", "out of", "over", "from"):
                for body in bodies:
                    if not others:
                        continue
                    if p.prep in ("into", "in"):
                        self._go_into_passive(f, body, others, p)
                    elif p.prep in ("onto", "against") and not self.structural(others[0]):
                        self._hit(f, [body], others, None)
                    elif (
                        p.prep in ("off", "out of", "over", "from")
                        and (self._elevated(others[0]) or self._carries(others[0], body))
                        and (p.prep != "over" or p.mention.part)
                        and not (p.prep == "out of" and self.kind(others[0]) == "building")
                    ):
                        self.place([body], [others[0]], "on")
                        if self.last_hit is not None and self.last_hit[1] == body:
                            self._share_support(f, *self.last_hit)
                        self.event(NodeEvent.FALL, (body,), f, None)

    def _down(self, f: Frame, body: str) -> None:
        """ "knocks a glass to the floor": it falls off what it stands on, or topples."""
        if body not in self.scene.supported_by:
            hosts = [
                i
                for ids in reversed(self.world.salience)
                for i in ids
                if i != body and "support" in self.e(i).noun.traits
            ]
            if hosts:
                self.place([body], hosts[:1], "on")
        fell = body in self.scene.supported_by
        self.event(NodeEvent.FALL if fell else NodeEvent.TOPPLE, (body,), f, None)

    def _go_into_passive(self, f: Frame, body: str, others: list[str], p: Phrase) -> None:
        other = others[0]
        noun = self.e(other).noun
        if self.structural(other):
            return
        if noun.kind in ("region", "goal", "hole", "hoop", "water") or "goal" in noun.traits:
            self.enter(f, body, other, p.mention, self._time(f))
        else:
            self._hit(f, [body], others, self._time(f))

    def _already_hit(self, f: Frame, s: list[str], o: list[str]) -> bool:
        if not any(self.tl.tracks.get(b) is not None and self.tl.tracks[b].hit for b in o):
            return False
        if f.causer is not None:
            return True
        last = self.last_hit
        if last is None or last[1] not in o or f.link not in ("cause", "then", "while"):
            return False
        # "the second hits it and the third knocks it over": a hit of its own
        people = all(self.kind(i) == "person" for i in s)
        mates = {i for x in s for i in self.world.groups.get(self.e(x).group or "", [x])}
        return (
            not s
            or last[0] in s
            or (people and self.kind(last[0]) != "person")
            or (last[0] not in mates and not self._aimable(s[0]))
        )

    def _consequence(self, f: Frame, bodies: list[str]) -> None:
        words = " ".join(f.adverbs)
        if "over" in f.adverbs or "down" in f.adverbs or "upside down" in words:
            for b in self._representatives(bodies, []):
                self.event(NodeEvent.TOPPLE, (b,), f, None)
        elif self._at_last(f, "off") and f.verb.sense in ("knock", "launch", "cause"):
            for b in self._representatives(bodies, []):
                self._beside_its_mates(b)
                stacked = self.e(b).pattern == "stack" and self.e(b).in_group
                if b in self.scene.supported_by or stacked:
                    self.event(NodeEvent.FALL, (b,), f, None)

    @staticmethod
    def _at_last(f: Frame, word: str) -> bool:
        """Whether the clause ends with an adverb, "too" and the like left out."""
        rest = [a for a in f.adverbs if a not in ("too", "also", "again", "then", "instead")]
        return bool(rest) and rest[-1] == word

    def _beside_its_mates(self, body: str) -> None:
        """ "pushes the red block off the table ... and the green block off too": from there too."""
        if body in self.scene.supported_by:
            return
        for node in reversed(self.tl.nodes):
            other = node.participants[0]
            host = self.scene.supported_by.get(other, "")
            if node.event is NodeEvent.FALL and host and self.e(other).noun == self.e(body).noun:
                self.place([body], [host], "on")
                return

    def _carried_along(self, body: str) -> bool:
        """ "hits the pallet and the stack collapses": moved by a hit of its support or a mate.

        A member that the prompt names has left its plural, so that it needs a hit of its own.
        """
        last = self.tl.node(self.tl.last_event or "")
        if last is None or last.event is not NodeEvent.COLLISION or body in self.tl.tracks:
            return False
        mates = self.world.groups.get(self.e(body).group or "", [])
        movers = {i for i in mates if self.e(i).in_group} if self.e(body).in_group else set()
        host = self.scene.supported_by.get(body)
        while host is not None and host not in movers:
            movers.add(host)
            host = self.scene.supported_by.get(host)
        if not (movers - {body}) & {*last.participants}:
            return False
        self.tl.carry(body, last.id)
        return True

    def _place_where_hit(self, thing: str) -> None:
        """Puts what comes down to the floor on what was hit, or on what its striker stands on."""
        if thing in self.scene.supported_by or thing in self.tl.tracks:
            return
        hits = [n.participants for n in self.tl.nodes if n.event is NodeEvent.COLLISION]
        strikers = {a for a, b in hits if b == thing}
        for a, b in reversed(hits):
            if thing not in (a, b) and (a in strikers or not strikers) and self._fits_on(thing, b):
                self.place([thing], [b], "on")
                return

    def _struck_before(self, f: Frame, body: str) -> None:
        """ "thrown at a bottle, which falls": the fall implies the hit."""
        if body in self.tl.tracks:
            return
        last = self.last_hit
        group = self.e(body).group
        if body in self.each and last is not None and group and self.e(last[1]).group == group:
            self._hit(f, [last[0]], [body])  # "hits two boxes and both fall"
            return
        for mover, aimed in self.aim.items():
            track = self.tl.tracks.get(mover)
            if aimed == body and track is not None and not track.closed:
                self._hit(f, [mover], [body])
                return
