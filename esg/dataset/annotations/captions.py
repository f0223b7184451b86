"""Captions at three lengths: what one sees, what happens in order, and all of it with numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from esg.dataset.annotations.clauses import (
    Clause,
    Story,
    event_clauses,
    hit_clauses,
    manner_verb,
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

MEDIUM_CLAUSES = 5
LONG_CLAUSES = 12
"""Most that a caption tells; of more, the first."""
LATER_S = 1.0
"""A pause from which on it is said how long it was."""
SOON_S = 0.3


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
    told = sorted([*events, *hit_clauses(story, events)], key=lambda c: c.time)
    templates = {c: choose.of(rows("clauses")[c.what]).template for c in told}
    texts = tuple((c, sentence(worded(story, c, templates[c]))) for c in events)
    return Captions(
        short=_short(story, events or told, templates),
        medium=_medium(story, told[:MEDIUM_CLAUSES], templates, choose),
        long=_long(story, told[:LONG_CLAUSES], len(told), templates, choose),
        events=texts,
    )


class _Names:
    """Bodies by the names they have at that point of a text: new at first, then known."""

    def __init__(self, story: Story) -> None:
        self._story = story
        self._told: set[str] = set()

    def of(self, name: str) -> str:
        if not name:
            return ""
        nouns = self._story.nouns
        noun = nouns.noun(name)
        if nouns.several(name) > 1 and name in self._told:
            return f"the same {noun}"
        known = name in self._told or name == GROUND
        if nouns.several(name) > 1 and noun in self._told:
            # One of them has been told: this is another.
            text = f"{'the other' if nouns.several(name) == 2 else 'another'} {noun}"
        else:
            text = nouns.the(name) if known or noun in self._told else nouns.a(name)
        self._told |= {name, noun}
        return text

    def introduce(self, name: str) -> None:
        """Counts a body as known: an inventory has named it."""
        if self._story.nouns.several(name) == 1:
            self._told |= {name, self._story.nouns.noun(name)}

    def fill(self, clause: Clause) -> dict[str, str]:
        names = {"a": self.of(clause.a)}
        if clause.b:
            names["b"] = self.of(clause.b)
        return names


def _short(story: Story, told: Sequence[Clause], templates: dict[Clause, str]) -> str:
    """One sentence of the first and the last thing that happens besides moving."""
    doing = [c for c in told if c.what != "moves"] or list(told)
    if not doing:
        return _still(story)
    chosen = [doing[0], doing[-1]] if len(doing) > 1 else doing
    names = _Names(story)
    text = worded(story, chosen[0], templates[chosen[0]], names.fill(chosen[0]))
    for before, c in pairwise(chosen):
        text += _joined(story, before, c, templates[c], names)
    return sentence(text)


def _joined(story: Story, before: Clause, c: Clause, template: str, names: _Names) -> str:
    """A second clause behind the first, without naming a subject that both have."""
    if c.a == before.a and not before.with_b and template.startswith("{a} [") and not c.with_b:
        return " and" + worded(story, c, template.removeprefix("{a}"), names.fill(c))
    # Only what stands at the very end of the first clause can be meant by "which".
    last = before.b if not before.with_b and templates_end(before) else ""
    if c.a == last and template.startswith("{a} [") and not c.with_b:
        return ", which" + worded(story, c, template.removeprefix("{a}"), names.fill(c))
    return ", and " + worded(story, c, template, names.fill(c))


def templates_end(clause: Clause) -> bool:
    """Whether the clause's last word is its object."""
    return clause.what in ("collision", "falls_off", "bounces", "placed", "reaches")


def _still(story: Story) -> str:
    """What can be said of a scene in which no two bodies meet and no event is completed."""
    names = _Names(story)
    for name in _movers(story):
        return sentence(
            agreeing(f"{names.of(name)} {manner_verb(story, name)} along", plural=False)
        )
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
    """Where the scene is: what lies on the ground and the prompt names, with `on`."""
    for body in story.scene.bodies:
        if not body.collides and body.label and body.category != FRAGMENT:
            noun = story.nouns.noun(body.name)
            if noun not in ("ground", "floor") or body.mentioned:
                return f" on the {noun}"
    return ""


def _connected(
    story: Story, told: Sequence[Clause], templates: dict[Clause, str], choose: Chooser,
    names: _Names,
) -> list[str]:  # fmt: skip
    """One sentence a clause, each with a word for when it happens."""
    out: list[str] = []
    for k, c in enumerate(told):
        text = worded(story, c, templates[c], names.fill(c))
        lead = ""
        if k:
            pause = c.time - told[k - 1].time
            if pause >= LATER_S:
                lead = f"{_seconds(pause)} later, "
            elif pause <= SOON_S:
                lead = choose.of(("right after that, ", "a moment later, "))
            else:
                lead = choose.of(("then, ", "after that, "))
            if k == len(told) - 1 and k > 1 and choose.below(2):
                lead = "finally, "
        elif len(told) > 1 and choose.below(2):
            lead = "first, "
        out.append(sentence(lead + text))
    return out


def _seconds(value: float) -> str:
    return f"{value:.1f} seconds" if value < 9.95 else f"{value:.0f} seconds"


def _medium(
    story: Story, told: Sequence[Clause], templates: dict[Clause, str], choose: Chooser
) -> str:
    names = _Names(story)
    lines: list[str] = []
    first = next(iter(_movers(story)), "")
    if first and not any(c.what == "moves" for c in told):
        begun = f"{names.of(first)} {manner_verb(story, first)} along{_place(story)}"
        lines.append(sentence(agreeing(begun, plural=story.nouns.is_plural(first))))
    lines += _connected(story, told, templates, choose, names)
    lines += _ending(story, names)
    return " ".join(lines) or _still(story)


def _ending(story: Story, names: _Names) -> list[str]:
    """Whether everything lies still in the end, or what still moves."""
    motion = story.motion
    whole = [
        i for i, b in enumerate(story.scene.bodies)
        if motion.whole[i] and b.collides and not b.static
    ]  # fmt: skip
    moving = [i for i in whole if not motion.at_rest(i)]
    if not whole or len(whole) != sum(b.collides and not b.static and b.category != FRAGMENT
                                      for b in story.scene.bodies):  # fmt: skip
        return []  # what is broken is not followed
    if not moving:
        return ["In the end, everything is at rest."] if story.motion.hits or moving else []
    if len(moving) == 1:
        name = names.of(motion.names[moving[0]])
        plural = story.nouns.is_plural(motion.names[moving[0]])
        return [sentence(agreeing(f"in the end, {name} [be] still moving", plural=plural))]
    return []


def _long(
    story: Story, told: Sequence[Clause], n_told: int, templates: dict[Clause, str],
    choose: Chooser,
) -> str:  # fmt: skip
    names = _Names(story)
    lines: list[str] = []
    shown = story.nouns.inventory(_things(story))
    if shown:
        row = choose.of(("The scene shows {}{}.", "There {be} {}{}."))
        several = len(shown) > 1 or shown[0].split()[0] not in ("a", "an")
        lines.append(
            row.replace("{be}", "are" if several else "is").format(listed(shown), _place(story))
        )
        for name in _things(story):
            names.introduce(name)
    lines += _starts(story, names)
    for c in told:
        text = worded(story, c, templates[c], names.fill(c))
        strength = (
            "" if c.impulse is None else f", with an impulse of {three_digits(c.impulse)} N s"
        )
        when = f"at {c.time:.2f} s, " if c.time > 0.005 else "at the start, "
        lines.append(sentence(f"{when}{text}{strength}"))
    if n_told > len(told):
        lines.append("More hits follow.")
    lines += _ends(story, names)
    return " ".join(lines)


def _starts(story: Story, names: _Names) -> list[str]:
    out: list[str] = []
    for name in _movers(story)[:3]:
        speed = story.motion.speed[0, story.index(name)]
        text = f"at the start, {names.of(name)} {manner_verb(story, name)} at {speed:.1f} m/s"
        out.append(sentence(agreeing(text, plural=story.nouns.is_plural(name))))
    return out


def _ends(story: Story, names: _Names) -> list[str]:
    """Where what has moved ends, and what has not moved although it could."""
    motion, out, still = story.motion, list[str](), list[str]()
    for i, body in enumerate(story.scene.bodies):
        if not motion.whole[i] or not body.collides or body.static:
            continue
        if not story.nouns.clear(body.name):
            continue
        name = names.of(body.name)
        plural = story.nouns.is_plural(body.name)
        moved = motion.moved(i)
        if moved:
            far = metres(motion.displacement(i))
            if motion.at_rest(i):
                text = (
                    f"{name} [come] to rest {far} from where {'they' if plural else 'it'} started"
                )
            else:
                speed = motion.speed[-1, i]
                text = (
                    f"{name} [be] {far} from the start in the end, still moving at {speed:.1f} m/s"
                )
            out.append(sentence(agreeing(text, plural=plural)))
        elif moved is False:
            still.append(name)
    if still:
        be = "do not move" if len(still) > 1 else "does not move"
        out.append(sentence(f"{listed(still)} {be} noticeably"))
    out.append(f"The recording lasts {motion.end:.1f} s.")
    return out
