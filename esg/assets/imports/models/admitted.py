"""What of a robot description is read: checked before MuJoCo sees it, all faults at once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
import io
import math
from pathlib import Path, PurePosixPath
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np

from esg.files import read_limited
from esg.outcomes import UserError
from esg.strangers.folders import file_in
from esg.strangers.markup import parsed

MOST_BYTES = 4 * 2**20
MOST_MESH_BYTES = 64 * 2**20
MOST_TOTAL_BYTES = 256 * 2**20
MOST_FACES = 200_000
"""Of one mesh: what MuJoCo reads."""
_MESHES = (".obj", ".stl")
_URDF_JOINTS = {
    "floating": "make its child the root of the model, which moves freely",
    "planar": "replace it by two prismatic joints and a link between them",
}
_SECTIONS = ("compiler", "default", "asset", "worldbody")
"""Of an MJCF file; the other sections say nothing about bodies, or are refused."""
_COMPILER = (
    "angle", "eulerseq", "autolimits", "inertiafromgeom", "inertiagrouprange", "balanceinertia",
    "boundmass", "boundinertia", "settotalmass",
)  # fmt: skip
_REFUSED = {
    "include": "put its contents into the file",
    "attach": "put its contents into the file",
    "model": "put its contents into the file",
    "replicate": "write the copies out",
    "composite": "write its bodies out",
    "flexcomp": "only rigid bodies are imported; delete it",
    "flex": "only rigid bodies are imported; delete it",
    "skin": "only rigid bodies are imported; delete it",
    "hfield": "give a mesh instead",
    "plugin": "delete it",
}
_COUPLED = {
    "equality": "loops and coupled joints are not imported; delete it, or cut the loop open",
    "tendon": "tendons are not imported; delete them",
    "deformable": "only rigid bodies are imported; delete it",
    "extension": "plugins are not imported; delete it",
}
_DROPPED = ("texture", "site", "camera", "light", "user")


@dataclass
class Admitted:
    """A description that may be read.

    Args:
        root: Its XML, with the names of files replaced by those in `files`.
        urdf: Whether it is URDF, else MJCF.
        name: What it calls itself, else the file's stem.
        files: Meshes as binary STL, by name.
        faults: What is wrong: place, value and remedy each.
        digest: All bytes that were read.
        in_world: Whether a URDF hangs in a link called `world`, fixed there.
    """

    root: ET.Element
    urdf: bool
    name: str
    files: dict[str, bytes] = field(default_factory=dict)
    faults: list[str] = field(default_factory=list)
    digest: list[bytes] = field(default_factory=list)
    in_world: bool = False


def admit(path: Path) -> Admitted:
    """Reads a description and everything that it names.

    Raises:
        UserError: If it is no URDF or MJCF at all; other faults are listed in the result.
    """
    try:
        data = read_limited(path, MOST_BYTES)
    except OSError as error:
        raise UserError(f"{path} cannot be read: {error.strerror}") from None
    root = parsed(data, str(path))
    if root.tag not in ("robot", "mujoco"):
        raise UserError(
            f"{path}: its root is <{root.tag[:40]}>; expected <robot> (URDF) or <mujoco> (MJCF)"
        )
    urdf = root.tag == "robot"
    name = (root.get("name" if urdf else "model") or "").strip()
    model = Admitted(root, urdf, name or path.stem, digest=[data])
    model.faults += [f for e in root.iter() for f in _numbers(e)]
    if urdf:
        model.faults += [*_tree(root), *_joints(root)]
        model.in_world = any(e.get("name") == "world" for e in root.findall("link"))
        for stray in root.findall("mujoco"):
            root.remove(stray)
        compiler = ET.SubElement(ET.SubElement(root, "mujoco"), "compiler")
        # Visuals are drawn and weigh nothing beside the collision shapes.
        compiler.attrib |= {"discardvisual": "false", "fusestatic": "false"}
        compiler.attrib |= {"inertiagrouprange": "0 0"}
        named = [(e, "filename", "") for e in root.iter("mesh")]
    else:
        model.faults += [*_foreign(root)]
        folder = _plain(root)
        named = [(e, "file", folder) for e in root.iter("mesh")]
    for element, attribute, folder in named:
        _take_in(model, path.parent, element, attribute, folder)
    return model


def place(element: ET.Element) -> str:
    """An element as a message names it."""
    name = element.get("name") or element.get("link") or element.get("file")
    return f"<{element.tag}>" if name is None else f"<{element.tag} {name[:60]!r}>"


def _numbers(element: ET.Element) -> Iterator[str]:
    """Numbers that are none: MuJoCo takes NaN for what it is."""
    for key, text in element.attrib.items():
        if key in ("name", "model", "file", "filename", "class", "childclass"):
            continue
        for word in text.split():
            try:
                value = float(word)
            except ValueError:
                break
            if not math.isfinite(value) or abs(value) > 1e9:
                yield f"{place(element)}: {key} is {text[:40]!r}; give finite numbers below 1e9"
                break


def _tree(root: ET.Element) -> Iterator[str]:
    """Whether the links of a URDF are one tree."""
    links = [e.get("name") or "" for e in root.findall("link")]
    joints = root.findall("joint")
    for kind, names in (("link", links), ("joint", [j.get("name") or "" for j in joints])):
        for name, count in Counter(names).items():
            if not name or count > 1:
                told = f"{count} {kind}s are called {name[:60]!r}"
                yield f"{told}; give each a name of its own"
    children: Counter[str] = Counter()
    parent_of: dict[str, str] = {}
    for joint in joints:
        for end in ("parent", "child"):
            found = joint.find(end)
            link = "" if found is None else found.get("link") or ""
            if link not in links:
                yield f"{place(joint)}: its {end} is {link[:60]!r}; name a link of the file"
            elif end == "child":
                children[link] += 1
                above = joint.find("parent")
                parent_of[link] = "" if above is None else above.get("link") or ""
    for link, count in children.items():
        if count > 1:
            yield (
                f"<link {link[:60]!r}>: it is the child of {count} joints, a closed loop; "
                "leave one of them"
            )
    roots = [name for name in links if name not in children]
    if len(roots) != 1:
        told = ", ".join(map(repr, roots[:5])) or "none"
        yield f"the links without a parent are {told}; a model has one, from which all others hang"
    elif any(_loops(name, parent_of) for name in links):
        yield "its joints lead in a circle; cut it open at one of them"


def _loops(link: str, parent_of: dict[str, str]) -> bool:
    seen: set[str] = set()
    while link in parent_of and link not in seen:
        seen.add(link)
        link = parent_of[link]
    return link in seen


def _joints(root: ET.Element) -> Iterator[str]:
    """Whether the joints of a URDF are such as the one record of joints can hold."""
    for joint in root.findall("joint"):
        kind = joint.get("type") or ""
        if kind not in ("revolute", "continuous", "prismatic", "fixed"):
            remedy = _URDF_JOINTS.get(kind, "use revolute, continuous, prismatic or fixed")
            yield f"{place(joint)}: its type is {kind[:40]!r}, which is not imported; {remedy}"
        mimic = joint.find("mimic")
        if mimic is not None:
            yield (
                f"{place(joint)}: it mimics {(mimic.get('joint') or '')[:60]!r}; joints that "
                "follow others are not imported: delete <mimic>, and it moves by itself"
            )
        axis = joint.find("axis")
        if axis is not None and kind != "fixed":
            words = (axis.get("xyz") or "").split()
            if len(words) != 3 or not any(_number(w) for w in words):
                yield f"{place(joint)}: its axis is {axis.get('xyz')!r}; give a direction"
        limit = joint.find("limit")
        if kind in ("revolute", "prismatic"):
            ends = [_number(limit.get(k) or "0") for k in ("lower", "upper")] if limit is not None \
                else [0.0, 0.0]  # fmt: skip
            if not ends[0] < ends[1]:
                yield (
                    f"{place(joint)}: its limits are {ends[0]:g} and {ends[1]:g}; give a lower "
                    "below an upper (a joint without limits is continuous)"
                )


def _number(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return math.nan


def _foreign(root: ET.Element) -> Iterator[str]:
    """What of an MJCF file no asset here can hold."""
    for element in root.iter():
        if element.tag in _REFUSED:
            yield f"{place(element)} is not imported; {_REFUSED[element.tag]}"
    for section in root:
        if section.tag in _COUPLED and len(section):
            inner = ", ".join(place(e) for e in section[:3])
            yield f"<{section.tag}> holds {inner}; {_COUPLED[section.tag]}"
    asset = root.find("asset")
    for mesh in [] if asset is None else asset.findall("mesh"):
        if mesh.get("builtin") or not (mesh.get("file") or mesh.get("vertex")):
            yield f"{place(mesh)} names no file; name an .obj or .stl"


def _plain(root: ET.Element) -> str:
    """Leaves of an MJCF file what tells of bodies; returns the folder of its meshes."""
    folder = ""
    for section in list(root):
        if section.tag not in _SECTIONS:
            root.remove(section)
        elif section.tag == "compiler":
            folder = section.get("meshdir") or section.get("assetdir") or folder
            kept = {k: v for k, v in section.attrib.items() if k in _COMPILER}
            section.attrib.clear()
            section.attrib |= kept
    ET.SubElement(root, "compiler").attrib |= {"fusestatic": "false", "discardvisual": "false"}
    for element in list(root.iter()):
        element.attrib.pop("texture", None)
        element.attrib.pop("user", None)
        for inner in list(element):
            if inner.tag in _DROPPED or (element.tag == "material" and inner.tag == "layer"):
                element.remove(inner)
    world = root.find("worldbody")
    if world is not None:
        _weighed(world)
    return folder


def _weighed(container: ET.Element) -> None:
    """Makes a body of the shapes that stand in the world, so that they are weighed as one."""
    for frame in container.findall("frame"):
        _weighed(frame)
    shapes = [geom for geom in container.findall("geom") if geom.get("type") != "plane"]
    if shapes:
        base = ET.Element("body")
        for geom in shapes:
            container.remove(geom)
            base.append(geom)
        container.insert(0, base)


def _take_in(model: Admitted, home: Path, element: ET.Element, attribute: str, folder: str) -> None:
    """Reads a mesh that an element names, and lets it name what was read."""
    given = element.get(attribute)
    if given is None:
        return
    fault, found = "", _found(home, given, folder)
    suffix = PurePosixPath(given).suffix.lower()
    if suffix not in _MESHES:
        fault = f"{suffix or 'no suffix'} is not read; save it as .obj or .stl"
    elif found is None:
        fault = (
            f"it is no file in {home} or below; put it there, and name it by its path from there"
        )
    elif sum(map(len, model.digest)) > MOST_TOTAL_BYTES:
        fault = f"the meshes have more than {MOST_TOTAL_BYTES >> 20} MiB; give smaller ones"
    else:
        try:
            data = read_limited(found, MOST_MESH_BYTES)
            model.digest.append(data)
            name = f"mesh{len(model.files)}.stl"
            model.files[name] = _as_stl(data, suffix)
            element.set("name", element.get("name") or found.stem)
            if model.urdf:
                del element.attrib["name"]
            element.set(attribute, name)
        except (UserError, OSError, ValueError) as error:
            fault = str(error)
    if fault:
        model.faults.append(f"<mesh>: its {attribute} is {given[:120]!r}: {fault}")


def _found(home: Path, given: str, folder: str) -> Path | None:
    """A mesh by its path from the description's folder; a package is that folder or one in it."""
    scheme, sign, rest = given.partition("://")
    if not sign:
        text = f"{folder.rstrip('/')}/{given}" if folder.strip("./") else given
        return file_in(home, text.removeprefix("./"))
    inner = rest.partition("/")[2]
    return (file_in(home, inner) or file_in(home, rest)) if scheme == "package" else None


def _as_stl(data: bytes, suffix: str) -> bytes:
    """A mesh alone, without anything that it may name.

    Raises:
        ValueError: Saying what is wrong, with the remedy.
    """
    import trimesh

    try:
        # Nothing that it names is read: what resolves names knows none.
        loaded: Any = trimesh.load(
            io.BytesIO(data), file_type=suffix[1:], resolver={}, force="mesh", process=False
        )
        vertices, faces = np.asarray(loaded.vertices), np.asarray(loaded.faces)
    except Exception as error:  # whatever a parser of strangers' files raises
        raise ValueError(f"it cannot be read ({type(error).__name__}); save it anew") from None
    if not 0 < len(faces) <= MOST_FACES or not np.isfinite(vertices).all():
        raise ValueError(
            f"it has {len(faces)} triangles; give 1 to {MOST_FACES}, with finite corners"
        )
    return bytes(loaded.export(file_type="stl"))
