"""Datasets at a URL: the same bytes as in a folder, resumable from any machine."""

from __future__ import annotations

from collections.abc import Iterator
import json
from pathlib import Path
import shutil
import socket
from typing import Any

import pytest

from esg import stages
from esg.commands.datasets import dataset as command
from esg.dataset import running as module
from esg.dataset.batch import make_batch
from esg.dataset.remote import Remote, checked_place, is_url, staging_folder
from esg.outcomes import UserError
from tests.dataset import fakes
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


def test_places_that_cannot_be_reached_are_named(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="nowhere://x"):
        run("nowhere://x/y", tmp_path)
    closed = "s3://b/x?endpoint_override=127.0.0.1:9&scheme=http&region=us-east-1"
    with pytest.raises(UserError, match="check the address"):
        Remote(closed).has("x")
