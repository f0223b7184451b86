"""The rules of the scene grammar: slots, sentences and what they mean (docs/dataset.md).

Every rule renders one sentence (or two) per choice of its slots and states its events in order, in
the words of the sentence. Numbers become constraints exactly where the sentence says them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from esg.dataset import vocabulary as words
from esg.dataset.vocabulary import Noun
from esg.metrics.models import SuiteConstraint, SuiteEvent

if TYPE_CHECKING:
    import numpy as np

    from esg.dataset.grammar import Distribution

Values = dict[str, Any]


@dataclass(frozen=True)
class Slot:
    """A place to fill.

    Args:
        name: mover, target, speed, mass, time, count or wording.
        draw: Value for the values drawn before it, None if nothing fits.
        other: A different value for a finished scene, None if there is none.
        optional: Whether sentences may leave it out.
    """

    name: str
    draw: Callable[[np.random.Generator, Values, Distribution], Any]
    other: Callable[[np.random.Generator, Values], Any]
    optional: bool = False


@dataclass(frozen=True)
class Rendered:
    """A sentence and its meaning."""

    prompt: str
    events: tuple[SuiteEvent, ...]
    constraints: tuple[SuiteConstraint, ...] = ()


@dataclass(frozen=True)
class Rule:
    """One kind of scene.

    Args:
        name: Stable; part of scene ids.
        level: single, chain or multi_phase.
        slots: In the order they are drawn.
        render: Sentence and meaning of filled slots.
        movers: Nouns of the slot `mover`.
        weight: Within the level.
    """

    name: str
    level: str
    slots: tuple[Slot, ...]
    render: Callable[[Values], Rendered]
    movers: tuple[Noun, ...]
    weight: float = 1.0


# Slots.


def _pick(rng: np.random.Generator, items: Any) -> Any:
    return items[int(rng.integers(len(items)))]


def _mover(nouns: tuple[Noun, ...]) -> Slot:
    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> Noun:
        allowed = [n for n in nouns if not given.movers or n.name in given.movers]
        return _pick(rng, allowed)

    return Slot("mover", draw, lambda rng, values: None)


def _noun(name: str, nouns: tuple[Noun, ...]) -> Slot:
    """A noun that shares no head with the nouns before it: two crates could not be told apart."""

    def fitting(values: Values) -> list[Noun]:
        taken = {v.name.split()[-1] for k, v in values.items() if isinstance(v, Noun) and k != name}
        return [n for n in nouns if n.name.split()[-1] not in taken]

    def other(rng: np.random.Generator, values: Values) -> Noun | None:
        left = [n for n in fitting(values) if n != values[name]]
        return _pick(rng, left) if left else None

    return Slot(name, lambda rng, values, given: _pick(rng, fitting(values)), other)


def _noun_free(name: str, nouns: tuple[Noun, ...]) -> Slot:
    """A noun whose adjective tells it apart: balls of other colours."""

    def other(rng: np.random.Generator, values: Values) -> Noun | None:
        return _pick(rng, [n for n in nouns if n != values[name]])

    return Slot(name, lambda rng, values, given: _pick(rng, nouns), other)


def _speed(optional: bool = True) -> Slot:
    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> float | None:
        limits = values["mover"].speeds_mps
        if limits is None:
            return None
        thirds = ("slow", "medium", "fast")
        shares = [given.speeds.get(t, 0.0) for t in thirds]
        third = int(rng.choice(3, p=[s / sum(shares) for s in shares]))
        low, high = limits
        return _half(low + (high - low) * (third + rng.random()) / 3)

    def other(rng: np.random.Generator, values: Values) -> float | None:
        """A speed at least a third of the range away."""
        low, high = values["mover"].speeds_mps
        now, step = values["speed"], (high - low) / 3
        options = [
            v for v in (0.5 * k for k in range(round(2 * low), round(2 * high) + 1))
            if abs(v - now) >= step
        ]  # fmt: skip
        return _pick(rng, options) if options else None

    return Slot("speed", draw, other, optional)


def _mass() -> Slot:
    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> float | None:
        masses = values["mover"].masses_kg
        return _pick(rng, masses) if masses else None

    def other(rng: np.random.Generator, values: Values) -> float | None:
        left = [m for m in values["mover"].masses_kg if m != values["mass"]]
        return _pick(rng, left) if left else None

    return Slot("mass", draw, other, optional=True)


def _time(low: float, high: float, optional: bool = True) -> Slot:
    """A time in half seconds, or tenths if the range is short."""
    step = 0.5 if high - low >= 1.0 else 0.1

    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> float:
        return round(low + step * int(rng.integers(round((high - low) / step) + 1)), 3)

    return Slot("time", draw, lambda rng, values: None, optional)


def _one_of(name: str, *options: Any) -> Slot:
    return Slot(name, lambda rng, values, given: _pick(rng, options), lambda rng, values: None)


def _count(*options: int) -> Slot:
    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> int:
        return _pick(rng, [n for n in options if n <= given.max_count] or options[:1])

    return Slot("count", draw, lambda rng, values: None)


def _half(value: float) -> float:
    return round(2 * value) / 2


# Words.


def _at(values: Values, before: str = "", after: str = "") -> str:
    """The stated speed with the words around it, or nothing."""
    return f"{before}at {values['speed']:g} m/s{after}" if "speed" in values else ""


def _seconds(time: float) -> str:
    return f"{time:g} second" if time == 1 else f"{time:g} seconds"


def _heavy(values: Values, noun: Noun) -> str:
    """The noun with its article and its stated mass."""
    if "mass" in values:
        article = "an" if f"{values['mass']:g}".startswith("8") else "a"
        return f"{article} {values['mass']:g} kg {noun.name}"
    return noun.phrase


def _colored(color: str, noun: Noun) -> str:
    return f"a {color} {noun.name}" if color else noun.phrase


def _cap(text: str) -> str:
    return text[0].upper() + text[1:]


# Meaning.


def _event(number: int, kind: str, after: int | None = None, **fields: Any) -> SuiteEvent:
    data: dict[str, Any] = {"id": f"e{number}", "type": kind, **fields}
    data["after"] = (f"e{after}",) if after else ()
    return SuiteEvent.model_validate(data)


def _hit(number: int, a: str, b: str, after: int | None = None) -> SuiteEvent:
    return _event(number, "collision", after, a=a, b=b)


def _initial(quantity: Literal["mass", "speed"], obj: str, value: float) -> SuiteConstraint:
    if quantity == "mass":
        return SuiteConstraint(kind="initial", quantity="mass", object=obj, value=value, unit="kg")
    return SuiteConstraint(
        kind="initial", quantity="speed", object=obj, at="start", value=value, unit="m/s"
    )


def _stated(values: Values, obj: str) -> tuple[SuiteConstraint, ...]:
    """Constraints of the stated mass and speed of an object."""
    out: list[SuiteConstraint] = []
    if "mass" in values:
        out.append(_initial("mass", obj, values["mass"]))
    if "speed" in values:
        out.append(_initial("speed", obj, values["speed"]))
    return tuple(out)


def _when(values: Values, event: str = "e1") -> tuple[SuiteConstraint, ...]:
    if "time" not in values:
        return ()
    return (
        SuiteConstraint(
            kind="outcome", quantity="time", event=event, value=values["time"], unit="s"
        ),
    )


# Single events.


def _drive_into(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    later = f" after {_seconds(v['time'])}" if "time" in v else ""
    speed = _at(v, " driving ")
    prompt = f"{_cap(_colored(v['color'], mover))}{speed} {v['verb']} {target.phrase}{later}."
    return Rendered(
        prompt, (_hit(1, mover.name, target.name),), (*_stated(v, mover.name), *_when(v))
    )


def _roll_into(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    head = _cap(_heavy(v, mover))
    if "time" in v:
        prompt = (
            f"{head} rolls{_at(v, ' ')} toward {target.phrase} and hits it after "
            f"{_seconds(v['time'])}."
        )
    else:
        prompt = f"{head} {v['verb']} {target.phrase}{_at(v, ' ')}."
    return Rendered(
        prompt, (_hit(1, mover.name, target.name),), (*_stated(v, mover.name), *_when(v))
    )


def _throw_at(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    later = f" after {_seconds(v['time'])}" if "time" in v else ""
    prompt = (
        f"{_cap(_heavy(v, mover))} is thrown at {target.phrase}{_at(v, ' ')} and hits it{later}."
    )
    return Rendered(
        prompt, (_hit(1, mover.name, target.name),), (*_stated(v, mover.name), *_when(v))
    )


def _slide_into(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    prompt = (
        f"{_cap(_heavy(v, mover))} slides across the floor{_at(v, ' ')} and {v['verb']} "
        f"{target.phrase}."
    )
    return Rendered(prompt, (_hit(1, mover.name, target.name),), _stated(v, mover.name))


def _drop_onto(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    prompt = f"{_cap(_heavy(v, mover))} {v['verb']} {target.phrase}."
    return Rendered(prompt, (_hit(1, mover.name, target.name),), _stated(v, mover.name))


def _bowl(v: Values) -> Rendered:
    mover = v["mover"]
    number = words.NUMBER_WORDS[v["count"]]
    prompt = (
        f"{_cap(_heavy(v, mover))} rolls{_at(v, ' ')} toward {number} bowling pins and hits them."
    )
    return Rendered(prompt, (_hit(1, mover.name, "bowling pins"),), _stated(v, mover.name))


def _drive(v: Values) -> Rendered:
    mover = v["mover"]
    prompt = f"{_cap(_colored(v['color'], mover))} {v['verb']} {v['place']}{_at(v, ' ')}."
    return Rendered(prompt, (_event(1, "moves", object=mover.name),), _stated(v, mover.name))


def _roll_off(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    prompt = f"{_cap(mover.phrase)} rolls off {target.phrase}."
    fall = _event(1, "falls", object=mover.name, **{"from": target.name})
    return Rendered(prompt, (fall,))


def _head_on(v: Values) -> Rendered:
    plural = _plural(v["mover"].name)
    later = f" after {_seconds(v['time'])}" if "time" in v else ""
    prompt = f"Two {plural} {v['verb']} toward each other{_at(v, ' ')} and collide{later}."
    return Rendered(prompt, (_hit(1, plural, plural),), (*_stated(v, plural), *_when(v)))


def _plural(name: str) -> str:
    return f"{name}es" if name.endswith("s") else f"{name}s"


# Chains.


def _street_chain(v: Values) -> Rendered:
    head = f"{_cap(v['mover'].phrase)}{_at(v, ' driving ')} hits"
    return _chain(v, head)


def _floor_chain(v: Values) -> Rendered:
    return _chain(v, f"{_cap(v['mover'].phrase)} rolls{_at(v, ' ')} into")


def _chain(v: Values, head: str) -> Rendered:
    mover, middle, target = v["mover"], v["middle"], v["target"]
    sentence = v["wording"].format(
        head=head, middle=middle.phrase, it=middle.name, target=target.phrase
    )
    hits = (_hit(1, mover.name, middle.name), _hit(2, middle.name, target.name, 1))
    return Rendered(sentence, hits, _stated(v, mover.name))


def _ball_chain(v: Values) -> Rendered:
    n = v["count"]
    if v["named"] == "letters":
        names = [f"ball {letter}" for letter in "ABCDE"[:n]]
        said = names
    else:
        start = v["first_color"]
        names = [f"{words.BALL_COLORS[(start + k) % 7]} ball" for k in range(n)]
        said = [f"the {name}" for name in names]
    first = f"{_cap(said[0])} rolls{_at(v, ' ')} into {said[1]}"
    rest = [f"{said[k]} hits {said[k + 1]}" for k in range(1, n - 1)]
    prompt = ", ".join([first, *rest[:-1]]) + f", and {rest[-1]}."
    hits = tuple(_hit(k + 1, names[k], names[k + 1], k or None) for k in range(n - 1))
    return Rendered(prompt, hits, _stated(v, names[0]))


def _knock_off(v: Values) -> Rendered:
    mover, item, target = v["mover"], v["item"], v["target"]
    prompt = (
        f"{_cap(mover.phrase)} rolls across {target.phrase}, hits {item.phrase} and knocks it "
        f"off the {target.name}."
    )
    fall = _event(2, "falls", 1, object=item.name, **{"from": target.name})
    return Rendered(prompt, (_hit(1, mover.name, item.name), fall))


def _knock_over(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    prompt = v["wording"].format(
        mover=_cap(mover.phrase), speed=_at(v, " "), target=target.phrase, it=target.name
    )
    topple = _event(2, "topples", 1, object=target.name)
    return Rendered(prompt, (_hit(1, mover.name, target.name), topple), _stated(v, mover.name))


def _pocket(v: Values) -> Rendered:
    ball, pocket = v["target"], v["pocket"]
    prompt = f"The cue ball {v['verb']} the {ball.name}, sending it into {pocket}."
    name = pocket.split(" ", 1)[1]
    enters = _event(2, "enters", 1, object=ball.name, target=name)
    return Rendered(prompt, (_hit(1, "cue ball", ball.name), enters))


# Several phases.


def _brake_to_stop(v: Values) -> Rendered:
    mover, speed, time = v["mover"], v["speed"], v["time"]
    prompt = (
        f"{_cap(_colored(v['color'], mover))} is moving at {speed:g} m/s down the road. The driver "
        f"brakes, and the {mover.name} stops in {_seconds(time)}."
    )
    stop = SuiteConstraint(
        kind="outcome", quantity="time_to_stop", object=mover.name, event="e2", value=time,
        unit="s",
    )  # fmt: skip
    events = (_event(1, "moves", object=mover.name), _event(2, "stops", 1, object=mover.name))
    return Rendered(prompt, events, (*_stated(v, mover.name), stop))


def _turn_and_hit(v: Values) -> Rendered:
    mover, target, side = v["mover"], v["target"], v["side"]
    prompt = (
        f"{_cap(mover.phrase)} drives along the street{_at(v, ' ')}, turns {side} at the crossing "
        f"and then hits {target.phrase}."
    )
    turn = _event(1, "turns", object=mover.name, direction=side, degrees=90.0)
    return Rendered(prompt, (turn, _hit(2, mover.name, target.name, 1)), _stated(v, mover.name))


def _rear_end(v: Values) -> Rendered:
    mover = v["mover"].name
    prompt = (
        f"Two {_plural(mover)} drive one behind the other{_at(v, ' ')}. The front {mover} brakes "
        f"suddenly and the rear {mover} hits it after {_seconds(v['time'])}."
    )
    since = SuiteConstraint(
        kind="outcome", quantity="time_since", event="e2", since="e1", value=v["time"], unit="s"
    )
    events = (
        _event(1, "brakes", object=f"front {mover}"),
        _hit(2, f"rear {mover}", f"front {mover}", 1),
    )
    return Rendered(prompt, events, (*_stated(v, _plural(mover)), since))


def _brake_and_hit(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    prompt = (
        f"{_cap(_colored(v['color'], mover))} drives down the road{_at(v, ' ')}, brakes hard, but "
        f"still hits {target.phrase}."
    )
    events = (
        _event(1, "moves", object=mover.name),
        _event(2, "brakes", 1, object=mover.name),
        _hit(3, mover.name, target.name, 2),
    )
    return Rendered(prompt, events, _stated(v, mover.name))


_HIT_VERBS = ("hits", "crashes into", "runs into", "collides with")
_CHAIN_WORDINGS = (
    "{head} {middle}, knocking it into {target}.",
    "{head} {middle}, which then hits {target}.",
    "{head} {middle} and the {it} then crashes into {target}.",
)
_OVER_WORDINGS = (
    "{mover} rolls into {target}{speed} and knocks it over.",
    "{mover} hits {target}{speed} and the {it} topples.",
)
_LIGHT = ("cardboard box", "wooden box", "bucket", "suitcase")
"""Floor targets that a bowling ball pushes along."""
_COLOR = _one_of("color", *words.VEHICLE_COLORS)

RULES: tuple[Rule, ...] = (
    Rule(
        "drive_into", "single",
        (_mover(words.VEHICLES), _noun("target", words.STREET_TARGETS), _COLOR,
         _one_of("verb", *_HIT_VERBS), _speed(), _time(1.0, 3.0)),
        _drive_into, words.VEHICLES, 3.0,
    ),
    Rule(
        "roll_into", "single",
        (_mover(words.BALLS), _noun("target", words.FLOOR_TARGETS),
         _one_of("verb", "rolls into", "runs into", "bumps into"), _mass(), _speed(),
         _time(1.0, 2.0)),
        _roll_into, words.BALLS, 3.0,
    ),
    Rule(
        "throw_at", "single",
        (_mover(words.THROWN), _noun("target", words.THROW_TARGETS), _mass(), _time(0.6, 1.0)),
        _throw_at, words.THROWN, 1.5,
    ),
    Rule(
        "slide_into", "single",
        (_mover(words.SLIDERS), _noun("target", words.SLIDE_TARGETS),
         _one_of("verb", "hits", "bumps into"), _mass(), _speed()),
        _slide_into, words.SLIDERS, 1.5,
    ),
    Rule(
        "drop_onto", "single",
        (_mover(words.DROPPED), _noun("target", words.DROP_TARGETS),
         _one_of("verb", "is dropped onto", "falls onto")),
        _drop_onto, words.DROPPED,
    ),
    Rule(
        "bowl", "single",
        (_mover(tuple(n for n in words.BALLS if n.name == "bowling ball")),
         _count(3, 4, 5, 6, 10), _mass(), _speed(optional=False)),
        _bowl, tuple(n for n in words.BALLS if n.name == "bowling ball"), 0.7,
    ),
    Rule(
        "drive", "single",
        (_mover(words.VEHICLES), _COLOR, _one_of("verb", "drives", "moves"),
         _one_of("place", "down the street", "along the road"), _speed(optional=False)),
        _drive, words.VEHICLES, 0.7,
    ),
    Rule(
        "roll_off", "single",
        (_mover(words.ROLL_OFF), _noun("target", words.ROLL_OFF_SUPPORTS)),
        _roll_off, words.ROLL_OFF, 0.6,
    ),
    Rule(
        "head_on", "single",
        (_mover(words.VEHICLES), _one_of("verb", "drive", "move"), _speed(optional=False),
         _time(1.0, 2.0)),
        _head_on, words.VEHICLES, 0.7,
    ),
    Rule(
        "street_chain", "chain",
        (_mover(words.VEHICLES), _noun("middle", words.STREET_MOVABLES),
         _noun("target", words.STREET_ENDS), _one_of("wording", *_CHAIN_WORDINGS), _speed()),
        _street_chain, words.VEHICLES, 3.0,
    ),
    Rule(
        "floor_chain", "chain",
        (_mover(words.TOPPLERS[1:2]),
         _noun("middle", tuple(n for n in words.FLOOR_TARGETS if n.name in _LIGHT)),
         _noun("target", tuple(n for n in words.FLOOR_TARGETS if n.name not in _LIGHT)),
         _one_of("wording", *_CHAIN_WORDINGS), _speed()),
        _floor_chain, words.TOPPLERS[1:2],
    ),
    Rule(
        "ball_chain", "chain",
        (_mover(words.BALLS[:1]), _count(3, 3, 4), _one_of("named", "letters", "colors"),
         _one_of("first_color", *range(7)), _speed()),
        _ball_chain, words.BALLS[:1], 2.0,
    ),
    Rule(
        "knock_off", "chain",
        (_mover(words.TABLE_BALLS), _noun("item", words.TABLE_ITEMS),
         _noun("target", words.ROLL_OFF_SUPPORTS)),
        _knock_off, words.TABLE_BALLS,
    ),
    Rule(
        "knock_over", "chain",
        (_mover(words.TOPPLERS), _noun("target", words.TOPPLED),
         _one_of("wording", *_OVER_WORDINGS), _speed()),
        _knock_over, words.TOPPLERS, 2.0,
    ),
    Rule(
        "pocket", "chain",
        (_mover((Noun("cue ball"),)), _noun_free("target", words.POOL_BALLS),
         _one_of("verb", "strikes", "hits"),
         _one_of("pocket", "a corner pocket", "the bottom pocket", "the corner pocket")),
        _pocket, (Noun("cue ball"),), 1.0,
    ),
    Rule(
        "brake_to_stop", "multi_phase",
        (_mover(words.VEHICLES), _COLOR, _speed(optional=False),
         _time(2.5, 4.0, optional=False)),  # tyres brake with 7 m/s² at most
        _brake_to_stop, words.VEHICLES, 2.0,
    ),
    Rule(
        "turn_and_hit", "multi_phase",
        (_mover(words.VEHICLES), _noun("target", words.STREET_TARGETS),
         _one_of("side", "left", "right"), _speed()),
        _turn_and_hit, words.VEHICLES,
    ),
    Rule(
        "rear_end", "multi_phase",
        (_mover(words.VEHICLES), _speed(optional=False), _time(1.0, 2.0, optional=False)),
        _rear_end, words.VEHICLES,
    ),
    Rule(
        "brake_and_hit", "multi_phase",
        (_mover(words.VEHICLES), _noun("target", words.STREET_TARGETS), _COLOR, _speed()),
        _brake_and_hit, words.VEHICLES,
    ),
)  # fmt: skip
"""All rules."""
