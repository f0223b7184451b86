"""Runs a compiled class in PhysX 5: the artifact itself is executed, not a parallel description.

The physical world is built from what the class says through the shim (poses, masses, mass frames,
damping, materials, collision types) and from the collision of the assets it names; the scene's
manifest contributes nothing but the order of the bodies. This is PhysX under a stand-in for
Unreal's API, not Unreal: Chaos, its solver and its asset import are not exercised.
"""

from __future__ import annotations

from dataclasses import dataclass
import json
from pathlib import Path
import re
import threading
from typing import Any, Literal

from esg.compile import build
from esg.compile.class_run import ClassRun
from esg.compile.emit import IMPORTS_FORMAT, IMPORTS_VERSION
from esg.compile.records import ReplayError
from esg.engines.base import VERIFY_DT_S
from esg.engines.scene import Rollout, SimScene
from esg.engines.worlds import Frames
from esg.outcomes import UserError

_ONE_AT_A_TIME = threading.Lock()
"""Classes of one library share the shim's state, and PhysX's configuration is the process's."""


@dataclass(frozen=True)
class ClassReplay:
    """What a class did when it was run.

    Args:
        rollout: Same structure as an engine's, bodies in the order of the scene.
        log: What the class wrote with UE_LOG, `Verbosity: text`.
        compile_seconds: Time spent compiling, 0 from the cache.
        scene: The physical scene the class described.
        proof: Always `class`: the emitted class was executed.
    """

    rollout: Rollout
    log: list[str]
    compile_seconds: float
    scene: SimScene
    proof: Literal["class"] = "class"

    def events(self) -> list[dict[str, str]]:
        """The log's EVENT lines as dictionaries; `event` holds EVENT_HIT or EVENT_CHECK."""
        out: list[dict[str, str]] = []
        for line in self.log:
            text = line.split(": ", 1)[1]
            if text.startswith("EVENT_"):
                head, *pairs = text.split(" ")
                out.append({"event": head, **dict(p.split("=", 1) for p in pairs if "=" in p)})
        return out


def replay_class(
    folder: str | Path,
    *,
    dt: float = VERIFY_DT_S,
    duration: float | None = None,
    record_every: int = 1,
    ground_contacts: bool = False,
    engine: Literal["physx", "rapier"] = "physx",
) -> ClassReplay:
    """Compiles (or finds) the class of a scene folder and runs it in PhysX.

    Args:
        folder: Scene folder with `unreal/` in it.
        dt: Physics step [s].
        duration: [s]; default the scene's own.
        record_every: Steps per recorded frame.
        ground_contacts: Whether the contact log includes the ground.
        engine: Which physics runs under the shim.

    Raises:
        CompilerMissing: Without g++: replay the program instead.
        ClassError: If the class breaks a rule or does not compile.
        ReplayError: If the running class does what Unreal would refuse.
        UserError: If the folder holds no class or a broken import manifest.
    """
    folder = Path(folder)
    try:
        files = build.ClassFiles.read(folder)
    except OSError as error:
        raise UserError(f"{folder}: no compiled scene: {error}") from None
    library = build.compile_class(files)
    imports = load_imports(folder / "unreal" / "imports.json")
    if duration is None:
        duration = scene_duration(files.header)
    grid = Frames.of(duration, dt, record_every)
    with _ONE_AT_A_TIME:
        run = ClassRun(library, imports)
        try:
            rollout = run.play(engine, grid, ground_contacts)
        finally:
            run.close()
    return ClassReplay(rollout, run.log, library.seconds, run.scene)


def load_imports(path: Path) -> dict[str, Any]:
    """Reads an import manifest.

    Raises:
        UserError: If it is missing, no JSON or of another format.
    """
    try:
        data = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise UserError(f"{path}: cannot read the import manifest: {error}") from None
    if not isinstance(data, dict):
        raise UserError(f"{path}: cannot read the import manifest: it is no JSON object")
    if data.get("format") != IMPORTS_FORMAT or data.get("version") != IMPORTS_VERSION:
        raise UserError(f"{path}: /format is not {IMPORTS_FORMAT!r} version {IMPORTS_VERSION}")
    for key, kind in (("class", str), ("assets", list), ("components", dict)):
        if not isinstance(data.get(key), kind):
            raise UserError(f"{path}: /{key} is missing or of another type")
    return data


def scene_duration(header: str) -> float:
    """The default of the class's SceneDuration property [s]."""
    found = re.search(r"double SceneDuration = ([0-9.e+-]+);", header)
    if not found:
        raise ReplayError("the class has no SceneDuration")
    return float(found.group(1))


__all__ = ["ClassReplay", "ReplayError", "load_imports", "replay_class", "scene_duration"]
