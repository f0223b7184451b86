"""Questions about the words of a noun phrase: is it a name, a measure, a colour for a ball?"""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.nouns import low_at, match_noun, pair_acts, token_at
from esg.draft.grammar.phrases.reader import element_before, noun_soon, verb_ahead
from esg.draft.text.elements import Mention, Verb, Word
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings
from esg.lexicon.senses import no_things

_NUMERALS = lex.word_set("numerals")
_ALSO_THINGS = lex.word_set("also things")
_TERRAIN = lex.word_set("terrain")
_MEETING = lex.word_set("meeting (noun questions)")
_ARTICLES = lex.word_set("articles")
_TOOLS = frozenset({"saw", "shot"})
"""Things whose names are also the past of a verb."""
PIECES = lex.word_set("pieces")
_VESSELS = lex.word_set("vessels (noun heads)")
_IS = lex.word_set("is")
_LETTING = lex.word_set("letting (noun questions)")
_MEASURES = lex.word_set("measures (noun questions)")
_STACKS = frozenset({"stack", "pile", "heap"})
_WISPS, _WISPS_OF = lex.word_set("wisps"), lex.word_set("wisps of")
_SHINING = lex.word_set("shining")
_PEOPLE = lex.word_set("people")
_FLUIDS, _TAKING = lex.word_set("unseen fluids"), lex.word_set("taking")
_HEAPED, _LINED_UP = lex.word_set("heaped"), lex.word_set("lined up")
_LINKS = lex.word_set("links")


def numbers(c: Chunks, j: int) -> bool:
    """ "car number one", "ball number 3": a name follows."""
    token = token_at(c, j + 1)
    numeral = token is not None and (token.kind == "number" or token.low in _NUMERALS)
    return low_at(c, j) == "number" and numeral


def noun_then_verb(c: Chunks, k: int, m: Mention) -> bool:
    """ "an airport shuttle waits": no bare verb follows "a" where a finite one does."""
    if m.determiner not in ("a", "an") or match_noun(c, k) is not None:
        return False
    readings, after = verb_readings(low_at(c, k)), verb_readings(low_at(c, k + 1))
    bare = bool(readings) and all(r.form == "base" for r in readings)
    return bare and any(r.form == "s" for r in after) and match_noun(c, k + 1) is None


def part_alone(c: Chunks, j: int, m: Mention) -> bool:
    """ "hits a bumper", "The lid slides off": what nothing before it has is no part."""
    owned = low_at(c, j + 1) == "of" or match_noun(c, j + 1) is not None
    pinball = low_at(c, j) == "bumper" and "pinball" in c.text.lower()
    first = m.determiner == "the" and not any(isinstance(e, Mention) for e in c.elements)
    several = m.count is not None and m.count > 1  # "two red tops"
    own = m.determiner in ("a", "an") or first or several
    own = own and lex.singular(low_at(c, j))[0] in _ALSO_THINGS
    return (own or pinball) and not owned


def names_it(m: Mention, low: str) -> bool:
    """Whether an abstract noun before another one says what that is ("space station")."""
    return bool(m.determiner) and m.determiner not in lex.PRONOUNS and low not in lex.GROUP_WORDS


def heap_of(c: Chunks, k: int, noun: lex.Noun | None) -> bool:
    """Whether the word at token k makes several things of the noun before it."""
    word = low_at(c, k)
    lined_up = noun is not None and noun.kind in _LINED_UP
    return word in _STACKS or (word in _HEAPED and lined_up)


def piled(c: Chunks, k: int, m: Mention) -> int:
    """ "the tyre stack", "a domino chain": several things; the words that say so."""
    word = low_at(c, k)
    if not heap_of(c, k, m.noun) or not m.determiner or m.group_word or m.plural:
        return 0
    nxt = token_at(c, k + 1)
    small = lex.PREPOSITIONS - {"of", "up", "on", "onto"} | {"and", "but", "or", "is", "which"}
    ends = nxt is None or nxt.kind in ("punct", "qty", "number") or nxt.low in small
    if not (ends or _finite(c, k + 1)):
        return 0
    m.pattern, m.group_word, m.plural, m.count = lex.GROUP_WORDS[word], word, True, None
    return 1


def _finite(c: Chunks, k: int) -> bool:
    """Whether a verb in -s or of the past stands here."""
    return any(r.form in ("s", "past") for r in verb_readings(low_at(c, k)))


def plain_noun(c: Chunks, j: int) -> bool:
    """Whether the tagger's noun stands here, which nothing else could be."""
    token = token_at(c, j)
    tagged = token is not None and token.tag in ("NOUN", "PROPN") and token.low.isalpha()
    if not tagged or token is None or token.low.endswith("s"):
        return False
    closed = lex.PREPOSITIONS | lex.ADVERBS | lex.DETERMINERS | lex.PRONOUNS | lex.ATTRIBUTES
    return token.low not in closed and not verb_readings(token.low)


def like_a_verb(c: Chunks, j: int, m: Mention) -> bool:
    """ "lands on a shield", "hits a slipper.": after an article and where things are met."""
    low, nxt, before = low_at(c, j), token_at(c, j + 1), element_before(c)
    readings = verb_readings(low)
    if m.determiner not in _ARTICLES or not readings or low in _TERRAIN | lex.ATTRIBUTES:
        return False
    if any(r.form != "base" for r in readings):
        return False
    met = isinstance(before, Verb) and before.sense in ("hit", "land", "miss", "overtake")
    met = met or (isinstance(before, Word) and before.low in _MEETING)
    if m.determiner == "the" and isinstance(before, Word) and before.low == "off":
        return False  # "off the tee"
    ends = nxt is None or nxt.kind == "punct" or nxt.low in lex.PREPOSITIONS | {"and", "but"}
    return met and ends and nxt is not None and nxt.low != "of"


def does_next(c: Chunks, j: int, m: Mention) -> bool:
    """ "The saw falls", "a steel hook is hit": who does what the verb behind it says."""
    nxt, forms = low_at(c, j + 1), {r.form for r in verb_readings(low_at(c, j))}
    if (forms != {"base"} and low_at(c, j) not in _TOOLS) or m.determiner not in _ARTICLES:
        return False
    if low_at(c, j) in _TERRAIN | lex.ATTRIBUTES:
        return False
    if m.adjectives and m.adjectives[-1] in lex.ALONE | lex.PLACE_ADJECTIVES:
        return False
    finite = any(r.form == "s" for r in verb_readings(nxt)) and match_noun(c, j + 1) is None
    return finite or nxt in _IS


def one_does(c: Chunks, j: int, m: Mention) -> bool:
    """ "One rolls away and another hits a box": a verb, as no plural follows "another"."""
    single = m.determiner in ("another", "each", "either", "neither") and not m.adjectives
    ordinal = m.determiner == "the" and m.adjectives[-1:] and m.adjectives[-1] in lex.ALONE
    single = single or (m.determiner == "the" and m.adjectives == ["other"])
    numbered = m.determiner == "a" and len(m.adjectives) == 1 and m.adjectives[0] in lex.ORDINALS
    single = single or (numbered and lex.singular(low_at(c, j))[0] != low_at(c, j))
    forms = {r.form for r in verb_readings(low_at(c, j))}
    object_ = low_at(c, j + 1) in lex.DETERMINERS | lex.PRONOUNS | {"nothing", "neither"}
    if "past" in forms and object_ and (single or ordinal):
        return True  # "the second hit it"
    return bool(single or (ordinal and match_noun(c, j) is None)) and "s" in forms


def is_she(c: Chunks, i: int) -> bool:
    """ "hits her on the leg", "runs into her": no noun follows that could be hers."""
    nxt = token_at(c, i + 1)
    if low_at(c, i) != "her":
        return False
    closed = lex.PREPOSITIONS | lex.SUBORDINATORS | {"and", "but", "or", "then", "who", "which"}
    if nxt is None or nxt.kind in ("punct", "qty") or nxt.low in closed:
        return True
    return nxt.low in lex.ADVERBS and not noun_soon(c, i + 1)


def waiting_place(c: Chunks, i: int, j: int, m: Mention) -> bool:
    """ "waits at the stop", "passes a stop": where buses stop, not that something does."""
    passes = low_at(c, i - 1) in ("passes", "passing", "past", "near", "behind", "opposite")
    at = low_at(c, i - 1) in ("at", "from") and m.determiner == "the"
    return bool(m.determiner) and (passes or at) and low_at(c, j + 1) != "of"


def many_do(c: Chunks, j: int, m: Mention) -> bool:
    """ "both fall", "the other two swerve": after "both" or a number comes a plural, or a verb."""
    low = low_at(c, j)
    many = m.determiner in ("both", "all", "some", "many", "several") and not m.adjectives
    counted = not m.vague and (m.count or 1) > 1 and _others_only(m) and _clause_goes_on(c, j + 1)
    return (many or counted) and lex.singular(low)[0] == low and bool(verb_readings(low))


def _others_only(m: Mention) -> bool:
    """Whether nothing but "other", "first", "last" is said of those counted."""
    return m.determiner == "the" and {*m.adjectives} <= {"other", "first", "last", "next"}


def _clause_goes_on(c: Chunks, k: int) -> bool:
    """Whether token k may follow a verb without an object."""
    nxt = token_at(c, k)
    small = lex.PREPOSITIONS | lex.ADVERBS | {"and", "but", "while", "as", "together"}
    return nxt is None or nxt.kind == "punct" or nxt.low in small


def ends_phrase(c: Chunks, k: int) -> bool:
    """Whether a base form ends its noun phrase ("a cat bowl.") and is no verb."""
    if any(r.form != "base" for r in verb_readings(low_at(c, k))):
        return False
    nxt = token_at(c, k + 1)
    return nxt is None or nxt.kind == "punct" or nxt.low in lex.PREPOSITIONS | {"and", "is"}


def let_do(c: Chunks, k: int, readings: tuple[lex.VerbForm, ...]) -> bool:
    """Whether a bare verb follows what "make", "let", "have" or "watch" acts on."""
    verb = c.elements[-1] if c.elements else None
    lets = isinstance(verb, Verb) and verb.lemma in _LETTING and not verb.auxiliary
    base = any(r.form == "base" and r.sense != "noop" for r in readings)
    nxt = low_at(c, k + 1)
    follows = nxt in lex.PREPOSITIONS | lex.DETERMINERS | lex.PRONOUNS | lex.ADVERBS
    return bool(lets and base and follows)


def color_acts(c: Chunks, j: int, m: Mention) -> bool:
    """ "The white hits the pink": a ball and its verb, no white hit."""
    if not m.adjectives or m.adjectives[-1] not in lex.COLORS or m.determiner in ("a", "an"):
        return False
    acts = any(r.form == "s" and r.sense != "noop" for r in verb_readings(low_at(c, j)))
    nxt = token_at(c, j + 1)
    small = lex.DETERMINERS | lex.PREPOSITIONS | lex.ADVERBS | lex.COLORS.keys() | {"and"}
    return acts and (nxt is None or nxt.kind != "word" or nxt.low in small)


def bare_color(c: Chunks, i: int, j: int, m: Mention) -> bool:
    """ "white into pink", "red knocks blue off": a colour that names a ball."""
    if j != i + 1 or m.adjectives[0] not in lex.COLORS:
        return False
    before, nxt = c.elements[-1] if c.elements else None, token_at(c, j)
    if isinstance(before, Verb):
        placed = before.sense in ("hit", "knock", "miss", "pocket", "scatter", "topple")
    else:
        placed = before is None or not isinstance(before, Mention)
        placed = placed and getattr(before, "low", ".") in (
            *".,;:!?",
            "and",
            "into",
            "off",
            "then",
        )
    if nxt is None or nxt.kind == "punct":
        return placed
    acts = any(r.form == "s" for r in verb_readings(nxt.low))
    return placed and (acts or nxt.low in ("into", "off", "onto", "past", "in", "and", "goes"))


def names_no_thing(word: str, *, bare: bool = False) -> bool:
    """ "an interaction", "smoke": what nobody can touch, or what things are made of.

    Args:
        word: The noun as it stands.
        bare: Whether it has neither article nor number ("stirs soup").
    """
    if word in lex.COLORS or parse_number(word) is not None:
        return False  # "the pink", "ball two"
    single = lex.singular(word)[0]
    if single in _LINKS:
        return False  # "hang on strings", which is a section of an orchestra, too
    kinds = {no_things().get(word), no_things().get(single)}
    filling = bare and word == single and word in lex.SUBSTANCES
    return filling or bool(kinds & {"nothing", "substance"})


def people_here(c: Chunks, j: int) -> bool:
    """ "A couple dances", "two teams": not "a couple of cups", "a crowd barrier"."""
    if lex.singular(low_at(c, j))[0] not in _PEOPLE or low_at(c, j + 1) == "of":
        return False
    return not noun_soon(c, j + 1) or bool(verb_readings(low_at(c, j + 1)))


def packed(c: Chunks, word: str, m: Mention) -> lex.Noun | None:
    """ "Pick up the milk", "puts the butter on a plate": what such stuff is sold in.

    Of what no row tells it is a bottle or a packet, as a stand-in.
    """
    verb, stuff = element_before(c), word in lex.SUBSTANCES | _FLUIDS
    taken = isinstance(verb, Verb) and verb.lemma in _TAKING and not verb.passive
    if not (taken and (stuff or no_things().get(word) == "substance")):
        return None
    if m.determiner not in _ARTICLES or m.amounts:
        return None
    rows = lex.packed()
    before = [m.head] if m.head not in ("", word) else m.adjectives[-1:]
    row = rows.get(" ".join([*before, word])) or rows.get(word)
    noun = lex.nouns()[row or ("bottle" if word in _FLUIDS else "food packet")]
    if row is None:
        return replace(noun, stand_in=noun.name)
    return replace(noun, name=row, description=row)


def wisp(c: Chunks, j: int) -> int:
    """ "a plume of grey smoke", "a laser beam": the words from token j on, 0 if it is a thing."""
    if lex.singular(low_at(c, j))[0] not in _WISPS:
        return 0
    if low_at(c, j + 1) == "of":
        of = next((k for k in (j + 2, j + 3) if low_at(c, k) in _WISPS_OF), j)
        return of + 1 - j if of > j else 0
    return int(lex.singular(low_at(c, j))[0] == "beam" and low_at(c, j - 1) in _SHINING)


def fills(c: Chunks, j: int, vessel: lex.Noun) -> bool:
    """ "a pot of stew", "a bowl of batter": a bare singular after a vessel is what fills it."""
    token, after = token_at(c, j), token_at(c, j + 1)
    if vessel.kind not in _VESSELS or token is None or token.kind != "word":
        return False
    closed = lex.DETERMINERS | lex.PRONOUNS | _NUMERALS | _ARTICLES
    single = lex.singular(token.low)[0] == token.low and token.low not in closed
    compound = after is not None and (after.tag == "NOUN" or match_noun(c, j + 1) is not None)
    return token.tag == "NOUN" and single and not compound


def weighed(c: Chunks, first: int, last: int) -> bool:
    """ "a lump of clay", "10 kg of rice", "coal weighing 3 kg": a thing, whatever it is made of.

    Args:
        c: The text.
        first: First token of the phrase.
        last: Its noun.
    """
    if low_at(c, first - 1) == "of" and (low_at(c, first - 2) in PIECES or _mass(c, first - 2)):
        return True
    said = low_at(c, last + 1) in ("weighing", "of", "with", "has", "weighs")
    return said and any(_mass(c, k) for k in range(last + 2, last + 6))


def _mass(c: Chunks, k: int) -> bool:
    token = token_at(c, k)
    amount = token.amount if token is not None else None
    return amount is not None and amount.dimension in ("mass", "volume")


def ends_as_noun(c: Chunks, k: int, m: Mention) -> bool:
    """ "a visible dent", "a gentle touch of a finger": no verb, and no thing either."""
    nxt = token_at(c, k + 1)
    small = lex.PREPOSITIONS | lex.SUBORDINATORS | {"and", "but", "that", "which"}
    ends = nxt is None or nxt.kind == "punct" or nxt.low in small
    if pair_acts(c, k):
        return False
    base = any(r.form == "base" for r in verb_readings(low_at(c, k)))
    return m.determiner in ("a", "an") and base and ends and names_no_thing(low_at(c, k))


def is_name(c: Chunks, j: int, m: Mention) -> bool:
    """ "Kevin lobs a ball": a capital in mid-sentence, or a common first name."""
    token = c.tokens[j]
    if m.determiner or m.adjectives or m.count is not None or not token.text[0].isupper():
        return False
    if token.low in lex.FIRST_NAMES:
        return True
    before = token_at(c, j - 1)
    starts = before is None or before.text in '.;:!?-–—•*)"“'
    return not starts and token.tag == "PROPN" and token.text[1:].islower()


def is_attribute_start(c: Chunks, j: int) -> bool:
    if low_at(c, j) in _MEASURES and low_at(c, j - 1) in ("in", "whose", "'s"):
        return True  # "2 cm in diameter"
    if low_at(c, j) in _MEASURES and token_at(c, j + 1) is not None:
        if c.tokens[j + 1].text == ":":
            return True
        return c.tokens[j + 1].kind == "qty" or low_at(c, j + 1) == "of"
    if low_at(c, j) in ("time", "motion", "place", "reverse", "times", "line", "advance"):
        return low_at(c, j - 1) in ("in", "three", "two", "several", "of", "into", "times")
    return low_at(c, j) in (
        "speed",
        "velocity",
        "sunlight",
        "rain",
        "speeds",
        "velocities",
        "brakes",
        "impact",
        "contact",
    )


def pronoun_here(c: Chunks, j: int) -> bool:
    low = low_at(c, j)
    if low in ("that", "this"):
        return bool(verb_ahead(c, j + 1))
    return True


def goes_off(c: Chunks, i: int) -> bool:
    """ "glass slides off,": a verb in -s with a particle, no plural."""
    token, nxt = token_at(c, i), low_at(c, i + 1)
    verb = token is not None and any(r.form == "s" for r in verb_readings(token.low))
    return verb and nxt in ("off", "down", "over", "into", "onto", "away", "out")
