"""Words of a prompt that a model's document has nothing for are owned up to, and no others."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest

from esg.draft.llm.drafter import draft_llm_batch
from esg.draft.llm.settings import LlmSettings
from esg.draft.llm.words.unheld import FORGOTTEN, head
from esg.fidelity import fully_understood
from esg.graph import EsgDocument
from esg.graph.models import NodeEvent, Predicate
from esg.outcomes import Outcome
from tests.draft.test_llm_told import Told

Json = dict[str, Any]
WALK: Json = {"id": "m1", "start": "scene_start", "end": "e1", "motion": "UniformMotion"}
TRIGGER: Json = {"id": "e1", "event": "Trigger"}


def scene(
    things: Iterable[str], relations: Iterable[tuple[str, str, str]] = (), dynamic: bool = True
) -> Json:
    """Answer a scene of "label" or "label/category", each by the name of its last word and _1."""
    ground = {"asset_id": "ground", "category": "ground", "description": "flat ground",
              "length_cm": 12000, "width_cm": 12000, "height_cm": 10, "mass_kg": 10000,
              "movable": False}  # fmt: skip
    assets, objects = [ground], [
        {"name": "ground_1", "asset_id": "ground", "mentioned": False, "structural": True}
    ]  # fmt: skip
    for thing in things:
        label, _, category = thing.partition("/")
        name = label.split()[-1]
        assets.append({"asset_id": name, "category": category or name, "description": "plain",
                       "length_cm": 40, "width_cm": 40, "height_cm": 40, "mass_kg": 30})  # fmt: skip
        objects.append({"name": f"{name}_1", "asset_id": name, "label": label})
    told = [{"subject": a, "relation": r, "object": b} for a, r, b in relations]
    expansion = {"expanded_description": "", "is_dynamic": dynamic, "scene_type": "outdoor",
                 "environment": "field"}  # fmt: skip
    return {
        "expansion": expansion,
        "assets": {"assets": assets, "objects": objects},
        "spatial": {"relations": told},
    }


def goes(actor: str, statements: Iterable[Json] = (), *, to: Json = TRIGGER, **how: Any) -> Json:
    """Answer a timeline in which one thing travels to one event."""
    people = to.get("participants", [actor])
    return {
        "actors": [{"object": actor, "role": "active", "force_direction": "HORIZONTAL_PLANE"}],
        "events": [{**to, "participants": people}],
        "segments": [{**WALK, "actor": actor, **how}],
        "statements": list(statements),
    }


def says(predicate: str, words: str, who: str, target: str = "", **more: Any) -> Json:
    """Answer a statement."""
    return {"says": predicate, "words": words, "object": [who],
            "target": [target] if target else [], **more}  # fmt: skip


def made(prompt: str, scene: Json, timeline: Json | None = None) -> EsgDocument:
    """Draft with a model that answers this."""
    answers = {"scene": scene} | ({"timeline": timeline} if timeline is not None else {})
    config = LlmSettings(base_url="http://127.0.0.1:9/v1", model="m", max_rounds=0)
    (result,) = draft_llm_batch([prompt], settings=config, client=Told(answers))
    assert result.outcome is Outcome.SOLVED and result.document is not None, result.reason
    return result.document


def lost(doc: EsgDocument) -> dict[str, str]:
    """Give the words that a draft owns up to, and why."""
    prompt = doc.scene_definition.original_description
    stated = [s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    assert all(prompt[s.start : s.end] == s.text for s in stated)
    assert len({s.id for s in doc.statements or ()}) == len(doc.statements or ())
    return {s.text: s.note for s in stated}


CONTENTS = (
    ("A ball lies in a bucket filled with water.", "ball", "bucket", "water"),
    ("A spoon lies in a cup full of tea.", "spoon", "cup", "tea"),
    ("An apple lies in a bowl of soup.", "apple", "bowl", "soup"),
)


@pytest.mark.parametrize(("prompt", "thing", "vessel", "fluid"), CONTENTS)
def test_a_fluid_in_a_vessel_is_owned_up_to(
    prompt: str, thing: str, vessel: str, fluid: str
) -> None:
    """Draw no water as a solid in a bucket without saying so."""
    places = [
        (f"{thing}_1", "inside_of", f"{vessel}_1"),
        (f"{fluid}_1", "inside_of", f"{vessel}_1"),
    ]
    doc = made(prompt, scene((thing, vessel, fluid), places, dynamic=False))
    found = {words.removeprefix("of "): why for words, why in lost(doc).items()}
    assert found == {fluid: "fluids are not simulated"}
    assert not fully_understood(doc.model_dump(mode="json"))


def test_a_water_that_is_drawn_by_itself_is_there() -> None:
    """Leave alone what flows in no vessel."""
    told = says("supported_by", "rides a wave", "surfer_1", "wave_1")
    doc = made("A surfer rides a wave.", scene(("surfer", "wave")), goes("surfer_1", [told]))
    assert lost(doc) == {}


HELD = (says("slower_than", "slowly", "dog_1", low=100),)


@pytest.mark.parametrize(
    ("prompt", "statements", "wanted"),
    [
        ("A dog walks slowly along a road.", HELD, {}),
        ("A dog walks slowly along a road.", (), {"slowly": FORGOTTEN}),
        ("A dog walks along a road rapidly.", (), {"rapidly": FORGOTTEN}),
        ("A dog walks gracefully along a road.", (), {"gracefully": "manner is not simulated"}),
        (
            "A dog walks gracefully along a road.",
            (says("slower_than", "gracefully", "dog_1", low=100),),
            {},
        ),
        (
            "A dog walks gracefully along a road.",
            (says("moves", "walks gracefully", "dog_1", direction="forward"),),
            {"gracefully": "manner is not simulated"},
        ),
    ],
)
def test_a_manner_needs_a_statement_of_manner(
    prompt: str, statements: tuple[Json, ...], wanted: dict[str, str]
) -> None:
    """Miss an adverb that no pace says, whether the rules can say it or not."""
    places = [("dog_1", "on", "road_1")]
    assert lost(made(prompt, scene(("dog", "road"), places), goes("dog_1", statements))) == wanted


NO_THING = "no solid thing or motion stands for it"


@pytest.mark.parametrize(
    ("prompt", "words", "direction", "wanted"),
    [
        ("A dog runs in circles.", "runs in circles", "around", {}),
        ("A dog runs towards happiness.", "towards happiness", "toward", {"happiness": NO_THING}),
        ("A dog walks through the silence.", "through the silence", "through",
         {"silence": NO_THING}),
    ],
)  # fmt: skip
def test_a_motion_holds_the_noun_of_its_course(
    prompt: str, words: str, direction: str, wanted: dict[str, str]
) -> None:
    """Take "in circles" from a statement of motion, and no noun that names no thing."""
    told = says("moves", words, "dog_1", "ground_1", direction=direction)
    found = lost(made(prompt, scene(("dog",)), goes("dog_1", [told])))
    assert {w.removeprefix("the "): why for w, why in found.items()} == wanted


def test_a_thing_that_is_only_called_so_is_none() -> None:
    """Own up to a noun that names nothing, though something is drawn under its name."""
    prompt = "A zebra walks to a herd of its kind."
    told = says("moves", "to a herd of its kind", "zebra_1", "kind_1", direction="toward")
    found = lost(made(prompt, scene(("zebra", "kind/horse")), goes("zebra_1", [told])))
    assert found and set(found.values()) == {NO_THING}


@pytest.mark.parametrize(
    ("garment", "wanted"), [("coat", {"red coat"}), ("dress", {"red dress"}), ("hat", set())]
)
def test_only_what_keeps_its_shape_is_worn(garment: str, wanted: set[str]) -> None:
    """Show a hat by a stiff body that is fixed to who wears it, and no cloth."""
    prompt = f"A woman in a red {garment} walks along a road."
    told = says("attached_to", f"in a red {garment}", f"{garment}_1", "woman_1")
    things = scene(("woman", "road", f"red {garment}"), [("woman_1", "on", "road_1")])
    assert set(lost(made(prompt, things, goes("woman_1", [told])))) == wanted


def test_a_model_says_what_is_worn() -> None:
    """Miss no coat of which the model states that she wears it."""
    prompt = "A woman in a red coat walks along a road."
    told = says("wears", "red coat", "woman_1", noun="red coat")
    things = scene(("woman", "road"), [("woman_1", "on", "road_1")])
    assert lost(made(prompt, things, goes("woman_1", [told]))) == {}


SWING = "A crate swings into a box."
HIT: Json = {"id": "e1", "event": "Collision", "participants": ["crate_1", "box_1"]}


def test_an_act_that_only_the_model_draws_holds_its_verb() -> None:
    """Miss a verb for which neither draft has anything, and none that the model has a motion for."""
    things = scene(("crate", "box"))
    plain = made(SWING, things, goes("crate_1", to=HIT, target="box_1"))
    assert lost(plain) == {"swings": "nothing swings: it moves, and hangs from nothing"}
    bent = {"id": "e1", "event": "HeadingReached", "turn_degrees": 90, "turn_direction": "left"}
    turned = made("A car drives around a corner.", scene(("car",)),
                  goes("car_1", to=bent, motion="Turn", turn_direction="left", turn_degrees=90))  # fmt: skip
    assert lost(turned) == {} and turned.coverage.warnings == ()


def test_a_statement_with_its_words_holds_a_verb() -> None:
    """Let a model climb where the rules do not, and miss it where neither does."""
    prompt, things = "A cat climbs a tree.", scene(("cat", "tree"))
    up = says("moves", "climbs", "cat_1", direction="up")
    assert lost(made(prompt, things, goes("cat_1", [up]))) == {}
    found = lost(made(prompt, things, goes("cat_1", target="tree_1")))
    assert found.keys() == {"climbs a tree"}


def test_an_event_holds_the_direction_that_it_has() -> None:
    """Ask for no "up" beside a jump, and for one beside a walk."""
    jump: Json = {"id": "e1", "event": "Jump", "participants": ["boy_1"]}
    leaps = goes("boy_1", to=jump, motion="Toward")
    leaps["actors"][0]["force_direction"] = "ANY_3D"
    assert lost(made("A boy jumps up.", scene(("boy",)), leaps)) == {}
    assert lost(made("A bird flies up.", scene(("bird",)), goes("bird_1"))) == {"up": FORGOTTEN}


def test_what_the_model_owns_up_to_is_not_said_twice() -> None:
    """Add nothing to words that the model has already called not represented."""
    told = says("not_represented", "walks gracefully", "dog_1", missing="grace")
    doc = made("A dog walks gracefully.", scene(("dog",)), goes("dog_1", [told]))
    assert lost(doc) == {"walks gracefully": "grace"}


def test_a_prompt_that_the_rules_refuse_is_looked_up_word_by_word() -> None:
    """Own up to each word of content of a prompt in which the rules find nothing to draw."""
    prompt = "Aerial sunrise shot over a town, flying forwards."
    doc = made(prompt, scene(("town",), dynamic=False))
    assert {"Aerial", "shot", "flying"} <= set(lost(doc)) and "town" not in lost(doc)


def test_words_of_another_language_are_not_looked_up() -> None:
    """Say nothing of a prompt whose words the tables do not know."""
    prompt = "Ein Hund läuft über die Straße und ein Auto steht auf dem Gehweg."
    assert lost(made(prompt, scene(("dog", "road", "car")), goes("dog_1"))) == {}


@pytest.mark.parametrize(
    ("label", "noun"),
    [("tin buckets of water", "bucket"), ("two people", "person"), ("leaves", "leaf"), ("", "")],
)
def test_the_head_of_a_label(label: str, noun: str) -> None:
    assert head(label) == noun


def test_equal_things_are_found_by_their_noun() -> None:
    """Warn of no object whose plural is irregular."""
    doc = made("Several children walk.", scene(("child",)), goes("child_1"))
    assert doc.coverage.warnings == ()


ARRIVES: Json = {"id": "e1", "event": "Reach", "participants": ["dog_1", "car_1"]}


@pytest.mark.parametrize(
    ("words", "says_so", "event"),
    [
        ("to the back of the car", "behind", NodeEvent.TRIGGER),
        ("to the left of the car", "left_of", NodeEvent.TRIGGER),
        ("to the car", "ends_near", NodeEvent.REACH),
    ],
)
def test_going_to_a_side_is_no_arrival(words: str, says_so: str, event: NodeEvent) -> None:
    """Let who goes to the back of a car end behind it without having reached it."""
    told = says(says_so, words, "dog_1", "car_1", when="end")
    doc = made(f"A dog walks {words}.", scene(("dog", "car")),
               goes("dog_1", [told], to=ARRIVES, target="car_1"))  # fmt: skip
    assert doc.timeline_system is not None
    graph = doc.timeline_system.sequence_graph
    assert graph.nodes[1].event is event
    assert (graph.edges[0].target is None) is (event is NodeEvent.TRIGGER)


def test_a_label_is_the_name_of_the_whole() -> None:
    """Call a rock by its name where the model has it by its surface, and no leg a table."""
    things = scene(("rough rock surface/rock", "table leg/table_leg"), dynamic=False)
    doc = made("A table leg lies on a rough rock surface.", things)
    labels = {n.label for n in doc.spatial_relation_graph.nodes.values() if n.mentioned}
    assert labels == {"rough rock", "table leg"}
