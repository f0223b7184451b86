"""`esg setup`: everything that would otherwise stall a first scene, done once per machine."""

from __future__ import annotations

from collections.abc import Callable
import contextlib
import sys
import threading
import time
from typing import TextIO

from esg.commands.live import LOG_EVERY_S, duration

SAMPLES = (
    ("A red ball rolls across the floor and hits a wooden box.", "exact"),
    ("A table with a vase on it.", "exact"),
    ("A wooden box slides across the floor and hits another wooden box.", "sdf"),
)
"""Prompts whose whole way through the stages loads and compiles what scenes need, each with what
bodies collide with in its search; the last one compiles the kernels of signed distance fields."""
PACKAGES = ("esg", "tasks", "flows")
"""Packages of the project."""


def setup(*, device: str | None = None, again: bool = False) -> int:
    """Compile and cache all kernels (a few minutes the first time, a second afterwards).

    Args:
        device: Whose kernels are compiled beside those of the processor, such as cuda:0; that of
            this machine, if it has one, unless it is cpu.
        again: Go through all of it, even where it was done before and is still there.
    """
    from esg.api.inputs import check_cache
    from esg.paths import cache_dir, kernel_cache_dir
    from esg.prepared import note_prepared, prepared

    check_cache()
    if not again and prepared(device):
        print("all of it is there already (--again goes through it anyway)")
    else:
        _prepare(_gpu(device))
        note_prepared(device)
    _step("bytecode of the modules", _bytecode)
    print(f"ready; caches are in {cache_dir()} and {kernel_cache_dir()}")
    return 0


def _prepare(gpu: str | None) -> None:
    from pathlib import Path
    import tempfile

    from esg.engines import warmup

    _step("scheduler database", _prefect)
    _step("kernels of the processor, side by side", lambda: _ahead("cpu"))
    if gpu is not None:
        _step(f"kernels of {gpu}, side by side", lambda: _ahead(gpu))
        _step(f"engine kernels of {gpu}", lambda: warmup(progress=_line, device=gpu))
    _step("engine kernels", lambda: warmup(progress=_line))
    _step("surrogate kernels", _surrogate)
    with tempfile.TemporaryDirectory(prefix="esg-setup-") as folder:
        for number, sample in enumerate(SAMPLES, 1):
            name = f"sample scene {number} of {len(SAMPLES)}"
            _step(name, lambda s=sample: _sample(*s, Path(folder)))


def _gpu(device: str | None) -> str | None:
    """The GPU to compile for, if any.

    Raises:
        UserError: If this machine does not have the device that was asked for.
    """
    from esg.engines.newton.setup import known_device, quiet_warp

    if device is not None:
        return None if known_device(device, "esg setup") == "cpu" else device
    return next((str(d) for d in quiet_warp().get_devices() if d.is_cuda), None)


def _ahead(device: str) -> None:
    from esg.engines.fleet.ahead import compile_ahead

    def tell(name: str, done: int, total: int) -> None:
        _show(f"kernels {done}/{total}: {name}")

    search = "cpu" if device == "cpu" else "gpu"
    layout = [f"esg.layout.kernels.{name}" for name in (search, "evaluation")]
    compile_ahead(device, tell, layout)


def _step(name: str, work: Callable[[], object]) -> None:
    start = time.perf_counter()
    with _Clock(name):
        work()
    print(f"{name}: {time.perf_counter() - start:.1f} s", flush=True)


class _Clock:
    """Says what is being done and for how long, since one kernel may take a minute.

    A terminal has one line that is written over every second; a file or a pipe gets a line every
    `LOG_EVERY_S`.

    Args:
        name: Of the step.
        stream: Where to.
        every_s: Between two lines [s]; None decides by the stream.
    """

    current: _Clock | None = None

    def __init__(self, name: str, stream: TextIO = sys.stderr, every_s: float | None = None):
        self.doing, self._stream, self._tty = name, stream, stream.isatty()
        self._every_s = every_s or (1.0 if self._tty else LOG_EVERY_S)
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._tell, name="esg-setup", daemon=True)

    def __enter__(self) -> _Clock:
        self._start = time.monotonic()
        _Clock.current = self
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._over.set()
        self._thread.join()
        _Clock.current = None
        if self._tty:
            print("\r\x1b[K", end="", file=self._stream, flush=True)

    def _tell(self) -> None:
        while True:
            waited = f"{self.doing} ... {duration(time.monotonic() - self._start)}"
            line = f"\r\x1b[K{waited}" if self._tty else f"{waited}\n"
            if self._tty or time.monotonic() - self._start >= self._every_s:
                # A closed pipe or a full disk is no reason to fail.
                with contextlib.suppress(OSError, ValueError):
                    print(line, end="", file=self._stream, flush=True)
            if self._over.wait(self._every_s):
                return


def _show(text: str) -> None:
    """What the running step is doing now."""
    if _Clock.current is not None:
        _Clock.current.doing = text


def _line(name: str, done: int, total: int) -> None:
    _show(f"engine kernels {done}/{total}: {name}")


def _prefect() -> None:
    from flows.embedded import prepare_template

    prepare_template()


def _surrogate() -> None:
    from esg.engines.surrogate import warmup

    warmup()


def _bytecode() -> None:
    """What Python would write beside a module at its first import, unless it is told not to.

    Container images are (PYTHONDONTWRITEBYTECODE), and some installers leave it to the first run:
    without it each command compiles some 500 modules of the project again. A folder that cannot be
    written to stays as it is.
    """
    from compileall import compile_dir, compile_file
    from importlib.util import find_spec

    for package in PACKAGES:
        spec = find_spec(package)
        for folder in (spec.submodule_search_locations or ()) if spec is not None else ():
            compile_dir(folder, quiet=2)
    loaded = (getattr(m, "__file__", None) for m in [*sys.modules.values()])
    for file in loaded:
        if file is not None and file.endswith(".py"):
            compile_file(file, quiet=2)


def _sample(prompt: str, collision: str, root: object) -> None:
    from pathlib import Path

    from esg.outcomes import UserError
    from esg.pipeline import STAGES, SceneRequest, SceneState, run_stage, scratch_store

    assert isinstance(root, Path)
    with scratch_store(root):
        state = SceneState(SceneRequest(prompt, collision=collision))
        for stage in STAGES:
            _show(f"sample scene: {stage}")
            state = run_stage(stage, state)
    if len(state.artifacts) < len(STAGES):
        raise UserError(f"the sample scene {prompt!r} failed: {state.reason}", exit_code=1)
