"""Scene folders made without the pipeline: a ball that falls onto a box."""

from __future__ import annotations

from collections.abc import Sequence
import json
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from esg.engines.manifest import manifest_bytes, manifest_to_json
from esg.engines.program import Program
from esg.engines.rollout_file import save_rollout
from esg.engines.scene import Body, ContactLog, Rollout, Shape, SimScene

EYE = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
HIT_S = 0.5


def scene(name: str = "drop") -> SimScene:
    """A ball above a box."""
    ball = Body(
        "ball_1",
        static=False,
        mass=1.0,
        inertia=EYE,
        shapes=(Shape("sphere", (0.2, 0.2, 0.2)),),
        position=(0.0, 0.0, 2.0),
        origin_offset=(0.0, 0.0, -0.2),
        half_extents=(0.2, 0.2, 0.2),
        label="red ball",
        color=(0.8, 0.1, 0.1),
    )
    box = Body(
        "box_1",
        static=True,
        mass=5.0,
        inertia=EYE,
        shapes=(Shape("box", (0.5, 0.5, 0.25)),),
        position=(0.0, 0.0, 0.25),
        origin_offset=(0.0, 0.0, -0.25),
        half_extents=(0.5, 0.5, 0.25),
        label="box",
    )
    return SimScene(name, (ball, box))


def rollout(hz: int = 240, seconds: float = 1.0, engine: str = "physx") -> Rollout:
    """The ball falls freely, then rests on the box; one hit between."""
    time = np.arange(round(seconds * hz) + 1) / hz
    fall = np.minimum(time, HIT_S)
    position = np.zeros((1, len(time), 2, 3), np.float32)
    position[0, :, 0, 2] = 2.0 - 0.5 * 9.81 * fall**2
    position[0, :, 1, 2] = 0.25
    velocity = np.zeros_like(position)
    velocity[0, :, 0, 2] = np.where(time < HIT_S, -9.81 * time, 0.0)
    turn = np.zeros((1, len(time), 2, 4), np.float32)
    turn[..., 3] = 1.0
    one = np.array([0], np.int32)
    hit = ContactLog(
        world=one,
        frame=np.array([round(HIT_S * hz)], np.int32),
        a=one,
        b=np.array([1], np.int32),
        time=np.array([HIT_S]),
        impulse=np.array([4.9]),
        depth=np.array([0.0]),
        point=np.array([[0.0, 0.0, 0.5]]),
        normal=np.array([[0.0, 0.0, 1.0]]),
    )
    valid = np.array([True])
    return Rollout(
        engine, 1 / hz, time, position, turn, velocity, np.zeros_like(velocity), hit, valid
    )


def event(completed: bool = True, **more: Any) -> dict[str, Any]:
    """An event of the verdict."""
    return {
        "id": "e1",
        "type": "collision",
        "completed": completed,
        "time_s": HIT_S if completed else None,
        "bodies": ["ball_1", "box_1"],
        "reason": "" if completed else "the pair never touches",
        "measured": {"impulse_ns": 4.9, "time_s": HIT_S} if completed else {},
        **more,
    }


def _asset(name: str, mass_kg: float, size_cm: float) -> dict[str, Any]:
    return {
        "asset_name": name,
        "category": name,
        "source": "parametric",
        "mesh_path": f"meshes/{name}_01.glb",
        "dimensions_cm": [size_cm] * 3,
        "mass_kg": mass_kg,
        "is_movable": name == "ball",
        "friction": 0.5,
        "restitution": 0.3,
    }


def document(prompt: str, *, label: str = "red ball") -> dict[str, Any]:
    """A document that fits the schema, with everything that a page reads."""
    return {
        "scene_definition": {
            "scene_id": "drop",
            "original_description": prompt,
            "scene_parameters": {"is_dynamic": True, "scene_type": "indoor"},
        },
        "spatial_relation_graph": {
            "nodes": {
                "ball_1": {"asset_id": "ball_01", "label": label, "mentioned": True},
                "box_1": {"asset_id": "box_01", "label": "box", "mentioned": True},
            },
            "edges": {
                "binary_relations": [{"from": "ball_1", "to": "box_1", "relation_type": "above"}],
                "multi_relations": [],
            },
        },
        "asset_configurations": {
            "ball_01": _asset("ball", 1.0, 40.0),
            "box_01": _asset("box", 5.0, 100.0),
        },
        "timeline_system": {
            "sequence_graph": {
                "nodes": [
                    {"id": "scene_start", "event": "SceneStart", "participants": [], "timestamp": 0},
                    {
                        "id": "hit",
                        "event": "Collision",
                        "participants": ["ball_1", "box_1"],
                        "window": [0.3, 0.8],
                        "time_is_prescribed": True,
                    },
                ],
                "edges": [
                    {"id": "fall", "from": "scene_start", "to": "hit", "actor": "ball_1", "event": "Toward"}
                ],
            }
        },
        "coverage": {
            "items": [
                {
                    "text": prompt[:3],
                    "start": 0,
                    "end": min(3, len(prompt)),
                    "kind": "object",
                    "status": "not_understood",
                    "note": "",
                }
            ],
            "warnings": [],
        },
        "dynamics_result": {
            "outcome": "solved",
            "duration_s": 1.0,
            "strategy": "batched",
            "engine": "newton",
            "dt_s": 1 / 240,
            "evaluations": 64,
            "loss": 0.01,
            "history": [1.0, 0.1, 0.01],
            "parameters": [
                {"name": "drop/aim", "value": 0.1, "lower": -1, "upper": 1, "initial": 0,
                 "fixed": False, "unit": "rad"}
            ],
            "margins": {"hit": 0.5},
            "relaxed": [],
        },
        "provenance": [{"stage": "draft", "version": "1", "seed": 3}],
    }  # fmt: skip


def statement(prompt: str, words: str, status: str, reason: str = "", **measured: float) -> Any:
    """A row of what became of a statement (esg.fidelity)."""
    start = prompt.index(words)
    kept = {"kept": True, "broken": False}.get(status)
    return {"id": f"s{start}", "says": "supported_by", "words": words, "start": start,
            "end": start + len(words), "status": status, "kept": kept, "measured": measured,
            "reason": reason}  # fmt: skip


def write_scene(
    folder: Path,
    prompt: str = "A red ball falls onto a box.",
    *,
    outcome: str = "solved",
    reason: str = "",
    seconds: float = 2.0,
    label: str = "red ball",
    completed: bool = True,
    said: Sequence[dict[str, Any]] = (),
) -> Path:
    """Writes a scene folder; one that never got past its draft for `invalid_draft`.

    `said` are rows of what became of its statements (`statement`); words outside the prompt are
    not looked for.
    """
    folder.mkdir(parents=True)
    (folder / "prompt.txt").write_text(prompt + "\n", encoding="utf-8")
    log = [
        {"stage": "draft", "cached": False, "seconds": seconds},
        {"outcome": outcome, "reason": reason},
    ]
    lines = "".join(json.dumps(entry) + "\n" for entry in log)
    (folder / "log.jsonl").write_text(lines, encoding="utf-8")
    told = document(prompt, label=label)
    if said:
        told["coverage"]["items"] = [
            {k: row[k] for k in ("start", "end")}
            | {"text": row["words"], "kind": "relation", "status": "used", "note": ""}
            for row in said
        ]
        told["statements"] = [
            {k: row[k] for k in ("id", "start", "end")}
            | {"text": row["words"], "predicate": "not_represented", "note": row["reason"]}
            for row in said
        ]
    (folder / "esg.json").write_text(json.dumps(told), encoding="utf-8")
    if outcome in ("invalid_draft", "crashed"):
        return folder
    sim = scene(folder.name)
    manifest = manifest_to_json(sim, Program((), 1.0), dt=1 / 240)
    (folder / "manifest.json").write_bytes(manifest_bytes(manifest))
    save_rollout(rollout(), folder / "rollout.npz")
    verdict = {
        "scene_id": "drop",
        "suite_scene": "drop",
        "engine": "physx",
        "dt_s": 1 / 240,
        "layout": {"valid": True},
        "events": [event(completed)],
        "completed": int(completed),
        "n_events": 1,
        "slr": True,
        "constraints": [
            {
                "constraint": "speed ball @hit = 5 m/s",
                "kind": "outcome",
                "quantity": "speed",
                "unit": "m/s",
                "measured": 4.9,
                "target": 5.0,
                "score": 1.0,
                "score_strict": 1.0,
                "score_lenient": 1.0,
                "reason": "",
            },
            {
                "constraint": "time_since e1 since start = 0.6 s",
                "kind": "outcome",
                "quantity": "time_since",
                "unit": "s",
                "measured": 0.5,
                "target": 0.6,
                "score": 1.0,
                "score_strict": 1.0,
                "score_lenient": 1.0,
                "reason": "",
            },
        ],
    }
    metrics = {
        "outcome": outcome,
        "reason": reason,
        "advice": "",
        "proof": "class",
        "judged_against": "suite",
        "verified": completed,
        "verdict": verdict,
        "statements": list(said),
        "plausibility": {
            "plausible": completed,
            "worst": "" if completed else "ball_1: speed 99 m/s, limit 47.3 m/s at 0.00 s",
            "checks": [
                {
                    "name": "speed",
                    "unit": "m/s",
                    "ok": completed,
                    "measured": 4.9 if completed else 99.0,
                    "limit": 47.3,
                    "body": "ball_1",
                    "time_s": 0.0,
                    "note": "",
                }
            ],
        },
        "not_kept": [
            {k: row[k] for k in ("words", "start", "end", "status", "reason")}
            for row in said
            if row["status"] in ("broken", "not_represented")
        ],
    }
    (folder / "metrics.json").write_text(json.dumps(metrics), encoding="utf-8")
    (folder / "unreal").mkdir()
    (folder / "unreal" / "EsgScene.h").write_text("#pragma once\nclass AScene { int32 A = 1; };\n")
    Image.new("RGB", (300, 200), (90, 120, 150)).save(folder / "preview.png")
    return folder
