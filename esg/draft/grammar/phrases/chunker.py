"""Shallow syntax of a prompt: tokens become noun phrases, verb groups and small words.

The lexicon decides first, because statistical taggers misread ungrammatical prompts ("A car move
towards ..."); spaCy's tags only settle words that the lexicon does not know.
"""

from __future__ import annotations

from collections.abc import Callable
import re

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.noun_phrases import noun_phrase
from esg.draft.grammar.phrases.noun_starts import EXTENTS, finite_after_of
from esg.draft.grammar.phrases.nouns import low_at, match_noun, token_at
from esg.draft.grammar.phrases.reader import (
    element_before,
    is_adjective,
    thing_named,
    unknown_verb,
    verb_ahead,
    verb_here,
    verb_soon,
)
from esg.draft.grammar.phrases.verb_groups import verb_group
from esg.draft.text.elements import Element, Mention, Token, Verb, Word, WordKind
from esg.draft.text.multiwords import MULTIWORDS
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings

_HEADINGS = lex.word_set("headings")
_DATELINE = re.compile(
    rf"[^.:;!?]{{0,60}}\b(?:may|{'|'.join(lex.word_set('months'))})\b[\s,.\d]{{0,12}}"
    r"\b(?:19|20)\d\d\b[^.:;!?]{0,30}[.:]",
    re.IGNORECASE,
)
"""Where and when a picture was taken, before it is described."""
_TITLES = lex.word_set("titles (chunker)")
_ASKED = lex.DETERMINERS | {"you", "we", "i", "it", "they", "there"}
_ASKING = lex.word_set("asking (chunker)")
_BOUNDS = (
    ("at", "least"), ("at", "most"), ("no", "fewer", "than"), ("no", "more", "than"),
    ("no", "less", "than"), ("not", "more", "than"), ("more", "than"), ("fewer", "than"),
    ("less", "than"), ("up", "to"), ("as", "many", "as"), ("exactly",), ("precisely",), ("about",),
    ("around",), ("roughly",), ("nearly",), ("almost",),
)  # fmt: skip
"""What bounds a count: "at least two of the pins"."""
_SO_AS_TO = (("in", "order", "to"), ("so", "as", "to"))
_MOMENTS = lex.word_set("moments")
_EVENT_NOUNS = lex.word_set("event nouns")


_AIMS = lex.word_set("aims (chunker)")


def new_chunks(text: str, tokens: list[Token]) -> Chunks:
    """A text of which no phrase has been read yet."""
    lows = tuple("" if t.kind == "punct" else t.low for t in tokens)
    c = Chunks(text, tokens, lows, noun_phrase=lambda i: noun_phrase(c, i))
    return c


def chunk(text: str, tokens: list[Token]) -> list[Element]:
    """Phrases of a text: noun phrases, verb groups and small words, in its order."""
    c = new_chunks(text, tokens)
    i = 0
    while i < len(c.tokens):
        i = step(c, i)
    return c.elements


def step(c: Chunks, i: int) -> int:
    """Reads the element at token i; returns the token after it."""
    return next(j for reader in READERS if (j := reader(c, i)) is not None)


def _word(c: Chunks, i: int, kind: WordKind, low: str, n: int = 1) -> int:
    """Adds a small word of n tokens; the token after it."""
    c.elements.append(Word(c.tokens[i].start, c.tokens[i + n - 1].end, kind, low))
    return i + n


def _punctuation(c: Chunks, i: int) -> int | None:
    token = c.tokens[i]
    return _word(c, i, "punct", token.text) if token.kind == "punct" else None


def _question(c: Chunks, i: int) -> int | None:
    """ "Can a ball hit a box?"."""
    previous = element_before(c)
    opens = previous is None or (isinstance(previous, Word) and previous.low in ".;!?\n")
    after_if = isinstance(previous, Word) and previous.low == "," and c.text.rstrip().endswith("?")
    asks = (opens or after_if) and low_at(c, i) in _ASKING and low_at(c, i + 1) in _ASKED
    return _word(c, i, "adv", "indeed") if asks else None


def _quantity(c: Chunks, i: int) -> int | None:
    token = c.tokens[i]
    if token.kind != "qty":
        return None
    j = noun_phrase(c, i)
    if j is not None:
        return j
    c.elements.append(Word(token.start, token.end, "qty", token.low, token.amount))
    return i + 1


def _early_multiword(c: Chunks, i: int) -> int | None:
    return _multiword(c, i) if low_at(c, i) in ("to", "which", "that") else None


def _so_as_to(c: Chunks, i: int) -> int | None:
    """ "in order to ram it"."""
    if c.lows[i : i + 3] not in _SO_AS_TO or not verb_readings(low_at(c, i + 3)):
        return None
    j = step(c, i + 2)
    c.elements[-1].start = c.tokens[i].start
    return j


def _to(c: Chunks, i: int) -> int | None:
    """An infinitive, or the preposition."""
    if low_at(c, i) != "to":
        return None
    base = any(v.form == "base" for v in verb_readings(low_at(c, i + 1)))
    if base and (low_at(c, i + 1) not in lex.nouns() or _verb_after_to(c, i + 1)):
        j = verb_group(c, i + 1)
        if j is not None:
            verb = c.elements[-1]
            assert isinstance(verb, Verb)
            verb.infinitive, verb.start = True, c.tokens[i].start
            return j
    return _word(c, i, "prep", "to")


def _relative(c: Chunks, i: int) -> int | None:
    low = low_at(c, i)
    if low in ("which", "who", "whose", "whom"):
        return _word(c, i, "rel", low)
    if low != "that":
        return None
    if isinstance(element_before(c), Mention) and (verb_ahead(c, i + 1) or _clause_of_noun(c, i)):
        return _word(c, i, "rel", low)
    degree = {low_at(c, i - 2), low_at(c, i - 3)} & {"so", "such"}
    return _word(c, i, "sub", "so") if degree and verb_soon(c, i + 1) else None


def _conjunction(c: Chunks, i: int) -> int | None:
    low = low_at(c, i)
    return _word(c, i, "conj", low) if low in ("and", "or", "but", "plus", "nor") else None


def _bound(c: Chunks, i: int) -> int | None:
    n = _bounded_count(c, i)
    return _word(c, i, "adv", "exactly", n) if n else None


def _extent(c: Chunks, i: int) -> int | None:
    """ "15 cm tall and 7 cm wide tips over"."""
    size = element_before(c)
    extent = low_at(c, i) in EXTENTS and isinstance(size, Word) and size.kind == "qty"
    return _word(c, i, "unknown", low_at(c, i)) if extent else None


def _named(c: Chunks, i: int) -> int | None:
    return noun_phrase(c, i) if _named_thing(c, i) else None


def _verb(c: Chunks, i: int) -> int | None:
    return verb_group(c, i) if verb_here(c, i) or _verb_after_amount(c, i) else None


def _link(c: Chunks, i: int) -> int | None:
    """ "then", "after that", "when"."""
    low = low_at(c, i)
    if low in ("then", "meanwhile", "simultaneously"):
        return _word(c, i, "adv", low)
    that = low in ("after", "before") and low_at(c, i + 1) in ("that", "this", "which")
    if that and low_at(c, i + 2) not in lex.RETOLD_NOUNS:
        c.elements.append(Word(c.tokens[i].start, c.tokens[i].end, "adv", "then"))
        return i + 2
    clause = low in lex.SUBORDINATORS and _clause_follows(c, i)
    return _word(c, i, "sub", low) if clause else None


def _unknown_verb(c: Chunks, i: int) -> int | None:
    if not unknown_verb(c, i):
        return None
    token = c.tokens[i]
    form = "ing" if token.low.endswith("ing") else "s"
    c.elements.append(Verb(token.start, token.end, token.low, "unknown", form))
    return i + 1


def _small_word(c: Chunks, i: int) -> int | None:
    """A preposition or an adverb."""
    low, after = low_at(c, i), low_at(c, i + 1)
    if low == "in" and after == "off":
        return _word(c, i, "adv", "in")  # "goes in off the cushion"
    verb = element_before(c)
    leaves = isinstance(verb, Verb) and verb.sense in ("fall", "roll", "slide", "knock")
    if low == "of" and leaves and after in lex.DETERMINERS:
        low = "off"  # "falls of the shelf"
    if low in lex.PREPOSITIONS or low in lex.SUBORDINATORS:
        return _word(c, i, "prep", low)
    adverb = low in lex.ADVERBS or low.endswith("ly") or c.tokens[i].tag == "ADV"
    return _word(c, i, "adv", low) if adverb or low in lex.MODALS else None


def _unknown(c: Chunks, i: int) -> int:
    """A word that nothing explains: a verb where one may stand, else unknown."""
    token, previous = c.tokens[i], element_before(c)
    low = token.low
    inflected = token.tag == "VERB" or low.endswith(("s", "ed", "ing"))
    after = isinstance(previous, Mention) or (
        isinstance(previous, Word) and previous.kind in ("conj", "rel", "adv")
    )
    if inflected and after and low.isalpha() and low not in _IN_ING:
        form = "ing" if low.endswith("ing") else "s"
        c.elements.append(Verb(token.start, token.end, low, "unknown", form))
        return i + 1
    return _word(c, i, "unknown", low)


_IN_ING = frozenset({"nothing", "anything", "everything", "something"})
"""What ends like a participle, and is none: "a van drives by and nothing hits the cone"."""
_DOES_IT = frozenset({"it", "he", "she", "they", "i", "we", "you", "someone", "somebody"})
"""Subjects of a relative clause that need no article."""


def _clause_of_noun(c: Chunks, i: int) -> bool:
    """ "the bottle that the ball knocked off": a subject of its own follows."""
    head = element_before(c)
    if not isinstance(head, Mention) or head.attribute or head.pronoun:
        return False
    if low_at(c, i + 1) not in lex.DETERMINERS:
        return low_at(c, i + 1) in _DOES_IT and verb_ahead(c, i + 2)
    noun = match_noun(c, i + 2) or match_noun(c, i + 3)
    return noun is not None and any(verb_ahead(c, k) for k in (i + 3, i + 4))


def _heading(c: Chunks, i: int) -> int | None:
    """ "Scene 1:", "SYSTEM:", "Prompt:" in front of a sentence names no object."""
    previous = element_before(c)
    if previous is not None and not (isinstance(previous, Word) and previous.low in ".;!?-"):
        return None
    token = c.tokens[i]
    titled = _title(c, i)
    if titled:
        c.elements.append(Word(token.start, c.tokens[i + titled - 1].end, "adv", "heading"))
        return i + titled
    n = 2 if token_at(c, i + 1) is not None and c.tokens[i + 1].kind == "number" else 1
    colon = token_at(c, i + n)
    if token.kind != "word" or colon is None or colon.text != ":":
        return None
    unknown = match_noun(c, i) is None and not verb_readings(token.low)
    if token.low not in _HEADINGS and not (unknown and token.text.isupper()):
        return None
    if len(token.text) == 1:
        return None
    c.elements.append(Word(token.start, colon.end, "adv", "heading"))
    return i + n + 1


def _title(c: Chunks, i: int) -> int:
    """ "Pushing task:", "Lima, Peru - May 2019:": the words of a title and its colon."""
    dated = _DATELINE.match(c.text) if i == 0 else None
    if dated is not None:
        return sum(t.end <= dated.end() for t in c.tokens)
    for n in (2, 3, 4):
        colon = token_at(c, i + n)
        words = c.tokens[i : i + n]
        if colon is None or any(t.kind != "word" for t in words):
            return 0
        if colon.text == ":":
            return n + 1 if words[-1].low in _HEADINGS | _TITLES else 0
    return 0


def _named_thing(c: Chunks, i: int) -> bool:
    """ "Block A slides into block B": a verb's form, but a noun with its letter."""
    letter = token_at(c, i + 1)
    if letter is None or not re.fullmatch(r"[A-Z]|#?\d", letter.text):
        return False
    if letter.text[-1].isdigit() and letter.kind != "number":
        return False
    clear = not isinstance(element_before(c), Mention) and match_noun(c, i) is not None
    return clear and low_at(c, i + 2) not in _AIMS


def _verb_after_amount(c: Chunks, i: int) -> bool:
    """ "with a mass of 25 kg slides": a noun cannot follow a quantity that "of" introduces."""
    previous = element_before(c)
    return (
        isinstance(previous, Word) and previous.amount is not None and finite_after_of(c, i - 1, i)
    )


def _bounded_count(c: Chunks, i: int) -> int:
    """Words that bound a count: "at least two pins fall"."""
    first = low_at(c, i)
    for words in _BOUNDS:
        if words[0] != first:
            continue
        k = i + len(words)
        counted = token_at(c, k)
        if counted is None or any(low_at(c, i + n) != w for n, w in enumerate(words)):
            continue
        value = parse_number(counted.low) if counted.kind in ("word", "number") else None
        whole = isinstance(value, float) and value.is_integer() and value >= 1.0
        if not whole or counted.low in ("a", "an"):
            continue
        thing = k + 1
        while is_adjective(c, thing) and match_noun(c, thing) is None:
            thing += 1
        if low_at(c, k + 1) == "of" or match_noun(c, thing) is not None:
            return len(words)
    return 0


def _many_reverse(c: Chunks) -> bool:
    """Whether a plural stands here whose verb is still to come."""
    previous, before = element_before(c), c.elements[-2] if len(c.elements) > 1 else None
    opens = before is None or getattr(before, "low", "") in (*".;!?,:", "and", "but", "then")
    return opens and isinstance(previous, Mention) and previous.plural


def _multiword(c: Chunks, i: int) -> int | None:
    for words, kind, low in MULTIWORDS.get(low_at(c, i), ()):
        n = len(words)
        if c.lows[i : i + n] != words or _apart(c, i, words):
            continue
        if kind == "sub" and words[-1] in _MOMENTS and not _clause_follows(c, i + n - 1):
            continue  # "at the moment of impact"
        if kind == "prep" and low in ("after", "before") and words[-1] == low:
            kind = "sub" if _clause_follows(c, i + n - 1) else kind
        if words == ("from", "behind") and thing_named(c, i + 2):
            kind, low = "prep", "behind"  # "runs out from behind a bus"
        return _word(c, i, kind, low, n)
    return None


def _of_several(c: Chunks) -> bool:
    """Whether the phrase named last in the text so far is of several things."""
    last = next((e for e in reversed(c.elements) if isinstance(e, Mention)), None)
    several = ("they", "all", "both", "ones")
    return last is not None and (last.plural or last.pronoun in several)


def _apart(c: Chunks, i: int, words: tuple[str, ...]) -> bool:
    """Whether words that stand together do not belong together here."""
    previous, after = element_before(c), low_at(c, i + len(words))
    if words[0] in ("left", "right"):
        return isinstance(previous, Verb) and previous.sense in ("turn", "swerve")
    if words == ("a", "little"):
        j = i + 2
        while low_at(c, j) in lex.COLORS or low_at(c, j) in lex.MATERIALS or is_adjective(c, j):
            j += 1
        return match_noun(c, j) is not None  # "a little wooden ball"
    if words == ("back", "into"):
        return _many_reverse(c)  # "Two vans back into each other"
    if words[0] in ("at", "in", "on") and after in ("of", "to"):
        return True  # "at the end of the ramp", "on the way to the door"
    if words == ("to", "a", "man") and not _of_several(c):
        return True  # "runs to a man who has fallen"
    if words[-1] in ("that", "this") and after in lex.RETOLD_NOUNS:
        return True  # "because of that bump"
    if words == ("at", "the", "end") and isinstance(previous, Mention):
        return previous.pronoun == "one" and previous.determiner == "the"  # "the one at the end"
    infinitive = words in (("down", "to"), ("on", "to"), ("in", "to"))
    return infinitive and bool(verb_readings(after))


def _verb_after_to(c: Chunks, i: int) -> bool:
    """Whether an ambiguous word after "to" is an infinitive ("to hit the ball")."""
    nxt = low_at(c, i + 1)
    token = token_at(c, i)
    if nxt in lex.DETERMINERS or nxt in lex.PRONOUNS or nxt in ("into", "with", "onto", "to"):
        return True
    return token is not None and token.tag == "VERB"


def _goes_on(c: Chunks, j: int) -> bool:
    """Whether a finite verb stands at token j, after a conjunction."""
    j += low_at(c, j) in ("then", "also", "finally")
    return any(r.form in ("s", "past") for r in verb_readings(low_at(c, j)))


def _clause_follows(c: Chunks, i: int) -> bool:
    """Whether a subordinator starts a clause ("after it hits") and not "after 3 seconds"."""
    token = token_at(c, i + 1)
    if token is None or token.kind in ("qty", "number") or _event_noun(c, i + 1):
        return False
    if low_at(c, i) in ("so", "since") and low_at(c, i + 1) in ("hard", "fast", "much"):
        return False
    aside = _aside_after(c, i)
    for j in range(i + 1, min(i + 14 + len(aside), len(c.tokens))):
        if j in aside:
            continue
        t = c.tokens[j]
        if t.text == "," and _participle_between(c, j):
            return True
        if t.kind == "punct" and t.text in ".;,!?":
            return False
        if t.low in ("and", "but", "or", "then") and j > i + 1 and _goes_on(c, j + 1):
            return False  # "stops before the wall and turns", "just before a gate but hits it"
        readings = verb_readings(t.low)
        plain = t.low not in lex.nouns() and t.low not in lex.ATTRIBUTES
        if not (readings or t.low in lex.MODALS):
            continue
        if plain or low_at(c, j - 1) not in lex.DETERMINERS:
            if t.low in lex.nouns() and j == i + 1:
                return any(r.form == "ing" for r in readings)
            return not (low_at(c, i) == "as" and j == i + 1)
    return False


def _participle_between(c: Chunks, j: int) -> bool:
    """ "When the truck, going 10 m/s, brakes": what stands between two commas from token j on."""
    going = any(r.form in ("ing", "pp") for r in verb_readings(low_at(c, j + 1)))
    return going and any(x.text == "," for x in c.tokens[j + 1 : j + 8])


def _aside_after(c: Chunks, i: int) -> range:
    """The tokens of ", which comes in later," between a subject and its verb; else none."""
    for j in range(i + 2, min(i + 7, len(c.tokens))):
        if c.tokens[j].text == "," and low_at(c, j + 1) in ("which", "who"):
            ends = (k for k in range(j + 2, min(j + 14, len(c.tokens))) if c.tokens[k].text == ",")
            close = next(ends, j)
            return range(j, close + 1) if close > j else range(0)
        if c.tokens[j].kind == "punct":
            break
    return range(0)


def _event_noun(c: Chunks, i: int) -> bool:
    """ "after the collision with a bus": a noun, where "after hits by" would be odd."""
    first = i + (low_at(c, i) in lex.DETERMINERS)
    after = low_at(c, first + 1)
    acts = bool(verb_readings(after)) or after in lex.MODALS
    by = after == "by" and first == i
    return low_at(c, first) in _EVENT_NOUNS and not acts and not by


READERS: tuple[Callable[[Chunks, int], int | None], ...] = (
    _punctuation,
    _heading,
    _question,
    _quantity,
    _early_multiword,
    _so_as_to,
    _to,
    _relative,
    _conjunction,
    _bound,
    _multiword,
    _extent,
    _named,
    _verb,
    _link,
    _unknown_verb,
    noun_phrase,
    _small_word,
    _unknown,
)
"""Readers of one element, in the order in which they are asked."""
