"""What a prompt tells without asserting it: wishes, attempts, conditions, near misses.

"The goalkeeper wants to stop the ball", "it would have hit the wall", "before it can hit the car"
name events that do not happen. Their frames stay, because later pronouns refer to what they name;
the interpreter makes no events of them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import re

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame

NEAR = re.compile(
    r"\b(?:almost|nearly|practically|all but)\s+(?:(?!immedi|instant|direct|simult)\w+ly\s+)?$",
    re.IGNORECASE,
)
_IN_GROUP = re.compile(r"\b(?:almost|nearly)\b", re.IGNORECASE)
_NEVER = re.compile(
    r"\b(?:never|no longer)\s+(?:\w+ly\s+)?$"
    r"|(?:n't|\bnot|\bnever|\bwithout)\s+(?:let|letting|allow|allowing)\s+(?:[\w'-]+\s+){1,4}$",
    re.IGNORECASE,
)
"""What denies the verb behind it: "never falls", "don't let the lamp fall"."""
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
_HARDLY = re.compile(r"\b(?:hardly|scarcely|barely)\s+$", re.IGNORECASE)
_STIRS = frozenset({"move", "budge", "stir", "shift", "bounce", "wobble"})
"""Verbs that "hardly" denies, as far as one sees: "the middle one hardly moves"."""
FAILED = "an attempt that fails"
STOPPED_FIRST = "it stops before that"
_IN_VAIN = re.compile(
    r"\b(?:in vain|to no avail|without (?:any )?success|unsuccessfully|too heavy)\b", re.IGNORECASE
)
_ENDS = re.compile(r"[.;!?\n]")
_NOBODY = re.compile(r"\b(?:nobody|nothing|no[ -]one)\s+$", re.IGNORECASE)
_NONE_OF = re.compile(r"(?:none|neither)\s+of\b", re.IGNORECASE)
_NONE_OF_WHICH = re.compile(
    r"\b(?:none|neither)\s+of\s+(?:which|whom|these|those)\s+$", re.IGNORECASE
)
_STOPS_DOING = re.compile(
    r"\s+(?:(?:pedall?|accelerat|push|kick|paddl|row|pull|steer|swing|blow|sweep|pump|brak|talk"
    r"|play|bark|wav|danc|laugh|sing|shak|wobbl|swerv)ing)\b",
    re.IGNORECASE,
)
_NO_ONE = re.compile(r"\bno[ -]one$", re.IGNORECASE)

NOBODY_DOES, _NOTHING_DOES = "nobody does it", "nothing does it"
_MOTIONS = frozenset({"cross", "own", "roll", "slide", "fly", "posture"})
"""Senses that make no event, and are asked all the same whether they happen."""
_WISHES = lex.word_set("wishes")
_ATTEMPTS = lex.word_set("attempts")
_TRIED_IS_DONE = lex.word_set("tried is done")
_EVENTS = lex.word_set("events (modality)")
_CAST = lex.word_set("cast (noun heads)")
_HOW_FILMED = lex.word_set("how it is filmed")
_SHOWING = lex.word_set("showing (modality)")
_DOES = lex.word_set("does")
_TOUCHES = lex.word_set("touches")
_SPEAKERS = lex.word_set("speakers")


def _none_of(text: str, start: int) -> bool:
    """ "None of the pins", "not one of the pins"."""
    one = text[:start].lower().endswith("not ") and text.lower().startswith("one of", start)
    return one or _NONE_OF.match(text, start) is not None


def _films(f: Frame, text: str) -> bool:
    """ "The camera pans", "the camera is fixed": how it is filmed, and no camera that is seen."""
    if f.verb.lemma in _SHOWING or f.verb.lemma in _HOW_FILMED:
        return True
    after = re.match(r"\s+(?:\w+ly\s+|completely\s+|all\s+)?([\w-]+)", text[f.verb.end :])
    state = f.verb.sense in ("be", "posture", "left_so")
    return state and after is not None and after[1].lower() in _HOW_FILMED


def mark_unreal(frames: list[Frame], text: str) -> None:
    """Marks frames that the prompt names and does not assert; near misses become negated hits.

    Args:
        frames: Frames of the prompt, in any order; their `unreal` and `verb.negated` are set.
        text: The prompt.
    """
    told = sorted(frames, key=lambda f: f.verb.start)
    for k, f in enumerate(told):
        if reason := _of_what_is_seen(f, text):
            f.unreal = reason
            continue
        earlier = [g for g in told[:k] if g.sentence == f.sentence]
        later = [g for g in told[k + 1 :] if g.sentence == f.sentence]
        true = _comes_true(f, told[k + 1 : k + 2], text)
        reason = "" if true else _reason(f, earlier, later, text)
        if reason:
            f.unreal = reason
        if _denied(f, text):
            f.verb.negated = True
        if f.verb.sense == "stop" and _STOPS_DOING.match(text, f.verb.end):
            f.unreal = "it stops doing something, not moving"
        if true:
            f.link = "then"
            continue
        if almost(f, text):
            if f.verb.sense == "hit":
                f.verb.negated = True
            elif f.verb.sense in _EVENTS | {"posture"} and f.verb.sense != "miss":
                f.unreal = "almost: it does not happen"
        if reason := _by_none(f, text):
            f.unreal = reason
            f.subject = f.subject if reason == _NOTHING_DOES else None  # no subject of before


def _of_what_is_seen(f: Frame, text: str) -> str:
    """Why a frame is only about the look of the scene; "" if it is not.

    What is filmed with names nothing there, and "its shadow moves across the roofs" moves nothing.
    """
    m = f.subject
    if m is None:
        return ""
    if m.head in ("camera", "viewer", "video", "shot") and _films(f, text):
        m.attribute = True
        return "how it is filmed"
    return "light and weather are not simulated" if m.attribute and m.head in _CAST else ""


def _denied(f: Frame, text: str) -> bool:
    """ "None of the pins falls", "never stops", "is hit by neither of them"."""
    met = [p.mention for p in f.phrases if p.prep in ("into", "against")]
    met = [f.object, *met] if f.verb.sense in _TOUCHES else []
    met += [p.mention for p in f.phrases if p.prep == "by" and f.verb.passive]
    if _NONE_OF_WHICH.search(text, max(0, f.verb.start - 24), f.verb.start):
        return True
    none = (f.subject if not f.relative else None, *met)
    if any(m is not None and _none_of(text, m.start) for m in none):
        return True
    if f.verb.lemma in _STIRS and _HARDLY.search(text, max(0, f.verb.start - 12), f.verb.start):
        return True
    return _NEVER.search(text, max(0, f.verb.start - 60), f.verb.start) is not None


def almost(f: Frame, text: str) -> bool:
    """ "Almost hits the wall", "very nearly falls"."""
    close = NEAR.search(text, max(0, f.verb.start - 24), f.verb.start)
    return bool(close or _IN_GROUP.search(text, f.verb.start, f.verb.end))


def _by_none(f: Frame, text: str) -> str:
    """Why what nothing and nobody does is not asserted; "" for other subjects."""
    m = f.subject
    denied = (m is None or f.verb.negated) and not f.verb.passive
    if denied and _NOBODY.search(text, max(0, f.verb.start - 12), f.verb.start):
        return NOBODY_DOES
    none = m is not None and (m.head in ("nothing", "nobody") or _NO_ONE.search(text, 0, m.end))
    return _NOTHING_DOES if none else ""


@dataclass(frozen=True)
class _Told:
    """A frame among those of its sentence, with what governs it and what takes it back."""

    frame: Frame
    earlier: list[Frame]
    later: list[Frame]
    before: str
    """Text right before the verb."""
    contrast: bool
    governor: Frame | None


def _reason(f: Frame, earlier: list[Frame], later: list[Frame], text: str) -> str:
    """Why a frame is not asserted; "" if it is."""
    if _COUNTERFACTUAL.search(text, f.verb.start, f.verb.end):
        return "it did not happen"
    if _unwanted(f, earlier):
        return "a wish"
    if _failed(f, earlier, later, text):
        return FAILED
    if f.verb.sense not in _EVENTS and f.verb.sense not in _MOTIONS:
        return ""
    if _ends_in(f, text):
        f.link = "then"
        return ""
    before = text[max(0, f.verb.start - 40) : f.verb.start]
    told = _Told(f, earlier, later, before, _contrast(f, text), _governor(f, earlier))
    return next((reason for applies, reason in _REASONS if applies(told)), "").format(
        modal=f.verb.modal
    )


def _failed(f: Frame, earlier: list[Frame], later: list[Frame], text: str) -> bool:
    """ "Tries to lift the box and fails", "tries in vain to lift it, but it does not budge"."""
    g = _governor(f, earlier)
    if "tried" not in f.verb.extra and (g is None or g.verb.lemma not in _ATTEMPTS):
        return False
    start, end = (g or f).verb.start, _ENDS.search(text, f.verb.end)
    if _IN_VAIN.search(text, start, end.start() if end else len(text)):
        return True
    fails = any(h.verb.lemma == "fail" and not h.verb.negated for h in later[:2])
    return fails or (_contrast(f, text) and any(h.verb.negated for h in later[:1]))


def _unwanted(f: Frame, earlier: list[Frame]) -> bool:
    """ "He didn't want to carry it": nobody carries it."""
    g = _governor(f, earlier)
    return g is not None and g.verb.negated and g.verb.lemma in _WISHES | _ATTEMPTS


def _possible(t: _Told) -> bool:
    modal = t.frame.verb.modal
    if modal in ("would", "could"):
        return not _polite(t.frame, t.earlier)
    return modal in ("should", "might", "may", "must", "can") and t.contrast


def _prevented(t: _Told) -> bool:
    return t.frame.subordinate == "before" and t.frame.verb.modal in ("can", "could")


def _about_to(t: _Told) -> bool:
    return t.frame.verb.infinitive and _ABOUT_TO.search(t.before) is not None


def _only_meant(t: _Told) -> bool:
    was = _WAS_MEANT_TO.search(t.before) or (t.contrast and _MEANT_TO.search(t.before))
    return t.frame.verb.infinitive and bool(was)


def _stopped_first(t: _Told) -> bool:
    """ "stops before it reaches the wall": what has stopped gets no further."""
    near = [*t.earlier[-1:], *t.later[:1]]
    main = next((g for g in near if g.subordinate != "before"), None)
    if t.frame.subordinate != "before" or main is None or main.verb.negated:
        return False
    event, does = t.frame.verb.sense, main.verb.sense
    back = main.verb.extra.get("dir") in ("around", "back", "u") or does == "reverse"
    if back and does in ("turn", "reverse") and event in ("hit", "reach", "enter"):
        return True  # "turns around before it reaches the wall"
    down = does in ("fall", "topple") and event == "reach" and main.subject is t.frame.subject
    ended = does == "stop" or down
    return ended and event in ("hit", "reach", "enter", "fall", "own", "cross", "knock", "topple")


def _only_tried(t: _Told) -> bool:
    verb, g = t.frame.verb, t.governor
    done = verb.sense in _TRIED_IS_DONE and verb.lemma != "dodge"
    tried = "tried" in verb.extra or (g is not None and g.verb.lemma in _ATTEMPTS)
    return tried and not done


def _wished(t: _Told) -> bool:
    """ "The goalkeeper wants to stop the ball"; "I want a ball to hit a pin" is what happens."""
    g = t.governor
    if g is None or g.verb.lemma not in _WISHES:
        return False
    return g.subject is not None and g.subject.pronoun not in _SPEAKERS


def _not_reached(t: _Told) -> bool:
    """ "brakes to stop at the line, but": what an act was for."""
    f, g = t.frame, t.governor
    purpose = f.link == "purpose" and f.causer is None and f.verb.sense != "miss"
    acts = g is not None and g.verb.sense not in ("be", "noop", "posture")
    return purpose and acts and t.contrast


def _interrupted(t: _Told) -> bool:
    verb = t.frame.verb
    progressive = verb.form == "ing" and bool(verb.auxiliary)
    when = any(g.subordinate == "when" for g in t.later[:1])
    return progressive and when and verb.sense in ("overtake", "pass")


_REASONS: tuple[tuple[Callable[[_Told], bool], str], ...] = (
    (_possible, '"{modal}": a possibility'),
    (_prevented, "it is prevented"),
    (_about_to, "about to: it does not happen yet"),
    (_only_meant, "it was only meant to happen"),
    (_stopped_first, STOPPED_FIRST),
    (_only_tried, "an attempt"),
    (_wished, "a wish"),
    (_not_reached, "a purpose that is not reached"),
    (_interrupted, "under way when something else happens"),
)
"""Why an event that is told does not happen: the first reason that applies."""


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


def _polite(f: Frame, earlier: list[Frame]) -> bool:
    """ "I would like a ball to hit a box"."""
    speaker = f.subject is not None and f.subject.pronoun in _SPEAKERS
    return speaker or f.verb.lemma in ("like", "love", "want")


def _contrast(f: Frame, text: str) -> bool:
    """Whether what follows takes it back: "..., but", or "instead" in the next sentence."""
    end = _ENDS.search(text, f.verb.end)
    stop = end.start() if end else len(text)
    if _BUT.search(text, f.verb.end, stop):
        return True
    following = _ENDS.search(text, stop + 1)
    return bool(_TURNED_OUT.search(text, f.verb.end, following.start() if following else len(text)))
