"""Nothing of a prompt is dropped in silence, whatever clauses are put together."""

from __future__ import annotations

import json
from pathlib import Path
import random
import re

import pytest

from esg.draft import draft
from esg.draft import lexicon as lex
from esg.draft.document.screening import screen
from esg.draft.text.tagging import pos_tags
from esg.draft.text.tokens import tokenize
from esg.draft.verbphrases import verb_readings
from esg.graph import verify
from esg.graph.models import EsgDocument
from esg.outcomes import UserError

PROMPTS = Path(__file__).resolve().parents[2] / "data" / "prompts"
LINKS = (". ", "; ", ", and ", ", then ", " and ", " while ", " until ", " after ", ", which ")
SMALL = (
    lex.ADVERBS
    | lex.PREPOSITIONS
    | lex.MODALS
    | lex.DETERMINERS
    | lex.PRONOUNS
    | lex.SUBORDINATORS
    | {"'s"}
)


def clauses() -> list[str]:
    rows = [
        json.loads(line)
        for file in sorted(PROMPTS.glob("*.jsonl"))
        for line in file.read_text(encoding="utf-8").splitlines()
    ]
    texts = [row["prompt"] for row in rows if row["split"] == "dev"]
    parts = [c.strip() for t in texts for c in re.split(r"[.;]|, then |, and |, which ", t)]
    return [c for c in parts if len(c.split()) > 2]


def recombined(seed: int, count: int) -> list[str]:
    """Random clauses of the corpus with random links; some lower case, some upper case."""
    rng = random.Random(seed)
    pool = clauses()
    out: list[str] = []
    for _ in range(count):
        text = rng.choice(pool)
        for _ in range(rng.randint(0, 3)):
            text += rng.choice(LINKS) + rng.choice(pool)
        case = rng.random()
        out.append(text.lower() if case < 0.1 else text.upper() if case < 0.13 else text)
    return out


def dropped(prompt: str, doc: EsgDocument) -> list[str]:
    """Quantities, nouns and verbs of the prompt (by lexicon or tagger) that nothing is about."""
    text = screen(prompt)
    told = (*doc.coverage.items, *(doc.statements or ()))
    known = {k for item in told for k in range(item.start, item.end)}
    lost: list[str] = []
    for token in tokenize(text, pos_tags(text)):
        if known & set(range(token.start, token.end)):
            continue
        word = token.kind == "word" and token.low not in SMALL
        content = token.tag in ("NOUN", "PROPN", "VERB") or bool(verb_readings(token.low))
        content = content or lex.singular(token.low)[0] in lex.nouns()
        if token.kind == "qty" or (word and content):
            lost.append(token.text)
    return lost


@pytest.mark.parametrize("seed", range(4))
def test_every_content_word_of_recombined_clauses_is_accounted_for(seed: int) -> None:
    """Put every noun, verb and quantity into the coverage record, or refuse the prompt."""
    for prompt in recombined(seed, 120):
        try:
            doc = draft(prompt)
        except UserError:
            continue
        assert dropped(prompt, doc) == [], prompt


@pytest.mark.slow
def test_recombined_clauses_hold_the_rules() -> None:
    """Draft almost all random stories without a violation; contradictory times may remain."""
    codes: list[str] = []
    prompts = recombined(77, 250)
    for prompt in prompts:
        try:
            codes += [v.code for v in verify(draft(prompt))]
        except UserError:
            continue
    assert set(codes) <= {"TIME_ORDER", "CONSTRAINT_CONTRADICTION"}
    assert len(codes) <= 0.02 * len(prompts)


def test_what_is_not_understood_is_a_warning() -> None:
    """Name every item that is not understood in a warning."""
    doc = draft("A ball hits a box 17 s before the frobnication, and the gromble zorbs the box.")
    missing = [i.text for i in doc.coverage.items if i.status == "not_understood"]
    assert missing
    for text in missing:
        assert any(text in warning for warning in doc.coverage.warnings), text


@pytest.mark.parametrize(
    ("prompt", "act"),
    [
        ("Startled by a train, a cow breaks through the fence.", "Startled"),
        ("A ball rolls because somebody has greased the wedge.", "greased"),
        ("A car drives past a man who is filming.", "filming"),
        ("A trolley hits an IV stand, and the IV stand tips over onto a bed.", "tips"),
    ],
)
def test_an_unknown_word_that_acts_is_a_verb_that_was_dropped(prompt: str, act: str) -> None:
    kinds = {i.text: (i.kind, i.status) for i in draft(prompt).coverage.items}
    assert kinds[act] == ("event", "not_understood")


def test_an_unknown_word_that_describes_is_no_verb() -> None:
    items = draft("A fire engine stops next to a gurgling house.").coverage.items
    assert ("gurgling", "modifier") in [(i.text, i.kind) for i in items]


def test_places_of_words_are_those_of_the_prompt_as_typed() -> None:
    prompt = "A block slides with v = 3 m/s towards a box (m = 4 kg) and hits it 2 s later."
    doc = draft(prompt)
    assert not verify(doc)
    later = [i for i in doc.coverage.items if i.text in ("later", "2 s", "4 kg", "hits")]
    assert later and all(prompt[i.start : i.end] == i.text for i in later)
