"""What other engines say of the same scenes, and what becomes of changed ones."""

from __future__ import annotations

from typing import Any

from esg.dataset.card.facts.tables import Tables


def engines(tables: Tables) -> dict[str, Any]:
    """Events that complete by engine and step, and those on which all engines agree."""
    if not tables.has("engine_events"):
        return {}
    columns = ["scene_key", "event_id", "engine", "dt_s", "completed"]
    by_run: dict[str, list[bool]] = {}
    by_event: dict[tuple[str, str], set[bool]] = {}
    for row in tables.rows("engine_events", columns):
        if row["completed"] is None:
            continue
        run = f"{row['engine']}, {1 / row['dt_s']:.0f} Hz" if row["dt_s"] else row["engine"]
        by_run.setdefault(run, []).append(row["completed"])
        by_event.setdefault((row["scene_key"], row["event_id"]), set()).add(row["completed"])
    return {
        "engines": {
            "runs": {k: {"events": len(v), "completed": sum(v)} for k, v in sorted(by_run.items())},
            "events": len(by_event),
            "agreed": sum(len(v) == 1 for v in by_event.values()),
        }
    }


def what_ifs(tables: Tables) -> dict[str, Any]:
    """Changed replays by variable: scenes, replays, and replays on which engines agree."""
    if not tables.has("what_ifs"):
        return {}
    rows = list(tables.rows("what_ifs", ["scene_key", "variable", "engine", "agrees"]))
    out: dict[str, dict[str, int]] = {}
    for name in sorted({r["variable"] for r in rows}):
        mine = [r for r in rows if r["variable"] == name]
        judged: dict[str, list[bool]] = {}
        for row in mine:
            if row["agrees"] is not None:
                judged.setdefault(row["scene_key"], []).append(bool(row["agrees"]))
        out[name] = {
            "scenes": len({r["scene_key"] for r in mine}),
            "replays": len(mine),
            "compared": len(judged),
            "agreed": sum(all(v) for v in judged.values()),
        }
    return {"what_ifs": out}
