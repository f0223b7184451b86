"""What kind of scene a text is about, where words mean something else in it."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex

_CRICKET = re.compile(rf"\b(?:{'|'.join(sorted(lex.word_set('cricket')))})\b", re.IGNORECASE)
_NET_SPORTS = re.compile(
    r"\b(?:volleyball|tennis|badminton|shuttlecock|ping[- ]pong|serves?|spiked)\b", re.IGNORECASE
)
_BILLIARDS = re.compile(
    r"\b(?:snooker|billiards?|pool (?:table|ball|player|cue)|cue ball|pots|potted|pocket)\b",
    re.IGNORECASE,
)

_APART = re.compile(
    rf"\b(?:{'|'.join(sorted(lex.word_set('breaking (senses)')))})(?:s|es|ed|ing)?\b"
    r"|\b(?:broke|smashing|splitting)\b",
    re.IGNORECASE,
)


def is_net_sport(text: str) -> bool:
    """Whether a game over a net is played."""
    return _NET_SPORTS.search(text) is not None


def is_billiards(text: str) -> bool:
    """Whether billiards is played."""
    return _BILLIARDS.search(text) is not None


def is_cricket(text: str) -> bool:
    """Whether cricket is played."""
    return _CRICKET.search(text) is not None


def comes_apart(text: str) -> bool:
    """Whether something is told to break, so that its pieces are no things of their own."""
    return _APART.search(text) is not None
