"""Every answer again from the tables alone, in plain Python that shares nothing with `esg`.

`python -m tests.dataset.answers FOLDER` reads a dataset (or the parts of one), answers all its
questions from `trajectories`, `what_ifs` and the manifests in `scenes`, and tells where the answers
in `questions` are others. Definitions: docs/dataset/annotations.md.
"""

from __future__ import annotations

from collections import Counter
import json
import math
from pathlib import Path
import sys
from typing import Any

Row = dict[str, Any]
WORDS = ("none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
         "eleven", "twelve")  # fmt: skip


class Recording:
    """A row of `trajectories` with the bodies of its scene's manifest."""

    def __init__(self, row: Row, manifest: Row) -> None:
        self.bodies = {b["name"]: b for b in manifest["bodies"]}
        self.names = list(row["bodies"])
        self.time = row["time_s"]
        self._row = row
        self._n = len(self.names)
        # As stored, a step ends at a rounded time.
        self.touches: dict[frozenset[str], list[tuple[float, float]]] = {}
        contacts = zip(
            row["contact_time_s"], row["contact_a"], row["contact_b"], row["contact_impulse_ns"],
            strict=True,
        )  # fmt: skip
        for t, a, b, impulse in sorted(contacts, key=lambda c: c[0]):
            if a >= 0 and b >= 0:
                pair = frozenset((self.names[a], self.names[b]))
                self.touches.setdefault(pair, []).append((t, impulse))

    def vector(self, column: str, width: int, frame: int, body: str) -> list[float]:
        start = width * (frame * self._n + self.names.index(body))
        return self._row[column][start : start + width]

    def velocity(self, frame: int, body: str) -> list[float]:
        return self.vector("linear_velocity_mps", 3, frame, body)

    def speed(self, frame: int, body: str) -> float:
        return math.sqrt(sum(v * v for v in self.velocity(frame, body)))

    def far(self, frame: int, body: str) -> float:
        there = self.vector("position_m", 3, frame, body)
        return math.dist(there, self.vector("position_m", 3, 0, body))

    @property
    def frames(self) -> range:
        return range(len(self.time))

    def supports(self, pair: frozenset[str]) -> bool:
        return self.touches[pair][0][0] <= 0.05

    def fragment(self, pair: frozenset[str]) -> bool:
        return any(self.bodies[n]["category"] == "fragment" for n in pair)

    def first_hit(self, a: str, b: str) -> float | None:
        """When two bodies first pass on more than 0.1 N s within 50 ms of a touch."""
        pair = frozenset((a, b))
        if pair not in self.touches or self.supports(pair) or self.fragment(pair):
            return None
        before = -math.inf
        for t, _ in self.touches[pair]:
            if t - before > 0.05 and self._passed_on(pair, t) > 0.1:
                return t
            before = t
        return None

    def _passed_on(self, pair: frozenset[str], start: float) -> float:
        return sum(p for t, p in self.touches[pair] if start <= t <= start + 0.05)

    def last_before(self, time: float) -> int:
        return max([k for k in self.frames if self.time[k] < time - 1e-4], default=0)

    def nearest(self, time: float) -> int:
        return min(self.frames, key=lambda k: abs(self.time[k] - time))

    def set_off(self, body: str) -> float | None:
        if self.speed(0, body) >= 0.05:
            return None
        return next((self.time[k] for k in self.frames if self.speed(k, body) > 0.2), None)

    def culprit(self, body: str) -> str | None:
        start = self.set_off(body)
        if start is None:
            return None
        found = set()
        for pair, times in self.touches.items():
            if body in pair and not self.supports(pair):
                (other,) = pair - {body}
                near = [t for t, _ in times if start - 0.15 <= t <= start + 1e-6]
                if near and self.speed(self.last_before(near[0]), other) > 0.2:
                    found.add(other)
        return found.pop() if len(found) == 1 else None

    def rest_time(self, body: str) -> float | None:
        moving = [k for k in self.frames if self.speed(k, body) >= 0.1]
        if not moving or moving[-1] + 1 >= len(self.time):
            return None
        return self.time[moving[-1] + 1]

    def heading(self, frame: int, body: str) -> float:
        x, y, _ = self.velocity(frame, body)
        return math.degrees(math.atan2(y, x))

    def tilt(self, frame: int, body: str) -> float:
        """Angle of the axis that pointed up at first to the vertical [deg]."""
        axes = [_rotated(self.vector("quaternion_xyzw", 4, frame, body), e) for e in _UNITS]
        first = [_rotated(self.vector("quaternion_xyzw", 4, 0, body), e) for e in _UNITS]
        k = max(range(3), key=lambda i: abs(first[i][2]))
        up = axes[k][2] * (1.0 if first[k][2] >= 0.0 else -1.0)
        return math.degrees(math.acos(max(-1.0, min(1.0, up))))


_UNITS = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def _rotated(q: list[float], v: tuple[float, float, float]) -> tuple[float, float, float]:
    """v + 2 w (u x v) + 2 u x (u x v), for a quaternion (u, w)."""
    u, w = q[:3], q[3]
    c = _cross(u, v)
    d = _cross(u, c)
    x, y, z = (v[i] + 2.0 * w * c[i] + 2.0 * d[i] for i in range(3))
    return x, y, z


def _cross(a: Any, b: Any) -> tuple[float, float, float]:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _between(degrees: float) -> float:
    return (degrees + 180.0) % 360.0 - 180.0


def _side(turn: float) -> str:
    if abs(turn) <= 25.0:
        return "straight on"
    if abs(turn) >= 155.0:
        return "back"
    return "to the left" if turn > 0.0 else "to the right"


def answer_of(q: Row, seen: Recording, what_ifs: list[Row]) -> tuple[Any, float | None]:
    """What the answer has to be, and its number: the answer is a text, or the name of a body."""
    of = q["arguments"]
    measure = q["measure"]
    if measure in ("happens", "sooner"):
        return _what_if(measure, of, what_ifs)
    if measure == "hit_order":
        one, two = seen.first_hit(of[0], of[1]), seen.first_hit(of[2], of[3])
        assert one is not None and two is not None
        return (of[0], of[1]) if one < two else (of[2], of[3]), abs(two - one)
    if measure == "first_hit":
        one, two = seen.first_hit(of[0], of[1]), seen.first_hit(of[0], of[2])
        assert one is not None and two is not None
        return (of[1],) if one < two else (of[2],), abs(two - one)
    if measure == "rest_order":
        times = {n: seen.rest_time(n) for n in of}
        assert None not in times.values()
        first, second = sorted(of, key=lambda n: times[n] or 0.0)
        return (first,), (times[second] or 0.0) - (times[first] or 0.0)
    if measure in ("cause", "first_cause"):
        return (_cause(measure, of[0], seen),), None
    if measure == "faster":
        return (max(of, key=lambda n: max(seen.speed(k, n) for k in seen.frames)),), None
    if measure.endswith("_speed"):
        speed = _speed(measure, of, seen)
        return f"About {speed:.1f} m/s.", speed
    if measure in ("after_hit", "pushed", "turn"):
        turn = _turned(measure, of, seen)
        text = _side(turn)
        return f"{text[0].upper()}{text[1:]}.", turn
    n = _counted(measure, of, seen)
    word = WORDS[n] if n < len(WORDS) else str(n)
    return f"{word.capitalize()}.", float(n)


def _cause(measure: str, body: str, seen: Recording) -> str | None:
    found = seen.culprit(body)
    while measure == "first_cause" and found and (before := seen.culprit(found)):
        found = before
    return found


def _speed(measure: str, of: list[str], seen: Recording) -> float:
    if measure == "start_speed":
        return seen.speed(0, of[0])
    if measure == "top_speed":
        return max(seen.speed(k, of[0]) for k in seen.frames)
    time = seen.first_hit(of[0], of[1])
    assert measure == "hit_speed" and time is not None
    return seen.speed(seen.last_before(time), of[0])


def _turned(measure: str, of: list[str], seen: Recording) -> float:
    if measure == "turn":
        touched = [t[0][0] for p, t in seen.touches.items() if of[0] in p and not seen.supports(p)]
        last = seen.last_before(min(touched)) if touched else len(seen.time) - 1
        steps = range(last)
        return sum(_between(seen.heading(k + 1, of[0]) - seen.heading(k, of[0])) for k in steps)
    time = seen.first_hit(of[0], of[1])
    assert time is not None
    who = of[0] if measure == "after_hit" else of[1]
    before = seen.heading(seen.last_before(time), of[0])
    return _between(seen.heading(seen.nearest(time + 0.2), who) - before)


def _counted(measure: str, of: list[str], seen: Recording) -> int:
    if measure == "moving_first":
        return sum(seen.speed(0, n) > 0.1 for n in of)
    if measure == "moved":
        return sum(max(seen.far(k, n) for k in seen.frames) > 0.035 for n in of)
    if measure == "hit_count":
        return sum(seen.first_hit(of[0], n) is not None for n in of[1:])
    assert measure == "fell_count", measure
    return sum(max(seen.tilt(k, n) for k in seen.frames) > 45.0 for n in of)


def _what_if(measure: str, of: list[str], rows: list[Row]) -> tuple[str, float | None]:
    variable, amount, body, event = of
    mine = {r["engine"]: r for r in rows if r["variable"] == variable}
    bases = {r["engine"]: r for r in rows if r["variable"] == "none"}
    assert len(mine) == 3 and all(r["amount"] == amount for r in mine.values())
    assert all((r["body"] or "") == body for r in mine.values())
    late, done = [], set()
    for engine, row in mine.items():
        k = list(row["event_ids"]).index(event)
        done.add(row["completed"][k])
        assert bases[engine]["completed"][k]
        if row["completed"][k]:
            late.append(row["event_times_s"][k] - bases[engine]["event_times_s"][k])
    assert len(done) == 1, "engines do not agree"
    if measure == "happens":
        return ("Yes.", 1.0) if done.pop() else ("No.", 0.0)
    if max(map(abs, late)) < 0.03:
        return "At about the same time.", None
    return ("Later.", None) if min(late) > 0.1 else ("Earlier.", None) if max(late) < -0.1 else (
        "", None)  # fmt: skip


def problem(q: Row, seen: Recording, what_ifs: list[Row]) -> str:
    """What is wrong with an answer; empty if it is the one that the tables give."""
    try:
        right, value = answer_of(q, seen, what_ifs)
    except (AssertionError, KeyError, ValueError, IndexError) as error:
        return f"cannot be answered: {type(error).__name__} {error}"
    given = q["answer"]
    if isinstance(right, tuple):
        if None in right or not _means(given, right, q["arguments"], seen):
            return f"{given!r}, not {right}"
    elif given != right:
        return f"{given!r}, not {right!r}"
    if (value is None) != (q["value"] is None) and not isinstance(right, str):
        return f"value {q['value']}, not {value}"
    if value is not None and q["value"] is not None and abs(value - q["value"]) > 2e-3:
        return f"value {q['value']}, not {value}"
    if q["choices"] and given not in q["choices"]:
        return f"{given!r} is none of its choices"
    return ""


def _means(given: str, right: tuple[str, ...], of: list[str], seen: Recording) -> bool:
    """Whether a text names these bodies, in this order if there are two, by their labels."""
    places = []
    for name in right:
        place = given.lower().find(_label(seen, name))
        if place < 0:
            return False
        places.append(place)
    return places == sorted(places) or "collide" in given


def _label(seen: Recording, name: str) -> str:
    """What its prompt calls a body, without a number and its unit in front: `10 kg crate`."""
    label = (seen.bodies[name]["label"] or name).lower().split()
    if label[0][0].isdigit():
        label = label[2:]
    stem = name.rsplit("_", 1)[0].replace("_", " ")
    return stem if {"it", "behind"} & set(label) else " ".join(label)


def wrong_answers(folder: Path) -> tuple[Counter[str], list[str]]:
    """How many questions of every measure a dataset has, and which answers are wrong, and why."""
    recordings = {
        r["scene_key"]: (r, m)
        for r in _rows(folder, "trajectories")
        for m in [next(s["manifest"] for s in _rows(folder, "scenes")
                       if s["scene_key"] == r["scene_key"])]
    }  # fmt: skip
    changed: dict[str, list[Row]] = {}
    for row in _rows(folder, "what_ifs"):
        changed.setdefault(row["scene_key"], []).append(row)
    counts: Counter[str] = Counter()
    wrong: list[str] = []
    seen: dict[str, Recording] = {}
    for q in _rows(folder, "questions"):
        key = q["scene_key"]
        if key not in seen:
            row, manifest = recordings[key]
            seen[key] = Recording(row, json.loads(manifest))
        counts[q["measure"]] += 1
        why = problem(q, seen[key], changed.get(key, []))
        if why:
            wrong.append(f"{key} {q['question_index']} {q['measure']}: {q['question']} {why}")
    return counts, wrong


def _rows(folder: Path, table: str) -> list[Row]:
    import pyarrow.parquet as pq

    root = folder / "parts" if (folder / "parts").is_dir() else folder
    files = sorted((root / table).glob("*.parquet"))
    return [row for f in files for row in pq.read_table(f.absolute()).to_pylist()]


def main() -> int:
    counts, wrong = wrong_answers(Path(sys.argv[1]))
    for line in wrong:
        print(line)
    total = counts.total()
    print(", ".join(f"{k} {v}" for k, v in sorted(counts.items())))
    print(f"{total - len(wrong)} of {total} answers agree")
    return 1 if wrong or not total else 0


if __name__ == "__main__":
    sys.exit(main())
