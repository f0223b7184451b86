"""Colours that tell alike things apart where the prompt gives none."""

from __future__ import annotations

import math

from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.scene import Scene
from esg.lexicon.kinds import kinds

TINTED = frozenset({"vehicle", "toyvehicle", "cart", "ball", "box", "block"})
"""Kinds of things that come in any colour."""
TINTS = {
    "blue": (36, 84, 170),
    "yellow": (238, 196, 36),
    "green": (40, 130, 58),
    "white": (240, 240, 236),
    "red": (196, 28, 30),
    "black": (24, 24, 26),
}
"""Colours given to the second, third ... of alike things, and their RGB."""
MOST = 4
"""So many alike are told apart; more are a crowd."""
ALIKE_RGB = 120.0
"""Colours nearer to each other than this look alike."""


def tints(scene: Scene) -> dict[str, str]:
    """Colours by node: who looks like a thing of a stated colour, or an earlier one, gets another.

    Only things of which at least two take part in events.
    """
    acting = {i for n in scene.timeline.nodes for i in n.participants}
    acting |= set(scene.timeline.tracks)
    alike: dict[str, list[Entity]] = {}
    for e in scene.world.entities.values():
        if e.noun.kind in TINTED:
            alike.setdefault(e.noun.name, []).append(e)
    out: dict[str, str] = {}
    for name, members in alike.items():
        acts = [e for e in members if e.id in acting]
        own = _own_rgb(name)
        if own is None or len(acts) < 2 or len(members) > MOST:
            continue
        seen = [TINTS[e.color] for e in members if e.color in TINTS]
        for e in members:
            if e.color is not None:
                continue
            if any(math.dist(own, rgb) < ALIKE_RGB for rgb in seen):
                free = (t for t, rgb in TINTS.items()
                        if all(math.dist(rgb, s) >= ALIKE_RGB for s in seen))  # fmt: skip
                out[e.id] = next(free, "black")
            seen.append(TINTS.get(out.get(e.id, ""), own))
    return out


def _own_rgb(name: str) -> tuple[int, int, int] | None:
    """The colour in which a kind is drawn."""
    text = next((k.color for k in kinds() if k.name == name and k.color), "")
    if not text.startswith("#"):
        return None
    return int(text[1:3], 16), int(text[3:5], 16), int(text[5:7], 16)
