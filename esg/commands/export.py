"""`esg export`: a finished scene in the format of another program."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter


def export(
    scene: str,
    *,
    to: Literal["unreal", "usd", "mjcf", "glb", "mcap"],
    form: Literal["usda", "usdc", "usdz"] = "usda",
    out: Path | None = None,
    self_contained: Annotated[bool, Parameter(negative="")] = False,
    trust: Annotated[bool, Parameter(negative="")] = False,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Write a scene folder for another program.

    Args:
        scene: Scene folder, id of one below ./runs, or key of a scene in the run database.
        to: unreal a plugin folder; usd physics and baked animation; mjcf MuJoCo XML; glb animated
            glTF; mcap a log for Foxglove.
        form: Of usd: layers as text or in binary, which simulate and play, or a package that
            shows the scene on phones.
        out: Folder to write into; default the scene folder. Needed for scenes of the database.
        self_contained: Of unreal: write what plays all scenes into the class, which then needs
            nothing else.
        trust: Export the class of an unreal plugin whatever it is: you vouch for who made it.
        json: Print one JSON document: the files written.
    """
    from esg.api.inputs import checked
    from esg.api.scene import Scene
    from esg.commands.console import emit
    from esg.commands.stored import is_stored, open_scene
    from esg.files import refused
    from esg.outcomes import UserError
    from esg.scenefolder import check_writable

    with contextlib.ExitStack() as stack:
        folder, _ = checked(
            lambda: stack.enter_context(open_scene(scene, meshes=True)),
            lambda: None if out is None else check_writable(out),
        )
        if out is None and is_stored(folder):
            raise UserError(f"{scene} is in the run database, not in a folder: give --out")
        target = folder if out is None else out
        if to == "mcap":
            check_writable(target)
            with refused(target):
                files = _mcap(folder, target)
        else:
            files = Scene(folder).export(
                to, target, form=form, self_contained=self_contained, trust=trust
            )
    if json:
        emit({"scene": scene, "to": to, "files": [str(f) for f in files]})
    else:
        for file in files:
            print(file)
    return 0


def _is_whole_mcap(path: Path) -> bool:
    """Whether a log is what its checksums say: a damaged one is made again."""
    from esg.outcomes import UserError
    from esg.scenereading import damaged
    from esg.store.checking import check_recording

    if path.is_dir():
        raise damaged(path, "a folder")
    if not path.is_file():
        return False
    try:
        check_recording(path)
    except UserError:
        return False
    return True


def _mcap(folder: Path, target: Path) -> list[Path]:
    """The scene's log: as written by its run, else from its stored trajectory, else replayed."""
    import shutil

    from esg.commands.stored import is_stored, stored_key, stored_rollout
    from esg.compile.transfer import replay_scene
    from esg.engines.manifest import load_manifest
    from esg.files import atomic_write
    from esg.graph import load_document
    from esg.metrics import expectations_from_timeline, judge
    from esg.outcomes import UserError
    from esg.store.mcap_log import write_mcap

    source = folder / "rollout.mcap"
    path = target / source.name
    if _is_whole_mcap(source):
        if path.resolve() != source.resolve():
            atomic_write(path, lambda partial: shutil.copyfile(source, partial))
        return [path]
    if not (folder / "manifest.json").exists():
        raise UserError(f"{folder} holds no compiled scene; its log.jsonl says why")
    manifest, doc = load_manifest(folder / "manifest.json"), load_document(folder / "esg.json")
    rollout = stored_rollout(stored_key(folder)) if is_stored(folder) else None
    # A stored trajectory may be thinned, which the judge must not see: only a replay is judged.
    verdict = None
    if rollout is None:
        rollout, _ = replay_scene(folder, manifest, "physx", manifest.dt, trust="nothing")
        expected = expectations_from_timeline(doc)
        verdict = judge(manifest.scene, manifest.program, rollout, expected)
    target.mkdir(parents=True, exist_ok=True)
    write_mcap(path, manifest.scene, manifest.program, rollout, verdict, doc)
    return [path]
