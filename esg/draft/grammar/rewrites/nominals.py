"""Nouns of events that a prompt has told before: "after that bump it falls"."""

from __future__ import annotations

from esg.draft import lexicon as lex

RETOLD_NOUNS = lex.word_set("retold nouns")
