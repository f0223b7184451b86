"""Where what falls or is dropped comes down."""

from __future__ import annotations

from esg.draft.decks import is_deck
from esg.draft.entities import BODY_PARTS, OWN_PARTS
from esg.draft.frames import Frame, Phrase
from esg.draft.scene import SELF_POWERED
from esg.draft.senses_launch import LaunchSenses
from esg.graph.models import NodeEvent


class Landings(LaunchSenses):
    """Ends of falls: on the ground, on things, in containers and water."""

    def _named(self) -> list[str]:
        return [i for ids in self.world.salience for i in ids if i in self.world.entities]

    def _landing(self, f: Frame, moved: list[str]) -> bool:
        for way in f.phrases:
            if way.prep == "through" and way.mention and self._opening(way.mention.entities):
                way.prep = "by way of"  # "drops through a hatch onto a cart"
        p = f.phrase("onto", "on", "into", "in", "through", "to", "upon")
        if p is None and f.verb.sense in ("fall", "topple"):
            p = f.phrase("against")
        m = p.mention if p is not None else None
        own_side = m is not None and m.determiner == "its" and not m.entities
        built = m is not None and m.determiner == "its" and bool(moved)
        own_side = own_side or (built and self.kind(moved[0]) in SELF_POWERED - {"person"})
        if own_side and m is not None and m.head in BODY_PARTS | OWN_PARTS:
            self.use(f, "landing")
            return True
        if p is None or p.mention is None or not p.mention.entities:
            return False
        other = p.mention.entities[0]
        if self.structural(other) and p.mention.start < f.verb.start:
            return False  # "In a café a waiter drops a tray": where, not where to
        owned = p.mention.determiner in ("its", "his", "her", "their")
        itself = not set(p.mention.entities) - set(moved)
        if owned and itself and p.mention.head in BODY_PARTS | OWN_PARTS:
            self.use(f, "landing")  # "lands on its wheels"
            if f.verb.sense == "fall" and moved and self.kind(moved[0]) == "person":
                self.event(NodeEvent.TOPPLE, (moved[0],), f, self._time(f))  # "flat on his face"
            return True
        self.came_down.update(moved)
        for t in moved:
            if t == other:
                continue
            if self.structural(other):
                if self.kind(t) == "flyer":
                    continue  # it lands
                leaper = self.kind(t) in ("person", "animal") and f.verb.sense == "land"
                if leaper and t not in self.scene.supported_by and t not in self.scene.heights:
                    self.use(f, "end of a jump")
                    continue
                if (
                    self._airborne(t)
                    and t not in self.scene.supported_by
                    and f.verb.sense == "land"
                ):
                    continue
                if not any(
                    n.event is NodeEvent.FALL and t in n.participants for n in self.tl.nodes
                ):
                    self.event(NodeEvent.FALL, (t,), f, self._time(f))
            elif self._takes_up_from_above(other, p.prep) or self.kind(other) in (
                "region",
                "water",
            ):
                if self.kind(other) == "water":
                    self._off_a_deck(f, t)
                self.enter(f, t, other, p.mention, self._time(f))
            else:
                self._hit(f, [t], p.mention.entities, self._time(f))
        self._lands_again(f, moved, p)
        return True

    def _off_a_deck(self, f: Frame, thing: str) -> None:
        """What falls into the water leaves the quay or bridge that was named."""
        decks = [i for i, e in self.world.entities.items() if is_deck(e)]
        told = any(n.event is NodeEvent.FALL and thing in n.participants for n in self.tl.nodes)
        host = self.scene.supported_by.get(thing)
        towed = [r for r in self.scene.relations if r.source == thing and r.kind == "behind"]
        afloat = any(self.kind(r.target) == "watercraft" for r in towed)
        if len(decks) != 1 or told or thing in decks or self._airborne(thing) or afloat:
            return
        if host is None:
            self.place([thing], decks, "on")
        if host in (None, decks[0]):
            self.event(NodeEvent.FALL, (thing,), f, None)

    def _lands_again(self, f: Frame, moved: list[str], first: Phrase) -> None:
        """ "falls into a funnel, out of it onto a ramp and from the ramp into a cup"."""
        if first not in f.phrases:
            return
        for p in f.phrases[f.phrases.index(first) + 1 :]:
            m = p.mention
            if m is None or m.attribute or p.prep not in ("onto", "into", "on"):
                continue
            others = [i for i in m.entities if i not in moved and not self.structural(i)]
            for t in moved if others else []:
                if p.prep == "into":
                    self._go_into(f, t, others, p, None)
                else:
                    self._hit(f, [t], others[:1])
