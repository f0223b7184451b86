"""How scenes end, what they say and show, how large they are."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from esg.dataset.card.facts.tables import Tables, counted, spread
from esg.fidelity import most_unseen, shortfalls
from esg.outcomes import Outcome


def endings(tables: Tables) -> dict[str, Any]:
    """Scenes by outcome, level, rule, proof and pair."""
    scenes = tables.scenes
    return {
        "scenes": len(scenes),
        "verified": sum(bool(s["verified"]) for s in scenes),
        "distinct_prompts": len({s["prompt"] for s in scenes}),
        "families": len({s["family"] for s in scenes}),
        "outcomes": counted(s["outcome"] for s in scenes),
        "partial": sum(s["outcome"] == Outcome.PARTIAL.value for s in scenes),
        "levels": _by(scenes, "level"),
        "rules": _by(scenes, "rule"),
        "proofs": counted(s["proof"] for s in scenes if s["proof"]),
        "examples": _examples(scenes),
        "pairs": _pairs(scenes),
    }


def statements(tables: Tables) -> dict[str, Any]:
    """What prompts state and what became of it."""
    return {
        "fully_understood": sum(bool(s["fully_understood"]) for s in tables.scenes),
        "statements": counted(
            r["status"]
            for r in tables.rows("statements", ["source", "status"])
            if r["source"] == "prompt"
        ),
        "not_represented": _unseen(tables),
    }


def plausibility(tables: Tables) -> dict[str, Any]:
    """Plausible replays, and the checks that the others fail."""
    return {
        "plausible": sum(s["plausible"] is True for s in tables.scenes),
        "replayed": sum(s["plausible"] is not None for s in tables.scenes),
        "implausible": counted(
            r["check_name"]
            for r in tables.rows("plausibility_checks", ["check_name", "ok"])
            if not r["ok"]
        ),
    }


def events(tables: Tables) -> dict[str, Any]:
    """Events by type and stated numbers by quantity."""
    rows = list(tables.rows("metrics", ["event_type", "completed"]))
    kinds = Counter(r["event_type"] for r in rows)
    done = Counter(r["event_type"] for r in rows if r["completed"])
    stated: dict[str, list[float]] = {}
    for row in tables.rows("constraints", ["quantity", "score"]):
        stated.setdefault(row["quantity"], []).append(row["score"])
    return {
        "events": {k: {"stated": n, "completed": done[k]} for k, n in sorted(kinds.items())},
        "constraints": {
            q: {"stated": len(scores), "mean_score": round(sum(scores) / len(scores), 4)}
            for q, scores in sorted(stated.items())
        },
    }


def sizes(tables: Tables) -> dict[str, Any]:
    """How large scenes are: least, median, mean and most of what can be counted in one."""
    replays = list(tables.rows("trajectories", ["bodies", "n_frames", "fps"]))
    stated = Counter(r["scene_key"] for r in tables.rows("constraints", ["scene_key"]))
    hits = [len(r["contact_time_s"]) for r in tables.rows("trajectories", ["contact_time_s"])]
    found = {
        "bodies": [len(r["bodies"]) for r in replays],
        "expected events": [s["n_events"] for s in tables.scenes if s["n_events"] is not None],
        "stated numbers": [stated[s["scene_key"]] for s in tables.scenes],
        "length of the replay [s]": [(r["n_frames"] - 1) / r["fps"] for r in replays],
        "contacts in the replay": hits,
    }
    return {"sizes": {name: spread(values) for name, values in found.items() if values}}


def _unseen(tables: Tables) -> list[dict[str, Any]]:
    """The words that scenes most often show nothing of: statements and verbs."""
    place = ["scene_key", "start", "stop", "status"]
    said: dict[str, list[dict[str, Any]]] = {}
    for row in tables.rows("statements", [*place, "source", "words", "reason"]):
        if row["source"] == "prompt":
            said.setdefault(row["scene_key"], []).append({**row, "end": row["stop"]})
    read: dict[str, list[dict[str, Any]]] = {}
    for row in tables.rows("coverage", [*place, "text", "kind"]):
        read.setdefault(row["scene_key"], []).append({**row, "end": row["stop"]})
    return most_unseen(
        shortfalls({"coverage": {"items": read.get(key, ())}}, said.get(key, ()))
        for key in sorted({*said, *read})
    )


def _examples(scenes: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The first verified and the first other scene of every level."""
    found: dict[tuple[str, bool], dict[str, Any]] = {}
    for s in sorted(scenes, key=lambda row: row["scene_key"]):
        found.setdefault(
            (s["level"] or "", bool(s["verified"])),
            {k: s[k] for k in ("level", "prompt", "outcome")} | {"verified": bool(s["verified"])},
        )
    return [found[key] for key in sorted(found, key=lambda k: (k[0], not k[1]))]


def _by(scenes: Sequence[Mapping[str, Any]], column: str) -> dict[str, dict[str, int]]:
    all_of = Counter(s[column] or "" for s in scenes)
    good = Counter(s[column] or "" for s in scenes if s["verified"])
    return {k: {"scenes": all_of[k], "verified": good[k]} for k in sorted(all_of) if k}


def _pairs(scenes: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Counterfactual pairs: how many, what they change, how many are verified on both sides."""
    sides: dict[str, list[bool]] = {}
    for s in scenes:
        if s["pair"]:
            sides.setdefault(s["pair"], []).append(bool(s["verified"]))
    whole = [v for v in sides.values() if len(v) == 2]
    return {
        "pairs": len(whole),
        "both_verified": sum(all(v) for v in whole),
        "changed": counted(s["changed"] for s in scenes if s["changed"]),
    }
