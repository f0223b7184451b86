"""The paper's adapter: a program's primitives become rigid bodies, its trail a launch.

Supp. Mat., "Scene Language -> UE adapter": (i) run the program in `exposed` mode, group primitives
into semantic rigid bodies, map them by (X, Y, Z)_UE = 100 (-z, x, y) cm; (ii) a linear launch
velocity from the last two centres of the kinematic trail at a reference speed of the scene's type,
no angular velocity. Our frame is Unreal's with Y mirrored. What the paper leaves open:

- **bodies**: what one registered call made and hangs together. A call whose pieces lie apart is
  looked into, and a call that made the whole scene always is. Flat things at the bottom that are as
  wide as half of the scene are its ground, which is ours.
- **where they start**: in the first frame, the lowest point of all on the ground.
- **who is launched**: what moves from the first frame to the second. What sets out later was hit.
- **reference speeds**: `REFERENCE_MPS`; the paper prints none.
- **masses**: 500 kg/m3 times the volume of the primitives, as the judge gives what has none.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, replace
import itertools
import json
from pathlib import Path
import subprocess
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.rivals.scene_language.language import bounds
from esg.engines.program import Program, SetVelocity
from esg.engines.scene import Body, Shape, SimScene
from esg.judging.bodies import played
from esg.judging.forms import of_extents
from esg.judging.recording import Faults, Recording, Thing

Floats = NDArray[np.float64]
Primitive = dict[str, Any]
AXES = np.array([[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""Our (X, Y, Z) = (-z, -x, y): Unreal's (-z, x, y) with Y mirrored."""
REFERENCE_MPS = {"car": 10.0, "jeep": 10.0, "ball": 5.0}
OTHER_MPS = 5.0
"""Launch speed by a word of the body's name; ours."""
TOUCH_M = 0.02
FLAT, WIDE = 0.05, 0.5
"""Ground: height over width, and its width over the scene's."""
DURATION_S = 10.0
SECONDS = 60


class ProgramFailed(Exception):
    """A program that made no scene."""


@dataclass(frozen=True)
class Part:
    """One rigid body in one frame.

    Args:
        name: Of the function that made it, numbered.
        primitives: Its own, in Scene Language's frame.
        doc: Docstring of the function.
    """

    name: str
    primitives: tuple[Primitive, ...]
    doc: str = ""

    @property
    def center(self) -> Floats:
        """Middle of its box in our frame [m]."""
        low, high = bounds(list(self.primitives))
        return AXES @ ((low + high) / 2)


def run_program(program: str) -> dict[str, Any]:
    """Frames of a program, run in a child that may only compute.

    Raises:
        ProgramFailed: If it fails, takes too long or makes nothing.
    """
    try:
        done = subprocess.run(
            [sys.executable, "-m", "benchmarks.rivals.scene_language.child"],
            input=program, capture_output=True, text=True, timeout=SECONDS, check=False,
            cwd=Path(__file__).parents[3], env={"PYTHONPATH": ".", "OMP_NUM_THREADS": "1",
            "OPENBLAS_NUM_THREADS": "1"},
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise ProgramFailed(f"it ran longer than {SECONDS} s") from None
    try:
        answer = json.loads(done.stdout)
    except ValueError:
        said = (done.stderr.strip().splitlines() or ["nothing"])[-1]
        raise ProgramFailed(f"it was stopped ({done.returncode}): {said[:200]}") from None
    if "error" in answer:
        raise ProgramFailed(answer["error"])
    if not answer["frames"] or not answer["frames"][0]:
        raise ProgramFailed("it draws nothing")
    for frame in answer["frames"]:
        for item in frame:
            item["matrix"] = np.array(item["matrix"], float)
            item["path"] = [(str(name), int(call)) for name, call in item["stack"]]
            if not np.isfinite(item["matrix"]).all():
                raise ProgramFailed("a primitive is at no finite place")
    return answer


def parts_of(frame: list[Primitive], docs: dict[str, str]) -> list[Part]:
    """The rigid bodies of a frame."""
    solid = _without_ground(frame)
    found = _split(solid, 0)
    counts: dict[str, int] = defaultdict(int)
    out: list[Part] = []
    for name, items in found:
        counts[name] += 1
        out.append(Part(f"{name}_{counts[name]}", tuple(items), docs.get(name, "")))
    return out


def _without_ground(frame: list[Primitive]) -> list[Primitive]:
    low, high = bounds(frame)
    extent = float((high - low)[[0, 2]].max())
    out: list[Primitive] = []
    for item in frame:
        base, top = bounds([item])
        wide = float((top - base)[[0, 2]].max())
        flat = float(top[1] - base[1]) <= FLAT * wide
        at_bottom = base[1] <= low[1] + FLAT * extent
        if not (flat and wide >= WIDE * extent and at_bottom and len(frame) > 1):
            out.append(item)
    return out


def _split(items: list[Primitive], depth: int) -> list[tuple[str, list[Primitive]]]:
    """Bodies among primitives that share the calls above a depth, each with its function's name."""
    calls: dict[Any, list[Primitive]] = defaultdict(list)
    for k, item in enumerate(items):
        calls[item["path"][depth] if depth < len(item["path"]) else ("", k)].append(item)
    out: list[tuple[str, list[Primitive]]] = []
    whole = len(calls) == 1 and depth == 0
    for (name, _), own in calls.items():
        clusters = _clusters(own)
        deeper = all(len(item["path"]) > depth + 1 for item in own)
        if deeper and (whole or len(clusters) > 1):
            out += _split(own, depth + 1)
        else:
            above = own[0]["path"][depth - 1][0] if depth else "thing"
            out += [(name or above, cluster) for cluster in clusters]
    return out


def _clusters(items: list[Primitive]) -> list[list[Primitive]]:
    """Primitives whose boxes touch, directly or over others."""
    boxes = [bounds([item]) for item in items]
    left, out = list(range(len(items))), list[list[Primitive]]()
    while left:
        group, waiting = [], [left.pop(0)]
        while waiting:
            k = waiting.pop()
            group.append(k)
            low, high = boxes[k]
            gaps = [np.maximum(low - boxes[j][1], boxes[j][0] - high) for j in left]
            near = [j for j, gap in zip(left, gaps, strict=True) if (gap <= TOUCH_M).all()]
            left = [j for j in left if j not in near]
            waiting += near
        out.append([items[k] for k in sorted(group)])
    return out


def shape_of(item: Primitive) -> Shape:
    """A primitive as a collision shape in our frame [m]; a sheared one by its axes' lengths."""
    from scipy.spatial.transform import Rotation

    turned = AXES @ item["matrix"][:3, :3]
    sizes = np.maximum(np.linalg.norm(turned, axis=0), 1e-3)
    left, _, right = np.linalg.svd(turned / sizes)
    turn = left @ right
    if np.linalg.det(turn) < 0.0:
        turn = turn @ np.diag([-1.0, 1.0, 1.0])
    kind = {"cube": "box"}.get(item["kind"], item["kind"])
    (shape,) = of_extents(kind, sizes.tolist())
    x, y, z, w = (float(v) for v in Rotation.from_matrix(turn).as_quat())
    at = AXES @ item["matrix"][:3, 3]
    return replace(
        shape, position=(float(at[0]), float(at[1]), float(at[2])), quaternion=(x, y, z, w)
    )


def launches(frames: list[list[Part]]) -> dict[str, Floats]:
    """Directions of launch by body: along the last two centres of its trail.

    Args:
        frames: Bodies by frame.
    """
    trails: dict[str, list[Floats]] = defaultdict(list)
    for frame in frames:
        for part in frame:
            trails[part.name].append(part.center)
    out: dict[str, Floats] = {}
    for name, trail in trails.items():
        if len(trail) < 2 or not np.linalg.norm(trail[1] - trail[0]) > 1e-3:
            continue
        steps = [b - a for a, b in itertools.pairwise(trail)]
        moving = [s for s in steps if np.linalg.norm(s) > 1e-3]
        out[name] = moving[-1] / np.linalg.norm(moving[-1])
    return out


def speed_of(name: str) -> float:
    """Reference speed of a body [m/s]."""
    words = name.lower().split("_")
    return next((v for word, v in REFERENCE_MPS.items() if word in words), OTHER_MPS)


def scene_of(answer: dict[str, Any], scene_id: str) -> tuple[SimScene, Program]:
    """Physical scene and program of what a program drew.

    Args:
        answer: Of `run_program`.
        scene_id: Name of the scene.

    Raises:
        ProgramFailed: If nothing of it is a body.
    """
    frames = [parts_of(frame, answer["docs"]) for frame in answer["frames"]]
    first = frames[0]
    if not first:
        raise ProgramFailed("nothing of it is a body")
    shapes = {part.name: tuple(shape_of(item) for item in part.primitives) for part in first}
    things = tuple(
        Thing(
            part.name,
            shapes[part.name],
            label=part.name.rpartition("_")[0].replace("_", " "),
            description=part.doc,
            color=tuple(part.primitives[0]["color"]),
            static=False,
        )
        for part in first
    )
    still = Recording(
        "scene language",
        np.array([0.0, 1.0]),
        np.zeros((2, len(things), 3)),
        np.tile([0.0, 0.0, 0.0, 1.0], (2, len(things), 1)),
        things,
    )
    scene = played(still, Faults(Path(scene_id))).scene
    lowest = min(_lowest(body) for body in scene.bodies)
    bodies = tuple(_weighed(replace(b, position=_raised(b, -lowest))) for b in scene.bodies)
    moving = launches(frames)
    program = Program(
        tuple(
            SetVelocity(name, 0.0, tuple(speed_of(name) * way), (0.0, 0.0, 0.0))
            for name, way in moving.items()
            if name in shapes
        ),
        DURATION_S,
    )
    active = tuple(replace(b, active=b.name in moving) for b in bodies)
    return replace(scene, scene_id=scene_id, bodies=active), program


def _lowest(body: Body) -> float:
    from esg.metrics.geometry import body_cores, lowest_point

    return lowest_point(body_cores(body), np.array(body.position), np.array(body.quaternion))


def _raised(body: Body, by: float) -> tuple[float, float, float]:
    x, y, z = body.position
    return x, y, z + by


def _weighed(body: Body) -> Body:
    """The body with the inertia of its box and at least a gram."""
    mass = max(body.mass, 1e-3)
    x, y, z = (2.0 * max(v, 1e-3) for v in body.half_extents)
    inertia = tuple(
        tuple(mass / 12.0 * v if i == j else 0.0 for j in range(3))
        for i, v in enumerate((y * y + z * z, x * x + z * z, x * x + y * y))
    )
    return replace(body, mass=mass, inertia=inertia)  # type: ignore[arg-type]  # three by three
