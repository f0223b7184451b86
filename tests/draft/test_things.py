"""A noun phrase becomes an object only where it names a thing; unknown things have a size."""

import pytest

from esg.draft import draft
from esg.draft.discourse.referents.likeness import unknown_noun
from esg.outcomes import UserError


def things(prompt: str) -> set[str]:
    """Ids, without numbers, of all that is drawn and was named."""
    nodes = draft(prompt).spatial_relation_graph.nodes
    named = (name for name, node in nodes.items() if node.mentioned and not node.is_structural)
    return {name.rstrip("0123456789").rstrip("_") for name in named}


@pytest.mark.parametrize(
    ("kind", "prompt", "expected"),
    [
        ("mark", "A hammer hits a plate and leaves a visible dent.", "hammer plate"),
        ("abstract", "Two cars collide, demonstrating the conservation of momentum.", "car"),
        ("abstract", "A child pushes a swing with a gentle rhythm.", "child swing"),
        ("event", "The interaction between the box and the ball moves the ball.", "box ball"),
        ("light", "The lighting is soft; a pear rolls along the table.", "pear table"),
        ("light", "A lighthouse beam sweeps over a boat.", "boat"),
        ("time", "A car stops at a bakery at twilight.", "car bakery"),
        ("filming", "A ball rolls down a ramp, shot with a static camera.", "ball ramp"),
        ("filming", "A crab walks towards the camera.", "crab"),
        ("filming", "A ball rolls out of the frame.", "ball"),
        ("filming", "The viewer can watch a box fall.", "box"),
        ("body", "A cat pushes a pen with its paw.", "cat pen"),
        ("body", "An elephant pushes a log with its trunk.", "elephant log"),
        ("body", "A man lifts a box with both hands.", "man box"),
        ("filming", "A box falls on the left side of the screen.", "box"),
        ("body", "A dog wags its tail and knocks a mug off a table.", "dog mug table"),
        ("fills", "An arrow hits a balloon filled with water.", "arrow balloon"),
        ("part", "A fork falls onto the rim of a glass.", "fork glass"),
        ("substance", "A pan is on a stove, steam rising into the air.", "pan stove"),
        ("substance", "Water drips from a faucet into a bucket.", "faucet bucket"),
        ("wisp", "A plane lands with a puff of smoke.", "plane"),
        ("fills", "A spoon falls into a bowl of batter.", "spoon bowl"),
        ("fills", "A ladle falls into a pot of stew.", "ladle pot"),
        ("pieces", "A hammer smashes a vase into pieces.", "hammer vase"),
        ("place", "A balloon rises over the valley.", "balloon"),
        ("place", "A lorry blocks the entrance of a tunnel.", "lorry tunnel"),
        ("owner", "A book falls onto a student's desk.", "book desk"),
        ("manner", "A crane lowers a crate step by step.", "crane crate"),
    ],
)
def test_what_is_no_thing_is_not_drawn(kind: str, prompt: str, expected: str) -> None:
    assert things(prompt) == set(expected.split()), kind


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("A can rolls off a table.", "can"),
        ("A ball hits a camera.", "camera"),
        ("A hand pushes a box.", "hand"),
        ("A lump of clay falls onto a table.", "lump"),
        ("10 kg of rice falls off a truck.", "rice"),
        ("Coal weighing 3 kg falls into a bin.", "coal"),
        ("A cork hits a bottle.", "cork"),
        ("A boat hits a mountain.", "mountain"),
        ("Coins roll along a table.", "coins"),
    ],
)
def test_what_is_a_thing_is_drawn(prompt: str, thing: str) -> None:
    assert thing in things(prompt) | {f"{n}s" for n in things(prompt)}


def test_prompt_of_no_thing_is_refused() -> None:
    with pytest.raises(UserError, match="names no object"):
        draft("Smoke rises.")


def test_domino_chain_is_dominoes() -> None:
    nodes = draft("A domino chain falls.").spatial_relation_graph.nodes
    assert sum(name.startswith("domino") for name in nodes) > 2


@pytest.mark.parametrize(
    ("noun", "longest_cm", "behaves"),
    [
        ("yo-yo", (4, 8), "toy"),
        ("feather", (10, 25), "book"),
        ("flashlight", (12, 25), "bottle"),
        ("typewriter", (30, 50), "generic"),
        ("outcrop", (20, 2000), "rock"),
        ("thumb", (5, 9), "generic"),
        ("comb", (10, 20), "generic"),
    ],
)
def test_unknown_noun_is_sized_and_behaves_like_what_is_above_it(
    noun: str, longest_cm: tuple[float, float], behaves: str
) -> None:
    found = unknown_noun(noun)
    assert longest_cm[0] <= max(found.dimensions_cm) <= longest_cm[1]
    assert (found.kind, found.name) == (behaves, noun)


def test_compound_is_looked_up_before_its_head() -> None:
    assert unknown_noun("feeder", ["red", "bird"]).like.startswith("bird house")


def test_light_thing_like_a_fixture_moves() -> None:
    assert "fixed" not in unknown_noun("tumbleweed").traits


def test_draft_says_what_a_thing_is_shaped_like_and_warns_of_boxes() -> None:
    coverage = draft("A yo-yo hits a zorple.").coverage
    assert coverage is not None
    notes = [item.note for item in coverage.items]
    assert "shaped and sized like: yo yo of 6 cm" in notes
    assert [w for w in coverage.warnings if "lexicon" in w] == [
        '"zorple" is not in the lexicon; a stand-in of 40 cm and 5 kg is used.'
    ]


@pytest.mark.parametrize(
    ("prompt", "drawn"),
    [
        ("12 december 2019: a car hits a wall.", ["car", "wall"]),
        ("A boat drifts in cambodia in the spring of 2017.", ["boat"]),
        ("A girl stands by some water.", ["girl", "water"]),
        ("A stone is thrown into a pile of hay.", ["hay", "stone"]),
        ("A horse shakes its mane.", ["horse"]),
    ],
)
def test_dates_places_and_heaps_are_no_things_of_a_number(prompt: str, drawn: list[str]) -> None:
    nodes = draft(prompt).spatial_relation_graph.nodes
    found = [i.rsplit("_", 1)[0] for i, n in nodes.items() if n.mentioned and not n.is_structural]
    assert sorted(found) == drawn
