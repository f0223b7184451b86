"""Loops of the scan-line renderer; on a processor they run one after the other, so order decides.

Camera space has x right, y up and z ahead [m]. A pixel's ray is (x, y, 1) at depth 1.
"""

# Warp reads annotations and operators as its own language.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportOperatorIssue=false
# pyright: reportIndexIssue=false, reportAssignmentType=false

# Warp looks at both sides of `and` and `or`, whatever the first one says.

# ruff: noqa: RUF046, UP018, SIM114  (Warp needs plain statements and int())
from __future__ import annotations

import warp as wp

wp.set_module_options({"enable_backward": False, "max_unroll": 1})

NEAR = wp.constant(0.03)
"""Nothing closer to the eye is drawn [m]."""


@wp.struct
class View:
    """One camera: axes of the world in its rows, focal length [px] and size [px]."""

    eye: wp.vec3
    axes: wp.mat33
    focal: float
    width: int
    height: int


@wp.struct
class Light:
    """Sun, sky and the map of what the sun sees, an orthographic picture of `side` pixels."""

    sun: wp.vec3
    sun_rgb: wp.vec3
    ambient: wp.vec3
    zenith: wp.vec3
    horizon: wp.vec3
    axes: wp.mat33
    center: wp.vec3
    scale: float
    side: int
    soft: float
    clear_m: float
    haze: float


@wp.struct
class Surface:
    """What all pixels of one part share; `texture` is an offset in texels or -1."""

    rgb: wp.vec3
    roughness: float
    metalness: float
    alpha: float
    texture: int
    edge: int
    tile_m: float
    body: int
    glow: float


@wp.kernel
def place(
    local: wp.array(dtype=wp.vec3),
    normal: wp.array(dtype=wp.vec3),
    mover: wp.array(dtype=int),
    poses: wp.array(dtype=wp.transform),
    start: int,
    world: wp.array(dtype=wp.vec3),
    turned: wp.array(dtype=wp.vec3),
):
    """Vertices and normals of what moves, from `start` on, in the world."""
    i = start + wp.tid()
    pose = poses[mover[i]]
    world[i] = wp.transform_point(pose, local[i])
    turned[i] = wp.transform_vector(pose, normal[i])


@wp.func
def edge(a: wp.vec2, b: wp.vec2, x: float, y: float):
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])


@wp.func
def on_screen(v: View, p: wp.vec3):
    return wp.vec2(
        0.5 * float(v.width) + v.focal * p[0] / p[2],
        0.5 * float(v.height) - v.focal * p[1] / p[2],
    )


@wp.func
def fill(
    v: View,
    pa: wp.vec3,
    pb: wp.vec3,
    pc: wp.vec3,
    plane: wp.vec3,
    triangle: int,
    dither: bool,
    nearness: wp.array2d(dtype=float),
    hit: wp.array2d(dtype=int),
):
    """Fills one triangle ahead of the eye; `plane` . (x, y, 1) is 1 / depth at a ray."""
    a = on_screen(v, pa)
    b = on_screen(v, pb)
    c = on_screen(v, pc)
    area = edge(a, b, c[0], c[1])
    if area != 0.0:
        sign = wp.where(area > 0.0, 1.0, -1.0)
        x0 = wp.max(int(wp.ceil(wp.max(wp.min(a[0], wp.min(b[0], c[0])), -1.0) - 0.5)), 0)
        y0 = wp.max(int(wp.ceil(wp.max(wp.min(a[1], wp.min(b[1], c[1])), -1.0) - 0.5)), 0)
        x1 = int(wp.floor(wp.min(wp.max(a[0], wp.max(b[0], c[0])), float(v.width)) - 0.5))
        y1 = int(wp.floor(wp.min(wp.max(a[1], wp.max(b[1], c[1])), float(v.height)) - 0.5))
        x1 = wp.min(x1, v.width - 1)
        y1 = wp.min(y1, v.height - 1)
        for y in range(y0, y1 + 1):
            cy = float(y) + 0.5
            ry = (0.5 * float(v.height) - cy) / v.focal
            for x in range(x0, x1 + 1):
                cx = float(x) + 0.5
                inside = (
                    sign * edge(a, b, cx, cy) >= 0.0
                    and sign * edge(b, c, cx, cy) >= 0.0
                    and sign * edge(c, a, cx, cy) >= 0.0
                )
                if inside and not (dither and (x + y) % 2 == 0):
                    rx = (cx - 0.5 * float(v.width)) / v.focal
                    n = plane[0] * rx + plane[1] * ry + plane[2]
                    if n > nearness[y, x]:
                        nearness[y, x] = n
                        hit[y, x] = triangle


@wp.func
def cut(inside: wp.vec3, outside: wp.vec3):
    """Where an edge comes closer than `NEAR`."""
    t = (NEAR - inside[2]) / (outside[2] - inside[2])
    return inside + t * (outside - inside)


@wp.kernel
def scan(
    view: View,
    world: wp.array(dtype=wp.vec3),
    triangles: wp.array2d(dtype=int),
    part: wp.array(dtype=int),
    surfaces: wp.array(dtype=Surface),
    order: wp.array(dtype=int),
    backs: bool,
    nearness: wp.array2d(dtype=float),
    hit: wp.array2d(dtype=int),
):
    """Writes 1 / depth and the triangle of every pixel that something of `order` covers."""
    t = order[wp.tid()]
    a = view.axes * (world[triangles[t, 0]] - view.eye)
    b = view.axes * (world[triangles[t, 1]] - view.eye)
    c = view.axes * (world[triangles[t, 2]] - view.eye)
    if a[2] < NEAR and b[2] < NEAR and c[2] < NEAR:
        return
    n = wp.cross(b - a, c - a)
    k = wp.dot(n, a)
    if k == 0.0 or (k < 0.0 and not backs):  # seen from behind: these axes are left-handed
        return
    plane = n / k
    dither = surfaces[part[t]].alpha < 0.75
    # Turned until the first corner is the only one of its side of the near plane.
    count = int(a[2] >= NEAR) + int(b[2] >= NEAR) + int(c[2] >= NEAR)
    p = a
    q = b
    r = c
    if count == 1 or count == 2:
        lone = count == 1
        if (b[2] >= NEAR) == lone:
            p = b
            q = c
            r = a
        if (c[2] >= NEAR) == lone:
            p = c
            q = a
            r = b
    if count == 3:
        fill(view, a, b, c, plane, t, dither, nearness, hit)
    elif count == 1:
        fill(view, p, cut(p, q), cut(p, r), plane, t, dither, nearness, hit)
    else:
        u = cut(q, p)
        w = cut(r, p)
        fill(view, u, q, r, plane, t, dither, nearness, hit)
        fill(view, u, r, w, plane, t, dither, nearness, hit)


@wp.kernel
def shade_from(
    light: Light,
    world: wp.array(dtype=wp.vec3),
    triangles: wp.array2d(dtype=int),
    order: wp.array(dtype=int),
    height: wp.array2d(dtype=float),
):
    """Height toward the sun of what it sees first."""
    t = order[wp.tid()]
    half = 0.5 * float(light.side)
    a = light.axes * (world[triangles[t, 0]] - light.center)
    b = light.axes * (world[triangles[t, 1]] - light.center)
    c = light.axes * (world[triangles[t, 2]] - light.center)
    n = wp.cross(b - a, c - a)
    if wp.abs(n[2]) < 1.0e-12:
        return
    pa = wp.vec2(half + light.scale * a[0], half + light.scale * a[1])
    pb = wp.vec2(half + light.scale * b[0], half + light.scale * b[1])
    pc = wp.vec2(half + light.scale * c[0], half + light.scale * c[1])
    sign = wp.where(edge(pa, pb, pc[0], pc[1]) > 0.0, 1.0, -1.0)
    side = float(light.side)
    x0 = wp.max(int(wp.ceil(wp.max(wp.min(pa[0], wp.min(pb[0], pc[0])), -1.0) - 0.5)), 0)
    y0 = wp.max(int(wp.ceil(wp.max(wp.min(pa[1], wp.min(pb[1], pc[1])), -1.0) - 0.5)), 0)
    x1 = wp.min(int(wp.min(wp.max(pa[0], wp.max(pb[0], pc[0])), side) - 0.5), light.side - 1)
    y1 = wp.min(int(wp.min(wp.max(pa[1], wp.max(pb[1], pc[1])), side) - 0.5), light.side - 1)
    for y in range(y0, y1 + 1):
        cy = float(y) + 0.5
        for x in range(x0, x1 + 1):
            cx = float(x) + 0.5
            if (
                sign * edge(pa, pb, cx, cy) >= 0.0
                and sign * edge(pb, pc, cx, cy) >= 0.0
                and sign * edge(pc, pa, cx, cy) >= 0.0
            ):
                lx = (cx - half) / light.scale - a[0]
                ly = (cy - half) / light.scale - a[1]
                z = a[2] - (n[0] * lx + n[1] * ly) / n[2]
                if z > height[y, x]:
                    height[y, x] = z


@wp.func
def sky(light: Light, ray: wp.vec3):
    """Linear colour of the sky; below the horizon its haze."""
    up = wp.clamp(ray[2], 0.0, 1.0)
    return light.horizon + (light.zenith - light.horizon) * wp.sqrt(up)


@wp.func
def lit(light: Light, p: wp.vec3, height: wp.array2d(dtype=float)):
    """Share of the sun that reaches a point, from looks around it on the map."""
    q = light.axes * (p - light.center)
    half = 0.5 * float(light.side)
    fx = half + light.scale * q[0]
    fy = half + light.scale * q[1]
    edge = light.soft + 1.0
    if fx < edge or fy < edge or fx > float(light.side) - edge or fy > float(light.side) - edge:
        return 1.0
    # Most points are wholly in light or shadow: four looks tell.
    around = float(0.0)
    for k in range(4):
        x = int(fx + wp.where(k < 2, -light.soft, light.soft))
        y = int(fy + wp.where(k % 2 == 0, -light.soft, light.soft))
        around += wp.where(height[y, x] > q[2], 0.0, 1.0)
    if around == 0.0 or around == 4.0:
        return 0.25 * around
    sum = float(0.0)
    for k in range(9):
        gx = fx + light.soft * 0.75 * float(k % 3 - 1) - 0.5
        gy = fy + light.soft * 0.75 * float(k // 3 - 1) - 0.5
        x = int(gx)
        y = int(gy)
        u = gx - float(x)
        w = gy - float(y)
        s00 = wp.where(height[y, x] > q[2], 0.0, 1.0)
        s01 = wp.where(height[y, x + 1] > q[2], 0.0, 1.0)
        s10 = wp.where(height[y + 1, x] > q[2], 0.0, 1.0)
        s11 = wp.where(height[y + 1, x + 1] > q[2], 0.0, 1.0)
        sum += (s00 * (1.0 - u) + s01 * u) * (1.0 - w) + (s10 * (1.0 - u) + s11 * u) * w
    return sum / 9.0


@wp.func
def texel(texels: wp.array(dtype=wp.vec3ub), start: int, edge: int, x: int, y: int):
    c = texels[start + ((y % edge) + edge) % edge * edge + ((x % edge) + edge) % edge]
    return wp.vec3(float(c[0]), float(c[1]), float(c[2])) * (1.0 / 255.0)


@wp.func
def sampled(s: Surface, uv: wp.vec2, footprint: float, texels: wp.array(dtype=wp.vec3ub)):
    """Linear colour of a texture at the level where a texel is about a pixel wide.

    Args:
        footprint: Width of a pixel there [tiles].
    """
    start = s.texture
    edge = s.edge
    wide = footprint * float(edge)
    while wide > 1.4 and edge > 1:
        start += edge * edge
        edge = edge // 2
        wide = 0.5 * wide
    fx = uv[0] * float(edge) - 0.5
    fy = (1.0 - uv[1]) * float(edge) - 0.5
    x = int(wp.floor(fx))
    y = int(wp.floor(fy))
    u = fx - float(x)
    w = fy - float(y)
    top = texel(texels, start, edge, x, y) * (1.0 - u) + texel(texels, start, edge, x + 1, y) * u
    low = texel(texels, start, edge, x, y + 1) * (1.0 - u)
    low = low + texel(texels, start, edge, x + 1, y + 1) * u
    c = top * (1.0 - w) + low * w
    return wp.cw_mul(c, c)


@wp.kernel
def shade(
    view: View,
    light: Light,
    world: wp.array(dtype=wp.vec3),
    normals: wp.array(dtype=wp.vec3),
    uvs: wp.array(dtype=wp.vec2),
    triangles: wp.array2d(dtype=int),
    part: wp.array(dtype=int),
    surfaces: wp.array(dtype=Surface),
    texels: wp.array(dtype=wp.vec3ub),
    height: wp.array2d(dtype=float),
    nearness: wp.array2d(dtype=float),
    hit: wp.array2d(dtype=int),
    gamma: wp.array(dtype=wp.uint8),
    image: wp.array3d(dtype=wp.uint8),
):
    """Colours of all pixels."""
    y, x = wp.tid()
    rx = (float(x) + 0.5 - 0.5 * float(view.width)) / view.focal
    ry = (0.5 * float(view.height) - float(y) - 0.5) / view.focal
    toward = wp.transpose(view.axes) * wp.vec3(rx, ry, 1.0)
    ray = wp.normalize(toward)
    t = hit[y, x]
    color = sky(light, ray)
    if t >= 0:
        s = surfaces[part[t]]
        depth = 1.0 / nearness[y, x]
        p = view.eye + depth * toward
        a = world[triangles[t, 0]]
        ab = world[triangles[t, 1]] - a
        ac = world[triangles[t, 2]] - a
        n = wp.cross(ab, ac)
        whole = wp.dot(n, n)
        v = wp.dot(wp.cross(p - a, ac), n) / whole
        w = wp.dot(wp.cross(ab, p - a), n) / whole
        flat = n / wp.sqrt(whole)
        n = normals[triangles[t, 0]] * (1.0 - v - w)
        n = n + normals[triangles[t, 1]] * v + normals[triangles[t, 2]] * w
        long = wp.length(n)
        n = wp.where(long > 0.1, n / long, flat)
        base = s.rgb
        facing = wp.max(-wp.dot(n, ray), 0.0)
        if s.texture >= 0:
            uv = uvs[triangles[t, 0]] * (1.0 - v - w)
            uv = uv + uvs[triangles[t, 1]] * v + uvs[triangles[t, 2]] * w
            footprint = depth / (view.focal * s.tile_m * wp.max(-wp.dot(flat, ray), 0.15))
            base = wp.cw_mul(base, sampled(s, uv, footprint, texels))
        sun = wp.dot(n, light.sun)
        if sun > 0.0 and wp.dot(flat, light.sun) > 0.0:
            sun = sun * lit(light, p + flat * (1.5 / light.scale), height)
        else:
            sun = 0.0
        around = light.ambient * (0.72 + 0.28 * n[2])
        color = wp.cw_mul(base, light.sun_rgb * sun + around) * (1.0 - 0.7 * s.metalness)
        # What the sky adds by reflection, more at the edge, and the sun's own glint.
        bounce = ray + 2.0 * facing * n
        edge = 1.0 - facing
        rim = edge * edge * edge * edge * edge
        gloss = (1.0 - s.roughness) * (1.0 - s.roughness)
        tint = wp.vec3(0.04) + (base - wp.vec3(0.04)) * s.metalness
        seen = sky(light, bounce) * wp.where(bounce[2] < 0.0, 0.35, 1.0)
        color = color + wp.cw_mul(tint + (wp.vec3(1.0) - tint) * rim * 0.6, seen) * gloss
        if sun > 0.0 and s.roughness < 0.6:
            glint = wp.max(wp.dot(bounce, light.sun), 0.0)
            power = 2.0 / (s.roughness * s.roughness * s.roughness * s.roughness + 0.01)
            color = color + wp.cw_mul(tint, light.sun_rgb) * (
                sun * wp.pow(glint, power) * gloss * 4.0
            )
        color = color + base * s.glow
        haze = wp.clamp((depth - light.clear_m) / (4.0 * light.clear_m), 0.0, light.haze)
        color = color * (1.0 - haze) + light.horizon * haze
    for k in range(3):
        image[y, x, k] = gamma[int(wp.clamp(color[k], 0.0, 1.0) * 4095.0)]


@wp.kernel
def smooth(
    hit: wp.array2d(dtype=int),
    part: wp.array(dtype=int),
    source: wp.array3d(dtype=wp.uint8),
    target: wp.array3d(dtype=wp.uint8),
):
    """Softens the stairs where one part ends and another begins."""
    y, x = wp.tid()
    bottom = hit.shape[0] - 1
    right = hit.shape[1] - 1
    me = hit[y, x]
    mine = int(-1)
    if me >= 0:
        mine = part[me]
    border = bool(False)
    for k in range(4):
        u = wp.clamp(x + wp.where(k == 0, 1, wp.where(k == 1, -1, 0)), 0, right)
        w = wp.clamp(y + wp.where(k == 2, 1, wp.where(k == 3, -1, 0)), 0, bottom)
        other = hit[w, u]
        if other != me:
            if other < 0:
                border = True
            elif part[other] != mine:
                border = True
    for c in range(3):
        value = int(source[y, x, c])
        if border:
            value = (
                4 * value
                + int(source[y, wp.max(x - 1, 0), c])
                + int(source[y, wp.min(x + 1, right), c])
                + int(source[wp.max(y - 1, 0), x, c])
                + int(source[wp.min(y + 1, bottom), x, c])
            ) // 8
        target[y, x, c] = wp.uint8(value)
