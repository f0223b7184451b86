"""What a file tells of how things moved, whatever its format."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
import math
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from esg.engines.base import MOST_STATES
from esg.engines.manifest import Manifest
from esg.engines.scene import ContactLog, Rollout, Shape
from esg.outcomes import UserError

Floats = NDArray[np.float64]
Pose = tuple[Floats, Floats]
"""Positions [m] and quaternions (x, y, z, w), shapes [..., 3] and [..., 4]."""
MOST_THINGS = 2000
MOST_PROBLEMS = 20
"""Of one file that are told."""


@dataclass(frozen=True)
class Thing:
    """One rigid body as a file tells of it; its frame is the one that its poses place.

    Args:
        name: In the file; unique.
        shapes: What it collides with, in its frame [m]; empty: it is only a place.
        box: Lower and upper corner of all of it in its frame [m]; None if its shapes tell.
        mass: [kg]; None if the file does not say.
        static: Whether it is fixed; None if the file does not say.
        center: Centre of mass in its frame [m]; None if the file does not say.
        label: Words for it; empty: its name.
        category, description: More words.
        color: RGB in [0, 1]; None if the file does not say.
        drawn: Whether its shapes are those of what is seen, because it has no colliders.
    """

    name: str
    shapes: tuple[Shape, ...] = ()
    box: tuple[Floats, Floats] | None = None
    mass: float | None = None
    static: bool | None = None
    center: tuple[float, float, float] | None = None
    label: str = ""
    category: str = ""
    description: str = ""
    color: tuple[float, float, float] | None = None
    drawn: bool = False


@dataclass(frozen=True)
class Recording:
    """How B things moved over T frames; right-handed, Z up, SI.

    Args:
        format: Of the file, as messages call it.
        time: Of the frames [s], rising, shape [T].
        position: Of the things' frames [m], shape [T, B, 3].
        quaternion: (x, y, z, w), shape [T, B, 4].
        things: In the order of the columns.
        velocity: Of the frames' origins [m/s], shape [T, B, 3]; None if the file has none.
        spin: In the world's axes [rad/s], shape [T, B, 3]; None if the file has none.
        contacts: The contact log; None if the file has none.
        manifest: The physical scene that the file carries; None if it has none.
        centered: Whether poses are those of centres of mass, where a manifest tells the bodies.
        rollout: The exact replay, of a file that holds one; then only `manifest` counts beside it.
        notes: What the format could not tell, a sentence each.
    """

    format: str
    time: Floats
    position: Floats
    quaternion: Floats
    things: tuple[Thing, ...]
    velocity: Floats | None = None
    spin: Floats | None = None
    contacts: ContactLog | None = None
    manifest: Manifest | None = None
    centered: bool = False
    rollout: Rollout | None = None
    notes: tuple[str, ...] = ()


@dataclass
class Faults:
    """Everything that is wrong with a file, told at once.

    Args:
        path: The file.
    """

    path: Path
    found: list[str] = field(default_factory=list)

    def add(self, what: str) -> None:
        """Notes one fault, once."""
        if what not in self.found:
            self.found.append(what)

    def stop(self) -> None:
        """Raises what was found.

        Raises:
            UserError: If anything was.
        """
        if not self.found:
            return
        if len(self.found) == 1:
            raise UserError(f"{self.path}: {self.found[0]}")
        told = self.found[:MOST_PROBLEMS]
        if len(self.found) > len(told):
            told.append(f"and {len(self.found) - len(told)} more")
        lines = "".join(f"\n  {line}" for line in told)
        raise UserError(f"{self.path}: {len(self.found)} problems{lines}")

    def fail(self, what: str) -> UserError:
        """The error that this fault and those before it make."""
        self.add(what)
        try:
            self.stop()
        except UserError as error:
            return error
        raise AssertionError("a fault was just added")


@dataclass(frozen=True)
class Frame:
    """Units and axes of formats that do not state their own.

    Args:
        says: In a sentence.
        metres: In one unit of length.
        axes: Ours (X, Y, Z) from theirs: a signed permutation, shape [3, 3].
    """

    says: str
    metres: float
    axes: tuple[tuple[int, int, int], ...]

    def lengths(self, vectors: Floats) -> Floats:
        """Vectors of theirs in our axes [m or m/s], shape [..., 3]."""
        return self.metres * self.directions(vectors)

    def directions(self, vectors: Floats) -> Floats:
        """Vectors of theirs in our axes, their unit kept, shape [..., 3]."""
        return np.asarray(vectors, float) @ np.array(self.axes, float).T

    def turns(self, spins: Floats) -> Floats:
        """Angular velocities of theirs in our axes [rad/s], shape [..., 3]."""
        return self._hand * self.directions(spins)

    def quaternions(self, q: Floats) -> Floats:
        """Orientations of theirs (x, y, z, w) in our axes, shape [..., 4]."""
        q = np.asarray(q, float)
        return np.concatenate([self._hand * self.directions(q[..., :3]), q[..., 3:]], axis=-1)

    @property
    def _hand(self) -> float:
        """-1 if theirs is left-handed: a mirror turns turning round."""
        return float(np.sign(np.linalg.det(np.array(self.axes, float))))


FRAMES = {
    "z-up": Frame("right-handed, Z up, metres", 1.0, ((1, 0, 0), (0, 1, 0), (0, 0, 1))),
    "y-up": Frame("right-handed, Y up, metres", 1.0, ((1, 0, 0), (0, 0, -1), (0, 1, 0))),
    "unreal": Frame(
        "Unreal's: left-handed, Z up, centimetres", 0.01, ((1, 0, 0), (0, -1, 0), (0, 0, 1))
    ),
}
"""What --frame may be."""

Reader = Callable[[Path, Frame, Faults], Recording]


def checked(recording: Recording, faults: Faults) -> Recording:
    """The recording with unit quaternions, if its numbers can be those of a motion.

    Raises:
        UserError: With everything that is wrong with the file.
    """
    if not recording.things:
        raise faults.fail("nothing in it moves or stands: it holds no body")
    if len(recording.things) > MOST_THINGS:
        faults.add(f"it holds {len(recording.things)} bodies, at most {MOST_THINGS} are judged")
    frames = len(recording.time)
    if frames < 2:
        raise faults.fail(f"it has {frames} frames; a motion has two or more")
    if frames * len(recording.things) > MOST_STATES:
        raise faults.fail(
            f"{frames} frames of {len(recording.things)} bodies are more than is read"
        )
    if not np.isfinite(recording.time).all() or (np.diff(recording.time) <= 0.0).any():
        faults.add("the times of its frames do not rise")
    names = [thing.name for thing in recording.things]
    for name in sorted({n for n in names if names.count(n) > 1}):
        faults.add(f"several bodies are called {name!r}")
    norms = np.linalg.norm(recording.quaternion, axis=-1)
    for column, name in enumerate(names):
        if not np.isfinite(recording.position[:, column]).all():
            faults.add(f"{name!r} has positions that are no numbers")
        if not (np.isfinite(norms[:, column]).all() and (norms[:, column] > 1e-6).all()):
            faults.add(f"{name!r} has orientations that are no quaternions")
    for thing in recording.things:
        if thing.mass is not None and not (math.isfinite(thing.mass) and thing.mass >= 0.0):
            faults.add(f"the mass of {thing.name!r} is {thing.mass:g} kg")
        if not sizes_hold(thing.shapes):
            faults.add(f"a shape of {thing.name!r} has no positive, finite size")
    faults.stop()
    unit = recording.quaternion / norms[..., None]
    return Recording(**{**vars(recording), "quaternion": unit})


def sizes_hold(shapes: Iterable[Shape]) -> bool:
    """Whether every size is positive (a flat hull may be flat) and finite."""
    for shape in shapes:
        sizes = shape.size[:2] if shape.kind in ("capsule",) else shape.size
        if not all(math.isfinite(v) for v in shape.size):
            return False
        if shape.kind != "convex" and not all(v > 0.0 for v in sizes):
            return False
    return True
