"""What a dataset will hold, decided before the first scene is made.

A plan follows from its specification alone: every shard and every resumed run works out the same
scenes, ids, seeds, splits and batches.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
import hashlib
import json
from pathlib import Path
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict

from esg.dataset.distribution import Distribution
from esg.dataset.grammar import GRAMMAR_VERSION, sample_scenes
from esg.dataset.whatifs.amounts import Variable
from esg.outcomes import UserError
from esg.pipeline import SceneRequest
from esg.store.records import prompt_family, split_of

PLAN_FORMAT = 1
MAX_SCENES = 10_000_000
MAX_BATCH = 32
MAX_GPU_BATCH = 1024
"""On a GPU the scenes of a batch share its launches, which take hardly longer for more of them."""
MAX_PROMPT_CHARS = 8000

Share = Literal["all", "failed", "sample", "none"]
PreviewShare = Literal["all", "sample", "none"]
SAMPLE_EVERY = 50
"""`sample` means every so many scenes, beginning with the first."""
LATER = ("annotations", "what_if", "engines", "meshes", "render", "thin")
"""Fields of a specification that datasets of an older version do not have."""


class Prompt(BaseModel):
    """A line of a prompts file (JSON Lines).

    Args:
        prompt: The text.
        seed: Of the scene; default derived from the dataset's seed and the line.
        family: Prompts of one family share a split; default from the text.
        expect: What must happen: `events`, `constraints`, `objects` of a suite scene. Without it,
            the scene is judged by its own timeline.
    """

    model_config = ConfigDict(frozen=True, extra="ignore")

    prompt: str
    seed: int | None = None
    family: str = ""
    expect: str = ""


class RenderSpec(BaseModel):
    """What cameras see of every scene; see `esg.dataset.clips`.

    Args:
        channels: Of `esg.dataset.clips.encoding.CHANNELS`.
        cameras: How many, 1 to 8.
        size: Width and height [px], both even.
        fps: Frames a second.
        renderer: Of colours: raster, path or cycles.
        samples: Rays a pixel; None for what the renderer takes by itself.
        camera: `auto` for what the director chooses, one of its kinds, or `around`.
        motion_blur: Colours are those of all the time the shutter is open.
        lossless: Colours are kept as they are, in files that browsers do not play.
        device: cpu or cuda:N.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    channels: tuple[str, ...] = ("rgb", "depth", "segmentation")
    cameras: int = 1
    size: tuple[int, int] = (256, 256)
    fps: float = 24.0
    renderer: str = "raster"
    samples: int | None = None
    camera: str = "auto"
    motion_blur: bool = False
    lossless: bool = False
    device: str = "cpu"

    def options(self) -> list[str]:
        """As on the command line of `esg dataset`, without what is default."""
        usual, out = RenderSpec(), [f"--render {','.join(self.channels)}"]
        if self.size != usual.size:
            out.append(f"--size {self.size[0]}x{self.size[1]}")
        for name in ("cameras", "fps", "renderer", "samples", "camera"):
            if (value := getattr(self, name)) != getattr(usual, name):
                out.append(f"--{name} {value:g}" if name == "fps" else f"--{name} {value}")
        if self.motion_blur:
            out.append("--motion-blur")
        return [*out, *(["--lossless"] if self.lossless else [])]


class DatasetSpec(BaseModel):
    """Everything a dataset depends on besides code.

    Args:
        source: sample or prompts.
        n: Number of scenes.
        seed: Of the dataset.
        distribution: Of sampled scenes.
        counterfactual: Whether sampled scenes come in pairs.
        prompts_sha256: Hash of the prompts.
        drafter, strategy, engine, device: As of a scene request.
        mcap: Which scenes get an MCAP recording.
        previews: Which scenes get a picture.
        fps: Frames a second of the recorded trajectories.
        batch: Scenes a batch.
        strict: Whether `partial` scenes count as failed.
        annotations: Whether scenes get captions and questions.
        what_if: Variables of which each is changed in every solved scene.
        engines: Engines that every scene is replayed in, at two steps.
        meshes: Whether the meshes that manifests name are packed beside them.
        render: What cameras see; None for a dataset without clips.
        thin: Whether near-duplicates are left out of all splits.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    format: int = PLAN_FORMAT
    source: Literal["sample", "prompts"]
    n: int
    seed: int = 0
    distribution: Distribution | None = None
    counterfactual: bool = False
    prompts_sha256: str = ""
    grammar: int = GRAMMAR_VERSION
    drafter: str = "rules"
    strategy: str = "batched"
    engine: str = "physx"
    device: str = "cpu"
    mcap: Share = "none"
    previews: PreviewShare = "sample"
    fps: float = 60.0
    batch: int = 0
    strict: bool = False
    annotations: Literal["all", "none"] = "all"
    what_if: tuple[Variable, ...] = ()
    engines: tuple[Literal["physx", "rapier", "newton"], ...] = ()
    meshes: bool = True
    render: RenderSpec | None = None
    thin: bool = False

    @property
    def batch_size(self) -> int:
        """Scenes a batch: even, so that no counterfactual pair is parted."""
        if self.batch:
            return self.batch
        if self.device != "cpu":
            return max(4, min(MAX_GPU_BATCH, 2 * (self.n // 8)))
        return max(4, min(MAX_BATCH, 2 * (self.n // 64)))

    @property
    def n_batches(self) -> int:
        return -(-self.n // self.batch_size)

    def name(self) -> str:
        """Id of the dataset: equal specifications have equal names."""
        return f"dataset-{hashlib.sha256(self.canonical().encode()).hexdigest()[:12]}"

    def canonical(self) -> str:
        """Canonical JSON; what came later and was not asked for leaves names as they were."""
        data = self.model_dump(mode="json")
        for name in LATER:
            if getattr(self, name) == type(self).model_fields[name].default:
                del data[name]
        return json.dumps(data, sort_keys=True, separators=(",", ":"))

    def differences(self, other: DatasetSpec) -> list[str]:
        """Fields in which two specifications differ, as `name: mine, not theirs`."""
        mine, theirs = self.model_dump(mode="json"), other.model_dump(mode="json")
        return [f"{k}: {mine[k]!r}, not {theirs[k]!r}" for k in mine if mine[k] != theirs[k]]


@dataclass(frozen=True)
class PlannedScene:
    """One scene to make.

    Args:
        index: Its number in the dataset.
        scene_id: Deterministic; sorts like the index.
        request: For the pipeline.
        family: Prompt family.
        split: train, validation or test.
        level: Difficulty band, if known.
        rule: Rule of the grammar, or empty.
        pair: Id of the counterfactual pair's base scene, or empty.
        changed: What this scene changes of its base; empty for a base.
        parameters: JSON of the grammar's slots and of what was drawn beside them, or empty.
        camera: How the distribution has it filmed; empty: as the dataset is.
    """

    index: int
    scene_id: str
    request: SceneRequest
    family: str
    split: str
    level: str = ""
    rule: str = ""
    pair: str = ""
    changed: str = ""
    parameters: str = ""
    camera: str = ""


@dataclass(frozen=True)
class Shard:
    """The i-th of n parts of a dataset's batches, i from 1.

    Args:
        index: i.
        count: n.
    """

    index: int = 1
    count: int = 1

    @staticmethod
    def parse(text: str) -> Shard:
        """Reads `i/n`.

        Raises:
            UserError: If it is not that, or i is not between 1 and n.
        """
        first, slash, second = text.partition("/")
        if slash and all(n.isdecimal() and len(n) < 10 for n in (first, second)):
            index, count = int(first), int(second)
            if 1 <= index <= count:
                return Shard(index, count)
        raise UserError(f"--shard {text!r:.60}: give i/n with 1 <= i <= n, e.g. 1/4 to 4/4")

    def batches(self, spec: DatasetSpec) -> list[int]:
        """Numbers of the batches of this shard; every batch is in exactly one shard."""
        return list(range(self.index - 1, spec.n_batches, self.count))


def plan_batch(
    spec: DatasetSpec, number: int, prompts: Sequence[Prompt] = ()
) -> tuple[PlannedScene, ...]:
    """The scenes of one batch, without those of others.

    Args:
        spec: The specification.
        number: Of the batch.
        prompts: The prompts, if that is the source.
    """
    first = number * spec.batch_size
    indices = range(first, min(first + spec.batch_size, spec.n))
    if spec.source == "prompts":
        return tuple(_from_prompt(spec, i, prompts[i]) for i in indices)
    sampled = sample_scenes(
        len(indices), spec.seed, spec.distribution,
        counterfactual=spec.counterfactual, first=first,
    )  # fmt: skip
    out: list[PlannedScene] = []
    base = ""
    for i, scene in zip(indices, sampled, strict=True):
        scene_id = f"{i:07d}-{scene.rule}"
        if not scene.changed:
            base = scene_id
        expected = scene.expectation.model_copy(update={"id": scene_id})
        out.append(
            PlannedScene(
                index=i,
                scene_id=scene_id,
                request=_request(spec, scene.prompt, scene.seed, scene_id, _json(expected)),
                family=scene.family,
                split=split_of(scene.family),
                level=scene.level,
                rule=scene.rule,
                pair=base if spec.counterfactual else "",
                changed=scene.changed,
                parameters=json.dumps(dict(scene.values), sort_keys=True),
                camera=scene.camera,
            )
        )
    return tuple(out)


def plan_scenes(spec: DatasetSpec, prompts: Sequence[Prompt] = ()) -> list[PlannedScene]:
    """All scenes of a dataset in order.

    Args:
        spec: The specification.
        prompts: The prompts, if that is the source.
    """
    return [scene for n in range(spec.n_batches) for scene in plan_batch(spec, n, prompts)]


def _from_prompt(spec: DatasetSpec, i: int, p: Prompt) -> PlannedScene:
    family = p.family or prompt_family(p.prompt)
    digest = hashlib.sha256(f"{spec.seed}/{i}".encode()).digest()
    seed = p.seed if p.seed is not None else int.from_bytes(digest[:4], "big") >> 1
    scene_id = f"{i:07d}"
    expected, level = "", ""
    if p.expect:
        data = {**json.loads(p.expect), "id": scene_id, "prompt": p.prompt}
        level = data.get("level", "")
        expected = json.dumps(data, sort_keys=True)
    request = _request(spec, p.prompt, seed, scene_id, expected)
    return PlannedScene(i, scene_id, request, family, split_of(family), level)


def _request(
    spec: DatasetSpec, prompt: str, seed: int, scene_id: str, expected: str
) -> SceneRequest:
    return SceneRequest(
        prompt=prompt,
        seed=seed,
        drafter=spec.drafter,
        strategy=spec.strategy,
        device=spec.device,
        engine=spec.engine,
        suite_scene=expected,
        name=scene_id,
    )


def _json(scene: Any) -> str:
    return scene.model_dump_json(by_alias=True)


def read_prompts(path: Path) -> list[Prompt]:
    """Reads a prompts file: one prompt a line (.txt), JSON Lines (.jsonl), or a suite (.yaml).

    Raises:
        UserError: Listing every problem with its line.
    """
    suffix = path.suffix.lower()
    if suffix in (".yaml", ".yml"):
        return _suite_prompts(path)
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except FileNotFoundError:
        raise UserError(f"--prompts {path} does not exist; check the path") from None
    except IsADirectoryError:
        raise UserError(f"--prompts {path} is a folder; name the file in it") from None
    except UnicodeDecodeError:
        raise UserError(f"--prompts {path} is not UTF-8 text; save it as UTF-8") from None
    except OSError as error:
        raise UserError(f"--prompts {path} cannot be read: {error.strerror}") from None
    read = _json_prompt if suffix in (".jsonl", ".ndjson") else _text_prompt
    out: list[Prompt] = []
    problems: list[str] = []
    for number, line in enumerate(lines, 1):
        text = line.strip()
        if not text or (read is _text_prompt and text.startswith("#")):
            continue
        try:
            out.append(read(text))
        except ValueError as error:
            problems += [f"  line {number}: {p}" for p in str(error).splitlines()]
    if problems:
        shown = problems[:20]
        more = [f"  and {len(problems) - 20} more"] if len(problems) > 20 else []
        count = "1 problem" if len(problems) == 1 else f"{len(problems)} problems"
        raise UserError("\n".join([f"--prompts {path}: {count}", *shown, *more]))
    if not out:
        raise UserError(f"--prompts {path} holds no prompts; write one a line")
    return out


def _text_prompt(text: str) -> Prompt:
    if any(ord(c) < 32 and c != "\t" for c in text):
        raise ValueError("holds control characters; give plain text")
    if len(text) > MAX_PROMPT_CHARS:
        raise ValueError(f"has {len(text)} characters; at most {MAX_PROMPT_CHARS} make a scene")
    return Prompt(prompt=text)


def _json_prompt(text: str) -> Prompt:
    try:
        data = json.loads(text)
    except ValueError:
        raise ValueError(f"is not JSON: {text[:60]!r}") from None
    if not isinstance(data, dict) or not isinstance(data.get("prompt"), str):
        raise ValueError('lacks "prompt" (a text)')
    prompt = _text_prompt(data["prompt"].strip())
    if not prompt.prompt:
        raise ValueError("the prompt is empty")
    seed, family = data.get("seed"), data.get("family", "")
    if seed is not None and (isinstance(seed, bool) or not isinstance(seed, int) or seed < 0):
        raise ValueError(f"seed {seed!r} is no whole number from 0 on")
    if not isinstance(family, str):
        raise ValueError(f"family {family!r} is no text")
    expect = data.get("expect")
    return Prompt(
        prompt=prompt.prompt,
        seed=seed,
        family=family,
        expect=_expectation(prompt.prompt, expect) if expect is not None else "",
    )


def _expectation(prompt: str, expect: Any) -> str:
    """Canonical JSON of a checked suite scene."""
    from esg.metrics import parse_suite

    if not isinstance(expect, dict):
        raise ValueError('"expect" is no mapping; give events, constraints and objects')
    scene = {**expect, "id": "scene", "prompt": prompt}
    try:
        suite = parse_suite(json.dumps({"suite": "prompts", "scenes": [scene]}), name="expect")
    except UserError as error:
        raise ValueError(str(error)) from None
    return _json(suite.scenes[0])


def _suite_prompts(path: Path) -> list[Prompt]:
    from esg.metrics import load_suite

    return [Prompt(prompt=s.prompt, expect=_json(s)) for s in load_suite(path).scenes]


def prompts_text(prompts: Sequence[Prompt]) -> str:
    """JSON Lines of prompts, as kept in the dataset's folder."""
    rows = (p.model_dump(mode="json") for p in prompts)
    return "".join(json.dumps(r, sort_keys=True, ensure_ascii=False) + "\n" for r in rows)


def kept_prompts(text: str) -> list[Prompt]:
    """The inverse of `prompts_text`."""
    return [Prompt.model_validate_json(line) for line in text.splitlines() if line]
