"""The physical scene and the poses of centres of mass that a recording amounts to."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from esg.engines.scene import Body, SimScene
from esg.judging.forms import extent_of, volume_of
from esg.judging.recording import Faults, Floats, Pose, Recording, Thing
from esg.units import quat_rotate

DENSITY_KG_M3 = 500.0
"""Of what a file gives no mass: between wood and a hollow thing."""
STILL_M, STILL_DOT = 1e-3, 1.0 - 1e-6
"""What never moves or turns by more, and has no mass, is fixed."""
_ORIGIN = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Played:
    """Bodies and how their centres of mass moved.

    Args:
        scene: B bodies.
        position: Of the centres of mass [m], shape [T, B, 3].
        quaternion: (x, y, z, w), shape [T, B, 4].
        velocity: Of the centres of mass [m/s], shape [T, B, 3]; None if the file has none.
        spin: [rad/s], shape [T, B, 3]; None if the file has none.
        unweighed: Names of the bodies whose mass is a guess.
        drawn: Names of the bodies whose shapes are those of what is seen.
    """

    scene: SimScene
    position: Floats
    quaternion: Floats
    velocity: Floats | None
    spin: Floats | None
    unweighed: frozenset[str] = frozenset()
    drawn: frozenset[str] = frozenset()


def played(recording: Recording, faults: Faults) -> Played:
    """Bodies and motion of a recording.

    Raises:
        UserError: If it does not hold the bodies of the manifest that it carries.
    """
    if recording.manifest is not None:
        return _by_manifest(recording, recording.manifest.scene, faults)
    centers = [_center(thing) for thing in recording.things]
    position, velocity = _at_centers(recording, centers)
    bodies: list[Body] = []
    for k, thing in enumerate(recording.things):
        pose = position[:, k], recording.quaternion[:, k]
        bodies.append(_body(thing, np.asarray(centers[k], float), pose))
    return Played(
        SimScene(recording.format, tuple(bodies)),
        position,
        recording.quaternion,
        velocity,
        recording.spin,
        frozenset(t.name for t in recording.things if t.mass is None),
        frozenset(t.name for t in recording.things if t.drawn),
    )


def _by_manifest(recording: Recording, scene: SimScene, faults: Faults) -> Played:
    """Bodies as the manifest has them; what is fixed stands where it says."""
    columns = {thing.name: k for k, thing in enumerate(recording.things)}
    frames = len(recording.time)
    position = np.empty((frames, len(scene.bodies), 3))
    quaternion = np.empty((frames, len(scene.bodies), 4))
    velocity, spin = recording.velocity, recording.spin
    picked: list[int] = []
    for k, body in enumerate(scene.bodies):
        column = columns.get(body.name)
        if body.static or (column is None and not body.collides):
            position[:, k], quaternion[:, k] = body.position, body.quaternion
        elif column is None:
            faults.add(f"the body {body.name!r} of its manifest is not in it")
            continue
        else:
            turned = recording.quaternion[:, column]
            offset = _ORIGIN if recording.centered else tuple(-v for v in body.origin_offset)
            position[:, k] = recording.position[:, column] + quat_rotate(turned, np.array(offset))
            quaternion[:, k] = turned
        picked.append(-1 if column is None else column)
    faults.stop()
    if velocity is not None and recording.centered:
        velocity, spin = _picked(velocity, picked), None if spin is None else _picked(spin, picked)
    else:
        velocity = spin = None
    return Played(scene, position, quaternion, velocity, spin)


def _picked(values: Floats, columns: list[int]) -> Floats:
    """Columns in another order; zeros where there is none."""
    padded = np.concatenate([values, np.zeros((len(values), 1, values.shape[-1]))], axis=1)
    return padded[:, columns]


def _at_centers(
    recording: Recording, centers: list[tuple[float, float, float]]
) -> tuple[Floats, Floats | None]:
    offset = quat_rotate(recording.quaternion, np.array(centers, float)[None])
    velocity = recording.velocity
    if velocity is not None:
        if recording.spin is not None:
            velocity = velocity + np.cross(recording.spin, offset)
        elif np.any(np.array(centers)):
            velocity = None  # without spins nobody knows how fast the centres of mass are
    return recording.position + offset, velocity


def _center(thing: Thing) -> tuple[float, float, float]:
    """Centre of mass in the thing's frame [m]: stated, or that of its shapes."""
    if thing.center is not None:
        return thing.center
    if not thing.shapes:
        return _ORIGIN
    found = [volume_of(shape) for shape in thing.shapes]
    total = sum(volume for volume, _ in found)
    if total <= 0.0:
        return _ORIGIN
    middle = np.sum([volume * at for volume, at in found], axis=0) / total
    return float(middle[0]), float(middle[1]), float(middle[2])


def _body(thing: Thing, center: Floats, pose: Pose) -> Body:
    shapes = tuple(
        replace(s, position=tuple(float(v) for v in np.array(s.position) - center))
        for s in thing.shapes
    )
    low, high = (c - center for c in _box(thing))
    volume = sum(volume_of(s)[0] for s in thing.shapes)
    mass = thing.mass if thing.mass is not None else DENSITY_KG_M3 * volume
    about = 0.1 * max(mass, 1e-9) * float(np.sum((high - low) ** 2))
    ball = len(shapes) == 1 and shapes[0].kind == "sphere"
    middle = 0.5 * (low + high)
    position, quaternion = pose
    return Body(
        name=thing.name,
        static=_fixed(thing, pose),
        mass=float(mass),
        inertia=((about, 0.0, 0.0), (0.0, about, 0.0), (0.0, 0.0, about)),
        shapes=shapes,
        position=(float(position[0, 0]), float(position[0, 1]), float(position[0, 2])),
        quaternion=tuple(float(v) for v in quaternion[0]),  # type: ignore[arg-type]  # four of them
        roll_radius=shapes[0].size[0] if ball else 0.0,
        origin_offset=(float(middle[0]), float(middle[1]), float(low[2])),
        half_extents=tuple(float(v) for v in 0.5 * (high - low)),  # type: ignore[arg-type]  # three
        category=thing.category,
        label=thing.label or thing.name,
        description=thing.description,
        color=thing.color or Body.__dataclass_fields__["color"].default,
    )


def _box(thing: Thing) -> tuple[Floats, Floats]:
    if thing.box is not None:
        return thing.box
    return extent_of(thing.shapes) if thing.shapes else (np.zeros(3), np.zeros(3))


def _fixed(thing: Thing, pose: Pose) -> bool:
    if thing.static is not None:
        return thing.static
    if thing.mass is not None and not thing.drawn:
        return False
    position, quaternion = pose
    moved = float(np.linalg.norm(position - position[0], axis=-1).max())
    return moved < STILL_M and float(np.abs(quaternion @ quaternion[0]).min()) > STILL_DOT
