"""What a drawing closure depends on, and parts that are not drawn twice."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from esg.assets.geometry import shapes
from esg.assets.geometry.closures import key_of
from esg.assets.geometry.finishing import Drawing, finished

_drawn: list[float] = []


def _ball(radius: float) -> Any:
    _drawn.append(radius)
    return shapes.ball(radius, (0.0, 0.0, 0.0), (1, 1, 1), 1)


def _drawing(radius: Any, *more: Any) -> Callable[[], Any]:
    return lambda: (_ball(radius), more)[0]


@pytest.mark.parametrize(
    "value", [1, 2.5, "x", None, (1, [2.0, "y"]), {"a": 1}, np.arange(3.0), np.float32(1.5), max]
)
def test_equal_values_have_one_key(value: Any) -> None:
    """Closures that enclose equal values draw the same."""
    again = value.copy() if isinstance(value, np.ndarray) else value
    assert key_of(_drawing(value)) == key_of(_drawing(again)) is not None


def test_other_values_and_other_code_have_other_keys() -> None:
    """Nothing that draws otherwise is taken for the same: numbers of other kind or sign, arrays."""
    values: list[Any] = [1, 1.0, True, 0.0, -0.0, (1, 2), [1, 2], (1, (2,)), "1",
                         (1.0, 2), (True, 2), ("1", 2), ("1, 2",), (-0.0,), (0.0,), (None,), ("None",),
                         np.zeros(2), np.zeros(2, np.float32), np.zeros((2, 1)), {1: 2}]  # fmt: skip
    keys = [key_of(_drawing(value)) for value in values]
    keys += [key_of(lambda: _ball(1.0)), key_of(lambda: _ball(2.0))]
    assert None not in keys and len(set(keys)) == len(keys)


def test_what_cannot_be_compared_has_no_key() -> None:
    """An object of unknown content, and one that encloses itself, have to be drawn."""
    circle: list[Any] = []
    circle.append(circle)
    assert key_of(_drawing(object())) is None and key_of(_drawing(circle)) is None


def test_a_list_is_told_by_what_it_holds_now() -> None:
    """Builders go on filling lists that closures enclose."""
    points = [1.0]
    make = _drawing(1.0, points)
    before = key_of(make)
    points.append(2.0)
    assert key_of(make) != before


def test_an_equal_part_is_not_drawn_again() -> None:
    """Of equal closures one is called; both have its surface."""
    _drawn.clear()
    one, two, other = (Drawing(_drawing(radius)) for radius in (3.25, 3.25, 3.5))
    first, second = finished(one, 10.0), finished(two, 10.0)
    assert _drawn == [3.25, 3.5]
    assert second is first and finished(other, 10.0) is not first
    assert one.outline.extent_cm == pytest.approx(6.5)
