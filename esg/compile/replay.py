"""Runs a compiled class in PhysX 5: the artifact itself is executed, not a parallel description.

The physical world is built from what the class says through the shim (poses, masses, mass frames,
damping, materials, collision types) and from the collision of the assets it names; the scene's
manifest contributes nothing but the order of the bodies. This is PhysX under a stand-in for
Unreal's API, not Unreal: Chaos, its solver and its asset import are not exercised.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import json
from pathlib import Path
import re
from typing import TYPE_CHECKING, Any, Literal

from esg.compile import build
from esg.compile.emit import IMPORTS_FORMAT, IMPORTS_VERSION
from esg.compile.records import ReplayError
from esg.compile.trust.confined import play_confined
from esg.compile.trust.playing import Job, play
from esg.compile.trust.standing import Standing, standing_of
from esg.engines.base import VERIFY_DT_S
from esg.engines.scene import Rollout, SimScene
from esg.outcomes import UserError

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument


@dataclass(frozen=True)
class ClassReplay:
    """What a class did when it was run.

    Args:
        rollout: Same structure as an engine's, bodies in the order of the scene.
        log: What the class wrote with UE_LOG, `Verbosity: text`.
        compile_seconds: Time spent compiling, 0 from the cache.
        scene: The physical scene the class described; None if it ran in a child.
        proof: Always `class`: the emitted class was executed.
    """

    rollout: Rollout
    log: list[str]
    compile_seconds: float
    scene: SimScene | None
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


class ForeignClass(UserError):
    """A class that this version does not emit from its scene's document, and nobody vouched for.

    Args:
        folder: Its scene folder.
        why: What tells it from ours.
    """

    def __init__(self, folder: Path, why: str) -> None:
        self.why = why
        super().__init__(
            f"{folder}/unreal: {why}; it is not used unless you trust who made it (--trust)"
        )


def replay_class(
    folder: str | Path,
    *,
    dt: float = VERIFY_DT_S,
    duration: float | None = None,
    record_every: int = 1,
    ground_contacts: bool = False,
    engine: Literal["physx", "rapier"] = "physx",
    document: EsgDocument | Callable[[], EsgDocument] | None = None,
    trust: bool = False,
) -> ClassReplay:
    """Compiles (or finds) the class of a scene folder and runs it in PhysX.

    A class that this process has written runs in it; one that equals what this version emits from
    the folder's `esg.json` runs in a child; any other is not even compiled (docs/trust.md).

    Args:
        folder: Scene folder with `unreal/` in it.
        dt: Physics step [s].
        duration: [s]; default the scene's own.
        record_every: Steps per recorded frame.
        ground_contacts: Whether the contact log includes the ground.
        engine: Which physics runs under the shim.
        document: What `esg.json` holds, if the caller has read it; or a function that gives the
            caller's own document, which then counts instead.
        trust: Whether to run what is neither, in a child that shares nothing with this process.

    Raises:
        ForeignClass: For a class that is not ours, without `trust`.
        CompilerMissing: Without g++: replay the program instead.
        ClassError: If the class breaks a rule or does not compile.
        ReplayError: If the running class does what Unreal would refuse, or had to be stopped.
        UserError: If the folder holds no class or a broken import manifest.
    """
    folder = Path(folder)
    files, text = _read(folder)
    standing, why = standing_of(files, text, document or folder / "esg.json")
    if standing is Standing.FOREIGN and not trust:
        build.compiler()  # without one there is nothing to ask for
        raise ForeignClass(folder, why)
    foreign = standing is Standing.FOREIGN
    library = build.compile_class(files, limited=foreign)
    job = Job(
        library=str(library.path),
        create=library.create,
        imports=parse_imports(folder / "unreal" / "imports.json", text),
        duration=scene_duration(files) if duration is None else duration,
        dt=dt,
        record_every=record_every,
        ground_contacts=ground_contacts,
        engine=engine,
    )
    played = play(job) if standing is Standing.OWN else play_confined(job, fresh=foreign)
    return ClassReplay(played.rollout, played.log, library.seconds, played.scene)


def compile_ours(folder: Path, document: EsgDocument | Callable[[], EsgDocument]) -> None:
    """Compiles the class of a scene folder, if it is ours, so that its replay finds it compiled.

    Args:
        folder: Scene folder with `unreal/` in it.
        document: As of `replay_class`, which raises what this does.
    """
    files, text = _read(folder)
    if standing_of(files, text, document)[0] is not Standing.FOREIGN:
        build.compile_class(files)


def standing_in(folder: Path) -> tuple[str, str]:
    """Whose the class of a scene folder is, and for a foreign one why; empty without a class."""
    if not (folder / "unreal").is_dir():
        return "", ""
    try:
        standing, why = standing_of(*_read(folder), folder / "esg.json")
    except UserError as error:
        return Standing.FOREIGN.value, str(error).splitlines()[0]
    return standing.value, why


def require_ours(folder: Path) -> None:
    """Makes sure that the class of a scene folder is what this version emits.

    Raises:
        ForeignClass: If not.
        UserError: If the folder holds no class.
    """
    standing, why = standing_of(*_read(folder), folder / "esg.json")
    if standing is Standing.FOREIGN:
        raise ForeignClass(folder, why)


def _read(folder: Path) -> tuple[build.ClassFiles, str]:
    """A class and the text of its import manifest."""
    try:
        files = build.ClassFiles.read(folder)
    except OSError as error:
        raise UserError(f"{folder}: no compiled scene: {error}") from None
    return files, read_imports(folder / "unreal" / "imports.json")


def load_imports(path: Path) -> dict[str, Any]:
    """Reads an import manifest.

    Raises:
        UserError: If it is missing, no JSON or of another format.
    """
    return parse_imports(path, read_imports(path))


def read_imports(path: Path) -> str:
    """The text of an import manifest.

    Raises:
        UserError: If it cannot be read.
    """
    try:
        return path.read_text("utf-8")
    except (OSError, ValueError) as error:
        raise UserError(f"{path}: cannot read the import manifest: {error}") from None


def parse_imports(path: Path, text: str) -> dict[str, Any]:
    """The import manifest that a text is.

    Args:
        path: Where it stands, for messages.
        text: The text.

    Raises:
        UserError: If it is no JSON or of another format.
    """
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise UserError(f"{path}: cannot read the import manifest: {error}") from None
    if not isinstance(data, dict):
        raise UserError(f"{path}: cannot read the import manifest: it is no JSON object")
    if data.get("format") != IMPORTS_FORMAT or data.get("version") != IMPORTS_VERSION:
        raise UserError(f"{path}: /format is not {IMPORTS_FORMAT!r} version {IMPORTS_VERSION}")
    for key, kind in (("class", str), ("assets", list), ("components", dict)):
        if not isinstance(data.get(key), kind):
            raise UserError(f"{path}: /{key} is missing or of another type")
    return data


def scene_duration(files: build.ClassFiles) -> float:
    """The value of the class's SceneDuration property [s]."""
    text = files.source + files.header  # where a class that inherits it states it comes first
    found = re.search(r"\bSceneDuration = ([0-9.e+-]+);", text)
    if not found:
        raise ReplayError("the class has no SceneDuration")
    return float(found.group(1))


__all__ = [
    "ClassReplay",
    "ForeignClass",
    "ReplayError",
    "load_imports",
    "replay_class",
    "scene_duration",
]
