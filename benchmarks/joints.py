"""Every engine's joints against motions with a closed form: `python -m benchmarks.joints`.

Each case is one experiment in a scene of its own. The command prints the table of
docs/results/joints.md and fails if an engine misses a limit.
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

from benchmarks.analytic import DT, ENGINES, Film, Floats, Vec, ball, box
from esg.engines import get_engine
from esg.engines.joints import Joint, Motor, joint_between, joint_poses, joint_state
from esg.engines.program import Primitive, Program, SetVelocity, batch_programs
from esg.engines.scene import Body, SimScene
from esg.units import GRAVITY_MPS2 as G

GAP_LIMIT_M = 1e-3
"""How far anchors may be apart that belong together."""
PERIOD, AMPLITUDE, SPRING = 1e-3, 1e-2, 5e-3
DOOR, SEESAW, CRADLE = 0.02, 0.03, 0.05
MOTION = 0.01
"""Shares by which a period, an amplitude after 10 s and so on may be off."""

_Y, _Z = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Case:
    """One experiment.

    Args:
        name: Row of the table.
        quantity: What is compared.
        exact: Closed form [SI].
        measure: The same from a film, shape as `exact`.
        limits: Shares by which each may be off, shape as `exact`; infinite for what is reported.
        bodies, joints, commands: The scene and its program.
        seconds: It plays [s].
        scale: What an error is a share of; the exact values where empty.
        beyond: Engines that cannot do it, of which it is only reported.
    """

    name: str
    quantity: str
    exact: tuple[float, ...]
    measure: Callable[[Film], tuple[float, ...]]
    limits: tuple[float, ...]
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    commands: tuple[Primitive, ...] = ()
    seconds: float = 10.0
    scale: tuple[float, ...] = ()
    beyond: tuple[str, ...] = ()

    @property
    def scene(self) -> SimScene:
        return SimScene(self.name, self.bodies, joints=self.joints, gravity=(0.0, 0.0, -G))


def solid(body: Body, mu: float = 0.0, e: float = 0.0) -> Body:
    """The body with a friction and restitution of its own: those of a pair of such."""
    return replace(body, friction=mu, restitution=e)


def swung(body: Body, pivot: Vec, arm: float, angle: float) -> Body:
    """The body with its centre `arm` below a pivot, then turned about it by an angle about Y."""
    x, y, z = pivot
    at = (x - arm * math.sin(angle), y, z - arm * math.cos(angle))
    turn = (0.0, math.sin(0.5 * angle), 0.0, math.cos(0.5 * angle))
    return replace(body, position=at, quaternion=turn)


def about(body: Body, arm: float) -> float:
    """Moment of inertia about an axis along Y that passes at a distance of the centre [kg m^2]."""
    return body.inertia[1][1] + body.mass * arm * arm


def positions(film: Film, joint: Joint) -> tuple[Floats, Floats]:
    """Position and gap of a joint in every frame (`esg.engines.joints.JointState`), shape [T]."""
    rollout = film.rollout
    poses = joint_poses(film.scene, joint, rollout.position[0], rollout.quaternion[0])
    state = joint_state(joint, *poses)
    return state.position, state.gap


def period(values: Floats) -> float:
    """Mean time between falls through zero [s]."""
    falls = np.flatnonzero((values[:-1] > 0.0) & (values[1:] <= 0.0))
    at = falls + values[falls] / (values[falls] - values[falls + 1])
    return float(np.diff(at).mean() * DT) if len(at) > 1 else math.nan


def kept(values: Floats, seconds: float) -> float:
    """Amplitude at the end, over the last `seconds`, as a share of that at the start."""
    return float(np.abs(values[-round(seconds / DT) :]).max() / abs(values[0]))


def elliptic_period(inertia: float, mass: float, arm: float, amplitude: float) -> float:
    """Period of a physical pendulum [s], by the arithmetic-geometric mean of 1 and cos(a / 2).

    The complete elliptic integral of Landau and Lifshitz, Mechanics, section 11.
    """
    a, b = 1.0, math.cos(0.5 * amplitude)
    for _ in range(20):
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    return 2.0 * math.pi * math.sqrt(inertia / (mass * G * arm)) / a


def pendulums() -> list[Case]:
    """Balls and rods that swing about Y for 10 s."""
    pivot = (0.0, 0.0, 3.0)
    rod = box("rod", (0.0, 0.0, 0.0), (0.05, 0.05, 0.5), 0.0, mass=2.0)
    bob = ball("bob", (0.0, 0.0, 0.0), 0.0, 0.0)
    out: list[Case] = []
    for name, body, kind, arm, degrees in (
        ("ball on a hinge, 10 degrees", bob, "hinge", 1.0, 10.0),
        ("ball on a ball joint, 30 degrees", bob, "ball", 1.0, 30.0),
        ("ball on a rope, 30 degrees", bob, "rope", 1.0, 30.0),
        ("rod on a hinge, 30 degrees", rod, "hinge", 0.5, 30.0),
        ("rod on a hinge, 120 degrees", rod, "hinge", 0.5, 120.0),
    ):
        angle = math.radians(degrees)
        made = solid(swung(body, pivot, arm, angle))
        if kind == "rope":
            # From its centre, so that it does not turn.
            joint = joint_between("pivot", "rope", made, None, at=made.position, parent_at=pivot)
            joint, inertia = replace(joint, upper=arm), made.mass * arm * arm
        else:
            joint = joint_between("pivot", kind, made, None, at=pivot, axis=_Y)
            inertia = about(made, arm)
        exact = elliptic_period(inertia, made.mass, arm, angle)

        def measure(film: Film, body: str = made.name, exact: float = exact) -> tuple[float, ...]:
            x, _, z = (film.path(body) - pivot).T
            angles = np.unwrap(np.arctan2(-x, -z))
            return period(angles), kept(angles, exact)

        out.append(Case(
            f"pendulum: {name}", "period, amplitude kept in 10 s", (exact, 1.0), measure,
            (PERIOD, AMPLITUDE), (made,), (joint,),
        ))  # fmt: skip
    return out


def springs() -> list[Case]:
    """A ball on a spring, a rod on a hinge and a block on a slider that are drawn back."""
    k, rest, top = 100.0, 0.5, 3.0
    bob = solid(ball("bob", (0.0, 0.0, top - rest), 0.0, 0.0))
    hung = joint_between("spring", "spring", bob, None, at=bob.position, parent_at=(0, 0, top))
    hung = replace(hung, upper=rest, stiffness=k)
    middle = rest + G / k
    beat = 2.0 * math.pi * math.sqrt(1.0 / k)

    def bounce(film: Film) -> tuple[float, ...]:
        way = positions(film, hung)[0] - middle
        return period(way), kept(way, beat), float(positions(film, hung)[0].mean())

    leaf = solid(box("leaf", (0.5, 0.0, 2.0), (0.5, 0.02, 0.2), 0.0))
    inertia = leaf.inertia[2][2] + leaf.mass * 0.25
    turned = joint_between(
        "torsion", "hinge", leaf, None, at=(0.0, 0.0, 2.0), axis=_Z, position=0.5
    )
    turned = replace(turned, stiffness=20.0)
    swing = 2.0 * math.pi * math.sqrt(inertia / turned.stiffness)

    def torsion(film: Film) -> tuple[float, ...]:
        angle, _ = positions(film, turned)
        return period(angle), kept(angle, swing)

    cart = solid(box("cart", (0.3, 0.0, 2.0), (0.2, 0.2, 0.1), 0.0))
    drawn = joint_between("rail", "slider", cart, None, at=cart.position, position=0.3)
    drawn = replace(drawn, stiffness=250.0, damping=4.0)
    fade = drawn.damping / (2.0 * cart.mass)
    pace = math.sqrt(drawn.stiffness / cart.mass - fade * fade)

    def damped(film: Film) -> tuple[float, ...]:
        way, _ = positions(film, drawn)
        turns = np.flatnonzero((way[1:-1] > way[:-2]) & (way[1:-1] >= way[2:])) + 1
        share = math.log(way[turns[0]] / way[turns[3]]) / 3.0
        return period(way), share

    return [
        Case(
            "ball on a spring", "period, amplitude kept in 10 s, mean length", (beat, 1.0, middle),
            bounce, (SPRING,) * 3, (bob,), (hung,),
        ),
        Case(
            "hinge with stiffness", "period, amplitude kept in 10 s", (swing, 1.0), torsion,
            (SPRING,) * 2, (leaf,), (turned,),
        ),
        Case(
            "slider with stiffness and damping", "period, logarithm of the decrement",
            (2.0 * math.pi / pace, 2.0 * math.pi * fade / pace), damped, (SPRING, MOTION),
            (cart,), (drawn,), seconds=6.0,
        ),
    ]  # fmt: skip


def wheels() -> list[Case]:
    """A disc on a vertical axle: damping, friction, a motor; an arm that friction holds."""
    disc = solid(box("disc", (0.0, 0.0, 1.0), (0.3, 0.3, 0.05), 0.0))
    inertia = disc.inertia[2][2]
    axle = joint_between("axle", "hinge", disc, None, at=disc.position, axis=_Z)
    spin = (SetVelocity("disc", 0.0, (0.0, 0.0, 0.0), (0.0, 0.0, 4.0)),)
    drag, grip, push = 0.3, 0.6, 0.9

    def rates(*times: float) -> Callable[[Film], tuple[float, ...]]:
        return lambda film: tuple(float(film.w("disc", t)[2]) for t in times)

    stop = inertia * 4.0 / grip
    reached = inertia * 3.0 / push
    arm = solid(box("arm", (0.5, 0.0, 2.0), (0.5, 0.05, 0.05), 0.0))
    held = joint_between("shoulder", "hinge", arm, None, at=(0.0, 0.0, 2.0), axis=_Y)
    weight = arm.mass * G * 0.5
    cart = solid(box("cart", (0.0, 0.0, 1.0), (0.2, 0.2, 0.1), 0.0))
    rail = joint_between("rail", "slider", cart, None, at=cart.position)
    rail = replace(rail, motor=Motor(0.2, 0.5))

    def angle(film: Film, joint: Joint = held) -> tuple[float, ...]:
        return (float(np.abs(positions(film, joint)[0]).max()),)

    return [
        Case(
            "hinge with damping", "spin after 1 s, 3 s",
            (4.0 * math.exp(-drag / inertia), 4.0 * math.exp(-3.0 * drag / inertia)),
            rates(1.0, 3.0), (MOTION,) * 2, (disc,), (replace(axle, damping=drag),), spin, 4.0,
        ),
        Case(
            "hinge with friction", "spin half-way, at rest",
            (2.0, 0.0), rates(0.5 * stop, 1.1 * stop), (MOTION,) * 2, (disc,),
            (replace(axle, friction=grip),), spin, 5.0, (4.0, 4.0),
        ),
        Case(
            "arm that friction holds", "angle", (0.0,), angle, (GAP_LIMIT_M,), (arm,),
            (replace(held, friction=1.2 * weight),), seconds=3.0, scale=(1.0,),
        ),
        Case(
            "motor of a hinge", "spin half-way, reached", (1.5, 3.0),
            rates(0.5 * reached, 1.2 * reached), (MOTION,) * 2, (disc,),
            (replace(axle, motor=Motor(3.0, limit=push)),), (), 4.0,
        ),
        Case(
            "motor of a slider, to a place", "way after 1 s, 4 s", (0.2, 0.5),
            lambda film: tuple(float(film.way("cart", 0.0, t)[0]) for t in (1.0, 4.0)),
            (MOTION,) * 2, (cart,), (rail,), (), 4.0,
        ),
    ]  # fmt: skip


def limits() -> list[Case]:
    """A rod that falls against its limit, a cone, a fixed pair that falls as one."""
    pivot = (0.0, 0.0, 3.0)
    rod = solid(swung(box("rod", pivot, (0.05, 0.05, 0.5), 0.0, mass=2.0), pivot, 0.5, 1.0))
    hinge = joint_between("pivot", "hinge", rod, None, at=pivot, axis=_Y, position=1.0)
    hinge = replace(hinge, lower=-0.3)
    cone = joint_between("pivot", "ball", rod, None, at=pivot, axis=_Z)
    cone = replace(cone, upper=0.4)
    pair = tuple(
        solid(box(n, (x, 0.0, 3.0), (0.2, 0.1, 0.1), 0.0, mass=m))
        for n, x, m in (("left", -0.3, 2.0), ("right", 0.3, 6.0))
    )
    weld = joint_between("weld", "fixed", pair[0], pair[1], at=(0.0, 0.0, 3.0))
    spin = tuple(
        SetVelocity(b.name, 0.0, (0.0, 2.0 * (b.position[0] - 0.15), 0.0), (0.0, 0.0, 2.0))
        for b in pair
    )

    def lowest(film: Film) -> tuple[float, ...]:
        return (float(positions(film, hinge)[0].min()),)

    def widest(film: Film) -> tuple[float, ...]:
        return (float(positions(film, cone)[0].max()),)

    return [
        Case("limit of a hinge", "angle [rad]", (-0.3,), lowest, (MOTION,), (rod,), (hinge,),
             seconds=4.0, scale=(1.0,)),
        Case("cone of a ball joint", "angle [rad]", (0.4,), widest, (MOTION,), (rod,), (cone,),
             seconds=4.0, scale=(1.0,)),
        Case("fixed pair, spinning as it falls", "spins", (2.0, 2.0),
             lambda film: tuple(float(film.w(b.name, 0.6)[2]) for b in pair), (MOTION,) * 2,
             pair, (weld,), spin, 0.6),
    ]  # fmt: skip


def hits() -> list[Case]:
    """A ball that hits a door beside its hinge; what falls on one end of a seesaw."""
    mass, v, e, arm, wide = 20.0, 5.0, 0.5, 0.7, 0.45
    leaf = solid(box("leaf", (wide, 0.0, 1.05), (wide, 0.02, 1.0), 0.0, mass=mass), e=e)
    door = joint_between("hinge", "hinge", leaf, None, at=(0.0, 0.0, 1.05), axis=_Z)
    shot = solid(ball("shot", (arm, -0.5, 1.05), 0.0, 0.0), e=e)
    inertia = leaf.inertia[2][2] + mass * wide * wide
    push = (1.0 + e) * v / (1.0 + arm * arm / inertia)
    spin = arm * push / inertia

    def door_after(film: Film) -> tuple[float, ...]:
        turn = (float(film.w("leaf", t)[2]) for t in (0.2, 1.0))
        return (*turn, float(film.v("shot", 0.2)[1]))

    reach, high, drop, tilt = 1.2, 0.05, 0.3, 0.3
    plank = solid(box("plank", (0.0, 0.0, 0.6), (1.5, 0.15, 0.03), 0.0), mu=2.0)
    pivot = joint_between("pivot", "hinge", plank, None, at=plank.position, axis=_Y)
    pivot = replace(pivot, lower=-tilt, upper=0.0)
    light, heavy = (
        solid(box(n, (x, 0.0, 0.6 + z), (0.02, 0.02, 0.02), 0.0, mass=m), mu=2.0)
        for n, x, z, m in (("light", reach, high, 1.0), ("heavy", -reach, high + drop, 4.0))
    )
    # From the hit on they turn as one, held by friction, until the plank is stopped.
    lever = plank.inertia[1][1] + sum(about(b, math.hypot(reach, high)) for b in (light, heavy))
    start = heavy.mass * math.sqrt(2.0 * G * drop) * reach / lever
    fallen = reach * math.sin(tilt) * (heavy.mass - light.mass)
    fallen += high * (1.0 - math.cos(tilt)) * (heavy.mass + light.mass)
    launch = math.hypot(reach, high) * math.sqrt(start * start + 2.0 * G * fallen / lever)

    def thrown(film: Film) -> tuple[float, ...]:
        speeds = film.rollout.linear_velocity[0, :, film.scene.index("light")].astype(float)
        apex = int(np.flatnonzero(speeds[:, 2] > 1.0)[0])
        apex += int(np.flatnonzero(speeds[apex:, 2] < 0.0)[0])
        return (float(np.linalg.norm(speeds[:apex], axis=1).max()),)

    return [
        Case("door that a ball hits", "spin, spin after 1 s, ball",
             (spin, spin, v - push), door_after, (DOOR,) * 3, (leaf, shot), (door,),
             (SetVelocity("shot", 0.0, (0.0, v, 0.0)),), 1.2),
        Case("seesaw", "speed thrown", (launch,), thrown, (SEESAW,), (plank, light, heavy),
             (pivot,), seconds=1.6),
    ]  # fmt: skip


def cradles() -> list[Case]:
    """Five balls on hinges; the first falls from 30 degrees. Touching ones are only reported.

    Newton's law of restitution goes by the speeds at the beginning of a step: balls that are nearer
    than they move in one (7 mm) share a blow.
    """
    out: list[Case] = []
    for name, gap, limit, beyond in (
        ("8 mm apart", 8e-3, CRADLE, ()),
        ("3 mm apart", 3e-3, CRADLE, ("newton",)),
        ("touching", 0.0, math.inf, ENGINES),
    ):
        angle, arm = math.radians(30.0), 1.0
        balls: list[Body] = []
        joints: list[Joint] = []
        for i in range(5):
            made = ball(f"ball {i}", (0.0, 0.0, 0.0), 0.0, 0.0, radius=0.05)
            pivot = (i * (0.1 + gap), 0.0, 1.5)
            made = solid(swung(made, pivot, arm, angle if i == 0 else 0.0), e=1.0)
            balls.append(made)
            joints.append(joint_between(f"hook {i}", "hinge", made, None, at=pivot, axis=_Y))
        spin = math.sqrt(2.0 * G * arm * (1.0 - math.cos(angle)) / about(balls[0], arm))

        def last(film: Film) -> tuple[float, ...]:
            speeds = np.linalg.norm(film.rollout.linear_velocity[0, :, 4], axis=1)
            return (float(speeds.max()),)

        out.append(Case(
            f"cradle of five, {name}", "speed of the last", (arm * spin,), last, (limit,),
            tuple(balls), tuple(joints), seconds=0.8, beyond=beyond,
        ))  # fmt: skip
    return [toy_cradle(), *out]


def toy_cradle() -> Case:
    """The library's: balls of 5 cm on strings of 22 cm, 4 mm apart, of its steel and friction.

    Four blows pass on what hardened steel does; the speed of the last is compared with the first's.
    """
    angle, arm, radius, e, mu = math.radians(35.0), 0.215, 0.025, 0.994, 0.05
    balls: list[Body] = []
    joints: list[Joint] = []
    for i in range(5):
        made = ball(f"ball {i}", (0.0, 0.0, 0.0), 0.0, 0.0, radius=radius)
        pivot = (0.054 * i, 0.0, 0.5)
        made = solid(swung(made, pivot, arm, angle if i == 0 else 0.0), mu=mu, e=e)
        balls.append(made)
        joints.append(joint_between(f"hook {i}", "hinge", made, None, at=pivot, axis=_Y))

    def share(film: Film) -> tuple[float, ...]:
        speeds = np.linalg.norm(film.rollout.linear_velocity[0], axis=2).max(axis=0)
        return (float(speeds[4] / speeds[0]),)

    return Case(
        "cradle of the library", "speed of the last over that of the first", (1.0,), share,
        (CRADLE,), tuple(balls), tuple(joints), seconds=0.6,
    )  # fmt: skip


def breaks() -> list[Case]:
    """A ball falls 0.5 m until its rope is taut, which holds or breaks."""
    slack, top = 0.5, 6.0
    bob = solid(ball("bob", (0.0, 0.0, top - 0.5), 0.0, 0.0))
    rope = joint_between("rope", "rope", bob, None, at=bob.position, parent_at=(0, 0, top))
    blow = bob.mass * math.sqrt(2.0 * G * slack)

    def lost(film: Film) -> tuple[float, ...]:
        return (float(-film.way("bob", 0.0, 1.0)[2] > 1.5 * slack),)

    return [
        Case(
            f"rope that {name}", "whether it is gone", (gone,), lost, (0.0,), (bob,),
            (replace(rope, upper=0.5 + slack, break_impulse=share * blow),),
            seconds=1.0, scale=(1.0,),
        )
        for name, share, gone in (("holds", 1.15, 0.0), ("breaks", 0.85, 1.0))
    ]  # fmt: skip


def cases() -> list[Case]:
    """All of them, in the order of the table."""
    return [
        *pendulums(), *springs(), *wheels(), *limits(), *hits(), *cradles(), *breaks(),
    ]  # fmt: skip


@dataclass(frozen=True)
class Row:
    """What the engines made of a case.

    Args:
        case: It.
        measured: By engine, shape as its `exact`.
        error: By engine, by what share each value is off.
        gap: By engine, how far the joints' anchors were apart that should not be, at most [m].
    """

    case: Case
    measured: dict[str, tuple[float, ...]] = field(default_factory=dict)
    error: dict[str, tuple[float, ...]] = field(default_factory=dict)
    gap: dict[str, float] = field(default_factory=dict)


def run(engines: tuple[str, ...] = ENGINES, chosen: list[Case] | None = None) -> list[Row]:
    """Simulates every case in every engine at 240 Hz.

    Args:
        engines: Their names.
        chosen: The cases; all of them by default.
    """
    rows: list[Row] = []
    for case in cases() if chosen is None else chosen:
        row = Row(case)
        batch = batch_programs([Program(case.commands, case.seconds)], case.scene.names)
        for engine in engines:
            film = Film(case.scene, get_engine(engine).rollout(case.scene, batch, dt=DT))
            measured = np.array(case.measure(film))
            scale = np.abs(case.scale or case.exact)
            row.measured[engine] = tuple(measured.tolist())
            row.error[engine] = tuple((np.abs(measured - case.exact) / scale).tolist())
            broken = any(j.break_impulse is not None for j in case.joints)
            gaps = [0.0] if broken else [float(positions(film, j)[1].max()) for j in case.joints]
            row.gap[engine] = max(gaps)
        rows.append(row)
    return rows


def too_far(rows: list[Row], engines: tuple[str, ...] = ENGINES) -> list[str]:
    """What is over its limit in an engine that is held to it."""
    out: list[str] = []
    for row in rows:
        held = [e for e in engines if e in row.error and e not in row.case.beyond]
        for engine in held:
            if not all(e <= m for e, m in zip(row.error[engine], row.case.limits, strict=True)):
                out.append(
                    f"{row.case.name}: {engine} measured {row.measured[engine]}, "
                    f"exact {row.case.exact}, limits {row.case.limits}"
                )
            if not row.gap[engine] <= GAP_LIMIT_M:
                out.append(f"{row.case.name}: {engine} lets anchors {row.gap[engine]:.2g} m apart")
    return out


def markdown(rows: list[Row], engines: tuple[str, ...]) -> str:
    """The table: what is off by how much, and how far anchors were apart."""
    lines = [
        f"| case | compared | {' | '.join(engines)} |",
        "| --- | --- |" + " --- |" * len(engines),
    ]
    for row in rows:
        cells = [
            f"{', '.join(f'{e:.2%}' for e in row.error[n])}; {1e3 * row.gap[n]:.2f} mm"
            for n in engines
        ]
        lines.append(f"| {row.case.name} | {row.case.quantity} | {' | '.join(cells)} |")
    return "\n".join(lines)


def main() -> int:
    """Prints the table; 1 if an engine misses a limit."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engines", nargs="+", default=list(ENGINES), choices=ENGINES)
    parser.add_argument("--only", default="", help="cases whose name contains this")
    parser.add_argument("--json", type=Path, help="also write all numbers to this file")
    args = parser.parse_args()
    engines = tuple(args.engines)
    rows = run(engines, [c for c in cases() if args.only in c.name])
    print(markdown(rows, engines))
    if args.json:
        data = [
            {"name": r.case.name, "exact": r.case.exact, "measured": r.measured,
             "error": r.error, "gap": r.gap}
            for r in rows
        ]  # fmt: skip
        args.json.write_text(json.dumps(data, indent=2) + "\n")
    wrong = too_far(rows)
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
