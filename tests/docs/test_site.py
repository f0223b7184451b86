"""The site: every page of it builds without a warning, and every public name is on it."""

from __future__ import annotations

from pathlib import Path
import re
import subprocess
import sys

import pytest

import esg

ROOT = Path(__file__).parents[2]
pytest.importorskip("mkdocs", reason="mkdocs-material is not installed")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("site")
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(out)],
        cwd=ROOT, capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return out


def test_every_public_name_is_in_the_reference(site: Path) -> None:
    text = (site / "reference.html").read_text("utf-8")
    shown = set(re.findall(r'id="esg\.[\w.]*\.(\w+)"', text))
    assert set(esg.__all__) - {"__version__"} <= shown


def test_public_names_say_shapes_units_and_errors(site: Path) -> None:
    """Whatever takes arguments documents them, and members of records have a line each."""
    text = (site / "reference.html").read_text("utf-8")
    assert text.count("doc-section-title") > 30
    assert "shape [T, 3]" in text
    assert "UserError" in text


def test_pages_beside_the_docs_lead_into_them(site: Path) -> None:
    readme = (site / "overview.html").read_text("utf-8")
    assert 'href="results.html"' in readme
    assert 'src="images/s6.png"' in readme
    trust = (site / "security.html").read_text("utf-8")
    assert "trust.html#" in trust


def test_nothing_is_fetched(site: Path) -> None:
    fetched = re.compile(r'(?:src|href)="(https?://[^"]+\.(?:css|js|woff2?))"')
    assert [m for p in site.glob("*.html") for m in fetched.findall(p.read_text("utf-8"))] == []
