"""When something is picked up, put down, bounces, jumps or has turned (`measures`)."""

from __future__ import annotations

import math

import numpy as np

from esg.dynamics.losses.measures import AddTerm, Detected, gap_over_time
from esg.dynamics.losses.recording import Bools, Floats, Recording
from esg.graph.models import TimelineNode
from esg.lexicon.contents import CONTENT, contents
from esg.thresholds import STOPPED_FOR_S
from esg.units import quat_rotate, yaw_from_quat

PICKED_UP_M, PICKED_UP_SHARE = 0.05, 1.0 / 3.0
"""What is picked up has risen by so much, and by such a share of its height."""
PLACED_MPS, TOUCHES_M = 0.05, 0.003
"""What was put down is slower, and its surface is so near to what it was put on: nearer than what
is held just above that (`plan.guides.SET_DOWN_M`)."""
REBOUND_MPS, SAFE_REBOUND_MPS = 0.3, 0.45
"""What bounces leaves at more than that; at more than this in every engine."""
NEAR_BOUNCE_M = 0.05
JUMP_SHARE, SAFE_JUMP = 0.1, 1.5
"""What jumps rises by such a share of its height; by so many times that in every engine."""
DOWN_MPS, DOWN_FOR_S = 0.5, 0.15
"""What is down again moves up or down no faster, for longer than it does at the top of its leap."""
TURN_SCALE = math.radians(30.0)


def _height(rec: Recording, body: int) -> Floats:
    return rec.r.position[:, :, body, 2].astype(float)


def picked_up(rec: Recording, node: TimelineNode, earliest: Floats, _: AddTerm) -> Detected:
    body = rec.scene.index(node.participants[0])
    z = _height(rec, body)
    needed = max(PICKED_UP_M, PICKED_UP_SHARE * 2.0 * rec.scene.bodies[body].half_extents[2])
    risen = np.where(rec.late(earliest), z - z[:, :1], -np.inf)
    time = rec.first(risen >= needed)
    short = np.clip(needed - risen.max(axis=1), 0.0, needed) / needed
    return Detected(time, 1.0 + short)


def placed(rec: Recording, node: TimelineNode, earliest: Floats, _: AddTerm) -> Detected:
    a, b = rec.scene.index(node.participants[0]), rec.members(node.participants[1])
    gap = np.where(_afloat(rec, a, b), 0.0, _gap(rec, a, b))
    slow = (rec.speed[:, :, a] < PLACED_MPS) & (gap < TOUCHES_M) & rec.late(earliest)
    moved = np.maximum.accumulate(rec.speed[:, :, a] > 2.0 * PLACED_MPS, axis=1)
    still = slow & moved
    for k in range(1, max(1, round(STOPPED_FOR_S * rec.fps)) + 1):
        still[:, :-k] &= slow[:, k:]
        still[:, -k:] = False
    away = np.nan_to_num(gap[:, -1], nan=10.0, posinf=10.0)
    return Detected(rec.first(still), 0.5 + np.minimum(np.maximum(away, 0.0) / 0.3, 8.0))


def _afloat(rec: Recording, a: int, b: list[int]) -> Bools:
    """Whether some of a body is in the liquid of one of others, shape [W, T]."""
    out = np.zeros(rec.speed.shape[:2], bool)
    names = {rec.scene.bodies[i].name for i in b}
    for region in (r for r in rec.scene.regions if r.kind == CONTENT and r.parent in names):
        if not contents()[region.name.rpartition("/")[2]].liquid:
            continue
        vessel, half = rec.scene.index(region.parent), np.array(region.half_extents)
        turn = rec.r.quaternion[:, :, vessel].astype(float)
        back = turn * np.array([-1.0, -1.0, -1.0, 1.0])
        off = (rec.r.position[:, :, a] - rec.r.position[:, :, vessel]).astype(float)
        off = quat_rotate(back, off) - np.array(region.center)
        low = off[..., 2] - rec.scene.bodies[a].half_extents[2]
        out |= np.all(np.abs(off[..., :2]) <= half[:2], axis=-1) & (low < half[2])
    return out


def _gap(rec: Recording, a: int, b: list[int]) -> Floats:
    """Distance of a body from others, or from the ground if they have no surface [m]."""
    solid = [i for i in b if rec.scene.bodies[i].shapes]
    if solid:
        return gap_over_time(rec, [a], solid)
    return _height(rec, a) + rec.scene.bodies[a].origin_offset[2]


def bounce(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    """Every change from towards to away, beside what it bounces off, counts."""
    a, b = rec.scene.index(node.participants[0]), rec.members(node.participants[1])
    gap, count = _gap(rec, a, b), node.times or 1
    rate = np.gradient(np.nan_to_num(gap, nan=0.0, posinf=0.0), rec.t, axis=1)
    near = (gap < NEAR_BOUNCE_M + 0.02 * np.abs(rate)) & rec.late(earliest)
    turns = near & (rate > REBOUND_MPS)
    turns[:, 1:] &= ~(turns[:, :-1])
    begun = np.zeros_like(turns)
    towards = np.maximum.accumulate(np.where(rate < -0.05, np.arange(len(rec.t)), -1), axis=1)
    last = np.full(rec.n, -1)
    for k in range(len(rec.t)):
        fresh = turns[:, k] & (towards[:, k] > last)
        begun[:, k] = fresh
        last = np.where(fresh, k, last)
    number = np.cumsum(begun, axis=1)
    time = rec.first(number >= count)
    leaving = rec.extreme(rate, time, 0.0, 0.1)
    weak = np.maximum(SAFE_REBOUND_MPS - np.nan_to_num(leaving), 0.0) / SAFE_REBOUND_MPS
    add(f"{node.id}/weak", np.where(np.isfinite(time), weak, 0.0))
    missing = count - number[:, -1]
    nearest = np.nan_to_num(gap, nan=10.0, posinf=10.0).min(axis=1)
    return Detected(time, missing + np.clip(nearest / 0.3, 0.0, 8.0))


def jump(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    """Over when it has come down by half of what counts, over something when it is down again."""
    body, count = rec.scene.index(node.participants[0]), node.times or 1
    over = rec.members(node.participants[1]) if len(node.participants) > 1 else []
    z, v = _height(rec, body), rec.r.linear_velocity[:, :, body, 2].astype(float)
    late = rec.late(earliest)
    needed = JUMP_SHARE * 2.0 * rec.scene.bodies[body].half_extents[2]
    base = np.minimum.accumulate(np.where(late, z, np.inf), axis=1)
    up = late & (z - base > needed) & (v > DOWN_MPS)
    down = late & _down(rec, z - base, v, needed)
    landed, aloft = np.zeros(z.shape, int), np.zeros(rec.n, bool)
    top = np.full(rec.n, -np.inf)
    for k in range(1, len(rec.t)):
        top = np.where(up[:, k] & ~aloft, z[:, k], np.maximum(top, z[:, k]))
        aloft |= up[:, k]
        # Onto what is higher it comes down by less than it rose, and from what carries it by more.
        falls = down[:, k] if over or count > 1 else top - z[:, k] > 0.5 * needed
        lands = aloft & falls
        landed[:, k] = landed[:, k - 1] + lands
        aloft &= ~lands
    risen = np.where(np.isfinite(base), z - base, 0.0).max(axis=1)
    safe = SAFE_JUMP * needed
    add(f"{node.id}/weak", np.maximum(safe - risen, 0.0) / safe)
    clears, missed = np.ones(z.shape, bool), np.zeros(rec.n)
    if over:
        clears, missed = _clears(rec, body, over, late)
    time = rec.first((landed >= count) & clears)
    return Detected(time, 1.0 + missed + np.maximum(count - landed[:, -1], 0))


def _down(rec: Recording, height: Floats, v: Floats, needed: float) -> Bools:
    """Whether a body is on its feet: where it took off at once, elsewhere once it rests there."""
    calm = np.abs(v) < DOWN_MPS
    still = calm.copy()
    for k in range(1, max(1, round(DOWN_FOR_S * rec.fps)) + 1):
        still[:, :-k] &= calm[:, k:]
    return (calm & (height < 0.5 * needed)) | still


def _clears(rec: Recording, body: int, over: list[int], late: Bools) -> tuple[Bools, Floats]:
    """Whether a body is on the other side of things, untouched, and how deep it got into them [m].

    Shapes [W, T] and [W].
    """
    gap = np.where(late, np.nan_to_num(gap_over_time(rec, [body], over), posinf=10.0), 10.0)
    p = rec.r.position.astype(float)
    aside = p[:, :, body, :2] - p[:, :, over, :2].mean(axis=2)
    beyond = (aside * aside[np.arange(rec.n), np.argmax(late, axis=1)][:, None]).sum(-1) < 0.0
    untouched = np.minimum.accumulate(gap, axis=1) > 0.0
    return beyond & untouched, 1.0 + np.clip(-gap.min(axis=1), 0.0, 1.0)


def spin(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    body = rec.scene.index(node.participants[0])
    asked = math.radians(node.turn_degrees or 360.0)
    axle = next((j for j in rec.scene.joints if j.child == node.participants[0]), None)
    yaw = np.unwrap(yaw_from_quat(rec.r.quaternion[:, :, body].astype(float)), axis=1)
    if axle is not None and axle.kind == "hinge":
        yaw = rec.opening(axle)
    late = rec.late(earliest)
    begin = np.argmax(late, axis=1)
    turned = np.abs(yaw - yaw[np.arange(rec.n), begin][:, None])
    turned = np.where(late, turned, 0.0)
    p = rec.r.position[:, :, body].astype(float)
    off = np.linalg.norm(p[..., :2] - p[np.arange(rec.n), begin][:, None, :2], axis=-1)
    radius = max(rec.scene.bodies[body].half_extents[:2])
    time = rec.first((turned >= asked) & (off < radius))
    add(f"{node.id}/off", np.clip(rec.at(off, time) / radius - 0.5, 0.0, 1.0))
    return Detected(time, np.clip(asked - turned.max(axis=1), 0.0, None) / TURN_SCALE)
