"""Rows of wording: every one makes its own example; articles, numbers, verbs, names."""

from __future__ import annotations

import csv
from pathlib import Path
import re

import pytest

from esg.dataset.annotations import wording
from esg.dataset.annotations.nouns import Nouns, listed, noun_of, number, with_article
from esg.dataset.annotations.wording import (
    Chooser,
    Row,
    agreeing,
    metres,
    rows,
    sentence,
    third,
    three_digits,
)
from esg.engines.scene import SimScene
from tests.metrics.worlds import ball, body

TABLES = ("clauses", "questions", "supposed")
ROWS = [(table, row) for table in TABLES for found in rows(table).values() for row in found]


def made_by(row: Row, example: str) -> bool:
    """Whether a row can make a sentence, whatever fills its gaps."""
    for plural in (False, True):
        pattern = re.escape(
            agreeing(row.template.replace("{manner}", "[drive] along"), plural=plural)
        )
        pattern = re.sub(r"\\\{\w+\\\}", ".+", pattern)
        if re.fullmatch(pattern + r"\.?", example, re.IGNORECASE):
            return True
    return False


@pytest.mark.parametrize(("table", "row"), ROWS, ids=[f"{t}: {r.example}" for t, r in ROWS])
def test_every_row_makes_its_example(table: str, row: Row) -> None:
    assert made_by(row, row.example)
    assert not re.search(r"[{}\[\]]", row.example)


def test_every_manner_makes_its_example() -> None:
    with open(Path(wording.__file__).parent / "manners.csv", encoding="utf-8") as file:
        found = list(csv.DictReader(file))
    for row in found:
        assert f" {third(row['verb'].strip('[]'))}" in row["example"]
        assert wording.verb_of(row["manner"], row["category"]) == row["verb"]
    assert wording.verb_of("drive", "hovercraft") == "[drive]"


@pytest.mark.parametrize(
    ("noun", "phrase"),
    [
        ("car", "a car"), ("apple", "an apple"), ("hourglass", "an hourglass"),
        ("unicycle", "a unicycle"), ("umbrella", "an umbrella"), ("one-legged stool",
        "a one-legged stool"), ("egg", "an egg"), ("SUV", "a SUV"), ("open box", "an open box"),
    ],
)  # fmt: skip
def test_articles_follow_the_sound(noun: str, phrase: str) -> None:
    assert with_article(noun) == phrase


@pytest.mark.parametrize(
    ("verb", "form"),
    [("hit", "hits"), ("pass", "passes"), ("carry", "carries"), ("be", "is"), ("go", "goes"),
     ("brake", "brakes"), ("stay", "stays"), ("reach", "reaches")],
)  # fmt: skip
def test_third_person(verb: str, form: str) -> None:
    assert third(verb) == form
    assert agreeing(f"x [{verb}]", plural=True) == ("x are" if verb == "be" else f"x {verb}")


def test_numbers_lists_and_measures() -> None:
    assert (number(0), number(12), number(13)) == ("no", "twelve", "13")
    assert listed(["a"]) == "a" and listed(["a", "b", "c"]) == "a, b and c"
    assert [metres(v) for v in (0.004, 0.35, 2.44, 31.2)] == ["1 cm", "35 cm", "2.4 m", "31 m"]
    assert [three_digits(v) for v in (12814.5, 1.7527, 91.88, 0.863)] == [
        "12800", "1.75", "91.9", "0.863"
    ]  # fmt: skip
    assert sentence("a  car stops") == "A car stops."


@pytest.mark.parametrize(
    ("label", "name", "group", "noun"),
    [
        ("red ball", "red_ball_1", "", "red ball"),
        ("10 kg wooden crate", "wooden_crate_1", "", "wooden crate"),
        ("the 2.5 m pole", "pole_1", "", "pole"),
        ("car behind it", "rear_car_1", "", "rear car"),
        ("another suitcase", "suitcase_2", "", "suitcase"),
        ("row of dominos", "domino_3", "dominos", "domino"),
        ("bowling pins", "bowling_pin_1", "bowling_pins", "bowling pin"),
        ("glass of water", "glass_1", "", "glass of water"),
        ("", "tall_lamp_2", "", "tall lamp"),
    ],
)
def test_bodies_are_called_what_explains_itself(
    label: str, name: str, group: str, noun: str
) -> None:
    assert noun_of(body(name, label=label, group=group)) == noun


def test_several_of_one_name_are_told_as_such() -> None:
    pins = [body(f"pin_{k}", label="pin", group="pins") for k in (1, 2, 3)]
    two = [body("box_1", label="box"), body("box_2", label="box")]
    balls = [ball("ball_1", label="ball"), ball("red_ball_1", label="red ball")]
    nouns = Nouns(SimScene("s", (*pins, *two, *balls, body("stairs_1", label="stairs"))))
    assert nouns.the("pin_2") == "one of the three pins" and nouns.a("box_1") == "one of two boxes"
    assert nouns.share("pin_1", 2) == "two of the three pins"
    assert nouns.share("pin_1", 3) == "all three pins" and nouns.share("box_1", 2) == "both boxes"
    assert nouns.clear("red_ball_1") and not nouns.clear("ball_1") and not nouns.clear("pin_1")
    assert nouns.is_plural("stairs_1") and nouns.a("stairs_1") == "stairs"
    assert nouns.inventory(["pin_1", "pin_2", "pin_3", "red_ball_1"]) == [
        "three pins",
        "a red ball",
    ]


def test_what_has_a_letter_for_a_name_has_no_article() -> None:
    nouns = Nouns(SimScene("s", (ball("ball_1", label="ball A"), ball("ball_2", label="car 2"))))
    assert nouns.the("ball_1") == nouns.a("ball_1") == "ball A" and nouns.the("ball_2") == "car 2"


def test_choices_depend_on_nothing_but_the_seed() -> None:
    one, two, other = (Chooser(s) for s in ("a", "a", "b"))
    drawn = [[c.below(100) for _ in range(8)] for c in (one, two, other)]
    assert drawn[0] == drawn[1] != drawn[2]
    assert sorted(Chooser("a").shuffled([1, 2, 3])) == [1, 2, 3]
