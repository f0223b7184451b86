"""The judge on what wobbles: leans to one side, the other and back, and does not fall."""

from __future__ import annotations

import pytest

from esg.assets.library.catalogue import entries_by_name
from esg.assets.stage import configure
from esg.dynamics.plan.build import make_body
from esg.engines import get_engine
from esg.engines.program import Program, batch_programs
from esg.engines.scene import SimScene
from esg.graph.models import Node, Pose
from esg.lexicon.lying import TIPPED_UP
from esg.metrics import judge
from esg.metrics.models import SuiteScene, SuiteStatement
from tests.assets.worlds import EMPTY, requirement

SLENDER = ("vase", "bottle", "refrigerator")


def _judged(name: str, engine: str, lies: str | None) -> tuple[bool | None, dict[str, float], str]:
    wanted = requirement(entries_by_name()[name]).model_copy(update={"lies": lies})
    at = Pose(position_cm=(0.0, 0.0, 0.01))
    config = configure(name, wanted)
    body = make_body(EMPTY, f"{name}_1", Node(asset_id=name), config, at, active=False)
    scene, program = SimScene("s", (body,)), Program((), 3.0)
    out = get_engine(engine).rollout(
        scene, batch_programs([program], scene.names), dt=1 / 240, ground_contacts=True
    )
    told = SuiteStatement(id="s1", says="wobbles", object=f"={name}_1", when="throughout")  # type: ignore[arg-type]
    suite = SuiteScene(id="s", prompt="It wobbles.", level="single", statements=(told,))
    (statement,) = judge(scene, program, out, suite).statements
    return statement.kept, statement.measured, statement.reason or ""


@pytest.mark.parametrize("engine", ["physx", "rapier", "newton"])
@pytest.mark.parametrize("name", SLENDER)
def test_what_is_let_go_on_the_edge_of_its_foot_wobbles(name: str, engine: str) -> None:
    kept, measured, reason = _judged(name, engine, TIPPED_UP)
    assert kept, (measured, reason)
    assert 2.0 < measured["lean_deg"] < 13.0


def test_what_stands_does_not_wobble() -> None:
    kept, _, reason = _judged("vase", "physx", None)
    assert not kept and "0 sides" in reason


def test_what_is_squat_is_not_tipped_up() -> None:
    for name in ("plate", "bowl", "crate"):
        wanted = requirement(entries_by_name()[name]).model_copy(update={"lies": TIPPED_UP})
        assert configure(name, wanted).lying is None


def test_what_falls_over_does_not_wobble() -> None:
    kept, _, reason = _judged("vase", "physx", "on its side")
    assert not kept and reason == "falls over"
