"""Compiles emitted classes with g++ under the shim, cached by content.

A library's key is the hash of the class's two files, the shim, the class that plays all scenes and
the compiler's version, so that an unchanged class is never compiled twice. What all classes share
is compiled once; several classes share a translation unit and all units a precompiled header.

Whatever the cache holds is loaded or linked only if it has the hash that was noted when it was
written; what a crash or a failing disk left damaged is compiled again.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
import errno
from functools import cache, lru_cache, partial
import hashlib
import json
import os
from pathlib import Path
import re
import shutil
import subprocess
import tempfile
import time
import uuid

from esg.compile.lint import ENGINE_HEADERS, PLAYER, generated_header, lint
from esg.files import is_intact, sha256_of, sync_file, sync_folder
from esg.outcomes import UserError

FLAGS = (
    "-std=c++20",
    "-Wall",
    "-Wextra",
    "-Werror",
    "-O0",
    "-fPIC",
    "-fvisibility=hidden",
    "-fno-gnu-unique",
)
CLASSES_PER_UNIT = 16
"""More classes save little more header time and make one failure cost more."""

_SHARED = {
    "UEShim.h": Path(__file__).parent / "shim" / "UEShim.h",
    "runtime.cpp": Path(__file__).parent / "shim" / "runtime.cpp",
    f"{PLAYER}.h": Path(__file__).parent / "unreal" / f"{PLAYER}.h",
    f"{PLAYER}.cpp": Path(__file__).parent / "unreal" / f"{PLAYER}.cpp",
}
"""What every class is compiled with: the stand-in for Unreal, and what plays all scenes."""
_OBJECTS = ("runtime.o", f"{PLAYER}.o")
_COMMON = "Common.h"
"""Includes what every unit begins with, and is precompiled."""
_KEY_LENGTH = 20
_EXPORT = '__attribute__((visibility("default")))'
_HASHES = "hashes.json"
_LIMITED = ("sh", "-c", 'ulimit -t 120 && ulimit -v 4194304 && exec "$0" "$@"')
"""Two minutes of processor time and 4 GiB, for what a stranger makes a compiler compute."""
_UNIT = re.compile(r"unit-[0-9a-f]{20}\.so")


class CompilerMissing(RuntimeError):
    """There is no C++ compiler: replay the control program instead and say so."""

    def __init__(self) -> None:
        super().__init__(
            "no g++ found: the emitted class cannot be compiled for replay. Install g++ 11 or "
            "newer, or set CXX; without it the control program is replayed instead."
        )


class ClassError(RuntimeError):
    """An emitted class breaks a rule or does not compile.

    Args:
        where: Its files.
        complaints: Every complaint, or the compiler's output as one.
    """

    def __init__(self, where: str, complaints: Sequence[str]) -> None:
        self.complaints = tuple(complaints)
        super().__init__(f"{where}: " + "; ".join(complaints))


@dataclass(frozen=True)
class ClassFiles:
    """The two files of one class.

    Args:
        folder: Where they came from, for messages.
        name: Class name without Unreal's A.
        header, source: Their text.
    """

    folder: str
    name: str
    header: str
    source: str

    @staticmethod
    def read(folder: Path) -> ClassFiles:
        """The class in `folder`/unreal.

        Raises:
            FileNotFoundError: If there is not exactly one header with its source.
            UserError: If they are no text.
        """
        headers = sorted((folder / "unreal").glob("*.h"))
        if len(headers) != 1:
            raise FileNotFoundError(f"{folder}/unreal holds {len(headers)} headers, expected one")
        source = headers[0].with_suffix(".cpp")
        try:
            texts = headers[0].read_text("utf-8"), source.read_text("utf-8")
        except UnicodeDecodeError as error:
            raise UserError(f"{folder}/unreal is damaged (no UTF-8 text: {error.reason})") from None
        return ClassFiles(str(folder), headers[0].stem, *texts)


@dataclass(frozen=True)
class Library:
    """A compiled class.

    Args:
        path: Shared library.
        create: Symbol of the function in it that makes an instance.
        seconds: Compile time, the class's share of its unit; 0 from the cache.
    """

    path: Path
    create: str
    seconds: float


def cache_dir() -> Path:
    """Folder of compiled classes: $ESG_CACHE_DIR or ~/.cache/esg, below it `classes`."""
    root = os.environ.get("ESG_CACHE_DIR")
    return (Path(root) if root else Path.home() / ".cache" / "esg") / "classes"


def compiler() -> str:
    """Path of the C++ compiler.

    Raises:
        CompilerMissing: If there is none.
    """
    found = shutil.which(os.environ.get("CXX") or "g++")
    if not found:
        raise CompilerMissing
    return found


@cache
def _compiler_version(path: str) -> str:
    done = subprocess.run([path, "--version"], capture_output=True, text=True, check=True)
    return done.stdout.splitlines()[0]


@cache
def _linker() -> tuple[str, ...]:
    """What asks the compiler for the quicker of the usual linkers, where the machine has it."""
    return ("-fuse-ld=gold",) if shutil.which("ld.gold") else ()


@cache
def shared_texts() -> Mapping[str, str]:
    """The files that every class is compiled with, by their names."""
    return {name: path.read_text("utf-8") for name, path in _SHARED.items()}


def _environment_key(cxx: str) -> str:
    parts = (*shared_texts().values(), _compiler_version(cxx), *FLAGS)
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:_KEY_LENGTH]


def class_key(files: ClassFiles, cxx: str) -> str:
    """Key of a compiled class: its text, the shim and the compiler."""
    parts = (_environment_key(cxx), files.name, files.header, files.source)
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:_KEY_LENGTH]


def compile_class(files: ClassFiles, *, limited: bool = False) -> Library:
    """Lints and compiles one class, or finds it in the cache.

    Args:
        files: The class.
        limited: Whether the compiler's time and memory are limited, for a stranger's class.

    Raises:
        CompilerMissing: Without a compiler.
        ClassError: If lint or the compiler complains.
    """
    result = compile_many([files], jobs=1, limited=limited)[0]
    if isinstance(result, Exception):
        raise result
    return result


def compile_many(
    classes: Sequence[ClassFiles | str | Path], jobs: int | None = None, *, limited: bool = False
) -> list[Library | ClassError]:
    """Compiles many classes: several to a unit, units in parallel.

    For batches: call it once with all folders of the batch, after their classes are written and
    before the first is replayed. `replay_class` then finds each library by the content of its
    class, wherever the folder has been moved to. Compared with one compilation per replay, a class
    costs 0.03 s of processor time instead of 0.2 s (docs/results/speed.md): the header of
    the shim is compiled once per machine, and up to sixteen classes share a unit.

        compile_many([state.artifact("compile") for state in batch], jobs=1)
        for state in batch:
            replay_class(state.artifact("compile"))

    Args:
        classes: Scene folders or classes, in any order; equal classes are compiled once.
        jobs: Parallel compilers; default the number of cores. Workers that share a machine should
            pass 1 each. Several processes may compile into one cache at a time.
        limited: As of `compile_class`.

    Returns:
        One entry per class, in order: its library, or what is wrong with it. One bad class, or one
        folder without a class, does not fail the others.

    Raises:
        CompilerMissing: Without a compiler.
    """
    cxx = compiler()
    read = [_read(c) for c in classes]
    keys = [class_key(c, cxx) if isinstance(c, ClassFiles) else str(c) for c in read]
    results: dict[str, Library | ClassError] = {}
    todo: dict[str, ClassFiles] = {}
    for key, files in zip(keys, read, strict=True):
        if key in results or key in todo:
            continue
        if isinstance(files, ClassError):
            results[key] = files
            continue
        complaints = _linted(files.header, files.source, files.name)
        if complaints:
            results[key] = ClassError(f"{files.folder}/unreal/{files.name}", complaints)
        elif (found := _cached(key)) is not None:
            results[key] = found
        else:
            todo[key] = files
    if todo:
        include = _include_dir(cxx)
        workers = jobs or os.cpu_count() or 1
        units = _units(todo, workers)
        with ThreadPoolExecutor(workers) as pool:
            for part in pool.map(partial(_compile_unit, cxx, include, limited), units):
                results.update(part)
    return [results[key] for key in keys]


@lru_cache(maxsize=4 * CLASSES_PER_UNIT)
def _linted(header: str, source: str, stem: str) -> tuple[str, ...]:
    """What lint says; a class is compiled with its batch and looked for again by its replay."""
    return tuple(lint(header, source, stem))


def _read(item: ClassFiles | str | Path) -> ClassFiles | ClassError:
    if isinstance(item, ClassFiles):
        return item
    try:
        return ClassFiles.read(Path(item))
    except (OSError, UnicodeDecodeError) as error:
        return ClassError(str(item), [f"no compiled scene: {error}"])


def _cached(key: str) -> Library | None:
    reference = cache_dir() / f"{key}.ref"
    try:
        name, digest = reference.read_text("ascii").split()
    except (OSError, ValueError):
        return None
    path = cache_dir() / name
    if not _UNIT.fullmatch(name) or not is_intact(path, digest):
        return None
    return Library(path, _entry(key), 0.0)


def _units(todo: dict[str, ClassFiles], jobs: int) -> list[list[tuple[str, ClassFiles]]]:
    """Groups of at most CLASSES_PER_UNIT classes, at least one group per job."""
    items = list(todo.items())
    size = max(1, min(CLASSES_PER_UNIT, -(-len(items) // jobs)))
    return [items[i : i + size] for i in range(0, len(items), size)]


def _compile_unit(
    cxx: str, include: Path, limited: bool, unit: list[tuple[str, ClassFiles]]
) -> dict[str, Library | ClassError]:
    start = time.perf_counter()
    root = cache_dir()
    names = "\0".join(key for key, _ in unit)
    target = root / f"unit-{hashlib.sha256(names.encode()).hexdigest()[:_KEY_LENGTH]}.so"
    with tempfile.TemporaryDirectory(dir=root, prefix="build-") as work:
        main: list[str] = []
        for number, (key, files) in enumerate(unit):
            entry = _entry(key)
            _write_class(Path(work, entry), files, number)
            # Renaming by macro lets classes of one name, such as seeds of a scene, share a unit
            # while their files stay as emitted.
            own = _own_names(files)
            main += [f"#define {name} {name}_{entry}" for name in own]
            main.append(f'#include "{entry}/{files.name}.cpp"')
            main.append(f'extern "C" {_EXPORT} AActor* {entry}() {{ return new A{files.name}; }}')
            main += [f"#undef {name}" for name in own]
        unit_cpp = Path(work, "unit.cpp")
        unit_cpp.write_text("\n".join(main) + "\n", "utf-8")
        built = Path(work, "unit.so")
        objects = [str(include / name) for name in _OBJECTS]
        command = [cxx, *FLAGS, "-shared", "-include", _COMMON, f"-I{include}", f"-I{work}",
                   str(unit_cpp), *objects, "-o", str(built)]  # fmt: skip
        command = [*(_LIMITED if limited else ()), *command]
        done = _linked(command)
        digest = ""
        if done.returncode == 0:
            digest = sha256_of(built)
            sync_file(built)
            os.replace(built, target)
            sync_folder(root)
    _check_room(done.stderr, root)
    if done.returncode != 0:
        if not _is_sound(include):
            # It was damaged under our hands: no fault of the class.
            return _compile_unit(cxx, _include_dir(cxx), limited, unit)
        if len(unit) > 1:
            # One bad class must not fail its neighbours: find it by compiling each alone.
            out: dict[str, Library | ClassError] = {}
            for item in unit:
                out.update(_compile_unit(cxx, include, limited, [item]))
            return out
        key, files = unit[0]
        message = _error_first(done.stderr.strip().replace(f"{work}/", ""))
        return {key: ClassError(f"{files.folder}/unreal/{files.name}.cpp", [message])}
    seconds = (time.perf_counter() - start) / len(unit)
    for key, _ in unit:
        _write(root / f"{key}.ref", f"{target.name} {digest}")
    return {key: Library(target, _entry(key), seconds) for key, _ in unit}


def _linked(command: list[str]) -> subprocess.CompletedProcess[str]:
    """Runs a compiler that links; the usual linker has the last word on what does not link."""
    done = subprocess.run([*command, *_linker()], capture_output=True, text=True, check=False)
    if done.returncode != 0 and _linker() and "collect2" in done.stderr:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done


def _error_first(said: str) -> str:
    """A compiler's output that begins with its first error, not with where that was included."""
    lines = said.splitlines()
    first = next((k for k, line in enumerate(lines) if re.search(r"\berror:", line)), 0)
    return "\n".join(lines[first:] + lines[:first])


def _check_room(said: str, folder: Path) -> None:
    """What a compiler says of a full disk is no fault of what it compiles.

    Raises:
        OSError: If its disk is full.
    """
    full = os.strerror(errno.ENOSPC)
    if full in said:
        raise OSError(errno.ENOSPC, full, str(folder))


def _own_names(files: ClassFiles) -> list[str]:
    """Everything at namespace scope that carries the class's name."""
    found = re.findall(rf"\b[A-Z]\w*?{files.name}\w*\b|\b{files.name}Detail\b", files.header)
    found += re.findall(rf"\b(?:Log{files.name}|{files.name}Detail)\b", files.source)
    return sorted(set(found))


def _entry(key: str) -> str:
    return f"esg_create_{key}"


def _write_class(folder: Path, files: ClassFiles, number: int) -> None:
    folder.mkdir()
    texts = {
        f"{files.name}.h": files.header,
        f"{files.name}.cpp": files.source,
        f"{files.name}.generated.h": generated_header(files.header, files.name),
    }
    for name, text in texts.items():
        path = folder / name
        path.write_text(text, "utf-8")
        # g++ takes files of equal content and time for one when it sees #pragma once.
        os.utime(path, (number + 1, number + 1))


def _write(path: Path, text: str) -> None:
    temporary = path.with_name(f"{path.name}.{os.getpid()}.tmp")
    temporary.write_text(text, "utf-8")
    os.replace(temporary, path)


def _include_dir(cxx: str) -> Path:
    """Folder with what every class shares, compiled, and a stub per engine header."""
    root = cache_dir()
    root.mkdir(parents=True, exist_ok=True)
    folder = root / f"include-{_environment_key(cxx)}"
    if _is_sound(folder):
        return folder
    with tempfile.TemporaryDirectory(dir=root, prefix="include-build-") as work:
        build = Path(work, "include")
        build.mkdir()
        shared = shared_texts()
        texts = {
            **shared,
            f"{PLAYER}.generated.h": generated_header(shared[f"{PLAYER}.h"], PLAYER),
            _COMMON: f'#include "{PLAYER}.h"\n',
        }
        for name, text in texts.items():
            (build / name).write_text(text, "utf-8")
        for name in sorted(ENGINE_HEADERS):
            stub = build / name
            stub.parent.mkdir(parents=True, exist_ok=True)
            stub.write_text('#pragma once\n#include "UEShim.h"\n', "utf-8")
        for arguments in (
            ["-x", "c++-header", _COMMON, "-o", f"{_COMMON}.gch"],
            ["-c", "runtime.cpp", "-o", "runtime.o"],
            ["-c", f"{PLAYER}.cpp", "-o", f"{PLAYER}.o"],
        ):
            command = [cxx, *FLAGS, *arguments]
            done = subprocess.run(command, cwd=build, capture_output=True, text=True, check=False)
            _check_room(done.stderr, folder.parent)
            if done.returncode != 0:
                raise RuntimeError(f"{cxx} cannot compile the shim: {done.stderr.strip()}")
        hashes = {name: sha256_of(build / name) for name in _include_files()}
        (build / _HASHES).write_text(json.dumps(hashes), "ascii")
        for name in (*hashes, _HASHES):
            sync_file(build / name)
        try:
            os.rename(build, folder)
        except OSError:
            # Another process finished first, or what is there is damaged.
            if _is_sound(folder):
                return folder
            os.rename(folder, Path(work, f"damaged-{uuid.uuid4().hex}"))
            os.rename(build, folder)
        sync_folder(root)
    return folder


def _include_files() -> list[str]:
    own = (*_SHARED, *_OBJECTS, f"{PLAYER}.generated.h", _COMMON, f"{_COMMON}.gch")
    return [*ENGINE_HEADERS, *own]


def _is_sound(folder: Path) -> bool:
    """Whether the shim's folder is complete and every file in it as it was written."""
    try:
        hashes = json.loads((folder / _HASHES).read_bytes())
        return sorted(hashes) == sorted(_include_files()) and all(
            is_intact(folder / name, digest) for name, digest in hashes.items()
        )
    except (OSError, ValueError, TypeError):
        return False


def read_classes(folders: Iterable[Path]) -> list[ClassFiles]:
    """The classes of many scene folders."""
    return [ClassFiles.read(Path(folder)) for folder in folders]
