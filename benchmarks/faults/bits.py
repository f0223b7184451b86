"""Single flipped bits by the thousand, read as commands read them but within this process.

`flips.py` asks whole commands, a second or more each; here the readers themselves are asked whether
they notice, or give what they gave before.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Generator
import contextlib
import hashlib
import logging
import os
from pathlib import Path
import random
import shutil

HEADS = ("file", "flips", "noticed", "no effect", "wrong")


class Noticed(Exception):
    """The reader says that the file is damaged, or makes it again."""


def _table(place: Path, path: Path) -> object:
    from esg.store import read_table

    return repr(read_table(path).to_pylist())


def _recording(place: Path, path: Path) -> object:
    from mcap.reader import make_reader

    from esg.store.checking import check_recording

    check_recording(path)
    with path.open("rb") as file:
        read = make_reader(file).iter_messages()
        return [(c.topic, m.log_time, hashlib.sha256(m.data).digest()) for _, c, m in read]


def _stage_result(place: Path, path: Path) -> object:
    from esg.store.artifacts import ArtifactStore

    home = next(p for p in path.parents if p.parent.parent.name == "artifacts")
    found = ArtifactStore(place / "cache" / "artifacts").find(home.name)
    if found is None:
        raise Noticed
    return [p.read_bytes() for p in sorted(found.rglob("*")) if p.is_file()]


def _class(place: Path, path: Path) -> object:
    """Which libraries would be loaded and linked, and what is in them."""
    from esg.compile import build

    root = place / "cache" / "classes"
    found = [build._cached(p.stem) for p in sorted(root.glob("*.ref"))]
    shims = [p for p in root.glob("include-*") if build._is_sound(p)]
    if None in found or not shims:
        raise Noticed
    return [lib.path.read_bytes() for lib in found if lib]


def _mark(place: Path, path: Path) -> object:
    from esg.dataset.folder import read_mark

    found = read_mark(place / "half", int(path.stem.rpartition("-")[2]))
    if found is None:
        raise Noticed
    return found


READERS: dict[str, tuple[str, Callable[[Path, Path], object]]] = {
    "Parquet, scenes": ("runs/parts/scenes/*.parquet", _table),
    "Parquet, metrics": ("runs/parts/metrics/*.parquet", _table),
    "Parquet, trajectories": ("runs/parts/trajectories/*.parquet", _table),
    "recordings (MCAP)": ("runs/*/rollout.mcap", _recording),
    "stage results": ("cache/artifacts/*/*/data/**/*", _stage_result),
    "marks of stage results": ("cache/artifacts/*/*/artifact.json", _stage_result),
    "compiled classes": ("cache/classes/**/*", _class),
    "marks of batches": ("half/marks/*.json", _mark),
}
"""Files, and who reads them."""


def flipped(
    seed: int, count: int, ground: Path, place: Path, name: str
) -> list[tuple[tuple[object, ...], str]]:
    """Flips bits of a kind of file, one at a time; each is taken back.

    Args:
        seed: Chooses files and bits.
        count: Of flips.
        ground: A prepared folder.
        place: Receives a copy of it.
        name: Of `READERS`.

    Returns:
        A row for `HEADS`, with what is wrong.
    """
    from benchmarks.faults.kills import prepared_copy

    prepared_copy(ground, place, "report")  # with the whole cache
    pattern, read = READERS[name]
    rng = random.Random(f"{seed} {name}")
    files = [p for p in sorted(place.glob(pattern)) if p.is_file() and p.stat().st_size]
    ends, wrong, sound = Counter[str](), list[str](), dict[Path, object]()
    logging.disable(logging.WARNING)  # "damaged: dropped" is what is wanted here
    with _cache(place / "cache"):
        for _ in range(count):
            path = rng.choice(files)
            if path not in sound:
                sound[path] = read(place, path)
            kept = path.read_bytes()
            at, bit = rng.randrange(len(kept)), rng.randrange(8)
            data = bytearray(kept)
            data[at] ^= 1 << bit
            path.write_bytes(data)
            end = _end(read, place, path, sound[path])
            ends[end] += 1
            if end == "wrong":
                wrong.append(f"{path.relative_to(place)} byte {at} bit {bit}")
            _restored(ground, place, path)
    cells = (name, count, ends["noticed"], ends["no effect"], len(wrong))
    return [(cells, "; ".join(wrong[:5]))]


def _end(read: Callable[[Path, Path], object], place: Path, path: Path, sound: object) -> str:
    from esg.outcomes import UserError

    try:
        return "no effect" if read(place, path) == sound else "wrong"
    except (Noticed, UserError):
        return "noticed"


def _restored(ground: Path, place: Path, path: Path) -> None:
    """Puts a file back; a reader may have taken its whole folder away."""
    folder = path.parent
    while not folder.exists():
        folder = folder.parent
    inner = path.relative_to(folder).parts[0]
    source = ground / folder.relative_to(place) / inner
    if source.is_dir():
        shutil.copytree(source, folder / inner)
    else:
        shutil.copyfile(source, folder / inner)


@contextlib.contextmanager
def _cache(folder: Path) -> Generator[None]:
    """Lets the readers in the body use a cache folder."""
    before = os.environ.get("ESG_CACHE_DIR")
    os.environ["ESG_CACHE_DIR"] = str(folder)
    try:
        yield
    finally:
        os.environ.pop("ESG_CACHE_DIR")
        if before is not None:
            os.environ["ESG_CACHE_DIR"] = before
