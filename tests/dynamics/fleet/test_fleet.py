"""Many scenes at once decide what each of them decides alone, to the last bit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from esg.dynamics import start_hints
from esg.dynamics.fleet import many
from esg.dynamics.fleet.many import Clock, optimize_many
from esg.dynamics.plan import build_scene
from esg.dynamics.search import batched
from esg.dynamics.strategies import optimize
from esg.engines.fleet import FleetNewton, FleetSurrogate
from esg.engines.fleet import surrogate as fleet_surrogate
from esg.engines.jobs import Buffer, Expected, make_job, read
from esg.engines.program import HoldVelocity, Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Body, Rollout, Shape, SimScene, Variation
from esg.engines.shapes import SceneShapes
from esg.graph.models import EsgDocument
from esg.layout import solve
from esg.outcomes import UserError
from tests.dynamics import stories
from tests.dynamics.stage import lay_out

STORIES = (
    stories.car_bin_table,
    stories.three_balls,
    stories.car_hits_jeep_at_3s,
    stories.throw_hits_table_at_1s,
    stories.topple,
    stories.impossible_transfer,
)


@pytest.fixture(scope="module")
def documents() -> list[EsgDocument]:
    return [lay_out(story(), 1) for story in STORIES]


@pytest.fixture(scope="module")
def alone(documents: list[EsgDocument]) -> list[EsgDocument]:
    return [optimize(d, seed=k, max_rounds=3) for k, d in enumerate(documents)]


@pytest.mark.slow
@pytest.mark.parametrize(("processes", "shift"), [(1, 250), (3, 250), (1, 2), (3, 2)])
def test_together_is_as_alone(
    documents: list[EsgDocument],
    alone: list[EsgDocument],
    processes: int,
    shift: int,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Outcome, theta, steps and provenance are equal, whatever the processes and shifts."""
    monkeypatch.setattr(many, "SHIFT_SCENES", shift)
    clock = Clock()
    seeds = list(range(len(documents)))
    together = optimize_many(documents, seeds, max_rounds=3, processes=processes, clock=clock)
    for one, other in zip(alone, together, strict=True):
        assert one.model_dump_json() == other.model_dump_json()
    first = clock.launches[0]
    assert first["engine"] == "surrogate" and first["scenes"] >= min(shift, len(documents))
    if shift < len(documents):
        begun = [row["scenes"] for row in clock.launches[: len(documents) // shift]]
        assert max(begun) < len(documents) * 2, "each shift has a launch of its own"
    confirmed = [row for row in clock.launches if row["engine"] == "newton"]
    first = [row for row in confirmed if row.get("beside")]
    assert len(first) == 1, "what need not be explored is confirmed while others explore"
    assert first[0]["scenes"] > 1, "together, not one by one"
    # What is done by the second of them plays its ending there, too.
    assert len(documents) <= sum(row["scenes"] for row in confirmed[:2]) <= 2 * len(documents)
    assert set(clock.seconds) >= {"surrogate", "newton", "wait"}


def test_candidates_are_played_beside_the_finalists_before_them(
    documents: list[EsgDocument], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Passes of two rounds of polishing overlap; documents, counts included, stay the same."""
    monkeypatch.setattr(batched, "settled", lambda *_: False)
    monkeypatch.setattr(batched, "REFERENCE_SHARE", 1.0)
    doc = documents[STORIES.index(stories.impossible_transfer)]
    alone = optimize(doc, seed=1, max_rounds=4)
    assert alone.dynamics_result is not None
    assert [s.phase for s in alone.dynamics_result.steps].count("polish") == 2
    clock = Clock()
    (together,) = optimize_many([doc], [1], max_rounds=4, clock=clock)
    assert together.model_dump_json() == alone.model_dump_json()
    worlds = [row["worlds"] for row in clock.launches if row["engine"] == "newton"]
    assert worlds == [8, 8, 8, 8, 32, 64, 32, 1], "the last plays the ending"


def test_none_and_static_documents(documents: list[EsgDocument]) -> None:
    """Without a search, and without anything to search."""
    static = documents[0].model_copy(update={"timeline_system": None})
    docs = [static, documents[2]]
    together = optimize_many(docs, [0, 0], strategy="none")
    assert together == [optimize(d, seed=0, strategy="none") for d in docs]
    assert optimize_many([], []) == []


def test_what_cannot_run_together_is_said(documents: list[EsgDocument]) -> None:
    with pytest.raises(UserError, match="hybrid"):
        optimize_many(documents, [0] * len(documents), strategy="hybrid")
    with pytest.raises(UserError, match="seeds"):
        optimize_many(documents, [0])


def test_an_error_in_one_scene_reaches_the_caller(documents: list[EsgDocument]) -> None:
    """Nothing hangs when a search fails: the others' engines stop waiting for it."""
    broken = documents[2].model_copy(update={"layout_result": None})
    errors = []
    try:
        optimize(broken)
    except Exception as error:
        errors.append(type(error))
    assert errors, "the document is broken for a single search, too"
    with pytest.raises(errors[0]):
        optimize_many([documents[2], broken], [0, 0], max_rounds=1)


# -- engines ---------------------------------------------------------------------------------------

UNIT = ((0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1))


def _cloud(n: int) -> tuple[tuple[float, float, float], ...]:
    points = np.random.default_rng(n).normal(size=(n, 3))
    points *= 0.2 / np.linalg.norm(points, axis=1, keepdims=True)
    return tuple((float(x), float(y), float(z)) for x, y, z in points)


def _ball_and_hull() -> SimScene:
    """A ball rolls into a convex body; a table stands by."""
    ball = Body("ball", False, 1.0, UNIT, (Shape("sphere", (0.2, 0.2, 0.2)),), (0.0, 0.0, 0.2),
                roll_radius=0.2)  # fmt: skip
    rock = Body("rock", False, 2.0, UNIT,
                (Shape("convex", (0.2, 0.2, 0.2), vertices=_cloud(14)),), (0.8, 0.0, 0.21))  # fmt: skip
    table = Body("table", True, 1.0, UNIT, (Shape("box", (0.3, 0.3, 0.3)),), (2.0, 0.0, 0.3))
    return SimScene("ball and rock", (table, ball, rock))


def _stack() -> SimScene:
    """Boxes of many shapes that touch at once: more contacts than there is room for at first."""
    legs = tuple(
        Shape("box", (0.05, 0.05, 0.1), (x, y, 0.0)) for x in (-0.3, 0.3) for y in (-0.3, 0.0, 0.3)
    )
    bodies = [Body(f"box_{k}", False, 1.0, UNIT, legs, (0.0, 0.0, 0.1 + 0.2 * k)) for k in range(4)]
    puck = Body("puck", False, 0.5, UNIT, (Shape("cylinder", (0.1, 0.1, 0.05)),), (1.0, 0.0, 0.05))
    return SimScene("stack", (*bodies, puck))


def _calls():
    ball = [
        Program((HoldVelocity("ball", 0.0, 1.0, 1.5 + 0.2 * k, 0.0, roll_radius=0.2,
                              until_contact=("rock",)),), 1.0)
        for k in range(3)
    ]  # fmt: skip
    puck = [Program((SetVelocity("puck", 0.1, (-3.0 - k, 0.0, 0.0)),), 0.5) for k in range(2)]
    blown = [Program((SetVelocity("ball", 0.1, (x, 0.0, 0.0)),), 0.5) for x in (1.0, 700.0)]
    scenes = (_ball_and_hull(), _stack(), _ball_and_hull())
    variation = Variation(friction_scale=np.array([0.8, 1.0, 1.2]),
                          restitution_offset=np.array([0.0, 0.1, -0.1]))  # fmt: skip
    return [
        (s, batch_programs(p, s.names), v)
        for s, p, v in zip(scenes, (ball, puck, blown), (variation, None, None), strict=True)
    ]


def _fleet(name: str, calls: Sequence[Any]) -> list[Rollout]:
    engine = {"surrogate": FleetSurrogate, "newton": FleetNewton}[name]("cpu")
    jobs = [
        make_job(name, k, s, SceneShapes.of(s), b, dt=1 / 240, record_every=4, variation=v)
        for k, (s, b, v) in enumerate(calls)
    ]
    shapes = [j.shapes for j, _ in jobs]
    buffer = Buffer(np.zeros(20_000_000, np.uint8))
    played = engine.play([j for j, _ in jobs], [s for s in shapes if s is not None], buffer)
    return [read(j, start, p) for (j, start), p in zip(jobs, played, strict=True)]


def test_newton_uses_what_it_built_ahead() -> None:
    """Announced jobs are built once, before they come, and play as those that nobody announced."""
    calls = [_calls()[k] for k in (0, 2)]
    jobs = [
        make_job("newton", k, s, SceneShapes.of(s), b, dt=1 / 240, record_every=4, variation=v)
        for k, (s, b, v) in enumerate(calls)
    ]
    shapes = [j.shapes for j, _ in jobs if j.shapes is not None]
    engine = FleetNewton("cpu", ahead=True)
    expected = [Expected(j.key, j.n_worlds, j.frames) for j, _ in jobs]
    engine.expect(expected[:1], shapes[:1], complete=False)
    assert not engine.drafts.ready
    engine.expect(expected, shapes, complete=True)
    assert sorted(*engine.drafts.ready) == [(0, 3, 1), (1, 2, 1)]
    played = engine.play([j for j, _ in jobs], shapes, Buffer(np.zeros(20_000_000, np.uint8)))
    assert not engine.drafts.ready
    for (job, start), result, plain in zip(jobs, played, _fleet("newton", calls), strict=True):
        _assert_equal(plain, read(job, start, result))


def _assert_equal(here: Rollout, there: Rollout) -> None:
    for field in ("time", "position", "quaternion", "linear_velocity", "angular_velocity", "valid"):
        assert np.array_equal(getattr(here, field), getattr(there, field)), field
    for column in here.contacts.__dataclass_fields__:
        a, b = getattr(here.contacts, column), getattr(there.contacts, column)
        assert np.array_equal(a, b), column
    assert len(here.contacts.world) or not here.valid.all()
    for note in ("deepest", "tunnelled"):
        if note in here.extra:
            a, b = (np.asarray(r.extra[note]) for r in (here, there))
            assert np.array_equal(a, b)


def _alone(name: str) -> list[Rollout]:
    engine = get_engine(name)
    return [engine.rollout(s, b, record_every=4, variation=v) for s, b, v in _calls()]


def test_surrogate_plays_different_scenes_as_alone() -> None:
    """States, logs and validity of three scenes of different size and length, one diverging."""
    together = _fleet("surrogate", _calls())
    for here, there in zip(_alone("surrogate"), together, strict=True):
        _assert_equal(here, there)
    assert not together[2].valid.all(), "the last scene's second world is too fast"


def test_newton_plays_different_scenes_as_alone() -> None:
    """Likewise; beside a more crowded scene the solver adds up in another order."""
    alone, calls = _alone("newton"), _calls()
    pair = _fleet("newton", [calls[0], calls[2]])
    _assert_equal(alone[0], pair[0])
    _assert_equal(alone[2], pair[1])
    for here, there in zip(alone, _fleet("newton", calls), strict=True):
        assert np.array_equal(here.valid, there.valid)
        assert np.abs(here.position - there.position).max() < 1e-2
        assert abs(len(here.contacts.world) - len(there.contacts.world)) <= 2


def test_surrogate_grants_more_room(monkeypatch: pytest.MonkeyPatch) -> None:
    """The stack has more contacts than fit at first; none is lost."""
    monkeypatch.setattr(fleet_surrogate, "CONTACTS", 12)
    fleet = FleetSurrogate("cpu")
    scene, batch, _ = _calls()[1]
    job, _ = make_job(
        "surrogate", 7, scene, SceneShapes.of(scene), batch, dt=1 / 240, record_every=4,
        variation=None,
    )  # fmt: skip
    assert job.shapes is not None
    fleet.play([job], [job.shapes], Buffer(np.zeros(20_000_000, np.uint8)))
    assert fleet.contacts[7] > 12


def test_jointed_scenes_are_searched_beside_others() -> None:
    """What has joints explores in Newton, in passes of its own; all come out as alone."""
    door = stories.cast("A ball hits a swinging door.")
    door = solve(door, seed=0, hints=start_hints(door, seed=0))
    assert build_scene(door).joints
    docs = [lay_out(stories.three_balls(), 1), door]
    together = optimize_many(docs, [0, 1], max_rounds=3)
    for k, (doc, other) in enumerate(zip(docs, together, strict=True)):
        alone = optimize(doc, seed=k, max_rounds=3)
        assert alone.model_dump_json() == other.model_dump_json()
    explored = together[1].dynamics_result
    assert explored is not None and {s.engine for s in explored.steps} == {"newton"}
