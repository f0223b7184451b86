"""The last resort for a timeline that a model cannot mend: drop what no rule allows, and say so.

Nothing is added or guessed. A time that cannot be becomes open, a constraint, target, segment or
event that breaks a rule goes, mildest first, and each is named in the record and in a warning.
"""

from __future__ import annotations

from collections.abc import Callable
import copy
import re
from typing import Any

from esg.graph.rules_events import TIME_S
from esg.graph.verifier import verify
from esg.graph.violations import Violation

Json = dict[str, Any]

_PLACE = re.compile(
    r"/timeline_system/sequence_graph/(nodes|edges)/(\d+)(?:/([a-z_]+)(?:/(\d+))?)?"
)
_ACTOR = re.compile(r"/timeline_system/actors/([^/]+)")
_TIMES = ("timestamp", "window", "time_is_prescribed")
MAX_PASSES = 12
OPEN_S = (0.1, 2.0)
"""Window of an event whose time is left open, after what comes before it [s]."""


def pruned(raw: Json) -> tuple[Json, tuple[str, ...]]:
    """A document whose timeline holds every rule, or as good as it gets.

    Args:
        raw: Document as JSON; it is not changed.

    Returns:
        The document, and what was dropped, in words. Without a single event left, or with a rule
        broken outside the timeline, the document comes back as it was.
    """
    out = copy.deepcopy(raw)
    log: list[str] = []
    for _ in range(MAX_PASSES):
        violations = verify(out)
        if not violations:
            break
        if not all(v.pointer.startswith("/timeline_system") for v in violations):
            return raw, ()
        if not any(step(out, violations, log) for step in _STEPS):
            return raw, ()
    if verify(out) or len(_nodes(out)) < 2 <= len(_nodes(raw)):
        return raw, ()
    return out, tuple(log)


def _nodes(raw: Json) -> list[Json]:
    timeline: Json = raw.get("timeline_system") or {}
    return timeline.get("sequence_graph", {}).get("nodes", [])


def _edges(raw: Json) -> list[Json]:
    return raw["timeline_system"]["sequence_graph"]["edges"]


def _parts(violations: tuple[Violation, ...], kind: str) -> list[tuple[int, str, int | None]]:
    """Index, field and item of every violation on a node or an edge, the last first."""
    found: set[tuple[int, str, int | None]] = set()
    for v in violations:
        m = _PLACE.match(v.pointer)
        if m is not None and m[1] == kind:
            found.add((int(m[2]), m[3] or "", int(m[4]) if m[4] else None))
    return sorted(found, key=lambda x: (x[0], x[2] or 0), reverse=True)


def _constraints(raw: Json, violations: tuple[Violation, ...], log: list[str]) -> bool:
    done = False
    for k, name, item in _parts(violations, "nodes"):
        node = _nodes(raw)[k]
        if name == "constraints" and item is not None and item < len(node["constraints"]):
            gone = node["constraints"].pop(item)
            log.append(f"constraint {gone['quantity']} of {gone['object']!r} dropped")
            done = True
    return done


def _times(raw: Json, violations: tuple[Violation, ...], log: list[str]) -> bool:
    """Opens times that are out of range or out of order, in the order of the segments."""
    broken = {k for k, name, _ in _parts(violations, "nodes") if name in _TIMES}
    named = {v.code for v in violations} & {"WINDOW_ORDER", "TIME_ORDER", "TIME_RANGE"}
    if not broken and not named:
        return False
    nodes = _nodes(raw)
    before = copy.deepcopy(nodes)
    bad = {nodes[k]["id"] for k in broken}
    ends: dict[str, tuple[float, float]] = {nodes[0]["id"]: (0.0, 0.0)}
    for node in _in_order(raw):
        if node["event"] == "SceneStart":
            continue
        earlier = [
            ends[e["from"]] for e in _edges(raw) if e["to"] == node["id"] and e["from"] in ends
        ]
        ready = max((hi for _, hi in earlier), default=0.0)
        span = _span(node)
        fits = span is not None and TIME_S[0] <= span[0] <= span[1] <= TIME_S[1]
        if span is None or not fits or span[0] < ready or node["id"] in bad:
            span = (round(ready + OPEN_S[0], 4), round(ready + OPEN_S[1], 4))
            node.update(timestamp=None, window=list(span), time_is_prescribed=False)
            log.append(f"time of event {node['id']!r} left open")
        ends[node["id"]] = span
    return nodes != before


def _span(node: Json) -> tuple[float, float] | None:
    time, window = node.get("timestamp"), node.get("window")
    if time is not None:
        return float(time), float(time)
    return (float(window[0]), float(window[1])) if window else None


def _in_order(raw: Json) -> list[Json]:
    """Events, predecessors first; those of a circle in the order of the document."""
    left = list(_nodes(raw))
    out: list[Json] = []
    while left:
        names = {n["id"] for n in left}
        free = (
            n for n in left
            if not any(e["to"] == n["id"] and e["from"] in names for e in _edges(raw))
        )  # fmt: skip
        node = next(free, left[0])
        left.remove(node)
        out.append(node)
    return out


def _fields(raw: Json, violations: tuple[Violation, ...], log: list[str]) -> bool:
    """Clears the optional fields of a segment that break a rule."""
    done = False
    for k, name, _ in _parts(violations, "edges"):
        edge = _edges(raw)[k]
        if name == "target" and edge.get("target"):
            edge["target"] = None
        elif name == "params" and edge.get("params"):
            edge["params"] = {}
            edge["speed_is_prescribed"] = False
        elif name == "speed_is_prescribed" and edge.get(name):
            edge[name] = False
        else:
            continue
        log.append(f"{name} of segment {edge['id']!r} dropped")
        done = True
    return done


def _segments(raw: Json, violations: tuple[Violation, ...], log: list[str]) -> bool:
    gone = sorted({k for k, _, _ in _parts(violations, "edges")}, reverse=True)
    for k in gone:
        log.append(f"segment {_edges(raw).pop(k)['id']!r} dropped")
    return bool(gone)


def _events(raw: Json, violations: tuple[Violation, ...], log: list[str]) -> bool:
    gone = sorted({k for k, _, _ in _parts(violations, "nodes") if k > 0}, reverse=True)
    for k in gone:
        node = _nodes(raw)[k]
        log.append(f"event {node['id']!r} dropped")
        drop_event(raw, node)
    return bool(gone)


def drop_event(raw: Json, node: Json) -> None:
    """Takes a point event out of a timeline; what comes from it goes straight on, or goes too.

    Args:
        raw: Document as JSON; changed in place.
        node: One of its point events.
    """
    _nodes(raw).remove(node)
    edges = _edges(raw)
    for e in [e for e in edges if e["from"] == node["id"]]:
        into = next((o for o in edges if o["to"] == node["id"] and o["actor"] == e["actor"]), None)
        if into is not None:
            into["to"] = e["to"]  # its actor goes straight on
        edges.remove(e)
    edges[:] = [e for e in edges if e["to"] != node["id"]]
    for other in _nodes(raw):
        kept = [c for c in other.get("constraints", ()) if c.get("since") != node["id"]]
        other["constraints"] = kept


def _actors(raw: Json, violations: tuple[Violation, ...], log: list[str]) -> bool:
    actors = raw["timeline_system"]["actors"]
    found = {m[1] for v in violations if (m := _ACTOR.match(v.pointer)) is not None}
    gone = [name for name in actors if name in found]
    for name in gone:
        del actors[name]
        _edges(raw)[:] = [e for e in _edges(raw) if e["actor"] != name]
        log.append(f"actor {name!r} dropped")
    return bool(gone)


_Step = Callable[[Json, tuple[Violation, ...], list[str]], bool]
_STEPS: tuple[_Step, ...] = (_constraints, _times, _fields, _segments, _events, _actors)
"""Mildest first."""
