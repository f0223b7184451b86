"""How high does something come up again that drops on a rigid bed on springs?

    python -m benchmarks.trampoline

A ball of 0.6 kg and one of 70 kg drop 1 m on a bed of 2.4 m, without restitution, that slides up
and down with 5,000 N/m or hangs in four springs of 15,000 N/m to the world, in PhysX and in
Rapier. Why trampolines are no springs here: docs/ropes.md.
"""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np

from benchmarks.analytic import DT, ball, box
from benchmarks.joints import solid
from esg.commands.console import table
from esg.engines import get_engine
from esg.engines.joints import Joint, joint_between
from esg.engines.program import Program, batch_programs
from esg.engines.scene import Body, SimScene
from esg.units import GRAVITY_MPS2 as G

HEIGHT_M, DROP_M, HALF_M, THICK_M = 1.0, 1.0, 1.2, 0.02
DAMPING = 20.0
SLIDER_NPM, SPRING_NPM = 5_000.0, 15_000.0
SLACK = 0.6
"""Rest length of a spring as a share of its length: the bed is drawn tight."""
MASSES_KG, BEDS_KG = (70.0, 0.6), (5.0, 0.5, 0.05)


def on_a_slider(bed: Body) -> tuple[Joint, ...]:
    """One spring, up and down."""
    rail = joint_between("rail", "slider", bed, None, at=bed.position, axis=(0.0, 0.0, 1.0))
    return (replace(rail, stiffness=SLIDER_NPM, damping=DAMPING),)


def in_springs(bed: Body) -> tuple[Joint, ...]:
    """Four springs, from its corners outwards."""
    out: list[Joint] = []
    for k, (x, y) in enumerate(((1, 1), (1, -1), (-1, 1), (-1, -1))):
        at = (x * HALF_M, y * HALF_M, HEIGHT_M)
        end = (1.3 * at[0], 1.3 * at[1], HEIGHT_M)
        spring = joint_between(f"spring {k}", "spring", bed, None, at=at, parent_at=end)
        rest = SLACK * math.dist(at, end)
        out.append(replace(spring, upper=rest, stiffness=SPRING_NPM, damping=DAMPING))
    return tuple(out)


def comes_up(engine: str, mass: float, bed_mass: float, springs: bool) -> float:
    """Height above the bed's level that a ball reaches after it was down [m]."""
    half = (HALF_M, HALF_M, THICK_M)
    bed = solid(box("bed", (0.0, 0.0, HEIGHT_M), half, 0.0, mass=bed_mass), mu=0.5)
    shot = solid(ball("ball", (0.0, 0.0, 0.0), 0.0, 0.0), mu=0.5)
    level = HEIGHT_M + THICK_M + shot.shapes[0].size[0]
    scale = mass / shot.mass
    inertia = tuple(tuple(scale * v for v in row) for row in shot.inertia)
    shot = replace(shot, mass=mass, inertia=inertia, position=(0.0, 0.0, level + DROP_M))  # type: ignore[arg-type]
    joints = in_springs(bed) if springs else on_a_slider(bed)
    scene = SimScene("trampoline", (bed, shot), joints=joints, gravity=(0.0, 0.0, -G))
    batch = batch_programs([Program((), 4.0)], scene.names)
    played = get_engine(engine).rollout(scene, batch, dt=DT)  # type: ignore[arg-type]
    height = played.position[0, :, 1, 2] - level
    met = int(np.argmax(height < 0.0))
    low = met + int(np.argmin(height[met : met + round(1.0 / DT)]))
    return float(height[low:].max())


def main() -> None:
    rows = [
        [f"{mass:g}", "springs" if springs else "slider", f"{bed:g}"]
        + [f"{comes_up(engine, mass, bed, springs):.2f}" for engine in ("physx", "rapier")]
        for mass in MASSES_KG
        for springs in (False, True)
        for bed in BEDS_KG
    ]
    print(table(["dropped kg", "bed on", "bed kg", "physx m", "rapier m"], rows))


if __name__ == "__main__":
    main()
