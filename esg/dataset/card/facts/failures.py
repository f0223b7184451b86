"""Failures by cause."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
import re
from typing import Any


def failure_table(failed: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Failures by outcome and cause, most frequent first; numbers in the cause are left out."""
    groups: dict[tuple[str, str, str], list[str]] = {}
    for row in failed:
        key = (str(row["outcome"]), str(row["stage"]), cause(str(row["reason"])))
        groups.setdefault(key, []).append(str(row["scene"]))
    ordered = sorted(groups.items(), key=lambda item: (-len(item[1]), item[0]))
    return [
        {"outcome": o, "stage": s, "cause": c, "scenes": len(names), "example": min(names)}
        for (o, s, c), names in ordered
    ]


def cause(reason: str) -> str:
    """A reason without what differs from scene to scene: names of bodies and numbers."""
    text = reason.split("; ")[0]
    text = re.sub(r"\b[a-z0-9_]*[a-z]_\d+(?:_[a-z0-9_]*)?\b", "…", text)
    text = re.sub(r"\be\d+\b", "…", text)
    text = re.sub(r"-?\d+(?:\.\d+)?", "#", text)
    return text[:120] or "none given"
