"""The judge on what breaks: found in its fragments, which no phrase means and no check faults."""

from dataclasses import replace

import pytest

from esg.engines import get_engine
from esg.engines.breaking.pieces import broken
from esg.engines.program import Program, batch_programs
from esg.engines.scene import Body, Shape, SimScene
from esg.metrics import judge
from esg.metrics.models import SuiteEvent, SuiteScene
from esg.metrics.plausibility import Told, assess

TURNED = (0.2588190451025207, 0.0, 0.0, 0.9659258262890683)
TENSOR = ((0.01, 0.0, 0.0), (0.0, 0.01, 0.0), (0.0, 0.0, 0.005))
VASE = Body(
    "vase_1", False, 1.5, TENSOR, (Shape("box", (0.08, 0.08, 0.16)),), (0.0, 0.0, 1.2), TURNED,
    half_extents=(0.08, 0.08, 0.16), category="vase", label="vase", restitution=0.1,
)  # fmt: skip
SUITE = SuiteScene(
    id="s",
    prompt="A vase breaks.",
    level="single",
    events=(SuiteEvent(id="e1", type="breaks", object="vase"),),
)


def told_of(bears: float) -> tuple[SimScene, Program, object]:
    whole, pieces = broken(replace(VASE, break_impulse=bears), 10)
    scene, program = SimScene("s", (whole, *pieces)), Program((), 2.0)
    out = get_engine("physx").rollout(scene, batch_programs([program], scene.names), dt=1 / 240)
    return scene, program, out


@pytest.mark.parametrize(("bears", "breaks"), [(2.0, True), (60.0, False)])
def test_a_vase_breaks_at_a_blow_that_it_cannot_take(bears: float, breaks: bool) -> None:
    scene, program, out = told_of(bears)
    verdict = judge(scene, program, out, SUITE)
    assert verdict.bindings["vase"] == ("vase_1",)
    (event,) = verdict.events
    assert event.completed is breaks
    if breaks:
        assert 0.4 < event.time_s < 1.0
        assert event.measured["pieces"] >= 3.0
    else:
        assert event.reason == "stays whole: no blow exceeds 60 N s"


def test_a_break_is_plausible_and_fragments_do_not_overlap_what_they_are_of() -> None:
    scene, program, out = told_of(2.0)
    found = assess(scene, program, out, Told(movers=frozenset({"vase_1"})))
    assert [c.name for c in found.checks if not c.ok] == []
    verdict = judge(scene, program, out, SUITE)
    assert verdict.layout.overlaps == ()
    # As bodies like any other they would start in each other.
    apart = scene.with_bodies(
        tuple(replace(b, fragments=(), break_impulse=None) for b in scene.bodies)
    )
    assert judge(apart, program, out, SUITE).layout.overlaps != ()
