"""What a dataset cost: the one part of a card that differs from run to run."""

from __future__ import annotations

from collections.abc import Mapping
import json
from pathlib import Path
from typing import Any


def cost(out: Path, facts: Mapping[str, Any]) -> dict[str, Any]:
    """Time by stage, a scene or a clip, and on what.

    Args:
        out: Folder of the dataset, with `meta/timings.json` and `meta/run.json`.
        facts: Of the dataset: how many clips and frames there are.
    """
    path = out / "meta" / "timings.json"
    if not path.is_file():
        return {}
    times = json.loads(path.read_bytes())
    run = out / "meta" / "run.json"
    seen = facts.get("clips") or {}
    return {
        "machine": json.loads(run.read_bytes())["machine"] if run.is_file() else "",
        "scenes": times["scenes"],
        "clips": seen.get("clips", 0),
        "frames": seen.get("frames", 0),
        "seconds": {k: v for k, v in times["seconds"].items() if v > 0},
        "megabytes": round(sum(seen.get("megabytes", {}).values()), 1),
    }
