"""Selection: which of the searched starts of a scene becomes its layout."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from esg.graph.models import EsgDocument, RelationReport
from esg.layout.judge.check import World, intrusions, penetrations, relation_reports, world_poses
from esg.layout.judge.resting import unsupported
from esg.layout.judge.screen import Screen, build_screen, passing
from esg.layout.problem.record import LayoutProblem
from esg.layout.search import SearchResult

HARD_RELATIONS = ("on", "inside_of", "attached_vertical", "attached_horizontal")
"""Relations without which a layout is not feasible."""


@dataclass(frozen=True)
class Found:
    """One start, scored: hard faults, broken relations, energy (less is better)."""

    score: tuple[float, float, float]
    world: World
    result: SearchResult
    start: int
    energy: tuple[float, ...]
    reports: tuple[RelationReport, ...] | None = None
    """Of a layout without any fault; None leaves them to the detailed check."""


def choose_all(
    docs: Sequence[EsgDocument],
    problems: list[LayoutProblem],
    members: list[int],
    results: list[SearchResult],
) -> list[Found]:
    """The best start of every scene: the lowest one where it has no fault, else see `_choose`."""
    out: list[Found | None] = [None] * len(members)
    screens: list[Screen] = []
    firsts: list[tuple[int, Found]] = []
    for k, (i, result) in enumerate(zip(members, results, strict=True)):
        screen = build_screen(docs[i], problems[i])
        if screen is None:
            continue
        total = result.energy.sum(1)
        start = int(np.argmin(np.where(np.isfinite(total), total, np.inf)))
        world = world_poses(problems[i], result.units[start])
        energy = tuple(result.energy[start].tolist())
        score = (0.0, 0.0, float(total[start]))
        screens.append(screen)
        firsts.append((k, Found(score, world, result, start, energy, screen.reports)))
    poses = [np.array([f.world.pose[n] for n in problems[members[k]].names]) for k, f in firsts]
    for (k, found), good in zip(firsts, passing(screens, poses).tolist(), strict=True):
        if good:
            out[k] = found
    return [
        found if found is not None else _choose(docs[i], problems[i], result)
        for found, i, result in zip(out, members, results, strict=True)
    ]


def _choose(doc: EsgDocument, problem: LayoutProblem, result: SearchResult) -> Found:
    """The best start: fewest hard faults, then most relations, then least energy."""
    total = result.energy.sum(1)
    order = np.argsort(np.where(np.isfinite(total), total, np.inf), kind="stable")
    best: Found | None = None
    for k in order[:6].tolist():
        world = world_poses(problem, result.units[k])
        deep = sum(1 for p in penetrations(problem, world) if p[0] > 0.05)
        deep += len(intrusions(problem, world)) + len(unsupported(problem, world))
        reports = relation_reports(doc, problem, world)
        broken = sum(not r.satisfied for r in reports)
        hard = sum(not r.satisfied and r.relation_type in HARD_RELATIONS for r in reports)
        score = (float(deep + hard), float(broken), float(total[k]))
        if best is None or score < best.score:
            energy = tuple(float(v) for v in result.energy[k])
            best = Found(score, world, result, k, energy)
        if deep + hard + broken == 0:
            break
    assert best is not None
    return best
