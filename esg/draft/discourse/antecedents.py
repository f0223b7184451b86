"""What "it" means: the best of the things told of, by their part there and by what "it" does.

A thing has a part in every clause that names it; how well a part suits what is asked for, less a
little for every clause since, is its score there, and its best score is its own.
"""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import aimable, entity_of, kind_of, movable
from esg.draft.discourse.record import Discourse, Told
from esg.draft.discourse.referents.sizes import dimensions_of, mass_of
from esg.draft.discourse.scene import SELF_POWERED
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Mention

_FALLING = frozenset({"fall", "topple", "land", "pocket", "drop"})
_FLYING_ON = lex.word_set("flying on") | {"hit", "miss", "land"}
_CONTACT = frozenset({"hit", "knock", "topple", "miss"})
_HALTING = lex.word_set("halting")
_STEERED = lex.word_set("steered (anaphora)")
STATES = lex.word_set("states (references)")
_LAUNCHING = frozenset({"launch", "drop", "roll", "slide"})
_AT = ("at", "against", "toward", "towards", "into", "to")
_WAYS = frozenset({"stairs", "ramp"})
_PARTS = ("does", "is", "undergoes", "is sent", "is met", "is there")
"""Parts of a clause: who acts, of what a state is told, what is acted on, thrown or dropped, what
is run into or aimed at, and all else."""
_SCORES = {
    "falls": (4.0, 6.0, 6.0, 6.0, 6.5, 0.0),
    "goes on": (4.0, 3.0, 2.0, 6.0, 0.0, -1.0),
    "steers": (6.0, 4.0, 3.0, 2.0, 2.0, -1.0),
    "does": (6.0, 4.0, 2.0, 2.0, 0.0, -1.0),
    "undergoes": (2.0, 3.0, 4.2, 4.2, 4.2, 1.0),
    "is halted": (5.0, 3.0, 3.0, 5.0, 2.0, 0.0),
    "is hit": (2.5, 3.0, 4.2, 2.5, 4.5, 1.0),
}  # fmt: skip
"""By what is asked of "it", how well each of `_PARTS` suits."""
_PER_CLAUSE, _PER_SENTENCE = 0.5, 0.5
"""What a clause, and the end of a sentence, take from a score."""
_SUITS = {
    "self powered": 4.0,
    "same actor": 1.5,
    "another actor": 1.5,
    "way": -3.0,
    "fixed": -2.0,
    "aside": -2.0,
    "stays": -3.0,
}


def _asked(f: Frame, m: Mention) -> str:
    """What a clause tells of "it"."""
    if m is not f.subject:
        if f.verb.sense == "cause":
            return "falls"
        if m is f.object and f.verb.lemma in _HALTING:
            return "is halted"
        return "is hit" if f.verb.sense in _CONTACT else "undergoes"
    off = "off" in f.adverbs or f.phrase("off", "from") is not None
    falls = f.verb.sense in _FALLING or (off and f.verb.sense in ("roll", "slide"))
    pots = f.subordinate == "before" and f.phrase("into") is not None
    if falls and f.object is None and not pots:
        return "falls"
    if f.verb.sense in _STEERED and not f.verb.passive:
        return "steers"
    return "goes on" if f.verb.sense in _FLYING_ON or f.link == "until" else "does"


def part_of(d: Discourse, t: Told, i: str) -> str:
    """The part that a thing has in a clause, or ""."""
    f = t.frame
    if i in t.objects:
        sent = f.verb.sense in _LAUNCHING or (f.verb.sense == "hit" and f.phrase(*_AT))
        return "is sent" if sent and not f.verb.passive else "undergoes"
    if i in t.subject:
        return "is" if f.verb.sense in STATES else "undergoes" if f.verb.passive else "does"
    phrases = [p for p in f.phrases if p.mention is not None and i in p.mention.entities]
    if phrases:
        aimed = f.verb.sense in _LAUNCHING | _CONTACT or phrases[0].prep not in ("at", "to")
        return "is met" if phrases[0].prep in _AT and aimed else "is there"
    return ""


def it_means(d: Discourse, f: Frame, m: Mention, avoid: list[str]) -> list[str]:
    """The thing, or the plural of one name, that "it" means in a clause; none if nothing suits."""
    asked = _asked(f, m)
    carries = f.verb.sense in STATES and m is not f.subject  # "a bucket standing on top of it"
    scores: dict[tuple[str, ...], float] = {}
    for age, t in enumerate(reversed(d.refs.told)):
        for ids in t.named():
            i = ids[0]
            part = part_of(d, t, i)
            if not part or not _can_be(d, ids, avoid):
                continue
            score = _SCORES[asked][_PARTS.index(part)]
            score -= _PER_CLAUSE * age + _PER_SENTENCE * (f.sentence - t.frame.sentence)
            later = m is f.subject and f.sentence > t.frame.sentence
            stands = later and asked == "falls" and not f.phrases and "off" not in f.adverbs
            said = {
                "self powered": asked == "steers" and kind_of(d, i) in SELF_POWERED,
                "same actor": m is not f.subject and f.subject is t.frame.subject,
                "another actor": m is not f.subject and part in ("does", "is") and _new(f),
                "way": kind_of(d, i) in _WAYS,
                "fixed": not carries
                and _stands_firm(d, i, asked == "falls" and part == "undergoes"),
                "stays": part in ("undergoes", "is met") and _stays(d, f, i, t, stands),
                "aside": t.frame.subordinate not in ("", "so") and f.start_of_sentence,
            }
            score += sum(_SUITS[name] for name, so in said.items() if so)
            scores[tuple(ids)] = max(score, scores.get(tuple(ids), -99.0))
    return list(max(scores, key=lambda ids: scores[ids])) if scores else []


def _new(f: Frame) -> bool:
    """Whether somebody comes into the story."""
    return f.subject is not None and not f.subject.pronoun


def _stands_firm(d: Discourse, i: str, felled: bool) -> bool:
    """Whether a thing rarely moves: a wall, a tree, what carries other things."""
    return not (movable(d, i) or felled) or "support" in entity_of(d, i).noun.traits


def _stays(d: Discourse, f: Frame, i: str, t: Told, stands: bool) -> bool:
    """Whether "it" is rather what hits a thing: "A scooter hits a truck. It falls over."."""
    mine = entity_of(d, i)
    for e in (entity_of(d, k) for k in t.subject if movable(d, k)):
        rounder = "round" in e.noun.traits - mine.noun.traits
        if stands and mass_of(mine, dimensions_of(mine)) >= mass_of(e, dimensions_of(e)):
            return True
        rolls = f.verb.sense == "roll" and t.frame.verb.sense == "hit" and not f.subordinate
        if rounder and rolls:
            return True  # "A ball hits a box, and it rolls off the table"
    return False


def _can_be(d: Discourse, ids: list[str], avoid: list[str]) -> bool:
    """Whether "it" can mean these at all."""
    if set(ids) & {*avoid} or any(i not in d.world.entities for i in ids):
        return False
    e = entity_of(d, ids[0])
    if e.noun.kind == "person" or e.noun.name == "arm" or not aimable(d, ids[0]):
        return False
    return len(ids) == 1 or e.group in d.world.collective
