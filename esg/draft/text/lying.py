"""How things lie and stand, taken out of the text: on their side, upside down, overturned.

"A bottle lies on its side on a table" is read as "a bottle lies on a table", how it lies beside it:
the words are blanked before anything is read, every other word stays where it stands. Of what gets
so in the course of a scene ("lands upside down", "falls onto its side") the act stays in the text.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.text.alternatives import Blank, Places, any_of, taken
from esg.draft.text.shown import BEFORE
from esg.lexicon.lying import pose_said


@dataclass(frozen=True)
class Lain:
    """Words that say how a thing lies or stands.

    Args:
        pose: Row of the table of poses.
        start, end: Where they stand.
        about: Where the noun of the thing begins; `BEFORE`: whatever the clause there is about.
        at_last: It gets so; else it is so from the start.
    """

    pose: str
    start: int
    end: int
    about: int = BEFORE
    at_last: bool = False


_BE = {"is": "stands", "was": "stands", "are": "stand", "were": "stand"}
_IS_SO = (
    r"is|are|was|were|lies|lie|lay|lain|lying|laying|rests?|rested|resting|sits?|sat|sitting|"
    r"stands?|stood|standing|left|parked|(?:(?:is|are)\s+)?(?:placed|laid|positioned)|"
    r"balanced|balances|balancing|leans"
)
_GETS_SO = (
    r"lands?|landed|landing|(?:ends?|ended|ending|winds?|wound|finish(?:es)?)(?:\s+up)?"
    r"(?:\s+(?:lying|resting|sitting|standing))?|(?:comes?|coming|came)\s+to\s+(?:a\s+)?"
    r"(?:rest|stop|halt)|settles?|stops|"
    r"(?:(?:falls?|fell|falling|tips?|tipped|tipping|rolls?|rolled|rolling|flips?|flipped|flipping|"
    r"turns?|turned|turning|topples?|toppled|toppling|tumbles?|knocked|pushed|thrown|drops?)"
    r"(?:\s+(?:over|down))?)"
)
_ACTS = re.compile(r"(?:fall|fell|tip|roll|flip|turn|toppl|tumbl|knock|push|thrown|drop)", re.I)
"""Acts of which it is the end: they stay in the text as they are."""
_PUTS = (
    r"(?:puts?|putting|places?|placed|placing|sets?|setting|lays?|laying|stands?|lands?|turns?|"
    r"turning|flips?|flipping|tips?|tipping|knocks?|knocking|pushes|push)"
)
_DET = r"(?:an?|the|one|two|three|four|five|several|some|his|her|its|their|another|this|that)"
_FINDS = re.compile(
    r"\b(?:see|sees|finds?|shows?|showing|leaves|with|of|there\s+(?:is|are))\b", re.I
)
_ALONE = frozenset({"upside down", "face down", "face up", "on its side", "on its edge"})
"""Poses told right after a noun, too: "a mug upside down", "a barrel on its side"."""
_ADJECTIVES = (
    r"overturned|upturned|upended|capsized|upside[ -]down|inverted|toppled|fallen|"
    r"(?:tipped|knocked|flipped|toppled|turned)-over"
)
_SMALL = lex.PREPOSITIONS | lex.DETERMINERS
_AGENT = re.compile(r"\s+(?:by|from|into|when|as|because)\b", re.I)
_HELD = frozenset({"on its edge", "on end", "upright"})
"""Poses that nothing falls into."""
_UNTIL = re.compile(r"\buntil\b[^.,;]*$", re.I)
_LATER = re.compile(r"\b(?:after|when|once|until|if|because|since|before)\b[^.,;]*$", re.I)


def take_lying(text: str, nouns: Sequence[int], blank: Blank) -> list[Lain]:
    """Reads and takes out of a text how things lie and stand.

    Args:
        text: A prompt as it was screened.
        nouns: Where words begin that are nouns.
        blank: Puts other words, no longer than they are, in the place of some.
    """
    if not _any_words().search(text):
        return []
    return taken((found for read in _READERS for found in read(text, nouns)), blank)


def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern, re.IGNORECASE)


@cache
def _words() -> str:
    onto = [w.replace("on ", "onto ", 1) for w in pose_said() if w.startswith("on ")]
    listed = any_of([*pose_said(), *onto]).replace(r"\ ", r"\s+")
    return rf"(?P<words>(?:lying\s+)?(?:{listed}))\b"


@cache
def _any_words() -> re.Pattern[str]:
    return _compiled(rf"\b(?:{_words()}|{_ADJECTIVES}|been\s+\w+\s+over|overturned|toppled)")


def _pose(words: str) -> str:
    plain = re.sub(r"\s+", " ", words.lower()).removeprefix("lying ")
    plain = re.sub(r"^onto\b", "on", plain)
    said = pose_said()
    return said.get(plain) or said.get(plain.replace("-", " ")) or "upside down"


_BOUND: dict[str, re.Pattern[str]] = {
    "flat": re.compile(r"(?:lies|lie|lay|lying|laying|rests?|resting|lands?|falls?|rest)$", re.I),
    "upright": re.compile(r"(?:stand|stood|land|rest$|balanc|plac|end|wind|sit|is$|are$)", re.I),
    "overturned": re.compile(r"(?:lies|lie|lay|lying|rests?|resting|sits?|stands?|left)$", re.I),
    "tipped over": re.compile(r"(?:lies|lie|lay|lying|rests?|resting|left)$", re.I),
    "on its back": re.compile(r"(?:lies|lie|lay|lying|lands?|falls?|ends? up|rest)", re.I),
    "on its roof": re.compile(
        r"(?:lies|lie|lay|lying|rest|land|end|wind|over|flip|roll|stop)", re.I
    ),
}
"""Verbs that words of a pose need before them: "is overturned by a wave" is an act."""


def _after_verbs(text: str, nouns: Sequence[int]) -> Iterator[tuple[Lain, Places]]:
    """ "Lies on its side", "is upside down", "lands on its roof", "falls onto its side"."""
    pattern = _compiled(
        rf"\b(?P<verb>{_IS_SO}|{_GETS_SO})\s+(?:(?:\w+ly|still|now|almost|back)\s+)?{_words()}"
    )
    for m in pattern.finditer(text):
        pose, verb = _pose(m["words"]), m["verb"].lower()
        bound = _BOUND.get(pose)
        if (bound is not None and not bound.search(verb)) or _own_parts(text, m, pose):
            continue
        onto = m["words"].lower().startswith("onto")
        so = not onto and re.fullmatch(_IS_SO, verb, re.IGNORECASE) is not None
        rolls = re.match(r"(?:roll|turn)", verb) is not None and "over" not in verb
        if _ACTS.match(verb) and not onto and (rolls or pose in _HELD):
            continue  # "rolls on its edge" is how it rolls
        lain = Lain(
            pose, *m.span("words"), at_last=not so or bool(_UNTIL.search(text[: m.start()]))
        )
        if verb in _BE and so:
            yield lain, [(m.start("verb"), m.end("words"), _BE[verb])]
        elif _ACTS.match(verb) or (pose == "on its side" and not so):
            yield lain, []  # that it falls over is read from it
        else:
            up = re.fullmatch(r"\w+\s+up", verb) is not None
            yield lain, [(*m.span("words"), "lying" if up else "")]


def _own_parts(text: str, m: re.Match[str], pose: str) -> bool:
    """Whether a roof or a back is of what somebody is on: "a cat sits on its roof"."""
    if pose != "on its roof":
        return False
    words = re.findall(r"[a-z]+", text[: m.start("verb")].lower())
    told = (lex.nouns().get(w) for w in reversed(words))
    kind = next((n.kind for n in told if n is not None), "")
    return kind not in ("vehicle", "toyvehicle")


def _after_nouns(text: str, nouns: Sequence[int]) -> Iterator[tuple[Lain, Places]]:
    """ "A mug upside down on a table", "places a cup upside down"; "with a barrel on its side"."""
    noun = rf"(?P<det>\b{_DET}\s+)(?:[\w-]+\s+){{0,2}}?(?P<noun>[\w-]+)"
    pattern = _compiled(
        rf"{noun}\s+{_words()}(?=\s*(?:[.,;]|$)|\s+(?:on|in|at|next|beside|near|under|and|with|by|"
        r"while|so|between|behind)\b)"
    )
    for m in pattern.finditer(text):
        pose = _pose(m["words"])
        if pose not in _ALONE or m.start("noun") not in nouns:
            continue
        told = text[: m.start()]
        puts = _compiled(rf"\b{_PUTS}\s+(?:over\s+)?$").search(told)
        onto = m["words"].lower().startswith("onto")
        shows = not told.strip() or told.rstrip()[-1] in ".;:" or _FINDS.search(told[-14:])
        if puts is None and (onto or not shows):
            continue  # "hits a car on its side", "drops it on a car upside down"
        lain = Lain(pose, *m.span("words"), m.start("noun"), at_last=puts is not None)
        yield lain, [(*m.span("words"), "")]


def _before_nouns(text: str, nouns: Sequence[int]) -> Iterator[tuple[Lain, Places]]:
    """ "An overturned car", "a fallen tree"; one of the fallen pins has fallen in the scene."""
    pattern = _compiled(
        rf"\b(?:an?|one|two|three|four|several|some|another|past|past\s+the)\s+(?P<first>[\w-]+\s+)??"
        rf"(?P<words>{_ADJECTIVES})\s+"
    )
    for m in pattern.finditer(text):
        after = [at for at in nouns if m.end() <= at]
        head = next(iter(after), None)
        between = "" if head is None else text[m.end() : head].lower()
        if head is None or not re.fullmatch(r"(?:[\w-]+\s+){0,2}", between):
            continue
        if (m["first"] and m.start("first") in nouns) or {*between.split()} & _SMALL:
            continue  # "a mug upside down on a table"
        while (more := re.compile(r"\w+ (?=\w)").match(text, head)) and more.end() in after:
            head = more.end()
        words = m["words"].lower().replace("-over", " over")
        pose = _pose("upside down" if words == "inverted" else words)
        yield Lain(pose, *m.span("words"), head), [(*m.span("words"), "")]


def _has_been(text: str, nouns: Sequence[int]) -> Iterator[tuple[Lain, Places]]:
    """ "A cone has been tipped over": it lies there; what it was by has not yet happened."""
    pattern = _compiled(
        r"\b(?P<words>(?P<has>has|have|had)\s+(?:just\s+|already\s+)?been\s+(?:(?P<down>tipped|"
        r"knocked|pushed|blown|toppled)\s+over|overturned|toppled|(?:flipped|turned)\s+"
        r"(?:over|upside\s+down)))\b"
    )
    for m in pattern.finditer(text):
        if _AGENT.match(text, m.end()) or _LATER.search(text[: m.start()]):
            continue
        pose = "tipped over" if m["down"] or "toppled" in m["words"] else "overturned"
        instead = "stands" if m["has"].lower() != "have" else "stand"
        yield Lain(pose, *m.span("words")), [(*m.span("words"), instead)]


_READERS: tuple[Callable[[str, Sequence[int]], Iterator[tuple[Lain, Places]]], ...] = (
    _has_been,
    _before_nouns,
    _after_verbs,
    _after_nouns,
)
