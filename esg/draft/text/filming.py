"""How the prompt says that the scene is filmed: views, sizes, moves of the camera, its pace.

`data/filming.csv` says which words mean what. Its parts are the places where such words stand:
before the noun of a picture (`view`: "an aerial shot"), by themselves (`alone`: "in slow motion"),
after a participle of showing (`seen`: "filmed from a drone") and after the camera (`camera`: "the
camera pans left"; its words are verbs, its ways what follows them).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
import csv
from dataclasses import dataclass
from functools import cache, lru_cache
import re

from esg.draft import lexicon as lex
from esg.draft.text.alternatives import any_of
from esg.graph.models import Filming

_PICTURES = r"(?:shots?|views?|footage|angles?|perspectives?|videos?|clips?|point of view)"
_MARKS = re.compile(
    r"camera|\bshot|\bview|footage|\bangle|perspective|\bpov\b|person|zoom|close|motion|slow|slo-?mo"
    r"|lapse|\b(?:seen|filmed|viewed|captured|taken|recorded|watched)\b|hand-?held|macro|\bclip|video"
    r"|\bpan|\btilt|\bdolly|(?:^|[.!?;\n])\s*from\s[\w\s]{4,24},",
    re.IGNORECASE,
)
"""A text without any of these says nothing of it."""
_ADVERBS = (
    r"(?:(?:slowly|gently|smoothly|gradually|steadily|continuously|calmly|closely|slightly|subtly|"
    r"seamlessly|carefully|fluidly|softly|gracefully|dynamically|always|also|still|directly|"
    r"straight|simultaneously|meanwhile|slow)\s+)*"
)
_AIDS = (
    r"(?:(?:is|are|was|be|being|has been|starts?|begins?|starts? to|begins? to|starting to|"
    r"beginning to|starting|continues? to|continues?|keeps?|will|starts? by|begins? by|should|"
    r"can be seen)\s+)?"
)
_DENIED = re.compile(
    r"\b(?:no|not|never|without|nor|don't|doesn't)\s+(?:an?\s+|the\s+)?$", re.IGNORECASE
)
_LATER = re.compile(r"\b(?:then|before|next|finally|afterwards?|later)\s+$", re.IGNORECASE)
_THEN = re.compile(r"\s+(?:then|finally|next|later)\b", re.IGNORECASE)
_SENTENCE = re.compile(r"[.!?;\n]")
_CAMERA = re.compile(r"\b(?:drone\s+)?(?:camera|cam)(?:\s+(?:view|angle|shot))?\b,?", re.IGNORECASE)
_NEXT = re.compile(
    r"(?:,(?:\s+and)?(?:\s+then)?|\band(?:\s+then)?\b|\bthen\b|\bwhile\b|\bbefore\b|\bto\b)\s+",
    re.IGNORECASE,
)
"""What comes before a further move of the camera."""
_OWN_VERB = re.compile(
    rf"{_ADVERBS}(?:pan|tilt|zoom|dolly|push|pull|orbit|circle)\w*\s", re.IGNORECASE
)
"""Verbs that are the camera's where nobody else is told to do it."""
_ANY_VERB = re.compile(rf"{_ADVERBS}(?:[a-z]+)\s", re.IGNORECASE)
_BARE_START = re.compile(r"(?:(?<=[.!?;\n]\s)|^)(?=(?:pan|tilt|zoom|dolly)\s)", re.IGNORECASE)
_AND_OUT = re.compile(r"\s+and\s+(?:out|back|forth|right|left|down)\b", re.IGNORECASE)
"""A move to and fro is none to one side."""
_STRUCK = re.compile(
    r"\b(?:takes?|fires?|hits?|makes?|plays?|attempts?|miss(?:es)?|saves?|blocks?|gets?|with|"
    r"taking|firing|hitting|making|playing)\s+(?:an?|the|his|her)\s+(?:\w+\s+)?$",
    re.IGNORECASE,
)
"""Before a shot that somebody takes at a goal."""
_OF_A_PICTURE = re.compile(
    r"\s*(?:[,.:;!?)-]|$|(?:of|showing|from|in|at|on|over|with|where|that|as|by|through|following|"
    r"captur\w+|looking|and|follows|tracks|shows|reveals|focus\w+|behind|above|around|along|for|to|which|while)\b)",
    re.IGNORECASE,
)
"""What follows a shot that is a picture: no verb of its own ("a wide shot misses the goal")."""
_ALONG = re.compile(
    r"\s+(?:that\s+|which\s+)?(?P<verb>following|follows|tracking)\b", re.IGNORECASE
)
""" "A drone shot following a car"."""
_BETWEEN = (
    r"(?!(?:camera|cam|window|seat|of|the|an?|in|on|at|to|and|or|is|with|from|for|by)\b)[\w'’-]+"
)


@dataclass(frozen=True)
class Row:
    """A row of the table, as patterns."""

    part: str
    filming: Filming
    pattern: re.Pattern[str]
    tail: re.Pattern[str] | None = None
    """Of `seen`: the same words right behind what the camera does."""


@dataclass(frozen=True)
class Words:
    """Words, from `start` to `end` in the text, that say how it is filmed."""

    start: int
    end: int
    filming: Filming
    later: bool = False
    """Whether it comes after another one in time."""
    moves: bool = False
    """Whether the camera is told to do it."""


def _forms(lemma: str) -> str:
    """A pattern of all forms of a regular verb."""
    if lemma == "be":
        return r"(?:is|are|was|being|be)"
    stem = lemma[:-1] if lemma.endswith("e") else lemma
    if re.search(r"[^aeiou][aeiou][bdgmnpt]$", lemma) and lemma not in _UNDOUBLED:
        stem = lemma + lemma[-1]
    third = lemma + "es" if lemma.endswith(("sh", "ch", "o")) else lemma + "s"
    third = lemma[:-1] + "ies" if lemma.endswith(("ly", "ny")) else third
    return rf"(?:{lemma}|{third}|{stem}ing|{stem}ed|{lemma}ing)"


_UNDOUBLED = frozenset({"orbit", "pedestal", "travel", "follow"})


def _listed(words: str) -> str:
    return any_of(words.split("/")).replace("_", r"\s+")


@cache
def rows() -> tuple[Row, ...]:
    """The table."""
    with open(lex.DATA / "filming.csv", encoding="utf-8", newline="") as file:
        return tuple(_row(r) for r in csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE))


def _row(r: dict[str, str]) -> Row:
    pattern = re.compile(_PATTERNS[r["part"]](r), re.IGNORECASE)
    tail = rf"\s+(?:[\w'’-]+\s+){{0,4}}?(?P<words>{_listed(r['words'])})\b"
    seen = re.compile(tail, re.IGNORECASE) if r["part"] == "seen" else None
    return Row(r["part"], r["filming"], pattern, seen)  # type: ignore[arg-type]  # a test reads the whole table


def _moves(r: dict[str, str]) -> str:
    verbs = "|".join(_forms(v) for v in r["words"].split("/") if v)
    optional = "" in r["words"].split("/")
    ways = [w for w in r["ways"].split("/") if w]
    way = rf"(?:{_listed('/'.join(ways))})\b" if ways else ""
    if "" in r["ways"].split("/") and ways:
        way = rf"(?:{way})?"
    gap = rf"\s+{_ADVERBS}" if ways and verbs else ""
    if optional and verbs:
        return rf"{_ADVERBS}(?:(?:{verbs})\s+{_ADVERBS})?{way}"
    gap = rf"(?:{gap})?" if "" in r["ways"].split("/") and ways else gap
    verb = rf"(?:{verbs})\b" if verbs else ""
    return rf"{_ADVERBS}{_AIDS}{_ADVERBS}{verb}{gap}{way}"


_OPENS = re.compile(r"from_.*(?:above|overhead|air|distance|far|afar|angle)$")
_COMES_DOWN = (
    r"(?:falls?|falling|fell|drops?|dropp|lands?|rains?|descend|swoop|plummet|lower|pour|hits?|"
    r"throw|toss|shoot|crash|comes?|dives?|jumps?|tumbl|hang|pounce|strikes?)"
)
"""What comes from above in a story does not say how it is filmed."""


def _opening(words: str) -> str:
    """Of words that stand before a sentence, with a comma: "From above, two cars race"."""
    told = "/".join(w for w in words.split("/") if _OPENS.match(w))
    if not told:
        return ""
    return (
        rf"|(?:(?<=[.!?;\n]\s)|(?<![\s\S]))(?:{_listed(told)})"
        rf"(?=,(?![^.!?;\n]*\b{_COMES_DOWN})),?"
    )


_PATTERNS: dict[str, Callable[[dict[str, str]], str]] = {
    "view": lambda r: (
        rf"\b(?P<words>{_listed(r['words'])})(?=(?:[\s-]+{_BETWEEN}){{0,3}}?[\s-]+"
        rf"(?P<noun>{_PICTURES})\b(?!\s+(?:mirror|camera)))"
    ),
    "alone": lambda r: rf"\b(?:{_listed(r['words'])})\b",
    "seen": lambda r: (
        r"\b(?:seen|viewed|filmed|shot|captured|taken|recorded|watched|shown|view|footage|"
        rf"perspective|looking)\s+(?:\w+ly\s+)?(?:{_listed(r['words'])})\b{_opening(r['words'])}"
    ),
    "camera": _moves,
}


@lru_cache(maxsize=16)
def said(text: str) -> tuple[Words, ...]:
    """Words that say how a scene is filmed, in order; none overlaps another.

    Args:
        text: Any text.
    """
    if not _MARKS.search(text):
        return ()
    found = [w for row in rows() for w in _FINDERS[row.part](row, text)]
    found += _of_the_camera(text)
    out: list[Words] = []
    for w in sorted(found, key=lambda w: (w.start, -w.end)):
        if not any(w.start < o.end and o.start < w.end for o in out):
            out.append(w)
    return tuple(out)


def _views(row: Row, text: str) -> Iterator[Words]:
    """ "A wide aerial shot": each of the words before the noun of a picture."""
    for found in row.pattern.finditer(text):
        before = text[max(0, found.start() - 40) : found.start()]
        struck = found["noun"].lower().startswith("shot") and _STRUCK.search(before)
        loose = not _OF_A_PICTURE.match(text, found.end("noun"))
        if not _DENIED.search(before) and not struck and not loose:
            between = text[found.end() : found.start("noun")].strip(" -")
            end = found.end() if between else found.end("noun")
            yield Words(found.start(), end, row.filming)
            along = None if between else _ALONG.match(text, found.end("noun"))
            if along:
                yield Words(along.start("verb"), along.end("verb"), "follows")


def _alone(row: Row, text: str) -> Iterator[Words]:
    for found in row.pattern.finditer(text):
        if not _DENIED.search(text, max(0, found.start() - 20), found.start()):
            yield Words(*found.span(), row.filming)
            if row.part == "seen":
                yield from _from_where(text, found.end(), len(text))


def _after_camera(row: Row, text: str) -> Iterator[Words]:
    yield from ()  # found sentence by sentence: `_of_the_camera`


_FINDERS: dict[str, Callable[[Row, str], Iterator[Words]]] = {
    "view": _views,
    "alone": _alone,
    "seen": _alone,
    "camera": _after_camera,
}


def _of_the_camera(text: str) -> Iterator[Words]:
    """ "The camera pans left and zooms in", "zoom in on the ball"."""
    starts = [(c.start(), c.end()) for c in _CAMERA.finditer(text)]
    starts += [(b.start(), b.end()) for b in _BARE_START.finditer(text)]
    for start, at in starts:
        then = _THEN.match(text, at)
        at = then.end() if then else at
        stop = _SENTENCE.search(text, at)
        end = stop.start() if stop else len(text)
        first = _move_at(text, at, end)
        if first is None:
            continue
        before = _LATER.search(text, max(0, start - 12), _the(text, start))
        yield Words(start, first.end, first.filming, bool(then or before), moves=True)
        yield from _from_where(text, first.end, end)
        for joint in _NEXT.finditer(text, first.end, end):
            beside = not text[first.end : joint.start()].strip()
            own = _OWN_VERB if not beside else _ANY_VERB
            if not own.match(text, joint.end(), end):
                continue
            if _CAMERA.search(text, first.end, joint.start()):
                break
            more = _move_at(text, joint.end(), end)
            if more is not None:
                after = _LATER.search(text, first.end, joint.end()) is not None
                yield Words(joint.end(), more.end, more.filming, after, moves=True)


def _from_where(text: str, at: int, end: int) -> Iterator[Words]:
    """ "Follows the dog from behind": the side, right behind what the camera does."""
    for row in rows():
        found = row.tail.match(text, at, end) if row.tail else None
        if found:
            yield Words(found.start("words"), found.end("words"), row.filming)


def _the(text: str, start: int) -> int:
    """Where the article of a noun stands that starts there."""
    found = re.search(r"(?:the|a)\s+$", text[:start], re.IGNORECASE)
    return found.start() if found else start


def _move_at(text: str, at: int, end: int) -> Words | None:
    """The longest move that is told there."""
    while at < end and text[at] in " \t,":
        at += 1
    best: Words | None = None
    for row in rows():
        found = row.pattern.match(text, at, end) if row.part == "camera" else None
        if not found or not found.group().strip() or _AND_OUT.match(text, found.end()):
            continue
        if best is None or found.end() > best.end:
            best = Words(at, found.end(), row.filming)
    return best


_OPENING = re.compile(
    r"(?:(?<=[.!?;\n])|^)\s*(?P<words>[\w\s,'’-]{4,80}?)\b(?:of|:)\s+(?=\w)", re.IGNORECASE
)
_FRAMES = re.compile(rf"\b(?:an?|the|in|and|with|from|{_PICTURES})\b|[\s,'’-]+", re.IGNORECASE)


def without_heading(text: str) -> str:
    """A text whose sentences begin with what is filmed: "Slow motion close-up of a ball falling".

    Args:
        text: A prompt.

    Returns:
        Spaces in place of headings that consist of words of the camera alone; the same length.
    """
    words = said(text)
    for found in [*_OPENING.finditer(text)] if words else ():
        start, end = found.span("words")
        inside = [w for w in words if start <= w.start and w.end <= end]
        left = "".join(
            c for k, c in enumerate(text[start:end], start)
            if not any(w.start <= k < w.end for w in inside)
        )  # fmt: skip
        if inside and not _FRAMES.sub("", left):
            text = text[: found.start("words")] + " " * (found.end() - start) + text[found.end() :]
    return text
