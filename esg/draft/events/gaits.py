"""How fast legs go where a text gives no number: by how long they are, and by the gait it names.

A leg swings as a pendulum does, so that what goes on foot goes alike at equal v / sqrt(g h), h the
height of its hips (R. McN. Alexander, "Optimization and gaits in the locomotion of vertebrates",
Physiological Reviews 69, 1989: animals break into a trot or a run at v^2 / (g h) of about 0.5, and
gallop from 2.5 on).
"""

from __future__ import annotations

import csv
from functools import cache
import math

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.scene import LIVING
from esg.units import GRAVITY_MPS2

HIPS = 0.5
"""Height of the hips over that of a body."""
SMALL_CM = 40.0
"""Lower animals go at their own size's speeds whatever the verb; larger ones at any animal's."""

SEEN_CM_S = (20.0, 30.0)
"""Speeds of what is so small that its own gait would hardly be seen."""


@cache
def gaits() -> dict[str, tuple[float, float] | None]:
    """Least and greatest v / sqrt(g h) by verb, None of what is no gait; "" is any other verb."""
    with open(lex.DATA / "gaits.csv", encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file, delimiter=";")
        return {
            verb: (float(row["least"]), float(row["most"])) if row["least"] else None
            for row in rows
            for verb in row["verbs"].split("|")
        }


def on_legs(e: Entity, lemma: str) -> tuple[float, float] | None:
    """The speeds [cm/s] at which a person or an animal goes by a verb; None where any will do.

    Args:
        e: Who goes.
        lemma: The verb.
    """
    if e.noun.kind not in LIVING:
        return None
    height = (e.dimensions_cm or e.noun.dimensions_cm)[2]
    small = e.noun.kind == "animal" and height < SMALL_CM
    share = gaits().get(lemma, gaits()[""] if small else None)
    if share is None:
        return None
    unit = 100.0 * math.sqrt(GRAVITY_MPS2 * 0.01 * HIPS * height)
    least, most = round(share[0] * unit, 1), round(share[1] * unit, 1)
    # A beetle is seen to go, and no slower than what counts as motion.
    return (least, most) if most >= SEEN_CM_S[1] else (max(least, SEEN_CM_S[0]), SEEN_CM_S[1])
