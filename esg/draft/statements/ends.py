"""What stands at an end, an edge or a corner of a table, a shelf or a plank at the start."""

from __future__ import annotations

from collections.abc import Iterator
import re

from esg.draft.discourse.core import structural
from esg.draft.discourse.places import elevated
from esg.draft.discourse.record import Discourse
from esg.draft.events.stated import start_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.statements.book import Told, ids
from esg.graph.models import NodeEvent, Predicate
from esg.lexicon.parts import CORNER, EDGE, END, OTHER_END, SIDE, TOWARDS, known

ENDS_THERE = "nothing sees to it that it ends there"
_WORDS = {"end": END, "edge": EDGE, "rim": EDGE, "corner": CORNER, "side": SIDE}
"""What a part is called, where no word says which one of several it is."""
_WHICH = frozenset({"one", "other", "opposite", "very"})
"""What may be said of a part so that any of them, or the one that is left, is meant."""
_ORDER = ("front", "back", "left", "right")
"""How sides of a corner follow each other in its name."""
_PREPS = frozenset({"on", "at", "in", "near", "by", "close to", "upon", "from"})
_STANDING = frozenset({"be", "posture", "have", "left_so", "park"})
_OTHER = re.compile(r"\b(?:the )?(?:other|opposite)\b", re.IGNORECASE)
_ALL = re.compile(r"\b(?:each|both|every|either|all)\b", re.IGNORECASE)
_END_TO_END = re.compile(
    r"\bfrom (?:one|the|an) (?:[a-z]+ )?(?:end|edge|corner|side)\b[^.,;]{0,40}? to the "
    r"(?:(?:other|opposite|far)\b(?: (?:end|edge|corner|side)\b)?|\w+ (?:end|edge|corner)\b)",
    re.IGNORECASE,
)


def at_parts(t: Told) -> None:
    """ "A cup at one end of a table and a jug at the other": two statements of the start."""
    d = t.d
    for m in _END_TO_END.finditer(d.text):
        crosses = any(s.direction == "across" and s.start < m.end() and m.start() < s.end
                      for s in t.book.items)  # fmt: skip
        if not crosses:
            t.book.add(Predicate.NOT_REPRESENTED, *m.span(), note=ENDS_THERE)
    for about, p in _placed(t.frames, d):
        m = p.mention
        part = _part(m.part.split()) if m is not None else None
        if m is None or part is None or p.prep not in _PREPS:
            continue
        start = start_of(p, d.text)
        words, hosts = d.text[start : m.end], [i for i in ids(m) if _has_ends(d, i)]
        if not hosts or _ALL.search(words):
            continue
        there = tuple(i for i in about if d.scene.supported_by.get(i) == hosts[0])
        if p.prep == "from":
            there = tuple(i for i in there if _sets_off(d, i))
        if not there or not {*there}.isdisjoint(d.scene.at_part):
            continue
        before = tuple(i for i, at in d.scene.at_part.items() if at == (hosts[0], END))
        if _OTHER.search(words):
            if part != END or not before:
                continue
            part = OTHER_END
        named = known(part)
        if named is None:
            continue  # "on the side of a table"
        d.scene.at_part.update((i, (hosts[0], named)) for i in there)
        others = before if part == OTHER_END else ()
        t.book.add(Predicate.AT_PART, start, m.end, object=there, target=(hosts[0], *others),
                   noun=part, when="start")  # fmt: skip


def _placed(frames: list[Frame], d: Discourse) -> Iterator[tuple[list[str], Phrase]]:
    """Who is said to be where at the start, in the order of the text."""
    found = [(ids(m), p) for m, p in d.attached]
    found += [
        (ids(f.object if f.object is not None and not f.verb.passive else f.subject), p)
        for f in frames for p in f.phrases
        if not f.unreal and (f.verb.sense in _STANDING or p.prep == "from" or _laid(d, f))
    ]  # fmt: skip
    told = [(about, p) for about, p in found if p.mention is not None]
    return iter(sorted(told, key=lambda x: x[1].mention.start if x[1].mention else 0))


def _part(words: list[str]) -> str | None:
    """The part that words name; None if they name none, or say of it what is not the viewer's."""
    kind = _WORDS.get(words[-1]) if words else None
    sides = sorted({*words[:-1]} & {*TOWARDS}, key=[*_ORDER].index)
    if kind is None or not {*words[:-1]} <= _WHICH | {*TOWARDS}:
        return None
    part = " ".join((*sides, kind))
    return part if known(part) is not None or part == SIDE else None


def _laid(d: Discourse, f: Frame) -> bool:
    """ "A plate is placed at the edge of a table": where it is from the start on."""
    put = f.verb.sense in ("put", "place", "noop", "pick") and f.verb.passive
    return put and not any(e.actor in ids(f.subject) for e in d.timeline.edges)


def _has_ends(d: Discourse, node: str) -> bool:
    """Whether it is a table, a shelf or a plank, and not the floor."""
    return node in d.world.entities and not structural(d, node) and elevated(d, node)


def _sets_off(d: Discourse, node: str) -> bool:
    """Whether it leaves a part without falling off there."""
    falls = any(n.event is NodeEvent.FALL and node in n.participants for n in d.timeline.nodes)
    return not falls and any(e.actor == node for e in d.timeline.edges)
