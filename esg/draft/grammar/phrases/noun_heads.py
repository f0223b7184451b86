"""Heads of noun phrases: the noun itself, what belongs to it, and individual letters."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import re
from typing import NamedTuple

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks, NounMatch
from esg.draft.grammar.phrases.letters import letters
from esg.draft.grammar.phrases.noun_questions import (
    PIECES,
    bare_color,
    color_acts,
    does_next,
    ends_as_noun,
    ends_phrase,
    fills,
    heap_of,
    is_attribute_start,
    is_name,
    let_do,
    like_a_verb,
    many_do,
    names_it,
    names_no_thing,
    noun_then_verb,
    numbers,
    one_does,
    packed,
    part_alone,
    people_here,
    piled,
    plain_noun,
    pronoun_here,
    waiting_place,
    weighed,
    wisp,
)
from esg.draft.grammar.phrases.nouns import low_at, match_noun, token_at
from esg.draft.grammar.phrases.reader import (
    compound_noun,
    element_before,
    known_adjective,
    looks_like_verb,
    named_before,
    noun_not_verb,
    noun_soon,
    stands_for_noun,
    unknown_act,
    unknown_noun,
)
from esg.draft.grammar.phrases.rows import inner_phrase, member_of_row, the_rest
from esg.draft.text.elements import ONE_OF_THESE, Mention, Verb, Word
from esg.draft.verbphrases import verb_readings
from esg.lexicon.articulations import articulations
from esg.lexicon.senses import no_things

_RUNNING_GEAR = lex.word_set("running gear")
_SINGULAR = lex.word_set("singular")
_MOSTLY_NOUNS = lex.word_set("mostly nouns")
_WAYS = lex.word_set("ways (noun heads)")
_VESSELS = lex.word_set("vessels (noun heads)")
_THEM = ("it", "him", "her", "them")
_STACKS = ("stack", "pile", "tower", "heap")
_FIGURES = lex.word_set("parts of figures")
_LIMBS = (lex.BODY_PARTS | _FIGURES) - lex.PARTS
_IN_THE_SKY = lex.word_set("hangs in the sky")
_UNDER_THE_SKY = lex.word_set("under the sky")
_GROUPS = lex.word_set("people")
_HANDS = frozenset({"left", "left-hand", "right", "right-hand"})
_DOING = frozenset({"do", "does", "did", "perform", "execute", "attempt"})
_PAVED = lex.word_set("paved (nouns)")
_CAST = lex.word_set("cast (noun heads)")
_PICKING = frozenset({"left", "right", "front", "rear", "middle", "top", "bottom"})
_NOT_ONE = frozenset({"light", "dark", "cold"})
"""Adjectives that are nouns, too: "the light" is no light one."""
_ALWAYS_PEOPLE = frozenset({"crowd", "family", "gang", "squad"})
_BUILT = frozenset({"made", "built", "carved", "constructed", "crafted", "woven", "cast"})
"""Participles before what something consists of."""
_UPON = frozenset({"across", "along", "on", "onto", "over", "upon"})
_NOT_LEVEL = lex.word_set("not level")
_AMID = frozenset({"against", "from", "in", "into", "through", "toward", "towards", "under"})
"""Prepositions of what is around somebody ("glitters in the light")."""
_NO_NOUNS = lex.ADVERBS | lex.PREPOSITIONS | lex.DETERMINERS | lex.SUBORDINATORS


@dataclass(frozen=True)
class Place:
    """Where the head of a phrase is looked for.

    Args:
        first: Token at which the phrase begins.
        at: Token after its modifiers.
        low: The word there, "" at the end of the text.
        noun: The noun of the lexicon there.
    """

    first: int
    at: int
    low: str
    noun: NounMatch | None


class Head(NamedTuple):
    """A head that has been read: the token after it, and whether its phrase is complete."""

    after: int
    complete: bool = False


HeadReader = Callable[[Chunks, Place, Mention], Head | None]
"""Reads one kind of head; `OTHER` where there is none of its kind, None where no phrase is."""
OTHER = Head(-1)


def read_head(c: Chunks, i: int, j: int, m: Mention) -> int | None:
    """Reads the head of a phrase and what belongs to it, and adds the phrase to the elements.

    Args:
        c: The text; the phrase is appended to its elements.
        i: Token at which the phrase begins.
        j: Token after its modifiers.
        m: The phrase so far.

    Returns:
        The token after the phrase, None if there is none.
    """
    place = Place(i, j, low_at(c, j), _noun_here(c, j, m))
    for reader in HEADS:
        head = reader(c, place, m)
        if head is None:
            return None
        if head is not OTHER:
            return head.after if head.complete else _complete(c, place, head.after, m)
    return None


def _noun_here(c: Chunks, j: int, m: Mention) -> NounMatch | None:
    noun = match_noun(c, j) if j < len(c.tokens) else None
    if noun is None:
        return None
    own = m.determiner in lex.POSSESSIVES or low_at(c, j + 1) == "of"
    if noun[3] in ("corner", "entrance", "exit", "rim", "step", "rung") and own:
        return None  # of a room or a table, not of the street; a tunnel has no door
    if noun[3] == "path" and m.determiner and low_at(c, j + 1) == "of":
        return None  # "into the path of a tram": no footpath
    if noun[3] in lex.COLORS and _color_of(c, j + 1):
        return None  # "orange sky"
    if noun[3] in lex.PARTS and low_at(c, j + 1) == "of" and _of_a_vehicle(c, j + 2):
        return None  # "the bed of a truck"
    if _acts_after_stuff(c, j, noun, m):
        return None  # "a stone skips"
    if m.determiner in ("both", "all", "the") and many_do(c, j, m):
        return None  # "and both slide into a bale", "the two stick together"
    return noun


def _acts_after_stuff(c: Chunks, j: int, noun: NounMatch, m: Mention) -> bool:
    """Whether a plural after "a" and a noun of stuff is what that does, and no thing."""
    finite = any(r.form == "s" for r in verb_readings(low_at(c, j)))
    one = m.determiner in _SINGULAR and m.count in (None, 1)
    return one and noun[2] and finite and bool(m.adjectives) and m.adjectives[-1] in lex.nouns()


def _color_of(c: Chunks, j: int) -> bool:
    """Whether a noun stands at token j that the lexicon does not know as a thing."""
    token = token_at(c, j)
    noun = token is not None and token.tag == "NOUN" and match_noun(c, j) is None
    return noun and token is not None and not verb_readings(token.low)


def _of_a_vehicle(c: Chunks, j: int) -> bool:
    """Whether a vehicle is named at token j, after an article and adjectives."""
    for k in range(j, min(j + 4, len(c.tokens))):
        noun = match_noun(c, k)
        if noun is not None:
            return noun[0].kind in ("vehicle", "toyvehicle", "watercraft")
    return False


def _owner(c: Chunks, j: int) -> tuple[Mention, int] | None:
    """The phrase that starts at token j, taken from the elements again, and the token after it."""
    size = len(c.elements)
    after = c.noun_phrase(j)
    if after is None:
        return None
    owner = c.elements.pop()
    assert isinstance(owner, Mention) and len(c.elements) == size
    return owner, after


def _known(c: Chunks, p: Place, m: Mention) -> Head | None:
    """A noun of the lexicon, with the nouns and places that belong to it."""
    if p.noun is None or (m.determiner == "a" and p.noun[2] and one_does(c, p.at, m)):
        return OTHER  # "a third slides past"
    j, plural = _compound(c, p.at, p.noun, m)
    j += piled(c, j, m)
    _measure_or_role(c, j, m)
    j = _made_of(c, j, m)
    j = _stands(c, j, m, plural)
    if (m.role or m.head == "net") and low_at(c, j) == "of":
        found = _owner(c, j + 1)
        if found is not None:
            owner, after = found
            owner.start = m.start
            c.elements.append(owner)
            return Head(after, complete=True)
    return Head(j if plural else _unknown_after(c, j, m))


def _compound(c: Chunks, j: int, noun: NounMatch, m: Mention) -> tuple[int, bool]:
    """The last noun of "steel ball" or "office desk"; the token after it, whether it is plural.

    An adjective that is also a noun ends a compound.
    """
    entry, n, plural, phrase = noun
    first, k = j, j + n
    while True:
        following = match_noun(c, k) if k < len(c.tokens) else None
        if following is None or plural or not _continues(c, k, following, m):
            break
        if heap_of(c, k, entry) or wisp(c, k):
            break  # "a domino chain", "a lighthouse beam"
        if entry.kind == "vehicle" and lex.singular(low_at(c, k))[0] in lex.PARTS:
            break  # "a car roof"
        m.adjectives.extend(" ".join(t.low for t in c.tokens[first:k]).split())
        entry, n, plural, phrase = following
        first, k = k, k + n
    m.noun, m.head, m.plural = entry, phrase, plural or m.plural
    return k, plural


def _continues(c: Chunks, k: int, following: NounMatch, m: Mention) -> bool:
    """Whether the noun at token k continues a compound and is no verb."""
    low = low_at(c, k)
    readings = verb_readings(low)
    if low in lex.ADVERBS or let_do(c, k, readings):
        return False  # "make a ball bowl over a pin"
    acts = low_at(c, k + 1) in lex.DETERMINERS | lex.PRONOUNS
    if following[2] and (m.determiner in _SINGULAR or (readings and acts)):
        return False  # "a door swings shut", "a cyclist signals": no plural after "a"
    if following[2] and _stuff_of(c, k):
        return True  # "on its iron wheels."
    swings = following[2] and any(r.form == "s" for r in readings)
    if swings and low_at(c, k + 1) in _WAYS:
        return False  # "the quad bike swings left"
    named = following[0].kind in _VESSELS or low in _MOSTLY_NOUNS
    vessel = m.determiner and named and ends_phrase(c, k)
    return not (readings and following[1] == 1 and not (vessel or compound_noun(c, k, m)))


def _stuff_of(c: Chunks, k: int) -> bool:
    """Whether the plural at token k is what a noun of stuff before it is told of, after "on"."""
    before, after = c.elements[-1] if c.elements else None, token_at(c, k + 1)
    ends = after is None or after.kind == "punct" or after.low in ("and", "in", "on", "of")
    met = isinstance(before, Word) and before.kind == "prep"
    return met and ends and low_at(c, k - 1) in lex.MATERIALS and c.tokens[k].tag == "NOUN"


_COMPARED = lex.word_set("compared (measures)")


def _measure_or_role(c: Chunks, k: int, m: Mention) -> None:
    """ "a mass of 2 kg" is no object, "the driver" a role."""
    after = token_at(c, k + 1)
    if m.head in ("weight", "mass"):
        told = low_at(c, k) in ("of", "is") and after is not None and after.kind == "qty"
        compared = bool(_COMPARED & {*m.adjectives}) and not m.determiner
        near = c.tokens[k : k + 7]
        stated = low_at(c, k) == "of" and any(t.low == "is" for t in near)
        stated = stated and any(t.kind == "qty" for t in near)  # "the weight of a crate is 5 kg"
        if told or compared or stated or m.determiner in ("its", "their"):
            m.noun, m.attribute = None, True
    crew = m.head in lex.PERSON_ROLES and not m.plural  # two passengers are no vehicle
    if crew or m.head in ("cyclist", "rider"):
        m.role = m.head if m.head in lex.PERSON_ROLES else ""
    if m.head in ("row", "line"):
        m.noun = None


def _made_of(c: Chunks, j: int, m: Mention) -> int:
    """ "a ball of steel", "an armchair on wheels": no objects of their own."""
    substance = low_at(c, j + 1) in lex.SUBSTANCES and match_noun(c, j + 1) is None
    substance = substance or (m.noun is not None and fills(c, j + 1, m.noun))
    if low_at(c, j) == "of" and substance:
        m.adjectives.append(low_at(c, j + 1))
        j += 2
    if low_at(c, j) == "on" and low_at(c, j + 1) in _RUNNING_GEAR:
        m.adjectives.append("wheeled")
        j += 2
    return j


def _on_top(c: Chunks, j: int) -> int:
    """How many tokens say "on top (of the stack)"; 0 for a top of anything else."""
    words = 2 if low_at(c, j + 1) == "top" else 3 if low_at(c, j + 2) == "top" else 0
    if not words or low_at(c, j) not in ("on", "at") or low_at(c, j + 1) not in ("top", "the"):
        return 0
    after = low_at(c, j + words)
    of_all = after != "of" or low_at(c, j + words + 2) in _STACKS
    return words if of_all and after != "speed" else 0


def _stands(c: Chunks, j: int, m: Mention, plural: bool) -> int:
    """ "the car behind", "the one in front of it", "the crate on top of the stack"."""
    if m.noun is not None and "structural" in m.noun.traits:
        return j  # "crosses the road in front of it": there is no other road
    low, the = low_at(c, j), m.determiner == "the"
    new = m.determiner in ("a", "an") and low == "behind"  # "a couch behind him": a place
    new = new or (low == "following" and not the and not m.possessor)  # "two dogs following it"
    if low in ("behind", "following") and low_at(c, j + 1) in _THEM and not new:
        m.adjectives.append("rear")
        j += 2
    elif low == "behind" and the and _ends_or_acts(c, j + 1):
        m.adjectives += ["rear", *_absolute(c, j + 1, m)]
        j += 1
    elif (low, low_at(c, j + 1)) == ("in", "front") and the and _of_it(c, j + 2):
        j += 4 if low_at(c, j + 2) == "of" else 2
        m.adjectives += ["front", *_absolute(c, j, m)]
    if the and not plural and (on_top := _on_top(c, j)):
        m.adjectives.append("top")
        j += on_top
    level = set(m.adjectives) & lex.STACKED.keys() and low_at(c, j) == "of"
    stack = low_at(c, j + 1) in ("the", "a", "this", "that") and low_at(c, j + 2) in _STACKS
    if level and stack and low_at(c, j + 3) != "of":
        m.stacked = True
        j += 3
    return j


def _absolute(c: Chunks, j: int, m: Mention) -> list[str]:
    """ "A van and a bus drive along, the van in front.": no other van."""
    token = token_at(c, j)
    ends = token is None or token.low in (".", ";", "!")
    opens = re.search(r",\s*(?:(?:and|with)\s+)?$", c.text[: m.start], re.IGNORECASE)
    return [ONE_OF_THESE] if ends and opens else []


def _of_it(c: Chunks, j: int) -> bool:
    return low_at(c, j) != "of" or low_at(c, j + 1) in _THEM


def _ends_or_acts(c: Chunks, j: int) -> bool:
    token = token_at(c, j)
    return token is None or token.kind == "punct" or bool(verb_readings(token.low))


def _unknown_after(c: Chunks, j: int, m: Mention) -> int:
    """Unknown nouns after a known one that only says what they are: "car horn"."""
    token = token_at(c, j)
    if token is None or token.kind != "word" or token.tag not in ("NOUN", "PROPN"):
        return j
    acts = looks_like_verb(c, j, m) and not stands_for_noun(c, j, m)
    acts = acts or unknown_act(c, j, m)
    if len(token.text) < 2 or acts or numbers(c, j):
        return j
    if token.low in _NO_NOUNS or (verb_readings(token.low) and not stands_for_noun(c, j, m)):
        return j
    single, several = lex.singular(token.low)
    nothing = (names_no_thing(token.low) and not _weighs(c, j, j, m)) or wisp(c, j)
    pack = packed(c, single, m)
    if single in PIECES:
        return j + 1  # "the pizza slice"
    people = single in _GROUPS and bool(m.determiner) and low_at(c, j + 1) != "of"
    if (single in lex.ATTRIBUTES or nothing) and pack is None and not people:
        m.attribute, m.head, m.noun = True, single, None
    elif people:
        m.noun, m.head, m.plural, m.group_word = lex.nouns()["person"], "person", True, single
        m.pattern = lex.GROUP_WORDS.get(single) or "scatter"  # "the football team"
    elif single in lex.PARTS:
        m.part = single
    elif single not in ("other", "one"):
        m.adjectives.append(m.head)
        m.head, m.noun, m.plural, m.known = single, pack, several, pack is not None
    else:
        return j
    return j + 1


def _people(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "A couple", "the crowd", "rival gangs": persons, as many as the word means."""
    word, several = lex.singular(p.low)
    if not people_here(c, p.at):
        return OTHER
    told = m.determiner not in ("", "the") or m.count is not None
    those = m.determiner == "the" and word in lex.GROUP_WORDS and word not in _ALWAYS_PEOPLE
    verb = several and m.determiner in ("a", "an")  # "an engine couples onto five wagons"
    caption = not several and not c.elements  # "Happy family with two kids"
    named = told or m.determiner or ((several or caption) and m.adjectives)
    if m.group_word or those or verb or not named:
        return OTHER
    m.noun, m.head, m.plural, m.group_word = lex.nouns()["person"], "person", True, word
    m.pattern = lex.GROUP_WORDS.get(word) or "scatter"
    m.count = (m.count or 1) * lex.VAGUE_COUNTS[word] if word in lex.VAGUE_COUNTS else None
    return Head(p.at + 1)


def _rest(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "the rest"."""
    if p.low != "rest" or m.determiner != "the" or m.adjectives:
        return OTHER
    return Head(the_rest(c, p.at, m))


def _wisp(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "a puff of smoke": no thing."""
    words = wisp(c, p.at)
    if not words:
        return OTHER
    m.head, m.attribute = p.low, True
    return Head(p.at + words)


def _far_off(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "Under a pale moon", "stars twinkling above": light in the sky, and no body."""
    single, several = lex.singular(p.low)
    before = element_before(c)
    under = isinstance(before, Word) and before.low in _UNDER_THE_SKY
    stars = several and single == "star" and not m.determiner and m.count is None
    if single not in _IN_THE_SKY or not (under or stars) or match_noun(c, p.at + 1) is not None:
        return OTHER
    m.attribute, m.head, m.plural = True, single, several
    return Head(p.at + 1)


def _piece(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "a roll of tape": the thing itself."""
    if p.low not in PIECES or low_at(c, p.at + 1) != "of":
        return OTHER
    of = low_at(c, p.at + 2)
    if of in lex.MATERIALS and match_noun(c, p.at + 2) is None and not noun_soon(c, p.at + 3):
        m.adjectives.append(of)  # "a lump of clay falls"
        m.head, m.known = p.low, False
        return Head(p.at + 3)
    inner = inner_phrase(c, p.at + 2, m)
    return Head(inner, complete=True) if inner else OTHER


def _body_part(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "his arm"."""
    if m.determiner == "the" and p.low in _LIMBS:
        whose = low_at(c, p.at + 1) == "of" and low_at(c, p.at + 2) in lex.DETERMINERS
        if whose and not m.adjectives:  # "the tail of the dog"
            m.head = lex.singular(p.low)[0]
            return Head(p.at + 1)
    if p.low not in lex.BODY_PARTS or not (
        low_at(c, p.first - 1) == "'s" or m.determiner in lex.POSSESSIVES
    ):
        return OTHER
    m.head, m.attribute = p.low, False
    return Head(p.at + 1)


def _weight_of(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "Bends under the weight of a truck": under the truck."""
    before = element_before(c)
    under = isinstance(before, Word) and before.low in ("under", "beneath")
    if p.low not in ("weight", "load") or not under or low_at(c, p.at + 1) != "of":
        return OTHER
    if m.determiner != "the" or getattr(token_at(c, p.at + 2), "kind", "") == "qty":
        return OTHER
    found = _owner(c, p.at + 2)
    if found is None:
        return OTHER
    owner, after = found
    owner.start = m.start
    c.elements.append(owner)
    return Head(after, complete=True)


def _part(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "the edge of a table": the table, and which part of it."""
    low, j = p.low, p.at
    part = lex.singular(low)[0]
    told = m.determiner or m.adjectives or m.count == 1 or low_at(c, j + 1) == "of"
    known = lex.PARTS_OF if low_at(c, j + 1) == "of" else lex.PARTS
    if not low or not {low, part} & known or not told or part_alone(c, j, m):
        return OTHER
    sided = low in _HANDS and {low_at(c, j + 1)} & lex.PARTS  # "the left side of a car"
    if sided or (match_noun(c, j + 1) is not None and not verb_readings(low_at(c, j + 1))):
        return _modifies(c, p, m)  # "the head pin"
    m.part = m.head = part
    m.attribute = True
    j += 1
    if m.part in ("edge", "side") and low_at(c, j) in ("length", "lengths"):
        m.part, m.head = "", "size"  # "with an edge length of 10 cm"
        j += 1
    found = _owner(c, j + 1) if low_at(c, j) == "of" else None
    if found is None:
        return Head(j)
    owner, after = found
    if part in _PICKING and (owner.count or 1) > 1 and not owner.determiner:
        owner.pick, owner.start = part, m.start  # "the left of two lamps"
        c.elements.append(owner)
        return Head(after, complete=True)
    before = element_before(c)
    on = isinstance(before, Word) and before.low in _UPON
    if part != "surface" or not on:  # "rolls on the surface of a table": on it
        owner.part = f"{' '.join(m.adjectives)} {m.part}" if m.adjectives else m.part
    owner.start = m.start
    c.elements.append(owner)
    return Head(after, complete=True)


def _modifies(c: Chunks, p: Place, m: Mention) -> Head | None:
    """The word is a modifier of the head that follows it."""
    m.adjectives.append(p.low)
    after = read_head(c, p.first, p.at + 1, m)
    return None if after is None else Head(after, complete=True)


def _bus_stop(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "waits at the stop"."""
    if p.low != "stop" or not waiting_place(c, p.first, p.at, m):
        return OTHER
    m.noun, m.head = lex.nouns()["bus stop"], "stop"
    return Head(p.at + 1)


def _doer(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "a steel hook is hit": a verb's form, but what does something."""
    if not p.low or not does_next(c, p.at, m):
        return OTHER
    m.head, m.known = p.low, False
    return Head(p.at + 1)


def _attribute(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "a mass of 2 kg", "the collision": no object."""
    low, j = p.low, p.at
    single = lex.singular(low)[0]
    if not low or not {low, single} & lex.ATTRIBUTES:
        return OTHER
    if many_do(c, j, m) or color_acts(c, j, m) or one_does(c, j, m):
        return OTHER
    if not (m.determiner or m.adjectives or m.count is not None or is_attribute_start(c, j)):
        return OTHER
    acts = verb_readings(low_at(c, j + 1)) and not noun_not_verb(c, j + 1, m)
    named = match_noun(c, j + 1) is not None and not acts
    if names_it(m, low) and (named or plain_noun(c, j + 1)):
        return _modifies(c, p, m)  # "the space station", "a weather vane"
    m.attribute, m.head = True, low if low in lex.ATTRIBUTES else single
    j += 1
    if low_at(c, j) in ("speed", "velocity", "distance", "height"):
        m.head = low_at(c, j)
        j += 1
    return Head(j)


def _floor(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "Bounces on a hard surface": one of nothing that is named, and level, is the floor."""
    if p.low != "surface" or m.determiner not in ("a", "an") or m.count:
        return OTHER
    before = element_before(c)
    on = isinstance(before, Word) and before.low in _UPON and low_at(c, p.at + 1) != "of"
    words = {*m.adjectives} - {*lex.MATERIALS}
    if not on or words & _NOT_LEVEL or any(w in lex.nouns() for w in words):
        return OTHER
    m.noun, m.head = lex.nouns()["floor"], p.low
    return Head(p.at + 1)


def _pronoun(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "it", "the other one"."""
    if p.low not in lex.PRONOUNS or m.adjectives:
        return OTHER
    if p.low in ("that", "this", "one", "both") and not pronoun_here(c, p.at):
        return OTHER
    if m.determiner and p.low not in ("one", "other"):
        return None
    m.pronoun = p.low
    return Head(p.at + 1)


def _determiner_alone(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "another", "both": determiners in place of a noun."""
    if p.at != p.first + 1 or (m.determiner == "another" and unknown_noun(c, p.at)):
        return OTHER
    if m.determiner in lex.PRONOUNS and not m.adjectives and m.count is None:
        if p.low in _CAST and m.determiner in lex.POSSESSIVES:
            m.head, m.attribute = p.low, True  # "its shadow"
            return Head(p.at + 1)
        m.pronoun = m.determiner
        return None if m.determiner in {*lex.POSSESSIVES, "my", "our", "your"} else Head(p.at)
    if m.determiner in ("both", "each", "all", "some", "many", "several", "another"):
        m.pronoun = m.determiner
        return Head(p.at)
    return OTHER


def _one(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "the red one", "two others"."""
    if p.low not in ("one", "ones", "other", "others"):
        return OTHER
    if not (m.determiner or m.adjectives or (m.count is not None and p.low == "others")):
        return OTHER
    m.pronoun = "ones" if p.low in ("ones", "others") else "one"
    if p.low.startswith("other"):
        m.adjectives.append("other")
    j = p.at + 1
    picked = [a for a in m.adjectives if a in lex.COLORS]
    if p.low == "one" and picked and low_at(c, j) == "of":
        size = len(c.elements)
        inner = c.noun_phrase(j + 1)
        owner = c.elements[-1] if len(c.elements) == size + 1 else None
        if inner is not None and isinstance(owner, Mention) and (owner.count or 1) > 1:
            owner.pick, owner.start = picked[-1], m.start  # "the blue one of three balls"
            return Head(inner, complete=True)
        del c.elements[size:]
    return Head(j)


def _lies_on(c: Chunks) -> bool:
    before = c.elements[-1] if c.elements else None
    return isinstance(before, Word) and before.low in ("on", "onto", "across", "along", "over")


def _is_a_noun(c: Chunks, p: Place, m: Mention, word: str) -> bool:
    """Whether what stands as the last adjective is none: unknown, or a material ("a cloth")."""
    if word.startswith("@"):
        return False
    cloth = m.determiner in ("a", "an") and word in lex.MATERIALS and not no_things().get(word)
    return (cloth and c.tokens[p.at - 1].tag == "NOUN") or not known_adjective(word)


def _adjective_alone(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "the other", "the second", "the black", "the last two", "the first of two barrels"."""
    if not m.adjectives or not (m.determiner or bare_color(c, p.first, p.at, m)):
        return OTHER
    if p.at < len(c.tokens) and unknown_noun(c, p.at):
        return OTHER
    if p.at < len(c.tokens) and ends_as_noun(c, p.at, m):
        m.attribute, m.head = True, p.low
        return Head(p.at + 1)
    last = m.adjectives[-1]
    if _bare_form(c, p.at, m):
        m.attribute = names_no_thing(p.low)
        m.head, m.known = p.low, m.attribute
        return Head(p.at + 1)
    if _is_a_noun(c, p, m, last):
        m.adjectives.pop()  # the tagger took an unknown noun for an adjective
        m.head, m.plural = lex.singular(last)
        m.known = False
        return Head(p.at)
    before = c.elements[-1] if c.elements else None
    acted_on = isinstance(before, Verb) or (isinstance(before, Word) and before.low in _AMID)
    acted_on = acted_on and m.determiner == "the"
    if last in _NOT_ONE and acted_on and len(m.adjectives) == 1:
        m.attribute, m.head = True, last  # "turns off the light": no light one
        m.adjectives.clear()
        return Head(p.at)
    if last in _PAVED and _lies_on(c) and len(m.adjectives) == 1:
        m.head, m.noun = last, lex.nouns()["ground"]  # "cracks on the concrete"
        m.adjectives.clear()
        return Head(p.at)
    m.pronoun = "ones" if m.count and m.count > 1 else "one"
    found = _owner(c, p.at + 1) if low_at(c, p.at) == "of" and m.pronoun == "one" else None
    if found is None:
        return Head(p.at)
    owner, after = found
    owner.pick, owner.start = last, m.start
    c.elements.append(owner)
    return Head(after, complete=True)


def _bare_form(c: Chunks, j: int, m: Mention) -> bool:
    """ "Around a vertical loop": after "a" and an adjective no bare verb follows."""
    if m.determiner not in ("a", "an") or j >= len(c.tokens) or c.tokens[j].tag != "NOUN":
        return False
    forms = {r.form for r in verb_readings(low_at(c, j))}
    return forms == {"base"} and low_at(c, j + 1) not in lex.DETERMINERS


def _unknown(c: Chunks, p: Place, m: Mention) -> Head | None:
    """A noun that the lexicon does not know, possibly a compound."""
    tokens, j = c.tokens, p.at
    if not p.low or not unknown_noun(c, j):
        return OTHER
    introduced = m.determiner or m.adjectives or m.count is not None or m.pattern
    if not introduced and tokens[j].tag not in ("NOUN", "PROPN") and not named_before(c, j):
        return OTHER
    k = j
    while _unknown_goes_on(c, k, m) or noun_then_verb(c, k + 1, m):
        m.adjectives.append(low_at(c, k))
        k += 1
    known = match_noun(c, k + 1) if k + 1 < len(tokens) else None
    known = None if known is not None and unknown_act(c, k + 1, m) else known
    ends = bool(m.determiner) and ends_phrase(c, k + 1)  # "on the lab floor."
    last, after = token_at(c, k + 1), token_at(c, k + 2)
    closes = after is None or after.kind == "punct"
    ends = ends or (closes and last is not None and (last.tag, last.low[-3:]) == ("NOUN", "ing"))
    clear = ends or not verb_readings(low_at(c, k + 1)) or noun_not_verb(c, k + 1, m)
    if known is not None and clear and tokens[k].text != "'s":
        return _modifies(c, Place(p.first, k, low_at(c, k), None), m)
    m.head, m.plural = lex.singular(low_at(c, k))
    if k == j and is_name(c, j, m):
        m.head, m.plural, m.noun = low_at(c, k), False, lex.nouns()["person"]
    m.attribute = _no_thing(c, Place(p.first, k, low_at(c, k), None), m, alone=k == j)
    m.known = m.attribute or m.noun is not None
    return Head(k + 1)


def _no_thing(c: Chunks, last: Place, m: Mention, alone: bool) -> bool:
    """Whether an unknown noun that ends at a place names no thing ("Night has fallen.")."""
    k = last.at
    titled = alone and k + 1 < len(c.tokens) and c.tokens[k + 1].text == ":"
    titled = titled and m.head in lex.ATTRIBUTES
    bare = not m.determiner and m.count is None
    nothing = m.head in lex.ATTRIBUTES or names_no_thing(last.low, bare=bare) or _done(c)
    m.noun = m.noun or packed(c, m.head, m)
    return nothing and m.noun is None and not _weighs(c, last.first, k, m) and not titled


def _done(c: Chunks) -> bool:
    """ "Does a backflip", "performs a cartwheel": an act that is done is no thing."""
    verb = c.elements[-1] if c.elements else None
    return isinstance(verb, Verb) and bool({verb.lemma, verb.auxiliary} & _DOING)


def _weighs(c: Chunks, first: int, last: int, m: Mention) -> bool:
    """Whether a mass is stated of what a phrase names."""
    return any(a.dimension == "mass" for a in m.amounts) or weighed(c, first, last)


def _unknown_goes_on(c: Chunks, k: int, m: Mention) -> bool:
    """Whether one more unknown noun follows the one at token k."""
    if looks_like_verb(c, k + 1, m) or unknown_act(c, k + 1, m):
        return False  # "a metronome ticks", "a panda eating"
    if k + 1 >= len(c.tokens) or match_noun(c, k + 1) is not None or not unknown_noun(c, k + 1):
        return False
    return c.tokens[k + 1].tag in ("NOUN", "PROPN", "") and c.tokens[k].tag != ""


def _count_alone(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "the two", "three"."""
    if not m.count or p.at <= p.first:
        return OTHER
    if m.determiner not in ("the", "this", "that") and p.at != p.first + 1:
        return None
    if m.count > 1 and {r.form for r in verb_readings(p.low)} == {"s"} and not m.determiner:
        found = _owner(c, p.at + 2) if low_at(c, p.at + 1) == "of" else None
        if found is not None:  # "two slices of bread": no two that slice
            owner, after = found
            owner.start, owner.count, owner.plural = m.start, m.count, True
            c.elements.append(owner)
            return Head(after, complete=True)
        m.head, m.plural = lex.singular(p.low)
        m.known, m.attribute = False, names_no_thing(m.head)
        return Head(p.at + 1)
    m.pronoun = "ones" if m.count > 1 else "one"
    return Head(p.at)


def _verb_form(c: Chunks, p: Place, m: Mention) -> Head | None:
    """ "lands on a shield": a noun that the lexicon only knows as a verb."""
    if not like_a_verb(c, p.at, m):
        return OTHER
    m.head, m.known = p.low, False
    return Head(p.at + 1)


HEADS: tuple[HeadReader, ...] = (
    _body_part,
    _people,
    _wisp,
    _far_off,
    _weight_of,
    _known,
    _rest,
    _piece,
    _floor,
    _part,
    _bus_stop,
    _doer,
    _attribute,
    _pronoun,
    _determiner_alone,
    _one,
    _adjective_alone,
    _unknown,
    _count_alone,
    _verb_form,
)
"""Kinds of heads; the first that is there is taken."""


def _part_of_whole(c: Chunks, j: int, m: Mention) -> int | None:
    """ "On the seat of a chair": the chair; the token after it, None if no whole is named."""
    before = c.elements[-1] if c.elements else None
    met = isinstance(before, Verb) or (isinstance(before, Word) and before.kind in ("prep", "to"))
    limb = m.head in lex.BODY_PARTS or m.head in _FIGURES
    if low_at(c, j) != "of" or not (limb or lex.is_part(m.head)):
        return None
    found = _owner(c, j + 1)
    if found is None:
        return None
    owner, after = found
    solid = not (owner.attribute or owner.pronoun) and getattr(owner.noun, "kind", "") != "ground"
    own = limb and m.determiner == "the" and solid
    if not owner.determiner or (owner.noun is None and not own):
        return None
    if not (own or (owner.noun is not None and lex.is_part(m.head, owner.noun))):
        return None
    row = articulations().get(owner.head)
    if limb and row is not None and not row.tips:
        return None  # "the arm of a catapult"
    if not (met or own) and (
        row is None or not row.tips
    ):  # "The pans of a balance": ends of its beam
        return None
    owner.part, owner.start = m.head, m.start
    c.elements.append(owner)
    return after


def _made_out_of(c: Chunks, j: int, m: Mention) -> int:
    """ "A vase made of glass stands there": of what it is made, and then its verb."""
    if low_at(c, j) not in _BUILT or m.attribute or m.pronoun or not m.head:
        return j
    k = j + 2 if low_at(c, j + 1) == "out" else j + 1
    if low_at(c, k) not in ("of", "from") or low_at(c, k + 1) not in lex.MATERIALS:
        return j
    after = token_at(c, k + 2)
    goes_on = after is not None and after.kind == "word" and after.tag != "VERB"
    small = lex.PREPOSITIONS | lex.ADVERBS | lex.SUBORDINATORS | {"and", "but", "is", "are"}
    finite = any(r.form in ("s", "past") for r in verb_readings(low_at(c, k + 2)))
    acts = finite and low_at(c, k + 3) in small | lex.DETERMINERS
    if goes_on and after is not None and after.low not in small and not acts:
        return j  # "made of glass blocks"
    m.adjectives.append(low_at(c, k + 1))
    return k + 2


def _on_horseback(c: Chunks, j: int, m: Mention) -> int:
    """ "A cowboy on horseback": a rider on a horse."""
    told = (low_at(c, j), low_at(c, j + 1)) == ("on", "horseback")
    if not told or m.noun is None or m.noun.kind != "person":
        return j
    m.noun = lex.nouns()["horse rider"]
    return j + 2


def _complete(c: Chunks, p: Place, j: int, m: Mention) -> int | None:
    """Adds the phrase with the names and owners that follow its head."""
    tokens = c.tokens
    j = _on_horseback(c, _made_out_of(c, j, m), m)
    if (whole := _part_of_whole(c, j, m)) is not None:
        return whole
    j = member_of_row(c, j, m) or letters(c, j, m)
    if set(m.adjectives) & lex.ORDINALS.keys() and low_at(c, j + 1) in ("the", "top", "bottom"):
        k = j + 2 if low_at(c, j + 1) == "the" else j + 1
        if low_at(c, j) == "from" and low_at(c, k) in lex.COUNTED_FROM:
            m.counted_from, j = low_at(c, k), k + 1  # "the second crate from the left"
    m.end = tokens[j - 1].end
    first_word = p.first + (1 if m.determiner and low_at(c, p.first) == m.determiner else 0)
    start = tokens[min(first_word, j - 1)].start
    if (p.noun is not None and m.pattern is not None) or m.vague:
        start = tokens[p.at].start if p.at < len(tokens) else tokens[p.first].end
    m.text = c.text[start : m.end]
    after = token_at(c, j)
    plural_owner = after is not None and after.text in ("'", "’") and m.plural
    found = _owner(c, j + 1) if low_at(c, j) == "'s" or plural_owner else None
    if found is None:
        c.elements.append(m)
        return j
    owned, end = found  # "ball A's speed"
    owned.possessor, owned.start = m, m.start
    owned.determiner = owned.determiner or "the"
    if m.single and not m.plural and owned.plural:  # "one of the cart's wheels"
        owned.single, owned.count, m.single, m.count = True, 1, False, None
    c.elements.append(owned)
    return end
