"""The judge on how things lie: by the axis of the model that points up."""

from __future__ import annotations

import pytest

from esg.engines import get_engine
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.scene import Body, Shape, SimScene
from esg.metrics import judge
from esg.metrics.models import SuiteScene, SuiteStatement
from esg.units import quat_from_euler_deg

TENSOR = ((0.02, 0.0, 0.0), (0.0, 0.02, 0.0), (0.0, 0.0, 0.02))
ROLLED = (0.7071067811865476, 0.0, 0.0, 0.7071067811865476)


def _judged(
    told: str,
    when: str,
    *,
    turned: tuple[float, float, float, float] | None = None,
    roll: float = 0.0,
    pushed: float = 0.0,
) -> tuple[bool | None, str]:
    """A carton drawn 10 x 10 x 30 cm; turned, or rolled about its front, or pushed over."""
    down = turned is not None
    half = (0.05, 0.15, 0.05) if down else (0.05, 0.05, 0.15)
    high = half[2] if roll in (0.0, 180.0) else half[1]
    body = Body(
        "carton_1", False, 1.0, TENSOR, (Shape("box", half),), (0.0, 0.0, high),
        quaternion=tuple(quat_from_euler_deg(0.0, 0.0, roll)),  # type: ignore[arg-type]
        half_extents=half, category="carton", label="carton", turned=turned,
    )  # fmt: skip
    scene = SimScene("s", (body,))
    push = (SetVelocity("carton_1", 0.5, (0.0, pushed, 0.0), (-pushed / 0.15, 0.0, 0.0)),)
    program = Program(push if pushed else (), 3.0)
    out = get_engine("physx").rollout(
        scene, batch_programs([program], scene.names), dt=1 / 240, ground_contacts=True
    )
    told_of = SuiteStatement(id="s1", says="lies", object="=carton_1", noun=told, when=when)  # type: ignore[arg-type]
    suite = SuiteScene(id="s", prompt="A carton.", level="single", statements=(told_of,))
    (statement,) = judge(scene, program, out, suite).statements
    return statement.kept, statement.reason or ""


@pytest.mark.parametrize(
    ("told", "how", "kept"),
    [
        ("on its side", {"turned": ROLLED}, True),
        ("on its side", {"roll": 90.0}, True),
        ("on its side", {}, False),
        ("upside down", {"roll": 180.0}, True),
        ("upside down", {"turned": ROLLED}, False),
        ("upright", {}, True),
        ("upright", {"turned": ROLLED}, False),
    ],
)
def test_an_axis_points_up(told: str, how: dict[str, float], kept: bool) -> None:
    assert _judged(told, "throughout", **how)[0] is kept  # type: ignore[arg-type]


def test_what_is_knocked_over_ends_on_its_side() -> None:
    assert _judged("on its side", "end", pushed=1.6)[0] is True
    assert _judged("on its side", "start", pushed=1.6)[0] is False
    kept, reason = _judged("upside down", "end", pushed=1.6)
    assert not kept and "degrees off lying upside down" in reason
