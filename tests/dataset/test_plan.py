"""Plans: prompts files, ids, shards, splits."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from esg.dataset.grammar import sample_scenes
from esg.dataset.plan import (
    DatasetSpec,
    Shard,
    kept_prompts,
    plan_batch,
    plan_scenes,
    prompts_text,
    read_prompts,
)
from esg.outcomes import UserError


def sampled(n: int, **more: object) -> DatasetSpec:
    return DatasetSpec(source="sample", n=n, **more)  # type: ignore[arg-type]


def test_ids_sort_like_indices_and_are_unique() -> None:
    scenes = plan_scenes(sampled(120))
    assert [s.scene_id for s in scenes] == sorted({s.scene_id for s in scenes})
    assert all(s.request.name == s.scene_id for s in scenes)


def test_sampled_scenes_are_judged_by_their_sentence() -> None:
    scene = plan_scenes(sampled(1))[0]
    expected = json.loads(scene.request.suite_scene)
    assert (expected["id"], expected["prompt"]) == (scene.scene_id, scene.request.prompt)
    assert expected["events"]


@pytest.mark.parametrize("count", [1, 2, 3, 7])
def test_shards_are_a_partition_of_the_batches(count: int) -> None:
    spec = sampled(333)
    shards = [Shard(i, count).batches(spec) for i in range(1, count + 1)]
    assert sorted(n for shard in shards for n in shard) == list(range(spec.n_batches))


def test_batches_part_no_pair() -> None:
    for n in (8, 100, 2000, 5000):
        assert sampled(n, counterfactual=True).batch_size % 2 == 0
    scenes = plan_scenes(sampled(64, counterfactual=True))
    for base, twin in zip(scenes[::2], scenes[1::2], strict=True):
        assert base.pair == twin.pair == base.scene_id
        assert (base.split, base.family) == (twin.split, twin.family)


@pytest.mark.parametrize("pairs", [False, True])
def test_a_batch_is_planned_without_the_others(pairs: bool) -> None:
    spec = sampled(70, counterfactual=pairs, batch=16)
    whole = list(sample_scenes(70, spec.seed, spec.distribution, counterfactual=pairs))
    batches = [plan_batch(spec, n) for n in range(spec.n_batches)]
    assert [len(b) for b in batches] == [16, 16, 16, 16, 6]
    assert [s.request.prompt for b in batches for s in b] == [s.prompt for s in whole]
    assert [s.index for s in batches[3]] == list(range(48, 64))
    far = sampled(10_000_000, batch=1000)
    assert len(plan_batch(far, far.n_batches - 1)) == 1000


def test_no_prompt_is_in_two_splits() -> None:
    """Also not a twin's sentence that is another unit's base."""
    where: dict[str, set[str]] = {}
    for scene in plan_scenes(sampled(2000, counterfactual=True)):
        where.setdefault(scene.request.prompt, set()).add(scene.split)
    assert all(len(splits) == 1 for splits in where.values())
    assert {s for splits in where.values() for s in splits} == {"train", "validation", "test"}


@pytest.mark.parametrize("text", ["", "3", "0/2", "3/2", "a/b", "1/0", "-1/2", "1/2/3"])
def test_bad_shards_are_named(text: str) -> None:
    with pytest.raises(UserError, match="--shard"):
        Shard.parse(text)
    assert Shard.parse("2/3") == Shard(2, 3)


def test_prompts_from_text(tmp_path: Path) -> None:
    path = tmp_path / "p.txt"
    path.write_text("# a comment\n\nA car hits a wall.\n  A ball rolls off a table.  \n")
    found = read_prompts(path)
    assert [p.prompt for p in found] == ["A car hits a wall.", "A ball rolls off a table."]
    assert kept_prompts(prompts_text(found)) == found


def test_prompts_from_json_lines_carry_seed_family_and_expectation(tmp_path: Path) -> None:
    path = tmp_path / "p.jsonl"
    expect = {"events": [{"id": "e1", "type": "collision", "a": "car", "b": "wall"}]}
    rows = [
        {"prompt": "A car hits a wall.", "seed": 7, "family": "f", "expect": expect, "id": "x"},
        {"prompt": "A car stops."},
    ]
    path.write_text("".join(json.dumps(r) + "\n" for r in rows))
    prompts = read_prompts(path)
    spec = DatasetSpec(source="prompts", n=2)
    first, second = plan_scenes(spec, prompts)
    assert (first.request.seed, first.family) == (7, "f")
    judged = json.loads(first.request.suite_scene)
    assert (judged["id"], judged["events"][0]["a"]) == ("0000000", "car")
    assert second.request.suite_scene == ""
    assert plan_scenes(spec, prompts)[1].request.seed == second.request.seed
    assert kept_prompts(prompts_text(prompts)) == prompts


def test_all_mistakes_of_a_prompts_file_are_told_with_their_lines(tmp_path: Path) -> None:
    path = tmp_path / "p.jsonl"
    bad_event = {"prompt": "x", "expect": {"events": [{"id": "e1", "type": "explodes", "a": "x"}]}}
    lines = ['{"prompt": "good"}', "no json", '{"text": 1}', '{"prompt": "a", "seed": -1}',
             '{"prompt": " "}', json.dumps(bad_event)]  # fmt: skip
    path.write_text("\n".join(lines))
    with pytest.raises(UserError) as error:
        read_prompts(path)
    text = str(error.value)
    assert all(f"line {n}:" in text for n in (2, 3, 4, 5, 6))
    assert "explodes" in text
    assert "line 1:" not in text


def test_missing_empty_and_binary_prompts_files(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="does not exist"):
        read_prompts(tmp_path / "nope.txt")
    with pytest.raises(UserError, match="folder"):
        read_prompts(tmp_path)
    (tmp_path / "e.txt").write_text("\n# only this\n")
    with pytest.raises(UserError, match="no prompts"):
        read_prompts(tmp_path / "e.txt")
    (tmp_path / "b.txt").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(UserError, match="UTF-8"):
        read_prompts(tmp_path / "b.txt")


def test_equal_specifications_have_equal_names() -> None:
    assert sampled(10).name() == sampled(10).name()
    assert len({sampled(10).name(), sampled(11).name(), sampled(10, seed=1).name()}) == 3
    assert DatasetSpec.model_validate_json(sampled(10).canonical()) == sampled(10)
    assert sampled(10, seed=1).differences(sampled(10)) == ["seed: 1, not 0"]
