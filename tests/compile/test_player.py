"""The class that all scenes are played with, and the form of a class that brings it."""

from __future__ import annotations

import math
from pathlib import Path
import re

import golden
from helpers import vouched, written
import numpy as np
import pytest
import scenes

from esg.compile import joints, replay_class
from esg.compile.build import read_classes, shared_texts
from esg.compile.lint import lint
from esg.compile.unreal.selfcontained import is_self_contained, self_contained
from esg.engines import joint_rules, traction, wheels
from esg.engines.program import GUIDE_RATE

CONSTANTS = {
    "GuideRate": GUIDE_RATE,
    "FallingShare": traction.FALLING,
    "UprightCosine": traction.ON_WHEELS,
    "Blow": 100.0 * traction.BLOW_MPS,
    "LeastTilt": traction.LEAST_TILT,
    "LeastLean": math.degrees(traction.LEAST_LEAN_RAD_S),
    "Upright": wheels.UPRIGHT,
    "Falls": wheels.FALLS,
    "RunsDown": wheels.RUNS_DOWN_S,
    "FarTurn": joints.FAR_TURN_DEG,
    "FarSlide": 100.0 * joints.FAR_SLIDE_M,
    "RigidDrive": joints.RIGID_DRIVE,
    "Unlimited": joints.UNLIMITED,
    "ApproachRate": joint_rules.APPROACH_RATE,
    "BreakWindow": joint_rules.BREAK_WINDOW_S,
}


@pytest.mark.parametrize("name", CONSTANTS)
def test_the_class_goes_by_the_rules_of_the_program(name: str) -> None:
    """The C++ states them to the 15 digits of every emitted number."""
    found = re.search(rf"constexpr \w+ {name} = ([^;f]+)f?;", shared_texts()["EsgScene.cpp"])
    assert found
    assert float(found.group(1)) == pytest.approx(CONSTANTS[name], rel=1e-14)


def test_what_plays_scenes_follows_the_rules_of_classes() -> None:
    texts = shared_texts()
    assert lint(texts["EsgScene.h"], texts["EsgScene.cpp"], "EsgScene") == []


def test_a_class_states_values_program_and_events_and_nothing_else() -> None:
    emitted = golden.emitted()
    functions = re.findall(rf"A{emitted.name}::(\w+)\(", emitted.source)
    assert functions == [f"A{emitted.name}", "CollectBodies", "CollectProgram", "DispatchProgram"]


def test_a_self_contained_class_does_the_same_bit_by_bit(tmp_path: Path) -> None:
    """It is one pair of files that names nothing of the shared class."""
    folder = written(tmp_path, *scenes.street(), scenes.STREET_WATCH)
    shared = replay_class(folder)
    (files,) = read_classes([folder])
    whole = self_contained(files)
    assert is_self_contained(whole) and not is_self_contained(files)
    assert self_contained(whole) == whole
    assert lint(whole.header, whole.source, whole.name) == []
    for text in (whole.header, whole.source):
        assert not re.search(r"\b(?:[AF]|Log)?Esg(?!Scene_S6)", text)
    (folder / "unreal" / f"{files.name}.h").write_text(whole.header)
    (folder / "unreal" / f"{files.name}.cpp").write_text(whole.source)
    alone = replay_class(vouched(folder))
    assert alone.log == shared.log
    np.testing.assert_array_equal(alone.rollout.position, shared.rollout.position)
    np.testing.assert_array_equal(alone.rollout.contacts.time, shared.rollout.contacts.time)
