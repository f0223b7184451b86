"""Which bodies rest where they start, judged from geometry, against what engines do with them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.engines import get_engine, jobs
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.rest import at_rest, close_pairs, starts_at_rest
from esg.engines.scene import Body, Shape, SimScene, Variation

UNIT = ((0.05, 0.0, 0.0), (0.0, 0.05, 0.0), (0.0, 0.0, 0.05))


def body(name: str, at: tuple[float, float, float], *shapes: Shape, **options) -> Body:
    half = shapes[0].size
    return Body(name, options.pop("static", False), 2.0, UNIT, shapes, at, half_extents=half,
                **options)  # fmt: skip


def crate(name: str, x: float, z: float = 0.2, **options) -> Body:
    return body(name, (x, 0.0, z), Shape("box", (0.2, 0.2, 0.2)), **options)


TILTED = (0.0, float(np.sin(0.05)), 0.0, float(np.cos(0.05)))
LEGS = tuple(
    Shape("box", (0.03, 0.03, 0.2), (x, y, -0.05)) for x in (-0.3, 0.3) for y in (-0.3, 0.3)
)
TOP = Shape("box", (0.35, 0.35, 0.05), (0.0, 0.0, 0.2))
CASES = {
    "on the ground": ([crate("a", 0.0)], [True]),
    "in the air": ([crate("a", 0.0, 0.25)], [False]),
    "in the ground": ([crate("a", 0.0, 0.19)], [False]),
    "tilted": ([crate("a", 0.0, quaternion=TILTED)], [False]),
    "a tower": ([crate("c", 0.0, 1.0), crate("a", 0.0), crate("b", 0.0, 0.6)], [True] * 3),
    "hardly on the edge, which is not understood": (
        [crate("a", 0.0), crate("b", 0.19, 0.6)], [True, False]
    ),
    "over the edge": ([crate("a", 0.0), crate("b", 0.21, 0.6)], [True, False]),
    "on what falls": ([crate("a", 0.0, 0.5), crate("b", 0.0, 0.9)], [False, False]),
    "in one another": ([crate("a", 0.0), crate("b", 0.3)], [False, False]),
    "side by side": ([crate("a", 0.0), crate("b", 0.4)], [True, True]),
    "on legs": ([body("table", (0.0, 0.0, 0.25), *LEGS, TOP)], [True]),
    "on one leg": ([body("table", (0.0, 0.0, 0.25), LEGS[0], TOP)], [False]),
    "a ball": ([body("ball", (0.0, 0.0, 0.1), Shape("sphere", (0.1, 0.1, 0.1)))], [True]),
    "a ball on a table": (
        [body("table", (0.0, 0.0, 0.25), *LEGS, TOP, static=True),
         body("ball", (0.1, 0.0, 0.6), Shape("sphere", (0.1, 0.1, 0.1)))],
        [False, True],
    ),
    "a can": ([body("can", (0.0, 0.0, 0.1), Shape("cylinder", (0.05, 0.05, 0.1)))], [True]),
    "a decal": ([Body("mat", False, 1.0, UNIT, (), (0.0, 0.0, 0.0))], [False]),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_what_rests(name: str) -> None:
    bodies, expected = CASES[name]
    assert at_rest(SimScene(name, tuple(bodies))).tolist() == expected


@pytest.mark.parametrize("name", [n for n in CASES if any(CASES[n][1])])
def test_what_rests_stays_in_the_reference_engine(name: str) -> None:
    """Half a second of Newton moves it by less than a millimetre."""
    bodies, expected = CASES[name]
    scene = SimScene(name, tuple(bodies))
    r = get_engine("newton").rollout(scene, batch_programs([Program((), 0.5)], scene.names))
    moved = np.abs(r.position[0, -1] - r.position[0, 0]).max(axis=-1)
    assert (moved[np.array(expected)] < 1e-3).all()


def test_slanted_gravity_lets_nothing_rest() -> None:
    scene = replace(SimScene("slope", (crate("a", 0.0),)), gravity=(1.0, 0.0, -9.7))
    assert not at_rest(scene).any()


def test_neither_what_starts_elsewhere_rests_nor_its_load() -> None:
    """In the second world the lower crate was shifted away."""
    scene = SimScene("shifted", (crate("a", 0.0), crate("b", 0.0, 0.6), crate("c", 2.0)))
    position = np.tile([b.position for b in scene.bodies], (2, 1, 1))
    quaternion = np.tile([b.quaternion for b in scene.bodies], (2, 1, 1))
    position[1, 0, 0] += 0.3
    rests = starts_at_rest(scene, position, quaternion)
    assert rests.tolist() == [[True, True, True], [False, False, True]]


def test_close_pairs_are_measured_part_by_part() -> None:
    """What stands between a table's legs is not close to any of them."""
    table = body("table", (0.0, 0.0, 0.25), *LEGS, TOP)
    cup = body("cup", (0.0, 0.0, 0.05), Shape("cylinder", (0.03, 0.03, 0.05)))
    scene = SimScene("under", (table, cup))
    assert not close_pairs(scene, 0.05).any()
    assert close_pairs(scene, 0.4).tolist() == [[False, True], [True, False]]


def test_the_surrogate_lets_it_sleep_until_it_is_hit(monkeypatch: pytest.MonkeyPatch) -> None:
    """A hit on a crate that carries another is as hard as if both had been awake before."""
    scene = SimScene(
        "hit",
        (replace(crate("a", 0.0), active=True), crate("b", 1.0), crate("c", 1.0, 0.6),
         crate("d", 5.0), crate("e", 7.0, 0.4)),
    )  # fmt: skip
    batch = batch_programs([Program((SetVelocity("a", 0.0, (3.1, 0.0, 0.0)),), 0.8)], scene.names)
    engine = get_engine("surrogate")
    asleep = engine.rollout(scene, batch)
    monkeypatch.setattr(jobs, "starts_at_rest", lambda s, p, q: np.zeros(p.shape[:2], bool))
    awake = engine.rollout(scene, batch)
    assert np.abs(asleep.position - awake.position).max() < 5e-3
    assert np.array_equal(asleep.position[0, :, 3], asleep.position[0, :1, 3].repeat(193, axis=0))
    assert asleep.position[0, -1, 4, 2] < 0.25, "what hangs in the air falls"
    hits = [
        r.contacts.impulse[(r.contacts.a == 0) & (r.contacts.b == 1)].sum() for r in (asleep, awake)
    ]
    assert hits[0] == pytest.approx(hits[1], rel=0.02) and hits[0] > 1.0


def test_nothing_sleeps_where_the_ground_is_logged() -> None:
    scene = SimScene("weight", (crate("a", 0.0),))
    batch = batch_programs([Program((), 0.25)], scene.names)
    r = get_engine("surrogate").rollout(scene, batch, variation=Variation(), ground_contacts=True)
    assert r.contacts.impulse.sum() == pytest.approx(2.0 * 9.81 * 0.25, rel=0.05)
