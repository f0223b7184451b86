"""What a wheel holds: everything that an installed copy reads."""

from __future__ import annotations

from pathlib import Path
import shutil
import subprocess
import sys
import zipfile

import pytest

ROOT = Path(__file__).parents[2]
SOURCES = ("esg", "tasks", "flows", "pyproject.toml", "README.md", "LICENSE")


def tracked(*paths: str) -> list[str]:
    command = ["git", "ls-files", *paths]
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=True)
    return [f for f in done.stdout.splitlines() if (ROOT / f).is_file()]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Built from a copy: what an earlier build left in the checkout would go into it."""
    out = tmp_path_factory.mktemp("wheel")
    for name in tracked(*SOURCES):
        (out / "source" / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, out / "source" / name)
    command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation"]
    done = subprocess.run(
        [*command, "--wheel-dir", str(out), str(out / "source")],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return next(out.glob("*.whl"))


def test_every_file_of_the_packages_is_in_the_wheel(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        held = set(archive.namelist())
    assert [f for f in tracked("esg", "tasks", "flows") if f not in held] == []


def test_an_installed_copy_knows_its_suites_and_data(wheel: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "site")
    code = (
        "import esg, pathlib; from esg.metrics import load_suite, own_suites;"
        "assert 'site' in pathlib.Path(esg.__file__).parts;"
        "print(len(load_suite('paper').scenes), len(own_suites()))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path,
        env={"PYTHONPATH": str(tmp_path / "site"), "PATH": "/usr/bin:/bin"}, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    scenes, suites = map(int, done.stdout.split())
    assert scenes == 10 and suites >= 9
