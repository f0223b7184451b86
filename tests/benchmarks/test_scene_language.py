"""Scene Language's adapter on programs written for these tests, which no model wrote."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from benchmarks.rivals.scene_language.__main__ import report
from benchmarks.rivals.scene_language.adapter import (
    ProgramFailed,
    launches,
    parts_of,
    run_program,
    scene_of,
)
from benchmarks.rivals.scene_language.answers import program_of
from benchmarks.rivals.scene_language.requests import messages, requests
from esg.engines.program import SetVelocity
from esg.judging.bodies import DENSITY_KG_M3
from esg.metrics import load_suite
from esg.metrics.geometry import body_cores, lowest_point

BALLS = """
from helper import *

@register("one ball")
def ball(color) -> Shape:
    return primitive_call('sphere', shape_kwargs={'radius': 0.1}, color=color)

@register()
def ground() -> Shape:
    return primitive_call('cube', shape_kwargs={'scale': (10, 0.1, 10)})

@register()
def ball_a() -> Shape:
    return library_call('ball', color=(1, 0, 0))

@register()
def ball_b() -> Shape:
    return library_call('ball', color=(0, 1, 0))

@register_animation()
def three_balls() -> Generator[Shape, None, None]:
    for frame in range(4):
        a = transform_shape(library_call('ball_a'), translation_matrix([0, 1.1, -0.3 * frame]))
        b = transform_shape(library_call('ball_b'), translation_matrix([0, 1.1, -2.0]))
        floor = transform_shape(library_call('ground'), translation_matrix([0, 0.95, 0]))
        yield concat_shapes(a, b, floor)
"""
MANY = """
from helper import *

@register()
def pin() -> Shape:
    return primitive_call('cylinder', shape_kwargs={'radius': 0.05, 'p0': (0, 0, 0), 'p1': (0, 0.4, 0)})

@register()
def bowling_pins() -> Shape:
    return loop(3, lambda i: transform_shape(library_call('pin'), translation_matrix((0.3 * i, 0, 0))))

@register()
def table() -> Shape:
    top = primitive_call('cube', shape_kwargs={'scale': (1, 0.1, 1)})
    legs = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.1, 0.8, 0.1)}), translation_matrix((0.8 * i - 0.4, -0.45, 0))))
    return concat_shapes(top, legs)

@register()
def whole() -> Shape:
    return concat_shapes(library_call('bowling_pins'), transform_shape(library_call('table'), translation_matrix((5, 0.85, 0))))
"""


def test_the_trail_and_the_axes_are_the_paper_s() -> None:
    answer = run_program(BALLS)
    scene, program = scene_of(answer, "S7-0")
    assert scene.names == ("ball_a_1", "ball_b_1")  # the floor is the ground
    a, b = scene.bodies
    assert a.position == pytest.approx((0.0, 0.0, 0.1))
    # Unreal's (X, Y, Z) = (-z, x, y), with Y mirrored: 2 m along -z lies 2 m along +X.
    assert b.position == pytest.approx((2.0, 0.0, 0.1))
    (launch,) = program.primitives
    assert isinstance(launch, SetVelocity) and launch.body == "ball_a_1"
    assert launch.linear == pytest.approx((5.0, 0.0, 0.0))
    assert launch.angular == (0.0, 0.0, 0.0)
    assert a.mass == pytest.approx(DENSITY_KG_M3 * 4 / 3 * np.pi * 0.001)
    assert (a.color, a.label, b.active) == ((1.0, 0.0, 0.0), "ball a", False)


def test_calls_whose_pieces_lie_apart_are_several_bodies() -> None:
    answer = run_program(MANY)
    names = [part.name for part in parts_of(answer["frames"][0], answer["docs"])]
    assert names == ["pin_1", "pin_2", "pin_3", "table_1"]
    scene, program = scene_of(answer, "S1-0")
    assert len(scene.body("table_1").shapes) == 3 and not program.primitives
    heights = [
        lowest_point(body_cores(b), np.array(b.position), np.array(b.quaternion))
        for b in scene.bodies
    ]
    assert min(heights) == pytest.approx(0.0, abs=1e-9)


def test_what_sets_out_after_the_first_frame_is_not_launched() -> None:
    answer = run_program(BALLS.replace("[0, 1.1, -2.0]", "[0, 1.1, -2.0 - max(0, frame - 2)]"))
    frames = [parts_of(frame, answer["docs"]) for frame in answer["frames"]]
    assert list(launches(frames)) == ["ball_a_1"]


@pytest.mark.parametrize(
    ("program", "message"),
    [
        ("raise ValueError('no')", "ValueError: no"),
        ("from helper import *\n@register()\ndef a():\n    return []", "draws nothing"),
        ("open('/etc/passwd').read()", "Error"),
        ("import socket; socket.create_connection(('127.0.0.1', 80))", "Error"),
        ("import os; os.fork()", "Error"),
        ("x = [0] * 10**12", "MemoryError"),
    ],
)
def test_a_program_may_only_compute(program: str, message: str) -> None:
    with pytest.raises(ProgramFailed, match=message):
        run_program(program)


def test_programs_are_judged_as_our_own_scenes_are(tmp_path: Path) -> None:
    suite = load_suite("paper")
    suite = suite.model_copy(update={"scenes": tuple(s for s in suite.scenes if s.id == "S7")})
    (tmp_path / "S7-0.py").write_text(BALLS)
    (tmp_path / "S7-1.py").write_text("1 / 0")
    made, lines = report(suite, tmp_path, 3)
    # A hits B; there is no C, so that the layout fails and the second event cannot be.
    assert made["scenes"][0]["completed"] == [1, 0, 0]
    assert made["totals"]["slr"] == 0.0
    assert [line.split(":")[0] for line in lines] == ["S7-0", "S7-1", "S7-2"]
    assert "ZeroDivisionError" in lines[1] and "no program" in lines[2]


def test_requests_say_what_scene_language_says() -> None:
    rows = requests("paper", 5)
    assert len(rows) == 50 and rows[0]["custom_id"] == "S1-0" and rows[-1]["custom_id"] == "S10-4"
    system, user = messages("A car stops.")
    assert "You are a code completion model" in system["content"]
    assert "primitive_call(name: Literal['cube', 'sphere', 'cylinder']" in system["content"]
    assert (
        "def pacman_chase_animation" in user["content"]
        and '"""\nA car stops.\n"""' in user["content"]
    )
    assert "__main__" not in user["content"]
    assert json.dumps(rows)


def test_the_first_block_of_python_is_the_program() -> None:
    assert program_of("Sure:\n```python\nx = 1\n```\nand\n```python\ny\n```") == "x = 1\n"
    assert program_of("no code") is None
