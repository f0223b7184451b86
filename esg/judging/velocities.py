"""Velocities of poses, by differences that do not reach over a hit."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import ContactLog
from esg.judging.recording import Floats
from esg.units import quat_inverse, quat_multiply


def velocities(position: Floats, time: Floats, contacts: ContactLog) -> Floats:
    """Velocities of bodies [m/s], shape [T, B, 3].

    Central differences; one-sided at the ends, and beside a step in which something touched the
    body: the frame before a hit has the speed it came with, the frame after the one it left with.

    Args:
        position: [m], shape [T, B, 3].
        time: [s], shape [T].
        contacts: Who touched whom.
    """
    between = np.diff(position, axis=0) / np.diff(time)[:, None, None]
    hit = hits(len(time), position.shape[1], contacts, time)
    before = np.concatenate([between[:1], between])
    after = np.concatenate([between, between[-1:]])
    hit_before = np.concatenate([np.ones_like(hit[:1]), hit])
    hit_after = np.concatenate([hit, np.ones_like(hit[:1])])
    both = 0.5 * (before + after)
    out = np.where((hit_before & ~hit_after)[..., None], after, both)
    return np.where((hit_after & ~hit_before)[..., None], before, out)


def hits(frames: int, bodies: int, contacts: ContactLog, time: Floats) -> NDArray[np.bool_]:
    """Steps in which another body touched one anew, shape [T - 1, B]."""
    out = np.zeros((frames - 1, bodies), bool)
    step = np.clip(np.searchsorted(time, contacts.time - 1e-9, side="right") - 1, 0, frames - 2)
    for indices in (contacts.a, contacts.b):
        known = indices >= 0
        out[step[known], indices[known]] = True
    # In a touch that lasts there is no step to look past.
    held = out.copy()
    held[1:] &= out[:-1]
    held[:-1] &= held[1:] | out[1:]
    return out & ~held


def spins(quaternion: Floats, time: Floats) -> Floats:
    """Angular velocities in the world's axes [rad/s], shape [T, B, 3].

    Args:
        quaternion: (x, y, z, w), shape [T, B, 4].
        time: [s], shape [T].
    """
    turn = quat_multiply(quaternion[1:], quat_inverse(quaternion[:-1]))
    turn = np.where(turn[..., 3:] < 0.0, -turn, turn)
    sine = np.linalg.norm(turn[..., :3], axis=-1, keepdims=True)
    angle = 2.0 * np.arctan2(sine, turn[..., 3:])
    axis = turn[..., :3] / np.where(sine > 1e-12, sine, 1.0)
    between = axis * angle / np.diff(time)[:, None, None]
    first, last = between[:1], between[-1:]
    return np.concatenate([first, 0.5 * (between[1:] + between[:-1]), last])
