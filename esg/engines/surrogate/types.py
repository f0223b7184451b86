"""Arrays of the fused surrogate, in the form its kernels take them.

W worlds, B bodies, S shapes, P primitives of the program, C contacts a world. Everything is SI, in
the world frame unless it says otherwise. Body b owns the shapes first[b] .. first[b + 1] - 1.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
from enum import IntEnum

import warp as wp


class Fired(IntEnum):
    """What a primitive did in a step of a trace."""

    NOTHING = 0
    ACTS = 1
    LAST = 2
    """It held for the last time, because its time ended."""


@wp.struct
class Model:
    """What does not change during a rollout."""

    n_bodies: int
    n_primitives: int
    n_worlds: int
    gravity: wp.vec3
    dt: wp.float64
    n_steps: int
    record_every: int
    # Shapes, [S]; `scale` and `mesh` in the convention of Newton's support maps.
    first: wp.array(dtype=int)
    kind: wp.array(dtype=int)
    scale: wp.array(dtype=wp.vec3)
    mesh: wp.array(dtype=wp.vec3)
    position: wp.array(dtype=wp.vec3)
    rotation: wp.array(dtype=wp.quat)
    half: wp.array(dtype=wp.vec3)
    radius: wp.array(dtype=float)
    # Bodies, [B]; `reach` is the radius around the centre of mass that holds all shapes.
    reach: wp.array(dtype=float)
    dynamic: wp.array(dtype=int)
    wheeled: wp.array(dtype=int)
    inertia: wp.array(dtype=wp.mat33)
    inverse_inertia: wp.array(dtype=wp.mat33)
    features: wp.array2d(dtype=float)
    """For the ground (`esg.engines.traction.Feature`), [B, FEATURES]."""
    grounded: int
    """Whether there are brakes or tyres."""
    # Worlds, [W] and [W, B]; `factor` scales the inertia.
    mass: wp.array2d(dtype=float)
    factor: wp.array2d(dtype=float)
    restitution: wp.array2d(dtype=float)
    ground: wp.array(dtype=wp.vec3)
    friction_scale: wp.array(dtype=float)
    # Program, [P], [P, B] and [W, P, FIELDS].
    action: wp.array(dtype=int)
    target: wp.array(dtype=int)
    until: wp.array2d(dtype=int)
    table: wp.array3d(dtype=wp.float64)


@wp.struct
class State:
    """What a step changes, [W, B] unless stated otherwise."""

    x: wp.array2d(dtype=wp.vec3)
    r: wp.array2d(dtype=wp.quat)
    v: wp.array2d(dtype=wp.vec3)
    o: wp.array2d(dtype=wp.vec3)
    friction: wp.array2d(dtype=float)
    damping: wp.array2d(dtype=wp.vec2)
    awake: wp.array2d(dtype=int)
    idle: wp.array2d(dtype=int)
    inverse: wp.array2d(dtype=wp.mat33)
    """Inverse inertia in world axes."""
    light: wp.array2d(dtype=float)
    """Inverse mass of what impulses move; 0 for what is static or asleep."""
    before_v: wp.array2d(dtype=wp.vec3)
    before_o: wp.array2d(dtype=wp.vec3)
    """Velocities before the contacts act."""
    delay: wp.array2d(dtype=wp.vec2)
    """Normal impulses on a body, times the delay of each contact, and their sum."""
    touched: wp.array3d(dtype=int)
    """Step after the last one in which two bodies touched, [W, B, B]."""
    braking: wp.array2d(dtype=float)
    driven: wp.array2d(dtype=int)
    """Step after the last one in which a hold or a guide set the velocity."""
    start: wp.array2d(dtype=wp.vec3)
    """Velocity at the beginning of the last step, after brakes and tyres."""
    tips: wp.array2d(dtype=int)
    """Whether a two-wheeler has lost its balance and shall lean on."""
    done: wp.array2d(dtype=int)
    active: wp.array2d(dtype=int)
    """Of every primitive, [W, P]."""


@wp.struct
class Contacts:
    """The contacts of the current step, [W, C]; `impulse` is (normal, tangent 1, tangent 2)."""

    base: int
    """0, or if a trace is kept the number of slots of a step."""
    count: wp.array2d(dtype=int)
    """[W, 1], or [W, steps] with a trace."""
    dropped: wp.array(dtype=int)
    a: wp.array2d(dtype=int)
    b: wp.array2d(dtype=int)
    shape_a: wp.array2d(dtype=int)
    shape_b: wp.array2d(dtype=int)
    normal: wp.array2d(dtype=wp.vec3)
    side: wp.array2d(dtype=wp.vec3)
    """First tangent; the second is orthogonal to both."""
    arm_a: wp.array2d(dtype=wp.vec3)
    arm_b: wp.array2d(dtype=wp.vec3)
    gap: wp.array2d(dtype=float)
    friction: wp.array2d(dtype=float)
    wanted: wp.array2d(dtype=float)
    delay: wp.array2d(dtype=float)
    share: wp.array2d(dtype=wp.vec3)
    impulse: wp.array2d(dtype=wp.vec3)
    used: wp.array2d(dtype=int)
    """Whether the contact pressed in any sweep."""
    early: wp.array2d(dtype=float)
    turn_a: wp.array2d(dtype=wp.quat)
    turn_b: wp.array2d(dtype=wp.quat)
    """Time into the step at which normal and arms are measured, and the orientations then."""


@wp.struct
class Trace:
    """Decisions of every step, for the replay that is differentiated; all empty without a trace."""

    steps: int
    """0 without a trace."""
    awake: wp.array3d(dtype=int)
    """[W, steps, B]"""
    fired: wp.array3d(dtype=int)
    """`Fired`, [W, steps, P]."""
    sweeps: wp.array2d(dtype=int)
    """[W, steps]"""
    grounded: wp.array3d(dtype=int)
    """Whether brakes or tyres changed a velocity, 2 if it tips over too, [W, steps, B]."""


@wp.struct
class Raw:
    """Contact points of one pair of shapes as the narrow phase finds them, [W, 8]."""

    world: int
    count: wp.array(dtype=int)
    point: wp.array2d(dtype=wp.vec3)
    normal: wp.array2d(dtype=wp.vec3)
    distance: wp.array2d(dtype=float)


@wp.struct
class Log:
    """Rows of the contact log, [W, R]; `row` is the last one of each pair, [W, B + 1, B + 1]."""

    ground: int
    count: wp.array(dtype=int)
    row: wp.array3d(dtype=int)
    frame: wp.array2d(dtype=int)
    a: wp.array2d(dtype=int)
    b: wp.array2d(dtype=int)
    step: wp.array2d(dtype=int)
    impulse: wp.array2d(dtype=float)
    depth: wp.array2d(dtype=float)
    point: wp.array2d(dtype=wp.vec3)
    normal: wp.array2d(dtype=wp.vec3)


@wp.struct
class Out:
    """What a rollout of W worlds leaves: states of moving bodies, [W, T - 1, D] from frame 1 on,
    and per world [W] the largest overlap and the first frame that is not sound, else T."""

    x: wp.array3d(dtype=wp.vec3)
    r: wp.array3d(dtype=wp.quat)
    v: wp.array3d(dtype=wp.vec3)
    o: wp.array3d(dtype=wp.vec3)
    deepest: wp.array(dtype=float)
    end: wp.array(dtype=int)


@wp.struct
class Fields:
    """Signed distance fields [m] of F bodies, in their body frames.

    Every field is a cube of n^3 cells whose values sit at the cells' centres. Field f owns the
    samples first[f] .. first[f + 1] - 1.
    """

    n: int
    of_body: wp.array(dtype=int)
    """[B]: index of a body's field or -1."""
    ball: wp.array(dtype=int)
    """[B]: whether a body is one sphere."""
    values: wp.array4d(dtype=float)
    origin: wp.array(dtype=wp.vec3)
    """Corner of the grid, [F]."""
    cell: wp.array(dtype=float)
    first: wp.array(dtype=int)
    sample: wp.array(dtype=wp.vec3)
