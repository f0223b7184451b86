"""Reads the constraints of a suite's scene."""

from __future__ import annotations

from typing import Any, get_args

from esg.metrics.models import Quantity, SuiteConstraint, SuiteEvent
from esg.metrics.quantities import BASE_UNIT, DIMENSION_OF, unit_factor
from esg.metrics.suite_problems import Problems, closest, read_number, report_unknown, show
from esg.untyped import is_list, is_object

_CONSTRAINT_FIELDS = (
    "kind", "quantity", "object", "event", "since", "at", "target", "value", "range", "unit",
)  # fmt: skip
_NEEDS = {
    "mass": ("object",),
    "speed": ("object",),
    "speed_after": ("object", "event"),
    "time": ("event",),
    "time_since": ("event", "since"),
    "time_to_stop": ("event",),
    "distance": ("object",),
    "height": ("object",),
    "angle": ("object",),
}
START = "start"


def read_constraints(
    items: Any, where: str, ids: list[str], events: list[SuiteEvent], problems: Problems
) -> list[SuiteConstraint]:
    """The constraints of one scene; mistakes are added to `problems`."""
    if items is None:
        return []
    if not is_list(items):
        problems.add(f"{where} /constraints", f"is {show(items)}", "write a list of constraints")
        return []
    broken_events = any(line.startswith(f"{where} /events") for line in problems.lines)
    out: list[SuiteConstraint] = []
    for k, item in enumerate(items):
        place = f"{where} /constraints/{k}"
        if not is_object(item):
            problems.add(place, f"is {show(item)}", "write {kind: .., quantity: .., value: ..}")
            continue
        before = len(problems.lines)
        values = _constraint_fields(item, place, problems)
        for name in ("event", "since", "at"):
            ref = values.get(name)
            fine = ref is None or ref in ids or (ref == START and name != "event") or broken_events
            if not fine:
                known = ", ".join(ids) or "none"
                problems.add(f"{place}/{name}", f"{ref!r} is no event", f"known ids: {known}")
        if len(problems.lines) == before:
            out.append(SuiteConstraint(**values))
    return out


def _constraint_fields(item: dict[str, Any], place: str, problems: Problems) -> dict[str, Any]:
    values: dict[str, Any] = {}
    kind = item.get("kind")
    if kind not in ("initial", "outcome"):
        problems.add(f"{place}/kind", f"is {show(kind)}", "write initial or outcome")
    values["kind"] = kind
    quantity: Any = item.get("quantity")
    known = get_args(Quantity)
    if quantity not in known:
        hint = closest(quantity, known)
        problems.add(
            f"{place}/quantity",
            f"{show(quantity)} is not a quantity",
            f"{hint}choose one of {', '.join(known)}",
        )
        return values
    values["quantity"] = quantity
    for name in ("object", "event", "since", "at", "target"):
        if item.get(name) is None:
            continue
        text = item[name]
        if isinstance(text, str | int) and not isinstance(text, bool) and str(text).strip():
            values[name] = str(text).strip()
        else:
            problems.add(f"{place}/{name}", f"is {show(text)}", "write a text")
    if quantity == "speed" and "at" not in values and "event" in values:
        values["at"] = values.pop("event")
    for name in _NEEDS[quantity]:
        if name not in values and name not in item:
            problems.add(
                f"{place}/{name}", f"is missing in a {quantity!r} constraint", f"add {name!r}"
            )
    _bounds(item, quantity, values, place, problems)
    report_unknown(place, item, _CONSTRAINT_FIELDS, problems)
    return values


def _bounds(
    item: dict[str, Any], quantity: str, values: dict[str, Any], place: str, problems: Problems
) -> None:
    factor = 1.0
    try:
        factor = unit_factor(quantity, item.get("unit"))
    except ValueError as error:
        text = str(error).split("; ")
        problems.add(f"{place}/unit", text[0], text[-1])
    values["unit"] = BASE_UNIT[DIMENSION_OF[quantity]]
    has_value, has_range = item.get("value") is not None, item.get("range") is not None
    if has_value == has_range:
        what = "has both value and range" if has_value else "has neither value nor range"
        problems.add(place, what, "give one of them")
        return
    if has_value:
        number = read_number(item["value"], f"{place}/value", problems)
        if number is not None:
            _positive(number, quantity, f"{place}/value", problems)
            values["value"] = number * factor
        return
    pair = item["range"]
    if not is_list(pair) or len(pair) != 2:
        problems.add(f"{place}/range", f"is {show(pair)}", "write [low, high]")
        return
    low = read_number(pair[0], f"{place}/range/0", problems)
    high = read_number(pair[1], f"{place}/range/1", problems)
    if low is None or high is None:
        return
    if low >= high:
        remedy = f"write value: {low:g}" if low == high else f"write [{high:g}, {low:g}]"
        problems.add(f"{place}/range", f"[{low:g}, {high:g}] is not in increasing order", remedy)
        return
    _positive(low, quantity, f"{place}/range/0", problems)
    values["range"] = (low * factor, high * factor)


def _positive(number: float, quantity: str, place: str, problems: Problems) -> None:
    if number < 0 and quantity != "angle":
        problems.add(place, f"is {number:g}", f"a {quantity} is never negative")
