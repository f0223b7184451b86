"""Executes the program of a manifest.json, with nothing of this project, on any engine's bodies.
A body has what Rapier's have; play_manifest.py beside this file plays whole scenes with it.
Postures do not change here (ChangeBody is passed over): who sits down stands."""

import math

from read_liquid import buoy
from read_traction import Traction, moving


class Program:
    def __init__(self, manifest):
        self.waiting, self.driving = list(manifest["program"]["primitives"]), []
        self.gravity_z, self.traction = manifest["gravity"][2], Traction(manifest)

    def before_step(self, t, dt, body_of, touching, set_friction):
        """Acts before the step from t to t + dt; touching: pairs of names in the step before."""
        self.traction.look(dt, body_of)
        for p in [p for p in self.waiting if p.get("start", p.get("time")) <= t + dt / 2]:
            body = body_of(p["body"])
            if p["kind"] in LASTING:
                hit = any({p["body"], b} in touching for b in p.get("until_contact", ()))
                end = p["start"] + p["times"][-1] if "times" in p else p["end"]
                if not (end is not None and t + dt / 2 > end) and not (hit and p in self.driving):
                    self.driving.append(p)
                    LASTING[p["kind"]](p, body, t - p["start"], dt, self.gravity_z * dt)
                    continue
            elif p["kind"] == "SetVelocity":
                body.linvel = tuple(p["linear"])
                body.angvel = tuple(p["angular"] or body.angvel)
            elif p["kind"] == "ApplyImpulse":
                v, j = tuple(body.linvel), p["impulse"]
                body.linvel = tuple(v[i] + j[i] / body.mass for i in range(3))
            elif p["kind"] == "AdjustProperties":
                for name in ("linear_damping", "angular_damping"):
                    setattr(body, name, getattr(body, name) if p[name] is None else p[name])
                if p["friction"] is not None:
                    set_friction(p["body"], p["friction"])
                self.traction.adjust(p)
            self.waiting.remove(p)
        self.traction.act(dt, [p for p in self.driving if p in self.waiting], body_of)


def drive(p, body, s, dt, pull):
    """Motion s seconds after its start: rolling, or flying against the step's pull of gravity."""
    speed = max(0.0, p["speed"] + p["acceleration"] * s)
    if p["acceleration"] > 0 and p["max_speed"] is not None:
        speed = min(speed, p["max_speed"])
    heading, r = p["heading"] + p["turn_rate"] * s, 0.0 if "climb" in p else p["roll_radius"]
    vx, vy = moving(p, tuple(body.linvel), speed, heading, dt)
    body.linvel = (vx, vy, p["climb"] - pull if "climb" in p else tuple(body.linvel)[2])
    body.angvel = (-vy / r, vx / r, 0.0) if r else (0.0, 0.0, p["turn_rate"])


def guide(p, body, s, dt, pull):
    """Along its path, returning to it where it has left it (10 m/s for a metre)."""
    (x, y), at = (place(p, s), place(p, s + dt)), tuple(body.translation)
    v = [(y[i] - x[i]) / dt + 10 * (x[i] - at[i]) for i in range(3)]
    body.linvel, body.angvel = (v[0], v[1], v[2] - pull), (0.0, 0.0, p["turn_rate"])


def place(p, s):
    """The cubic through the two points around s, with their velocities; straight outside."""
    t, knots = p["times"], list(zip(p["points"], p["velocities"], strict=True))
    k = max([i for i, time in enumerate(t) if time < s], default=0)
    (x, v), h = knots[k], s - t[k]
    if k + 1 == len(t) or s < t[0]:
        return [x[i] + v[i] * h for i in range(3)]
    (y, w), d = knots[k + 1], t[k + 1] - t[k]
    u = h / d
    a, b = u * u * (3 - 2 * u), d * u * (1 - u)
    return [x[i] + a * (y[i] - x[i]) + b * ((1 - u) * v[i] - u * w[i]) for i in range(3)]


def spin(p, body, s, dt, pull):
    """About its axis; where it goes is physics."""
    body.angvel = tuple(p["rate"] * a / math.hypot(*p["axis"]) for a in p["axis"])


LASTING = {"HoldVelocity": drive, "GuideAlong": guide, "HoldSpin": spin, "BuoyUp": buoy}
