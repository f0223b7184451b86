"""Reads the statements of a suite's scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, get_args

from esg.graph.models import Direction, Filming, Predicate, Side
from esg.metrics.models import OF_EVENTS, SuiteStatement
from esg.metrics.quantities import unit_factor
from esg.metrics.suite_problems import (
    Problems,
    closest,
    read_number,
    read_phrase,
    report_unknown,
    show,
)
from esg.untyped import is_list, is_object

_MOMENTS = ("start", "end", "throughout")
_SIZES = ("height", "length", "width")
_SIDES = get_args(Side)
_TARGETED = get_args(Direction)[get_args(Direction).index("toward") :]
"""Directions that are of something."""


@dataclass(frozen=True)
class _Fields:
    """What a predicate is written with.

    Args:
        needs: Fields that it cannot do without.
        may: Fields that it may have.
        quantity: Of its value, for the unit; None where it has none or names its own.
    """

    needs: tuple[str, ...]
    may: tuple[str, ...] = ()
    quantity: str | None = None


_PLACED = _Fields(("object", "target"))
_OWN = _Fields(("object",))
_PAIR = _Fields(("a", "b"))
_SPEED = _Fields(("object", "value"), ("unit",), "speed")
_FIELDS: dict[str, _Fields] = {
    **dict.fromkeys(
        ("supported_by", "inside", "hangs_from", "attached_to", "leans_on", "carried_by",
         "ends_on", "ends_in", "ends_near", "under", "left_of", "right_of", "in_front_of",
         "behind"),
        _PLACED,
    ),
    **dict.fromkeys(
        ("rolls", "slides", "spins", "tumbles", "wobbles", "airborne", "stays_upright",
         "stays_still", "at_rest"),
        _OWN,
    ),
    **dict.fromkeys(("touches", "never_touches", "same_time", "before"), _PAIR),
    **dict.fromkeys(("slower_than", "faster_than"), _SPEED),
    "above": _Fields(("object", "target"), ("distance", "unit"), "distance"),
    "moves": _Fields(("object", "direction"), ("target",)),
    **dict.fromkeys(("floats", "sinks"), _PLACED),
    "filled_with": _Fields(("object", "noun")),
    "climbs": _Fields(("object", "target", "direction"), ("value", "unit"), "height"),
    "struck_on": _Fields(("object", "target", "side")),
    "filmed": _Fields(("filming",), ("object",)),
    "size": _Fields(("object",), ("quantity", "value", "as", "unit"), "height"),
    "count": _Fields(("noun", "value")),
    "absent": _Fields(("noun",)),
    **dict.fromkeys(
        ("wears", "looks", "lit", "lies", "posture", "gives_off"), _Fields(("object", "noun"))
    ),
    "gestures": _Fields(("object", "noun"), ("target",)),
    "faces": _Fields(("object", "target")),
    "at_part": _Fields(("object", "target", "noun")),
    "weather": _Fields(("noun",)),
    "sways": _Fields(("object",), ("noun",)),
}  # fmt: skip
_PHRASES = ("object", "target", "a", "b", "noun")
_COMMON = ("id", "says", "when")


def read_statements(
    items: Any, where: str, ids: list[str], problems: Problems
) -> list[SuiteStatement]:
    """The statements of one scene; mistakes are added to `problems`.

    Args:
        items: What the file says.
        where: How messages call the scene.
        ids: Of its events.
        problems: Takes in the mistakes.
    """
    if items is None:
        return []
    if not is_list(items):
        problems.add(f"{where} /statements", f"is {show(items)}", "write a list of statements")
        return []
    broken_events = any(line.startswith(f"{where} /events") for line in problems.lines)
    out: list[SuiteStatement] = []
    seen: set[str] = set()
    for k, item in enumerate(items):
        place = f"{where} /statements/{k}"
        if not is_object(item):
            problems.add(place, f"is {show(item)}", "write {id: s1, says: rolls, object: ball}")
            continue
        before = len(problems.lines)
        values = _statement(item, place, None if broken_events else ids, problems)
        if values.get("id") in seen:
            remedy = "give each statement its own"
            problems.add(f"{place}/id", f"id {values['id']!r} is used twice", remedy)
        seen.add(str(values.get("id")))
        if len(problems.lines) == before:
            out.append(SuiteStatement.model_validate(values))
    return out


def _statement(
    item: dict[str, Any], place: str, ids: list[str] | None, problems: Problems
) -> dict[str, Any]:
    """The fields of one statement; `ids` are of the events, None where those are not known."""
    says: Any = item.get("says")
    values: dict[str, Any] = {"says": says}
    if "id" in item:
        values["id"] = read_phrase(item["id"], f"{place}/id", problems)
    else:
        problems.add(f"{place}/id", "is missing", "give a non-empty id")
    fields = _FIELDS.get(says) if isinstance(says, str) else None
    if fields is None:
        hint = closest(says, tuple(_FIELDS))
        what = f"{show(says)} is no statement"
        problems.add(f"{place}/says", what, f"{hint}choose one of {', '.join(_FIELDS)}")
        return values
    for name in fields.needs:
        if name not in item:
            problems.add(f"{place}/{name}", f"is missing in a {says!r} statement", f"add {name!r}")
    known = (*fields.needs, *fields.may)
    for name in (n for n in _PHRASES if n in item and n in known):
        values[name] = read_phrase(item[name], f"{place}/{name}", problems)
    if "direction" in known and "direction" in item:
        values |= _direction(item, values, place, problems)
    if "side" in known and "side" in item:
        values |= _side(item["side"], place, problems)
    if "filming" in known and "filming" in item:
        values |= _filming(item["filming"], place, problems)
    if says == "size":
        values |= _size(item, place, problems)
    elif "value" in known or "distance" in known:
        values |= _value(item, fields.quantity, place, problems)
    values["when"] = _when(item.get("when", "throughout"), place, ids, problems)
    if Predicate(says) in OF_EVENTS and ids is not None:
        _events(values, place, ids, problems)
    report_unknown(place, item, (*_COMMON, *known), problems)
    return values


def _direction(
    item: dict[str, Any], values: dict[str, Any], place: str, problems: Problems
) -> dict[str, Any]:
    """A direction, with what it is of behind it ("toward the wall") or as `target`."""
    text = str(item["direction"]).strip()
    word, _, of = text.partition(" ")
    known = get_args(Direction)
    if word not in known:
        hint = closest(word, known)
        remedy = f"{hint}choose one of {', '.join(known)}"
        problems.add(f"{place}/direction", f"{show(text)} is no direction", remedy)
        return {}
    target = of.strip() or values.get("target")
    if word in _TARGETED and not target:
        problems.add(f"{place}/direction", f"{word!r} is of nothing", f"write {word} and of what")
    return {"direction": word, "target": target}


def _side(said: Any, place: str, problems: Problems) -> dict[str, Any]:
    if said in _SIDES:
        return {"side": said}
    remedy = f"{closest(said, _SIDES)}choose one of {', '.join(_SIDES)}"
    problems.add(f"{place}/side", f"{show(said)} is no side", remedy)
    return {}


def _filming(said: Any, place: str, problems: Problems) -> dict[str, Any]:
    known = get_args(Filming)
    if said in known:
        return {"filming": said}
    remedy = f"{closest(said, known)}choose one of {', '.join(known)}"
    problems.add(f"{place}/filming", f"{show(said)} is no way to film", remedy)
    return {}


def _size(item: dict[str, Any], place: str, problems: Problems) -> dict[str, Any]:
    quantity = item.get("quantity")
    if quantity is not None and quantity not in _SIZES:
        problems.add(f"{place}/quantity", f"is {show(quantity)}", f"write {', '.join(_SIZES)}")
    if ("value" in item) == ("as" in item):
        what = "has both value and as" if "as" in item else "has neither value nor as"
        problems.add(place, what, "give one of them")
    values: dict[str, Any] = {"quantity": quantity}
    if "as" in item:
        values["alike"] = read_phrase(item["as"], f"{place}/as", problems)
    if "value" in item:
        values |= _value(item, "height", place, problems)
        values["quantity"] = quantity
    return values


def _value(
    item: dict[str, Any], quantity: str | None, place: str, problems: Problems
) -> dict[str, Any]:
    """The number of a statement in base units, if it has one."""
    name = "distance" if quantity == "distance" else "value"
    if name not in item:
        return {}
    number = read_number(item[name], f"{place}/{name}", problems)
    if number is None:
        return {}
    if number < 0 or (number == 0 and quantity is not None):
        problems.add(f"{place}/{name}", f"is {number:g}", "write a number above 0")
    factor = 1.0
    if quantity is not None:
        try:
            factor = unit_factor(quantity, item.get("unit"))
        except ValueError as error:
            what, _, remedy = str(error).rpartition("; ")
            problems.add(f"{place}/unit", what, remedy)
    return {"value": number * factor, "quantity": quantity or "count"}


def _when(value: Any, place: str, ids: list[str] | None, problems: Problems) -> str:
    text = str(value).strip()
    if ids is None:
        return text
    moments = text.split("..")
    wrong = [m for m in moments if m not in (*_MOMENTS, *ids)]
    if wrong or len(moments) > 2 or (len(moments) == 2 and "throughout" in moments):
        known = ", ".join((*_MOMENTS, *ids))
        remedy = f"write one of {known}, or two of them as from..to"
        problems.add(f"{place}/when", f"{show(value)} is no time", remedy)
    return text


def _events(values: dict[str, Any], place: str, ids: list[str], problems: Problems) -> None:
    for name in ("a", "b"):
        ref = values.get(name)
        if ref is not None and ref not in ids:
            known = ", ".join(ids) or "none"
            problems.add(f"{place}/{name}", f"{ref!r} is no event", f"known ids: {known}")
