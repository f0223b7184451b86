"""A differentiable rollout of the fused surrogate: forward with a trace, replay on `wp.Tape`."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.base import SURROGATE
from esg.engines.jobs import job_of, read
from esg.engines.newton.setup import quiet_warp
from esg.engines.program import ProgramBatch
from esg.engines.scene import SimScene, Variation
from esg.engines.surrogate.engine import scene_arrays, simulate
from esg.engines.worlds import Start

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Touch:
    """The first moment two bodies touch in one world.

    Args:
        step: Of the contact.
        time: [s], within the step.
        contact: Index of the contact whose delay carries the derivative, or -1 if it has none.
    """

    step: int
    time: float
    contact: int


@dataclass(frozen=True)
class Seeds:
    """Derivatives of a scalar loss with respect to what a rollout produced.

    Shapes: W worlds, N steps, B bodies. Entries that are None are zero.

    Args:
        position: [W, N + 1, B, 3].
        quaternion: (x, y, z, w), [W, N + 1, B, 4].
        velocity: [W, N + 1, B, 3].
        delay: Of `Touch.contact`, [contacts].
    """

    position: Floats | None = None
    quaternion: Floats | None = None
    velocity: Floats | None = None
    delay: Floats | None = None


@dataclass(frozen=True)
class Pull:
    """Derivatives with respect to what a rollout started from.

    Args:
        table: Of the program's numbers, [W, P, FIELDS].
        position: Of the initial positions, [W, B, 3].
        quaternion: Of the initial orientations, [W, B, 4].
    """

    table: Floats
    position: Floats
    quaternion: Floats


class TapedRollout:
    """One differentiable rollout of W worlds.

    Args:
        scene: Bodies and materials.
        batch: W programs.
        dt: Physics step [s].
        duration: [s]; default the batch's.
        variation: Per-world changes of the scene.
        device: Warp device.
    """

    def __init__(
        self,
        scene: SimScene,
        batch: ProgramBatch,
        *,
        dt: float,
        duration: float | None = None,
        variation: Variation | None = None,
        device: str = "cpu",
    ) -> None:
        start = Start.of(
            scene, batch, dt=dt, record_every=1, duration=duration, variation=variation
        )
        arrays = scene_arrays(scene, device)
        job = job_of(SURROGATE, 0, start, arrays.shapes)
        self.scene, self.batch, self.device = scene, batch, device
        self.frames, self.values = start.frames, start.values
        self.moving = arrays.shapes.dynamic
        run = simulate(job, arrays, traced=True)
        # Their arrays lie in the memory of the run.
        self.run, self.trace = run, run.trace
        self.model, self.contacts = run.struct("model"), run.struct("contacts")
        (played,) = run.collect([0])
        read(job, start, played)
        self.position, self.quaternion, self.velocity, self.angular = start.states
        end = np.full(len(start.valid), self.frames.n_frames) if played.end is None else played.end
        self.valid = end >= self.frames.n_frames
        self.last_step = np.minimum(end - 1, self.frames.n_steps)
        self.room = run.rooms[0].contacts
        shape = (batch.n_worlds, self.frames.n_steps, self.room)
        self._read = {n: getattr(self.contacts, n).numpy() for n in
                      ("used", "a", "b", "delay", "impulse", "gap")}  # fmt: skip
        self._read = {n: v.reshape(*shape, *v.shape[2:]) for n, v in self._read.items()}
        slots = np.arange(self.room)[None, None] < self.contacts.count.numpy()[:, :, None]
        self.used = slots & (self._read["used"] != 0)

    def touches(self, a: list[int], b: list[int], earliest: Floats) -> list[Touch | None]:
        """First contact of any of `a` with any of `b` per world, not before `earliest` [s], [W]."""
        one, two = self._read["a"], self._read["b"]
        pair = (np.isin(one, a) & np.isin(two, b)) | (np.isin(one, b) & np.isin(two, a))
        pair &= self.used & (self._read["impulse"][..., 0] > 0.0)
        end = (np.arange(pair.shape[1]) + 1) * self.frames.dt
        out: list[Touch | None] = []
        for w in range(len(pair)):
            steps = np.flatnonzero(pair[w].any(axis=1) & (end >= earliest[w] - 1e-9))
            if not len(steps):
                out.append(None)
                continue
            step = int(steps[0])
            slots = np.flatnonzero(pair[w, step])
            delays = self._read["delay"][w, step, slots]
            moving = np.flatnonzero(delays > 0.0)
            pick = slots[moving[np.argmin(delays[moving])]] if len(moving) else slots[0]
            late = float(self._read["delay"][w, step, pick])
            flat = self._flat(w, step, int(pick)) if late > 0.0 else -1
            out.append(Touch(step, step * self.frames.dt + late, flat))
        return out

    def hits(self, horizon: NDArray[np.int64]) -> list[set[tuple[int, int]]]:
        """Pairs of bodies that hit each other at speed before a step, per world; ground is -1."""
        hit = self.used & (self._read["delay"] > 0.0) & (self._read["impulse"][..., 0] > 0.0)
        hit &= (np.arange(hit.shape[1]) < horizon[:, None])[..., None]
        out: list[set[tuple[int, int]]] = [set() for _ in horizon]
        for w, step, slot in zip(*np.nonzero(hit), strict=True):
            a, b = int(self._read["a"][w, step, slot]), int(self._read["b"][w, step, slot])
            out[w].add((min(a, b), max(a, b)))
        return out

    @property
    def n_contacts(self) -> int:
        """Contacts in the flat order of the replay."""
        return int(self.used.sum())

    def _flat(self, w: int, step: int, slot: int) -> int:
        """Number of a contact in the flat order of the replay."""
        before = int(self.used[:w, : self.used.shape[1]].sum()) if w else 0
        before += int(self.used[w, :step].sum())
        return before + int(self.used[w, step, :slot].sum())

    def pull(self, seeds: Seeds, horizon: NDArray[np.int64] | None = None) -> Pull:
        """Pulls derivatives back to the start by `wp.Tape`.

        Args:
            seeds: Derivatives of the loss.
            horizon: Steps per world behind which all seeds are zero; default all. Shape [W].
        """
        replayed = Replay(
            self, np.minimum(self.last_step, self.last_step if horizon is None else horizon)
        )
        return replayed.pull(seeds)

    def replayed_position(self) -> Floats:
        """Positions as the replay computes them: those of the rollout, [W, N + 1, B, 3]."""
        replayed = Replay(self, self.last_step)
        replayed.play()
        return replayed.X.numpy()[replayed.pose_at]


class Replay:
    """The operations of a traced rollout, up to a step per world."""

    def __init__(self, taped: TapedRollout, steps: NDArray[np.int64]) -> None:
        from esg.engines.surrogate import ops as so
        from esg.engines.surrogate.features import Features

        self.taped, self.wp, self.device = taped, quiet_warp(), taped.device
        w, n, b = taped.position.shape[:3]
        self.n_worlds, self.n_bodies = w, b
        inside = np.arange(n - 1)[None] < steps[:, None]
        trace = taped.trace
        used = (taped.used & inside[..., None]).sum(-1)
        awake = trace.awake.numpy() * inside[..., None]
        awake[..., ~taped.moving] = 0
        fired = ((trace.fired.numpy() != 0) & inside[..., None]).sum(-1)
        moves, solves = awake.sum(-1), trace.sweeps.numpy() * used
        grounded = ((trace.grounded.numpy() != 0) & inside[..., None]).sum(-1)
        n_ops = (fired + grounded + 2 * moves + 2 * used + solves).sum(1)
        n_v = 1 + b + (fired + grounded + 2 * moves + 2 * solves).sum(1)
        n_x = b + 1 + moves.sum(1)
        n_j = 1 + solves.sum(1)
        self.first_x, first_j = _starts(n_x), _starts(n_j)
        total, n_c = int(n_ops.sum()), max(1, int(taped.used.sum()))
        flat = [name for name in so.Ops.vars if name != "first"]
        self.ops = self._zeros(so.Ops, flat, max(1, total))
        self.ops.first = self._ints(np.append(_starts(n_ops), total))
        flat = [name for name in Features.vars if name != "first"]
        self.feat = self._zeros(Features, flat, n_c)
        # The flat number of a contact counts all contacts of earlier worlds, inside or not.
        self.feat.first = self._ints(_starts(taped.used.sum((1, 2))))
        ver = self._zeros(so.Versions, ("now_v", "now_x", "free_v", "kick", "hit", "set_v"), (w, b))
        self._zeros(so.Versions, ("last_i", "number"), (w, taped.room), ver)
        self._zeros(so.Versions, ("acted",), (w, trace.fired.shape[2]), ver)
        self._zeros(so.Versions, ("velocity_at", "pose_at"), (w, n, b), ver)
        self._zeros(so.Versions, ("late",), int(n_x.sum()), ver)
        self._zeros(so.Versions, ("next",), (w, len(so.Cursor)), ver)
        ver.velocity, ver.pose, ver.impulse = map(self._ints, (_starts(n_v), self.first_x, first_j))
        self.frozen_late = ver.late
        self.wp.launch(
            so.link, dim=w, device=self.device,
            inputs=[taped.model, taped.contacts, trace, self._ints(steps), self.ops, self.feat,
                    ver],
        )  # fmt: skip
        self.pose_at, self.velocity_at = ver.pose_at.numpy(), ver.velocity_at.numpy()
        for w_, last in enumerate(steps):
            self.pose_at[w_, last:] = self.pose_at[w_, last]
            self.velocity_at[w_, last:] = self.velocity_at[w_, last]
        self._arrays(int(n_v.sum()), int(n_x.sum()), int(n_j.sum()), n_c)

    def _zeros(self, struct: Any, names: Iterable[str], shape: Any, made: Any = None) -> Any:
        """An instance of a struct, new or given, with zeros in some of its arrays."""
        made = struct() if made is None else made
        for name in names:
            dtype = struct.vars[name].type.dtype
            setattr(made, name, self.wp.zeros(shape, dtype=dtype, device=self.device))
        return made

    def _ints(self, values: Any) -> Any:
        return self.wp.array(np.asarray(values, np.int32), dtype=int, device=self.device)

    def _arrays(self, n_v: int, n_x: int, n_j: int, n_c: int) -> None:
        wp, t = self.wp, self.taped

        def make(count: int, dtype: Any) -> Any:
            return wp.zeros(count, dtype=dtype, device=t.device, requires_grad=True)

        self.V, self.O = make(n_v, wp.vec3), make(n_v, wp.vec3)
        self.X, self.R = make(n_x, wp.vec3), make(n_x, wp.quat)
        x, r = np.zeros((n_x, 3), np.float32), np.zeros((n_x, 4), np.float32)
        x[self.pose_at[:, 0]] = t.values.position
        r[self.pose_at[:, 0]] = t.values.quaternion
        r[self.first_x + self.n_bodies, 3] = 1.0
        self.X.assign(x)
        self.R.assign(r)
        table = t.batch.table if t.batch.table.shape[1] else np.zeros((self.n_worlds, 1, 1))
        self.table = wp.array(table, dtype=wp.float64, device=t.device, requires_grad=True)
        self.frozen = wp.array(table, dtype=wp.float64, device=t.device)
        bodies = t.scene.bodies
        damping = np.array([(b.linear_damping, b.angular_damping) for b in bodies], np.float32)
        self.damping = wp.array(
            np.tile(damping, (self.n_worlds, 1, 1)), dtype=wp.vec2, device=t.device
        )
        self.J = make(n_j, wp.vec3)
        self.inverse, self.late = make(n_x, wp.mat33), make(n_x, wp.vec2)
        self.shift = make(n_x, wp.vec3)
        self.contact = [make(n_c, wp.vec3) for _ in range(3)] + [make(n_c, float), make(n_c, float)]
        self.contact.append(make(n_c, wp.vec3))

    def play(self) -> Any:
        """Executes all operations under a tape and returns the tape."""
        from esg.engines.surrogate.replay import replay

        wp, t = self.wp, self.taped
        tape = wp.Tape()
        with tape:
            wp.launch(
                replay, dim=self.n_worlds, device=t.device,
                inputs=[t.model, self.ops, self.feat, t.frames.dt, self.table, self.frozen,
                        self.damping, self.V, self.O, self.X, self.R, self.J, self.inverse,
                        self.late, self.shift, self.frozen_late, *self.contact],
            )  # fmt: skip
        return tape

    def pull(self, seeds: Seeds) -> Pull:
        """Derivatives with respect to the program and the initial poses."""
        tape = self.play()
        grads: dict[Any, Any] = {}
        for array, at, seed in (
            (self.X, self.pose_at, seeds.position),
            (self.R, self.pose_at, seeds.quaternion),
            (self.V, self.velocity_at, seeds.velocity),
        ):
            if seed is not None:
                cotangent = np.zeros((array.shape[0], seed.shape[-1]), np.float32)
                np.add.at(cotangent, at.reshape(-1), seed.reshape(-1, seed.shape[-1]))
                grads[array] = self._seed(cotangent, array)
        if seeds.delay is not None:
            grads[self.contact[4]] = self._seed(seeds.delay.astype(np.float32), self.contact[4])
        tape.backward(grads=grads)
        start = self.pose_at[:, 0]
        return Pull(
            np.nan_to_num(self.table.grad.numpy())[:, : len(self.taped.batch.kind)],
            self.X.grad.numpy().astype(float)[start],
            self.R.grad.numpy().astype(float)[start],
        )

    def _seed(self, values: NDArray[np.float32], array: Any) -> Any:
        return self.wp.array(values, dtype=array.dtype, device=self.taped.device)


def _starts(counts: NDArray[Any]) -> NDArray[np.int32]:
    """Where each part begins if parts of these sizes follow each other."""
    return np.concatenate([[0], np.cumsum(counts)[:-1]]).astype(np.int32)


def warmup(device: str = "cpu") -> None:
    """Compiles the surrogate's kernels and those of its derivatives (once per machine)."""
    from esg.engines.program import Program, SetVelocity, batch_programs
    from esg.engines.scene import Body, Shape

    unit = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    ball = Body("ball", False, 1.0, unit, (Shape("sphere", (0.1, 0.1, 0.1)),), (0.0, 0.0, 0.1))
    scene = SimScene("warmup", (ball,))
    program = Program((SetVelocity("ball", 0.0, (1.0, 0.0, 0.0)),), 0.05)
    taped = TapedRollout(scene, batch_programs([program], scene.names), dt=1 / 240, device=device)
    taped.pull(Seeds(position=np.ones_like(taped.position, float)))
