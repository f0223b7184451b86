"""Kernels compiled ahead of their use, on all cores.

What is to run is gone through once while no module is loaded: launches do nothing and only say
which kernels they need. All of them are compiled side by side; what runs afterwards finds them, and
compiles what no launch has told.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import contextmanager, suppress
from functools import partial
import multiprocessing
from multiprocessing.connection import wait
import signal
from typing import Any

from esg.engines.newton.setup import quiet_warp
from esg.outcomes import UserError
from esg.workers import usable_cores

Needed = dict[tuple[Any, str, int | None], None]
"""Modules of kernels, each for a device and a number of threads that work together, in order."""
Progress = Callable[[str, int, int], None]
OWN = {
    "cpu": (
        "esg.engines.surrogate.sdf_kernels",
        "esg.engines.surrogate.replay",
        "esg.engines.surrogate.kernels",
        "esg.engines.surrogate.ops",
        "esg.engines.newton.break_kernels",
    ),
    "cuda": (
        "esg.engines.surrogate.kernels",
        "esg.engines.newton.break_kernels",
    ),
}
"""Modules of this package, those that take longest first. A GPU takes minutes for derivatives and
signed distance fields, which no dataset asks it for."""


def compile_ahead(
    device: str = "cpu", progress: Progress | None = None, more: Sequence[str] = ()
) -> int:
    """Compiles what searches on a device need, as many modules at once as there are cores.

    Args:
        device: Warp device.
        progress: Called with (name, done, in all) as modules are done.
        more: Names of modules beside those of engines.

    Returns:
        How many modules there are.

    Raises:
        UserError: If the device does not exist, or a module cannot be compiled.
    """
    from esg.engines import doctor
    from esg.engines.newton import clear_cache
    from esg.engines.newton.setup import known_device

    known_device(device, "set-up")
    names = (*_own(device), *more)
    works: list[Callable[[], object]] = [partial(_load, name, device) for name in names]
    works += [partial(doctor.play, scene, device) for scene in doctor.tiny_scenes().values()]
    if device != "cpu":
        works += [partial(_sized, bodies, points, device) for bodies, points in searched_sizes()]
    needed = needed_by(works)
    clear_cache()  # models that nothing was launched for
    if device != "cpu":
        with _many_pairs():
            needed |= needed_by(
                partial(doctor.play, s, device) for s in doctor.tiny_scenes().values()
            )
        clear_cache()
    compile_all(needed, progress)
    return len(needed)


def _own(device: str) -> tuple[str, ...]:
    return OWN["cpu" if device == "cpu" else "cuda"]


def _load(name: str, device: str) -> None:
    """Loads a module of this package as its launches do."""
    from importlib import import_module

    from esg.engines.surrogate.launch import BLOCK

    module = import_module(name)
    of_surrogate = name.startswith("esg.engines.surrogate")
    quiet_warp().load_module(module, device=device, block_dim=BLOCK if of_surrogate else None)


def searched_sizes() -> list[tuple[int, int]]:
    """Moving bodies and contact points of a world: one pair for every kernel of the solver that
    searches of many scenes without joints ask a GPU for."""
    from esg.engines.fleet.newton import POINTS
    from esg.engines.newton.sizes import common

    return common(POINTS.world, POINTS.shape)


def _sized(bodies: int, points: int, device: str) -> None:
    """Takes the first steps of a world with so many bodies and room for so many points."""
    from esg.engines.doctor import spheres
    from esg.engines.newton.builder import Drafts
    from esg.engines.newton.model import NewtonModel, Points
    from esg.engines.shapes import SceneShapes

    wanted, shapes = ((0, 1, 1),), [SceneShapes.of(spheres(bodies))]
    room = Points(world=points, body=0, shape=0, rounded=True)
    model = NewtonModel(wanted, shapes, Drafts(keep=False).take(wanted, shapes), device, room)
    model.take_steps()


@contextmanager
def _many_pairs() -> Generator[None]:
    """Lets Newton collide tiny scenes as it does on a GPU from some thousands of pairs on.

    It splits what it does with a pair of convex shapes into kernels of their own there.
    """
    from newton._src.sim import collide

    names = [n for n in dir(collide) if n.startswith("_SPLIT_") and n.endswith("_THRESHOLD")]
    known = {name: getattr(collide, name) for name in names}
    try:
        for name in names:
            setattr(collide, name, 0)
        yield
    finally:
        for name, value in known.items():
            setattr(collide, name, value)


def needed_by(works: Iterable[Callable[[], object]]) -> Needed:
    """What works would compile. Nothing is launched: what they compute is of no use.

    A work that fails because it reads what has not been computed is left there; the rest of what
    it needs is compiled when it runs.
    """
    needed: Needed = {}
    with _noted(needed):
        for work in works:
            with suppress(Exception):
                work()
    return needed


@contextmanager
def _noted(needed: Needed) -> Generator[None]:
    """Lets modules be noted instead of loaded; without one, a launch does nothing."""
    quiet_warp()
    from warp._src.context import Module

    load = Module.load

    def note(self: Any, device: Any, block_dim: int | None = None, *_: Any, **__: Any) -> None:
        needed[self, str(device), block_dim] = None

    Module.load = note
    try:
        yield
    finally:
        Module.load = load


def compile_all(needed: Needed, progress: Progress | None = None) -> None:
    """Compiles modules, as many at once as there are cores.

    The compiler of CUDA works in threads; that of the processor takes one module at a time, so each
    has a process, where processes can fork.

    Args:
        needed: What `needed_by` found.
        progress: Called with (name, done, in all) as modules are done.

    Raises:
        UserError: If a module cannot be compiled or written; no other is begun then.
    """
    done = 0

    def tell(name: str) -> None:
        nonlocal done
        done += 1
        if progress is not None:
            progress(name, done, len(needed))

    forks = "fork" in multiprocessing.get_all_start_methods()
    own = [k for k in needed if forks and k[1] == "cpu"]
    _in_processes(own, tell)
    _in_threads([k for k in needed if k not in own], tell)


def _in_processes(needed: list[Any], tell: Callable[[str], None]) -> None:
    fork = multiprocessing.get_context("fork")
    queue, running = list(needed), {}
    try:
        while queue or running:
            while queue and len(running) < usable_cores():
                module, device, block = queue.pop(0)
                reader, writer = fork.Pipe(duplex=False)
                process = fork.Process(target=_compile, args=(module, device, block, writer))
                process.start()
                writer.close()
                running[process.sentinel] = process, reader, module.name
            for ended in wait(list(running)):
                process, reader, name = running.pop(ended)
                process.join()
                if process.exitcode:
                    raise _failed(name, _said(reader) or f"exit code {process.exitcode}")
                tell(name)
    finally:
        for process, _, _ in running.values():
            process.kill()
            process.join()


def _compile(module: Any, device: str, block_dim: int | None, told: Any) -> None:
    """Compiles a module in a process of its own; exit code 1 with a message if it cannot."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    try:
        module.load(quiet_warp().get_device(device), block_dim)
    except Exception as error:
        told.send(_first_line(error))
        raise SystemExit(1) from None


def _said(reader: Any) -> str:
    with suppress(EOFError, OSError):
        return reader.recv() if reader.poll() else ""
    return ""


def _in_threads(needed: list[Any], tell: Callable[[str], None]) -> None:
    pool = ThreadPoolExecutor(usable_cores(), thread_name_prefix="esg-compile")
    try:
        device = quiet_warp().get_device
        names = {pool.submit(m.load, device(d), block): m.name for m, d, block in needed}
        for one in as_completed(names):
            if (error := one.exception()) is not None:
                raise _failed(names[one], _first_line(error)) from None
            tell(names[one])
    finally:
        pool.shutdown(wait=False, cancel_futures=True)


def _first_line(error: BaseException) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0]


def _failed(name: str, why: str) -> UserError:
    return UserError(f"the kernels of {name} cannot be compiled: {why}", exit_code=1)
