"""A disk that fills up on the way costs no earlier export and leaves no half of a new one."""

from __future__ import annotations

from pathlib import Path

import pytest
import scenes
from test_export import folder_of, replayed

from esg.compile.export import export
from esg.files import refused
from esg.outcomes import UserError
from tests.disks import small_files


def content(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


@pytest.mark.parametrize("to", ["unreal", "usd", "mjcf", "glb"])
def test_an_earlier_export_survives_a_full_disk(tmp_path: Path, to: str) -> None:
    scene = folder_of(tmp_path / "scene", *scenes.street())
    rollout, out = replayed(scene), tmp_path / "out"
    export(scene, to, out)  # type: ignore[arg-type]
    before = content(out)
    for path in out.rglob("*"):
        if path.is_file():
            path.write_bytes(path.read_bytes() + b"\n")  # so that a rewritten file shows
    touched = content(out)
    with (
        pytest.raises(UserError, match=r"cannot write .*raise the limit") as told,
        refused(out),
        small_files(300),
    ):
        export(scene, to, out, rollout=rollout)  # type: ignore[arg-type]
    assert told.value.exit_code == 1
    assert content(out) == touched
    assert export(scene, to, out)  # type: ignore[arg-type]
    assert content(out) == before
    assert not list(out.glob(".*"))
