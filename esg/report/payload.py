"""One scene as data for the page: what moves, what happened, what was asked."""

from __future__ import annotations

import base64
from collections.abc import Generator, Sequence
import contextlib
import io
from pathlib import Path
from typing import Any

import numpy as np

from esg.assets.looks import Look
from esg.engines.breaking import shown, whole_of_fragments
from esg.engines.scene import Rollout, SimScene
from esg.engines.wheels import scene_angles
from esg.fidelity import stand_ins
from esg.report.binary import Chunk
from esg.report.meshes import MeshLibrary
from esg.report.replays import Replayed
from esg.report.run import SceneEntry
from esg.report.words import pieces
from esg.scenereading import absent, collected, damaged
from esg.strangers.gltf import MOST_PIXELS
from esg.thresholds import PIECE_GAP_M

FPS = 60.0
"""Frames a second that a page keeps of a replay."""
MAX_CONTACTS = 400
MIN_IMPULSE_NS = 0.01
THUMB_PX = (320, 214)
SHEET_PX = 1100
PICTURES = ("PNG", "WEBP")
MOST_FILM_BYTES = 2_000_000
MOST_TEXT_CHARS = 4_000_000
"""Of a file that a page quotes."""
_MOVED_M, _TURNED = 1e-4, 1e-4


def index_entry(
    scene: SceneEntry, number: int, key: str, problems: Sequence[str] = ()
) -> dict[str, Any]:
    """What lists, filters and cards need to know of a scene.

    Args:
        scene: The scene.
        number: Its place in the run.
        key: Its folder, seen from the run's.
        problems: Damaged files of it, told without its path.
    """
    verdict, coverage = scene.verdict, scene.document.get("coverage", {})
    items = coverage.get("items", [])
    constraints = verdict.get("constraints", [])
    return {
        "n": number,
        "id": key,
        "group": scene.group,
        "seed": scene.seed,
        "prompt": scene.prompt,
        "outcome": scene.outcome,
        "reason": scene.reason,
        "problems": list(problems),
        "advice": scene.metrics.get("advice", ""),
        "proof": scene.metrics.get("proof", ""),
        "judged_against": scene.metrics.get("judged_against", ""),
        "verified": bool(scene.metrics.get("verified")),
        "events": [
            {k: e.get(k) for k in ("id", "type", "completed", "time_s", "bodies", "reason")}
            for e in verdict.get("events", [])
        ],
        "completed": verdict.get("completed", 0),
        "n_events": verdict.get("n_events", 0),
        "slr": verdict.get("slr"),
        "ppa": _mean([c["score"] for c in constraints]),
        "constraints": len(constraints),
        "used": sum(i["status"] == "used" for i in items),
        "items": len(items),
        "not_understood": [i["text"] for i in items if i["status"] == "not_understood"],
        "statements": len(scene.statements),
        "kept": sum(row["status"] == "kept" for row in scene.statements),
        "not_kept": [{k: row[k] for k in ("words", "status")} for row in scene.not_kept],
        "plausible": scene.plausible,
        "implausible": (scene.metrics.get("plausibility") or {}).get("worst", ""),
        "warnings": [*coverage.get("warnings", []), *stand_ins(scene.document)],
        "objects": len(scene.document.get("spatial_relation_graph", {}).get("nodes", {})),
        "seconds": round(scene.seconds, 2),
    }


def _mean(values: Sequence[float]) -> float | None:
    return sum(values) / len(values) if values else None


def scene_chunk(
    scene: SceneEntry,
    replays: Sequence[Replayed],
    meshes: MeshLibrary,
    problems: list[str] | None = None,
) -> str:
    """Everything the page of one scene shows.

    Args:
        scene: The scene.
        replays: Its replays, the recorded one first; none if it never came to one.
        meshes: Receives the meshes.
        problems: Receives what is wrong with a damaged contact sheet.
    """
    sheet, film = scene.folder / "preview.png", scene.folder / "preview.mp4"
    told = [] if problems is None else problems
    chunk = Chunk(
        {
            "document": scene.document,
            "metrics": scene.metrics,
            "words": pieces(scene.prompt, scene.document, scene.statements),
            "statements": scene.statements,
            "asked": scene.asked,
            "log": list(scene.log),
            "files": [] if scene.refused else files_of(scene.folder),
            "texts": {} if scene.refused else texts_of(scene.folder),
            "sheet": ""
            if scene.refused
            else collected(told, lambda: picture(sheet, SHEET_PX, quality=62), ""),
            "film": "" if scene.refused else collected(told, lambda: film_of(film), ""),
            "bodies": [],
            "replays": [],
        }
    )
    if replays:
        around = around_of(scene.document, replays[0], meshes)
        if around is not None:
            chunk.head["around"] = around
        chunk.head["bodies"] = _bodies(replays[0].scene, scene.folder, meshes, told)
        chunk.head["regions"] = _regions(replays[0].scene)
        ropes = ropes_of(replays[0].scene)
        if ropes:
            chunk.head["ropes"] = ropes
    for number, replay in enumerate(replays):
        chunk.head["replays"].append(_replay(chunk, number, replay))
    return chunk.text()


def _bodies(
    sim: SimScene, folder: Path, meshes: MeshLibrary, problems: list[str]
) -> list[dict[str, Any]]:
    wholes = whole_of_fragments(sim)
    return [
        {
            "name": b.name,
            "label": b.label or b.name.replace("_", " "),
            "category": b.category,
            "static": b.static,
            "mass": b.mass,
            "color": list(b.color),
            "half": list(b.half_extents),
            "offset": list(b.origin_offset),
            "collides": b.collides,
            "mesh": meshes.add(b, folder, problems, wholes.get(b.name)),
            **({"wheels": [[w.name, *w.axle] for w in b.wheels]} if b.wheels else {}),
        }
        for b in sim.bodies
    ]


def _regions(sim: SimScene) -> list[dict[str, Any]]:
    names = sim.names
    return [
        {
            "name": r.name,
            "body": names.index(r.parent),
            "center": list(r.center),
            "half": list(r.half_extents),
        }
        for r in sim.regions
        if r.parent in names
    ]


def ropes_of(sim: SimScene) -> list[dict[str, Any]]:
    """Ropes and springs: the bodies they hold (-1 for the world), where, and how long they are [m].

    One that is longer than that is gone.
    """
    names = sim.names
    return [
        {
            "a": names.index(j.parent) if j.parent in names else -1,
            "b": names.index(j.child),
            "from": list(j.parent_anchor),
            "to": list(j.child_anchor),
            "length": j.upper + PIECE_GAP_M if j.kind == "rope" and j.upper is not None else None,
        }
        for j in sim.joints
        if j.flexible
    ]


def _replay(chunk: Chunk, number: int, replay: Replayed) -> dict[str, Any]:
    rollout = shown(replay.scene, replay.rollout)
    frames = frames_at(rollout.time, FPS)
    # What diverged is shown as far as it went: not a number is no place to draw at.
    position = np.nan_to_num(rollout.position[0, frames].astype(float), posinf=0.0, neginf=0.0)
    quaternion = continuous(np.nan_to_num(rollout.quaternion[0, frames].astype(float)))
    moving = [
        i
        for i in range(position.shape[1])
        if np.ptp(position[:, i], axis=0).max() > _MOVED_M
        or np.ptp(quaternion[:, i], axis=0).max() > _TURNED
    ]
    speed = np.linalg.norm(rollout.linear_velocity[0, frames][:, moving].astype(float), axis=2)
    chunk.quantized(f"time{number}", rollout.time[frames][:, None], delta=True)
    chunk.quantized(f"position{number}", position[:, moving].reshape(len(frames), -1), delta=True)
    chunk.quantized(f"turn{number}", quaternion[:, moving].reshape(len(frames), -1), delta=True)
    chunk.quantized(f"speed{number}", speed, delta=True)
    angles = scene_angles(replay.scene, rollout)[frames]
    if angles.shape[1]:
        chunk.quantized(f"wheels{number}", angles, delta=True)
    return {
        "engine": rollout.engine,
        "hz": round(1 / rollout.dt),
        "proof": replay.proof,
        "valid": bool(rollout.valid[0]),
        "moving": moving,
        "start": [
            [*map(float, p), *map(float, q)]
            for p, q in zip(position[0], quaternion[0], strict=True)
        ],
        "events": replay.events,
        "completed": sum(bool(e.get("completed")) for e in replay.events),
        "contacts": contacts_of(rollout),
    }


def frames_at(time: Any, fps: float) -> list[int]:
    """Indices of the frames nearest to every 1/fps, and of the last."""
    time = np.asarray(time, float)
    count = int(np.floor(time[-1] * fps + 1e-6)) + 1
    wanted = np.arange(count) / fps
    right = np.clip(np.searchsorted(time, wanted), 0, len(time) - 1)
    left = np.maximum(right - 1, 0)
    index = np.where(wanted - time[left] < time[right] - wanted, left, right)
    return sorted({*index.tolist(), len(time) - 1})


def continuous(q: Any) -> Any:
    """Quaternions whose sign does not jump from frame to frame, shape [T, B, 4]."""
    flips = np.sign(np.einsum("tbi,tbi->tb", q[1:], q[:-1]))
    flips[flips == 0] = 1
    return q * np.concatenate([np.ones((1, q.shape[1])), np.cumprod(flips, axis=0)])[..., None]


def contacts_of(rollout: Rollout) -> list[list[float]]:
    """Contacts worth drawing, by time: time, a, b, impulse [N s], point [m], normal.

    Blows win over resting contact: of every pair the strongest contact of each twentieth of a
    second is kept, of all of them the strongest few hundred.
    """
    c = rollout.contacts.select(0)
    best: dict[tuple[int, int, int], int] = {}
    for row in range(len(c.time)):
        if not c.impulse[row] >= MIN_IMPULSE_NS or c.b[row] < 0:
            continue
        key = (int(c.a[row]), int(c.b[row]), int(c.time[row] / 0.05))
        if key not in best or c.impulse[row] > c.impulse[best[key]]:
            best[key] = row
    rows = sorted(best.values(), key=lambda r: -float(c.impulse[r]))[:MAX_CONTACTS]
    return [
        [
            round(float(c.time[r]), 4),
            int(c.a[r]),
            int(c.b[r]),
            float(f"{float(c.impulse[r]):.4g}"),
            *(round(float(v), 4) for v in c.point[r]),
            *(round(float(v), 3) for v in c.normal[r]),
        ]
        for r in sorted(rows, key=lambda r: (float(c.time[r]), r))
        if np.isfinite([c.impulse[r], *c.point[r], *c.normal[r]]).all()
    ]


_SHOWN = frozenset(
    [".json", ".jsonl", ".h", ".cpp", ".usda", ".mcap", ".glb", ".png", ".mp4", ".npz", ".txt"]
)


def files_of(folder: Path) -> list[list[Any]]:
    """Files of the scene folder that one may want to open: path and size [bytes]."""
    found = [p for p in sorted(folder.rglob("*")) if p.is_file() and p.suffix in _SHOWN]
    return [
        [p.relative_to(folder).as_posix(), p.stat().st_size]
        for p in found
        if p.relative_to(folder).parts[0] not in ("stages", "meshes")
    ]


def texts_of(folder: Path) -> dict[str, str]:
    """The emitted class and the manifest."""
    paths = [*sorted((folder / "unreal").glob("*.h")), *sorted((folder / "unreal").glob("*.cpp"))]
    texts = [*paths, folder / "manifest.json", folder / "violations.json"]
    return {p.name: _beginning(p) for p in texts if p.is_file()}


def _beginning(path: Path) -> str:
    with path.open(encoding="utf-8", errors="replace") as file:
        text = file.read(MOST_TEXT_CHARS)
        return text + ("\n[cut off]" if file.read(1) else "")


def thumbnail(folder: Path) -> str:
    """A card's picture as base64 (WebP), empty if there is none: the sheet's middle panel.

    Raises:
        UserError: If it is damaged.
    """
    path = folder / "preview.png"
    if absent(path):
        return ""
    from PIL import Image

    from esg.view.sheet import panel_boxes

    with _reading(path), Image.open(path, formats=PICTURES) as image:
        _bearable(image)
        boxes = panel_boxes(image)
        crop = image.convert("RGB").crop(boxes[min(1, len(boxes) - 1)]) if boxes else image
        return _webp(crop.convert("RGB"), THUMB_PX, 60)


def picture(path: Path, width: int, *, quality: int) -> str:
    """A picture as base64 (WebP), at most `width` pixels wide; empty if it is missing.

    Raises:
        UserError: If it is damaged.
    """
    if absent(path):
        return ""
    from PIL import Image

    with _reading(path), Image.open(path, formats=PICTURES) as image:
        _bearable(image)
        height = max(1, round(image.height * min(1.0, width / image.width)))
        return _webp(image.convert("RGB"), (width, height), quality)


def film_of(path: Path) -> str:
    """A film as base64, empty if there is none.

    Raises:
        UserError: If it is none, or too large to travel in a page.
    """
    if absent(path):
        return ""
    try:
        data = path.read_bytes() if path.stat().st_size <= MOST_FILM_BYTES else b""
    except OSError as error:
        raise damaged(path, error.strerror or str(error)) from None
    if data[4:8] != b"ftyp":
        raise damaged(path, f"no film of at most {MOST_FILM_BYTES} bytes")
    return base64.b64encode(data).decode("ascii")


def around_of(
    document: dict[str, Any], replay: Replayed, meshes: MeshLibrary
) -> dict[str, Any] | None:
    """What surrounds a dressed scene: its light, its ground and what stands there.

    Args:
        document: The scene graph as JSON.
        replay: Its bodies and their motion.
        meshes: Receives the meshes.
    """
    from pydantic import ValidationError

    from esg.assets.gltf.surfaces import surface_of
    from esg.dressing.clearance import covered
    from esg.graph.models import EsgDocument
    from esg.lexicon.places import places
    from esg.report.meshes import Piece
    from esg.view.surroundings import surroundings_of, thing_of

    if not document.get("dressing"):
        return None
    try:
        doc = EsgDocument.model_validate(document)
    except ValidationError:
        return None  # the document's own reader tells what is wrong with it
    around = surroundings_of(doc, replay.scene, replay.rollout)
    sky = around.sky
    plane = 200.0 * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
    tiles = plane[:, :2] / around.ground.tile_m
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    pieces = [Piece("plane", plane, faces, tiles, surface_of(around.ground))]
    for part in around.parts:
        look = part.look or Look("", part.color)
        uvs = part.uvs if look.texture else None
        pieces.append(Piece(thing_of(part), part.vertices, part.faces, uvs, surface_of(look)))
    indoor = places()[doc.dressing.place].setting == "indoor" if doc.dressing else False
    ground = doc.dressing.ground if doc.dressing else ""
    bodies = enumerate(replay.scene.bodies)
    return {
        "mesh": meshes.add_pieces(pieces),
        "covered": [i for i, b in bodies if covered(b, indoor=indoor, ground=ground)],
        "kind": sky.kind,
        **{
            k: list(getattr(sky, k)) for k in ("sun", "sun_rgb", "ambient_rgb", "zenith", "horizon")
        },
    }


def _bearable(image: Any) -> None:
    """Looks at the size that a picture declares before it is decoded."""
    if image.width * image.height > MOST_PIXELS:
        raise ValueError(f"{image.width} x {image.height} pixels, at most {MOST_PIXELS} are read")


@contextlib.contextmanager
def _reading(path: Path) -> Generator[None]:
    """Tells what a decoder found wrong with a picture."""
    try:
        yield
    except Exception as error:  # a decoder's complaints have no common class
        raise damaged(path, f"no picture: {str(error).split(chr(39))[0].strip()}") from None


def _webp(image: Any, size: tuple[int, int], quality: int) -> str:
    from PIL import Image

    if image.width > size[0] or image.height > size[1]:
        image.thumbnail(size, Image.Resampling.LANCZOS)
    out = io.BytesIO()
    image.save(out, "WEBP", quality=quality, method=4)
    return base64.b64encode(out.getvalue()).decode("ascii")
