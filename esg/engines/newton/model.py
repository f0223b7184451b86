"""A Newton model of the worlds of one scene or of several, its captured step and its buffers.

A model depends only on the structure of its scenes: which bodies exist, their collision shapes,
whether they are static and which ground they touch. Poses, masses, inertias, materials, damping and
programs are arrays that jobs bring with them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.jobs import Buffer, Job, Pieces, Played
from esg.engines.newton.breaking import Shatter, parked
from esg.engines.newton.builder import MARK, Blueprint, Wanted
from esg.engines.newton.jointed import Jointed
from esg.engines.newton.places import Places
from esg.engines.newton.setup import FIXED_POINT
from esg.engines.newton.sizes import rounded, rung
from esg.engines.newton.swaps import Swaps
from esg.engines.newton.trees import AXES, plan_trees
from esg.engines.newton.worlds import AxisRows, NewtonWorlds, Singles
from esg.engines.program import FIELDS, Action, Column
from esg.engines.scene import ContactLog
from esg.engines.shapes import SceneShapes
from esg.units import quat_multiply, quat_rotate

CHUNK_FRAMES = 8
"""Frames whose pairs are summed up before they are packed; a graph's steps go into their steps."""
_LEAST_PRIMITIVES = 16
_LEAST_FRAMES = 256
_ROWS_PER_WORLD, _MOST_ROWS = 64, 1_000_000
"""Room for touches before a pass is played again: of all pairs in all frames, between these."""


@dataclass(frozen=True)
class Points:
    """Room for contact points before it has to grow, which the solver visits all of in every step.

    Args:
        world: Of a world.
        body, shape: Of each moving body and each of its shapes in a world.
        rounded: Whether the room of the most crowded world is rounded up, so that models of many
            scenes find their kernels compiled.
    """

    world: int
    body: int
    shape: int
    rounded: bool

    def of(self, s: SceneShapes) -> int:
        """Of a world of a scene."""
        shapes = int(np.diff(s.first)[s.dynamic].sum())
        return self.world + self.body * int(s.dynamic.sum()) + self.shape * shapes


class NewtonModel(NewtonWorlds):
    """Worlds of several scenes, the captured step and its buffers.

    Args:
        wanted: Per scene its key, the number of its worlds and the factor on room for contacts.
        shapes: Of the scenes.
        blueprint: Of these worlds.
        device: Warp device.
        points: Room for contact points.
        ground: Whether contacts with the ground can be logged; jobs say whether they are.
    """

    def __init__(
        self,
        wanted: Wanted,
        shapes: list[SceneShapes],
        blueprint: Blueprint,
        device: str,
        points: Points,
        *,
        ground: bool = False,
    ) -> None:
        copies = np.array([w for _, w, _ in wanted])
        most = max(s.n_bodies for s in shapes)
        super().__init__(device, int(copies.sum()), most)
        self.wanted, self.shapes, self.copies = wanted, shapes, copies
        self.scene_of = np.repeat(np.arange(len(copies)), copies)
        self.owners = blueprint.owners
        self.last: dict[int, Job] = {}
        self.frames = 0
        self.rows = 0
        with self.wp.ScopedDevice(device):
            self._build(blueprint, points)
            self._make_arrays(ground)
            self.jointed = self._join()
            if any(s.brittle for s in shapes):
                own = self.dynamic.numpy()
                self.shatter = Shatter(self.model, shapes, self.scene_of, own)
            if any(s.stances for s in shapes):
                self.swaps = Swaps(self.model, shapes, self.scene_of, self.dynamic.numpy())

    def _join(self) -> Jointed | None:
        """The joints of all scenes."""
        if not any(s.joints for s in self.shapes):
            return None
        local = [np.where(s.dynamic, np.cumsum(s.dynamic) - 1, -1) for s in self.shapes]
        marks: list[dict[int, int]] = []
        for w, k in enumerate(self.scene_of):
            first = self.first_shapes[w] + np.nonzero(self.owners[k] == MARK)[0]
            tied = [b for b in self.plans[k].tied if local[k][b] >= 0]
            marks.append(dict(zip(tied, first.tolist(), strict=True)))
        places = Places.of(self.model, self.plans, self.scene_of, self.first_body, local)
        return Jointed(self.model, places, marks)

    def _axis_rows(self) -> AxisRows | None:
        if not any(s.joints for s in self.shapes):
            return None
        axes = [
            [n.record for n in plan.links if n.record is not None and n.record.kind in AXES]
            for plan in self.plans
        ]
        rows = 3 * max(len(of) for of in axes)
        limited = [r.lower is not None or r.upper is not None for of in axes for r in of]
        return AxisRows(
            axes=rung(rows) if self.on_gpu and rows else rows,
            limits=any(limited),
            loose=any(plan.loose for plan in self.plans),
        )

    def _build(self, blueprint: Blueprint, room: Points) -> None:
        self.plans = [plan_trees(s.joints, s.ends, s.dynamic) for s in self.shapes]
        points = [
            growth * room.of(s) + len(plan.ties)
            for (_, _, growth), s, plan in zip(self.wanted, self.shapes, self.plans, strict=True)
        ]
        most = max(points)
        n_shapes = np.array([len(o) for o in self.owners])[self.scene_of]
        n_moving = np.array([int(s.dynamic.sum()) for s in self.shapes])[self.scene_of]
        self.first_shapes = np.concatenate([[0], np.cumsum(n_shapes)])
        self.first_body = np.concatenate([[0], np.cumsum(n_moving)])
        self._finalize(
            blueprint.builder,
            self.first_shapes,
            int(self.first_body[-1]),
            int((np.array(points) * self.copies).sum()),
            self._room_for(most, room),
            self._axis_rows(),
        )

    def _room_for(self, points: int, room: Points) -> int:
        """Of the most crowded world, as the solver is told."""
        if self.on_gpu:
            return rung(points)
        return rounded(points) if room.rounded else points

    def _make_arrays(self, ground: bool) -> None:
        b = self.n_bodies
        dynamic = np.full((self.n_worlds, b), -1, np.int32)
        self._pair_of = np.full((len(self.shapes), b + 1, b + 1), -1, np.int32)
        self.pairs: list[NDArray[np.int64]] = []
        for k, s in enumerate(self.shapes):
            rows = np.nonzero(self.scene_of == k)[0]
            local = np.cumsum(s.dynamic) - 1
            dynamic[rows, : s.n_bodies] = np.where(
                s.dynamic, self.first_body[rows][:, None] + local, -1
            )
            pairs = _pairs(s, ground)
            self.pairs.append(pairs)
            self._pair_of[k, pairs[:, 0] + 1, pairs[:, 1] + 1] = np.arange(len(pairs))
        self._pair_of = np.maximum(self._pair_of, self._pair_of.swapaxes(1, 2))
        self._logs_ground = np.full(len(self.shapes), ground)
        counts = np.array([len(p) for p in self.pairs])[self.scene_of]
        self.first_pairs = np.concatenate([[0], np.cumsum(counts)])
        self.n_pairs = max(1, int(self.first_pairs[-1]))
        self.owner = np.concatenate([self.owners[k] for k in self.scene_of])
        self._allocate(
            dynamic, self._pair_of[self.scene_of], self.first_pairs, self.first_shapes, self.owner,
            CHUNK_FRAMES,
        )  # fmt: skip
        self.count = self.wp.zeros(1, dtype=int)

    # -- one pass ----------------------------------------------------------------------------------

    def play(
        self, jobs: list[Job], buffer: Buffer | None, seconds: dict[str, float]
    ) -> Pieces[tuple[list[Played], NDArray[np.bool_]]]:
        """Plays jobs of the model's scenes; also tells whose contacts found no room.

        Worlds that nobody asks for play their last job again. Wall clock is added to `seconds`. It
        comes in pieces of a few frames, so that somebody else may use the device between them.
        States are put into `buffer`, or into new arrays without one.
        """
        frames = max(j.frames.n_frames for j in jobs) - 1
        every = jobs[0].frames.record_every
        chosen = self._places(jobs)
        self.last.update(zip(chosen, jobs, strict=True))
        everything = [self.last[k] for k in range(len(self.wanted))]
        begin = time.perf_counter()
        with self.wp.ScopedDevice(self.device):
            self._load(everything, frames, every)
            graph = self.prepare()
        seconds["load"] += time.perf_counter() - begin
        yield
        chunks = self._run(graph, frames, every)
        left = True
        while left:
            begin = time.perf_counter()
            with self.wp.ScopedDevice(self.device):
                left = next(chunks, None) is not None
            seconds["run"] += time.perf_counter() - begin
            yield
        begin = time.perf_counter()
        with self.wp.ScopedDevice(self.device):
            if self.device != "cpu":
                self.wp.synchronize_stream(self.wp.get_stream(self.device))
            ran = time.perf_counter()
            played, full = self._read(everything, frames, buffer, set(chosen))
        seconds["run"] += ran - begin
        seconds["read"] += time.perf_counter() - ran
        return [played[k] for k in chosen], full[chosen]

    def _places(self, jobs: list[Job]) -> list[int]:
        """Where in the model jobs are played; a scene may have several places."""
        free: dict[tuple[int, int], list[int]] = {}
        for k, (key, worlds, _) in enumerate(self.wanted):
            free.setdefault((key, worlds), []).append(k)
        return [free[j.key, j.n_worlds].pop(0) for j in jobs]

    def _load(self, jobs: list[Job], frames: int, every: int) -> None:
        wp = self.wp
        if self.shatter is not None or self.swaps is not None:
            jobs = [parked(j, s) for j, s in zip(jobs, self.shapes, strict=True)]
        move = [np.nonzero(s.dynamic)[0] for s in self.shapes]
        pairs = list(zip(jobs, move, strict=True))

        def bodies(values: list[Any]) -> Singles:
            return np.concatenate(values).astype(np.float32)

        if self.model.body_count:
            mass = bodies([j.mass[:, d].reshape(-1) for j, d in pairs])
            inertia = bodies([j.inertia.reshape(-1, 3, 3) for j in jobs])
            damping = bodies([np.tile(j.damping[d], (j.n_worlds, 1)) for j, d in pairs])
            ground = bodies([np.tile(j.features[d], (j.n_worlds, 1)) for j, d in pairs])
            self._load_bodies(mass, inertia, damping, ground)
        self._load_materials(jobs)
        self.friction_scale.assign(np.concatenate([j.friction_scale for j in jobs]))
        self._load_states(bodies([
            np.concatenate([j.position[:, d], j.quaternion[:, d]], axis=-1).reshape(-1, 7)
            for j, d in pairs
        ]), None if self.jointed is None else self.jointed.load(
            [(j.position.astype(float), j.quaternion.astype(float)) for j in jobs]
        ))  # fmt: skip
        if self.shatter is not None:
            self.shatter.load(
                [(j.position.astype(float), j.quaternion.astype(float)) for j in jobs]
            )
        if self.swaps is not None:
            self.swaps.load(jobs)
        self._load_batches(jobs)
        self._choose_pairs(jobs)
        if frames > self.frames:
            self.frames = frames = max(_LEAST_FRAMES, frames)
            n = max(1, self.model.body_count)
            self.out_q = wp.zeros((frames, n), dtype=wp.transform)
            self.out_qd = wp.zeros((frames, n), dtype=wp.spatial_vector)
            self._graphs.clear()
        self._start(jobs[0].frames.dt, every, CHUNK_FRAMES)

    def _choose_pairs(self, jobs: list[Job]) -> None:
        """Tells the kernels which pairs are logged."""
        wanted = np.array([j.ground_contacts for j in jobs])
        if np.array_equal(wanted, self._logs_ground):
            return
        self._logs_ground = wanted
        pair = self._pair_of.copy()
        pair[~wanted, 0, :] = -1
        pair[~wanted, :, 0] = -1
        self.pair.assign(pair[self.scene_of])

    def _load_materials(self, jobs: list[Job]) -> None:
        """Materials of all shapes, and poses of those that stand still."""
        mu = np.empty(len(self.owner), np.float32)
        restitution = np.empty_like(mu)
        pose = self.model.shape_transform.numpy()
        for k, (job, s) in enumerate(zip(jobs, self.shapes, strict=True)):
            w, own = job.n_worlds, self.owners[k]
            world = int(self.copies[:k].sum())
            span = slice(self.first_shapes[world], self.first_shapes[world + w])
            m = np.empty((w, len(own)), np.float32)
            r = np.empty_like(m)
            solid = own[own >= 0]
            of = slice(2, 2 + len(solid))
            m[:, of], r[:, of] = job.friction[:, solid], job.restitution[:, solid]
            m[:, :2], r[:, :2] = job.ground[:, :2], job.ground[:, 2:]
            # Marks are all that is left.
            m[:, of.stop :] = r[:, of.stop :] = 0.0
            mu[span], restitution[span] = m.reshape(-1), r.reshape(-1)
            still = np.nonzero(s.static[solid])[0]
            if len(still):
                rows = pose[span].reshape(w, len(own), 7)
                body, shape = solid[still], _shape_numbers(s)[still]
                q = job.quaternion[:, body].astype(float)
                local = np.broadcast_to(s.origin[shape], (w, len(still), 3))
                rows[:, 2 + still, :3] = job.position[:, body] + quat_rotate(q, local)
                turn = np.broadcast_to(s.rotation[shape], (w, len(still), 4))
                rows[:, 2 + still, 3:] = quat_multiply(q, turn)
        self._load_shapes(mu, restitution, pose)

    def _load_batches(self, jobs: list[Job]) -> None:
        w, b = self.n_worlds, self.n_bodies
        p = self._room(max(len(j.kind) for j in jobs), _LEAST_PRIMITIVES)
        kind, body = np.zeros((w, p), np.int32), np.zeros((w, p), np.int32)
        until, table = np.zeros((w, p, b), np.int32), np.zeros((w, p, FIELDS))
        count = np.zeros(w, np.int32)
        at, changes = 0, False
        for j in jobs:
            rows, n = slice(at, at + j.n_worlds), len(j.kind)
            kind[rows, :n], body[rows, :n] = j.kind, j.body
            until[rows, :n, : j.until.shape[1]] = j.until
            table[rows, :n] = j.table
            count[rows] = n
            changes |= bool(np.isfinite(j.table[:, j.kind == Action.ADJUST, Column.FRICTION]).any())
            at += j.n_worlds
        self._load_programs(kind, body, until, table, count)
        self.has_friction_change = changes
        if self.jointed is not None and self.jointed.load_drives([j.joint for j in jobs], p):
            self._graphs.clear()

    def _run(self, graph: Any, frames: int, every: int) -> Iterator[int]:
        """Plays all frames chunk by chunk and gathers the pairs that touched."""
        from esg.engines.newton import kernels

        wp = self.wp
        least = _ROWS_PER_WORLD * self.n_worlds
        self._reserve_rows(max(least, min(frames * self.n_pairs, _MOST_ROWS)))
        self.count.zero_()
        done = 0
        for first in range(0, frames, CHUNK_FRAMES):
            n = min(CHUNK_FRAMES, frames - first)
            if first:
                # The step counter lives on the device; only where the chunk begins is written.
                wp.launch(kernels.begin_chunk, dim=1, inputs=[self.clock, first, n])
            else:
                self._clock[3] = n
                self.clock.assign(self._clock)
            target = (first + n) * every
            launches = -(-(target - done) // self.graph_steps)
            for _ in range(launches):
                wp.capture_launch(graph)
            done += launches * self.graph_steps
            wp.launch(
                kernels.pack_pairs,
                dim=(n, self.n_pairs),
                inputs=[first + 1, self.impulse, self.first, self.depth, self.moments, self.count,
                        self.ints, self.depths, self.sums],
            )  # fmt: skip
            yield first

    def _reserve_rows(self, n: int) -> None:
        if n <= self.rows:
            return
        wp = self.wp
        self.rows = n
        self.ints = wp.zeros((n, 3), dtype=int)
        self.depths = wp.zeros(n, dtype=float)
        self.sums = wp.zeros((n, 7), dtype=wp.int64)

    def _read(
        self, jobs: list[Job], frames: int, buffer: Buffer | None, asked: set[int]
    ) -> tuple[dict[int, Played], NDArray[np.bool_]]:
        used = int(self.count.numpy()[0])
        if used > self.rows:
            # The list of touches was too short: play the pass again with room for all.
            self._reserve_rows(used)
            every = jobs[0].frames.record_every
            self._load(jobs, frames, every)
            for _ in self._run(self.prepare(), frames, every):
                pass
            used = int(self.count.numpy()[0])
        pose, velocity = self._fetch(frames, buffer)
        n = used
        ints, depths, sums = (a[:n].numpy() for a in (self.ints, self.depths, self.sums))
        world = np.searchsorted(self.first_pairs, ints[:, 1], side="right") - 1
        order = np.lexsort((ints[:, 1], ints[:, 0], world))
        world, ints, depths, sums = world[order], ints[order], depths[order], sums[order]
        overflow = self.solver.constraint_overflow.numpy()
        full = np.asarray(overflow[: self.n_worlds], bool) | bool(overflow[self.n_worlds :].any())
        over = np.zeros(len(jobs), bool)
        out: dict[int, Played] = {}
        at = -jobs[0].n_worlds
        for k, job in enumerate(jobs):
            at += jobs[k - 1].n_worlds if k else jobs[0].n_worlds
            if k not in asked:
                continue
            w, t = job.n_worlds, job.frames.n_frames - 1
            d = int(self.shapes[k].dynamic.sum())
            columns = slice(self.first_body[at], self.first_body[at + w])
            p = pose[:t, columns].reshape(t, w, d, 7).swapaxes(0, 1)
            v = velocity[:t, columns].reshape(t, w, d, 6).swapaxes(0, 1)
            begin, stop = np.searchsorted(world, [at, at + w])
            rows = slice(begin, stop)
            log = self._log(k, job, world[rows] - at, ints[rows], depths[rows], sums[rows],
                            self.first_pairs[world[rows]])  # fmt: skip
            out[k] = Played(p[..., :3], p[..., 3:], v[..., :3], v[..., 3:], None, None, log)
            over[k] = full[at : at + w].any()
        return out, over

    def _fetch(self, frames: int, buffer: Buffer | None) -> list[Singles]:
        """Poses [T, D, 7] and velocities [T, D, 6] of all moving bodies."""
        wp, n = self.wp, self.model.body_count
        out: list[Singles] = []
        for source, width in ((self.out_q, 7), (self.out_qd, 6)):
            if buffer is None:
                out.append(source.numpy()[:frames].copy())
                continue
            target = buffer.take((frames, n, width))[1]
            if n:
                into = wp.array(target, dtype=source.dtype, device="cpu", copy=False)
                wp.copy(into, source, count=frames * n)
            out.append(target)
        return out

    def _log(
        self,
        k: int,
        job: Job,
        world: NDArray[np.int64],
        ints: NDArray[np.int32],
        depths: Singles,
        sums: NDArray[np.int64],
        first_pair: NDArray[np.int64],
    ) -> ContactLog:
        bodies = self.pairs[k][ints[:, 1] - first_pair]
        impulse = sums[:, 0].astype(float)
        moments = sums[:, 1:].astype(float) / impulse[:, None]
        normal = moments[:, 3:]
        length = np.linalg.norm(normal, axis=1, keepdims=True)
        return ContactLog(
            world=world.astype(np.int32),
            frame=ints[:, 0].astype(np.int32),
            a=bodies[:, 0].astype(np.int32),
            b=bodies[:, 1].astype(np.int32),
            time=(ints[:, 2] + 1).astype(float) * job.frames.dt,
            impulse=impulse / FIXED_POINT,
            depth=np.maximum(depths.astype(float), 0.0),
            point=moments[:, :3],
            normal=normal / np.where(length > 0.0, length, 1.0),
        )


def _pairs(s: SceneShapes, ground: bool) -> NDArray[np.int64]:
    """Pairs of bodies that may touch, one of them moving, sorted; -1 is the ground, [P, 2]."""
    n = s.n_bodies
    a, b = np.nonzero(np.triu(s.dynamic[:, None] | s.dynamic[None], 1))
    if ground:
        moving = np.nonzero(s.dynamic)[0]
        a, b = np.append(a, moving), np.append(b, np.full(len(moving), -1))
    order = np.argsort(a * (n + 1) + b + 1)
    return np.stack([a, b], axis=1)[order]


def _shape_numbers(s: SceneShapes) -> NDArray[np.int64]:
    """Numbers of the shapes that Newton's worlds hold, in their order."""
    return np.array(
        [i for b in range(s.n_bodies) if s.collides[b] for i in range(s.first[b], s.first[b + 1])],
        int,
    )
