"""What cameras saw, and how it stands against geometry."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from esg.dataset.card.facts.tables import Tables, counted, spread

_NAMED = 10
"""Failing scenes that are named, a check."""


def clips(tables: Tables) -> dict[str, Any]:
    """Clips by camera, renderer and channel; their length and size."""
    if not tables.has("clips"):
        return {"clips": {}}
    columns = [
        "scene_key", "camera_kind", "renderer", "samples", "width", "height", "fps", "n_frames",
        "channels", "files", "place", "sky",
    ]  # fmt: skip
    rows = list(tables.rows("clips", columns))
    size: Counter[str] = Counter()
    for row in rows:
        for file in row["files"]:
            size[file["channel"]] += int(file["bytes"])
    return {
        "clips": {
            "clips": len(rows),
            "scenes": len({r["scene_key"] for r in rows}),
            "frames": sum(r["n_frames"] for r in rows),
            "hours": round(sum(r["n_frames"] / r["fps"] for r in rows) / 3600, 4),
            "length_s": spread([r["n_frames"] / r["fps"] for r in rows]),
            "pictures": counted(
                f"{r['width']} x {r['height']} at {r['fps']:g} frames a second" for r in rows
            ),
            "renderers": counted(f"{r['renderer']}, {r['samples']} rays a pixel" for r in rows),
            "cameras": counted(r["camera_kind"] for r in rows),
            **{
                name: _most_first(counted(r[name] for r in rows if r[name]))
                for name in ("place", "sky")
            },
            "channels": sorted({c for r in rows for c in r["channels"]}),
            "megabytes": {k: round(v / 1e6, 1) for k, v in sorted(size.items())},
        }
    }


def _most_first(counts: Mapping[str, int]) -> dict[str, int]:
    return dict(sorted(counts.items(), key=lambda item: (-item[1], item[0])))


def truth(tables: Tables) -> dict[str, Any]:
    """Residuals of every check, over all clips that were checked, and the scenes that fail."""
    if not tables.has("truth_checks"):
        return {"truth": {}}
    columns = [
        "scene_id", "camera", "check_name", "unit", "samples", "p50", "p90", "p99", "worst",
        "limit_value", "ok",
    ]  # fmt: skip
    return {"truth": summaries(tables.rows("truth_checks", columns))}


def summaries(rows: Iterable[Mapping[str, Any]]) -> dict[str, dict[str, Any]]:
    """Residuals by check: medians over clips, the highest, and who fails.

    Args:
        rows: Of table `truth_checks`.
    """
    by_check: dict[str, list[Mapping[str, Any]]] = {}
    for row in rows:
        if row["p99"] is not None or row["ok"] is False:
            by_check.setdefault(row["check_name"], []).append(row)
    return {name: _summary(found) for name, found in sorted(by_check.items())}


def _summary(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    measured = [r for r in rows if r["p99"] is not None]
    failing = sorted({r["scene_id"] for r in rows if not r["ok"]})
    return {
        "unit": rows[0]["unit"],
        "limit": rows[0]["limit_value"],
        "checked": len(rows),
        "samples": sum(r["samples"] for r in rows),
        **{
            p: float(np.median([r[p] for r in measured])) if measured else None
            for p in ("p50", "p90", "p99")
        },
        "highest_p99": max((r["p99"] for r in measured), default=None),
        "worst": max((r["worst"] for r in measured), default=None),
        "failing": len(failing),
        "named": failing[:_NAMED],
    }
