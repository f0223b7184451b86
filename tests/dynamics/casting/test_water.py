"""Water is flat: what rolls or falls into it comes to lie over it."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics.casting import fitted


@pytest.mark.parametrize(
    ("prompt", "thing", "share"),
    [
        ("A ball rolls into the pond.", "ball_1", None),
        ("A car drives off the quay and falls into the water.", "car_1", 0.65),
    ],
)
def test_the_region_over_water_is_low_for_what_falls(
    prompt: str, thing: str, share: float | None
) -> None:
    doc = fitted(resolve(draft(prompt)))
    nodes = doc.spatial_relation_graph.nodes
    water = next(n for n in nodes if n.startswith(("pond", "water")))
    config = doc.asset_configurations[nodes[water].asset_id]
    assert not config.proxies
    (inside,) = (r for r in config.regions if r.name == "inside")
    body = doc.asset_configurations[nodes[thing].asset_id]
    expected = 100.0 if share is None else share * body.dimensions_cm[2]
    assert 2.0 * inside.half_extents_cm[2] == pytest.approx(expected)
    assert inside.half_extents_cm[0] == pytest.approx(0.5 * config.dimensions_cm[0])
