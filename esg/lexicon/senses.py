"""What nouns outside the table of kinds name that is no thing: acts, substances, places, parts.

The table was made from WordNet 3.0 (esg/lexicon/wordnet.py).
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Literal, cast

TABLE = Path(__file__).parent / "no_things.txt"
NounClass = Literal["nothing", "substance", "place", "body"]
"""What a noun names: what nobody can touch (acts, events, qualities, times, numbers), what things
are made of, where they are, or a part of a body."""


@cache
def no_things() -> dict[str, NounClass]:
    """Singular nouns that name no thing in most of their senses, and what they name."""
    found: dict[str, NounClass] = {}
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        kind, _, words = line.partition("\t")
        found.update(dict.fromkeys(words.split(";"), cast(NounClass, kind)))
    return found
