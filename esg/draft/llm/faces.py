"""The way that things face where a model does not say it: what they move towards, or the front."""

from __future__ import annotations

from typing import Any

from esg.graph.verifier import verify

Json = dict[str, Any]

_FRONT = "+Y"
_CARDINALS = {0.0: "+X", 90.0: "+Y", 180.0: "-X", 270.0: "-Y"}
"""Directions of the viewer by their heading [degrees]."""
TOLD, ASSUMED = 1.0, 0.5
"""Confidence of a face that a motion asks for, and of a default (`esg.commands.generate`)."""


def face(raw: Json, *, once: bool = True) -> None:
    """Gives everything that faces nothing, and has to, its one `face`.

    Args:
        raw: Document as JSON; changed in place.
        once: Whether further ones of a thing are dropped.
    """
    graph = raw["spatial_relation_graph"]
    edges: list[Json] = graph["edges"]["binary_relations"]
    seen: set[str] = set()
    kept: list[Json] = []
    for edge in edges:
        if edge["relation_type"] == "face":
            if once and edge["from"] in seen:
                continue
            seen.add(edge["from"])
        kept.append(edge)
    edges[:] = kept
    base = next((n for n, v in graph["nodes"].items() if v.get("is_structural")), None)
    if base is None:
        return
    for v in verify(raw):
        if v.code == "FACE_MISSING":
            edges.append(_facing(raw, v.pointer.rsplit("/", 1)[1], base))


def _facing(raw: Json, name: str, base: str) -> Json:
    timeline: Json = raw.get("timeline_system") or {}
    told = timeline.get("sequence_graph", {}).get("edges", ())
    own = next((e for e in told if e["actor"] == name), None)
    params: Json = own["params"] if own is not None else {}
    heading = params.get("heading_deg")
    if isinstance(heading, float) and heading % 360.0 in _CARDINALS:
        way = (heading + (180.0 if params.get("backward") else 0.0)) % 360.0
        return _edge(name, base, TOLD, _CARDINALS[way])
    if own is not None and own.get("target") not in (None, base) and not params.get("backward"):
        return _edge(name, own["target"], TOLD)
    return _edge(name, base, ASSUMED, _FRONT)


def _edge(name: str, to: str, confidence: float, cardinal: str | None = None) -> Json:
    return {
        "from": name,
        "to": to,
        "relation_type": "face",
        "confidence": confidence,
        "semantic_description": "",
        "cardinal": cardinal,
    }
