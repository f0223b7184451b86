"""Reads a benchmark suite: YAML to frozen models, all mistakes reported at once."""

from __future__ import annotations

from pathlib import Path
from typing import Any, get_args
from unicodedata import category

from esg.files import read_limited, safe_name
from esg.metrics.models import (
    EVENT_DEGREES,
    EVENT_FIELDS,
    EVENT_INSTEAD,
    EVENT_OPTIONAL,
    EventType,
    Suite,
    SuiteEvent,
    SuiteScene,
)
from esg.metrics.suite_constraints import START, read_constraints
from esg.metrics.suite_problems import (
    Problems,
    closest,
    kind_of,
    read_number,
    read_phrase,
    report_unknown,
    show,
)
from esg.metrics.suite_statements import read_statements
from esg.outcomes import UserError
from esg.strangers.yamlfile import MAX_CHARACTERS, read_yaml
from esg.untyped import is_list, is_object

MAX_ITEMS = 200
"""Events, constraints, statements and objects of one scene, each."""
ENOUGH_LINES = 1000
"""Mistakes after which the rest of a suite is not looked at."""
MAX_TEXT = {"id": 100, "prompt": 8000}
"""Characters: ids name folders, and longer prompts are not read as a scene."""
_SCENE_FIELDS = ("id", "level", "prompt", "events", "constraints", "objects", "statements")
SUITES = Path(__file__).parent / "data" / "suites"
_SUITE_FIELDS = ("suite", "source", "scenes")


def own_suites() -> dict[str, Path]:
    """The suites that come with the package, by name."""
    return {path.stem: path for path in sorted(SUITES.glob("*.yaml"))}


def suite_file(suite: str | Path) -> Path:
    """The file of a suite.

    Args:
        suite: Path of a file, or the name of one that comes with the package: paper.
    """
    path = Path(suite)
    return path if path.is_file() else own_suites().get(str(suite), path)


def load_suite(suite: str | Path) -> Suite:
    """Reads and checks a suite.

    Args:
        suite: Path of a file, or the name of one that comes with the package: paper.

    Raises:
        UserError: Listing every problem with scene id, field, value and remedy.
    """
    file = suite_file(suite)
    try:
        text = read_limited(file, MAX_CHARACTERS).decode()
    except FileNotFoundError:
        names = ", ".join(own_suites())
        raise UserError(f"suite {file} does not exist; give a file, or one of {names}") from None
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
    problems = Problems()
    data = _read_yaml(text, name, problems)
    suite = _suite(data, problems) if data is not None else None
    if problems.lines or suite is None:
        raise UserError(problems.told(name))
    return suite


def _read_yaml(text: str, name: str, problems: Problems) -> Any:
    data, mistakes = read_yaml(text)
    for mistake in mistakes:
        problems.add(mistake.place, mistake.what, mistake.remedy)
    if mistakes:
        return None
    if data is None:
        problems.add("file", "is empty", "write `suite: NAME` and a list of `scenes`")
        return None
    if not is_object(data):
        problems.add(
            "file",
            f"is a {kind_of(data)}, not a mapping",
            "write `suite: NAME` and a list of `scenes`",
        )
        return None
    return data


def _suite(data: dict[str, Any], problems: Problems) -> Suite | None:
    report_unknown("file", data, _SUITE_FIELDS, problems, strict=False)
    title = data.get("suite")
    if not isinstance(title, str | int) or not str(title).strip():
        problems.add("/suite", f"is {show(title)}", "give the suite a name")
    scenes = data.get("scenes")
    if not is_list(scenes) or not scenes:
        problems.add("/scenes", f"is {show(scenes)}", "list at least one scene with id and prompt")
        return None
    out: list[SuiteScene] = []
    seen: dict[str, int] = {}
    folders: dict[str, int] = {}
    for i, item in enumerate(scenes):
        if len(problems.lines) > ENOUGH_LINES:
            break
        scene = _scene(item, i, problems)
        if scene is None:
            continue
        if scene.id in seen:
            problems.add(
                f"scene {scene.id!r} (/scenes/{i}/id)",
                f"id {scene.id!r} is already used by /scenes/{seen[scene.id]}",
                "give every scene its own id",
            )
        elif (folder := safe_name(f"{scene.id}-run0")) in folders:
            problems.add(
                f"scene {scene.id!r} (/scenes/{i}/id)",
                f"its folder would be {folder!r}, as that of /scenes/{folders[folder]}",
                "let ids differ in letters, digits, '.', '_' or '-'",
            )
        else:
            folders[folder] = i
        seen.setdefault(scene.id, i)
        out.append(scene)
    if problems.lines:
        return None
    return Suite(suite=str(title), source=str(data.get("source") or ""), scenes=tuple(out))


def _scene(item: Any, index: int, problems: Problems) -> SuiteScene | None:
    place = f"/scenes/{index}"
    if not is_object(item):
        problems.add(place, f"is {show(item)}", "write a mapping with id, prompt and events")
        return None
    before = len(problems.lines)
    scene_id = _text(item, "id", place, problems)
    where = f"scene {scene_id!r}" if scene_id else place
    prompt = _text(item, "prompt", where, problems)
    report_unknown(where, item, _SCENE_FIELDS, problems, strict=False)
    for name in ("events", "constraints", "statements", "objects"):
        if is_list(found := item.get(name)) and len(found) > MAX_ITEMS:
            problems.add(f"{where} /{name}", f"has {len(found)}", f"list {MAX_ITEMS} at most")
            item = {**item, name: None}
    events = _events(item.get("events"), where, problems)
    ids = [e.id for e in events]
    constraints = read_constraints(item.get("constraints"), where, ids, events, problems)
    statements = read_statements(item.get("statements"), where, ids, problems)
    objects: Any = item.get("objects") or []
    if not is_list(objects) or not all(isinstance(o, str) and o.strip() for o in objects):
        problems.add(f"{where} /objects", f"is {show(objects)}", "list noun phrases")
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
        statements=tuple(statements),
    )


def _events(items: Any, where: str, problems: Problems) -> list[SuiteEvent]:
    if items is None:
        return []
    if not is_list(items):
        problems.add(f"{where} /events", f"is {show(items)}", "write a list of events")
        return []
    declared = [str(e.get("id")) for e in items if is_object(e) and e.get("id") is not None]
    out: list[SuiteEvent] = []
    previous: str | None = None
    for k, item in enumerate(items):
        place = f"{where} /events/{k}"
        if not is_object(item):
            problems.add(place, f"is {show(item)}", "write {id: e1, type: collision, a: .., b: ..}")
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


def _event_fields(item: dict[str, Any], place: str, problems: Problems) -> dict[str, Any]:
    kind: Any = item.get("type")
    types = get_args(EventType)
    if kind not in types:
        hint = closest(kind, types)
        problems.add(
            f"{place}/type",
            f"{show(kind)} is not an event type",
            f"{hint}choose one of {', '.join(types)}",
        )
        return {}
    required = EVENT_FIELDS[kind]
    instead = EVENT_INSTEAD.get(kind, ())
    if any(name in item for name in instead) and not any(name in item for name in required):
        required = instead
    optional = EVENT_OPTIONAL.get(kind, ())
    values: dict[str, Any] = {"type": kind}
    if kind in EVENT_DEGREES:
        values["degrees"] = EVENT_DEGREES[kind]
    for name in (*required, *optional):
        if name in item:
            values[name] = _event_field(name, item[name], f"{place}/{name}", problems)
        elif name in required:
            problems.add(f"{place}/{name}", f"is missing in a {kind!r} event", f"add {name!r}")
    report_unknown(place, item, ("id", "type", "after", *required, *optional), problems)
    return values


def _event_field(name: str, value: Any, place: str, problems: Problems) -> Any:
    if name == "degrees":
        degrees = read_number(value, place, problems)
        if degrees is not None and not 0 < degrees <= 3600:
            problems.add(place, f"is {degrees:g}", "give an angle above 0")
        return degrees
    if name == "times":
        if isinstance(value, bool) or not isinstance(value, int) or not 0 < value <= 1000:
            problems.add(place, f"is {show(value)}", "write how often, from 1 on")
        return value
    if name == "direction":
        if value not in ("left", "right"):
            problems.add(place, f"is {show(value)}", "write left or right")
        return value
    return read_phrase(value, place, problems)


def _after(
    item: dict[str, Any],
    place: str,
    event_id: str,
    previous: str | None,
    earlier: list[str],
    declared: list[str],
    problems: Problems,
) -> tuple[str, ...]:
    if "after" not in item:
        return (previous,) if previous else ()
    after = item["after"]
    if after is None:
        return ()
    refs = after if is_list(after) else [after]
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
            problems.add(f"{place}/after", f"{show(ref)} is no event", f"known ids: {known}")
    return tuple(dict.fromkeys(out))


def _text(item: dict[str, Any], name: str, place: str, problems: Problems) -> str:
    value = item.get(name)
    if isinstance(value, str | int) and not isinstance(value, bool) and str(value).strip():
        text = str(value).strip()
        if len(text) > MAX_TEXT[name]:
            what = f"has {len(text)} characters"
            problems.add(f"{place}/{name}", what, f"write {MAX_TEXT[name]} at most")
            return ""
        if any(category(c) in ("Cc", "Cs") and c not in "\t\n\r" for c in text):
            problems.add(f"{place}/{name}", "holds a control character", "write plain text")
            return ""
        return text
    what = f"is {show(value)}" if name in item else "is missing"
    problems.add(f"{place} /{name}" if place.startswith("scene") else f"{place}/{name}", what,
                 f"give a non-empty {name}")  # fmt: skip
    return ""
