"""The same picture elsewhere: GLB and USD of finished scenes in Blender and three.js beside ours.

    python -m venv blender && blender/bin/pip install bpy==5.0.1
    npm ci --prefix tests/compile/gltf
    python -m benchmarks.looks RUN --bpy blender/bin/python --out OUT [--sheet looks.webp]

Every scene of RUN is exported and opened, without anything of this project, by Blender (both files)
and by three.js in headless Chromium (the GLB). Each draws the middle of the replay through the
file's own camera by the file's own sun; what it found is compared with what was exported: where
every body is at three instants, and every material's factors and pictures.
"""

from __future__ import annotations

import argparse
from collections.abc import Collection, Sequence
from dataclasses import asdict, dataclass, field, replace
import json
from pathlib import Path
import shutil
import subprocess
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.looks.in_three import BROWSERS, THREE, shown
from esg.assets.gltf.parts import parts_of
from esg.assets.gltf.surfaces import Surface
from esg.compile.export import animation
from esg.compile.glb import origin_poses
from esg.compile.names import unique_identifiers
from esg.compile.visuals.decals import drawn_lifts
from esg.compile.visuals.setting import Setting, seen_at
from esg.engines.manifest import load_manifest
from esg.engines.scene import Rollout, SimScene
from esg.graph import load_document
from esg.scenefolder import is_scene_folder
from esg.view.camera import Camera
from esg.view.setting import export_folder, setting_in

SIZE = (480, 270)
SAMPLES = 12
THREADS = 2
FACTOR = 0.01
"""Largest difference of a factor that counts as the same."""
COLUMNS = ("ours", "Blender, GLB", "Blender, USD", "three.js, GLB")
_Y_UP = np.array([[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, -1.0, 0.0, 0.0], [0, 0, 0, 1]])
"""Leads our frame into glTF's."""


@dataclass
class Found:
    """What a program found in a file, against what was exported.

    Args:
        program: Its name and version.
        file: Which file.
        bodies: How many were compared.
        apart_m, turned_deg: Largest difference of a body's place at three instants.
        materials: How many there are.
        same: How many of them have the factors and pictures that were exported.
        wrong: What differs, in words.
    """

    program: str
    file: str
    bodies: int = 0
    apart_m: float = 0.0
    turned_deg: float = 0.0
    materials: int = 0
    same: int = 0
    wrong: list[str] = field(default_factory=list)


def wanted_places(
    scene: SimScene, rollout: Rollout, covered: Collection[str], frames: Sequence[int]
) -> dict[str, NDArray[np.float64]]:
    """World matrices of the bodies that are drawn, at some frames, shape [n, 4, 4]."""
    out: dict[str, NDArray[np.float64]] = {}
    for index, body in enumerate(scene.bodies):
        if body.name in covered:
            continue
        at, q = origin_poses(
            body, rollout.position[0, frames, index], rollout.quaternion[0, frames, index]
        )
        matrices = np.tile(np.eye(4), (len(frames), 1, 1))
        for k in range(len(frames)):
            matrices[k, :3, :3] = _matrix(q[k])
        matrices[:, :3, 3] = at
        out[body.name] = matrices
    return out


def _raised(by: float) -> NDArray[np.float64]:
    """What raises a matrix, added to it."""
    up = np.zeros((4, 4))
    up[2, 3] = by
    return up


def _matrix(q: NDArray[np.float64]) -> NDArray[np.float64]:
    from scipy.spatial.transform import Rotation

    return Rotation.from_quat(q).as_matrix()


def compare_places(
    found: Found, wanted: dict[str, NDArray[np.float64]], places: Sequence[dict[str, Any]]
) -> None:
    """How far bodies are from where they should be, by name."""
    for name, matrices in wanted.items():
        if name not in places[0]:
            found.wrong.append(f"{name} is missing")
            continue
        found.bodies += 1
        for matrix, place in zip(matrices, places, strict=True):
            other = np.array(place[name], float)
            found.apart_m = max(found.apart_m, float(np.linalg.norm(matrix[:3, 3] - other[:3, 3])))
            between = matrix[:3, :3].T @ other[:3, :3]
            cosine = np.clip((np.trace(between) - 1.0) / 2.0, -1.0, 1.0)
            found.turned_deg = max(found.turned_deg, float(np.degrees(np.arccos(cosine))))


def compare_materials(found: Found, wanted: Sequence[Surface], materials: Any) -> None:
    """Whether every exported surface is there with its factors and pictures."""
    seen = [(name.rsplit(".", 1)[0] if name[-4:-3] == "." else name, m) for name, m in materials]
    for surface in wanted:
        found.materials += 1
        same = [m for name, m in seen if m is not None and _same_name(name, surface.name)]
        faults = [_faults(surface, m) for m in same]
        if faults and min(map(len, faults)) == 0:
            found.same += 1
        else:
            best = min(faults, key=len) if faults else ["missing"]
            found.wrong.append(f"material {surface.name}: {', '.join(best)}")


def _same_name(name: str, wanted: str) -> bool:
    """Whether names agree, but for the number that tells materials of one name apart."""
    return name == wanted or name.removeprefix(wanted).lstrip("_").isdigit()


def _faults(surface: Surface, m: dict[str, Any]) -> list[str]:
    out: list[str] = []
    pictures = {
        "base": surface.base, "normal": surface.normal, "rough_metal": surface.rough_metal
    }  # fmt: skip
    for kind, picture in pictures.items():
        sizes = m["pictures"].get(kind, [])
        if bool(sizes) != (picture is not None):
            out.append(f"picture {kind} is {'there' if sizes else 'not there'}")
        elif picture is not None and min(sizes) < 2:
            out.append(f"picture {kind} could not be read")
    for key in ("color", "roughness", "metalness"):
        value, told = getattr(surface, key), m.get(key)
        if told is not None and np.abs(np.subtract(value, told)).max() > FACTOR:
            out.append(f"{key} {np.round(told, 3)}, not {np.round(value, 3)}")
    return out


def in_blender(job: dict[str, Any], python: str) -> dict[str, Any]:
    """What Blender finds in a file; its picture goes to the job's `picture`."""
    answer = Path(job["picture"]).with_suffix(".json")
    path = answer.with_suffix(".job")
    path.write_text(json.dumps(job | {"answer": str(answer)}))
    script = Path(__file__).with_name("in_blender.py")
    done = subprocess.run([python, str(script), str(path)], capture_output=True, text=True)
    if not answer.is_file():
        raise SystemExit(f"{job['file']} in Blender: {done.stdout[-600:]}{done.stderr[-2000:]}")
    return json.loads(answer.read_text())


def ours(
    scene: SimScene, rollout: Rollout, folder: Path, setting: Setting, frame: int, out: Path
) -> None:
    """Our own picture of a frame through the same camera."""
    from PIL import Image

    from esg.engines.wheels import scene_angles
    from esg.view.renderers.kinds import kind_named
    from esg.view.renderers.records import Poses, Quality
    from esg.view.scenery import scenery_of
    from esg.view.surroundings import thing_of

    camera = camera_at(setting, float(rollout.time[frame]))
    whole = scenery_of(scene, rollout, load_document(folder / "esg.json"))
    around = whole.surroundings
    assert around is not None
    exported = {thing_of(p) for p in setting.parts}
    parts = tuple(p for p in around.parts if thing_of(p) in exported)
    seen = replace(whole, surroundings=replace(around, sky=setting.sky, parts=parts))
    drawer = kind_named("raster").load(seen, Quality(SIZE))
    angles = scene_angles(scene, rollout)[None, frame : frame + 1]
    now = slice(frame, frame + 1)
    poses = Poses(rollout.position[:1, now], rollout.quaternion[:1, now], angles)
    rgb = drawer.draw(poses, [camera]).rgb
    assert rgb is not None
    Image.fromarray(rgb[0]).save(out)


def camera_at(setting: Setting, time: float) -> Camera:
    """The first camera of a setting at an instant [s]."""
    view = setting.views[0]
    at, turn = seen_at(view, np.array([time]))
    ahead = _matrix(turn[0]) @ (0.0, 0.0, -1.0)
    eye, target = tuple(at[0]), tuple(at[0] + 10.0 * ahead)
    return Camera(eye, target, view.fov)  # type: ignore[arg-type]  # three floats each


def look(folder: Path, out: Path, python: str, browser: str) -> list[Found]:
    """Exports a scene, opens it everywhere, and leaves the pictures in `out`."""
    manifest = load_manifest(folder / "manifest.json")
    scene, rollout = manifest.scene, animation(folder, manifest)
    setting = setting_in(folder, scene, rollout)
    assert setting is not None
    out.mkdir(parents=True, exist_ok=True)
    [glb] = export_folder(folder, "glb", out)
    usd = next(p for p in export_folder(folder, "usd", out) if "animation" in p.name)
    last = len(rollout.time) - 1
    frames = [0, last // 2, last]
    times = [float(rollout.time[f]) for f in frames]
    ours(scene, rollout, folder, setting, frames[1], out / "ours.png")
    lifts = drawn_lifts(scene, setting.covered)
    lying = wanted_places(scene, rollout, setting.covered, frames)
    wanted = {n: m + _raised(lifts.get(scene.index(n), 0.0)) for n, m in lying.items()}
    surfaces = list(dict.fromkeys(part.surface for part in parts_of(glb.read_bytes())))
    rate = 1.0 / (times[1] / frames[1]) if frames[1] else 60.0
    job = {
        "times": times, "at": times[1], "rate": rate, "ambient": list(setting.sky.ambient_rgb),
        "samples": SAMPLES, "threads": THREADS, "size": SIZE,
    }  # fmt: skip
    results: list[Found] = []
    for path, picture in ((glb, "blender_glb.png"), (usd, "blender_usd.png")):
        answer = in_blender(job | {"file": str(path), "picture": str(out / picture)}, python)
        found = Found(f"Blender {answer['version']}", path.name)
        places = answer["places"]
        if path is usd:
            idents = usd_names(scene, setting)
            places = [{n: p[i] for n, i in idents.items() if i in p} for p in places]
        # What lies on the ground is drawn higher: in USD only its picture, not its body.
        compare_places(found, lying if path is usd else wanted, places)
        compare_materials(found, surfaces, answer["materials"].items())
        results.append(found)
    middle = _Y_UP[:3, :3] @ np.array(camera_target(wanted))
    answer = shown(
        glb, job | {"middle": middle.tolist(), "picture": str(out / "three.png")}, browser
    )
    found = Found(f"three.js r{answer['version']}", glb.name)
    compare_places(found, wanted, [{n: _z_up(m) for n, m in p.items()} for p in answer["places"]])
    compare_materials(found, surfaces, answer["materials"])
    return [*results, found]


def camera_target(wanted: dict[str, NDArray[np.float64]]) -> NDArray[np.float64]:
    """Middle of the bodies that move, at the middle instant [m]."""
    moving = [m[1, :3, 3] for m in wanted.values() if np.abs(m[0] - m[-1]).max() > 1e-3]
    return np.mean(moving or [m[1, :3, 3] for m in wanted.values()], axis=0)


def usd_names(scene: SimScene, setting: Setting) -> dict[str, str]:
    """Names of prims by those of bodies."""
    from esg.compile.usd import reserved

    return unique_identifiers(scene.names, reserved=reserved(scene, setting))


def _z_up(columns: Sequence[float]) -> Any:
    """A matrix that three.js wrote column by column, in our frame, node's own axes included."""
    return (_Y_UP.T @ np.array(columns).reshape(4, 4).T @ _Y_UP).tolist()


def sheet(rows: Sequence[tuple[str, Path]], path: Path, width: int = 300) -> None:
    """Pictures of scenes, one a row: ours and the others'."""
    from PIL import Image, ImageDraw

    names = ("ours.png", "blender_glb.png", "blender_usd.png", "three.png")
    height, gap, head = width * SIZE[1] // SIZE[0], 4, 18
    image = Image.new(
        "RGB", (4 * (width + gap), head + len(rows) * (height + gap)), (255, 255, 255)
    )
    draw = ImageDraw.Draw(image)
    for column, title in enumerate(COLUMNS):
        draw.text((column * (width + gap) + 4, 3), title, fill=(0, 0, 0))
    for row, (title, folder) in enumerate(rows):
        for column, name in enumerate(names):
            at = column * (width + gap), head + row * (height + gap)
            with Image.open(folder / name) as picture:
                image.paste(picture.convert("RGB").resize((width, height)), at)
        draw.text((6, head + row * (height + gap) + 4), title, fill=(255, 255, 255))
    image.save(path, quality=82)


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.looks", description=__doc__.splitlines()[0]
    )
    parser.add_argument("run", type=Path, help="folder of scene folders")
    parser.add_argument("--bpy", required=True, help="interpreter that has Blender as a module")
    parser.add_argument("--browser", default=next(filter(shutil.which, BROWSERS), ""))
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--only", nargs="*", help="names of scene folders")
    parser.add_argument("--sheet", type=Path, help="where the pictures go, one row a scene")
    options = parser.parse_args()
    if not options.browser or not THREE.is_dir():
        parser.error("needs Chromium and `npm ci --prefix tests/compile/gltf`")
    folders = [p for p in options.run.iterdir() if is_scene_folder(p)]
    folders = [p for p in folders if not options.only or p.name in options.only]
    folders.sort(key=lambda p: (len(p.name), p.name))
    report: dict[str, list[dict[str, Any]]] = {}
    for folder in folders:
        results = look(folder, options.out / folder.name, options.bpy, options.browser)
        report[folder.name] = [asdict(r) for r in results]
        for r in results:
            print(
                f"{folder.name} {r.program} {r.file}: {r.bodies} bodies within "
                f"{1000 * r.apart_m:.3f} mm, {r.turned_deg:.3f} deg; "
                f"{r.same} of {r.materials} materials; {'; '.join(r.wrong[:4])}",
                flush=True,
            )
    (options.out / "looks.json").write_text(json.dumps(report, indent=1) + "\n")
    if options.sheet:
        sheet([(f.name, options.out / f.name) for f in folders], options.sheet)


if __name__ == "__main__":
    main()
