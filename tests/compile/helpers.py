from __future__ import annotations

from pathlib import Path

import numpy as np

from esg.compile import WatchedEvent, emit_class, replay_class
from esg.compile.build import read_classes
from esg.compile.replay import ClassReplay
from esg.compile.scene import write_class
from esg.compile.trust.written import remember
from esg.engines.program import Program, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Rollout, SimScene


def written(
    folder: Path,
    scene: SimScene,
    program: Program,
    watch: tuple[WatchedEvent, ...] = (),
    **more: float,
) -> Path:
    write_class(emit_class(scene, program, watch=watch, **more), folder)
    return folder


def vouched(folder: Path) -> Path:
    """The folder; its class, edited since it was written, passes for this process's own."""
    (files,) = read_classes([folder])
    imports = (folder / "unreal" / "imports.json").read_text("utf-8")
    remember(files.name, files.header, files.source, imports)
    return folder


def both(
    folder: Path,
    scene: SimScene,
    program: Program,
    watch: tuple[WatchedEvent, ...] = (),
    *,
    engine: str = "physx",
    dt: float = 1 / 240,
) -> tuple[ClassReplay, Rollout]:
    """The class run and the program run in the same engine."""
    written(folder, scene, program, watch)
    replayed = replay_class(folder, dt=dt, engine=engine)  # type: ignore[arg-type]
    batch = batch_programs([program], scene.names)
    return replayed, get_engine(engine).rollout(scene, batch, dt=dt)


def first_touches(rollout: Rollout) -> dict[tuple[int, int], float]:
    log = rollout.contacts
    out: dict[tuple[int, int], float] = {}
    for a, b, t in zip(log.a.tolist(), log.b.tolist(), log.time.tolist(), strict=True):
        out.setdefault((a, b), t)
    return out


def assert_same(one: Rollout, two: Rollout, *, tolerance_m: float = 1e-3) -> None:
    """Same contacts, first touches within one step, positions within the tolerance."""
    times, others = first_touches(one), first_touches(two)
    assert times.keys() == others.keys()
    for pair, time in times.items():
        assert abs(time - others[pair]) <= one.dt * 1.0001
    assert np.abs(one.position - two.position).max() <= tolerance_m
    np.testing.assert_allclose(one.time, two.time)
