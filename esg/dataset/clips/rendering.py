"""Rendering one scene: all its cameras, drawn on one thread and encoded on others.

Where cameras go is worked out first, by as many processes as there are; a GPU is drawn on by one
process at a time, so that its memory holds one scene and none waits half drawn.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
import contextlib
from dataclasses import dataclass
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from esg.dataset.clips.records import FIRST_BODY, ClipObject, ClipRecord, Intrinsics
from esg.dataset.clips.writing import ClipWriter, clip_folder, filed, whole_folder
from esg.limits import place_in
from esg.view import truth
from esg.view.renderers.kinds import kind_named
from esg.view.seeing.wanted import BOXES, PICTURES, Settings
from esg.view.seeing.witness import Shot, Sight, shots, sight_of
from esg.view.worlds import Views

if TYPE_CHECKING:
    from esg.dataset.plan import RenderSpec
    from esg.engines.scene import Rollout, SimScene
    from esg.graph.models import EsgDocument
    from esg.metrics.models import SceneVerdict

AHEAD = 2
"""So many batches of frames may be drawn and not yet written: what lies between is memory."""


@dataclass(frozen=True)
class Replay:
    """Everything that cameras need of a scene.

    Args:
        scene: The bodies.
        rollout: Their motion.
        verdict: Events, for the director.
        doc: Meshes and the place.
    """

    scene: SimScene
    rollout: Rollout
    verdict: SceneVerdict | None
    doc: EsgDocument


@dataclass(frozen=True)
class Subject:
    """A scene that is to be rendered.

    Args:
        index: Of the scene in the dataset.
        common: run_id, scene_key, suite, scene_id, seed, split and prompt.
        load: Its replay.
        camera: How the distribution has it filmed; empty: as the dataset is.
    """

    index: int
    common: Mapping[str, Any]
    load: Callable[[], Replay]
    camera: str = ""

    @property
    def scene_id(self) -> str:
        """Id of the scene in the dataset."""
        return str(self.common["scene_id"])


def render_scene(subject: Subject, spec: RenderSpec, out: Path) -> list[ClipRecord]:
    """Renders all cameras of a scene; its folder appears complete or not at all.

    Args:
        subject: The scene.
        spec: What to render.
        out: Folder of the dataset.

    Returns:
        One record a camera.

    Raises:
        OSError: If the disk does not take them.
    """
    replay = subject.load()
    settings = settings_of(spec, int(subject.common["seed"]), subject.camera)
    common = {**subject.common, **_setting(replay.doc)}
    sight = sight_of(replay.scene, replay.rollout, replay.verdict, replay.doc, settings)
    return draw_scene(sight, common, spec, out)


def draw_scene(
    sight: Sight, common: Mapping[str, Any], spec: RenderSpec, out: Path
) -> list[ClipRecord]:
    """The same, once the cameras are directed.

    Args:
        sight: What they see.
        common: Columns of the scene.
        spec: What to render.
        out: Folder of the dataset.

    Raises:
        OSError: If the disk does not take it.
    """
    scene_id = str(common["scene_id"])
    place = f"clips/{scene_id}"
    with whole_folder(out / place) as work, contextlib.ExitStack() as open_films:
        films: list[_Film] = []
        taken = shots(sight)
        for shot in taken:
            _ = shot.scenery  # found out before others wait
        with turn_on(spec.device):
            for camera, shot in enumerate(taken):
                film = _Film(shot, spec, work / f"camera_{camera}")
                open_films.callback(film.stop)
                for numbers, views in shot.drawn():
                    film.add(numbers, views)
                films.append(film)
        return [
            film.finish(common, camera, clip_folder(scene_id, camera))
            for camera, film in enumerate(films)
        ]


def _setting(doc: EsgDocument) -> dict[str, str]:
    """Where a scene is shown, and under which sky."""
    around = doc.dressing
    return {"place": around.place, "sky": around.sky} if around else {"place": "", "sky": ""}


def settings_of(spec: RenderSpec, seed: int, camera: str = "") -> Settings:
    """What renderers are told; cameras, points and noise follow from the scene's seed.

    Args:
        spec: Of the dataset.
        seed: Of the scene.
        camera: How to film the scene, where the dataset leaves it to the director.
    """
    channels = tuple(c for name in spec.channels for c in (BOXES if name == "boxes" else (name,)))
    return Settings(
        channels=channels,
        size=spec.size,
        fps=spec.fps,
        cameras=spec.cameras,
        device=spec.device,
        seed=seed,
        renderer=spec.renderer,
        samples=spec.samples,
        motion_blur=spec.motion_blur,
        camera=camera if camera and spec.camera == "auto" else spec.camera,
    )


def turn_on(device: str) -> contextlib.AbstractContextManager[None]:
    """Waits for a place on a device: one process at a time draws on a GPU, on the CPU any number.

    `ESG_STAGE_LIMITS=render=2` sets another number for both.
    """
    if device == "cpu":
        return place_in("render")
    number = device.partition(":")[2] or "0"
    visible = os.environ.get("CUDA_VISIBLE_DEVICES", "")
    seen = visible.split(",")[int(number)] if number.isdecimal() and visible else number
    return place_in("render", where=f"gpu{seen}", most=1)


class _Film:
    """What one camera's pictures become: every channel has a thread, which keeps its order.

    Args:
        shot: The camera's pictures.
        spec: What is rendered.
        folder: For the files.
    """

    def __init__(self, shot: Shot, spec: RenderSpec, folder: Path) -> None:
        self._shot, self._spec = shot, spec
        self._writer = ClipWriter(
            folder, spec.channels, spec.size, spec.fps, lossless=spec.lossless
        )
        self._boxes2d: list[dict[str, int]] = []
        self._tracks: list[tuple[Any, Any]] = []
        self._lanes = {
            channel: ThreadPoolExecutor(1) for channel in (*self._writer.channels, "marks")
        }
        self._under_way: deque[list[Future[None]]] = deque()

    def add(self, numbers: range, views: Views) -> None:
        """Takes the next pictures; waits while too many are not yet written."""
        while len(self._under_way) >= AHEAD:
            self._settle()
        jobs = [
            self._lanes[channel].submit(self._write, channel, numbers, views)
            for channel in self._writer.channels
        ]
        jobs.append(self._lanes["marks"].submit(self._mark, numbers, views))
        self._under_way.append(jobs)

    def finish(self, common: Mapping[str, Any], camera: int, place: str) -> ClipRecord:
        """Waits for the last picture; the record of the clip.

        Args:
            common: Columns of the scene.
            camera: Its number.
            place: Where the files will be, below the dataset's folder.
        """
        while self._under_way:
            self._settle()
        paths = self._writer.close()
        return filed(self._record(common, camera), self._writer.scales, paths, place)

    def stop(self) -> None:
        """Ends the threads, whatever they still have to do."""
        for lane in self._lanes.values():
            lane.shutdown(cancel_futures=True)
        with contextlib.suppress(Exception):  # a file that was not finished
            self._writer.close()

    def _settle(self) -> None:
        for job in self._under_way.popleft():
            job.result()

    def _write(self, channel: str, numbers: range, views: Views) -> None:
        self._writer.add({channel: VALUES[channel](self._shot, numbers, views)})

    def _mark(self, numbers: range, views: Views) -> None:
        """Boxes and tracks, which are columns."""
        for k, at in enumerate(numbers):
            if "boxes" in self._spec.channels:
                for box in self._shot.boxes_2d(views.body[k]):
                    sides = zip(("x0", "y0", "x1", "y1"), box["box_px"], strict=True)
                    self._boxes2d.append(
                        {
                            "frame": at,
                            "id": box["id"],
                            **dict(sides),
                            "visible_px": box["visible_px"],
                        }
                    )
            if "tracks" in self._spec.channels:
                self._tracks.append(self._shot.tracks(at, views.depth[k], views.body[k]))

    def _record(self, common: Mapping[str, Any], camera: int) -> ClipRecord:
        shot, spec, sight = self._shot, self._spec, self._shot.sight
        n, m = len(sight.frames), len(sight.scene.bodies)
        position, quaternion = sight.moved
        matrix = shot.holes[0].matrix
        kind = kind_named(spec.renderer)
        tracked = sight.tracked
        xy, seen = (
            (np.array([t[k] for t in self._tracks]) for k in (0, 1))
            if self._tracks
            else (np.zeros((n, 0, 2)), np.zeros((n, 0), bool))
        )
        return ClipRecord(
            **common,
            camera=camera,
            camera_kind=shot.take.kind,
            width=spec.size[0],
            height=spec.size[1],
            fps=spec.fps,
            n_frames=n,
            time_s=sight.time_s.astype(np.float32),
            renderer=spec.renderer,
            samples=spec.samples or kind.samples,
            intrinsics=Intrinsics(*(float(matrix[k]) for k in ((0, 0), (1, 1), (0, 2), (1, 2)))),
            **_extrinsics(shot),
            channels=spec.channels,
            files=(),
            objects=tuple(
                ClipObject(k + FIRST_BODY, b.name, b.label, b.category, b.static)
                for k, b in enumerate(sight.scene.bodies)
            ),
            object_bounds_m=sight.bounds.astype(np.float32),
            object_position_m=position[:, :m].astype(np.float32),
            object_quaternion_xyzw=quaternion[:, :m].astype(np.float32),
            boxes2d=tuple(self._boxes2d),
            boxes3d=_boxes_3d(sight) if "boxes" in spec.channels else (),
            track_ids=(tracked.owner + FIRST_BODY).astype(np.int32),
            track_point_m=tracked.points.astype(np.float32),
            track_xy_px=xy.astype(np.float32),
            track_visible=seen,
        )


def _extrinsics(shot: Shot) -> dict[str, Any]:
    """Where the camera is and how it is turned, in every picture."""
    poses = np.array([hole.world_to_camera for hole in shot.holes])
    back = poses[:, :3, :3].transpose(0, 2, 1)
    eyes = -np.einsum("nij,nj->ni", back, poses[:, :3, 3])
    return {
        "camera_position_m": eyes.astype(np.float32),
        "camera_quaternion_xyzw": Rotation.from_matrix(back).as_quat().astype(np.float32),
    }


def _boxes_3d(sight: Sight) -> tuple[Mapping[str, float], ...]:
    """Oriented boxes of all bodies in all pictures."""
    names = ("x_m", "y_m", "z_m", "half_x_m", "half_y_m", "half_z_m", "qx", "qy", "qz", "qw")
    bodies = sight.scene.bodies
    half = np.array([b.half_extents for b in bodies])
    offset = np.array([b.origin_offset for b in bodies])
    out: list[Mapping[str, float]] = []
    for at, (position, quaternion) in enumerate(zip(*sight.moved, strict=True)):
        n = len(bodies)
        center = truth.box_centers(half, offset, position[:n], quaternion[:n])
        rows = np.concatenate([center, half, quaternion[:n]], axis=1).astype(np.float32)
        out += [
            {"frame": at, "id": k + FIRST_BODY, **dict(zip(names, row, strict=True))}
            for k, row in enumerate(rows.tolist())
        ]
    return tuple(out)


def _flows(step: int) -> Callable[[Shot, range, Views], NDArray[Any]]:
    def flows(shot: Shot, numbers: range, views: Views) -> NDArray[Any]:
        return np.stack(
            [
                shot.flow(at, at + step, views.depth[k], views.mover[k])
                for k, at in enumerate(numbers)
            ]
        )

    return flows


def _colors(_: Shot, __: range, views: Views) -> NDArray[np.uint8]:
    assert views.rgb is not None
    return views.rgb


VALUES: dict[str, Callable[[Shot, range, Views], NDArray[Any]]] = {
    "rgb": _colors,
    "depth": lambda _, __, views: views.depth,
    "segmentation": lambda _, __, views: truth.segment_ids(views.body),
    "normal": lambda _, __, views: views.normal,
    "flow": _flows(1),
    "backward_flow": _flows(-1),
    "object_coordinates": lambda shot, numbers, views: np.stack(
        [shot.places(at, views.depth[k], views, k) for k, at in enumerate(numbers)]
    ),
}
"""Frames of every channel, as `esg.dataset.clips.writing.Values` has them."""
assert set(VALUES) == set(PICTURES)
