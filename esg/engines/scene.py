"""The physical scene every engine builds from: bodies, shapes, materials, regions (SI).

A body's frame has its origin at the centre of mass, so that positions, velocities and impulses mean
the same in every engine. `origin_offset` leads from there to the asset's local origin (bottom
centre), which is where the mesh and the Unreal component sit.

Contact materials combine by **average** (PhysX, Unreal and Rapier default). Every scene has one
ground, the half-space z <= 0. Wheeled bodies touch a second ground of friction
`vehicle_ground_friction` instead of the normal one, so that a coasting vehicle does not grind to a
halt like a box (docs/engines.md).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from esg.engines.joints import Joint
from esg.lexicon.shown import Sway

ShapeKind = Literal["sphere", "box", "capsule", "cylinder", "convex"]
Floats = NDArray[np.float64]

FRAGMENT = "fragment"
"""Category of what something breaks into: no phrase of a prompt means it."""
GROUND = "ground"
"""Reserved body name of the ground half-space in contact logs."""


@dataclass(frozen=True)
class Shape:
    """One collision shape in its body's frame.

    Args:
        kind: Shape type.
        size: sphere (r, r, r); box half extents; capsule and cylinder (r, r, half height along
            local Z, caps excluded); convex half extents of its bounding box [m], shape [3].
        position: Centre in the body frame [m], shape [3].
        quaternion: Orientation (x, y, z, w) in the body frame, shape [4].
        vertices: Convex hull points in the shape's own frame [m], shape [n, 3]; empty otherwise.
    """

    kind: ShapeKind
    size: tuple[float, float, float]
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    quaternion: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    vertices: tuple[tuple[float, float, float], ...] = ()


@dataclass(frozen=True)
class Wheel:
    """A wheel of a body, of which no engine knows: what plays a recording turns it.

    Args:
        name: Of its node in the body's mesh.
        axle: A point of its axis, which lies along Y of the body frame [m], shape [3].
        radius: [m].
    """

    name: str
    axle: tuple[float, float, float]
    radius: float


@dataclass(frozen=True)
class Shine:
    """Light of a body's model, of which no engine knows (`esg.engines.wheels`).

    Args:
        part: How the names of the parts begin that shine; "flame" is drawn on top of it.
        color: sRGB in [0, 1].
        before, after: Whether it shines before and after it changes; the same: all the time.
        event: Id of the point event at which it changes; empty: soon after the start.
        period_s: Of its flashes [s]; 0 does not flash.
    """

    part: str
    color: tuple[float, float, float]
    before: bool = True
    after: bool = True
    event: str = ""
    period_s: float = 0.0


@dataclass(frozen=True)
class Gesture:
    """Motion of arms, head or tail of a body's model, of which no engine knows.

    Args:
        name: Row of the table of gestures (`esg.lexicon.gestures`).
        period_s: From its rest to its far end and back [s]; 0 is held.
        times: How often; 0 is on and on.
        sweep_m: How far hand, head or tail go to and fro on what is drawn [m].
        rise_m: How far their rest is from where they are without it [m].
        begins, ends: Ids of the point events; empty: soon after the start, and never.
    """

    name: str
    period_s: float
    times: int
    sweep_m: float
    rise_m: float
    begins: str = ""
    ends: str = ""


@dataclass(frozen=True)
class GivesOff:
    """Smoke, steam, dust or sparks that leave a body, of which no engine knows.

    Args:
        name: Row of the table of plumes (`esg.lexicon.plumes`).
        begins: Id of the point event; empty: at the start.
    """

    name: str
    begins: str = ""


@dataclass(frozen=True)
class Body:
    """One rigid body.

    Args:
        name: Node id in the ESG document; unique.
        static: Immovable (mass is ignored).
        mass: [kg].
        inertia: About the centre of mass in body axes [kg m^2], shape [3, 3] as nested tuples.
        shapes: Collision shapes; empty for decals.
        position: Centre of mass in the world [m], shape [3].
        quaternion: Orientation (x, y, z, w), shape [4].
        friction: Friction coefficient (static = dynamic).
        restitution: Coefficient of restitution.
        linear_damping: [1/s]; per step v *= max(0, 1 - c dt).
        angular_damping: [1/s]; likewise.
        wheeled: Touches the vehicle ground instead of the normal ground.
        tyre_friction: Side friction coefficient of the tyres of a wheeled body, beyond that of its
            contacts; 0 lets it slide sideways as easily as it rolls (`esg.engines.program`).
        tyre_drop: How far below the centre of mass they push [m]: 0 for what stands on a wide
            track, else it leans and may fall over.
        tyre_foot: How far its shapes reach to the side where they stand [m]: the edge that what
            leans falls over.
        roll_radius: Radius [m] of a round body that rolls, 0 for others.
        origin_offset: From the centre of mass to the asset's local origin, body axes [m].
        half_extents: Of the asset's bounding box [m]; `height` is twice the last.
        mesh: Path of the GLB inside the scene folder.
        category: Asset category, for binding noun phrases.
        label: How the prompt names it.
        description: Free text for binding noun phrases.
        color: RGB in [0, 1].
        group: Name shared by the members of one plural.
        mentioned: False if expansion added it.
        active: It moves under its own control.
        wheels: What turns as the body travels (`esg.engines.wheels`).
        break_impulse: It breaks once it took more within `BREAK_WINDOW_S`
            (`esg.engines.joint_rules`) [N s]; None: never.
        fragments: Names of the bodies that it then is (`esg.engines.breaking`).
        postures: Names of the bodies that it is in other postures (`esg.engines.breaking.stances`).
        drawn: Parts of its model as "NAME #rrggbb MATERIAL", of those of whom it is stated what
            they wear; nothing physical depends on it.
        shines: Its lights and flames, where it is stated that it is lit.
        sways: How it sways, where it is stated that it does.
        gestures: That it makes, where it is stated that it does.
        gives_off: Smoke, steam, dust and sparks, where it is stated that it does.
        turned: From its model as it is usually drawn to how it lies (x, y, z, w); None: not at all.
    """

    name: str
    static: bool
    mass: float
    inertia: tuple[tuple[float, float, float], ...]
    shapes: tuple[Shape, ...]
    position: tuple[float, float, float]
    quaternion: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    friction: float = 0.5
    restitution: float = 0.2
    linear_damping: float = 0.0
    angular_damping: float = 0.0
    wheeled: bool = False
    tyre_friction: float = 0.0
    tyre_drop: float = 0.0
    tyre_foot: float = 0.0
    roll_radius: float = 0.0
    origin_offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    half_extents: tuple[float, float, float] = (0.5, 0.5, 0.5)
    mesh: str = ""
    category: str = ""
    label: str = ""
    description: str = ""
    color: tuple[float, float, float] = (0.6, 0.6, 0.6)
    group: str = ""
    mentioned: bool = True
    active: bool = False
    wheels: tuple[Wheel, ...] = ()
    break_impulse: float | None = None
    fragments: tuple[str, ...] = ()
    postures: tuple[str, ...] = ()
    drawn: tuple[str, ...] = ()
    shines: tuple[Shine, ...] = ()
    sways: Sway | None = None
    gestures: tuple[Gesture, ...] = ()
    gives_off: tuple[GivesOff, ...] = ()
    turned: tuple[float, float, float, float] | None = None

    @property
    def collides(self) -> bool:
        return bool(self.shapes)


def stand_in(body: Body, **own: Any) -> Body:
    """What is there instead of a body, as a fragment or a posture of it: no phrase means it.

    Args:
        body: The body.
        **own: What it has otherwise.
    """
    return replace(
        body,
        category=FRAGMENT,
        label="",
        description="",
        group="",
        mentioned=False,
        active=False,
        gives_off=(),
        **own,
    )


@dataclass(frozen=True)
class Region:
    """A volume things can enter: a pocket, a goal mouth, a bin's inside.

    Args:
        name: "node_id/region name".
        parent: Name of the body it belongs to.
        center: In the parent's body frame [m], shape [3].
        half_extents: Of the box in the parent's body axes [m], shape [3].
        kind: pocket, goal, hole, inside, lane or area.
    """

    name: str
    parent: str
    center: tuple[float, float, float]
    half_extents: tuple[float, float, float]
    kind: str = "area"


@dataclass(frozen=True)
class SimScene:
    """Everything an engine needs except the control program.

    Args:
        scene_id: Identifier of the scene.
        bodies: All bodies, structural decals included.
        regions: Named volumes.
        gravity: [m/s^2], shape [3].
        ground_friction: Friction coefficient of the ground.
        ground_restitution: Coefficient of restitution of the ground.
        vehicle_ground_friction: Friction of the second ground that wheeled bodies touch.
        joints: What holds bodies together (`esg.engines.joints`).
        weather: What falls or hangs in the air, as statements name it; no engine knows of it.
    """

    scene_id: str
    bodies: tuple[Body, ...]
    regions: tuple[Region, ...] = ()
    gravity: tuple[float, float, float] = (0.0, 0.0, -9.81)
    ground_friction: float = 0.7
    ground_restitution: float = 0.3
    vehicle_ground_friction: float = 0.0
    joints: tuple[Joint, ...] = ()
    weather: tuple[str, ...] = ()

    def index(self, name: str) -> int:
        """Index of the body called `name`; raises KeyError with the known names."""
        for i, body in enumerate(self.bodies):
            if body.name == name:
                return i
        raise KeyError(f"no body {name!r}; bodies are {[b.name for b in self.bodies]}")

    def body(self, name: str) -> Body:
        """The body called `name`."""
        return self.bodies[self.index(name)]

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(b.name for b in self.bodies)

    def with_bodies(self, bodies: tuple[Body, ...]) -> SimScene:
        """The same scene with other bodies."""
        return replace(self, bodies=bodies)


@dataclass(frozen=True)
class Variation:
    """What may differ between the worlds of one batch besides the program; None keeps the scene's.

    Shapes: W worlds, B bodies in `SimScene.bodies` order.

    Args:
        position: Initial centres of mass [m], shape [W, B, 3].
        quaternion: Initial orientations, shape [W, B, 4].
        mass_scale: Factor on mass and inertia, shape [W, B].
        friction_scale: Factor on the friction of everything, ground included, shape [W].
        restitution_offset: Added to every restitution, clipped to [0, 1], shape [W].
    """

    position: Floats | None = None
    quaternion: Floats | None = None
    mass_scale: Floats | None = None
    friction_scale: Floats | None = None
    restitution_offset: Floats | None = None


@dataclass(frozen=True)
class ContactLog:
    """Sparse record of touching pairs, one row per world, frame and pair with impulse > 0.

    Columns have shape [n]; bodies are indices into `SimScene.bodies`, -1 is the ground. Rows are
    sorted by (world, frame, a, b) with a < b, except that the ground is always b = -1. Those with
    the ground are recorded only if asked for.

    Args:
        world, frame, a, b: Integers.
        time: End time of the step in which the contact was solved [s].
        impulse: Normal impulse accumulated over the frame [N s].
        depth: Largest penetration depth in the frame [m], >= 0.
        point: A contact point, world frame [m], shape [n, 3].
        normal: Unit normal from b towards a, shape [n, 3].
    """

    world: NDArray[np.int32]
    frame: NDArray[np.int32]
    a: NDArray[np.int32]
    b: NDArray[np.int32]
    time: Floats
    impulse: Floats
    depth: Floats
    point: Floats
    normal: Floats

    @staticmethod
    def empty() -> ContactLog:
        i, f = np.zeros(0, np.int32), np.zeros(0)
        return ContactLog(i, i, i, i, f, f, f, np.zeros((0, 3)), np.zeros((0, 3)))

    def select(self, world: int) -> ContactLog:
        """The rows of one world."""
        keep = self.world == world
        return ContactLog(**{k: getattr(self, k)[keep] for k in self.__dataclass_fields__})


@dataclass(frozen=True)
class Rollout:
    """Result of simulating W worlds for T frames (frame 0 is the initial state).

    Args:
        engine: newton, physx, rapier or surrogate.
        dt: Physics step [s].
        time: Frame times [s], shape [T]. At `record_every` = 1 a frame is a step.
        position: Centres of mass [m], shape [W, T, B, 3], float32.
        quaternion: (x, y, z, w), shape [W, T, B, 4].
        linear_velocity: Of the centre of mass [m/s], shape [W, T, B, 3].
        angular_velocity: World frame [rad/s], shape [W, T, B, 3].
        contacts: Touching pairs.
        valid: False for worlds that diverged (NaN, or a body faster than 500 m/s), shape [W].
        extra: Engine-specific notes (version, solver, class replay log).
    """

    engine: str
    dt: float
    time: Floats
    position: NDArray[np.float32]
    quaternion: NDArray[np.float32]
    linear_velocity: NDArray[np.float32]
    angular_velocity: NDArray[np.float32]
    contacts: ContactLog
    valid: NDArray[np.bool_]
    extra: dict[str, object] = field(default_factory=dict)
