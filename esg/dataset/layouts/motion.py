"""Motion of a clip's bodies at the times of its frames."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dataset.layouts.source import Sample
from esg.outcomes import UserError

Floats = NDArray[np.float32]


def velocities_of(sample: Sample) -> tuple[Floats, Floats]:
    """Velocities [m/s] and angular velocities [rad/s] of a clip's objects, between those of the
    recorded replay.

    Args:
        sample: With its table `trajectories`.

    Returns:
        Two arrays of shape [n, m, 3].

    Raises:
        UserError: If the replay of the scene's engine is not in the dataset.
    """
    record, engine = sample.clip.record, sample.scene["engine"]
    row = next((r for r in sample.more["trajectories"] if r["engine"] == engine), None)
    if row is None:
        raise UserError(f"scene {record.scene_id} has no trajectories in {engine}")
    at = [row["bodies"].index(o.name) for o in record.objects]
    time = np.asarray(row["time_s"])

    def between(column: str) -> Floats:
        known = np.asarray(row[column], float).reshape(len(time), -1, 3)[:, at]
        flat = known.reshape(len(time), -1).T
        found: Any = np.stack([np.interp(record.time_s, time, values) for values in flat], axis=1)
        return found.reshape(record.n_frames, len(at), 3).astype(np.float32)

    return between("linear_velocity_mps"), between("angular_velocity_radps")


def states_of(sample: Sample) -> Floats:
    """Position [m], quaternion (x, y, z, w), velocity [m/s] and angular velocity [rad/s] of every
    object in every frame, shape [n, m, 13].
    """
    record = sample.clip.record
    poses = (record.object_position_m, record.object_quaternion_xyzw)
    return np.concatenate([*poses, *velocities_of(sample)], axis=-1).astype(np.float32)
