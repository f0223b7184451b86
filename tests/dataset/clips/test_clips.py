"""Clips: what is written is what is read, exactly or to a bound that is stated."""

from __future__ import annotations

from dataclasses import fields, replace
import errno
from pathlib import Path
import re
from typing import Any

import numpy as np
import pytest

from esg.dataset.clips.encoding import CHANNELS, PICTURES, check_encoders, decoded
from esg.dataset.clips.reading import read_clips
from esg.dataset.clips.records import ClipRecord
from esg.dataset.clips.writing import ClipWriter, whole_folder, write_clip
from esg.outcomes import UserError
from esg.store.tables import COLUMNS, part_files, read_table, to_table, write_part
from tests.dataset.clips.synthetic import FAR_M, NEAR_M, STEP_PX, record, values, write_synthetic


@pytest.fixture
def dataset(tmp_path: Path) -> Path:
    made = [write_synthetic(tmp_path, camera=k) for k in (1, 0)]
    write_part(
        to_table("clips", [r.row() for r in made]), tmp_path / "parts" / "clips" / "a.parquet"
    )
    return tmp_path


def test_a_record_has_the_columns_of_its_table():
    assert {f.name for f in fields(ClipRecord)} == set(COLUMNS["clips"]) - {"video"}


def test_rows_come_back_as_records(dataset: Path):
    first, second = (clip.record for clip in read_clips(dataset))
    assert (first.camera, second.camera) == (0, 1)
    wanted = record()
    for f in fields(ClipRecord):
        found, known = getattr(first, f.name), getattr(wanted, f.name)
        if isinstance(known, np.ndarray) and known.size:
            assert found.shape == known.shape and found.dtype == known.dtype
            assert np.array_equal(found, known), f.name
        elif f.name in ("boxes2d", "channels", "objects", "prompt", "intrinsics", "fps"):
            assert found == known, f.name
    assert [f.channel for f in first.files] == list(PICTURES)
    assert all((dataset / f.path).stat().st_size == f.bytes for f in first.files)
    assert list(read_clips(dataset, "test")) == []


def test_channels_come_back_in_the_units_of_their_meaning(dataset: Path):
    clip = next(read_clips(dataset))
    wanted = values()
    assert np.array_equal(clip.frames("segmentation"), wanted["segmentation"])
    depth = clip.frames("depth")
    assert np.array_equal(depth == 0, wanted["depth"] == 0)
    hit = depth > 0
    assert np.abs(depth[hit] / wanted["depth"][hit] - 1).max() < np.log(FAR_M / NEAR_M) / 65533
    for name, sign in (("flow", 1), ("backward_flow", -1)):
        shift = clip.frames(name)
        assert np.array_equal(np.isnan(shift), np.isnan(wanted[name]))
        assert np.nanmax(np.abs(shift - wanted[name])) < 1e-4
        assert np.nanmax(sign * shift) == pytest.approx(STEP_PX, abs=1e-4)
    assert np.abs(clip.frames("normal") - wanted["normal"]).max() < 1 / 65534
    places = clip.frames("object_coordinates")
    assert np.array_equal(np.isnan(places), np.isnan(wanted["object_coordinates"]))
    assert np.nanmax(np.abs(places - wanted["object_coordinates"])) < 1 / 65534
    # H.264 keeps colours apart, if not to the last digit.
    assert np.abs(clip.frames("rgb").astype(int) - wanted["rgb"]).mean() < 4


def test_equal_frames_give_equal_bytes(tmp_path: Path):
    names = {}
    for place in ("one", "two"):
        made = write_synthetic(tmp_path / place)
        names[place] = {f.channel: (tmp_path / place / f.path).read_bytes() for f in made.files}
    assert names["one"] == names["two"]


def test_how_frames_come_makes_no_difference(tmp_path: Path):
    made = write_synthetic(tmp_path)
    wanted = values()
    writer = ClipWriter(tmp_path / "parts", PICTURES, (made.width, made.height), made.fps)
    for first, last in ((0, 1), (1, 4), (4, 5)):
        writer.add({name: v[first:last] for name, v in wanted.items()})
    paths = writer.close()
    for file in made.files:
        assert paths[file.channel].read_bytes() == (tmp_path / file.path).read_bytes()
    assert np.array_equal(np.array(writer.scales["depth_scale"]), made.depth_scale)


def test_lossless_colours_are_exact(tmp_path: Path):
    noise = np.random.default_rng(0).integers(0, 256, (3, 24, 32, 3)).astype(np.uint8)
    made = replace(record(frames=3), channels=("rgb",))
    made = write_clip(tmp_path, made, {"rgb": noise}, lossless=True)
    assert np.array_equal(decoded(tmp_path / made.files[0].path), noise)


def test_films_play_in_browsers(tmp_path: Path):
    import av

    made = write_synthetic(tmp_path)
    path = tmp_path / made.files[0].path
    with av.open(str(path)) as container:
        stream = container.streams.video[0]
        assert (stream.codec_context.name, stream.pix_fmt) == ("h264", "yuv420p")
        assert stream.average_rate == 24
    data = path.read_bytes()
    assert data.index(b"moov") < data.index(b"mdat")  # it plays before all of it is there


def test_a_folder_is_there_as_a_whole_or_not_at_all(tmp_path: Path):
    target = tmp_path / "clips" / "S1"
    with pytest.raises(OSError, match="free some space"), whole_folder(target) as work:
        (work / "half").write_text("x")
        raise OSError(errno.ENOSPC, "full")
    assert not target.exists() and list(target.parent.iterdir()) == []
    for text in ("old", "new"):
        with whole_folder(target) as work:
            (work / "file").write_text(text)
    assert (target / "file").read_text() == "new"
    assert [p.name for p in target.parent.iterdir()] == ["S1"]


def test_a_damaged_file_is_named(dataset: Path):
    clip = next(read_clips(dataset))
    path = clip.path("depth")
    path.write_bytes(path.read_bytes()[:80])
    with pytest.raises(UserError, match=r"depth\.mkv is missing or damaged"):
        clip.frames("depth")
    with pytest.raises(UserError, match="only of rgb, depth"):
        clip.path("tracks")


def test_all_channels_have_an_encoder():
    check_encoders(CHANNELS)
    check_encoders(CHANNELS, lossless=True)


def test_the_decoders_of_the_documentation_read_what_is_written(dataset: Path):
    """As they stand there: without this package."""
    text = (Path(__file__).parents[3] / "docs" / "dataset" / "clips.md").read_text("utf-8")
    blocks = re.findall(r"```python decoder\n(.*?)```", text, re.DOTALL)
    assert len(blocks) == 4 and all("esg" not in b for b in blocks)
    assert max(b.count("\n") for b in blocks) <= 12
    clip = next(read_clips(dataset))
    read: dict[str, Any] = {
        "folder": f"{clip.path('rgb').parent}/",
        "row": read_table(part_files(dataset / "parts", "clips")[0]).to_pylist()[0],
    }
    exec(blocks[0], read)
    assert np.array_equal(read["rgb"], clip.frames("rgb"))
    assert np.array_equal(read["ids"], clip.frames("segmentation"))
    exec(blocks[1], read)
    assert read["metres"] == pytest.approx(clip.frames("depth"))
    exec(blocks[2], read)
    shift = clip.frames("flow")
    assert np.array_equal(read["known"], ~np.isnan(shift[..., 0]))
    assert read["pixels"][read["known"]] == pytest.approx(shift[read["known"]], abs=1e-5)
    exec(blocks[3], read)
    assert read["normals"] == pytest.approx(clip.frames("normal"), abs=1e-6)
    places = clip.frames("object_coordinates")
    assert np.array_equal(np.isnan(read["shares"]), np.isnan(places))
    assert np.nanmax(np.abs(read["shares"] - places)) < 1e-6
