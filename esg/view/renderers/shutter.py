"""Poses while the shutter is open: what motion blur averages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Rollout
from esg.view.renderers.records import Poses

INSTANTS = 9
"""Odd, so that the one in the middle is the frame itself."""
OPEN = 0.5
"""The shutter is open for so much of the time between two frames, as in film (180 degrees)."""


def poses_at(
    rollout: Rollout, frames: Sequence[int], angles: NDArray[Any], open_s: float = 0.0
) -> Poses:
    """Poses of the first world at some frames, and around them while the shutter is open.

    Args:
        rollout: Motion of all bodies.
        frames: Indices of its frames.
        angles: Of all wheels in all its frames [rad], shape [T, W].
        open_s: The shutter is open for so long around each frame [s]; 0 for no motion blur.
    """
    position, quaternion = rollout.position[0], rollout.quaternion[0]
    if not open_s > 0:
        chosen = list(frames)
        return Poses(
            position[chosen][:, None], quaternion[chosen][:, None], angles[chosen][:, None]
        )
    time = np.asarray(rollout.time, float)
    around = (np.arange(INSTANTS) / (INSTANTS - 1) - 0.5) * open_s
    wanted = np.clip(time[list(frames)][:, None] + around, time[0], time[-1])
    return Poses(*at_times(rollout, wanted), _between(time, angles, wanted))


def at_times(
    rollout: Rollout, wanted: NDArray[Any]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Poses of the first world at any times, between those of the frames.

    Args:
        rollout: Motion of all bodies.
        wanted: Times within it [s], shape [...].

    Returns:
        Positions [m] and quaternions, shapes [..., B, 3] and [..., B, 4].
    """
    time = np.asarray(rollout.time, float)
    position, turned = rollout.position[0], np.array(rollout.quaternion[0], float)
    # Of the two quaternions of an orientation, the one next to that of the frame before.
    flips = np.sum(turned[1:] * turned[:-1], axis=-1, keepdims=True) < 0
    signs = np.cumprod(
        np.concatenate([np.ones_like(flips[:1], float), np.where(flips, -1.0, 1.0)]), axis=0
    )
    q = _between(time, turned * signs, wanted)
    q /= np.maximum(np.linalg.norm(q, axis=-1, keepdims=True), 1e-12)
    return _between(time, position, wanted), q


def _between(
    time: NDArray[np.float64], values: NDArray[Any], wanted: NDArray[Any]
) -> NDArray[np.float64]:
    """Values of shape [T, ...] at times [s], linearly between the frames."""
    right = np.clip(np.searchsorted(time, wanted), 1, len(time) - 1)
    share = (wanted - time[right - 1]) / (time[right] - time[right - 1])
    before, after = values[right - 1].astype(float), values[right].astype(float)
    return before + share.reshape(*share.shape, *[1] * (values.ndim - 1)) * (after - before)
