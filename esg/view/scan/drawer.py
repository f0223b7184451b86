"""One scene on the processor, ready to be drawn from anywhere."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.camera import Camera
from esg.view.pieces import Movers, Part
from esg.view.surroundings import Sky, thing_of

SHADOW_PX = 768
"""Side of the map of what the sun sees."""
SOFT_TEXELS = 1.2
CLEAR_M, MOST_HAZE = 60.0, 0.85
"""Haze begins so far off [m], and hides so much at most five times as far, unless there is fog."""
PLAIN_ROUGHNESS = 0.6

Textures = Callable[[str], "NDArray[np.uint8] | None"]


def no_textures(_: str) -> None:
    """Leaves surfaces plain."""


class Scan:
    """Draws one set of parts in many poses from many cameras.

    Args:
        parts: Meshes.
        n_bodies: Number of bodies that `Part.body` refers to.
        size: Width and height of the pictures [px].
        sky: Light from above.
        still: Bodies that never change their pose: they are drawn once while the camera stands.
        textures: Gives the base colours of a texture, sRGB of shape [n, n, 3], n a power of 2.
    """

    def __init__(
        self,
        parts: Sequence[Part],
        n_bodies: int,
        size: tuple[int, int],
        *,
        sky: Sky | None = None,
        still: Iterable[int] = (),
        textures: Textures = no_textures,
    ) -> None:
        from esg.engines.newton import quiet_warp

        self._wp = wp = quiet_warp()
        from esg.view.scan import kernels

        self._k = kernels
        rest = {-1, *still}
        # What stands still comes first, so that it is placed and drawn first.
        parts = sorted((p for p in parts if len(p.faces)), key=lambda p: _moves(p, rest))
        self.size, self._movers, self._sky = size, Movers(parts, n_bodies), sky or Sky()
        counts = np.array([len(p.vertices) for p in parts], int)
        faces = np.array([len(p.faces) for p in parts], int)
        starts = np.cumsum(counts) - counts
        self._bodies = np.array([p.body for p in parts] or [-1], np.int32)
        triangles = _joined([p.faces + s for p, s in zip(parts, starts, strict=True)], 3)
        mover = np.repeat([self._movers.of(p) for p in parts], counts) + 1
        moving = np.repeat([_moves(p, rest) for p in parts], faces)
        self._part = np.repeat(np.arange(len(parts)), faces)
        self._moving, self._hidden = moving, frozenset[str]()
        self._things = [thing_of(p) if p.body < 0 else "" for p in parts]
        self._order = {
            "still": self._array(np.flatnonzero(~moving), int),
            "moving": self._array(np.flatnonzero(moving), int),
        }
        # What gives light casts no shadow.
        dark = np.array([p.look is None or not p.look.glow for p in parts], bool)
        self._casting = self._array(np.flatnonzero(moving & dark[self._part]), int)
        self._rest = int(sum(c for c, p in zip(counts, parts, strict=True) if not _moves(p, rest)))
        self._local = self._array(_joined([p.vertices for p in parts], 3), wp.vec3)
        normals = [p.normals if p.normals is not None else 0 * p.vertices for p in parts]
        self._normal = self._array(_joined(normals, 3), wp.vec3)
        uvs = [p.uvs if p.uvs is not None else np.zeros((len(p.vertices), 2)) for p in parts]
        self._uvs = self._array(_joined(uvs, 2), wp.vec2)
        self._mover = self._array(mover, int)
        self._triangles = self._array(triangles, int, 2)
        self._parts = self._array(self._part, int)
        self._world, self._turned = wp.empty_like(self._local), wp.empty_like(self._normal)
        self._surfaces, self._texels = _surfaces(wp, kernels, parts, textures)
        self._gamma = self._array(_gamma(), wp.uint8)
        self._images: dict[tuple[int, int], dict[str, Any]] = {}
        self._subsets: dict[tuple[int, ...], Any] = {}
        self._placed = False
        self._stood: Camera | None = None
        self._lit: Any = None
        self._light: Any = None
        side = SHADOW_PX
        self._heights = [wp.empty((side, side), dtype=float, device="cpu") for _ in range(2)]
        self._shadowed = False

    def hide(self, things: frozenset[str]) -> None:
        """Leaves things of the surroundings out, and shows all others.

        Args:
            things: Their ids; see `Surroundings.parts`.
        """
        if things == self._hidden:
            return
        gone = np.array([thing in things for thing in self._things], bool)
        order = np.flatnonzero(~self._moving & ~gone[self._part])
        self._order["still"] = self._array(order, int)
        self._hidden, self._stood, self._lit = things, None, None
        self._shadowed = False

    def light(self, center: Any, reach: float) -> None:
        """Says what the map of shadows covers.

        Args:
            center: Of what is filmed [m], shape [3].
            reach: Half the side of the map [m].
        """
        wp, sky, light = self._wp, self._sky, self._k.Light()
        sun = np.asarray(sky.sun, float)
        sun = sun / np.linalg.norm(sun)
        right = np.cross((0.0, 0.0, 1.0) if abs(sun[2]) < 0.99 else (1.0, 0.0, 0.0), sun)
        right = right / np.linalg.norm(right)
        light.sun = wp.vec3(*sun)
        light.axes = wp.mat33(*np.concatenate([right, np.cross(sun, right), sun]))
        light.sun_rgb, light.ambient = wp.vec3(*sky.sun_rgb), wp.vec3(*sky.ambient_rgb)
        light.zenith, light.horizon = wp.vec3(*sky.zenith), wp.vec3(*sky.horizon)
        light.center = wp.vec3(*(float(c) for c in center))
        light.clear_m, light.haze = CLEAR_M, MOST_HAZE
        if sky.sight_m:
            light.clear_m, light.haze = 0.2 * sky.sight_m, 1.0
        light.scale, light.side, light.soft = 0.5 * SHADOW_PX / reach, SHADOW_PX, SOFT_TEXELS
        self._light, self._shadowed = light, False

    def pose(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None = None
    ) -> None:
        """Moves the bodies.

        Args:
            position: Body origins [m], shape [B, 3].
            quaternion: (x, y, z, w), shape [B, 4].
            angles: Of the scene's wheels [rad], shape [W].
        """
        self.place(self.poses(position, quaternion, angles))

    def poses(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None = None
    ) -> NDArray[np.float32]:
        """Poses of all that moves, for `place`, at any number of instants at once.

        Args:
            position: Body origins [m], shape [..., B, 3].
            quaternion: (x, y, z, w), shape [..., B, 4].
            angles: Of the scene's wheels [rad], shape [..., W].

        Returns:
            The world's and theirs, shape [..., 1 + M, 7].
        """
        moved = np.concatenate(self._movers.poses(position, quaternion, angles), axis=-1)
        world = np.broadcast_to((0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), (*moved.shape[:-2], 1, 7))
        return np.concatenate([world, moved], axis=-2).astype(np.float32)

    def place(self, poses: NDArray[np.float32]) -> None:
        """Moves everything to poses of one instant, as of `poses`."""
        wp = self._wp
        poses = wp.array(poses, dtype=wp.transform, device="cpu")
        start = self._rest if self._placed else 0
        self._launch(
            self._k.place,
            len(self._local) - start,
            [self._local, self._normal, self._mover, poses, start],
            [self._world, self._turned],
        )
        self._placed, self._shadowed = True, False

    def color(self, camera: Camera) -> NDArray[np.uint8]:
        """The picture from a camera, shape [height, width, 3]."""
        if self._light is None:
            self.light(camera.target, float(np.linalg.norm(np.subtract(camera.eye, camera.target))))
        wp, (width, height) = self._wp, self.size
        self._shadow()
        images, view = self._seen_from(camera)
        common = [self._triangles, self._parts, self._surfaces, self._texels]
        self._launch(
            self._k.shade,
            (height, width),
            [view, self._light, self._world, self._turned, self._uvs, *common, self._heights[1]],
            [*images["now"], self._gamma, images["raw"]],
        )
        out = wp.empty((height, width, 3), dtype=wp.uint8, device="cpu")
        ends = [images["now"][1], self._parts, images["raw"]]
        self._launch(self._k.smooth, (height, width), ends, [out])
        return out.numpy()

    def look(
        self, camera: Camera, size: tuple[int, int], only: Sequence[int] | None = None
    ) -> tuple[NDArray[np.int32], NDArray[np.float32]]:
        """What a camera sees, backs of surfaces included: from inside of a thing, its walls.

        Args:
            camera: Where to look from.
            size: Width and height [px].
            only: Bodies to draw; all, and the world, if None.

        Returns:
            The body of each pixel, -1 for the world and -2 for nothing, and 1 / depth [1/m], 0
            for nothing; both of shape [height, width].
        """
        images, view = self._images_of(size), self._view(camera, size)
        self._clear(images["now"])
        orders = [*self._order.values()] if only is None else [self._subset(tuple(only))]
        for order in orders:
            self._scan(view, order, images["now"], backs=True)
        hit = images["now"][1].numpy()
        owner = np.append(self._bodies[self._part], -2)
        return owner[hit].astype(np.int32), images["now"][0].numpy().copy()

    def _seen_from(self, camera: Camera) -> tuple[dict[str, Any], Any]:
        """Depth and triangles of a picture; what stands still is kept while the camera stands."""
        images, view = self._images_of(self.size), self._view(camera, self.size)
        if camera != self._stood:
            self._clear(images["base"])
            self._scan(view, self._order["still"], images["base"])
            self._stood = camera
        for image, base in zip(images["now"], images["base"], strict=True):
            self._wp.copy(image, base)
        self._scan(view, self._order["moving"], images["now"])
        return images, view

    def _scan(self, view: Any, order: Any, images: Any, *, backs: bool = False) -> None:
        scene = [self._world, self._triangles, self._parts, self._surfaces]
        self._launch(self._k.scan, len(order), [view, *scene, order, backs], list(images))

    def _clear(self, images: Any) -> None:
        images[0].fill_(0.0)
        images[1].fill_(-1)

    def _shadow(self) -> None:
        """Draws what the sun sees: what stands still once, what moves in every pose."""
        if self._shadowed:
            return
        wp, (still, now) = self._wp, self._heights
        scene = [self._light, self._world, self._triangles]
        if self._light is not self._lit:
            still.fill_(-1.0e9)
            order = self._order["still"]
            self._launch(self._k.shade_from, len(order), [*scene, order], [still])
            self._lit = self._light
        wp.copy(now, still)
        order = self._casting
        self._launch(self._k.shade_from, len(order), [*scene, order], [now])
        self._shadowed = True

    def _subset(self, bodies: tuple[int, ...]) -> Any:
        if bodies not in self._subsets:
            mine = np.flatnonzero(np.isin(self._bodies[self._part], bodies))
            self._subsets[bodies] = self._array(mine, int)
        return self._subsets[bodies]

    def _view(self, camera: Camera, size: tuple[int, int]) -> Any:
        wp, view = self._wp, self._k.View()
        axes = camera.axes * (1.0, 1.0, -1.0)
        view.eye = wp.vec3(*(float(c) for c in camera.eye))
        view.axes = wp.mat33(*axes.T.reshape(-1))
        view.width, view.height = size
        view.focal = 0.5 * size[1] / math.tan(camera.fov / 2)
        return view

    def _images_of(self, size: tuple[int, int]) -> dict[str, Any]:
        """Depths and triangles now and of what stands still, and a picture, of one size."""
        if size not in self._images:
            wp, shape = self._wp, size[::-1]
            now, base = (
                tuple(wp.zeros(shape, dtype=kind, device="cpu") for kind in (float, int))
                for _ in range(2)
            )
            raw = wp.empty((*shape, 3), dtype=wp.uint8, device="cpu")
            self._images[size] = {"now": now, "base": base, "raw": raw}
        return self._images[size]

    @property
    def still_triangles(self) -> NDArray[np.float32]:
        """Corners of what stands still in the world [m], shape [n, 3, 3]."""
        order = self._order["still"].numpy()
        return self._world.numpy()[self._triangles.numpy()[order]]

    def _array(self, values: Any, dtype: Any, dims: int = 1) -> Any:
        kind = np.float32 if hasattr(dtype, "_wp_scalar_type_") else None
        kind = np.int32 if dtype is int else np.uint8 if dtype is self._wp.uint8 else kind
        array = np.ascontiguousarray(values, kind)
        return self._wp.array(array, dtype=dtype, device="cpu", ndim=dims)

    def _launch(self, kernel: Any, dim: Any, inputs: list[Any], outputs: list[Any]) -> None:
        self._wp.launch(kernel, dim=dim, inputs=inputs, outputs=outputs, device="cpu")


def _moves(part: Part, rest: set[int]) -> bool:
    return part.body not in rest or part.act is not None


def _joined(arrays: Sequence[Any], width: int) -> Any:
    return np.concatenate([np.zeros((0, width)), *arrays])


def _gamma() -> NDArray[np.uint8]:
    """sRGB of 4096 steps of linear light."""
    linear = np.linspace(0.0, 1.0, 4096)
    curve = np.where(linear < 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.rint(255 * curve).astype(np.uint8)


def _surfaces(wp: Any, kernels: Any, parts: Sequence[Part], textures: Textures) -> tuple[Any, Any]:
    """One row a part, and all texels of all levels of all textures."""
    rows: list[Any] = []
    texels: list[NDArray[np.uint8]] = [np.zeros((1, 3), np.uint8)]
    starts: dict[str, tuple[int, int]] = {}
    length = 1
    for part in parts:
        row, look = kernels.Surface(), part.look
        name = look.texture if look is not None and part.uvs is not None else None
        if name is not None and name not in starts:
            image = textures(name)
            starts[name] = (-1, 0) if image is None else (length, len(image))
            levels = [] if image is None else _levels(image)
            texels += levels
            length += sum(len(level) for level in levels)
        color = np.asarray(look.color if look is not None else part.color, float)
        row.texture, row.edge = starts[name] if name is not None else (-1, 0)
        # A texture is squared in the loop, which undoes its sRGB well enough.
        row.rgb = wp.vec3(*(color**2.2))
        row.roughness = look.roughness if look is not None else PLAIN_ROUGHNESS
        row.metalness = look.metalness if look is not None else 0.0
        row.glow = look.glow if look is not None else 0.0
        row.alpha = look.alpha if look is not None else 1.0
        row.tile_m = look.tile_m if look is not None else 1.0
        row.body = part.body
        rows.append(row)
    table = wp.array(rows or [kernels.Surface()], dtype=kernels.Surface, device="cpu")
    return table, wp.array(np.concatenate(texels), dtype=wp.vec3ub, device="cpu")


def _levels(image: NDArray[np.uint8]) -> list[NDArray[np.uint8]]:
    """A texture and its halves down to one texel, as rows of texels."""
    out = [image.reshape(-1, 3)]
    level = image.astype(float)
    while len(level) > 1:
        level = 0.25 * (level[::2, ::2] + level[1::2, ::2] + level[::2, 1::2] + level[1::2, 1::2])
        out.append(np.rint(level).astype(np.uint8).reshape(-1, 3))
    return out
