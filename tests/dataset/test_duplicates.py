"""Near-duplicates: planted ones are found, others are not, whoever made them and in what order."""

from __future__ import annotations

from pathlib import Path
import random

import numpy as np
import pyarrow as pa
import pytest

from esg.dataset.duplicates import Way, duplicates_in, find_duplicates, marking, path_of
from esg.store.tables import arrow_schema, to_table, write_part

TIME = np.linspace(0.0, 2.0, 121)
HIT = "A red car driving at 7 m/s hits a wooden fence."


def replay(speed: float, angle: float = 0.0, at: tuple[float, float] = (0.0, 0.0)) -> np.ndarray:
    """A body that rolls to another at rest, which then rolls on; shape [121, 3, 3]."""
    hit = 4.0 / speed
    first = np.where(hit > TIME, speed * TIME, 4.0)
    second = np.where(hit > TIME, 4.2, 4.2 + 0.8 * speed * (TIME - hit))
    along = np.stack([first, second, np.full_like(TIME, 9.0)], axis=1)
    turned = np.stack([along * np.cos(angle), along * np.sin(angle), 0 * along], axis=-1)
    return turned + np.array([*at, 0.1])


def way(key: str, speed: float, angle: float = 0.0, at: tuple[float, float] = (0, 0)) -> Way:
    found = path_of(key, TIME, replay(speed, angle, at))
    assert found is not None
    return found


def test_a_way_does_not_know_where_it_is_or_which_way_it_faces() -> None:
    here, there = way("a", 3.0), way("b", 3.0, 1.1, (7.0, -20.0))
    assert here.points == pytest.approx(there.points, abs=1e-5)
    assert here.reach_m == pytest.approx(4.2 + 0.8 * 3.0 * (2.0 - 4.0 / 3.0))
    assert here.points.shape == (2, 24, 3)


def test_what_stands_has_no_way() -> None:
    assert path_of("a", TIME, np.zeros((121, 3, 3))) is None


def test_a_fall_is_turned_by_where_the_others_are() -> None:
    drop = np.zeros((121, 2, 3))
    drop[:, 0, 2] = 2.0 - 0.5 * TIME**2
    drop[:, 1, 0] = 3.0 + 0.5 * TIME
    turned = drop.copy()
    turned[..., 0], turned[..., 1] = drop[..., 1], drop[..., 0]
    one, other = path_of("a", TIME, drop), path_of("b", TIME, turned)
    assert one is not None and other is not None
    assert one.points == pytest.approx(other.points, abs=1e-5)


def planted() -> tuple[list[Way], dict[str, str], dict[str, str]]:
    ways = [
        way("k0", 3.0),
        way("k1", 3.0, 0.7, (5.0, 5.0)),  # a duplicate, turned and moved
        way("k2", 4.5),  # another speed
        way("k3", 3.0, 2.0),  # the same motion of other things
        way("k4", 3.02, -1.0),  # hardly faster: a duplicate
        way("k5", 3.0),  # the other side of a pair with k6
        way("k6", 3.0),
    ]
    prompts = dict.fromkeys([w.scene_key for w in ways], HIT)
    prompts["k3"] = "A basketball rolls off a table."
    for key in ("k5", "k6"):
        prompts[key] = "In a park, a soccer ball knocks over a vase."
    return ways, prompts, {"k5": "p", "k6": "p"}


def test_planted_duplicates_are_found_and_no_others() -> None:
    found = find_duplicates(*planted())
    assert [(d.scene_key, d.duplicate_of) for d in found] == [("k1", "k0"), ("k4", "k0")]
    assert found[0].path_distance < 1e-4 and found[0].text_cosine == 1.0
    assert 0 < found[1].path_distance <= 0.02


def test_the_order_they_come_in_makes_no_difference() -> None:
    ways, prompts, pairs = planted()
    shuffled = list(ways)
    random.Random(3).shuffle(shuffled)
    assert find_duplicates(shuffled, prompts, pairs) == find_duplicates(ways, prompts, pairs)


def test_without_a_pair_its_sides_are_duplicates() -> None:
    ways, prompts, _ = planted()
    found = {d.scene_key: d.duplicate_of for d in find_duplicates(ways, prompts, {})}
    assert found["k6"] == "k5"


def rows(ways: list[tuple[str, float]]) -> dict[str, list[dict[str, object]]]:
    base = {"run_id": "r", "suite": "", "seed": 0}
    return {
        "scenes": [
            {**base, "scene_key": k, "scene_id": k, "prompt": HIT, "split": "train"}
            for k, _ in ways
        ],
        "trajectories": [
            {
                **base, "scene_key": k, "scene_id": k, "engine": "physx", "bodies": ["a", "b", "c"],
                "n_frames": len(TIME), "fps": 60.0, "time_s": TIME.tolist(),
                "position_m": replay(speed).ravel().tolist(),
            }
            for k, speed in ways
        ],
    }  # fmt: skip


@pytest.mark.parametrize("cut", [1, 3, 5])
def test_parts_may_be_cut_anywhere(tmp_path: Path, cut: int) -> None:
    ways = [("k0", 3.0), ("k1", 4.0), ("k2", 3.0), ("k3", 5.0), ("k4", 4.0), ("k5", 6.0)]
    for number, some in enumerate((ways[:cut], ways[cut:])):
        for table, found in rows(some).items():
            write_part(to_table(table, found), tmp_path / table / f"batch-{number}.parquet")
    found = duplicates_in(tmp_path)
    assert [(d.scene_key, d.duplicate_of) for d in found] == [("k2", "k0"), ("k4", "k1")]
    data = marking(found)("scenes", to_table("scenes", rows(ways)["scenes"]))
    assert data.schema.equals(arrow_schema("scenes"))
    assert data["duplicate_of"].to_pylist() == [None, None, "k0", None, "k1", None]
    other = pa.table({"x": [1]})
    assert marking(found)("metrics", other) is other
