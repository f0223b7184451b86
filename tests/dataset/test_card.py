"""The card: facts of a dataset that is known by heart, and their text."""

from __future__ import annotations

import json
from pathlib import Path
import re
import subprocess
import sys
from typing import Any

from PIL import Image
import pytest

from esg.dataset.card import CARD, untimed, write_card
from esg.dataset.card.facts.failures import cause
from esg.dataset.card.markdown import cell, table
from esg.dataset.card.recipes import recipes
from esg.dataset.card.sheet import TILE_PX
from esg.dataset.distribution import Distribution
from esg.dataset.plan import DatasetSpec, RenderSpec
from esg.store.assembling import assemble_tables
from esg.store.shapes import parameters
from esg.store.tables import to_table, write_part
from tests.dataset.clips.synthetic import write_synthetic

MIX = Distribution(
    places={"unsaid": 1.0, "park": 3.0}, lights={"dusk": 1.0}, bystanders={"0": 1.0, "5": 1.0},
    colors={"red": 1.0}, cameras={"orbit": 1.0},
)  # fmt: skip
SPEC = DatasetSpec(
    source="sample", n=3, seed=7, distribution=MIX, thin=True,
    render=RenderSpec(channels=("rgb", "depth"), cameras=2),
)  # fmt: skip
DRAWN = [
    {"mover": "ball", "place": "park", "light": "dusk", "mover_color": "red"},
    {"mover": "car", "light": "dusk", "color": "red", "n_bystanders": 5,
     "bystanders": "3 person, 2 bench"},
    {"mover": "ball", "place": "park"},
]  # fmt: skip


@pytest.fixture(scope="module")
def card(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, Any], str]:
    """A dataset's folder with tables of all kinds, its facts and its card."""
    out = tmp_path_factory.mktemp("set")
    base = [{"run_id": "r", "scene_key": f"r/-/S{k}/{k}", "suite": "", "scene_id": f"S{k}",
             "seed": k, "prompt": f"A prompt | {k}."} for k in range(3)]  # fmt: skip
    rows: dict[str, list[dict[str, Any]]] = {
        "scenes": [
            {**b, "split": "train", "family": "f", "outcome": "solved", "verified": k != 1,
             "parameters": parameters(DRAWN[k]), "plausible": True, "fully_understood": True,
             "esg_resolve": json.dumps({"asset_configurations": {
                 "a": {"license": "CC-BY-4.0", "attribution": "Somebody"}, "b": {
                     "license": "Apache-2.0", "attribution": ""}}})}
            for k, b in enumerate(base)
        ],
        "truth_checks": [
            {**b, "camera": 0, "check_name": "flow", "unit": "px", "samples": 100, "p50": 0.01,
             "p90": 0.02, "p99": 0.03 + 0.1 * (k == 2), "worst": 0.5, "limit_value": 0.1,
             "ok": k != 2, "note": ""}
            for k, b in enumerate(base)
        ],
        "clips": [write_synthetic(out, run_id="r", scene_id=f"S{k}", seed=k).row()
                  for k in range(3)],
    }  # fmt: skip
    for name, found in rows.items():
        write_part(to_table(name, found), out / "parts" / name / "batch.parquet")
    (out / "meta").mkdir()
    (out / "meta" / "timings.json").write_text(
        json.dumps({"scenes": 3, "seconds": {"draft": 3.0, "render": 6.0, "cast": 0.0}})
    )
    (out / "meta" / "run.json").write_text(json.dumps({"machine": "x86_64, 2 cores, cpu"}))
    (out / "meta" / "layouts.json").write_text(json.dumps(["movi", "webdataset"]))
    (out / "meta" / "duplicates.jsonl").write_text(
        json.dumps({"scene_key": "r/-/S9/9", "duplicate_of": "r/-/S0/0"}) + "\n"
    )
    counts = assemble_tables(out / "parts", out)
    failed = [{"outcome": "crashed", "stage": "layout", "reason": "bin_1 fell 3 m", "scene": "S8"}]
    facts = write_card(out, SPEC, counts, failed)
    return out, facts, (out / CARD).read_text()


def test_the_hub_reads_its_metadata(card: tuple[Path, dict[str, Any], str]) -> None:
    from huggingface_hub import DatasetCard

    data = DatasetCard.load(card[0] / CARD).data.to_dict()
    assert data["license"] == "apache-2.0" and data["size_categories"] == ["n<1K"]
    assert "text-to-video" in data["task_categories"]
    configs = {c["config_name"]: c for c in data["configs"]}
    assert set(configs) == {"scenes", "clips", "truth_checks"} and configs["scenes"]["default"]
    assert configs["clips"]["data_files"] == [{"split": "train", "path": "clips/train-*.parquet"}]


def test_facts_are_those_of_the_tables(card: tuple[Path, dict[str, Any], str]) -> None:
    facts = card[1]
    assert (facts["scenes"], facts["verified"], facts["plausible"]) == (3, 2, 3)
    assert facts["drawn"]["place"] == {"park": 2, "unsaid": 1}
    assert facts["drawn"]["color"] == {"red": 2}
    assert facts["drawn"]["bystander"] == {"person": 3, "bench": 2}
    assert facts["duplicates"] == {"found": 1, "kept": 0, "examples": [{"scene": "S9", "of": "S0"}]}
    assert (facts["clips"]["clips"], facts["clips"]["frames"]) == (3, 15)
    flow = facts["truth"]["flow"]
    assert (flow["p99"], flow["highest_p99"], flow["failing"]) == (0.03, 0.13, 1)
    assert {(r["license"], r["attribution"], r["scenes"]) for r in facts["licences"]} == {
        ("CC-BY-4.0", "Somebody", 3), ("Apache-2.0", "", 3)
    }  # fmt: skip
    assert json.loads(json.dumps(facts)) == facts, "it goes into meta/info.json"


@pytest.mark.parametrize(
    "line",
    [
        "| place | park 75%, unsaid 25% | park 2, unsaid 1 |",
        "| color | red 100% | red 2 |",
        "| bystanders | 0 50%, 5 50% | 0 to 5 a scene, 1.67 on average |",
        "Near-duplicates (by motion and words): 1 found, left out of all splits",
        "| flow | 3 | 300 | 0.01 | 0.02 | 0.03 | 0.13 | 0.5 | 0.1 px | 1 |",
        "- flow: S2",
        "| CC-BY-4.0 | Somebody | 3 |",
        "| render | 6.0 | 66.7% | 2.00 | 2.00 |",
        "x86_64, 2 cores, cpu",
        "| 1 | crashed | layout | … fell # m | S8 |",
        "--thin --render rgb,depth --cameras 2 --out FOLDER",
        "![scenes of this dataset, each above its prompt](sheet.jpg)",
        "**webdataset**",
        "**movi**",
        "metres = np.exp(",
        "- Scenery (houses, trees, furniture of a place) has no ids of its own",
    ],
)
def test_the_text_tells(card: tuple[Path, dict[str, Any], str], line: str) -> None:
    assert line in card[2]


def test_what_it_has_nothing_of_it_does_not_tell(
    card: tuple[Path, dict[str, Any], str],
) -> None:
    for title in ("Other engines", "What if", "Captions and questions", "Counterfactual pairs"):
        assert f"## {title}" not in card[2]
    assert "lerobot" not in card[2]


def test_without_its_cost_it_is_always_the_same(card: tuple[Path, dict[str, Any], str]) -> None:
    out, _, text = card
    assert "hours of one process" in text and "hours of one process" not in untimed(text)
    assert "## Failures" in untimed(text) and "## Known limits" in untimed(text)
    (out / "meta" / "timings.json").write_text(
        json.dumps({"scenes": 3, "seconds": {"draft": 30.0, "render": 1.0}})
    )
    sheet = (out / "sheet.jpg").read_bytes()
    counts = assemble_tables(out / "parts", out)
    failed = [{"outcome": "crashed", "stage": "layout", "reason": "bin_1 fell 3 m", "scene": "S8"}]
    assert write_card(out, SPEC, counts, failed) == card[1]
    again = (out / CARD).read_text()
    assert again != text and untimed(again) == untimed(text)
    assert (out / "sheet.jpg").read_bytes() == sheet


def test_the_sheet_shows_every_scene_once(card: tuple[Path, dict[str, Any], str]) -> None:
    with Image.open(card[0] / "sheet.jpg") as sheet:
        assert sheet.width > 3 * TILE_PX[0] and sheet.height > TILE_PX[1]
        # The middle frame of a synthetic clip: a red body on grey.
        red, green, _ = sheet.convert("RGB").resize((3, 1)).getpixel((0, 0))  # type: ignore[misc]
        assert red > green


def test_its_code_is_written_as_ours(tmp_path: Path) -> None:
    """A card that is published in the docs has to pass the same checks as they do."""
    every = {
        "clips": {"channels": ("rgb", "depth", "flow", "segmentation")},
        "layouts": ("webdataset", "lerobot", "movi"),
    }
    blocks = re.findall(r"```python\n(.*?)```", "\n".join(recipes(every)), re.S)
    assert len(blocks) == 6
    for k, block in enumerate(blocks):
        (tmp_path / f"block{k}.py").write_text(block)
    done = subprocess.run(
        [sys.executable, "-m", "ruff", "format", "--check", "--config", "pyproject.toml", tmp_path],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr


def test_cells_stay_in_their_table() -> None:
    assert cell("a | b\nc") == "a \\| b c"
    assert table(("x", "y"), [("a", 1.5)], "lr") == ["| x | y |", "| --- | ---: |", "| a | 1.5 |"]


def test_causes_leave_out_what_differs() -> None:
    assert cause("box_1 misses e2 by 0.3 m; and more") == "… misses … by # m"
