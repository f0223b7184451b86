"""Gestures as poses: hands, heads and tails are where they are told."""

from __future__ import annotations

import numpy as np
import pytest

from esg.assets.appearance import Appearance
from esg.assets.builders.living.poses import POSES, pose_of, skeleton
from esg.assets.library.catalogue import build_sketch, entries_by_name
from esg.lexicon.gestures import EASES, NONE, SWEEPS, gestures, posed, states_at

REST, FAR = (EASES, 0), (EASES, SWEEPS)


def _wrists(gesture: str, state: tuple[int, int]) -> np.ndarray:
    arms = skeleton(pose_of(posed("stand", gesture, state))).arms
    return np.array([arm[2] for arm in arms])


def test_no_gesture_is_the_pose_itself() -> None:
    assert posed("stand", "waves", NONE) == "stand"
    assert pose_of("stand") is POSES["stand"]


def test_who_waves_has_one_hand_beside_his_head() -> None:
    left, right = _wrists("waves", REST)
    assert right[2] > 140.0 > 100.0 > left[2]
    assert np.linalg.norm(_wrists("waves", FAR)[1] - right) > 15.0


def test_hands_meet_that_clap() -> None:
    left, right = _wrists("claps", FAR)
    far = _wrists("claps", REST)
    assert abs(left[1] - right[1]) < 20.0 < far[0, 1] - far[1, 1]
    assert left[0] > 20.0


@pytest.mark.parametrize("gesture", ["raises a hand", "raises both arms"])
def test_raised_hands_are_over_the_head(gesture: str) -> None:
    left, right = _wrists(gesture, REST)
    assert right[2] > 172.0
    assert bool(left[2] > 172.0) is (gesture == "raises both arms")


def test_a_head_turns_that_is_shaken() -> None:
    nose = np.array([[10.0, 0.0, 158.0]])
    left, right = (
        skeleton(pose_of(posed("stand", "shakes the head", state))).head(nose)[0, 1]
        for state in (FAR, REST)
    )
    assert left > 4.0
    assert right < -4.0


@pytest.mark.parametrize(
    ("gesture", "part"), [("grazes", "nose"), ("wags the tail", "tail"), ("nods", "nose")]
)
def test_animals_move_head_and_tail_and_nothing_else(gesture: str, part: str) -> None:
    entry = entries_by_name()["dog" if part == "tail" else "horse"]

    def drawn(state: tuple[int, int]) -> dict[str, np.ndarray]:
        look = Appearance(pose=posed("", gesture, state))
        parts = build_sketch(entry, entry.dimensions_cm, entry.color_rgb, look).parts
        return {p.name: np.asarray(p.mesh().vertices) for p in parts}

    rest, far, none = drawn(REST), drawn(FAR), drawn(NONE)
    assert np.abs(far[part] - rest[part]).max() > 5.0
    assert np.allclose(rest["body"], none["body"])
    assert np.allclose(rest["leg_front_left"], none["leg_front_left"])
    if gesture == "grazes":
        assert rest["nose"][:, 2].min() < 0.3 * none["nose"][:, 2].min()


def test_states_ease_in_sweep_and_end() -> None:
    row = gestures()["nods", "people"]
    since = np.linspace(-1.0, row.lasts_s + 1.0, 400)
    states = states_at(row.period_s, row.times, since)
    assert not states[since < 0.0].any()
    assert not states[since > row.lasts_s].any()
    ways = np.sign(np.diff(states[:, 1]))
    assert np.count_nonzero(np.diff(ways[ways != 0])) == 2 * row.times - 1
