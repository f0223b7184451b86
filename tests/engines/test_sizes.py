"""Few sizes of problems on a GPU: what is rounded keeps its results, and set-up compiles all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.engines.doctor import spheres
from esg.engines.fleet import ahead
from esg.engines.fleet.newton import POINTS
from esg.engines.newton import clear_cache, sharing
from esg.engines.newton.setup import quiet_warp
from esg.engines.newton.sizes import LEAST, MOST, common, rounded, rung
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Shape, SimScene
from esg.engines.shapes import SceneShapes
from esg.outcomes import UserError
from tests.engines.lab import ball, box


def test_there_are_few_rungs_with_room_for_all() -> None:
    sizes = range(1, 4 * MOST)
    assert all(rung(n) >= n for n in sizes)
    assert {rung(n) for n in range(1, MOST + 1)} == {32, 64, 128, 256, 512, 1024}
    # Above, memory that lanes share is scarce: no more than a half is added.
    assert all(rung(n) == rounded(n) <= 1.5 * n for n in sizes if n > MOST)
    assert rung(1) == LEAST


def _compound(scene: SimScene, shapes: int) -> SimScene:
    shape = Shape("sphere", (0.1, 0.1, 0.1))
    first, *others = scene.bodies
    return replace(scene, bodies=(replace(first, shapes=(shape,) * shapes), *others))


@pytest.mark.parametrize("bodies", [1, 2, 3, 5, 6, 8, 10, 11, 12, 16, 21, 22, 30, 42])
@pytest.mark.parametrize("growth", [1, 2])
@pytest.mark.parametrize("shapes", [1, 6, 20, 40])
def test_set_up_compiles_the_sizes_of_common_scenes(bodies: int, growth: int, shapes: int) -> None:
    """Singles, pairs, chains, lines and rings: the solver's sizes are those of a warm kernel."""
    scene = SceneShapes.of(_compound(spheres(bodies), shapes))
    wanted = rung(6 * bodies), rung(growth * POINTS.of(scene))
    assert wanted in {(rung(6 * b), p) for b, p in ahead.searched_sizes()}


def test_no_size_is_compiled_twice() -> None:
    sizes = [(rung(6 * b), rung(p)) for b, p in common(POINTS.world, POINTS.shape)]
    assert len(sizes) == len(set(sizes)) < 24


@pytest.mark.parametrize("bodies", [1, 3])
def test_room_for_more_coordinates_changes_no_result(
    bodies: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Balls hit boxes in worlds as wide as they are and in wider ones: every number is equal."""
    things = [ball("ball", 0.1, 2.0, (-0.4, 0.02, 0.1))]
    things += [box(f"box {k}", (0.1, 0.1, 0.1), 1.0, (0.25 * k, 0, 0.1)) for k in range(bodies - 1)]
    scene = SimScene("row", tuple(things))
    programs = [Program((SetVelocity("ball", 0.0, (v, 0.1, 0.0)),), 0.6) for v in (2.0, 4.0)]
    batch = batch_programs(programs, scene.names)
    widths: list[int] = []
    widen = sharing._widen

    def noted(solver: object, model: object, dofs: int) -> None:
        widen(solver, model, dofs)
        widths.append(solver._world_dof_indices.shape[1])  # type: ignore[attr-defined]

    def played() -> tuple[np.ndarray, ...]:
        clear_cache()
        rollout = get_engine("newton").rollout(scene, batch)
        log = rollout.contacts
        return rollout.position, rollout.quaternion, log.impulse, log.point

    narrow = played()
    monkeypatch.setattr(sharing, "_widens", lambda device: True)
    monkeypatch.setattr(sharing, "_widen", noted)
    try:
        wide = played()
    finally:
        clear_cache()
    assert widths and set(widths) == {32}
    assert all(np.array_equal(a, b) for a, b in zip(narrow, wide, strict=True))


def test_models_name_their_modules_and_launch_nothing() -> None:
    """What plays for real asks for no module that was not named."""
    from warp._src.context import Module

    from esg.engines.doctor import play, tiny_scenes

    quiet_warp()
    scene = tiny_scenes()["sphere + box"]
    clear_cache()
    named = {(m.name, block) for m, _, block in ahead.needed_by([lambda: play(scene)])}
    clear_cache()
    used: set[tuple[str, int | None]] = set()
    load = Module.load

    def noted(self: Module, device: object, block_dim: int | None = None, *more: object) -> object:
        used.add((self.name, block_dim))
        return load(self, device, block_dim, *more)

    Module.load = noted
    try:
        play(scene)
    finally:
        Module.load = load
        clear_cache()
    assert len(used) > 8
    assert used <= named


class _Module:
    """A module that is compiled as `how` says."""

    def __init__(self, name: str, how: object) -> None:
        self.name, self.how = name, how

    def load(self, device: object, block_dim: int | None) -> None:
        if isinstance(self.how, Exception):
            raise self.how


@pytest.mark.parametrize("forks", [True, False])
def test_a_module_that_cannot_be_compiled_is_one_message(
    forks: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In processes and in threads: its name and the compiler's first line, exit code 1."""
    if not forks:
        monkeypatch.setattr(ahead.multiprocessing, "get_all_start_methods", lambda: ["spawn"])
    bad = _Module("wrong", RuntimeError("no space left\nwhere it was"))
    told: list[str] = []
    modules = [_Module("good", None), bad]
    with pytest.raises(UserError, match=r"kernels of wrong .*: no space left$") as caught:
        ahead.compile_all(
            {(m, "cpu", 1): None for m in modules}, lambda name, done, total: told.append(name)
        )
    assert caught.value.exit_code == 1
    assert set(told) <= {"good"}


def test_all_modules_are_told() -> None:
    told: list[tuple[int, int]] = []
    modules = [_Module(f"m{k}", None) for k in range(5)]
    ahead.compile_all(
        {(m, "cpu", 1): None for m in modules}, lambda name, done, total: told.append((done, total))
    )
    assert told == [(k + 1, 5) for k in range(5)]


def test_tiny_scenes_are_collided_as_large_ones_for_a_while() -> None:
    """Newton still decides by these numbers, and has them back afterwards."""
    from newton._src.sim import collide

    before = {k: v for k, v in vars(collide).items() if k.startswith("_SPLIT_")}
    limits = {k for k in before if k.endswith("PAIR_COUNT_THRESHOLD")}
    assert len(limits) == 2
    with ahead._many_pairs():
        assert all(getattr(collide, k) == 0 for k in limits)
    assert {k: v for k, v in vars(collide).items() if k.startswith("_SPLIT_")} == before
