"""Which of the things that a prompt names can break (`breakables.csv`)."""

from __future__ import annotations

from esg.draft.discourse.jointed import articulation_of
from esg.draft.discourse.referents.entities import Entity, head_of
from esg.draft.discourse.scene import Scene
from esg.lexicon.breakables import Breakable, breakables


def breakable_of(scene: Scene, text: str, e: Entity) -> Breakable | None:
    """The row of a thing, by its name and what it is called; None for what does not break.

    What is jointed does not: a door, a pot on cords.
    """
    if articulation_of(scene, text, e) is not None:
        return None
    head, table = head_of(e), breakables()
    materials = [f"{a} {head}" for a in e.adjectives]
    row = next((table[n] for n in (*materials, head, e.noun.name) if n in table), None)
    return row if row is not None and row.pieces else None
