"""The second reading of a prompt: what its parse says and the draft does not hold."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from benchmarks import second_reading
from esg.draft import draft
from esg.draft.audit import checks, courses, owned_up, things
from esg.draft.audit.checks import CHECKS
from esg.draft.audit.parse import propositions
from esg.draft.text import tagging
from esg.draft.text.tagging import parsed
from esg.graph.models import EsgDocument, Predicate

_SUITES = Path(__file__).resolve().parents[2] / "data" / "suites"
_ALONE = (
    "A horse pulls a cart. A wheel of the cart hits a rock and the cart overturns.",
    "The waiter carries a tray past two tables, then slips, and the tray lands on the third table.",
    "A grandfather clock leans against the wall. A boy on roller skates bumps it, and it falls on the carpet.",
    "A red ball at rest is struck by a blue ball moving at 3 m/s.",
    "Three shopping trolleys stand in a row. A boy shoves the last one. It runs into the one in front of it,"
    " which hits the first, and the first rolls away.",
    "A yellow cube sits on the left of a purple cylinder, and a ball rolls between them.",
    "The cue ball hits the cushion first. Afterwards it hits the yellow ball.",
    "A cube slides into two others, and only two cubes roll.",
    "A pumpkin is placed on a wall. An arrow hits it after 0.5 seconds, and it falls behind the wall.",
    "A tennis ball is released above a wooden table and bounces twice.",
)
"""What a question would find if it took the parse at its word."""
_CASES = {
    checks.NOT_ALL: (
        ("A snooker ball hits two red balls, and one of them rolls into the side pocket.", "hits"),
        ("The curling stone hits two other stones and comes to a stop.", "hits"),
        ("A red bowling ball rolls down the lane and knocks over all ten pins.", "all ten pins"),
        ("A bowling ball hits the head pin, and all the pins fall.", "all the pins"),
        ("The ball knocks down all the pins.", "all the pins"),
        ("A skater slides into ten bowling pins and all of the pins topple.", "all of the pins"),
    ),
    checks.ONE_OF_EACH: (
        ("A postman cycles past a row of houses and tosses a newspaper onto each porch.", "each"),
        ("Nobody steers the raft, yet it misses every rock.", "every rock"),
        ("Every chair around the table is pushed in except one.", "Every chair"),
    ),
    checks.ONE_WAY: (
        ("Two boys on a seesaw go up and down.", "up and down"),
        (
            "The mower goes up and down the lawn: it turns left at the hedge, comes back, turns right"
            " at the path and finally bumps into a gnome.",
            "up and down",
        ),
    ),
    checks.IN_PART: (
        ("Marbles pour out of a jar, and all but one roll under the sofa.", "all but"),
        ("All cars stop except a taxi, and the ambulance rams the taxi.", "except"),
        ("A magnet is passed over paper clips and half of them jump up to it.", "half of them"),
    ),
    checks.SAME: (
        ("A tennis ball hits the ball.", "the ball"),
        ("A kitten pushes a ball of yarn, and the yarn rolls against a basket.", "the yarn"),
    ),
    checks.LOOSE: (
        ("A jogger with a dog on a leash overtakes a couple pushing a pram.", "a leash"),
        ("A helicopter above a lake lowers a bucket on a rope into the water.", "a rope"),
        ("A jogger with a dog on a leash runs past a bench. The dog sees a squirrel.", "a leash"),
    ),
    checks.STAYS: (
        ("A toddler pushes a toy lorry along a wooden bench until it drops off the end.", "pushes"),
        ("A red toy mower is pushed across the grass by a toddler.", "is pushed"),
    ),
    checks.NOTHING: (
        ("A crowded escalator carries shoppers up.", "up"),
        ("The bus pulls out and hits a cyclist.", "out"),
        ("When the gate opens, four greyhounds run out.", "out"),
        ("A gymnast swings from a bar, lets go and lands on a mat on both feet.", "lets go"),
        ("A man pushes a wheelbarrow, the man lets go, and the wheelbarrow topples.", "lets go"),
        ("Mia put her ball at the top of the slide and let go. It rolled down.", "and let go"),
        ("The train came in, stopped, waited a while and left.", "waited a while"),
        (
            "A wooden ball on a long string is swinging back and forth. Each swing is a little smaller than"
            " the one before, until it finally hangs still.",
            "until it finally hangs still",
        ),
    ),
    checks.NO_SUCH: (
        ("A crate of 20 kg is dragged 5 m across a rough floor by a horizontal rope.", "dragged"),
        (
            "A 500 g cart on a low-friction track is pulled by a string over a pulley attached to"
            " a hanging 100 g mass.",
            "pulled",
        ),
    ),
    things.TWO_NAMES: (
        (
            "A rapid-fire shootout in a crowded hospital emergency ward, with medical staff and patients"
            " caught in the crossfire as rival gangs clash amidst stretchers and medical equipment.",
            "patients",
        ),
    ),
    things.ONE_TOO_MANY: (
        (
            "Four toy tractors drive one behind another from right to left; the second is the biggest.",
            "the second",
        ),
        (
            "Two children run toward the same swing. The girl gets there first; the boy stops in front of"
            " her.",
            "The girl",
        ),
        ("Two dogs run across a lawn. The puppy stops at a bench.", "The puppy"),
    ),
    things.IN_ITS_PART: (
        ("put the bottle in the drawer of the printer", "drawer of the printer"),
        (
            "The bricklayer drops a brick from the scaffold; it hits the wheelbarrow of the apprentice.",
            "wheelbarrow of the apprentice",
        ),
    ),
    things.BESIDE_ITS_WHOLE: (
        ("A bus stops and its doors open.", "its doors"),
        ("The van's door flies open.", "The van's door"),
        (
            "A limousine stops at the red carpet. The door opens and hits a photographer.",
            "The door",
        ),
    ),
    things.TWO_PLACES: (
        (
            "A broom stands propped against a kitchen shelf with a row of jars on it. The shelf is nudged,"
            " the broom slides sideways along it and clatters onto the tile floor.",
            "A broom",
        ),
    ),
    things.NO_PLACE: (
        (
            "An apple falls onto one side of a seesaw, causing the pear on the other side to fly up.",
            "on the other side",
        ),
    ),
    things.NO_PART: (
        (
            "First the robot set the red cube on the blue cube, and then the green cube on the red one. As"
            " it drove away, it bumped into the table leg and the tower fell.",
            "the green cube",
        ),
    ),
    things.OTHER_NUMBER: (
        (
            "Ten dominoes stand on a table in a straight line with a wide gap after the sixth, so that only"
            " six of them fall when the first is pushed.",
            "only six",
        ),
        (
            "Eight dominoes stand in a row, and only five of them fall when the first is pushed.",
            "only five",
        ),
        ("A ball rolls into a row of six dominoes, and only three of them fall.", "only three"),
    ),
    things.TOO_BIG: (
        ("With 30 mph on the clock, the van goes into the back of a lorry.", "the van"),
        (
            "In a living room there are a sofa, two armchairs, a coffee table, a floor lamp, a bookshelf, a"
            " plant, a rug, a television on a cabinet, a guitar and a dog. The dog runs into the floor lamp"
            " and the lamp falls onto the coffee table.",
            "a rug",
        ),
    ),
    things.A_VERB: (
        (
            "A tall lamp stands between two short stools, and a cat sleeps under the left one.",
            "A tall lamp stands",
        ),
    ),
    things.A_PERSON: (
        (
            "The shot-putter pushes the shot at 12 m/s. It flies over the line and hits the board.",
            "It",
        ),
        ("A taxi driver opens his door and a cyclist rides into it.", "it"),
        (
            "Smith drives it low to the keeper's left, it comes back off the post and Jones taps it in.",
            "it",
        ),
    ),
    courses.OF_ANOTHER: (
        (
            "What knocked the lamp over was a football that had come in through the window.",
            "through the window",
        ),
        (
            "Nobody is holding the suitcase standing in the aisle of the bus, so when the driver brakes it"
            " rolls forward and hits a seat post.",
            "forward",
        ),
        (
            "A wheelbarrow full of bricks is tipped forward by its handles until they all slide out onto the"
            " grass.",
            "slide",
        ),
    ),
    courses.GOES_NO_FURTHER: (
        (
            "A red metal sphere enters from the left and strikes a resting blue rubber cube, which slides a"
            " short way and stops. The sphere rolls on slowly and leaves the picture at the bottom.",
            "rolls",
        ),
        (
            "A black hockey puck slides over smooth ice, hits the boards at an angle and slides away.",
            "slides",
        ),
    ),
    courses.NOT_COUNTED: (
        (
            "The weightlifter drops the barbell. It bounces once, rolls off the platform and hits the judge's"
            " table.",
            "once",
        ),
        ("A ball falls from a balcony, bounces once and hits a bicycle.", "once"),
        ("A basketball hits the rim, bounces up once and drops through the hoop.", "once"),
    ),
    courses.HITS_NOTHING: (
        ("The drone rises to 5 m, flies forward, hits a power line and drops onto a car.", "hits"),
        (
            "A tugboat pushes a barge along the quay. The barge scrapes a pile, swings to the left and rams a"
            " moored yacht. The tugboat stops.",
            "scrapes",
        ),
        ("A child on a sled slides down a hill, hits a bump, and crashes into a snowman.", "hits"),
    ),
    courses.NO_RACE: (
        (
            "A metal sphere and a wooden cube go down the same ramp, and the sphere gets to the bottom first.",
            "first",
        ),
    ),
    courses.SOME_OF_THEM: (
        ("A broom falls across two chairs.", "chairs"),
        ("Three balls roll down three lanes and each ball hits a pin.", "lanes"),
        ("A woman puts a plate in front of each of the three guests.", "guests"),
        (
            "Three camels walk in single file. The one in front stops, the one in the middle walks into it,"
            " and the last one goes around both.",
            "both",
        ),
        (
            "The small cylinder sits on the large cylinder, and a cone leans against both.",
            "both",
        ),
        (
            "A red cube and a blue cube lie on a table, and a stick leans against both of them.",
            "both of them",
        ),
    ),
    courses.ANOTHER_WAY: (
        (
            "A golf ball is putted too hard, runs over the hole and hits the flag lying behind it.",
            "over the hole",
        ),
        (
            "A toaster of 1.5 kg is pushed 20 cm across the counter until it touches the bread bin.",
            "across the counter",
        ),
        (
            "I need a warehouse scene: a robot cart carrying a barrel goes around two shelves and stops in"
            " front of the roller door. The barrel must not fall off.",
            "around two shelves",
        ),
    ),
}
"""Cases of independent origin for each question (the tables' rows have their own)."""


def _said(doc: EsgDocument) -> list[tuple[str, str]]:
    lost = [s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    return [(s.note, s.text) for s in lost]


@pytest.mark.parametrize(
    ("note", "prompt", "words"),
    [(n, p, w) for n, cases in _CASES.items() for p, w in cases],
)
def test_owns_up_to_what_only_the_parse_sees(note: str, prompt: str, words: str) -> None:
    """Name the words and what is missing."""
    found = [text for said, text in _said(draft(prompt)) if said == note]
    assert any(text.startswith(words) for text in found), _said(draft(prompt))


@pytest.mark.parametrize("prompt", _ALONE)
def test_leaves_alone_what_only_the_parse_gets_wrong(prompt: str) -> None:
    """Say nothing of parts, third ones, who stands on skates, verbs with a subject beside them."""
    asked = {n for n in _CASES if n in vars(things).values() or n in vars(courses).values()}
    assert len(asked) == len(things.CHECKS) + len(courses.CHECKS)
    assert not [x for x in _said(draft(prompt)) if x[0] in asked]


@pytest.mark.parametrize("row", [*checks.doubts().items()], ids=lambda row: "-".join(row[0]))
def test_doubts_a_noun_of_two_senses(row: tuple[tuple[str, str], checks.Doubt]) -> None:
    """Own up where another sense is meant, by the row's example."""
    (noun, _), doubt = row
    notes = [note for note, _ in _said(draft(doubt.example))]
    drawn = draft(doubt.example).asset_requirement.values()
    if any(a.asset_category == doubt.drawn for a in drawn):
        assert any(doubt.meant in note for note in notes), (noun, notes)
    plain = _said(draft(f"A {noun} lies on a table."))
    assert not any(doubt.meant in note for note, _ in plain)


@pytest.mark.parametrize("suite", ["paper", "breadth"])
def test_finds_nothing_where_both_readings_agree(
    suite: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Leave drafts alone that show what their suite asks for."""
    text = (_SUITES / f"{suite}.yaml").read_text(encoding="utf-8")
    for scene in yaml.safe_load(text)["scenes"]:
        with_audit = _said(draft(scene["prompt"]))
        with monkeypatch.context() as without:
            without.setattr("esg.draft.rules.owned_up", lambda *_: ())
            assert _said(draft(scene["prompt"])) == with_audit


def test_says_the_same_twice_and_numbers_on() -> None:
    """Give new statements ids of their own, in the order of the text."""
    prompt = "A postman cycles past a row of houses and tosses a newspaper onto each porch."
    first, again = draft(prompt), draft(prompt)
    assert first == again
    said = first.statements or ()
    assert len({s.id for s in said}) == len(said)
    assert [s.start for s in said] == sorted(s.start for s in said)
    assert all(prompt[s.start : s.end] == s.text for s in said)


def test_finds_the_words_in_marked_up_text() -> None:
    """Place what is found where it was typed."""
    prompt = "A steep <b>escalator</b> carries shoppers <i>up</i>."
    found = [s for s in draft(prompt).statements or () if s.note == checks.NOTHING]
    assert [prompt[s.start : s.end] for s in found] == ["up"]


def test_is_absent_without_a_parser(monkeypatch: pytest.MonkeyPatch) -> None:
    """Draft as before where no model is installed, and say so in the provenance."""
    prompt = "A postman cycles past a row of houses and tosses a newspaper onto each porch."
    monkeypatch.setattr(tagging, "_spacy_model", lambda: None)
    doc = draft(prompt)
    assert parsed(prompt) is None
    assert owned_up(prompt, doc, doc.coverage, doc.statements) == ()
    assert doc.provenance[0].config["audit"] == "absent"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("A cup is pushed by a cat.", ("pushed", ["cup"], [], ["cat"])),
        ("A ball hits a box, which slides away.", ("slides", ["box"], [], [])),
        ("A magnet lifted by a crane drops a car.", ("lifted", ["magnet"], [], ["crane"])),
        ("A dog and a cat chase a mouse.", ("chase", ["dog", "cat"], ["mouse"], [])),
        ("A man kicks a ball and it bounces.", ("bounces", ["it"], [], [])),
    ],
)
def test_reads_who_does_what_to_whom(
    text: str, told: tuple[str, list[str], list[str], list[str]]
) -> None:
    """Find subjects of passives, relatives, participles and coordinated verbs."""
    found = {p.word: p for p in propositions(parsed(text))}
    p = found[told[0]]
    assert [a.word for a in p.subjects] == told[1]
    assert [a.word for a in p.objects] == told[2]
    assert [a.word for a in p.agents] == told[3]


def test_counts_what_a_question_finds_by_verdict(capsys: pytest.CaptureFixture[str]) -> None:
    """List each finding once, and captions by their newest verdict."""
    told = (
        "First the robot set the red cube on the blue cube, and then the green cube on the red one."
    )
    found = second_reading.ask(f"{told} As it drove away, it bumped into the table leg.", "other")
    assert [(f.question, f.words) for f in found] == [("no part", "the green cube")]
    verdicts = dict(second_reading.captions(["read11.tsv"])).values()
    assert len(verdicts) == 48 and set(verdicts) == set(second_reading.CLASSES)
    with pytest.raises(SystemExit):
        second_reading.main(["--show", "no such question"])
    assert "invalid choice" in capsys.readouterr().err


def test_registers_a_question_once() -> None:
    """Ask every question by a name of its own."""
    assert len(set(CHECKS.values())) == len(CHECKS)
