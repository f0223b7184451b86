"""Generated corruptions of valid documents, each with the violation it must cause.

Every generator walks a whole document and damages one place at a time, so that the number of
corruptions grows with the corpus. `also` lists codes that the same damage may rightly cause beside
the expected one; anything else in the verifier's answer is a false alarm.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
import copy
from dataclasses import dataclass
from typing import Any

from tests.graph.builders import PASSIVE, VALID, Json, edge, event, rel

Path = tuple[str | int, ...]
GRAPH = ("spatial_relation_graph",)
NODES = (*GRAPH, "nodes")
BINARY = (*GRAPH, "edges", "binary_relations")
MULTI = (*GRAPH, "edges", "multi_relations")
EVENTS = ("timeline_system", "sequence_graph", "nodes")
SEGMENTS = ("timeline_system", "sequence_graph", "edges")
ACTORS = ("timeline_system", "actors")


@dataclass(frozen=True)
class Corruption:
    """One damaged document.

    Args:
        name: Base document, place and kind of the damage.
        raw: The damaged document.
        code: Code that must be reported.
        pointer: Beginning of the pointer under which it must be reported.
        also: Codes that may be reported beside it.
    """

    name: str
    raw: Json
    code: str
    pointer: str
    also: frozenset[str] = frozenset()


def get(tree: Any, path: Path) -> Any:
    for part in path:
        tree = tree[part]
    return tree


def put(raw: Json, path: Path, value: Any) -> Json:
    out = copy.deepcopy(raw)
    get(out, path[:-1])[path[-1]] = value
    return out


def without(raw: Json, path: Path) -> Json:
    out = copy.deepcopy(raw)
    del get(out, path[:-1])[path[-1]]
    return out


def append(raw: Json, path: Path, *values: Any) -> Json:
    out = copy.deepcopy(raw)
    get(out, path).extend(values)
    return out


def where(path: Path) -> str:
    return "".join(f"/{p}" for p in path)


class Maker:
    """Names and collects the corruptions of one base document."""

    def __init__(self, base: str) -> None:
        self.base = base
        self.raw = VALID[base]()
        self.made: list[Corruption] = []

    def add(
        self, code: str, path: Path, raw: Json, *also: str, note: str = "", at: Path | None = None
    ) -> None:
        name = f"{self.base}{where(path)}:{code}{':' + note if note else ''}"
        pointer = where(path if at is None else at)
        if any(c.name == name for c in self.made):
            name += f":{len(self.made)}"
        self.made.append(Corruption(name, raw, code, pointer, frozenset(also)))

    def set(self, code: str, path: Path, value: Any, *also: str, note: str = "") -> None:
        self.add(code, path, put(self.raw, path, value), *also, note=note)


def schema(m: Maker) -> None:
    raw = m.raw
    for path, key in ((("scene_definition",), "scene_id"), (EVENTS, None), (SEGMENTS, None)):
        if path[0] not in raw:
            continue
        targets = [path] if key else [(*path, i) for i in range(len(get(raw, path)))]
        for target in targets:
            field = key or "id"
            m.add("SCHEMA_MISSING", (*target, field), without(raw, (*target, field)))
    for name in raw["asset_requirement"]:
        base = ("asset_requirement", name)
        m.add(
            "SCHEMA_MISSING",
            (*base, "expected_mass_kg"),
            without(raw, (*base, "expected_mass_kg")),
        )
        m.set("SCHEMA_UNKNOWN_FIELD", (*base, "expected_masskg"), 3.0)
        m.set("SCHEMA_TYPE", (*base, "expected_mass_kg"), "12 kg")
        m.set("SCHEMA_TYPE", (*base, "expected_dimensions_cm"), [1.0, 2.0])
        m.set("SCHEMA_TYPE", (*base, "is_movable"), "yes", "ACTOR_IMMOVABLE")
        m.set("JSON_NOT_FINITE", (*base, "expected_mass_kg"), float("nan"))
        m.set("JSON_NOT_FINITE", (*base, "expected_dimensions_cm", 1), float("inf"))
        m.set("JSON_NUMBER_RANGE", (*base, "expected_mass_kg"), 10**400)
        m.set("JSON_NUMBER_RANGE", (*base, "expected_mass_kg"), -1e18, note="float")
    for i, _ in enumerate(get(raw, BINARY)):
        m.set("SCHEMA_VALUE", (*BINARY, i, "relation_type"), "next_to")
    for region in get(raw, (*GRAPH, "semantic_regions")):
        m.set("SCHEMA_VALUE", (*GRAPH, "semantic_regions", region, "region_type"), "SHELF")
    m.set("SCHEMA_VERSION", ("schema_version",), "9.9.9")
    m.set("SCHEMA_VERSION", ("schema_version",), 1, note="number")
    m.set("SCHEMA_TYPE", NODES, [], "COVERAGE_POINTER")
    m.set("SCHEMA_TYPE", ("scene_definition", "original_description"), None)
    m.set("SCHEMA_VALUE", ("scene_definition", "scene_parameters", "scene_type"), "space")
    m.set("SCHEMA_VALUE", ("scene_definition", "coordinate_system"), {"units": "m"})
    if "timeline_system" in raw:
        for i, item in enumerate(get(raw, SEGMENTS)):
            m.set("SCHEMA_VALUE", (*SEGMENTS, i, "event"), "Teleport")
            m.set("SCHEMA_TYPE", (*SEGMENTS, i, "params"), {**item.get("params", {}), "speed": "5"})
            m.set("SCHEMA_TYPE", (*SEGMENTS, i, "params"), {"speed": [1, 2, 3]}, note="triple")
        for i, _ in enumerate(get(raw, EVENTS)):
            m.set("SCHEMA_VALUE", (*EVENTS, i, "event"), "Explode")


def references(m: Maker) -> None:
    raw = m.raw
    for name, item in get(raw, NODES).items():
        m.set("REF_ASSET", (*NODES, name, "asset_id"), "no_such_asset", "ASSET_UNUSED")
        if item.get("semantic_region"):
            m.set(
                "REF_REGION", (*NODES, name, "semantic_region"), "no_such_region", "REGION_CONFLICT"
            )
    for region in get(raw, (*GRAPH, "semantic_regions")):
        m.set("REF_REGION_PARENT", (*GRAPH, "semantic_regions", region, "parent_object"), "nobody")
    for i, _ in enumerate(get(raw, BINARY)):
        m.set("REF_RELATION", (*BINARY, i, "from"), "nobody", "FACE_MISSING")
        m.set("REF_RELATION", (*BINARY, i, "to"), "nobody")
    for i, item in enumerate(get(raw, MULTI)):
        m.set("REF_GROUP", (*MULTI, i, "subjects", 0), "nobody")
        if item.get("targets"):
            m.set("REF_GROUP", (*MULTI, i, "targets", 0), "nobody")
    if "timeline_system" not in raw:
        return
    m.set("REF_ACTOR", (*ACTORS, "nobody"), PASSIVE)
    for i, item in enumerate(get(raw, EVENTS)):
        for k, _ in enumerate(item.get("participants", [])):
            m.set(
                "REF_PARTICIPANT",
                (*EVENTS, i, "participants", k),
                "nobody",
                "EVENT_NO_ACTOR",
                "EDGE_ACTOR_ABSENT",
                "CONNECTOR_DOWNSTREAM",
                "CONNECTOR_UPSTREAM",
                "CONSTRAINT_OBJECT",
            )
        for k, c in enumerate(item.get("constraints", [])):
            m.set("REF_CONSTRAINT", (*EVENTS, i, "constraints", k, "object"), "nobody")
            if c.get("since"):
                m.set("REF_EVENT", (*EVENTS, i, "constraints", k, "since"), "never")
        if item["event"] == "EnterRegion":
            m.set("REF_NAMED_REGION", (*EVENTS, i, "region"), "nobody/pocket")
            m.set("REF_NAMED_REGION", (*EVENTS, i, "region"), "pocket", note="form")
    for i, item in enumerate(get(raw, SEGMENTS)):
        lost = (
            "EVENT_MOVER",
            "TIMELINE_UNREACHABLE",
            "CONNECTOR_UPSTREAM",
            "CONNECTOR_DOWNSTREAM",
            "EDGE_PARAM_MISSING",
        )
        m.set("REF_EVENT", (*SEGMENTS, i, "from"), "never", *lost)
        m.set("REF_EVENT", (*SEGMENTS, i, "to"), "never", *lost)
        m.set("REF_EDGE_ACTOR", (*SEGMENTS, i, "actor"), "nobody", "ACTOR_IDLE", "EVENT_MOVER")
        m.set("REF_EDGE_TARGET", (*SEGMENTS, i, "target"), "nobody")
        m.set("EDGE_TARGET_SELF", (*SEGMENTS, i, "target"), item["actor"])


def scene(m: Maker) -> None:
    raw = m.raw
    for bad in ("", "../x", "a b", "x/y", "ä" * 200, ".hidden"):
        m.set("SCENE_ID_MALFORMED", ("scene_definition", "scene_id"), bad, note=bad[:9])
    bounds = ("scene_definition", "coordinate_system")
    m.set(
        "INTERVAL_REVERSED",
        bounds,
        {"world_bounds_cm": [[6000, -6000, -500], [-6000, 6000, 3000]]},
        "POSE_RANGE",
        "EVENT_RANGE",
    )
    base = put(raw, ("asset_requirement", "spare"), raw["asset_requirement"]["ground"])
    m.add("ASSET_UNUSED", ("asset_requirement", "spare"), base, "CONFIG_MISSING")
    second = put(raw, (*NODES, "ground_2"), get(raw, (*NODES, "ground_1")))
    m.add("SCENE_TWO_BASES", (*NODES, "ground_2"), second, "POSE_MISSING")
    floating = copy.deepcopy(raw)
    for item in get(floating, NODES).values():
        if item.pop("is_structural", False):
            item["semantic_region"] = "ground_area"
    m.add("SCENE_NO_BASE", NODES, floating, "REGION_CYCLE", "RELATION_CARDINAL", "FACE_MISSING")
    for name, item in get(raw, NODES).items():
        spaced = copy.deepcopy(raw)
        get(spaced, NODES)[f"bad {name}"] = item
        m.add(
            "ID_MALFORMED",
            (*NODES, f"bad {name}"),
            spaced,
            "POSE_MISSING",
            "SCENE_NO_BASE",
            "SCENE_TWO_BASES",
            "FACE_MISSING",
        )
        if not item.get("is_structural"):
            m.add("REGION_MISSING", (*NODES, name), without(raw, (*NODES, name, "semantic_region")))
            path = (*NODES, name, "group_pattern")
            lone = put(put(raw, path, "row"), (*NODES, name, "group"), None)
            m.add("GROUP_PATTERN", path, lone)
    for region, item in get(raw, (*GRAPH, "semantic_regions")).items():
        path = (*GRAPH, "semantic_regions", region)
        m.set("INTERVAL_REVERSED", (*path, "bounds_cm"), [[0, 5, 0], [1, -5, 1]])
        parent = item["parent_object"]
        if not get(raw, (*NODES, parent)).get("is_structural"):
            m.add(
                "REGION_CYCLE",
                (*NODES, parent, "semantic_region"),
                put(raw, (*NODES, parent, "semantic_region"), region),
                "REGION_CONFLICT",
                at=NODES,
            )


def units(m: Maker) -> None:
    raw = m.raw
    for name, spec in raw["asset_requirement"].items():
        base = ("asset_requirement", name)
        mass, size = spec["expected_mass_kg"], spec["expected_dimensions_cm"]
        m.set("UNIT_MASS", (*base, "expected_mass_kg"), -mass, "CONFIG_MASS", note="negative")
        m.set("UNIT_SIZE", (*base, "expected_dimensions_cm"), [0.0, *size[1:]], note="zero")
        m.set("UNIT_SIZE", (*base, "expected_dimensions_cm"), [-v for v in size], note="negative")
        m.set("UNIT_DAMPING", (*base, "linear_damping"), -0.1)
        m.set("UNIT_DAMPING", (*base, "linear_damping"), 1e4, note="huge")
        if spec.get("is_movable", True):
            m.set("UNIT_MASS", (*base, "expected_mass_kg"), 0.0, "CONFIG_MASS", note="zero")
            m.set("UNIT_MASS", (*base, "expected_mass_kg"), 1e9, "CONFIG_MASS", note="huge")
            m.set("UNIT_SIZE", (*base, "expected_dimensions_cm"), [v * 1e4 for v in size])
            if not spec.get("mass_is_prescribed"):
                in_grams = min(mass * 1e3, 1e5)
                density = in_grams / (size[0] * size[1] * size[2] * 1e-6)
                if density > 25_000:
                    m.set("UNIT_DENSITY", (*base, "expected_mass_kg"), in_grams, note="grams")
                in_metres = [v / 100 for v in size]
                if min(in_metres) >= 0.1:
                    m.set(
                        "UNIT_DENSITY",
                        (*base, "expected_dimensions_cm"),
                        in_metres,
                        "RELATION_TOO_SMALL",
                        note="metres",
                    )
                    m.made[-1] = Corruption(
                        m.made[-1].name,
                        m.made[-1].raw,
                        "UNIT_DENSITY",
                        where(base),
                        m.made[-1].also,
                    )


def relations(m: Maker) -> None:
    raw = m.raw
    count = len(get(raw, BINARY))
    new = (*BINARY, count)
    opposite = {
        "left_of": "right_of",
        "in_front_of": "behind",
        "behind": "in_front_of",
        "on": "under",
        "under": "on",
        "higher_than": "lower_than",
        "above": "under",
        "near": "far_from",
        "adjacent": "far_from",
        "far_from": "near",
        "same_level_as": "higher_than",
        "right_of": "left_of",
    }
    for i, item in enumerate(get(raw, BINARY)):
        a, kind, b = item["from"], item["relation_type"], item["to"]
        m.set("RELATION_SELF", (*BINARY, i, "to"), a, "RELATION_CARDINAL")
        m.made[-1] = Corruption(
            m.made[-1].name, m.made[-1].raw, "RELATION_SELF", where((*BINARY, i)), m.made[-1].also
        )
        m.set("RELATION_CONFIDENCE", (*BINARY, i, "confidence"), 1.5)
        m.set("RELATION_CONFIDENCE", (*BINARY, i, "confidence"), -0.1, note="negative")
        m.set("RELATION_DISTANCE", (*BINARY, i, "distance_cm"), -3.0)
        m.set("INTERVAL_REVERSED", (*BINARY, i, "distance_cm"), [30.0, 3.0])
        m.add("RELATION_DUPLICATE", new, append(raw, BINARY, item), note=str(i))
        if kind in opposite:
            support = ("RELATION_TWO_SUPPORTS", "REGION_CONFLICT", "RELATION_STRUCTURAL")
            against = rel(a, opposite[kind], b)
            m.add(
                "RELATION_CONTRADICTION",
                new,
                append(raw, BINARY, against),
                *support,
                note=f"{i}opposite",
            )
            if kind in ("left_of", "right_of", "behind", "in_front_of", "on", "higher_than"):
                m.add(
                    "RELATION_CONTRADICTION",
                    new,
                    append(raw, BINARY, rel(b, kind, a)),
                    *support,
                    note=f"{i}mutual",
                )
                spare = copy.deepcopy(raw)
                get(spare, NODES)["third_1"] = {
                    **get(raw, NODES)[a],
                    "is_structural": False,
                    "mentioned": False,
                }
                third = "third_1"
                m.add(
                    "RELATION_CYCLE",
                    BINARY,
                    append(spare, BINARY, rel(b, kind, third), rel(third, kind, a)),
                    *support,
                    "RELATION_CONTRADICTION",
                    "POSE_MISSING",
                    note=f"{i}cycle",
                )
        if kind != "face":
            m.set("RELATION_CARDINAL", (*BINARY, i, "cardinal"), "+X")
        else:
            other = "-X" if item.get("cardinal") != "-X" else "+Y"
            m.add(
                "FACE_DUPLICATE",
                new,
                append(raw, BINARY, rel(a, "face", "ground_1", cardinal=other)),
                note=str(i),
            )
            if not item.get("cardinal"):
                m.add(
                    "RELATION_CARDINAL",
                    (*BINARY, i),
                    put(raw, (*BINARY, i, "cardinal"), "+X"),
                )
            if a not in ("laptop_1", "cue_ball_1", "chair_1", "chair_2", "chair_3", "chair_4"):
                m.add("FACE_MISSING", (*NODES, a), without(raw, (*BINARY, i)))
        if kind in ("on", "inside_of", "attached_vertical"):
            m.add(
                "RELATION_TWO_SUPPORTS",
                new,
                append(raw, BINARY, rel(a, "on", _regular(raw, {a, b}))),
                "REGION_CONFLICT",
                "RELATION_CYCLE",
                "RELATION_CONTRADICTION",
                note=str(i),
            )
    thing = _regular(raw, set())
    m.add(
        "RELATION_STRUCTURAL",
        new,
        append(raw, BINARY, rel("ground_1", "on", thing)),
        "RELATION_CYCLE",
    )
    for i, item in enumerate(get(raw, MULTI)):
        path = (*MULTI, i)
        m.set("RELATION_CONFIDENCE", (*path, "confidence"), 7.0)
        m.set("RELATION_DISTANCE", (*path, "spacing_cm"), -1.0)
        m.set("RELATION_ARITY", (*path, "subjects"), [])
        m.made[-1] = Corruption(m.made[-1].name, m.made[-1].raw, "RELATION_ARITY", where(path))
        m.add(
            "RELATION_DUPLICATE",
            (*path, "subjects"),
            append(raw, (*path, "subjects"), item["subjects"][0]),
        )
        if item["relation_type"] != "align":
            m.add(
                "RELATION_SELF",
                path,
                put(raw, (*path, "targets"), [*item.get("targets", []), item["subjects"][0]]),
            )
    if m.base == "study":
        m.add(
            "RELATION_TOO_SMALL",
            new,
            put(
                append(raw, BINARY, rel("table_1", "inside_of", "box_1")),
                (*NODES, "table_1", "semantic_region"),
                "box_inside",
            ),
            "RELATION_CONTRADICTION",
            "RELATION_CYCLE",
        )
        m.add(
            "REGION_CONFLICT",
            new,
            put(
                append(raw, BINARY, rel("chair_1", "on", "table_1")),
                (*NODES, "chair_1", "semantic_region"),
                "desk_top",
            ),
        )


def _regular(raw: Json, but: set[str]) -> str:
    return next(
        n for n, v in get(raw, NODES).items() if not v.get("is_structural") and n not in but
    )


def timeline(m: Maker) -> None:
    raw = m.raw
    parameters = ("scene_definition", "scene_parameters")
    if "timeline_system" not in raw:
        m.add(
            "TIMELINE_MISSING",
            ("timeline_system",),
            put(raw, (*parameters, "is_dynamic"), True),
        )
        return
    m.add("TIMELINE_UNEXPECTED", ("timeline_system",), put(raw, (*parameters, "is_dynamic"), False))
    m.add("TIMELINE_MISSING", ("timeline_system",), without(raw, ("timeline_system",)))
    empty = put(put(put(raw, EVENTS, [get(raw, EVENTS)[0]]), SEGMENTS, []), ACTORS, {})
    m.add("TIMELINE_EMPTY", ("timeline_system",), empty)
    events = get(raw, EVENTS)
    second = {"id": "second_start", "event": "SceneStart", "timestamp": 0.0}
    m.add("TIMELINE_START", EVENTS, append(raw, EVENTS, second))
    m.add(
        "TIMELINE_START",
        EVENTS,
        without(raw, (*EVENTS, 0)),
        "REF_EVENT",
        "TIMELINE_UNREACHABLE",
        note="none",
    )
    m.add(
        "TIMELINE_START_TIME",
        (*EVENTS, 0),
        put(raw, (*EVENTS, 0, "timestamp"), 0.5),
        "TIME_ORDER",
    )
    m.add(
        "TIMELINE_START_TIME",
        (*EVENTS, 0),
        without(raw, (*EVENTS, 0, "timestamp")),
        note="no time",
    )
    m.add(
        "TIMELINE_UNREACHABLE",
        EVENTS,
        append(raw, EVENTS, {**events[1], "id": "island", "constraints": []}),
    )
    orphan = [e for e in get(raw, SEGMENTS) if e["to"] != events[-1]["id"]]
    m.add(
        "TIMELINE_UNREACHABLE",
        (*EVENTS, len(events) - 1),
        put(raw, SEGMENTS, orphan),
        "ACTOR_IDLE",
        note="cut",
    )
    for i, item in enumerate(events[1:], 1):
        path = (*EVENTS, i)
        span = item.get("window") or [item["timestamp"], item["timestamp"]]
        bare = {k: v for k, v in item.items() if k not in ("window", "timestamp")}
        m.add("TIME_MISSING", path, put(raw, path, bare))
        m.add(
            "TIME_BOTH",
            path,
            put(raw, path, {**bare, "window": span, "timestamp": span[0]}),
        )
        m.add(
            "INTERVAL_REVERSED",
            (*path, "window"),
            put(raw, path, {**bare, "window": [span[1] + 1, span[0]]}),
            "TIME_ORDER",
        )
        m.add(
            "TIME_RANGE", path, put(raw, path, {**bare, "timestamp": -1.0}), "TIME_ORDER",
            note="negative",
        )  # fmt: skip
        m.add("TIME_RANGE", path, put(raw, path, {**bare, "window": [span[0], 1e4]}), "TIME_ORDER")
        m.add("ID_DUPLICATE", EVENTS, append(raw, EVENTS, item), note=item["id"])
        m.add(
            "TIMELINE_CYCLE",
            SEGMENTS,
            append(raw, SEGMENTS, edge("loop", item["id"], item["id"], "Toward", _active(raw))),
            "EDGE_ACTOR_ABSENT",
            note=item["id"],
        )
        m.set(
            "SCHEMA_VALUE",
            (*path, "constraints"),
            [{"quantity": "weight", "object": item["participants"][0], "value": 1.0}],
        )
    for i, item in enumerate(get(raw, SEGMENTS)):
        ends = {e["id"]: k for k, e in enumerate(events)}
        a, b = ends[item["from"]], ends[item["to"]]
        if a:
            early = {k: v for k, v in events[b].items() if k not in ("window", "timestamp")}
            first = events[a].get("window") or [events[a]["timestamp"]] * 2
            m.add(
                "TIME_ORDER",
                (*EVENTS, b),
                put(raw, (*EVENTS, b), {**early, "window": [first[1] - 0.2, first[1] + 30]}),
                note=f"overlap{i}",
            )
            m.made[-1] = Corruption(
                m.made[-1].name, m.made[-1].raw, "TIME_ORDER", where((*EVENTS,)),
            )  # fmt: skip
            back = edge("back", item["to"], item["from"], "Toward", item["actor"])
            m.add(
                "TIMELINE_CYCLE",
                SEGMENTS,
                append(raw, SEGMENTS, back),
                "EDGE_ACTOR_PASSIVE",
                "EDGE_ACTOR_ABSENT",
                "CONSTRAINT_SINCE",
                note=f"back{i}",
            )
        m.add("ID_DUPLICATE", SEGMENTS, append(raw, SEGMENTS, item), note=item["id"])


def _active(raw: Json) -> str:
    return next(n for n, a in get(raw, ACTORS).items() if a["role"] == "active")


def roles(m: Maker) -> None:
    raw = m.raw
    if "timeline_system" not in raw:
        return
    m.add("ACTOR_IMMOVABLE", (*ACTORS, "ground_1"), put(raw, (*ACTORS, "ground_1"), PASSIVE))
    for name, actor in get(raw, ACTORS).items():
        path = (*ACTORS, name)
        if actor["role"] == "passive":
            m.set("ACTOR_FORCE_FORBIDDEN", (*path, "force_direction"), "ANY_3D")
            idle = put(raw, path, {"role": "active", "force_direction": "ANY_3D"})
            moves = [e for e in get(raw, SEGMENTS) if e["actor"] == name]
            m.add("CONNECTOR_ACTIVE" if moves else "ACTOR_IDLE", path, idle, at=())
            m.add(
                "TRIGGER_PASSIVE",
                EVENTS,
                append(
                    append(raw, EVENTS, event("push", "Trigger", [name], window=[20, 21])),
                    SEGMENTS,
                    edge("to_push", "scene_start", "push", "Toward", _active(raw)),
                ),
                "EDGE_ACTOR_ABSENT",
                note=name,
            )
            m.add(
                "EDGE_ACTOR_PASSIVE",
                SEGMENTS,
                append(
                    raw,
                    SEGMENTS,
                    edge("drive_passive", "scene_start", _event_of(raw, name), "Brake", name),
                ),
                "TIME_ORDER",
                note=name,
            )
            m.add(
                "CONNECTOR_UPSTREAM",
                SEGMENTS,
                append(
                    raw,
                    SEGMENTS,
                    edge("drift", "scene_start", _event_of(raw, name), "InertialConnector", name),
                ),
                note=name,
            )
            continue
        m.add("ACTOR_FORCE_MISSING", path, put(raw, path, {"role": "active"}))
        m.add("EDGE_ACTOR_PASSIVE", SEGMENTS, put(raw, path, PASSIVE), "TRIGGER_PASSIVE", note=name)
        m.add("ACTOR_IMMOVABLE", path, put(raw, (*NODES, name, "is_static"), True))
        still = [e for e in get(raw, SEGMENTS) if e["actor"] != name]
        m.add(
            "ACTOR_IDLE",
            path,
            put(raw, SEGMENTS, still),
            "EVENT_MOVER",
            "TIMELINE_UNREACHABLE",
            "CONNECTOR_UPSTREAM",
        )


def _event_of(raw: Json, name: str) -> str:
    return next(e["id"] for e in get(raw, EVENTS)[1:] if name in e["participants"])


def events(m: Maker) -> None:
    raw = m.raw
    if "timeline_system" not in raw:
        return
    absent = (
        "EDGE_ACTOR_ABSENT",
        "CONNECTOR_DOWNSTREAM",
        "CONNECTOR_UPSTREAM",
        "CONSTRAINT_OBJECT",
        "EVENT_NO_ACTOR",
    )
    for i, item in enumerate(get(raw, EVENTS)[1:], 1):
        path = (*EVENTS, i)
        people, kind = item["participants"], item["event"]
        m.set("EVENT_PARTICIPANTS", (*path, "participants"), [], *absent)
        m.set("EVENT_PARTICIPANTS", (*path, "participants"), [people[0]] * 2, *absent, note="twice")
        leads = {e["actor"] for e in get(raw, SEGMENTS) if e["to"] == item["id"]}
        if kind == "Collision" and people[1] not in leads:
            m.add("EVENT_MOVER", path, put(raw, (*path, "participants"), people[::-1]))
        others = _bystanders(raw, len(people))
        if len(others) == len(people):
            m.set("EVENT_NO_ACTOR", (*path, "participants"), others, *absent)
        if kind != "PositionAt":
            m.set("EVENT_FIELD_FORBIDDEN", (*path, "position_cm"), [0.0, 0.0, 0.0])
        else:
            m.add("EVENT_FIELD_MISSING", path, without(raw, (*path, "position_cm")))
            m.set("EVENT_RANGE", (*path, "position_cm"), [1e6, 0.0, 0.0])
        if kind != "EnterRegion":
            m.set("EVENT_FIELD_FORBIDDEN", (*path, "region"), "ground_1/area")
        else:
            m.add("EVENT_FIELD_MISSING", path, without(raw, (*path, "region")))
        if kind == "HeadingReached":
            m.add(
                "EVENT_FIELD_MISSING", path, without(raw, (*path, "turn_degrees")), note="degrees"
            )
            m.add("EVENT_FIELD_MISSING", path, without(raw, (*path, "turn_direction")), note="side")
            m.set("EVENT_RANGE", (*path, "turn_degrees"), -90.0, "CONSTRAINT_CONTRADICTION")
        elif kind == "Spin":
            m.set("EVENT_RANGE", (*path, "turn_degrees"), 1e5)
        else:
            m.set("EVENT_FIELD_FORBIDDEN", (*path, "turn_degrees"), 90.0)
        if kind in ("Bounce", "Jump"):
            m.set("EVENT_RANGE", (*path, "times"), 0)
        else:
            m.set("EVENT_FIELD_FORBIDDEN", (*path, "times"), 2)
        if kind in ("PickedUp", "Placed", "Jump"):
            led = [e for e in get(raw, SEGMENTS) if e["to"] != item["id"]]
            back = edge("led", "scene_start", item["id"], "UniformMotion", people[0])
            m.add(
                "EVENT_NOT_LED_TO", path, put(raw, SEGMENTS, [*led, back]), "TIMELINE_UNREACHABLE"
            )
        constraint = {"quantity": "speed_after", "object": people[0], "value": 100.0}
        more = [*item.get("constraints", []), constraint]
        last = (*path, "constraints", len(more) - 1)
        base = put(raw, (*path, "constraints"), more)
        m.add("CONSTRAINT_RANGE", last, put(base, (*last, "value"), -5.0))
        m.add("CONSTRAINT_RANGE", last, put(base, (*last, "value"), 3e10), note="light")
        m.add("INTERVAL_REVERSED", last, put(base, (*last, "value"), [3.0, 2.0]))
        m.add("CONSTRAINT_OBJECT", last, put(base, (*last, "object"), _bystanders(raw, 1)[0]))
        gap = {"quantity": "distance", "object": people[0], "value": 100.0}
        m.add("REF_CONSTRAINT", last, put(base, last, {**gap, "to": "nowhere"}), note="gap")
        m.add("CONSTRAINT_OBJECT", last, put(base, last, {**gap, "to": people[0]}), note="gap")
        timed = {"quantity": "time_since", "object": people[0], "value": 1.0}
        m.add("CONSTRAINT_SINCE", last, put(base, last, timed))
        m.add("CONSTRAINT_SINCE", last, put(base, last, {**timed, "since": item["id"]}), note="own")
        far = {**timed, "value": [590.0, 600.0], "since": "scene_start"}
        m.add("CONSTRAINT_CONTRADICTION", last, put(base, last, far), note="window")
        twice = put(raw, (*path, "constraints"), [constraint, {**constraint, "value": 400.0}])
        m.add("CONSTRAINT_CONTRADICTION", path, twice)


def _bystanders(raw: Json, count: int) -> list[str]:
    """Nodes that are no actors (the ground is one) and take part in nothing."""
    busy = {p for e in get(raw, EVENTS) for p in e.get("participants", [])}
    free = [n for n in get(raw, NODES) if n not in get(raw, ACTORS) and n not in busy]
    spare = [n for n in get(raw, NODES) if n not in get(raw, ACTORS) and n in busy]
    return [*free, *spare][:count]


def segments(m: Maker) -> None:
    raw = m.raw
    if "timeline_system" not in raw:
        return
    for i, item in enumerate(get(raw, SEGMENTS)):
        path = (*SEGMENTS, i, "params")
        params = item.get("params", {})
        if item["event"] == "InertialConnector":
            m.add("EDGE_PARAM_FORBIDDEN", path, put(raw, path, {"speed": 100.0}))
            m.set("EDGE_ACTOR_PASSIVE", (*SEGMENTS, i, "event"), "UniformMotion")
            m.add(
                "CONNECTOR_DOWNSTREAM",
                SEGMENTS,
                append(raw, SEGMENTS, {**item, "id": "astray", "to": _without_actor(raw, item)}),
                "TIME_ORDER",
                "TIMELINE_CYCLE",
                note=str(i),
            )
            continue
        m.add(
            "EDGE_ACTOR_ABSENT",
            SEGMENTS,
            append(
                append(raw, EVENTS, event("alone", "Topple", [_other(raw, item)], window=[50, 51])),
                SEGMENTS,
                {**item, "id": "astray", "to": "alone"},
            ),
            "EVENT_NO_ACTOR",
            "EDGE_PARAM_MISSING",
            "GUIDE_END",
            note=str(i),
        )
        m.set(
            "CONNECTOR_ACTIVE",
            (*SEGMENTS, i, "event"),
            "InertialConnector",
            "EDGE_PARAM_FORBIDDEN",
            "CONNECTOR_DOWNSTREAM",
            "EVENT_NOT_LED_TO",
        )
        for name, value, code in (
            ("speed", -5.0, "UNIT_SPEED"),
            ("speed", 3e10, "UNIT_SPEED"),
            ("speed", [900.0, 300.0], "INTERVAL_REVERSED"),
            ("speed", [3.0, 15.0], "UNIT_SPEED"),
            ("acceleration", 1e6, "EDGE_PARAM_RANGE"),
            ("heading_deg", 1e4, "EDGE_PARAM_RANGE"),
            ("duration", -1.0, "EDGE_PARAM_RANGE"),
            ("duration", [2.0, 1.0], "INTERVAL_REVERSED"),
        ):
            m.add(code, (*path, name), put(raw, path, {**params, name: value}), note=str(value))
        if item["event"] == "Guide":
            m.add("EDGE_PARAM_RANGE", path, put(raw, path, {**params, "lift_cm": -5.0}))
            stopped = put(raw, (*SEGMENTS, i, "to"), "halted")
            halt = event("halted", "Stop", [item["actor"]], window=[50, 51])
            m.add(
                "GUIDE_END",
                (*SEGMENTS, i),
                append(stopped, EVENTS, halt),
                "EVENT_NOT_LED_TO",
                "TIMELINE_UNREACHABLE",
            )
        else:
            m.add("EDGE_PARAM_FORBIDDEN", path, put(raw, path, {**params, "release": True}))
        if item["event"] == "Brake":
            m.add("EDGE_PARAM_RANGE", path, put(raw, path, {"damping": -1.0}))
        else:
            m.add("EDGE_PARAM_FORBIDDEN", path, put(raw, path, {**params, "damping": 1.0}))
        if item["event"] == "Turn":
            m.add(
                "CONSTRAINT_CONTRADICTION",
                path,
                put(raw, (*path, "turn_direction"), "right"),
            )
            m.add("CONSTRAINT_CONTRADICTION", path, put(raw, (*path, "turn_degrees"), 45.0))
        else:
            m.add("EDGE_PARAM_FORBIDDEN", path, put(raw, path, {**params, "turn_degrees": 9.0}))
            to_turn = put(raw, (*SEGMENTS, i, "event"), "Turn")
            m.add(
                "EDGE_PARAM_MISSING",
                path,
                to_turn,
                "EDGE_PARAM_FORBIDDEN",
                "EVENT_NOT_LED_TO",
                note="turn",
            )
        if item["event"] == "Toward":
            flat = put(raw, path, {**params, "elevation_deg": [10, 40]})
            flat = put(flat, (*ACTORS, item["actor"], "force_direction"), "HORIZONTAL_PLANE")
            m.add("EDGE_FORCE_DIRECTION", SEGMENTS, flat, note=str(i))
            m.add("EDGE_PARAM_RANGE", path, put(raw, path, {**params, "elevation_deg": 120.0}),
                  "EDGE_FORCE_DIRECTION")  # fmt: skip


def _without_actor(raw: Json, item: Json) -> str:
    return next(
        (e["id"] for e in get(raw, EVENTS)[1:] if item["actor"] not in e["participants"]),
        "scene_start",
    )


def _other(raw: Json, item: Json) -> str:
    return next(n for n in get(raw, ACTORS) if n != item["actor"])


def stages(m: Maker) -> None:
    raw = m.raw
    if m.base != "finished":
        layout = {"poses": {n: {"position_cm": [0, 0, 0]} for n in get(raw, NODES)}, "energy": 0.0}
        m.add("STAGE_ORDER", ("layout_result",), put(raw, ("layout_result",), layout))
        dynamics = {"strategy": "none", "duration_s": 1.0, "outcome": "solved"}
        m.add("STAGE_ORDER", ("dynamics_result",), put(raw, ("dynamics_result",), dynamics))
        return
    for name in raw["asset_configurations"]:
        path = ("asset_configurations", name)
        m.add("CONFIG_MISSING", path, without(raw, path))
        m.set("UNIT_MASS", (*path, "mass_kg"), -1.0, "CONFIG_MASS")
        m.set("UNIT_SIZE", (*path, "dimensions_cm"), [0.0, 10.0, 10.0])
        m.set("UNIT_DAMPING", (*path, "angular_damping"), -1.0)
        m.set("CONFIG_MATERIAL", (*path, "friction"), -0.1)
        m.set("CONFIG_MATERIAL", (*path, "restitution"), 1.3)
        m.set("CONFIG_GEOMETRY", (*path, "scale"), [1.0, 0.0, 1.0])
        m.set("CONFIG_GEOMETRY", (*path, "proxies", 0, "size_cm"), [1.0, -1.0, 1.0])
        m.set("CONFIG_GEOMETRY", (*path, "regions", 0, "half_extents_cm"), [1.0, 1.0, 0.0])
        m.set("CONFIG_PATH", (*path, "mesh_path"), "../../etc/passwd")
        m.set("CONFIG_PATH", (*path, "mesh_path"), "/tmp/x.glb", note="absolute")
        m.set("CONFIG_PATH", (*path, "mesh_path"), "C:\\x.glb", note="drive")
        m.set("QUATERNION", (*path, "proxies", 0, "orientation_xyzw"), [0.0, 0.0, 0.0, 2.0])
        m.set("QUATERNION", (*path, "proxies", 0, "orientation_xyzw"), [0.0] * 4, note="zero")
        if raw["asset_configurations"][name]["is_movable"]:
            m.set("CONFIG_NO_PROXY", (*path, "proxies"), [])
    m.set("CONFIG_MASS", ("asset_configurations", "bin", "mass_kg"), 30.0)
    m.set("CONFIG_UNKNOWN", ("asset_configurations", "extra"), raw["asset_configurations"]["bin"])
    poses = ("layout_result", "poses")
    for name in get(raw, poses):
        m.add("POSE_MISSING", (*poses, name), without(raw, (*poses, name)))
        m.set("POSE_RANGE", (*poses, name, "position_cm"), [1e5, 0.0, 0.0])
    m.set("POSE_UNKNOWN", (*poses, "ghost"), {"position_cm": [0, 0, 0]})
    result = ("dynamics_result",)
    m.set("POSE_UNKNOWN", (*result, "start_poses"), {"ghost": {"position_cm": [0, 0, 0]}})
    m.set("OUTCOME_UNKNOWN", (*result, "outcome"), "fine")
    m.set("PARAMETER_RANGE", (*result, "parameters", 0, "value"), 9e3)
    m.set("INTERVAL_REVERSED", (*result, "parameters", 0, "lower"), 9e3)
    m.made[-1] = Corruption(
        m.made[-1].name, m.made[-1].raw, "INTERVAL_REVERSED", where((*result, "parameters", 0))
    )
    first = (*result, "program", "primitives", 0)
    for path, value, code in (
        ((*first, "body"), "ghost", "PROGRAM_BODY"),
        ((*first, "until_contact"), ["ghost"], "PROGRAM_BODY"),
        ((*first, "kind"), "Teleport", "PROGRAM_INVALID"),
        ((*first, "body"), 3, "PROGRAM_INVALID"),
        ((*first, "until_contact"), None, "PROGRAM_INVALID"),
        ((*first, "speed"), "fast", "PROGRAM_INVALID"),
        ((*first, "colour"), "red", "PROGRAM_INVALID"),
        ((*result, "program", "version"), 7, "PROGRAM_INVALID"),
    ):
        m.add(code, path, put(raw, path, value), at=(*result, "program"))
    item = ("coverage", "items", 0)
    m.add("COVERAGE_SPAN", item, put(raw, (*item, "end"), 4000))
    m.add("COVERAGE_SPAN", item, put(raw, (*item, "start"), -1), note="negative")
    m.set("COVERAGE_POINTER", (*item, "pointer"), "/spatial_relation_graph/nodes/ghost")
    m.set("COVERAGE_POINTER", (*item, "pointer"), "car_1", note="form")
    region = event(
        "in", "EnterRegion", ["trashbin_1"], window=[5, 6], region="picnic_table_1/pocket"
    )
    entering = append(
        append(raw, EVENTS, region),
        SEGMENTS,
        edge("in_slide", "bin_hits_table", "in", "InertialConnector", "trashbin_1"),
    )
    m.add("REF_NAMED_REGION", (*EVENTS, 3, "region"), entering)


def statements(m: Maker) -> None:
    """Statements of what is not there, said twice, or without what they are measured by."""
    if m.base != "finished":
        return
    car = {"text": "The car", "start": 0, "end": 7, "object": ["car_1"]}
    bin_ = {"target": ["trashbin_1"]}
    told: list[Json] = [
        {"id": "s1", "predicate": "moves", "direction": "left", "when": "start", **car},
        {"id": "s2", "predicate": "ends_near", **car, **bin_},
    ]
    stated = {**m.raw, "statements": told}
    first, second = ("statements", 0), ("statements", 1)
    m.add("STATEMENT_TWICE", (*second, "id"), put(stated, (*second, "id"), "s1"))
    m.add("STATEMENT_UNKNOWN", (*first, "object"), put(stated, (*first, "object"), ["ghost"]))
    m.add("STATEMENT_UNKNOWN", (*second, "target"), put(stated, (*second, "target"), ["ghost"]))
    m.add("STATEMENT_UNKNOWN", (*first, "when"), put(stated, (*first, "when"), "start..ghost"))
    for part, missing in ((first, "object"), (first, "direction"), (second, "target")):
        m.add("STATEMENT_INCOMPLETE", (*part, missing), without(stated, (*part, missing)))
    towards = put(stated, (*first, "direction"), "toward")
    m.add("STATEMENT_INCOMPLETE", (*first, "target"), towards)
    for says, needs in (
        ("absent", "noun"), ("count", "value"), ("faster_than", "value"), ("not_represented", "note"),
        ("filmed", "filming"),
    ):  # fmt: skip
        changed = put(stated, (*second, "predicate"), says)
        also = ("STATEMENT_INCOMPLETE",)
        m.add("STATEMENT_INCOMPLETE", (*second, needs), changed, *also)
    one = put(stated, (*second, "predicate"), "same_time")
    m.add("STATEMENT_INCOMPLETE", (*second, "object"), one, "STATEMENT_UNKNOWN")


def casting(m: Maker) -> None:
    """Choices and a choreography that name what is not there, or choose what cannot be."""
    if m.base != "finished":
        return
    configuration = m.raw["asset_configurations"]["bin"]
    choices: Json = {
        "assets": {"bin": {"configuration": configuration, "reasons": ["mass_kg: lighter"]}},
        "nodes": {"trashbin_1": {"is_static": False}},
        "actors": {"car_1": {"force_direction": "ANY_3D"}},
        "segments": {"car_drive": {"params": {"speed": [300, 1500]}}},
    }
    told: Json = {
        "constellations": [
            {
                "placements": [{"node": "car_1", "x_cm": -500.0, "y_cm": 0.0}],
                "corridors": [
                    {
                        "points_cm": [[0, 0], [1, 1]],
                        "half_width_cm": 90,
                        "participants": ["trashbin_1"],
                    }
                ],
                "anchor": "picnic_table_1",
            }
        ],
        "nominal": {"car_drive/speed": 8.0},
    }
    cast = {**m.raw, "casting": choices, "choreography": told}
    for part, chosen in choices.items():
        path = ("casting", part, "ghost")
        m.add("CASTING_UNKNOWN", path, put(cast, path, next(iter(chosen.values()))))
    for path in (
        ("placements", 0, "node"),
        ("corridors", 0, "participants", 0),
        ("anchor",),
    ):
        for name in ("ghost", "group:ghosts"):
            here = ("choreography", "constellations", 0, *path)
            m.add("CASTING_UNKNOWN", here, put(cast, here, name), note=name)
    chosen = ("casting", "assets", "bin", "configuration")
    m.add("CONFIG_MATERIAL", chosen, put(cast, (*chosen, "friction"), -0.1))
    m.add("UNIT_MASS", chosen, put(cast, (*chosen, "mass_kg"), -1.0), "CONFIG_MASS")
    m.add("CONFIG_MASS", chosen, put(cast, (*chosen, "mass_kg"), 30.0))
    m.add("CONFIG_PATH", chosen, put(cast, (*chosen, "mesh_path"), "../x.glb"))
    segment = ("casting", "segments", "car_drive")
    m.add("UNIT_SPEED", segment, put(cast, (*segment, "params", "speed"), [1.0, 9e5]))
    still = without(
        without(without(cast, ("timeline_system",)), ("dynamics_result",)), ("casting",)
    )
    m.add("STAGE_ORDER", ("choreography",), still, "TIMELINE_MISSING")


def dressing(m: Maker) -> None:
    """Places that are not there, nobody wants, or that stand in the way."""
    around: Json = {
        "place": "park",
        "sky": "clear",
        "sun_azimuth_deg": 30.0,
        "sun_elevation_deg": 50.0,
        "ground": "grass",
        "markings": [{"surface": "gravel", "center_cm": [0, 900], "half_cm": [4000, 90]}],
        "items": [
            {"id": "bench_1", "kind": "bench", "position_cm": [0, 1500, 0], "size_cm": [60, 160, 80]},
            {"id": "tree_1", "kind": "broadleaf", "position_cm": [0, -900, 0],
             "size_cm": [500, 500, 700], "surface": "leaves"},
        ],
    }  # fmt: skip
    dressed = {**m.raw, "dressing": around}
    here = ("dressing",)
    if m.base != "finished":
        m.add("STAGE_ORDER", here, dressed)
        return
    for path in (("place",), ("sky",), ("ground",), ("markings", 0, "surface"),
                 ("items", 0, "kind"), ("items", 1, "surface")):  # fmt: skip
        m.add("DRESSING_UNKNOWN", (*here, *path), put(dressed, (*here, *path), "ghost"))
    m.add("DRESSING_TWICE", (*here, "items"), put(dressed, (*here, "items", 1, "id"), "bench_1"))
    for path, value in (
        (("items", 0, "size_cm"), [60, 160, 1e6]),
        (("items", 0, "position_cm"), [0, 9e5, 0]),
        (("markings", 0, "half_cm"), [0, 90]),
    ):
        there = (*here, *path[:2])
        m.add("DRESSING_RANGE", there, put(dressed, (*here, *path), value), note=path[2])
    near = (*here, "items", 1)
    m.add("DRESSING_NEAR", near, put(dressed, (*near, "position_cm"), [100, -430, 0]))
    only = put(dressed, ("scene_definition", "scene_parameters", "allow_supplementary"), False)
    m.add("DRESSING_UNASKED", here, only)


def joints(m: Maker) -> None:
    """Joints of what is not there, that cannot move anything, or that say too much or too little."""
    if m.base != "finished":
        return
    jointed = m.raw
    for key in ("bin", "table"):
        mounts = [{"name": "pivot", "position_cm": [0, 0, 10], "axis": [0, 1, 0]}]
        jointed = put(jointed, ("asset_configurations", key, "mounts"), mounts)
    hinge = {
        "id": "hinge", "kind": "hinge", "child": "trashbin_1", "child_mount": "pivot",
        "parent": "picnic_table_1", "parent_mount": "pivot", "lower": -90, "upper": 90,
        "position": 30, "damping": 0.1, "motor": {"speed": 20, "limit": 5},
    }  # fmt: skip
    path = (*GRAPH, "joints")
    here = (*path, 0)

    def told(code: str, *also: str, at: str, note: str = "", **change: Any) -> None:
        broken = {k: v for k, v in {**hinge, **change}.items() if v is not None}
        m.add(code, (*here, at), put(jointed, path, [broken]), *also, note=note or at)

    m.add("JOINT_TWICE", (*path, 1, "id"), put(jointed, path, [hinge, hinge]))
    told("JOINT_UNKNOWN", at="child", child="ghost")
    told("JOINT_UNKNOWN", at="parent", parent="ghost")
    told("JOINT_CHILD", at="child", note="itself", child="picnic_table_1")
    told(
        "JOINT_CHILD",
        "JOINT_MOUNT",
        at="child",
        note="fixed",
        child="ground_1",
        child_mount="pivot",
    )
    told("JOINT_MOUNT", at="child_mount", child_mount="ghost")
    told("JOINT_MOUNT", at="parent_mount", parent_mount="ghost")
    told("JOINT_FIELD", at="parent", parent=None)
    plain = {"lower": None, "position": 0, "motor": None}
    told("JOINT_FIELD", at="lower", kind="rope", **{**plain, "lower": 1})
    told("JOINT_FIELD", at="motor", kind="rope", **{**plain, "motor": {"speed": 1}})
    told("JOINT_FIELD", at="upper", kind="rope", **plain, upper=None)
    told("JOINT_FIELD", at="parent_mount", kind="rope", **plain, parent_mount=None)
    told("JOINT_FIELD", at="stiffness", kind="spring", **plain)
    told("JOINT_VALUE", at="upper", kind="rope", **plain, upper=-1)
    told("JOINT_VALUE", at="damping", damping=-1)
    told("JOINT_VALUE", at="break_impulse", break_impulse=-1)
    told("JOINT_VALUE", at="motor", motor={"limit": -1})
    told("JOINT_POSITION", at="position", position=91)
    told("INTERVAL_REVERSED", at="lower", lower=91)
    _moved_by_joints(m)
    back = {**hinge, "id": "back", "child": "picnic_table_1", "parent": "trashbin_1"}
    m.add("JOINT_CIRCLE", path, put(jointed, path, [hinge, back]))


def breaking(m: Maker) -> None:
    """What breaks at no blow, into no pieces, or though something holds it; breaks of other things."""
    if m.base != "finished":
        return
    here = (*GRAPH, "nodes", "trashbin_1", "breaking")
    for field, value, code in (
        ("speed", 0, "BREAK_SPEED"),
        ("speed", -240, "BREAK_SPEED"),
        ("speed", 1e6, "BREAK_SPEED"),
        ("pieces", 1, "BREAK_PIECES"),
        ("pieces", 500, "BREAK_PIECES"),
    ):
        told = {"speed": 240, "pieces": 12, field: value}
        m.add(code, (*here, field), put(m.raw, here, told), note=f"{field} {value}")
    ground = (*GRAPH, "nodes", "ground_1", "breaking")
    m.add("BREAK_HELD", ground, put(m.raw, ground, {"speed": 240, "pieces": 12}))
    last = len(get(m.raw, EVENTS))
    breaks = event("breaks", "Break", ["trashbin_1"], window=[5.0, 9.0])
    led = [e for e in get(m.raw, SEGMENTS) if e["actor"] == "trashbin_1"]
    joined = edge("joined", led[-1]["to"], "breaks", "InertialConnector", "trashbin_1")
    raw = put(m.raw, EVENTS, [*get(m.raw, EVENTS), breaks])
    raw = put(raw, SEGMENTS, [*get(m.raw, SEGMENTS), joined])
    m.add("EVENT_UNBROKEN", (*EVENTS, last, "participants", 0), raw, "CONNECTOR_UPSTREAM")


def _moved_by_joints(m: Maker) -> None:
    """Events and segments of joints that nothing has."""
    last = len(get(m.raw, EVENTS))
    opens = event("opens", "Open", ["trashbin_1"], window=[5.0, 9.0])
    led = [e for e in get(m.raw, SEGMENTS) if e["actor"] == "trashbin_1"]
    joined = edge("joined", led[-1]["to"], "opens", "InertialConnector", "trashbin_1")
    raw = put(m.raw, EVENTS, [*get(m.raw, EVENTS), opens])
    raw = put(raw, SEGMENTS, [*get(m.raw, SEGMENTS), joined])
    m.add("EVENT_NO_JOINT", (*EVENTS, last, "participants", 0), raw, "CONNECTOR_UPSTREAM")
    for kind in ("Drive", "Release"):
        k = next(i for i, e in enumerate(get(m.raw, SEGMENTS)) if e["event"] == "UniformMotion")
        changed = put(put(m.raw, (*SEGMENTS, k, "event"), kind), (*SEGMENTS, k, "params"), {})
        m.add("EDGE_NO_JOINT", (*SEGMENTS, k, "actor"), changed, note=kind)


GENERATORS: tuple[Callable[[Maker], None], ...] = (
    schema,
    references,
    scene,
    units,
    relations,
    timeline,
    roles,
    events,
    segments,
    stages,
    statements,
    casting,
    joints,
    breaking,
    dressing,
)


def corruptions() -> Iterator[Corruption]:
    """All corruptions of all valid documents."""
    for base in VALID:
        maker = Maker(base)
        for generate in GENERATORS:
            generate(maker)
        yield from maker.made
