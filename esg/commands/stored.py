"""Scenes by folder, by id below ./runs or by key in the run database, as a folder to work on."""

from __future__ import annotations

from collections.abc import Generator
import contextlib
from pathlib import Path
from typing import Any

_KEY_FILE = ".scene_key"


@contextlib.contextmanager
def open_scene(scene: str, *, meshes: bool = False, whole: bool = True) -> Generator[Path]:
    """Folder of a scene.

    A scene of the database is compiled again from its stored document, into a folder that is gone
    after the body: equal documents give equal bytes.

    Args:
        scene: Scene folder, id of one below ./runs, or scene key (`RUN/SUITE/SCENE/SEED`) or scene
            id in the run database.
        meshes: Whether a scene of the database gets its mesh files too.
        whole: As of `find_scene`.

    Raises:
        UserError: If there is no such scene, the id names several, or it was never solved.
    """
    import tempfile

    from esg.api.inputs import find_scene
    from esg.notices import warn
    from esg.outcomes import UserError
    from esg.strangers.sums import altered

    try:
        folder = find_scene(scene, whole=whole)
    except UserError as error:
        row = None if Path(scene).exists() or "ambiguous" in str(error) else stored_row(scene)
        if row is None:
            raise
        with tempfile.TemporaryDirectory(prefix="esg-scene-") as work:
            folder = Path(work)
            _materialize(row, folder, meshes)
            yield folder
        return
    warn(altered(folder))
    yield folder


def is_stored(folder: Path) -> bool:
    """Whether a folder of `open_scene` holds a scene of the run database."""
    return (folder / _KEY_FILE).is_file()


def stored_key(folder: Path) -> str:
    """Key of the scene of the run database in a folder of `open_scene`."""
    return (folder / _KEY_FILE).read_text(encoding="utf-8").strip()


def stored_row(scene: str) -> dict[str, Any] | None:
    """A scene's row of the run database: scene_key, prompt, document; None if there is none.

    Raises:
        UserError: If the id names several scenes, or the scene has no final document.
    """
    from esg.outcomes import UserError
    from esg.runs import database_path
    from esg.store import query

    db = database_path()
    if not db.exists():
        return None
    text = scene.replace("'", "''")
    columns = "scene_key, prompt, esg_optimize, outcome"
    for column in ("scene_key", "scene_id"):
        result = query(db, f"SELECT {columns} FROM scenes WHERE {column} = '{text}'")
        rows = result.dicts()
        if len(rows) > 1:
            keys = ", ".join(sorted(str(r["scene_key"]) for r in rows)[:5])
            raise UserError(f"{scene!r} names {len(rows)} stored scenes; give a key, e.g. {keys}")
        if rows:
            if not rows[0]["esg_optimize"]:
                raise UserError(
                    f"stored scene {scene!r} ended {rows[0]['outcome']} before it was compiled"
                )
            return rows[0]
    return None


def stored_rollout(key: str) -> Any:
    """The stored trajectory of a scene as a rollout of one world, None if none was stored.

    Points and normals of contacts are zero where an older version stored them.

    Args:
        key: Scene key.
    """
    import numpy as np
    import pyarrow.parquet as pq

    from esg.engines.scene import ContactLog, Rollout
    from esg.runs import database_path
    from esg.store import query

    text = key.replace("'", "''")
    found = query(
        database_path(),
        f"SELECT file, engine FROM trajectories WHERE scene_key = '{text}' ORDER BY engine",
    ).dicts()
    found = [f for f in found if Path(f["file"]).is_file()]
    if not found:
        return None
    wanted = [("scene_key", "=", key), ("engine", "=", found[0]["engine"])]
    rows = pq.read_table(found[0]["file"], filters=wanted).to_pylist()
    if not rows:
        return None
    row, bodies = rows[0], len(rows[0]["bodies"])

    def states(name: str, width: int) -> Any:
        return np.array(row[name], np.float32).reshape(1, row["n_frames"], bodies, width)

    def vectors(name: str) -> Any:
        found = row.get(name)
        return np.zeros((n, 3)) if found is None else np.array(found, float).reshape(n, 3)

    time = np.array(row["time_s"], float)
    n = len(row["contact_time_s"])
    contacts = ContactLog(
        world=np.zeros(n, np.int32),
        frame=np.searchsorted(time, np.array(row["contact_time_s"]) - 1e-6).astype(np.int32),
        a=np.array(row["contact_a"], np.int32),
        b=np.array(row["contact_b"], np.int32),
        time=np.array(row["contact_time_s"], float),
        impulse=np.array(row["contact_impulse_ns"], float),
        depth=np.array(row["contact_depth_m"], float),
        point=vectors("contact_point_m"),
        normal=vectors("contact_normal"),
    )
    return Rollout(
        engine=row["engine"],
        dt=row["dt_s"],
        time=time,
        position=states("position_m", 3),
        quaternion=states("quaternion_xyzw", 4),
        linear_velocity=states("linear_velocity_mps", 3),
        angular_velocity=states("angular_velocity_radps", 3),
        contacts=contacts,
        valid=np.array([True]),
    )


def _materialize(row: dict[str, Any], folder: Path, meshes: bool) -> None:
    from esg.compile import compile_scene
    from esg.graph import EsgDocument, canonical_json

    doc = EsgDocument.model_validate_json(row["esg_optimize"])
    (folder / "prompt.txt").write_text(f"{row['prompt']}\n", encoding="utf-8")
    (folder / _KEY_FILE).write_text(f"{row['scene_key']}\n", encoding="utf-8")
    (folder / "esg.json").write_bytes(canonical_json(doc))
    compile_scene(doc, folder)
    if meshes:
        from esg.assets import write_meshes

        write_meshes(doc, folder)
