"""Prompts that cannot be drafted: one clear message each."""

from __future__ import annotations

import math
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.scene import MAX_TIME_S, Scene
from esg.draft.text.markup import plain
from esg.draft.text.quantities import Amount, find_amounts
from esg.draft.verbphrases import verb_readings
from esg.graph.models import NodeEvent, TimelineSystem
from esg.outcomes import UserError

MAX_CHARACTERS = 20_000
LIGHT_SPEED_CM_S = 2.99792458e10
MAX_SPEED_CM_S = 15_000.0
MAX_MASS_KG = 1e5
MAX_OBJECTS = 400
"""Most objects of a scene."""


_WORDS = (
    lex.DETERMINERS | lex.PREPOSITIONS | lex.ADVERBS | lex.PRONOUNS | lex.MODALS | lex.ATTRIBUTES
    | frozenset(lex.COLORS) | {"and", "or", "but", "to"}
)  # fmt: skip
_ELSEWHERE_TOO = frozenset({"a", "an", "in", "on", "as", "die", "at", "i", "me", "no"})
"""English words that other languages have as well."""
_FOREIGN = lex.word_set("foreign")
_MARK = "[\u200b\u200c\u2060]+"
_MARKED = re.compile(rf"[^\W\d_]+(?:{_MARK}[^\W\d_]+)+")
_BEFORE_THE_SCENE = re.compile(r"\s+(?:ago|earlier|before|previously|beforehand)\b", re.IGNORECASE)
_LATER = re.compile(r"\s+(?:later|after)\b", re.IGNORECASE)
_LIGHT = re.compile(
    r"\b(?:faster than|at|exceeding|beyond) (?:the speed of )?light(?:'s speed)?\b", re.IGNORECASE
)


def screen(prompt: str) -> str:
    """The prompt with white space normalized.

    Raises:
        UserError: If it is empty, too long, not English, or physically impossible.
    """
    if not prompt.strip():
        raise UserError('The prompt is empty; describe a scene, such as "A car hits a bin."')
    if len(prompt) > MAX_CHARACTERS:
        raise UserError(
            f"The prompt has {len(prompt):,} characters; the limit is {MAX_CHARACTERS:,}. "
            "Describe one scene."
        )
    text = re.sub(r"[\u00a0\t\r\f\v ]+", " ", plain(prompt)).replace("’", "'").strip()
    text = re.sub(r"[\ufeff\u00ad\u200d\x00-\x09\x0b-\x1f]", "", text)
    text = re.sub(_MARK, "", _MARKED.sub(_joined, text))
    amounts = find_amounts(text)
    _check_language(text, amounts)
    problems = [p for a in amounts if (p := _impossible(text, a))]
    if _LIGHT.search(text):
        problems.append('"faster than light" is impossible; state a speed up to 150 m/s')
    if problems:
        raise UserError("The prompt asks for the impossible: " + "; ".join(problems) + ".")
    return text


def _is_english(word: str) -> bool:
    """Whether the lexicon has the word in any class."""
    nouns = lex.nouns()
    return (
        word in _WORDS
        or word in nouns
        or lex.singular(word)[0] in nouns.keys() | lex.word_set("people")
        or bool(verb_readings(word))
    )


def _joined(m: re.Match[str]) -> str:
    """What invisible marks part: words of their own, or the pieces of one."""
    words: list[str] = []
    for piece in re.split(_MARK, m[0]):
        left = words[-1] if words else ""
        apart = _is_english(left.lower()) and _is_english(piece.lower())
        if left and not (apart and not _is_english((left + piece).lower())):
            words[-1] += piece
        else:
            words.append(piece)
    return " ".join(words)


def _check_language(text: str, amounts: list[Amount]) -> None:
    """Raises UserError unless the words, without units of quantities, are English."""
    rest = text
    for a in reversed(amounts):
        rest = rest[: a.start] + " " + rest[a.end :]
    words = re.findall(r"[^\W\d_]+", rest.lower())
    known = [w for w in words if _is_english(w)]
    few = len(words) >= 3 and len(known) / len(words) < 0.34
    if few or not set(known) - _ELSEWHERE_TOO:
        raise UserError(
            f"No English words that name objects or motions were found in {text[:60]!r}; "
            "write the prompt in English."
        )
    foreign = _FOREIGN & set(words)
    if len(foreign) >= 2 and sum(w in _FOREIGN for w in words) > 0.15 * len(words):
        raise UserError(
            f"The prompt {text[:60]!r} mixes English with another language "
            f"({', '.join(sorted(foreign)[:4])}); write all of it in English."
        )


def _impossible(text: str, a: Amount) -> str:
    """Why there can be no such quantity; empty if there can."""
    kind = a.dimension
    if kind in ("mass", "length", "time", "speed") and a.low < 0.0:
        return f'"{a.text}" is negative; a {kind} must be positive'
    if kind == "mass" and a.low == 0.0:
        return f'"{a.text}": a mass must be greater than zero'
    if kind == "mass" and a.high > MAX_MASS_KG:
        return f'"{a.text}" is more than the largest mass, {MAX_MASS_KG:g} kg'
    if kind == "speed" and abs(a.high) > LIGHT_SPEED_CM_S:
        return f'"{a.text}" is faster than light'
    if kind == "speed" and abs(a.high) > MAX_SPEED_CM_S:
        return f'"{a.text}" is more than the fastest simulated speed, 150 m/s'
    if kind == "time" and a.high > MAX_TIME_S and not _background(text, a):
        return f'"{a.text}" is more than the longest scene, 600 s'
    if not (math.isfinite(a.low) and math.isfinite(a.high)):
        return f'"{a.text}" is more than a number can hold'
    return ""


def _background(text: str, a: Amount) -> bool:
    """ "came loose an hour ago", "Half an hour later, ...": no time of the scene."""
    opens = not re.sub(r"(?i)\b(?:about|some|half)\b|\W", "", text[: a.start])
    later = opens and _LATER.match(text, a.end) is not None
    return later or _BEFORE_THE_SCENE.match(text, a.end) is not None


_ORDERS = re.compile(
    r"\b(?:ignore|disregard|forget)\b.{0,30}\b(?:instructions?|above|prompts?|rules)\b",
    re.IGNORECASE,
)


def nothing_to_draw(scene: Scene) -> None:
    """Raises UserError if the prompt names no object; warns of text addressed to the system."""
    if _ORDERS.search(scene.text):
        scene.warnings.append(
            "Text that reads like an instruction to the system is taken as description only."
        )
    if not any(
        e.mentioned and "ground" not in e.noun.traits for e in scene.world.entities.values()
    ):
        raise UserError(
            f"The prompt {scene.text[:60]!r} names no object that can be placed; "
            'name one, such as "a ball rolls into a box".'
        )


def too_much(scene: Scene) -> None:
    """Raises UserError if the prompt tells of more objects than a scene holds."""
    number = len(scene.world.entities)
    if number > MAX_OBJECTS:
        raise UserError(
            f"The prompt names {number:,} objects; a scene holds {MAX_OBJECTS}. Describe one scene."
        )


def too_long(timeline: TimelineSystem | None) -> None:
    """Raises UserError if the events of the prompt cannot happen within the longest scene."""
    nodes = timeline.sequence_graph.nodes if timeline is not None else ()
    last = max((n.window[1] if n.window else n.timestamp or 0.0 for n in nodes), default=0.0)
    if last > MAX_TIME_S:
        events = sum(n.event is not NodeEvent.TRIGGER for n in nodes) - 1
        raise UserError(
            f"The prompt tells of {events} events, which take {last:.0f} s; the longest scene has "
            f"{MAX_TIME_S:.0f} s. Split it into several scenes."
        )


def contradictions(scene: Scene) -> None:
    """Raises UserError if the prompt states two values for one property, or motion and rest."""
    if scene.world.conflicts:
        stated = "; ".join(dict.fromkeys(scene.world.conflicts))
        raise UserError(f"The prompt contradicts itself: {stated}. State one of them.")
