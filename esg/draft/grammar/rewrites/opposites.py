"""Courses told by one before: "a bus drives the other way", "in the opposite direction"."""

from __future__ import annotations

from esg.draft.text.elements import Element, Mention, Verb, Word

_WAYS = frozenset({"way", "direction"})
_OTHER = frozenset({"other", "opposite", "reverse"})
_TOLD = {
    "left": "left", "leftward": "left", "leftwards": "left", "from right to left": "left",
    "right": "right", "rightward": "right", "rightwards": "right", "from left to right": "right",
}  # fmt: skip
_BACK = {"left": "rightwards", "right": "leftwards"}
_TO = frozenset({"to", "toward", "towards"})
_STANDING = frozenset({"face", "be", "posture"})
_TURNING = frozenset({"turn", "swerve"})
_SENTENCES = 2
"""How many sentences back the course may be told."""


def oppose(elements: list[Element]) -> list[Element]:
    """Puts the side in place of "the other way" where a side was told before.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    out: list[Element] = []
    for e in elements:
        side = _last_side(out) if _is_other_way(e) else ""
        verb = next((v for v in reversed(out) if isinstance(v, Verb)), None)
        if not side or verb is None or verb.sense in _STANDING:
            out.append(e)
            continue
        start = e.start
        if isinstance(out[-1], Word) and out[-1].low == "in":
            start = out.pop().start
        turns = verb.sense in _TURNING  # which have a side, and no course
        out.append(Word(start, e.end, "adv", _BACK[side].removesuffix("wards" * turns)))
    return out


def _is_other_way(e: Element) -> bool:
    if not isinstance(e, Mention) or e.determiner != "the":
        return False
    return bool({e.head, e.part} & _WAYS) and bool(_OTHER & {*e.adjectives})


def _last_side(out: list[Element]) -> str:
    """The side to which something was told to go last; empty if none was, or it turned there."""
    ended = 0
    verb = next((v for v in reversed(out) if isinstance(v, Verb)), None)
    turns = verb is not None and verb.sense in _TURNING
    for k in range(len(out) - 1, -1, -1):
        e = out[k]
        ended += isinstance(e, Word) and e.low in (".", "!", "?", "\n")
        if ended >= _SENTENCES:
            return ""
        before = next((v for v in reversed(out[:k]) if isinstance(v, Verb)), None)
        if before is not None and (before.sense in _TURNING) != turns:
            continue
        if isinstance(e, Word) and e.kind == "adv" and e.low in _TOLD:
            return _TOLD[e.low]
        side = e.part or e.head if isinstance(e, Mention) and e.attribute else ""
        prep = out[k - 1] if k else None
        if side in ("left", "right") and isinstance(prep, Word) and prep.low in _TO:
            return side
        if side in ("left", "right") and isinstance(prep, Word) and prep.low == "from":
            return "left" if side == "right" else "right"
    return ""
