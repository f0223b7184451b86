"""Where the project keeps what can be recomputed: one cache folder, never the working directory."""

from __future__ import annotations

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
    xdg = os.environ.get("XDG_CACHE_HOME")
    if xdg:
        return Path(xdg) / "esg"
    home = Path.home()
    return (home / "Library" / "Caches" if sys.platform == "darwin" else home / ".cache") / "esg"
