"""Which of the things that a prompt names turn or slide on a joint (`articulations.csv`)."""

from __future__ import annotations

from dataclasses import replace
import re

from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.scene import Scene
from esg.lexicon.articulations import Articulation, articulations


def articulation_of(scene: Scene, text: str, e: Entity) -> Articulation | None:
    """The row of a thing; None for what hangs on something that the prompt names, or is its part.

    "The door of a car" and "the drawer of a desk" stay as they are.
    """
    row = articulations().get(head_of(e))
    return None if row is None or e.id in scene.attached or _is_part(text, e) else row


def loosen(scene: Scene, text: str) -> None:
    """What moves on a joint is not fixed: a door, a swing, though their frames are."""
    for e in scene.world.entities.values():
        row = articulation_of(scene, text, e)
        if row is not None and row.carries == "with":
            e.noun = replace(e.noun, traits=e.noun.traits - {"fixed", "structural"})


def head_of(e: Entity) -> str:
    """The noun as the table has it: tokens part a possessive ("newton 's cradle")."""
    return e.head.lower().replace(" 's", "'s")


def _is_part(text: str, e: Entity) -> bool:
    told = rf"\b{re.escape(e.head)}s? of (?:an?|the|his|her|its|their|my)\b"
    return re.search(told, text, re.IGNORECASE) is not None
