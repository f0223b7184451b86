"""The shards as `webdataset` and `tarfile` read them."""

from __future__ import annotations

import io
import json
from pathlib import Path
import tarfile

import numpy as np
import pytest

from esg.dataset.layouts import webdataset as module
from esg.dataset.layouts.building import add_layouts
from esg.dataset.layouts.source import Source


def test_webdataset_reads_a_sample_a_clip_with_all_its_files(whole, tmp_path):
    wds = pytest.importorskip("webdataset")
    urls = [str(p) for p in sorted((whole / "layouts" / "webdataset").glob("train-*.tar"))]
    found = list(wds.WebDataset(urls, shardshuffle=False))
    clips = list(Source(whole).samples("train"))
    assert [s["__key__"] for s in found] == [c.key for c in clips]
    for sample, clip in zip(found, clips, strict=True):
        about = json.loads(sample["json"])
        assert about["prompt"] == clip.clip.record.prompt
        assert [e["event_id"] for e in about["events"]] == ["e1", "e2"]
        assert about["outcome"] in ("solved", "not_converged")
        arrays = np.load(io.BytesIO(sample["npz"]))
        assert np.array_equal(arrays["object_position_m"], clip.clip.record.object_position_m)
        for file in clip.clip.record.files:
            path = clip.clip.path(file.channel)
            assert sample[f"{file.channel}{path.suffix}"] == path.read_bytes()


def test_headers_tell_nothing_of_the_machine(whole):
    for path in (whole / "layouts" / "webdataset").glob("*.tar"):
        with tarfile.open(path) as tar:
            for member in tar:
                assert (member.mtime, member.uid, member.gid) == (0, 0, 0)
                assert member.uname == member.gname == ""


def test_shards_are_cut_by_size_and_number(whole, tmp_path, monkeypatch):
    """Every clip is in exactly one shard, in order."""
    import shutil

    out = Path(shutil.copytree(whole, tmp_path / "copy", ignore=shutil.ignore_patterns("layouts")))
    clips = [s.clip.record for s in Source(out).samples("train")]
    sizes = [sum(f.bytes for f in c.files) for c in clips]
    monkeypatch.setattr(module, "SHARD_BYTES", max(sizes) * 2)
    monkeypatch.setattr(module, "SHARD_CLIPS", 5)
    add_layouts(out, ["webdataset"], print)
    names: list[list[str]] = []
    for path in sorted((out / "layouts" / "webdataset").glob("train-*.tar")):
        with tarfile.open(path) as tar:
            names.append([n[: -len(".json")] for n in tar.getnames() if n.endswith(".json")])
    assert [n for shard in names for n in shard] == [s.key for s in Source(out).samples("train")]
    assert [len(shard) for shard in names] == [2, 2, 2]
    facts = json.loads((out / "layouts" / "webdataset" / "layout.json").read_text())
    assert facts["splits"]["train"] == {"samples": 6, "shards": 3}
