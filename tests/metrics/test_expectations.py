"""A document's timeline as a suite scene."""

from __future__ import annotations

import pytest

from esg.graph.models import (
    Actor,
    AssetRequirement,
    EsgDocument,
    EventConstraint,
    Node,
    NodeEvent,
    SceneDefinition,
    SceneParameters,
    SequenceGraph,
    SpatialRelationGraph,
    Statement,
    TimelineEdge,
    TimelineNode,
    TimelineSystem,
)
from esg.metrics import expectations_from_timeline

N = TimelineNode


def edge(name: str, start: str, end: str, kind: str, actor: str, **more: object) -> TimelineEdge:
    return TimelineEdge.model_validate(
        {"id": name, "from": start, "to": end, "event": kind, "actor": actor, **more}
    )


def document(nodes: list[TimelineNode], edges: list[TimelineEdge], **assets) -> EsgDocument:
    actors = {e.actor: Actor(role="passive") for e in edges}
    return EsgDocument(
        scene_definition=SceneDefinition(
            scene_id="doc",
            original_description="a prompt",
            scene_parameters=SceneParameters(is_dynamic=True, scene_type="outdoor"),
        ),
        asset_requirement=assets,
        spatial_relation_graph=SpatialRelationGraph(
            nodes={name: Node(asset_id=f"{name}_asset") for name in ("car_1", "bin_1", "table_1")}
        ),
        timeline_system=TimelineSystem(
            actors=actors, sequence_graph=SequenceGraph(nodes=tuple(nodes), edges=tuple(edges))
        ),
    )


START = N(id="start", event="SceneStart", timestamp=0.0)


def test_chain_of_collisions_keeps_its_order():
    doc = document(
        [
            START,
            N(id="e2", event="Collision", participants=("bin_1", "table_1"), window=(2, 3)),
            N(id="e1", event="Collision", participants=("car_1", "bin_1"), window=(1, 2)),
        ],
        [
            edge("drive", "start", "e1", "UniformMotion", "car_1", target="bin_1"),
            edge("fly", "e1", "e2", "InertialConnector", "bin_1", target="table_1"),
        ],
    )
    found = expectations_from_timeline(doc)
    assert [(e.id, e.type, e.a, e.b, e.after) for e in found.events] == [
        ("e1", "collision", "=car_1", "=bin_1", ()),
        ("e2", "collision", "=bin_1", "=table_1", ("e1",)),
    ]
    assert found.objects == ("=car_1", "=bin_1", "=table_1")
    assert found.constraints == ()


def test_braking_is_an_event_and_times_since_its_trigger_are_since_it():
    doc = document(
        [
            START,
            N(id="t1", event="Trigger", participants=("car_1",), window=(1, 2)),
            N(
                id="e",
                event="Collision",
                participants=("car_1", "bin_1"),
                timestamp=3.0,
                time_is_prescribed=True,
                constraints=(
                    EventConstraint(quantity="time_since", object="car_1", value=1.0, since="t1"),
                    EventConstraint(quantity="speed_before", object="car_1", value=(100.0, 200.0)),
                ),
            ),
        ],
        [
            edge(
                "drive", "start", "t1", "UniformMotion", "car_1",
                params={"speed": (500.0, 1000.0)}, speed_is_prescribed=True,
            ),
            edge("brake", "t1", "e", "Brake", "car_1", target="bin_1"),
        ],
    )  # fmt: skip
    found = expectations_from_timeline(doc)
    assert [(e.id, e.type, e.after) for e in found.events] == [
        ("drive", "moves", ()),
        ("brake", "brakes", ("drive",)),
        ("e", "collision", ("brake",)),
    ]
    assert [c.label for c in found.constraints] == [
        "time e = 3 s",
        "time_since =car_1 e since brake = 1 s",
        "speed =car_1 @e in [1, 2] m/s",
        "speed =car_1 @start in [5, 10] m/s",
    ]


def test_every_point_event_has_its_counterpart():
    nodes = [
        START,
        N(id="stop", event="Stop", participants=("car_1",)),
        N(id="top", event="Topple", participants=("bin_1",)),
        N(id="fall", event="Fall", participants=("bin_1", "table_1")),
        N(id="reach", event="Reach", participants=("car_1", "bin_1")),
        N(id="miss", event="Miss", participants=("car_1", "bin_1")),
        N(id="at", event="PositionAt", participants=("car_1",), position_cm=(100.0, 0.0, 50.0)),
        N(
            id="turn",
            event="HeadingReached",
            participants=("car_1",),
            turn_direction="right",
            turn_degrees=45.0,
        ),
        N(id="in", event="EnterRegion", participants=("bin_1",), region="table_1/inside"),
    ]
    edges = [edge(f"to_{n.id}", "start", n.id, "Toward", "car_1") for n in nodes[1:]]
    events = {e.id: e for e in expectations_from_timeline(document(nodes, edges)).events}
    assert events["stop"].type == "stops"
    assert events["top"].type == "topples"
    assert (events["fall"].type, events["fall"].from_) == ("falls", "=table_1")
    assert (events["reach"].type, events["reach"].target) == ("reaches", "=bin_1")
    assert events["miss"].type == "misses"
    assert events["at"].target == "@1,0,0.5"
    assert (events["turn"].direction, events["turn"].degrees) == ("right", 45.0)
    assert events["in"].target == "=table_1/inside"
    assert all(e.after == () for e in events.values())


def test_prescribed_masses_are_initial_constraints():
    asset = AssetRequirement(
        asset_category="car",
        asset_description="a car",
        expected_dimensions_cm=(400, 180, 150),
        expected_mass_kg=900.0,
        mass_is_prescribed=True,
    )
    found = expectations_from_timeline(document([START], [], car_1_asset=asset))
    assert [c.label for c in found.constraints] == ["mass =car_1 = 900 kg"]


def test_a_static_document_promises_its_objects_only():
    doc = document([START], []).model_copy(update={"timeline_system": None})
    found = expectations_from_timeline(doc)
    assert found.events == ()
    assert len(found.objects) == 3


def test_one_member_named_for_a_group_means_any_of_it():
    def pins(*named: str) -> EsgDocument:
        nodes = [START] + [
            N(id=f"e{k}", event="Collision", participants=("car_1", pin))
            for k, pin in enumerate(named)
        ]
        edges = [edge(f"d{n.id}", "start", n.id, "Toward", "car_1") for n in nodes[1:]]
        doc = document(nodes, edges)
        rack = {f"pin_{k}": Node(asset_id="pin", group="pins") for k in (1, 2, 3)}
        graph = doc.spatial_relation_graph
        graph = graph.model_copy(update={"nodes": {**graph.nodes, **rack}})
        return doc.model_copy(update={"spatial_relation_graph": graph})

    assert expectations_from_timeline(pins("pin_1")).events[0].b == "=pin_1,pin_2,pin_3"
    both = expectations_from_timeline(pins("pin_1", "pin_2")).events
    assert [e.b for e in both] == ["=pin_1", "=pin_2"]


def stated(doc: EsgDocument, **fields: object):
    """The only statement of a document, as the judge gets it."""
    values = {"id": "s1", "text": "in words", "start": 0, "end": 8, **fields}
    doc = doc.model_copy(update={"statements": (Statement.model_validate(values),)})
    (found,) = expectations_from_timeline(doc).statements
    assert found.words == "in words"
    return found


def test_statements_have_exact_references_and_base_units():
    doc = document([START], [])
    moved = stated(doc, predicate="faster_than", object=["car_1", "bin_1"], value=250.0)
    assert (moved.object, moved.value, moved.when) == ("=car_1,bin_1", 2.5, "throughout")
    above = stated(doc, predicate="above", object=["car_1"], target=["bin_1"], value=(50.0, 150.0))
    assert (above.target, above.value, above.range) == ("=bin_1", None, (0.5, 1.5))
    alike = stated(doc, predicate="size", object=["car_1"], target=["bin_1"], quantity="height")
    assert (alike.target, alike.alike) == (None, "=bin_1")
    count = stated(doc, predicate="count", noun="bin", quantity="count", value=3)
    assert (count.noun, count.value) == ("bin", 3)
    assert stated(doc, predicate="not_represented", note="no wind").note == "no wind"


def test_statements_need_no_timeline():
    doc = document([], []).model_copy(update={"timeline_system": None})
    assert stated(doc, predicate="supported_by", object=["car_1"], target=["table_1"])


def test_moments_that_are_not_measured_give_way_to_measured_ones():
    doc = document(
        [
            START,
            N(id="hit", event="Collision", participants=("car_1", "bin_1"), window=(1, 2)),
            N(id="go", event="Trigger", participants=("bin_1",), window=(2, 3)),
            N(id="halt", event="Stop", participants=("bin_1",), window=(3, 4)),
        ],
        [
            edge("drive", "start", "hit", "UniformMotion", "car_1", target="bin_1"),
            edge("wait", "hit", "go", "InertialConnector", "bin_1"),
            edge("roll", "go", "halt", "UniformMotion", "bin_1"),
        ],
    )
    still = {"predicate": "at_rest", "object": ["bin_1"]}
    assert stated(doc, **still, when="go..halt").when == "hit..halt"
    assert stated(doc, **still, when="start..go").when == "start..halt"
    assert stated(doc, **still, when="go").when == "hit"
    before = stated(doc, predicate="before", object=["hit", "halt"])
    assert (before.a, before.b, before.object) == ("hit", "halt", None)


@pytest.mark.parametrize(
    ("fields", "expected"),
    [
        ({"event": "Bounce", "participants": ("bin_1", "table_1"), "times": 3}, {"times": 3}),
        ({"event": "Placed", "participants": ("bin_1", "table_1")}, {"target": "=table_1"}),
        ({"event": "PickedUp", "participants": ("bin_1",)}, {"type": "picked_up"}),
        ({"event": "Jump", "participants": ("bin_1",)}, {"type": "jumps", "times": 1}),
        ({"event": "Spin", "participants": ("bin_1",)}, {"type": "spins", "degrees": 360.0}),
        ({"event": "Spin", "participants": ("bin_1",), "turn_degrees": 90.0}, {"degrees": 90.0}),
    ],
)
def test_point_events_of_handling_are_events_of_the_same_name(fields, expected):
    if fields["event"] not in {e.value for e in NodeEvent}:
        pytest.skip("the document has no such point event")
    node = N.model_validate({"id": "e1", "window": (1, 2), **fields})
    (found,) = expectations_from_timeline(document([START, node], [])).events
    assert {k: getattr(found, k) for k in expected} == expected
    assert found.object == "=bin_1"
