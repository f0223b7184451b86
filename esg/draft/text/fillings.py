"""What open vessels are filled with, and what floats or sinks in it: taken out of the text.

"A bucket filled with water" is read as "a bucket" with what is in it beside: the words are blanked
before anything is read, every other word stays where it stands. What pours, spills or is stirred is
no filling, and stays in the text.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache, partial
import re

from esg.draft import lexicon as lex
from esg.draft.text.alternatives import any_of
from esg.draft.text.lying import Lain, take_lying
from esg.draft.text.shining import Shown, take_shown
from esg.draft.verbphrases import verb_readings
from esg.graph.models import Predicate
from esg.lexicon.contents import contents, contents_said

_FULL: dict[str, float] = {"half": 0.5, "partly": 0.5, "partially": 0.5, "quarter": 0.25}
"""Share of the depth that a word before "full" or "filled" tells of."""
BRIM, LIQUID, LOOSE = 0.92, 0.85, 0.6
"""Of what is said to be full; of what a vessel is said to hold, by what that is."""
_SHOWN = "clear|clean|fresh|still|calm|plain|tap|pure"
"""Adjectives that a drawing of a content answers by itself."""
_OTHER = "hot|cold|cool|warm|boiling|steaming|icy|dirty|muddy|murky|soapy|salty|sparkling|fizzy"
"""Those that it does not."""
COUNTED = r"(?:a|an|the|one|two|three|his|her|its|their|this|that|another|each)"


@dataclass(frozen=True)
class Filling:
    """A vessel that is filled.

    Args:
        vessel: Where its noun begins in the text.
        start, end: Words that say so.
        content: Name of what is in it.
        share: Of its depth.
        color: As it is said, None where it is not.
        lacks: Words about it that nothing shows.
    """

    vessel: int
    start: int
    end: int
    content: str
    share: float
    color: str | None = None
    lacks: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True)
class Floating:
    """Something that floats or sinks in a vessel.

    Args:
        says: Which of them; `INSIDE` where it is only put on the surface.
        start, end: Words that say so.
        vessel: Where the noun of the vessel begins, -1 where it was named before.
        lasts: Whether it is so all the time, not only at the end.
    """

    says: Predicate
    start: int
    end: int
    vessel: int = -1
    lasts: bool = False


@dataclass
class Fillings:
    """What was taken out of a text.

    Args:
        told: The text as it was.
        text: The text without it, of the same length.
        fillings, floating, splashes, meant, changed: What was found.
        shown: What shines, falls from the sky or sways.
    """

    told: str
    text: str
    fillings: list[Filling] = field(default_factory=list[Filling])
    floating: list[Floating] = field(default_factory=list[Floating])
    splashes: list[tuple[int, int]] = field(default_factory=list[tuple[int, int]])
    """Verbs of which only the fall is shown."""
    changed: list[tuple[int, int]] = field(default_factory=list[tuple[int, int]])
    """Where the text is another now."""
    shown: list[Shown] = field(default_factory=list[Shown])
    lain: list[Lain] = field(default_factory=list[Lain])
    """How things lie and stand."""
    meant: dict[str, str] = field(default_factory=dict[str, str])
    """By what a vessel is filled with, the vessel's noun: "the water" is what is in it."""


def take_out(text: str, nouns: Sequence[int] = ()) -> Fillings:
    """Reads what vessels of a text are filled with.

    Args:
        text: A prompt as it was screened.
        nouns: Where words begin that are nouns: "a cup of coffee beans" is filled with none.
    """
    found = Fillings(text, text)
    if "drop" in text.lower():
        for m in [*_DROP.finditer(text)]:
            _blank(found, *m.span(), "droplets" if m["many"] or m["more"] else "droplet")
    found.lain = take_lying(found.text, nouns, partial(_blank, found))
    found.shown = take_shown(found.text, partial(_blank, found))
    if not _ANY.search(found.text) or not _vessel_words().search(found.text):
        return found
    taken = frozenset(nouns)
    for read in (_within, _said_of_it, _after, _before):
        read(found, taken)
    _on_its_level(found)
    _floats(found)
    _falls_in(found)
    _meant(found)
    if found.fillings:
        _at_last(found)
    return found


def _blank(found: Fillings, start: int, end: int, instead: str = "") -> None:
    """Puts other words, no longer than they are, in the place of some."""
    found.text = found.text[:start] + instead.ljust(end - start) + found.text[end:]
    found.changed.append((start, end))


def _filling(
    found: Fillings, m: re.Match[str], vessel: int, at: tuple[int, int], full: str = ""
) -> None:
    name = contents_said()[m["content"].lower()]
    adjectives = m["adjectives"] or ""
    base = m.start("adjectives")
    words = [
        (w[0].lower(), base + w.start(), base + w.end()) for w in re.finditer(r"\S+", adjectives)
    ]
    if words and name == "wine" and words[-1][0] == "white":
        name, words = "white wine", words[:-1]
    share = next((s for w, s in _FULL.items() if w in full.lower()), 0.0)
    usual = LIQUID if contents()[name].liquid else LOOSE
    found.fillings.append(
        Filling(
            vessel,
            *at,
            content=name,
            share=share or (BRIM if "full" in full.lower() and contents()[name].liquid else usual),
            color=next((lex.COLORS[w] for w, _, _ in words if w in lex.COLORS), None),
            lacks=tuple((a, b) for w, a, b in words if re.fullmatch(_OTHER, w)),
        )
    )  # fmt: skip


def _goes_on(found: Fillings, end: int, nouns: frozenset[int]) -> bool:
    """Whether a noun follows, of which what was read is only the first word ("coffee beans")."""
    after = re.compile(r"[ -](\w*)").match(found.text, end)
    if after is None or after[0][0] == "-":
        return after is not None
    return after.start(1) in nouns and not verb_readings(after[1].lower())


def _after(found: Fillings, nouns: frozenset[int]) -> None:
    """ "A bucket (that is) filled with water", "a glass of milk", "a pot containing soup"."""
    for m in [*_after_words().finditer(found.text)]:
        bare = m["with"] and m.end() == m.end("content")  # "washes a bowl with water"
        if not bare and not _goes_on(found, m.end(), nouns):
            _filling(found, m, m.start("vessel"), (m.start("told"), m.end()), m["how"] or "")
            _blank(found, m.start("told"), m.end())


def _meant(found: Fillings) -> None:
    """ "The water" is what is in the vessel, where the text has no other."""
    for f in found.fillings:
        words = [w for w, name in contents_said().items() if name == f.content]
        found.meant.update(dict.fromkeys(words, _word(found.text, f.vessel)))


def _said_of_it(found: Fillings, nouns: frozenset[int]) -> None:
    """ "The bucket is half full of water", "the bucket contains water": it stands there."""
    for m in [*_said_words().finditer(found.text)]:
        if _goes_on(found, m.end(), nouns) or re.match(r"\s+(?:by|from)\b", found.text[m.end() :]):
            continue
        _filling(found, m, m.start("vessel"), (m.start("told"), m.end()), m["how"] or "")
        plural = (m["verb"] or m["holds"]).lower() in ("are", "were", "contain", "hold")
        _blank(found, m.start("told"), m.end(), "stand" if plural else "stands")


def _before(found: Fillings, nouns: frozenset[int]) -> None:
    """ "A water-filled bucket"."""
    for m in [*_before_words().finditer(found.text)]:
        _filling(found, m, m.start("vessel"), (m.start("told"), m.end("told")))
        _blank(found, m.start("told"), m.end("told"))


def _within(found: Fillings, nouns: frozenset[int]) -> None:
    """ "Into the water in a bucket": into the bucket."""
    for m in [*_within_words().finditer(found.text)]:
        told = m["told"].rstrip()
        _filling(found, m, m.start("vessel"), (m.start("told"), m.start("told") + len(told)))
        _put_into(found, m)


def _put_into(found: Fillings, m: re.Match[str]) -> None:
    """In the place of "on the surface of"; what is set down there is set down on it."""
    if _SET_DOWN.search(found.text, 0, m.start()):
        at = m.start("prep"), m.end("told") - 1
        found.floating.append(Floating(Predicate.INSIDE, *at, m.start("vessel")))
        _blank(found, m.start("told"), m.end("told"))
        return
    into = m["prep"].lower() in ("into", "onto", "to")
    if "surface" in m["told"].lower() or m["told"].lower().startswith("the top"):
        at = m.start("prep"), m.end("told") - 1
        found.floating.append(Floating(Predicate.INSIDE, *at, m.start("vessel"), lasts=True))
    _blank(found, m.start("prep"), m.end("told"), "into " if into else "in ")


_SET_DOWN = re.compile(
    r"\b(?:puts?|places?|sets?|lays?|lowers?|(?:is|are|gently|carefully|slowly|softly|lightly)\s+"
    r"(?:placed|put|set|laid|lowered)|(?:placed|put|set|laid|lowered)\s+"
    r"(?:down\s+)?(?:gently|carefully|slowly|softly|lightly))\b[^.,;]*$",
    re.IGNORECASE,
)
"""An act that sets something down, and not how it is from the start."""


def _on_its_level(found: Fillings) -> None:
    """ "On the surface of a bucket" that is filled: in it, as its density says."""
    filled = {f.vessel for f in found.fillings}
    names = {_word(found.text, at) for at in filled}
    for m in [*_level_words().finditer(found.text)]:
        if m.start("vessel") in filled or _word(found.text, m.start("vessel")) in names:
            _put_into(found, m)


def _floats(found: Fillings) -> None:
    """ "A ball floats in a bathtub": it lies in it, and there is water."""
    filled = {f.vessel for f in found.fillings}
    names = {_word(found.text, at) for at in filled}
    for m in [*_floats_words().finditer(found.text)]:
        verb, vessel, at = m["verb"].lower(), _vessel(found, m), m.span("verb")
        if vessel < 0:
            continue
        if vessel not in filled and _word(found.text, vessel) not in names:
            found.fillings.append(Filling(vessel, m.start("prep"), m.end(), "water", LIQUID))
        found.floating = [f for f in found.floating if f.vessel != vessel or f.start < m.start()]
        found.floating.append(Floating(Predicate.FLOATS, *at, vessel, lasts=True))
        lies = {"floats": "lies", "float": "lie", "floated": "lay", "floating": "lying"}[verb]
        _blank(found, *at, lies)
        _blank(found, *m.span("prep"), "in")
    for m in [*_sinks_words().finditer(found.text)]:
        vessel = _vessel(found, m)
        if vessel in filled or (vessel >= 0 and _word(found.text, vessel) in names):
            bottom = "bottom" in m["prep"]
            at = (m.start("verb"), m.end("prep") if bottom else m.end("verb"))
            found.floating.append(Floating(Predicate.SINKS, *at, vessel))
            if bottom:
                _blank(found, *m.span("prep"), "into")


def _vessel(found: Fillings, m: re.Match[str]) -> int:
    """Where the noun of the vessel begins that a match names, or of the one that holds the content
    that it names; -1 for none."""
    if m["vessel"]:
        return m.start("vessel")
    name = contents_said()[m["content"].lower()]
    holds = [f.vessel for f in found.fillings if f.content == name and f.vessel < m.start()]
    return max(holds, default=-1)


def _falls_in(found: Fillings) -> None:
    """ "Splashes into a bucket": it falls in, and no splash is shown."""
    names = {_word(found.text, f.vessel) for f in found.fillings}
    for m in [*_splash_words().finditer(found.text)]:
        if _word(found.text, m.start("vessel")) in names:
            verb = m["verb"].lower()
            falls = {"splashes": "falls", "splash": "fall", "splashed": "fell"}.get(verb, "falling")
            found.splashes.append((m.start("verb"), m.end("verb")))
            _blank(found, m.start("verb"), m.end("verb"), falls)


def _at_last(found: Fillings) -> None:
    """ "Is dropped into a bowl of water and sinks to the bottom"."""
    first = min(f.vessel for f in found.fillings)
    for m in [*_last_words().finditer(found.text)]:
        if m.start() > first:
            says = Predicate.SINKS if m["sinks"] else Predicate.FLOATS
            found.floating.append(Floating(says, m.start("told"), m.end("told")))
            _blank(found, m.start(), m.end())


def _word(text: str, at: int) -> str:
    found = re.compile(r"\w+").match(text, at)
    return lex.singular(found[0].lower())[0] if found else ""


_ANY = re.compile(
    r"\b(?:full|of|with|containing|contains?|holding|holds?|filled|float\w*|sink\w*|sank|water)\b",
    re.I,
)


@cache
def _vessels() -> str:
    words = lex.word_set("filled vessels")
    return rf"(?P<vessel>(?:{any_of([*words, *(w + 's' for w in words), 'glasses'])}))\b"


@cache
def _vessel_words() -> re.Pattern[str]:
    return _compiled(rf"\b{_vessels()}")


@cache
def _content() -> str:
    adjectives = f"{_SHOWN}|{_OTHER}|{any_of([c for c in lex.COLORS if c.isalpha()])}"
    return (
        rf"(?P<adjectives>(?:(?:{adjectives})\s+){{0,2}})"
        rf"(?P<content>{any_of([*contents_said()])})\b"
    )


_HOW = (
    r"(?P<how>(?:(?:half|partly|partially|almost|nearly|quarter|completely|entirely)[\s-]+)?"
    r"(?:full\s+of|filled\s+(?:(?:up|to\s+the\s+(?:brim|top|rim))\s+)?with|brimming\s+with))"
)
_SOME = r"\s+(?:some\s+|a\s+little\s+)?"
_INSIDE = r"(?:\s+(?:in\s+it|inside(?:\s+it)?)(?=[\s,.;]|$))?"


def _counted() -> str:
    """A vessel with its article or number, and a word or two between."""
    return rf"{COUNTED}\s+(?:[\w-]+\s+){{0,2}}?{_vessels()}"


def _where() -> str:
    """A vessel, or what one is filled with."""
    return (
        rf"(?:{_counted()}"
        rf"|the\s+(?P<content>{any_of([*contents_said()])})\b)"
    )


def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern, re.IGNORECASE)


@cache
def _after_words() -> re.Pattern[str]:
    which = r"(?:(?:that|which)\s+(?:is|are|was)\s+)?"
    how = _HOW.replace("(?P<how>", "(?P<how>of|containing|holding|(?:that|which)\\s+contains|")
    told = rf"(?P<told>(?:{which}{how}{_SOME}|(?P<with>with){_SOME}){_content()}{_INSIDE})"
    return _compiled(rf"\b{_vessels()}\s+{told}")


@cache
def _said_words() -> re.Pattern[str]:
    how = _HOW.replace("(?P<how>", "(?P<how>")
    verb = rf"(?P<verb>is|are|was|were)\s+{how}"
    return _compiled(
        rf"\b{_vessels()}\s+(?P<told>(?:{verb}|(?P<holds>contains?|holds?)){_SOME}{_content()})"
    )


@cache
def _before_words() -> re.Pattern[str]:
    return _compiled(rf"\b(?P<told>{_content()}[\s-]filled)\s+(?:[\w-]+\s+){{0,2}}?{_vessels()}")


@cache
def _within_words() -> re.Pattern[str]:
    part = r"(?:the\s+(?:surface|top|bottom)\s+of\s+)?(?:the\s+|some\s+)?"
    return _compiled(
        rf"\b(?P<prep>in|into|inside|through|onto|on|to|at)\s+(?P<told>{part}{_content()}"
        rf"\s+(?:in|inside|within|of)\s+)(?={_counted()})"
    )


@cache
def _level_words() -> re.Pattern[str]:
    return _compiled(
        r"\b(?P<prep>on|onto|to|at|upon)\s+(?P<told>(?:the\s+)?(?:surface|top)\s+of\s+)"
        rf"(?={_counted()})"
    )


@cache
def _floats_words() -> re.Pattern[str]:
    return _compiled(
        r"\b(?P<verb>floats|float|floated|floating)\s+"
        rf"(?P<prep>inside|in|on\s+top\s+of|on\s+the\s+(?:surface|top)\s+of|on)\s+{_where()}"
    )


@cache
def _splash_words() -> re.Pattern[str]:
    return _compiled(
        r"\b(?P<verb>splashes|splash|splashed|splashing)\s+(?:down\s+)?into\s+"
        rf"{_counted()}"
    )


_DROP = re.compile(
    r"\b(?:(?:rain|dew)[\s-]?drop|drop(?P<many>s)?\s+of\s+(?:rain)?water|(?<=\ba )water\s+drop"
    r"|water\s+droplet)(?(many)|(?P<more>s)?)\b(?!\s+cling)",
    re.IGNORECASE,
)


@cache
def _sinks_words() -> re.Pattern[str]:
    return _compiled(
        r"\b(?P<verb>sinks?|sank|sinking)\s+"
        rf"(?P<prep>into|inside|in|(?:down\s+)?to\s+the\s+bottom\s+of|through)\s+{_where()}"
    )


@cache
def _last_words() -> re.Pattern[str]:
    named = any_of([*contents_said(), *lex.word_set("filled vessels")])
    of = rf"(?:\s+of\s+(?:it|the\s+(?:{named})))?"
    where = rf"(?:\s+(?:up\s+)?(?:to|on|at)\s+(?:the|its)\s+(?:surface|top){of})?"
    down = rf"(?:\s+(?:down\s+)?to\s+the\s+bottom{of})?"
    return _compiled(
        r",?\s*\b(?:and|but|then|where|until)\s+(?:then\s+)?(?:it\s+)?(?P<told>(?P<sinks>sinks?"
        rf"{down})|floats?{where}|(?:stays?|remains?)\s+(?:afloat|on\s+(?:the|its)\s+surface{of}))"
        r"(?=\s*(?:[.,;]|$))"
    )
