"""What a prompt tells without asserting it: wishes, attempts, conditions, near misses.

"The goalkeeper wants to stop the ball", "it would have hit the wall", "before it can hit the car"
name events that do not happen. Their frames stay, because later pronouns refer to what they name;
the interpreter makes no events of them.
"""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame

NEAR = re.compile(
    r"\b(?:almost|nearly|practically|all but)\s+(?:(?!immedi|instant|direct|simult)\w+ly\s+)?$",
    re.IGNORECASE,
)
_IN_GROUP = re.compile(r"\b(?:almost|nearly)\b", re.IGNORECASE)
_NEVER = re.compile(r"\bnever\s+(?:\w+ly\s+)?$", re.IGNORECASE)
_ABOUT_TO = re.compile(r"\b(?:about|unable|too\s+\w+|reluctant|afraid)\s*$", re.IGNORECASE)
_WAS_MEANT_TO = re.compile(
    r"\b(?:was|were)\s+(?:only\s+|originally\s+|actually\s+)?(?:supposed|meant|intended)\s*$",
    re.IGNORECASE,
)
_MEANT_TO = re.compile(r"\b(?:supposed|meant|expected|intended)\s*$", re.IGNORECASE)
_BUT = re.compile(r"\b(?:but|yet|though|although|only to)\b|;\s*however\b", re.IGNORECASE)
_TURNED_OUT = re.compile(
    r"\b(?:instead|however|unfortunately|luckily|fortunately)\b", re.IGNORECASE
)
_COUNTERFACTUAL = re.compile(
    r"\b(?:should|would|could|might)(?:n[\u2019']t)?\s+(?:\w+\s+)?have\b|\bought to have\b",
    re.IGNORECASE,
)
_ENDS = re.compile(r"[.;!?\n]")
_NOBODY = re.compile(r"\b(?:nobody|no[ -]one)\s+$", re.IGNORECASE)
_NONE_OF = re.compile(r"none\s+of\b", re.IGNORECASE)
_STOPS_DOING = re.compile(
    r"\s+(?:(?:pedall?|accelerat|push|kick|paddl|row|pull|steer|swing|blow|sweep|pump|brak|talk"
    r"|play|bark|wav|danc|laugh|sing|shak|wobbl|swerv)ing)\b",
    re.IGNORECASE,
)
_NO_ONE = re.compile(r"\bno[ -]one$", re.IGNORECASE)

_WISHES = lex.word_set("wishes")
_ATTEMPTS = lex.word_set("attempts")
_TRIED_IS_DONE = lex.word_set("tried is done")
_EVENTS = lex.word_set("events (modality)")
_SHOWING = lex.word_set("showing (modality)")
_DOES = lex.word_set("does")
_SPEAKERS = lex.word_set("speakers")


def mark_unreal(frames: list[Frame], text: str) -> None:
    """Marks frames that the prompt names and does not assert; near misses become negated hits.

    Args:
        frames: Frames of the prompt, in any order; their `unreal` and `verb.negated` are set.
        text: The prompt.
    """
    told = sorted(frames, key=lambda f: f.verb.start)
    for k, f in enumerate(told):
        seen = f.subject is not None and f.subject.head in ("camera", "viewer", "video", "shot")
        if seen and f.subject is not None and f.verb.lemma in _SHOWING:
            f.subject.attribute, f.unreal = True, "how it is filmed"
            continue
        earlier = [g for g in told[:k] if g.sentence == f.sentence]
        later = [g for g in told[k + 1 :] if g.sentence == f.sentence]
        true = _comes_true(f, told[k + 1 : k + 2], text)
        reason = "" if true else _reason(f, earlier, later, text)
        if reason:
            f.unreal = reason
        if f.subject is not None and _NONE_OF.match(text, f.subject.start):
            f.verb.negated = True
        if f.verb.sense == "stop" and _STOPS_DOING.match(text, f.verb.end):
            f.unreal = "it stops doing something, not moving"
        if _NEVER.search(text, max(0, f.verb.start - 24), f.verb.start):
            f.verb.negated = True
        if true:
            f.link = "then"
            continue
        close = NEAR.search(text, max(0, f.verb.start - 24), f.verb.start)
        if close or _IN_GROUP.search(text, f.verb.start, f.verb.end):
            if f.verb.sense == "hit":
                f.verb.negated = True
            elif f.verb.sense in _EVENTS and f.verb.sense != "miss":
                f.unreal = "almost: it does not happen"
        if f.subject is not None and (
            f.subject.head in ("nothing", "nobody") or _NO_ONE.search(text, 0, f.subject.end)
        ):
            f.unreal = "nothing does it"
        if f.subject is None and _NOBODY.search(text, max(0, f.verb.start - 12), f.verb.start):
            f.unreal = "nobody does it"


def _reason(f: Frame, earlier: list[Frame], later: list[Frame], text: str) -> str:
    """Why a frame is not asserted; "" if it is."""
    if _COUNTERFACTUAL.search(text, f.verb.start, f.verb.end):
        return "it did not happen"
    if f.verb.sense not in _EVENTS and f.verb.sense not in ("own", "roll", "slide", "fly"):
        return ""
    if _ends_in(f, text):
        f.link = "then"
        return ""
    before = text[max(0, f.verb.start - 40) : f.verb.start]
    contrast = _contrast(f, text)
    modal = f.verb.modal
    if modal in ("would", "could") and not _polite(f, earlier):
        return f'"{modal}": a possibility'
    if modal in ("should", "might", "may", "must", "can") and contrast:
        return f'"{modal}": a possibility'
    if f.subordinate == "before" and modal in ("can", "could"):
        return "it is prevented"
    if f.verb.infinitive and _ABOUT_TO.search(before):
        return "about to: it does not happen yet"
    if f.verb.infinitive and _WAS_MEANT_TO.search(before):
        return "it was only meant to happen"
    if f.verb.infinitive and _MEANT_TO.search(before) and contrast:
        return "it was only meant to happen"
    if f.subordinate == "before" and _stopped_first(f, [*earlier[-1:], *later[:1]]):
        return "it stops before that"
    done = f.verb.sense in _TRIED_IS_DONE and f.verb.lemma != "dodge"
    if "tried" in f.verb.extra and not done:
        return "an attempt"
    governor = _governor(f, earlier)
    if governor is not None:
        lemma = governor.verb.lemma
        if lemma in _WISHES and not _spoken(governor):
            return "a wish"
        if lemma in _ATTEMPTS and not done:
            return "an attempt"
        purpose = f.link == "purpose" and f.causer is None and f.verb.sense != "miss"
        if purpose and contrast and governor.verb.sense not in ("be", "noop", "posture"):
            return "a purpose that is not reached"
    progressive = f.verb.form == "ing" and bool(f.verb.auxiliary)
    interrupted = any(g.subordinate == "when" for g in later[:1])
    if progressive and interrupted and f.verb.sense in ("overtake", "pass"):
        return "under way when something else happens"
    return ""


def _comes_true(f: Frame, following: list[Frame], text: str) -> bool:
    """ "is about to hit a deer, and it does": told to happen after all."""
    for g in following:
        again = g.object is not None and g.object.end <= f.verb.end + 60 and g.reduced
        bare = (g.object is None or again) and not g.phrases and not g.verb.negated
        does = (text[g.verb.start : g.verb.end].lower().split() or [""])[0] in _DOES
        return bare and does and g.sentence <= f.sentence + 1 and g.subject is not None
    return False


def _ends_in(f: Frame, text: str) -> bool:
    """ "glances off one bumper only to fetch up against the other": what happens next."""
    return f.verb.infinitive and text[: f.verb.start].rstrip().lower().endswith("only")


def _governor(f: Frame, earlier: list[Frame]) -> Frame | None:
    """The verb that an infinitive depends on, coordinated ones included."""
    if not f.verb.infinitive:
        return None
    return f.parent or f.causer or (earlier[-1] if earlier else None)


def _spoken(governor: Frame) -> bool:
    """ "I want a ball to hit a pin": what the user asks for is what happens."""
    subject = governor.subject
    return subject is None or subject.pronoun in _SPEAKERS


def _polite(f: Frame, earlier: list[Frame]) -> bool:
    """ "I would like a ball to hit a box"."""
    speaker = f.subject is not None and f.subject.pronoun in _SPEAKERS
    return speaker or f.verb.lemma in ("like", "love", "want")


def _stopped_first(f: Frame, near: list[Frame]) -> bool:
    """ "stops before it reaches the wall": what has stopped gets no further."""
    main = next((g for g in near if g.subordinate != "before"), None)
    if main is None or main.verb.negated:
        return False
    down = main.verb.sense in ("fall", "topple") and f.verb.sense == "reach"
    back = main.verb.extra.get("dir") in ("around", "back", "u") or main.verb.sense == "reverse"
    if (
        back
        and main.verb.sense in ("turn", "reverse")
        and f.verb.sense in ("hit", "reach", "enter")
    ):
        return True  # "turns around before it reaches the wall"
    if main.verb.sense != "stop" and not (down and main.subject is f.subject):
        return False
    return f.verb.sense in ("hit", "reach", "enter", "fall", "own", "knock", "topple")


def _contrast(f: Frame, text: str) -> bool:
    """Whether what follows takes it back: "..., but", or "instead" in the next sentence."""
    end = _ENDS.search(text, f.verb.end)
    stop = end.start() if end else len(text)
    if _BUT.search(text, f.verb.end, stop):
        return True
    following = _ENDS.search(text, stop + 1)
    return bool(_TURNED_OUT.search(text, f.verb.end, following.start() if following else len(text)))
