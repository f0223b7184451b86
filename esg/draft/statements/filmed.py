"""How the prompt says that the scene is filmed, as statements (words: `esg.draft.text.filming`)."""

from __future__ import annotations

from collections.abc import Sequence
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of
from esg.draft.discourse.record import Discourse
from esg.draft.document.coverage import FILMED
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.statements.account import nodes_of
from esg.draft.text.elements import Element, Mention
from esg.draft.text.filming import Words, said
from esg.graph.filming import agree
from esg.graph.models import Filming, Predicate, Statement

ONE_SHOT = "the scene is one shot, and more is said of the camera"
AT_ONCE = "all moves of the camera are made at once"
_WAY = "what the camera passes is not held"
_PREPOSITION = re.compile(
    r"\s+(?P<words>across|over|along|through|past|between|above|below|under|beneath|into|inside|"
    r"behind|in front of|beside|onto|out of|down|up|from)\s",
    re.IGNORECASE,
)
_BESIDE = "only the view itself is held"
_STANDS = "nothing moves that the camera could follow"
_NOT_THERE = "nothing in the scene stands for what the camera is about"
_ABOUT: frozenset[Filming] = frozenset(
    {"first_person", "over_shoulder", "follows", "from_front", "from_behind", "from_side",
     "close_up", "extreme_close_up", "medium", "orbits"}
)  # fmt: skip
"""What means nothing without somebody or something that it is about."""
_SIZES: frozenset[Filming] = frozenset({"close_up", "extreme_close_up", "medium"})
_OF_SCENES: frozenset[Filming] = frozenset({"slow_motion", "time_lapse"})
"""What is of the scene as a whole."""
_MOVES: frozenset[Filming] = frozenset(
    {"follows", "zooms_in", "zooms_out", "moves_forward", "moves_backward", "moves_left",
     "moves_right", "moves_up", "moves_down", "pans_left", "pans_right", "tilts_up", "tilts_down",
     "orbits"}
)  # fmt: skip
"""Moves of the camera: all that are told are made at once."""
_OF = re.compile(
    r"\s*,?\s*(?:(?:shots?|view|footage|video|clip|perspective)\s+)?"
    r"(?:of|on|in on|from|following|showing|shows|around|with|to|towards?|capturing)?\s+",
    re.IGNORECASE,
)
"""Between such words and what they are about."""
_SMALL = (
    lex.DETERMINERS | lex.PREPOSITIONS | frozenset({"and", "it", "then", "camera", "view", "shot"})
)


def set_filming_apart(clauses: Clauses, text: str) -> None:
    """Marks clauses and noun phrases of the camera: nothing happens and no thing is named there.

    Args:
        clauses: Of the prompt; their frames and mentions are marked.
        text: That they were read from.
    """
    for w in said(text):
        for f in clauses.frames:
            if w.start <= f.verb.start and f.verb.start < w.end:
                f.unreal = f.unreal or "how it is filmed"  # "a low angle shot"
        for m in clauses.mentions:
            if m.start < w.end and w.start < m.end <= w.end:
                # "A bird's eye view": no bird; "in front of her".
                m.attribute, m.possessor, m.pronoun = True, None, ""


def how_filmed(d: Discourse, elements: Sequence[Element]) -> tuple[Statement, ...]:
    """What a prompt says of how it is filmed, held or owned up to, numbered from 1.

    Args:
        d: The discourse, with all of its things; its record of used words takes note.
        elements: What the text was read as.
    """
    told = [w for w in said(_told(d)) if not _is_thing(d, w)]
    acting = _acting(d) if told else ()
    if not acting:
        return ()
    told = sorted([*told, *_facing(d, told, acting)], key=lambda w: w.start)
    kept: list[tuple[Words, tuple[str, ...]]] = []
    out: list[Statement] = []
    for number, w in enumerate(told, 1):
        about = _about(d, w, acting)
        why = _lacks(w, about, [word for word, _ in kept])
        if w.filming == "follows" and not why and not d.timeline.tracks:
            why = _STANDS
        held = about is not None and not why
        if about is not None and held:
            kept.append((w, about))
            inside = ((e.start, e.end) for e in elements if w.start <= e.start and e.end <= w.end)
            for place in ((w.start, w.end), *inside):
                d.scene.used.setdefault(place, FILMED)
        out.append(
            Statement(
                id=f"s{number}", text=_told(d)[w.start : w.end], start=w.start, end=w.end,
                predicate=Predicate.FILMED if held else Predicate.NOT_REPRESENTED,
                filming=w.filming if held else None,
                object=about if about is not None and held else (),
                note=why,
            )
        )  # fmt: skip
        out += _past(d, w, told)
    return (*out, *_beside(d, told, elements))


def _beside(d: Discourse, told: Sequence[Words], elements: Sequence[Element]) -> list[Statement]:
    """ "An overhead view in a plane": what was read with such words and is not held by them."""
    out: list[Statement] = []
    for e in elements:
        ends = [w.end for w in told if e.start <= w.start and w.end < e.end]
        if isinstance(e, Mention) or not ends:
            continue
        start, end = max(ends), e.end
        words = re.findall(r"[\w'-]+", _told(d)[start:end].lower())
        if set(words) <= _SMALL:
            continue
        start += len(_told(d)[start:end]) - len(_told(d)[start:end].lstrip(" ,"))
        out.append(
            Statement(
                id="s0", text=_told(d)[start:end], start=start, end=end,
                predicate=Predicate.NOT_REPRESENTED, note=_BESIDE,
            )
        )  # fmt: skip
    return out


def _told(d: Discourse) -> str:
    """The text before words were taken out of it, which keep their places."""
    return d.scene.fillings.told or d.text


_FACING: dict[str, Filming] = {"in front of": "from_front", "behind": "from_behind"}


def _facing(d: Discourse, told: Sequence[Words], acting: tuple[str, ...]) -> list[Words]:
    """ "Moves backward in front of the man" who acts: where the camera is."""
    out: list[Words] = []
    for w in told:
        prep = _PREPOSITION.match(_told(d), w.end) if w.moves else None
        way = _FACING.get(prep["words"].lower()) if prep else None
        if prep is None or way is None:
            continue
        for m in d.mentions:
            if m.start <= prep.end() + 1 and prep.end() < m.end and {*nodes_of(d, m)} == {*acting}:
                out.append(Words(prep.start("words"), m.end, way))
    return out[:1]


def _past(d: Discourse, w: Words, told: Sequence[Words]) -> list[Statement]:
    """ "Pans left across the rooftops": where else the camera goes, which is not held."""
    prep = _PREPOSITION.match(_told(d), w.end) if w.moves else None
    if prep is None or any(o.start < prep.end() and prep.start() < o.end for o in told):
        return []
    near = (m.end for m in d.mentions if m.start <= prep.end() + 1 and prep.end() < m.end)
    end = max(near, default=0)
    if not end:
        return []
    start = prep.start("words")
    if prep["words"].lower() == "from" and w.filming in ("zooms_out", "moves_backward"):
        return []  # "pulls back from the car"
    return [
        Statement(
            id="s0", text=_told(d)[start:end], start=start, end=end,
            predicate=Predicate.NOT_REPRESENTED, note=_WAY,
        )
    ]  # fmt: skip


def with_filming(
    text: str, others: Sequence[Statement], shown: Sequence[Statement]
) -> tuple[Statement, ...]:
    """All that is stated: what is owned up to of words of filming gives way to what is said there.

    Args:
        text: What was read.
        others: What is stated and owned up to beside it.
        shown: What is said of how it is filmed.
    """
    number = max((int(s.id[1:]) for s in others), default=0)
    rest = [s for s in others if not _answered(text, s, shown)]
    owned = [(s.start, s.end) for s in rest if s.predicate is Predicate.NOT_REPRESENTED]
    said_twice = [
        s for s in shown
        if s.note == _WAY and any(a < s.end and s.start < b for a, b in owned)
    ]  # fmt: skip
    shown = [s for s in shown if s not in said_twice]
    mine = [s.model_copy(update={"id": f"s{number + k}"}) for k, s in enumerate(shown, 1)]
    return tuple(sorted((*rest, *mine), key=lambda s: s.start))


def _lacks(w: Words, about: tuple[str, ...] | None, kept: Sequence[Words]) -> str:
    """Why words of filming are not held beside those that are; nothing if they are."""
    if about is None:
        return _NOT_THERE
    if not all(agree(w.filming, other.filming) for other in kept):
        return ONE_SHOT
    earlier = any(o.end <= w.start and o.filming in _MOVES for o in kept)
    return AT_ONCE if w.later and earlier else ""


def _answered(text: str, s: Statement, told: Sequence[Statement]) -> bool:
    """Whether something is stated by words of filming and small words around them alone."""
    for w in told:
        if w.filming in _ABOUT and s.start == w.end + 1 and s.text.lower().startswith("of "):
            return True  # "a close-up of a cube"
        if s.start < w.end and w.start < s.end:
            rest = text[s.start : max(s.start, w.start)] + " " + text[min(w.end, s.end) : s.end]
            if all(word.lower() in _SMALL for word in re.findall(r"[\w'’-]+", rest)):
                return True
    return False


def _is_thing(d: Discourse, w: Words) -> bool:
    """Whether a thing of the scene was made of the words: "the camera falls off the table"."""
    return any(m.start < w.end and w.start < m.end and nodes_of(d, m) for m in d.mentions)


def _acting(d: Discourse) -> tuple[str, ...]:
    """Who moves first; what is named first where nothing moves."""
    for clause in d.scene.clauses:
        movers = tuple(i for i in clause.movers if i in d.world.entities)
        if movers:
            return movers
    named = [i for m in sorted(d.mentions, key=lambda m: m.start) for i in nodes_of(d, m)]
    things = [i for i in named if "structural" not in entity_of(d, i).noun.traits]
    return tuple((things or named)[:1])


def _about(d: Discourse, w: Words, acting: tuple[str, ...]) -> tuple[str, ...] | None:
    """The nodes that words are about; None if what they name is not in the scene."""
    if w.filming in _OF_SCENES:
        return ()
    m = _named(d, w)
    if m is None or m.pronoun:
        return acting
    found = tuple(dict.fromkeys(i for x in (m, *m.coordinated) for i in nodes_of(d, x)))
    things = tuple(i for i in found if "structural" not in entity_of(d, i).noun.traits)
    if things:
        return things
    if found:
        return acting  # "a wide shot of a street": who acts there
    bare = m.attribute and w.filming not in _SIZES  # "follows the action", not "a close-up of it"
    return None if w.filming in _ABOUT and not bare else acting


def _named(d: Discourse, w: Words) -> Mention | None:
    """The noun phrase right behind words and "of", "on" or a verb of showing."""
    of = _OF.match(_told(d), w.end)
    at = of.end() if of else w.end
    near = (m for m in d.mentions if w.end <= m.start and m.start <= at + 1)
    return min(near, key=lambda m: m.start, default=None)
