"""What a liquid does to a body of a manifest.json; read_manifest.py beside this file calls it."""

import math


def buoy(p, body, s, dt, pull):
    """Borne up and slowed down by a liquid, as far as it is in it."""
    x, y, z = (a - b for a, b in zip(tuple(body.translation), p["center"], strict=True))
    heading = p["heading"]
    i, j, k, w = body.rotation.quaternion
    up = (2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j))
    half = sum(abs(u) * e for u, e in zip(up, p["extents"], strict=True))
    along = math.cos(heading) * x + math.sin(heading) * y
    across = math.cos(heading) * y - math.sin(heading) * x
    f = min(1.0, (half - z) / (2 * half))
    if abs(along) > p["basin"][0] or abs(across) > p["basin"][1] or z < -2 * p["basin"][2] or f < 0:
        return
    f, v = f * f * (3 - 2 * f) if p["round"] else f, tuple(body.linvel)
    kept = 1 / (1 + f * dt * (p["linear_drag"] + p["quadratic_drag"] * math.hypot(*v)))
    body.linvel = (v[0] * kept, v[1] * kept, v[2] * kept + f * dt * p["lift"])
    body.angvel = tuple(a / (1 + f * dt * p["turning_drag"]) for a in tuple(body.angvel))
