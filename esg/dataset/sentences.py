"""Sentences of the scene grammar and what they mean: one function a rule (esg.dataset.rules).

Each renders one sentence (or two) from filled slots and states its events in order, in the words of
the sentence. Numbers become constraints exactly where the sentence says them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from esg.dataset import vocabulary as words
from esg.dataset.slots import Values
from esg.dataset.vocabulary import Noun
from esg.metrics.models import SuiteConstraint, SuiteEvent


@dataclass(frozen=True)
class Rendered:
    """A sentence and its meaning."""

    prompt: str
    events: tuple[SuiteEvent, ...]
    constraints: tuple[SuiteConstraint, ...] = ()


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
    return Noun(f"{color} {noun.name}").phrase if color else noun.phrase


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


def drive_into(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    later = f" after {_seconds(v['time'])}" if "time" in v else ""
    speed = _at(v, " driving ")
    prompt = f"{_cap(_colored(v['color'], mover))}{speed} {v['verb']} {target.phrase}{later}."
    return Rendered(
        prompt, (_hit(1, mover.name, target.name),), (*_stated(v, mover.name), *_when(v))
    )


def roll_into(v: Values) -> Rendered:
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


def throw_at(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    later = f" after {_seconds(v['time'])}" if "time" in v else ""
    prompt = (
        f"{_cap(_heavy(v, mover))} is thrown at {target.phrase}{_at(v, ' ')} and hits it{later}."
    )
    return Rendered(
        prompt, (_hit(1, mover.name, target.name),), (*_stated(v, mover.name), *_when(v))
    )


def slide_into(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    prompt = (
        f"{_cap(_heavy(v, mover))} slides across the floor{_at(v, ' ')} and {v['verb']} "
        f"{target.phrase}."
    )
    return Rendered(prompt, (_hit(1, mover.name, target.name),), _stated(v, mover.name))


def drop_onto(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    prompt = f"{_cap(_heavy(v, mover))} {v['verb']} {target.phrase}."
    return Rendered(prompt, (_hit(1, mover.name, target.name),), _stated(v, mover.name))


def bowl(v: Values) -> Rendered:
    mover = v["mover"]
    number = words.NUMBER_WORDS[v["count"]]
    prompt = (
        f"{_cap(_heavy(v, mover))} rolls{_at(v, ' ')} toward {number} bowling pins and hits them."
    )
    return Rendered(prompt, (_hit(1, mover.name, "bowling pins"),), _stated(v, mover.name))


def drive(v: Values) -> Rendered:
    mover = v["mover"]
    prompt = f"{_cap(_colored(v['color'], mover))} {v['verb']} {v['place']}{_at(v, ' ')}."
    return Rendered(prompt, (_event(1, "moves", object=mover.name),), _stated(v, mover.name))


def roll_off(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    prompt = f"{_cap(mover.phrase)} rolls off {target.phrase}."
    fall = _event(1, "falls", object=mover.name, **{"from": target.name})
    return Rendered(prompt, (fall,))


def head_on(v: Values) -> Rendered:
    plural = _plural(v["mover"].name)
    later = f" after {_seconds(v['time'])}" if "time" in v else ""
    prompt = f"Two {plural} {v['verb']} toward each other{_at(v, ' ')} and collide{later}."
    return Rendered(prompt, (_hit(1, plural, plural),), (*_stated(v, plural), *_when(v)))


def _plural(name: str) -> str:
    return f"{name}es" if name.endswith("s") else f"{name}s"


# Chains.


def street_chain(v: Values) -> Rendered:
    head = f"{_cap(v['mover'].phrase)}{_at(v, ' driving ')} hits"
    return _chain(v, head)


def floor_chain(v: Values) -> Rendered:
    return _chain(v, f"{_cap(v['mover'].phrase)} rolls{_at(v, ' ')} into")


def _chain(v: Values, head: str) -> Rendered:
    mover, middle, target = v["mover"], v["middle"], v["target"]
    sentence = v["wording"].format(
        head=head, middle=middle.phrase, it=middle.name, target=target.phrase
    )
    hits = (_hit(1, mover.name, middle.name), _hit(2, middle.name, target.name, 1))
    return Rendered(sentence, hits, _stated(v, mover.name))


def ball_chain(v: Values) -> Rendered:
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


def knock_off(v: Values) -> Rendered:
    mover, item, target = v["mover"], v["item"], v["target"]
    prompt = (
        f"{_cap(mover.phrase)} rolls across {target.phrase}, hits {item.phrase} and knocks it "
        f"off the {target.name}."
    )
    fall = _event(2, "falls", 1, object=item.name, **{"from": target.name})
    return Rendered(prompt, (_hit(1, mover.name, item.name), fall))


def knock_over(v: Values) -> Rendered:
    mover, target = v["mover"], v["target"]
    prompt = v["wording"].format(
        mover=_cap(mover.phrase), speed=_at(v, " "), target=target.phrase, it=target.name
    )
    topple = _event(2, "topples", 1, object=target.name)
    return Rendered(prompt, (_hit(1, mover.name, target.name), topple), _stated(v, mover.name))


def pocket(v: Values) -> Rendered:
    ball, pocket = v["target"], v["pocket"]
    prompt = f"The cue ball {v['verb']} the {ball.name}, sending it into {pocket}."
    name = pocket.split(" ", 1)[1]
    enters = _event(2, "enters", 1, object=ball.name, target=name)
    return Rendered(prompt, (_hit(1, "cue ball", ball.name), enters))


# Several phases.


def brake_to_stop(v: Values) -> Rendered:
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


def turn_and_hit(v: Values) -> Rendered:
    mover, target, side = v["mover"], v["target"], v["side"]
    prompt = (
        f"{_cap(mover.phrase)} drives along the street{_at(v, ' ')}, turns {side} at the crossing "
        f"and then hits {target.phrase}."
    )
    turn = _event(1, "turns", object=mover.name, direction=side, degrees=90.0)
    return Rendered(prompt, (turn, _hit(2, mover.name, target.name, 1)), _stated(v, mover.name))


def rear_end(v: Values) -> Rendered:
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


def brake_and_hit(v: Values) -> Rendered:
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
