"""Opening, closing and swinging are detected as the judge detects them."""

import math

import numpy as np
import pytest

from esg.dynamics.losses.joints import closed, opened, swung
from esg.dynamics.losses.recording import Recording
from esg.engines.joints import joint_between
from esg.engines.scene import Body, ContactLog, Rollout, Shape, SimScene
from esg.graph.models import TimelineNode
from esg.units import quat_from_euler_deg

UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
LEAF = Body("leaf", False, 20.0, UNIT, (Shape("box", (0.4, 0.02, 1.0)),), (0.4, 0.0, 1.0))
HINGE = joint_between("h", "hinge", LEAF, None, at=(0.0, 0.0, 1.0), axis=(0.0, 0.0, 1.0))
T = np.linspace(0.0, 3.0, 361)


class NoStory:
    def expand(self, name):
        return (name,)


def recorded(yaw_deg: np.ndarray, height: np.ndarray | None = None) -> Recording:
    yaw = np.radians(yaw_deg)
    z = np.full(len(T), 1.0) if height is None else height
    position = np.stack([0.4 * np.cos(yaw), 0.4 * np.sin(yaw), z], axis=1)[None, :, None]
    quaternion = np.array([quat_from_euler_deg(d) for d in yaw_deg])[None, :, None]
    velocity = np.gradient(position, T, axis=1)
    rollout = Rollout(
        "test", float(T[1]), T, position, quaternion, velocity, np.zeros_like(velocity),
        ContactLog.empty(), np.array([True]),
    )  # fmt: skip
    return Recording(SimScene("s", (LEAF,), joints=(HINGE,)), NoStory(), rollout, [{}])  # type: ignore[arg-type]


def event(kind: str, **more) -> TimelineNode:
    return TimelineNode(id="e", event=kind, participants=("leaf",), window=(0.0, 9.0), **more)


def found(measure, rec: Recording, node: TimelineNode) -> tuple[float, float]:
    result = measure(rec, node, np.zeros(1), lambda name, value: None)
    return float(result.time[0]), float(result.far[0])


def test_opening_counts_from_closed_and_a_nearer_miss_costs_less():
    assert found(opened, recorded(30.0 * T), event("Open"))[0] == pytest.approx(1.0, abs=0.01)
    assert found(opened, recorded(-30.0 * T), event("Open"))[0] == pytest.approx(1.0, abs=0.01)
    further = recorded(40.0 + 30.0 * T)
    assert found(opened, further, event("Open"))[0] == pytest.approx(1.0, abs=0.01)
    misses = [found(opened, recorded(rate * T), event("Open")) for rate in (8.0, 4.0)]
    assert all(math.isinf(time) for time, _ in misses)
    assert misses[0][1] < misses[1][1]


def test_closing_counts_when_it_rests_closed():
    shut = recorded(np.maximum(60.0 - 60.0 * T, 0.0))
    assert found(closed, shut, event("Close"))[0] == pytest.approx(1.0, abs=0.02)
    assert math.isinf(found(closed, recorded(60.0 - 10.0 * T), event("Close"))[0])


@pytest.mark.parametrize(("times", "happens"), [(1, True), (5, True), (7, False)])
def test_swings_count_passes_of_the_lowest_point(times, happens):
    angle = 0.5 * np.cos(2.0 * math.pi * T)
    rec = recorded(np.zeros(len(T)), height=3.0 - 2.0 * np.cos(angle))
    assert math.isfinite(found(swung, rec, event("Swing", times=times))[0]) is happens
