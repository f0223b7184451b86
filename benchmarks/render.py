"""Frames a second of the batch renderer: W worlds of one scene, T frames each, at one size.

    python -m benchmarks.render --worlds 64 --frames 240 --size 256 --device cuda:0 --out h200.json

The scene has a car, a bin, a picnic table and a street (as in the paper's sixth scene), every world
in another pose at every frame. Reported for colour (4 rays a pixel, shadows), for exact channels
(depth, normals, masks; one ray) and for both, without and with copying the pictures to the host.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
import platform
import time
from typing import Any

import numpy as np

from esg.view.camera import Camera
from esg.view.pieces import Part
from esg.view.worlds import WorldRenderer

CASES = {
    "rgb": {"rgb": True, "exact": False},
    "exact": {"rgb": False, "exact": True},
    "rgb and exact": {"rgb": True, "exact": True},
}


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
    options = CASES[case]

    def step(k: int) -> None:
        renderer.pose(*script[k % len(script)])
        renderer.draw(cameras, **options)
        if copy:
            renderer.read(rgb=options["rgb"])

    step(0)  # compiles
    wp.synchronize()
    start = time.perf_counter()
    for k in range(frames):
        step(k)
    wp.synchronize()
    return renderer.worlds * frames / (time.perf_counter() - start)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--worlds", type=int, default=64)
    parser.add_argument("--frames", type=int, default=240)
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--out", type=Path)
    args = parser.parse_args()
    from esg.engines.newton import quiet_warp

    wp = quiet_warp()
    parts, bodies = street()
    start = time.perf_counter()
    size = (args.size, args.size)
    renderer = WorldRenderer(parts, bodies, args.worlds, size, device=args.device)
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
    text = json.dumps(result, indent=2)
    print(text)
    if args.out:
        args.out.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
