"""`esg render DATASET` as typed, of real scenes: bad input, a full disk, the path tracer."""

from __future__ import annotations

from collections.abc import Iterator
import json
from pathlib import Path
import shutil
import subprocess
import sys

import numpy as np
import pytest

from esg.dataset.clips.reading import read_clips
from esg.store.tables import part_files, read_table, write_part

pytestmark = pytest.mark.slow
ROOT = Path(__file__).parents[3]
STILL = ("--camera", "around", "--workers", "1")
SMALL = ("--size", "32x32", "--fps", "4", *STILL)


def esg(*words: str) -> subprocess.CompletedProcess[str]:
    """What a command leaves."""
    command = [sys.executable, "-m", "esg.cli", *words]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three scenes without clips."""
    out = tmp_path_factory.mktemp("sets") / "three"
    options = ("--strategy", "none", "--previews", "none", "--no-meshes", "--workers", "1")
    done = esg("dataset", "--sample", "3", *options, "--out", str(out))
    assert done.returncode in (0, 3), done.stderr
    return out


@pytest.fixture
def three(finished: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(finished, tmp_path / "three"))


def kept(out: Path) -> dict[str, bytes]:
    """All files of a dataset."""
    return {p.relative_to(out).as_posix(): p.read_bytes() for p in out.rglob("*") if p.is_file()}


def test_all_mistakes_are_one_message_and_nothing_is_touched(three: Path) -> None:
    before = kept(three)
    done = esg("render", str(three), "--channels", "rgb,dpeth", "--size", "0x33", "--fps", "0")
    assert done.returncode == 2 and "Traceback" not in done.stderr
    for word in ("'dpeth'", "--size '0x33'", "--fps 0", "object_coordinates, tracks, boxes"):
        assert word in done.stderr
    assert esg("render", str(three), "--size", "100000x100000").returncode == 2
    assert kept(three) == before


def test_a_scene_that_cannot_be_rendered_is_named_and_the_others_go_on(three: Path) -> None:
    path = next(p for p in part_files(three, "scenes") if p.name.startswith("train"))
    table = read_table(path)
    damaged = table["scene_id"][0].as_py()
    column = table.column_names.index("manifest")
    texts = [*table["manifest"].to_pylist()]
    texts[0] = texts[0].replace('"bodies"', '"bodeis"')
    field = table.schema.field(column)
    write_part(table.set_column(column, field, [texts]), path)
    done = esg("render", str(three), "--channels", "rgb,depth", *SMALL)
    assert done.returncode == 3 and "Traceback" not in done.stderr, done.stderr
    assert "2 of 3 scenes rendered" in done.stdout and "failures.jsonl" in done.stdout
    rows = [json.loads(t) for t in (three / "failures.jsonl").read_text().splitlines()]
    (told,) = [r for r in rows if r["outcome"] == "not_rendered"]
    assert (told["scene"], told["stage"]) == (damaged, "render") and told["reason"]
    seen = {clip.record.scene_id for clip in read_clips(three)}
    assert len(seen) == 2 and damaged not in seen


@pytest.fixture
def little(tmp_path: Path) -> Iterator[Path]:
    """A disk of its own with little room."""
    place = tmp_path / "disk"
    place.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=800k", "tmpfs", str(place)]
    if subprocess.run(mount, check=False, capture_output=True).returncode:
        pytest.skip("no disk can be mounted here")
    try:
        yield place
    finally:
        subprocess.run(["umount", str(place)], check=True)


def test_a_full_disk_is_one_message_and_is_gone_on_from(finished: Path, little: Path) -> None:
    out = Path(shutil.copytree(finished, little / "three"))
    before = kept(out)
    shown = ("--channels", "rgb,depth,normal", "--size", "128x128", "--fps", "12")
    ask = ("render", str(out), *shown, "--batch", "1", *STILL)
    done = esg(*ask)
    assert done.returncode == 1, done.stderr
    (line,) = [t for t in done.stderr.splitlines() if t.startswith("esg: ")]
    assert "No space left on device; free some space" in line and "--resume" in line
    assert "Traceback" not in done.stderr
    assert {name: data for name, data in kept(out).items() if name in before} == before
    subprocess.run(["mount", "-o", "remount,size=64m", str(little)], check=True)
    done = esg(*ask, "--resume")
    assert done.returncode == 0, done.stderr
    assert len(list(read_clips(out))) == 3 and not list(out.rglob("*.tmp"))


def test_the_path_tracer_draws_colours_and_leaves_the_rest_exact(three: Path) -> None:
    pytest.importorskip("mitsuba")
    exact = Path(shutil.copytree(three, three.parent / "raster"))
    tiny = ("--channels", "rgb,depth,segmentation", "--size", "16x16", "--fps", "1", *STILL)
    assert esg("render", str(exact), *tiny).returncode == 0
    done = esg("render", str(three), *tiny, "--renderer", "path", "--samples", "2")
    assert done.returncode == 0, done.stderr
    for traced, drawn in zip(read_clips(three), read_clips(exact), strict=True):
        assert (traced.record.renderer, traced.record.samples) == ("path", 2)
        for channel in ("depth", "segmentation"):
            assert np.array_equal(traced.frames(channel), drawn.frames(channel))
        assert not np.array_equal(traced.frames("rgb"), drawn.frames("rgb"))
