"""The wheel, installed elsewhere: commands, suites, the studio and Python's examples without a checkout."""

from __future__ import annotations

from collections.abc import Callable
import os
from pathlib import Path
import re
import shutil
import subprocess
import sys
import sysconfig
import venv
import zipfile

import pytest

from esg.paths import cache_dir, kernel_cache_dir

ROOT = Path(__file__).parents[2]
ROOMS = ("esg", "tasks", "flows")
PROMPT = "A car collides with a trashbin, knocking it into a picnic table."
SUITE = f"""
suite: one
scenes:
  - {{id: A, prompt: "{PROMPT}", events: [{{id: e1, type: collision, a: car, b: trashbin}}]}}
"""
Run = Callable[..., str]


def plain(path: Path) -> bool:
    return path.is_file() and "__pycache__" not in path.parts


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Built from a copy, so that the checkout is left as it is."""
    work = tmp_path_factory.mktemp("build")
    for room in ROOMS:
        shutil.copytree(
            ROOT / room, work / "src" / room, ignore=shutil.ignore_patterns("__pycache__")
        )
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, work / "src")
    done = subprocess.run(
        [sys.executable, "-c", "import setuptools.build_meta as b; b.build_wheel('..')"],
        cwd=work / "src", capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr[-2000:]
    (found,) = work.glob("*.whl")
    return found


def runner(python: Path, place: Path) -> Run:
    """Runs Python of an environment in a folder without a checkout; tells what it printed."""
    own = ("PYTHONPATH", "ESG_CACHE_DIR", "ESG_DB", "PREFECT_API_URL")
    variables = {k: v for k, v in os.environ.items() if k not in own}
    variables |= {
        "ESG_CACHE_DIR": str(place / "cache"),
        "WARP_CACHE_PATH": str(kernel_cache_dir().parent),
        "PATH": f"{python.parent}{os.pathsep}{os.environ['PATH']}",
    }

    def run(*arguments: str, timeout: float = 600) -> str:
        done = subprocess.run(
            [python, *arguments], cwd=place, env=variables, capture_output=True, text=True,
            timeout=timeout, check=False,
        )  # fmt: skip
        assert done.returncode == 0, (arguments, done.stdout[-2000:], done.stderr[-4000:])
        return done.stdout

    return run


@pytest.fixture(scope="module")
def borrowing(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Run:
    """An environment with the wheel and, of this one, only the libraries: seconds to make."""
    home = tmp_path_factory.mktemp("borrowing")
    venv.create(home / "venv", with_pip=False)
    site = next((home / "venv").glob("lib/python*/site-packages"))
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(site)
    (site / "libraries.pth").write_text(sysconfig.get_path("purelib") + "\n")
    place = home / "elsewhere"
    place.mkdir()
    prefect = cache_dir() / "prefect"
    if prefect.is_dir():  # what `esg setup` has prepared for this machine
        shutil.copytree(prefect, place / "cache" / "prefect")
    run = runner(home / "venv" / "bin" / "python", place)
    found = run("-c", "import esg, tasks, flows; print(esg.__file__, tasks.__file__)")
    assert found.count(str(site)) == 2
    return run


def test_every_file_of_the_packages_is_in_the_wheel(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        inside = set(archive.namelist())
    wanted = {
        p.relative_to(ROOT).as_posix() for r in ROOMS for p in (ROOT / r).rglob("*") if plain(p)
    }
    assert sorted(wanted - inside) == []


def examples() -> str:
    """The first block of docs/api.md, and what the page says of a scene's motion."""
    text = (ROOT / "docs" / "api.md").read_text("utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    first, motion = blocks[:2]
    return (
        f"{first}\n{motion}\n"
        "assert scene.events and motion.contacts and car.speed.max() > 0\n"
        "assert esg.judge(scene).verified and esg.Scene.load(scene.folder).prompt == scene.prompt\n"
        "assert all(p.exists() for p in scene.export('glb', 'exported'))\n"
        "assert esg.cost([scene])['scenes'] == 1\n"
        "print(scene.outcome.value)\n"
    )


def smoke(run: Run, place: Path) -> None:
    """All that a newcomer does first; stages that one command has made the next one finds."""
    assert "solved" in run("-m", "esg", "generate", PROMPT)
    assert run("-c", examples()).strip().splitlines()[-1] == "solved"
    assert run("-m", "esg", "studio", "--once", "--port", "0").startswith("http://127.0.0.1:")
    (place / "one.yaml").write_text(SUITE)
    told = run("-m", "esg", "serve", "--once", "--cached", "--runs", "1", "--suite", "one.yaml",
               "--workers", "0")  # fmt: skip
    assert "one: " in told and "0 failed" in told
    assert "one" in run("-m", "esg", "sql", "select suite from bench_history", "--to", "md")
    run("-m", "esg", "judge", "--help")


@pytest.mark.slow
def test_the_wheel_works_without_the_checkout(borrowing: Run, tmp_path: Path) -> None:
    place = Path(borrowing("-c", "import os; print(os.getcwd())").strip())
    smoke(borrowing, place)


@pytest.mark.slow
def test_a_fresh_environment_runs_the_paper(wheel: Path, tmp_path: Path) -> None:
    """Installed by pip with all that it depends on, and the suites by name."""
    venv.create(tmp_path / "venv", with_pip=True)
    place = tmp_path / "elsewhere"
    place.mkdir()
    run = runner(tmp_path / "venv" / "bin" / "python", place)
    constraints = str(ROOT / "constraints.txt")
    run("-m", "pip", "install", "--quiet", "-c", constraints, str(wheel), timeout=1800)
    smoke(run, place)
    assert "| Total | 18 | 18.0" in run("-m", "esg", "bench", "paper", "--runs", "1", timeout=1800)
    run("-m", "esg", "serve", "--once", "--cached", "--runs", "1", "--suite", "paper", timeout=1800)
