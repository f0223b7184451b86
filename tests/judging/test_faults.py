"""Files that cannot be judged: one message with everything that is wrong, before much is made."""

from __future__ import annotations

import io
import json
from pathlib import Path
import struct
import subprocess
import sys
import zipfile

import numpy as np
import pytest

from esg.judging.readers import FORMATS
from esg.judging.verdict import judge_file
from esg.outcomes import UserError
from tests.judging import worlds

ROOT = Path(__file__).parents[2]
HEAD = "time,body,x,y,z,qx,qy,qz,qw\n"
ROW = "{t},{name},0,0,1,0,0,0,1\n"


def told(path: Path) -> str:
    with pytest.raises(UserError) as caught:
        judge_file(path, worlds.SCENE)
    assert caught.value.exit_code == 2
    return str(caught.value)


def text(folder: Path, content: str, name: str = "S1.csv") -> Path:
    (folder / name).write_text(content)
    return folder / name


def test_all_that_is_wrong_with_a_table_is_told_at_once(tmp_path: Path) -> None:
    rows = ROW.format(t=0, name="a") + ROW.format(t=0, name="b") + ROW.format(t=0.1, name="a")
    rows += ROW.format(t=0.2, name="a") + ROW.format(t=0.2, name="a") + ROW.format(t=0.2, name="b")
    said = told(text(tmp_path, HEAD + rows))
    assert "2 problems" in said
    assert "'a' has several rows at 0.2 s" in said and "'b' has no row at 0.1 s" in said


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "does not name its columns"),
        ("time,x\n0,1\n", "lacks the columns body, y, z, qx"),
        (HEAD + "0,a,1,2\n", "line 2 has 4 values"),
        (HEAD + "0,a,nan,0,0,0,0,0,1\n", "row 1: x is 'nan', no number"),
        (HEAD + "0,a,0,0,east,0,0,0,1\n", "row 1: z is 'east', no number"),
        (HEAD + ROW.format(t=0, name="a"), "it has 1 frames"),
        (HEAD + "0,a,0,0,0,0,0,0,0\n1,a,0,0,0,0,0,0,0\n", "no quaternions"),
        (HEAD, "it has no rows"),
    ],
)
def test_tables_that_are_no_motion(content: str, message: str, tmp_path: Path) -> None:
    assert message in told(text(tmp_path, content))


def test_facts_of_bodies_are_checked_together(tmp_path: Path) -> None:
    path = text(tmp_path, HEAD + "".join(ROW.format(t=t, name="a") for t in (0, 1)))
    text(
        tmp_path,
        "body,shape,size_x,size_y,size_z,static,mesh\na,blob,1,1,1,perhaps,\nb,box,1,0,1,,\nb,,,,,,../x.glb\n",
        "S1.bodies.csv",
    )
    said = told(path)
    for part in (
        "'blob' is none of box, sphere", "static is 'perhaps'", "has 'b' several times",
        "'b', which has no poses",
    ):  # fmt: skip
        assert part in said, said
    text(tmp_path, "body,mesh\na,../x.glb\n", "S1.bodies.csv")
    assert "'../x.glb' is no .glb file in the folder" in told(path)


def test_an_array_that_says_more_than_it_holds_is_refused_before_it_is_made(tmp_path: Path) -> None:
    header = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        header, {"descr": "<f8", "fortran_order": False, "shape": (10**9, 10**6)}
    )
    with zipfile.ZipFile(tmp_path / "S1.npz", "w") as archive:
        archive.writestr("time.npy", header.getvalue())
    assert "says it has 8000000000000000 bytes" in told(tmp_path / "S1.npz")
    np.savez(tmp_path / "S1.npz", names=np.array(["a"]), time=np.arange(3.0), position=np.zeros(3),
             quaternion=np.zeros((3, 1, 3)))  # fmt: skip
    said = told(tmp_path / "S1.npz")
    assert "2 problems" in said and "position has shape (3,)" in said
    np.savez(tmp_path / "S1.npz", names=np.array([object()]))
    assert "objects" in told(tmp_path / "S1.npz")


def test_an_accessor_larger_than_its_buffer_is_refused(tmp_path: Path) -> None:
    document = {
        "asset": {"version": "2.0"}, "buffers": [{"byteLength": 8}],
        "bufferViews": [{"buffer": 0, "byteLength": 8}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 10**9, "type": "VEC3"}],
    }  # fmt: skip
    data = json.dumps(document).encode()
    data += b" " * (-len(data) % 4)
    size = 12 + 8 + len(data) + 8 + 8
    glb = struct.pack("<III", 0x46546C67, 2, size) + struct.pack("<II", len(data), 0x4E4F534A)
    (tmp_path / "S1.glb").write_bytes(glb + data + struct.pack("<II", 8, 0x004E4942) + b"\0" * 8)
    assert "S1.glb: it is no GLB that can be read" in told(tmp_path / "S1.glb")


@pytest.mark.parametrize("suffix", sorted(set(FORMATS) - {".csv"}))
@pytest.mark.parametrize("content", [b"", b"\0\1garbage" * 50, b"{}"])
def test_what_is_none_of_a_format_is_said_in_one_line(
    suffix: str, content: bytes, tmp_path: Path
) -> None:
    path = tmp_path / f"S1{suffix}"
    path.write_bytes(content)
    said = told(path)
    assert said.startswith(f"{path}: ") and "\n" not in said


def test_a_stage_that_refers_outside_of_its_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "secret.usda").write_text('#usda 1.0\ndef Xform "World" {}\n')
    (tmp_path / "in" / "S1.usda").write_text(
        "#usda 1.0\n(\n    subLayers = [@../secret.usda@]\n)\n"
    )
    assert "outside of its folder" in told(tmp_path / "in" / "S1.usda")


def test_a_manifest_that_does_not_hold_is_refused(tmp_path: Path) -> None:
    scene, rollout = worlds.played()
    data = bytearray(worlds.glb_file(tmp_path, scene, rollout).read_bytes())
    at = data.index(b'"esg-manifest"')
    data[at : at + 14] = b'"elsewhere....'[:13] + b'"'
    (tmp_path / "S1.glb").write_bytes(data)
    assert "the manifest in it does not hold: /format" in told(tmp_path / "S1.glb")


def test_the_command_names_all_files_that_are_wrong(tmp_path: Path) -> None:
    first, second = text(tmp_path, "", "S1.csv"), text(tmp_path, HEAD, "S2.csv")
    done = subprocess.run(
        [sys.executable, "-m", "esg", "judge", "--trajectories", first, second, "--suite", "paper"],
        capture_output=True, text=True, cwd=ROOT, check=False,
    )  # fmt: skip
    assert done.returncode == 2 and "Traceback" not in done.stderr
    assert "2 problems" in done.stderr and str(first) in done.stderr and str(second) in done.stderr
    none = subprocess.run(
        [sys.executable, "-m", "esg", "judge", "--trajectories", tmp_path / "S9.txt", "--suite",
         "nowhere.yaml"],
        capture_output=True, text=True, cwd=ROOT, check=False,
    )  # fmt: skip
    assert none.returncode == 2 and "2 problems" in none.stderr
