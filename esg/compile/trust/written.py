"""Classes that this process has written itself."""

from __future__ import annotations

import hashlib

_MOST = 4096
_written: dict[str, None] = {}


def _key(name: str, header: str, source: str, imports: str) -> str:
    return hashlib.sha256("\0".join((name, header, source, imports)).encode()).hexdigest()


def remember(name: str, header: str, source: str, imports: str) -> None:
    """Notes that this process has written a class, given its name and its texts."""
    _written[_key(name, header, source, imports)] = None
    if len(_written) > _MOST:
        del _written[next(iter(_written))]


def is_remembered(name: str, header: str, source: str, imports: str) -> bool:
    """Whether this process has written a class, be it into another folder."""
    return _key(name, header, source, imports) in _written
