"""The JSON Schema of a request: bounded for small models, closed over names settled before."""

from __future__ import annotations

from collections.abc import Sequence
import copy
from functools import cache
from typing import Any

from esg.draft.llm.small import SmallReply
from esg.draft.llm.stages import REPLIES
from esg.untyped import is_list, is_object


def bounded(schema: Any, items: int | None, text: int | None) -> Any:
    """A JSON Schema whose lists and free texts end, for servers that sample by grammar.

    Args:
        schema: JSON Schema.
        items: Most items of every list; None leaves lists open.
        text: Most characters of every text without a list of allowed words; None leaves it open.

    Returns:
        A copy with maxItems and maxLength.
    """
    if is_list(schema):
        return [bounded(x, items, text) for x in schema]
    if not is_object(schema):
        return schema
    out = {k: bounded(v, items, text) for k, v in schema.items()}
    if items is not None and out.get("type") == "array":
        most = min(items, out.get("maxItems", items))
        out["maxItems"] = max(most, out.get("minItems", 0))
    if text is not None and out.get("type") == "string" and not {"enum", "const"} & out.keys():
        out["maxLength"] = text
    return out


_OBJECT_FIELDS: dict[str, tuple[str, ...]] = {
    "RegionPart": ("parent",),
    "PlacementPart": ("object",),
    "RelationPart": ("subject", "object"),
    "GroupRelationPart": ("subjects", "targets"),
    "StatementPart": ("target",),
    "ActorPart": ("object",),
    "ConstraintPart": ("object", "to"),
    "EventPart": ("participants",),
    "SegmentPart": ("actor", "target"),
}
MAX_NAMES = 200
"""Most names of a closed list; beyond it a schema would outgrow what servers accept."""


def settled(schema: dict[str, Any], objects: Sequence[str], events: int | None = None) -> Any:
    """A stage's schema in which references can only be what was settled before.

    A server that samples by schema then cannot misspell a name or make one up.

    Args:
        schema: JSON Schema of the spatial or timeline reply; others come back unchanged.
        objects: Names of the objects.
        events: Also number the point events e1 to this, and lead segments from and to these only;
            None leaves the events' names open.

    Returns:
        A copy.
    """
    out = copy.deepcopy(schema)
    defs = out.get("$defs", {})
    parts = [p for p in _OBJECT_FIELDS if p in defs]
    if not parts or not objects or len(objects) > MAX_NAMES:
        return out
    defs["ObjectName"] = {"type": "string", "enum": list(dict.fromkeys(objects))}
    for part in parts:
        for name in _OBJECT_FIELDS[part]:
            _refer(defs[part]["properties"], name, "ObjectName")
    if events is not None and "SegmentPart" in defs:
        ids = [f"e{k + 1}" for k in range(max(1, events))]
        defs["EventName"] = {"type": "string", "enum": ids}
        defs["EarlierName"] = {"type": "string", "enum": ["scene_start", *ids]}
        _refer(defs["EventPart"]["properties"], "id", "EventName")
        _refer(defs["ConstraintPart"]["properties"], "since", "EarlierName")
        _refer(defs["SegmentPart"]["properties"], "start", "EarlierName")
        _refer(defs["SegmentPart"]["properties"], "end", "EventName")
    return out


def _refer(properties: dict[str, Any], name: str, target: str) -> None:
    """Replaces a text or a list of texts by (a list of) one definition."""
    old, new = properties[name], {"$ref": f"#/$defs/{target}"}
    if old.get("type") == "array":
        old["items"] = new
    else:
        properties[name] = new


@cache
def schema_of(stage: str) -> dict[str, Any]:
    """JSON Schema of a stage's reply, as short as it can be said: it is sent with every request.

    What may be left out is not also offered as null; titles and defaults tell a model nothing.
    """
    shape = SmallReply if stage == "small" else REPLIES[stage]
    return _short(shape.model_json_schema())


def _short(schema: Any) -> Any:
    if is_list(schema):
        return [_short(x) for x in schema]
    if not is_object(schema):
        return schema
    out = {
        k: {name: _short(x) for name, x in v.items()} if k in ("properties", "$defs") else _short(v)
        for k, v in schema.items()
        if k not in ("title", "default")
    }
    choices = [c for c in out.get("anyOf", ()) if c != {"type": "null"}]
    if len(choices) == 1:
        del out["anyOf"]
        out = {**choices[0], **out}
    if out.get("type") == "object" or "enum" in out:
        out.pop("description", None)  # docstrings are for people
    return out
