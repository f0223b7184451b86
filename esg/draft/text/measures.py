"""What stands around a quantity and belongs to it: "1.6 cm across", "2 s after the start"."""

from __future__ import annotations

import re

_SUFFIXES: dict[str, tuple[tuple[str, str], ...]] = {
    "angle": ((r"angle", ""), (r"(?:slope|inclination|gradient)", "")),
    "length": (
        (r"across", "diameter"),
        (r"(?:on|along|to)\s+(?:each|a|every|all|the)\s+(?:side|edge)s?", "side"),
        (r"(?:per|a|each)\s+side", "side"),
        (r"in\s+(?:overall\s+)?size", ""),
    ),
    "mass": ((r"in\s+(?:weight|mass)", ""),),
    "time": (
        (r"mark", "start"),
        (r"on(?=\s*,)", ""),
        (r"(?:of|after)\s+(?:that|this)(?=\s*[,.;]|\s+(?:an?|the|it)\b)", ""),
        (r"(?:has|have)\s+(?:passed|elapsed|gone\s+by)", ""),
        (r"after\s+(?:it|he|she|they)\s+(?:starts?|begins?|started|began|sets?\s+off)"
         r"(?:\s+(?:moving|rolling|driving|to\s+(?:move|roll|drive)))?(?=\s*[,.;])", "start"),
        (r"in(?=\s*[,.;])", "start"),
        (
            r"(?:(?:later\s+than|after|from|since|past)\s+(?:the\s+)?(?:very\s+)?"
            r"(?:start|beginning|outset)|in(?:to)?)"
            r"(?:\s+(?:of\s+)?(?:the|this)\s+(?:scene|simulation|clip|video|shot|sequence|action"
            r"|animation|movie|recording))",
            "start",
        ),
        (
            r"(?:later\s+than|after|from)\s+(?:the\s+)?(?:very\s+)?(?:start|beginning|outset)",
            "start",
        ),
        (
            r"after\s+(?:the\s+)?(?:scene|simulation|clip|video|shot|sequence|action|animation)"
            r"\s+(?:starts|begins|has\s+started|has\s+begun)",
            "start",
        ),
    ),
}  # fmt: skip
_COMPILED = {
    dimension: tuple((re.compile(rf"[\s-]+{p}\b", re.IGNORECASE), m) for p, m in patterns)
    for dimension, patterns in _SUFFIXES.items()
}


_ON_A_SLOPE = re.compile(
    r"\b(?:down|up|on|onto|off|along|over|across|from|of|to|into)\s+(?:an?|the|its|this)\s+"
    r"[\d.]+[\s-]*(?:degrees?|deg|°)$",
    re.IGNORECASE,
)


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
    for pattern, measure in _COMPILED.get(dimension, ()):
        m = pattern.match(text, at)
        if m is not None:
            return m.end(), measure
    return at, ""


def product(number: str, unit: str) -> re.Pattern[str]:
    """Pattern of "20 x 30 x 40 cm" and "2 m by 1 m".

    Args:
        number, unit: Patterns of a number and of a unit of length.
    """
    times = r"\s*(?:x|×|\*|by)\s*"
    one, last = rf"{number}(?:[\s-]*{unit})?", rf"{number}[\s-]*(?P<unit>{unit})"
    return re.compile(rf"(?P<sides>{one}(?:{times}{one})?{times}{last})(?![a-z0-9])", re.IGNORECASE)
