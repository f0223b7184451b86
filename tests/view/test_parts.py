"""What is painted on the ground lies on it: nothing that stands there is sunk in paint."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
import trimesh

from esg.assets import build_mesh
from esg.assets.appearance import USUAL
from esg.assets.library.catalogue import entries_by_name
from esg.assets.materials import MATERIALS
from esg.assets.stage import configure
from esg.view import parts as module
from tests.assets.worlds import requirement


def flat(name: str, size: tuple[float, float, float], collides: bool = False) -> SimpleNamespace:
    """A body with its origin at the bottom centre; `size` is in metres."""
    return SimpleNamespace(
        name=name, category="", collides=collides, color=(0.5, 0.5, 0.5), origin_offset=(0.0, 0.0, 0.0),
        half_extents=tuple(0.5 * s for s in size), wheels=(),
    )  # fmt: skip


def test_decals_lie_within_millimetres_of_the_ground(monkeypatch: pytest.MonkeyPatch) -> None:
    """A floor drawn 1 cm thick hid a rug of 1.2 cm and buried half of a marble."""
    bodies = [
        flat("floor", (10.0, 8.0, 0.01)),
        flat("lane", (6.0, 1.0, 0.02)),
        flat("rug", (2.0, 1.4, 0.012), collides=True),
    ]

    def mesh(size: tuple[float, float, float]) -> trimesh.Scene:
        box = trimesh.creation.box([100.0 * s for s in size])
        box.apply_translation([0, 0, 50.0 * size[2]])
        return trimesh.Scene(box)

    meshes = {b.name: mesh(tuple(2 * h for h in b.half_extents)) for b in bodies}
    monkeypatch.setattr("esg.assets.build_mesh", lambda name, look: meshes[name])
    usual = dict.fromkeys(meshes, USUAL)
    monkeypatch.setattr("esg.assets.appearances.appearances", lambda doc: usual)
    doc = SimpleNamespace(
        scene_definition=SimpleNamespace(scene_parameters=SimpleNamespace(scene_type="indoor")),
        spatial_relation_graph=SimpleNamespace(
            nodes={b.name: SimpleNamespace(asset_id=b.name) for b in bodies}
        ),
        asset_configurations={b.name: b.name for b in bodies},
        casting=None,
        dressing=None,
        statements=None,
        timeline_system=None,
    )
    drawn = module.body_parts(SimpleNamespace(bodies=bodies), doc)  # type: ignore[arg-type]
    tops = {bodies[p.body].name: float(p.vertices[:, 2].max()) for p in drawn}
    assert 0.0 < tops["floor"] < tops["lane"] < 0.01
    assert tops["rug"] == pytest.approx(0.012)


def test_pieces_of_an_asset_carry_look_normals_coordinates_and_name() -> None:
    config = configure("chair", requirement(entries_by_name()["chair"]))
    pieces = module.mesh_parts(build_mesh(config), config.color_rgb)
    assert len({p.name for p in pieces}) == len(pieces) > 0
    for p in pieces:
        assert p.look is not None and p.look.material in MATERIALS
        assert p.normals is not None and p.normals.shape == p.vertices.shape
        assert p.uvs is not None and p.uvs.shape == (len(p.vertices), 2)
