"""Bodies that change their posture, in the emitted class."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from helpers import both
import numpy as np
import pytest
import scenes

from esg.engines.breaking import hidden
from esg.engines.manifest import manifest_from_json, manifest_to_json
from esg.engines.program import ChangeBody, HoldVelocity, Program
from esg.engines.scene import FRAGMENT, SimScene


def _scene() -> tuple[SimScene, Program]:
    dog = replace(scenes.box("dog", (0.0, 0.0, 0.3), (0.4, 0.15, 0.3), 20.0), postures=("lying",))
    lying = scenes.box("lying", (0.05, 0.0, 0.12), (0.4, 0.16, 0.12), 20.0)
    bench = scenes.box("bench", (3.0, 0.0, 0.2), (0.5, 0.5, 0.2), 1.0, static=True)
    program = Program(
        (
            HoldVelocity("dog", 0.0, 0.5, 1.0, 0.0),
            ChangeBody("dog", 0.8, "lying"),
            ChangeBody("dog", 1.4, "dog"),
            ChangeBody("dog", 1.8, "lying", (3.0, 0.0, 0.7), 1.0),
        ),
        2.4,
    )
    return SimScene("lies", (dog, bench, replace(lying, category=FRAGMENT))), program


@pytest.mark.parametrize("engine", ["physx", "rapier"])
def test_class_and_program_change_alike(tmp_path: Path, engine: str) -> None:
    scene, program = _scene()
    replayed, rollout = both(tmp_path, scene, program, engine=engine)
    played = replayed.rollout
    gone = [hidden(scene, r.position[0], r.quaternion[0]) for r in (played, rollout)]
    assert np.abs(gone[0].astype(int) - gone[1].astype(int)).sum() <= 6
    assert np.abs(played.position - rollout.position).max() < 5e-3
    assert played.position[0, -1, 2] == pytest.approx([3.03, 0.04, 0.52], abs=0.02)
    assert sum("ChangeBody" in line for line in replayed.log) == 3
    assert not (played.contacts.a == 2).any() and not (played.contacts.b == 2).any()


def test_a_manifest_keeps_postures() -> None:
    scene, program = _scene()
    data = manifest_to_json(scene, program, dt=1 / 240)
    again = manifest_from_json(data)
    assert again.scene == scene and again.program == program
    assert "postures" in data["conventions"]


def test_the_change_is_in_the_usd_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from pxr import Usd
    from usd import player, usd_of

    scene, program = _scene()
    stage = Usd.Stage.Open(str(usd_of(tmp_path, scene, program)))
    read = player(monkeypatch).read_scene(stage)["program"]["primitives"]
    assert [p["into"] for p in read if p["kind"] == "ChangeBody"] == ["lying", "dog", "lying"]
    changes = [
        (
            [str(t) for t in prim.GetRelationship("esg:into").GetTargets()],
            prim.GetAttribute("esg:time").Get(),
            prim.GetAttribute("esg:position").Get() if prim.HasAttribute("esg:position") else None,
        )
        for prim in stage.GetPrimAtPath("/World/Program").GetChildren()
        if prim.GetAttribute("esg:kind").Get() == "ChangeBody"
    ]
    assert changes == [
        (["/World/Lying"], 0.8, None),
        (["/World/Dog"], 1.4, None),
        (["/World/Lying"], 1.8, (3.0, 0.0, 0.7)),
    ]
