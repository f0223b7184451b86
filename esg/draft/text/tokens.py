"""Tokens of a prompt, with whole quantities as one token."""

from __future__ import annotations

from collections.abc import Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.text.amounts import joined
from esg.draft.text.elements import Token
from esg.draft.text.quantities import find_amounts

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
_CONTRACTED = re.compile(
    r"(?:there|that(?!'s (?:how|why|where|when|what|the way))|he|she|here|who|what"
    r"|it(?='s\s+(?:an?|the|in|on|at|not|been|being|about|just|now"
    r"|gone|come|fallen|left|done|broken|over|clear|open|empty|full|still|safe|so|too|very"
    r"|one|two|three|four|five|\d\S*|\w+ing|\w+ed|hit|struck|thrown)\b))'s\b",
    re.IGNORECASE,
)
"""What "'s" means "is" after ("it's" also where "its" is meant)."""
_TITLES = lex.word_set("titles (tokens)")
_WHOLE = frozenset({"it", "there", "that", "he", "she"})
"""Words that no "'s" is parted from where it means no "is"."""


def is_name(token: Token, *, after_noun: bool) -> bool:
    """Whether a token names one of several alike: "R1", "#5"; after a noun a bare number too."""
    pattern = r"#?\d{1,3}|[A-Z]\d{1,2}" if after_noun else r"#\d+|[A-Z]\d{1,2}"
    return token.kind in ("word", "number") and re.fullmatch(pattern, token.text) is not None


def tokenize(text: str, tags: list[tuple[int, str]] | None = None) -> list[Token]:
    """Splits text into words, numbers, punctuation and whole quantities."""
    out: list[Token] = []
    cursor = 0
    for amount in joined(find_amounts(text), text):
        out += _tokens(text, cursor, amount.start)
        out.append(Token(amount.text, amount.start, amount.end, "qty", amount))
        cursor = amount.end
    out += _tokens(text, cursor, len(text))
    by_start = dict(tags or [])
    for token in out:
        named = token.kind == "word" and token.text[-1].isdigit()  # "R1" is no noun
        token.tag = "NUM" if named else by_start.get(token.start, "")
    return out


def _tokens(text: str, start: int, end: int) -> Iterator[Token]:
    """What stands between two quantities, without the full stops of abbreviations ("vs.")."""
    before: Token | None = None
    for m in _WORD.finditer(text, start, end):
        if m[0] != "." or before is None or before.low not in _TITLES or before.end != m.start():
            for before in _parts(text, m):
                yield before


def _parts(text: str, m: re.Match[str]) -> Iterator[Token]:
    """The tokens that a sequence of characters holds."""
    word, (start, end) = m[0], m.span()
    if word == "\n":  # a new line that starts a new sentence
        yield Token(".", start, end, "punct")
    elif len(word) > 1 and word[-1].isdigit() and not word[0].isdigit():
        if len(word) <= 3 and word[0].isalpha():
            yield Token(word, start, end, "word")  # "robot R1"
        else:
            yield Token("#" + re.sub(r"\D", "", word), start, end, "number")  # "car no. 7"
    elif word[0].isalpha():
        cut, second = _second_word(text, start, end)
        yield Token(text[start:cut], start, cut, "word")
        if second:
            yield Token(second, cut, end, "word")
    elif word[0].isdigit():
        yield Token(word, start, end, "word" if re.search(r"[a-z]", word) else "number")
    elif word == "&":
        yield Token("and", start, end, "word")
    else:
        yield Token(word, start, end, "punct")


def _second_word(text: str, start: int, end: int) -> tuple[int, str]:
    """Where the first of two words in one ends, and the second: "it'll", "that's", "car's"."""
    short = _SHORTENED.match(text, start)
    if short is not None and short.end() == end:
        return short.end(1), _SHORT[short[2].lower()]
    is_ = _CONTRACTED.match(text, start)
    if is_ is not None and is_.end() == end:
        return end - 2, "is"
    if text[start:end].endswith(("'s", "’s")) and text[start : end - 2].lower() not in _WHOLE:
        return end - 2, "'s"
    return end, ""
