"""Warp kernels of the tracer: what a pixel sees, how it is lit, finer edges, and the picture.

`look` traces one ray through the centre of every pixel and shades what it hits; `outline` lists
the pixels whose neighbours differ and `refine` shades more rays there; `develop` smooths the light
over neighbours of one surface and makes the picture. Light of the sun and of the sky is
sampled with few rays in a pattern of three by three pixels, which the smoothing over three by three
pixels makes whole again.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
# pyright: reportAttributeAccessIssue=false
# Warp evaluates both sides of `and`: nested conditions save the search on the right one.
# Without `float()` a number is a constant to it.
# ruff: noqa: SIM102, UP018, RUF046
import warp as wp

# Searches in loops, unrolled, make kernels so long that a GPU holds few of their threads.
wp.set_module_options({"max_unroll": 1})

NOTHING = wp.constant(-2)
"""Owner of what is not there."""
GROUND = wp.constant(-1)
"""Instance and owner of the ground plane."""
FIXED = wp.constant(-3)
"""Owner of meshes that belong to no body."""
FAR_M = wp.constant(2000.0)
GROUND_M = wp.constant(-2.0e-4)
"""The plane lies so much below what is drawn at z = 0."""
PATTERN = wp.constant(9)
"""Pixels that share a pattern of rays toward sun and sky, three by three."""
LAYERS = wp.constant(4)
"""So many clear surfaces are looked through."""
ALIKE = wp.constant(0.92)
"""Cosine between normals above which two pixels show one surface."""
TILE = wp.constant(8)
TILE_ROWS = wp.constant(4)
"""Width and height of the tiles that pictures are drawn in [px]: one warp of a GPU."""
TILE_PX = wp.constant(32)
THREADS = 64
"""Of a block of a GPU: rays end at different times, and a large block waits for its last."""


@wp.struct
class Material:
    """Linear colour, and where its texture is in the pyramid (first -1: none)."""

    color: wp.vec3
    roughness: float
    metalness: float
    alpha: float
    first: int
    size: int
    texel_m: float
    glow: float


@wp.struct
class Scene:
    """Meshes, instances (W worlds of M movers), light and sky.

    `corner_*` have three entries a face, in the order of `face_first` of each mesh; `pyramid`
    holds texels (linear colour, roughness) of all textures, level after level.
    """

    bvh: wp.uint64
    instances: int
    mesh: wp.array(dtype=wp.uint64)
    clear: wp.array(dtype=int)
    face_first: wp.array(dtype=int)
    pose: wp.array(dtype=wp.transform)
    owner: wp.array(dtype=int)
    fixed_mesh: wp.uint64
    fixed_first: int
    fixed_clear_mesh: wp.uint64
    fixed_clear_first: int
    corner_normal: wp.array(dtype=wp.vec3)
    corner_uv: wp.array(dtype=wp.vec2)
    face_material: wp.array(dtype=int)
    material: wp.array(dtype=Material)
    pyramid: wp.array(dtype=wp.vec4)
    has_ground: int
    ground: Material
    ground_mean: wp.vec3
    ground_tile: float
    sun: wp.vec3
    sun_rgb: wp.vec3
    sun_radius: float
    sun_reach: float
    sky_rgb: wp.vec3
    bounce_rgb: wp.vec3
    haze_rgb: wp.vec3
    haze_m: float
    sky: wp.array2d(dtype=wp.vec3)
    blurred: wp.array3d(dtype=wp.vec3)


@wp.struct
class View:
    """A camera: its pose, the tangent of half its vertical field of view, and its world."""

    pose: wp.transform
    tangent: float


@wp.struct
class Hit:
    """The nearest surface on a ray; `instance` is -2 for none, -1 for the ground plane."""

    t: float
    instance: int
    face: int
    u: float
    v: float
    normal: wp.vec3


@wp.struct
class Shade:
    """A lit surface: albedo times light (of sun, sky and ground, as shares) plus the rest.

    `mirror` is what it reflects where nothing is near, `shine` the highlight of an unhidden sun.
    """

    albedo: wp.vec3
    light: wp.vec3
    mirror: wp.vec3
    shine: wp.vec3
    rest: wp.vec3


@wp.func
def _from_front(mesh: wp.uint64, o: wp.vec3, d: wp.vec3, reach: float):
    """The nearest face of a mesh that is seen from its front."""
    hit = Hit()
    hit.instance = NOTHING
    start = float(0.0)
    for _k in range(8):
        q = wp.mesh_query_ray(mesh, o + d * start, d, reach - start)
        if not q.result:
            return hit
        if wp.dot(q.normal, d) < 0.0:
            hit.t = start + q.t
            hit.instance = 0
            hit.face = q.face
            hit.u = q.u
            hit.v = q.v
            hit.normal = q.normal
            return hit
        start = start + q.t + 1.0e-5 + 1.0e-6 * start
    return hit


@wp.func
def _closest(s: Scene, world: int, o: wp.vec3, d: wp.vec3, reach: float):
    best = Hit()
    best.t = reach
    best.instance = NOTHING
    if s.has_ground > 0 and d[2] < -1.0e-6 and o[2] > GROUND_M:
        t = (GROUND_M - o[2]) / d[2]
        if t < best.t:
            best.t = t
            best.instance = GROUND
            best.normal = wp.vec3(0.0, 0.0, 1.0)
    if s.fixed_mesh != wp.uint64(0):
        hit = _from_front(s.fixed_mesh, o, d, best.t)
        if hit.instance == 0:
            best = hit
            best.instance = s.instances
    if s.fixed_clear_mesh != wp.uint64(0):
        hit = _from_front(s.fixed_clear_mesh, o, d, best.t)
        if hit.instance == 0:
            best = hit
            best.instance = s.instances + 1
    if s.bvh != wp.uint64(0):
        query = wp.bvh_query_ray(s.bvh, o, d, wp.bvh_get_group_root(s.bvh, world))
        i = int(0)
        while wp.bvh_query_next(query, i, best.t):
            away = wp.transform_inverse(s.pose[i])
            local = wp.transform_vector(away, d)
            hit = _from_front(s.mesh[i], wp.transform_point(away, o), local, best.t)
            if hit.instance == 0:
                best = hit
                best.instance = i
                best.normal = wp.transform_vector(s.pose[i], hit.normal)
    return best


@wp.func
def _hidden(s: Scene, world: int, o: wp.vec3, d: wp.vec3, reach: float) -> bool:
    """Whether anything opaque is on a ray; the ground plane never is."""
    if s.fixed_mesh != wp.uint64(0):
        if wp.mesh_query_ray_anyhit(s.fixed_mesh, o, d, reach):
            return True
    if s.bvh != wp.uint64(0):
        query = wp.bvh_query_ray(s.bvh, o, d, wp.bvh_get_group_root(s.bvh, world))
        i = int(0)
        while wp.bvh_query_next(query, i, reach):
            if s.clear[i] == 0:
                away = wp.transform_inverse(s.pose[i])
                at = wp.transform_point(away, o)
                if wp.mesh_query_ray_anyhit(s.mesh[i], at, wp.transform_vector(away, d), reach):
                    return True
    return False


@wp.func
def _wrapped(i: int, size: int) -> int:
    k = i % size
    if k < 0:
        k = k + size
    return k


@wp.func
def _texel(s: Scene, m: Material, uv: wp.vec2, footprint_m: float) -> wp.vec4:
    """Colour and roughness of a texture over about `footprint_m`, bilinear in one level."""
    size = m.size
    first = m.first
    texel = m.texel_m * 1.4
    while footprint_m > texel and size > 1:
        first = first + size * size
        size = size / 2
        texel = texel * 2.0
    x = uv[0] * float(size) - 0.5
    y = (1.0 - uv[1]) * float(size) - 0.5
    x0 = int(wp.floor(x))
    y0 = int(wp.floor(y))
    fx = x - float(x0)
    fy = y - float(y0)
    xa = _wrapped(x0, size)
    xb = _wrapped(x0 + 1, size)
    ya = first + _wrapped(y0, size) * size
    yb = first + _wrapped(y0 + 1, size) * size
    top = s.pyramid[ya + xa] * (1.0 - fx) + s.pyramid[ya + xb] * fx
    low = s.pyramid[yb + xa] * (1.0 - fx) + s.pyramid[yb + xb] * fx
    return top * (1.0 - fy) + low * fy


@wp.func
def _sky(s: Scene, d: wp.vec3) -> wp.vec3:
    height = s.sky.shape[0]
    width = s.sky.shape[1]
    x = (wp.atan2(d[1], d[0]) * 0.15915494 + 0.5) * float(width) - 0.5
    y = wp.asin(wp.clamp(d[2], 0.0, 1.0)) * 0.63661977 * float(height) - 0.5
    y = wp.clamp(y, 0.0, float(height) - 1.001)
    x0 = int(wp.floor(x))
    y0 = int(y)
    fx = x - float(x0)
    fy = y - float(y0)
    xa = _wrapped(x0, width)
    xb = _wrapped(x0 + 1, width)
    y1 = wp.min(y0 + 1, height - 1)
    low = s.sky[y0, xa] * (1.0 - fx) + s.sky[y0, xb] * fx
    top = s.sky[y1, xa] * (1.0 - fx) + s.sky[y1, xb] * fx
    return low * (1.0 - fy) + top * fy


@wp.func
def _blurred(s: Scene, k: int, x: float, y: float) -> wp.vec3:
    """A level of the blurred surroundings between its pixels."""
    height = s.blurred.shape[1]
    width = s.blurred.shape[2]
    y = wp.clamp(y, 0.0, float(height) - 1.001)
    x0 = int(wp.floor(x))
    y0 = int(y)
    fx = x - float(x0)
    fy = y - float(y0)
    xa = _wrapped(x0, width)
    xb = _wrapped(x0 + 1, width)
    low = s.blurred[k, y0, xa] * (1.0 - fx) + s.blurred[k, y0, xb] * fx
    top = s.blurred[k, y0 + 1, xa] * (1.0 - fx) + s.blurred[k, y0 + 1, xb] * fx
    return low * (1.0 - fy) + top * fy


@wp.func
def _mirrored(s: Scene, d: wp.vec3, roughness: float) -> wp.vec3:
    """What a surface of a roughness reflects from a direction: the sky, or the ground."""
    levels = s.blurred.shape[0]
    height = s.blurred.shape[1]
    width = s.blurred.shape[2]
    level = roughness * float(levels)
    k = wp.min(int(level), levels - 1)
    x = (wp.atan2(d[1], d[0]) * 0.15915494 + 0.5) * float(width) - 0.5
    y = (wp.asin(wp.clamp(d[2], -1.0, 1.0)) * 0.31830989 + 0.5) * float(height) - 0.5
    rough = _blurred(s, k, x, y)
    if level >= 1.0:
        f = level - float(k)
        return rough * (1.0 - f) + _blurred(s, wp.min(k + 1, levels - 1), x, y) * f
    sharp = s.bounce_rgb
    if d[2] > 0.0:
        sharp = _sky(s, d)
    # The horizon of a mirror is not a knife's edge.
    near = wp.clamp(0.5 + d[2] / (0.02 + roughness), 0.0, 1.0)
    sharp = sharp * near + s.bounce_rgb * (1.0 - near)
    return sharp * (1.0 - level) + rough * level


@wp.func
def _across(n: wp.vec3) -> wp.vec3:
    """A unit vector across a unit vector."""
    a = wp.vec3(1.0, 0.0, 0.0)
    if wp.abs(n[0]) > 0.7:
        a = wp.vec3(0.0, 1.0, 0.0)
    return wp.normalize(wp.cross(n, a))


@wp.func
def _lit(s: Scene, world: int, at: wp.vec3, n: wp.vec3, flat: wp.vec3, t: float, k: int, rays: int):
    """Shares of sun, sky and ground light at a point, by the rays of place `k` of the pattern."""
    start = at + flat * (2.0e-4 + 1.0e-4 * t)
    reach = wp.clamp(0.2 * t, 0.03, 1.6)
    sun_side = _across(s.sun)
    sun_up = wp.cross(s.sun, sun_side)
    side = _across(flat)
    up = wp.cross(flat, side)
    sun = float(0.0)
    open_ = float(0.0)
    for i in range(rays):
        # A sunflower's seeds, spread over a disc: PATTERN pixels share RAYS * PATTERN of them.
        seed = float(k + i * PATTERN)
        radius = wp.sqrt((seed + 0.5) / float(rays * PATTERN))
        cx = radius * wp.cos(2.39996323 * seed)
        cy = radius * wp.sin(2.39996323 * seed)
        toward = wp.normalize(s.sun + (sun_side * cx + sun_up * cy) * s.sun_radius)
        facing = wp.dot(n, toward)
        if facing > 0.0 and wp.dot(flat, toward) > 0.0:
            if not _hidden(s, world, start, toward, s.sun_reach):
                sun = sun + facing
        away = side * cx + up * cy + flat * wp.sqrt(wp.max(0.0, 1.0 - radius * radius))
        if not _hidden(s, world, start, away, reach):
            open_ = open_ + 1.0
    sun = sun / float(rays)
    open_ = open_ / float(rays)
    rise = 0.5 + 0.5 * n[2]
    return wp.vec3(sun, open_ * rise, open_ * (1.0 - rise))


@wp.func
def _face(s: Scene, hit: Hit) -> int:
    """Where the face of a hit on a mesh stands among all faces."""
    first = s.fixed_first
    if hit.instance < s.instances:
        first = s.face_first[hit.instance]
    elif hit.instance > s.instances:
        first = s.fixed_clear_first
    return first + hit.face


@wp.func
def _owner(s: Scene, hit: Hit) -> int:
    """Whose surface a hit is on."""
    if hit.instance < 0:
        return hit.instance
    if hit.instance >= s.instances:
        return FIXED
    return s.owner[hit.instance]


@wp.func
def _paint(s: Scene, hit: Hit) -> int:
    """Which material a hit shows; -1 and below for the ground and for nothing."""
    if hit.instance < 0:
        return hit.instance
    return s.face_material[_face(s, hit)]


@wp.func
def _painted(s: Scene, hit: Hit, at: wp.vec3, footprint_m: float):
    """Material at a hit, its colour and roughness those of its texture, and the smooth normal."""
    m = s.ground
    n = hit.normal
    if hit.instance == GROUND:
        if m.first >= 0:
            uv = wp.vec2(at[0] / s.ground_tile, at[1] / s.ground_tile)
            texel = _texel(s, m, uv, footprint_m)
            m.color = wp.cw_mul(m.color, wp.vec3(texel[0], texel[1], texel[2]))
            m.roughness = m.roughness * texel[3]
        return m, n
    face = _face(s, hit)
    m = s.material[s.face_material[face]]
    w = 1.0 - hit.u - hit.v
    smooth = (
        s.corner_normal[3 * face] * hit.u
        + s.corner_normal[3 * face + 1] * hit.v
        + s.corner_normal[3 * face + 2] * w
    )
    if wp.dot(smooth, smooth) > 1.0e-6:
        if hit.instance < s.instances:
            smooth = wp.transform_vector(s.pose[hit.instance], smooth)
        n = wp.normalize(smooth)
    if m.first >= 0:
        uv = (
            s.corner_uv[3 * face] * hit.u
            + s.corner_uv[3 * face + 1] * hit.v
            + s.corner_uv[3 * face + 2] * w
        )
        texel = _texel(s, m, uv, footprint_m)
        m.color = wp.cw_mul(m.color, wp.vec3(texel[0], texel[1], texel[2]))
        m.roughness = m.roughness * texel[3]
    return m, n


@wp.func
def _share(m: Material, facing: float) -> wp.vec3:
    """Share of the surroundings' light that a surface reflects.

    After Karis, "Physically based shading on mobile" (2014).
    """
    f0 = wp.vec3(0.04) * (1.0 - m.metalness) + m.color * m.metalness
    r = m.roughness
    a = wp.min((1.0 - r) * (1.0 - r), wp.pow(2.0, -9.28 * facing)) * (1.0 - r)
    a = a + 0.0425 - 0.0275 * r
    return f0 * (1.04 - 0.572 * r - 1.04 * a) + wp.vec3(1.04 * a + 0.022 * r - 0.04)


@wp.func
def _highlight(s: Scene, m: Material, n: wp.vec3, d: wp.vec3) -> wp.vec3:
    """The sun as a surface reflects it (GGX, bounded so that no pixel is a firefly)."""
    f0 = wp.vec3(0.04) * (1.0 - m.metalness) + m.color * m.metalness
    half = wp.normalize(s.sun - d)
    alpha = wp.max(0.02, m.roughness * m.roughness)
    cosine = wp.max(0.0, wp.dot(n, half))
    bottom = cosine * cosine * (alpha * alpha - 1.0) + 1.0
    peak = wp.min(0.25 * alpha * alpha / (bottom * bottom), 12.0)
    fresnel = f0 + (wp.vec3(1.0) - f0) * wp.pow(1.0 - wp.max(0.0, wp.dot(half, s.sun)), 5.0)
    return wp.cw_mul(fresnel, s.sun_rgb) * peak


@wp.func
def _shade(s: Scene, world: int, o: wp.vec3, d: wp.vec3, hit: Hit, pixel: float, k: int, rays: int):
    """Light along a ray whose nearest surface is `hit`; what is clear lets the next through.

    Without `rays` what falls on it is left out.
    """
    out = Shade()
    left = float(1.0)
    here = hit
    travelled = float(0.0)
    origin = o
    for layer in range(LAYERS):
        if here.instance == NOTHING:
            out.rest = out.rest + _sky(s, d) * left
            return out
        at = origin + d * here.t
        travelled = travelled + here.t
        slant = wp.max(0.06, -wp.dot(here.normal, d))
        m, n = _painted(s, here, at, pixel * travelled / wp.sqrt(slant))
        if wp.dot(n, d) > -0.02:  # a smooth normal that looks away at the rim
            n = wp.normalize(n - d * (wp.dot(n, d) + 0.02))
        opaque = m.alpha
        haze = float(0.0)
        if s.haze_m > 0.0:
            haze = 1.0 - wp.exp(-wp.pow(travelled / s.haze_m, 1.5))
        clear = left * (1.0 - haze)
        if layer == 0 and rays > 0:
            out.light = _lit(s, world, at, n, here.normal, travelled, k, rays)
        out.albedo = out.albedo + m.color * (clear * opaque * (1.0 - m.metalness))
        facing = wp.max(1.0e-3, -wp.dot(n, d))
        seen = _mirrored(s, d + n * (2.0 * facing), m.roughness)
        out.mirror = out.mirror + wp.cw_mul(_share(m, facing), seen) * clear
        out.shine = out.shine + _highlight(s, m, n, d) * clear
        out.rest = out.rest + s.haze_rgb * (left * haze) + m.color * (m.glow * clear * opaque)
        left = clear * (1.0 - opaque)
        if left < 0.02 or layer == LAYERS - 1:
            return out
        origin = at + d * (1.0e-4 + 1.0e-5 * travelled)
        here = _closest(s, world, origin, d, FAR_M)
    return out


@wp.func
def _ray(view: View, x: float, y: float, width: int, height: int) -> wp.vec3:
    """Unit direction in the world through a point of the picture [px]."""
    scale = 2.0 * view.tangent / float(height)
    local = wp.vec3((x - 0.5 * float(width)) * scale, (0.5 * float(height) - y) * scale, -1.0)
    return wp.transform_vector(view.pose, wp.normalize(local))


@wp.func
def _pixel(i: int, width: int) -> wp.vec2i:
    """Column and row of the i-th pixel, tile after tile: neighbours run together."""
    inside = i % TILE_PX
    tile = i / TILE_PX
    across = (width + TILE - 1) / TILE
    return wp.vec2i(
        (tile % across) * TILE + inside % TILE, (tile / across) * TILE_ROWS + inside / TILE
    )


@wp.kernel(enable_backward=False)
def place(
    poses: wp.array(dtype=wp.transform),
    mover: wp.array(dtype=int),
    low: wp.array(dtype=wp.vec3),
    high: wp.array(dtype=wp.vec3),
    pose: wp.array(dtype=wp.transform),
    lower: wp.array(dtype=wp.vec3),
    upper: wp.array(dtype=wp.vec3),
):
    """Boxes of all instances in the world, for the tree of boxes."""
    i = wp.tid()
    p = poses[mover[i]]
    pose[i] = p
    middle = wp.transform_point(p, (low[i] + high[i]) * 0.5)
    half = (high[i] - low[i]) * 0.5
    q = wp.quat_to_matrix(wp.transform_get_rotation(p))
    reach = wp.vec3(
        wp.abs(q[0, 0]) * half[0] + wp.abs(q[0, 1]) * half[1] + wp.abs(q[0, 2]) * half[2],
        wp.abs(q[1, 0]) * half[0] + wp.abs(q[1, 1]) * half[1] + wp.abs(q[1, 2]) * half[2],
        wp.abs(q[2, 0]) * half[0] + wp.abs(q[2, 1]) * half[1] + wp.abs(q[2, 2]) * half[2],
    )
    lower[i] = middle - reach - wp.vec3(1.0e-4)
    upper[i] = middle + reach + wp.vec3(1.0e-4)


@wp.kernel(enable_backward=False)
def look(
    s: Scene,
    views: wp.array(dtype=View),
    rays: int,
    depth: wp.array3d(dtype=float),
    normal: wp.array3d(dtype=wp.vec3),
    mover: wp.array3d(dtype=int),
    paint: wp.array3d(dtype=int),
    point: wp.array3d(dtype=wp.vec3),
    albedo: wp.array3d(dtype=wp.vec3),
    light: wp.array3d(dtype=wp.vec3),
    mirror: wp.array3d(dtype=wp.vec3),
    shine: wp.array3d(dtype=wp.vec3),
    rest: wp.array3d(dtype=wp.vec3),
):
    """One ray through every pixel, and `rays` toward sun and sky each; 0 for no colour."""
    w, i = wp.tid()
    height = depth.shape[1]
    width = depth.shape[2]
    at = _pixel(i, width)
    x = at[0]
    y = at[1]
    if x >= width or y >= height:
        return
    view = views[w]
    o = wp.transform_get_translation(view.pose)
    d = _ray(view, float(x) + 0.5, float(y) + 0.5, width, height)
    hit = _closest(s, w, o, d, FAR_M)
    ahead = -wp.dot(d, wp.transform_vector(view.pose, wp.vec3(0.0, 0.0, 1.0)))
    n = wp.vec3(0.0)
    far = float(0.0)
    if hit.instance != NOTHING:
        n = hit.normal
        far = hit.t * ahead
    depth[w, y, x] = far
    normal[w, y, x] = n
    mover[w, y, x] = _owner(s, hit)
    point[w, y, x] = o + d * hit.t
    paint[w, y, x] = _paint(s, hit)
    if rays > 0:
        pixel = 2.0 * view.tangent / float(height)
        shade = _shade(s, w, o, d, hit, pixel, 3 * (y % 3) + x % 3, rays)
        albedo[w, y, x] = shade.albedo
        light[w, y, x] = shade.light
        mirror[w, y, x] = shade.mirror
        shine[w, y, x] = shade.shine
        rest[w, y, x] = shade.rest


@wp.func
def _differs(
    normal: wp.array3d(dtype=wp.vec3),
    mover: wp.array3d(dtype=int),
    point: wp.array3d(dtype=wp.vec3),
    w: int,
    v: int,
    u: int,
    owner: int,
    n: wp.vec3,
    at: wp.vec3,
    far: float,
) -> bool:
    """Whether a pixel shows another surface than the one at a point that is so far away."""
    if owner != mover[w, v, u]:
        return True
    if owner == NOTHING:
        return False
    if wp.dot(n, normal[w, v, u]) < ALIKE:
        return True
    # A surface may recede as it likes, but one of the two is not beside the other's plane.
    return wp.abs(wp.dot(n, point[w, v, u] - at)) > 0.004 * far


@wp.func
def _added(s: Scene, a: Shade, light: wp.vec3) -> wp.vec3:
    """Radiance of a shaded surface in a light; no part of it is a firefly."""
    open_ = wp.clamp(light[1] + light[2], 0.0, 1.0)
    total = s.sun_rgb * light[0] + s.sky_rgb * light[1] + s.bounce_rgb * light[2]
    return wp.cw_mul(a.albedo, total) + a.mirror * open_ + a.shine * light[0] + a.rest


@wp.func
def _smoothed(
    normal: wp.array3d(dtype=wp.vec3),
    mover: wp.array3d(dtype=int),
    point: wp.array3d(dtype=wp.vec3),
    light: wp.array3d(dtype=wp.vec3),
    w: int,
    y: int,
    x: int,
    owner: int,
    n: wp.vec3,
    at: wp.vec3,
    far: float,
) -> wp.vec4:
    """Mean light on a surface, of a pixel and its neighbours that show it, and how many do."""
    total = wp.vec3(0.0)
    count = float(0.0)
    for j in range(9):
        v = y + j / 3 - 1
        u = x + j % 3 - 1
        if v >= 0 and u >= 0 and v < mover.shape[1] and u < mover.shape[2]:
            if not _differs(normal, mover, point, w, v, u, owner, n, at, far):
                total = total + light[w, v, u]
                count = count + 1.0
    if count > 0.0:
        total = total / count
    return wp.vec4(total[0], total[1], total[2], count)


@wp.func
def _calm(
    depth: wp.array3d(dtype=float),
    normal: wp.array3d(dtype=wp.vec3),
    mover: wp.array3d(dtype=int),
    point: wp.array3d(dtype=wp.vec3),
    light: wp.array3d(dtype=wp.vec3),
    w: int,
    y: int,
    x: int,
) -> wp.vec3:
    """Light on what the centre of a pixel shows."""
    mean = _smoothed(
        normal, mover, point, light, w, y, x,
        mover[w, y, x], normal[w, y, x], point[w, y, x], depth[w, y, x],
    )  # fmt: skip
    return wp.vec3(mean[0], mean[1], mean[2])


@wp.kernel(enable_backward=False)
def outline(
    depth: wp.array3d(dtype=float),
    normal: wp.array3d(dtype=wp.vec3),
    mover: wp.array3d(dtype=int),
    paint: wp.array3d(dtype=int),
    point: wp.array3d(dtype=wp.vec3),
    is_edge: wp.array3d(dtype=int),
    edges: wp.array(dtype=wp.vec3i),
    count: wp.array(dtype=int),
):
    """Lists world, row and column of the pixels beside which another surface is seen.

    Their order is any: each is worked on alone.
    """
    w, i = wp.tid()
    at = _pixel(i, depth.shape[2])
    x = at[0]
    y = at[1]
    if x >= depth.shape[2] or y >= depth.shape[1]:
        return
    found = bool(False)
    for j in range(9):
        v = wp.clamp(y + j / 3 - 1, 0, depth.shape[1] - 1)
        u = wp.clamp(x + j % 3 - 1, 0, depth.shape[2] - 1)
        if not found:
            found = paint[w, v, u] != paint[w, y, x]
        if not found:
            found = _differs(
                normal, mover, point, w, v, u,
                mover[w, y, x], normal[w, y, x], point[w, y, x], depth[w, y, x],
            )  # fmt: skip
    if found:
        is_edge[w, y, x] = 1
        edges[wp.atomic_add(count, 0, 1)] = wp.vec3i(w, y, x)


@wp.kernel(enable_backward=False)
def refine(
    s: Scene,
    views: wp.array(dtype=View),
    samples: int,
    depth: wp.array3d(dtype=float),
    normal: wp.array3d(dtype=wp.vec3),
    mover: wp.array3d(dtype=int),
    paint: wp.array3d(dtype=int),
    point: wp.array3d(dtype=wp.vec3),
    albedo: wp.array3d(dtype=wp.vec3),
    light: wp.array3d(dtype=wp.vec3),
    mirror: wp.array3d(dtype=wp.vec3),
    shine: wp.array3d(dtype=wp.vec3),
    rest: wp.array3d(dtype=wp.vec3),
    edge: wp.array3d(dtype=wp.vec3),
    edges: wp.array(dtype=wp.vec3i),
    count: wp.array(dtype=int),
):
    """The mean of more rays at each pixel of the list.

    They share the light of pixels that show the same surface. Where none does they take it from
    the same places of the pattern everywhere: what is not smoothed must not show it.
    """
    k = wp.tid()
    if k >= count[0]:
        return
    w = edges[k][0]
    y = edges[k][1]
    x = edges[k][2]
    view = views[w]
    height = depth.shape[1]
    width = depth.shape[2]
    pixel = 2.0 * view.tangent / float(height)
    o = wp.transform_get_translation(view.pose)
    here = Shade()
    here.albedo = albedo[w, y, x]
    here.mirror = mirror[w, y, x]
    here.shine = shine[w, y, x]
    here.rest = rest[w, y, x]
    total = _added(s, here, _calm(depth, normal, mover, point, light, w, y, x))
    for i in range(1, samples):
        # Kronecker's sequence in the plane (Roberts 2018) spreads any number of points well.
        dx = float(i) * 0.7548776662
        dy = float(i) * 0.5698402910
        d = _ray(
            view,
            float(x) + dx - wp.floor(dx),
            float(y) + dy - wp.floor(dy),
            width,
            height,
        )
        hit = _closest(s, w, o, d, FAR_M)
        mean = _smoothed(
            normal, mover, point, light, w, y, x,
            _owner(s, hit), hit.normal, o + d * hit.t, hit.t,
        )  # fmt: skip
        rays = int(0)
        if mean[3] == 0.0:
            rays = 1
        shade = _shade(s, w, o, d, hit, pixel, (4 * i) % PATTERN, rays)
        if rays == 0:
            shade.light = wp.vec3(mean[0], mean[1], mean[2])
        total = total + _added(s, shade, shade.light)
    edge[w, y, x] = total / float(samples)


@wp.func
def _encoded(x: float) -> float:
    """Display value of linear light: as it is up to 0.6, a soft shoulder above, then sRGB."""
    y = wp.max(x, 0.0)
    if y > 0.6:
        y = 0.6 + 0.4 * (1.0 - wp.exp(-(y - 0.6) / 0.4))
    if y <= 0.0031308:
        return 12.92 * y
    return 1.055 * wp.pow(y, 1.0 / 2.4) - 0.055


@wp.kernel(enable_backward=False)
def develop(
    s: Scene,
    depth: wp.array3d(dtype=float),
    normal: wp.array3d(dtype=wp.vec3),
    mover: wp.array3d(dtype=int),
    paint: wp.array3d(dtype=int),
    point: wp.array3d(dtype=wp.vec3),
    albedo: wp.array3d(dtype=wp.vec3),
    light: wp.array3d(dtype=wp.vec3),
    mirror: wp.array3d(dtype=wp.vec3),
    shine: wp.array3d(dtype=wp.vec3),
    rest: wp.array3d(dtype=wp.vec3),
    edge: wp.array3d(dtype=wp.vec3),
    is_edge: wp.array3d(dtype=int),
    first: int,
    share: float,
    radiance: wp.array3d(dtype=wp.vec3),
    packed: wp.array3d(dtype=wp.uint32),
):
    """Adds one instant's `share` to the radiance and encodes what there is so far."""
    w, y, x = wp.tid()
    color = edge[w, y, x]
    if is_edge[w, y, x] == 0:
        here = Shade()
        here.albedo = albedo[w, y, x]
        here.mirror = mirror[w, y, x]
        here.shine = shine[w, y, x]
        here.rest = rest[w, y, x]
        color = _added(s, here, _calm(depth, normal, mover, point, light, w, y, x))
    if first > 0:
        radiance[w, y, x] = color * share
    else:
        radiance[w, y, x] = radiance[w, y, x] + color * share
    color = radiance[w, y, x]
    r = wp.uint32(wp.int32(_encoded(color[0]) * 255.0 + 0.5))
    g = wp.uint32(wp.int32(_encoded(color[1]) * 255.0 + 0.5))
    b = wp.uint32(wp.int32(_encoded(color[2]) * 255.0 + 0.5))
    packed[w, y, x] = r | (g << wp.uint32(8)) | (b << wp.uint32(16))
