"""Lookup by name: the library entry whose name or synonym a noun phrase or its head is."""

from __future__ import annotations

from functools import lru_cache
import re

from esg.assets.library.catalogue import Entry, entries_by_name, lexicon, normalize

_TAIL = re.compile(
    r"\b(of|for|with|without|in|on|from|to|at|by|used|thrown|made(?= (?:of|from|out|with|by))"
    r"|that|which|into|over|under)\b"
)
AMBIGUOUS_HEADS = frozenset(
    [
        "board",
        "stand",
        "screen",
        "club",
        "stop",
        "tin",
        "tube",
        "post",
        "pole",
        "bob",
        "meter",
        "saw",
        "stick",
        "bar",
        "cross",
        "head",
        "machine",
        "display",
        "store",
        "shop",
        "surface",
        "track",
        "home",
        "frame",
        "hat",
        "roller",
        "line",
        "set",
        "organ",
        "beam",
        "watch",
        "coin",
        "wheel",
        "horn",
        "lantern",
        "dish",
        "mat",
        "court",
        "bag",
        "pin",
        "bat",
        "block",
        "pot",
        "plant",
        "net",
        "ring",
        "glass",
        "cue",
        "gun",
    ]
)
"""Nouns that name a library entry alone but mean something else as the head of a compound."""


def _compact(text: str) -> str:
    return text.replace(" ", "")


@lru_cache(maxsize=1)
def _compact_lexicon() -> dict[str, str]:
    return {_compact(k): v for k, v in lexicon().items()}


def exact(text: str) -> Entry | None:
    """The entry whose name or synonym is `text`, spaces and hyphens aside."""
    name = _compact_lexicon().get(_compact(normalize(text)))
    return entries_by_name()[name] if name else None


def head_phrase(text: str) -> str:
    """The noun phrase before the first preposition ("bottle" of "bottle of wine")."""
    words = normalize(text)
    cut = _TAIL.split(words, maxsplit=1)[0].strip()
    return normalize(cut) if cut else words


def head_match(text: str) -> Entry | None:
    """The entry named by the longest suffix of the head phrase ("rusty oil drum" -> oil drum)."""
    words = head_phrase(text).split()
    for start in range(len(words)):
        tail = words[start:]
        if len(tail) == 1 and len(words) > 1 and tail[0] in AMBIGUOUS_HEADS:
            return None
        name = _compact_lexicon().get("".join(tail))
        if name:
            return entries_by_name()[name]
    return None
