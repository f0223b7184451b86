"""Valid ESG documents of many kinds, as plain JSON: the corpus that the verifier must accept."""

from __future__ import annotations

import copy
from typing import Any

Json = dict[str, Any]


def asset(category: str, size: tuple[float, float, float], mass: float, **more: Any) -> Json:
    return {
        "asset_category": category,
        "asset_description": f"a {category}",
        "expected_dimensions_cm": list(size),
        "expected_mass_kg": mass,
        **more,
    }


GROUND = asset("ground", (4000, 4000, 10), 1000, is_movable=False)
CAR = asset("car", (450, 180, 150), 1400)
BIN = asset("trashbin", (60, 60, 90), 12, shape="cylinder")
TABLE = asset("picnic_table", (180, 150, 75), 40)
BALL = asset("ball", (22, 22, 22), 0.45, shape="sphere")
BOTTLE = asset("bottle", (8, 8, 28), 0.6)
BOX = asset("box", (60, 60, 60), 8)


def rel(a: str, kind: str, b: str, **more: Any) -> Json:
    return {"from": a, "to": b, "relation_type": kind, **more}


def region(parent: str, kind: str = "SUPPORT_SURFACE") -> Json:
    return {"region_description": f"{parent}", "region_type": kind, "parent_object": parent}


def node(asset_id: str, where: str | None = "ground_area", **more: Any) -> Json:
    return {"asset_id": asset_id, "semantic_region": where, **more}


def event(name: str, kind: str, participants: list[str], **more: Any) -> Json:
    return {"id": name, "event": kind, "participants": participants, **more}


START = {"id": "scene_start", "event": "SceneStart", "timestamp": 0.0}


def edge(name: str, a: str, b: str, kind: str, actor: str, **more: Any) -> Json:
    return {"id": name, "from": a, "to": b, "event": kind, "actor": actor, **more}


def document(
    scene_id: str,
    prompt: str,
    assets: Json,
    nodes: Json,
    relations: list[Json] | None = None,
    timeline: Json | None = None,
    regions: Json | None = None,
    multi: list[Json] | None = None,
    scene_type: str = "outdoor",
) -> Json:
    out: Json = {
        "schema_version": "1.0.0",
        "scene_definition": {
            "scene_id": scene_id,
            "original_description": prompt,
            "scene_parameters": {"is_dynamic": timeline is not None, "scene_type": scene_type},
        },
        "asset_requirement": {"ground": GROUND, **assets},
        "spatial_relation_graph": {
            "semantic_regions": {"ground_area": region("ground_1"), **(regions or {})},
            "nodes": {
                "ground_1": {"asset_id": "ground", "is_structural": True, "mentioned": False},
                **nodes,
            },
            "edges": {"binary_relations": relations or [], "multi_relations": multi or []},
        },
    }
    if timeline is not None:
        out["timeline_system"] = timeline
    return copy.deepcopy(out)


def active(direction: str = "HORIZONTAL_PLANE") -> Json:
    return {"role": "active", "force_direction": direction}


PASSIVE: Json = {"role": "passive"}


def timeline(actors: Json, nodes: list[Json], edges: list[Json]) -> Json:
    return {"actors": actors, "sequence_graph": {"nodes": [START, *nodes], "edges": edges}}


def chain() -> Json:
    """A car hits a bin, which hits a table."""
    return document(
        "chain",
        "A car collides with a trashbin, knocking it into a picnic table.",
        {"sedan": CAR, "bin": BIN, "table": TABLE},
        {"car_1": node("sedan"), "trashbin_1": node("bin"), "picnic_table_1": node("table")},
        [
            rel("car_1", "face", "trashbin_1"),
            rel("trashbin_1", "near", "picnic_table_1", confidence=0.7),
            rel("picnic_table_1", "face", "ground_1", cardinal="+Y"),
            rel("car_1", "left_of", "trashbin_1"),
            rel("trashbin_1", "left_of", "picnic_table_1"),
        ],
        timeline(
            {
                "car_1": active("ALONG_FORWARD_OR_BACKWARD"),
                "trashbin_1": PASSIVE,
                "picnic_table_1": PASSIVE,
            },
            [
                event("car_hits_bin", "Collision", ["car_1", "trashbin_1"], window=[0.8, 2.0]),
                event(
                    "bin_hits_table",
                    "Collision",
                    ["trashbin_1", "picnic_table_1"],
                    window=[2.1, 4.0],
                    constraints=[
                        {
                            "quantity": "time_since",
                            "object": "trashbin_1",
                            "value": [0.1, 2.0],
                            "since": "car_hits_bin",
                        },
                        {"quantity": "speed_after", "object": "picnic_table_1", "value": 50.0},
                    ],
                ),
            ],
            [
                edge(
                    "car_drive",
                    "scene_start",
                    "car_hits_bin",
                    "UniformMotion",
                    "car_1",
                    target="trashbin_1",
                    params={"speed": [300, 1500]},
                ),
                edge(
                    "bin_slide",
                    "car_hits_bin",
                    "bin_hits_table",
                    "InertialConnector",
                    "trashbin_1",
                    target="picnic_table_1",
                ),
            ],
        ),
    )


def braking() -> Json:
    """Two cars, one behind the other; the front one brakes; two branches meet."""
    return document(
        "braking",
        "Two cars move at the same speed, the front car brakes and they collide after 1 second.",
        {"sedan": CAR},
        {"car_1": node("sedan", label="front car"), "car_2": node("sedan", label="rear car")},
        [
            rel("car_1", "in_front_of", "car_2", distance_cm=[500, 1500]),
            rel("car_1", "face", "ground_1", cardinal="+Y"),
            rel("car_2", "face", "car_1"),
        ],
        timeline(
            {"car_1": active("ALONG_FORWARD_ONLY"), "car_2": active("ALONG_FORWARD_ONLY")},
            [
                event("front_brakes", "Trigger", ["car_1"], window=[0.5, 1.5]),
                event("crash", "Collision", ["car_2", "car_1"], window=[1.5, 3.5]),
            ],
            [
                edge(
                    "front_drive",
                    "scene_start",
                    "front_brakes",
                    "UniformMotion",
                    "car_1",
                    params={"speed": [500, 1000]},
                ),
                edge(
                    "front_brake",
                    "front_brakes",
                    "crash",
                    "Brake",
                    "car_1",
                    params={"damping": [0.5, 8]},
                ),
                edge(
                    "rear_drive",
                    "scene_start",
                    "crash",
                    "UniformMotion",
                    "car_2",
                    target="car_1",
                    params={"speed": [500, 1000]},
                ),
            ],
        ),
    )


def turning() -> Json:
    """A car turns left, brakes and hits a bicycle; two more cars accelerate and stop."""
    return document(
        "turning",
        "A car turns left at a cross, brakes and hits a bicycle.",
        {"sedan": CAR, "bicycle": asset("bicycle", (175, 50, 105), 14)},
        {"car_1": node("sedan"), "bicycle_1": node("bicycle"), "car_2": node("sedan")},
        [
            rel("car_1", "face", "ground_1", cardinal="-Y"),
            rel("bicycle_1", "face", "car_1"),
            rel("car_2", "face", "ground_1", cardinal="+X"),
            rel("car_2", "far_from", "car_1"),
        ],
        timeline(
            {"car_1": active("ALONG_FORWARD_ONLY"), "bicycle_1": PASSIVE, "car_2": active()},
            [
                event(
                    "turned",
                    "HeadingReached",
                    ["car_1"],
                    window=[1.0, 3.0],
                    turn_direction="left",
                    turn_degrees=90.0,
                ),
                event("brakes", "Trigger", ["car_1"], window=[3.1, 4.0]),
                event("crash", "Collision", ["car_1", "bicycle_1"], window=[4.1, 7.0]),
                event("go", "Trigger", ["car_2"], window=[0.5, 1.0]),
                event(
                    "arrive",
                    "PositionAt",
                    ["car_2"],
                    window=[1.5, 5.0],
                    position_cm=[500.0, 0.0, 75.0],
                ),
                event("halt", "Stop", ["car_2"], window=[5.5, 9.0]),
            ],
            [
                edge(
                    "turn",
                    "scene_start",
                    "turned",
                    "Turn",
                    "car_1",
                    params={
                        "speed": [300, 900],
                        "turn_direction": "left",
                        "turn_degrees": 90.0,
                        "turn_rate_deg_s": [20, 90],
                    },
                ),
                edge("go_on", "turned", "brakes", "UniformMotion", "car_1", params={"speed": 600}),
                edge("brake", "brakes", "crash", "Brake", "car_1", params={"damping": [0.2, 2]}),
                edge("wait", "scene_start", "go", "UniformMotion", "car_2", params={"speed": 0.0}),
                edge(
                    "speed_up",
                    "go",
                    "arrive",
                    "AcceleratedMotion",
                    "car_2",
                    params={"acceleration": [50, 400]},
                ),
                edge("stop", "arrive", "halt", "Brake", "car_2", params={"damping": [1, 6]}),
            ],
        ),
    )


def throwing() -> Json:
    """A heavy ball is thrown at a table with bottles; bottles fall, topple and land."""
    bottles = {
        f"bottle_{i}": node("bottle", "table_top", group="bottles", group_pattern="scatter")
        for i in (1, 2, 3)
    }
    return document(
        "throwing",
        "A basketball of 10 kg is thrown toward a picnic table with bottles and hits it after 1 s.",
        {
            "basketball": {**BALL, "expected_mass_kg": 10.0, "mass_is_prescribed": True},
            "table": TABLE,
            "bottle": BOTTLE,
        },
        {"basketball_1": node("basketball"), "picnic_table_1": node("table"), **bottles},
        [
            rel("picnic_table_1", "face", "ground_1", cardinal="+Y"),
            *(rel(b, "on", "picnic_table_1") for b in bottles),
        ],
        timeline(
            {
                "basketball_1": active("ANY_3D"),
                "picnic_table_1": PASSIVE,
                "bottle_1": PASSIVE,
                "bottle_2": PASSIVE,
            },
            [
                event(
                    "hit",
                    "Collision",
                    ["basketball_1", "picnic_table_1"],
                    timestamp=1.0,
                    time_is_prescribed=True,
                ),
                event("knock", "Collision", ["basketball_1", "bottle_1"], window=[1.1, 2.0]),
                event("fall", "Fall", ["bottle_1"], window=[2.1, 3.0]),
                event("land", "Collision", ["bottle_1", "ground_1"], window=[3.1, 5.0]),
                event("clash", "Collision", ["bottle_1", "bottle_2"], window=[2.1, 3.0]),
                event("tip", "Topple", ["bottle_2"], window=[3.1, 5.0]),
            ],
            [
                edge(
                    "throw",
                    "scene_start",
                    "hit",
                    "Toward",
                    "basketball_1",
                    target="picnic_table_1",
                    params={"speed": [300, 1500], "elevation_deg": [0, 60], "spin": "none"},
                ),
                edge("carry_on", "hit", "knock", "Toward", "basketball_1"),
                edge("drop", "knock", "fall", "InertialConnector", "bottle_1"),
                edge("dive", "fall", "land", "InertialConnector", "bottle_1"),
                edge("swerve", "knock", "clash", "InertialConnector", "bottle_1"),
                edge("tilt", "clash", "tip", "InertialConnector", "bottle_2"),
            ],
        ),
        {"table_top": region("picnic_table_1")},
        [{"subjects": list(bottles), "relation_type": "scatter_by", "spacing_cm": [5, 30]}],
    )


def billiards() -> Json:
    """A cue ball sends the black ball into a pocket; regions nest three deep."""
    ball = asset("billiard_ball", (5.7, 5.7, 5.7), 0.17, shape="sphere")
    return document(
        "billiards",
        "The cue ball strikes the black ball, sending it into the bottom pocket.",
        {
            "ball": ball,
            "table": asset("billiard_table", (254, 127, 80), 300, is_movable=False),
        },
        {
            "billiard_table_1": node("table"),
            "cue_ball_1": node("ball", "cloth", label="cue ball"),
            "black_ball_1": node("ball", "cloth", label="black ball"),
            "ball_3": node("ball", "cloth", mentioned=False),
        },
        [
            rel("billiard_table_1", "face", "ground_1", cardinal="+Y"),
            rel("cue_ball_1", "on", "billiard_table_1"),
            rel("cue_ball_1", "face", "black_ball_1"),
            rel("ball_3", "same_level_as", "cue_ball_1"),
            rel("ball_3", "behind", "black_ball_1"),
        ],
        timeline(
            {"cue_ball_1": active(), "black_ball_1": PASSIVE},
            [
                event("strike", "Collision", ["cue_ball_1", "black_ball_1"], window=[0.3, 1.5]),
                event(
                    "pot",
                    "EnterRegion",
                    ["black_ball_1"],
                    window=[1.6, 5.0],
                    region="billiard_table_1/bottom pocket",
                ),
            ],
            [
                edge(
                    "shot",
                    "scene_start",
                    "strike",
                    "Toward",
                    "cue_ball_1",
                    target="black_ball_1",
                    params={"speed": [100, 600], "heading_deg": [-180, 180], "spin": "roll"},
                ),
                edge(
                    "roll",
                    "strike",
                    "pot",
                    "InertialConnector",
                    "black_ball_1",
                    target="billiard_table_1",
                ),
            ],
        ),
        {"cloth": region("billiard_table_1")},
        scene_type="indoor",
    )


def study() -> Json:
    """A static room: things on, in, under and attached to others, and a seating group."""
    return document(
        "study",
        "A desk with a laptop, a lamp and a box of books; four chairs around a round table.",
        {
            "wall": asset("wall", (600, 15, 280), 3000, is_movable=False),
            "desk": asset("desk", (80, 160, 75), 45),
            "laptop": asset("laptop", (24, 34, 2), 1.6),
            "box": BOX,
            "book": asset("book", (24, 17, 3), 0.5),
            "picture": asset("picture", (3, 60, 40), 2),
            "lamp": asset("ceiling_lamp", (40, 40, 30), 3),
            "chair": asset("chair", (50, 50, 90), 6),
            "round_table": asset("table", (120, 120, 75), 30, shape="cylinder"),
        },
        {
            "wall_1": {"asset_id": "wall", "is_structural": True},
            "desk_1": node("desk"),
            "laptop_1": node("laptop", "desk_top"),
            "box_1": node("box"),
            "book_1": node("book", "box_inside"),
            "book_2": node("book", "desk_top"),
            "picture_1": node("picture", "wall_face"),
            "lamp_1": node("lamp", "ceiling"),
            "table_1": node("round_table"),
            **{f"chair_{i}": node("chair") for i in (1, 2, 3, 4)},
        },
        [
            rel("desk_1", "face", "ground_1", cardinal="+Y"),
            rel("picture_1", "face", "desk_1"),
            rel("book_1", "face", "ground_1", cardinal="+Y"),
            rel("book_2", "face", "ground_1", cardinal="-X"),
            rel("laptop_1", "on", "desk_1"),
            rel("laptop_1", "center_of", "desk_1"),
            rel("laptop_1", "face", "desk_1"),
            rel("box_1", "under", "desk_1"),
            rel("book_1", "inside_of", "box_1"),
            rel("book_2", "on", "desk_1"),
            rel("book_2", "right_of", "laptop_1", distance_cm=10.0),
            rel("picture_1", "attached_vertical", "wall_1"),
            rel("picture_1", "higher_than", "desk_1"),
            rel("lamp_1", "above", "table_1"),
            rel("desk_1", "adjacent", "wall_1"),
            *(rel(f"chair_{i}", "face", "table_1") for i in (1, 2, 3, 4)),
        ],
        None,
        {
            "desk_top": region("desk_1"),
            "box_inside": {
                **region("box_1", "STORAGE"),
                "bounds_cm": [[-28, -28, 1], [28, 28, 58]],
            },
            "wall_face": region("wall_1", "ATTACHED_VERTICAL"),
            "ceiling": region("wall_1", "ATTACHED_HORIZONTAL"),
        },
        [
            {
                "subjects": ["chair_1", "chair_2", "chair_3", "chair_4"],
                "targets": ["table_1"],
                "relation_type": "surround",
            },
            {"subjects": ["chair_1", "chair_2"], "relation_type": "align"},
            {
                "subjects": ["box_1"],
                "targets": ["desk_1", "table_1"],
                "relation_type": "between",
            },
        ],
        "indoor",
    )


def finished() -> Json:
    """The chain after all stages, with poses, a control program and a coverage record."""
    out = chain()
    out["asset_configurations"] = {
        name: {
            "asset_name": name,
            "source": "parametric",
            "category": spec["asset_category"],
            "mesh_path": f"meshes/{name}.glb",
            "dimensions_cm": spec["expected_dimensions_cm"],
            "proxies": [
                {
                    "kind": "box",
                    "size_cm": [v / 2 for v in spec["expected_dimensions_cm"]],
                    "orientation_xyzw": [0.0, 0.0, 0.6, 0.8],
                }
            ],
            "regions": [
                {"name": "inside", "center_cm": [0, 0, 40], "half_extents_cm": [20, 20, 30]}
            ],
            "support_surfaces": [
                {"name": "top", "center_cm": [0, 0, 75], "half_extents_cm": [20, 20]}
            ],
            "mass_kg": spec["expected_mass_kg"],
            "is_movable": spec.get("is_movable", True),
            "friction": 0.6,
            "restitution": 0.3,
        }
        for name, spec in out["asset_requirement"].items()
    }
    out["asset_requirement"]["bin"]["mass_is_prescribed"] = True
    nodes = out["spatial_relation_graph"]["nodes"]
    out["layout_result"] = {
        "poses": {n: {"position_cm": [100.0 * i, 0.0, 0.0]} for i, n in enumerate(nodes)},
        "energy": 0.01,
    }
    out["dynamics_result"] = {
        "strategy": "batched",
        "parameters": [
            {"name": "car_drive/speed", "value": 900.0, "lower": 300, "upper": 1500, "initial": 800}
        ],
        "program": {
            "version": 1,
            "duration": 6.0,
            "primitives": [
                {
                    "kind": "HoldVelocity",
                    "body": "car_1",
                    "start": 0.0,
                    "end": None,
                    "speed": 9.0,
                    "heading": 0.0,
                    "until_contact": ["trashbin_1"],
                }
            ],
        },
        "duration_s": 6.0,
        "outcome": "solved",
    }
    prompt = out["scene_definition"]["original_description"]
    out["coverage"] = {
        "items": [
            {
                "text": "car",
                "start": prompt.index("car"),
                "end": prompt.index("car") + 3,
                "kind": "object",
                "status": "used",
                "pointer": "/spatial_relation_graph/nodes/car_1",
            }
        ]
    }
    out["provenance"] = [{"stage": "draft", "version": "1", "seed": 0}]
    return out


def carried() -> Json:
    """A car hits a table, and the bin that stands on it topples."""
    out = chain()
    out["spatial_relation_graph"]["semantic_regions"]["table_top"] = region("picnic_table_1")
    out["spatial_relation_graph"]["nodes"]["trashbin_1"] = node("bin", "table_top")
    out["spatial_relation_graph"]["edges"]["binary_relations"] = [
        rel("trashbin_1", "on", "picnic_table_1"),
        rel("car_1", "face", "picnic_table_1"),
        rel("picnic_table_1", "face", "ground_1", cardinal="+Y"),
    ]
    out["timeline_system"] = timeline(
        {
            "car_1": active("ALONG_FORWARD_OR_BACKWARD"),
            "trashbin_1": PASSIVE,
            "picnic_table_1": PASSIVE,
        },
        [
            event("car_hits_table", "Collision", ["car_1", "picnic_table_1"], window=[0.8, 2.0]),
            event("bin_topples", "Topple", ["trashbin_1"], window=[2.1, 4.0]),
        ],
        [
            edge(
                "car_drive",
                "scene_start",
                "car_hits_table",
                "UniformMotion",
                "car_1",
                target="picnic_table_1",
                params={"speed": [300, 1500]},
            ),
            edge("bin_tips", "car_hits_table", "bin_topples", "InertialConnector", "trashbin_1"),
        ],
    )
    return copy.deepcopy(out)


def handled() -> Json:
    """A mug is put on a shelf, a ball held above it and let go, a top spins, a dog jumps."""
    return document(
        "handled",
        "The mug is picked up and put on the shelf. A ball is held above the floor, released and "
        "bounces three times. The top spins. The dog jumps over the fence.",
        {
            "mug": asset("mug", (10, 10, 10), 0.3, shape="cylinder"),
            "shelf": asset("shelf", (80, 30, 120), 20),
            "ball": BALL,
            "top": asset("spinning_top", (8, 8, 10), 0.2, shape="cylinder"),
            "dog": asset("dog", (90, 30, 60), 25),
            "fence": asset("fence", (10, 150, 40), 15),
        },
        {
            "mug_1": node("mug"),
            "shelf_1": node("shelf"),
            "ball_1": node("ball"),
            "top_1": node("top"),
            "dog_1": node("dog"),
            "fence_1": node("fence"),
            "spare_1": node("mug", mentioned=False),
        },
        [
            rel("shelf_1", "face", "ground_1", cardinal="+Y"),
            rel("dog_1", "face", "fence_1"),
            rel("fence_1", "face", "ground_1", cardinal="+Y"),
        ],
        timeline(
            {
                "mug_1": active("ANY_3D"),
                "ball_1": active("ANY_3D"),
                "top_1": active(),
                "dog_1": active("ALONG_FORWARD_ONLY"),
            },
            [
                event("lifted", "PickedUp", ["mug_1"], window=[0.3, 2.0]),
                event("put", "Placed", ["mug_1", "shelf_1"], window=[2.1, 6.0]),
                event("let_go", "Trigger", ["ball_1"], window=[0.5, 2.0]),
                event("bounces", "Bounce", ["ball_1", "ground_1"], window=[2.1, 6.0], times=3),
                event("turned", "Spin", ["top_1"], window=[0.5, 9.0], turn_degrees=1080.0),
                event("jumped", "Jump", ["dog_1", "fence_1"], window=[0.5, 4.0]),
            ],
            [
                edge("lift", "scene_start", "lifted", "Guide", "mug_1", params={"lift_cm": 20}),
                edge("carry", "lifted", "put", "Guide", "mug_1", target="shelf_1",
                     params={"duration": [1.0, 3.0], "release": True}),
                edge("hold", "scene_start", "let_go", "Guide", "ball_1", target="ground_1",
                     params={"clearance_cm": [80, 150]}),
                edge("drop", "let_go", "bounces", "Toward", "ball_1"),
                edge("spin", "scene_start", "turned", "Spin", "top_1",
                     params={"turn_rate_deg_s": [200, 700]}),
                edge("jump", "scene_start", "jumped", "Toward", "dog_1", target="fence_1",
                     params={"height_cm": [45, 80]}),
            ],
        ),
    )  # fmt: skip


VALID = {f.__name__: f for f in (
    chain, braking, turning, throwing, billiards, study, carried, handled, finished,
)}  # fmt: skip
