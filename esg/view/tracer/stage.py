"""The scene as the tracer's kernels want it: arrays of meshes, materials, texels and sky."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
import copy
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.view.maps import RASTER_PX, linear, mean_color, pyramid
from esg.view.pieces import Movers, Part
from esg.view.skies import AIRS, blurred_maps, haze_of, sky_map
from esg.view.surroundings import GROUND, Sky, Surroundings, thing_of

CLEAR = 0.97
"""What is less opaque lets the sun through."""
BOUNCE = (0.16, 0.15, 0.14)
"""Light from below where there is no ground."""
WORLD = -1


@dataclass
class Bundle:
    """All parts that move as one and all cast shadows or none, as one mesh.

    Args:
        mover: Index among `Movers`; -1 for the world.
        clear: Whether it casts no shadow: one sees through it, or it lies flat on the ground.
        vertices: Shape [n, 3] [m].
        faces: Shape [f, 3].
        normals: At the corners of faces, 0 for a flat face, shape [f, 3, 3].
        uvs: At the corners of faces, shape [f, 3, 2].
        materials: Of the faces, shape [f].
    """

    mover: int
    clear: bool
    vertices: NDArray[np.float32]
    faces: NDArray[np.int32]
    normals: NDArray[np.float32]
    uvs: NDArray[np.float32]
    materials: NDArray[np.int32]


def surface(part: Part) -> Look:
    """The look of a part; a plain one in its colour if it names none."""
    return part.look or Look("", part.color)


def bundles(parts: Sequence[Part], movers: Movers) -> tuple[list[Bundle], list[Look]]:
    """One mesh for everything that moves as one, and the looks that its faces count.

    Every mesh costs the tracer a search of its own; a car of forty pieces is five.
    """
    looks: dict[Look, int] = {}
    groups: dict[tuple[int, bool], list[Part]] = {}
    for part in parts:
        if len(part.faces):
            flat = part.body == WORLD and thing_of(part) == GROUND
            clear = flat or surface(part).alpha < CLEAR
            groups.setdefault((movers.of(part), clear), []).append(part)
    out: list[Bundle] = []
    for (mover, clear), members in sorted(groups.items(), key=lambda g: g[0]):
        starts = np.cumsum([0, *(len(p.vertices) for p in members[:-1])])
        kinds = [looks.setdefault(surface(p), len(looks)) for p in members]
        out.append(
            Bundle(
                mover,
                clear,
                np.concatenate([p.vertices for p in members]).astype(np.float32),
                np.concatenate([p.faces + s for p, s in zip(members, starts, strict=True)]).astype(
                    np.int32
                ),
                np.concatenate([_corners(p.normals, p.faces, 3) for p in members]),
                np.concatenate([_corners(p.uvs, p.faces, 2) for p in members]),
                np.repeat(kinds, [len(p.faces) for p in members]).astype(np.int32),
            )
        )
    return out, list(looks)


def _corners(values: Any, faces: Any, width: int) -> NDArray[np.float32]:
    if values is None:
        return np.zeros((len(faces), 3, width), np.float32)
    return np.asarray(values, np.float32)[faces]


class Stage:
    """Meshes, light and sky of W worlds on one device.

    Args:
        parts: Meshes of one world.
        n_bodies: Number of bodies that `Part.body` refers to.
        worlds: Number of worlds W.
        surroundings: Sky and ground; its own parts are not looked at. None: no ground, plain sky.
        device: cpu or cuda:N.
        seed: Of the clouds.
    """

    def __init__(
        self,
        parts: Iterable[Part],
        n_bodies: int,
        worlds: int,
        surroundings: Surroundings | None,
        *,
        device: str = "cpu",
        seed: int = 0,
    ) -> None:
        from esg.engines.newton import quiet_warp

        self._wp = quiet_warp()
        from esg.view.tracer import kernels

        self._kernels, self.device, self.worlds = kernels, device, worlds
        parts = list(parts)
        self.movers = Movers(parts, n_bodies)
        made, looks = bundles(parts, self.movers)
        self.scene = kernels.Scene()
        self._keep: list[Any] = []
        ground = surroundings.ground if surroundings else None
        self._materials([*looks, *([ground] if ground else [])], ground)
        self._meshes(made)
        self._lamps(surroundings.sky if surroundings else Sky(), ground, seed)

    def twin(self) -> Stage:
        """The same scene for poses of its own; meshes, materials and sky are shared."""
        other = copy.copy(self)
        other.scene = self._kernels.Scene()
        for name in self._kernels.Scene.vars:
            setattr(other.scene, name, getattr(self.scene, name))
        other._unposed(self.scene.instances)
        return other

    @property
    def tools(self) -> tuple[Any, Any, Any]:
        """Warp, the kernels' module, and the scene to give them."""
        return self._wp, self._kernels, self.scene

    def _array(self, values: Any, dtype: Any) -> Any:
        return self._wp.array(values, dtype=dtype, device=self.device)

    def _materials(self, looks: Sequence[Look], ground: Look | None) -> None:
        wp, scene = self._wp, self.scene
        names = list(dict.fromkeys(k.texture for k in looks if k.texture))
        texels = [np.concatenate([v.reshape(-1, 4) for v in pyramid(n)]) for n in names]
        starts = dict(zip(names, np.cumsum([0, *(len(t) for t in texels)]), strict=False))
        rows: list[Any] = []
        for look in looks:
            row = self._kernels.Material()
            row.color = wp.vec3(*(float(c) for c in linear(look.color)))
            row.roughness, row.metalness = max(look.roughness, 0.04), look.metalness
            row.alpha = 1.0 if look.alpha >= CLEAR else look.alpha
            row.glow = look.glow
            row.first = int(starts[look.texture]) if look.texture else -1
            row.size = RASTER_PX
            row.texel_m = look.tile_m / RASTER_PX
            rows.append(row)
        scene.has_ground = int(ground is not None)
        if ground is not None:
            scene.ground = rows[-1]
            scene.ground_tile = ground.tile_m
        blank = [np.zeros((1, 4), np.float32)]
        scene.pyramid = self._array(np.concatenate(texels or blank), wp.vec4)
        scene.material = self._array(rows or [self._kernels.Material()], self._kernels.Material)

    def _meshes(self, made: Sequence[Bundle]) -> None:
        wp, scene, worlds = self._wp, self.scene, self.worlds
        firsts = np.cumsum([0, *(len(b.faces) for b in made)]).tolist()
        meshes = [
            wp.Mesh(
                self._array(b.vertices, wp.vec3),
                self._array(b.faces.ravel(), wp.int32),
                bvh_constructor="sah",  # made once and searched often, on a GPU, too
                bvh_leaf_size=2,
            )
            for b in made
        ]
        self._keep += meshes
        moving = [k for k, b in enumerate(made) if b.mover >= 0]
        for k, b in enumerate(made):
            if b.mover == WORLD and b.clear:
                scene.fixed_clear_mesh, scene.fixed_clear_first = meshes[k].id, firsts[k]
            elif b.mover == WORLD:
                scene.fixed_mesh, scene.fixed_first = meshes[k].id, firsts[k]
        everything = [np.zeros((1, 3, 3), np.float32), np.zeros((1, 3, 2), np.float32)]
        if made:
            everything = [
                np.concatenate([b.normals for b in made]),
                np.concatenate([b.uvs for b in made]),
            ]
        scene.corner_normal = self._array(everything[0].reshape(-1, 3), wp.vec3)
        scene.corner_uv = self._array(everything[1].reshape(-1, 2), wp.vec2)
        materials = np.concatenate([b.materials for b in made]) if made else np.zeros(1, np.int32)
        scene.face_material = self._array(materials, wp.int32)
        count = worlds * len(moving)
        scene.instances = count
        own = [made[k] for k in moving]
        scene.mesh = self._array(
            np.array([meshes[k].id for k in moving] * worlds, np.uint64), wp.uint64
        )
        scene.clear = self._array(np.array([b.clear for b in own] * worlds, np.int32), wp.int32)
        scene.face_first = self._array(
            np.array([firsts[k] for k in moving] * worlds, np.int32), wp.int32
        )
        movers = np.array([b.mover for b in own], np.int32)
        scene.owner = self._array(np.tile(movers, worlds), wp.int32)
        world = np.repeat(np.arange(worlds, dtype=np.int32), len(own))
        self._mover = self._array(world * len(self.movers) + np.tile(movers, worlds), wp.int32)
        self._groups = self._array(world, wp.int32)
        low = np.array([b.vertices.min(axis=0) for b in own] * worlds, np.float32)
        high = np.array([b.vertices.max(axis=0) for b in own] * worlds, np.float32)
        self._low = self._array(low.reshape(-1, 3), wp.vec3)
        self._high = self._array(high.reshape(-1, 3), wp.vec3)
        self._unposed(count)

    def _unposed(self, count: int) -> None:
        """Room for the poses and boxes of so many instances."""
        wp, scene = self._wp, self.scene
        scene.pose = wp.zeros(count, dtype=wp.transform, device=self.device)
        self._lower = wp.zeros(count, dtype=wp.vec3, device=self.device)
        self._upper = wp.zeros(count, dtype=wp.vec3, device=self.device)
        self._bvh, scene.bvh = None, 0

    def _lamps(self, sky: Sky, ground: Look | None, seed: int) -> None:
        wp, scene, air = self._wp, self.scene, AIRS[sky.kind]
        bounce = np.array(BOUNCE)
        if ground is not None:
            below = mean_color(ground.color, ground.texture)
            light = np.array(sky.sun_rgb) * max(0.0, sky.sun[2]) + np.array(sky.ambient_rgb)
            bounce = 0.8 * below * light
            scene.ground_mean = wp.vec3(*(float(c) for c in below))
        scene.sun = wp.vec3(*(float(c) for c in sky.sun))
        scene.sun_rgb = wp.vec3(*sky.sun_rgb)
        scene.sun_radius, scene.sun_reach = air.sun_radius, air.reach_m
        scene.sky_rgb = wp.vec3(*sky.ambient_rgb)
        red, green, blue = (float(c) for c in bounce)
        scene.bounce_rgb = wp.vec3(red, green, blue)
        scene.haze_m = haze_of(sky)
        seen = sky_map(sky, seed)
        scene.haze_rgb = wp.vec3(*(float(c) for c in seen[0].mean(axis=0)))
        scene.sky = self._array(seen, wp.vec3)
        scene.blurred = self._array(blurred_maps(sky, seed, (red, green, blue)), wp.vec3)

    def turn_sun(self, toward: tuple[float, float, float]) -> None:
        """Puts the sun elsewhere; the picture of the sky stays.

        Args:
            toward: Unit vector toward the sun.
        """
        self.scene.sun = self._wp.vec3(*toward)

    def pose(
        self, position: NDArray[Any], quaternion: NDArray[Any], angles: NDArray[Any] | None = None
    ) -> None:
        """Moves all bodies.

        Args:
            position: Body origins [m], shape [W, B, 3].
            quaternion: (x, y, z, w), shape [W, B, 4].
            angles: Of the wheels of a scene [rad], shape [W, wheels].
        """
        wp, scene = self._wp, self.scene
        if not scene.instances:
            return
        moved = self.movers.poses(position, quaternion, angles)
        poses = np.concatenate(moved, axis=-1).reshape(-1, 7).astype(np.float32)
        wp.launch(
            self._kernels.place,
            dim=scene.instances,
            inputs=[
                self._array(np.ascontiguousarray(poses), wp.transform),
                self._mover,
                self._low,
                self._high,
                scene.pose,
                self._lower,
                self._upper,
            ],
            device=self.device,
            block_dim=self._kernels.THREADS,
        )
        if self._bvh is None:
            self._bvh = wp.Bvh(self._lower, self._upper, groups=self._groups)
            scene.bvh = self._bvh.id
        else:
            self._bvh.refit()
