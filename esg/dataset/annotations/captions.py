"""Captions at three lengths: what one sees, what happens in order, and all of it with numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from esg.dataset.annotations.clauses import (
    Clause,
    Story,
    event_clauses,
    hit_clauses,
    is_it,
    manner,
    manner_verb,
    merged,
    worded,
)
from esg.dataset.annotations.nouns import listed
from esg.dataset.annotations.wording import (
    Chooser,
    agreeing,
    metres,
    rows,
    sentence,
    three_digits,
)
from esg.engines.scene import FRAGMENT, GROUND
from esg.thresholds import MOVING_MPS

MEDIUM_CLAUSES = 5
LONG_CLAUSES = 12
"""Most that a caption tells; of more, the first."""
LATER_S = 1.0
"""A pause from which on it is said how long it was."""
SOON_S = 0.3
AT_FIRST_S = 0.05
MOST_STARTS = 3
GROUNDS = frozenset(("ground", "floor"))
"""What every scene stands on: told only if the prompt names it."""
MARKINGS = frozenset(("crossroad", "crosswalk", "road_marking"))
"""Categories of what is painted on a road or part of it: the road is the place."""


@dataclass(frozen=True)
class Captions:
    """Texts of a scene, and what they tell.

    Args:
        short, medium, long: The captions.
        events: Clauses of completed events, with their text.
    """

    short: str
    medium: str
    long: str
    events: tuple[tuple[Clause, str], ...]


def captions(story: Story, seed: str) -> Captions:
    """The captions of a scene.

    Args:
        story: The scene with what its replay shows.
        seed: Of the wording.
    """
    choose = Chooser(f"{seed}/captions")
    events = event_clauses(story)
    all_told = sorted([*events, *hit_clauses(story, events)], key=lambda c: c.time)
    told = merged(story, all_told)
    telling = _Telling(
        story, {c: choose.of(rows("clauses")[c.what]).template for c in (*told, *all_told)}
    )
    wanted = [c for c in told if c.event] or told
    return Captions(
        short=_short(telling, wanted),
        medium=_medium(telling, told[:MEDIUM_CLAUSES], choose),
        long=_long(telling, told[:LONG_CLAUSES], len(told), choose),
        events=tuple((c, sentence(telling.text(c))) for c in events),
    )


@dataclass(frozen=True)
class _Telling:
    """A scene and the wording that was chosen for every clause."""

    story: Story
    templates: Mapping[Clause, str]

    def text(self, c: Clause, names: Mapping[str, str] | None = None) -> str:
        return worded(self.story, c, self.templates[c], names)

    def predicate(self, c: Clause, names: Mapping[str, str]) -> str:
        """The clause without its subject, with the space before it."""
        return worded(self.story, c, self.templates[c].removeprefix("{a}"), names)

    def has_predicate(self, c: Clause) -> bool:
        """Whether the clause goes on without its subject."""
        simple = c.several == (1, 1) and not c.with_b
        return simple and self.templates[c].startswith("{a} ")

    def ends_with_object(self, c: Clause) -> bool:
        """Whether the clause's last word is its object, so that a `which` can follow."""
        return self.templates[c].endswith("{b}") and not c.with_b


class _Names:
    """Bodies by the names they have at that point of a text: new at first, then known."""

    def __init__(self, story: Story) -> None:
        self._story = story
        self._told: set[str] = set()
        self.subject = ""

    def of(self, name: str) -> str:
        """The body's name, which counts as told from now on."""
        nouns = self._story.nouns
        noun = nouns.noun(name)
        known = noun in self._told or name == GROUND
        self._told.add(noun)
        return nouns.the(name) if known else nouns.a(name)

    def introduce(self, names: Iterable[str]) -> None:
        """Counts bodies as known: an inventory has named them."""
        self._told |= {self._story.nouns.noun(n) for n in names}

    def fill(self, clause: Clause, *, pronoun: bool = False) -> dict[str, str]:
        """Names for a clause; the subject of the sentence before is `it` if `pronoun` is set."""
        again = pronoun and clause.a == self.subject and is_it(self._story, clause.a)
        names = {"a": "it" if again else self.of(clause.a)}
        if clause.b:
            names["b"] = self.of(clause.b)
        self.subject = "" if clause.with_b or clause.several[0] > 1 else clause.a
        return names


def _short(telling: _Telling, told: Sequence[Clause]) -> str:
    """One sentence of the first and the last thing that happens besides moving."""
    doing = [c for c in told if c.what != "moves"]
    if len(doing) < 2:
        # A lone stop or turn is told of something that was seen to move before.
        alone = doing and (doing[0].impulse is not None or doing[0].b)
        doing = [c for c in told if not doing or c in doing or (not alone and c.a == doing[0].a)]
    if not doing:
        return _still(telling.story)
    first, last = doing[0], doing[-1]
    names = _Names(telling.story)
    text = telling.text(first, names.fill(first))
    return sentence(text if first is last else text + _joined(telling, first, last, names))


def _joined(telling: _Telling, before: Clause, c: Clause, names: _Names) -> str:
    """A second clause behind the first, without naming a subject that both have."""
    if telling.has_predicate(c):
        if c.a == before.a and telling.has_predicate(before):
            return " and" + telling.predicate(c, names.fill(c))
        if c.a == before.b and before.several[1] == 1 and telling.ends_with_object(before):
            which = "which" if is_it(telling.story, c.a) else "who"
            if telling.story.nouns.several(c.a) == 1:
                return f", {which}" + telling.predicate(c, names.fill(c))
    return ", and " + telling.text(c, names.fill(c))


def _still(story: Story) -> str:
    """What can be said of a scene in which no two bodies meet and no event is completed."""
    names = _Names(story)
    for name in _movers(story):
        text = f"{names.of(name)} {manner_verb(story, name)} along"
        return sentence(agreeing(text, plural=story.nouns.is_plural(name)))
    shown = story.nouns.inventory(_things(story))
    return sentence(f"{listed(shown)} can be seen") if shown else "Nothing can be seen."


def _movers(story: Story) -> list[str]:
    """Bodies that move at first, the fastest first."""
    motion = story.motion
    found = [
        i
        for i, b in enumerate(story.scene.bodies)
        if motion.whole[i] and b.collides and motion.moves_at_first(i)
    ]
    return [motion.names[i] for i in sorted(found, key=lambda i: -motion.speed[0, i])]


def _things(story: Story) -> list[str]:
    """Bodies that one can see and name: no ground, no road, no fragments."""
    return [b.name for b in story.scene.bodies if b.collides and b.category != FRAGMENT]


def _place(story: Story) -> str:
    """Where the scene is, with `on`: the widest of what lies on the ground, or the ground."""
    flat = [b for b in story.scene.bodies if not b.collides and b.label and b.category != FRAGMENT]
    named = [b for b in flat if b.mentioned or story.nouns.noun(b.name) not in GROUNDS]
    roads = [b for b in named if b.category not in MARKINGS] or named
    if not roads:
        return ""
    widest = max(roads, key=lambda b: (not b.name.startswith(GROUND), b.half_extents[0]))
    return f" on the {story.nouns.noun(widest.name)}"


def _connected(
    telling: _Telling, told: Sequence[Clause], choose: Chooser, names: _Names, *, begun: bool
) -> list[str]:
    """One sentence a clause, each with a word for when it happens."""
    out: list[str] = []
    for k, c in enumerate(told):
        lead = ""
        if k:
            pause = c.time - told[k - 1].time
            if pause >= LATER_S:
                lead = f"about {_seconds(pause)} later, "
            elif pause <= SOON_S:
                lead = choose.of(("right after that, ", "a moment later, "))
            else:
                lead = choose.of(("then, ", "after that, ", "next, "))
            if k == len(told) - 1 and k > 1 and pause < LATER_S and choose.below(2):
                lead = "finally, "
        elif len(told) > 1 and not begun and choose.below(2):
            lead = "first, "
        out.append(sentence(lead + telling.text(c, names.fill(c, pronoun=True))))
    return out


def _seconds(value: float) -> str:
    return f"{value:.1f} seconds" if value < 9.95 else f"{value:.0f} seconds"


def _medium(telling: _Telling, told: Sequence[Clause], choose: Chooser) -> str:
    story = telling.story
    names = _Names(story)
    lines: list[str] = []
    first = next(iter(_movers(story)), "")
    how = manner(story, first) if first else ""
    at_once = how == "fall" and any(c.what in ("falls", "falls_off", "lands") for c in told)
    if first and not at_once and not any(c.what == "moves" and c.time < AT_FIRST_S for c in told):
        where = "" if how in ("fall", "fly") else _place(story)
        text = f"{names.of(first)} {_along(story, first)}{where}"
        lines.append(sentence(agreeing(text, plural=story.nouns.is_plural(first))))
        names.subject = first
    lines += _connected(telling, told, choose, names, begun=bool(lines))
    if not lines:
        lines = [_still(story)]
        names.introduce(_things(story))
    return " ".join([*lines, *_ending(story, names)])


def _along(story: Story, name: str) -> str:
    verb = manner_verb(story, name)
    return verb if verb == "[fall]" else f"{verb} along"


def _loose(story: Story) -> list[int]:
    """Bodies that could move; none of them where something breaks, whose pieces nobody follows."""
    motion = story.motion
    loose = [
        i for i, b in enumerate(story.scene.bodies)
        if b.collides and not b.static and b.category != FRAGMENT
    ]  # fmt: skip
    return loose if all(motion.whole[i] for i in loose) else []


def _ending(story: Story, names: _Names) -> list[str]:
    """Whether everything lies still in the end, or what alone still moves."""
    motion, loose = story.motion, _loose(story)
    moving = [i for i in loose if not motion.at_rest(i)]
    if loose and not moving and any(motion.moved(i) for i in loose):
        return ["In the end, everything is at rest."]
    if len(moving) == 1 and motion.speed[-1, moving[0]] > MOVING_MPS:
        name = motion.names[moving[0]]
        text = f"in the end, {names.of(name)} [be] still moving"
        return [sentence(agreeing(text, plural=story.nouns.is_plural(name)))]
    return []


def _long(telling: _Telling, told: Sequence[Clause], n_told: int, choose: Chooser) -> str:
    story = telling.story
    names = _Names(story)
    lines: list[str] = []
    shown = story.nouns.inventory(_things(story))
    if shown:
        several = len(shown) > 1 or shown[0].split()[0] not in ("a", "an")
        there = "There are" if several else "There is"
        opening = choose.of(("The scene shows", there))
        lines.append(f"{opening} {listed(shown)}{_place(story)}.")
        names.introduce(_things(story))
    started, starts = _starts(story, names)
    lines += starts
    for c in told:
        if c.what == "moves" and c.time < AT_FIRST_S and c.a in started:
            continue
        strength = (
            "" if c.impulse is None else f", with an impulse of {three_digits(c.impulse)} N s"
        )
        on = " on" if c.several != (1, 1) or c.what == "each_other" else ""
        when = f"{'from' if on else 'at'} {c.time:.2f} s{on}, "
        if c.time < AT_FIRST_S:
            when = "at the start, "
        lines.append(sentence(f"{when}{telling.text(c, names.fill(c))}{strength}"))
    if n_told > len(told):
        lines.append("More hits follow.")
    return " ".join([*lines, *_ends(story)])


def _starts(story: Story, names: _Names) -> tuple[list[str], list[str]]:
    """Who moves at first, and how fast, in words."""
    who = [n for n in _movers(story) if story.nouns.several(n) == 1][:MOST_STARTS]
    out: list[str] = []
    for name in who:
        speed = story.motion.speed[0, story.index(name)]
        # What has only just been let go falls later.
        verb = "[move]" if manner(story, name) == "fall" else manner_verb(story, name)
        text = f"at the start, {names.of(name)} {verb} at {speed:.1f} m/s"
        out.append(sentence(agreeing(text, plural=story.nouns.is_plural(name))))
    return who, out


def _ends(story: Story) -> list[str]:
    """Where what has moved ends, and what has not moved although it could."""
    motion, out, still = story.motion, list[str](), list[str]()
    for i, body in enumerate(story.scene.bodies):
        if not motion.whole[i] or not body.collides or body.static:
            continue
        if story.nouns.several(body.name) > 1 or not story.nouns.known(body.name):
            continue
        moved, name = motion.moved(i), story.nouns.the(body.name)
        if moved is False:
            still.append(body.name)
        elif moved:
            far, plural = metres(motion.displacement(i)), story.nouns.is_plural(body.name)
            began = "they started" if plural else "it started"
            speed = motion.speed[-1, i]
            text = f"in the end, {name} [be] {far} from where {began}"
            if motion.at_rest(i):
                text = f"{name} [come] to rest {far} from where {began}"
            elif speed > MOVING_MPS:
                text += f" and still moving at {speed:.1f} m/s"
            out.append(sentence(agreeing(text, plural=plural)))
    if still:
        one = len(still) == 1 and not story.nouns.is_plural(still[0])
        who = listed([story.nouns.the(n) for n in still])
        out.append(sentence(f"{who} {'does' if one else 'do'} not move noticeably"))
    out.append(f"The recording lasts {motion.end:.1f} s.")
    return out
