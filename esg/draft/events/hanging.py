"""What a clause tells of turns or slides on a joint: it opens, or hangs and is let go."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, mark_used
from esg.draft.discourse.jointed import articulation_of
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import head_of
from esg.draft.discourse.referents.parts import parts_of
from esg.draft.discourse.referents.registry import add_entity, current_id
from esg.draft.discourse.referents.wholes import has_pans
from esg.draft.discourse.tracks import Motion
from esg.draft.events.timing import moved_by_others
from esg.draft.events.told import amount, at_rest, one_that, recent
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Mention
from esg.graph.models import ForceDirection
from esg.lexicon.articulations import Articulation, articulations

SHUTTING = lex.word_set("shutting") | {"closed"}
_TURNING = lex.word_set("turning on an axle")
_OPENING = SHUTTING | {"open"}
OTHER_SIDE = re.compile(r"(?:on)?to (?:the|its) other (?:side|end)", re.IGNORECASE)
_TIPPING = {("topple", "tip"), ("noop", "tilt"), ("noop", "rock"), ("noop", "seesaw")}
TIPPED = 0.6
"""Share of its limit to which a seesaw with nobody on it is tipped; its friction holds it there."""
NEARLY_LEVEL = 0.05
"""The same of a balance on whose one pan something lands: under a degree, as it looks level."""
SWAYING = frozenset({"swing", "sway", "oscillate"})
_SLIDING = lex.word_set("slides out")
_BOBBING = lex.word_set("bobs")
_MAKING = lex.word_set("makes a turn")
_TIMES = {"half a": 0.5, "two": 2.0, "three": 3.0, "four": 4.0, "five": 5.0}
_SHARES = {"quarter": 0.25, "half": 0.5, "three-quarter": 0.75}
_TURNS = re.compile(
    rf"(?:\b(an?|one|{'|'.join(_TIMES)})\s+)?"
    r"(?:(quarter|half|three-quarter|full|complete|whole)[ -])?"
    r"\b(?:turn|rotation|revolution)s?\b",
    re.IGNORECASE,
)
"""How far something turns, in words."""
_RISING = {"go": "up", "rise": "", "raise": "", "lift": ""}
_SINKING = {"go": "down", "come": "down", "lower": ""}
"""How what has hinges goes up and down, with the adverb that says so: a boom gate, a lid."""
_WORKING = lex.word_set("works a lever")
_FLYING_OUT = lex.word_set("flies out")
_SWINGING = {
    ("noop", "sway"): "swing",
    ("noop", "oscillate"): "swing",
    ("noop", "click"): "swing",
    ("drop", "release"): "let_go",
    ("drop", "let"): "let_go",
    ("carry", "lift"): "let_go",
    ("carry", "raise"): "let_go",
    ("tow", "pull"): "let_go",
    ("topple", "pull"): "let_go",  # "is pulled up"
}


_LYING_SHUT = frozenset({"close", "shut"})
_PUSHING, _WALKED_THROUGH = lex.word_set("pushing open"), lex.word_set("walked through")
_ROUND = re.compile(
    r"(?:all the way |right |fully |completely |once )*(?:a)?round(?: (?:once|twice|(\w+) times))?"
    r"(?=\s*(?:[.,;]|and\b|$))",
    re.IGNORECASE,
)
"""How far something goes round, in words."""
BACK_AND_FORTH = re.compile(
    r"back and forth|to and fro|from side to side|up and down"
    r"|out(?:,| and) back(?: and out again)?",
    re.IGNORECASE,
)
"""How what hangs moves, in words."""
_GOING = lex.word_set("goes round")
UNMET = "touched by nothing that is named"
"""Note of a verb that tells what is not touched on the way."""
SENT_UP = "launched by the seesaw"
"""Note of a verb that tells what a seesaw launches."""


def row_of(d: Discourse, node: str) -> Articulation | None:
    """How a thing of the scene is jointed."""
    return (
        articulation_of(d.scene, d.text, entity_of(d, node)) if node in d.world.entities else None
    )


def hanging(d: Discourse, bodies: list[str]) -> list[str]:
    """Those that hang and can be drawn back."""
    return [b for b in bodies if (row := row_of(d, b)) is not None and row.drawn is not None]


def openable(d: Discourse, bodies: list[str]) -> list[str]:
    """Those that open and close."""
    return [b for b in bodies if (row := row_of(d, b)) is not None and row.opened is not None]


def turned_instead(d: Discourse, f: Frame, subject: list[str]) -> list[str]:
    """ "A coconut falls on the lid and it slams shut": what can of those named last."""
    words = d.text[f.verb.start : f.verb.end].lower().split()
    so = f.verb.extra.get("result") in _OPENING or f.verb.lemma in SHUTTING
    so = so or (f.verb.lemma in SWAYING and words[-1] in _OPENING)
    if not so or f.object is not None:
        return subject
    return one_that(d, f.subject, subject, lambda i: bool(openable(d, [i])))


def closed_instead(d: Discourse, f: Frame, objects: list[str]) -> list[str]:
    """ "Open the drawer, take out the scissors and close it": what can be closed."""
    m = f.object
    it = m is not None and m.pronoun == "it" and f.verb.lemma in _OPENING | _LYING_SHUT
    if not it or openable(d, objects):
        return objects
    return next(([i] for i in recent(d) if openable(d, [i])), objects)


def by_their_doors(d: Discourse, f: Frame, bodies: list[str]) -> list[str]:
    """ "A man closes the fridge", "opens a book": what turns is its door, its cover.

    The part is there from then on, and the thing itself is what it is joined to.
    """
    told = f.verb.sense == "noop" and f.verb.lemma in _OPENING
    told = told or f.verb.extra.get("result") in _OPENING
    if not told or f.unreal or openable(d, bodies):
        return bodies
    return [_door_of(d, b) for b in bodies]


def _door_of(d: Discourse, body: str) -> str:
    """The door, cover or lid of a thing that has one; the thing itself if it has none."""
    head = head_of(entity_of(d, body)) if body in d.world.entities else ""
    rows = (r for r in articulations().values() if r.kind == "hinge" and r.opened is not None)
    row = next((r for r in rows if head in r.serves and r.carries == "with"), None)
    if row is None:
        return body
    there = (e.id for e in d.world.entities.values() if row_of(d, e.id) is row)
    known = next(there, None)
    if known is not None:
        return known
    name = row.nouns[0]
    return add_entity(d.world, lex.part(row.becomes), name, mentioned=False).id


def lies_shut(d: Discourse, f: Frame, bodies: list[str]) -> bool:
    """ "The door is shut. A man walks up to it": how it is at first, as nobody has opened it."""
    told = f.verb.passive and f.verb.lemma in _LYING_SHUT and f.phrase("by") is None
    words = d.text[f.verb.start : f.verb.end].lower().split()
    return told and words[:1] == ["is"] and len(words) == 2 and all(
        b not in d.timeline.tracks and b not in d.scene.openings for b in bodies
    )  # fmt: skip


def walks_into(d: Discourse, f: Frame, bodies: list[str]) -> bool:
    """ "Pushes the gate open": who pushes a leaf goes through it, and meets it on the way."""
    rows = [row_of(d, b) for b in bodies]
    leaves = bool(rows) and all(row is not None and row.becomes in _WALKED_THROUGH for row in rows)
    return leaves and f.verb.lemma in _PUSHING


def named_parts(d: Discourse) -> None:
    """ "The lid of a chest stands open ... on the lid": a part goes by its name alone later on."""
    parts = {n.split()[-1] for row in articulations().values() for n in row.serves}
    known: dict[str, list[str]] = {}
    for m in d.mentions:
        name = m.part or m.head
        if name not in parts:
            continue
        if m.part and m.entities:
            known[name] = [*m.entities]
        elif not m.entities and m.determiner == "the" and name in known:
            m.entities = d.world.resolved[id(m)] = [*known[name]]


def told_by_their_parts(d: Discourse) -> None:
    """ "A ball hits the lid of a box", "a box lid": the lid, where the thing has a row with one.

    What `wholes.csv` calls a part of it is a place on it: "sits on the cover of a book".
    """
    for m in d.mentions:
        if not m.part or len(m.entities) != 1 or m.entities[0] not in d.world.entities:
            continue
        whole = entity_of(d, m.entities[0])
        name = f"{head_of(whole)} {m.part}"
        if name in articulations() and not lex.is_part(m.part, whole.noun):
            m.entities = d.world.resolved[id(m)] = [_door_of(d, whole.id)]


def tipping(d: Discourse, bodies: list[str]) -> list[str]:
    """Those that tip to one side or the other: a seesaw."""
    return [b for b in bodies if (row := row_of(d, b)) is not None and row.tips]


def tipped(d: Discourse, m: Mention) -> None:
    """ "On the raised end of a seesaw": one end is up before something lands there.

    "Into one pan of a balance": that pan, which is hardly higher than the other.
    """
    for body in tipping(d, m.entities):
        row = row_of(d, body)
        share = TIPPED if m.part.endswith("end") else 0.0
        share = NEARLY_LEVEL if has_pans(entity_of(d, body), m.part) else share
        if row is not None and share:
            d.scene.openings.setdefault(body, share * (row.upper or 0.0))


def sent_up(d: Discourse, f: Frame, agents: list[str], sent: list[str]) -> bool:
    """ "A crate drops onto a seesaw and launches a ball": it sits on the end that is down.

    Returns:
        Whether a seesaw, or what landed on one, does the launching.
    """
    last = d.moves.last_hit
    landed = [last[1]] if last is not None and last[0] in agents else []
    board = next(iter(tipping(d, [*agents, *landed])), None)
    if board is None or board in sent or not d.timeline.track(board).hit:
        return False
    row = row_of(d, board)
    d.scene.openings[board] = (row.upper or 0.0) if row else 0.0
    for body in sent:
        d.scene.supported_by[body] = board
        d.scene.relations = [r for r in d.scene.relations if body not in (r.source, r.target)]
        track, under = d.timeline.track(body), d.timeline.track(board)
        track.at, track.hit, track.role, track.closed = under.at, True, under.role, False
    mark_used(d, f, SENT_UP)
    return True


def thrown_up(d: Discourse, f: Frame, bodies: list[str]) -> bool:
    """ "The coin on the other end flies up": by what fell on the seesaw that it is on."""
    last = d.moves.last_hit
    board = (
        next(iter(tipping(d, [last[1]])), None) if last is not None and len(bodies) == 1 else None
    )
    if board is None or last is None or last[0] in bodies:
        return False
    places = [p.mention for m, p in d.attached if {*m.entities} == {*bodies} and p.prep == "on"]
    places += [
        p.mention for g in d.told for p in g.phrases
        if g.subject is not None and {*g.subject.entities} == {*bodies} and p.prep == "on"
    ]  # fmt: skip
    ends = (m for m in places if m is not None and m.part.endswith(("end", "side")))
    return any(board in m.entities for m in ends) and sent_up(d, f, [board], bodies)


def sprung_back(d: Discourse, f: Frame, bodies: list[str]) -> bool:
    """ "The spring throws it back", "is thrown back", "rolls back": off the bumper that it hit."""
    last = d.moves.last_hit
    row = row_of(d, last[1]) if last is not None and last[0] in bodies else None
    return row is not None and row.rebounds and "back" in f.adverbs


def turning(d: Discourse, bodies: list[str]) -> list[str]:
    """Those that turn on and on about an axle: a merry-go-round, the sails of a windmill."""
    rows = ((b, row_of(d, b)) for b in bodies)
    return [b for b, row in rows if row is not None and row.turns]


def turns_told(d: Discourse, f: Frame) -> float | None:
    """How far something turns by what is told after its verb: "a quarter turn" [degrees]."""
    told = _ROUND.match(d.text, f.verb.end + 1)
    if told is not None:
        d.scene.used[told.span()] = "how far it turns"
        return 360.0 * (2.0 if "twice" in told[0].lower() else _TIMES.get(told[1] or "", 1.0))
    told = _TURNS.search(d.text, f.verb.end)
    if told is None or "." in d.text[f.verb.end : told.start()]:
        return None
    times, share = (told[1] or "").lower(), (told[2] or "").lower()
    d.scene.used[told.span()] = "how far it turns"
    return 360.0 * _TIMES.get(times, 1.0) * _SHARES.get(share, 1.0)


def sense_on_joint(d: Discourse, f: Frame, bodies: list[str]) -> str | None:
    """The sense of a verb of what moves on a joint; None if nothing of the kind is told of."""
    told = _on_hinges(d, f, bodies) or _about_an_axle(d, f, bodies)
    if told is not None:
        return told
    if (f.verb.sense, f.verb.lemma) in _TIPPING and tipping(d, bodies[:1]):
        landed_on = not at_rest(d, bodies[0]) or OTHER_SIDE.search(d.text, f.verb.end)
        return "tip" if landed_on else None
    if f.verb.lemma in _BOBBING and {*bodies} & d.scene.sprung:
        return "swing"
    swings = _SWINGING.get((f.verb.sense, f.verb.lemma))
    if "out" in f.adverbs and f.verb.lemma in _FLYING_OUT and any(row_parts(d, b) for b in bodies):
        return "swing"
    return swings if swings is not None and hanging(d, bodies) else None


def _on_hinges(d: Discourse, f: Frame, bodies: list[str]) -> str | None:
    """ "Is left ajar", "swings open", "slides out": the sense of what opens and shuts."""
    if not openable(d, bodies):
        return None
    if f.verb.sense == "posture" and f.verb.extra.get("result") in _OPENING:
        return "left_so"
    return "open" if _opens(f) or "result" in f.verb.extra else None


def _opens(f: Frame) -> bool:
    """Whether a verb tells that what has hinges or slides opens or shuts."""
    if f.verb.sense == "noop" and f.verb.lemma in _OPENING:
        return True
    out = f.verb.lemma in _SLIDING and bool({"out", "open"} & {*f.adverbs})
    return out or _worked(f) or raised(f) or lowered(f)


def _about_an_axle(d: Discourse, f: Frame, bodies: list[str]) -> str | None:
    """ "Makes one full turn", "goes round", "goes back and forth": it spins, or swings."""
    after = d.text[f.verb.end :].lstrip()
    turns = f.object is not None and _TURNS.match(f.object.head) is not None
    turns = turns or _TURNS.match(after) is not None  # "one full turn"
    if (f.verb.lemma in _TURNING or (turns and f.verb.lemma in _MAKING)) and turning(d, bodies):
        return "spin"
    if f.verb.lemma not in _GOING or f.verb.negated:
        return None
    if _ROUND.match(after) and turning(d, bodies):
        return "spin"
    return "swing" if BACK_AND_FORTH.match(after) and hanging(d, bodies) else None


def raised(f: Frame) -> bool:
    """ "The boom gate goes up", "the lid is lifted": what has hinges opens so."""
    return _goes(f, _RISING)


def lowered(f: Frame) -> bool:
    """ "The barrier comes down": it closes."""
    return _goes(f, _SINKING)


def _worked(f: Frame) -> bool:
    """ "The lever is pulled": nobody is told of who does it."""
    return f.verb.passive and f.verb.lemma in _WORKING and f.phrase("by") is None


def _goes(f: Frame, ways: dict[str, str]) -> bool:
    way = ways.get(f.verb.lemma)
    by = f.phrase("by") is not None if f.verb.passive else f.object is not None
    carried = f.verb.sense == "carry" and by
    return way is not None and not carried and (not way or way in f.adverbs)


def let_go(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """What hangs and nothing has moved yet starts drawn back: by a stated angle or a usual one."""
    angle = amount(d, f, "angle")
    for body in bodies:
        row = row_of(d, body)
        if row is None or moved_by_others(d, body) or not at_rest(d, body):
            continue
        drawn = (row.drawn or 0.0) if angle is None else angle.high
        d.scene.openings[body] = -drawn if _on_the_far_side(d, body) else drawn
        if angle is not None:
            mark_used(d, angle, "where it is let go")
        d.timeline.move(body, Motion("release"), ForceDirection.ANY_3D)


def row_parts(d: Discourse, body: str) -> list[str]:
    """The parts among which a part goes by its number, in their order: the balls of a cradle."""
    e = entity_of(d, body)
    whole = d.world.entities.get(current_id(d.world, e.whole))
    return [] if whole is None else [x.id for x in parts_of(d.world, whole)]


def _on_the_far_side(d: Discourse, body: str) -> bool:
    """Whether a part is drawn back the other way: the last ball of a cradle."""
    row = row_parts(d, body)
    return body in row and 2 * row.index(body) > len(row)
