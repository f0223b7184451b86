"""Quantities: units, ranges, words, bounds, and what is no quantity."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
import pytest

from esg.draft import draft
from esg.draft.text.numerals import parse_number
from esg.draft.text.quantities import find_amounts


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("at 2m/s, then", "speed", 200.0),
        ("5~10m/s", "speed", (500.0, 1000.0)),
        ("36 km/h", "speed", 1000.0),
        ("between 2 and 3 m/s", "speed", (200.0, 300.0)),
        ("5 meters per second", "speed", 500.0),
        ("10 feet per second", "speed", 304.8),
        ("weigh 10kg", "mass", 10.0),
        ("a 10-kg ball", "mass", 10.0),
        ("forty kilograms", "mass", 40.0),
        ("1,500 kg", "mass", 1500.0),
        ("200 grams", "mass", 0.2),
        ("two tons", "mass", 2000.0),
        ("2~3 seconds", "time", (2.0, 3.0)),
        ("2 to 3 s", "time", (2.0, 3.0)),
        ("3±0.5 s", "time", (2.5, 3.5)),
        ("half a second later", "time", 0.5),
        ("one and a half seconds", "time", 1.5),
        ("after a second, it", "time", 1.0),
        ("250 ms", "time", 0.25),
        ("two minutes", "time", 120.0),
        ("1/2 m", "length", 50.0),
        ("12 in tall", "length", 30.48),
        ("10 feet", "length", 304.8),
        ("90-degree", "angle", 90.0),
        ("30°", "angle", 30.0),
        ("3 m/s^2", "acceleration", 300.0),
        ("2 m/s²", "acceleration", 200.0),
        ("3 meters per second squared", "acceleration", 300.0),
        ("-3 kg", "mass", -3.0),
    ],
)
def test_reads_quantity(text: str, dimension: str, value: object) -> None:
    """Gives the dimension and the value in document units."""
    amounts = find_amounts(text)
    assert [a.dimension for a in amounts] == [dimension]
    assert amounts[0].value == pytest.approx(value)


@pytest.mark.parametrize(
    "text", ["after a second car", "5 in the box", "two cars", "ball 3", "a kg"]
)
def test_leaves_other_numbers_alone(text: str) -> None:
    """Counts, ordinals, labels and articles are no quantities."""
    assert find_amounts(text) == []


def test_keeps_two_quantities_apart() -> None:
    """Different dimensions joined by "and" are no range."""
    assert [a.dimension for a in find_amounts("3 s and 5 kg")] == ["time", "mass"]


def test_one_sided_bounds() -> None:
    """ "at least" and "within" mark the side."""
    assert find_amounts("at least 3 s")[0].bound == "min"
    assert find_amounts("within 3 s")[0].bound == "max"


def test_spans_point_at_the_text() -> None:
    """The span of a quantity is its text; a lone "from" is left outside."""
    text = "dropped from 4 meters onto"
    amount = find_amounts(text)[0]
    assert text[amount.start : amount.end] == "4 meters"


@given(st.integers(0, 999))
def test_number_words_round_trip(n: int) -> None:
    """Every number below 1000 in words is read back."""
    ones = [
        "zero",
        "one",
        "two",
        "three",
        "four",
        "five",
        "six",
        "seven",
        "eight",
        "nine",
        "ten",
        "eleven",
        "twelve",
        "thirteen",
        "fourteen",
        "fifteen",
        "sixteen",
        "seventeen",
        "eighteen",
        "nineteen",
    ]
    tens = ["twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"]

    def below_100(k: int) -> str:
        if k < 20:
            return ones[k]
        return tens[k // 10 - 2] + (f"-{ones[k % 10]}" if k % 10 else "")

    words = below_100(n % 100) if n < 100 else f"{ones[n // 100]} hundred"
    if n >= 100 and n % 100:
        words += f" and {below_100(n % 100)}"
    assert parse_number(words) == n


@given(
    st.floats(0.01, 5000, allow_nan=False).map(lambda x: round(x, 2)),
    st.sampled_from(["kg", "m/s", "s", "m"]),
)
def test_digits_round_trip(x: float, unit: str) -> None:
    """A number with a unit is read back exactly."""
    factor = {"kg": 1.0, "m/s": 100.0, "s": 1.0, "m": 100.0}[unit]
    assert find_amounts(f"it has {x} {unit} now")[0].low == pytest.approx(x * factor)


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("a tonne and a half", "mass", 1500.0),
        ("two-and-a-half-metre drop", "length", 250.0),
        ("6'2\" tall", "length", 187.96),
        ("a fifth of a second", "time", 0.2),
        ("¾ of a second", "time", 0.75),
        ("zero point three seconds", "time", 0.3),
        ("at 0:05", "time", 5.0),
        ("4 m·s⁻¹", "speed", 400.0),
        ("9.8 m s^-2", "acceleration", 980.0),
        ("six metres every second", "speed", 600.0),
        ("12 kts", "speed", 617.3333),
        ("fifteen hundred kg", "mass", 1500.0),
        ("three pounds eight ounces", "mass", 1.5876),
        ("two hundredweight", "mass", 101.6047),
    ],
)
def test_quantities_as_people_spell_them(text: str, dimension: str, value: float) -> None:
    found = find_amounts(f"it {text}.")
    assert [a.dimension for a in found] == [dimension]
    assert found[0].low == pytest.approx(value, rel=1e-4)


@pytest.mark.parametrize("text", ["a 16:9 picture at 12:30", "two stones fall", "a 1:24 scale car"])
def test_what_only_looks_like_a_quantity(text: str) -> None:
    assert [a for a in find_amounts(text) if a.dimension in ("time", "mass")] == []


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [
        ("5 m ± 1/2 m", 450.0, 550.0),
        ("5 m plus or minus 1 1/2 m", 350.0, 650.0),
        ("5 m give or take ½ m", 450.0, 550.0),
        ("5 m +/- 1,5 m", 350.0, 650.0),
        ("5 m ± 10 percent", 450.0, 550.0),
    ],
)
def test_a_tolerance_is_a_number_like_any_other(text: str, low: float, high: float) -> None:
    (amount,) = find_amounts(f"The gap is {text} wide.")
    assert (amount.low, amount.high) == pytest.approx((low, high))


def test_a_unit_without_its_number_is_no_quantity() -> None:
    """The raised two of "m/s²" is a digit, and no number."""
    assert parse_number("²") is None
    doc = draft("A cart brakes at m/s² from 9 m/s and hits a wall.")
    assert doc.timeline_system is not None
