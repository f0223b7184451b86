"""What is lit, falls from the sky and sways, as statements (words: `esg.draft.text.shining`)."""

from __future__ import annotations

from collections.abc import Sequence
import re

from esg.draft.discourse.core import entity_of, kind_of, structural
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import LIVING
from esg.draft.document.requirements import environment
from esg.draft.events.courses import measurable
from esg.draft.statements.book import Book, Told
from esg.draft.statements.looks.contents import named_at
from esg.draft.text.shown import BEFORE, Shown
from esg.graph.models import Predicate
from esg.lexicon.plumes import plumes
from esg.lexicon.shown import Light, lights_of, swaying, weathers

NOBODY = "it changes by itself: nobody's hand does it"
NO_LIGHT = "nothing in the scene has such a light"
NO_SKY = "no weather is shown indoors"
_OF_THINGS = ("smoke", "steam", "exhaust", "sparks")
"""Plumes that nobody alive gives off."""
OTHER_HUE = "it is drawn in its usual colour"
NO_SOURCE = "nothing in the scene gives it off"
STIFF = "nothing in the scene sways as it does"
_STATES = {"burning": "on", "turned burning": "turned on", "turned out": "turned off"}
_LATER = re.compile(r"\s*,?\s*(?:when|once|after|as soon as)\b", re.IGNORECASE)


def shown(t: Told) -> None:
    """ "Its headlights on", "the lamp goes out", "in the rain", "a flag waves in the wind"."""
    for s in t.d.scene.fillings.shown:
        _WRITERS[s.says](t, s)


def _lit(t: Told, s: Shown) -> None:
    d, book = t.d, t.book
    burns = s.noun in _STATES
    found: dict[str, Light] = {}
    who: list[str] = []
    for who in _bearers(d, s):
        found = {i: row for i in who if (row := _light(d, i, s, burns=burns)) is not None}
        if found:
            break
    if not found:
        book.add(Predicate.NOT_REPRESENTED, s.start, s.end, object=tuple(who), note=NO_LIGHT)
        return
    row = next(iter(found.values()))
    noun = f"{row.name} {_STATES.get(s.noun, s.noun)}"
    when = _since(t, s) if "turned" in noun else "throughout"
    alike = tuple(i for i in found if found[i] == row)
    book.add(Predicate.LIT, s.start, s.end, object=alike, noun=noun, when=when)
    if s.act is not None:
        book.add(Predicate.NOT_REPRESENTED, *s.act, object=alike, note=NOBODY)


def _bearers(d: Discourse, s: Shown) -> list[list[str]]:
    """Of what it may be said: what is named there, or what was named before, the last first."""
    if s.about != BEFORE:
        return [named_at(d, s.about)]
    before = sorted((m for m in d.mentions if m.start < s.start), key=lambda m: -m.start)
    return [named_at(d, m.start) for m in before]


def _light(d: Discourse, node: str, s: Shown, *, burns: bool) -> Light | None:
    """The light of a node that words mean."""
    e = entity_of(d, node)
    names = {e.noun.name, e.head, e.noun.name.replace("_", " ")}
    own = lights_of(names, wheeled="wheeled" in e.noun.traits)
    own = [row for row in own if row.flame is burns]
    said = [row for row in own if not s.light or s.light in row.words]
    flashing = [row for row in said if row.name == "beacon"]
    return next(iter(flashing if "flashing" in s.noun and flashing else said), None)


def _since(t: Told, s: Shown) -> str:
    """The event before which it is not so: what was told last, or what the words name after it."""
    kinds = {n.id: n.event for n in t.d.timeline.nodes}
    told = [
        (f.verb.start, note) for f in t.frames
        if (note := str(t.d.scene.used.get((f.verb.start, f.verb.end)))) in kinds
        and measurable(kinds[note])
    ]  # fmt: skip
    if _LATER.match(t.d.text, s.end):
        return min([x for x in told if x[0] > s.end], default=(0, "throughout"))[1]
    return max([x for x in told if x[0] < s.start], default=(0, "throughout"))[1]


def _weather(t: Told, s: Shown) -> None:
    if environment(t.d.scene)[0] == "indoor":
        t.book.add(Predicate.NOT_REPRESENTED, s.start, s.end, note=NO_SKY)
        return
    t.book.add(Predicate.WEATHER, s.start, s.end, noun=s.noun)
    lacks = weathers()[s.noun.split()[-1]].not_shown
    if lacks and "thunder" in _words(t.book, s):
        t.book.add(Predicate.NOT_REPRESENTED, s.start, s.end, note=lacks)


def _words(book: Book, s: Shown) -> str:
    return (book.d.scene.fillings.told or book.d.text)[s.start : s.end].lower()


def _sways(t: Told, s: Shown) -> None:
    who: Sequence[str] = named_at(t.d, s.about)
    kinds = swaying()
    if who and all({entity_of(t.d, i).noun.name, entity_of(t.d, i).head} & {*kinds} for i in who):
        t.book.add(
            Predicate.SWAYS, s.start, s.end, object=tuple(who), noun=s.noun or None
        )  # fmt: skip
    else:
        t.book.add(Predicate.NOT_REPRESENTED, s.start, s.end, object=tuple(who), note=STIFF)


def _gives_off(t: Told, s: Shown) -> None:
    who = _doers(t, s) if s.about == BEFORE else named_at(t.d, s.about)
    if not who or (s.noun in _OF_THINGS and any(kind_of(t.d, i) in LIVING for i in who)):
        t.book.add(Predicate.NOT_REPRESENTED, s.start, s.end, note=NO_SOURCE)
        return
    moving = plumes()[s.noun].moving
    # "A smoking house" smokes already; "and smoke rises from it" tells what comes next.
    already = s.about >= s.end
    when = "throughout" if moving or already else _after_a_hit(t, s)
    t.book.add(Predicate.GIVES_OFF, s.start, s.end, object=tuple(who), noun=s.noun, when=when)
    if s.lacks is not None:
        t.book.add(Predicate.NOT_REPRESENTED, *s.lacks, object=tuple(who), note=OTHER_HUE)


def _doers(t: Told, s: Shown) -> list[str]:
    """Who does what was told last before: "a car drives across a desert, leaving dust"."""
    before = (f for f in t.frames if f.verb.start < s.end and f.subject is not None)
    for f in sorted(before, key=lambda f: -f.verb.start):
        who = [i for i in f.subject.entities if i in t.d.world.entities] if f.subject else []
        who = [i for i in who if not structural(t.d, i)]
        if who:
            return who
    nobody: list[str] = []
    named = (own for own in _bearers(t.d, s) if own and not structural(t.d, own[0]))
    return next(named, nobody)


def _after_a_hit(t: Told, s: Shown) -> str:
    """ "Hits a pole, and smoke rises from its engine": from then on."""
    since = _since(t, s)
    return since if since == "throughout" else f"{since}..end"


_WRITERS = {Predicate.LIT: _lit, Predicate.WEATHER: _weather, Predicate.SWAYS: _sways,
            Predicate.GIVES_OFF: _gives_off}  # fmt: skip
"""How each of them is written down."""
