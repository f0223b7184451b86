"""What a dataset's what-ifs and engines come to, for its card."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from esg.store.tables import iter_rows, part_files

_COLUMNS = ["scene_key", "variable", "engine", "amount", "outcome", "reason", "agrees"]


def what_if_statistics(folder: Path) -> dict[str, Any]:
    """Numbers of tables `what_ifs` and `engine_events` of a dataset whose split files are written.

    Args:
        folder: Of the dataset.

    Returns:
        `what_ifs`: by variable, the scenes that it was changed in (`replayed`), those in which it
        could not be (`not_applicable`, `failed`), in how many all engines agree (`agree`, and their
        `share`), and in how many an engine sees other events than without the change (`changed`);
        `engines`: by engine and step, events, completed ones and failures; `events_agree`: the
        share of events that all engines see alike at all steps. Empty without such tables.
    """
    what_ifs = _by_variable(list(iter_rows(part_files(folder, "what_ifs"), _COLUMNS)))
    events = list(
        iter_rows(
            part_files(folder, "engine_events"),
            ["scene_key", "event_id", "engine", "dt_s", "completed", "agrees"],
        )
    )
    out: dict[str, Any] = {}
    if what_ifs:
        asked = sum(v["replayed"] for k, v in what_ifs.items() if k != "none")
        agree = sum(v["agree"] for k, v in what_ifs.items() if k != "none")
        out |= {"what_ifs": what_ifs, "what_ifs_agree": _share(agree, asked)}
    if events:
        alike = {(r["scene_key"], r["event_id"]): r["agrees"] for r in events}
        out |= {
            "engines": _by_engine(events),
            "events_agree": _share(sum(a is True for a in alike.values()), len(alike)),
        }
    return out


def _by_variable(rows: Sequence[Mapping[str, Any]]) -> dict[str, dict[str, Any]]:
    scenes: dict[str, dict[str, list[Mapping[str, Any]]]] = {}
    for row in rows:
        scenes.setdefault(row["variable"], {}).setdefault(row["scene_key"], []).append(row)
    out: dict[str, dict[str, Any]] = {}
    for variable, of in sorted(scenes.items()):
        unfit = sum(all(r["outcome"] == "not_applicable" for r in found) for found in of.values())
        sound = [found for found in of.values() if all(r["agrees"] is not None for r in found)]
        agree = sum(all(r["agrees"] for r in found) for found in sound)
        out[variable] = {
            "scenes": len(of),
            "replayed": len(sound),
            "not_applicable": unfit,
            "failed": len(of) - unfit - len(sound),
            "agree": agree,
            "share": _share(agree, len(sound)),
            "changed": sum(any(r["outcome"] == "other_events" for r in f) for f in sound),
        }
    return out


def _by_engine(rows: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    out: dict[tuple[str, float], dict[str, Any]] = {}
    for row in rows:
        key = row["engine"], row["dt_s"]
        start = {"engine": key[0], "dt_s": key[1], "events": 0, "completed": 0, "failed": 0}
        found = out.setdefault(key, start)
        found["events"] += 1
        found["completed"] += row["completed"] is True
        found["failed"] += row["completed"] is None
    return [out[key] for key in sorted(out, key=lambda k: (k[0], -k[1]))]


def _share(part: int, whole: int) -> float | None:
    return round(part / whole, 4) if whole else None
