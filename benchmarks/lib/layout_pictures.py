"""Sheets of layouts seen from above and in perspective, drawn from the proxies."""

from __future__ import annotations

from collections.abc import Callable
import colorsys
import itertools
import math
from pathlib import Path

from PIL import Image, ImageDraw

from esg.graph.models import EsgDocument
from esg.layout.problem.shapes import CIRCLE, footprints

TILE = 240
MARGIN = 16
Point = tuple[float, float]
Picture = Callable[[EsgDocument], Image.Image]


def _outline(kind: int, x: float, y: float, yaw: float, hx: float, hy: float) -> list[Point]:
    if kind == CIRCLE:
        n = 20
        return [
            (x + hx * math.cos(2 * math.pi * k / n), y + hx * math.sin(2 * math.pi * k / n))
            for k in range(n)
        ]
    c, s = math.cos(yaw), math.sin(yaw)
    corners = ((hx, hy), (-hx, hy), (-hx, -hy), (hx, -hy))
    return [(x + c * u - s * v, y + s * u + c * v) for u, v in corners]


def prisms(doc: EsgDocument) -> list[tuple[str, list[Point], float, float]]:
    """Every proxy of a layout: node, outline [cm], lower and upper height [cm]."""
    assert doc.layout_result is not None
    out = []
    for name, node in doc.spatial_relation_graph.nodes.items():
        pose = doc.layout_result.poses[name]
        yaw = math.radians(pose.yaw_deg)
        c, s = math.cos(yaw), math.sin(yaw)
        x, y, z = pose.position_cm
        config = doc.asset_configurations[node.asset_id]
        for p in footprints(config):
            px, py = x + c * p.x - s * p.y, y + s * p.x + c * p.y
            out.append(
                (name, _outline(p.kind, px, py, yaw + p.yaw, p.hx, p.hy), z + p.z0, z + p.z1)
            )
    return out


def _color(category: str, light: float) -> tuple[int, int, int]:
    hue = (sum(ord(ch) * (k + 7) for k, ch in enumerate(category)) % 97) / 97.0
    r, g, b = colorsys.hls_to_rgb(hue, light, 0.45)
    return int(255 * r), int(255 * g), int(255 * b)


def _fit(points: list[Point]) -> tuple[float, float, float]:
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    scale = (TILE - 2 * MARGIN) / max(max(xs) - min(xs), max(ys) - min(ys), 1.0)
    return scale, 0.5 * (min(xs) + max(xs)), 0.5 * (min(ys) + max(ys))


def top_down(doc: EsgDocument) -> Image.Image:
    """The viewer stands below the picture's lower edge: right = -X, down = +Y."""
    image = Image.new("RGB", (TILE, TILE), "white")
    draw = ImageDraw.Draw(image)
    items = sorted(prisms(doc), key=lambda t: t[3])
    if not items:
        return image
    scale, cx, cy = _fit([p for _, o, _, _ in items for p in o])
    nodes = doc.spatial_relation_graph.nodes
    for name, outline, _, top in items:
        fill = _color(nodes[name].asset_id, 0.45 + min(0.35, top / 500.0))
        draw.polygon(
            [(TILE / 2 - scale * (x - cx), TILE / 2 + scale * (y - cy)) for x, y in outline],
            fill=fill,
            outline="black",
        )
    assert doc.layout_result is not None
    for name, node in nodes.items():
        if node.is_structural:
            continue
        pose = doc.layout_result.poses[name]
        x, y, _ = pose.position_cm
        a = math.radians(pose.yaw_deg)
        reach = 0.5 * doc.asset_configurations[node.asset_id].dimensions_cm[0]
        ends = [(x, y), (x + reach * math.cos(a), y + reach * math.sin(a))]
        draw.line(
            [(TILE / 2 - scale * (u - cx), TILE / 2 + scale * (v - cy)) for u, v in ends],
            fill="red",
        )
    return image


def perspective(doc: EsgDocument) -> Image.Image:
    """Seen by the viewer: from +Y, 30 degrees above the horizon, painted from far to near."""
    image = Image.new("RGB", (TILE, TILE), (244, 244, 240))
    draw = ImageDraw.Draw(image)
    items = prisms(doc)
    if not items:
        return image
    points = [(x, y, z) for _, o, lo, hi in items for x, y in o for z in (lo, hi)]
    middle = [0.5 * (min(p[k] for p in points) + max(p[k] for p in points)) for k in range(3)]
    radius = max(math.dist(p, middle) for p in points)
    azimuth, elevation = math.radians(70.0), math.radians(30.0)
    back = (
        math.cos(elevation) * math.cos(azimuth),
        math.cos(elevation) * math.sin(azimuth),
        math.sin(elevation),
    )
    right = (-math.sin(azimuth), math.cos(azimuth), 0.0)
    up = (
        -math.sin(elevation) * math.cos(azimuth),
        -math.sin(elevation) * math.sin(azimuth),
        math.cos(elevation),
    )
    away = 2.6 * radius

    def view(x: float, y: float, z: float) -> tuple[float, float, float]:
        d = (x - middle[0], y - middle[1], z - middle[2])
        u, v, w = (sum(a * b for a, b in zip(d, axis, strict=True)) for axis in (right, up, back))
        return u / (away - w), -v / (away - w), away - w

    scale, cx, cy = _fit([view(*p)[:2] for p in points])

    def screen(x: float, y: float, z: float) -> Point:
        u, v, _ = view(x, y, z)
        return TILE / 2 + scale * (u - cx), TILE / 2 + scale * (v - cy)

    nodes = doc.spatial_relation_graph.nodes
    faces = []
    for name, outline, low, high in items:
        kind = nodes[name].asset_id
        for (x0, y0), (x1, y1) in itertools.pairwise([*outline, outline[0]]):
            # outlines run counter-clockwise: the outside is on the right
            if (y1 - y0) * (middle[0] + away * back[0] - x0) < (x1 - x0) * (
                middle[1] + away * back[1] - y0
            ):
                continue
            shade = 0.35 + 0.12 * abs(math.cos(math.atan2(y1 - y0, x1 - x0)))
            quad = [(x0, y0, low), (x1, y1, low), (x1, y1, high), (x0, y0, high)]
            faces.append((quad, _color(kind, shade), None))
        faces.append(([(x, y, high) for x, y in outline], _color(kind, 0.68), (60, 60, 60)))
    faces.sort(key=lambda f: -sum(view(*p)[2] for p in f[0]) / len(f[0]))
    for corners, fill, line in faces:
        draw.polygon([screen(*p) for p in corners], fill=fill, outline=line)
    return image


def sheet(
    docs: list[EsgDocument], path: Path, columns: int = 5, picture: Picture = top_down
) -> None:
    """Writes one picture of every layout on one sheet."""
    rows = math.ceil(len(docs) / columns)
    image = Image.new("RGB", (columns * TILE, rows * TILE), "white")
    draw = ImageDraw.Draw(image)
    for k, doc in enumerate(docs):
        x, y = (k % columns) * TILE, (k // columns) * TILE
        image.paste(picture(doc), (x, y))
        draw.text((x + 6, y + 6), doc.scene_definition.scene_id[:38], fill="black")
    image.save(path)


def curve(rows: list[dict[str, float]], path: Path) -> None:
    """Plots processor seconds over objects, a line per number of starts, axes logarithmic."""
    width, height, left, bottom = 640, 420, 70, 50
    image = Image.new("RGB", (width, height), "white")
    draw = ImageDraw.Draw(image)
    counts = sorted({r["objects"] for r in rows})
    low = math.floor(math.log10(min(r["cpu_seconds"] for r in rows)))
    high = math.ceil(math.log10(max(r["cpu_seconds"] for r in rows)))
    span = math.log(counts[-1] / counts[0])

    def at(objects: float, seconds: float) -> Point:
        x = left + (width - left - 110) * math.log(objects / counts[0]) / span
        share = (math.log10(max(seconds, 10.0**low)) - low) / (high - low)
        return x, height - bottom - (height - bottom - 30) * share

    for k in range(low, high + 1):
        y = at(counts[0], 10.0**k)[1]
        draw.line([(left, y), (width - 110, y)], fill=(220, 220, 220))
        draw.text((8, y - 6), f"{10.0**k:g} s", fill="black")
    for n in counts:
        draw.text((at(n, 1.0)[0] - 6, height - bottom + 8), f"{n:g}", fill="black")
    draw.text((width / 2 - 60, height - 20), "objects", fill="black")
    draw.text((8, 8), "processor seconds of the search, one CPU core", fill="black")
    for k, starts in enumerate(sorted({r["starts"] for r in rows})):
        line = [at(r["objects"], r["cpu_seconds"]) for r in rows if r["starts"] == starts]
        color = ((31, 119, 180), (214, 120, 20), (44, 130, 44))[k % 3]
        draw.line(line, fill=color, width=2)
        draw.text((line[-1][0] + 8, line[-1][1] - 6), f"{starts:g} starts", fill=color)
    image.save(path)
