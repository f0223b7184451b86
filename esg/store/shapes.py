"""Columns with structure: what was JSON text in files of format 1 and has types since format 2.

ESG documents and manifests stay JSON text: they have schemas of their own (`schemas/`), are read
and hashed as documents, and as types they would be hundreds of columns that are mostly null.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
import json
from typing import TYPE_CHECKING, Any

from esg.store.columns import arrow_type

if TYPE_CHECKING:
    import pyarrow as pa

MEASURED = "list<struct<name: string, value: float64>>"
"""Numbers of an event or a statement; a name carries its unit."""

PARAMETERS = "list<struct<slot: string, text: string, number: float64>>"
"""Slots of the scene grammar: a number, or else a text."""

_EVENT = (
    "struct<id: string, type: string, a: string, b: string, object: string, target: string, "
    "from: string, direction: string, degrees: float64, times: int32, after: list<string>>"
)
_CONSTRAINT = (
    "struct<kind: string, quantity: string, object: string, event: string, since: string, "
    "at: string, target: string, value: float64, range: list<float64>, unit: string>"
)
_STATEMENT = (
    "struct<id: string, says: string, words: string, object: string, target: string, a: string, "
    "b: string, direction: string, side: string, quantity: string, value: float64, "
    "range: list<float64>, alike: string, noun: string, when: string, note: string>"
)
EXPECTATION = (
    f"struct<events: list<{_EVENT}>, constraints: list<{_CONSTRAINT}>, objects: list<string>, "
    f"statements: list<{_STATEMENT}>>"
)
"""A scene of a suite (esg.metrics.models.SuiteScene) without id, prompt and level."""


def measured(values: Mapping[str, float]) -> list[dict[str, Any]]:
    """Numbers by name, as a value of type MEASURED."""
    return [{"name": name, "value": values[name]} for name in sorted(values)]


def parameters(values: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Slots of the scene grammar, as a value of type PARAMETERS."""
    return [_slot(name, values[name]) for name in sorted(values)]


def _slot(name: str, value: Any) -> dict[str, Any]:
    plain = isinstance(value, int | float) and not isinstance(value, bool)
    text = value if isinstance(value, str) else json.dumps(value, sort_keys=True)
    return {"slot": name, "text": None if plain else text, "number": value if plain else None}


def expectation(scene: Mapping[str, Any]) -> dict[str, Any]:
    """The JSON of a suite's scene, as a value of type EXPECTATION."""
    return {k: scene.get(k) or [] for k in ("events", "constraints", "objects", "statements")}


SHAPED: dict[tuple[str, str], Callable[[Any], Any]] = {
    ("metrics", "measured"): measured,
    ("statements", "measured"): measured,
    ("scenes", "parameters"): parameters,
    ("scenes", "expectation"): expectation,
}
"""By table and column: what makes the typed value of the text's JSON."""


def upgraded(table: str, data: pa.Table, types: Mapping[str, str]) -> pa.Table:
    """A table of any format with the types of this one.

    Args:
        table: Its name.
        data: As it was read.
        types: Words of its columns' types in this format.

    Raises:
        ValueError: If a text is no JSON of its kind.
    """
    import pyarrow as pa

    for (owner, column), shape in SHAPED.items():
        place = data.schema.get_field_index(column) if owner == table else -1
        if place < 0 or not pa.types.is_string(data.schema.field(place).type):
            continue
        values = [None if t is None else shape(json.loads(t)) for t in data[column].to_pylist()]
        data = data.set_column(place, column, pa.array(values, arrow_type(types[column])))
    return data


def as_json_sql(column: str, word: str) -> str:
    """SQL that gives a shaped column as the JSON object that it was, for the database."""
    if word == MEASURED:
        pairs = f"list_transform({column}, lambda x: {{'k': x.name, 'v': x.value}})"
    else:
        value = "coalesce(to_json(x.number), to_json(x.text))"
        pairs = f"list_transform({column}, lambda x: {{'k': x.slot, 'v': {value}}})"
    return f"to_json(map_from_entries({pairs}))::VARCHAR"
