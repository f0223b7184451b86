"""Checks of what moves on the ground: gaining, losing and keeping speed, slipping, leaving it."""

from __future__ import annotations

import math

import numpy as np

from esg.metrics.detection import runs
from esg.metrics.plausibility.facts import Bools, Facts
from esg.metrics.plausibility.grounds import ROADS, beyond, flats
from esg.metrics.plausibility.limits import limit
from esg.metrics.plausibility.record import Check, Worst
from esg.metrics.replay import Floats
from esg.thresholds import MOVING_MPS, STOPPED_MPS, UPRIGHT_DEG
from esg.units import quat_rotate

_BACKWARDS = math.cos(math.radians(45.0))
"""What goes within 45 degrees of where its back points goes backwards; else it slips, or turns."""


def acceleration(f: Facts) -> Check:
    """Gains speed, or turns, faster than its kind can while nothing pushes it.

    What lands is pressed on the ground, and gains as much more as friction then gives it. What has
    no power of its own gains as much as friction gives it, and may be launched.
    """
    worst = Worst()
    for i in f.dynamic:
        motion, v = f.motion(i), f.replay.velocity[:, i]
        level = np.linalg.norm(v[:, :2], axis=1)
        gain = f.gains(level)
        powered, free = f.powered(i), f.clear(f.struck(i), f.guided(i))
        if not motion.own_power:
            free &= f.clear(f.launched(i))
        driven = ~f.clear(powered) | motion.own_power
        normal = np.maximum(f.gains(v[:, 2]) + f.g, 0.0)
        on_ground = ~f.clear(f.level(i))
        lands = np.where(on_ground, f.pair(i) * np.maximum(normal - f.g, 0.0), 0.0)
        _look(f, worst, i, gain, motion.accelerate_mps2 + lands, free & driven)
        given = np.where(on_ground, f.friction(i) * normal, 0.0) + limit("free flight")
        _look(f, worst, i, gain, given, free & ~driven & f.clear(f.touching(i) & ~f.level(i)))
        if motion.own_power:
            side = _sideways(f, i)
            most = np.full(len(side), f.friction(i) * f.g * (1.0 + limit("brake tolerance")))
            _look(f, worst, i, side, most, free & f.clear(~powered), "in a turn")
    return worst.check("acceleration", "m/s2")


def _sideways(f: Facts, i: int) -> Floats:
    """Acceleration across the way over each window [m/s^2]."""
    v = f.replay.velocity[:, i, :2]
    n = f.window
    a = f.gains(v)
    mean = 0.5 * (v[n:] + v[:-n])
    size = np.linalg.norm(mean, axis=1)
    across = np.abs(mean[:, 0] * a[:, 1] - mean[:, 1] * a[:, 0])
    return np.where(size > MOVING_MPS, across / np.maximum(size, MOVING_MPS), 0.0)


def _look(
    f: Facts, worst: Worst, i: int, value: Floats, most: Floats, where: Bools, note: str = ""
) -> None:
    """Considers the window in which a value is largest against its limit."""
    if where.any():
        k = int(np.argmax(np.where(where, value / np.maximum(most, 1e-9), -np.inf)))
        if value[k] > 0.0:
            time = float(f.replay.time[k])
            worst.look(float(value[k]), float(most[k]), f.name(i), time, note)


def braking(f: Facts) -> Check:
    """Loses speed faster than friction and its drag allow while nothing pushes it."""
    worst = Worst()
    for i in f.dynamic:
        motion, v = f.motion(i), f.replay.velocity[:, i]
        level = np.linalg.norm(v[:, :2], axis=1)
        normal = np.maximum(f.gains(v[:, 2]) + f.g, f.g)
        drag = f.replay.scene.bodies[i].linear_damping * level[: -f.window]
        most = f.friction(i) * normal * (1.0 + limit("brake tolerance")) + drag
        stopping = level[f.window :] < limit("creep")
        most += np.where(stopping, limit("creep") / (f.window * f.replay.frame_s), 0.0)
        free = f.clear(f.struck(i), f.guided(i))
        free &= f.clear(~f.powered(i)) if motion.flies else f.clear(~f.level(i))
        _look(f, worst, i, -f.gains(level), most, free)
    return worst.check("braking", "m/s2")


def side_slip(f: Facts) -> Check:
    """Slides sideways on upright wheels farther than the energy that it lost pays for.

    A tyre that slips across takes mu m g per metre, and no more than it is pressed on the ground.
    Shoved at v it slides v^2/(2 mu g) far. What slips is the tyres, below the centre of mass: of a
    bicycle that falls over they stay where they are.
    """
    worst = Worst()
    for i in f.dynamic:
        body, motion = f.replay.scene.bodies[i], f.motion(i)
        if not body.wheeled or motion.moves in ("casters", "air", "water", "legs"):
            continue
        v, q = f.replay.velocity[:, i], f.replay.quaternion[:, i]
        down = quat_rotate(q, np.array([0.0, 0.0, min(body.origin_offset[2], 0.0)]))
        foot = v + np.cross(f.replay.spin[:, i], down)
        across = np.abs((quat_rotate(q, np.array([0.0, 1.0, 0.0])) * foot).sum(axis=1))
        upright = f.replay.up(i)[:, 2] >= math.cos(math.radians(UPRIGHT_DEG))
        slips = (across > STOPPED_MPS) & upright & f.level(i) & ~f.struck(i)
        pressed = np.clip(1.0 + np.gradient(v[:, 2], f.replay.time) / f.g, 0.0, 1.0)
        turning = body.inertia[2][2] / body.mass * f.replay.spin[:, i, 2] ** 2
        energy = 0.5 * ((v[:, :2] ** 2).sum(axis=1) + turning)
        for start, stop in runs(slips):
            way = float((across * pressed)[start:stop].sum() * f.replay.frame_s)
            lost = max(float(energy[start] - energy[min(stop, len(energy) - 1)]), 0.0)
            most = lost / (f.friction(i) * f.g) + limit("side slip tolerance")
            worst.look(way, most, f.name(i), float(f.replay.time[start]))
    return worst.check("side_slip", "m")


def speed(f: Facts) -> Check:
    """Goes faster than its kind does before anything pushes it, unless the prompt asks for it."""
    worst = Worst()
    for i in f.dynamic:
        free = f.upto_struck(i)
        own = f.replay.speed[:, i][free]
        if not len(own):
            continue
        asked = f.told.speeds_mps.get(f.name(i), 0.0) * (1.0 + limit("prescribed"))
        back = _backwards(f, i)[free]
        ahead = np.full(len(own), f.motion(i).speed_mps)
        own_most = np.where(back, _rolled_back(f, i)[free], ahead)
        most = np.maximum(own_most, asked)
        k = int(np.argmax(own / most))
        note = "backwards" if back[k] else ""
        note = "prescribed by the prompt" if asked > own_most[k] else note
        worst.look(float(own[k]), float(most[k]), f.name(i), float(f.replay.time[k]), note)
    return worst.check("speed", "m/s")


def _backwards(f: Facts, i: int) -> Bools:
    """Frames at which what has a front and moves by itself on the ground goes away from it."""
    motion, v = f.motion(i), f.replay.velocity[:, i]
    if not motion.own_power or motion.flies:
        return np.zeros(len(v), bool)
    front = quat_rotate(f.replay.quaternion[:, i], np.array([1.0, 0.0, 0.0]))
    along = (front[:, :2] * v[:, :2]).sum(axis=1)
    upright = f.replay.up(i)[:, 2] >= math.cos(math.radians(UPRIGHT_DEG))
    return upright & (along < -_BACKWARDS * np.linalg.norm(v, axis=1))


def _rolled_back(f: Facts, i: int) -> Floats:
    """The greatest speed [m/s] backwards: of its kind, and what the way down added to it."""
    height = f.replay.position[:, i, 2]
    down = np.maximum(height[0] - height, 0.0)
    return np.sqrt(f.motion(i).reverse_mps ** 2 + 2.0 * f.g * down)


def leaving(f: Facts) -> Check:
    """Moves beyond the drawn ground, or drives off the road that it set out on."""
    worst = Worst()
    scene = f.replay.scene
    flat = flats(scene)
    roads = [i for i in flat if scene.bodies[i].category in ROADS]
    for i in f.dynamic:
        way = f.replay.position[:, i]
        out = beyond(scene, way, flat)
        k = int(np.argmax(out))
        time = float(f.replay.time[k])
        worst.look(float(out[k]), limit("off the ground"), f.name(i), time, "off the ground")
        if f.motion(i).moves != "road" or f.told.off_road or not roads:
            continue
        off = beyond(scene, way, roads)
        goes = f.upto_struck(i) & np.logical_or.accumulate(f.powered(i)) & f.level(i)
        if off[0] > 0.0 or not goes.any() or _meets_off_road(f, i, off):
            continue
        k = int(np.argmax(np.where(goes, off, -1.0)))
        time = float(f.replay.time[k])
        worst.look(float(off[k]), limit("off the ground"), f.name(i), time, "off the road")
    return worst.check("leaving", "m")


def _meets_off_road(f: Facts, i: int, off: Floats) -> bool:
    """Whether what it runs into, or nearly, stands beside the road: its way leads there."""
    struck = np.flatnonzero(f.struck(i))
    return bool(len(struck)) and bool(off[struck[0]] > 0.0)
