"""The judge on postures: by the height of the body that is there, and that it rests on something."""

from __future__ import annotations

from dataclasses import replace

import pytest

from esg.engines import get_engine
from esg.engines.program import ChangeBody, Program, batch_programs
from esg.engines.scene import FRAGMENT, Body, Shape, SimScene
from esg.metrics import judge
from esg.metrics.models import SuiteScene, SuiteStatement
from esg.metrics.plausibility import Told, assess

TENSOR = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def _man(name: str, size: tuple[float, float, float], postures: tuple[str, ...] = ()) -> Body:
    half = tuple(0.5 * v for v in size)
    return Body(
        name, False, 70.0, TENSOR, (Shape("box", half),), (0.0, 0.0, half[2]),  # type: ignore[arg-type]
        half_extents=half, postures=postures,  # type: ignore[arg-type]
        category="person" if postures else FRAGMENT, label="man" if postures else "",
    )  # fmt: skip


def _judged(height: float, told: str, when: str, lift: float = 0.0) -> tuple[bool | None, str]:
    """A man who stands for a second, then is of a height until the end."""
    low = _man("man_1_low", (0.4, 0.5, height))
    low = replace(low, position=(0.0, 0.0, 0.5 * height + lift))
    scene = SimScene("s", (_man("man_1", (0.3, 0.5, 1.72), ("man_1_low",)), low))
    program = Program((ChangeBody("man_1", 1.0, "man_1_low"),), 1.2 if lift else 3.0)
    out = get_engine("physx").rollout(
        scene, batch_programs([program], scene.names), dt=1 / 240, ground_contacts=True
    )
    told_of = SuiteStatement(id="s1", says="posture", object="=man_1", noun=told, when=when)  # type: ignore[arg-type]
    suite = SuiteScene(id="s", prompt="A man.", level="single", statements=(told_of,))
    verdict = judge(scene, program, out, suite)
    if not lift:
        found = assess(scene, program, out, Told(movers=frozenset({"man_1"})))
        assert [c.name for c in found.checks if not c.ok] == []
    (statement,) = verdict.statements
    return statement.kept, statement.reason or ""


@pytest.mark.parametrize(
    ("height", "told", "when", "kept"),
    [
        (0.3, "lies", "end", True),
        (0.3, "lies", "start", False),
        (0.3, "stands", "start", True),
        (0.3, "stands", "end", False),
        (0.3, "sits", "end", False),
        (0.95, "sits", "end", True),
        (0.95, "sits", "start..end", True),
        (1.3, "kneels", "end", True),
        (1.3, "lies", "end", False),
    ],
)
def test_a_posture_is_a_height(height: float, told: str, when: str, kept: bool) -> None:
    assert _judged(height, told, when)[0] is kept


def test_nobody_sits_in_the_air() -> None:
    kept, reason = _judged(0.95, "sits", "end", lift=0.5)
    assert not kept
    assert "on something" in reason
