"""Who has come to a halt on his feet stays on them until something touches him."""

from __future__ import annotations

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import cast
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.engines.program import HoldVelocity
from tests.dynamics.stage import lay_out


def test_a_halt_outlasts_the_steps_that_it_takes() -> None:
    doc = lay_out(cast(resolve(draft("A man walks across the road."))))
    plan = make_plan(doc, build_scene(doc), seed=0)
    program = plan.compile(plan.initial())
    holds = [p for p in program.primitives if isinstance(p, HoldVelocity)]
    last = max(holds, key=lambda p: p.start)
    assert last.acceleration < 0.0
    assert last.end > last.start - last.speed / last.acceleration + 3.0
