"""Bodies that change their posture: one body in each, of which one at a time is there.

A body with `postures` names other bodies of the scene, which are it when it lies, sits or stands.
`ChangeBody` of the program says which is there from when on (docs/postures.md). Those that are not
there neither move nor touch. Recordings have them where they ride in the first one, which goes on
as if it were fixed to the one that is there, `LIFT_M` above its place there: that tells from the
poses alone who is there, and a body keeps its name, its way and its contacts whatever its posture.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.joints import Floats
from esg.engines.program import Action, Column, ProgramBatch
from esg.engines.scene import ContactLog, SimScene
from esg.units import quat_from_euler_deg, quat_inverse, quat_multiply, quat_rotate

LIFT_M = 4e-4
"""So far above its place in the one that is there a body is recorded that is not [m]."""
_TELLS_M = 2e-4


@dataclass(frozen=True)
class Stance:
    """A body in its postures, by index.

    Args:
        bodies: The body itself, then those that stand in for it, n in all.
        local: Their centres in its frame [m], shape [n, 3]; its own is 0.
        turn: Their orientations there (x, y, z, w), shape [n, 4].
    """

    bodies: tuple[int, ...]
    local: Floats
    turn: Floats


def stances(scene: SimScene) -> tuple[Stance, ...]:
    """Who of a scene changes his posture, in the order of its bodies."""
    if not any(b.postures for b in scene.bodies):
        return ()
    index = {name: i for i, name in enumerate(scene.names)}
    out: list[Stance] = []
    for i, body in enumerate(scene.bodies):
        if body.postures:
            own = (i, *(index[name] for name in body.postures))
            back = quat_inverse(np.asarray(body.quaternion, float))
            at = np.array([scene.bodies[k].position for k in own]) - np.asarray(body.position)
            turns = np.array([scene.bodies[k].quaternion for k in own])
            out.append(Stance(own, quat_rotate(back, at), quat_multiply(back, turns)))
    return tuple(out)


def stance_problems(scene: SimScene) -> list[str]:
    """Everything that is wrong with the postures of bodies, each with place, value and remedy."""
    bodies = {b.name: b for b in scene.bodies}
    joined = {n for j in scene.joints for n in (j.child, j.parent)}
    out: list[str] = []
    for i, body in enumerate(scene.bodies):
        wrong = [n for n in body.postures if n not in bodies or n == body.name]
        wrong += [n for n in body.postures if n in bodies and _unfit(bodies[n])]
        if wrong:
            out.append(
                f"/bodies/{i}/postures: {wrong} cannot be; name bodies that move and collide"
            )
        elif body.postures and ({body.name, *body.postures} & joined or _unfit(body, own=True)):
            out.append(
                f"/bodies/{i}/postures: {body.name!r} is fixed, joined or breaks; leave it out"
            )
    return out


def _unfit(body: Any, *, own: bool = False) -> bool:
    held = body.static or not body.collides or body.fragments
    return bool(held or (body.postures and not own))


def frame_of(s: Stance, k: int, position: Any, quaternion: Any) -> tuple[Floats, Floats]:
    """Where the body would be whose posture number `k` has a pose, shape [..., 3] and [..., 4]."""
    turn = quat_multiply(np.asarray(quaternion, float), quat_inverse(s.turn[k]))
    return np.asarray(position, float) - quat_rotate(turn, s.local[k]), turn


def pose_in(s: Stance, k: int, position: Any, quaternion: Any) -> tuple[Floats, Floats]:
    """Where posture number `k` is in a body with a pose, shape [..., 3] and [..., 4]."""
    q = np.asarray(quaternion, float)
    return np.asarray(position, float) + quat_rotate(q, s.local[k]), quat_multiply(q, s.turn[k])


def who_is_there(s: Stance, batch: ProgramBatch, time: Floats, dt: float) -> NDArray[np.int64]:
    """Which posture is there at the frames of a rollout, by its number, shape [W, T].

    Args:
        s: Whose.
        batch: W programs.
        time: Of the frames [s], shape [T].
        dt: Physics step [s].
    """
    out = np.zeros((batch.n_worlds, len(time)), np.int64)
    rows = np.flatnonzero((batch.kind == Action.CHANGE) & (batch.body == s.bodies[0]))
    for w in range(batch.n_worlds):
        for k in rows[np.argsort(batch.table[w, rows, Column.START], kind="stable")]:
            # It is there after the step that began with the change.
            # What changes at once is so from the first frame on.
            since = batch.table[w, k, Column.START]
            later = (since <= time - 0.5 * dt) | (since <= 0.0)
            out[w, later] = s.bodies.index(int(batch.table[w, k, Column.INTO]))
    return out


def fill_in(
    scene: SimScene,
    batch: ProgramBatch,
    time: Floats,
    dt: float,
    states: tuple[Any, Any, Any, Any],
    worlds: Sequence[int] | None = None,
) -> None:
    """Writes into a recording where those are that are not there, in place.

    Args:
        scene: B bodies.
        batch: W programs.
        time: Of the frames [s], shape [T].
        dt: Physics step [s].
        states: Positions, quaternions and both velocities, shape [W, T, B, 3 or 4].
        worlds: Which of them; None for all.
    """
    for s in stances(scene):
        there = who_is_there(s, batch, time, dt)
        for w in range(batch.n_worlds) if worlds is None else worlds:
            ride_along(s, w, there[w], states)


def ride_along(
    s: Stance, w: int, there: NDArray[np.int64], states: tuple[Any, Any, Any, Any]
) -> None:
    """Writes into a recording where the postures of one body are that are not there, in place.

    Args:
        s: The body.
        w: World.
        there: Number of the one that is there, shape [T].
        states: As of `fill_in`.
    """
    for k in np.unique(there):
        frames = np.flatnonzero(there == k)
        own = [a[w, frames, s.bodies[k]] for a in states]
        base = frame_of(s, int(k), own[0], own[1])
        base[0][..., 2] += LIFT_M * (k > 0)
        for n, body in enumerate(s.bodies):
            if n == k:
                continue
            pose = base if n == 0 else pose_in(s, n, *base)
            for target, value in zip(states, (*pose, own[2], own[3]), strict=True):
                target[w, frames, body] = value


def absent(scene: SimScene, position: Any, quaternion: Any) -> NDArray[np.bool_]:
    """Who is not there in which frame of a recording, shape [..., T, B].

    Args:
        scene: B bodies.
        position, quaternion: Of a recording, shape [..., T, B, 3 or 4].
    """
    out = np.zeros(np.shape(position)[:-1], np.bool_)
    for s in stances(scene):
        base = (np.asarray(a, float)[..., s.bodies[0], :] for a in (position, quaternion))
        at, turn = base
        for k, body in enumerate(s.bodies[1:], 1):
            place = pose_in(s, k, at, turn)[0]
            off = np.linalg.norm(np.asarray(position, float)[..., body, :] - place, axis=-1)
            out[..., body] = off <= _TELLS_M
        out[..., s.bodies[0]] = ~out[..., list(s.bodies[1:])].all(axis=-1)
    return out


def own_names(scene: SimScene, log: ContactLog) -> ContactLog:
    """A contact log in which a body is itself whatever its posture."""
    own = np.arange(-1, len(scene.bodies), dtype=np.int32)
    for s in stances(scene):
        own[np.array(s.bodies) + 1] = s.bodies[0]
    a, b = own[log.a + 1], own[log.b + 1]
    turned = (a > b) & (b >= 0)
    normal = np.where(turned[:, None], -log.normal, log.normal)
    a, b = np.where(turned, b, a), np.where(turned, a, b)
    order = np.lexsort((b, a, log.frame, log.world))
    log = replace(log, a=a, b=b, normal=normal)
    return ContactLog(**{n: getattr(log, n)[order] for n in log.__dataclass_fields__})


class Changes:
    """Swaps the bodies of one world that is stepped (`esg.engines.executor`).

    Args:
        scene: Its bodies.
    """

    def __init__(self, scene: SimScene) -> None:
        self._of = {s.bodies[0]: s for s in stances(scene)}
        self._now = dict.fromkeys(self._of, 0)

    def open(self, world: Any) -> None:
        """Takes out who is not there at the start."""
        for s in self._of.values():
            for body in s.bodies[1:]:
                world.retire(body)

    def change(self, body: int, row: Sequence[float], world: Any) -> None:
        """Lets another posture of a body be there; `row` has the numbers of a `ChangeBody`."""
        s, k = self._of[body], self._now[body]
        n = s.bodies.index(int(row[Column.INTO]))
        if n == k:
            return
        position, quaternion, linear, angular = (
            np.asarray(a, float) for a in world.read(s.bodies[k])
        )
        frame = frame_of(s, k, position, quaternion)
        if row[Column.PLACE] == row[Column.PLACE]:
            turn = quat_from_euler_deg(np.degrees(row[Column.FACING]))
            frame = np.array(row[Column.PLACE : Column.PLACE + 3]), turn
            linear, angular = np.zeros(3), np.zeros(3)
        world.retire(s.bodies[k])
        world.release(s.bodies[n], *pose_in(s, n, *frame), linear, angular)
        self._now[body] = n
