"""A scripted model: known drafts with seeded faults, in place of a real one.

It answers each stage with the rules drafter's document in the stage's shape and spoils answers at
a given rate the way small models do: wrong names, forgotten fields, contradictions, overlapping
windows, cut-off text. Told of a fault it answers again, less spoiled. It proves the machinery and
compares the variants; it says nothing about the quality of any real model.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
import hashlib
import json
import re
from typing import Any, get_args

import numpy as np

from esg.draft.llm.client import Call, Reply
from esg.draft.llm.stages import ParameterName
from esg.graph.models import EsgDocument, Quantity

Json = dict[str, Any]
_PARTS = {
    "scene": ("expansion", "assets", "spatial"),
    "timeline": ("timeline",),
    "single_shot": ("expansion", "assets", "spatial", "timeline"),
    "visual": ("visual",),
}
"""What the answer of each stage consists of."""
Fault = Callable[[Json, np.random.Generator], None]


class ScriptedModel:
    """Answers requests like a fallible model.

    Args:
        fault_rate: Probability that the first answer of a stage is spoiled.
        relapse_rate: Probability that a corrected answer is spoiled again.
        draft: prompt -> document to imitate; default the rules drafter.
    """

    def __init__(
        self,
        fault_rate: float = 0.3,
        relapse_rate: float = 0.1,
        draft: Callable[[str], EsgDocument] | None = None,
    ) -> None:
        self.fault_rate = fault_rate
        self.relapse_rate = relapse_rate
        self.draft = draft
        self._replies: dict[str, dict[str, Json | None]] = {}

    async def complete(self, call: Call) -> Reply:
        text = self.answer(call.stage, call.messages, call.seed)
        size_in = sum(len(t) for _, t in call.messages) + len(call.instructions)
        return Reply(text, size_in // 4, len(text) // 4)

    def answer(self, stage: str, messages: Sequence[tuple[str, str]], seed: int = 0) -> str:
        """The text of the answer to a conversation."""
        match = re.search(r"<<<\n(.*)\n>>>", messages[0][1], re.DOTALL)
        if match is None:
            return "I see no scene description."
        replies = self._known(match.group(1))
        corrected = len(messages) > 1
        rate = self.relapse_rate if corrected else self.fault_rate
        digest = hashlib.sha256(json.dumps([stage, seed, list(map(list, messages))]).encode())
        rng = np.random.default_rng(int.from_bytes(digest.digest()[:8], "little"))
        parts = _PARTS[stage]
        body: Json = {p: replies[p] for p in parts}
        stages = [p for p in parts if body[p] is not None]
        body = json.loads(json.dumps(body))
        text_fault = False
        for part in stages:
            if rng.random() < rate:
                faults = FAULTS.get(part, ())
                k = int(rng.integers(len(faults) + 1))
                if k == len(faults):
                    text_fault = True
                else:
                    faults[k](body[part], rng)
        text = json.dumps(body if len(parts) > 1 else body[stage])
        if text_fault:
            return text[: int(len(text) * rng.uniform(0.3, 0.9))]
        return text if rng.random() < 0.7 else f"Here it is:\n```json\n{text}\n```"

    def _known(self, prompt: str) -> dict[str, Json | None]:
        if prompt not in self._replies:
            draft = self.draft
            if draft is None:
                from esg.draft.rules import draft_rules

                draft = draft_rules
            self._replies[prompt] = replies_of(draft(prompt))
        return self._replies[prompt]


def replies_of(doc: EsgDocument) -> dict[str, Json | None]:
    """A document in the shapes of the stages' replies (the inverse of assembling)."""
    scene = doc.scene_definition
    parameters = scene.scene_parameters
    return {
        "expansion": {
            "expanded_description": scene.expanded_description,
            "is_dynamic": parameters.is_dynamic,
            "scene_type": parameters.scene_type,
            "environment": parameters.environment,
            "allow_supplementary": parameters.allow_supplementary,
        },
        "assets": {
            "assets": [
                {
                    "asset_id": name,
                    "category": a.asset_category,
                    "description": a.asset_description,
                    "length_cm": a.expected_dimensions_cm[0],
                    "width_cm": a.expected_dimensions_cm[1],
                    "height_cm": a.expected_dimensions_cm[2],
                    "mass_kg": a.expected_mass_kg,
                    "movable": a.is_movable,
                    "mass_is_prescribed": a.mass_is_prescribed,
                    "size_is_prescribed": a.dimensions_are_prescribed,
                    "material": a.material,
                    "color": a.color,
                    "shape": a.shape,
                }
                for name, a in doc.asset_requirement.items()
            ],
            "objects": _objects(doc),
        },
        "spatial": _spatial(doc),
        "timeline": _timeline(doc),
        "visual": {"relations": [], "places": []},
    }


def _objects(doc: EsgDocument) -> list[Json]:
    nodes = doc.spatial_relation_graph.nodes
    out: list[Json] = []
    done: set[str] = set()
    for name, node in nodes.items():
        if name in done:
            continue
        item = {
            "name": name,
            "asset_id": node.asset_id,
            "label": node.label,
            "mentioned": node.mentioned,
            "structural": node.is_structural,
        }
        base = re.sub(r"_1$", "", name)
        members = [n for n, v in nodes.items() if v.group is not None and v.group == node.group]
        counted = [f"{base}_{k + 1}" for k in range(len(members))]
        if len(members) > 1 and members == counted:
            done.update(members)
            item |= {"name": base, "count": len(members), "pattern": node.group_pattern}
        out.append(item)
    return out


def _ends(value: Quantity | None) -> tuple[float, float] | None:
    return None if value is None else value if isinstance(value, tuple) else (value, value)


def _spatial(doc: EsgDocument) -> Json:
    graph = doc.spatial_relation_graph
    relations: list[Json] = []
    for e in graph.edges.binary_relations:
        item: Json = {
            "subject": e.from_,
            "relation": e.relation_type.value,
            "object": e.to,
            "confidence": e.confidence,
            "description": e.semantic_description,
            "direction": e.cardinal,
        }
        ends = _ends(e.distance_cm)
        if ends:
            item |= {"distance_low_cm": ends[0], "distance_high_cm": ends[1]}
        relations.append(item)
    return {
        "regions": [
            {
                "name": name,
                "type": r.region_type.value,
                "parent": r.parent_object,
                "description": r.region_description,
            }
            for name, r in graph.semantic_regions.items()
        ],
        "placements": [
            {"object": name, "region": node.semantic_region}
            for name, node in graph.nodes.items()
            if node.semantic_region is not None and not node.is_structural
        ],
        "relations": relations,
        "group_relations": [
            {
                "relation": m.relation_type.value,
                "subjects": list(m.subjects),
                "targets": list(m.targets),
                "confidence": m.confidence,
            }
            for m in graph.edges.multi_relations
        ],
        "statements": _statements(doc) if doc.timeline_system is None else [],
    }


def _timeline(doc: EsgDocument) -> Json | None:
    if doc.timeline_system is None:
        return None
    graph = doc.timeline_system.sequence_graph
    events: list[Json] = []
    for n in graph.nodes:
        if n.event.value == "SceneStart":
            continue
        span = n.window or (n.timestamp or 0.0, n.timestamp or 0.0)
        constraints: list[Json] = []
        for c in n.constraints:
            low, high = _ends(c.value) or (0.0, 0.0)
            constraints.append(
                {
                    "quantity": c.quantity,
                    "object": c.object,
                    "low": low,
                    "high": high,
                    "since": c.since,
                    "to": c.to,
                }
            )
        events.append(
            {
                "id": n.id,
                "event": n.event.value,
                "participants": list(n.participants),
                "earliest_s": span[0],
                "latest_s": span[1],
                "time_is_prescribed": n.time_is_prescribed,
                "constraints": constraints,
                "position_cm": n.position_cm,
                "region": n.region,
                "turn_direction": n.turn_direction,
                "turn_degrees": n.turn_degrees,
                "times": n.times,
                "description": n.description,
            }
        )
    segments: list[Json] = []
    for e in graph.edges:
        parameters: list[Json] = []
        for name in get_args(ParameterName):
            ends = _ends(getattr(e.params, name))
            if ends is not None:
                parameters.append({"name": name, "low": ends[0], "high": ends[1]})
        turn = _ends(e.params.turn_degrees)
        segments.append(
            {
                "id": e.id,
                "start": e.from_,
                "end": e.to,
                "motion": e.event.value,
                "actor": e.actor,
                "target": e.target,
                "parameters": parameters,
                "speed_is_prescribed": e.speed_is_prescribed,
                "turn_direction": e.params.turn_direction,
                "turn_degrees": turn[0] if turn else None,
                "spin": e.params.spin,
                "backward": e.params.backward or False,
                "holds_on": e.params.release is False,
            }
        )
    return {
        "actors": [
            {
                "object": name,
                "role": a.role.value,
                "force_direction": a.force_direction.value if a.force_direction else None,
            }
            for name, a in doc.timeline_system.actors.items()
        ],
        "events": events,
        "segments": segments,
        "statements": _statements(doc),
    }


def _statements(doc: EsgDocument) -> list[Json]:
    out: list[Json] = []
    for s in doc.statements or ():
        low, high = _ends(s.value) or (None, None)
        out.append(
            {
                "says": s.predicate.value,
                "words": s.text,
                "object": list(s.object),
                "target": list(s.target),
                "direction": s.direction,
                "side": s.side,
                "quantity": s.quantity if s.quantity != "count" else None,
                "low": low,
                "high": high,
                "noun": s.noun,
                "when": s.when,
                "missing": s.note or None,
            }
        )
    return out


def _pick(items: list[Any], rng: np.random.Generator) -> Any:
    return items[int(rng.integers(len(items)))] if items else {}


def _set(items: str, key: str, value: Callable[[Any], Any]) -> Fault:
    """A fault that changes one field of a random item of a list."""

    def fault(body: Json, rng: np.random.Generator) -> None:
        item = _pick(body.get(items, []), rng)
        if key in item and item[key] is not None:
            item[key] = value(item[key])

    return fault


def _drop(items: str, key: str) -> Fault:
    def fault(body: Json, rng: np.random.Generator) -> None:
        _pick(body.get(items, []), rng).pop(key, None)

    return fault


def _lose(items: str) -> Fault:
    def fault(body: Json, rng: np.random.Generator) -> None:
        if body.get(items):
            body[items].pop(int(rng.integers(len(body[items]))))

    return fault


def _dangle(body: Json, rng: np.random.Generator) -> None:
    first = _pick(body["placements"], rng).get("object", "thing")
    body["relations"].append({"subject": first, "relation": "near", "object": "invisible_9"})


def _contradict(body: Json, rng: np.random.Generator) -> None:
    names = [p["object"] for p in body["placements"]][:2]
    if len(names) == 2:
        for relation in ("left_of", "right_of"):
            edge = {"subject": names[0], "relation": relation, "object": names[1]}
            body["relations"].append(edge)


def _two_faces(body: Json, rng: np.random.Generator) -> None:
    faces = [r for r in body["relations"] if r["relation"] == "face"]
    if faces:
        other = "+X" if faces[0].get("direction") != "+X" else "-Y"
        base = body["regions"][0]["parent"]
        body["relations"].append({**faces[0], "object": base, "direction": other})


def _overlap(body: Json, rng: np.random.Generator) -> None:
    if body["events"]:
        body["events"][0]["latest_s"] = body["events"][-1]["latest_s"] + 1.0


FAULTS: dict[str, tuple[Fault, ...]] = {
    "expansion": (lambda body, rng: body.update(scene_type="both"),),
    "assets": (
        _set("assets", "mass_kg", lambda v: -v - 1.0),
        _set("assets", "length_cm", lambda v: v * 1e5),
        _set("objects", "asset_id", lambda v: v.replace("_", "-").title()),
        _set("objects", "asset_id", lambda v: "model_0815"),
        _drop("assets", "mass_kg"),
    ),
    "spatial": (
        _set("placements", "object", lambda v: re.sub(r"_\d+$", "", v)),
        _set("relations", "object", lambda v: v.replace("_", " ").title()),
        _set("regions", "parent", lambda v: "somewhere"),
        _drop("relations", "object"),
        _lose("placements"),
        _dangle,
        _contradict,
        _two_faces,
    ),
    "timeline": (
        _set("segments", "actor", lambda v: re.sub(r"_\d+$", "", v)),
        _set("segments", "start", lambda v: v + "_event"),
        _set("events", "participants", lambda v: [*v[:1], "invisible_9"]),
        _set("actors", "force_direction", lambda v: None),
        _set("actors", "role", lambda v: "passive" if v == "active" else "active"),
        _set("events", "earliest_s", lambda v: v + 1e4),
        _drop("segments", "motion"),
        _lose("segments"),
        _lose("actors"),
        _overlap,
    ),
}
"""What goes wrong in each stage; some of it code repairs, the rest the model must."""
