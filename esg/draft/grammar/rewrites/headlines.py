"""Headlines: "car crash at an intersection", "domino effect with ten books", "bowling strike"."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.gaps import is_word
from esg.draft.text.elements import Element, Mention, Verb, Word
from esg.draft.verbphrases import verb_readings

_LABELS = lex.word_set("labels")
_LONGEST = 9
"""Elements of a heading."""
_DRIVEN = lex.word_set("driven (headlines)")
_COUNT = r"(?:two|three|four|five|six|seven|eight|nine|ten|twelve|a row of|\d{1,2})"
_CRASH = re.compile(
    r"^(?:an?\s+|the\s+)?(?:(?:rear-end|head-on|t-bone|frontal)\s+)?(?P<what>[a-z]+(?: [a-z]+)?)\s+"
    r"(?:crash|collision|accident|wreck)(?=$|\s*[.,;]|\s+(?:at|on|in|near|under)\b)(?P<rest>.*)$",
    re.IGNORECASE | re.DOTALL,
)
_COLLISION = re.compile(
    rf"^(?:an?\s+|the\s+)?(?P<how>rear-end|head-on|t-bone|frontal)?\s*(?:crash|collision|accident)"
    rf"\s*(?:,|:|-|with|of|between)\s*(?P<two>{_COUNT}\s+[\w -]*?\ws)\b(?P<rest>.*)$",
    re.IGNORECASE | re.DOTALL,
)
_DOMINO = re.compile(
    rf"^(?:an?\s+|the\s+)?domino (?:effect|chain|reaction)\s*(?:,|:|-|with|of|using)\s*"
    rf"(?P<row>{_COUNT}\s+[\w -]*?\ws)\b(?P<rest>.*)$",
    re.IGNORECASE | re.DOTALL,
)
_STRIKE = re.compile(
    r"^(?:an?\s+|the\s+)?(?:bowling strike|strike (?:in|at) bowling)\s*[.!]*$", re.IGNORECASE
)


def spelled_out(text: str) -> str:
    """A prompt that is a headline without a verb as the sentence that it stands for.

    Args:
        text: The prompt, white space normalized.

    Returns:
        The sentence, or the text as it was if it tells an event by a verb.
    """
    if _STRIKE.match(text):
        return "A bowling ball hits ten bowling pins and knocks all of them down."
    if (m := _COLLISION.match(text)) and not _verb(m["rest"]):
        how = f" {m['how']}" if m["how"] and m["how"].lower() == "head-on" else ""
        return f"{m['two']} collide{how}{m['rest']}"
    if (m := _CRASH.match(text)) and not _verb(m["rest"]):
        noun = lex.nouns().get(m["what"].lower())
        if noun is not None and noun.kind in _DRIVEN:
            return f"Two {lex.plural(m['what'])} collide{m['rest']}"
    if (m := _DOMINO.match(text)) and not _verb(m["rest"]):
        return f"{m['row']} stand in a row{m['rest'].rstrip('. ')} and topple one after another."
    return text


def _verb(text: str) -> bool:
    """Whether a finite verb is among the words."""
    words = re.findall(r"[a-z'-]+", text.lower())
    return any(r.form in ("s", "past") for w in words for r in verb_readings(w))


def heading(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Shopping cart race: two carts ...": nothing before the colon is a thing of its own.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
        i: Where to look.
        out: The elements before it; takes a word for the heading.

    Returns:
        How many elements it takes; 0 if there is no heading.
    """
    if i or out:
        return 0
    colon = next((k for k, e in enumerate(elements[: _LONGEST + 1]) if is_word(e, ":")), 0)
    head, rest = elements[:colon], elements[colon + 1 :]
    told = any(isinstance(e, Verb) and e.form in ("s", "past", "base") for e in rest)
    named = any(isinstance(e, Mention) for e in rest[:4])
    if not head or not told or not named or not any(map(_label, head)):
        return 0
    if any(is_word(e, ".", ";", "!", "?") for e in head):
        return 0
    does = [isinstance(e, Verb) and e.form not in ("pp", "ing") for e in head]
    if any(does[:-1]) or getattr(head[-1], "form", "") == "s":
        return 0  # "Two boys throw stones at a can: ..."
    out.append(Word(head[0].start, elements[colon].end, "adv", "heading"))
    return colon + 1


def _label(e: Element) -> bool:
    if isinstance(e, Mention):
        return e.head in _LABELS and not e.amounts
    return (e.lemma if isinstance(e, Verb) else e.low) in _LABELS
