"""Whatever size is asked for, a kind keeps being a body: finite, solid, drawn at that size."""

from __future__ import annotations

import numpy as np
import pytest

from esg.assets import build_mesh, catalogue
from esg.assets.geometry.mesh import configured_sketch
from esg.assets.library.catalogue import Entry, entries_by_name
from esg.assets.stage import configure
from esg.graph.models import ProxyKind
from tests.assets.worlds import requirement

SIZES = [
    (1, 1, 1),
    (40, 40, 40),
    (1e4, 1e4, 1e4),
    (1, 1, 1e4),
    (1e4, 1, 1),
    (1, 1e4, 1),
    (1e4, 1e4, 1),
    (1, 1e4, 1e4),
    (300, 5, 40),
    (7, 90, 20),
]


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("entry", catalogue(), ids=lambda e: e.name)
def test_no_size_breaks_a_kind(entry: Entry) -> None:
    for size in SIZES:
        for prescribed in (True, False):
            asked = requirement(
                entry, expected_dimensions_cm=size, dimensions_are_prescribed=prescribed
            )
            config = configure(entry.name, asked)
            where = f"{size} prescribed={prescribed}"
            assert min(config.dimensions_cm) > 0, where
            for proxy in config.proxies:
                assert min(proxy.size_cm) > 0 or proxy.kind is ProxyKind.CONVEX, where
            for part in (*config.support_surfaces, *config.regions):
                assert min(part.half_extents_cm) > 0, where
            if not config.proxies:
                continue
            assert np.isfinite(config.center_of_mass_cm).all(), where
            xx, yy, zz, xy, xz, yz = config.inertia_kg_cm2
            moments = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
            assert moments[0] > 0, where
            assert moments[0] + moments[1] >= moments[2] * (1 - 1e-6), where


@pytest.mark.parametrize("name", ["house", "net", "door", "goal", "shelf", "bathtub", "tray"])
@pytest.mark.parametrize("size", [(1, 1, 1), (40, 40, 40), (7, 90, 20)])
def test_odd_sizes_are_drawn_closed_and_at_that_size(name: str, size: tuple[float, ...]) -> None:
    entry = entries_by_name()[name]
    asked = requirement(entry, expected_dimensions_cm=size, dimensions_are_prescribed=True)
    config = configure(name, asked)
    assert all(part.mesh().is_watertight for part in configured_sketch(entry, config).parts)
    scene = build_mesh(config)
    extents = scene.bounds[1] - scene.bounds[0]
    np.testing.assert_allclose(extents, config.dimensions_cm, rtol=0.15, atol=0.3)
