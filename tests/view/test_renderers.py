"""Renderers: what paper says of sky, scale, shadows and light is what their pictures show."""

from __future__ import annotations

from dataclasses import replace
import importlib.util
import math
import shutil
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray
import pytest
import trimesh

from esg.assets import textures
from esg.assets.looks import Look
from esg.engines.scene import Rollout
from esg.outcomes import UserError
from esg.view.camera import Camera
from esg.view.maps import encoded, linear, pyramid
from esg.view.pieces import Part
from esg.view.renderers import cycles, mitsuba
from esg.view.renderers.finish import view_directions
from esg.view.renderers.kinds import KINDS, kind_named
from esg.view.renderers.records import Poses, Quality, Scenery
from esg.view.renderers.shutter import INSTANTS, poses_at
from esg.view.skies import AIRS, sky_at, sky_map
from esg.view.surroundings import Sky, Surroundings
from esg.view.truth import Pinhole
from esg.view.worlds import GROUND, NOTHING, Views, WorldRenderer

SIZE = (96, 64)
WHITE = Look("", (1.0, 1.0, 1.0), roughness=1.0)
GREY = Look("", (0.5, 0.5, 0.5), roughness=1.0)
OVERHEAD = Sky("clear", (0.0, 0.0, 1.0), (0.7, 0.7, 0.7), (0.2, 0.2, 0.2), (0.2, 0.4, 0.8),
               (0.6, 0.7, 0.9))  # fmt: skip
FRONT = Camera((0.0, -6.0, 1.5), (0.0, 0.0, 0.5))
has_mitsuba = all(importlib.util.find_spec(m) for m in ("mitsuba", "mitsuba_oidn"))
TRACERS = [
    "raster",
    pytest.param("path", marks=pytest.mark.skipif(not has_mitsuba, reason="needs [render]")),
]


def box(center: Any, extents: Any, look: Look = GREY, body: int = -1) -> Part:
    mesh = trimesh.creation.box(extents)
    vertices = np.asarray(mesh.vertices) + np.asarray(center)
    return Part(body, vertices, np.asarray(mesh.faces), look.color, look=look)


def still(frames: int = 1, bodies: int = 0) -> Poses:
    turn = np.zeros((frames, 1, bodies, 4))
    turn[..., 3] = 1.0
    return Poses(np.zeros((frames, 1, bodies, 3)), turn)


def scenery(*parts: Part, sky: Sky = OVERHEAD, ground: Look = GREY, bodies: int = 0) -> Scenery:
    return Scenery(parts, bodies, Surroundings(sky, ground))


def drawn(kind: str, shown: Scenery, camera: Camera = FRONT, **quality: Any) -> Views:
    made = kind_named(kind).load(shown, Quality(**{"size": SIZE, "samples": 16, **quality}))
    return made.draw(still(1, shown.n_bodies), [camera])


def rgb(views: Views) -> NDArray[np.uint8]:
    assert views.rgb is not None
    return views.rgb[0]


def test_unknown_renderers_are_named() -> None:
    with pytest.raises(UserError, match="'teapot': choose from raster, path, cycles"):
        kind_named("teapot")


@pytest.mark.parametrize("kind", TRACERS)
def test_the_sky_is_behind_what_is_not_there(kind: str) -> None:
    """Rays that miss show the same picture of the sky, with its clouds, in every renderer."""
    up = Camera((0.0, 0.0, 2.0), (3.0, 1.0, 4.0))
    shown = rgb(drawn(kind, scenery(box((0, 50, 0), (1, 1, 1))), up, samples=2))
    wanted = encoded(sky_at(sky_map(OVERHEAD, 0), view_directions(up, SIZE)))
    assert np.abs(shown.astype(int) - wanted).max() <= 1
    assert np.ptp(wanted.reshape(-1, 3), axis=0).max() > 20  # there are clouds to see


def test_clouds_follow_the_seed() -> None:
    assert not np.allclose(sky_map(OVERHEAD, 0), sky_map(OVERHEAD, 1))
    assert np.allclose(sky_map(Sky(), 0), sky_map(Sky(), 1))  # a plain sky has none


@pytest.fixture
def checker(monkeypatch: pytest.MonkeyPatch) -> str:
    """A texture of two by two squares, white at the upper left."""

    def maps(name: str, size: int = 512) -> textures.Maps:
        half = np.arange(size) < size // 2
        white = half[:, None] == half[None, :]
        color = np.where(white[..., None], 255, 0).astype(np.uint8) * np.ones(3, np.uint8)
        flat = np.full((size, size, 3), (128, 128, 255), np.uint8)
        return textures.Maps(color, flat, np.full((size, size), 255, np.uint8))

    monkeypatch.setattr(textures, "maps", maps)
    pyramid.cache_clear()
    return "checker of a test"


@pytest.mark.parametrize("kind", TRACERS)
def test_a_texture_is_as_large_as_its_tile(kind: str, checker: str) -> None:
    """On a wall 4 m away, squares of half a tile of 0.8 m are as wide as a pinhole says."""
    look = Look("", (1.0, 1.0, 1.0), roughness=1.0, texture=checker, tile_m=0.8)
    corners = np.array([[-2.0, 0, 0], [2, 0, 0], [2, 0, 3.2], [-2, 0, 3.2]])
    uvs = corners[:, [0, 2]] / 0.8
    wall = Part(-1, corners, np.array([[0, 1, 2], [0, 2, 3]]), (1, 1, 1), look=look, uvs=uvs)
    sky = replace(OVERHEAD, sun=(0.0, -math.sqrt(0.5), math.sqrt(0.5)))
    camera = Camera((0.0, -4.0, 1.6), (0.0, 0.0, 1.6))
    seen = rgb(drawn(kind, scenery(wall, sky=sky), camera, samples=32))[..., 1].astype(float)
    # Squares above and below eye level (a tile's border) have swapped colours; 0.4 m are so wide:
    width = 0.4 / 4.0 * SIZE[1] / (2 * math.tan(camera.fov / 2))
    row = seen[int(SIZE[1] / 2 - width / 2)]
    changes = np.nonzero(np.diff((row > 90).astype(int)))[0] + 1 - SIZE[0] / 2
    wanted = width * np.arange(-math.floor(SIZE[0] / 2 / width), SIZE[0] / 2 / width)
    assert len(changes) == len(wanted)
    assert np.abs(changes - wanted).max() <= 1.0
    # A tile's picture stands upright: right of the middle and above it is its lower left square.
    right = int(SIZE[0] / 2 + width / 2)
    above, below = (seen[int(SIZE[1] / 2 + s * width / 2), right] for s in (-1, 1))
    assert above < 60 < 120 < below


@pytest.mark.slow
@pytest.mark.parametrize("kind", TRACERS)
@pytest.mark.parametrize("sky", ["clear", "cloudy"])
def test_shadows_are_as_soft_as_the_sun_is_wide(kind: str, sky: Any) -> None:
    """Below an edge 1 m up, the penumbra of a sun overhead is twice its radius wide."""
    roof = box((-4.0, 0.0, 1.0), (8.0, 8.0, 0.02))
    light = replace(OVERHEAD, kind=sky, ambient_rgb=(0.05, 0.05, 0.05))
    # Seen from the open side, below the roof's height: the shadow's edge runs across at x = 0.
    camera = Camera((1.6, 0.0, 0.9), (0.0, 0.01, 0.0), fov=0.5)
    size = (64, 256)
    seen = rgb(drawn(kind, scenery(roof, sky=light), camera, samples=64, size=size))
    level = linear(seen[:, 28:36].mean(axis=(1, 2)) / 255.0)
    pinhole = Pinhole.of(camera, size)
    x = np.linspace(-0.5, 0.5, 1001)
    pixels, _ = pinhole.project(np.stack([x, 0 * x, 0 * x], axis=1))
    along = np.interp(pixels[:, 1], np.arange(size[1]) + 0.5, level)
    low, high = along[0], along[-1]
    assert high > 3 * low
    share = (along - low) / (high - low)
    soft = x[np.argmax(share > 0.9)] - x[np.argmax(share > 0.1)]
    # A disc cut by an edge goes from 10% to 90% over 0.687 of its diameter.
    wanted = 0.687 * 2 * math.tan(AIRS[sky].sun_radius)
    pixels_3 = 0.022  # [m] of ground: what the smoothing of light adds
    assert soft == pytest.approx(wanted, rel=0.2, abs=pixels_3)


@pytest.mark.parametrize("kind", TRACERS)
def test_white_in_the_sun_is_as_bright_as_the_sky_says(kind: str) -> None:
    """Level ground reflects sun and sky times its albedo, and a gleam of a few percent."""
    seen = rgb(drawn(kind, scenery(box((0, 90, 0), (1, 1, 1)), ground=GREY)))
    light = linear(seen[50:60].mean(axis=(0, 1)) / 255.0)
    wanted = linear(np.array(GREY.color)) * (0.7 + 0.2)
    assert light == pytest.approx(wanted, rel=0.2)


@pytest.mark.skipif(not has_mitsuba, reason="needs [render]")
def test_the_path_tracer_sees_what_the_exact_channels_say() -> None:
    """Away from edges: depths within 2 mm and a quarter of a pixel, normals within a hundredth."""
    from esg.view.renderers.path import PathTracer

    parts = [
        box((0.3, 0.0, 0.5), (1.0, 1.0, 1.0), body=0),
        box((-1.0, 1.0, 0.25), (0.5, 0.5, 0.5), body=1),
    ]
    quality = Quality(SIZE, samples=16, exact=True)
    tracer = PathTracer(scenery(*parts, bodies=2), quality)
    poses = still(1, 2)
    exact = tracer.draw(poses, [FRONT])
    found = tracer.channels(poses, FRONT)
    d = view_directions(FRONT, SIZE)
    depth = found["distance"] * (d @ -FRONT.axes[:, 2])
    inside = same_around(exact.normal[0].round(2)) & same_around(exact.body[0])
    # The ground recedes within a pixel near the horizon: there the mean is not the centre's.
    near = inside & (exact.depth[0] > 0) & (exact.depth[0] < 8.0)
    assert near.sum() > 2000
    assert set(exact.body[0][near]) == {0, 1, GROUND}
    slope = np.linalg.norm(np.gradient(exact.depth[0]), axis=0)
    assert (np.abs(depth - exact.depth[0])[near] < 0.002 + 0.25 * slope[near]).all()
    assert np.median(np.abs(depth - exact.depth[0])[near & (exact.body[0] >= 0)]) < 0.001
    assert np.abs(found["normal"] - exact.normal[0])[near].max() < 0.01
    sky = exact.body[0] == NOTHING
    assert found["alpha"][sky & same_around(sky)].max() < 1e-3


def same_around(values: NDArray[Any]) -> NDArray[np.bool_]:
    """Pixels whose eight neighbours have the same value."""
    values = values.reshape(*values.shape[:2], -1)
    same = np.ones(values.shape[:2], bool)
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            same &= (np.roll(values, (dy, dx), (0, 1)) == values).all(axis=-1)
    same[[0, -1]] = same[:, [0, -1]] = False
    return same


@pytest.mark.parametrize("kind", TRACERS)
def test_the_same_seed_draws_the_same_bytes(kind: str) -> None:
    shown = scenery(box((0.0, 0.0, 0.5), (1.0, 1.0, 1.0)))
    one, two = (rgb(drawn(kind, shown, samples=4, seed=3)) for _ in range(2))
    assert (one == two).all()


def test_worlds_of_a_batch_are_single_renders() -> None:
    """The same bytes, whichever neighbours a world has in the batch."""
    parts = [box((0, 0, 0.5), (1, 1, 1), body=0), box((0, 0, 1.2), (0.4, 0.4, 0.4), body=1)]
    around = Surroundings(OVERHEAD, GREY, (box((2.0, 1.0, 0.5), (0.5, 0.5, 1.0)),))
    position = np.zeros((3, 2, 3))
    position[:, 0, 0] = (-1.0, 0.0, 1.0)
    turn = np.tile([0.0, 0.0, 0.0, 1.0], (3, 2, 1))
    cameras = [Camera((0.1 * k, -6.0, 1.5), (0.0, 0.0, 0.5)) for k in range(3)]
    batch = WorldRenderer(parts, 2, 3, SIZE, surroundings=around)
    batch.pose(position, turn)
    batch.draw(cameras)
    together = batch.read()
    single = WorldRenderer(parts, 2, 1, SIZE, surroundings=around)
    assert together.rgb is not None
    for k in range(3):
        single.pose(position[k : k + 1], turn[k : k + 1])
        single.draw(cameras[k : k + 1])
        alone = single.read()
        assert (together.rgb[k] == rgb(alone)).all()
        assert (together.body[k] == alone.body[0]).all()


@pytest.mark.parametrize("kind", TRACERS)
def test_one_sees_through_clear_things(kind: str) -> None:
    """A pane tints what is behind it and throws no shadow; the exact channels show the pane."""
    glass = Look("", (0.9, 0.95, 0.9), roughness=0.5, alpha=0.3)
    wall = box((0.0, 2.0, 1.0), (4.0, 0.1, 2.0), Look("", (0.9, 0.1, 0.1), 1.0), body=1)
    pane = box((0.0, 0.0, 1.0), (1.0, 0.02, 1.5), glass, body=0)
    views = drawn(kind, scenery(wall, pane, bodies=2), exact=True, samples=32)
    middle = rgb(views)[26:30, 46:50].mean(axis=(0, 1))
    assert middle[0] > 1.3 * middle[2]  # red comes through
    assert views.body[0, 28, 48] == 0


@pytest.mark.slow
@pytest.mark.parametrize("kind", TRACERS)
def test_motion_blur_smears_what_moves_and_nothing_else(kind: str) -> None:
    """A box that moves 1 m while the shutter is open leaves a ramp of light so wide."""
    dark = Look("", (0.02, 0.02, 0.02), roughness=1.0)
    cube = box((0.0, 0.0, 0.5), (1.0, 1.0, 1.0), dark, body=0)
    post = box((-2.2, 0.0, 0.5), (0.5, 0.5, 1.0), dark)
    shown = scenery(cube, post, ground=WHITE, bodies=1)
    poses = still(1, 1)
    moved = np.repeat(poses.position, INSTANTS, axis=1)
    moved[0, :, 0, 0] = np.linspace(-0.5, 0.5, INSTANTS)
    blurred = Poses(moved, np.repeat(poses.quaternion, INSTANTS, axis=1))
    high = Camera((0.0, -8.0, 8.0), (0.0, 0.0, 0.0))
    made = kind_named(kind).load(shown, Quality(SIZE, samples=100))
    sharp, soft = (linear(rgb(made.draw(p, [high]))[30] / 255.0)[:, 1] for p in (poses, blurred))
    grey = lambda row: int(((row > 0.1) & (row < 0.6)).sum())  # noqa: E731
    assert grey(soft) >= grey(sharp) + 8
    assert soft[:30] == pytest.approx(sharp[:30], abs=0.08)


def rollout() -> Rollout:
    time = np.linspace(0.0, 1.0, 11)
    angle = 0.5 * np.pi * time
    turn = np.stack([0 * time, 0 * time, np.sin(angle / 2), np.cos(angle / 2)], axis=1)
    turn[5:] *= -1.0  # the same orientations
    position = np.stack([2.0 * time, 0 * time, 0 * time], axis=1)
    return SimpleNamespace(  # type: ignore[return-value]  # what is read of a rollout
        time=time, position=position[None, :, None], quaternion=turn[None, :, None]
    )


def test_poses_of_the_shutter_lie_around_the_frame() -> None:
    """Evenly in time, through the sign of a quaternion, and never outside of the recording."""
    angles = np.linspace(0, 10, 11)[:, None]
    made = poses_at(rollout(), [0, 5], angles, open_s=0.1)
    assert made.position[1, :, 0, 0] == pytest.approx(np.linspace(0.9, 1.1, INSTANTS))
    assert made.angles is not None
    assert made.angles[1, :, 0] == pytest.approx(np.linspace(4.5, 5.5, INSTANTS))
    yaw = 2 * np.arctan2(made.quaternion[1, :, 0, 2], made.quaternion[1, :, 0, 3])
    assert np.ptp(np.unwrap(yaw)) == pytest.approx(0.05 * np.pi, rel=1e-3)
    assert made.position[0].min() == 0.0
    sharp = poses_at(rollout(), [5], angles)
    middle = made.part(1, 2).middle()
    assert middle.position == pytest.approx(sharp.position)


def test_light_is_encoded_and_decoded() -> None:
    """Below the shoulder a picture's bytes are sRGB; nothing is brighter than white."""
    levels = np.linspace(0.0, 0.6, 50)
    assert linear(encoded(levels) / 255.0) == pytest.approx(levels, abs=0.004)
    assert encoded(np.array([5.0, 100.0])).tolist() == [255, 255]
    assert (np.diff(encoded(np.linspace(0, 3, 200)).astype(int)) >= 0).all()


def test_a_missing_blender_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    cycles.blender.cache_clear()
    monkeypatch.setenv("ESG_BLENDER", "/nowhere/blender")
    with pytest.raises(UserError, match="ESG_BLENDER='/nowhere/blender' is no program"):
        KINDS["cycles"].version()
    monkeypatch.setenv("ESG_BLENDER", shutil.which("true") or "true")
    with pytest.raises(UserError, match="is no Blender"):
        KINDS["cycles"].version()
    cycles.blender.cache_clear()


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("blender") is None, reason="needs a Blender")
def test_blender_draws_the_same_picture() -> None:
    """Sky and box are where the fast renderer has them, in about the same light."""
    shown = scenery(box((0.3, 0.0, 0.5), (1.0, 1.0, 1.0), body=0), bodies=1)
    a = rgb(drawn("cycles", shown, samples=16)).astype(float)
    b = rgb(drawn("raster", shown)).astype(float)
    assert np.abs(a[:4] - b[:4]).max() <= 1
    assert np.median(np.abs(a - b)) < 16


def test_slopes_of_a_normal_map_are_as_steep_as_the_material_says() -> None:
    """Rubber at full strength is lit alike all over: its balls looked flat."""
    steep = np.array([[[218, 127, 217]]], np.uint8)
    flat, half, full = (2 * mitsuba.sloped(steep, s)[0, 0] - 1 for s in (0.0, 0.5, 1.0))
    assert flat == pytest.approx((0.0, 0.0, 1.0), abs=1e-6)
    assert full[0] / full[2] == pytest.approx(91 / 90, abs=0.02)
    assert half[0] / half[2] == pytest.approx(0.5 * full[0] / full[2], abs=1e-3)
    assert np.linalg.norm(half) == pytest.approx(1.0, abs=1e-6)
