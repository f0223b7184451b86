"""Rollouts as files: exact and equal bytes for equal rollouts."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from esg.engines.rollout_file import load_rollout, save_rollout
from esg.engines.scene import ContactLog, Rollout


def make_rollout() -> Rollout:
    rng = np.random.default_rng(0)

    def random(*shape: int) -> np.ndarray:
        return rng.normal(size=shape).astype(np.float32)

    contacts = ContactLog(
        world=np.zeros(2, np.int32),
        frame=np.array([1, 2], np.int32),
        a=np.zeros(2, np.int32),
        b=np.array([-1, 1], np.int32),
        time=np.array([0.1, 0.2]),
        impulse=np.array([1.0, 2.0]),
        depth=np.zeros(2),
        point=np.ones((2, 3)),
        normal=np.ones((2, 3)),
    )
    return Rollout(
        engine="physx",
        dt=1 / 240,
        time=np.arange(4) / 240,
        position=random(1, 4, 2, 3),
        quaternion=random(1, 4, 2, 4),
        linear_velocity=random(1, 4, 2, 3),
        angular_velocity=random(1, 4, 2, 3),
        contacts=contacts,
        valid=np.array([True]),
    )


def test_round_trip_is_exact(tmp_path: Path) -> None:
    rollout = make_rollout()
    save_rollout(rollout, tmp_path / "r.npz")
    back = load_rollout(tmp_path / "r.npz")
    assert back.engine == "physx"
    assert back.dt == rollout.dt
    for name in ("time", "position", "quaternion", "linear_velocity", "angular_velocity", "valid"):
        np.testing.assert_array_equal(getattr(back, name), getattr(rollout, name))
        assert getattr(back, name).dtype == getattr(rollout, name).dtype
    for name in ContactLog.__dataclass_fields__:
        np.testing.assert_array_equal(getattr(back.contacts, name), getattr(rollout.contacts, name))


def test_equal_rollouts_give_equal_bytes(tmp_path: Path) -> None:
    save_rollout(make_rollout(), tmp_path / "a.npz")
    save_rollout(make_rollout(), tmp_path / "b.npz")
    assert (tmp_path / "a.npz").read_bytes() == (tmp_path / "b.npz").read_bytes()
