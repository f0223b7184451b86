"""What a model is told, and what code makes of its answers: words, examples, joints, statements."""

from __future__ import annotations

import json
from typing import Any

import pytest

from esg.draft import draft
from esg.draft.llm.assemble import Json, Replies, assemble
from esg.draft.llm.auto import chosen, disagreements, draft_auto
from esg.draft.llm.client import Call, Reply
from esg.draft.llm.drafter import draft_llm_batch
from esg.draft.llm.instructions import examples, instructions, vocabulary
from esg.draft.llm.mending import mend
from esg.draft.llm.schema import schema_of
from esg.draft.llm.scripted import ScriptedModel, replies_of
from esg.draft.llm.segments import open_times
from esg.draft.llm.settings import LlmSettings
from esg.draft.llm.stages import WholeReply
from esg.graph import EsgDocument, verify
from esg.graph.models import EdgeEvent, NodeEvent, Predicate
from esg.lexicon.articulations import articulations
from esg.outcomes import Outcome

WORDS = {"events": NodeEvent, "motions": EdgeEvent, "predicates": Predicate}


class Told:
    """A model that answers with given objects by stage, and remembers what it was asked."""

    def __init__(self, answers: dict[str, Any]) -> None:
        self.answers, self.calls = answers, list[Call]()

    async def complete(self, call: Call) -> Reply:
        self.calls.append(call)
        return Reply(json.dumps(self.answers[call.stage]))


@pytest.mark.parametrize("kind", WORDS)
def test_every_word_of_the_document_is_told(kind: str) -> None:
    """Explain every word that the document allows, and none that it does not."""
    assert set(vocabulary()[kind]) == {w.value for w in WORDS[kind]}
    assert all(meaning for meaning in vocabulary()[kind].values())
    text = instructions("timeline")
    for word, meaning in vocabulary()[kind].items():
        assert f"- {word}: {meaning}" in text


def test_instructions_are_filled_in() -> None:
    """Leave no place holder, and name every jointed thing of the table."""
    for stage in ("scene", "timeline", "single_shot"):
        text = instructions(stage)
        assert not any("{" + kind + "}" in text for kind in (*WORDS, "jointed"))
        assert all(e["prompt"] in text for e in examples())
    for row in articulations().values():
        assert row.nouns[0] in instructions("scene")


@pytest.mark.parametrize("example", examples(), ids=lambda e: e["prompt"][:30])
def test_examples_are_faultless(example: dict[str, Any]) -> None:
    """Draft every example from its own answers in no further round, with nothing missing."""
    whole = {**example["scene"], "timeline": example["timeline"]}
    model = Told({**example, "single_shot": whole})
    config = LlmSettings(base_url="http://127.0.0.1:9/v1", model="m", max_rounds=0)
    for variant in ("full", "no_validation", "single_shot"):
        (made,) = draft_llm_batch(
            [example["prompt"]], settings=config, client=model, variant=variant
        )
        assert made.outcome is Outcome.SOLVED, (variant, made.reason)
    (made,) = draft_llm_batch([example["prompt"]], settings=config, client=model)
    assert made.document is not None and made.document.coverage.warnings == ()
    assert not any("read as" in r or "dropped" in r for r in made.repairs)
    for s in made.document.statements or ():
        assert example["prompt"][s.start : s.end] == s.text


def test_examples_are_no_prompts_of_a_corpus() -> None:
    """Show a model nothing that it is measured by."""
    from benchmarks.drafting.corpus import PROMPTS

    known = [p.read_text(encoding="utf-8") for p in PROMPTS.glob("*.jsonl")]
    for example in examples():
        assert not any(json.dumps(example["prompt"])[1:-1] in text for text in known)


def test_a_schema_says_nothing_twice() -> None:
    """Send no titles, defaults or nulls, and what is needed all the same."""
    for stage in ("scene", "timeline", "single_shot"):
        text = json.dumps(schema_of(stage))
        assert '"default"' not in text and '"title"' not in text and '"null"' not in text
    part = schema_of("timeline")["$defs"]["StatementPart"]
    assert part["required"] == ["says", "words"]
    assert set(schema_of("scene")["required"]) == {"expansion", "assets", "spatial"}


JOINTED = (
    "A door opens.",
    "A pendulum swings and hits a box.",
    "A black drawer closes.",
    "A chest opens.",
    "A Newton's cradle swings.",
    "A wrecking ball hits a wall.",
    "A vase falls off a shelf and breaks.",
    "A robot arm picks up the red block and puts it on the blue block.",
    "A man jumps over a log.",
    "A ball bounces twice on the floor.",
    "A top spins.",
    "A car reverses slowly into a wall.",
    "A boy rides a bicycle along a road.",
    "A ball rolls gracefully.",
)


@pytest.mark.parametrize("prompt", JOINTED)
def test_a_model_can_say_what_the_rules_say(prompt: str) -> None:
    """Restore joints, blows, motions and statements from the shapes of the replies."""
    wanted = draft(prompt)
    config = LlmSettings(base_url="http://127.0.0.1:9/v1", model="m")
    (made,) = draft_llm_batch([prompt], settings=config, client=ScriptedModel(0.0, 0.0))
    got = made.document
    assert made.outcome is Outcome.SOLVED and made.rounds == 0 and got is not None
    assert wanted.timeline_system is not None and got.timeline_system is not None
    assert got.timeline_system.sequence_graph.edges == wanted.timeline_system.sequence_graph.edges
    assert got.spatial_relation_graph.joints == wanted.spatial_relation_graph.joints
    assert got.statements == wanted.statements
    broken = {n: v.breaking for n, v in wanted.spatial_relation_graph.nodes.items()}
    assert {n: v.breaking for n, v in got.spatial_relation_graph.nodes.items()} == broken


SCENE: dict[str, Any] = {
    "expansion": {"expanded_description": "x", "is_dynamic": True, "scene_type": "indoor"},
    "assets": {
        "assets": [
            {"asset_id": a, "category": a, "description": a, "length_cm": x, "width_cm": y,
             "height_cm": z, "mass_kg": m}
            for a, x, y, z, m in (
                ("floor", 900, 900, 10, 9000), ("door", 4, 90, 200, 25), ("cup", 8, 8, 10, 0.3),
                ("box", 40, 30, 30, 5),
            )
        ],
        "objects": [
            {"name": "floor_1", "asset_id": "floor", "structural": True, "mentioned": False},
            {"name": "door_1", "asset_id": "door", "label": "open door"},
            {"name": "cup_1", "asset_id": "cup", "label": "cup"},
            {"name": "box_1", "asset_id": "box", "label": "box"},
        ],
    },
    "spatial": {},
}  # fmt: skip


def made_of(timeline: dict[str, Any], prompt: str = "An open door closes.") -> tuple[Json, Any]:
    whole = WholeReply.model_validate({**SCENE, "timeline": timeline})
    return assemble(
        prompt, 0, Replies(whole.expansion, whole.assets, whole.spatial, whole.timeline)
    )


def test_a_named_door_gets_its_frame() -> None:
    """Join a door to a frame of the table, open at the start, with the events' windows filled."""
    raw, log = made_of(
        {
            "actors": [{"object": "door_1", "role": "active", "force_direction": "ANY_3D"}],
            "events": [{"id": "e1", "event": "Close", "participants": ["door_1"]}],
            "segments": [{"id": "m1", "start": "scene_start", "end": "e1",
                          "motion": "UniformMotion", "actor": "door_1"}],
        }
    )  # fmt: skip
    assert verify(raw) == ()
    (joint,) = raw["spatial_relation_graph"]["joints"]
    row = articulations()["door"]
    assert (joint["parent"], joint["child"], joint["position"]) == (
        "door_frame_1", "door_1", row.opened
    )  # fmt: skip
    graph = raw["timeline_system"]["sequence_graph"]
    assert graph["edges"][0]["event"] == "Drive" and graph["nodes"][1]["window"] == [0.2, 5.0]
    assert any("read as Drive" in text for text in log)


def test_statements_have_their_place_and_course() -> None:
    """Find the words, set the course of the motion, fill a pace, report what is not there."""
    prompt = "A cup slides slowly to the left, humming."
    raw, log = made_of(
        {
            "actors": [{"object": "cup_1", "role": "active", "force_direction": "HORIZONTAL_PLANE"}],
            "events": [{"id": "e1", "event": "Trigger", "participants": ["cup_1"]}],
            "segments": [{"id": "m1", "start": "scene_start", "end": "e1", "motion": "Toward",
                          "actor": "cup_1", "parameters": [{"name": "speed", "low": 50, "high": 90}]}],
            "statements": [
                {"says": "moves", "words": "to the  left", "object": ["The Cup"],
                 "direction": "left"},
                {"says": "slower_than", "words": "slowly", "object": ["cup_1"]},
                {"says": "not_represented", "words": "it is humming", "missing": "sound"},
            ],
        },
        prompt,
    )  # fmt: skip
    assert verify(raw) == ()
    doc = EsgDocument.model_validate_json(json.dumps(raw))
    first, second, third = doc.statements or ()
    assert prompt[first.start : first.end] == first.text == "to the left"
    assert first.object == ("cup_1",) and second.value == 90.0 and second.quantity == "speed"
    assert "humming" in third.text and third.note == "sound"
    assert raw["timeline_system"]["sequence_graph"]["edges"][0]["params"]["heading_deg"] == 0.0
    assert any("humming" in text for text in log)


def edge(kind: str, to: str = "e1", actor: str = "a", **params: Any) -> Json:
    return {"id": "m", "from": "s", "to": to, "event": kind, "actor": actor, "target": None,
            "params": params}  # fmt: skip


@pytest.mark.parametrize(
    ("event", "motion", "becomes"),
    [
        ("Placed", "UniformMotion", "Guide"),
        ("PickedUp", "Toward", "Guide"),
        ("Jump", "UniformMotion", "Toward"),
        ("Open", "Guide", "Drive"),
        ("Swing", "Toward", "Release"),
        ("Collision", "Guide", "UniformMotion"),
        ("Collision", "InertialConnector", "Toward"),
        ("Collision", "Toward", "Toward"),
    ],
)
def test_a_motion_is_read_as_what_its_end_allows(event: str, motion: str, becomes: str) -> None:
    """Take the one type of segment that leads to an event, for an active actor."""
    nodes: list[Json] = [{"id": "s", "event": "SceneStart"},
                         {"id": "e1", "event": event, "participants": ["a", "b"]}]  # fmt: skip
    edges = [edge(motion)]
    mend(nodes, edges, {"a": {"role": "active", "force_direction": "ANY_3D"}}, "ground_1")
    assert edges[0]["event"] == becomes


def test_slips_with_one_meaning_are_mended() -> None:
    """Put participants, movers, roles, foreign fields and force directions right, and say so."""
    nodes: list[Json] = [
        {"id": "s", "event": "SceneStart"},
        {"id": "e1", "event": "Collision", "participants": ["b", "a"], "turn_degrees": 9.0},
        {"id": "e2", "event": "EnterRegion", "participants": ["a", "box_1"]},
        {"id": "e3", "event": "Bounce", "participants": ["a"]},
    ]
    edges = [edge("UniformMotion", elevation_deg=20.0), edge("Toward", "e3", elevation_deg=20.0)]
    actors: Json = {"a": {"role": "passive"}, "b": {"role": "active"}}
    log = mend(nodes, edges, actors, "ground_1")
    assert nodes[1]["participants"] == ["a", "b"] and nodes[1]["turn_degrees"] is None
    assert nodes[2]["participants"] == ["a"] and nodes[2]["region"] == "box_1/inside"
    assert nodes[3]["participants"] == ["a", "ground_1"]
    assert "elevation_deg" not in edges[0]["params"] and "elevation_deg" in edges[1]["params"]
    assert actors["a"]["role"] == "active" and actors["b"]["role"] == "passive"
    assert len(log) >= 5


def test_open_times_follow_one_another() -> None:
    """Fill windows in order, before a stated time that follows, and after a stated delay."""
    nodes: list[Json] = [
        {"id": "s", "event": "SceneStart", "timestamp": 0.0},
        {"id": "a", "event": "Collision"},
        {"id": "b", "event": "Fall"},
        {"id": "c", "event": "Stop", "timestamp": 3.0},
        {"id": "d", "event": "Stop",
         "constraints": [{"quantity": "time_since", "since": "c", "value": 10.0}]},
        {"id": "e", "event": "Trigger"},
    ]  # fmt: skip
    pairs = (("s", "a"), ("a", "b"), ("b", "c"), ("c", "d"), ("s", "e"))
    open_times(nodes, [{"from": x, "to": y} for x, y in pairs])
    windows = {n["id"]: n.get("window") for n in nodes}
    assert 0.0 < windows["a"][0] < windows["a"][1] <= windows["b"][0] < windows["b"][1] <= 3.0
    assert windows["c"] is None and windows["d"][0] == 13.0 and windows["d"][1] > 13.0
    assert windows["e"] == [0.5, 1.5]


def test_auto_takes_the_rules_without_a_model(monkeypatch: pytest.MonkeyPatch) -> None:
    """Draft as the rules do where nothing is configured, and say why."""
    for name in ("BASE_URL", "MODEL", "CASSETTE"):
        monkeypatch.delenv(f"ESG_LLM_{name}", raising=False)
    drafter, why = chosen()
    assert drafter == "rules" and "ESG_LLM_BASE_URL" in why
    prompt = "A ball hits a box."
    assert draft_auto(prompt) == draft(prompt, drafter="auto").model_copy(
        update={"scene_definition": draft_auto(prompt).scene_definition}
    )


def test_auto_survives_a_model_that_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    """Warn and go on with the rules when nobody answers."""
    monkeypatch.setenv("ESG_LLM_BASE_URL", "http://127.0.0.1:9/v1")
    monkeypatch.setenv("ESG_LLM_MODEL", "m")
    monkeypatch.setenv("ESG_LLM_ATTEMPTS", "1")
    assert chosen()[0] == "llm"
    doc = draft("A ball hits a box.", drafter="auto")
    assert verify(doc) == () and doc.provenance[0].config.get("drafter") != "llm"
    assert any("gave no draft" in w for w in doc.coverage.warnings)


def test_disagreement_on_who_hits_whom_is_shown() -> None:
    """Name each hit that only one of two readings has, by the nouns."""
    one, two = draft("A red ball hits a box."), draft("A ball hits a vase.")
    assert disagreements(one, one) == ()
    told = disagreements(one, two)
    assert len(told) == 2 and any('"ball" and "vase"' in t for t in told)
    assert disagreements(one, draft("A blue ball hits two boxes.")) == ()
    assert replies_of(one)["timeline"] is not None


def test_a_small_model_is_asked_once_in_plain_words() -> None:
    """Draft from things and acts: sizes of the lexicon, motions by the event, chains as told."""
    answer = {
        "things": [
            {"name": "bowling ball"},
            {"name": "crate"},
            {"name": "vase", "on": "table"},
            {"name": "table"},
        ],
        "acts": [
            {"who": "bowling ball", "does": "hits", "whom": "crate", "speed_m_s": 5.0},
            {"who": "crate", "does": "hits", "whom": "table"},
            {"who": "vase", "does": "falls"},
        ],
    }
    model = Told({"small": answer})
    config = LlmSettings(base_url="http://127.0.0.1:9/v1", model="m", profile="small")
    prompt = "A bowling ball at 5 m/s hits a crate into a table, and the vase on it falls."
    (made,) = draft_llm_batch([prompt], settings=config, client=model)
    assert made.outcome is Outcome.SOLVED, made.reason
    assert [c.stage for c in model.calls] == ["small"] and made.rounds == 0
    assert len(instructions("small")) < 1200 and "$defs" in model.calls[0].schema
    doc = made.document
    assert doc is not None and doc.timeline_system is not None
    ball = doc.asset_requirement["bowling_ball"]
    assert ball.shape == "sphere" and 5.0 <= ball.expected_mass_kg <= 8.0
    told = [(n.event.value, n.participants) for n in doc.timeline_system.sequence_graph.nodes[1:]]
    assert told == [
        ("Collision", ("bowling_ball", "crate")),
        ("Collision", ("crate", "table")),
        ("Fall", ("vase",)),
    ]
    edges = doc.timeline_system.sequence_graph.edges
    assert edges[0].params.speed == 500.0 and edges[0].speed_is_prescribed
    assert edges[1].event is EdgeEvent.INERTIAL_CONNECTOR and edges[1].from_ == "e1"
    assert any(e.from_ == "vase" and e.to == "table" for e in
               doc.spatial_relation_graph.edges.binary_relations)  # fmt: skip


def test_a_small_model_is_told_what_is_wrong() -> None:
    """Send violations back to the one short request."""

    class Learning(Told):
        async def complete(self, call: Call) -> Reply:
            self.calls.append(call)
            falls = {"who": "ball", "does": "hits", "whom": "ball"}
            good = {"who": "ball", "does": "hits", "whom": "box"}
            acts = [good if len(self.calls) > 1 else falls]
            return Reply(json.dumps({"things": [{"name": "ball"}, {"name": "box"}], "acts": acts}))

    model = Learning({})
    config = LlmSettings(base_url="http://127.0.0.1:9/v1", model="m", profile="small")
    (made,) = draft_llm_batch(["A ball hits a box."], settings=config, client=model)
    assert made.outcome is Outcome.SOLVED and made.rounds == 1
    assert "EVENT_PARTICIPANTS" in model.calls[1].messages[-1][1]


def test_what_no_table_joins_is_left_out_and_owned_up_to() -> None:
    """Spend no round on a cup that opens, keep the rest, and say what is not shown."""
    raw, log = made_of(
        {
            "actors": [{"object": "cup_1", "role": "active", "force_direction": "ANY_3D"},
                       {"object": "box_1", "role": "active", "force_direction": "ANY_3D"}],
            "events": [{"id": "e1", "event": "Open", "participants": ["cup_1"]},
                       {"id": "e2", "event": "Fall", "participants": ["box_1"]}],
            "segments": [
                {"id": "m1", "start": "scene_start", "end": "e1", "motion": "Drive",
                 "actor": "cup_1"},
                {"id": "m2", "start": "scene_start", "end": "e2", "motion": "Toward",
                 "actor": "box_1"},
            ],
        },
        "A cup opens and a box falls.",
    )  # fmt: skip
    assert verify(raw) == ()
    graph = raw["timeline_system"]["sequence_graph"]
    assert [n["event"] for n in graph["nodes"]] == ["SceneStart", "Fall"]
    (statement,) = raw["statements"]
    assert statement["predicate"] == "not_represented" and statement["text"] == "cup"
    assert any("left out" in text for text in log)
