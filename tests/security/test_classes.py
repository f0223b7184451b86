"""Whose class runs, and what a class cannot do that runs because somebody vouched for it."""

from __future__ import annotations

from collections.abc import Callable
import json
import os
from pathlib import Path
import socket
import threading

import numpy as np
import pytest

from benchmarks.faults.tampering import (
    TAMPERED,
    in_a_static,
    in_every_step,
    in_tick,
    plants,
    source_of,
)
from esg.api.rendering import Asked
from esg.commands.export import export
from esg.commands.render import render
from esg.commands.replay import replay
from esg.commands.report import report
from esg.commands.view import view
from esg.compile import build
from esg.compile.replay import ForeignClass, replay_class
from esg.compile.trust import confined, locks
from esg.compile.trust.confined import ClassStopped
from esg.engines.manifest import load_manifest
from esg.engines.rollout_file import load_rollout
from esg.outcomes import UserError

DECLARED = """
#define SAID(X) #X
extern SAID(C) {
	int socket(int, int, int) noexcept;
	int open(const char*, int, ...) noexcept(false);
	long read(int, void*, unsigned long) noexcept(false);
	long syscall(long, ...) noexcept;
}
"""


@pytest.mark.parametrize("tamper", TAMPERED)
def test_a_tampered_class_is_not_even_compiled(
    tamper: Callable[[Path, Path], None],
    scene: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Its program is replayed instead, and why is told."""
    marker = tmp_path / "ran"
    tamper(scene, marker)
    monkeypatch.setattr(build, "_compile_unit", _never)
    with pytest.raises(ForeignClass, match="--trust"):
        replay_class(scene)
    if (scene / "esg.json").exists():
        assert not marker.exists()


def _never(*_: object) -> None:
    raise AssertionError("a stranger's class was compiled")


@pytest.mark.parametrize("recorded", [True, False])
def test_looking_runs_nothing(
    recorded: bool, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Report, view, render and exports show a scene; its class stays text."""
    marker = tmp_path / "ran"
    in_a_static(scene, marker)
    (scene / "SHA256SUMS").unlink()  # as whoever changes a class would
    monkeypatch.setattr(build, "_compile_unit", _never)
    if not recorded:
        for name in ("rollout.npz", "rollout.mcap"):
            (scene / name).unlink()
    assert report(scene, engines="physx") == 0
    assert view(str(scene), port=0, once=True) == 0
    assert render(str(scene), asked=Asked(size="32x32", fps=2.0), out=tmp_path / "render") == 0
    for to in ("usd", "glb", "mjcf", "mcap"):
        assert export(str(scene), to=to, out=tmp_path / to) == 0  # type: ignore[arg-type]
    assert not marker.exists()


def test_a_place_that_nobody_knows_is_told(scene: Path, tmp_path: Path) -> None:
    """A document fits its schema and yet names what is in no table."""
    path = scene / "esg.json"
    document = json.loads(path.read_text("utf-8"))
    document["dressing"]["place"] = "the moon"
    path.write_text(json.dumps(document), "utf-8")
    (scene / "SHA256SUMS").unlink()
    with pytest.raises(UserError, match="'the moon' is in no table"):
        export(str(scene), to="glb", out=tmp_path / "glb")
    with pytest.raises(UserError, match="'the moon' is in no table"):
        render(str(scene), asked=Asked(size="32x32", fps=2.0), out=tmp_path / "render")
    assert report(scene, engines="physx") in (0, 3)


def test_a_strangers_class_is_handed_on_only_on_trust(scene: Path, tmp_path: Path) -> None:
    """Who exports a plugin will compile it."""
    in_a_static(scene, tmp_path / "ran")
    with pytest.raises(UserError, match="--trust"):
        export(str(scene), to="unreal", out=tmp_path / "plugin")
    assert export(str(scene), to="unreal", out=tmp_path / "plugin", trust=True) == 0


def test_replay_says_that_the_program_was_replayed(
    scene: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """On the console, in JSON, and with the remedy."""
    in_every_step(scene, tmp_path / "ran")
    assert replay(str(scene)) in (0, 3)
    said = capsys.readouterr().out
    assert "proof: program" in said and "the class was not run" in said and "--trust" in said
    replay(str(scene), json=True)
    told = json.loads(capsys.readouterr().out)
    assert told["proof"] == "program" and source_of(scene).name in told["proof_note"]
    assert not (tmp_path / "ran").exists()


def test_our_own_class_runs_in_a_child_and_does_the_same(
    scene: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """What equals the emission is proof as before, bit by bit."""
    monkeypatch.setattr("esg.compile.replay.play", _never)
    replayed = replay_class(scene)
    assert np.array_equal(replayed.rollout.position, load_rollout(scene / "rollout.npz").position)
    assert replayed.log and replayed.scene is None
    replay(str(scene), json=True)
    told = json.loads(capsys.readouterr().out)
    assert told["proof"] == "class" and told["proof_note"] == ""


def test_threads_are_no_hindrance(scene: Path) -> None:
    """Beside other threads the child is a fresh process, not a fork."""
    alone = replay_class(scene).rollout
    over = threading.Event()
    thread = threading.Thread(target=over.wait)
    thread.start()
    try:
        beside = replay_class(scene).rollout
    finally:
        over.set()
        thread.join()
    assert np.array_equal(alone.position, beside.position)


@pytest.mark.parametrize(
    ("code", "says"),
    [
        ("for (volatile int I = 0;;) { I = I + 1; }", "ran longer than 4 s and was stopped"),
        ("for (;;) { new char[1 << 24](); }", r"wanted more than 0\.25 GiB of memory"),
        ("*reinterpret_cast<volatile int*>(8) = 1;", r"crashed \(SIGSEGV\)"),
        ("_Exit(0);", "without a result"),
        ("throw 7;", "crashed"),
    ],
)
def test_a_class_that_misbehaves_is_told_in_one_sentence(
    code: str, says: str, scene: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Loops, eats memory, crashes, leaves: this process lives on and says so."""
    in_tick(scene, code, DECLARED)
    monkeypatch.setattr(confined, "MEMORY_BYTES", 2**28)
    if "volatile int I " in code:
        monkeypatch.setattr(confined, "time_limit", lambda job: 4.0)
    with pytest.raises(ClassStopped, match=says) as told:
        replay_class(scene, trust=True)
    assert len(str(told.value).splitlines()) == 1
    with pytest.raises(UserError, match="leave out --trust"):
        replay(str(scene), trust=True)


def test_an_interrupt_leaves_no_child_behind(scene: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever gives up waiting does not leave a loop running."""
    in_tick(scene, "for (volatile int I = 0;;) { I = I + 1; }")
    pids: list[int] = []

    def interrupted(running: confined._Child, *_: object) -> None:
        pids.append(running.pid)
        raise KeyboardInterrupt

    monkeypatch.setattr(confined, "_collect", interrupted)
    with pytest.raises(KeyboardInterrupt):
        replay_class(scene, trust=True)
    with pytest.raises(ProcessLookupError):
        os.kill(pids[0], 0)


def _logged(scene: Path) -> str:
    return "\n".join(replay_class(scene, trust=True, duration=0.02).log)


def test_it_cannot_write(scene: Path, tmp_path: Path) -> None:
    """Neither when it is loaded nor when it plays."""
    in_a_static(scene, tmp_path / "loaded")
    in_tick(scene, plants(tmp_path / "played"))
    assert "SCENE_START" in _logged(scene)
    assert not (tmp_path / "loaded").exists() and not (tmp_path / "played").exists()


@pytest.mark.skipif(locks.FILES not in locks.available(), reason="the kernel locks no files")
def test_it_cannot_read_what_is_not_code(scene: Path, tmp_path: Path) -> None:
    """No key, no history: what it could tell in its log or its motion."""
    secret = tmp_path / "id_rsa"
    secret.write_text("PRIVATE KEY")
    code = (
        f'char Text[64] = {{}}; const int File = open(TEXT("{secret}"), 0); read(File, Text, 63); '
        'UE_LOG(LogTemp, Display, TEXT("READ %d %s"), File, Text);'
    )
    in_tick(scene, code, DECLARED + "DEFINE_LOG_CATEGORY_STATIC(LogTemp, Log, All);")
    log = _logged(scene)
    assert "READ -1" in log and "PRIVATE" not in log


@pytest.mark.skipif(locks.CALLS not in locks.available(), reason="calls are not filtered here")
def test_it_reaches_no_network_and_starts_nothing(scene: Path, tmp_path: Path) -> None:
    """No connection arrives, no command runs, nobody else is signalled."""
    with socket.socket() as server:
        server.bind(("127.0.0.1", 0))
        server.listen()
        server.settimeout(0.2)
        code = (
            "const int Socket = socket(2, 1, 0); const int Unix = socket(1, 1, 0); "
            f'const int Ran = system(TEXT("touch {tmp_path}/ran")); '
            "const long Fork = syscall(57), Exec = syscall(59, 0, 0, 0), Kill = syscall(62, 1, 0); "
            'UE_LOG(LogTemp, Display, TEXT("NET %d %d RAN %d %d %d %d"), Socket, Unix, Ran == 0, '
            "static_cast<int>(Fork), static_cast<int>(Exec), static_cast<int>(Kill));"
        )
        in_tick(scene, code, DECLARED + "DEFINE_LOG_CATEGORY_STATIC(LogTemp, Log, All);")
        assert "NET -1 -1 RAN 0 -1 -1 -1" in _logged(scene)
        with pytest.raises(TimeoutError):
            server.accept()
    assert not (tmp_path / "ran").exists()


def test_it_knows_nothing_of_the_environment(scene: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Keys of language models are kept in it."""
    monkeypatch.setenv("ESG_LLM_API_KEY", "sesame")
    code = (
        'UE_LOG(LogTemp, Display, TEXT("KEY %s"), '
        'getenv(TEXT("ESG_LLM_API_KEY")) ? getenv(TEXT("ESG_LLM_API_KEY")) : TEXT("none"));'
    )
    in_tick(scene, code, DECLARED + "DEFINE_LOG_CATEGORY_STATIC(LogTemp, Log, All);")
    log = _logged(scene)
    assert "KEY none" in log and "sesame" not in log


def test_it_cannot_speak_for_the_command(scene: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """What it prints stays out of `--json`, and what it says instead of an answer is refused."""
    in_tick(scene, 'puts(TEXT("{}"));', DECLARED)
    replay(str(scene), trust=True, json=True)
    assert json.loads(capfd.readouterr().out)["proof"] == "class"


@pytest.mark.parametrize("seconds", ["1e9", "1e300"])
def test_a_class_that_wants_to_play_forever_is_refused(seconds: str, scene: Path) -> None:
    """Before anything is allocated for it."""
    path = source_of(scene)
    before, after = path.read_text("utf-8").split("SceneDuration = ", 1)
    path.write_text(before + f"SceneDuration = {seconds};" + after.split(";", 1)[1], "utf-8")
    with pytest.raises(UserError, match=r"more than is recorded"):
        replay(str(scene), trust=True)


def test_a_pipelines_class_runs_in_its_own_process(
    made: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The document is the caller's own: no child is started for it."""
    from esg.compile.trust import written
    from esg.graph import load_document

    monkeypatch.setattr(written, "_written", {})
    monkeypatch.setattr("esg.compile.replay.play_confined", _never)
    replayed = replay_class(made, document=lambda: load_document(made / "esg.json"))
    assert replayed.scene is not None
    assert replayed.scene.names == load_manifest(made / "manifest.json").scene.names
