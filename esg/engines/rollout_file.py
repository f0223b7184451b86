"""A rollout as one file: the exact arrays, so that judging later sees what the engine gave."""

from __future__ import annotations

from pathlib import Path
import zipfile

import numpy as np

from esg.engines.scene import ContactLog, Rollout
from esg.strangers.arrays import check_npz

_ARRAYS = ("time", "position", "quaternion", "linear_velocity", "angular_velocity", "valid")
MOST_BYTES = 2**30
"""Of all arrays of a rollout: an hour of fifteen bodies."""
_EPOCH = (1980, 1, 1, 0, 0, 0)


def save_rollout(rollout: Rollout, path: Path) -> None:
    """Writes a rollout; equal rollouts give equal bytes. `extra` is not kept.

    Args:
        rollout: Any number of worlds.
        path: Of the file (`.npz`).
    """
    arrays = {name: getattr(rollout, name) for name in _ARRAYS}
    for name in ContactLog.__dataclass_fields__:
        arrays[f"contacts.{name}"] = getattr(rollout.contacts, name)
    arrays["engine"] = np.array(rollout.engine)
    arrays["dt"] = np.array(rollout.dt)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for name, array in arrays.items():
            # numpy.savez stamps the wall clock into the archive; a fixed date keeps it equal.
            with archive.open(zipfile.ZipInfo(f"{name}.npy", _EPOCH), "w", force_zip64=True) as out:
                np.lib.format.write_array(out, np.asarray(array), allow_pickle=False)


def load_rollout(path: Path) -> Rollout:
    """Reads what `save_rollout` wrote.

    Raises:
        ValueError: If its arrays are not what they say, or too large.
    """
    check_npz(path, MOST_BYTES)
    with np.load(path, allow_pickle=False) as data:
        contacts = {n: data[f"contacts.{n}"] for n in ContactLog.__dataclass_fields__}
        return Rollout(
            engine=str(data["engine"]),
            dt=float(data["dt"]),
            **{name: data[name] for name in _ARRAYS},
            contacts=ContactLog(**contacts),
        )
