"""What is pushed over an edge and breaks below is pushed so softly that it does not break there."""

import pytest

from esg.dynamics import start_hints
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.layout import solve
from tests.dynamics.stories import cast


@pytest.mark.parametrize(
    ("prompt", "softly"),
    [
        ("A cat knocks a flower vase off a sideboard, and the vase shatters on the tiles.", True),
        ("A cat pushes a glass off a table and it shatters.", True),
        ("A ball rolls along a shelf and knocks a mug off it. The mug shatters.", True),
        ("A dog runs into a flower vase, which shatters.", False),
    ],
)
def test_what_is_to_fall_before_it_breaks_is_pushed_softly(prompt: str, softly: bool) -> None:
    doc = cast(prompt)
    doc = solve(doc, seed=0, hints=start_hints(doc, seed=0))
    plan = make_plan(doc, build_scene(doc), seed=0)
    (pushed,) = [b for b in plan.scene.bodies if b.break_impulse is not None]
    assert pushed.break_impulse is not None
    borne = pushed.break_impulse / pushed.mass
    (speed,) = [v for v in plan.variables if v.name.endswith("/speed")]
    assert (speed.upper <= 0.6 * borne + 1e-9) is softly
    assert speed.lower <= speed.initial <= speed.upper
