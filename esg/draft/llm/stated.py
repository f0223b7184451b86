"""Statements of a reply as the document holds them: places in the prompt, values, courses."""

from __future__ import annotations

from collections.abc import Sequence
import difflib
import re
from typing import Any

from esg.draft.llm.names import Names, slug, unique
from esg.draft.llm.stages import StatementPart
from esg.graph.models import Predicate
from esg.untyped import is_list

Json = dict[str, Any]

HEADINGS = {"left": 0.0, "front": 90.0, "right": 180.0, "back": 270.0}
"""Course over the ground of a direction of the viewer [degrees]."""
_PACES = (Predicate.SLOWER_THAN, Predicate.FASTER_THAN)
_OF_EVENTS = (Predicate.SAME_TIME, Predicate.BEFORE)
MOST_TEXT = 400
"""Longest note of what is not represented [characters]."""


def state(
    raw: Json, prompt: str, stated: Sequence[StatementPart], objects: Names, events: Names
) -> list[str]:
    """Writes the statements of a reply into a document.

    Args:
        raw: Document as JSON; changed in place: it gets `statements`, and segments their courses.
        prompt: The user's text, in which each statement has its place.
        stated: As the model said them.
        objects, events: Known names.

    Returns:
        What was repaired, in words.
    """
    log: list[str] = []
    out: list[Json] = []
    for part in stated:
        names = events if part.says in _OF_EVENTS else objects
        start, end = _place(prompt, part.words, log)
        value = _value(part, raw, names, log)
        out.append(
            {
                "id": f"s{len(out) + 1}",
                "predicate": part.says.value,
                "text": prompt[start:end] if end else part.words,
                "start": start,
                "end": end,
                "object": unique(n for x in part.object for n in names.find(x)),
                "target": unique(n for x in part.target for n in objects.find(x)),
                "direction": part.direction,
                "side": part.side,
                "filming": part.filming,
                "quantity": part.quantity or ("speed" if part.says in _PACES else None),
                "value": value,
                "noun": part.noun,
                "when": "..".join(_moment(m, events) for m in part.when.split("..")),
                "note": (part.missing or "")[:MOST_TEXT],
            }
        )
    if out:
        raw["statements"] = out
        _courses(raw, out, log)
    return log


def _moment(text: str, events: Names) -> str:
    word = text.strip()
    return word if word in ("start", "end", "throughout") else events.one(word)


def _place(prompt: str, words: str, log: list[str]) -> tuple[int, int]:
    """Where the words stand; of words that do not, the longest stretch that does."""
    parts = [re.escape(w) for w in words.split()]
    found = re.search(r"\s+".join(parts), prompt, re.IGNORECASE) if parts else None
    if found is not None:
        return found.span()
    matcher = difflib.SequenceMatcher(None, prompt.lower(), words.lower(), autojunk=False)
    best = matcher.find_longest_match()
    start, end = best.a, best.a + best.size
    log.append(f"words {words!r} of a statement read as {prompt[start:end]!r}")
    return start, end


def _value(part: StatementPart, raw: Json, names: Names, log: list[str]) -> Any:
    """The number of a statement; of a pace without one, the middle of the motion's own speeds."""
    ends = [v for v in (part.low, part.high) if v is not None]
    if ends:
        return ends[0] if ends[0] == ends[-1] or part.says in _PACES else ends
    if part.says not in _PACES:
        return None
    actors = {n for x in part.object for n in names.find(x)}
    for edge in _edges(raw):
        speed = edge["params"].get("speed")
        if edge["actor"] in actors and speed is not None:
            low, high = speed if is_list(speed) else (speed, speed)
            value: float = low if part.says is Predicate.FASTER_THAN else high
            log.append(f"{part.says.value} of {edge['actor']!r} given {value:g} cm/s of its motion")
            return value
    return None


def _edges(raw: Json) -> list[Json]:
    timeline: Json = raw.get("timeline_system") or {}
    return timeline.get("sequence_graph", {}).get("edges", [])


def _courses(raw: Json, statements: list[Json], log: list[str]) -> None:
    """Lets the first motion of what moves in a viewer's direction, or backward, carry it."""
    for statement in statements:
        if statement["predicate"] != Predicate.MOVES.value:
            continue
        for name in statement["object"]:
            edge = next((e for e in _edges(raw) if e["actor"] == name), None)
            if edge is None or edge["event"] in ("Guide", "Drive", "Release", "InertialConnector"):
                continue
            params, heading = edge["params"], HEADINGS.get(statement["direction"] or "")
            if heading is not None and params.get("heading_deg") is None and not edge["target"]:
                params["heading_deg"] = heading
                log.append(f"course of {slug(edge['id'])} set to {statement['direction']}")
            if statement["direction"] == "backward" and not params.get("backward"):
                params["backward"] = True
                log.append(f"{slug(edge['id'])} goes backward")
            actor = raw["timeline_system"]["actors"].get(name, {})
            if params.get("backward") and actor.get("force_direction") == "ALONG_FORWARD_ONLY":
                actor["force_direction"] = "ALONG_FORWARD_OR_BACKWARD"
