"""One launch of the surrogate for the worlds of some jobs: arrays, simulation and results."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.jobs import Buffer, Job, Played
from esg.engines.newton.setup import quiet_warp
from esg.engines.scene import ContactLog
from esg.engines.surrogate.arena import Arena, Records, view
from esg.engines.surrogate.scene import SceneArrays

CONTACTS, TRACED_CONTACTS = 160, 48
"""Room for contacts of one world and step before it has to grow; less where every step keeps its
own. Unused room costs memory only, while too little costs a second rollout."""
ROWS_PER_FRAME = 12
"""Room for rows of the contact log before it has to grow."""
MAX_CONTACTS = 4096
_POINTS = 8
"""Contact points of a pair of shapes."""
BLOCK = 32
"""Threads of a block; one number for all kernels of a module, which is compiled for it."""
THREADS = 131072
"""Threads that a GPU runs side by side, roughly."""

Numbers = NDArray[np.int64]


@dataclass(frozen=True)
class Room:
    """How many contacts a step and how many rows a log of one world may have."""

    contacts: int
    rows: int


def world_bytes(job: Job, room: Room) -> int:
    """Device memory of a world, roughly."""
    frames, b = job.frames.n_frames, job.mass.shape[1]
    return frames * b * 52 + room.rows * 48 + room.contacts * 188 + 12 * b * b + 300 * b


class Launch:
    """Device arrays of some jobs, their simulation and what comes back.

    Args:
        device: Warp device.
        jobs: Rollouts.
        scenes: Of the jobs.
        rooms: Of a world, per job.
        traced: Whether the contacts and decisions of every step are kept, of one job only.
        fields: Signed distance fields of the scenes (`Fields`); without them bodies meet by their
            shapes.
    """

    def __init__(
        self,
        device: str,
        jobs: list[Job],
        scenes: list[SceneArrays],
        rooms: list[Room],
        *,
        traced: bool = False,
        fields: list[Any] | None = None,
    ) -> None:
        self.wp = wp = quiet_warp()
        from esg.engines.surrogate import types

        self.device, self.jobs, self.scenes, self.rooms = device, jobs, scenes, rooms
        arena = Arena(wp, device)
        n = len(jobs)
        self.w = w = np.array([j.n_worlds for j in jobs], np.int64)
        b = np.array([s.shapes.n_bodies for s in scenes], np.int64)
        contacts = np.array([r.contacts for r in rooms], np.int64)
        rows = np.array([r.rows for r in rooms], np.int64)
        steps = np.array([j.frames.n_steps if traced else 1 for j in jobs], np.int64)
        self.kernel, points = _method(fields is not None)
        self.fields = fields and wp.array(fields, dtype=types.Fields, device=device)
        self.records = {
            "model": _models(Records(types.Model, n), arena, jobs, scenes),
            "state": _states(Records(types.State, n), arena, jobs, scenes),
            "raw": Records(types.Raw, n),
            "contacts": Records(types.Contacts, n),
            "log": Records(types.Log, n),
            "out": Records(types.Out, n),
        }
        raw, con, log = (self.records[k] for k in ("raw", "contacts", "log"))
        arena.fill(raw, ("point", "normal", "distance"), [w, points])
        arena.fill(raw, ("count",), [w])
        own = ("base", "count", "dropped")
        kept = [name for name in types.Contacts.vars if name not in own]
        arena.fill(con, kept, [w, contacts * steps])
        arena.fill(con, ("count",), [w, steps])
        arena.fill(con, ("dropped",), [w])
        con.rows["base"] = contacts if traced else 0
        columns = ("frame", "a", "b", "step", "impulse", "depth", "point", "normal")
        arena.fill(log, columns, [w, rows])
        arena.fill(log, ("count",), [w])
        arena.fill(log, ("row",), [w, b + 1, b + 1], "minus")
        log.rows["ground"] = [j.ground_contacts for j in jobs]
        self.start = np.cumsum(w) - w
        self._place_results(self.records["out"], arena)
        self._upload(arena)
        self.trace = types.Trace()
        if traced:
            self._place_trace(jobs[0])

    def _place_results(self, out: Records, arena: Arena) -> None:
        """Makes the arrays that come back: states lie densely one scene after the other."""
        wp, w = self.wp, self.w
        frames = np.array([j.frames.n_frames - 1 for j in self.jobs], np.int64)
        d = np.array([int(s.shapes.dynamic.sum()) for s in self.scenes], np.int64)
        self.cells = w * frames * d
        total = max(1, int(self.cells.sum()))
        self.out = [
            wp.empty(total, dtype=t, device=self.device)
            for t in (wp.vec3, wp.quat, wp.vec3, wp.vec3)
        ]
        for name, array in zip("xrvo", self.out, strict=True):
            arena.place(out, array, name, [w, frames, d])
        worlds = int(w.sum())
        self.per_world = [wp.zeros(worlds, dtype=t, device=self.device) for t in (float, int)]
        for name, array in zip(("deepest", "end"), self.per_world, strict=True):
            arena.place(out, array, name, [w])

    def _upload(self, arena: Arena) -> None:
        """Completes the structs, and tells every thread its world."""
        wp, w = self.wp, self.w
        worlds = int(w.sum())
        self.scene_of = np.repeat(np.arange(len(w)), w).astype(np.int32)
        self.world_of = (np.arange(worlds) - np.repeat(self.start, w)).astype(np.int32)
        columns = [(self.scene_of, wp.int32), (self.world_of, wp.int32)]
        self._keep, placed = arena.upload(list(self.records.values()), columns)
        self.structs = dict(zip(self.records, placed, strict=False))
        self.indices = placed[len(self.records) :]
        self.counts = wp.zeros((2, worlds), dtype=int, device=self.device)

    def _place_trace(self, job: Job) -> None:
        w, b = job.mass.shape
        steps, p = job.frames.n_steps, max(1, len(job.kind))
        shapes = {"awake": (w, steps, b), "fired": (w, steps, p), "sweeps": (w, steps),
                  "grounded": (w, steps, b)}  # fmt: skip
        self.trace.steps = steps
        for name, shape in shapes.items():
            setattr(self.trace, name, self.wp.zeros(shape, dtype=int, device=self.device))

    def struct(self, name: str) -> Any:
        """One of the first job's structs as kernels take it alone, such as `model`."""
        records = self.records[name]
        return view(self.wp, records.struct, records.rows[0], self.device)

    def launch(self, stream: Any = None, threads: int = 1) -> None:
        """Simulates all worlds to the end.

        Args:
            stream: Of a GPU, beside the one that everything else runs on; `done` says when it has
                ended.
            threads: Of a CPU that share the worlds.
        """
        from esg.engines.surrogate import kernels

        wp, n, s = self.wp, len(self.scene_of), self.structs
        if stream is not None:
            stream.wait_stream(wp.get_stream(self.device))
        spread = 1
        if self.device != "cpu":
            spread = 1 << min(5, max(0, (THREADS // n).bit_length() - 1))
        where = {"device": self.device, "block_dim": BLOCK, "stream": stream}
        inputs = [self.fields, *s.values(), self.trace, *self.indices]

        def roll(first: int, count: int) -> None:
            wp.launch(self.kernel, dim=spread * count, inputs=[*inputs, first, spread], **where)

        parts = np.array_split(np.arange(n), min(threads, n))
        if len(parts) == 1:
            roll(0, n)
        else:
            # The kernel is loaded before threads ask for it.
            roll(0, 0)
            with ThreadPoolExecutor(len(parts)) as pool:
                for job in [pool.submit(roll, int(p[0]), len(p)) for p in parts]:
                    job.result()
        wp.launch(
            kernels.count_rows,
            dim=n,
            inputs=[s["contacts"], s["log"], *self.indices, self.counts],
            **where,
        )
        self._event = None if stream is None else stream.record_event()

    @property
    def done(self) -> bool:
        """Whether all worlds have been simulated."""
        return self._event is None or self._event.is_complete

    def needs(self) -> list[Room]:
        """Per job, its own room if that was enough, else the room to simulate it with again."""
        if self._event is not None:
            # What reads the results, or frees their memory, comes after the simulation.
            self.wp.get_stream(self.device).wait_event(self._event)
        rows, dropped = self.counts.numpy()
        room = np.repeat([r.rows for r in self.rooms], self.w)
        self.used = np.minimum(rows, room).astype(np.int64)
        lost = np.logical_or.reduceat(dropped > 0, self.start)
        most = np.maximum.reduceat(rows, self.start)
        out: list[Room] = []
        for own, more, n in zip(self.rooms, lost, most, strict=True):
            wanted = Room(own.contacts * (2 if more else 1), max(own.rows, int(n)))
            out.append(wanted if wanted.contacts <= MAX_CONTACTS else own)
        return out

    def collect(self, wanted: Sequence[int], buffer: Buffer | None = None) -> list[Played]:
        """Brings states and logs of `wanted` jobs to the host, after `needs`.

        Args:
            wanted: Indices of jobs.
            buffer: Where states are put; without one they are views of the device's on a CPU.
        """
        flat = [self._fetch(array, buffer) for array in self.out]
        deepest, end = (a.numpy() for a in self.per_world)
        columns = self._log(end)
        first = np.concatenate([[0], np.cumsum(self.cells)])
        out = []
        for i in wanted:
            job, moving = self.jobs[i], int(self.scenes[i].shapes.dynamic.sum())
            shape = (job.n_worlds, job.frames.n_frames - 1, moving)
            states = [a[first[i] : first[i + 1]].reshape(*shape, a.shape[1]) for a in flat]
            span = slice(int(self.start[i]), int(self.start[i] + self.w[i]))
            begin, stop = int(self.offset[span.start]), int(self.offset[span.stop])
            log = _columns(columns, begin, stop, job)
            x, r, v, o = states
            out.append(Played(x, r, v, o, end[span].astype(np.int64), deepest[span], log))
        return out

    def _fetch(self, array: Any, buffer: Buffer | None) -> NDArray[np.float32]:
        if buffer is None:
            return array.numpy()
        _, target = buffer.take((array.shape[0], array.dtype._length_))
        self.wp.copy(self.wp.array(target, dtype=array.dtype, device="cpu", copy=False), array)
        return target

    def _log(self, end: NDArray[np.int32]) -> dict[str, NDArray[Any]]:
        """Rows of all worlds before their ends, sorted by (world, frame, a, b)."""
        from esg.engines.surrogate import kernels

        wp = self.wp
        offset = np.concatenate([[0], np.cumsum(self.used)])
        n = int(offset[-1])
        ints = wp.empty((max(1, n), 4), dtype=int, device=self.device)
        floats = wp.empty((max(1, n), 8), dtype=float, device=self.device)
        wp.launch(
            kernels.pack_logs,
            dim=len(self.scene_of),
            inputs=[self.structs["log"], *self.indices,
                    wp.array(offset.astype(np.int32), dtype=int, device=self.device),
                    ints, floats],
            device=self.device,
            block_dim=BLOCK,
        )  # fmt: skip
        i, f = ints.numpy()[:n], floats.numpy()[:n]
        world = np.repeat(np.arange(len(self.used)), self.used)
        alive = i[:, 0] < end[world]
        order = np.nonzero(alive)[0]
        order = order[np.lexsort((i[order, 2], i[order, 1], i[order, 0], world[order]))]
        self.offset = np.searchsorted(world[order], np.arange(len(self.used) + 1))
        return {"world": self.world_of[world[order]], "ints": i[order], "floats": f[order]}


def _method(by_fields: bool) -> tuple[Any, int]:
    """How bodies meet: the kernel, and how many contact points two shapes or bodies have."""
    if by_fields:
        from esg.engines.surrogate.sdf_kernels import SLOTS, roll

        return roll, SLOTS
    from esg.engines.surrogate.kernels import roll

    return roll, _POINTS


def _models(model: Records, arena: Arena, jobs: list[Job], scenes: list[SceneArrays]) -> Records:
    """Scenes, materials and programs."""
    single = np.float32
    shapes = [s.shapes for s in scenes]
    model.rows["n_bodies"] = [s.n_bodies for s in shapes]
    model.rows["n_worlds"] = [j.n_worlds for j in jobs]
    model.rows["n_primitives"] = [len(j.kind) for j in jobs]
    model.rows["gravity"] = np.array([s.gravity for s in shapes], single)
    for name in ("dt", "n_steps", "record_every"):
        model.rows[name] = [getattr(j.frames, name) for j in jobs]
    # Masses of what cannot move are never used, but must not be zero.
    mass = [np.where(j.mass > 0.0, j.mass, 1.0) for j in jobs]
    arena.data(
        model,
        {name: [s.fields[name] for s in scenes] for name in scenes[0].fields}
        | {
            "mass": [m.astype(single) for m in mass],
            "factor": [(m / s.mass).astype(single) for m, s in zip(mass, shapes, strict=True)],
            "restitution": [j.restitution for j in jobs],
            "ground": [j.ground for j in jobs],
            "friction_scale": [j.friction_scale for j in jobs],
            "features": [j.features for j in jobs],
        },
    )
    model.rows["grounded"] = [j.grounded for j in jobs]
    programs = [_program(j) for j in jobs]
    arena.data(model, {name: [p[name] for p in programs] for name in programs[0]})
    return model


def _program(job: Job) -> dict[str, NDArray[Any]]:
    """A job's program; an array without elements has no address, so that none is one row too."""
    one = np.zeros(1, np.int32)
    if len(job.kind) == 0:
        until, table = np.zeros((1, job.mass.shape[1]), np.int32), np.zeros((job.n_worlds, 1, 1))
        return {"action": one, "target": one, "until": until, "table": table}
    return {
        "action": job.kind,
        "target": job.body,
        "until": job.until.astype(np.int32),
        "table": np.ascontiguousarray(job.table),
    }


def _states(state: Records, arena: Arena, jobs: list[Job], scenes: list[SceneArrays]) -> Records:
    """How all worlds begin."""
    dynamic = [s.shapes.dynamic for s in scenes]
    w = np.array([j.n_worlds for j in jobs], np.int64)
    b = np.array([len(d) for d in dynamic], np.int64)
    primitives = np.maximum(1, [len(j.kind) for j in jobs])
    awake = [d & ~j.asleep for d, j in zip(dynamic, jobs, strict=True)]
    arena.data(
        state,
        {
            "x": [j.position for j in jobs],
            "r": [j.quaternion for j in jobs],
            "friction": [j.friction for j in jobs],
            "damping": [np.tile(j.damping.astype(np.float32), (j.n_worlds, 1, 1)) for j in jobs],
            "awake": [a.astype(np.int32) for a in awake],
        },
    )
    still = ("v", "o", "before_v", "before_o", "delay", "inverse", "idle", "light", "braking",
             "driven", "start", "tips")  # fmt: skip
    arena.fill(state, still, [w, b])
    arena.fill(state, ("touched",), [w, b, b], "minus")
    arena.fill(state, ("done", "active"), [w, primitives])
    return state


def _columns(all_: dict[str, NDArray[Any]], begin: int, end: int, job: Job) -> ContactLog:
    i, f = all_["ints"][begin:end], all_["floats"][begin:end]
    impulse = f[:, 0].astype(float)
    length = np.linalg.norm(f[:, 5:8].astype(float), axis=1, keepdims=True)
    return ContactLog(
        world=all_["world"][begin:end].astype(np.int32),
        frame=i[:, 0].copy(),
        a=i[:, 1].copy(),
        b=i[:, 2].copy(),
        time=(i[:, 3] + 1) * job.frames.dt,
        impulse=impulse,
        depth=f[:, 1].astype(float),
        point=(f[:, 2:5] / impulse[:, None]).astype(float),
        normal=(f[:, 5:8] / np.where(length > 0.0, length, 1.0)).astype(float),
    )
