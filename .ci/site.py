"""What the site has that `docs/` has not: the files beside it, and links that lead out of it."""

from __future__ import annotations

from pathlib import Path, PurePosixPath
import re
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

ROOT = Path(__file__).parents[1]
BESIDE = {
    "README.md": "overview.md",  # MkDocs would make it the index
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "SECURITY.md": "security.md",
}
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Adds the pages that lie beside `docs/`."""
    for name, page in BESIDE.items():
        text = (ROOT / name).read_text("utf-8")
        files.append(File.generated(config, page, content=text))
    return files


def on_page_markdown(markdown: str, page: Any, config: MkDocsConfig, files: Files) -> str:
    """Leads links of pages and of files beside `docs/` to where the site has them.

    What the site does not hold (sources, data) becomes its name.
    """
    here = PurePosixPath(page.file.src_uri)
    beside = here.name in BESIDE.values()
    folder = PurePosixPath() if beside else PurePosixPath("docs") / here.parent

    def led(found: re.Match[str]) -> str:
        picture, text, target = found.groups()
        if ":" in target.partition("#")[0] or target.startswith("#"):
            return found[0]
        path, mark, anchor = target.partition("#")
        there = _joined(folder, path)
        inside = BESIDE.get(there) or there.removeprefix("docs/")
        if there != inside and files.get_file_from_path(inside):
            up = "../" * (len(here.parts) - 1)
            return f"{picture}[{text}]({up}{inside}{mark}{anchor})"
        return f"{text} (`{there}`)" if (ROOT / there).exists() else found[0]

    return LINK.sub(led, markdown)


def _joined(folder: PurePosixPath, path: str) -> str:
    parts: list[str] = []
    for part in (folder / path).parts:
        if part == "..":
            parts = parts[:-1]
        else:
            parts.append(part)
    return "/".join(parts)
