"""Noun phrases: determiner, count, group word, adjectives, amounts, and then the head."""

from __future__ import annotations

from collections.abc import Callable

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.noun_heads import read_head
from esg.draft.grammar.phrases.noun_questions import goes_off, is_she, people_here
from esg.draft.grammar.phrases.noun_starts import (
    EXTENTS,
    alone,
    count_of,
    finite_after_of,
    last_of_sizes,
    lone_letter,
    noun_at_or_after,
    numbered,
    part_of_plural,
    parts_of,
    verb_next,
)
from esg.draft.grammar.phrases.nouns import low_at, match_noun, token_at
from esg.draft.grammar.phrases.reader import acts, is_adjective, known_adjective, noun_soon
from esg.draft.text.elements import Mention, Word
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings

_QUANTIFIERS = lex.word_set("quantifiers of")
_VAGUE = lex.word_set("vague counts")
_SEVERAL = {"pair": 2, "couple": 2, "trio": 3, "dozen": 12, "half-dozen": 6, "dozens": 12}
_INTENSIFIERS = lex.word_set("intensifiers")
_MEASURED = ("mass", "length", "speed", "angle", "volume")
_ALSO_ADVERBS = lex.word_set("adjectives that are adverbs")
_OWNS = frozenset({"'s", "\u2019s", "'"})
_STOP = -1
"""No further modifier: what stands here is the head, or no noun phrase."""


def noun_phrase(c: Chunks, i: int) -> int | None:
    """Reads the noun phrase at token i; returns the next index, None where there is none."""
    if i >= len(c.tokens):
        return None
    m = Mention(c.tokens[i].start, c.tokens[i].end)
    j = _without_noun(c, i, m)
    if j:
        return j
    j = _determiner(c, _quantifier(c, i, m), m)
    j = _group(c, count_of(c, _vague_count(c, j, m), m), m)
    if low_at(c, j) in ("other", "more", "additional", "extra"):
        m.adjectives.append("other")
        j = count_of(c, j + 1, m)
    while j < len(c.tokens):
        if _ends_early(c, i, j, m):
            return j
        after = next((k for reader in MODIFIERS if (k := reader(c, i, j, m))), _STOP)
        if after == _STOP:
            break
        j = after
        if m.adjectives and low_at(c, j) in ("one", "ones") and _names_one(low_at(c, j - 1)):
            break
    return read_head(c, i, j, m)


def _add(c: Chunks, m: Mention, end: int, start: int | None = None) -> None:
    """Adds a phrase whose last token is before `end`."""
    m.end = c.tokens[end - 1].end
    m.text = c.text[m.start if start is None else start : m.end]
    c.elements.append(m)


def _without_noun(c: Chunks, i: int, m: Mention) -> int:
    """Letters, "this crash", "the latter", "her": phrases with no noun; the next index or 0."""
    low, after = low_at(c, i), low_at(c, i + 1)
    if lone_letter(c, i):
        m.letters, m.head, m.determiner = [c.tokens[i].text.lstrip("#")], "@", "the"
        m.text, m.end = c.tokens[i].text, c.tokens[i].end
        c.elements.append(m)
        return i + 1
    previous = c.elements[-1] if c.elements else None
    retold = isinstance(previous, Word) and previous.kind in ("prep", "sub")
    if retold and low in ("this", "that") and after in lex.RETOLD_NOUNS:
        m.determiner, m.head, m.attribute = low, after, True
    elif low == "the" and after in ("latter", "former") and alone(c, i + 2):
        m.pronoun = after
    elif is_she(c, i) or (low in ("this", "that", "these", "those") and verb_next(c, i + 1)):
        m.pronoun = low
        _add(c, m, i + 1)
        return i + 1
    else:
        return 0
    _add(c, m, i + 2)
    return i + 2


def _quantifier(c: Chunks, j: int, m: Mention) -> int:
    """ "all of", "one of", "two of the ten"."""
    low = low_at(c, j)
    if low in _QUANTIFIERS and low_at(c, j + 1) == "of":
        m.count = 1 if low in ("one", "each") else 2 if low == "both" else m.count
        m.single = low == "one"
        return j + 2
    if low in ("all", "both") and low_at(c, j + 1) in lex.DETERMINERS:
        return j + 1
    if part_of_plural(c, j):
        value = parse_number(low)
        m.subset = int(value) if isinstance(value, float) else 0
        return j + 2
    return j


def _determiner(c: Chunks, j: int, m: Mention) -> int:
    if low_at(c, j) in lex.DETERMINERS:
        m.determiner = low_at(c, j)
        m.count = 0 if m.determiner == "no" else m.count
        j += 1
    if m.determiner in lex.VAGUE_COUNTS:
        m.count, m.vague = lex.VAGUE_COUNTS[m.determiner], m.determiner != "both"
    return j


def _vague_count(c: Chunks, j: int, m: Mention) -> int:
    """ "several", "a dozen", but not "a handful of"."""
    word = low_at(c, j)
    if word not in _VAGUE or word == m.determiner:
        return j
    if word in lex.GROUP_WORDS and (low_at(c, j + 1) == "of" or people_here(c, j)):
        return j
    m.count, m.vague = lex.VAGUE_COUNTS[word], word not in ("couple", "dozen", "pair")
    return j + 1


def _group(c: Chunks, j: int, m: Mention) -> int:
    """ "a set of", "a long row of five": how many, and how they stand."""
    skip, word = 0, lex.singular(low_at(c, j))[0]
    second = lex.singular(low_at(c, j + 1))[0]
    if is_adjective(c, j) and second in lex.GROUP_WORDS and low_at(c, j + 2) == "of":
        skip, word = 1, second
    if word not in lex.GROUP_WORDS or low_at(c, j + 1 + skip) != "of":
        return j
    named = token_at(c, j + 2 + skip)
    if named is not None and named.tag == "PROPN" and named.text[:1].isupper():
        return j  # "the pyramids of Giza"
    one = word == "wall" or not lex.singular(low_at(c, j + 2))[1]
    if (match_noun(c, j) or (None, 1))[1] >= 3 and one:
        return j  # "a pile of snow", "a wall of bricks" is one thing, "a tower of blocks" several
    if word == "wall" and low_at(c, j + 2 + skip) in lex.DETERMINERS:
        return j
    if word == "load" and low_at(c, j + 2 + skip) in ("the", "its", "his", "her", "their"):
        return j  # "the load of the lorry": what is on it
    m.pattern, m.group_word = lex.GROUP_WORDS[word], word
    times = m.count if m.count and m.count > 1 else 1
    m.count = _SEVERAL[word] * times if word in _SEVERAL else None
    m.vague, m.plural = False, True
    j += 2 + skip
    if low_at(c, j) in lex.DETERMINERS:
        if low_at(c, j) in lex.VAGUE_COUNTS:
            m.count, m.vague = lex.VAGUE_COUNTS[low_at(c, j)], True
        j += 1
    return count_of(c, j, m)


def _ends_early(c: Chunks, i: int, j: int, m: Mention) -> bool:
    """Whether the last modifier was the head, and a verb stands here; the phrase is added then."""
    low = low_at(c, j)
    if c.tokens[j].kind == "qty" or not m.adjectives:
        return False
    noun = match_noun(c, j)
    plural = noun is not None and noun[2]
    acting = any(r.form == "s" for r in verb_readings(low))
    a_thing = m.determiner in ("a", "an") and not m.group_word
    ambiguous = plural or lex.singular(low)[0] in lex.ATTRIBUTES
    if a_thing and acting and ambiguous and not known_adjective(m.adjectives[-1]):
        # "a pendulum swings": an unknown noun and its verb
        m.head, m.known = lex.singular(m.adjectives.pop())[0], False
        _add(c, m, j, c.tokens[j - 1].start)
        return True
    if (_part_acts(c, i, j, m) or _bare_acts(c, i, j, m)) and acting:
        own = low_at(c, i - 1) in _OWNS
        m.head, m.known, m.attribute = m.adjectives.pop(), own, own
        _add(c, m, j)
        return True
    if m.determiner == "the" and m.adjectives[-1] in lex.ALONE and acting:
        after = low_at(c, j + 1)
        many = noun is None or (plural and m.count is None)
        small = many and after in (lex.PREPOSITIONS | lex.ADVERBS) - {"of"}
        if small or after in lex.PRONOUNS or after in lex.DETERMINERS:
            m.pronoun = "one"  # "the second hits it"
            _add(c, m, j)
            return True
    return False


def _goes_on(c: Chunks, j: int) -> bool:
    """Whether token j may follow a verb."""
    nxt = token_at(c, j)
    small = (lex.PREPOSITIONS | lex.ADVERBS | lex.DETERMINERS | lex.PRONOUNS) - {"of"}
    if nxt is None or nxt.kind == "punct" or nxt.low.endswith("ly"):
        return True
    return nxt.low in small | {"and", "but", "when"}


def _part_acts(c: Chunks, i: int, j: int, m: Mention) -> bool:
    """ "The ladder's top slides along a wall": a part and its verb, no slides."""
    part = low_at(c, i - 1) in _OWNS and m.adjectives[-1] in lex.PARTS
    return part and _goes_on(c, j + 1)


def _bare_acts(c: Chunks, i: int, j: int, m: Mention) -> bool:
    """ "and ego stops behind it": who does it and the verb, no stops of a kind."""
    before = c.elements[-1] if c.elements else None
    begins = before is None or (
        isinstance(before, Word) and before.kind in ("punct", "conj", "sub")
    )
    bare = not m.determiner and m.count is None and len(m.adjectives) == 1 and j == i + 1
    named = bare and low_at(c, i - 1) not in _OWNS and not known_adjective(m.adjectives[0])
    after = low_at(c, j + 1)
    adverb = after in lex.ADVERBS or after.endswith("ly")
    noun = named and (adverb or c.tokens[j].tag == "VERB")
    return begins and noun and _goes_on(c, j + 1)


def _names_one(low: str) -> bool:
    return low in lex.PLACE_ADJECTIVES or low in lex.COLORS or low in lex.MATERIALS


def _tells_one(c: Chunks, j: int, m: Mention) -> bool:
    """ "the rubber one", "an orange one": a material or a colour there is no thing of its own."""
    made = m.determiner == "the" and low_at(c, j) in lex.MATERIALS
    return (made or low_at(c, j) in lex.COLORS) and low_at(c, j + 1) in ("one", "ones")


def _amount(c: Chunks, i: int, j: int, m: Mention) -> int:
    """ "a 2 kg", "a 3 m long"."""
    token = c.tokens[j]
    amount = token.amount
    if token.kind != "qty" or amount is None or amount.dimension not in _MEASURED:
        return 0
    k = j + 1
    extent = low_at(c, k).lstrip("-")
    dash = token_at(c, k)
    if dash is not None and dash.text == "-":
        k += 1
        extent = low_at(c, k)
    if not noun_at_or_after(c, k):
        return _STOP
    if j == i and (finite_after_of(c, i, k) or (extent in EXTENTS and last_of_sizes(c, i, k))):
        return _STOP
    m.amounts.append(amount)
    if extent in EXTENTS:
        m.adjectives.append(f"@{amount.start}:{extent}")
        k += 1
    return k


def _name(c: Chunks, i: int, j: int, m: Mention) -> int:
    """ "the No. 4 car"."""
    token = c.tokens[j]
    if token.kind != "number" or token.text[0] != "#" or not match_noun(c, j + 1):
        return 0
    m.letters.append(token.text[1:])
    return j + 1


def _between(c: Chunks, i: int, j: int, m: Mention) -> int:
    """What stands between two modifiers: "a 2 m long, 30 kg log", "a red and white ball"."""
    token, after = c.tokens[j], token_at(c, j + 1)
    if token.text == ",":
        listed = bool(m.amounts) and after is not None and after.kind == "qty"
        adjective = token.kind == "punct" and m.adjectives and is_adjective(c, j + 1)
        return j + 1 if listed or (adjective and noun_soon(c, j + 1)) else 0
    if token.low != "and" or not m.adjectives or not is_adjective(c, j + 1):
        return 0
    colors = m.adjectives[-1] in lex.COLORS and low_at(c, j + 1) in lex.COLORS
    return j + 1 if colors else 0


def _is_head(c: Chunks, i: int, j: int, m: Mention) -> int:
    """A noun that is no modifier of another one."""
    noun = match_noun(c, j)
    if noun is None or _tells_one(c, j, m):
        return 0
    if noun[1] > 1 or not is_adjective(c, j) or not noun_soon(c, j + 1) or numbered(c, j):
        return _STOP  # numbered: "Marble one hits marble two"
    if m.determiner and acts(c, j + 1):
        return _STOP  # "the brick slides off it": a material that is a thing of its own
    bare = not m.determiner and not m.count
    return _STOP if bare and goes_off(c, j + 1) else 0  # "glass slides off"


def _adverb(c: Chunks, i: int, j: int, m: Mention) -> int:
    """ "a very heavy box"."""
    low = low_at(c, j)
    if low not in lex.ADVERBS or is_adjective(c, j):
        return 0
    return j + 1 if low in _INTENSIFIERS and is_adjective(c, j + 1) else _STOP


def _adjective(c: Chunks, i: int, j: int, m: Mention) -> int:
    low = low_at(c, j)
    if not is_adjective(c, j):
        return 0
    if not (low_at(c, j + 1) in ("one", "ones") and _names_one(low)):
        follows = (noun_soon(c, j + 1) or parts_of(c, j + 1)) and not _acts_there(c, i, j)
        small = low in _ALSO_ADVERBS and not m.determiner and not parts_of(c, j + 1)
        if not follows and (low in lex.PARTS or small):
            return _STOP
    m.adjectives.append(low)
    return j + 1


def _acts_there(c: Chunks, i: int, j: int) -> bool:
    """ "The one in the middle flies off": no flies of the middle."""
    at, who = (c.elements[-1:] or [None])[0], (c.elements[-2:-1] or [None])[0]
    if low_at(c, j) not in lex.PARTS or j != i + 1 or not isinstance(at, Word) or at.kind != "prep":
        return False
    one = isinstance(who, Mention) and who.determiner == "the" and not who.plural
    acts = any(r.form == "s" for r in verb_readings(low_at(c, j + 1)))
    after = low_at(c, j + 2)
    return one and acts and (not after or after in lex.PREPOSITIONS | lex.DETERMINERS | {".", ","})


def _verb_form(c: Chunks, i: int, j: int, m: Mention) -> int:
    """ "a fallen tree", "an empty jam jar"."""
    low, readings = low_at(c, j), verb_readings(low_at(c, j))
    participle = any(r.form in ("ing", "pp") for r in readings) and (m.determiner or m.count)
    participle = participle and noun_soon(c, j + 1) and low not in lex.nouns()
    bare = bool(readings) and all(r.form == "base" for r in readings) and bool(m.adjectives)
    bare = bare and m.determiner in ("a", "an") and match_noun(c, j + 1) is not None
    if not participle and not bare:
        return 0
    m.adjectives.append(low)
    return j + 1


MODIFIERS: tuple[Callable[[Chunks, int, int, Mention], int], ...] = (
    _amount,
    _name,
    _between,
    _is_head,
    _adverb,
    _adjective,
    _verb_form,
)
"""Readers of one modifier at token j of a phrase that begins at token i.

Each returns the token after it, 0 where it is none of its kind, or `_STOP`.
"""
