"""Executes the program of a manifest.json, with nothing of this project, on any engine's bodies.

A body has linvel, angvel, mass, linear_damping and angular_damping, as Rapier's have;
play_manifest.py beside this file plays whole scenes with it.
"""

import math


class Program:
    def __init__(self, manifest):
        self.waiting, self.driving = list(manifest["program"]["primitives"]), []
        self.gravity_z = manifest["gravity"][2]

    def before_step(self, t, dt, body_of, touching, set_friction):
        """Acts before the step from t to t + dt; touching: pairs of names in the step before."""
        for p in [p for p in self.waiting if p.get("start", p.get("time")) <= t + dt / 2]:
            body = body_of(p["body"])
            if p["kind"] == "HoldVelocity":
                hit = any({p["body"], other} in touching for other in p["until_contact"])
                late = p["end"] is not None and t + dt / 2 > p["end"]
                if not late and not (hit and p in self.driving):
                    self.driving.append(p)
                    drive(p, body, t - p["start"], self.gravity_z * dt)
                    continue
            elif p["kind"] == "SetVelocity":
                body.linvel = tuple(p["linear"])
                if p["angular"] is not None:
                    body.angvel = tuple(p["angular"])
            elif p["kind"] == "ApplyImpulse":
                v, j = tuple(body.linvel), p["impulse"]
                body.linvel = tuple(v[i] + j[i] / body.mass for i in range(3))
            elif p["kind"] == "AdjustProperties":
                for name in ("linear_damping", "angular_damping"):
                    if p[name] is not None:
                        setattr(body, name, p[name])
                if p["friction"] is not None:
                    set_friction(p["body"], p["friction"])
            self.waiting.remove(p)


def drive(p, body, s, pull):
    """Motion s seconds after its start: rolling, or flying against the step's pull of gravity."""
    speed = max(0.0, p["speed"] + p["acceleration"] * s)
    if p["acceleration"] > 0 and p["max_speed"] is not None:
        speed = min(speed, p["max_speed"])
    heading, r = p["heading"] + p["turn_rate"] * s, 0.0 if "climb" in p else p["roll_radius"]
    vx, vy = speed * math.cos(heading), speed * math.sin(heading)
    body.linvel = (vx, vy, p["climb"] - pull if "climb" in p else tuple(body.linvel)[2])
    body.angvel = (-vy / r, vx / r, 0.0) if r else (0.0, 0.0, p["turn_rate"])
