"""What is drawn of gestures and plumes: parts in their states, and puffs behind what moves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.engines.scene import Body, ContactLog, Gesture, GivesOff, Rollout, Shape, SimScene
from esg.filming.plumes import MOST, puffs
from esg.layout import solve
from esg.view.parts import body_parts
from esg.view.pieces import Part
from esg.view.seeing.shows import with_shows

TIME = np.linspace(0.0, 4.0, 121)
TENSOR = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def _still(scene: SimScene) -> Rollout:
    shape = (1, len(TIME), len(scene.bodies))
    at = np.tile(np.array([b.position for b in scene.bodies], np.float32), (*shape[:2], 1, 1))
    turn = np.tile(np.array([b.quaternion for b in scene.bodies], np.float32), (*shape[:2], 1, 1))
    zero = np.zeros((*shape, 3), np.float32)
    return Rollout(
        "physx", 0.01, TIME, at, turn, zero, zero, ContactLog.empty(), np.ones(1, np.bool_)
    )


def _highest(parts: list[Part], time: float) -> float:
    seen = [p for p in parts if p.act is None or p.act.seen(np.array(time))]
    return max(float(p.vertices[:, 2].max()) for p in seen)


def test_a_raised_hand_is_over_the_head_from_its_time_on() -> None:
    from esg.dynamics.plan.build import build_scene

    doc = solve(resolve(draft("A man raises his hand.")))
    scene = build_scene(doc)
    man = scene.index("man_1")
    (gesture,) = scene.bodies[man].gestures
    assert gesture.rise_m > 0.8
    whole = body_parts(scene, doc)
    drawn = [p for p in with_shows(whole, scene, _still(scene), doc) if p.body == man]
    tall = _highest([p for p in whole if p.body == man], 0.0)
    assert _highest(drawn, 0.3) == pytest.approx(tall, abs=1e-6)
    assert _highest(drawn, 3.0) > tall + 0.25
    # No part is there twice.
    for time in (0.3, 0.8, 3.0):
        names = [p.name for p in drawn if p.act is None or p.act.seen(np.array(time))]
        assert len(names) == len(set(names))


def _car(**more: object) -> Body:
    return Body(
        "car_1", False, 1.0, TENSOR, (Shape("box", (2.0, 0.9, 0.7)),), (0.0, 0.0, 0.7),
        half_extents=(2.0, 0.9, 0.7), origin_offset=(0.0, 0.0, -0.7), **more,  # type: ignore[arg-type]
    )  # fmt: skip


def _puffs(name: str, speed: float, begins: str = "") -> list[tuple[float, tuple[float, ...]]]:
    at = np.stack([speed * TIME, 0.0 * TIME, np.full(len(TIME), 0.7)], axis=1)
    turn = np.tile([0.0, 0.0, 0.0, 1.0], (len(TIME), 1))
    gives = GivesOff(name, begins)
    found = puffs(gives, _car(gives_off=(gives,)), TIME, at, turn, {"hit": 2.0, "missed": None})
    return [(p.begins, p.at) for p in found]


def test_dust_stays_behind_what_moves() -> None:
    found = _puffs("dust", 5.0)
    assert 10 < len(found) <= MOST
    assert all(at[0] <= 5.0 * (begins + 0.1) - 1.9 for begins, at in found)
    assert not _puffs("dust", 0.0)


def test_smoke_begins_at_its_event_and_never_at_none() -> None:
    assert min(begins for begins, _ in _puffs("smoke", 0.0, "hit")) >= 2.0
    assert not _puffs("smoke", 0.0, "missed")
    assert min(begins for begins, _ in _puffs("smoke", 0.0)) == 0.0


def test_bodies_without_either_read_as_before() -> None:
    from esg.engines.manifest import manifest_from_json, manifest_to_json
    from esg.engines.program import Program

    scene = SimScene("s", (_car(),))
    told = manifest_to_json(scene, Program((), 1.0), dt=0.01)
    assert not {"gestures", "gives_off"} & {*told["bodies"][0]}
    made = (Gesture("waves", 0.9, 0, 0.3, 0.9, "hit"),)
    more = replace(scene, bodies=(_car(gestures=made, gives_off=(GivesOff("smoke"),)),))
    again = manifest_from_json(manifest_to_json(more, Program((), 1.0), dt=0.01)).scene.bodies[0]
    assert (again.gestures, again.gives_off) == (made, (GivesOff("smoke"),))
