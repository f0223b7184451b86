"""Every entry of the parametric library: geometry, proxies, surfaces and figures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from shapely.geometry import MultiPoint, Point

from esg.assets import build_mesh, catalogue
from esg.assets.geometry.mesh import configured_sketch
from esg.assets.library.catalogue import Entry, entries_by_name
from esg.assets.materials import MATERIALS
from esg.assets.stage import configure
from esg.graph.models import AssetConfiguration, ProxyKind
from esg.units import quat_rotate
from tests.assets.worlds import requirement

ENTRIES = [e for e in catalogue() if e.library == "parametric"]
NAMED = pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.name)

# Sourced independently of the catalogue: (length, width, height) [cm] in any order, mass [kg].
REFERENCE = {
    "soccer_ball": ((22, 22, 22), 0.43),
    "basketball": ((24, 24, 24), 0.62),
    "tennis_ball": ((6.7, 6.7, 6.7), 0.058),
    "golf_ball": ((4.3, 4.3, 4.3), 0.0459),
    "bowling_ball": ((21.6, 21.6, 21.6), 6.4),
    "bowling_pin": ((12.1, 12.1, 38.1), 1.55),
    "billiard_ball": ((5.7, 5.7, 5.7), 0.16),
    "car": ((460, 180, 146), 1450),
    "bus": ((1200, 255, 310), 11000),
    "bicycle": ((175, 60, 105), 14),
    "trash_bin": ((55, 55, 95), 15),
    "wheelie_bin": ((73, 58, 107), 13),
    "picnic_table": ((180, 150, 75), 55),
    "desk": ((140, 70, 74), 38),
    "chair": ((45, 48, 90), 5.5),
    "sofa": ((205, 90, 85), 60),
    "laptop": ((32, 30, 22), 1.7),
    "brick": ((21.5, 10.25, 6.5), 2.7),
    "pallet": ((120, 80, 14.4), 24),
    "traffic_cone": ((38, 38, 71), 3.2),
    "can": ((6.6, 6.6, 12), 0.36),
    "bottle": ((7.5, 7.5, 29), 0.8),
    "refrigerator": ((60, 66, 180), 70),
    "washing_machine": ((60, 60, 85), 68),
    "piano": ((150, 60, 125), 225),
    "suitcase": ((45, 28, 69), 4),
}


def proxy_points(config: AssetConfiguration) -> np.ndarray:
    """Extreme points of all proxies in the local frame [cm]."""
    out = []
    for p in config.proxies:
        a, b, c = p.size_cm
        if p.kind is ProxyKind.CONVEX:
            local = np.array(p.vertices_cm)
        elif p.kind is ProxyKind.BOX:
            local = np.array(
                [(x * a, y * b, z * c) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
            )
        elif p.kind is ProxyKind.CYLINDER:
            t = np.linspace(0, 2 * np.pi, 25)
            local = np.concatenate(
                [np.stack([a * np.cos(t), a * np.sin(t), np.full(25, z)], 1) for z in (-c, c)]
            )
        else:
            half = 0.0 if p.kind is ProxyKind.SPHERE else c
            d = np.random.default_rng(0).normal(size=(400, 3))
            d = np.concatenate(
                [d / np.linalg.norm(d, axis=1, keepdims=True), np.eye(3), -np.eye(3)]
            )
            local = a * d + np.array([0, 0, 1]) * half * np.sign(d[:, 2:])
        out.append(quat_rotate(p.orientation_xyzw, local) + p.position_cm)
    return np.concatenate(out)


@NAMED
def test_mesh_is_closed_and_of_the_stated_extents(entry: Entry) -> None:
    config = configure(entry.name, requirement(entry))
    for part in configured_sketch(entry, config).parts:
        mesh = part.mesh()
        assert mesh.is_watertight and mesh.volume > 0, part.name
    scene = build_mesh(config)
    extents = scene.bounds[1] - scene.bounds[0]
    np.testing.assert_allclose(extents, config.dimensions_cm, rtol=0.04, atol=0.1)
    assert abs(scene.bounds[0][2]) < 0.02 * config.dimensions_cm[2] + 0.05
    middle = scene.bounds.mean(0)[:2]
    assert np.abs(middle).max() < 0.04 * max(config.dimensions_cm[:2])


@NAMED
def test_proxies_touch_the_ground_and_stay_inside_the_extents(entry: Entry) -> None:
    config = configure(entry.name, requirement(entry))
    if "decal" in entry.flags:
        assert config.proxies == ()
        return
    points = proxy_points(config)
    half = np.array(config.dimensions_cm) / 2
    slack = 0.03 * max(config.dimensions_cm) + 0.2
    assert points[:, 2].min() == pytest.approx(0.0, abs=1e-6)
    assert (np.abs(points[:, :2]) <= half[:2] + slack).all()
    assert points[:, 2].max() <= config.dimensions_cm[2] + slack
    assert points[:, 2].max() >= 0.7 * config.dimensions_cm[2]


@NAMED
def test_centre_of_mass_lies_over_its_support(entry: Entry) -> None:
    config = configure(entry.name, requirement(entry))
    if "decal" in entry.flags or "rolls" in entry.flags or entry.builder in ("roller",):
        return
    points = proxy_points(config)
    base = MultiPoint(points[points[:, 2] < 1e-3][:, :2]).convex_hull
    com = config.center_of_mass_cm
    if entry.name == "pendulum_bob":
        assert com[:2] == pytest.approx((0, 0))
        return
    assert base.buffer(1e-6).contains(Point(com[0], com[1]))
    assert 0 < com[2] < config.dimensions_cm[2]


@NAMED
def test_surfaces_are_level_tops_of_the_proxies(entry: Entry) -> None:
    config = configure(entry.name, requirement(entry))
    if not config.proxies:
        assert all(s.center_cm[2] == 0 for s in config.support_surfaces)
        return
    tops = {round(float(z), 3) for z in proxy_points(config)[:, 2]}
    for surface in config.support_surfaces:
        assert round(surface.center_cm[2], 3) in tops, surface.name
        reach = np.abs(surface.center_cm[:2]) + surface.half_extents_cm
        assert (reach <= np.array(config.dimensions_cm[:2]) / 2 + 0.5).all(), surface.name
    names = [s.name for s in config.support_surfaces] + [r.name for r in config.regions]
    assert len(names) == len(set(names))


@NAMED
def test_inertia_is_physical(entry: Entry) -> None:
    config = configure(entry.name, requirement(entry))
    if not config.proxies:
        return
    xx, yy, zz, xy, xz, yz = config.inertia_kg_cm2
    moments = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    assert moments[0] > 0 and moments[0] + moments[1] >= moments[2] * (1 - 1e-9)


def test_there_are_more_than_eighty_kinds_and_every_material_is_known() -> None:
    assert len(ENTRIES) >= 80
    assert len({e.name for e in ENTRIES}) == len(ENTRIES)
    for entry in ENTRIES:
        assert entry.material in MATERIALS, entry.name
        assert entry.description


@pytest.mark.parametrize("name", sorted(REFERENCE))
def test_size_and_mass_agree_with_references(name: str) -> None:
    entry = entries_by_name()[name]
    size, mass = REFERENCE[name]
    assert 0.5 <= entry.mass_kg / mass <= 2.0
    np.testing.assert_allclose(sorted(entry.dimensions_cm), sorted(size), rtol=0.3)


def test_every_module_of_builders_is_loaded() -> None:
    """A module that is missing from the list would leave its kinds without a builder."""
    from esg.assets import builders

    folder = Path(str(builders.__file__)).parent
    registering = {
        ".".join((builders.__name__, *p.relative_to(folder).with_suffix("").parts))
        for p in folder.rglob("*.py")
        if "\n@builder(" in p.read_text("utf-8")
    }
    assert registering and registering <= set(builders.modules())
    builders.load_builders()
    assert {e.builder for e in ENTRIES} <= set(builders.BUILDERS)
