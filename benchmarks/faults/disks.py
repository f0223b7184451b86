"""Full and read-only disks: told in a message with exit code 1 or 2; with room, all is as ever."""

from __future__ import annotations

from collections.abc import Callable
import ctypes
from functools import cache
import os
from pathlib import Path
import random
import resource
import subprocess

from benchmarks.faults.ground import Ended, esg
from benchmarks.faults.kills import Sound, arguments, difference, facts, prepared_copy, undisturbed

HEADS = ("command", "disk", "runs", "exit codes", "wrong")
PATIENCE_S = 180.0
_SMALL = 2**19
_NEW_MOUNTS = 0x00020000

Row = tuple[tuple[object, ...], str]
Made = Callable[[], tuple[int | None, str]]


def filled(seed: int, count: int, ground: Path, place: Path, name: str) -> list[Row]:
    """A command on disks that fill up, and on one that is read-only.

    Args:
        seed: Chooses when they are full.
        count: Disks that fill up.
        ground: A prepared folder.
        place: Where it happens; disks are mounted there, where that is allowed.
        name: Of `kills.COMMANDS`.

    Returns:
        Rows for `HEADS`, each with what is wrong.
    """
    sound = undisturbed(name, 1, ground, place / "sound")
    before = _size(prepared_copy(ground, place / "before", name))
    made = max(_size(place / "sound") - before, 2**20)
    rng = random.Random(f"{seed} {name}")
    # Only databases and films are large: small limits are the ones that are felt.
    small = [rng.randrange(_SMALL) for _ in range(count)]
    told = {"no large files": [_no_large_files(name, ground, place, s, sound) for s in small]}
    if _may_mount():
        rooms = [rng.randrange(made) for _ in range(count)]
        told["full"] = [_mounted(name, ground, place, room, sound) for room in rooms]
        told["read-only"] = [_mounted(name, ground, place, None, sound)]
    rows: list[Row] = []
    for disk, ends in told.items():
        wrong = [fault for _, fault in ends if fault]
        codes = " ".join(sorted(str(code) for code, _ in ends))
        cells = (name, disk, len(ends), codes, len(wrong))
        rows.append((cells, "\n    ".join(f"{name}, {disk}: {fault}" for fault in wrong)))
    return rows


def _no_large_files(
    name: str, ground: Path, place: Path, most: int, sound: Sound
) -> tuple[int | None, str]:
    """No file may grow beyond a size: needs no privileges."""
    work = prepared_copy(ground, place / "it", name)
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, before[1]))
    try:
        ended = esg(arguments(name, work), work, work / "cache", PATIENCE_S)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    return ended.code, _judged(name, ended, work, sound)


def _mounted(
    name: str, ground: Path, place: Path, room: int | None, sound: Sound
) -> tuple[int | None, str]:
    """A disk of its own with little room [bytes], or one that is read-only."""
    disk = place / "disk"
    disk.mkdir(parents=True, exist_ok=True)
    _mount("-t", "tmpfs", "-o", "size=8g", "none", str(disk))
    try:
        work = prepared_copy(ground, disk / "it", name)
        (work / "tmp").mkdir()
        blocks = os.statvfs(disk)
        used = (blocks.f_blocks - blocks.f_bfree) * blocks.f_frsize
        _mount("-o", "remount,ro" if room is None else f"remount,size={used + room}", str(disk))
        ended = esg(arguments(name, work), work, work / "cache", PATIENCE_S)
        _mount("-o", "remount,rw,size=8g", str(disk))
        return ended.code, _judged(name, ended, work, sound)
    finally:
        subprocess.run(["umount", "-l", str(disk)], check=False)


def _judged(name: str, ended: Ended, work: Path, sound: Sound) -> str:
    """What is wrong with how a command ended, or with its end once there is room."""
    if fault := ended.wrong((0, 1, 2)):
        return fault
    if ended.code == 0 and (end := difference(sound[0], facts(work), "")) != "same":
        return f"done, it said, but {end}"
    again = esg(arguments(name, work), work, work / "cache")
    if fault := again.wrong((0, 3)):
        return f"with room again: {fault}"
    end = difference(sound[0], facts(work), name)
    return "" if end == "same" else f"with room again {end}"


def _size(folder: Path) -> int:
    return sum(p.stat().st_size for p in folder.rglob("*") if p.is_file())


def _mount(*arguments: str) -> None:
    subprocess.run(["mount", *arguments], check=True, capture_output=True)


@cache
def _may_mount() -> bool:
    """Whether this process may mount disks, which nobody else sees and which end with it."""
    libc = ctypes.CDLL(None, use_errno=True)
    if os.geteuid() != 0 or libc.unshare(_NEW_MOUNTS) != 0:
        return False
    try:
        _mount("--make-rprivate", "/")
    except (OSError, subprocess.CalledProcessError):
        return False
    return True
