from __future__ import annotations

from pathlib import Path

from helpers import first_touches, written
import numpy as np
import pytest
from random_scenes import random_scene

from esg.compile import compile_many, replay_class
from esg.compile.build import Library, read_classes
from esg.engines.program import Program, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Rollout, SimScene, Variation

ENGINES = ("physx", "rapier")
START_SHIFT_M = 1e-7
SHIFTS = 8


def sensitivity(scene: SimScene, program: Program, rollout: Rollout, engine: str) -> float:
    """How far the program's own result moves [m] when its start moves by 0.1 micrometres.

    The largest of several shifts: a chaotic scene answers only some directions.
    """
    start = np.array([b.position for b in scene.bodies])
    shifts = np.random.default_rng(0).normal(size=(SHIFTS, *start.shape)) * START_SHIFT_M
    batch = batch_programs([program] * SHIFTS, scene.names)
    moved = get_engine(engine).rollout(scene, batch, variation=Variation(start + shifts))
    return float(np.abs(moved.position - rollout.position).max())


def compare(root: Path, seeds: range, engine: str) -> None:
    """Every class compiles, and runs as its program does in the same engine."""
    scenes = {seed: random_scene(seed, guided=engine == "physx") for seed in seeds}
    folders = {seed: written(root / str(seed), *case) for seed, case in scenes.items()}
    assert all(isinstance(x, Library) for x in compile_many(read_classes(folders.values())))
    for seed, (scene, program, _) in scenes.items():
        one = replay_class(folders[seed], engine=engine).rollout  # type: ignore[arg-type]
        two = get_engine(engine).rollout(scene, batch_programs([program], scene.names))
        times, others = first_touches(one), first_touches(two)
        assert times.keys() == others.keys(), seed
        late = [abs(times[p] - others[p]) for p in times]
        assert max(late, default=0.0) <= one.dt * 1.0001, seed
        apart = np.abs(one.position - two.position).max()
        assert apart <= 1e-3 or apart <= 3 * sensitivity(scene, program, two, engine), seed
        assert one.valid.all() == two.valid.all()


@pytest.mark.parametrize("engine", ENGINES)
def test_random_scenes(tmp_path: Path, engine: str) -> None:
    compare(tmp_path, range(6), engine)


@pytest.mark.slow
@pytest.mark.parametrize("engine", ENGINES)
def test_forty_random_scenes(tmp_path: Path, engine: str) -> None:
    compare(tmp_path, range(100, 140), engine)
