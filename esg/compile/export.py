"""`export`: a compiled scene folder in the format of another program."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
import tempfile
from typing import Literal, get_args

from esg.compile.transfer import check_length
from esg.compile.visuals.setting import Setting
from esg.compile.visuals.usd_files import UsdForm
from esg.engines.manifest import Manifest, carried_json, load_manifest
from esg.engines.program import batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Rollout
from esg.files import TEMPORARY, make_folder, sync_file, sync_folder
from esg.outcomes import UserError
from esg.scenereading import absent, read_rollout
from esg.strangers.sums import seal

Target = Literal["unreal", "usd", "mjcf", "glb"]
FRAMES_PER_SECOND = 60
"""Of exported animations."""


def export(
    folder: str | Path,
    to: Target,
    out: str | Path | None = None,
    *,
    rollout: Rollout | None = None,
    setting: Setting | None = None,
    form: UsdForm = "usda",
    self_contained: bool = False,
) -> list[Path]:
    """Writes a scene for another program.

    Args:
        folder: Compiled scene folder (`manifest.json`, `unreal/`, `meshes/`).
        to: `unreal` a plugin folder; `usd` UsdPhysics scene and baked animation; `mjcf` MuJoCo XML;
            `glb` animated glTF.
        out: Folder to write into, default `folder`.
        rollout: Replay to show in animations (its first world, at most 60 frames a second);
            default the recorded one, else the program is replayed in PhysX.
        setting: Ground, dressing, light and cameras of `usd` and `glb`; None: the bodies alone.
        form: Of `usd`: layers as text or in binary, or a package of what is seen.
        self_contained: Of `unreal`: the class brings what plays it.

    Returns:
        The files written, sorted.

    Raises:
        UserError: For an unknown target or a folder that holds no compiled scene.
    """
    folder = Path(folder)
    target = Path(out) if out is not None else folder
    if to not in get_args(Target):
        raise UserError(f"unknown export {to!r}; choose one of {', '.join(get_args(Target))}")
    if not (folder / "manifest.json").is_file():
        raise UserError(f"{folder} holds no manifest.json: compile the scene first")
    manifest = load_manifest(folder / "manifest.json")
    make_folder(target)
    # A disk that fills up on the way leaves earlier exports as they were.
    if to == "unreal":
        from esg.compile.plugin import write_plugin

        write = partial(write_plugin, folder, alone=self_contained)
    else:
        write = partial(_write, folder, manifest, to, rollout=rollout, setting=setting, form=form)
    with tempfile.TemporaryDirectory(prefix=".export-", suffix=TEMPORARY, dir=target) as aside:
        work = Path(aside)
        files: list[Path] = []
        for file in write(work):
            path = target / file.relative_to(work)
            make_folder(path.parent)
            sync_file(file)
            file.replace(path)
            files.append(path)
    for changed in {path.parent for path in files}:
        sync_folder(changed)
    if target == folder:
        seal(folder, files)
    return files


def _write(
    folder: Path,
    manifest: Manifest,
    to: Target,
    out: Path,
    *,
    rollout: Rollout | None,
    setting: Setting | None,
    form: UsdForm,
) -> list[Path]:
    if to == "mjcf":
        from esg.compile.mjcf import scene_mjcf

        path = out / "scene.xml"
        path.write_text(scene_mjcf(manifest), "utf-8", newline="\n")
        return [path]
    rollout = animation(folder, manifest) if rollout is None else thinned(rollout)
    if to == "glb":
        from esg.compile.glb import scene_glb

        path = out / "scene.glb"
        carried = carried_json(manifest)
        path.write_bytes(
            scene_glb(manifest.scene, rollout, folder, setting=setting, manifest=carried)
        )
        return [path]
    from esg.compile.usd import write_usd

    return write_usd(manifest, rollout, folder, out, setting=setting, form=form)


def animation(folder: Path, manifest: Manifest) -> Rollout:
    """The motion to show: as it was recorded, else the program replayed in PhysX.

    No class is run for it: to look at a scene must not run code that came with it.
    """
    recorded = folder / "rollout.npz"
    if not absent(recorded):
        return thinned(read_rollout(recorded, len(manifest.scene.bodies)))
    check_length(folder, manifest, manifest.dt)
    every = max(1, round(1.0 / (FRAMES_PER_SECOND * manifest.dt)))
    batch = batch_programs([manifest.program], manifest.scene.names)
    return get_engine("physx").rollout(manifest.scene, batch, dt=manifest.dt, record_every=every)


def thinned(rollout: Rollout) -> Rollout:
    """The rollout's poses at no more than FRAMES_PER_SECOND, first and evenly spaced frames."""
    if len(rollout.time) < 2:
        return rollout
    every = max(1, round(1.0 / (FRAMES_PER_SECOND * float(rollout.time[1] - rollout.time[0]))))
    return replace(
        rollout,
        time=rollout.time[::every],
        position=rollout.position[:, ::every],
        quaternion=rollout.quaternion[:, ::every],
        linear_velocity=rollout.linear_velocity[:, ::every],
        angular_velocity=rollout.angular_velocity[:, ::every],
    )
