"""The rounds of a layout around its search: build, choose, emphasize what is broken, report."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import replace
import math
from typing import Any

import numpy as np

from esg.graph.joints import Frame, pose_of
from esg.graph.models import EsgDocument, LayoutResult, Pose
from esg.layout.clock import Clock
from esg.layout.config import LayoutConfig
from esg.layout.judge.check import World, intrusions, penetrations, relation_reports
from esg.layout.judge.patterns import pattern_reports
from esg.layout.judge.resting import unsupported
from esg.layout.judge.selection import HARD_RELATIONS, Found, choose_all
from esg.layout.problem.hints import StartHints
from esg.layout.problem.join import join
from esg.layout.problem.problem import build_problem
from esg.layout.problem.record import LayoutProblem
from esg.layout.search import EvaluateRequest, Request, SearchRequest, batches
from esg.units import quat_from_euler_deg

MAX_PENETRATION_CM = 2.0
WORK = 40_000
"""Starts times terms of one scene: huge scenes get fewer starts, so that time stays bounded."""


def solve_steps(
    docs: Sequence[EsgDocument],
    seeds: Sequence[int],
    plans: Sequence[StartHints | None],
    config: LayoutConfig,
    clock: Clock,
) -> Generator[Request, Any, list[LayoutResult]]:
    """Everything but the search: yields what is to be searched and is sent what was found.

    So the same code runs beside the search or in a process of its own.

    Yields:
        Joined scenes to search or to evaluate (`esg.layout.search.answer` serves them).

    Returns:
        One result per document.
    """
    clock.start()
    problems = [build_problem(d, s, h) for d, s, h in zip(docs, seeds, plans, strict=True)]
    plain = list(problems)
    best: list[Found | None] = [None] * len(docs)
    open_ = list(range(len(docs)))
    for round_ in range(max(1, config.rounds)):
        settings = config
        if round_ > 0:  # truth before tidiness, and more weight for what is still broken
            settings = replace(
                config,
                candidates=2 * config.candidates,
                iterations=2 * config.iterations,
                alignment_weight=0.1 * config.alignment_weight,
            )
            for i in open_:
                problems[i] = _emphasize(docs[i], problems[i], best[i])
        again = []
        for members, request in _requests(problems, seeds, open_, round_, settings):
            clock.lap("build")
            searched = yield request
            clock.start()
            results = searched.split(request.unit_count, request.config.starts)
            chosen = choose_all(docs, problems, members, results)
            for i, found in zip(members, chosen, strict=True):
                current = best[i]
                if current is None or found.score < current.score:
                    best[i] = found
                if sum(best[i].score[:2]) > 0 and not _is_hopeless(plain[i]):  # type: ignore[union-attr]  # set above
                    again.append(i)
            clock.lap("judge")
        open_ = sorted(again)
        if not open_:
            break
    # reported energies have the weights of the document, whatever a retry emphasized
    retried = [i for i, p in enumerate(problems) if p is not plain[i]]
    if retried:
        poses = [best[i].result.units[best[i].start] for i in retried]  # type: ignore[union-attr]
        data = join([plain[i] for i in retried], config.collision)
        clock.lap("build")
        fresh = yield EvaluateRequest(data, np.concatenate(poses), config)
        clock.start()
        for i, e in zip(retried, fresh, strict=True):
            best[i] = replace(best[i], energy=tuple(float(v) for v in e))  # type: ignore[type-var]
    out = []
    for doc, problem, found in zip(docs, plain, best, strict=True):
        assert found is not None
        out.append(_result(doc, problem, found))
    clock.lap("write")
    return out


def _requests(
    problems: list[LayoutProblem],
    seeds: Sequence[int],
    which: list[int],
    round_: int,
    config: LayoutConfig,
) -> Generator[tuple[list[int], SearchRequest]]:
    """One search per number of starts; a scene's number follows from its own size alone."""
    groups: dict[int, list[int]] = {}
    for i in which:
        size = len(problems[i].pair) + len(problems[i].edge_kind) + 1
        groups.setdefault(min(config.starts, max(2, WORK // size)), []).append(i)
    for starts, group in sorted(groups.items()):
        sizes = [starts * len(problems[i].units) * len(problems[i].node_unit) for i in group]
        for part in batches(sizes):
            members = group[part]
            yield (
                members,
                SearchRequest(
                    join([problems[i] for i in members], config.collision),
                    np.array([seeds[i] + 7907 * round_ for i in members], np.int64),
                    tuple(len(problems[i].units) for i in members),
                    replace(config, starts=starts),
                ),
            )


def _level(problem: LayoutProblem, name: str) -> float:
    """Height in its parent of the surface that carries an object [cm]: one shelf of several."""
    return round(problem.supports.of[name].z_cm + problem.shape[name].bottom, 1)


def _is_hopeless(problem: LayoutProblem) -> bool:
    """Whether a surface is smaller than what must stand on it: more search cannot help."""
    need: dict[tuple[str, float], float] = {}
    room: dict[tuple[str, float], float] = {}
    count: dict[tuple[str, float], int] = {}
    for n, s in problem.supports.of.items():
        if s.parent is None or s.rect is None or s.kind not in ("on", "inside"):
            continue
        shape = problem.shape[n]
        if not shape.is_decal:
            at = (s.parent, _level(problem, n))
            need[at] = need.get(at, 0.0) + (
                math.pi * shape.hx**2 if shape.is_round else 4 * shape.hx * shape.hy
            )
            area = (s.rect[2] - s.rect[0]) * (s.rect[3] - s.rect[1])
            room[at] = max(room.get(at, 0.0), area)
            count[at] = count.get(at, 0) + 1
    return any(need[at] > room[at] for at in need if count[at] > 1)


def _emphasize(doc: EsgDocument, problem: LayoutProblem, found: Found | None) -> LayoutProblem:
    """Triples the weight of relations that the best layout so far breaks."""
    if found is None:
        return problem
    reports = relation_reports(doc, problem, found.world)
    binary = len(doc.spatial_relation_graph.edges.binary_relations)
    broken = {
        f"b{k}" if k < binary else f"m{k - binary}"
        for k, r in enumerate(reports)
        if not r.satisfied
    }
    weight = problem.edge_w * np.array([3.0 if t.source in broken else 1.0 for t in problem.terms])
    return replace(problem, edge_w=weight.astype(np.float32))


def _reason(
    doc: EsgDocument, problem: LayoutProblem, deep: list[tuple[float, str, str]], hard: list[str]
) -> str:
    """Why a layout is not feasible, in words."""
    parts = []
    crowded: dict[str | None, list[str]] = {}
    for _, a, b in deep:
        pa, pb = problem.supports.of[a].parent, problem.supports.of[b].parent
        if pa == pb:
            crowded.setdefault(pa, []).extend([a, b])
        else:
            parts.append(f"{a} and {b} overlap")
    for parent, members in sorted(crowded.items(), key=lambda t: str(t[0])):
        if parent is None:
            parts += [f"{a} and {b} overlap" for _, a, b in deep if {a, b} <= set(members)]
            continue
        level = problem.supports.of[members[0]].rect, _level(problem, members[0])
        on = [
            n for n, s in problem.supports.of.items()
            if s.parent == parent and (s.rect, _level(problem, n)) == level
        ]  # fmt: skip
        area = sum(4 * problem.shape[n].hx * problem.shape[n].hy for n in on) / 1e4
        rect = problem.supports.of[on[0]].rect
        room = (rect[2] - rect[0]) * (rect[3] - rect[1]) / 1e4 if rect else math.inf
        parts.append(
            f"{parent} is too small: {len(on)} objects need {area:.2f} m2 of {room:.2f} m2"
        )
    return "; ".join([*parts, *hard])


def _pose(problem: LayoutProblem, world: World, name: str) -> Pose:
    x, y, yaw = world.pose[name]
    z = world.z[name]
    tilt = problem.joined.tilt.get(name)
    turned = math.degrees(math.remainder(yaw, 2 * math.pi))
    if tilt is not None:
        flat = Frame(np.array([x, y, z]), quat_from_euler_deg(turned))
        return pose_of(flat.then(tilt))
    return Pose(position_cm=(round(x, 4), round(y, 4), round(z, 4)), yaw_deg=round(turned, 4))


def _result(doc: EsgDocument, problem: LayoutProblem, found: Found) -> LayoutResult:
    """What the document says about its layout."""
    world, result, k = found.world, found.result, found.start
    fine = found.reports is not None
    deep = [] if fine else penetrations(problem, world)
    reports = found.reports or relation_reports(doc, problem, world)
    hard = [
        f"{r.edge} does not hold{': ' + r.note if r.note else ''}"
        for r in reports
        if not r.satisfied and r.relation_type in HARD_RELATIONS
    ]
    bad = [d for d in deep if d[0] >= MAX_PENETRATION_CM]
    supports = [f"{n} {s.note}" for n, s in problem.supports.of.items() if s.note]
    blocked = [] if fine else intrusions(problem, world)
    blocked = [f"{n} stands in {label}" for _, n, label in blocked]
    loose = [] if fine else unsupported(problem, world)
    hung = [f"{n} hangs in the air beside {parent}" for _, n, parent in loose]
    feasible = not bad and not hard and not supports and not blocked and not hung
    reason = _reason(doc, problem, bad, [*hard, *supports, *blocked, *hung])
    (x0, y0, _), (x1, y1, _) = doc.scene_definition.coordinate_system.world_bounds_cm
    away = [
        f"{n} starts outside the world bounds"
        for n, (x, y, _) in world.pose.items()
        if not (x0 <= x <= x1 and y0 <= y <= y1)
    ]
    notes = "; ".join([*problem.notes, *away])
    poses = {n: _pose(problem, world, n) for n in problem.names}
    relation, collision, region = found.energy
    return LayoutResult(
        poses=poses,
        energy=round(relation + collision + region, 4),
        energy_terms={
            "relation": round(relation, 4),
            "collision": round(collision, 4),
            "region": round(region, 4),
            "initial": round(float(result.initial[k].sum()), 4),
        },
        relations=reports,
        patterns=pattern_reports(doc, problem, world) or None,
        max_penetration_cm=round(deep[0][0] if deep else 0.0, 4),
        feasible=feasible,
        reason="; ".join(p for p in (reason, notes) if p),
    )
