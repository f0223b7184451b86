"""People and four-legged animals that step, and get into their postures: drawn limb by limb.

Nothing of it is physics: the body goes as the engine moved it, and its drawing is cut into a trunk,
thighs, shanks and feet, each with a track of poses in the body's frame. Who goes steps by the way
that he has gone (`gaits`); who throws or kicks swings through and stands; who is about to kneel or
to sit gets there in `EASE_S` before the engine swaps his body, and up again after it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.assets.appearance import Appearance
from esg.assets.appearances import appearances
from esg.assets.builders.living.poses import POSES, Pose
from esg.assets.configuration import parametric_entry
from esg.assets.postures import Held, config_of, plan_drawn, taken
from esg.engines.breaking.stances import absent
from esg.engines.scene import Rollout, SimScene
from esg.graph.casting import effective
from esg.lexicon.postures import PLANS
from esg.units import CM_PER_M, GRAVITY_MPS2, quat_multiply, quat_rotate
from esg.view.moments import set_off
from esg.view.pieces import Act, Part, Track
from esg.view.seeing.arms import Made, arms_alone, gestured, made_by
from esg.view.seeing.gaits import Going, beast, going, person
from esg.view.seeing.shows import event_times

if TYPE_CHECKING:
    from esg.assets.geometry.mesh import Member
    from esg.assets.geometry.sketch import Limb
    from esg.graph.models import EsgDocument

Floats = NDArray[np.float64]

EASE_S = 0.45
"""Time in which somebody gets into a posture, or up from it."""
CROUCH_DEG = 38.0
"""Half-way down thighs are so far ahead."""
HELD_S, THROUGH_S = 0.1, 0.6
"""Who has thrown or kicked something stays as he is so long, then takes so long to stand."""
GOES_M = 0.25
"""Who is moved less than this does not step."""
SMOOTH_S = 0.08
LAP = 0.055
"""Halves of a limb lap over at its joint by this share of its length."""
UPRIGHT = 0.8
"""Who leans more (37 degrees) does not step."""
THICK, LEAST_STEP = 0.33, 0.4
"""Legs wider than this share of their length take shorter steps, at least so much of the usual."""
FREE = frozenset({"", "stand", "walk", "run", "play", "laden"})
"""Poses in which nothing is held, so that the arms swing."""
STEPPING = FREE | {"push", "hold", "bear", "throw", "kick", "swing"}
"""Poses of somebody on his feet."""
ACTING = frozenset({"throw", "kick", "swing"})
_SOLE_CM = ((-8.9, -9.2), (8.0, -9.2), (20.0, -9.2))
_KNEE_CM, _SEAT_CM, _ANKLE_CM, _LEG_CM = 7.0, 11.0, 9.2, 81.5


@dataclass(frozen=True)
class Rig:
    """A body that is drawn limb by limb.

    Args:
        index: Of the body.
        plan: people or beasts.
        pose: It is drawn in.
        limbs: In the body's frame [m], by name, shape [3, 3] each.
        pitches: Of what is beyond each limb's last joint [deg].
        members: Its geometry.
        origin: The asset's origin in the body's frame [m], shape [3].
        reach: Share of the usual step that what is worn allows.
    """

    index: int
    plan: str
    pose: str
    limbs: Mapping[str, Floats]
    pitches: Mapping[str, float]
    members: tuple[Member, ...]
    origin: Floats
    reach: float

    @property
    def legs(self) -> list[str]:
        """Names of its legs."""
        return [name for name in self.limbs if name.startswith("leg")]

    @property
    def leg(self) -> float:
        """Height of the first joint of a leg that stands [m]."""
        joints = self.limbs[self.legs[0]]
        long = float(np.linalg.norm(np.diff(joints, axis=0), axis=1).sum())
        return long * (1.0 + _ANKLE_CM / _LEG_CM)


@dataclass(frozen=True)
class Bearing:
    """What somebody does with his limbs, at T instants.

    Args:
        go: How he goes.
        stands: 0 for as he is drawn, 1 for as he goes or stands, shape [T].
        upright: 1 where he stands upright, 0 where he lies or falls, shape [T].
        posture: The posture that he gets into or comes from; None for none.
        eased: How much he is in it, 0 to 1, shape [T].
        away: Where he is on the way to his place in it, in his frame [m], shape [T, 3].
        turned: By how much he has turned on the way [rad], shape [T].
        made: Gestures of his arms meanwhile.
    """

    go: Going
    stands: Floats
    upright: Floats
    posture: Pose | None
    eased: Floats
    away: Floats
    turned: Floats
    made: Made = ()


def stepping(scene: SimScene, rollout: Rollout, doc: EsgDocument) -> frozenset[int]:
    """Indices of the bodies that are drawn limb by limb.

    Args:
        scene: The bodies.
        rollout: Their motion.
        doc: What they look like.
    """
    doc = effective(doc)
    plans = {
        i: plan
        for i, b in enumerate(scene.bodies)
        if not (b.static or b.wheels) and b.collides
        if not b.gestures or arms_alone(b)  # other gestures have poses of their own
        if (plan := plan_drawn(doc, b.name))
    }
    if not plans:
        return frozenset()
    looks = appearances(doc)
    doers = {i for _, _, by in set_off(scene, rollout, doc) for i in by}
    out: set[int] = set()
    for index, plan in plans.items():
        body = scene.bodies[index]
        pose = looks[body.name].pose
        if plan == "people" and pose not in STEPPING:
            continue
        way = np.nan_to_num(rollout.position[0, :, index, :2]).astype(float)
        goes = float(np.linalg.norm(way - way[0], axis=1).max()) > GOES_M
        acts = (body.postures or (index in doers and pose in ACTING)) and not body.gestures
        waves = not body.gestures or (plan == "people" and pose in FREE and not body.postures)
        if (goes and waves) or acts:
            out.add(index)
    held = {j.child for j in scene.joints if j.kind == "fixed"}
    held |= {j.parent for j in scene.joints if j.kind == "fixed"}
    return frozenset(i for i in out if scene.bodies[i].name not in held)


def with_limbs(
    parts: Sequence[Part], scene: SimScene, rollout: Rollout, doc: EsgDocument
) -> list[Part]:
    """Parts of bodies, those of who steps limb by limb.

    Args:
        parts: Of bodies, in their frames.
        scene: The bodies.
        rollout: Their motion.
        doc: What they look like.
    """
    who = stepping(scene, rollout, doc)
    if not who:
        return list(parts)
    drawn = limb_parts(who, scene, rollout, doc)
    mine = {p.body for p in drawn}
    return [*(p for p in parts if p.body not in mine), *drawn]


def limb_parts(
    who: frozenset[int], scene: SimScene, rollout: Rollout, doc: EsgDocument
) -> tuple[Part, ...]:
    """The parts of some bodies, each with the track of its limb.

    Args:
        who: Indices of the bodies.
        scene, rollout, doc: As of `with_limbs`.
    """
    doc = effective(doc)
    looks = appearances(doc)
    postures = taken(doc)
    begun = [(t, by) for t, _, by in set_off(scene, rollout, doc)]
    events = event_times(doc, scene, rollout) if any(scene.bodies[i].gestures for i in who) else {}
    out: list[Part] = []
    for index in sorted(who):
        rig = _rig(index, scene, doc, looks)
        if rig is None:
            continue
        acts = [t for t, by in begun if index in by]
        own = postures.get(scene.bodies[index].name, ())
        bearing = _bearing(rig, scene, rollout, own, acts[:1])
        made = made_by(scene.bodies[index], np.asarray(rollout.time, float), events)
        bearing = replace(bearing, made=made)
        out += _parts(rig, rollout, bearing, _there(index, scene, rollout))
    return tuple(out)


def _rig(
    index: int, scene: SimScene, doc: EsgDocument, looks: Mapping[str, Appearance]
) -> Rig | None:
    # Meshes load their libraries: only where somebody steps.
    from esg.assets.geometry.mesh import limbed

    body = scene.bodies[index]
    config = config_of(doc, body.name)
    entry = parametric_entry(config)
    if entry is None:
        return None
    plan, look = PLANS[entry.builder], looks[body.name]
    if plan == "beasts" and look.pose:
        look = replace(look, pose="")
    limbs, members = limbed(config, look)
    if not limbs:
        return None
    origin = np.asarray(body.origin_offset, float)

    def placed(limb: Limb) -> Floats:
        return np.asarray(limb.joints) / CM_PER_M + origin

    joints = {limb.name: placed(limb) for limb in limbs}
    pitches = {limb.name: limb.pitch for limb in limbs}
    reach = min(limb.reach for limb in limbs)
    if plan == "beasts":
        reach *= _slender(limbs, members)
    return Rig(index, plan, look.pose, joints, pitches, members, origin, reach)


def _slender(limbs: Sequence[Limb], members: Sequence[Member]) -> float:
    """Share of the usual step that legs take which are thick for their length: an elephant's."""
    name, joints = limbs[0].name, np.asarray(limbs[0].joints)
    long = float(np.linalg.norm(np.diff(joints, axis=0), axis=1).sum())
    own = [m.surface.vertices[:, 1] for m in members if m.limb == name]
    wide = max(float(np.ptp(y)) for y in own) if own else 0.0
    return float(np.clip(THICK * long / max(wide, 1e-6), LEAST_STEP, 1.0))


def _bearing(
    rig: Rig, scene: SimScene, rollout: Rollout, postures: Sequence[Held], acts: Sequence[float]
) -> Bearing:
    time = np.asarray(rollout.time, float)
    p = np.nan_to_num(rollout.position[0, :, rig.index]).astype(float)
    q = np.nan_to_num(rollout.quaternion[0, :, rig.index]).astype(float)
    step = np.maximum(np.gradient(time), 1e-6)
    velocity = np.gradient(p, axis=0) / step[:, None]
    # What is moved at once by a swap is no step.
    velocity[np.linalg.norm(velocity, axis=1) > 40.0] = 0.0
    velocity = _smoothed(velocity, SMOOTH_S / float(np.median(step)))
    ahead = quat_rotate(q, np.tile((1.0, 0.0, 0.0), (len(q), 1)))
    up = quat_rotate(q, np.tile((0.0, 0.0, 1.0), (len(q), 1)))[:, 2]
    sinks = np.gradient(velocity[:, 2]) / step
    carried = (sinks > -0.5 * GRAVITY_MPS2).astype(float)
    flat = np.linalg.norm(velocity[:, :2], axis=1)
    along = np.einsum("ti,ti->t", velocity[:, :2], ahead[:, :2])
    go = going(time, np.where(along < -0.3 * flat, -flat, flat), carried, rig.leg, rig.reach)
    upright = np.clip((up - UPRIGHT) / 0.1, 0.0, 1.0)
    stands = np.ones(len(time))
    if rig.pose in ACTING and acts and float(go.much.max()) < 0.5:
        stands = _smooth((time - acts[0] - HELD_S) / THROUGH_S)
    elif rig.pose in ACTING and float(go.much.max()) < 0.5:
        stands = np.zeros(len(time))
    nothing, still = np.zeros(len(time)), np.zeros((len(time), 3))
    eased = _eased_into(rig, scene, rollout, postures, (p, q))
    if eased is None:
        return Bearing(go, stands, upright, None, nothing, still, nothing)
    return Bearing(go, stands, upright, *eased)


def _eased_into(
    rig: Rig,
    scene: SimScene,
    rollout: Rollout,
    postures: Sequence[Held],
    own: tuple[Floats, Floats],
) -> tuple[Pose, Floats, Floats, Floats] | None:
    """The posture of a body, how much it is in it, and its way there and back."""
    body = scene.bodies[rig.index]
    if not body.postures or rig.plan != "people":
        return None
    time, (p, q) = np.asarray(rollout.time, float), own
    gone = absent(scene, rollout.position[0], rollout.quaternion[0])
    rows = {h.name: h.row for h in postures}
    share, away, turned = np.zeros(len(time)), np.zeros((len(time), 3)), np.zeros(len(time))
    pose: Pose | None = None
    for name in body.postures:
        there = ~gone[:, scene.index(name)]
        row = rows.get(name)
        if row is None or not there.any() or row.pose not in POSES:
            continue
        into = [
            k for k in np.flatnonzero(there[1:] & ~there[:-1]) + 1 if not gone[k - 1, rig.index]
        ]
        out_of = [k for k in np.flatnonzero(~there[1:] & there[:-1]) + 1 if not gone[k, rig.index]]
        for k, way in [*((k, 1) for k in into), *((k, -1) for k in out_of)]:
            a, b = (k - 1, k) if way > 0 else (k, k - 1)
            e = (
                1.0 - np.abs(time - time[a]) / EASE_S
                if way > 0
                else 1.0 - (time - time[a]) / EASE_S
            )
            mine = (time <= time[a]) if way > 0 else (time >= time[a])
            e = _smooth(e) * mine
            back = q[a] * (-1.0, -1.0, -1.0, 1.0)
            jump = quat_rotate(back, p[b] - p[a])
            spin = _yaw(q[b]) - _yaw(q[a])
            spin = math.atan2(math.sin(spin), math.cos(spin))
            found = POSES["floor"] if POSES[row.pose].lies else POSES[row.pose]
            if pose is not None and found is not pose:
                e = e * 0.0  # one posture a body is eased into: the first of the scene
            pose = pose or found
            share = np.maximum(share, e)
            away = away + e[:, None] * np.array([jump[0], jump[1], jump[2] * found.seated])
            turned = turned + e * spin
    return None if pose is None else (pose, share, away, turned)


def _there(index: int, scene: SimScene, rollout: Rollout) -> tuple[tuple[float, float], ...] | None:
    """When a body is the one of its postures that is there [s]; None for always."""
    if not scene.bodies[index].postures:
        return None
    gone = absent(scene, rollout.position[0], rollout.quaternion[0])[:, index]
    edges = np.diff(np.concatenate([[True], gone, [True]]).astype(int))
    time = np.append(np.asarray(rollout.time, float), math.inf)
    starts, ends = np.flatnonzero(edges < 0), np.flatnonzero(edges > 0)
    return tuple((float(time[a]), float(time[b])) for a, b in zip(starts, ends, strict=True))


def _parts(
    rig: Rig,
    rollout: Rollout,
    bearing: Bearing,
    there: tuple[tuple[float, float], ...] | None,
) -> list[Part]:
    tracks = _tracks(rig, np.asarray(rollout.time, float), bearing)
    acts = {key: Act(there=there, track=track) for key, track in tracks.items()}
    out: list[Part] = []
    for member in rig.members:
        vertices = member.surface.vertices / CM_PER_M + rig.origin
        for level, faces in _cut(rig, member, vertices):
            used, index = np.unique(faces, return_inverse=True)
            act = acts.get((member.limb, level), acts[("", 0)])
            out.append(
                Part(
                    rig.index,
                    vertices[used],
                    index.reshape(-1, 3),
                    member.color,
                    None,
                    member.look,
                    member.surface.normals[used],
                    member.surface.uvs[used],
                    name=member.limb or "body",
                    act=act,
                )
            )
    return out


def _cut(rig: Rig, member: Member, vertices: Floats) -> list[tuple[int, NDArray[np.int64]]]:
    """The faces of a member above and below the limb's second joint, or beyond its last."""
    faces = np.asarray(member.surface.faces)
    if member.limb in ("", "trunk") or member.limb not in rig.limbs:
        return [(0, faces)]
    if member.tip:
        return [(2, faces)]
    top, middle, tip = rig.limbs[member.limb]
    a, b = middle - top, tip - middle
    long = float(np.linalg.norm(a) + np.linalg.norm(b))
    way = a / np.linalg.norm(a) + b / np.linalg.norm(b)
    way = way / max(float(np.linalg.norm(way)), 1e-9)
    beyond = (vertices[faces].mean(axis=1) - middle) @ way
    halves = [(0, faces[beyond < LAP * long]), (1, faces[beyond > -LAP * long])]
    return [(level, own) for level, own in halves if len(own)]


def _tracks(rig: Rig, time: Floats, bearing: Bearing) -> dict[tuple[str, int], Track]:
    """The poses of every piece of a body, by limb and number from its top."""
    moved = _people(rig, bearing) if rig.plan == "people" else _beasts(rig, bearing)
    lift = -_lowest(rig, moved, bearing) * bearing.upright
    if bearing.posture is not None and bearing.posture.seated:
        lift = lift * (1.0 - bearing.eased) + bearing.eased * _sunk(rig)
    base = np.zeros((len(time), 3))
    base[:, 2] = lift
    return {
        key: _track(time, (pivot, at + base, turn), bearing)
        for key, (pivot, at, turn) in moved.items()
    }


def _sunk(rig: Rig) -> float:
    """How much lower than drawn the hips of who sits are above his seat's origin [m]."""
    hip = rig.limbs[rig.legs[0]][0]
    size = _size(rig)
    return float(0.1 * size - (hip[2] - rig.origin[2]))


def _size(rig: Rig) -> float:
    joints = rig.limbs[rig.legs[0]]
    return float(np.linalg.norm(np.diff(joints, axis=0), axis=1).sum()) * CM_PER_M / _LEG_CM


Piece = tuple[Floats, Floats, Floats]
"""Where a piece turns as it is drawn, shape [3], where that point goes [T, 3], and how it turns."""


def _track(time: Floats, piece: Piece, bearing: Bearing) -> Track:
    pivot, at, turn = piece
    # At least one pose, with what the whole body does on its way to a place.
    yaw = np.zeros((len(time), 4))
    yaw[:, 2], yaw[:, 3] = np.sin(0.5 * bearing.turned), np.cos(0.5 * bearing.turned)
    at = quat_rotate(yaw, at) + bearing.away
    turn = quat_multiply(yaw, turn)
    at = at - quat_rotate(turn, np.broadcast_to(pivot, at.shape))
    signs = np.sign(np.einsum("ti,ti->t", turn[1:], turn[:-1]))
    signs[signs == 0.0] = 1.0
    turn = turn * np.concatenate([[1.0], np.cumprod(signs)])[:, None]
    return Track(time, at, turn)


def _people(rig: Rig, bearing: Bearing) -> dict[tuple[str, int], Piece]:
    count = len(bearing.stands)
    posture, eased = bearing.posture, bearing.eased
    free = rig.pose in FREE or rig.pose in ACTING
    drawn = POSES.get(rig.pose, POSES["stand"])
    lean = drawn.lean * np.ones(count)
    if free:
        lean = lean + bearing.stands * (bearing.go.much * 8.0 * bearing.go.runs - drawn.lean)
    if posture is not None:
        lean = lean + eased * (posture.lean - lean)
    tilt = about_y(np.radians(lean - drawn.lean))
    pivot = rig.limbs["trunk"][0]
    middle = np.broadcast_to(pivot, (count, 3))
    out: dict[tuple[str, int], Piece] = {("trunk", 0): (pivot, middle, tilt)}
    out[("", 0)] = out[("trunk", 0)]
    for name, joints in rig.limbs.items():
        if name == "trunk":
            continue
        side = 1 if name.endswith("left") else -1
        k = 0 if side > 0 else 1
        arm = name.startswith("arm")
        own = (drawn.arms if arm else drawn.legs)[k]
        rest = (POSES["stand"].arms if arm else POSES["stand"].legs)[k]
        swing, bend, pitch = person(name, bearing.go)
        if not arm:
            swing, bend = rig.reach * swing, rig.reach * bend
        much = bearing.go.much
        goes = [
            rest.swing + much * (swing - rest.swing),
            np.full(count, rest.out * 0.6 + 0.4 * own.out if not arm else rest.out),
            rest.bend + much * (bend - rest.bend),
            rest.turn * arm + much * pitch * (not arm),
        ]
        as_drawn = [np.full(count, v) for v in (own.swing, own.out, own.bend, own.turn)]
        share = bearing.stands if (free or not arm) else np.zeros(count)
        angles = [a + share * (b - a) for a, b in zip(as_drawn, goes, strict=True)]
        if posture is not None:
            told = (posture.arms if arm else posture.legs)[k]
            ends = (told.swing, told.out, told.bend, told.turn)
            angles = [a + eased * (b - a) for a, b in zip(angles, ends, strict=True)]
            if not arm and not posture.gathers and rig.reach == 1.0:
                # Who goes down bends his knees ahead of him before they are on the ground.
                down = 4.0 * eased * (1.0 - eased) * min(1.0, told.bend / 90.0)
                angles[0] = angles[0] + CROUCH_DEG * down
                angles[2] = angles[2] + 1.6 * CROUCH_DEG * down
                angles[3] = angles[3] * eased**2
        swing, out_, bend, turn = gestured(name, angles, bearing.made) if arm else angles
        fore = swing + bend if arm else swing - bend
        upper = _hanging(swing, out_, side)
        lower = _hanging(fore, out_ - turn if arm else 0.3 * out_, side)
        root = np.broadcast_to(joints[0], (count, 3))
        if arm:
            root = middle + quat_rotate(tilt, root - middle)
            whole = about_y(np.radians(lean))
            upper, lower = quat_rotate(whole, upper), quat_rotate(whole, lower)
        out |= _limb(name, joints, root, upper, lower)
        if not arm:
            ankle = out[(name, 1)][1] + quat_rotate(
                out[(name, 1)][2], np.broadcast_to(joints[2] - joints[1], (count, 3))
            )
            level = about_y(np.radians(turn - rig.pitches[name]))
            out[(name, 2)] = (joints[2], ankle, level)
    return out


def _limb(
    name: str, joints: Floats, root: Floats, upper: Floats, lower: Floats
) -> dict[tuple[str, int], Piece]:
    """Both halves of a limb whose bones point in directions, shape [T, 3] each."""
    a, b = joints[1] - joints[0], joints[2] - joints[1]
    first = between(a / np.linalg.norm(a), upper)
    second = between(b / np.linalg.norm(b), lower)
    knee = root + float(np.linalg.norm(a)) * upper
    return {(name, 0): (joints[0], root, first), (name, 1): (joints[1], knee, second)}


def _beasts(rig: Rig, bearing: Bearing) -> dict[tuple[str, int], Piece]:
    count = len(bearing.stands)
    still = np.zeros((count, 4))
    still[:, 3] = 1.0
    out: dict[tuple[str, int], Piece] = {("", 0): (np.zeros(3), np.zeros((count, 3)), still)}
    for name in rig.legs:
        joints = rig.limbs[name]
        swing, fold = (rig.reach * v * bearing.go.much for v in beast(name, bearing.go))
        first, second = about_y(-np.radians(swing)), about_y(-np.radians(swing + fold))
        root = np.broadcast_to(joints[0], (count, 3))
        knee = root + quat_rotate(first, np.broadcast_to(joints[1] - joints[0], (count, 3)))
        out[(name, 0)] = (joints[0], root, first)
        out[(name, 1)] = (joints[1], knee, second)
    return out


def _lowest(rig: Rig, moved: Mapping[tuple[str, int], Piece], bearing: Bearing) -> Floats:
    """How high the lowest point of the legs is over the ground [m], shape [T]."""
    count, size = len(bearing.stands), _size(rig)
    heights: list[Floats] = []
    for name in rig.legs:
        joints = rig.limbs[name]
        _, knee, turn = moved[(name, 1)]
        if rig.plan == "beasts":
            foot = knee + quat_rotate(turn, np.broadcast_to(joints[2] - joints[1], (count, 3)))
            heights.append(foot[:, 2] - joints[2][2])
            continue
        heights.append(knee[:, 2] - _KNEE_CM / CM_PER_M * size - rig.origin[2])
        _, ankle, level = moved[(name, 2)]
        pitched = quat_multiply(level, about_y(np.full(count, math.radians(rig.pitches[name]))))
        for x, z in _SOLE_CM:
            at = np.array([x, 0.0, z]) / CM_PER_M * size
            heights.append(
                ankle[:, 2] + quat_rotate(pitched, np.broadcast_to(at, (count, 3)))[:, 2]
                - rig.origin[2]
            )  # fmt: skip
        hip = moved[(name, 0)][1]
        heights.append(hip[:, 2] - _SEAT_CM / CM_PER_M * size - rig.origin[2])
    return np.min(heights, axis=0)


def about_y(angle: Floats) -> Floats:
    """Turns by angles [rad] about Y as quaternions (x, y, z, w), shape [T, 4]."""
    nothing = np.zeros(np.shape(angle))
    return np.stack([nothing, np.sin(0.5 * angle), nothing, np.cos(0.5 * angle)], axis=-1)


def between(one: Floats, others: Floats) -> Floats:
    """The shortest turns from a direction to others, shape [T, 4]."""
    cross = np.cross(np.broadcast_to(one, others.shape), others)
    q = np.concatenate([cross, 1.0 + (others @ one)[:, None]], axis=1)
    return q / np.maximum(np.linalg.norm(q, axis=1, keepdims=True), 1e-9)


def _hanging(swing: Floats, out: Floats, side: int) -> Floats:
    """Directions of bones that hang, swung forwards and outwards [deg], shape [T, 3]."""
    f, o = np.radians(swing), np.radians(out)
    return np.stack(
        [np.sin(f) * np.cos(o), side * np.sin(o), -np.cos(f) * np.cos(o)], axis=1
    )  # fmt: skip


def _yaw(q: Floats) -> float:
    x, y, z, w = (float(v) for v in q)
    return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


def _smooth(share: Floats) -> Floats:
    share = np.clip(share, 0.0, 1.0)
    return share * share * (3.0 - 2.0 * share)


def _smoothed(values: Floats, width: float) -> Floats:
    """Averages along the first axis under a bell that is `width` frames wide."""
    reach = max(1, math.ceil(3.0 * width))
    bell = np.exp(-0.5 * (np.arange(-reach, reach + 1) / max(width, 1e-3)) ** 2)
    bell = bell / bell.sum()
    padded = np.pad(values, ((reach, reach), (0, 0)), mode="edge")
    return np.stack([np.convolve(c, bell, mode="valid") for c in padded.T], axis=1)
