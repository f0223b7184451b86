"""What the builders draw: sound meshes of few triangles, inside of what was asked for."""

from __future__ import annotations

import numpy as np
import pytest

from esg.dressing import dress
from esg.dressing.builders import BUILDERS, Wish
from esg.dressing.meshes import meshes_of
from esg.dressing.solids import Drawing
from esg.graph.models import Dressing, Marking
from esg.lexicon.places import places, standing, surfaces
from tests.dressing.worlds import PLACES, body, document, ground, road, rollout_of, scene_of

MOST_TRIANGLES = 100_000
STICKS_OUT = {"hall_wall": 0.23}
"""[m]; pillars of a hall stand before its wall."""


def sizes(name: str) -> set[tuple[float, float, float]]:
    """Least and greatest extents [m] at which the tables ask for a thing."""
    spans = [r.size_m for p in places() for r in standing(p) if r.item == name]
    told = [tuple(span[k] for span in s) for s in spans if s is not None for k in (0, 1)]
    return set(told) or {(0.12, 6.0, 2.7), (0.12, 25.0, 6.0)}  # type: ignore[arg-type]


@pytest.mark.parametrize(("name", "size"), [(n, s) for n in BUILDERS for s in sorted(sizes(n))])
def test_a_builder_draws_sound_triangles_where_it_was_asked_to(
    name: str, size: tuple[float, float, float]
) -> None:
    drawing = Drawing(np.random.default_rng(1), night=True)
    BUILDERS[name].run(drawing, Wish(*size))
    solids = drawing.solids()
    assert solids
    for solid in solids:
        assert solid.surface in surfaces()
        n = len(solid.vertices)
        assert solid.faces.min() >= 0 and solid.faces.max() < n
        assert solid.normals.shape == (n, 3) and solid.uvs.shape == (n, 2)
        assert np.isfinite(solid.vertices).all() and np.isfinite(solid.uvs).all()
        assert np.allclose(np.linalg.norm(solid.normals, axis=1), 1.0, atol=1e-6)
    points = np.concatenate([s.vertices for s in solids])
    room = np.array([0.5 * size[0], 0.5 * size[1]])
    beyond = float((np.abs(points[:, :2]).max(axis=0) - room).max())
    assert beyond < STICKS_OUT.get(name, 0.05), beyond


@pytest.mark.parametrize("name", [n for n in BUILDERS if n not in ("hill", "dune")])
def test_faces_are_turned_the_way_their_normals_point(name: str) -> None:
    """Parked cars were black once: every face of theirs looked inwards."""
    drawing = Drawing(np.random.default_rng(2))
    BUILDERS[name].run(drawing, Wish(3.0, 6.0, 3.0))
    for solid in drawing.solids():
        a, b, c = (solid.vertices[solid.faces[:, k]] for k in range(3))
        turned = np.cross(b - a, c - a)
        real = np.linalg.norm(turned, axis=1) > 1e-9
        agree = (turned * solid.normals[solid.faces].mean(axis=1)).sum(axis=1)[real] > 0
        assert agree.mean() > 0.97, solid.surface


def test_a_closed_thing_is_seen_from_outside() -> None:
    """The signed volume of a car that is closed is positive if its faces look outwards."""
    drawing = Drawing(np.random.default_rng(0))
    BUILDERS["parked_car"].run(drawing, Wish(4.5, 1.8, 1.5))
    volume = 0.0
    for solid in drawing.solids():
        a, b, c = (solid.vertices[solid.faces[:, k]] for k in range(3))
        volume += float((a * np.cross(b, c)).sum()) / 6.0
    assert 3.0 < volume < 4.5 * 1.8 * 1.5


@pytest.mark.parametrize("name", places())
def test_a_place_is_drawn_of_few_triangles(name: str) -> None:
    place = places()[name]
    bodies = [ground(), body("egg", (0.06, 0.06, 0.05))]
    if place.needs:
        bodies.append(road())
    scene = scene_of(*bodies)
    prompt = f"An egg rolls in the {place.said_as[0]}."
    preset = next(iter(place.presets), "generic")
    doc = document(scene, prompt, setting=place.setting, environment=preset)
    counts: list[int] = []
    for seed in range(3):
        made = dress(doc, scene, rollout_of(scene), seed=seed).dressing
        assert made is not None
        assert made.place == name, made.reasons
        meshes = list(meshes_of(made))
        counts.append(sum(len(m.faces) for m in meshes))
        for mesh in meshes:
            assert mesh.look.material and np.isfinite(mesh.uvs).all()
            assert float(mesh.vertices[:, 2].max()) < 70.0
    assert max(counts) < MOST_TRIANGLES


def test_lines_and_discs_are_as_large_as_told() -> None:
    marks = (
        Marking(surface="line_white", center_cm=(100, 0), half_cm=(200, 100), line_cm=10),
        Marking(surface="water", center_cm=(0, 0), half_cm=(300, 200), shape="ellipse", layer=1),
    )
    made = Dressing(
        place="park", sky="clear", sun_azimuth_deg=0, sun_elevation_deg=40, ground="grass",
        markings=marks,
    )  # fmt: skip
    line, disc = meshes_of(made)

    def area(vertices: np.ndarray, faces: np.ndarray) -> float:
        a, b, c = (vertices[faces[:, k]] for k in range(3))
        return float(np.cross(b - a, c - a)[:, 2].sum()) / 2

    assert area(line.vertices, line.faces) == pytest.approx(4 * 2 - 3.8 * 1.8)
    assert area(disc.vertices, disc.faces) == pytest.approx(np.pi * 6, rel=0.01)
    assert disc.vertices[0, 2] > line.vertices[0, 2]


def test_a_thing_stands_where_its_item_says() -> None:
    setting, environment, prompt = PLACES[1]
    scene = scene_of(ground(), body("ball", (0.2, 0.2, 0.2)))
    doc = document(scene, prompt, setting=setting, environment=environment)
    made = dress(doc, scene, rollout_of(scene)).dressing
    assert made is not None
    middle = {i.id: np.array(i.position_cm) / 100 for i in made.items}
    reach = {i.id: 0.6 * float(np.hypot(*i.size_cm[:2])) / 100 + 0.3 for i in made.items}
    for mesh in meshes_of(made):
        thing = mesh.name.partition("/")[0]
        if thing in middle:
            off = np.linalg.norm((mesh.vertices - middle[thing])[:, :2], axis=1)
            assert float(off.max()) < reach[thing], mesh.name


@pytest.mark.parametrize(
    "name", [n for n in BUILDERS if n.startswith("facade") or n in ("room_wall", "cottage")]
)
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_who_looks_at_a_wall_from_the_side_sees_no_back_of_a_face(name: str, side: float) -> None:
    """Backs are not drawn: where one came first, as in the reveals of windows, the sky showed."""
    drawing = Drawing(np.random.default_rng(3))
    deep = 0.3 if name == "room_wall" else 8.0
    BUILDERS[name].run(drawing, Wish(deep, 8.0, 6.0))
    corners = np.concatenate([s.vertices[s.faces] for s in drawing.solids()])
    rng = np.random.default_rng(4)
    front = 0.5 * deep
    eye = np.array([front + 6.0, side * 7.0, 3.0])
    aims = np.stack(
        [np.full(300, front - 0.2), rng.uniform(-3.9, 3.9, 300), rng.uniform(0.1, 5.9, 300)], -1
    )
    backs = [_nearest_is_back(corners, eye, aim - eye) for aim in aims]
    assert sum(backs) == 0


def _nearest_is_back(corners: np.ndarray, eye: np.ndarray, way: np.ndarray) -> bool:
    """Whether the first triangle on a ray turns its back to it; not if there is none."""
    a, ab, ac = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    h = np.cross(way, ac)
    det = (ab * h).sum(axis=1)
    with np.errstate(all="ignore"):
        u = ((eye - a) * h).sum(axis=1) / det
        q = np.cross(eye - a, ab)
        v, t = (q * way).sum(axis=1) / det, (ac * q).sum(axis=1) / det
    met = (np.abs(det) > 1e-12) & (u > 0) & (v > 0) & (u + v < 1) & (t > 0)
    return bool(met.any() and det[met][np.argmin(t[met])] < 0)
