"""Writing layouts: file after file, each whole or absent, then `layout.json`.

A layout that was interrupted goes on after its last whole file: files depend on the dataset alone.
One whose dataset has changed since, or that another version of this code began, is written anew.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
import json
from pathlib import Path
import shutil
from typing import Any

from esg.dataset.layouts.registry import LAYOUTS, Layout
from esg.dataset.layouts.source import Source
from esg.files import atomic_file, atomic_write, sha256_of, sweep
from esg.outcomes import UserError

FOLDER = "layouts"
DONE = "layout.json"
WANTED = Path("meta") / "layouts.json"
_BEGUN = ".begun.json"


class LayoutFolder:
    """The folder of a layout that is being written.

    Args:
        path: The folder.
        show: Told what is being written.
    """

    def __init__(self, path: Path, show: Callable[[str], object]) -> None:
        self.path = path
        self._show = show
        self._names: list[str] = []

    def add(self, name: str, write: Callable[[Path], object]) -> Path:
        """Has a file written, unless it was before.

        Args:
            name: Of the file, below the folder.
            write: Fills a temporary file; whatever it is called with, the content is the same.

        Raises:
            OSError: If the disk does not take it.
        """
        path = self.path / name
        self._names.append(name)
        if not path.is_file():
            self._show(f"{self.path.name}: {name}")
            atomic_write(path, write)
        return path

    def add_text(self, name: str, text: str) -> Path:
        """Has a text written, unless it was before."""
        return self.add(name, lambda path: path.write_bytes(text.encode()))

    def add_json(self, name: str, value: Any) -> Path:
        """Has a JSON document written, unless it was before."""
        return self.add_text(name, json.dumps(value, indent=2, sort_keys=True) + "\n")

    def files(self) -> dict[str, dict[str, Any]]:
        """Size and SHA-256 of every file, by name."""
        return {
            name: {
                "bytes": (self.path / name).stat().st_size,
                "sha256": sha256_of(self.path / name),
            }
            for name in sorted(self._names)
        }


def want_layouts(out: Path, names: Iterable[str]) -> tuple[str, ...]:
    """Remembers layouts of a dataset; returns all that are wanted, also those of earlier runs.

    Raises:
        OSError: If that cannot be written.
    """
    wanted = wanted_layouts(out)
    if not set(names) <= set(wanted):
        wanted = tuple(name for name in LAYOUTS if name in (*wanted, *names))
        with atomic_file(out / WANTED) as file:
            file.write((json.dumps(wanted) + "\n").encode())
    return wanted


def wanted_layouts(out: Path) -> tuple[str, ...]:
    """Layouts that a dataset was asked to have."""
    try:
        found = json.loads((out / WANTED).read_bytes())
    except (FileNotFoundError, NotADirectoryError, ValueError):
        return ()
    return tuple(name for name in LAYOUTS if name in found)


def missing_layouts(out: Path, names: Iterable[str]) -> list[str]:
    """Layouts among some that a finished dataset lacks, or that are not of its present content."""
    names = list(names)
    facts = {name: _facts(out / FOLDER / name) for name in names}
    if not any(facts.values()):
        return names
    digest = Source(out).digest()
    return [name for name in names if facts[name] != _beginning(LAYOUTS[name], digest)]


def _facts(folder: Path) -> dict[str, Any]:
    """Source and version of a layout that is complete; empty for others."""
    try:
        found = json.loads((folder / DONE).read_bytes())
        return {"source": found["source"], "version": found["version"]}
    except (OSError, ValueError, KeyError):
        return {}


def _beginning(layout: Layout, digest: str) -> dict[str, Any]:
    return {"source": digest, "version": layout.version}


def add_layouts(out: Path, names: Iterable[str], show: Callable[[str], object]) -> list[str]:
    """Writes the layouts that a finished dataset lacks.

    Args:
        out: Folder of the dataset.
        names: Of layouts.
        show: Told what is being written.

    Returns:
        Names of those that were written.

    Raises:
        UserError: If the dataset has no clips, or a disk does not take them; what is whole stays.
    """
    missing = missing_layouts(out, names)
    if not missing:
        return []
    source = Source(out)
    if not source.has_clips:
        raise UserError(no_clips(str(out), missing))
    digest = source.digest()
    for name in missing:
        try:
            _write(source, out / FOLDER / name, LAYOUTS[name], digest, show)
        except OSError as error:
            raise UserError(
                f"{error.filename or out / FOLDER / name}: {error.strerror or error}; the dataset "
                "is complete and what its layouts have is kept, run the same command with "
                "--resume to go on",
                exit_code=1,
            ) from None
    return missing


def no_clips(label: str, names: Iterable[str]) -> str:
    """What to say of a dataset that was not rendered."""
    return (
        f"--layout {','.join(names)}: these layouts hold clips, and {label} has none; render them "
        "with --render rgb,depth,segmentation, or leave --layout out"
    )


def _write(
    source: Source, path: Path, layout: Layout, digest: str, show: Callable[[str], object]
) -> None:
    begun, beginning = path / _BEGUN, _beginning(layout, digest)
    if not begun.is_file() or json.loads(begun.read_bytes() or b"{}") != beginning:
        shutil.rmtree(path, ignore_errors=True)
        with atomic_file(begun) as file:
            file.write(json.dumps(beginning).encode())
    (path / DONE).unlink(missing_ok=True)
    for inner in [path, *(p for p in path.rglob("*") if p.is_dir())]:
        sweep(inner, 0.0)
    folder = LayoutFolder(path, show)
    facts = layout.write(source, folder)
    whole = {
        "layout": path.name,
        "says": layout.says,
        **beginning,
        **facts,
        "files": folder.files(),
    }
    with atomic_file(path / DONE) as file:
        file.write((json.dumps(whole, indent=2, sort_keys=True) + "\n").encode())
    begun.unlink(missing_ok=True)
