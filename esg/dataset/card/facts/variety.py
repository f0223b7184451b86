"""What was drawn for sampled scenes, and which scenes repeat another."""

from __future__ import annotations

from collections import Counter
import json
from typing import Any

from esg.dataset.card.facts.tables import Tables, spread
from esg.dataset.variety.tables import UNSAID

_ONE_OF = ("place", "light", "camera")
_LOOKS = ("color", "material", "size", "variant")


def drawn(tables: Tables) -> dict[str, Any]:
    """How often everything was drawn that a distribution may ask for; nothing if it did not."""
    slots = [
        {p["slot"]: p["number"] if p["text"] is None else p["text"] for p in s["parameters"]}
        for s in tables.scenes
        if s["parameters"]
    ]
    found: dict[str, Any] = {}
    for name in _ONE_OF:
        values = Counter(str(s.get(name, UNSAID)) for s in slots)
        if len(values) > 1 or UNSAID not in values:
            found[name] = dict(sorted(values.items(), key=lambda item: (-item[1], item[0])))
    for name in _LOOKS:
        values = Counter(
            str(v) for s in slots for k, v in s.items() if k == name or k.endswith(f"_{name}")
        )
        if values:
            found[name] = dict(sorted(values.items(), key=lambda item: (-item[1], item[0])))
    crowds = [int(s.get("n_bystanders", 0)) for s in slots]
    if any(crowds):
        kinds: Counter[str] = Counter()
        for s in slots:
            for group in str(s.get("bystanders", "")).split(", "):
                number, _, kind = group.partition(" ")
                kinds.update({kind: int(number)} if kind else {})
        found["bystanders"] = spread(crowds)
        found["bystander"] = dict(sorted(kinds.items(), key=lambda item: (-item[1], item[0])))
    return {"drawn": found}


def duplicates(tables: Tables) -> dict[str, Any]:
    """Scenes that are near to another one: found, and still among the rows."""
    path = tables.out / "meta" / "duplicates.jsonl"
    lines = path.read_text("utf-8").splitlines() if path.is_file() else []
    there = {s["scene_key"] for s in tables.scenes}
    rows = [json.loads(line) for line in lines]
    return {
        "duplicates": {
            "found": len(rows),
            "kept": sum(r["scene_key"] in there for r in rows),
            "examples": [
                {"scene": r["scene_key"].split("/")[2], "of": r["duplicate_of"].split("/")[2]}
                for r in rows[:5]
            ],
        }
    }
