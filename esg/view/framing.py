"""Where to look from: cameras that see who takes part in a moment as well as can be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
import itertools
import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import FRAGMENT, Rollout, SimScene
from esg.graph.models import EsgDocument, Predicate
from esg.units import quat_rotate
from esg.view.camera import Camera, box_corners, frame_points
from esg.view.moments import FAR_REACH, HAND_REACH, REACH, Moment, moments_of
from esg.view.render import Renderer

if TYPE_CHECKING:
    from esg.metrics.models import SceneVerdict

PANEL_PX = (480, 320)
ACTION_LEAD_S, ACTION_TAIL_S = 0.6, 0.4
"""Fixed cameras keep in view what happens so long before the first event and after the last."""
SPECK = 20.0
"""What is so many times as large as what meets it is shown in part: else that is a few pixels."""
ROOM_ALONE = 0.9
"""Room on every side of a single body, in its own sizes."""
ELEVATIONS = ((24, 42), (58, 74))
"""Heights of the viewpoints [deg]; the second ones where the first hide what a moment is about."""
USUAL_DEG, ALOFT_DEG = 24, 6
"""The natural heights: of what is on the ground, and of what is in the air, behind which the place
is seen, and not the ground alone."""
ALOFT_M = 0.4
"""What is in the air is higher than this, and than its own size."""
HIDDEN = 0.3
"""Share of its size below which what a moment is about counts as hidden."""


def frame_at(rollout: Rollout, time: float) -> int:
    """Index of the frame nearest to a time [s]."""
    return int(np.argmin(np.abs(rollout.time - time)))


def pose(
    renderer: Renderer, rollout: Rollout, frame: int, angles: NDArray[np.float64] | None = None
) -> None:
    """Puts all bodies where they are in a frame; angles of wheels are [rad], shape [T, W]."""
    turned = None if angles is None else angles[frame]
    renderer.pose(rollout.position[0, frame], rollout.quaternion[0, frame], turned)


def corners_of(scene: SimScene, rollout: Rollout, frame: int, body: int) -> NDArray[np.float64]:
    """World corners of a body's bounding box in a frame [m], shape [8, 3]."""
    b = scene.bodies[body]
    return box_corners(
        rollout.position[0, frame, body],
        rollout.quaternion[0, frame, body],
        b.half_extents,
        np.asarray(b.origin_offset),
    )


def points_in_view(
    scene: SimScene, rollout: Rollout, moment: Moment, frame: int
) -> NDArray[np.float64]:
    """Points to keep in the picture: the focus, then its company while the picture stays close.

    Of a large focus, bodies that have flown off are left out in the same way.
    """
    boxes = {i: corners_of(scene, rollout, frame, i) for i in (*moment.focus, *moment.company)}
    movers = [i for i in moment.focus if not scene.bodies[i].static] or list(moment.focus)
    middle = np.median([boxes[i].mean(axis=0) for i in movers], axis=0)
    if moment.at_hand:
        boxes |= _near(boxes, moment.focus, movers)

    def nearest_first(bodies: Sequence[int]) -> list[int]:
        return sorted(bodies, key=lambda i: (float(np.linalg.norm(boxes[i].mean(0) - middle)), i))

    order = nearest_first(moment.focus)
    keep = order if len(order) <= 4 else order[:2]
    points = np.concatenate([boxes[i] for i in keep])
    span = float(np.ptp(points, axis=0).max())
    limit = max(moment.reach * span, min(moment.at_hand, HAND_REACH * span))
    for i in [*(j for j in order if j not in keep), *nearest_first(moment.company)]:
        wider = np.concatenate([points, boxes[i]])
        if float(np.ptp(wider, axis=0).max()) <= limit:
            points = wider
        elif moment.reach >= FAR_REACH and i in moment.company:
            part = _part_within(boxes[i], points, limit)
            points = points if part is None else np.concatenate([points, part])
    return points


def _part_within(
    box: NDArray[np.float64], points: NDArray[np.float64], limit: float
) -> NDArray[np.float64] | None:
    """What of a box can be shown in a picture so wide: of a tree beside a bird, the trunk."""
    low, high = points.min(axis=0), points.max(axis=0)
    room = np.maximum(0.5 * (limit - (high - low)), 0.0)
    a, b = np.maximum(box.min(axis=0), low - room), np.minimum(box.max(axis=0), high + room)
    return np.array(list(itertools.product(*zip(a, b, strict=True)))) if np.all(a < b) else None


def _near(
    boxes: dict[int, NDArray[np.float64]], focus: Sequence[int], movers: Sequence[int]
) -> dict[int, NDArray[np.float64]]:
    """Of what is very large beside a mover, the part around it: a net where the ball meets it."""
    small = min(movers, key=lambda i: float(np.ptp(boxes[i], axis=0).max()))
    room = 0.5 * SPECK * float(np.ptp(boxes[small], axis=0).max())
    low, high = boxes[small].min(axis=0) - room, boxes[small].max(axis=0) + room
    out: dict[int, NDArray[np.float64]] = {}
    for i in focus:
        a, b = np.maximum(boxes[i].min(axis=0), low), np.minimum(boxes[i].max(axis=0), high)
        if i != small and float(np.ptp(boxes[i], axis=0).max()) > 2.0 * room and np.all(a <= b):
            out[i] = np.array(list(itertools.product(*zip(a, b, strict=True))))
    return out


def camera_for(
    scene: SimScene,
    rollout: Rollout,
    moment: Moment,
    frame: int,
    azimuth: float,
    elevation: float,
) -> Camera:
    """The camera that sees a moment from a direction [rad], with a little room around it."""
    points = points_in_view(scene, rollout, moment, frame)
    span = float(np.ptp(points, axis=0).max())
    # A little room around the action, so that one sees where it happens.
    low, high = points.min(axis=0), points.max(axis=0)
    pad = (ROOM_ALONE if len(points) == 8 else 0.06) * span
    low = np.array([low[0] - pad, low[1] - pad, max(0.0, low[2] - pad)])
    high = high + np.array([pad, pad, 0.0])
    corners = np.array(list(itertools.product(*zip(low, high, strict=True))))
    return frame_points(corners, azimuth, elevation, PANEL_PX[0] / PANEL_PX[1])


_SIDE_WORDS = {
    "left_of": ("left",),
    "right_of": ("right",),
    "in_front_of": ("front", "before", "ahead"),
    "behind": ("behind", "back", "rear"),
}
"""How the sides of the viewer are called, by the relation."""


def told_side(doc: EsgDocument) -> float | None:
    """Azimuth from which left, right, front and back are as the prompt says; None if it does not.

    The viewer stands at +Y: from elsewhere a dog that runs toward the camera runs past it.
    """
    told = doc.statements or ()
    ways = (s for s in told if s.predicate is Predicate.MOVES and s.direction in _VIEWERS_WAYS)
    sides = (s for s in told if s.predicate.value in _VIEWERS_SIDES)
    relations = doc.spatial_relation_graph.edges.binary_relations
    # What a verb implies ("overtakes": it begins behind) is said of no viewer.
    prompt = doc.scene_definition.original_description.lower()
    words = (_SIDE_WORDS.get(r.relation_type.value, ()) for r in relations)
    places = (own for own in words if any(word in prompt for word in own))
    said = any(True for _ in itertools.chain(ways, sides, places))
    return math.pi / 2 if said else None


def gestures_side(scene: SimScene, rollout: Rollout) -> float | None:
    """Azimuth from which gestures are seen that are made where nobody moves, obliquely from ahead.

    Args:
        scene: The bodies.
        rollout: Their motion; its first world.
    """
    making = [i for i, b in enumerate(scene.bodies) if b.gestures]
    moved = np.ptp(np.nan_to_num(rollout.position[0]), axis=0).max(axis=-1)
    there = [i for i, b in enumerate(scene.bodies) if not b.static and b.category != FRAGMENT]
    if not making or max((float(moved[i]) for i in there), default=0.0) > 0.3:
        return None
    return seen_ahead(rollout, making, 0)


def seen_ahead(rollout: Rollout, bodies: Sequence[int], frame: int) -> float | None:
    """Azimuth obliquely ahead of bodies, to their right [rad]; None if they face nowhere."""
    rows = list(bodies)
    ahead = quat_rotate(rollout.quaternion[0, frame, rows], np.array([1.0, 0.0, 0.0])).sum(axis=0)
    if float(np.hypot(ahead[0], ahead[1])) < 0.2:
        return None
    return math.atan2(ahead[1], ahead[0]) + math.radians(AHEAD_DEG)


AHEAD_DEG = -38.0
"""So far beside straight ahead of who makes a gesture a camera looks at him: on his right hand."""


def viewpoint(
    scene: SimScene,
    rollout: Rollout,
    moments: list[Moment],
    renderer: Renderer,
    told: float | None = None,
) -> tuple[float, float]:
    """Azimuth and elevation from which the cast is seen best over all moments.

    The natural place is beside the motion, on the viewer's (+Y) side; other directions compete by
    how much of every framed body is visible at every moment. Where the prompt speaks of left and
    right (`told_side`), the viewer's own direction takes that place, and only near ones compete.
    """
    side = _beside(_motion_direction(scene, rollout, moments)) if told is None else told
    turns = (0, 30, -30, 60, -60, 180) if told is None else (0, 30, -30)
    natural, levels = USUAL_DEG, ELEVATIONS
    if _aloft(scene, rollout, moments):
        natural, levels = ALOFT_DEG, ((ALOFT_DEG, USUAL_DEG), *ELEVATIONS)
    best, best_score = (side, math.radians(natural)), -math.inf
    # First, last and the middle moment stand for all: this is half of the work otherwise.
    moments = [moments[k] for k in sorted({0, len(moments) // 2, len(moments) - 1})]
    least = 0.0
    for elevations in levels:
        if least >= HIDDEN:
            break  # only what lies at the bottom of something is looked at from above
        for turn, elevation in itertools.product(turns, elevations):
            view = (side + math.radians(turn), math.radians(elevation))
            seen = []
            for moment in moments:
                frame = frame_at(rollout, moment.time)
                pose(renderer, rollout, frame)
                camera = camera_for(scene, rollout, moment, frame, *view)
                seen.append(_visibility(scene, rollout, moment, frame, camera, renderer))
            preference = 0.0015 * abs(turn) + 0.004 * abs(elevation - natural)
            score = min(seen) + 0.5 * sum(seen) / len(seen) - preference
            if score > best_score + 1e-9:
                best, best_score, least = view, score, min(seen)
    return best


def _aloft(scene: SimScene, rollout: Rollout, moments: Sequence[Moment]) -> bool:
    """Whether all that is framed is high in the air, at every moment."""
    for moment in moments:
        frame = frame_at(rollout, moment.time)
        for i in moment.focus:
            box = corners_of(scene, rollout, frame, i)
            if box[:, 2].min() < max(ALOFT_M, float(np.ptp(box, axis=0).max())):
                return False
    return True


def camera_of_moment(
    scene: SimScene,
    rollout: Rollout,
    moment: Moment,
    view: tuple[float, float],
    renderer: Renderer,
) -> Camera:
    """The camera of one moment: from the common viewpoint unless something hides it there.

    Args:
        scene: The bodies.
        rollout: Their motion.
        moment: What happens.
        view: Azimuth and elevation that all moments share [rad].
        renderer: Draws the ids of what is seen; left posed at the moment.
    """
    frame = frame_at(rollout, moment.time)
    pose(renderer, rollout, frame)
    shared = camera_for(scene, rollout, moment, frame, *view)
    best, best_seen = shared, _visibility(scene, rollout, moment, frame, shared, renderer)
    if best_seen >= HIDDEN:
        return shared
    for turn, rise in (
        (0, 25),
        (40, 0),
        (-40, 0),
        (40, 25),
        (-40, 25),
        (90, 10),
        (-90, 10),
        (0, 45),
    ):
        elevation = min(view[1] + math.radians(rise), math.radians(75))
        other = (view[0] + math.radians(turn), elevation)
        camera = camera_for(scene, rollout, moment, frame, *other)
        seen = _visibility(scene, rollout, moment, frame, camera, renderer)
        if seen > best_seen + 0.05:
            best, best_seen = camera, seen
        if best_seen >= 2 * HIDDEN:
            break
    return best


def _visibility(
    scene: SimScene,
    rollout: Rollout,
    moment: Moment,
    frame: int,
    camera: Camera,
    renderer: Renderer,
) -> float:
    """Mean over the focus of visible pixels over those of its projected box, capped at 1."""
    width, height = 72, 48
    counts = renderer.visible(camera, moment.focus, width)
    shares = []
    for body in moment.focus:
        pixels, ahead = camera.project(corners_of(scene, rollout, frame, body), width, height)
        if not ahead.all():
            shares.append(0.0)
            continue
        area = float(np.prod(np.maximum(np.ptp(pixels, axis=0), 1.0)))
        shares.append(min(1.0, counts[body] / (0.45 * area)))
    return sum(shares) / max(1, len(shares))


def _motion_direction(
    scene: SimScene, rollout: Rollout, moments: list[Moment]
) -> NDArray[np.float64]:
    last = frame_at(rollout, moments[-1].time)
    moved = rollout.position[0, last] - rollout.position[0, 0]
    focus = sorted({i for m in moments for i in m.focus})
    longest = max(focus, key=lambda i: float(np.linalg.norm(moved[i, :2])))
    if float(np.linalg.norm(moved[longest, :2])) > 0.2:
        return moved[longest, :2].astype(float)
    centers = rollout.position[0, 0, focus, :2].astype(float)
    if len(focus) == 1:
        # What stays where it is shows its side: a fox that jumps, not its tail.
        front = quat_rotate(rollout.quaternion[0, 0, focus[0]], np.array([1.0, 0.0, 0.0]))
        if float(np.linalg.norm(front[:2])) > 0.2:
            return front[:2].astype(float)
    if len(focus) > 1:
        spread = centers - centers.mean(axis=0)
        return np.linalg.svd(spread)[2][0]
    return np.array([1.0, 0.0])


def action_points(
    scene: SimScene,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    doc: EsgDocument,
    steps: int,
) -> NDArray[np.float64]:
    """Corners of what the scene is about at `steps` instants around its events.

    Without events, from the start to the end.

    Args:
        scene: The bodies.
        rollout: Their motion.
        verdict: Events, whose participants count.
        doc: Relations, for what the participants stand on.
        steps: Number of instants.

    Returns:
        World points [m], shape [n, 3].
    """
    moments = moments_of(scene, rollout, verdict, doc)
    first, start, end = moments[0], moments[0].time, moments[-1].time
    if len(moments) > 2:
        start = max(start, moments[1].time - ACTION_LEAD_S)
        end = min(end, moments[-2].time + ACTION_TAIL_S)
    points = [
        points_in_view(scene, rollout, replace(first, reach=REACH), frame_at(rollout, float(time)))
        for time in np.linspace(start, end, steps)
    ]
    return np.concatenate(points)


def facing_side(
    scene: SimScene, rollout: Rollout, verdict: SceneVerdict | None, doc: EsgDocument
) -> float:
    """Azimuth that the prompt tells, or beside the motion, on the viewer's (+Y) side [rad]."""
    told = told_side(doc)
    if told is not None:
        return told
    return _beside(_motion_direction(scene, rollout, moments_of(scene, rollout, verdict, doc)))


_VIEWERS_WAYS = ("left", "right", "front", "back")
_VIEWERS_SIDES = ("left_of", "right_of", "in_front_of", "behind")


def _beside(along: NDArray[np.float64]) -> float:
    side = math.atan2(along[1], along[0]) + math.pi / 2
    return side + math.pi if math.sin(side) < -1e-6 else side
