from __future__ import annotations

from dataclasses import replace
import json
import math
from pathlib import Path
import re

import golden
from helpers import both, written
import numpy as np
import pytest
import scenes

from esg.compile import WatchedEvent, compile_many, emit_class, replay_class
from esg.compile.build import Library, read_classes, shared_texts
from esg.engines.program import HoldVelocity, Program, SetVelocity
from esg.engines.scene import SimScene
from esg.outcomes import UserError

HOSTILE = (
    "class", "int", "None", "Ground", "3 balls", "ball A", "ball_a", "Ball-A", "漢字", "é*/ clair",
    '#include "/etc/passwd"', 'q"); system("x', "new\nline\r\n", "tab\t", "trigraph ??/",
    "%s %n %d", "back\\slash", "// comment", "TEXT(x)", "SceneOrigin", "this", "x" * 200,
    "a\x00b", "\u202eright",
)  # fmt: skip


@pytest.mark.parametrize("name", sorted(golden.files()))
def test_golden(name: str) -> None:
    assert (golden.FOLDER / name).read_text("utf-8") == golden.files()[name]


def test_the_docs_read_the_golden_class_aloud() -> None:
    """Every C++ excerpt in docs/unreal.md stands in the golden or shared files, `...` aside."""
    text = (Path(__file__).parents[2] / "docs" / "unreal.md").read_text("utf-8")
    excerpts = re.findall(r"```cpp\n(.*?)```", text, re.DOTALL)
    assert len(excerpts) >= 10
    emitted, shared = golden.emitted(), shared_texts()
    files = emitted.header, emitted.source, shared["EsgScene.h"], shared["EsgScene.cpp"]
    lines = [line.strip() for line in "\n".join(files).splitlines()]
    for excerpt in excerpts:
        at = 0
        for line in filter(None, map(str.strip, excerpt.splitlines())):
            if line != "...":
                assert line in lines[at:], line
                at = lines.index(line, at) + 1
        assert at > 0


def test_every_number_of_the_class_is_named() -> None:
    """Function bodies hold no bare numbers other than 0, 1, 2 and indices."""
    source = shared_texts()["EsgScene.cpp"]
    body = source[source.index("AEsgScene::AEsgScene()") :]
    body = re.sub(r'"(?:[^"\\]|\\.)*"|Commands\[\d+\]|Events\[\d+\]', "", body)
    numbers = {float(n) for n in re.findall(r"(?<![\w.])\d+(?:\.\d+)?(?![\w.])", body)}
    assert numbers <= {0.0, 1.0, 2.0}


def test_every_setting_is_editable_and_has_a_range_or_unit() -> None:
    header = shared_texts()["EsgScene.h"]
    numeric = re.findall(r"UPROPERTY\(([^\n]*)\)\n\t(?:float|double) (\w+) =", header)
    assert len(numeric) > 30
    for specifiers, name in numeric:
        assert "EditAnywhere" in specifiers, name
    without = [n for s, n in numeric if "Units" not in s and "Clamp" not in s]
    comments = {
        n: re.search(rf"/\*\* ([^\n]*) \*/\n\tUPROPERTY[^\n]*\n\t\w+ {n} =", header)
        for n in without
    }
    for name, found in comments.items():
        assert found and "[" in found.group(1), f"{name} states no unit"


def test_values_survive_the_way_through_the_text() -> None:
    """Poses and speeds read from the emitted text, mirrored back, equal the scene to 1e-6."""
    scene, program = scenes.street()
    source = golden.emitted().source

    def numbers(member: str) -> np.ndarray:
        found = re.search(rf"\t{re.escape(member)} = F\w+\(([^)]*)\);", source)
        assert found, member
        return np.array([float(v) for v in found.group(1).split(",")])

    from esg.units import quat_rotate

    for ident, body in zip(
        ("Car1", "TrashBin1", "Table1", "Wall1", "Lane1"), scene.bodies, strict=True
    ):
        at = numbers(f"{ident}Settings.Location") * [0.01, -0.01, 0.01]
        turn = numbers(f"{ident}Settings.Rotation") * [-1, 1, -1, 1]
        origin = np.array(body.position) + quat_rotate(body.quaternion, body.origin_offset)
        np.testing.assert_allclose(at, origin, atol=1e-6)
        np.testing.assert_allclose(turn, body.quaternion, atol=1e-6)
    launch = program.primitives[2]
    assert isinstance(launch, SetVelocity) and launch.angular is not None
    np.testing.assert_allclose(
        numbers("Table1Launch1.Velocity") * [0.01, -0.01, 0.01], launch.linear, atol=1e-6
    )
    np.testing.assert_allclose(
        np.radians(numbers("Table1Launch1.Spin")) * [-1, 1, -1], launch.angular, atol=1e-6
    )


def test_emission_is_deterministic() -> None:
    assert golden.files() == golden.files()


def test_bodies_with_equal_mesh_and_collision_share_an_asset() -> None:
    pins = tuple(
        scenes.cylinder(f"pin_{i}", (i * 0.3, 0.0, 0.2), 0.06, 0.2, 1.5, mesh="meshes/pin.glb")
        for i in range(10)
    )
    other = scenes.cylinder("odd", (0.0, 3.0, 0.2), 0.07, 0.2, 1.5, mesh="meshes/pin.glb")
    data = json.loads(emit_class(SimScene("p", (*pins, other)), Program((), 1.0)).imports_json)
    assert [a["path"] for a in data["assets"]] == [
        "/Game/ESG/P/SM_Pin.SM_Pin",
        "/Game/ESG/P/SM_Pin__2.SM_Pin__2",
    ]


@pytest.mark.parametrize(
    "mesh", ["../x.glb", "/etc/passwd", "a/../../b.glb", "C:/x.glb", "..\\x.glb"]
)
def test_mesh_paths_cannot_leave_the_folder(mesh: str) -> None:
    body = scenes.box("a", (0.0, 0.0, 1.0), (1.0, 1.0, 1.0), 1.0, mesh=mesh)
    with pytest.raises(UserError, match="leaves the scene folder"):
        emit_class(SimScene("x", (body,)), Program((), 1.0))


def test_unknown_names_are_refused() -> None:
    scene, _ = scenes.street()
    with pytest.raises(ValueError, match="unknown body 'ghost'"):
        emit_class(scene, Program((SetVelocity("ghost", 0.0, (1.0, 0.0, 0.0)),), 1.0))
    with pytest.raises(ValueError, match="unknown body 'ghost'"):
        emit_class(scene, Program((), 1.0), watch=(WatchedEvent("e", ("ghost",), ("car_1",)),))
    with pytest.raises(ValueError, match="unknown events"):
        emit_class(
            scene, Program((), 1.0), watch=(WatchedEvent("e", ("car_1",), ("table_1",), ("x",)),)
        )


@pytest.mark.parametrize("where", ["position", "mass", "speed"])
def test_values_that_are_no_numbers_are_refused(where: str) -> None:
    body = scenes.box("a", (0.0, 0.0, 1.0), (1.0, 1.0, 1.0), 1.0)
    program = Program((SetVelocity("a", 0.0, (1.0, 0.0, 0.0)),), 1.0)
    if where == "position":
        body = replace(body, position=(math.nan, 0.0, 0.0))
    elif where == "mass":
        body = replace(body, mass=math.inf)
    else:
        program = Program((SetVelocity("a", 0.0, (math.nan, 0.0, 0.0)),), 1.0)
    with pytest.raises(ValueError, match="cannot emit"):
        emit_class(SimScene("x", (body,)), program)


def hostile_scene(names: tuple[str, ...]) -> tuple[SimScene, Program, tuple[WatchedEvent, ...]]:
    bodies = tuple(
        scenes.ball(n, (0.5 * (i % 15), 0.5 * (i // 15), 0.1), 0.1, 1.0, label=n, description=n)
        for i, n in enumerate(names)
    )
    program = Program(
        (
            *(SetVelocity(n, 0.01 * i, (0.1, 0.0, 0.0)) for i, n in enumerate(names)),
            HoldVelocity(names[0], 0.0, math.inf, 1.0, 0.0, until_contact=(names[1],)),
        ),
        0.2,
    )
    watch = tuple(
        WatchedEvent(n, (n,), (names[i + 1],), names[:i][-1:]) for i, n in enumerate(names[:-1])
    )
    return SimScene(names[0] + '*/"\n', bodies), program, watch


def test_hostile_names_compile_run_and_come_back(tmp_path: Path) -> None:
    scene, program, watch = hostile_scene(HOSTILE)
    written(tmp_path, scene, program, watch)
    replayed = replay_class(tmp_path)
    assert tuple(b.name for b in replayed.scene.bodies) == HOSTILE
    text = "".join(p.read_text("utf-8") for p in (tmp_path / "unreal").glob("EsgScene_*"))
    assert text.isascii()
    code = re.sub(r'"(?:[^"\\\n]|\\.)*"', "", text)
    assert "system" not in code and "passwd" not in code and "漢" not in code


@pytest.mark.parametrize(
    "scene_id", ["class", "7", "../../x", 'a"; }', "漢字", "a\nb", "con", "S 1"]
)
def test_scene_ids_become_class_names(tmp_path: Path, scene_id: str) -> None:
    body = scenes.ball("a", (0.0, 0.0, 0.1), 0.1, 1.0)
    emitted = emit_class(SimScene(scene_id, (body,)), Program((), 0.1))
    assert re.fullmatch(r"EsgScene_[A-Za-z][A-Za-z0-9_]*", emitted.name)
    folder = written(tmp_path, SimScene(scene_id, (body,)), Program((), 0.1))
    assert isinstance(compile_many(read_classes([folder]))[0], Library)


def test_two_hundred_objects(tmp_path: Path) -> None:
    names = tuple(f"ball {i}" for i in range(200))
    scene, program, watch = hostile_scene(names)
    replayed, rollout = both(tmp_path, scene, program, watch)
    assert replayed.rollout.position.shape[2] == 200
    assert np.abs(replayed.rollout.position - rollout.position).max() < 1e-3


def test_empty_scene_and_program(tmp_path: Path) -> None:
    written(tmp_path, SimScene("empty", ()), Program((), 0.1))
    assert replay_class(tmp_path).rollout.position.shape == (1, 25, 0, 3)
