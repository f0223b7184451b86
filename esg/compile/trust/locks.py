"""What a process takes from itself, for good, before it runs code that nobody vouches for.

Three locks, each used where the system has it and none of which needs privileges:

- limits (POSIX): memory, processor time, no files written, few open, no core dump;
- files (Linux 5.13 and later, landlock): nothing is read but code, nothing written, no TCP, no
  signals to others;
- calls (Linux on x86-64, seccomp): a short list of system calls; no network, no new processes or
  programs, no file opened for writing.

Where there is no filter of calls, a namespace of its own cuts the network off if it may be had.
"""

from __future__ import annotations

from collections.abc import Sequence
import contextlib
import ctypes as C
import os
from pathlib import Path
import platform
import signal
import struct
import sys

LIMITS, FILES, CALLS, NETWORK = "limits", "files", "calls", "network"

_OPEN_FILES = 64
_PR_SET_PDEATHSIG, _PR_SET_DUMPABLE, _PR_SET_SECCOMP, _PR_SET_NO_NEW_PRIVS = 1, 4, 22, 38
_CLONE_NEWUSER, _CLONE_NEWNET, _CLONE_THREAD = 0x10000000, 0x40000000, 0x00010000

_CREATE_RULESET, _ADD_RULE, _RESTRICT_SELF = 444, 445, 446
_READ_FILE, _READ_DIR = 1 << 2, 1 << 3
_FILE_RIGHTS = {1: (1 << 13) - 1, 2: (1 << 14) - 1, 3: (1 << 15) - 1, 5: (1 << 16) - 1}
"""Rights that landlock knows of files, by the first version of its interface that has them."""
_NET_RIGHTS, _NET_ABI = 0b11, 4
_SCOPES, _SCOPE_ABI = 0b11, 6

_X86_64 = 0xC000003E
_ALLOWED = {
    "read": 0, "write": 1, "close": 3, "fstat": 5, "lseek": 8, "mmap": 9, "mprotect": 10,
    "munmap": 11, "brk": 12, "rt_sigaction": 13, "rt_sigprocmask": 14, "rt_sigreturn": 15,
    "pread64": 17, "writev": 20, "access": 21, "sched_yield": 24, "mremap": 25, "madvise": 28,
    "nanosleep": 35,
    "getpid": 39, "exit": 60, "uname": 63, "getcwd": 79, "readlink": 89, "gettimeofday": 96,
    "getrusage": 98, "sysinfo": 99, "times": 100, "getuid": 102, "getgid": 104, "geteuid": 107,
    "getegid": 108, "getppid": 110, "sigaltstack": 131, "arch_prctl": 158, "gettid": 186,
    "time": 201, "futex": 202, "sched_getaffinity": 204, "getdents64": 217, "restart_syscall": 219,
    "clock_gettime": 228, "clock_getres": 229, "clock_nanosleep": 230, "exit_group": 231,
    "newfstatat": 262, "readlinkat": 267, "faccessat": 269, "set_robust_list": 273,
    "getrandom": 318, "membarrier": 324, "statx": 332, "rseq": 334, "faccessat2": 439,
}  # fmt: skip
"""System calls of x86-64 (arch/x86/entry/syscalls/syscall_64.tbl) that a replay may make."""
_OPENAT, _CLONE, _CLONE3, _TGKILL = 257, 56, 435, 234
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
_LOAD, _JEQ, _JGE, _JSET, _RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
_PASS, _REFUSE, _ABSENT, _KILL = 0x7FFF0000, 0x00050001, 0x00050026, 0x80000000


class _Program(C.Structure):
    _fields_ = [("length", C.c_ushort), ("filter", C.c_char_p)]


def lock(memory_bytes: int, seconds: int, readable: Sequence[Path]) -> tuple[str, ...]:
    """Locks this process in; there is no way back.

    Args:
        memory_bytes: Address space that it may take beyond what it has.
        seconds: Of processor time from now on.
        readable: Files and folders that stay readable where files can be locked.

    Returns:
        The locks that hold here.
    """
    held = [LIMITS] if _limit(memory_bytes, seconds) else []
    if os.uname().sysname != "Linux":
        return tuple(held)
    libc = C.CDLL(None, use_errno=True)
    libc.prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    libc.prctl(_PR_SET_DUMPABLE, 0, 0, 0, 0)
    if not calls_can_be_filtered() and libc.unshare(_CLONE_NEWUSER | _CLONE_NEWNET) == 0:
        held.append(NETWORK)
    if libc.prctl(_PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0:
        return tuple(held)
    if _lock_files(libc, readable):
        held.append(FILES)
    if calls_can_be_filtered() and _filter_calls(libc):
        held.append(CALLS)
    return tuple(held)


def available() -> tuple[str, ...]:
    """The locks that this machine has; asking takes nothing from the process."""
    held = [LIMITS]
    if sys.platform == "linux":
        held += [FILES] if _landlock_abi(C.CDLL(None, use_errno=True)) > 0 else []
        held += [CALLS] if calls_can_be_filtered() else []
    return tuple(held)


def calls_can_be_filtered() -> bool:
    """Whether the filter of system calls is written for this machine."""
    return sys.platform == "linux" and platform.machine() == "x86_64" and C.sizeof(C.c_void_p) == 8


def _limit(memory_bytes: int, seconds: int) -> bool:
    import resource

    used = 0
    with contextlib.suppress(OSError, ValueError, IndexError):
        pages = int(Path("/proc/self/statm").read_text().split()[0])
        used = pages * os.sysconf("SC_PAGE_SIZE")
    spent = resource.getrusage(resource.RUSAGE_SELF)
    cpu = int(spent.ru_utime + spent.ru_stime) + seconds
    wanted = {
        resource.RLIMIT_AS: used + memory_bytes,
        resource.RLIMIT_CPU: cpu,
        resource.RLIMIT_FSIZE: 0,
        resource.RLIMIT_NOFILE: _OPEN_FILES,
        resource.RLIMIT_CORE: 0,
    }
    for kind, value in wanted.items():
        hard = resource.getrlimit(kind)[1]
        most = value if hard == resource.RLIM_INFINITY else min(value, hard)
        with contextlib.suppress(OSError, ValueError):  # not every system knows every limit
            resource.setrlimit(kind, (most, most))
    return True


def _landlock_abi(libc: C.CDLL) -> int:
    return libc.syscall(_CREATE_RULESET, None, C.c_size_t(0), 1)


def _lock_files(libc: C.CDLL, readable: Sequence[Path]) -> bool:
    abi = _landlock_abi(libc)
    if abi < 1:
        return False
    rights = _FILE_RIGHTS[max(version for version in _FILE_RIGHTS if version <= abi)]
    fields = [rights]
    fields += [_NET_RIGHTS] if abi >= _NET_ABI else []
    fields += [_SCOPES] if abi >= _SCOPE_ABI else []
    attributes = struct.pack(f"={len(fields)}Q", *fields)
    rules = libc.syscall(_CREATE_RULESET, attributes, C.c_size_t(len(attributes)), 0)
    if rules < 0:
        return False
    for path in readable:
        try:
            folder = path.is_dir()
            handle = os.open(path, os.O_PATH | os.O_CLOEXEC)
        except OSError:
            continue  # what is not there needs no rule
        rule = struct.pack("=Qi", _READ_FILE | (_READ_DIR if folder else 0), handle)
        libc.syscall(_ADD_RULE, rules, 1, rule, 0)
        os.close(handle)
    locked = libc.syscall(_RESTRICT_SELF, rules, 0) == 0
    os.close(rules)
    return locked


def _filter_calls(libc: C.CDLL) -> bool:
    code = _filter(os.getpid())
    program = _Program(len(code) // 8, code)
    return libc.prctl(_PR_SET_SECCOMP, 2, C.byref(program), 0, 0) == 0


def _filter(pid: int) -> bytes:
    """The filter as instructions of the kernel's packet filter (linux/filter.h)."""

    def step(code: int, value: int, then: int = 0, otherwise: int = 0) -> bytes:
        return struct.pack("=HBBI", code, then, otherwise, value)

    def only_if(call: int, test: int, value: int, argument: int, holds: int, fails: int) -> bytes:
        """Of one call: a test of the lower half of an argument decides."""
        return b"".join(
            [
                step(_JEQ, call, 0, 4),
                step(_LOAD, 16 + 8 * argument),
                step(test, value, 0, 1),
                step(_RETURN, holds),
                step(_RETURN, fails),
            ]
        )

    parts = [
        step(_LOAD, 4),
        step(_JEQ, _X86_64, 1, 0),
        step(_RETURN, _KILL),
        step(_LOAD, 0),
        step(_JGE, 0x40000000, 0, 1),  # the 32-bit pointers' calls
        step(_RETURN, _REFUSE),
        only_if(_OPENAT, _JSET, _WRITING, 2, _REFUSE, _PASS),
        only_if(_CLONE, _JSET, _CLONE_THREAD, 0, _PASS, _REFUSE),
        only_if(_TGKILL, _JEQ, pid, 0, _PASS, _REFUSE),
        step(_JEQ, _CLONE3, 0, 1),
        step(_RETURN, _ABSENT),  # the C library falls back on clone
    ]
    for number in _ALLOWED.values():
        parts += [step(_JEQ, number, 0, 1), step(_RETURN, _PASS)]
    return b"".join([*parts, step(_RETURN, _REFUSE)])
