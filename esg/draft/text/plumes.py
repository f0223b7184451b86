"""Smoke, steam, dust and sparks: taken out of the text, as `shining` does with lights.

"Smoke rises from a chimney" is read as "see a chimney", "a car drives off, leaving a cloud of dust
behind it" as "a car drives off".
"""

from __future__ import annotations

from functools import cache
import re

from esg.draft.text.shown import BEFORE, Read, Shown
from esg.graph.models import Predicate
from esg.lexicon.plumes import plumes

_MUCH = r"(?:(?:thick|black|white|grey|gray|dark|hot|dense|fine|a\s+lot\s+of|some|little)\s+)*"
_OF = (
    r"(?:(?:an?|the|some|its|huge|large|big|small|long|thick)\s+)*(?:(?:clouds?|trails?|plumes?|"
    rf"puffs?|columns?|wisps?|showers?|jets?|bursts?|streams?)\s+of\s+)?{_MUCH}"
)
_BEHIND = (
    r"(?:\s+(?:(?:up\s+)?behind\s+(?:it|him|her|them)|in\s+(?:its|his|her|their)\s+wake|into\s+the\s+"
    r"(?:air|sky)|as\s+it\s+goes|everywhere|up))?"
)
_SORTS = "iron|steel|rear|front|back|tail|open|broken|left|right|two|four|hot|big|tall|chimney"
"""What parts are called besides, that smoke comes from."""
_OWN = r"(?:its|his|her|their)"


@cache
def _name_of() -> dict[str, str]:
    return {w: row.name for row in plumes().values() for w in row.words}


@cache
def _patterns() -> tuple[re.Pattern[str], ...]:
    what = "|".join(sorted(_name_of(), key=lambda w: (-len(w), w)))
    said = rf"(?P<what>{what})"
    rises = (
        r"(?:(?:slowly|gently|thickly|slightly)\s+)?(?:ris(?:e|es|ing)|com(?:e|es|ing)|pour(?:s|ing)?|billow(?:s|ing)?|"
        r"drift(?:s|ing)?|curl(?:s|ing)?|escap(?:e|es|ing)|fl(?:y|ies|ying)|shoot(?:s|ing)?|"
        r"spew(?:s|ing)?|puff(?:s|ing)?)"
        r"(?:\s+(?:up|out|slowly|gently|off|upwards?))*"
    )
    gives = (
        r"(?:(?:gives?|giving|gave|sends?|sending|puffs?|puffing|throws?|throwing)\s+(?:off|out|up)|emit(?:s|ting)?|"
        r"belch(?:es|ing)?|spew(?:s|ing)?|release[sd]?|releasing|leav(?:es|ing)|left|"
        r"trail(?:s|ing)?|rais(?:es|ing)|kick(?:s|ing)\s+up|kick\s+up|stir(?:s|ring)\s+up|"
        r"whirl(?:s|ing)\s+up|creat(?:es|ing)|mak(?:es|ing)|sprays?|spraying|shed(?:s|ding)?)"
    )
    joined = r"(?:\s*,?\s*\b(?:and|while|as)\s+|\s*,\s*|\s+)"
    owner = r"(?=(?:an?|the|his|her|two|three|some)\s+\w)"
    part = rf"{_OWN}\s+(?:(?:{_SORTS})\s+)?[\w-]+"
    return (
        # "with smoke coming from its engine", ", sparks flying from its wheels"
        re.compile(
            rf"{joined}(?:with\s+)?{_OF}{said}\s+{rises}\s+(?:from|out\s+of|off|behind|of)\s+"
            rf"(?P<own>{part}|it|him|her|them)\b",
            re.IGNORECASE,
        ),
        # "smoke rises from a chimney", "sparks fly from the wheels of a train"
        re.compile(
            rf"\b(?P<told>{_OF}{said}\s+{rises}\s+(?:from|out\s+of|off)\s+)"
            rf"(?P<part>the\s+[\w-]+\s+of\s+)?{owner}(?:an?|the|his|her|two|three|some)\s+"
            r"(?:[\w-]+\s+){0,2}?(?P<owner>[\w-]+)"
            r"(?=\s*(?:[.,;]|$|(?:and|on|in|of|as|while|at|beside|that)\b))",
            re.IGNORECASE,
        ),
        # ", leaving a cloud of dust behind it", "and kicks up dust"
        re.compile(
            rf"{joined}(?:which\s+|that\s+)?{gives}\s+{_OF}{said}{_BEHIND}"
            r"(?=\s*(?:[.,;]|$|(?:and|as|while|on|in|from)\b))",
            re.IGNORECASE,
        ),
        # "a smoking car", "a steaming cup"
        re.compile(
            r"\b(?P<being>smoking|steaming|smouldering|smoldering)\s+(?:(?:hot|old|big|small|black|white|red)\s+)?"
            r"(?P<owner>(?!(?:gun|man|woman|area|room|in|on|at|from|under|and|beside|near|while|as)\b)"
            r"[\w-]+)",
            re.IGNORECASE,
        ),
        # "a cup of tea is steaming"
        re.compile(
            r"\s+(?:is|are|was|were)\s+(?P<being>smoking|steaming|smouldering|smoldering)\b"
            r"(?!\s+(?:an?|the|his|her|cigars?|cigarettes?|pipes?)\b)",
            re.IGNORECASE,
        ),
    )


_BEING = {"smoking": "smoke", "smouldering": "smoke", "smoldering": "smoke", "steaming": "steam"}


def given_off(text: str) -> Read:
    """ "Smoke rises from a chimney", "leaving a cloud of dust behind it", "a steaming cup"."""
    from_own, from_other, gives, being, is_so = _patterns()
    for m in from_own.finditer(text):
        yield _told(m, BEFORE), [(*m.span(), "")]
    for m in from_other.finditer(text):
        told = m["told"] + (m["part"] or "")
        start = m.start("told")
        noun = _name_of()[m["what"].lower()]
        at, hue = (start, m.end("owner")), _color(m, noun)
        shown = Shown(Predicate.GIVES_OFF, *at, noun, m.start("owner"), lacks=hue)
        yield shown, [(start, start + len(told), _kept(text[:start]))]
    for m in gives.finditer(text):
        if re.search(r"[A-Za-z]", text[: m.start()]):
            bare = not m[0].lstrip().startswith(",") and not m[0].lower().lstrip(" ,").startswith(
                ("and", "while", "as", "which", "that")
            )
            verb = bare and not re.search(r"ing\b", m[0].split()[0])
            yield _told(m, BEFORE), [(*m.span(), " is there" if verb else "")]
    for m in being.finditer(text):
        noun = _BEING[m["being"].lower()]
        shown = Shown(Predicate.GIVES_OFF, *m.span("being"), noun, m.start("owner"))
        yield shown, [(*m.span("being"), "")]
    for m in is_so.finditer(text):
        noun = _BEING[m["being"].lower()]
        shown = Shown(Predicate.GIVES_OFF, m.start("being"), m.end("being"), noun, BEFORE)
        yield shown, [(*m.span(), " is there")]


def _told(m: re.Match[str], about: int) -> Shown:
    lead = len(m[0]) - len(m[0].lstrip(" ,"))
    name = _name_of()[m["what"].lower()]
    if name == "smoke" and _PIPE.search(m.groupdict().get("own") or ""):
        name = "exhaust"
    at = m.start() + lead, m.end()
    return Shown(Predicate.GIVES_OFF, *at, name, about, lacks=_color(m, name))


_PIPE = re.compile(r"\b(?:exhaust|tail\s?pipe|muffler)", re.IGNORECASE)
_HUES = re.compile(r"\b(?:black|white|dark|red|yellow|green|blue|brown|orange)\b", re.IGNORECASE)
_USUAL = {"steam": "white", "snow dust": "white", "dust": "brown"}


def _color(m: re.Match[str], name: str) -> tuple[int, int] | None:
    """A colour that is told of a plume and is not the one that it is drawn in."""
    hue = _HUES.search(m[0][: m.start("what") - m.start()])
    if hue is None or hue[0].lower() == _USUAL.get(name):
        return None
    return (m.start() + hue.start(), m.start() + hue.end())


def _kept(before: str) -> str:
    """What keeps the noun that follows a thing that is there."""
    return "with" if re.search(r"\bwith\s*$", before) else "see"
