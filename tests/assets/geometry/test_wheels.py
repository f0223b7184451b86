"""Wheels of the library: named by where they are, apart in the mesh, about their axles."""

from __future__ import annotations

import io

import numpy as np
import pytest
import trimesh

from esg.assets.geometry.mesh import glb_bytes
from esg.assets.geometry.sketch import Axle
from esg.assets.geometry.wheels import wheel_names
from esg.assets.library.catalogue import catalogue, entries_by_name
from esg.assets.stage import configure
from tests.assets.worlds import requirement

LEGLESS = frozenset({"snowmobile"})
"""Flagged as coasting, and without a wheel."""


def named(name: str, **more: object) -> dict[str, tuple[tuple[float, float, float], float]]:
    config = configure(name, requirement(entries_by_name()[name], **more))
    return {w.name: (w.axle_cm, w.radius_cm) for w in config.wheels or ()}


@pytest.mark.parametrize("name", [e.name for e in catalogue() if "wheeled" in e.flags])
def test_what_goes_on_wheels_names_them(name: str) -> None:
    wheels = named(name)
    assert bool(wheels) != (name in LEGLESS)
    assert all(w.startswith("wheel") for w in wheels)


def test_names_say_row_and_side() -> None:
    assert set(named("car")) == {
        f"wheel_{row}_{side}" for row in ("front", "rear") for side in ("left", "right")
    }
    assert set(named("bicycle")) == {"wheel_front", "wheel_rear"}
    assert set(named("wheelbarrow")) == {"wheel"}
    assert set(named("segway")) == {"wheel_left", "wheel_right"}
    assert set(named("tricycle")) == {"wheel_front", "wheel_rear_left", "wheel_rear_right"}
    car = named("car")
    assert car["wheel_front_left"][0][0] > 0 > car["wheel_rear_left"][0][0]
    assert car["wheel_front_left"][0][1] > 0 > car["wheel_front_right"][0][1]


def test_rows_between_are_numbered_and_twins_counted() -> None:
    axles = [Axle((x, y, 3.0), 3.0) for x in (-20.0, 0.0, 20.0) for y in (-9.0, 9.0, 12.0)]
    names = wheel_names(axles)
    assert len(set(names)) == 9
    assert names[5] == "wheel_2_left" and names[4] == "wheel_2_left_2"
    assert names[6] == "wheel_front_right"


def test_nothing_else_has_wheels() -> None:
    assert configure("x", requirement(entries_by_name()["chair"])).wheels is None


@pytest.mark.parametrize("name", ["car", "bicycle", "shopping_cart", "tractor", "scooter"])
def test_nodes_of_the_mesh_turn_about_their_axles(name: str) -> None:
    """A node of the GLB has its axle as origin; turned by half a turn, the wheel stays in place."""
    entry = entries_by_name().get(name) or entries_by_name()["kick_scooter"]
    config = configure(name, requirement(entry))
    scene = trimesh.load(io.BytesIO(glb_bytes(config)), file_type="glb", force="scene")
    parents = scene.graph.transforms.parents
    assert config.wheels
    for wheel in config.wheels:
        place = scene.graph[wheel.name][0]
        x, y, z = (0.01 * c for c in wheel.axle_cm)
        assert place == pytest.approx(trimesh.transformations.translation_matrix((x, z, -y)))
        parts = [n for n in scene.graph.nodes_geometry if parents[n] == wheel.name]
        points = np.concatenate(
            [
                trimesh.transform_points(
                    scene.geometry[scene.graph[n][1]].vertices, scene.graph[n][0]
                )
                for n in parts
            ]
        )
        around = np.hypot(points[:, 0] - x, points[:, 1] - z)
        assert around.max() == pytest.approx(0.01 * wheel.radius_cm, rel=0.03)


def test_a_car_of_another_size_has_its_wheels_where_they_are() -> None:
    usual, small = named("toy_car"), named("toy_car", expected_dimensions_cm=(8, 4, 3.5))
    for name, (axle, radius) in usual.items():
        scale = small[name][1] / radius
        assert scale < 0.9
        assert small[name][0] == pytest.approx([scale * c for c in axle])
