"""`esg export`: a finished scene in the format of another program."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter


def export(
    scene: str,
    *,
    to: Literal["unreal", "usd", "mjcf", "glb", "mcap"],
    out: Path | None = None,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Write a scene folder for another program.

    Args:
        scene: Scene folder, or id of one below ./runs.
        to: unreal a plugin folder; usd physics and baked animation; mjcf MuJoCo XML; glb animated
            glTF; mcap a log for Foxglove.
        out: Folder to write into; default the scene folder.
        json: Print one JSON document: the files written.
    """
    from esg.commands.console import emit
    from esg.commands.inputs import find_scene
    from esg.outcomes import UserError
    from esg.scenefolder import check_writable

    folder = find_scene(scene)
    target = folder if out is None else out
    check_writable(target)
    try:
        files = _mcap(folder, target) if to == "mcap" else _export(folder, to, target)
    except OSError as error:
        raise UserError(f"cannot write {target}: {error.strerror}", exit_code=1) from None
    if json:
        emit({"scene": str(folder), "to": to, "files": [str(f) for f in files]})
    else:
        for file in files:
            print(file)
    return 0


def _export(folder: Path, to: Literal["unreal", "usd", "mjcf", "glb"], target: Path) -> list[Path]:
    from esg.compile.export import export as run

    return run(folder, to, target)


def _mcap(folder: Path, target: Path) -> list[Path]:
    import shutil

    from esg.outcomes import UserError

    source = folder / "rollout.mcap"
    if not source.exists():
        raise UserError(f"{folder} holds no rollout.mcap; its log.jsonl says why")
    path = target / source.name
    if path.resolve() != source.resolve():
        target.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, path)
    return [path]
