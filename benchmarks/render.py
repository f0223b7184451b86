"""Frames a second of the batch renderer: W worlds of one scene, T frames each, at one size.

    python -m benchmarks.render --worlds 64 --frames 240 --size 256 --device cuda:0 --out h200.json
    python -m benchmarks.render --path 32,64 --size 512 --device cuda:0 --frames 4

With `--path`, seconds a frame of the path tracer at so many rays a pixel instead, one world.

The scene has a car, a bin, a picnic table and a street (as in the paper's sixth scene), every world
in another pose at every frame. It stands on a textured
ground under a sky with clouds. Reported for exact channels (depth, normals, masks) and for these
with colour (textures, sky, soft shadows), without and with copying the pictures to the host.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
import platform
import time
from typing import Any

import numpy as np

from esg.assets.materials import look_of
from esg.view.camera import Camera
from esg.view.pieces import Part
from esg.view.surroundings import Sky, Surroundings
from esg.view.worlds import WorldRenderer

SUN, HORIZON = (-0.4, 0.45, 0.8), (0.62, 0.75, 0.88)
CASES = {"exact": False, "rgb and exact": True}
"""Whether colours are drawn: the exact channels always are."""


def street() -> tuple[list[Part], int]:
    """Meshes of three bodies on a street, from the asset library, and how many bodies there are."""
    from esg.assets import build_mesh, resolve
    from esg.draft import draft
    from esg.units import CM_PER_M
    from esg.view.parts import mesh_parts

    doc = resolve(draft("A car hits a trash bin, which hits a picnic table on the road."), seed=0)
    parts: list[Part] = []
    body = 0
    for node in doc.spatial_relation_graph.nodes.values():
        config = doc.asset_configurations[node.asset_id]
        moves = bool(config.proxies) and not node.is_structural
        for piece in mesh_parts(build_mesh(config), config.color_rgb):
            mover, vertices = body if moves else -1, piece.vertices / CM_PER_M
            parts.append(
                Part(
                    mover,
                    vertices,
                    piece.faces,
                    piece.color,
                    look=piece.look,
                    normals=piece.normals,
                    uvs=piece.uvs,
                    name=piece.name,
                )
            )
        body += moves
    return parts, body


def poses(worlds: int, bodies: int, rng: np.random.Generator) -> tuple[Any, Any]:
    """Bodies beside each other, each world and frame a little different."""
    position = np.zeros((worlds, bodies, 3))
    position[..., 0] = 3.0 * np.arange(bodies) + rng.uniform(-1, 1, (worlds, bodies))
    position[..., 1] = rng.uniform(-1, 1, (worlds, bodies))
    yaw = rng.uniform(-np.pi, np.pi, (worlds, bodies)) / 2
    turn = np.zeros((worlds, bodies, 4))
    turn[..., 2], turn[..., 3] = np.sin(yaw), np.cos(yaw)
    return position, turn


def measure(renderer: WorldRenderer, bodies: int, frames: int, case: str, copy: bool) -> float:
    """Frames a second of all worlds together."""
    import warp as wp

    rng = np.random.default_rng(0)
    middle = 1.5 * (bodies - 1)
    cameras = [Camera((middle, 11.0, 4.0), (middle, 0.0, 0.6))] * renderer.worlds
    script = [poses(renderer.worlds, bodies, rng) for _ in range(min(frames, 24))]
    rgb = CASES[case]

    def step(k: int) -> None:
        renderer.pose(*script[k % len(script)])
        renderer.draw(cameras, rgb=rgb)
        if copy:
            renderer.read(rgb=rgb)

    step(0)  # compiles
    wp.synchronize()
    start = time.perf_counter()
    for k in range(frames):
        step(k)
    wp.synchronize()
    return renderer.worlds * frames / (time.perf_counter() - start)


def place() -> Surroundings:
    """Grass under a clear sky."""
    sky = Sky("clear", SUN, (0.95, 0.9, 0.8), (0.3, 0.36, 0.46), (0.16, 0.34, 0.68), HORIZON)
    return Surroundings(sky, look_of("grass"))


def measure_path(samples: int, size: int, frames: int, device: str) -> dict[str, float]:
    """Wall and processor seconds of a frame of the path tracer, after the first."""
    from esg.view.renderers.kinds import kind_named
    from esg.view.renderers.records import Poses, Quality, Scenery

    parts, bodies = street()
    rng = np.random.default_rng(0)
    scenery = Scenery(tuple(parts), bodies, place())
    drawer = kind_named("path").load(scenery, Quality((size, size), samples, device=device))
    middle = 1.5 * (bodies - 1)
    camera = Camera((middle, 11.0, 4.0), (middle, 0.0, 0.6))
    wall = cpu = 0.0
    for k in range(frames + 1):
        position, turn = poses(1, bodies, rng)
        start, used = time.perf_counter(), time.process_time()
        drawer.draw(Poses(position[:, None], turn[:, None]), [camera])
        if k:  # the first compiles
            wall += time.perf_counter() - start
            cpu += time.process_time() - used
    return {"wall_s": round(wall / frames, 2), "cpu_s": round(cpu / frames, 2)}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--worlds", type=int, default=64)
    parser.add_argument("--frames", type=int, default=240)
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--path", default="", help="rays a pixel, with commas")
    parser.add_argument("--out", type=Path)
    args = parser.parse_args()
    if args.path:
        result = {"device": args.device, "size_px": args.size, "path": {}}
        for samples in map(int, args.path.split(",")):
            seconds = measure_path(samples, args.size, args.frames, args.device)
            result["path"][str(samples)] = seconds
        finish(result, args.out)
        return
    from esg.engines.newton import quiet_warp

    wp = quiet_warp()
    parts, bodies = street()
    start = time.perf_counter()
    size = (args.size, args.size)
    renderer = WorldRenderer(
        parts, bodies, args.worlds, size, device=args.device, surroundings=place()
    )
    result: dict[str, Any] = {
        "device": str(wp.get_device(args.device).name) or platform.processor(),
        "worlds": args.worlds,
        "frames": args.frames,
        "size_px": args.size,
        "triangles_per_world": int(sum(len(p.faces) for p in parts)),
        "build_s": round(time.perf_counter() - start, 2),
        "frames_per_s": {},
    }
    for case in CASES:
        for copy in (False, True):
            name = f"{case}, copied to the host" if copy else case
            rate = measure(renderer, bodies, args.frames, case, copy)
            result["frames_per_s"][name] = round(rate, 1)
    finish(result, args.out)


def finish(result: dict[str, Any], out: Path | None) -> None:
    """Prints a result and writes it where that is asked for."""
    text = json.dumps(result, indent=2)
    print(text)
    if out:
        out.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
