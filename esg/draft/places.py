"""Where things are with respect to each other."""

from __future__ import annotations

from esg.draft.core import Core
from esg.draft.scene import Relation
from esg.graph.models import Quantity

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
    "around": "surround",
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


_WALL_THINGS = frozenset({"mirror", "clock", "television", "easel", "calendar", "target"})
"""Upright things that "on the wall" means the face of, not the top."""
_TABLE_KINDS = frozenset({"tableware", "bottle", "food", "game", "book", "electronics", "domino"})


class Places(Core):
    """Relations and supports, and what can support, hold or carry what."""

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
        many = len([t for t in things if t != other]) > 1
        if kind == "surround" and (not many or self.structural(other)):
            kind = "near"
        for t in things:
            if t == other or t not in self.world.entities:
                continue
            if self.structural(t):
                continue
            if self.kind(other) == "ceiling":
                if kind in ("on", "near", "adjacent", "under") and not self._towers(t):
                    self.hang(t, other)
                continue
            if self.structural(other):
                if kind in ("on", "inside_of"):
                    self.scene.marked[t] = other
                self.scene.relations.append(Relation(t, other, "structural", text=prep))
                continue
            if kind == "inside_of" and not self._holds(other):
                kind = "on" if "support" in self.e(other).noun.traits else "near"
            if kind == "on" and self.kind(other) in ("ball", "billiard"):
                kind = "near"
            if self._towers(t) and kind in ("above", "on", "under"):
                continue  # "on the wall above the sofa": what hangs there is above, not the wall
            if kind == "on" and self._wall_thing(t) and self._towers(other):
                self.hang(t, other)
                continue
            if kind == "surround":
                if self._set_on(t, other):
                    self.scene.supported_by.setdefault(t, other)
                self.scene.relations.append(Relation(t, other, "surround"))
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

    def hang(self, thing: str, host: str) -> None:
        """Fixes a thing to a wall's face or below a ceiling."""
        kind = "attached_horizontal" if self.kind(host) == "ceiling" else "attached_vertical"
        self.scene.attached[thing] = host
        self.scene.relations.append(Relation(thing, host, kind))

    def _wall_thing(self, node: str) -> bool:
        """What "on the wall" hangs; anything else stands on top of it."""
        return self.kind(node) == "wallhung" or self.e(node).noun.name in _WALL_THINGS

    def _set_on(self, thing: str, host: str) -> bool:
        """ "Plates around a table" are on it: small things of the table, not what stands around."""
        noun = self.e(thing).noun
        if self.kind(host) != "table" or self.kind(thing) not in _TABLE_KINDS:
            return False
        table, size = self.e(host).noun.dimensions_cm, noun.dimensions_cm
        return max(size[:2]) < 0.5 * min(table[:2]) and size[2] < 60.0

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
                "generic",
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

    def _carries(self, host: str, thing: str) -> bool:
        """Whether something lighter and smaller can have lain on it ("off a stepladder")."""
        if self.structural(host) or "round" in self.e(host).noun.traits or host == thing:
            return False
        mine, other = self.e(thing).noun, self.e(host).noun
        return mine.mass_kg < 2.0 * other.mass_kg and other.kind not in ("region", "water", "hole")

    def _fits_on(self, node: str, host: str) -> bool:
        """Whether something movable can share a table top or shelf."""
        top = self.e(host).noun
        if "support" not in top.traits or "incline" in top.traits or not self.movable(node):
            return False
        if self.kind(node) in ("person", "vehicle") or self.structural(node):
            return False
        size = self.e(node).dimensions_cm or self.e(node).noun.dimensions_cm
        return max(size) <= 0.5 * max(top.dimensions_cm[:2])

    def _free(self, nodes: list[str]) -> None:
        for node in nodes:
            if not self.structural(node):
                self.e(node).freed = True
