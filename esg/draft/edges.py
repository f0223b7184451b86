"""Edges, ends and openings: where things leave what carries them, or pass through."""

from __future__ import annotations

from esg.draft.core import Time
from esg.draft.frames import Frame, Phrase
from esg.draft.motions import Motions
from esg.graph.models import NodeEvent

_ENDS = frozenset({"end", "side", "corner", "ends", "sides", "corners"})
EDGES = frozenset({"edge", "end", "side", "rim", "lip"})
_HATCHES = frozenset({"trapdoor", "hatch", "skylight", "manhole", "opening", "chute", "gap"})
"""What things drop through."""
_BACKS = frozenset({"back", "rear", "tailgate", "bed", "top"})
"""What a load slides off, of the vehicle or thing that was named."""


class Edges(Motions):
    """Falls off ends, edges and the backs of vehicles; ways through."""

    def _opening(self, ids: list[str]) -> bool:
        """Whether it is a hatch or the like, which things pass and nothing stays in."""
        return len(ids) == 1 and bool(set(self.e(ids[0]).head.split()) & _HATCHES)

    def _from_an_end(self, f: Frame, p: Phrase, other: str) -> bool:
        """Whether a motion starts at the end of a table or shelf, and stays on it."""
        end = p.mention is not None and bool(_ENDS & set(p.mention.part.split()))
        top = self.e(other).noun.traits
        return end and "support" in top and "incline" not in top and f.verb.sense != "fall"

    def _off_the_edge(self, f: Frame, p: Phrase, actors: list[str], time: Time | None) -> bool:
        """ "falls off the end", "over its edge": of the support it moves on."""
        m = p.mention
        falls = f.verb.sense in ("fall", "drop")  # "falls at the end of the bar"
        if m is None:
            return False
        back = p.prep == "off" and m.head in _BACKS and m.determiner == "the" and not m.noun
        if m.part not in EDGES and not back:
            return False
        if p.prep not in ("off", "over") and not (falls and p.prep in ("at", "from")):
            return False
        hosts = [i for i in m.entities if i not in actors]
        if hosts and not self._elevated(hosts[0]):
            return False
        for actor in actors:
            if hosts:
                self.place([actor], hosts[:1], "on")
            if not hosts and actor not in self.scene.supported_by:
                near = self._loaded_named(actor) if back else self._carrier_named(actor)
                if not near:
                    return False
                self.place([actor], [near], "on")
            self.event(NodeEvent.FALL, (actor,), f, time)
        return bool(actors)

    def _comes_down(self, f: Frame, actor: str, p: Phrase) -> bool:
        """ "slides down to the ground" from the heap it lies on."""
        assert p.mention is not None
        down = "down" in self.text[f.verb.end : p.mention.start].lower().split()
        rests = actor in self.scene.supported_by or self._lies_on_something(actor)
        return down and rests and self.kind(actor) not in ("person", "animal")

    def _loaded_named(self, actor: str) -> str:
        """ "A lorry stops and pipes roll off the back": the vehicle or cart named last."""
        for ids in reversed(self.world.salience):
            for i in ids:
                known = i in self.world.entities and i != actor
                if known and self.kind(i) in ("vehicle", "cart", "watercraft"):
                    return i
        return ""

    def _carrier_named(self, actor: str) -> str:
        """What the prompt spoke of last that the actor can stand or run on."""
        for ids in reversed(self.world.salience):
            for i in ids:
                known = i in self.world.entities and i != actor and not self.structural(i)
                if known and {"support", "incline"} & self.e(i).noun.traits:
                    return i
        return ""
