"""What strangers do to what they pass on: classes, folders and files that attack who opens them.

The tests of `tests/security` open them within Python, `attacks.py` through the command line.
"""

from __future__ import annotations

import io
import json
import os
from pathlib import Path
import shutil
import socket
import struct
from typing import Any

import numpy as np

SECRET = "my secret key 4711"
"""Content of a file that nobody but its user shall see."""


def source_of(scene: Path) -> Path:
    """The class's source."""
    (path,) = (scene / "unreal").glob("*.cpp")
    return path


def in_tick(scene: Path, code: str, before: str = "") -> Path:
    """Lets the class do something in every step; `before` stands at the end of its includes."""
    path = source_of(scene)
    text = path.read_text("utf-8")
    head, last = text[: text.rindex("#include")], text[text.rindex("#include") :]
    line, rest = last.split("\n", 1)
    mark = "::DispatchProgram(double Due)\n{\n"
    assert mark in rest
    rest = rest.replace(mark, f"{mark}\t{code}\n", 1)
    path.write_text(f"{head}{line}\n{before}\n{rest}", "utf-8")
    return scene


def plants(marker: Path) -> str:
    """C++ that leaves a file behind when it runs."""
    return f'{{ if (auto* F = fopen(TEXT("{marker}"), TEXT("w"))) {{ fclose(F); }} }}'


def in_a_static(scene: Path, marker: Path) -> None:
    code = f"namespace {{ struct FPlant {{ FPlant() {plants(marker)} }} Plant; }}"
    path = source_of(scene)
    path.write_text(path.read_text("utf-8") + code + "\n", "utf-8")


def in_the_constructor(scene: Path, marker: Path) -> None:
    path = source_of(scene)
    mark = "\tFixedTimeStep = "
    text = path.read_text("utf-8")
    assert mark in text
    path.write_text(text.replace(mark, f"\t{plants(marker)}\n{mark}", 1), "utf-8")


def in_every_step(scene: Path, marker: Path) -> None:
    in_tick(scene, plants(marker))


def in_the_header(scene: Path, marker: Path) -> None:
    path = source_of(scene).with_suffix(".h")
    code = f"inline struct FPlant {{ FPlant() {plants(marker)} }} Plant;"
    path.write_text(path.read_text("utf-8") + code + "\n", "utf-8")


def with_its_document(scene: Path, marker: Path) -> None:
    """The document says something else than the class: another scene's."""
    in_every_step(scene, marker)
    path = scene / "esg.json"
    path.write_text(path.read_text("utf-8").replace("bowling", "bowling "), "utf-8")


def without_a_document(scene: Path, marker: Path) -> None:
    in_every_step(scene, marker)
    (scene / "esg.json").unlink()


def under_another_name(scene: Path, marker: Path) -> None:
    in_every_step(scene, marker)
    for path in (source_of(scene), source_of(scene).with_suffix(".h")):
        text = path.read_text("utf-8").replace(path.stem, "EsgScene_Other")
        path.with_stem("EsgScene_Other").write_text(text, "utf-8")
        path.unlink()


TAMPERED = [
    in_a_static,
    in_the_constructor,
    in_every_step,
    in_the_header,
    with_its_document,
    without_a_document,
    under_another_name,
]


def _link(path: Path, target: Path) -> None:
    if path.is_dir():
        shutil.rmtree(path)
    path.unlink(missing_ok=True)
    path.symlink_to(target)


def _prompt(scene: Path, secret: Path) -> None:
    _link(scene / "prompt.txt", secret)


def _log(scene: Path, secret: Path) -> None:
    _link(scene / "log.jsonl", secret)


def _header(scene: Path, secret: Path) -> None:
    _link(next((scene / "unreal").glob("*.h")), secret)


def _new_file(scene: Path, secret: Path) -> None:
    _link(scene / "notes.txt", secret)


def _folder(scene: Path, secret: Path) -> None:
    _link(scene / "meshes", secret.parent)


def _relative(scene: Path, secret: Path) -> None:
    _link(scene / "stages", Path("..") / secret.parent.name)


def _over_a_link(scene: Path, secret: Path) -> None:
    _link(scene / "first", scene / "second")
    _link(scene / "second", secret)


def _dangling(scene: Path, secret: Path) -> None:
    _link(scene / "gone", Path("/no/such/place"))


def _pipe(scene: Path, secret: Path) -> None:
    (scene / "scene.glb").unlink(missing_ok=True)
    os.mkfifo(scene / "scene.glb")


def _pipe_for_a_document(scene: Path, secret: Path) -> None:
    (scene / "esg.json").unlink()
    os.mkfifo(scene / "esg.json")


def _socket(scene: Path, secret: Path) -> None:
    (scene / "rollout.mcap").unlink(missing_ok=True)
    here = os.getcwd()
    os.chdir(scene)  # addresses of sockets are short
    try:
        with socket.socket(socket.AF_UNIX) as made:
            made.bind("rollout.mcap")
    finally:
        os.chdir(here)


ODD = [_prompt, _log, _header, _new_file, _folder, _relative, _over_a_link, _dangling, _pipe,
       _pipe_for_a_document, _socket]  # fmt: skip


def glb(document: dict[str, Any], binary: bytes) -> bytes:
    """A GLB of a document and its binary chunk."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def box() -> tuple[dict[str, Any], bytes]:
    """A sound model."""
    import trimesh

    from esg.strangers import gltf

    data = trimesh.Scene(trimesh.creation.box()).export(file_type="glb")
    assert isinstance(data, bytes)
    return gltf.read_glb(data)


def _count(d: dict[str, Any]) -> None:
    d["accessors"][0]["count"] = 10**12


def _count_without_a_view(d: dict[str, Any]) -> None:
    d["accessors"].append({"count": 10**9, "componentType": 5126, "type": "VEC4"})


def _long_view(d: dict[str, Any]) -> None:
    d["bufferViews"][0]["byteLength"] = 10**9


def _long_buffer(d: dict[str, Any]) -> None:
    d["buffers"][0]["byteLength"] = 10**12


def _many_nodes(d: dict[str, Any]) -> None:
    from esg.strangers import gltf

    d["nodes"] = [{}] * (gltf.MOST_ITEMS + 1)


def _loop(d: dict[str, Any]) -> None:
    d["nodes"] = [{"children": [1]}, {"children": [0]}]


def _own_parent(d: dict[str, Any]) -> None:
    d["nodes"] = [{"children": [0]}]


def _doubled(d: dict[str, Any]) -> None:
    """Every node twice below the one before: 2^40 boxes."""
    d["nodes"] = [{"children": [i + 1, i + 1]} for i in range(40)] + [{"mesh": 0}]


def _deep(d: dict[str, Any]) -> None:
    d["nodes"] = [{"children": [i + 1]} for i in range(1000)] + [{"mesh": 0}]


def _crowd(d: dict[str, Any]) -> None:
    d["accessors"][0] = {"count": 10_000_000, "componentType": 5126, "type": "VEC3"}
    d["nodes"] = [{"mesh": 0}] * 1000


def _no_such_index(d: dict[str, Any]) -> None:
    d["meshes"][0]["primitives"][0]["indices"] = 99


def _negative(d: dict[str, Any]) -> None:
    d["accessors"][0]["bufferView"] = -1


def _text_for_a_number(d: dict[str, Any]) -> None:
    d["accessors"][0]["count"] = "8"


def _outside(d: dict[str, Any]) -> None:
    d["buffers"][0]["uri"] = "../../etc/passwd"


def _picture_outside(d: dict[str, Any]) -> None:
    d["images"] = [{"uri": "/etc/passwd"}]


def _no_objects(d: dict[str, Any]) -> None:
    d["meshes"] = [3]


LIES = [
    _count,
    _count_without_a_view,
    _long_view,
    _long_buffer,
    _many_nodes,
    _loop,
    _own_parent,
    _doubled,
    _deep,
    _crowd,
    _no_such_index,
    _negative,
    _text_for_a_number,
    _outside,
    _picture_outside,
    _no_objects,
]


def array_of(shape: tuple[int, ...], data: bytes, kind: str = "<f8") -> bytes:
    out = io.BytesIO()
    facts = {"descr": kind, "fortran_order": False, "shape": shape}
    np.lib.format.write_array_header_1_0(out, facts)
    return out.getvalue() + data
