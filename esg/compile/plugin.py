"""Unreal plugin skeleton: a folder to drop into a project's `Plugins/`.

Only what is emitted from the scene has been compiled (under the shim) and run; the files around it
are written for UE 5.1 to 5.4 and have not met the engine. The plugin's README says so.
"""

from __future__ import annotations

from functools import cache
import json
from pathlib import Path
from typing import Any

from esg.assets.gltf.parts import parts_of
from esg.compile import names
from esg.compile.assets import mesh_file
from esg.compile.build import ClassFiles, shared_texts
from esg.compile.glb import part_of
from esg.compile.lint import PLAYER, lint
from esg.compile.replay import load_imports
from esg.compile.unreal.selfcontained import is_self_contained, self_contained
from esg.outcomes import UserError
from esg.scenereading import damaged
from esg.strangers.gltf import read_glb

PLUGIN = "ESGScenes"
_TEMPLATES = Path(__file__).parent / "templates"


def write_plugin(folder: Path, out: Path, *, alone: bool = False) -> list[Path]:
    """Writes the plugin of a compiled scene folder below `out`.

    Args:
        folder: Scene folder with `unreal/` and the meshes it names.
        out: Where the plugin folder goes.
        alone: Whether the class brings what plays it, instead of sharing it with other scenes.

    Returns:
        The files written, sorted.

    Raises:
        UserError: If the folder holds no class, or one that is damaged.
    """
    try:
        files = ClassFiles.read(folder)
    except OSError as error:
        raise UserError(f"{folder}: no compiled scene: {error}") from None
    complaints = lint(files.header, files.source, files.name)
    if complaints:
        raise damaged(folder / "unreal", "; ".join(complaints))
    files = self_contained(files) if alone else files
    imports = load_imports(folder / "unreal" / "imports.json")
    root = out / PLUGIN
    resources = root / "Resources" / files.name
    meshes: dict[str, bytes] = {}
    imports = imports | {"assets": [_resource(folder, a, meshes) for a in imports["assets"]]}
    source = root / "Source" / PLUGIN
    texts = {
        root / f"{PLUGIN}.uplugin": _descriptor(),
        root / "README.md": _readme(files),
        root / "Config" / "DefaultEngine.fragment.ini": _template("plugin_engine.ini"),
        root / "Content" / "Python" / "import_esg_assets.py": _template("plugin_import.py.txt"),
        resources / "imports.json": json.dumps(imports, indent=1) + "\n",
        source / f"{PLUGIN}.Build.cs": _template("plugin_build.cs.txt"),
        source / "Private" / f"{PLUGIN}Module.cpp": _template("plugin_module.cpp"),
        source / "Public" / f"{files.name}.h": files.header,
        source / "Private" / f"{files.name}.cpp": files.source,
    }
    if not is_self_contained(files):
        shared = shared_texts()
        texts[source / "Public" / f"{PLAYER}.h"] = shared[f"{PLAYER}.h"]
        texts[source / "Private" / f"{PLAYER}.cpp"] = shared[f"{PLAYER}.cpp"]
    for path, text in texts.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8", newline="\n")
    for source, data in meshes.items():
        target = resources / source
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(data)
    return sorted({*texts, *(resources / source for source in meshes)})


def _readme(files: ClassFiles) -> str:
    log = files.name if is_self_contained(files) else PLAYER
    text = _template("plugin_readme.md")
    return text.replace("@CLASS@", files.name).replace("@LOG@", f"Log{log}")


def _resource(folder: Path, asset: dict[str, Any], meshes: dict[str, bytes]) -> dict[str, Any]:
    """An asset with a file of its own, which is added to `meshes`: Unreal imports whole files."""
    mesh = mesh_file(folder, asset["source"])
    if mesh is None:
        return asset
    node, rest = asset.get("node", ""), asset.get("without_nodes", [])
    source = mesh.relative_to(folder)
    data = mesh.read_bytes()
    try:
        read_glb(data)
    except ValueError as error:
        raise damaged(mesh, str(error)) from None
    if node:
        source = source.with_suffix(f".{names.identifier(node)}.glb")
        data = part_of(data, holders=[node])
    elif rest:
        source = source.with_suffix(".Body.glb")
        data = part_of(data, without=rest)
    meshes[source.as_posix()] = data
    plain = {k: v for k, v in asset.items() if k not in ("node", "without_nodes")}
    return plain | {"source": source.as_posix(), "materials": _materials(data)}


def _materials(data: bytes) -> list[dict[str, Any]]:
    """The materials of a GLB in the order of its parts: linear factors, and names of pictures."""
    surfaces = dict.fromkeys(part.surface for part in parts_of(data))
    return [
        {
            "name": surface.name,
            "base_color": [*surface.color, surface.alpha],
            "roughness": surface.roughness,
            "metallic": surface.metalness,
            "textures": {
                kind: picture.name or picture.digest
                for kind, picture in (
                    ("base_color", surface.base),
                    ("normal", surface.normal),
                    ("roughness_metallic", surface.rough_metal),
                )
                if picture is not None
            },
        }
        for surface in surfaces
    ]


@cache
def _template(name: str) -> str:
    return (_TEMPLATES / name).read_text("utf-8")


def _descriptor() -> str:
    data = {
        "FileVersion": 3,
        "Version": 1,
        "VersionName": "1.0",
        "FriendlyName": "ESG Scenes",
        "Description": "Dynamic scenes with a control program and checked contact events.",
        "Category": "Simulation",
        "CreatedBy": "esg-scenes",
        "CanContainContent": True,
        "Modules": [{"Name": PLUGIN, "Type": "Runtime", "LoadingPhase": "Default"}],
        "Plugins": [
            {"Name": "PythonScriptPlugin", "Enabled": True},
            {"Name": "EditorScriptingUtilities", "Enabled": True},
        ],
    }
    return json.dumps(data, indent="\t") + "\n"
