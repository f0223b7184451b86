"""What stands around a quantity and belongs to it: "1.6 cm across", "2 s after the start"."""

from __future__ import annotations

import re

from esg.draft.text.amounts import Bound
from esg.draft.text.numerals import NUMBER
from esg.draft.text.units import UNIT

_START = r"(?:the\s+)?(?:very\s+)?(?:start|beginning|outset)"
_SCENE = r"(?:scene|simulation|clip|video|shot|sequence|action|animation|movie|recording)"
_SUFFIXES = (
    ("angle", r"angle|slope|inclination|gradient", ""),
    ("length", r"across", "diameter"),
    ("length", r"(?:on|along|to)\s+(?:each|a|every|all|the)\s+(?:side|edge)s?", "side"),
    ("length", r"(?:per|a|each)\s+side", "side"),
    ("length", r"in\s+(?:overall\s+)?size", ""),
    ("mass", r"in\s+(?:weight|mass)", ""),
    ("time", r"mark|in(?=\s*[,.;])", "start"),
    ("time", r"on(?=\s*,)|(?:of|after)\s+(?:that|this)(?=\s*[,.;]|\s+(?:an?|the|it)\b)", ""),
    ("time", r"(?:has|have)\s+(?:passed|elapsed|gone\s+by)", ""),
    ("time", r"after\s+(?:it|he|she|they)\s+(?:starts?|begins?|started|began|sets?\s+off)"
             r"(?:\s+(?:moving|rolling|driving|to\s+(?:move|roll|drive)))?(?=\s*[,.;])", "start"),
    ("time", rf"(?:(?:later\s+than|after|from|since|past)\s+{_START}|in(?:to)?)"
             rf"\s+(?:of\s+)?(?:the|this)\s+{_SCENE}", "start"),
    ("time", rf"(?:later\s+than|after|from)\s+{_START}", "start"),
    ("time", rf"after\s+(?:the\s+)?{_SCENE}\s+(?:starts|begins|has\s+(?:started|begun))", "start"),
)  # fmt: skip
"""What is measured, words behind the unit, and what they say it measures."""
_COMPILED = [(d, re.compile(rf"[\s-]+(?:{p})\b", re.IGNORECASE), m) for d, p, m in _SUFFIXES]
_ON_A_SLOPE = re.compile(
    r"\b(?:down|up|on|onto|off|along|over|across|from|of|to|into)\s+(?:an?|the|its|this)\s+"
    r"[\d.]+[\s-]*(?:degrees?|deg|°)$",
    re.IGNORECASE,
)
_TRAILING = re.compile(
    r",?\s+(?:(?P<min>or\s+(?:more|faster|longer|heavier|above|later|higher|further)|and\s+up"
    r"|at\s+(?:the\s+(?:very\s+)?)?least|upwards|minimum)"
    r"|(?P<max>or\s+(?:less|under|slower|below|lower|shorter|fewer|sooner|earlier|lighter)"
    r"|at\s+(?:the\s+(?:very\s+)?)?most|tops|maximum|max)|or\s+so|or\s+thereabouts|-?ish|flat|sharp)"
    rf"(?![\w-])(?!\s+(?:{NUMBER})[\s-]*(?:{UNIT})(?![a-z0-9]))",
    re.IGNORECASE,
)
"""What stands behind a quantity and leaves a side open; not what bounds the next one."""


def suffix(text: str, at: int, dimension: str) -> tuple[int, str]:
    """Where a quantity's words end, and what they say it measures.

    Args:
        text: The prompt.
        at: Where the unit ends.
        dimension: What is measured.

    Returns:
        The end, and diameter, side, start (a time counted from the start of the scene) or "".
    """
    if dimension == "angle" and _ON_A_SLOPE.search(text, max(0, at - 40), at):
        return at, ""  # "down a 5-degree slope": a thing
    for measured, pattern, measure in _COMPILED:
        m = pattern.match(text, at) if measured == dimension else None
        if m is not None:
            return m.end(), measure
    return at, ""


def bounded(text: str, at: int) -> tuple[int, Bound]:
    """Where what bounds a quantity from behind ends, and the bound ("or so" has none).

    Args:
        text: The prompt.
        at: Where the quantity ends.
    """
    m = _TRAILING.match(text, at)
    if m is None:
        return at, None
    return m.end(), "min" if m["min"] else "max" if m["max"] else None
