"""Deterministic repair of motion segments: repetitions, double ids, ends that name no event."""

from __future__ import annotations

import json
from typing import Any

Json = dict[str, Any]

FIRST_S = (0.2, 5.0)
"""Window of an event of open time that follows nothing but the start [s]."""
NEXT_S = (0.1, 2.1)
"""The same after the latest time of what comes before it [s]."""


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

    Args:
        nodes: Point events; changed in place.
        edges: Segments.
    """
    ends = {n["id"]: high for n in nodes if (high := _latest(n)) is not None}
    left = [n for n in nodes if n["id"] not in ends]
    while left:
        names = {n["id"] for n in left}
        waits = {e["to"] for e in edges if e["from"] in names and e["to"] in names}
        node = next((n for n in left if n["id"] not in waits), left[0])
        left.remove(node)
        ready = max((ends[e["from"]] for e in edges if e["to"] == node["id"] and e["from"] in ends),
                    default=0.0)  # fmt: skip
        low, high = NEXT_S if ready > 0.0 else FIRST_S
        node["window"] = [round(ready + low, 4), round(ready + high, 4)]
        ends[node["id"]] = node["window"][1]


def _latest(node: Json) -> float | None:
    if node.get("timestamp") is not None:
        return node["timestamp"]
    return node["window"][1] if node.get("window") else None
