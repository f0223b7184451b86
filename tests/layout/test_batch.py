"""The same scenes alone, together, on many threads and in many processes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from benchmarks.lib.layout_graphs import generate
from esg.layout import LayoutConfig, solve, solve_batch
from esg.layout import farm as farm_module
from esg.layout.clock import Clock
from esg.layout.judge.check import penetrations, relation_reports, world_poses
from esg.layout.judge.screen import build_screen, passing
from esg.layout.problem.join import join, merge
from esg.layout.problem.poses import Pose2
from esg.layout.problem.problem import build_problem
from esg.layout.problem.record import LayoutProblem
from esg.layout.search import _staged, search_arrays
from tests.layout.builders import bin_, box, document, table

SCENES = (9000, 9001, 9002, 9003, 9004, 9005)


def _problems() -> list[LayoutProblem]:
    return [build_problem(generate(k, 8), k, None) for k in SCENES]


def test_joining_in_two_steps_is_joining_at_once() -> None:
    problems = _problems()
    once = join(problems, "hybrid")
    twice = merge([join(problems[:1], "hybrid"), join(problems[1:4], "hybrid"),
                   join(problems[4:], "hybrid")])  # fmt: skip
    assert once.keys() == twice.keys()
    for key, value in once.items():
        assert value.dtype == twice[key].dtype, key
        assert np.array_equal(value, twice[key]), key


@pytest.mark.slow
def test_many_threads_per_start_find_what_one_thread_finds(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # the kernels of a GPU, on the CPU: with one lane the order of all sums is the same
    data = join(_problems(), "proxy")
    config = LayoutConfig(starts=3, candidates=12, iterations=30)
    seeds = np.arange(len(SCENES))
    one = search_arrays(data, seeds, config, staged=False)
    assert float(one.initial.sum()) > float(one.energy.sum()) > 0.0
    for lanes in (1, 8):
        monkeypatch.setattr(_staged, "__defaults__", (lanes,))
        many = search_arrays(data, seeds, config, staged=True)
        assert np.array_equal(one.steps, many.steps)
        if lanes == 1:
            assert np.array_equal(one.units, many.units)
            assert np.array_equal(one.energy, many.energy)
            assert np.array_equal(one.initial, many.initial)
        else:
            assert np.allclose(one.energy, many.energy, rtol=1e-3, atol=1e-3)


def test_processes_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(farm_module, "LEAST", 2)
    docs = [generate(k, 6) for k in range(7000, 7009)]
    seeds = list(range(9))
    config = LayoutConfig(starts=2, candidates=12, iterations=20)
    beside = LayoutConfig(starts=2, candidates=12, iterations=20, processes=2)
    clock = Clock()
    alone = solve_batch(docs, seeds, config=config)
    shared = solve_batch(docs, seeds, config=beside, clock=clock)
    assert [d.model_dump_json() for d in alone] == [d.model_dump_json() for d in shared]
    assert {"build", "search", "judge", "write"} <= clock.seconds.keys()


def test_a_process_that_fails_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(farm_module, "LEAST", 1)

    def fail(*_: object) -> None:
        raise ValueError("no")

    monkeypatch.setattr("esg.layout.steps.build_problem", fail)
    with pytest.raises(RuntimeError, match="ended early"):
        solve_batch([generate(1, 3)] * 4, config=LayoutConfig(processes=2))


def test_the_screen_never_passes_what_the_check_faults_and_passes_most_of_the_rest() -> None:
    rng = np.random.default_rng(3)
    screens, poses, right = [], [], []
    for k in range(40):
        doc = generate(8000 + k, 5)
        problem = build_problem(doc, k, None)
        solved = solve(doc, seed=k, config=LayoutConfig(starts=4)).layout_result
        assert solved is not None
        # the solution, and the solution with one object moved or turned
        for shift in (0.0, 3.0, 30.0):
            world = world_poses(problem, np.zeros((len(problem.units), 3)))
            pose: dict[str, Pose2] = {
                n: (*p.position_cm[:2], math.radians(p.yaw_deg)) for n, p in solved.poses.items()
            }
            name = problem.names[int(rng.integers(1, len(problem.names)))]
            x, y, yaw = pose[name]
            dx, dy, turn = rng.normal(0.0, shift, 3)
            pose[name] = (x + dx, y + dy, yaw + 0.02 * turn)
            world.pose.update(pose)
            screen = build_screen(doc, problem)
            assert screen is not None
            screens.append(screen)
            poses.append(np.array([world.pose[n] for n in problem.names]))
            reports = relation_reports(doc, problem, world)
            right.append(all(r.satisfied for r in reports) and not penetrations(problem, world))
            if right[-1]:
                assert screen.reports == reports
    passed = passing(screens, poses)
    truth = np.array(right)
    assert not (passed & ~truth).any()
    assert 0.2 < truth.mean() < 0.9
    assert (passed & truth).sum() >= 0.9 * truth.sum()


def test_what_cannot_be_right_has_no_screen() -> None:
    solid = document({"box": box("box", 30, 30, 30), "cube": box("cube", 5, 5, 5)},
                     {"box_1": "box", "cube_1": "cube"},
                     [("cube_1", "inside_of", "box_1")])  # fmt: skip
    assert build_screen(solid, build_problem(solid, 0, None)) is None
    hollow = document({"bin": bin_("bin", 30, 30, 30), "cube": box("cube", 5, 5, 5)},
                      {"bin_1": "bin", "cube_1": "cube"},
                      [("cube_1", "inside_of", "bin_1")])  # fmt: skip
    assert build_screen(hollow, build_problem(hollow, 0, None)) is not None
    high = document({"table": table("table", 80, 80, 75), "cube": box("cube", 5, 5, 5)},
                    {"table_1": "table", "cube_1": "cube"},
                    [("cube_1", "on", "table_1"), ("table_1", "higher_than", "cube_1")])  # fmt: skip
    assert build_screen(high, build_problem(high, 0, None)) is None
