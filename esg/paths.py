"""Where the project keeps what can be recomputed: one cache folder, never the working directory."""

from __future__ import annotations

from importlib import metadata
import os
from pathlib import Path
import sys


def cache_dir() -> Path:
    """The cache folder; it is not created.

    `ESG_CACHE_DIR` wins; otherwise `XDG_CACHE_HOME`, or the platform's usual place, with `esg`
    below it.
    """
    explicit = os.environ.get("ESG_CACHE_DIR")
    if explicit:
        return Path(explicit).expanduser().resolve()
    return _user_cache() / "esg"


def _user_cache() -> Path:
    xdg = os.environ.get("XDG_CACHE_HOME")
    if xdg:
        return Path(xdg)
    home = Path.home()
    return home / "Library" / "Caches" if sys.platform == "darwin" else home / ".cache"


def kernel_cache_dir() -> Path:
    """Where warp keeps the kernels it compiled; found without importing it.

    `WARP_CACHE_PATH` wins; then `warp` in `ESG_CACHE_DIR`; otherwise the platform's usual place,
    which all that use warp share. Each version has its own folder.
    """
    explicit = os.environ.get("WARP_CACHE_PATH")
    if explicit:
        base = Path(explicit).resolve()
    else:
        base = (cache_dir() if os.environ.get("ESG_CACHE_DIR") else _user_cache()) / "warp"
    return base / metadata.version("warp-lang")


def kernels_compiled() -> bool:
    """Whether this machine has compiled the kernels of a search before (`esg setup`)."""
    try:
        return any(kernel_cache_dir().glob("wp_esg.engines.surrogate.kernels_*"))
    except OSError:
        return False
