"""A finished scene: what was asked, what came of it, and what can be done with it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from esg.outcomes import Outcome, UserError

if TYPE_CHECKING:
    from esg.api.trajectories import Trajectories
    from esg.compile.export import Target
    from esg.compile.transfer import Trust
    from esg.compile.visuals.usd_files import UsdForm
    from esg.engines.manifest import Manifest
    from esg.graph import EsgDocument
    from esg.metrics.models import EventVerdict, SceneVerdict, Suite, SuiteScene
    from esg.report.run import SceneEntry

Engine = Literal["physx", "rapier", "newton"]
RATE_HZ = 240
"""Physics steps a second of a replay that is not asked for others."""


@dataclass(frozen=True)
class Replay:
    """A scene played again.

    Args:
        engine: physx, rapier or newton.
        dt_s: Physics step [s].
        proof: `class` if the emitted class itself ran, `program` if its control program did.
        note: Why the class did not run where it could have; often empty.
        verdict: What the judge says of it.
        judged_against: timeline, or suite and scene.
        plausibility: Every check with its measured value and limit (docs/metrics/plausibility.md).
        trajectories: How its bodies moved.
    """

    engine: str
    dt_s: float
    proof: str
    note: str
    verdict: SceneVerdict
    judged_against: str
    plausibility: dict[str, Any]
    trajectories: Trajectories


@dataclass(frozen=True)
class Scene:
    """A scene folder, read as it is asked for.

    Args:
        folder: Its path; `Scene.load` checks it.
    """

    folder: Path

    @classmethod
    def load(cls, scene: str | Path) -> Scene:
        """The scene of a folder, or of an id below ./runs.

        Args:
            scene: Folder or id.

        Raises:
            UserError: If there is none, the id names several, or files in it may not be opened.
        """
        from esg.api.inputs import find_scene

        return cls(find_scene(str(scene)))

    @cached_property
    def _entry(self) -> SceneEntry:
        from esg.report.run import read_scene

        entry = read_scene(self.folder)
        if entry.problems:
            raise UserError("\n".join(entry.problems))
        return entry

    @property
    def id(self) -> str:
        """Name of its folder."""
        return self.folder.name

    @property
    def prompt(self) -> str:
        """What was asked for."""
        return self._entry.prompt

    @property
    def seed(self) -> int | None:
        """Of every random choice."""
        return self._entry.seed

    @property
    def outcome(self) -> Outcome:
        """How it ended.

        Raises:
            UserError: If its log does not say.
        """
        try:
            return Outcome(self._entry.outcome)
        except ValueError:
            raise UserError(
                f"{self.folder / 'log.jsonl'} does not say how the scene ended"
            ) from None

    @property
    def reason(self) -> str:
        """Why it ended so; often empty."""
        return self._entry.reason

    @property
    def advice(self) -> str:
        """What one can do about it."""
        return self.outcome.advice

    @property
    def seconds(self) -> float:
        """Time spent in its stages [s]; what came from the cache took none."""
        return self._entry.seconds

    @cached_property
    def graph(self) -> EsgDocument:
        """Its Evolutive Scene Graph (docs/graph.md).

        Raises:
            UserError: If there is none, or it does not hold.
        """
        from esg.graph import load_document

        if not (self.folder / "esg.json").exists():
            raise UserError(f"{self.folder} holds no scene graph; its log.jsonl says why")
        return load_document(self.folder / "esg.json")

    @cached_property
    def manifest(self) -> Manifest:
        """The physical scene in SI units and its control program (docs/compile.md).

        Raises:
            UserError: If it was never compiled.
        """
        from esg.scenereading import read_manifest

        if not (self.folder / "manifest.json").exists():
            raise UserError(f"{self.folder} holds no compiled scene; its log.jsonl says why")
        return read_manifest(self.folder / "manifest.json")

    @cached_property
    def verdict(self) -> SceneVerdict:
        """What the judge measured on its replay: events, constraints, layout, statements.

        Raises:
            UserError: If it was never judged.
        """
        from esg.metrics import SceneVerdict

        if not self._entry.verdict:
            raise UserError(f"{self.folder} was never judged; its log.jsonl says why")
        return SceneVerdict.from_json(self._entry.verdict)

    @property
    def events(self) -> Sequence[EventVerdict]:
        """Those of the verdict, each with whether and when it happened."""
        return self.verdict.events

    @property
    def verified(self) -> bool:
        """Whether the layout is valid and every event happened in the replay."""
        return bool(self._entry.metrics.get("verified"))

    @property
    def statements(self) -> list[dict[str, Any]]:
        """What the prompt states beyond its events, each kept, broken or not represented."""
        return self._entry.statements

    @property
    def not_kept(self) -> list[dict[str, Any]]:
        """The words of the prompt that the scene does not show, each with the reason."""
        return self._entry.not_kept

    @property
    def plausible(self) -> bool | None:
        """Whether its motion passes for real by every check; None if it was never judged."""
        return self._entry.plausible

    @property
    def plausibility(self) -> dict[str, Any]:
        """Every check with its measured value and limit; empty if it was never judged."""
        return self._entry.metrics.get("plausibility") or {}

    @cached_property
    def trajectories(self) -> Trajectories:
        """How its bodies moved in the replay that was judged.

        Raises:
            UserError: If it was never replayed.
        """
        from esg.api.trajectories import trajectories_of
        from esg.report.replays import replays_of

        found = replays_of(self.folder, self._entry.metrics)
        if not found:
            raise UserError(f"{self.folder} was never replayed; its log.jsonl says why")
        return trajectories_of(found[0].scene, found[0].rollout)

    def replay(
        self,
        engine: Engine = "physx",
        *,
        hz: int = RATE_HZ,
        suite: str | Path | None = None,
        trust: bool = False,
    ) -> Replay:
        """Plays the scene again and judges it.

        Args:
            engine: physx runs the emitted class, if it is what this version emits from the scene
                graph; rapier and newton run its control program.
            hz: Physics steps a second.
            suite: Suite to judge against, its scene found by prompt; default its own timeline.
            trust: Run the class whatever it is: you vouch for who made it.

        Raises:
            UserError: If the folder holds no compiled scene, or the suite not its prompt.
        """
        doc = self.graph
        expected, against = expectation(self.folder, doc, _suite(suite))
        trusted: Trust = "anything" if trust else "equal"
        return replayed(self.folder, doc, engine, 1.0 / hz, expected, against, trusted)

    def export(
        self,
        to: Target,
        out: str | Path | None = None,
        *,
        form: UsdForm = "usda",
        self_contained: bool = False,
        trust: bool = False,
    ) -> list[Path]:
        """Writes the scene for another program.

        Args:
            to: unreal a plugin folder; usd physics and baked animation; mjcf MuJoCo XML; glb
                animated glTF.
            out: Folder to write into; default the scene folder.
            form: Of usd: layers as text (usda) or in binary (usdc), which simulate and play, or a
                package (usdz) that shows the scene on phones.
            self_contained: Of unreal: write what plays all scenes into the class.
            trust: Export the class of an unreal plugin whatever it is.

        Returns:
            The files written.

        Raises:
            UserError: If the folder holds no compiled scene or `out` cannot be written.
        """
        from esg.compile.replay import require_ours
        from esg.files import refused
        from esg.scenefolder import check_writable
        from esg.view.setting import export_folder

        target = self.folder if out is None else Path(out)
        check_writable(target)
        if to == "unreal" and not trust:
            require_ours(self.folder)
        with refused(target):
            return export_folder(self.folder, to, target, form=form, self_contained=self_contained)

    def render(
        self,
        channels: str = "rgb,depth,segmentation",
        out: str | Path | None = None,
        *,
        size: str = "256x256",
        fps: float = 24.0,
        cameras: int = 1,
        camera: str = "around",
        format: Literal["png", "parquet"] = "png",
        device: str = "cpu",
        seed: int = 0,
        renderer: str = "raster",
        samples: int | None = None,
        motion_blur: bool = False,
    ) -> Path:
        """Draws the recorded replay with exact channels for learning (`docs/view.md`).

        Args:
            channels: Of rgb, depth, normal, segmentation, flow, backward_flow, object_coordinates,
                boxes2d, boxes3d (boxes: both), tracks, with commas between; or all.
            out: Folder to write; default `render` in the scene folder.
            size: Width x height [px].
            fps: Frames a second.
            cameras: How many, 1 to 8.
            camera: around, or a director's: auto, static, tracking, dolly, orbit or dash.
            format: png writes files, parquet shards of rows.
            device: cpu or cuda:N.
            seed: Of the points that tracks follow, of noise and of clouds.
            renderer: Of colours: raster, path (Mitsuba) or cycles (Blender).
            samples: Rays a pixel; default what suits the renderer.
            motion_blur: Let the shutter be open for half of the time between frames.

        Returns:
            The folder, whose `manifest.json` says what every file holds.

        Raises:
            UserError: Naming what cannot be drawn so; or if the scene was never replayed.
        """
        from esg.api.inputs import checked
        from esg.api.rendering import Asked, render_scene, settings_of
        from esg.scenefolder import check_writable

        target = self.folder / "render" if out is None else Path(out)
        asked = Asked(
            channels, size, fps, cameras, camera, format, device, seed, renderer, samples,
            motion_blur,
        )  # fmt: skip
        chosen, _ = checked(lambda: settings_of(asked), lambda: check_writable(target))
        return Path(render_scene(self.folder, target, chosen)["folder"])

    def show(self) -> Any:
        """Its film, for a notebook.

        Returns:
            An `IPython.display.Video`, or an `Image` of the contact sheet where there is no film;
            the path of either where there is no IPython.

        Raises:
            UserError: If the scene has no pictures.
        """
        path = self._picture()
        if path is None:
            raise UserError(f"{self.folder} has no pictures; its log.jsonl says why")
        try:
            from IPython.display import (  # pyright: ignore[reportMissingImports]  # a notebook's
                Image,
                Video,
            )
        except ImportError:
            return path
        film = path.suffix == ".mp4"
        return Video(str(path), embed=True) if film else Image(filename=str(path))

    def _picture(self) -> Path | None:
        names = ("preview.mp4", "preview.png")
        return next((self.folder / n for n in names if (self.folder / n).is_file()), None)

    def _repr_html_(self) -> str:
        """Prompt, outcome and film, as a notebook shows the last value of a cell."""
        import base64
        import html

        picture = self._picture()
        title = f"<p><b>{html.escape(self.prompt)}</b><br>{html.escape(self.outcome.value)}"
        title += f": {html.escape(self.reason)}</p>" if self.reason else "</p>"
        if picture is None:
            return title
        data = base64.b64encode(picture.read_bytes()).decode()
        if picture.suffix == ".mp4":
            return f'{title}<video controls loop muted src="data:video/mp4;base64,{data}"></video>'
        return f'{title}<img src="data:image/png;base64,{data}">'


def judge(scene: Scene | str | Path, suite: str | Path | None = None) -> SceneVerdict:
    """Judges the recorded replay of a scene again, without any simulation.

    Args:
        scene: A scene, its folder or its id below ./runs.
        suite: Suite that holds its prompt; default the scene's own timeline.

    Raises:
        UserError: If it was never replayed, or the suite does not hold its prompt.
    """
    from esg.metrics import judge as measure

    found = scene if isinstance(scene, Scene) else Scene.load(scene)
    expected, _ = expectation(found.folder, found.graph, _suite(suite))
    manifest = found.manifest
    return measure(manifest.scene, manifest.program, found.trajectories.rollout, expected)


def replayed(
    folder: Path,
    doc: EsgDocument,
    engine: str,
    dt: float,
    expected: SuiteScene,
    against: str,
    trust: Trust = "equal",
) -> Replay:
    """Replays and judges one scene folder.

    Args:
        folder: Scene folder.
        doc: Its document.
        engine: physx, rapier or newton.
        dt: Physics step [s].
        expected: What must happen.
        against: Where that is written.
        trust: Which classes are run.

    Raises:
        UserError: If the folder holds no compiled scene.
    """
    from esg.api.trajectories import trajectories_of
    from esg.compile.transfer import replay_scene
    from esg.engines.manifest import load_manifest
    from esg.metrics import judge as measure
    from esg.metrics.plausibility import assess, told_of

    manifest = load_manifest(folder / "manifest.json")
    rollout, proof = replay_scene(folder, manifest, engine, dt, trust=trust, document=doc)
    return Replay(
        engine,
        dt,
        proof,
        str(rollout.extra.get("note", "")),
        measure(manifest.scene, manifest.program, rollout, expected),
        against,
        assess(manifest.scene, manifest.program, rollout, told_of(doc)).to_json(),
        trajectories_of(manifest.scene, rollout),
    )


def document_of(folder: Path) -> EsgDocument:
    """The document of a compiled scene.

    Raises:
        UserError: If the folder holds no compiled scene.
    """
    from esg.graph import load_document

    if not (folder / "manifest.json").exists():
        raise UserError(f"{folder} holds no compiled scene; its log.jsonl says why")
    return load_document(folder / "esg.json")


def expectation(folder: Path, doc: EsgDocument, suite: Suite | None) -> tuple[SuiteScene, str]:
    """What must happen in a scene, and where that is written.

    Args:
        folder: Scene folder.
        doc: Its document.
        suite: The suite, or None for the scene's own timeline.

    Raises:
        UserError: If the suite does not hold its prompt.
    """
    from esg.metrics import expectations_from_timeline

    if suite is None:
        return expectations_from_timeline(doc), "timeline"
    prompt = " ".join(doc.scene_definition.original_description.split())
    for scene in suite.scenes:
        if " ".join(scene.prompt.split()) == prompt:
            return scene, f"{suite.suite} {scene.id}"
    raise UserError(
        f"--suite: {suite.suite} has no scene with the prompt of {folder}: {prompt[:80]!r}"
    )


def _suite(suite: str | Path | None) -> Suite | None:
    from esg.metrics import load_suite

    return None if suite is None else load_suite(str(suite))
