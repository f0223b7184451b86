"""The documentation leads somewhere: links, anchors, commands, paths, and pages of a readable length."""

from __future__ import annotations

from functools import cache
from importlib.util import find_spec
from pathlib import Path
import re
from urllib.parse import unquote

import pytest

from esg.commands import COMMANDS

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = sorted(DOCS.rglob("*.md"))
ALL = [*PAGES, ROOT / "README.md", ROOT / "CHANGELOG.md"]
MOST_WORDS = 1500
FENCE = re.compile(r"^\s*```.*?^\s*```", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#{1,6} +(.+?) *$", re.MULTILINE)
MODULE = re.compile(r"python3? -m ((?:benchmarks|esg|tests)(?:\.\w+)*)")
COMMAND = re.compile(r"(?:^|`|/|&& )esg ([a-z]+)\b", re.MULTILINE)
SOURCES = [
    p for room in ("esg", "tasks", "flows", "benchmarks") for p in (ROOT / room).rglob("*.py")
]
NAMED = re.compile(r"\bdocs/[\w/]+\.md\b")
DOTTED = re.compile(r"`(esg(?:\.[A-Za-z_]\w*)+)\b(?<!esg\.json)")
PATH = re.compile(r"`((?:esg|tasks|flows|data|schemas|benchmarks|tests|docs)/[\w./-]*)`")


def name(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def prose(path: Path) -> str:
    """A page without its fenced code."""
    return FENCE.sub("", path.read_text("utf-8"))


@cache
def anchors(path: Path) -> frozenset[str]:
    """The anchors that GitHub gives to the headings of a page."""
    found: set[str] = set()
    for title in HEADING.findall(prose(path)):
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title).replace("`", "").lower()
        slug = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
        repeated = sum(
            a == slug or re.fullmatch(rf"{re.escape(slug)}-\d+", a) is not None for a in found
        )
        found.add(f"{slug}-{repeated}" if repeated else slug)
    return frozenset(found)


def broken(page: Path, target: str) -> str:
    """What is wrong with a link; empty if it leads somewhere."""
    if re.match(r"[a-z]+:", target):
        return ""
    path, _, anchor = unquote(target).partition("#")
    there = (page.parent / path).resolve() if path else page
    if not there.exists():
        return f"{target}: no such file"
    if anchor and anchor not in anchors(there):
        return f"{target}: no such heading; there are {sorted(anchors(there))}"
    return ""


@pytest.mark.parametrize("page", ALL, ids=name)
def test_links_lead_somewhere(page: Path) -> None:
    """Resolve every relative link and anchor of a page."""
    assert [b for t in LINK.findall(prose(page)) if (b := broken(page, t))] == []


@pytest.mark.parametrize("page", ALL, ids=name)
def test_commands_are_modules(page: Path) -> None:
    """Name only modules that `python -m` finds."""
    named = set(MODULE.findall(page.read_text("utf-8")))
    assert [m for m in sorted(named) if find_spec(m) is None] == []


@pytest.mark.parametrize("page", ALL, ids=name)
def test_commands_are_commands(page: Path) -> None:
    """Name only commands that `esg --help` lists."""
    assert set(COMMAND.findall(page.read_text("utf-8"))) <= set(COMMANDS)


def test_every_command_is_documented() -> None:
    """Describe each command of `esg --help` in docs/cli.md."""
    assert set(COMMANDS) <= set(COMMAND.findall((DOCS / "cli.md").read_text("utf-8")))


def test_code_names_pages_that_exist() -> None:
    """Name only pages that are there, also in docstrings and messages."""
    named = {(name(p), page) for p in SOURCES for page in NAMED.findall(p.read_text("utf-8"))}
    assert [n for n in sorted(named) if not (ROOT / n[1]).exists()] == []


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_paths_exist(page: Path) -> None:
    """Name only files and folders that are there."""
    named = set(PATH.findall(page.read_text("utf-8")))
    assert [p for p in sorted(named) if not (ROOT / p).exists()] == []


def resolves(dotted: str) -> bool:
    """Whether a dotted name is a module, or is defined in the module that its front part names."""
    parts = dotted.split(".")
    spec = find_spec(parts[0])
    for k in range(1, len(parts)):
        assert spec is not None and spec.origin is not None
        inner = spec.submodule_search_locations and find_spec(".".join(parts[: k + 1]))
        if not inner:
            return re.search(rf"\b{parts[k]}\b", Path(spec.origin).read_text("utf-8")) is not None
        spec = inner
    return True


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_names_of_code_exist(page: Path) -> None:
    """Name only modules, functions and classes that are there."""
    named = set(DOTTED.findall(page.read_text("utf-8")))
    assert [n for n in sorted(named) if not resolves(n)] == []


@pytest.mark.parametrize("page", [p for p in PAGES if DOCS / "results" not in p.parents], ids=name)
def test_concept_pages_are_short(page: Path) -> None:
    """Keep what explains to 1,500 words; tables of measurements belong under docs/results."""
    words = [w for w in page.read_text("utf-8").split() if any(c.isalnum() for c in w)]
    assert len(words) <= MOST_WORDS


def test_every_page_can_be_reached() -> None:
    """Lead from docs/index.md to every page, in some number of steps."""
    seen, ahead = set[Path](), [DOCS / "index.md"]
    while ahead:
        page = ahead.pop()
        if page in seen or page.suffix != ".md" or not page.exists():
            continue
        seen.add(page)
        targets = (t.partition("#")[0] for t in LINK.findall(prose(page)) if ":" not in t)
        ahead += [(page.parent / unquote(t)).resolve() for t in targets if t]
    assert [name(p) for p in PAGES if p not in seen] == []


def test_broken_links_are_told() -> None:
    """Tell a missing file and a missing heading from what is there."""
    index = DOCS / "index.md"
    assert broken(index, "no_such_page.md")
    assert broken(index, "cli.md#no-such-heading")
    assert not broken(index, "cli.md#conventions")
