"""Reads a benchmark suite: YAML to frozen models, all mistakes reported at once."""

from __future__ import annotations

import difflib
import math
from pathlib import Path
from typing import Any, get_args

from esg.metrics.models import (
    EVENT_FIELDS,
    EVENT_OPTIONAL,
    EventType,
    Quantity,
    Suite,
    SuiteConstraint,
    SuiteEvent,
    SuiteScene,
)
from esg.metrics.quantities import BASE_UNIT, DIMENSION_OF, unit_factor
from esg.outcomes import UserError

_SCENE_FIELDS = ("id", "level", "prompt", "events", "constraints", "objects")
_SUITE_FIELDS = ("suite", "source", "scenes")
_CONSTRAINT_FIELDS = (
    "kind", "quantity", "object", "event", "since", "at", "target", "value", "range", "unit",
)  # fmt: skip
_NOTES = ("note", "notes", "comment", "description", "text", "source", "tags")
"""Annotations that may stand anywhere and mean nothing to the judge."""
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


class _Problems:
    """Collects mistakes with their place."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def add(self, place: str, what: str, remedy: str) -> None:
        self.lines.append(f"{place}: {what}; {remedy}")


def load_suite(path: str | Path) -> Suite:
    """Reads and checks a suite file.

    Raises:
        UserError: Listing every problem with scene id, field, value and remedy.
    """
    file = Path(path)
    try:
        text = file.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise UserError(f"suite {file} does not exist; check the path") from None
    except IsADirectoryError:
        raise UserError(f"suite {file} is a folder; name the .yaml file in it") from None
    except UnicodeDecodeError:
        raise UserError(f"suite {file} is not UTF-8 text; save it as UTF-8 YAML") from None
    except OSError as error:
        raise UserError(f"suite {file} cannot be read: {error.strerror}") from None
    return parse_suite(text, name=str(file))


def parse_suite(text: str, *, name: str = "suite") -> Suite:
    """Parses and checks the text of a suite.

    Args:
        text: YAML.
        name: How messages call the file.

    Raises:
        UserError: Listing every problem with scene id, field, value and remedy.
    """
    problems = _Problems()
    data = _read_yaml(text, name, problems)
    suite = _suite(data, problems) if data is not None else None
    if problems.lines or suite is None:
        n = len(problems.lines)
        lines = "\n".join(f"  {line}" for line in problems.lines)
        raise UserError(f"{name}: {n} problem{'s' if n != 1 else ''}\n{lines}")
    return suite


def _read_yaml(text: str, name: str, problems: _Problems) -> Any:
    import yaml

    class Loader(yaml.SafeLoader):
        """Safe loader that notices repeated keys (YAML keeps only the last one)."""

    def mapping(loader: Any, node: Any, deep: bool = False) -> Any:
        seen: set[str] = set()
        for key_node, _ in node.value:
            key = str(key_node.value)
            if key in seen:
                line = key_node.start_mark.line + 1
                problems.add(f"line {line}", f"key {key!r} is repeated", "keep one of them")
            seen.add(key)
        return yaml.SafeLoader.construct_mapping(loader, node, deep=deep)

    Loader.add_constructor(
        yaml.resolver.BaseResolver.DEFAULT_MAPPING_TAG, lambda ld, n: mapping(ld, n, deep=True)
    )
    try:
        data = yaml.load(text, Loader=Loader)  # a SafeLoader subclass: no arbitrary objects
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        place = f"line {mark.line + 1}, column {mark.column + 1}" if mark else "file"
        problem = getattr(error, "problem", None) or str(error).splitlines()[0]
        problems.add(place, f"not valid YAML ({problem})", "fix the syntax")
        return None
    except (RecursionError, ValueError, TypeError) as error:
        problems.add("file", f"not readable YAML ({type(error).__name__})", "fix the syntax")
        return None
    if data is None:
        problems.add("file", "is empty", "write `suite: NAME` and a list of `scenes`")
        return None
    if not isinstance(data, dict):
        problems.add(
            "file",
            f"is a {_kind(data)}, not a mapping",
            "write `suite: NAME` and a list of `scenes`",
        )
        return None
    return data


def _suite(data: dict[Any, Any], problems: _Problems) -> Suite | None:
    _unknown("file", data, _SUITE_FIELDS, problems, strict=False)
    title = data.get("suite")
    if not isinstance(title, str | int) or not str(title).strip():
        problems.add("/suite", f"is {title!r}", "give the suite a name")
    scenes = data.get("scenes")
    if not isinstance(scenes, list) or not scenes:
        problems.add("/scenes", f"is {_show(scenes)}", "list at least one scene with id and prompt")
        return None
    out: list[SuiteScene] = []
    seen: dict[str, int] = {}
    for i, item in enumerate(scenes):
        scene = _scene(item, i, problems)
        if scene is None:
            continue
        if scene.id in seen:
            problems.add(
                f"scene {scene.id!r} (/scenes/{i}/id)",
                f"id {scene.id!r} is already used by /scenes/{seen[scene.id]}",
                "give every scene its own id",
            )
        seen.setdefault(scene.id, i)
        out.append(scene)
    if problems.lines:
        return None
    return Suite(suite=str(title), source=str(data.get("source") or ""), scenes=tuple(out))


def _scene(item: Any, index: int, problems: _Problems) -> SuiteScene | None:
    place = f"/scenes/{index}"
    if not isinstance(item, dict):
        problems.add(place, f"is {_show(item)}", "write a mapping with id, prompt and events")
        return None
    before = len(problems.lines)
    scene_id = _text(item, "id", place, problems)
    where = f"scene {scene_id!r}" if scene_id else place
    prompt = _text(item, "prompt", where, problems)
    _unknown(where, item, _SCENE_FIELDS, problems, strict=False)
    events = _events(item.get("events"), where, problems)
    ids = [e.id for e in events]
    constraints = _constraints(item.get("constraints"), where, ids, events, problems)
    objects = item.get("objects") or []
    if not isinstance(objects, list) or not all(isinstance(o, str) and o.strip() for o in objects):
        problems.add(f"{where} /objects", f"is {_show(objects)}", "list noun phrases")
        objects = []
    if len(problems.lines) > before or not scene_id or not prompt:
        # The caller still needs the id to find duplicates.
        return SuiteScene(id=scene_id, prompt=prompt or "?") if scene_id else None
    return SuiteScene(
        id=scene_id,
        level=str(item.get("level") or ""),
        prompt=prompt,
        events=tuple(events),
        constraints=tuple(constraints),
        objects=tuple(objects),
    )


def _events(items: Any, where: str, problems: _Problems) -> list[SuiteEvent]:
    if items is None:
        return []
    if not isinstance(items, list):
        problems.add(f"{where} /events", f"is {_show(items)}", "write a list of events")
        return []
    declared = [str(e.get("id")) for e in items if isinstance(e, dict) and e.get("id") is not None]
    out: list[SuiteEvent] = []
    previous: str | None = None
    for k, item in enumerate(items):
        place = f"{where} /events/{k}"
        if not isinstance(item, dict):
            problems.add(
                place, f"is {_show(item)}", "write {id: e1, type: collision, a: .., b: ..}"
            )
            continue
        before = len(problems.lines)
        event_id = _text(item, "id", place, problems)
        if event_id == START:
            problems.add(f"{place}/id", "'start' means the scene start", "choose another id")
        if event_id and declared.index(event_id) < k and event_id in declared[:k]:
            problems.add(f"{place}/id", f"id {event_id!r} is used twice", "give each event its own")
        values = _event_fields(item, place, problems)
        after = _after(item, place, event_id, previous, declared[:k], declared, problems)
        previous = event_id or previous
        if len(problems.lines) == before and event_id:
            out.append(SuiteEvent(id=event_id, after=after, **values))
    return out


def _event_fields(item: dict[Any, Any], place: str, problems: _Problems) -> dict[str, Any]:
    kind: Any = item.get("type")
    types = get_args(EventType)
    if kind not in types:
        hint = _closest(kind, types)
        problems.add(
            f"{place}/type",
            f"{_show(kind)} is not an event type",
            f"{hint}choose one of {', '.join(types)}",
        )
        return {}
    required = EVENT_FIELDS[kind]
    optional = EVENT_OPTIONAL.get(kind, ())
    values: dict[str, Any] = {"type": kind}
    for name in (*required, *optional):
        if name == "degrees":
            if "degrees" in item:
                degrees = _number(item["degrees"], f"{place}/degrees", problems)
                if degrees is not None and not 0 < degrees <= 3600:
                    problems.add(f"{place}/degrees", f"is {degrees:g}", "give an angle above 0")
                values["degrees"] = degrees
            continue
        if name not in item:
            if name in required:
                problems.add(f"{place}/{name}", f"is missing in a {kind!r} event", f"add {name!r}")
            continue
        text = item[name]
        if name == "direction":
            if text not in ("left", "right"):
                problems.add(f"{place}/direction", f"is {_show(text)}", "write left or right")
            values[name] = text
        elif isinstance(text, str | int) and not isinstance(text, bool) and str(text).strip():
            values[name] = str(text).strip()
        else:
            problems.add(f"{place}/{name}", f"is {_show(text)}", "write a noun phrase")
    _unknown(place, item, ("id", "type", "after", *required, *optional), problems)
    return values


def _after(
    item: dict[Any, Any],
    place: str,
    event_id: str,
    previous: str | None,
    earlier: list[str],
    declared: list[str],
    problems: _Problems,
) -> tuple[str, ...]:
    if "after" not in item:
        return (previous,) if previous else ()
    after = item["after"]
    if after is None:
        return ()
    refs = after if isinstance(after, list) else [after]
    out: list[str] = []
    for ref in refs:
        name = str(ref)
        if name == event_id:
            problems.add(f"{place}/after", f"{name!r} refers to itself", "name an earlier event")
        elif name in earlier:
            out.append(name)
        elif name in declared:
            problems.add(
                f"{place}/after",
                f"{name!r} stands later in the list",
                "list events in causal order",
            )
        else:
            known = ", ".join(earlier) or "none before this one"
            problems.add(f"{place}/after", f"{_show(ref)} is no event", f"known ids: {known}")
    return tuple(dict.fromkeys(out))


def _constraints(
    items: Any, where: str, ids: list[str], events: list[SuiteEvent], problems: _Problems
) -> list[SuiteConstraint]:
    if items is None:
        return []
    if not isinstance(items, list):
        problems.add(f"{where} /constraints", f"is {_show(items)}", "write a list of constraints")
        return []
    broken_events = any(line.startswith(f"{where} /events") for line in problems.lines)
    out: list[SuiteConstraint] = []
    for k, item in enumerate(items):
        place = f"{where} /constraints/{k}"
        if not isinstance(item, dict):
            problems.add(place, f"is {_show(item)}", "write {kind: .., quantity: .., value: ..}")
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


def _constraint_fields(item: dict[Any, Any], place: str, problems: _Problems) -> dict[str, Any]:
    values: dict[str, Any] = {}
    kind = item.get("kind")
    if kind not in ("initial", "outcome"):
        problems.add(f"{place}/kind", f"is {_show(kind)}", "write initial or outcome")
    values["kind"] = kind
    quantity: Any = item.get("quantity")
    known = get_args(Quantity)
    if quantity not in known:
        hint = _closest(quantity, known)
        problems.add(
            f"{place}/quantity",
            f"{_show(quantity)} is not a quantity",
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
            problems.add(f"{place}/{name}", f"is {_show(text)}", "write a text")
    if quantity == "speed" and "at" not in values and "event" in values:
        values["at"] = values.pop("event")
    for name in _NEEDS[quantity]:
        if name not in values and name not in item:
            problems.add(
                f"{place}/{name}", f"is missing in a {quantity!r} constraint", f"add {name!r}"
            )
    _bounds(item, quantity, values, place, problems)
    _unknown(place, item, _CONSTRAINT_FIELDS, problems)
    return values


def _bounds(
    item: dict[Any, Any], quantity: str, values: dict[str, Any], place: str, problems: _Problems
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
        number = _number(item["value"], f"{place}/value", problems)
        if number is not None:
            _positive(number, quantity, f"{place}/value", problems)
            values["value"] = number * factor
        return
    pair = item["range"]
    if not isinstance(pair, list) or len(pair) != 2:
        problems.add(f"{place}/range", f"is {_show(pair)}", "write [low, high]")
        return
    low = _number(pair[0], f"{place}/range/0", problems)
    high = _number(pair[1], f"{place}/range/1", problems)
    if low is None or high is None:
        return
    if low >= high:
        remedy = f"write value: {low:g}" if low == high else f"write [{high:g}, {low:g}]"
        problems.add(f"{place}/range", f"[{low:g}, {high:g}] is not in increasing order", remedy)
        return
    _positive(low, quantity, f"{place}/range/0", problems)
    values["range"] = (low * factor, high * factor)


def _positive(number: float, quantity: str, place: str, problems: _Problems) -> None:
    if number < 0 and quantity != "angle":
        problems.add(place, f"is {number:g}", f"a {quantity} is never negative")


def _number(value: Any, place: str, problems: _Problems) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        problems.add(place, f"is {_show(value)}", "write a plain number, with the unit in `unit`")
        return None
    if not math.isfinite(value):
        problems.add(place, f"is {value}", "write a finite number")
        return None
    return float(value)


def _text(item: dict[Any, Any], name: str, place: str, problems: _Problems) -> str:
    value = item.get(name)
    if isinstance(value, str | int) and not isinstance(value, bool) and str(value).strip():
        return str(value).strip()
    what = f"is {_show(value)}" if name in item else "is missing"
    problems.add(f"{place} /{name}" if place.startswith("scene") else f"{place}/{name}", what,
                 f"give a non-empty {name}")  # fmt: skip
    return ""


def _unknown(
    place: str,
    item: dict[Any, Any],
    known: tuple[str, ...],
    problems: _Problems,
    *,
    strict: bool = True,
) -> None:
    """Reports fields that would be ignored; where free metadata is allowed, only misspelt ones."""
    for key in item:
        if key in known or str(key) in _NOTES:
            continue
        close = difflib.get_close_matches(str(key), known, n=1, cutoff=0.75)
        if close:
            problems.add(f"{place}/{key}", "is not a field", f"did you mean {close[0]!r}?")
        elif strict:
            problems.add(f"{place}/{key}", "is not a field", f"fields are {', '.join(known)}")


def _closest(value: Any, known: tuple[str, ...]) -> str:
    match = difflib.get_close_matches(str(value), known, n=1, cutoff=0.6)
    return f"did you mean {match[0]!r}? " if match else ""


def _kind(value: Any) -> str:
    return {"list": "list", "str": "text", "int": "number", "float": "number"}.get(
        type(value).__name__, type(value).__name__
    )


def _show(value: Any) -> str:
    if value is None:
        return "missing"
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."
