"""Questions about a scene whose answers are measured on its trajectory.

A question is asked only if its answer hangs on no threshold: what is near one, and what goes by a
name that two things share, is left out. `measure` and `arguments` say what was measured of whom, so
that other code can answer it again from the tables (tests/dataset/answers.py does).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

from esg.dataset.annotations.clauses import (
    Clause,
    Story,
    event_clauses,
    is_it,
    manner,
    of_hit,
    worded,
)
from esg.dataset.annotations.motion import AFTER_S, Hit, side
from esg.dataset.annotations.nouns import number
from esg.dataset.annotations.wording import Chooser, rows, sentence
from esg.dataset.whatifs.amounts import Amount, amount_named
from esg.engines.scene import FRAGMENT
from esg.lexicon.morphology import plural

MOST_OF_A_MEASURE = 2
"""Questions of one measure; of more, the seed picks. Of every what-if one of each measure."""
APART_S = 0.2
"""What comes first does so by more than this."""
FASTER = 1.2
"""What is faster is so by more than this factor."""
LEAST_SPEED_MPS = 0.5
"""Slower motion is not asked for its speed."""
STRAIGHT_DEG, TURNED_DEG = 5.0, 30.0
"""Less is no turn, more is one."""
SAME_EVENT_S = 0.3
"""An event that an engine shows so much earlier or later than the recording is another."""
SAME_TIME_S, LATE_S = 0.03, 0.1
"""A change that moves an event by less than the first in every engine leaves its time; by more than
the second in every engine, it does not."""


@dataclass(frozen=True)
class Question:
    """One question with its answer.

    Args:
        kind: order, count, cause, speed, direction or what_if.
        measure: What was measured (docs/dataset/annotations.md has a line for each).
        arguments: Of whom: names of bodies; of a what-if the variable and the event.
        question, answer: In English.
        choices: Answers to choose from, the right one among them; empty: an open question.
        value: The answer as a number, None if it is none.
        unit: Of the value.
        measured_by: Columns and moments that the answer was measured on.
    """

    kind: str
    measure: str
    arguments: tuple[str, ...]
    question: str
    answer: str
    choices: tuple[str, ...] = ()
    value: float | None = None
    unit: str = ""
    measured_by: str = ""


@dataclass(frozen=True)
class _Asking:
    """A story, and the means to word questions about it."""

    story: Story
    choose: Chooser

    def name(self, i: int) -> str:
        return self.story.motion.names[i]

    def the(self, i: int) -> str:
        return self.story.nouns.the(self.name(i))

    def clear(self, *bodies: int) -> bool:
        return all(self.story.nouns.clear(self.name(i)) for i in bodies)

    def singular(self, *bodies: int) -> bool:
        return not any(self.story.nouns.is_plural(self.name(i)) for i in bodies)

    def ask(
        self,
        kind: str,
        measure: str,
        arguments: Iterable[int | str],
        words: Mapping[str, str],
        answer: str,
        measured_by: str,
        *,
        choices: Sequence[str] = (),
        value: float | None = None,
        unit: str = "",
    ) -> Question:
        row = self.choose.of(rows("questions")[measure])
        text = row.template.format(**words)
        parts = [sentence(p, "") for p in text.split(". ")]
        return Question(
            kind, measure, tuple(a if isinstance(a, str) else self.name(a) for a in arguments),
            ". ".join(parts), sentence(answer),
            tuple(sentence(c) for c in self.choose.shuffled(choices)), value, unit, measured_by,
        )  # fmt: skip

    def clause(self, hit: Hit) -> str:
        clause = of_hit(self.story, hit)
        template = "{a} and {b} collide" if hit.mutual else "{a} [hit] {b}"
        return worded(self.story, clause, template)


def questions(
    story: Story, seed: str, what_ifs: Sequence[Mapping[str, Any]] = ()
) -> list[Question]:
    """The questions of a scene, in an order that its seed does not change.

    Args:
        story: The scene with what its replay shows.
        seed: Of the wording, and of which of many questions are asked.
        what_ifs: Rows of table `what_ifs` of the scene.
    """
    asking = _Asking(story, Chooser(f"{seed}/questions"))
    out: list[Question] = []
    for make in _MAKERS:
        found = list(make(asking))
        by_measure: dict[str, list[Question]] = {}
        for q in found:
            by_measure.setdefault(q.measure, []).append(q)
        for of_one in by_measure.values():
            out += asking.choose.shuffled(of_one)[:MOST_OF_A_MEASURE]
    return out + list(_what_if(asking, what_ifs))


def _hits(asking: _Asking) -> list[Hit]:
    return [h for h in asking.story.motion.hits if asking.clear(h.a, h.b)]


def _order(asking: _Asking) -> Iterator[Question]:
    hits, motion = _hits(asking), asking.story.motion
    for one, two in combinations(hits, 2):
        if two.time - one.time < APART_S:
            continue
        by = f"contact_time_s: {_pair(asking, one)} at {one.time:.3f} s, " \
             f"{_pair(asking, two)} at {two.time:.3f} s"  # fmt: skip
        texts = [asking.clause(one), asking.clause(two)]
        first, second = asking.choose.shuffled(texts)
        yield asking.ask(
            "order", "hit_order", (one.a, one.b, two.a, two.b), {"one": first, "two": second},
            texts[0], by, choices=texts, value=two.time - one.time, unit="s",
        )  # fmt: skip
        if one.a == two.a and not one.mutual and not two.mutual:
            names = [asking.the(one.b), asking.the(two.b)]
            b, c = asking.choose.shuffled(names)
            yield asking.ask(
                "order", "first_hit", (one.a, one.b, two.b),
                {"a": asking.the(one.a), "b": b, "c": c}, names[0], by, choices=names,
                value=two.time - one.time, unit="s",
            )  # fmt: skip
    rest = {i: t for i in _movable(asking) if asking.clear(i) and asking.singular(i)
            and motion.moved(i) and (t := motion.rest_time(i)) is not None}  # fmt: skip
    for a, b in combinations(sorted(rest, key=lambda i: rest[i]), 2):
        if rest[b] - rest[a] >= APART_S:
            names = [asking.the(a), asking.the(b)]
            first, second = asking.choose.shuffled(names)
            yield asking.ask(
                "order", "rest_order", (a, b), {"a": first, "b": second}, names[0],
                f"linear_velocity_mps: below 0.1 m/s for good, {asking.name(a)} from "
                f"{rest[a]:.2f} s and {asking.name(b)} from {rest[b]:.2f} s on",
                choices=names, value=rest[b] - rest[a], unit="s",
            )  # fmt: skip


def _pair(asking: _Asking, hit: Hit) -> str:
    return f"{asking.name(hit.a)} and {asking.name(hit.b)}"


def _bodies(asking: _Asking) -> list[int]:
    """Bodies that one can see, broken ones included."""
    found = enumerate(asking.story.scene.bodies)
    return [i for i, b in found if b.collides and b.category != FRAGMENT]


def _movable(asking: _Asking) -> list[int]:
    bodies, motion = asking.story.scene.bodies, asking.story.motion
    return [i for i in _bodies(asking) if not bodies[i].static and motion.whole[i]]


def _count(asking: _Asking) -> Iterator[Question]:
    motion, bodies = asking.story.motion, _bodies(asking)
    if all(motion.whole[i] for i in bodies):
        first = [motion.moves_at_first(i) for i in bodies]
        if None not in first:
            yield _counted(asking, "moving_first", bodies, {}, sum(map(bool, first)),
                           "linear_velocity_mps: above 0.2 m/s in frame 0")  # fmt: skip
        ever = [motion.moved(i) for i in bodies]
        if None not in ever:
            yield _counted(asking, "moved", bodies, {}, sum(map(bool, ever)),
                           "position_m: ever farther than 0.05 m from frame 0")  # fmt: skip
    for a in bodies:
        others = [b for b in bodies if b != a]
        in_doubt = any(a in pair for pair in motion.doubtful)
        if in_doubt or not asking.clear(a) or not motion.moved(a):
            continue
        n = sum(a in h.pair for h in motion.hits)
        yield _counted(asking, "hit_count", (a, *others), {"a": asking.the(a)}, n,
                       f"contact_impulse_ns: bodies that pass {asking.name(a)} more than 0.1 N s, "
                       "what it touches from the start aside")  # fmt: skip
    yield from _fallen(asking)


def _fallen(asking: _Asking) -> Iterator[Question]:
    """How many of several things of one name fall over."""
    motion, nouns = asking.story.motion, asking.story.nouns
    groups: dict[str, list[int]] = {}
    for i in _movable(asking):
        if motion.stands(i):
            groups.setdefault(nouns.noun(asking.name(i)), []).append(i)
    for noun, members in groups.items():
        fell = [motion.fell_over(i) for i in members]
        whole = len(members) > 1 and nouns.several(asking.name(members[0])) == len(members)
        if whole and None not in fell:
            words = {"members": f"{number(len(members))} {plural(noun)}"}
            by = "quaternion_xyzw: tilted by more than 60 degrees, in the end, too"
            yield _counted(asking, "fell_count", members, words, sum(map(bool, fell)), by)


def _counted(
    asking: _Asking, measure: str, of: Sequence[int], words: Mapping[str, str], n: int, by: str
) -> Question:
    answer = "none" if n == 0 else number(n)
    return asking.ask("count", measure, of, words, answer, by, value=float(n), unit="1")


def _cause(asking: _Asking) -> Iterator[Question]:
    motion = asking.story.motion
    things = [i for i in _bodies(asking) if asking.clear(i)]
    for a in (i for i in _movable(asking) if asking.clear(i)):
        chain = motion.first_cause(a)
        if not chain or not asking.clear(*chain):
            continue
        others = [asking.the(i) for i in things if i != a]
        by = f"linear_velocity_mps and contact_time_s: {asking.name(chain[0])} touches " \
             f"{asking.name(a)} as it begins to move, at {motion.set_off(a):.2f} s"  # fmt: skip
        choices = others if len(others) > 1 else ()
        yield asking.ask("cause", "cause", (a, chain[0]), {"a": asking.the(a)},
                         asking.the(chain[0]), by, choices=choices)  # fmt: skip
        if len(chain) > 1 and motion.moves_at_first(chain[-1]):
            told = " <- ".join(asking.name(i) for i in (a, *chain))
            yield asking.ask("cause", "first_cause", (a, chain[-1]), {"a": asking.the(a)},
                             asking.the(chain[-1]), f"the same, one by one: {told}",
                             choices=choices)  # fmt: skip


def _speed(asking: _Asking) -> Iterator[Question]:
    motion = asking.story.motion
    movable = [i for i in _movable(asking) if asking.clear(i) and asking.singular(i)]
    for a in movable:
        start, top = float(motion.speed[0, a]), motion.top_speed(a)
        name = asking.name(a)
        if start > LEAST_SPEED_MPS:
            yield _in_mps(asking, "start_speed", (a,), start, f"of {name} in frame 0")
        if top > max(LEAST_SPEED_MPS, FASTER * start):
            k = int(motion.speed[:, a].argmax())
            yield _in_mps(
                asking, "top_speed", (a,), top, f"of {name}, its largest norm (frame {k})"
            )
    for hit in _hits(asking):
        k = motion.before(hit.time)
        speed = float(motion.speed[k, hit.a])
        if not hit.mutual and speed > LEAST_SPEED_MPS and asking.singular(hit.a):
            yield _in_mps(asking, "hit_speed", (hit.a, hit.b), speed,
                          f"of {asking.name(hit.a)} in frame {k}, the last before "
                          f"{hit.time:.3f} s")  # fmt: skip
    for a, b in combinations(movable, 2):
        fast, slow = sorted((a, b), key=motion.top_speed, reverse=True)
        if motion.top_speed(slow) * FASTER < motion.top_speed(fast) and motion.moved(slow):
            names = [asking.the(fast), asking.the(slow)]
            first, second = asking.choose.shuffled(names)
            yield asking.ask(
                "speed", "faster", (fast, slow), {"a": first, "b": second}, names[0],
                f"linear_velocity_mps: largest norms {motion.top_speed(fast):.2f} and "
                f"{motion.top_speed(slow):.2f} m/s", choices=names,
            )  # fmt: skip


def _in_mps(asking: _Asking, measure: str, of: Sequence[int], speed: float, by: str) -> Question:
    words = dict(zip("ab", (asking.the(i) for i in of), strict=False))
    return asking.ask("speed", measure, of, words, f"about {speed:.1f} m/s",
                      f"linear_velocity_mps {by}", value=speed, unit="m/s")  # fmt: skip


_SIDES = ("straight on", "to the left", "to the right", "back")


def _direction(asking: _Asking) -> Iterator[Question]:
    motion = asking.story.motion
    for hit in _hits(asking):
        before, after = motion.before(hit.time), motion.at(hit.time + AFTER_S)
        heading = motion.heading(hit.a, before)
        if hit.mutual or heading is None or hit.time + AFTER_S > motion.end:
            continue
        if not asking.singular(hit.a, hit.b):
            continue
        for measure, body in (("after_hit", hit.a), ("pushed", hit.b)):
            then = motion.heading(body, after) if motion.whole[body] else None
            where = side(then - heading) if then is not None else None
            rests = motion.heading(body, before) is None
            if where is None or (measure == "pushed" and (where == "back" or not rests)):
                continue
            words = {"a": asking.the(hit.a), "b": asking.the(hit.b)}
            choices = _SIDES if measure == "after_hit" else _SIDES[:3]
            yield asking.ask(
                "direction", measure, (hit.a, hit.b), words, _where(where),
                f"linear_velocity_mps, horizontal: {asking.name(hit.a)} in frame {before}, "
                f"{asking.name(body)} in frame {after}",
                choices=choices, value=_turn(heading, then or 0.0), unit="deg",
            )  # fmt: skip
    yield from _turns(asking)


def _turns(asking: _Asking) -> Iterator[Question]:
    """Which way things go before they meet anything; what goes straight is asked if it drives."""
    motion = asking.story.motion
    for a in (i for i in _movable(asking) if asking.clear(i) and asking.singular(i)):
        how = manner(asking.story, asking.name(a)) if motion.moves_at_first(a) else "fly"
        if how in ("fly", "fall"):
            continue
        times = [
            float(t[0])
            for p, (t, _) in motion.touches.items()
            if a in p and frozenset(p) not in motion.supports
        ]
        last = motion.before(min(times)) if times else len(motion.time) - 1
        turn = motion.turn(a, 0, last)
        if turn is None or last < 2 or STRAIGHT_DEG <= abs(turn) <= TURNED_DEG:
            continue
        if abs(turn) < STRAIGHT_DEG and how not in ("drive", "ride"):
            continue
        where = "straight on" if abs(turn) < STRAIGHT_DEG else "left" if turn > 0.0 else "right"
        yield asking.ask(
            "direction", "turn", (a,),
            {"a": asking.the(a), "when": _WHEN[bool(times)]},
            _where(where),
            f"linear_velocity_mps of {asking.name(a)}, horizontal: its direction from frame 0 to "
            f"{last}, before it touches anything",
            choices=_SIDES[:3], value=turn, unit="deg",
        )  # fmt: skip


_WHEN = {True: "before it touches anything", False: "in this scene"}


def _where(where: str) -> str:
    return where if where in ("straight on", "back") else f"to the {where}"


def _turn(before: float, after: float) -> float:
    return (after - before + 180.0) % 360.0 - 180.0


_MAKERS: tuple[Callable[[_Asking], Iterator[Question]], ...] = (
    _order, _count, _cause, _speed, _direction,
)  # fmt: skip


# What-ifs: asked where all engines give the same answer.


def _what_if(asking: _Asking, rows_of: Sequence[Mapping[str, Any]]) -> Iterator[Question]:
    bases = {r["engine"]: r for r in rows_of if r["variable"] == "none"}
    variables = dict.fromkeys(r["variable"] for r in rows_of if r["variable"] != "none")
    clauses = {c.event: c for c in event_clauses(asking.story) if c.event}
    for variable in variables:
        mine = [r for r in rows_of if r["variable"] == variable]
        if any(r.get("completed") is None for r in mine):
            continue
        if any((bases.get(r["engine"]) or {}).get("completed") is None for r in mine):
            continue
        amount = amount_named(variable, mine[0]["amount"])
        change = _change(asking, amount, mine[0]["body"])
        if change is None:
            continue
        found = [
            q
            for k, event in enumerate(mine[0]["event_ids"])
            if (clause := clauses.get(event)) is not None and _askable(asking, clause, mine[0])
            for q in _of_event(asking, clause, change, mine, bases, k)
        ]
        for measure in ("happens", "sooner"):
            yield from asking.choose.shuffled([q for q in found if q.measure == measure])[:1]


def _askable(asking: _Asking, clause: Clause, row: Mapping[str, Any]) -> bool:
    """Whether all have clear names, and no thing that was taken away is asked for."""
    names = [n for n in (clause.a, clause.b) if n]
    away = row["body"] if row["variable"] == "remove" else ""
    clear = all(n == "ground" or asking.story.nouns.clear(n) for n in names)
    return clear and away not in names and f"would {clause.what}" in rows("supposed")


def _supposed(after: str, clause: Clause) -> str:
    """How an event reads after `would` or `that`."""
    return rows("supposed")[f"{after} {clause.what}"][0].template


def _change(asking: _Asking, amount: Amount, body: str) -> str | None:
    """What is supposed: `the ball were four times as heavy`; None if the body has no clear name."""
    if not body:
        whole = {"gravity": "gravity", "friction": "all surfaces"}
        return f"{whole[amount.variable]} {amount.words}"
    if not asking.story.nouns.clear(body):
        return None
    return f"{asking.story.nouns.the(body)} {amount.words}"


def _of_event(
    asking: _Asking,
    clause: Clause,
    change: str,
    mine: Sequence[Mapping[str, Any]],
    bases: Mapping[str, Mapping[str, Any]],
    k: int,
) -> Iterator[Question]:
    before = [bases[r["engine"]] for r in mine]
    times = [b["event_times_s"][k] for b in before]
    if any(t is None or abs(t - clause.time) > SAME_EVENT_S for t in times):
        return  # what the caption tells is another one
    done = {r["completed"][k] for r in mine}
    if len(done) != 1 or not all(b["completed"][k] for b in before):
        return
    row, event = mine[0], mine[0]["event_ids"][k]
    arguments = (row["variable"], row["amount"], row["body"], event)
    by = f"what_ifs: {row['variable']} ({row['amount']}) in {', '.join(r['engine'] for r in mine)}"
    happens = done.pop()
    names = _again(asking, clause, row["body"])
    would = worded(asking.story, clause, _supposed("would", clause), names)
    yield asking.ask(
        "what_if", "happens", arguments,
        {"change": change, "clause": would, "time": f"{row['duration_s']:.1f} seconds"},
        "yes" if happens else "no", by, choices=("yes", "no"), value=float(happens), unit="1",
    )  # fmt: skip
    if not happens or f"that {clause.what}" not in rows("supposed"):
        return
    late = [
        r["event_times_s"][k] - b["event_times_s"][k] for r, b in zip(mine, before, strict=True)
    ]
    answer = _lateness(late)
    if answer:
        that = worded(asking.story, clause, _supposed("that", clause), names)
        yield asking.ask(
            "what_if", "sooner", arguments, {"change": change, "clause": that},
            answer, f"{by}: {', '.join(f'{t:+.3f} s' for t in late)}",
            choices=("earlier", "later", "at about the same time"),
        )  # fmt: skip


def _again(asking: _Asking, clause: Clause, body: str) -> dict[str, str]:
    """`it` for the body that the change has just named."""
    if not body or not is_it(asking.story, body):
        return {}
    return {key: "it" for key, n in (("a", clause.a), ("b", clause.b)) if n == body}


def _lateness(late: Sequence[float]) -> str:
    if all(abs(t) < SAME_TIME_S for t in late):
        return "at about the same time"
    if all(t > LATE_S for t in late):
        return "later"
    return "earlier" if all(t < -LATE_S for t in late) else ""
