from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from esg.compile import frames
from esg.units import quat_rotate, quat_rotated

finite = st.floats(-1e4, 1e4)
vector = st.tuples(finite, finite, finite)
seeds = st.integers(0, 2**31)


@given(vector)
def test_round_trip_of_vectors(v: tuple[float, float, float]) -> None:
    back = frames.vector_from_unreal(frames.vector_to_unreal(v))
    np.testing.assert_allclose(back, v, rtol=1e-12, atol=1e-12)
    back = frames.angular_from_unreal(frames.angular_to_unreal(v))
    np.testing.assert_allclose(back, v, rtol=1e-12, atol=1e-12)


@given(seeds, vector)
def test_mirrored_rotation_turns_mirrored_vectors(seed: int, v: tuple[float, ...]) -> None:
    q = Rotation.random(rng=np.random.default_rng(seed)).as_quat()
    here = frames.vector_to_unreal(quat_rotate(q, v))
    there = quat_rotate(frames.quaternion_to_unreal(q), frames.vector_to_unreal(v))
    np.testing.assert_allclose(there, here, rtol=1e-9, atol=1e-6)


def same(numbers: tuple[float, ...], array: np.ndarray) -> bool:
    """To the last bit, the sign of zero included."""
    return np.array(numbers).tobytes() == array.tobytes()


@given(seeds, vector)
def test_numbers_one_by_one_are_those_of_arrays_to_the_last_bit(seed: int, v: tuple) -> None:
    q = tuple(Rotation.random(rng=np.random.default_rng(seed)).as_quat().tolist())
    single = np.array(v, np.float32)
    for value in (v, single):
        assert same(frames.vector_numbers(value), frames.vector_to_unreal(value))
        assert same(frames.angular_numbers(value), frames.angular_to_unreal(value))
        assert same(quat_rotated(q, value), quat_rotate(q, value))
    assert same(frames.quaternion_numbers(q), frames.quaternion_to_unreal(q))


small = st.floats(-100.0, 100.0)
small_vector = st.tuples(small, small, small)


@given(small_vector, small_vector)
def test_mirrored_spin_gives_mirrored_point_velocity(w: tuple, r: tuple) -> None:
    here = frames.vector_to_unreal(np.cross(w, r))
    spin = np.radians(frames.angular_to_unreal(w))
    there = np.cross(spin, frames.vector_to_unreal(r))
    np.testing.assert_allclose(there, here, rtol=1e-9, atol=1e-6)


def test_heading_is_the_yaw_of_the_mirrored_direction() -> None:
    heading = 0.7
    x, y, _ = frames.vector_to_unreal([np.cos(heading), np.sin(heading), 0.0])
    assert frames.heading_to_unreal(heading) == pytest.approx(np.degrees(np.arctan2(y, x)))


@given(st.floats(-1e9, 1e9))
def test_literals_read_back(value: float) -> None:
    text = frames.literal(value)
    assert "." in text or "e" in text
    assert float(text) == pytest.approx(value, rel=1e-14, abs=0.0)
    assert np.float32(frames.float_literal(value).removesuffix("f")) == np.float32(value)


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_numbers_without_a_literal_are_refused(value: float) -> None:
    with pytest.raises(ValueError, match="cannot emit"):
        frames.literal(value)
    with pytest.raises(ValueError, match="cannot emit"):
        frames.float_literal(value)
