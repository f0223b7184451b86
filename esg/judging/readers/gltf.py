"""GLB: nodes that an animation moves, and what stands beside them.

A thing is the topmost node with a mesh below it that is animated, or none of whose descendants is;
what turns inside it (a wheel) is part of it. Shapes are hulls of the pieces of its meshes, unless
the scene's `extras` carry a manifest (`esg export --to glb`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import math
from pathlib import Path
from typing import Any

import numpy as np

from esg.assets.gltf.parts import matrix_of, triangles_of, values_of
from esg.engines.scene import Shape
from esg.judging.forms import MOST_PIECES, of_mesh, of_points
from esg.judging.readers.carried import manifest_of
from esg.judging.recording import Faults, Floats, Frame, Recording, Thing
from esg.strangers.gltf import MOST_BYTES, read_glb
from esg.units import quat_multiply, quat_rotate
from esg.untyped import is_object

RATE_HZ = 60.0
"""Of the frames that are made of key frames farther apart than `COARSE_S`."""
COARSE_S = 1.0 / 20.0
MOST_KEYS = 1_000_000
Item = dict[str, Any]
_TURNED = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""Our axes from glTF's."""


@dataclass(frozen=True)
class _Channel:
    """Key frames of one property of a node.

    Args:
        time: [s], shape [K].
        values: Shape [K, width].
        steps: Whether a value holds until the next.
    """

    time: Floats
    values: Floats
    steps: bool


@dataclass(frozen=True)
class _File:
    """A document that holds together.

    Args:
        document, binary: Of the GLB.
        parents: Index of the node above each.
        channels: By node and path.
    """

    document: Item
    binary: bytes
    parents: dict[int, int]
    channels: dict[tuple[int, str], _Channel]

    @property
    def nodes(self) -> list[Item]:
        return self.document.get("nodes", [])

    def has_mesh(self, node: int) -> bool:
        return "mesh" in self.nodes[node]

    def moves(self, node: int) -> bool:
        return any((node, path) in self.channels for path in ("translation", "rotation"))


def read_glb_file(path: Path, frame: Frame, faults: Faults) -> Recording:
    """Reads `.glb`; glTF states its axes and units, so `frame` does not matter."""
    if path.stat().st_size > MOST_BYTES:
        raise faults.fail(f"it has more than {MOST_BYTES} bytes")
    try:
        document, binary = read_glb(path.read_bytes())
        parents = {
            child: k
            for k, node in enumerate(document.get("nodes", []))
            for child in node.get("children", [])
        }
        file = _File(document, binary, parents, _channels(document, binary))
        return _recording(file, faults)
    except (ValueError, KeyError, IndexError, TypeError, OSError) as error:
        raise faults.fail(f"it is no GLB that can be read ({str(error)[:120]})") from None


def _recording(file: _File, faults: Faults) -> Recording:
    nodes = _things(file)
    if not nodes:
        raise faults.fail("no node of it has a mesh")
    time = _frames(file, nodes)
    poses = [_poses(file, node, time) for node in nodes]
    manifest = _carried(file, faults)
    names = _names(file, nodes)
    if manifest is not None:
        things = [Thing(name) for name in names]
        notes = ()
    else:
        things = [_thing(file, node, name) for node, name in zip(nodes, names, strict=True)]
        notes = ("shapes are hulls of the pieces of its meshes",)
    return Recording(
        "glb",
        time,
        np.stack([p for p, _ in poses], axis=1),
        np.stack([q for _, q in poses], axis=1),
        tuple(things),
        manifest=manifest,
        notes=notes,
    )


def _carried(file: _File, faults: Faults) -> Any:
    scenes = file.document.get("scenes", [])
    if not scenes:
        return None
    extras = scenes[file.document.get("scene", 0)].get("extras")
    carried = extras.get("manifest") if is_object(extras) else None
    return None if carried is None else manifest_of(carried, faults)


def _channels(document: Item, binary: bytes) -> dict[tuple[int, str], _Channel]:
    """Channels of the first animation that move or turn nodes."""
    out: dict[tuple[int, str], _Channel] = {}
    animations = document.get("animations", [])
    for channel in animations[0].get("channels", []) if animations else []:
        target = channel.get("target", {})
        path, node = target.get("path"), target.get("node")
        if path not in ("translation", "rotation") or not isinstance(node, int):
            continue
        sampler = animations[0]["samplers"][channel["sampler"]]
        times = values_of(document, binary, sampler["input"], 1).ravel()
        values = values_of(document, binary, sampler["output"], 3 if path == "translation" else 4)
        kind = sampler.get("interpolation", "LINEAR")
        if kind == "CUBICSPLINE":
            values = values[1::3]  # between key frames it is taken for a line
        if len(times) > MOST_KEYS or len(times) != len(values) or not len(times):
            raise ValueError(
                f"a channel of node {node} has {len(times)} times, {len(values)} values"
            )
        if not np.isfinite(times).all() or (np.diff(times) <= 0.0).any():
            raise ValueError(f"the times of a channel of node {node} do not rise")
        out[node, path] = _Channel(times, values, kind == "STEP")
    return out


def _things(file: _File) -> list[int]:
    """Nodes that are things, in the order of the scene."""
    scenes = file.document.get("scenes", [])
    roots = [k for k in range(len(file.nodes)) if k not in file.parents]
    if scenes:
        roots = scenes[file.document.get("scene", 0)].get("nodes", [])
    meshes, moving = _below(file, file.has_mesh), _below(file, file.moves)
    out: list[int] = []
    waiting = list(reversed(roots))
    while waiting:
        node = waiting.pop()
        if node not in meshes:
            continue
        children = file.nodes[node].get("children", [])
        within = any(child in moving for child in children)
        if file.moves(node) or not within or "mesh" in file.nodes[node]:
            out.append(node)
        else:
            waiting += reversed(children)
    return out


def _below(file: _File, holds: Callable[[int], bool]) -> set[int]:
    """Nodes that hold something, or have a descendant that does."""
    out: set[int] = set()
    for k in range(len(file.nodes)):
        node: int | None = k if holds(k) else None
        while node is not None and node not in out:
            out.add(node)
            node = file.parents.get(node)
    return out


def _names(file: _File, nodes: list[int]) -> list[str]:
    """Names of things: of their nodes, numbered where several are called the same."""
    seen: dict[str, int] = {}
    out: list[str] = []
    for node in nodes:
        name = str(file.nodes[node].get("name", "")) or f"node {node}"
        seen[name] = seen.get(name, 0) + 1
        out.append(name if seen[name] == 1 else f"{name} {seen[name]}")
    return out


def _frames(file: _File, nodes: list[int]) -> Floats:
    """Times of the frames [s]: of the things' key frames, denser where they are far apart."""
    chains = {above for node in nodes for above in _chain(file, node)}
    keys = [c.time for (node, _), c in file.channels.items() if node in chains]
    if not keys:
        raise ValueError("no animation moves anything in it")
    time = np.unique(np.round(np.concatenate(keys), 7))
    if len(time) > 1 and float(np.median(np.diff(time))) <= COARSE_S:
        return time
    count = math.floor(float(time[-1] - time[0]) * RATE_HZ) + 1
    return time[0] + np.arange(min(count, MOST_KEYS)) / RATE_HZ


def _chain(file: _File, node: int) -> list[int]:
    """A node and those above it, from the top."""
    out = [node]
    while (above := file.parents.get(out[-1])) is not None:
        out.append(above)
    return out[::-1]


def _poses(file: _File, node: int, time: Floats) -> tuple[Floats, Floats]:
    """Poses of a node in our axes, shapes [T, 3] and [T, 4]; scales above it move it only."""
    at = np.zeros((len(time), 3))
    turn = np.tile([0.0, 0.0, 0.0, 1.0], (len(time), 1))
    scale = np.ones(3)
    for link in _chain(file, node):
        own_at, own_turn, own_scale = _local(file, link, time)
        at = at + quat_rotate(turn, scale * own_at)
        turn = quat_multiply(turn, own_turn)
        scale = scale * own_scale
    x, y, z, w = np.moveaxis(turn, -1, 0)
    return at @ _TURNED.T, np.stack([x, -z, y, w], axis=-1)


def _local(file: _File, node: int, time: Floats) -> tuple[Floats, Floats, Floats]:
    from scipy.spatial.transform import Rotation

    matrix = matrix_of(file.nodes[node])
    scale = np.linalg.norm(matrix[:3, :3], axis=0)
    at = np.tile(matrix[:3, 3], (len(time), 1))
    turn = np.array([0.0, 0.0, 0.0, 1.0])
    if (scale > 1e-9).all():
        turn = Rotation.from_matrix(matrix[:3, :3] / scale).as_quat()
    elif "rotation" in file.nodes[node]:
        turn = np.array(file.nodes[node]["rotation"], float)
    turns = np.tile(turn, (len(time), 1))
    if (node, "translation") in file.channels:
        at = _sampled(file.channels[node, "translation"], time)
    if (node, "rotation") in file.channels:
        turns = _sampled(file.channels[node, "rotation"], time)
        turns = turns / np.maximum(np.linalg.norm(turns, axis=1, keepdims=True), 1e-12)
    return at, turns, np.where(scale > 1e-9, scale, 1.0)


def _sampled(channel: _Channel, time: Floats) -> Floats:
    """Values at other times; quaternions along the shorter way."""
    values = channel.values
    if values.shape[1] == 4 and len(values) > 1:
        flips = np.sign(np.einsum("ki,ki->k", values[1:], values[:-1]))
        flips[flips == 0] = 1
        values = values * np.concatenate([[1.0], np.cumprod(flips)])[:, None]
    if channel.steps:
        index = np.clip(np.searchsorted(channel.time, time + 1e-7, side="right") - 1, 0, None)
        return values[index]
    return np.stack([np.interp(time, channel.time, v) for v in values.T], axis=1)


def _thing(file: _File, node: int, name: str) -> Thing:
    """A thing by its meshes, in the frame of its node and our axes."""
    shapes: list[Shape] = []
    extras = file.nodes[node].get("extras")
    said: Item = extras if is_object(extras) else {}
    scale = np.ones(3)
    for link in _chain(file, node)[:-1]:
        scale = scale * np.linalg.norm(matrix_of(file.nodes[link])[:3, :3], axis=0)
    own = np.linalg.norm(matrix_of(file.nodes[node])[:3, :3], axis=0)
    base = np.diag([*(scale * np.where(own > 1e-9, own, 1.0)), 1.0])
    waiting = [(node, base)]
    points: list[Floats] = []
    while waiting:
        at, matrix = waiting.pop()
        for vertices, faces in _primitives(file, at):
            placed = (vertices @ matrix[:3, :3].T + matrix[:3, 3]) @ _TURNED.T
            points.append(placed)
            shapes += of_mesh(placed, faces)
        for child in file.nodes[at].get("children", []):
            waiting.append((child, matrix @ matrix_of(file.nodes[child])))
    if len(shapes) > MOST_PIECES:
        shapes = list(of_points(np.concatenate(points)))
    mass = said.get("mass_kg")
    return Thing(
        name,
        tuple(shapes),
        mass=float(mass) if isinstance(mass, int | float) and mass > 0 else None,
        label=str(said.get("label", "")),
        category=str(said.get("category", "")),
        drawn=True,
    )


def _primitives(file: _File, node: int) -> list[tuple[Floats, Any]]:
    index = file.nodes[node].get("mesh")
    if index is None:
        return []
    out: list[tuple[Floats, Any]] = []
    for item in file.document["meshes"][index]["primitives"]:
        mode = item.get("mode", 4)
        if "POSITION" not in item["attributes"] or mode not in (4, 5, 6):
            continue
        points = values_of(file.document, file.binary, item["attributes"]["POSITION"], 3)
        corners = np.arange(len(points))
        if "indices" in item:
            held = values_of(file.document, file.binary, item["indices"], 1)
            corners = held.astype(np.int64).ravel()
        if corners.size and corners.max() >= len(points):
            raise ValueError(f"a mesh names vertex {corners.max()} of {len(points)}")
        out.append((points, triangles_of(corners, mode)))
    return out
