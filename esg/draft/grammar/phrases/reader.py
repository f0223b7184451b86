"""Looking at tokens: is this word a noun, an adjective or a verb here?"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks, NounMatch
from esg.draft.grammar.phrases.nouns import low_at, match_noun, token_at
from esg.draft.text.elements import Element, Mention, Verb, Word
from esg.draft.text.numerals import parse_number
from esg.draft.text.tokens import is_name
from esg.draft.verbphrases import PHRASES, verb_readings
from esg.lexicon.hypernyms import hypernyms

_DOERS = frozenset({"animal", "cart", "flyer", "person", "robot", "vehicle", "watercraft"})
_NOUNS_FIRST = lex.word_set("nouns first")
_ALSO_NOUNS = lex.word_set("also nouns")
_ARTICLES = frozenset({"a", "an", "the", "its", "his", "her", "their", "another"})
_SUBJECTS = frozenset({"he", "she", "it"})
_OUT = frozenset({"away", "down", "off", "out", "over", "up"})
_OBJECTS = frozenset({"it", "him", "them"})
_COMMANDS = lex.word_set("commands")
_SMALL = lex.PREPOSITIONS | lex.ADVERBS | lex.MODALS | lex.DETERMINERS | lex.PRONOUNS
_AFTER_ACTS = frozenset({"DET", "NOUN", "PROPN", "ADJ", "ADP", "ADV", "PRON", "NUM"})
_BE = frozenset({"is", "are", "was", "were", "be", "been", "being", "'s", "gets", "get"})
_HAVE = frozenset({"has", "have", "had", "having"})
_CANNOT = frozenset({"cannot", "can't", "couldn't"})


_ADJECTIVES = lex.PLACE_ADJECTIVES.union(
    lex.PLAIN_ADJECTIVES, lex.COLORS, lex.MATERIALS, lex.SIZES, lex.STRETCHES, lex.WEIGHTS
)


def acts(c: Chunks, i: int) -> bool:
    """Whether a word in -s that could be a plural is the verb of the noun before it."""
    token, nxt = token_at(c, i), token_at(c, i + 1)
    if token is None or not any(r.form == "s" for r in verb_readings(token.low)):
        return False
    if nxt is None or nxt.kind in ("punct", "qty"):
        return True
    return nxt.low in lex.PREPOSITIONS | lex.DETERMINERS | lex.ADVERBS | lex.PRONOUNS | {"and"}


def element_before(c: Chunks) -> Element | None:
    return c.elements[-1] if c.elements else None


def known_adjective(low: str) -> bool:
    if "-" in low and any(p in lex.COLORS or p in lex.SIZES for p in low.split("-")):
        return True
    return low in _ADJECTIVES


def is_adjective(c: Chunks, i: int) -> bool:
    token = token_at(c, i)
    if token is None or token.kind != "word":
        return False
    low = token.low
    if known_adjective(low):
        return True
    return (
        token.tag == "ADJ"
        and not named_before(c, i)
        and match_noun(c, i) is None
        and not verb_readings(low)
        and low not in lex.PREPOSITIONS
    )


def _verb_context(c: Chunks, i: int) -> bool:
    nxt = token_at(c, i + 1)
    if nxt is None:
        return c.tokens[i].tag in ("VERB", "")
    low = nxt.low
    return (
        _individual(c, i + 1)
        or low in lex.DETERMINERS
        or low in lex.PRONOUNS
        or low in lex.PREPOSITIONS
        or nxt.kind in ("qty",)
        or low in lex.ADVERBS
        or low == "to"
        or (nxt.kind == "punct" and c.tokens[i].tag in ("VERB", ""))
    )


def _individual(c: Chunks, i: int) -> bool:
    """ "then rams pallet P2", "and hits car 3", "rams R2": a name in place of an article."""
    noun = match_noun(c, i)
    if noun is not None and noun[2]:
        return False
    name = token_at(c, i + (noun[1] if noun is not None else 0))
    return name is not None and is_name(name, after_noun=noun is not None)


def noun_soon(c: Chunks, i: int) -> bool:
    """Whether adjectives and then a noun follow without a determiner."""
    for j in range(i, min(i + 4, len(c.tokens))):
        low = low_at(c, j)
        if c.tokens[j].kind != "word" or low in lex.DETERMINERS or low in lex.PREPOSITIONS:
            return False
        if match_noun(c, j) is not None:
            return True
        if verb_readings(low) and not is_adjective(c, j):
            return False
        if low in lex.ADVERBS and not is_adjective(c, j):
            return False
        if not is_adjective(c, j):
            return c.tokens[j].tag in ("NOUN", "PROPN")
    return False


def verb_ahead(c: Chunks, i: int) -> bool:
    for j in range(i, min(i + 3, len(c.tokens))):
        low = low_at(c, j)
        if low in lex.MODALS or verb_readings(low):
            return True
        if low not in lex.ADVERBS:
            return False
    return False


def participle(c: Chunks, j: int, also_been: bool = False) -> bool:
    for k in range(j, min(j + 3, len(c.tokens))):
        low = low_at(c, k)
        if also_been and low == "been":
            return True
        if any(r.form in ("pp", "ing") for r in verb_readings(low)):
            return True
        if low not in lex.ADVERBS and not low.endswith("ly"):
            return False
    return False


@dataclass(frozen=True)
class _Word:
    """A word that may be a verb here.

    Args:
        at: Its token.
        low: The word.
        previous: The element before it.
        forms: Forms of a verb that it can be.
        noun: The noun that starts with it.
        nounish: Whether it can be a noun at all.
        adjectival: Whether it can be an adjective.
        next: The word after it.
    """

    at: int
    low: str
    previous: Element | None
    forms: set[str]
    noun: NounMatch | None
    nounish: bool
    adjectival: bool
    next: str


def verb_here(c: Chunks, i: int) -> bool:
    """Whether the token starts a verb group here."""
    low, previous = low_at(c, i), element_before(c)
    named = isinstance(previous, Mention)
    if low in _BE:
        return low != "'s" or named
    if low in _CANNOT or low in lex.MODALS - _ALSO_NOUNS or low in _HAVE:
        return True
    if low in ("will", "can", "might"):
        return named
    forms = {r.form for r in verb_readings(low)}
    if not forms:
        return False
    noun = match_noun(c, i)
    nounish = noun is not None or low in lex.PARTS
    nounish = nounish or bool({low, lex.singular(low)[0]} & lex.ATTRIBUTES)
    w = _Word(i, low, previous, forms, noun, nounish, is_adjective(c, i), low_at(c, i + 1))
    return next(bool(v) for test in _VERB_TESTS if (v := test(c, w)) is not None)


def _modifier_here(c: Chunks, w: _Word) -> bool | None:
    """What a word before the verb rules out: "whose speed", "too slow", "the slide"."""
    before = low_at(c, w.at - 1)
    if before == "whose":
        return False
    if w.adjectival and before in ("too", "very", "so", "quite") and w.forms <= {"base"}:
        return False
    named = isinstance(w.previous, Mention)
    if w.noun is not None and w.noun[1] > 1 and not named:
        return False
    ended = isinstance(w.previous, Mention) and w.previous.end == c.tokens[w.at - 1].end
    return False if before in lex.DETERMINERS and not ended else None


def _noun_first(c: Chunks, w: _Word) -> bool | None:
    """Words that are verbs only after a noun: "left", "back", "ground"."""
    if w.low not in _NOUNS_FIRST:
        return None
    if not isinstance(w.previous, Mention):
        before = w.previous.kind if isinstance(w.previous, Word) else ""
        if w.low == "set":  # "and set on a bed", "and then set down"; not "and set of spoons"
            placed = w.next != "of" and w.next in lex.PREPOSITIONS | lex.ADVERBS
            return before in ("conj", "adv") and placed
        return w.low == "back" and before == "conj"
    if w.low == "left":
        return w.next in ("the", "its", "a")
    if w.low not in ("back", "end", "wound", "ground"):
        return True
    phrases = PHRASES.get("wind" if w.low == "wound" else w.low, [])
    return any(p.match(c.text, c.tokens[w.at].end) for p, _, _ in phrases)


def _after_preposition(c: Chunks, w: _Word) -> bool | None:
    previous = w.previous
    if not isinstance(previous, Word):
        return None
    owner = (c.elements[-2:-1] or [None])[0]
    dangles = previous.low in ("behind", "ahead", "opposite") and isinstance(owner, Mention)
    if dangles and "s" in w.forms:
        return True  # "bike behind hits bumper"
    side = "from" in (getattr(owner, "low", ""), c.text[previous.start :].split(" ")[0].lower())
    if side and "s" in w.forms and w.next in lex.DETERMINERS | lex.PREPOSITIONS | lex.ADVERBS:
        return True  # "a boat seen from above crosses a lake"
    if previous.kind == "prep" and "ing" not in w.forms:
        return not (w.nounish or w.adjectival) and previous.low != "by"
    return None


def _after_noun(c: Chunks, w: _Word) -> bool | None:
    if not isinstance(w.previous, Mention):
        return None
    ends = w.next in ("", ".", ",", ";")
    noun = w.forms == {"ing"} and w.noun is not None and c.tokens[w.at].tag == "NOUN"
    noun = noun and getattr(w.previous.noun, "kind", "") not in _DOERS
    return not (ends and noun)  # "A ball hits a box, oil painting."


def _after_verb(c: Chunks, w: _Word) -> bool | None:
    previous = w.previous
    if not isinstance(previous, Verb):
        return None
    before = c.elements[-3:-1]
    finite = bool(w.forms & {"s", "past"})
    if finite and [type(e) for e in before] == [Mention, Mention]:
        return w.noun is None  # "the tray he was carrying crashes"
    clause = bool(before) and isinstance(before[-1], Mention)
    own = clause and previous.form == "ing" and not previous.auxiliary
    if own and "s" in w.forms and (w.noun is None or w.next in lex.DETERMINERS | lex.PRONOUNS):
        return True  # "a car changing lanes knocks it over"
    within = clause and getattr(before[0], "kind", "") == "rel" and finite
    if within and (w.noun is None or w.next in lex.DETERMINERS | lex.PREPOSITIONS):
        return True  # "the trolley whose brakes fail rolls into a pond"
    relative = bool(before) and getattr(before[-1], "kind", "") == "rel" and finite
    if relative and (w.noun is None or w.next in lex.DETERMINERS):
        return True  # "a ball that is rolling hits a box"
    soon = noun_soon(c, w.at + 1)
    modifies = (w.nounish and not soon) or (w.adjectival and soon)
    return bool(w.forms & {"ing", "base"}) and not modifies


def _before_noun(c: Chunks, w: _Word) -> bool | None:
    """ "rolling ball": a modifier, unless a determiner follows."""
    if not w.adjectival or not noun_soon(c, w.at + 1):
        return None
    if isinstance(w.previous, Word) and w.previous.kind in ("rel", "sub"):
        return None
    return ("ing" in w.forms and w.next in lex.DETERMINERS) or _commands(c, w)


def _commands(c: Chunks, w: _Word) -> bool:
    """ "Drop three balls", "then stack 4 blocks": what is to be done with a number of things.

    In "stack 4 falls" the number is a name.
    """
    opens = w.previous is None or (isinstance(w.previous, Word) and w.previous.kind != "prep")
    at = w.at + (2 if w.next in ("up", "down", "out") else 1)
    number = low_at(c, at)
    value = parse_number(number)
    counted = isinstance(value, float) and value > 1.0
    if not (opens and counted and w.low in _COMMANDS and "base" in w.forms):
        return False
    k = next((k for k in range(at + 1, at + 4) if not is_adjective(c, k)), at + 1)
    named = number.isdigit() and any(r.form == "s" for r in verb_readings(low_at(c, k)))
    found = match_noun(c, k)
    return found is not None and found[2] and not named


def _opens_clause(c: Chunks, w: _Word) -> bool | None:
    previous = w.previous
    if isinstance(previous, Word) and not (
        (previous.kind == "punct" and previous.low in ".;!?:\n") or previous.low == "heading"
    ):
        return None
    if not w.nounish or _commands(c, w):
        return True
    by = w.next == "by" and "pp" in w.forms  # "Hit by an apple, he ..."
    by = by or (w.noun is None and "s" in w.forms and _report(c, w.at))
    return by or (w.next in lex.DETERMINERS and "base" in w.forms)


def _goes_on(c: Chunks, w: _Word) -> bool | None:
    """After a comma, a conjunction, an adverb or a relative."""
    previous = w.previous
    assert isinstance(previous, Word)
    told = any(isinstance(e, Verb) for e in c.elements)
    ends = w.next in ("", "and", "then") and previous.kind in ("punct", "conj", "adv")
    if w.nounish and w.forms & {"s", "past"} and ends and told:
        return True  # "..., slides, and hits"
    counted = parse_number(w.next) is not None
    if "s" in w.forms and counted and told and previous.kind in ("conj", "adv"):
        return True  # "knocks down eight pins and leaves two standing"
    if (
        previous.kind == "rel"
        and "s" in w.forms
        and (not verb_readings(w.next) or w.next == "open")
    ):
        return True  # ", which swings round": no plural without an article
    if previous.kind == "adv" and "s" in w.forms and not told:
        return True  # "a door slowly swings open"
    if w.noun is None:
        return True
    inflected = bool(w.forms & {"past", "pp", "ing"})
    if previous.kind in ("conj", "adv", "punct", "rel"):
        return _verb_context(c, w.at) or inflected
    return inflected or c.tokens[w.at].tag == "VERB"


_VERB_TESTS: tuple[Callable[[Chunks, _Word], bool | None], ...] = (
    _modifier_here,
    _noun_first,
    _after_preposition,
    _after_noun,
    _after_verb,
    _before_noun,
    _opens_clause,
    _goes_on,
)
"""What decides whether a word is a verb: the first that knows."""


def looks_like_verb(c: Chunks, j: int, m: Mention) -> bool:
    """An unknown word in -s or -ed after a singular noun, with no verb after it ("derails")."""
    low = low_at(c, j)
    if (
        not low.endswith(("s", "ed"))
        or low.endswith("ss")
        or m.determiner not in ("a", "an", "the", "this", "that", "its")
    ):
        return False
    before, nxt = low_at(c, j - 1), low_at(c, j + 1)
    if m.group_word and lex.singular(before)[0] == before:
        return False  # "a pair of oven mitts"
    return not (verb_readings(nxt) or nxt in lex.MODALS or nxt == "'s")


def unknown_act(c: Chunks, i: int, m: Mention) -> bool:
    """ "A panda drinking coffee": a word in -ing that no table knows, behind its doer."""
    low, nxt = low_at(c, i), token_at(c, i + 1)
    if not low.endswith("ing") or verb_readings(low):
        return False
    if not (m.determiner or m.count is not None or m.plural):
        return False
    goes_on = nxt is not None and (nxt.kind == "punct" or nxt.tag in _AFTER_ACTS)
    return (goes_on or nxt is None) and low.isalpha() and low not in hypernyms()


def unknown_verb(c: Chunks, i: int) -> bool:
    """ "The bag rips, and", ", rounds a shelf": an unknown word in -s in place of a verb."""
    previous, nxt = element_before(c), token_at(c, i + 1)
    if isinstance(previous, Mention) and not previous.attribute and unknown_act(c, i, previous):
        return previous.end == c.tokens[i - 1].end
    if _acted_on(c, i, previous):
        return True
    if not _unknown_in_s(c, i, previous):
        return False
    object_ = nxt is not None and nxt.low in lex.DETERMINERS | lex.PRONOUNS
    way = nxt is not None and nxt.low in lex.PREPOSITIONS | lex.ADVERBS - {"of"}
    if isinstance(previous, Mention):
        ends = nxt is None or nxt.kind in ("punct", "qty") or nxt.low in ("and", "but", "to")
        return (ends or object_ or way) and _subject_without_verb(c, i, previous)
    told = any(isinstance(e, Verb) for e in c.elements)
    listed = isinstance(previous, Word) and (previous.kind == "conj" or previous.low == ",")
    return listed and told and c.tokens[i].tag == "VERB" and (object_ or way)


def _acted_on(c: Chunks, i: int, previous: Element | None) -> bool:
    """ "Store the block in a box", "lifts a bin and empties it": a bare noun has no object.

    Two noun phrases stand side by side only where the first has its own article.
    """
    low, nxt = low_at(c, i), low_at(c, i + 1)
    noun = match_noun(c, i) or (None, 1, low.endswith("s") and not low.endswith("ss"))
    if noun[1] != 1 or verb_readings(low) or not low.isalpha() or low in _SMALL:
        return False
    told = any(isinstance(e, Verb) for e in c.elements)
    joined = isinstance(previous, Word) and previous.kind in ("conj", "adv") and told
    opens = previous is None or (isinstance(previous, Word) and previous.low in ".;!?\n")
    if noun[2]:
        if nxt in _OUT and low_at(c, i + 2) in _ARTICLES:
            nxt = low_at(c, i + 2)  # "and saws off the end"
        listed = isinstance(previous, Word) and previous.low == "," and told and nxt in _OBJECTS
        return bool(listed) or ((joined or _is_one(previous)) and nxt in _ARTICLES | _OBJECTS)
    known = match_noun(c, i) is not None
    return known and (opens or joined) and (nxt in _ARTICLES or (opens and nxt in _OBJECTS))


def _is_one(e: Element | None) -> bool:
    """Whether an element names one thing that may do something."""
    if not isinstance(e, Mention) or e.plural:
        return False
    return bool(e.determiner or e.pronoun in _SUBJECTS)


def _unknown_in_s(c: Chunks, i: int, previous: Element | None) -> bool:
    """Whether a word ends in -s and no table knows it as anything but, at most, a plural."""
    low, noun = low_at(c, i), match_noun(c, i)
    after_one = isinstance(previous, Mention) and previous.determiner in ("a", "an")
    after_one = after_one and noun is not None and noun[2] and noun[1] == 1  # "a cyclist signals,"
    known = (noun is not None and not after_one) or verb_readings(low) or is_adjective(c, i)
    if known or not low.isalpha() or not low.endswith("s") or low.endswith("ss"):
        return False
    closed = lex.PREPOSITIONS | lex.ADVERBS | lex.MODALS | lex.DETERMINERS | lex.PRONOUNS
    measures = lex.PARTS | lex.ATTRIBUTES
    return low not in closed | lex.SUBORDINATORS and not {low, lex.singular(low)[0]} & measures


def _subject_without_verb(c: Chunks, i: int, m: Mention) -> bool:
    """Whether a single thing opens a clause right before a word."""
    before = c.elements[-2] if len(c.elements) > 1 else None
    opens = before is None or getattr(before, "kind", "") in ("punct", "conj", "sub", "adv")
    one = m.determiner in ("a", "an", "the", "this", "that", "its", "one")
    return opens and one and not m.plural and m.end == c.tokens[i - 1].end


def compound_noun(c: Chunks, k: int, m: Mention) -> bool:
    """Whether an ambiguous word continues a compound ("picnic park") and is no verb."""
    nxt = token_at(c, k + 1)
    if nxt is None:
        return c.tokens[k].tag == "NOUN"
    if nxt.low in lex.DETERMINERS or nxt.low in lex.PRONOUNS:
        return False
    readings = verb_readings(low_at(c, k))
    base = all(r.form == "base" for r in readings)
    after = match_noun(c, k + 1)
    if m.determiner and after is not None and after[2] and "pp" in {r.form for r in readings}:
        return True  # "the engine shed doors"
    if base and stands_for_noun(c, k, m):
        return True
    ends = nxt.kind == "punct" or nxt.low in lex.PREPOSITIONS | {"and", "is"}
    thing = match_noun(c, k - 1)
    doer = thing is not None and thing[0].kind in _DOERS  # "a cyclist crossing from the right"
    going = all(r.form == "ing" for r in readings)
    if ends and not doer and going and c.tokens[k].tag == "NOUN":
        return match_noun(c, k) is not None  # "out of a school building toward a bus"
    return c.tokens[k].tag == "NOUN" and bool(verb_readings(nxt.low))


_LETTING = lex.word_set("letting (noun questions)") | lex.word_set("letting (verbs)")


def stands_for_noun(c: Chunks, k: int, m: Mention) -> bool:
    """Whether a bare verb form ends a phrase about one thing ("onto the phone stand.").

    One thing "stands": without the ending, behind a preposition or a verb that lets nobody do
    anything, and with nothing behind it, the word is a noun.
    """
    token, nxt = c.tokens[k], token_at(c, k + 1)
    readings = verb_readings(token.low)
    forms = {r.form for r in readings}
    ends = nxt is None or nxt.kind == "punct" or nxt.low in ("and", "is")
    part = low_at(c, k - 1) in lex.PARTS  # "its roof rack" is the bus's
    if m.plural or part or not m.determiner or forms != {"base"} or not ends:
        return False
    first = next((i for i in range(k - 1, 0, -1) if low_at(c, i) == m.determiner), 0)
    before = low_at(c, first - 1) if first else ""
    verb = c.elements[-1] if c.elements else None
    lets = isinstance(verb, Verb) and verb.lemma in _LETTING
    hits = any(r.sense == "hit" for r in readings)  # "rams the van broadside"
    acted_on = before in lex.PREPOSITIONS or (bool(verb_readings(before)) and not hits)
    return token.tag == "NOUN" and acted_on and not lets


def unknown_noun(c: Chunks, j: int) -> bool:
    token = token_at(c, j)
    if token is None or token.kind != "word" or token.text == "'s":
        return False
    low = token.low
    if (
        low in lex.PREPOSITIONS
        or low in lex.ADVERBS
        or low in lex.MODALS
        or low in lex.PRONOUNS
        or low in lex.DETERMINERS
        or low in lex.SUBORDINATORS
        or low in ("and", "or", "but", "to", "which", "who", "that", "not")
        or verb_readings(low)
    ):
        return False
    if token.tag in ("NOUN", "PROPN"):
        return True
    if token.tag in ("ADJ", "VERB", "X", "INTJ"):
        return not noun_soon(c, j + 1)
    return (token.tag == "" and not low.endswith("ly")) or named_before(c, j)


def named_before(c: Chunks, j: int) -> bool:
    """ "The storm fells the poplar; poplar crushes a shed": a noun by now."""
    word = lex.singular(low_at(c, j))[0]
    return any(isinstance(e, Mention) and e.head == word for e in c.elements)


def _report(c: Chunks, i: int) -> bool:
    """ "Truck, 9 m/s. Brakes at 3 s. Stops 2 s later.": verbs of what was named before."""
    nxt = token_at(c, i + 1)
    if not any(isinstance(e, Mention) for e in c.elements) or nxt is None:
        return False
    if nxt.kind == "word" and match_noun(c, i + 1) and not low_at(c, i + 2).endswith("ing"):
        return True  # "Hits shed door."
    small = lex.PREPOSITIONS - {"of"} | lex.ADVERBS | {"and"}
    return (nxt.kind in ("qty", "punct") and nxt.text != ":") or nxt.low in small


def noun_not_verb(c: Chunks, k: int, m: Mention) -> bool:
    """ "a cereal bowl off the chair": a bare verb does not follow a singular noun phrase."""
    readings = verb_readings(low_at(c, k))
    bare = all(r.form == "base" for r in readings)
    nxt = low_at(c, k + 1)
    one = m.determiner in ("a", "an", "this", "that", "each", "every", "another")
    previous = element_before(c)
    done = isinstance(previous, Verb) and previous.sense not in ("cause", "noop")
    one = one or (done and bool(m.determiner))  # "knocks its food bowl off": it has its verb
    return bare and one and nxt not in lex.DETERMINERS and nxt not in lex.PRONOUNS


def thing_named(c: Chunks, i: int) -> bool:
    """Whether a noun phrase with an article or a pronoun starts here."""
    low = low_at(c, i)
    named = low in lex.DETERMINERS or match_noun(c, i) is not None
    return named or low in ("it", "them", "him", "her", "its", "his", "their")


def verb_soon(c: Chunks, i: int) -> bool:
    return any(verb_readings(low_at(c, k)) for k in range(i, min(i + 6, len(c.tokens))))
