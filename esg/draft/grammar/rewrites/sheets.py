"""Data sheets and events named by nouns: "Ball: 2 kg, 10 m/s. Event: collision at t = 2 s."

What is listed becomes plain clauses: every label takes the properties beside it, and "a collision
between A and B" becomes "A hits B", with the time that stands anywhere in it at the end.
"""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.gaps import word_at
from esg.draft.text.elements import Element, Mention, Verb, Word

_ROLES = lex.word_set("roles")
_EVENTS = lex.word_set("events (sheets)")
_SPEEDS = frozenset({"speed", "velocity"})
_GAPS = lex.word_set("gaps (sheets)")
_HITS = lex.word_set("hits (sheets)")
_ENDS = ".;!?\n"
_EXTENTS = lex.word_set("extents")
_MOVES = lex.word_set("moves")
_GENERIC = frozenset({"object", "body", "item", "thing", "mass", "actor", "@"})


def from_sheet(elements: list[Element]) -> list[Element]:
    """Turns data sheets and nouns for events into clauses.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    parts = _sentences(elements)
    listed = sum(_label(p) != "" for p in parts)
    things: list[Mention] = []
    out: list[Element] = []
    for part in parts:
        part = _parked(_is_a(part))
        label = _label(part)
        label = label if listed > 1 or label == "gap" else ""
        if label and (row := _row(part, label, things)) is not None:
            out += row
            continue
        out += _telegram(_named_event(part, things))
    return out


def _parked(part: list[Element]) -> list[Element]:
    """ "Car B: 1200 kg, parked.": a state, not what it does."""
    colon, last = word_at(part, 1), next((e for e in reversed(part) if not _ending(e)), None)
    alone = sum(isinstance(e, Verb) for e in part) == 1 and isinstance(last, Verb)
    if colon is None or colon.low != ":" or not alone or last.lemma not in ("park", "stop"):
        return part
    return [
        Word(e.start, e.end, "adv", "at rest") if e is last and e.form != "s" else e for e in part
    ]


def _ending(e: Element) -> bool:
    return isinstance(e, Word) and e.kind == "punct"


_TOWARD = lex.word_set("toward")


def _telegram(part: list[Element]) -> list[Element]:
    """ "Hatchback, 1,150 kg, 64 km/h, into a barrier.": its mass, its speed, where it goes."""
    if any(isinstance(e, Verb) for e in part):
        return part
    k = 0
    while k < len(part) and not isinstance(part[k], Mention):
        e = part[k]
        if not (isinstance(e, Word) and (e.kind in ("adv", "unknown") or e.low == ":")):
            return part
        k += 1
    thing = part[k] if k < len(part) else None
    if not isinstance(thing, Mention) or thing.attribute or thing.pronoun:
        return part
    told: list[Word] = []
    n = k + 1
    while n < len(part) and isinstance(w := part[n], Word) and (w.amount or w.low in ",()"):
        told += [w] if w.amount is not None else []
        n += 1
    to, aim = word_at(part, n), part[n + 1] if n + 1 < len(part) else None
    if not told or to is None or to.low not in _TOWARD or not isinstance(aim, Mention):
        return part
    speeds = [w for w in told if w.amount and w.amount.dimension == "speed"]
    if len(speeds) != 1 or any(w.amount and w.amount.dimension == "time" for w in told):
        return part
    thing.amounts += [w.amount for w in told if w.amount and w not in speeds]
    goes = Verb(thing.end, thing.end, "go", "own", "s")
    at = Word(speeds[0].start, speeds[0].start, "prep", "at")
    return [*part[:k], thing, goes, at, speeds[0], *part[n:]]


def _sentences(elements: list[Element]) -> list[list[Element]]:
    """The elements cut after full stops, semicolons and new lines."""
    out: list[list[Element]] = [[]]
    for e in elements:
        out[-1].append(e)
        if isinstance(e, Word) and e.kind == "punct" and e.low in _ENDS:
            out.append([])
    return [p for p in out if p]


def _name(e: Element | None) -> str:
    if isinstance(e, Mention):
        return "" if e.pronoun else e.text.lower() or e.head
    return e.low if isinstance(e, Word) else ""


def _label(part: list[Element]) -> str:
    """The kind of a line of a sheet: role, event, speed, thing; "" for any other sentence."""
    colon = word_at(part, 1)
    if colon is None or colon.low not in (":", "=") or len(part) < 3:
        return ""
    name = _name(part[0])
    if name in _EVENTS:
        return "event"
    if name in _ROLES:
        return "role" if isinstance(part[2], Mention) else ""
    if not isinstance(part[0], Mention):
        return ""
    told = word_at(part, 2)
    if told is None or told.amount is None or any(isinstance(e, Verb) for e in part):
        return ""
    if part[0].head in _SPEEDS and part[0].attribute:
        return "speed"
    if part[0].head in _GAPS:
        return "gap"
    return "" if part[0].attribute else "thing"


def _row(part: list[Element], label: str, things: list[Mention]) -> list[Element] | None:
    """A line of a sheet as a sentence; None if it cannot be one."""
    end = part[-1] if isinstance(part[-1], Word) and part[-1].low in _ENDS else None
    body = part[2 : -1 if end is not None else None]
    if not body:
        return None
    stop = Word(part[-1].end, part[-1].end, "punct", ".") if end is None else end
    heading = Word(part[0].start, part[1].end, "adv", "heading")
    if label == "event":
        bare = isinstance(body[0], Mention) and body[0].head in _HITS and body[0].noun is None
        bare = bare and not any(isinstance(e, Mention) for e in body[1:])
        if bare and len(things) > 1:
            mover, met = _again(things[0]), _again(things[1])
            noun = body[0]
            hit = Verb(noun.start, noun.end, "hit", "hit", "s")
            return [heading, mover, hit, met, *body[1:], stop]
        return [heading, *_named_event([*body, stop], things)]
    if label == "gap":
        return [heading, *body, stop]
    if label == "speed":
        told = word_at(part, 2)
        if not things or told is None or told.amount is None or told.amount.dimension != "speed":
            return None
        at = Word(part[1].start, part[1].end, "prep", "at")
        return [
            Word(part[0].start, part[0].end, "adv", "heading"),
            _again(things[0]),
            at,
            told,
            stop,
        ]
    thing = part[0] if label == "thing" else body[0]
    rest = body if label == "thing" else body[1:]
    if not isinstance(thing, Mention) or any(isinstance(e, (Mention, Verb)) for e in rest):
        return None
    moving: list[Element] = []
    for k, e in enumerate(rest):
        if not isinstance(e, Word) or e.amount is None:
            continue
        if e.amount.dimension == "speed":
            moving += [Word(e.start, e.start, "prep", "at"), e]
        elif e.amount.dimension in ("mass", "length", "volume"):
            side = _name(rest[k + 1]) if k + 1 < len(rest) else ""
            if side in _EXTENTS:
                thing.adjectives.append(f"@{e.amount.start}:{side}")
            thing.amounts.append(e.amount)
    thing.determiner = thing.determiner or "a"
    things.append(thing)
    lead = [heading] if label == "role" else []
    return [*lead, thing, *moving, stop]


def _again(m: Mention) -> Mention:
    """The same thing, named once more."""
    return Mention(
        m.end, m.end, head=m.head, noun=m.noun, determiner="the", text=m.text, known=m.known,
        letters=list(m.letters), adjectives=[a for a in m.adjectives if a[0] != "@"],
    )  # fmt: skip


def _is_a(part: list[Element]) -> list[Element]:
    """ "Object A is a steel sphere.": the sphere A."""
    if len(part) < 3:
        return part
    name, be, thing = part[:3]
    if not isinstance(name, Mention) or not isinstance(be, Verb) or not isinstance(thing, Mention):
        return part
    if len(name.head) == 1 and name.head.isalpha() and set(name.adjectives) & _GENERIC:
        name.letters, name.head = [name.head.upper()], name.adjectives[-1]  # "body B"
    if be.sense != "be" or be.negated or len(name.letters) != 1 or name.head not in _GENERIC:
        return part
    if thing.attribute or thing.pronoun or thing.letters or thing.determiner not in ("a", "an"):
        return part
    thing.letters, thing.start = list(name.letters), name.start
    thing.determiner = ""
    thing.text = f"{thing.text} {name.letters[0]}"
    return part[2:]


def _named_event(part: list[Element], things: list[Mention]) -> list[Element]:
    """ "Impact after 3 s between a lorry and a caravan.": the lorry hits the caravan after 3 s."""
    k = 0
    while k < len(part) and _leads(part[k]):
        k += 1
    noun = part[k] if k < len(part) else None
    if not isinstance(noun, Mention) or noun.head not in _HITS or noun.noun is not None:
        return part
    link = k + 1
    times: list[Element] = []
    while (w := word_at(part, link)) is not None and w.low not in ("between", "of", "with"):
        if w.kind not in ("prep", "qty", "adv") or w.low in _ENDS:
            return part
        times.append(w)
        link += 1
    if w is None or not _one_time(times):
        return part
    rest = part[link + 1 :]
    first = rest[0] if rest else None
    if not isinstance(first, Mention) or first.attribute or first.head in ("place",):
        return part
    hit = Verb(noun.start, noun.end, "hit", "hit", "s")
    if first.plural or (first.count or 1) > 1:
        meet = Verb(noun.start, noun.end, "collide", "hit", "base")
        return [*part[:k], first, meet, *times, *rest[1:]]
    joins = ("and",) if w.low == "between" else ("and", "with", "against", "into", "on")
    for n, e in enumerate(rest[1:], start=1):
        if isinstance(e, Verb) and (w.low != "between" or e.form in ("s", "base")):
            return part  # "the impact of the hammer drives the wedge into the log"
        if isinstance(e, Word) and (e.low in joins) and n + 1 < len(rest):
            met = rest[n + 1]
            if not isinstance(met, Mention) or met.attribute:
                return part
            tail = rest[n + 2 :]
            acts = tail[0] if tail else None
            if isinstance(acts, Verb) and not acts.infinitive:
                if acts.lemma in ("happen", "occur", "take"):
                    return part
                if acts.lemma in _MOVES or acts.sense in ("cause", "knock"):
                    joint = Word(acts.start, acts.start, "conj", "and")
                    return [*part[:k], *rest[:n], hit, met, *times, joint, *tail]
            return [*part[:k], *rest[:n], hit, met, *times, *tail]
        if isinstance(e, Word) and e.kind == "punct" and e.low in _ENDS:
            break
    return part


def _leads(e: Element) -> bool:
    """Adverbs before the noun ("head-on", a heading)."""
    return isinstance(e, Word) and e.kind in ("adv", "unknown") and e.low not in ("no", "without")


def _one_time(times: list[Element]) -> bool:
    """Whether nothing but a time stands between the noun and its participants."""
    amounts = [e.amount for e in times if isinstance(e, Word) and e.amount is not None]
    return all(a.dimension == "time" for a in amounts) and (bool(amounts) or not times)
