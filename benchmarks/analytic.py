"""Every engine against motions with a closed form: `python -m benchmarks.analytic`.

Each case is one experiment with one answer from a textbook. Cases stand side by side in two scenes,
one with and one without gravity, far enough apart not to touch. The command prints the table of
docs/engines.md and fails if Newton or PhysX is more than 1% off anywhere; Rapier is reported.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass, field, replace
import json
import math
from pathlib import Path
import sys

import numpy as np
from numpy.typing import NDArray

from esg.engines import get_engine
from esg.engines.program import AdjustProperties, Program, SetVelocity, batch_programs
from esg.engines.scene import Body, Rollout, Shape, SimScene
from esg.units import GRAVITY_MPS2 as G

DT = 1.0 / 240.0
LIMIT = 0.01
HELD_TO_IT = ("newton", "physx")
ENGINES = ("newton", "physx", "rapier")
LANE_M = 4.0
"""Between experiments."""

GROUND_FRICTION, GROUND_RESTITUTION = 0.2, 0.5

Vec = tuple[float, float, float]
Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Film:
    """One rollout, looked up by body.

    Args:
        scene: What was simulated.
        rollout: Its only world.
    """

    scene: SimScene
    rollout: Rollout

    def v(self, body: str, t: float) -> Floats:
        """Velocity [m/s], shape [3]."""
        return self._at(self.rollout.linear_velocity, body, t)

    def w(self, body: str, t: float) -> Floats:
        """Angular velocity [rad/s], shape [3]."""
        return self._at(self.rollout.angular_velocity, body, t)

    def way(self, body: str, t0: float, t1: float) -> Floats:
        """Displacement of the centre of mass [m], shape [3]."""
        return self._at(self.rollout.position, body, t1) - self._at(self.rollout.position, body, t0)

    def after(self, body: str, other: str) -> float:
        """Time one step after the first touch of two bodies has ended [s]."""
        a, b = sorted((self.scene.index(body), self.scene.index(other)))
        log = self.rollout.contacts
        frames = set(log.frame[(log.a == a) & (log.b == b)].tolist())
        last = min(frames)
        while last + 1 in frames:
            last += 1
        return (last + 1) * DT

    def path(self, body: str) -> Floats:
        """Positions of the centre of mass [m], shape [T, 3]."""
        return self.rollout.position[0, :, self.scene.index(body)].astype(np.float64)

    def _at(self, array: NDArray[np.float32], body: str, t: float) -> Floats:
        return array[0, round(t / DT), self.scene.index(body)].astype(np.float64)


@dataclass(frozen=True)
class Case:
    """One experiment.

    Args:
        name: Row of the table.
        quantity: What is compared.
        exact: Closed form [SI]; a spin as the speed of the surface.
        measure: The same from a film, shape as `exact`.
        bodies: In a lane of their own; names are unique among all cases.
        commands: What they do.
        scale: What an error is a share of; the exact values where empty.
        free: Without gravity.
    """

    name: str
    quantity: str
    exact: tuple[float, ...]
    measure: Callable[[Film], tuple[float, ...]]
    bodies: tuple[Body, ...]
    commands: tuple[SetVelocity | AdjustProperties, ...]
    scale: tuple[float, ...] = ()
    free: bool = False


def ball(
    name: str, at: Vec, mu: float, e: float, *, radius: float = 0.1, mass: float = 1.0
) -> Body:
    """A solid ball whose friction and restitution with the ground are mu and e."""
    moment = 0.4 * mass * radius**2
    return Body(
        name, False, mass, _diagonal((moment, moment, moment)),
        (Shape("sphere", (radius, radius, radius)),), at, roll_radius=radius,
        friction=_with_ground(mu, GROUND_FRICTION), restitution=_with_ground(e, GROUND_RESTITUTION),
    )  # fmt: skip


def box(name: str, at: Vec, half: Vec, mu: float, *, mass: float = 10.0, e: float = 0.25) -> Body:
    """A box whose friction and restitution with the ground are mu and e."""
    x, y, z = half
    moments = [mass / 3.0 * s for s in (y * y + z * z, x * x + z * z, x * x + y * y)]
    return Body(
        name, False, mass, _diagonal(moments), (Shape("box", half),), at,
        friction=_with_ground(mu, GROUND_FRICTION), restitution=_with_ground(e, GROUND_RESTITUTION),
        half_extents=half,
    )  # fmt: skip


def fixed(name: str, at: Vec, half: Vec, like: Body, tilt: float = 0.0) -> Body:
    """A static box of the material of another body, tilted about Y [rad]."""
    turn = (0.0, math.sin(0.5 * tilt), 0.0, math.cos(0.5 * tilt))
    return replace(
        like, name=name, static=True, shapes=(Shape("box", half),), position=at, quaternion=turn,
        roll_radius=0.0, half_extents=half,
    )  # fmt: skip


def _diagonal(moments: list[float] | Vec) -> tuple[Vec, Vec, Vec]:
    x, y, z = moments
    return ((x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z))


def _with_ground(pair: float, ground: float) -> float:
    return 2.0 * pair - ground


def _on_material(body: Body, mu: float, e: float = 0.0) -> Body:
    """The body with mu and e of its own: those of a pair of equal ones."""
    return replace(body, friction=mu, restitution=e)


SLOPE = math.radians(20.0)
_DOWN = np.array([math.cos(SLOPE), 0.0, -math.sin(SLOPE)])


def _on_slope(name: str, body: Body, lift: float) -> tuple[Body, Body]:
    """A body on a slope of its material: `lift` is the height of its centre above the surface."""
    half = (6.0, 1.0, 0.5)
    normal = np.array([math.sin(SLOPE), 0.0, math.cos(SLOPE)])
    middle = np.array([0.0, 0.0, 4.0])
    x, y, z = (middle + (half[2] + lift) * normal - 3.0 * _DOWN).tolist()
    tilt = (0.0, math.sin(0.5 * SLOPE), 0.0, math.cos(0.5 * SLOPE))
    slope = fixed(f"{name} slope", (0.0, 0.0, 4.0), half, body, SLOPE)
    return replace(body, position=(x, y, z), quaternion=tilt), slope


def slopes() -> list[Case]:
    """A ball and a block on a slope of 20 degrees, measured after 1 s."""
    out: list[Case] = []
    for name, mu in (("rolling", 0.3), ("slipping", 0.06)):
        pull = G * math.sin(SLOPE)
        grip = min(mu * G * math.cos(SLOPE), 2.0 / 7.0 * pull)
        key = f"slope {name}"
        body, slope = _on_slope(key, _on_material(ball(key, (0.0, 0.0, 0.0), 0.0, 0.0), mu), 0.1)
        out.append(Case(
            f"ball on a slope, {name}", "speed, spin",
            (pull - grip, 2.5 * grip),
            lambda film, key=key: (float(film.v(key, 1.0) @ _DOWN), 0.1 * film.w(key, 1.0)[1]),
            (body, slope), (),
        ))  # fmt: skip
    for name, mu in (("sliding", 0.2), ("held", 0.5)):
        key = f"slope {name}"
        free = 0.5 * G * math.sin(SLOPE)
        way = max(0.0, free - 0.5 * mu * G * math.cos(SLOPE))
        made = _on_material(box(key, (0.0, 0.0, 0.0), (0.2, 0.2, 0.1), 0.0), mu)
        body, slope = _on_slope(key, made, 0.1)
        out.append(Case(
            f"block on a slope, {name}", "way", (way,),
            lambda film, key=key: (float(film.way(key, 0.0, 1.0) @ _DOWN),),
            (body, slope), (), scale=(way or free,),
        ))  # fmt: skip
    return out


def stops() -> list[Case]:
    """A block that slides to rest, a car that brakes, a car that skids sideways."""
    mu, v = 0.5, (2.4, 1.8, 0.0)
    block = Case(
        "block stop", "way", (9.0 / (2.0 * mu * G),),
        lambda film: (math.hypot(*film.way("block", 0.0, 3.0)[:2]),),
        (box("block", (0.0, 0.0, 0.1), (0.2, 0.2, 0.1), mu),), (SetVelocity("block", 0.0, v),),
    )  # fmt: skip
    # The vehicle ground has friction 0: half of the body's own is left.
    half, drag, damping = (2.2, 0.9, 0.7), 0.1 * G, 1.0
    ran = 10.0 / damping - drag / damping**2 * math.log(1.0 + damping * 10.0 / drag)
    car = replace(box("damped", (0.0, 0.0, 0.7), half, 0.0, mass=1200.0), wheeled=True)
    brake = Case(
        "brake of a car", "way", (10.0**2 / (2.0 * 5.0),),
        lambda film: (film.way("braking", 0.0, 3.0)[0],),
        (replace(car, name="braking", friction=0.0),),
        (AdjustProperties("braking", 0.0, braking=5.0),
         SetVelocity("braking", 0.0, (10.0, 0.0, 0.0))),
    )  # fmt: skip
    damp = Case(
        "brake of a car by damping", "way", (ran,),
        lambda film: (film.way("damped", 0.0, 3.0)[0],),
        (replace(car, friction=0.2),),
        (AdjustProperties("damped", 0.0, linear_damping=damping),
         SetVelocity("damped", 0.0, (10.0, 0.0, 0.0))),
    )  # fmt: skip
    skid = Case(
        "skid of a car, sideways", "way", (36.0 / (2.0 * 0.5 * G),),
        lambda film: (film.way("skidding", 0.0, 3.0)[0],),
        (replace(
            car, name="skidding", friction=0.1, quaternion=(0.0, 0.0, 0.5**0.5, 0.5**0.5)
        ),),
        (AdjustProperties("skidding", 0.0, friction=1.0),
         SetVelocity("skidding", 0.0, (6.0, 0.0, 0.0))),
    )  # fmt: skip
    return [block, brake, damp, skid]


def throw() -> Case:
    """A ball in the air, until it is as low as it was."""
    along, up = 3.0, 6.0

    def measure(film: Film) -> tuple[float, ...]:
        x, _, z = (film.path("thrown") - film.path("thrown")[0]).T
        k = int(np.flatnonzero(z[1:] < 0.0)[0])
        share = z[k] / (z[k] - z[k + 1])
        return float(x[k] + share * (x[k + 1] - x[k])), float(z.max())

    return Case(
        "projectile", "range, height", (2.0 * along * up / G, up * up / (2.0 * G)), measure,
        (ball("thrown", (0.0, 0.0, 3.0), 0.3, 0.5),),
        (SetVelocity("thrown", 0.0, (along, 0.0, up)),),
    )  # fmt: skip


def wall_bounces() -> list[Case]:
    """A rolling ball that hits a wall: friction lifts it, then it slips until it rolls again.

    About its line of contact with the ground it keeps the angular momentum that the wall left it,
    whatever it hops in between.
    """
    out: list[Case] = []
    for name, v, mu in (("slipping", 3.0, 0.15), ("sticking", 12.0, 0.3)):
        e = 0.6
        hop = min(mu * (1.0 + e) * v, 2.0 / 7.0 * v)
        spin = v - 2.5 * hop
        roller = ball(f"roller {name}", (0.0, 0.0, 0.1), mu, 0.4)
        # A pair's value is the average of both: the wall makes up what the ball differs by.
        wall = replace(
            fixed(f"wall {name}", (0.95, 0.0, 0.5), (0.15, 0.6, 0.5), roller),
            friction=2.0 * mu - roller.friction, restitution=2.0 * e - roller.restitution,
        )  # fmt: skip

        def measure(
            film: Film, ball: str = roller.name, wall: str = wall.name
        ) -> tuple[float, ...]:
            t = film.after(ball, wall)
            spin = 0.1 * float(film.w(ball, t)[1])
            return float(film.v(ball, t)[0]), spin, float(film.v(ball, 3.0)[0])

        out.append(Case(
            f"rolling ball off a wall, {name}",
            "speed, spin, speed in the end",
            (-e * v, spin, (-5.0 * e * v + 2.0 * spin) / 7.0), measure, (roller, wall),
            (SetVelocity(roller.name, 0.0, (v, 0.0, 0.0), (0.0, v / 0.1, 0.0)),),
        ))  # fmt: skip
    return out


def topple() -> Case:
    """Boxes set turning about an edge, each 1% faster than the last: which is the first to fall?"""
    x, z, mass = 0.15, 0.4, 10.0
    reach = math.hypot(x, z)
    limit = math.sqrt(2.0 * G * (reach - z) / (4.0 / 3.0 * reach**2))
    shares = [0.95 + 0.01 * k for k in range(11)]
    bodies: list[Body] = []
    commands: list[SetVelocity] = []
    for k, share in enumerate(shares):
        w = share * limit
        bodies.append(
            box(f"leaning {k}", (1.5 * k - 7.5, 0.0, z), (x, 0.2, z), 1.0, mass=mass, e=0.25)
        )
        commands.append(SetVelocity(f"leaning {k}", 0.0, (w * z, 0.0, w * x), (0.0, w, 0.0)))

    def measure(film: Film) -> tuple[float, ...]:
        fell = [film.way(f"leaning {k}", 0.0, 3.0)[2] < -0.1 for k in range(len(shares))]
        return ((shares[fell.index(True)] - 0.005) * limit if any(fell) else math.inf,)

    return Case(
        "topple threshold", "spin, to 0.5%", (limit,), measure,
        tuple(bodies), tuple(commands),
    )  # fmt: skip


@dataclass(frozen=True)
class Oblique:
    """A ball that meets a flat surface."""

    along: float
    towards: float
    mu: float
    e: float

    def leaves(self) -> tuple[float, float, float]:
        """Speed along and away from the surface and radius times spin [m/s]."""
        slip = min(self.mu * (1.0 + self.e) * self.towards, 2.0 / 7.0 * self.along)
        return self.along - slip, self.e * self.towards, 2.5 * slip


def bounces() -> list[Case]:
    """Oblique bounces without gravity: of the ground, and of a wall at high speed."""
    rng = np.random.default_rng(0)

    def drawn(n: int, low: float, high: float) -> list[Oblique]:
        return [
            Oblique(*(float(rng.uniform(*r)) for r in (
                (low, high), (low, high), (0.1, 0.8), (0.26, 0.74)
            )))
            for _ in range(n)
        ]  # fmt: skip

    chosen = [
        ("oblique bounce, sticking", [Oblique(3.0, 4.0, 0.5, 0.7)]),
        ("oblique bounce, slipping", [Oblique(3.0, 4.0, 0.1, 0.7)]),
        ("oblique bounces, 40 of 1 to 6 m/s", drawn(40, 1.0, 6.0)),
        ("oblique bounces, 20 of 8 to 30 m/s", drawn(20, 8.0, 30.0)),
    ]
    out: list[Case] = []
    for name, hits in chosen:
        bodies = tuple(
            ball(f"{name} {k}", (2.0 * k - len(hits), 0.0, 0.1 + 0.1 * hit.towards), hit.mu, hit.e)
            for k, hit in enumerate(hits)
        )
        commands = tuple(
            # Across the row, so that nobody crosses a neighbour's way.
            SetVelocity(b.name, 0.0, (0.0, hit.along, -hit.towards))
            for b, hit in zip(bodies, hits, strict=True)
        )

        def measure(film: Film, bodies: tuple[Body, ...] = bodies) -> tuple[float, ...]:
            out: list[float] = []
            for b in bodies:
                _, along, away = film.v(b.name, 0.2).tolist()
                out += [along, away, -0.1 * float(film.w(b.name, 0.2)[0])]
            return tuple(out)

        exact = tuple(v for hit in hits for v in hit.leaves())
        out.append(Case(
            name, "speeds, spin", exact, measure, bodies, commands,
            free=True,
        ))  # fmt: skip
    return out


def exchanges() -> list[Case]:
    """Balls on one line in free space."""
    out: list[Case] = []
    v = 2.0
    for name, masses, e in (
        ("two-body exchange", (1.0, 3.0), 0.5),
        ("three-ball exchange with gaps", (1.0, 1.0, 1.0), 0.6),
    ):
        row = tuple(
            _on_material(ball(f"{name} {k}", (0.35 * k, 0.0, 20.0), 0.0, 0.0, mass=m), 0.3, e)
            for k, m in enumerate(masses)
        )
        speeds = [v] + [0.0] * (len(masses) - 1)
        for k in range(len(masses) - 1):
            a, b = masses[k], masses[k + 1]
            common, apart = a * speeds[k] / (a + b), e * speeds[k] / (a + b)
            speeds[k], speeds[k + 1] = common - b * apart, common + a * apart
        out.append(Case(
            name, "speeds", tuple(speeds),
            lambda film, row=row: tuple(float(film.v(b.name, 0.4)[0]) for b in row),
            row, (SetVelocity(row[0].name, 0.0, (v, 0.0, 0.0)),), scale=(v,) * len(speeds),
            free=True,
        ))  # fmt: skip
    return out


def cases() -> list[Case]:
    """All of them, in the order of the table."""
    return [*slopes(), *stops(), throw(), topple(), *wall_bounces(), *bounces(), *exchanges()]


@dataclass(frozen=True)
class Row:
    """What an engine made of a case.

    Args:
        name, quantity: As in the case.
        exact: Closed form.
        measured: By engine, shape as `exact`.
        error: By engine, the largest share by which a value is off.
    """

    name: str
    quantity: str
    exact: tuple[float, ...]
    measured: dict[str, tuple[float, ...]] = field(default_factory=dict)
    error: dict[str, float] = field(default_factory=dict)


def scene_of(cases: list[Case], *, free: bool) -> tuple[SimScene, Program]:
    """Cases side by side, each in its lane."""
    bodies: list[Body] = []
    commands: list[SetVelocity | AdjustProperties] = []
    for lane, case in enumerate(cases):
        for body in case.bodies:
            x, y, z = body.position
            bodies.append(replace(body, position=(x, y + LANE_M * lane, z)))
        commands += case.commands
    scene = SimScene(
        "free" if free else "ground", tuple(bodies), gravity=(0.0, 0.0, 0.0 if free else -G),
        ground_friction=GROUND_FRICTION, ground_restitution=GROUND_RESTITUTION,
    )  # fmt: skip
    return scene, Program(tuple(commands), 0.5 if free else 3.0)


def run(engines: tuple[str, ...] = ENGINES) -> list[Row]:
    """Simulates every case in every engine at 240 Hz.

    Args:
        engines: Their names.

    Returns:
        A row per case.
    """
    every = cases()
    rows = [Row(c.name, c.quantity, c.exact) for c in every]
    for free in (False, True):
        chosen = [k for k, c in enumerate(every) if c.free is free]
        scene, program = scene_of([every[k] for k in chosen], free=free)
        batch = batch_programs([program], scene.names)
        for engine in engines:
            film = Film(scene, get_engine(engine).rollout(scene, batch, dt=DT))
            for k in chosen:
                measured = np.array(every[k].measure(film))
                scale = np.abs(every[k].scale or every[k].exact)
                error = np.abs(measured - every[k].exact) / scale
                rows[k].measured[engine] = tuple(measured.tolist())
                rows[k].error[engine] = float(error.max())
    return rows


def markdown(rows: list[Row], engines: tuple[str, ...]) -> str:
    """The table: what is off by how much."""
    lines = [
        f"| case | compared | {' | '.join(engines)} |",
        "| --- | --- |" + " --- |" * len(engines),
    ]
    for row in rows:
        errors = " | ".join(f"{row.error[e]:.2%}" for e in engines)
        lines.append(f"| {row.name} | {row.quantity} | {errors} |")
    return "\n".join(lines)


def too_far(rows: list[Row]) -> list[str]:
    """What is over the limit in an engine that is held to it."""
    return [
        f"{row.name}: {engine} is {row.error[engine]:.2%} off (measured "
        f"{row.measured[engine]}, exact {row.exact})"
        for row in rows
        for engine in HELD_TO_IT
        if engine in row.error and not row.error[engine] <= LIMIT
    ]


def main() -> int:
    """Prints the table; 1 if Newton or PhysX is off by more than 1%."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engines", nargs="+", default=list(ENGINES), choices=ENGINES)
    parser.add_argument("--json", type=Path, help="also write all numbers to this file")
    args = parser.parse_args()
    engines = tuple(args.engines)
    rows = run(engines)
    print(markdown(rows, engines))
    if args.json:
        args.json.write_text(json.dumps([vars(row) for row in rows], indent=2) + "\n")
    wrong = too_far(rows)
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
