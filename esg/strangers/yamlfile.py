"""YAML of strangers: plain values, read in time and memory that grow with the text alone.

A few hundred bytes of aliases to aliases stand for more values than any memory holds, deep nesting
overflows the stack, and a number of a million digits takes minutes. What is written is counted
before anything is made of it.
"""

from __future__ import annotations

import contextlib
from dataclasses import dataclass, field
from typing import Any

SHORT = 100_000
"""Characters up to which a text is read for the sake of its messages."""
MAX_CHARACTERS = 4 * 2**20
MAX_VALUES = 200_000
"""Values in a document, what aliases repeat included."""
MAX_DEPTH = 60
MAX_NUMBER_CHARACTERS = 60


@dataclass(frozen=True)
class Mistake:
    """What is wrong with a YAML text.

    Args:
        place: Line and column, or the file.
        what: Is wrong there.
        remedy: What to do about it.
    """

    place: str
    what: str
    remedy: str


@dataclass
class _Reading:
    """What is known while the nodes of a text are looked at.

    Args:
        mistakes: Found so far.
        sizes: Values that a node stands for, by its id; 0 while its parts are counted.
        too_much: Whether one stands for too many; what it is part of is not told of then.
    """

    mistakes: list[Mistake] = field(default_factory=list[Mistake])
    sizes: dict[int, int] = field(default_factory=dict[int, int])
    too_much: bool = False


def read_yaml(text: str) -> tuple[Any, list[Mistake]]:
    """The plain values of a YAML (or JSON) text.

    Args:
        text: One document.

    Returns:
        The value, and what is wrong with it; with mistakes the value is None.
    """
    import yaml

    if len(text) > MAX_CHARACTERS:
        what = f"has {len(text)} characters"
        return None, [Mistake("file", what, f"write {MAX_CHARACTERS} at most")]
    fast: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    # Python's own parser knows better where a mistake is, and takes 20 s for a megabyte.
    thorough = len(text) < SHORT
    try:
        with contextlib.suppress(*((yaml.YAMLError,) if thorough else ())):
            unbounded = _unbounded(yaml, yaml.parse(text, Loader=fast))
            if unbounded is not None:
                return None, [unbounded]
        node = yaml.compose(text, Loader=yaml.SafeLoader if thorough else fast)
        if node is None:
            return None, []
        reading = _Reading()
        _count(yaml, node, reading)
        if reading.mistakes:
            return None, reading.mistakes
        return yaml.SafeLoader("").construct_document(node), []
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        place = f"line {mark.line + 1}, column {mark.column + 1}" if mark else "file"
        problem = getattr(error, "problem", None) or str(error).splitlines()[0]
        return None, [Mistake(place, f"not valid YAML ({problem})", "fix the syntax")]
    except (
        RecursionError,
        ValueError,
        TypeError,
        OverflowError,
        AttributeError,
        KeyError,
    ) as error:
        # PyYAML meets dates of month 13, `!!bool maybe` and the like with any of them.
        return None, [Mistake("file", f"not readable YAML ({type(error).__name__})",
                              "fix the syntax")]  # fmt: skip


def _unbounded(yaml: Any, events: Any) -> Mistake | None:
    """What of a text is too much, if anything; reads no further than that."""
    depth = values = 0
    for event in events:
        if isinstance(event, (yaml.MappingStartEvent, yaml.SequenceStartEvent)):
            depth += 1
        elif isinstance(event, (yaml.MappingEndEvent, yaml.SequenceEndEvent)):
            depth -= 1
            continue
        elif not isinstance(event, (yaml.ScalarEvent, yaml.AliasEvent)):
            continue
        values += 1
        if depth > MAX_DEPTH:
            return Mistake(_line(event), "is nested too deeply", f"use {MAX_DEPTH} levels at most")
        if values > MAX_VALUES:
            return Mistake(_line(event), "is one value too many", f"write {MAX_VALUES} at most")
    return None


def _count(yaml: Any, node: Any, reading: _Reading) -> int:
    """How many values a node stands for, aliases counted each time they are used."""
    known = reading.sizes.get(id(node))
    if known is not None:
        if known == 0:
            reading.mistakes.append(
                Mistake(_line(node), "contains itself", "write aliases to finished values only")
            )
        return max(known, 1)
    reading.sizes[id(node)] = 0
    size = 1
    if isinstance(node, yaml.ScalarNode):
        if node.tag.endswith((":int", ":float")) and len(node.value) > MAX_NUMBER_CHARACTERS:
            what = f"is a number of {len(node.value)} characters"
            reading.mistakes.append(Mistake(_line(node), what, "write a shorter one"))
    else:
        pairs = node.value if isinstance(node, yaml.MappingNode) else ()
        _report_repeated([key for key, _ in pairs], reading)
        for child in [n for pair in pairs for n in pair] or node.value:
            size += _count(yaml, child, reading)
    if size > MAX_VALUES and not reading.too_much:
        reading.too_much = True
        what = f"stands for more than {MAX_VALUES} values"
        reading.mistakes.append(Mistake(_line(node), what, "repeat less with aliases"))
    reading.sizes[id(node)] = size
    return size


def _report_repeated(keys: list[Any], reading: _Reading) -> None:
    """YAML keeps only the last of repeated keys, without a word."""
    seen: set[str] = set()
    for key in keys:
        name = str(key.value) if isinstance(key.value, str) else ""
        if name and name in seen:
            what = f"key {name!r} is repeated"
            reading.mistakes.append(Mistake(_line(key), what, "keep one of them"))
        seen.add(name)


def _line(thing: Any) -> str:
    return f"line {thing.start_mark.line + 1}"
