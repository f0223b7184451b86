"""Adjectives and participles of what is drawn: what of them the scene shows.

Each word before a noun ("a hot pan") or after "is" and "looks" ("the bowl is empty") is asked for
a colour, a material, a size, a weight, a shape or a motion. What it asks for in vain is owned up
to; the word set "qualities that pass" has what shows nothing of its own or is told otherwise.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, movable, structural
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.slopes import ASLANT
from esg.draft.discourse.scene import LIMBED
from esg.draft.document.joining import STANDS_OPEN
from esg.draft.events.hanging import row_of
from esg.draft.events.motions import ROLLING
from esg.draft.events.stated import NAMED_BY
from esg.draft.events.told import happened
from esg.draft.statements.account import NOTHING, PASSED_OVER, Account, Gap, nodes_of, turns
from esg.draft.text.elements import ONE_OF_THESE, Mention, Token, Verb, Word, element_at
from esg.draft.verbphrases import verb_readings
from esg.graph.models import NodeEvent, Predicate
from esg.lexicon.senses import no_things

MOTIONS = frozenset({"own", "fly", "fall", "roll", "accelerate", "spin"})
"""Senses of going."""
_GOINGS_ON = lex.word_set("unseen goings-on")
_UNSEEN = lex.word_set("unseen qualities")
_PASS = lex.word_set("qualities that pass") | lex.PLACE_ADJECTIVES | PASSED_OVER
_TOLD = (
    frozenset(lex.COLORS) | frozenset(lex.MATERIALS) | frozenset(lex.SIZES)
    | frozenset(lex.WEIGHTS) | frozenset(lex.RANKS) | frozenset(lex.ORDINALS)
)  # fmt: skip
"""Words of which a thing is made as they say."""
_ROUND, _ANGULAR = lex.word_set("round shapes"), lex.word_set("angular shapes")
_UNMADE, _MADE = lex.word_set("unmade"), frozenset({"asphalt", "concrete"})
"""What a road may be called, and the materials of those that are drawn."""
_OF_A_QUALITY = frozenset({"ADJ", "VERB"})
"""Parts of speech of words that tell a quality; a noun before a noun tells its kind."""
_TILTED = frozenset({"raised", "lowered", "upper", "lower"})
"""Words of an end of a seesaw."""
_SHADES = frozenset({"light", "dark", "bright", "pale", "deep"})
"""Words that tell a colour after them more closely."""
_WORDS = frozenset({"ADJ", "NOUN", "PROPN"})
"""Parts of speech of words that tell of something."""
_LOOKS = frozenset({"look", "appear", "feel", "sound"})
"""Verbs of which a quality says what is meant ("looks angry")."""
_DOWN = (NodeEvent.TOPPLE, NodeEvent.FALL)
_DONE = {
    **dict.fromkeys(("fallen", "toppled", "overturned", "upset", "upended"), _DOWN),
    **dict.fromkeys(("broken", "shattered", "smashed", "cracked"), (NodeEvent.BREAK,)),
}
"""Participles of what may have happened in the scene ("one of the fallen pins")."""
_OF_A_KIND = frozenset({"substance", "place"})
"""Classes of nouns that no object is drawn of, and that tell the kind of one before its noun."""
_SAYS_SO = frozenset({"be", "noop", "left_so", "posture"})
"""Senses of verbs that a quality may follow ("is empty", "looks sad", "lies upside down")."""


_AMONG_THINGS = re.compile(
    r"(?P<thing>\w+)-(?:lined|strewn|studded|flanked|dotted|shaded|fringed|littered)$"
)
"""Words before a noun that ask for many other things."""


def _among_things(word: str) -> bool:
    """ "A tree-lined avenue": trees that no document has."""
    found = _AMONG_THINGS.match(word)
    return found is not None and found["thing"] in lex.nouns()


def qualities(a: Account) -> Iterator[Gap]:
    """ "A curious sloth", "a hot pan", and "a moving vehicle" that does not move."""
    moving = {e.actor for e in a.d.timeline.edges}
    for m in a.d.mentions:
        ids = nodes_of(a.d, m)
        if not ids:
            continue
        if ONE_OF_THESE in m.adjectives and not _in_order(a.d, ids[0]):
            yield Gap(m.start, m.end, NOTHING, tuple(ids))
        if not m.adjectives:
            continue
        laid = structural(a.d, ids[0])
        words = [t for t in a.tokens if m.start <= t.start < m.end and t.low in m.adjectives]
        for k, t in enumerate(words):
            later = words[k + 1].low if k + 1 < len(words) else ""
            lost = (
                _laid_lost(t.low, entity_of(a.d, ids[0]))
                if laid
                else _lost(a, t, later, entity_of(a.d, ids[0]), moving)
            )
            if lost or _among_things(t.low):
                yield Gap(t.start, t.end, NOTHING, tuple(ids))


def _laid_lost(word: str, e: Entity) -> bool:
    """ "A dirt road", which is drawn of asphalt; what is laid does not lean."""
    return word in ASLANT or (word in _UNMADE and e.noun.material in _MADE)


def _lost(a: Account, t: Token, later: str, e: Entity, moving: set[str]) -> bool:
    """Whether a word before a noun asks for something that the thing has not."""
    word, noun = t.low, e.noun
    if word in STANDS_OPEN and row_of(a.d, e.id) is not None:
        return False
    if word in _TILTED and e.id in a.d.scene.openings:
        return False  # "on the raised end of a seesaw"
    if word in _UNSEEN:
        return True
    if word == e.color:
        return False  # "a coral block", "a coral reef"
    if word in noun.name.split() or (later in lex.COLORS and word in _SHADES):
        return False
    if word in ASLANT:
        return "incline" not in noun.traits
    if word in _DONE:
        return not any(happened(a.d, event, e.id) for event in _DONE[word])
    if word.endswith("ing"):
        manner, _, last = word.rpartition(" ")
        paced = not manner or not _motion(last) or _paced(a, e.id)
        return _going(a, last, e, moving) or not paced
    if word in _ROUND | _ANGULAR:
        return not _shaped(e, word)
    if word in lex.STRETCHES:
        return noun.shape == "sphere" and not e.dimensions_prescribed
    last = word.rpartition(" ")[2]
    kind = word in lex.nouns() or no_things().get(word, "") in _OF_A_KIND  # "a castle wall"
    return t.tag in _OF_A_QUALITY and last not in _TOLD | _PASS and not kind and "-" not in word


def _going(a: Account, word: str, e: Entity, moving: set[str]) -> bool:
    """Whether a participle tells of what its thing does not do, and of no kind of things."""
    if word in _GOINGS_ON or word in NAMED_BY:
        return word in _GOINGS_ON  # "a running shoe", "a racing pigeon"
    if _manner(word):
        return not any(_SHOWN_BY[s](a, {e.id}) for s in _senses(word) & {*_SHOWN_BY})
    if _motion(word):
        goes = word == "moving" or movable(a.d, e.id)
        return goes and e.id not in moving and word not in _PASS
    return kind_of(a.d, e.id) in LIMBED and word not in _PASS  # no "measuring tape"


def _paced(a: Account, node: str) -> bool:
    """Whether a pace is stated of a thing ("a slowly moving car")."""
    paces = (Predicate.FASTER_THAN, Predicate.SLOWER_THAN)
    return any(s.predicate in paces and node in s.object for s in a.kept)


def _shaped(e: Entity, word: str) -> bool:
    """Whether a thing has the shape that a word tells; of a compound one nobody knows."""
    round_ = e.noun.shape in ("sphere", "cylinder") or "round" in e.noun.traits
    if word in _ROUND:
        return round_ or e.noun.shape != "box"
    return not round_


def said_of_it(a: Account) -> Iterator[Gap]:
    """ "The bowl is empty", "he looks sad", "a mug is upside down": nothing was made of it."""
    tags = {t.start: t.tag for t in a.tokens}
    has = {x for e in a.d.world.entities.values() for x in e.adjectives} | _PASS | {*lex.COLORS}
    measured = {t.end + 1 for t in a.tokens if t.kind == "qty"}  # "is 1 m long"
    before: Verb | None = None
    for k, x in enumerate(a.elements):
        if isinstance(x, Verb):
            before = x
            yield from _within(a, x, has)
        elif isinstance(x, Mention) or x.kind in ("punct", "rel", "sub"):
            before = None
        elif x.kind == "unknown" and x.start not in measured and x.low not in has:
            used = (x.start, x.end) in a.d.scene.used or not x.low[1:].isalpha()
            if not used and _tells(a, x, tags.get(x.start, ""), before, k):
                looks = before is not None and before.lemma in _LOOKS
                yield Gap(before.start if before and looks else x.start, x.end, NOTHING)


def _within(a: Account, verb: Verb, has: set[str]) -> Iterator[Gap]:
    """ "Is asleep": what was read as part of the verb."""
    for t in a.tokens if verb.sense == "be" else ():
        if verb.start < t.start < verb.end and t.tag == "ADJ" and t.low not in has:
            yield Gap(t.start, t.end, NOTHING)


def _tells(a: Account, x: Word, tag: str, before: Verb | None, k: int) -> bool:
    """Whether a word that nothing took up tells a quality, or names what nobody knows."""
    if x.low in _UNSEEN | _GOINGS_ON:
        return True
    if x.low in lex.PLAIN_ADJECTIVES:
        return before is not None and before.sense in _SAYS_SO
    after, first = element_at(a.elements, k + 1), element_at(a.elements, k - 1)
    if tag == "VERB":  # "a stolen van"
        opens = isinstance(first, Word) and first.low in lex.DETERMINERS
        return opens and isinstance(after, Mention) and bool(nodes_of(a.d, after))
    kind = tag != "ADJ" and isinstance(after, Mention) and nodes_of(a.d, after)
    return tag in _WORDS and not kind  # "a shed door" is a door


def _in_order(d: Discourse, who: str) -> bool:
    """Whether what is ahead of another one, or behind it, is gone for by it, or goes for it."""
    movers = {e.actor for e in d.timeline.edges}
    return any(who in {e.actor, e.target} <= movers for e in d.timeline.edges)


def _motion(word: str) -> bool:
    return bool(_senses(word) & MOTIONS) or _manner(word)


def _manner(word: str) -> bool:
    """Whether a participle tells more than that something moves ("a reversing van")."""
    return bool(_senses(word) & {*_SHOWN_BY})


def _senses(word: str) -> set[str]:
    told = (r for r in verb_readings(word) if r.form == "ing" and word not in NAMED_BY)
    senses = {r.lemma if r.lemma in _SHOWN_BY else r.sense for r in told}
    return senses if word == ROLLING or "roll" not in senses else senses - {"roll"} | {"own"}


def _jointed(a: Account, ids: set[str]) -> bool:
    return bool(ids & {j.child for j in a.d.scene.joints})


def _swings(a: Account, ids: set[str]) -> bool:
    acting = {i for n in a.d.timeline.nodes for i in n.participants}
    return _jointed(a, ids) and bool(ids & (acting | {e.actor for e in a.d.timeline.edges}))


def _hangs(a: Account, ids: set[str]) -> bool:
    says = {i for s in a.kept if s.predicate is Predicate.HANGS_FROM for i in s.object}
    return _jointed(a, ids) or bool(ids & ({*a.d.scene.attached} | says))


def _backs(a: Account, ids: set[str]) -> bool:
    return any(s.direction == "backward" and ids & {*s.object} for s in a.kept)


def _rolls(a: Account, ids: set[str]) -> bool:
    """Whether it is stated to roll, or what is no ball moves (a "rolling" cart)."""
    says = {i for s in a.kept if s.predicate is Predicate.ROLLS for i in s.object}
    goes = ids & {e.actor for e in a.d.timeline.edges}
    wheeled = any("wheeled" in entity_of(a.d, i).noun.traits for i in goes)
    return bool(ids & says) or wheeled


_SHOWN_BY: dict[str, Callable[[Account, set[str]], bool]] = {
    "roll": _rolls,
    "spin": lambda a, ids: turns(a.d, ids),
    "turn": lambda a, ids: turns(a.d, ids),
    "reverse": _backs,
    "swing": _swings,
    "sway": _swings,
    "hang": _hangs,
    "dangle": _hangs,
}
"""What shows a participle by its sense: a van that is reversing has to go backward."""
