"""What starts from rest speeds up, and what brakes slows down, as things of its kind do."""

from __future__ import annotations

import csv
import math

import numpy as np
import pytest

from esg.dynamics import build_scene, start_hints
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.plan.planner import Plan, make_plan
from esg.dynamics.search import REFERENCE_DT_S, Panel
from esg.dynamics.story.paces import FASTEST_G, SLOWEST_G, TABLE, grip, pace, pace_of
from esg.engines import get_engine
from esg.engines.program import AdjustProperties, HoldVelocity, Primitive, batch_programs
from esg.graph.models import EsgDocument
from esg.layout import solve
from esg.metrics.plausibility.limits import motion_of
from esg.thresholds import BRAKING_DRY_G
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast

G = GRAVITY_MPS2


def planned(doc: EsgDocument) -> Plan:
    laid = solve(doc, hints=start_hints(doc))
    return make_plan(laid, build_scene(laid))


def program_of(doc: EsgDocument) -> tuple[Primitive, ...]:
    plan = planned(doc)
    return plan.compile(plan.initial()).primitives


def braking_with(doc: EsgDocument, **params: object) -> EsgDocument:
    """The document with other parameters of its Brake segments."""
    timeline = doc.timeline_system
    assert timeline is not None
    graph = timeline.sequence_graph
    edges = tuple(
        e.model_copy(update={"params": e.params.model_copy(update=params)})
        if e.event.value == "Brake"
        else e
        for e in graph.edges
    )
    graph = graph.model_copy(update={"edges": edges})
    timeline = timeline.model_copy(update={"sequence_graph": graph})
    return doc.model_copy(update={"timeline_system": timeline})


def test_every_row_of_the_table_is_believable_and_says_where_it_is_from() -> None:
    """Between a tenth and a half of g from rest, no more than good tyres give when braking."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len({r["kind"] for r in rows}) == len(rows) > 20
    for row in rows:
        assert SLOWEST_G <= float(row["sets_off_g"]) <= FASTEST_G, row
        usual, hardest = float(row["brakes_g"]), float(row["hardest_g"])
        assert 0.1 <= usual <= hardest <= BRAKING_DRY_G, row
        assert len(row["source"]) > 10, row


@pytest.mark.parametrize(
    ("name", "like"),
    [
        ("old yellow taxi", "car"),
        ("racing_car", "sports car"),
        ("fire truck", "truck"),
        ("locomotive", "train"),
        ("sprinter", "person"),
        ("poodle", "dog"),
        ("giraffe", "animal"),
        ("quadcopter", "drone"),
    ],
)
def test_a_name_has_the_pace_of_what_stands_above_it(name: str, like: str) -> None:
    """The longest part of a name that is known decides, then its wider kinds."""
    assert pace_of(name) == pace_of(like)
    assert pace_of("no such thing", name) == pace_of(like)


def test_what_waits_gains_speed_and_what_is_under_way_does_not() -> None:
    """A van drives off at a quarter of g; one that comes along has its speed at once."""
    waits = "A van waits at the crossing for 2 seconds, then drives off and hits a bollard."
    hold = next(p for p in program_of(cast(waits)) if isinstance(p, HoldVelocity) and p.time > 0.0)
    assert (hold.speed, hold.acceleration) == pytest.approx((0.0, pace_of("van").gains))
    assert 2.0 < hold.max_speed < 20.0
    comes = next(
        p for p in program_of(cast("A van hits a bollard.")) if isinstance(p, HoldVelocity)
    )
    assert comes.time == 0.0 and comes.speed > 2.0 and comes.acceleration == 0.0


def test_what_has_stopped_drives_on_from_rest() -> None:
    """A bus at a stop pulls away as buses do, and turns while it gains speed."""
    doc = cast("A bus stops at a bus stop for 2 seconds, then drives on and turns right.")
    nominal = choreograph(doc).nominal
    gains = {k: v for k, v in nominal.items() if k.endswith("/gains")}
    assert gains and set(gains.values()) == {pace_of("bus").gains}
    begins = [nominal[k.replace("/gains", "/begins")] for k in gains]
    assert min(begins) == 0.0
    holds = [p for p in program_of(doc) if isinstance(p, HoldVelocity) and p.acceleration > 0.0]
    turn = next(p for p in holds if p.turn_rate)
    before = next(p for p in holds if p.end == turn.start)
    gained = before.speed + before.acceleration * (before.end - before.start)
    assert turn.speed == pytest.approx(gained, abs=1e-6)


def test_what_has_stopped_does_not_go_on_before_it_stands() -> None:
    """However fast the search has it come, and however soon it shall go on."""
    plan = planned(cast("A bus stops at a bus stop for 2 seconds, then drives on and turns right."))
    theta = plan.initial()
    names = [v.name for v in plan.variables]
    theta[names.index("bus_1_drive/speed")] = 16.0
    brakes, lets_go, on = plan.compile(theta).primitives[1:4]
    assert isinstance(brakes, AdjustProperties) and brakes.braking is not None
    assert isinstance(lets_go, AdjustProperties) and lets_go.braking == 0.0
    lasts = lets_go.time - brakes.time
    assert isinstance(on, HoldVelocity) and on.speed == 0.0 and on.start == lets_go.time
    assert 1.0 < lasts == pytest.approx(16.0 / (brakes.braking + 0.5 + 0.8), rel=0.1)


def test_a_hit_after_a_start_from_rest_has_room_for_it() -> None:
    """Where the taxi sets off when the truck has hit, the way to it is v^2 / 2 a or more."""
    doc = cast("A van waits for 2 seconds, then drives off and knocks over a bollard.")
    nominal = choreograph(doc).nominal
    speed, rate = nominal["van_1_drive_2/speed"], nominal["van_1_drive_2/gains"]
    lasts = nominal["van_1_bollard_1_collision/event_time"] - 2.0
    spots = {p.node: p for c in start_hints(doc).constellations for p in c.placements}
    way = 0.01 * (spots["bollard_1"].x_cm - spots["van_1"].x_cm)
    gaining = min(lasts, speed / rate)
    covered = 0.5 * rate * gaining**2 + speed * (lasts - gaining)
    assert 0.0 < way - covered < 4.0  # half of the van and half of the bollard


@pytest.mark.parametrize(
    "prompt",
    [
        "A white van drives at 12 m/s, then brakes and comes to a stop.",
        "A taxi drives down the road, brakes hard, but still hits a trash bin.",
        "A car collides with a trash bin, knocking it into a picnic table.",
        "A man walks to a bench and stops.",
        "A van waits for 2 seconds, then drives off, turns left and stops.",
        "A motorcycle overtakes a bus, cuts in front of it and brakes; the bus hits the motorcycle.",
    ],
)
def test_nothing_speeds_up_or_brakes_faster_than_the_ground_allows(prompt: str) -> None:
    """Without contact, no driver's velocity changes by more than 0.8 g from frame 0 on.

    Over a twentieth of a second: the solver's own noise is no acceleration.
    """
    plan = planned(cast(prompt))
    program = plan.compile(plan.initial())
    played = get_engine("physx").rollout(
        plan.scene, batch_programs([program], plan.scene.names), record_every=4
    )
    log, span = played.contacts, 3
    for actor in plan.story.phases:
        i = plan.scene.index(actor)
        touched = np.zeros(len(played.time) + span, bool)
        for frame in log.frame[(log.a == i) | (log.b == i)]:
            touched[max(frame - 2, 0) : frame + 3] = True
        v = played.linear_velocity[0, :, i, :2].astype(float)
        change = np.linalg.norm(v[span:] - v[:-span], axis=1) / (span * played.time[1])
        free = [not touched[k : k + span + 1].any() for k in range(len(change))]
        assert change[free].max() < 1.02 * BRAKING_DRY_G * G, actor


def test_the_driver_brakes_after_a_hit_that_others_carry_on() -> None:
    """Its tyres stop it at its kind's usual rate, no damping does."""
    doc = cast("A car collides with a trash bin, knocking it into a picnic table.")
    brakes = [p for p in program_of(doc) if isinstance(p, AdjustProperties)]
    assert [p.body for p in brakes] == ["car_1"]
    assert brakes[0].braking == pytest.approx(pace_of("car").brakes)
    assert brakes[0].linear_damping is None


@pytest.mark.parametrize(
    "prompt",
    [
        "A truck hits a shopping cart and the shopping cart then crashes into a wooden fence.",
        "A bus driving at 14 m/s hits a barrel, which then hits a brick wall.",
        "A taxi driving at 9 m/s hits a wooden crate and the wooden crate then crashes into a "
        "concrete barrier.",
    ],
)
def test_who_brakes_does_not_crush_what_it_sent_on(prompt: str) -> None:
    """It comes to what stands fast after the second look at the hit there, whatever the grip."""
    plan = planned(cast(prompt))
    found = Panel(plan, "cpu", dt=REFERENCE_DT_S).judge(plan.initial()[None])
    assert found.ensemble.all_completed().all()


def test_nobody_is_let_go_on_their_feet() -> None:
    """Whose part ends while the scene goes on slows down within a step, and stays upright."""
    plan = planned(cast("A man walks onto the road. A car drives at 10 m/s and brakes and stops."))
    played = get_engine("physx").rollout(
        plan.scene, batch_programs([plan.compile(plan.initial())], plan.scene.names)
    )
    x, y, _, _ = played.quaternion[0, -1, plan.scene.index("man_1")]
    assert 1.0 - 2.0 * (x * x + y * y) > 0.99


def test_who_has_crashed_brakes() -> None:
    """A car does not roll back from a wall for seconds."""
    brakes = [p for p in program_of(cast("A car hits a wall.")) if isinstance(p, AdjustProperties)]
    assert [p.braking for p in brakes] == [pytest.approx(pace_of("car").brakes)]


def test_ice_stops_nothing_soon() -> None:
    """What is said to be on ice brakes at a tenth of g at most."""
    doc = cast("A puck slides over the ice at 4 m/s and hits a goalpost.")
    assert grip(doc, "puck_1") == pytest.approx(0.04 * G)
    runs = cast("A dog runs over the ice and hits a goalpost.")
    assert grip(runs, "dog_1") == pytest.approx(0.1 * G)
    assert grip(cast("A car hits a wall."), "car_1") == pytest.approx(0.8 * G)


def test_a_stop_that_the_ground_does_not_allow_is_not_forced() -> None:
    """20 m/s in half a second would take 4 g: the brakes end at 0.8 g."""
    plan = planned(cast("A car drives at 20 m/s, brakes and stops within half a second."))
    braking = next(v for v in plan.variables if v.name.endswith("/braking"))
    assert braking.initial == braking.upper < BRAKING_DRY_G * G
    assert not braking.fixed


def test_what_a_document_states_of_its_brakes_is_kept() -> None:
    """A number of damping is that damping, and a stated rate is that rate; a pair is open."""
    doc = cast("A car drives at 10 m/s, brakes and stops.")
    damped = [p for p in program_of(braking_with(doc, damping=2.0)) if p.time > 0.0]
    assert [p.linear_damping for p in damped if isinstance(p, AdjustProperties)] == [2.0]
    plan = planned(braking_with(doc, acceleration=-900.0))
    braking = next(v for v in plan.variables if v.name.endswith("/braking"))
    car = plan.scene.body("car_1")
    coasts = 0.5 * car.friction * G
    assert braking.fixed and braking.initial == pytest.approx(9.0 - coasts, abs=0.6)
    free = planned(doc)
    assert not next(v for v in free.variables if v.name.endswith("/braking")).fixed


def test_what_walks_up_to_something_comes_to_rest_before_it() -> None:
    """Its brakes set in where they leave it at what it reaches."""
    plan = planned(cast("A cat walks to a bowl."))
    played = get_engine("physx").rollout(
        plan.scene, batch_programs([plan.compile(plan.initial())], plan.scene.names)
    )
    cat, bowl = (plan.scene.index(n) for n in ("cat_1", "bowl_1"))
    bodies = plan.scene.bodies
    gap = math.dist(*(played.position[0, -1, i, :2] for i in (cat, bowl)))
    gap -= bodies[cat].half_extents[0] + bodies[bowl].half_extents[0]
    assert np.linalg.norm(played.linear_velocity[0, -1, cat]) < 0.05
    assert 0.0 < gap < 0.3


def test_what_drives_on_as_before_keeps_its_speed() -> None:
    """One variable for the speed before, in and after a turn."""
    plan = planned(cast("A car drives along the road, turns left and hits a bin."))
    speeds = [v.name for v in plan.variables if v.name.endswith("/speed")]
    assert len(speeds) == 1
    holds = [p for p in plan.compile(plan.initial()).primitives if isinstance(p, HoldVelocity)]
    assert len(holds) == 3 and len({p.speed for p in holds}) == 1


def test_a_stated_time_of_arrival_is_that_of_its_end() -> None:
    """The brakes set in so early that the car is there, at rest, after four seconds."""
    plan = planned(cast("A car drives at 10 m/s to a gate and reaches it after 4 seconds."))
    sets_in = next(v for v in plan.variables if v.name.endswith("_reach/time"))
    assert not sets_in.fixed
    played = get_engine("physx").rollout(
        plan.scene, batch_programs([plan.compile(plan.initial())], plan.scene.names)
    )
    speed = np.linalg.norm(played.linear_velocity[0, :, plan.scene.index("car_1")], axis=1)
    stands = float(played.time[np.flatnonzero(speed > 0.1)[-1]])
    assert stands == pytest.approx(4.0, abs=0.25)


def test_what_slows_down_goes_on_with_the_speed_it_has_then() -> None:
    """From 15 to 5 m/s by a hold that ends where the next one begins, at no more than 0.8 g."""
    doc = cast("A car is moving at 15 m/s. It slows down to 5 m/s and hits a cone after 4 seconds.")
    cruise, slower, on = (p for p in program_of(doc) if isinstance(p, HoldVelocity))
    assert cruise.end == slower.start and slower.end == on.start
    lasts = slower.end - slower.start
    assert slower.speed + slower.acceleration * lasts == pytest.approx(on.speed)
    assert 0.3 * G < -slower.acceleration < BRAKING_DRY_G * G


def test_what_waits_after_a_time_brakes_before_it_stands() -> None:
    """From 1 m/s to a wait of 2 s it slows down as its kind does, then it is held at rest."""
    doc = cast(
        "A transport robot moves along the hospital corridor at 1 m/s, waits 2 seconds in front of "
        "a door, then goes on and turns left by 90 degrees."
    )
    under_way, slower, waits, *_ = (p for p in program_of(doc) if isinstance(p, HoldVelocity))
    assert under_way.end == slower.start and slower.end == waits.start
    assert slower.speed == under_way.speed == pytest.approx(1.0)
    assert -slower.acceleration == pytest.approx(pace(doc, "robot_1").brakes)
    assert waits.speed == pytest.approx(0.0, abs=1e-9)


def test_what_drives_on_more_slowly_after_a_turn_brakes_first() -> None:
    doc = cast("A fire engine turns left by 90 degrees at the intersection and drives on at 7 m/s.")
    *_, turn, slower, on = (p for p in program_of(doc) if isinstance(p, HoldVelocity))
    lasts = slower.end - slower.start
    assert slower.speed == pytest.approx(turn.speed) and on.speed == pytest.approx(7.0)
    assert slower.speed + slower.acceleration * lasts == pytest.approx(on.speed)
    assert -slower.acceleration <= grip(doc, "fire_engine_1")


def test_no_candidate_turns_or_stops_harder_than_its_grip_bears() -> None:
    """Whatever theta asks for: the fastest turn at 15 m/s, the shortest stop of what runs."""
    plan = planned(cast("An ambulance drives at 54 km/h, then turns left."))
    theta = plan.initial()
    fast = [float(v.upper) if v.name.endswith("turn_rate") else x
            for v, x in zip(plan.variables, theta, strict=True)]  # fmt: skip
    holds = [p for p in plan.compile(np.array(fast)).primitives if isinstance(p, HoldVelocity)]
    assert max(p.turn_rate for p in holds) == pytest.approx(0.75 * BRAKING_DRY_G * G / 15.0)


def test_a_skater_turns_no_faster_than_ice_allows() -> None:
    doc = cast("A skater glides over the ice at 3 m/s for 2 seconds, then turns left.")
    turns = [p for p in program_of(doc) if isinstance(p, HoldVelocity) and p.turn_rate]
    assert turns and all(p.turn_rate * p.speed <= 0.1 * G * (1.0 + 1e-9) for p in turns)


def test_what_rolls_out_is_slowed_no_harder_than_by_friction() -> None:
    doc = cast("A shot put of 7.26 kg rolls over the grass at 5 m/s and comes to rest within 2 s.")
    damped = [p for p in program_of(doc) if isinstance(p, AdjustProperties)]
    assert damped and damped[0].linear_damping is not None
    most, first, rest = grip(doc, "shot_put_1") * (1.0 + 1e-9), damped[0].linear_damping, damped[1]
    assert first * 5.0 <= most
    assert rest.linear_damping is not None
    assert rest.linear_damping * 5.0 * math.exp(-first * rest.time) <= most


def test_tyres_are_on_what_the_judge_holds_to_its_way() -> None:
    """One table says what runs on casters."""
    scene = planned(cast("A van hits a stroller, a shopping cart and a handcart.")).scene
    for b in scene.bodies:
        if b.wheeled:
            swivels = motion_of(b.label, b.category).moves == "casters"
            assert (b.tyre_friction == 0.0) is swivels, b.name
    assert {"casters", "pushed"} <= {motion_of(b.label, b.category).moves for b in scene.bodies}


@pytest.mark.parametrize(
    ("prompt", "name"),
    [
        ("A bulldozer moves up to a brick wall and stops 1 m in front of it.", "bulldozer"),
        (
            "A bulldozer shoves a concrete block into a portable toilet and the toilet falls over.",
            "bulldozer",
        ),
        ("A baby crawls up to a toy box and stops.", "baby"),
    ],
)
def test_nothing_is_guessed_to_be_faster_than_its_kind(prompt: str, name: str) -> None:
    plan = planned(cast(prompt))
    speeds = [v for v in plan.variables if v.name.endswith("/speed")]
    top = motion_of(name).speed_mps
    assert speeds and all(v.initial <= v.upper < top for v in speeds)


def test_a_stated_speed_is_kept_even_beyond_its_kind() -> None:
    program = program_of(cast("A bulldozer drives at 8 m/s into a brick wall."))
    assert any(isinstance(p, HoldVelocity) and p.speed == pytest.approx(8.0) for p in program)


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("A van reverses into a trash can.", "van"),
        ("A truck backs into a bollard.", "truck"),
        ("A car reverses quickly and hits a mailbox.", "car"),
    ],
)
def test_what_reverses_does_so_at_the_pace_of_its_kind(prompt: str, kind: str) -> None:
    """The plan begins at it, and the search goes to no more than three times it."""
    plan = planned(cast(prompt))
    speed = next(v for v in plan.variables if v.name.endswith("/speed"))
    usual = pace_of(kind).reverses
    assert 0.5 * usual <= speed.initial <= 1.25 * usual
    assert speed.upper <= min(3.0 * usual, motion_of(kind).reverse_mps)


def test_a_stated_speed_backwards_is_kept() -> None:
    hold = program_of(cast("A van reverses at 6 m/s into a trash can."))[0]
    assert isinstance(hold, HoldVelocity)
    assert hold.speed == pytest.approx(6.0, rel=0.05)


def test_what_has_backed_into_a_wall_drives_forward_away_from_it() -> None:
    """It rolled on against it, or back by the bounce of the hit alone."""
    told = cast("A truck backs up and hits a mailbox, then drives forward and stops.")
    back, ahead = [p for p in program_of(told) if isinstance(p, HoldVelocity)][:2]
    assert math.cos(ahead.heading - back.heading) == pytest.approx(-1.0)
    assert ahead.start > 0.5
