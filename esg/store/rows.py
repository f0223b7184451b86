"""Rows of tables with several for one scene: events, constraints, motion, words, statements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
import json
from typing import TYPE_CHECKING, Any

from esg.metrics.models import SceneVerdict
from esg.store import shapes

if TYPE_CHECKING:
    from esg.engines.scene import Rollout
    from esg.store.records import RunInfo


def event_rows(
    common: Mapping[str, Any], run: RunInfo, engine: str, verdict: SceneVerdict
) -> list[dict[str, Any]]:
    """Rows of table `metrics`: the events of one verdict."""
    return [
        {
            **common,
            "strategy": run.strategy,
            "engine": engine,
            "dt_s": verdict.dt_s,
            "event_id": e.id,
            "event_index": i,
            "event_type": e.type,
            "completed": e.completed,
            "time_s": e.time_s,
            "bodies": list(e.bodies),
            "reason": e.reason,
            "measured": shapes.measured(e.measured),
        }
        for i, e in enumerate(verdict.events)
    ]


def constraint_rows(
    common: Mapping[str, Any], run: RunInfo, engine: str, verdict: SceneVerdict
) -> list[dict[str, Any]]:
    """Rows of table `constraints`: those of one verdict, with the distance to their target."""
    out: list[dict[str, Any]] = []
    for i, c in enumerate(verdict.constraints):
        low, high = c.target if isinstance(c.target, tuple) else (c.target, c.target)
        error = None if c.measured is None else max(0.0, low - c.measured, c.measured - high)
        out.append(
            {
                **common,
                "strategy": run.strategy,
                "engine": engine,
                "constraint_index": i,
                "constraint": c.constraint,
                "kind": c.kind,
                "quantity": c.quantity,
                "unit": c.unit,
                "target_low": low,
                "target_high": high,
                "measured": c.measured,
                "error": error,
                "score": c.score,
                "score_strict": c.score_strict,
                "score_lenient": c.score_lenient,
                "reason": c.reason,
            }
        )
    return out


def statement_rows(
    common: Mapping[str, Any],
    run: RunInfo,
    statements: Mapping[str, Sequence[Mapping[str, Any]]],
) -> list[dict[str, Any]]:
    """Rows of table `statements`.

    Args:
        common: Columns that all tables share.
        run: Whose engine measured them.
        statements: Rows of esg.fidelity by source: the scene's own prompt, or its suite.
    """
    return [
        {
            **common,
            "strategy": run.strategy,
            "engine": "" if row["status"] == "not_judged" else run.engine,
            "source": source,
            "statement_id": row["id"],
            "statement_index": i,
            "says": row["says"],
            "words": row.get("words"),
            "start": row.get("start"),
            "stop": row.get("end"),
            "status": row["status"],
            "kept": row["kept"],
            "measured": shapes.measured(row["measured"]),
            "reason": row["reason"],
        }
        for source, rows in statements.items()
        for i, row in enumerate(rows)
    ]


def check_rows(
    common: Mapping[str, Any], run: RunInfo, checks: Sequence[Mapping[str, Any]]
) -> list[dict[str, Any]]:
    """Rows of table `plausibility_checks`: those of the replay in the run's engine."""
    return [
        {
            **common,
            "strategy": run.strategy,
            "engine": run.engine,
            "check_name": check["name"],
            "check_index": i,
            "limit_value": check["limit"],
            **{k: check[k] for k in ("unit", "ok", "measured", "body", "time_s", "note")},
        }
        for i, check in enumerate(checks)
    ]


def trajectory_row(
    common: Mapping[str, Any],
    split: str,
    engine: str,
    rollout: Rollout,
    bodies: tuple[str, ...],
) -> dict[str, Any]:
    """Row of table `trajectories`: one rollout, flat arrays in SI units."""
    import numpy as np

    c = rollout.contacts.select(0)
    frame = float(np.median(np.diff(rollout.time))) if len(rollout.time) > 1 else rollout.dt

    def flat(values: Any, kind: Any = np.float32) -> Any:
        return np.ascontiguousarray(values, kind).ravel()

    return {
        **common,
        "split": split,
        "engine": engine,
        "dt_s": rollout.dt,
        "fps": 1.0 / frame,
        "n_frames": len(rollout.time),
        "bodies": list(bodies),
        "time_s": flat(rollout.time),
        "position_m": flat(rollout.position[0]),
        "quaternion_xyzw": flat(rollout.quaternion[0]),
        "linear_velocity_mps": flat(rollout.linear_velocity[0]),
        "angular_velocity_radps": flat(rollout.angular_velocity[0]),
        "contact_time_s": flat(c.time),
        "contact_a": flat(c.a, np.int16),
        "contact_b": flat(c.b, np.int16),
        "contact_impulse_ns": flat(c.impulse),
        "contact_depth_m": flat(c.depth),
        "contact_point_m": flat(c.point),
        "contact_normal": flat(c.normal),
    }


def coverage_rows(common: Mapping[str, Any], draft: bytes | None) -> list[dict[str, Any]]:
    """Rows of table `coverage`: what became of every word, as the draft says."""
    if draft is None:
        return []
    items = json.loads(draft).get("coverage", {}).get("items", [])
    return [
        {
            **common,
            "item_index": i,
            "text": item["text"],
            "start": item["start"],
            "stop": item["end"],
            "kind": item["kind"],
            "status": item["status"],
            "pointer": item.get("pointer", ""),
            "note": item.get("note", ""),
        }
        for i, item in enumerate(items)
    ]
