"""A dataset at a URL (`s3://bucket/name` and whatever else Arrow or fsspec reach).

Work happens in a folder on this machine; finished batches go to the URL, parts first, the mark
last, so that the URL alone says what is done: any machine can go on with it. Objects appear whole
or not at all, which is what object stores promise of a put.
"""

from __future__ import annotations

from collections.abc import Generator, Iterable
import contextlib
import hashlib
from pathlib import Path
import re
from typing import Any
from urllib.parse import unquote, urlsplit

from esg.outcomes import UserError

_FIRST = ("meta/plan.json", "meta/prompts.jsonl", "meta/run.json", "meta/layouts.json")
_INFO = "meta/info.json"
_TOLD = ("README.md", "sheet.jpg", "failures.jsonl", "meta/timings.json")


def is_url(text: str) -> bool:
    """Whether an --out names a remote place."""
    return "://" in text


def checked_place(text: str) -> str:
    """An --out as a path or a URL; `file://` URLs become paths.

    Raises:
        UserError: If it is neither, such as s3:/name.
    """
    scheme, _, rest = text.partition(":/")
    if not rest or not re.fullmatch(r"[a-z][a-z0-9+.-]+", scheme):
        return text
    if scheme == "file":
        return unquote(urlsplit(text).path)
    if not rest.startswith("/"):
        raise UserError(
            f"--out {text}: a URL has two slashes ({scheme}://...), a folder is meant by ./{text}"
        )
    return text


def is_media(name: str) -> bool:
    """Whether a file of a dataset is one of a clip's: they are large, and no table."""
    return name.startswith("clips/") and name.count("/") > 1


def staging_folder(url: str) -> Path:
    """The folder on this machine in which a dataset at a URL is made."""
    from esg.paths import cache_dir

    return cache_dir() / "datasets" / hashlib.sha256(url.encode()).hexdigest()[:16]


class Remote:
    """A folder at a URL.

    Args:
        url: As `pyarrow.fs.FileSystem.from_uri` takes it; options go into its query, such as
            `s3://bucket/name?endpoint_override=localhost:9000&scheme=http`. Credentials come from
            the environment, as usual for the service.

    Raises:
        UserError: If nothing can reach such a URL.
    """

    def __init__(self, url: str) -> None:
        import pyarrow as pa
        from pyarrow import fs

        self.url = url
        try:
            self._fs, self._base = fs.FileSystem.from_uri(url)
        except (pa.ArrowException, OSError, ValueError) as first:
            self._fs, self._base = self._through_fsspec(url, first)

    def _through_fsspec(self, url: str, first: BaseException) -> tuple[Any, str]:
        from pyarrow import fs

        try:
            from fsspec.core import url_to_fs

            found, path = url_to_fs(url)
        except (ImportError, ValueError):
            raise UserError(f"--out {url}: {first}") from None
        return fs.PyFileSystem(fs.FSSpecHandler(found)), path

    def below(self, folder: str) -> Remote:
        """A folder of this one."""
        path, query, rest = self.url.partition("?")
        return Remote(f"{path.rstrip('/')}/{folder}{query}{rest}")

    def has(self, name: str) -> bool:
        """Whether an object exists.

        Raises:
            UserError: If the place cannot be asked.
        """
        from pyarrow import fs

        with self._explained():
            return self._fs.get_file_info(self._path(name)).type == fs.FileType.File

    def names(self, folder: str) -> list[str]:
        """Objects below a folder, relative to the dataset.

        Raises:
            UserError: If the place cannot be asked.
        """
        from pyarrow import fs

        selector = fs.FileSelector(self._path(folder), allow_not_found=True, recursive=True)
        with self._explained():
            found = self._fs.get_file_info(selector)
        start = len(self._base.rstrip("/")) + 1
        return sorted(f.path[start:] for f in found if f.type == fs.FileType.File)

    def push(self, folder: Path, names: Iterable[str]) -> None:
        """Uploads files, in the order given.

        Raises:
            UserError: If that fails; what was uploaded before stays.
        """
        for name in names:
            with self._explained():
                # Object stores have no folders; file systems want them.
                self._fs.create_dir(self._path(name).rsplit("/", 1)[0], recursive=True)
                with (
                    (folder / name).open("rb") as source,
                    self._fs.open_output_stream(self._path(name)) as target,
                ):
                    while block := source.read(1 << 22):
                        target.write(block)

    def pull(self, folder: Path, names: Iterable[str]) -> None:
        """Downloads files that the folder lacks, each whole or not at all.

        Raises:
            UserError: If that fails.
        """
        from esg.files import atomic_file

        for name in names:
            if (folder / name).is_file():
                continue
            with self._explained(), self._fs.open_input_stream(self._path(name)) as source:
                data = source.read()
            with atomic_file(folder / name) as file:
                file.write(data)

    def pull_beginning(self, folder: Path) -> None:
        """What a run has to know before it starts: plan, prompts, run, and whether all is done.

        What the URL has wins over what this machine remembers: a URL that was emptied is a new one.
        """
        import shutil

        if not self.has(_FIRST[0]):
            shutil.rmtree(folder, ignore_errors=True)
            if left := self.names(""):
                raise UserError(f"{self.url} holds files but no dataset ({left[0]}, ...)")
            return
        for name in (*_FIRST, _INFO):
            (folder / name).unlink(missing_ok=True)
        self.pull(folder, [n for n in (*_FIRST, _INFO) if self.has(n)])
        if (folder / _INFO).is_file():
            self._remove_scaffold()

    def push_beginning(self, folder: Path) -> None:
        """Plan, prompts and run, the plan last."""
        self.push(folder, [n for n in reversed(_FIRST) if (folder / n).is_file()])

    def push_dataset(self, folder: Path) -> None:
        """Uploads a finished dataset, `meta/info.json` last, and removes its scaffold there.

        Files of clips came with their batches.
        """
        names = [
            p.relative_to(folder).as_posix()
            for p in sorted(folder.rglob("*"))
            if p.is_file() and not p.name.startswith(".")
        ]
        self.push(folder, [n for n in names if n != _INFO and not is_media(n)])
        self.push(folder, [_INFO])
        self._remove_scaffold()

    def pull_tables(self, folder: Path) -> None:
        """Downloads the tables of a finished dataset, without the files of clips."""
        there = self.names("")
        tables = [n for n in there if n.endswith(".parquet") and n.count("/") == 1]
        self.pull(folder, [*tables, *(n for n in _TOLD if n in there)])

    def push_clips(self, folder: Path, tables: Iterable[str], scaffold: str) -> None:
        """Uploads what tells of a dataset's new clips, whose files came with their batches.

        Layouts are of the clips it had: they are removed.

        Args:
            folder: Of the dataset on this machine.
            tables: That have changed.
            scaffold: Folder of the rendering, which is removed.
        """
        files = [p for table in tables for p in sorted((folder / table).glob("*.parquet"))]
        names = [p.relative_to(folder).as_posix() for p in files]
        told = [n for n in _TOLD if (folder / n).is_file()]
        self.push(folder, [*names, *told, _FIRST[0], _INFO])
        self._remove([*self.names(scaffold), *self.names("layouts")])
        stale = [n for t in tables for n in self.names(t) if not is_media(n) and n not in names]
        self._remove(stale)

    def _remove(self, names: Iterable[str]) -> None:
        for name in names:
            with self._explained():
                self._fs.delete_file(self._path(name))

    def _remove_scaffold(self) -> None:
        for scaffold in ("parts", "marks"):
            self._remove(self.names(scaffold))

    def _path(self, name: str) -> str:
        return f"{self._base.rstrip('/')}/{name}".rstrip("/")

    @contextlib.contextmanager
    def _explained(self) -> Generator[None]:
        import pyarrow as pa

        try:
            yield
        except (pa.ArrowException, OSError) as error:
            reason = str(error).splitlines()[0] if str(error) else type(error).__name__
            raise UserError(
                f"{self.url}: {reason}; check the address, your permissions and credentials, then "
                "go on with --resume",
                exit_code=1,
            ) from None
