"""Datasets at a URL: the same bytes as in a folder, resumable from any machine."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
import json
from pathlib import Path
import shutil
import socket
from typing import Any

import numpy as np
import pytest

from esg import stages
from esg.commands.datasets import adding as adding_command
from esg.commands.datasets import dataset as command
from esg.commands.datasets.adding import render_dataset
from esg.commands.datasets.clips import BatchOptions, RenderOptions
from esg.commands.datasets.layouts import LayoutOptions
from esg.dataset import running as module
from esg.dataset.batch import make_batch
from esg.dataset.clips.reading import read_clips
from esg.dataset.layouts.building import missing_layouts
from esg.dataset.remote import Remote, checked_place, is_url, staging_folder
from esg.outcomes import UserError
from tests.dataset import fakes
from tests.dataset.clips import stand_ins
from tests.dataset.clips.stand_ins import media
from tests.dataset.clips.test_batches import told
from tests.dataset.test_batch import below

TEXTS = [*(f"balls {k}" for k in range(9)), "a bug"]


@pytest.fixture(autouse=True)
def quick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Fake stages in this process; the cache below the test's folder."""
    for name in fakes.STAGES:
        monkeypatch.setitem(stages.SPECS, name, stages.SPECS[name])
    monkeypatch.setattr(stages, "conclude", stages.conclude)
    monkeypatch.setenv("ESG_TEST_CALLS", str(tmp_path / "calls"))
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.setattr(module, "_compile_together", lambda states: None)
    monkeypatch.setattr(command, "make_batches", lambda jobs, *_: [make_batch(j) for j in jobs])
    fakes.install()
    (tmp_path / "p.txt").write_text("\n".join(TEXTS))
    yield


@pytest.fixture
def bucket(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """A URL in an S3 server on this machine."""
    pytest.importorskip("flask", reason="the S3 server of the tests needs moto[server]")
    server_module = pytest.importorskip("moto.server")
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    server = server_module.ThreadedMotoServer(ip_address="127.0.0.1", port=port, verbose=False)
    server.start()
    for name in ("AWS_ACCESS_KEY_ID", "AWS_SECRET_ACCESS_KEY"):
        monkeypatch.setenv(name, "testing")
    monkeypatch.setenv("AWS_EC2_METADATA_DISABLED", "true")
    for name in ("HTTP_PROXY", "http_proxy", "ALL_PROXY", "all_proxy"):
        monkeypatch.delenv(name, raising=False)
    options = f"endpoint_override=127.0.0.1:{port}&scheme=http&region=us-east-1"
    try:
        # Servers of one process share their buckets: every test has its own.
        yield f"s3://{tmp_path.name.replace('_', '-').lower()}/sets/one?{options}&allow_bucket_creation=true"
    finally:
        server.stop()


def run(out: str, tmp_path: Path, **more: Any) -> int:
    return command.dataset(out=out, prompts=tmp_path / "p.txt", previews="none", **more)


def download(url: str, folder: Path) -> Path:
    remote = Remote(url)
    remote.pull(folder, remote.names(""))
    return folder


def test_what_is_a_url() -> None:
    assert is_url("s3://bucket/x")
    assert not is_url("runs/set")
    assert checked_place("file:///data/my%20set") == "/data/my set"
    for fine in ("runs/set", "s3://bucket/x?scheme=http", "./s3:/x", "C:/x", "run:1"):
        assert checked_place(fine) == fine
    with pytest.raises(UserError, match="two slashes"):
        checked_place("s3:/bucket/x")
    assert staging_folder("s3://a/b") != staging_folder("s3://a/c")


def test_a_dataset_at_a_url_equals_one_in_a_folder(
    bucket: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(str(tmp_path / "here"), tmp_path) == 3
    capsys.readouterr()
    assert run(bucket, tmp_path, json=True) == 3
    told = json.loads(capsys.readouterr().out)
    assert (told["folder"], told["complete"], told["failed"]) == (bucket, True, 1)
    there, here = below(download(bucket, tmp_path / "there")), below(tmp_path / "here")
    assert there.keys() == here.keys()
    assert [n for n in here if here[n] != there[n] and n != "meta/crashes.jsonl"] == []
    assert not staging_folder(bucket).exists()


def test_another_machine_goes_on_where_one_stopped(
    bucket: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two of three batches are there; the machine that made them is lost with its folder."""
    monkeypatch.setattr(command, "make_batches", lambda jobs, *_: [make_batch(j) for j in jobs[:2]])
    run(bucket, tmp_path, shard="1/1")
    assert len(Remote(bucket).names("marks")) == 2
    shutil.rmtree(staging_folder(bucket))
    before = len(fakes.calls())
    monkeypatch.setattr(command, "make_batches", lambda jobs, *_: [make_batch(j) for j in jobs])
    with pytest.raises(UserError, match="add --resume"):
        run(bucket, tmp_path)
    assert run(bucket, tmp_path, resume=True) == 3
    again = [c for c in fakes.calls()[before:] if c.startswith("draft")]
    assert again == ["draft balls 8", "draft a bug"]
    assert Remote(bucket).has("meta/info.json")
    assert Remote(bucket).names("parts") == []


def test_shards_at_one_url_are_put_together_by_the_last(bucket: str, tmp_path: Path) -> None:
    run(bucket, tmp_path, shard="1/2")
    assert not Remote(bucket).has("meta/info.json")
    shutil.rmtree(staging_folder(bucket))
    assert run(bucket, tmp_path, shard="2/2", resume=True) == 3
    run(str(tmp_path / "here"), tmp_path)
    there, here = below(download(bucket, tmp_path / "there")), below(tmp_path / "here")
    assert there.keys() == here.keys()


def test_a_run_killed_while_uploading_goes_on(
    bucket: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:

        def cut(self: Remote, folder: Path) -> None:
            self.push(folder, ["README.md"])
            raise KeyboardInterrupt

        patch.setattr(Remote, "push_dataset", cut)
        with pytest.raises(KeyboardInterrupt):
            run(bucket, tmp_path)
    assert not Remote(bucket).has("meta/info.json")
    assert run(bucket, tmp_path, resume=True) == 3
    assert Remote(bucket).has("meta/info.json")


@pytest.fixture
def cameras(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> RenderOptions:
    """Cameras that see the balls of three scenes."""
    (tmp_path / "p.txt").write_text("balls 1\nballs 2\nballs 3")
    stand_ins.install(monkeypatch)
    monkeypatch.setattr(stages, "load_doc", lambda *_: None)
    monkeypatch.setattr(
        adding_command, "make_batches", lambda jobs, *_: [make_batch(j) for j in jobs]
    )
    return RenderOptions(",".join(stand_ins.SPEC.channels), 2, "32x24", 4.0, camera="around")


@pytest.mark.slow
def test_clips_at_a_url_equal_those_in_a_folder(
    bucket: str, tmp_path: Path, cameras: RenderOptions
) -> None:
    """Also those of a batch that another machine made, whose films are not here."""
    layouts = LayoutOptions("webdataset")
    run(str(tmp_path / "here"), tmp_path, batch=2, rendering=cameras, layouts=layouts)
    run(bucket, tmp_path, batch=2, rendering=cameras, layouts=layouts, shard="1/2")
    shutil.rmtree(staging_folder(bucket))
    run(bucket, tmp_path, batch=2, rendering=cameras, layouts=layouts, shard="2/2", resume=True)
    there, here = download(bucket, tmp_path / "there"), tmp_path / "here"
    assert media(there) == media(here)
    names = ("sheet.jpg", "layouts/webdataset/layout.json", *below_of(here, "clips", "*.parquet"))
    assert len(names) >= 3
    for name in names:
        assert (there / name).read_bytes() == (here / name).read_bytes(), name


def test_clips_are_read_from_their_url(bucket: str, tmp_path: Path, cameras: RenderOptions) -> None:
    """A row from the bucket, frames from the bucket: nothing is copied before."""
    import av
    from pyarrow import fs
    import pyarrow.parquet as pq

    run(bucket, tmp_path, batch=2, rendering=cameras)
    store, base = fs.FileSystem.from_uri(bucket)
    (name, *_) = (n for n in Remote(bucket).names("clips") if n.endswith(".parquet"))
    row = pq.read_table(f"{base}/{name}", filesystem=store).slice(0, 1).to_pylist()[0]
    path = {f["channel"]: f["path"] for f in row["files"]}["segmentation"]
    with store.open_input_file(f"{base}/{path}") as file, av.open(file) as film:
        ids = np.stack([f.to_ndarray() for f in film.decode(video=0)])
    assert ids.shape == (row["n_frames"], 24, 32)
    seen = {box["id"] for box in row["boxes2d"]}
    assert seen <= set(np.unique(ids).tolist()) <= seen | {0, 1}


@pytest.mark.slow
def test_a_dataset_at_a_url_gets_clips_and_new_layouts(
    bucket: str, tmp_path: Path, cameras: RenderOptions, monkeypatch: pytest.MonkeyPatch
) -> None:
    run(bucket, tmp_path, batch=2, rendering=cameras, layouts=LayoutOptions("webdataset"))
    before = Remote(bucket).names("")
    told(monkeypatch)
    three = replace(cameras, cameras=3)
    assert render_dataset(bucket, three, BatchOptions(batch=2), "cpu", {}, as_json=False) == 0
    after = download(bucket, tmp_path / "there")
    assert {n for n in before if "camera_1" in n} <= set(below_of(after, ".", "*"))
    assert len(list(read_clips(after))) == 9
    info = json.loads((after / "meta" / "info.json").read_text())
    assert info["rows"]["clips"] == 9 and info["rows"]["metrics"] > 0
    assert missing_layouts(after, ["webdataset"]) == []
    assert "9 clips" in (after / "README.md").read_text()
    assert Remote(bucket).names("rendering") == []


def below_of(folder: Path, inner: str, pattern: str) -> list[str]:
    """Files below a folder of a dataset, as named in it."""
    found = (p for p in (folder / inner).rglob(pattern) if p.is_file())
    return sorted(p.relative_to(folder).as_posix() for p in found)


def test_places_that_cannot_be_reached_are_named(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="nowhere://x"):
        run("nowhere://x/y", tmp_path)
    closed = "s3://b/x?endpoint_override=127.0.0.1:9&scheme=http&region=us-east-1"
    with pytest.raises(UserError, match="check the address"):
        Remote(closed).has("x")
