from __future__ import annotations

from dataclasses import replace
import json
from pathlib import Path
import re

from helpers import first_touches
import pytest
import scenes

from esg.compile import WatchedEvent, compile_scene, replay_class, watch_list
from esg.engines.manifest import load_manifest
from esg.engines.scene import Body, SimScene
from esg.graph.models import (
    EsgDocument,
    Node,
    NodeEvent,
    SceneDefinition,
    SceneParameters,
    SequenceGraph,
    SpatialRelationGraph,
    TimelineEdge,
    TimelineNode,
    TimelineSystem,
)


def document(
    nodes: dict[str, Node],
    events: tuple[tuple[str, NodeEvent, tuple[str, ...]], ...],
    edges: tuple[tuple[str, str], ...],
) -> EsgDocument:
    timeline = TimelineSystem(
        sequence_graph=SequenceGraph(
            nodes=tuple(TimelineNode(id=i, event=e, participants=p) for i, e, p in events),
            edges=tuple(
                TimelineEdge.model_validate(
                    {"id": f"m{k}", "from": a, "to": b, "event": "UniformMotion", "actor": "x"}
                )
                for k, (a, b) in enumerate(edges)
            ),
        )
    )
    return EsgDocument(
        scene_definition=SceneDefinition(
            scene_id="S7",
            original_description="three balls",
            scene_parameters=SceneParameters(is_dynamic=True, scene_type="outdoor"),
        ),
        spatial_relation_graph=SpatialRelationGraph(nodes=nodes),
        timeline_system=timeline if events else None,
    )


START = ("start", NodeEvent.SCENE_START, ())


def balls(names: list[str]) -> SimScene:
    return SimScene(
        "s", tuple(scenes.ball(n, (float(i), 0.0, 0.1), 0.1, 1.0) for i, n in enumerate(names))
    )


def test_chain_is_watched_in_causal_order() -> None:
    events = (
        ("late", NodeEvent.COLLISION, ("b", "c")),
        START,
        ("turn", NodeEvent.HEADING_REACHED, ("b",)),
        ("early", NodeEvent.COLLISION, ("a", "b")),
    )
    edges = (("start", "early"), ("early", "turn"), ("turn", "late"))
    nodes = {n: Node(asset_id=n) for n in "abc"}
    assert watch_list(document(nodes, events, edges), balls(list("abc"))) == (
        WatchedEvent("early", ("a",), ("b",)),
        WatchedEvent("late", ("b",), ("c",), ("early",)),
    )


def test_concurrent_events_do_not_wait_for_each_other() -> None:
    events = (
        START,
        ("one", NodeEvent.COLLISION, ("a", "b")),
        ("two", NodeEvent.COLLISION, ("c", "d")),
    )
    nodes = {n: Node(asset_id=n) for n in "abcd"}
    watch = watch_list(
        document(nodes, events, (("start", "one"), ("start", "two"))), balls(list("abcd"))
    )
    assert [w.after for w in watch] == [(), ()]


def test_plural_stands_for_all_its_members_but_lettered_balls_do_not() -> None:
    pins = {f"pin_{i}": Node(asset_id="pin", label="bowling pins", group="pins") for i in range(3)}
    lettered = {
        f"ball_{c}": Node(asset_id="ball", label=f"ball {c.upper()}", group="balls") for c in "ab"
    }
    events = (
        START,
        ("strike", NodeEvent.COLLISION, ("ball_a", "pin_1")),
        ("tap", NodeEvent.COLLISION, ("ball_a", "ball_b")),
    )
    doc = document({**lettered, **pins}, events, (("start", "strike"), ("strike", "tap")))
    strike, tap = watch_list(doc, balls([*lettered, *pins]))
    assert strike.a == ("ball_a",) and strike.b == ("pin_0", "pin_1", "pin_2")
    assert tap.b == ("ball_b",)


def test_what_cannot_touch_is_not_watched() -> None:
    lane = Body("lane", True, 0.0, ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0)), (), (0.0, 0.0, 0.0))
    scene = SimScene("s", (*balls(["a"]).bodies, lane))
    events = (START, ("e", NodeEvent.COLLISION, ("a", "lane")))
    nodes = {n: Node(asset_id=n) for n in ("a", "lane")}
    assert watch_list(document(nodes, events, (("start", "e"),)), scene) == ()


def test_compile_scene_writes_a_folder_that_runs(tmp_path: Path) -> None:
    scene, program = scenes.marbles()
    nodes = {b.name: Node(asset_id=b.name) for b in scene.bodies}
    events = (
        START,
        ("e1", NodeEvent.COLLISION, ("ball_a", "ball_b")),
        ("e2", NodeEvent.COLLISION, ("ball_b", "ball_c")),
    )
    doc = document(nodes, events, (("start", "e1"), ("e1", "e2")))
    compiled = compile_scene(doc, tmp_path, scene=scene, program=program)
    assert compiled.files == (
        "manifest.json",
        "unreal/EsgScene_S7.cpp",
        "unreal/EsgScene_S7.h",
        "unreal/imports.json",
    )
    manifest = load_manifest(tmp_path / "manifest.json")
    assert manifest.watch == (("ball_a", "ball_b"), ("ball_b", "ball_c"))
    assert manifest.extra["unreal_class"] == "EsgScene_S7"
    replayed = replay_class(tmp_path)
    assert {(0, 1), (1, 2)} <= first_touches(replayed.rollout).keys()
    assert "complete=2 of=2" in replayed.log[-1]
    before = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()}
    compile_scene(doc, tmp_path, scene=scene, program=program)
    assert {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()} == before


def test_another_class_replaces_the_one_before(tmp_path: Path) -> None:
    scene, program = scenes.marbles()
    doc = document({}, (), ())
    compile_scene(doc, tmp_path, scene=scene, program=program)
    compile_scene(doc, tmp_path, scene=SimScene("other", scene.bodies), program=program)
    assert sorted(p.name for p in (tmp_path / "unreal").iterdir()) == [
        "EsgScene_Other.cpp",
        "EsgScene_Other.h",
        "imports.json",
    ]


def test_a_static_scene_plays_and_nothing_moves(tmp_path: Path) -> None:
    table = scenes.box("table", (0.0, 0.0, 0.4), (0.5, 0.5, 0.4), 20.0)
    compile_scene(document({}, (), ()), tmp_path, scene=SimScene("still", (table,)))
    rollout = replay_class(tmp_path).rollout
    assert rollout.time[-1] == pytest.approx(2.0)
    assert abs(rollout.position[0, -1, 0] - rollout.position[0, 0, 0]).max() < 1e-3
    assert json.loads((tmp_path / "manifest.json").read_text())["program"]["primitives"] == []


HOSTILE_PROMPT = (
    'A "ball" */ rolls.\n#include <evil.h>\r\nint main() { system("rm"); } // \\ ??/ %s {0} \u202e'
    " TEXT(x)"
)


def test_nothing_of_a_prompt_reaches_code_unescaped(tmp_path: Path) -> None:
    """Prompt, labels and descriptions with quotes, newlines, comment ends and directives."""
    scene, program = scenes.marbles()
    bodies = tuple(
        replace(b, label=HOSTILE_PROMPT, description=HOSTILE_PROMPT, category=HOSTILE_PROMPT)
        for b in scene.bodies
    )
    nodes = {b.name: Node(asset_id=b.name, label=HOSTILE_PROMPT) for b in bodies}
    event = (HOSTILE_PROMPT, NodeEvent.COLLISION, ("ball_a", "ball_b"))
    doc = document(nodes, (START, event), (("start", HOSTILE_PROMPT),))
    definition = doc.scene_definition.model_copy(
        update={"scene_id": HOSTILE_PROMPT, "original_description": HOSTILE_PROMPT}
    )
    doc = doc.model_copy(update={"scene_definition": definition})
    hostile = SimScene(HOSTILE_PROMPT, bodies)
    compile_scene(doc, tmp_path, scene=hostile, program=program)
    for path in (tmp_path / "unreal").glob("EsgScene_*"):
        text = path.read_text("utf-8")
        assert text.isascii() and "??/" not in text
        code = re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', text)
        # A one-line comment stays one line: no backslash at its end, no way out of a block.
        for comment in re.findall(r"//[^\n]*", code):
            assert not set(comment[2:]) & set("\\*#\r") and '""' not in comment
        code = re.sub(r"//[^\n]*|/\*.*?\*/", "", code, flags=re.DOTALL)
        assert not {"system", "main", "rm", "evil"} & set(re.findall(r"\w+", code))
        directives = re.findall(r"^\s*#.*$", code, re.MULTILINE)
        assert all(re.fullmatch(r'\s*#(pragma once|include "")', d) for d in directives), directives
    replayed = replay_class(tmp_path)
    hits = [e for e in replayed.events() if e["event"] == "EVENT_HIT"]
    assert len(hits) == 1
    manifest = load_manifest(tmp_path / "manifest.json")
    assert manifest.scene.bodies[0].label == HOSTILE_PROMPT
