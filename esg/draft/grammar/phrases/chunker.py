"""Shallow syntax of a prompt: tokens become noun phrases, verb groups and small words.

The lexicon decides first, because statistical taggers misread ungrammatical prompts ("A car move
towards ..."); spaCy's tags only settle words that the lexicon does not know.
"""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.noun_phrases import noun_phrase
from esg.draft.grammar.phrases.noun_starts import EXTENTS, finite_after_of
from esg.draft.grammar.phrases.nouns import low_at, match_noun, token_at
from esg.draft.grammar.phrases.reader import (
    acts_on_something,
    element_before,
    is_adjective,
    thing_named,
    unknown_verb,
    verb_ahead,
    verb_here,
    verb_soon,
)
from esg.draft.grammar.phrases.verb_groups import verb_group
from esg.draft.grammar.rewrites.nominals import RETOLD_NOUNS
from esg.draft.text.elements import Element, Mention, Token, Verb, Word
from esg.draft.text.multiwords import MULTIWORDS
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings

_HEADINGS = lex.word_set("headings")
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
    token = c.tokens[i]
    low = token.low
    if token.kind == "punct":
        c.elements.append(Word(token.start, token.end, "punct", token.text))
        return i + 1
    used = _heading(c, i)
    if used:
        return i + used
    previous = element_before(c)
    opens = previous is None or (isinstance(previous, Word) and previous.low in ".;!?\n")
    if low in _ASKING and opens and low_at(c, i + 1) in _ASKED:
        c.elements.append(Word(token.start, token.end, "adv", "indeed"))
        return i + 1  # "Can a ball hit a box?"
    if token.kind == "qty":
        j = noun_phrase(c, i)
        if j is not None:
            return j
        c.elements.append(Word(token.start, token.end, "qty", token.low, token.amount))
        return i + 1
    used = _multiword(c, i) if low in ("to", "which", "that") else 0
    if used:
        return i + used
    if (low, low_at(c, i + 1), low_at(c, i + 2)) in _SO_AS_TO and verb_readings(low_at(c, i + 3)):
        j = step(c, i + 2)  # "in order to ram it"
        c.elements[-1].start = token.start
        return j
    if low == "to":
        nxt = verb_readings(low_at(c, i + 1))
        base = next((v for v in nxt if v.form == "base"), None)
        if base is not None and (low_at(c, i + 1) not in lex.nouns() or _verb_after_to(c, i + 1)):
            j = verb_group(c, i + 1)
            if j is not None:
                verb = c.elements[-1]
                assert isinstance(verb, Verb)
                verb.infinitive = True
                verb.start = token.start
                return j
        c.elements.append(Word(token.start, token.end, "prep", "to"))
        return i + 1
    if low in ("which", "who", "whose", "whom") or (
        low == "that"
        and isinstance(element_before(c), Mention)
        and (verb_ahead(c, i + 1) or _clause_of_noun(c, i))
    ):
        c.elements.append(Word(token.start, token.end, "rel", low))
        return i + 1
    degree = {low_at(c, i - 2), low_at(c, i - 3)} & {"so", "such"}
    if low == "that" and degree and verb_soon(c, i + 1):
        c.elements.append(Word(token.start, token.end, "sub", "so"))
        return i + 1
    if low in ("and", "or", "but", "plus", "nor"):
        c.elements.append(Word(token.start, token.end, "conj", low))
        return i + 1
    used = _bounded_count(c, i)
    if used:
        c.elements.append(Word(token.start, c.tokens[i + used - 1].end, "adv", "exactly"))
        return i + used
    used = _multiword(c, i)
    if used:
        return i + used
    size = element_before(c)
    if low in EXTENTS and isinstance(size, Word) and size.kind == "qty":
        c.elements.append(Word(token.start, token.end, "unknown", low))
        return i + 1  # "15 cm tall and 7 cm wide tips over"
    if _last_of_compound(c, i) and (j := noun_phrase(c, i)) is not None:
        head, first = c.elements.pop(), c.elements.pop()
        if isinstance(head, Mention) and isinstance(first, Mention):
            head.start, head.text = first.start, f"{first.text} {head.text}"
            head.adjectives.insert(0, first.head)
        c.elements.append(head)
        return j  # "Rain barrel topples"
    named = noun_phrase(c, i) if _named_thing(c, i) else None
    if named is not None:
        return named
    if verb_here(c, i) or _verb_after_amount(c, i):
        j = verb_group(c, i)
        if j is not None:
            return j
    if low in ("then", "meanwhile", "simultaneously"):
        c.elements.append(Word(token.start, token.end, "adv", low))
        return i + 1
    if (
        low in ("after", "before")
        and low_at(c, i + 1) in ("that", "this", "which")
        and low_at(c, i + 2) not in RETOLD_NOUNS
    ):
        c.elements.append(Word(token.start, token.end, "adv", "then"))
        return i + 2
    if low in lex.SUBORDINATORS and _clause_follows(c, i):
        c.elements.append(Word(token.start, token.end, "sub", low))
        return i + 1
    if unknown_verb(c, i):
        c.elements.append(Verb(token.start, token.end, low, "unknown", "s"))
        return i + 1
    j = noun_phrase(c, i)
    if j is not None:
        return j
    if low == "in" and low_at(c, i + 1) == "off":
        c.elements.append(Word(token.start, token.end, "adv", "in"))
        return i + 1  # "goes in off the cushion"
    verb = element_before(c)
    leaves = isinstance(verb, Verb) and verb.sense in ("fall", "roll", "slide", "knock")
    if low == "of" and leaves and low_at(c, i + 1) in lex.DETERMINERS:
        low = "off"  # "falls of the shelf"
    if low in lex.PREPOSITIONS or low in lex.SUBORDINATORS:
        c.elements.append(Word(token.start, token.end, "prep", low))
        return i + 1
    if low in lex.ADVERBS or low.endswith("ly") or token.tag == "ADV":
        c.elements.append(Word(token.start, token.end, "adv", low))
        return i + 1
    if low in lex.MODALS:
        c.elements.append(Word(token.start, token.end, "adv", low))
        return i + 1
    previous = element_before(c)
    if (
        (token.tag == "VERB" or low.endswith(("s", "ed", "ing")))
        and low.isalpha()
        and (
            isinstance(previous, Mention)
            or (isinstance(previous, Word) and previous.kind in ("conj", "rel", "adv"))
        )
    ):
        form = "ing" if low.endswith("ing") else "s"
        c.elements.append(Verb(token.start, token.end, low, "unknown", form))
        return i + 1
    c.elements.append(Word(token.start, token.end, "unknown", low))
    return i + 1


def _clause_of_noun(c: Chunks, i: int) -> bool:
    """ "the bottle that the ball knocked off": a subject of its own follows."""
    head = element_before(c)
    if not isinstance(head, Mention) or head.attribute or head.pronoun:
        return False
    if {"so", "such"} & {low_at(c, k) for k in range(max(0, i - 5), i)}:
        return False
    if low_at(c, i + 1) not in lex.DETERMINERS:
        return low_at(c, i + 1) in ("it", "he", "she", "they") and verb_ahead(c, i + 2)
    noun = match_noun(c, i + 2) or match_noun(c, i + 3)
    return noun is not None and any(verb_ahead(c, k) for k in (i + 3, i + 4))


def _heading(c: Chunks, i: int) -> int:
    """ "Scene 1:", "SYSTEM:", "Prompt:" in front of a sentence names no object."""
    previous = element_before(c)
    if previous is not None and not (isinstance(previous, Word) and previous.low in ".;!?-"):
        return 0
    token = c.tokens[i]
    titled = _title(c, i)
    if titled:
        c.elements.append(Word(token.start, c.tokens[i + titled - 1].end, "adv", "heading"))
        return titled
    n = 2 if token_at(c, i + 1) is not None and c.tokens[i + 1].kind == "number" else 1
    colon = token_at(c, i + n)
    if token.kind != "word" or colon is None or colon.text != ":":
        return 0
    unknown = match_noun(c, i) is None and not verb_readings(token.low)
    if token.low not in _HEADINGS and not (unknown and token.text.isupper()):
        return 0
    if len(token.text) == 1:
        return 0
    c.elements.append(Word(token.start, colon.end, "adv", "heading"))
    return n + 1


def _title(c: Chunks, i: int) -> int:
    """ "Pushing task:", "Physics puzzle:": the words of a title and its colon."""
    for n in (2, 3, 4):
        colon = token_at(c, i + n)
        words = c.tokens[i : i + n]
        if colon is None or any(t.kind != "word" for t in words):
            return 0
        if colon.text == ":":
            return n + 1 if words[-1].low in _HEADINGS | _TITLES else 0
    return 0


def _last_of_compound(c: Chunks, i: int) -> bool:
    """ "Rain barrel topples": after a bare noun a verb has an ending, and one follows."""
    first = element_before(c)
    bare = isinstance(first, Mention) and not (first.plural or first.determiner or first.count)
    if not bare or first.pronoun or first.letters or first.end + 1 != c.tokens[i].start:
        return False
    forms = {r.form for r in verb_readings(low_at(c, i))}
    follows = verb_readings(low_at(c, i + 1))
    finite = any(r.form in ("s", "past") for r in follows) or low_at(c, i + 1) in ("is", "was")
    return forms == {"base"} and finite and match_noun(c, i) is not None


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


def _multiword(c: Chunks, i: int) -> int:
    for words, kind, low in MULTIWORDS.get(low_at(c, i), ()):
        if c.lows[i : i + len(words)] == words:
            if words[0] in ("left", "right") and _previous_is_turn(c):
                continue
            if words == ("back", "into") and _many_reverse(c):
                continue  # "Two vans back into each other"
            if words[0] in ("at", "in", "on") and low_at(c, i + len(words)) in ("of", "to"):
                continue  # "at the end of the ramp", "on the way to the door"
            if words[-1] in ("that", "this") and low_at(c, i + len(words)) in RETOLD_NOUNS:
                continue  # "because of that bump"
            one = element_before(c) if words == ("at", "the", "end") else None
            if isinstance(one, Mention) and one.pronoun == "one" and one.determiner == "the":
                continue  # "the one at the end"
            if words == ("down", "to") and verb_readings(low_at(c, i + 2)):
                continue
            if words in (("on", "to"), ("in", "to")) and verb_readings(low_at(c, i + 2)):
                continue
            if (
                kind == "sub"
                and words[-1] in _MOMENTS
                and not _clause_follows(c, i + len(words) - 1)
            ):
                continue  # "at the moment of impact"
            if kind == "prep" and low in ("after", "before") and words[-1] == low:
                kind = "sub" if _clause_follows(c, i + len(words) - 1) else kind
            if words == ("from", "behind") and thing_named(c, i + 2):
                kind, low = "prep", "behind"  # "runs out from behind a bus"
            start, end = c.tokens[i].start, c.tokens[i + len(words) - 1].end
            c.elements.append(Word(start, end, kind, low))
            return len(words)
    return 0


def _previous_is_turn(c: Chunks) -> bool:
    p = element_before(c)
    return isinstance(p, Verb) and p.sense in ("turn", "swerve")


def _verb_after_to(c: Chunks, i: int) -> bool:
    """Whether an ambiguous word after "to" is an infinitive ("to hit the ball")."""
    nxt = low_at(c, i + 1)
    token = token_at(c, i)
    if nxt in lex.DETERMINERS or nxt in lex.PRONOUNS or nxt in ("into", "with", "onto", "to"):
        return True
    return token is not None and token.tag == "VERB"


def _goes_on(c: Chunks, j: int) -> bool:
    """Whether a finite verb stands at token j, after a conjunction, and no noun."""
    j += low_at(c, j) in ("then", "also", "finally")
    finite = any(r.form in ("s", "past") for r in verb_readings(low_at(c, j)))
    plural = match_noun(c, j) is not None and not acts_on_something(c, j + 1)
    return finite and not plural


def _clause_follows(c: Chunks, i: int) -> bool:
    """Whether a subordinator starts a clause ("after it hits") and not "after 3 seconds"."""
    token = token_at(c, i + 1)
    if token is None or token.kind in ("qty", "number"):
        return False
    if low_at(c, i) in ("so", "since") and low_at(c, i + 1) in ("hard", "fast", "much"):
        return False
    first = i + 1 + (low_at(c, i + 1) in lex.DETERMINERS)
    if (
        low_at(c, first)
        in (
            "collision",
            "impact",
            "crash",
            "hit",
            "contact",
            "turn",
            "stop",
            "strike",
            "kick",
        )
        and not verb_readings(low_at(c, first + 1))
        and low_at(c, first + 1) not in lex.MODALS
        and (low_at(c, first + 1) != "by" or first > i + 1)
    ):
        return False
    for j in range(i + 1, min(i + 14, len(c.tokens))):
        t = c.tokens[j]
        going = any(r.form in ("ing", "pp") for r in verb_readings(low_at(c, j + 1)))
        if t.text == "," and going and any(x.text == "," for x in c.tokens[j + 1 : j + 8]):
            return True  # "when the truck, going 10 m/s, brakes"
        if t.kind == "punct" and t.text in ".;,!?":
            return False
        if t.low in ("and", "but", "or", "then") and j > i + 1 and _goes_on(c, j + 1):
            return False  # "stops before the wall and turns", "just before a gate but hits it"
        readings = verb_readings(t.low)
        if (readings or t.low in lex.MODALS) and (
            (low_at(c, j) not in lex.nouns() and low_at(c, j) not in lex.ATTRIBUTES)
            or low_at(c, j - 1) not in lex.DETERMINERS
        ):
            if t.low in lex.nouns() and j == i + 1:
                return any(r.form == "ing" for r in readings)
            return not (low_at(c, i) == "as" and j == i + 1)
    return False
