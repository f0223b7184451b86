"""Multiword expressions: every row of the table is read as it says."""

from __future__ import annotations

import csv

import pytest

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunker import chunk
from esg.draft.text.elements import Word
from esg.draft.text.multiwords import spelled
from esg.draft.text.tagging import pos_tags
from esg.draft.text.tokens import tokenize

with open(lex.DATA / "multiwords.csv", encoding="utf-8", newline="") as file:
    ROWS = list(csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE))


@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row['reads as']} ({row['kind']})")
def test_example_of_a_row_is_read_as_the_row_says(row: dict[str, str]) -> None:
    text = row["example"]
    expressions = {" ".join(w) for e in row["words"].split("|") for w in spelled(e)}
    read = {
        text[e.start : e.end].lower(): (e.kind, e.low)
        for e in chunk(text, tokenize(text, pos_tags(text)))
        if isinstance(e, Word)
    }
    told = expressions & read.keys()
    assert told, read
    assert all(read[words] == (row["kind"], row["reads as"]) for words in told)


def test_an_expression_may_leave_words_out_or_choose() -> None:
    assert list(spelled("in/at the very? end")) == [
        ("in", "the", "very", "end"), ("in", "the", "end"),
        ("at", "the", "very", "end"), ("at", "the", "end"),
    ]  # fmt: skip
