"""From the model's replies to a document: expansion of groups, reference repair, defaults.

All of this is code: a misspelled name costs no further request. Every change of what the model said
is recorded in words.
"""

from __future__ import annotations

from dataclasses import dataclass, field
import hashlib
from typing import Any

from esg.draft.llm.faces import face
from esg.draft.llm.jointed import join_parts, leave_out_unjointed, let_break, seat_riders
from esg.draft.llm.mending import at_sides, mend, plain_labels
from esg.draft.llm.names import Names, slug, unique
from esg.draft.llm.segments import open_times, sound_segments
from esg.draft.llm.stages import (
    AssetsReply,
    EventPart,
    ExpansionReply,
    GroupRelationPart,
    SegmentPart,
    SpatialReply,
    TimelineReply,
)
from esg.draft.llm.stated import state
from esg.graph.models import EdgeEvent, ForceDirection, NodeEvent, Role

Json = dict[str, Any]

START = "scene_start"
GROUND: Json = {
    "asset_category": "ground",
    "asset_description": "flat ground",
    "expected_dimensions_cm": [12000.0, 12000.0, 10.0],
    "expected_mass_kg": 10000.0,
    "is_movable": False,
}
_BASE_NAMES = ("ground", "floor", "road", "street", "land", "surface", "base")


@dataclass(frozen=True)
class Replies:
    """What the model has said so far."""

    expansion: ExpansionReply
    assets: AssetsReply
    spatial: SpatialReply
    timeline: TimelineReply | None


@dataclass
class _Work:
    raw: Json
    objects: Names
    repair: bool
    groups: dict[str, list[str]] = field(default_factory=dict[str, list[str]])
    base: str | None = None
    log: list[str] = field(default_factory=list[str])


def assemble(
    prompt: str, seed: int, replies: Replies, *, repair: bool = True
) -> tuple[Json, tuple[str, ...]]:
    """The document as plain JSON, not yet verified, and what was repaired.

    Args:
        prompt: The user's text.
        seed: Enters the scene id.
        replies: One reply a stage.
        repair: False builds what was said, errors included (ablation without validation); what the
            form of the replies leaves to code is filled in all the same.
    """
    work = _Work({}, Names("object", repair=repair), repair)
    digest = hashlib.sha256(f"{prompt}\0{seed}\0llm".encode()).hexdigest()[:8]
    expansion = replies.expansion
    timeline = replies.timeline if expansion.is_dynamic else None
    work.raw = {
        "schema_version": "1.0.0",
        "scene_definition": {
            "scene_id": f"{slug(prompt)[:40].strip('_') or 'scene'}-{digest}",
            "original_description": prompt,
            "expanded_description": expansion.expanded_description,
            "scene_parameters": {
                "is_dynamic": timeline is not None,
                "scene_type": expansion.scene_type,
                "environment": slug(expansion.environment),
                "allow_supplementary": expansion.allow_supplementary,
            },
        },
        "asset_requirement": {},
        "spatial_relation_graph": {
            "semantic_regions": {},
            "nodes": {},
            "edges": {"binary_relations": [], "multi_relations": []},
        },
    }
    _objects(work, replies.assets)
    _space(work, replies.spatial)
    logs = [work.log, work.objects.log]
    events = Names("event", repair=work.repair)
    if timeline is not None:
        logs += _time(work, timeline, events)
    stated = replies.spatial.statements if timeline is None else timeline.statements
    logs.append(state(work.raw, prompt, stated, work.objects, events))
    # What a reply leaves to code by its form is no repair: it is filled in without one, too.
    logs += [join_parts(work.raw), let_break(work.raw), seat_riders(work.raw)]
    if work.repair:
        logs += [leave_out_unjointed(work.raw, prompt), at_sides(work.raw), plain_labels(work.raw)]
    face(work.raw, once=work.repair)
    return work.raw, tuple(unique(text for log in logs for text in log))


def _objects(work: _Work, reply: AssetsReply) -> None:
    assets, nodes = work.raw["asset_requirement"], work.raw["spatial_relation_graph"]["nodes"]
    names = Names("asset", repair=work.repair)
    for a in reply.assets:
        name = slug(a.asset_id)
        names.add(name, a.asset_id, a.category)
        assets[name] = {
            "asset_category": slug(a.category),
            "asset_description": a.description,
            "expected_dimensions_cm": [a.length_cm, a.width_cm, a.height_cm],
            "expected_mass_kg": a.mass_kg,
            "is_movable": a.movable,
            "mass_is_prescribed": a.mass_is_prescribed,
            "dimensions_are_prescribed": a.size_is_prescribed,
            "material": a.material,
            "color": a.color,
            "shape": a.shape,
        }
    for o in reply.objects:
        base = slug(o.name)
        members = [base] if o.count == 1 else [f"{base}_{k + 1}" for k in range(o.count)]
        asset = names.one(slug(o.asset_id) if slug(o.asset_id) in names.ids else o.asset_id)
        if o.count > 1:
            work.groups[base] = members
        for member in members:
            nodes[member] = {
                "asset_id": asset,
                "semantic_region": None,
                "is_structural": o.structural,
                "label": o.label,
                "mentioned": o.mentioned,
                "group": base if o.count > 1 else None,
                "group_pattern": (o.pattern or "scatter") if o.count > 1 else None,
            }
            work.objects.add(member, o.name, *([o.label] if o.label else []))
    work.log += names.log
    if work.repair:
        _structure(work, assets, nodes)
    work.base = next((n for n, v in nodes.items() if v["is_structural"]), None)
    if work.base is not None:
        work.objects.add(work.base, *(n for n in _BASE_NAMES if n not in nodes))


def _structure(work: _Work, assets: Json, nodes: Json) -> None:
    """Adds a missing ground, makes structural assets fixed, drops assets nothing uses."""
    if nodes and not any(v["is_structural"] for v in nodes.values()):
        named = next((n for n in nodes if n.partition("_")[0] in ("ground", "floor", "road")), None)
        if named is not None:
            nodes[named]["is_structural"] = True
            work.log.append(f"object {named!r} made structural")
        else:
            assets.setdefault("ground", dict(GROUND))
            nodes["ground_1"] = {
                "asset_id": "ground",
                "is_structural": True,
                "mentioned": False,
            }
            work.objects.add("ground_1", "ground")
            work.log.append("ground added")
    regular = {v["asset_id"] for v in nodes.values() if not v.get("is_structural")}
    for v in nodes.values():
        asset = assets.get(v["asset_id"])
        if v.get("is_structural") and asset and v["asset_id"] not in regular:
            asset["is_movable"] = False
    for name in [n for n in assets if n not in {v["asset_id"] for v in nodes.values()}]:
        del assets[name]
        work.log.append(f"asset {name!r} dropped: no object uses it")


def _space(work: _Work, reply: SpatialReply) -> None:
    graph = work.raw["spatial_relation_graph"]
    nodes, regions = graph["nodes"], graph["semantic_regions"]
    names = Names("region", repair=work.repair)
    for r in reply.regions:
        name = slug(r.name)
        names.add(name, r.name)
        regions[name] = {
            "region_description": r.description,
            "region_type": r.type.value,
            "parent_object": work.objects.one(r.parent),
        }
    for p in reply.placements:
        for member in work.objects.find(p.object):
            if member in nodes and not nodes[member].get("is_structural"):
                known = slug(p.region) if slug(p.region) in names.ids else p.region
                nodes[member]["semantic_region"] = names.one(known)
    seen: set[tuple[str, str, str]] = set()
    for r in reply.relations:
        low, high = r.distance_low_cm, r.distance_high_cm
        ends = [v for v in (low, high) if v is not None]
        distance = None if not ends else ends[0] if ends[0] == ends[-1] else ends
        for subject in work.objects.find(r.subject):
            target = work.objects.one(r.object)
            key = (subject, r.relation.value, target)
            if work.repair and key in seen:
                work.log.append(f"relation {' '.join(key)!r} was stated twice")
                continue
            seen.add(key)
            graph["edges"]["binary_relations"].append(
                {
                    "from": subject,
                    "to": target,
                    "relation_type": r.relation.value,
                    "confidence": r.confidence,
                    "semantic_description": r.description,
                    "distance_cm": distance,
                    "cardinal": r.direction,
                }
            )
    for g in reply.group_relations:
        graph["edges"]["multi_relations"].append(_group(work, g))
    _regions(work, names)
    work.log += names.log


def _group(work: _Work, g: GroupRelationPart) -> Json:
    def members(names: list[str]) -> list[str]:
        return unique(m for n in names for m in work.objects.find(n))

    return {
        "subjects": members(g.subjects),
        "targets": members(g.targets),
        "relation_type": g.relation.value,
        "confidence": g.confidence,
        "semantic_description": g.description,
    }


def _regions(work: _Work, names: Names) -> None:
    """Gives each object without a known region the one that its support implies."""
    graph = work.raw["spatial_relation_graph"]
    nodes, regions = graph["nodes"], graph["semantic_regions"]
    support = {
        e["from"]: (e["to"], e["relation_type"])
        for e in graph["edges"]["binary_relations"]
        if e["relation_type"] in ("on", "inside_of", "attached_vertical", "attached_horizontal")
    }
    kinds = {
        "on": "SUPPORT_SURFACE",
        "inside_of": "STORAGE",
        "attached_vertical": "ATTACHED_VERTICAL",
        "attached_horizontal": "ATTACHED_HORIZONTAL",
    }
    for name, node in nodes.items():
        inside = regions.get(node.get("semantic_region") or "")
        if not work.repair and node.get("semantic_region"):
            continue
        if node.get("is_structural") or (inside and inside["parent_object"] != name):
            continue
        parent, relation = support.get(name, (work.base, "on"))
        if parent is None or parent not in nodes or parent == name:
            continue
        fitting = (
            k
            for k, r in regions.items()
            if r["parent_object"] == parent and r["region_type"] == kinds[relation]
        )
        region = next(fitting, None)
        if region is None:
            region = slug(f"{parent}_{'inside' if relation == 'inside_of' else 'area'}")
            regions[region] = {
                "region_description": f"{relation} {parent}",
                "region_type": kinds[relation],
                "parent_object": parent,
            }
            names.add(region)
        if node.get("semantic_region"):
            work.log.append(f"region {node['semantic_region']!r} read as {region}")
        node["semantic_region"] = region


def _time(work: _Work, reply: TimelineReply, events: Names) -> list[list[str]]:
    objects = work.objects
    events.add(START, "start", "scene_start", "SceneStart")
    for e in reply.events:
        if e.event is NodeEvent.SCENE_START:
            events.add(START, e.id)
        else:
            events.add(slug(e.id), e.id)
    log: list[str] = []
    actors: Json = {}
    for a in reply.actors:
        for name in objects.find(a.object):
            actors[name] = _actor(work, name, a.role, a.force_direction, log)
    nodes: list[Json] = [{"id": START, "event": "SceneStart", "timestamp": 0.0}]
    for e in reply.events:
        if e.event is NodeEvent.SCENE_START:
            continue
        people = unique(n for p in e.participants for n in _people(work, p, e.event))
        nodes.append(
            {
                "id": slug(e.id),
                "event": e.event.value,
                "participants": people,
                **_when(e),
                "constraints": [
                    {
                        "quantity": c.quantity,
                        "object": objects.one(c.object),
                        "value": c.low if c.low == c.high else [c.low, c.high],
                        "since": None if c.since is None else events.one(c.since),
                        "to": None if c.to is None else objects.one(c.to),
                    }
                    for c in e.constraints
                ],
                "position_cm": e.position_cm,
                "region": None if e.region is None else _named_region(work, e.region),
                "turn_direction": e.turn_direction,
                "turn_degrees": e.turn_degrees,
                "times": e.times,
                "description": e.description,
            }
        )
    edges = [_segment(work, s, events) for s in reply.segments]
    if work.repair:
        edges = sound_segments(nodes, edges, log)
        _missing_actors(nodes, edges, actors, objects, log)
        log += mend(nodes, edges, actors, work.base)
    open_times(nodes, edges)
    work.raw["timeline_system"] = {
        "actors": actors,
        "sequence_graph": {"nodes": nodes, "edges": edges},
    }
    return [events.log, log]


def _when(e: EventPart) -> Json:
    """Its time; neither of both where the model left it open."""
    if e.earliest_s is None and e.latest_s is None:
        return {"timestamp": None, "window": None, "time_is_prescribed": False}
    low = e.earliest_s if e.earliest_s is not None else e.latest_s
    high = e.latest_s if e.latest_s is not None else low
    return {
        "timestamp": low if low == high else None,
        "window": None if low == high else [low, high],
        "time_is_prescribed": e.time_is_prescribed,
    }


def _actor(
    work: _Work, name: str, role: Role, direction: ForceDirection | None, log: list[str]
) -> Json:
    if work.repair and role is Role.PASSIVE and direction is not None:
        log.append(f"force direction of passive {name!r} dropped")
        direction = None
    if work.repair and role is Role.ACTIVE and direction is None:
        log.append(f"force direction of active {name!r} set to HORIZONTAL_PLANE")
        direction = ForceDirection.HORIZONTAL_PLANE
    return {"role": role.value, "force_direction": direction.value if direction else None}


def _people(work: _Work, name: str, event: NodeEvent) -> list[str]:
    """Members a participant stands for: in an event of two, a group is met at its first member."""
    found = work.objects.find(name)
    pairs = (NodeEvent.COLLISION, NodeEvent.REACH, NodeEvent.MISS)
    return found[:1] if event in pairs else found


def _named_region(work: _Work, text: str) -> str:
    owner, slash, region = text.partition("/")
    return f"{work.objects.one(owner)}/{region}" if slash else text


def _segment(work: _Work, s: SegmentPart, events: Names) -> Json:
    params: Json = {p.name: p.low if p.low == p.high else [p.low, p.high] for p in s.parameters}
    if s.motion is EdgeEvent.TURN:
        params["turn_direction"], params["turn_degrees"] = s.turn_direction, s.turn_degrees
    elif s.motion is EdgeEvent.SPIN and s.turn_direction is not None:
        params["turn_direction"] = s.turn_direction
    if s.spin is not None:
        params["spin"] = s.spin
    if s.backward:
        params["backward"] = True
    if s.motion is EdgeEvent.GUIDE and s.holds_on:
        params["release"] = False
    if work.repair and s.motion is EdgeEvent.INERTIAL_CONNECTOR:
        params = {}
    return {
        "id": slug(s.id),
        "from": events.one(s.start),
        "to": events.one(s.end),
        "event": s.motion.value,
        "actor": work.objects.one(s.actor),
        "target": None if s.target is None else work.objects.one(s.target),
        "params": params,
        "speed_is_prescribed": s.speed_is_prescribed,
    }


def _missing_actors(
    nodes: list[Json], edges: list[Json], actors: Json, objects: Names, log: list[str]
) -> None:
    """Lists as actors what segments move although the model forgot to list it."""
    for e in edges:
        name = e["actor"]
        if name in actors or name not in objects.ids:
            continue
        if e["event"] == EdgeEvent.INERTIAL_CONNECTOR.value:
            actors[name] = {"role": "passive"}
        else:
            direction = ForceDirection.HORIZONTAL_PLANE.value
            actors[name] = {"role": "active", "force_direction": direction}
        log.append(f"actor {name!r} added")
