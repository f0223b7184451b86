"""One launch of the surrogate for worlds of different scenes: arrays, simulation and results."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.fleet.arena import Arena, Buffer
from esg.engines.fleet.jobs import Job, Played, SceneShapes
from esg.engines.scene import ContactLog

_POINTS = 8
BLOCK = 32
"""Threads of a block; one number for all kernels of a module, which is compiled for it."""
THREADS = 131072
"""Threads that a GPU runs side by side, roughly."""

Numbers = NDArray[np.int64]


class Launch:
    """Device arrays of some jobs, their simulation and what comes back.

    Args:
        wp: Warp.
        device: Warp device.
        jobs: Rollouts.
        shapes: Their scenes.
        kept: Arrays of their scenes (`FleetSurrogate.fields`).
        rooms: Contacts and log rows of a world, per job.
    """

    def __init__(
        self,
        wp: Any,
        device: str,
        jobs: list[Job],
        shapes: list[SceneShapes],
        kept: list[dict[str, NDArray[Any]]],
        rooms: list[tuple[int, int]],
    ) -> None:
        self.wp = wp
        from esg.engines.fleet import roll as fleet_roll
        from esg.engines.surrogate import types as surrogate_types

        # Warp's structs and kernels carry what a type checker does not know.
        kernels: Any = fleet_roll
        types: Any = surrogate_types

        self.device, self.jobs, self.shapes = device, jobs, shapes
        arena = Arena(wp, device)
        n = len(jobs)
        w = np.array([j.n_worlds for j in jobs], np.int64)
        b = np.array([s.n_bodies for s in shapes], np.int64)
        p = np.maximum(1, [len(j.kind) for j in jobs])
        d = np.array([int(s.dynamic.sum()) for s in shapes], np.int64)
        frames = np.array([j.frames.n_frames for j in jobs], np.int64)
        contacts, rows = np.array(rooms, np.int64).T
        single, i4 = np.float32, np.int32
        model: Any = np.zeros(n, types.Model.numpy_dtype())
        model["n_bodies"], model["n_worlds"] = b, w
        model["n_primitives"] = [len(j.kind) for j in jobs]
        model["gravity"] = np.array([s.gravity for s in shapes], single)
        for name, a in kept[0].items():
            arena.data(model, name, [k[name] for k in kept], 0 if a.ndim == 1 else a.ndim - 1)
        mass = [np.where(j.mass > 0.0, j.mass, 1.0) for j in jobs]
        arena.data(model, "mass", [m.astype(single) for m in mass], 0)
        arena.data(
            model, "factor",
            [(m / s.mass).astype(single) for m, s in zip(mass, shapes, strict=True)], 0,
        )  # fmt: skip
        arena.data(model, "restitution", [j.restitution for j in jobs], 0)
        arena.data(model, "ground", [j.ground for j in jobs], 1)
        arena.data(model, "friction_scale", [j.friction_scale for j in jobs], 0)
        some = [bool(len(j.kind)) for j in jobs]
        zip_ = list(zip(jobs, some, strict=True))
        arena.data(model, "action", [j.kind if y else np.zeros(1, i4) for j, y in zip_], 0)
        arena.data(model, "target", [j.body if y else np.zeros(1, i4) for j, y in zip_], 0)
        arena.data(
            model, "until",
            [j.until.astype(i4) if y else np.zeros((1, j.mass.shape[1]), i4) for j, y in zip_], 0,
        )  # fmt: skip
        arena.data(
            model, "table",
            [np.ascontiguousarray(j.table) if y else np.zeros((j.n_worlds, 1, 1))
             for j, y in zip_], 0,
        )  # fmt: skip
        state: Any = np.zeros(n, types.State.numpy_dtype())
        arena.data(state, "x", [j.position for j in jobs], 1)
        arena.data(state, "r", [j.quaternion for j in jobs], 1)
        arena.data(state, "friction", [j.friction for j in jobs], 0)
        pairs = list(zip(jobs, shapes, strict=True))
        arena.data(
            state, "damping",
            [np.tile(s.damping.astype(single), (j.n_worlds, 1, 1)) for j, s in pairs], 1,
        )  # fmt: skip
        arena.data(state, "awake", [(s.dynamic & ~j.asleep).astype(i4) for j, s in pairs], 0)
        for name in ("v", "o", "before_v", "before_o"):
            arena.zeros(state, name, [w, b], 12)
        arena.zeros(state, "delay", [w, b], 8)
        arena.zeros(state, "inverse", [w, b], 36)
        for name in ("idle", "light"):
            arena.zeros(state, name, [w, b], 4)
        arena.zeros(state, "touched", [w, b, b], 4, "minus")
        for name in ("done", "active"):
            arena.zeros(state, name, [w, p], 4)
        con: Any = np.zeros(n, types.Contacts.numpy_dtype())
        sizes = {"normal": 12, "side": 12, "arm_a": 12, "arm_b": 12, "share": 12, "impulse": 12,
                 "turn_a": 16, "turn_b": 16}  # fmt: skip
        for name in types.Contacts.vars:
            if name not in ("base", "count", "dropped"):
                arena.zeros(con, name, [w, contacts], sizes.get(name, 4))
        arena.zeros(con, "count", [w, 1], 4)
        arena.zeros(con, "dropped", [w], 4)
        log: Any = np.zeros(n, types.Log.numpy_dtype())
        for name in ("frame", "a", "b", "step", "impulse", "depth"):
            arena.zeros(log, name, [w, rows], 4)
        for name in ("point", "normal"):
            arena.zeros(log, name, [w, rows], 12)
        arena.zeros(log, "count", [w], 4)
        arena.zeros(log, "row", [w, b + 1, b + 1], 4, "minus")
        raw: Any = np.zeros(n, types.Raw.numpy_dtype())
        arena.zeros(raw, "point", [w, _POINTS], 12)
        arena.zeros(raw, "normal", [w, _POINTS], 12)
        arena.zeros(raw, "distance", [w, _POINTS], 4)
        arena.zeros(raw, "count", [w], 4)
        out: Any = np.zeros(n, kernels.Out.numpy_dtype())
        self.cells = w * (frames - 1) * d
        first = np.cumsum(self.cells) - self.cells
        total = max(1, int(self.cells.sum()))
        # States lie densely one scene after the other: one copy brings all of them back.
        self.out = [
            wp.empty(total, dtype=t, device=self.device)
            for t in (wp.vec3, wp.quat, wp.vec3, wp.vec3)
        ]
        for name, array, element in zip("xrvo", self.out, (12, 16, 12, 12), strict=True):
            field = out[name]
            field["data"] = array.ptr + first * element
            field["shape"][:, :3] = np.stack([w, frames - 1, d], axis=1)
            field["strides"][:, :3] = np.stack(
                [(frames - 1) * d * element, d * element, np.full(n, element)], axis=1
            )
            field["ndim"] = 3
        worlds = int(w.sum())
        self.per_world = [wp.zeros(worlds, dtype=t, device=self.device) for t in (float, int)]
        start = np.cumsum(w) - w
        for name, array in zip(("deepest", "end"), self.per_world, strict=True):
            out[name]["data"] = array.ptr + start * 4
            out[name]["shape"][:, 0] = w
            out[name]["strides"][:, 0] = 4
            out[name]["ndim"] = 1
        self._keep = arena.upload()
        self._count = (log["count"]["data"].copy(), con["dropped"]["data"].copy())
        self.w, self.start, self.rows = w, start, rows
        self.scene_of = np.repeat(np.arange(n), w).astype(i4)
        self.world_of = (np.arange(worlds) - np.repeat(start, w)).astype(i4)

        def records(array: Any, struct: Any) -> Any:
            return wp.array(array, dtype=struct, device=self.device)

        self.structs = [
            records(a, t)
            for a, t in (
                (model, types.Model), (state, types.State), (raw, types.Raw),
                (con, types.Contacts), (log, types.Log), (out, kernels.Out),
            )
        ]  # fmt: skip
        self.indices = [wp.array(a, dtype=int, device=self.device)
                        for a in (self.scene_of, self.world_of)]  # fmt: skip
        self.times = [
            wp.array([j.frames.dt for j in jobs], dtype=wp.float64, device=self.device),
            wp.array([j.frames.n_steps for j in jobs], dtype=int, device=self.device),
            wp.array([j.frames.record_every for j in jobs], dtype=int, device=self.device),
        ]
        self.trace = types.Trace()
        self.kernels = kernels
        self.counts = wp.zeros((2, worlds), dtype=int, device=self.device)

    def launch(self, stream: Any = None) -> None:
        """Simulates all worlds to the end.

        Args:
            stream: Of a GPU, beside the one that everything else runs on; `done` says when it has
                ended.
        """
        wp, n = self.wp, len(self.scene_of)
        if stream is not None:
            stream.wait_stream(wp.get_stream(self.device))
        spread = 1
        if self.device != "cpu":
            spread = 1 << min(5, max(0, (THREADS // n).bit_length() - 1))
        wp.launch(
            self.kernels.roll_many,
            dim=spread * n,
            inputs=[*self.structs, self.trace, *self.indices, *self.times, spread],
            device=self.device,
            block_dim=BLOCK,
            stream=stream,
        )
        wp.launch(
            self.kernels.count_rows,
            dim=len(self.scene_of),
            inputs=[self.structs[3], self.structs[4], *self.indices, self.counts],
            device=self.device,
            block_dim=BLOCK,
            stream=stream,
        )
        self._event = None if stream is None else stream.record_event()

    @property
    def done(self) -> bool:
        """Whether all worlds have been simulated."""
        return self._event is None or self._event.is_complete

    def needs(self) -> tuple[NDArray[np.bool_], Numbers]:
        """Per job, whether contacts were dropped, and how many rows a world's log has."""
        if self._event is not None:
            # What reads the results, or frees their memory, comes after the simulation.
            self.wp.get_stream(self.device).wait_event(self._event)
        rows, dropped = self.counts.numpy()
        self.used = np.minimum(rows, np.repeat(self.rows, self.w)).astype(np.int64)
        return np.logical_or.reduceat(dropped > 0, self.start), np.maximum.reduceat(
            rows, self.start
        )

    def collect(self, buffer: Buffer, wanted: list[int]) -> list[tuple[int, Played]]:
        """Brings states and logs to the host; those of `wanted` jobs are returned."""
        wp = self.wp
        flat = []
        for array, width in zip(self.out, (3, 4, 3, 3), strict=True):
            _, target = buffer.take((array.shape[0], width))
            wp.copy(wp.array(target, dtype=array.dtype, device="cpu", copy=False), array)
            flat.append(target)
        deepest, end = (a.numpy() for a in self.per_world)
        columns = self._log(end)
        first = np.concatenate([[0], np.cumsum(self.cells)])
        out = []
        for i in wanted:
            job, s = self.jobs[i], self.shapes[i]
            shape = (job.n_worlds, job.frames.n_frames - 1, int(s.dynamic.sum()))
            states = [a[first[i] : first[i + 1]].reshape(*shape, a.shape[1]) for a in flat]
            span = slice(int(self.start[i]), int(self.start[i] + self.w[i]))
            begin, stop = int(self.offset[span.start]), int(self.offset[span.stop])
            log = _columns(columns, begin, stop, job)
            x, r, v, o = states
            played = Played(x, r, v, o, end[span].astype(np.int64), deepest[span], log)
            out.append((i, played))
        return out

    def _log(self, end: NDArray[np.int32]) -> dict[str, NDArray[Any]]:
        """Rows of all worlds before their ends, sorted by (world, frame, a, b)."""
        wp = self.wp
        offset = np.concatenate([[0], np.cumsum(self.used)])
        n = int(offset[-1])
        ints = wp.zeros((max(1, n), 4), dtype=int, device=self.device)
        floats = wp.zeros((max(1, n), 8), dtype=float, device=self.device)
        wp.launch(
            self.kernels.pack_logs,
            dim=len(self.scene_of),
            inputs=[self.structs[4], *self.indices,
                    wp.array(offset.astype(np.int32), dtype=int, device=self.device),
                    ints, floats],
            device=self.device,
        )  # fmt: skip
        i, f = ints.numpy()[:n], floats.numpy()[:n]
        world = np.repeat(np.arange(len(self.used)), self.used)
        alive = i[:, 0] < end[world]
        order = np.nonzero(alive)[0]
        order = order[np.lexsort((i[order, 2], i[order, 1], i[order, 0], world[order]))]
        self.offset = np.searchsorted(world[order], np.arange(len(self.used) + 1))
        return {"world": self.world_of[world[order]], "ints": i[order], "floats": f[order]}


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
