"""What works here, and the command that brings what is missing."""

from __future__ import annotations

import json
from pathlib import Path
import re

import pytest

from esg.commands import doctor

PINNED = re.compile(r'pip install "?([\w\[\]-]+)==([\w.]+)')


def test_what_is_missing_comes_with_its_remedy(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def missing() -> str:
        raise RuntimeError("not there\nat all")

    checks = (
        doctor._Check("thing", True, missing, "pip install thing"),
        doctor._Check("extra", False, missing, "esg setup"),
        doctor._Check("rest", True, lambda: "1.0", "never told"),
    )
    monkeypatch.setattr(doctor, "_CHECKS", checks)
    assert doctor.doctor(json=True) == 1
    told = json.loads(capsys.readouterr().out)
    assert not told["ok"]
    assert [(c["detail"], c["remedy"]) for c in told["checks"]] == [
        ("not there", "pip install thing"),
        ("not there", "esg setup"),
        ("1.0", ""),
    ]
    assert doctor.doctor() == 1
    text = capsys.readouterr().out
    assert "MISSING" in text and "absent" in text and "never told" not in text


def test_remedies_name_the_versions_that_the_project_asks_for() -> None:
    project = (Path(__file__).parents[2] / "pyproject.toml").read_text()
    for check in doctor._CHECKS:
        assert check.remedy
        for package, version in PINNED.findall(check.remedy):
            assert f'"{package}=={version}"' in project, check.name


def test_the_drafter_that_auto_takes_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """Say that the rules draft, and what is missing, until a model is configured."""
    for name in ("BASE_URL", "MODEL", "API_KEY", "CASSETTE"):
        monkeypatch.delenv(f"ESG_LLM_{name}", raising=False)
    check = next(c for c in doctor._CHECKS if c.name == "drafter")
    assert not check.required
    with pytest.raises(RuntimeError, match=r"uses the rules.*ESG_LLM_BASE_URL"):
        check.probe()
    monkeypatch.setenv("ESG_LLM_BASE_URL", "http://localhost:1/v1?key=secret")
    monkeypatch.setenv("ESG_LLM_MODEL", "some-model")
    assert "some-model at http://localhost:1/v1" in check.probe()
    assert "secret" not in check.probe()
