"""The second reading of a prompt: what its parse says and the draft does not hold."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from esg.draft import draft
from esg.draft.audit import checks, owned_up
from esg.draft.audit.checks import CHECKS
from esg.draft.audit.parse import propositions
from esg.draft.text import tagging
from esg.draft.text.tagging import parsed
from esg.graph.models import EsgDocument, Predicate

_SUITES = Path(__file__).resolve().parents[2] / "data" / "suites"
_CASES = {
    checks.NOT_ALL: (
        ("A snooker ball hits two red balls, and one of them rolls into the side pocket.", "hits"),
        ("The curling stone hits two other stones and comes to a stop.", "hits"),
        ("Wheels spinning, a car stuck in the mud is pushed out by two men.", "pushed"),
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
        ("Tilting a wooden board with a pencil on it until the pencil slides off.", "the pencil"),
        (
            "A colorful rubber ball is dropped from a height, showing the bounce of the ball as it"
            " makes contact with the hard floor.",
            "the ball",
        ),
        ("A kitten pushes a ball of yarn, and the yarn rolls against a basket.", "the yarn"),
    ),
    checks.LOOSE: (
        ("A jogger with a dog on a leash overtakes a couple pushing a pram.", "a leash"),
        ("A helicopter above a lake lowers a bucket on a rope into the water.", "a rope"),
        ("A jogger with a dog on a leash runs past a bench. The dog sees a squirrel.", "a leash"),
    ),
    checks.STAYS: (
        (
            "An elderly man in a wheelchair being pushed along a pier by a nurse, seagulls overhead.",
            "pushed",
        ),
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
    ),
    checks.NO_SUCH: (
        ("A crate of 20 kg is dragged 5 m across a rough floor by a horizontal rope.", "dragged"),
        (
            "A 500 g cart on a low-friction track is pulled by a string over a pulley attached to"
            " a hanging 100 g mass.",
            "pulled",
        ),
        ("The lowest of three stacked boxes is pulled out by a robot.", "pulled"),
    ),
}
"""Three cases of independent origin for each question (the tables' rows have their own)."""


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


@pytest.mark.parametrize("row", [*checks.doubts().items()], ids=lambda row: row[0])
def test_doubts_a_noun_of_two_senses(row: tuple[str, checks.Doubt]) -> None:
    """Own up where another sense is meant, by the row's example."""
    noun, doubt = row
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


def test_registers_a_question_once() -> None:
    """Ask every question by a name of its own."""
    assert len(set(CHECKS.values())) == len(CHECKS)
