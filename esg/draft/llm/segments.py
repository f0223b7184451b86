"""Deterministic repair of motion segments: repetitions, double ids, ends that name no event."""

from __future__ import annotations

import json
from typing import Any

Json = dict[str, Any]

FIRST_S = (0.2, 5.0)
"""Window of an event of open time that follows nothing but the start [s]."""
ACTION_S = (0.5, 1.5)
"""Window of an intended action that follows nothing but the start [s]."""
NEXT_S = (0.1, 2.1)
"""The same after the latest time of what comes before it [s]."""
MARGIN_S = 0.5
"""Least width of a window that a stated time since another event opens [s]."""


def sound_segments(nodes: list[Json], edges: list[Json], log: list[str]) -> list[Json]:
    """Segments without repetitions, with ids of their own, between events that exist.

    An unknown start is read as the scene's start if the actor has no earlier segment; an unknown
    end as the only event in which the actor takes part. Where several could be meant, nothing is
    guessed.

    Args:
        nodes: Point events, the scene's start first.
        edges: Segments.
        log: Gets a line for every change.
    """
    known = {n["id"] for n in nodes}
    used: set[str] = set()
    told: set[str] = set()
    out: list[Json] = []
    for edge in edges:
        body = json.dumps({k: v for k, v in edge.items() if k != "id"}, sort_keys=True)
        if body in told:
            log.append(f"segment {edge['id']!r} was stated twice")
            continue
        told.add(body)
        e = dict(edge)
        first = all(o["actor"] != e["actor"] for o in out)
        if e["from"] not in known and first:
            log.append(f"segment start {e['from']!r} read as {nodes[0]['id']}")
            e["from"] = nodes[0]["id"]
        if e["to"] not in known:
            own = [n["id"] for n in nodes[1:] if e["actor"] in n.get("participants", ())]
            if len(own) == 1:
                log.append(f"segment end {e['to']!r} read as {own[0]}")
                e["to"] = own[0]
        name, k = e["id"], 2
        while name in used:
            name = f"{e['id'][:60]}_{k}"
            k += 1
        if name != e["id"]:
            log.append(f"second segment {e['id']!r} renamed {name!r}")
            e["id"] = name
        used.add(name)
        out.append(e)
    return out


def open_times(nodes: list[Json], edges: list[Json]) -> None:
    """Gives every event without a time a window after the events that lead to it.

    It ends before whatever follows it at a stated time, and keeps to a stated time since another.

    Args:
        nodes: Point events; changed in place.
        edges: Segments.
    """
    spans = {n["id"]: span for n in nodes if (span := _span(n)) is not None}
    after = {n["id"]: [e["to"] for e in edges if e["from"] == n["id"]] for n in nodes}
    left = [n for n in nodes if n["id"] not in spans]
    while left:
        names = {n["id"] for n in left}
        waits = {e["to"] for e in edges if e["from"] in names and e["to"] in names}
        node = next((n for n in left if n["id"] not in waits), left[0])
        left.remove(node)
        before = [spans[e["from"]] for e in edges if e["to"] == node["id"] and e["from"] in spans]
        ready = max((high for _, high in before), default=0.0)
        alone = ACTION_S if node.get("event") == "Trigger" else FIRST_S
        first, last = NEXT_S if ready > 0.0 else alone
        low, high = ready + first, ready + last
        for low_since, high_since in _since(node, spans):
            low = max(low, low_since)
            high = max(low + MARGIN_S, high_since)
        limit, steps = _limit(node["id"], after, spans)
        if limit is not None and ready < limit < high + (steps - 1) * NEXT_S[1]:
            high = ready + (limit - ready) / steps
            low = ready + min(first, (high - ready) / 2)
        node["window"] = [round(low, 4), round(high, 4)]
        spans[node["id"]] = (node["window"][0], node["window"][1])


def _span(node: Json) -> tuple[float, float] | None:
    if node.get("timestamp") is not None:
        return node["timestamp"], node["timestamp"]
    return (node["window"][0], node["window"][1]) if node.get("window") else None


def _since(node: Json, spans: dict[str, tuple[float, float]]) -> list[tuple[float, float]]:
    """When an event happens by the stated times since earlier ones."""
    out: list[tuple[float, float]] = []
    for c in node.get("constraints", ()):
        if c["quantity"] == "time_since" and c.get("since") in spans:
            low, high = c["value"] if isinstance(c["value"], list) else (c["value"], c["value"])
            begin, end = spans[c["since"]]
            out.append((begin + low, end + high))
    return out


def _limit(
    name: str, after: dict[str, list[str]], spans: dict[str, tuple[float, float]]
) -> tuple[float | None, int]:
    """Earliest begin of a timed event that follows, and how many events without a time share the
    way there, this one included."""
    seen: set[str] = set()

    def follow(current: str) -> tuple[float | None, int]:
        best: tuple[float | None, int] = (None, 1)
        for following in after.get(current, ()):
            if following in seen:
                continue
            seen.add(following)
            if following in spans:
                found = (spans[following][0], 1)
            else:
                limit, steps = follow(following)
                found = (limit, steps + 1)
            if found[0] is not None and (best[0] is None or found[0] < best[0]):
                best = found
        return best

    return follow(name)
