"""The page of a study and the analysis of its answers; all answers here are synthetic."""

from __future__ import annotations

import json
import math
from pathlib import Path
import re
import subprocess
import sys

import pytest

from esg.outcomes import UserError
from esg.study.analysis import (
    PAPER,
    estimate,
    preferences_of,
    ratings_of,
    read_answers,
    read_key,
    wilson,
)
from esg.study.clips import find_clips
from esg.study.page import write_study
from tests.study.samples import PROMPTS, VARIANTS, synthetic_answers, write_answers, write_run

ROOT = Path(__file__).parents[2]


@pytest.fixture
def written(tmp_path: Path) -> tuple[Path, Path]:
    clips = find_clips(write_run(tmp_path / "run"), VARIANTS, 0, 7)
    return write_study(clips, tmp_path / "study.html", seed=7, pairs="full")


def data_of(page: Path) -> dict:
    found = re.search(r'id="data">(.*?)</script>', page.read_text(), re.S)
    assert found
    return json.loads(found[1])


def test_the_page_holds_every_film_and_no_variant(written: tuple[Path, Path]) -> None:
    page, key = written
    text, data = page.read_text(), data_of(page)
    assert {clip["prompt"] for clip in data["clips"]} == set(PROMPTS.values())
    assert len(data["clips"]) == 4 and len(data["pairs"]) == 2
    assert not any(variant in text for variant in VARIANTS)
    assert "S1-run0" not in text
    ids = [clip["id"] for clip in data["clips"]]
    assert ids == sorted(ids) and all(pair == sorted(pair) for pair in data["pairs"])
    assert {c["variant"] for c in json.loads(key.read_text())["clips"].values()} == set(VARIANTS)


def test_nothing_of_a_prompt_becomes_markup_and_nothing_is_fetched(
    written: tuple[Path, Path],
) -> None:
    text = written[0].read_text()
    assert "<b>car" not in text and text.count("</script>") == 2
    assert "default-src 'none'" in text
    assert not re.search(r"(?:src|href)=\"?https?:", text) and "fetch(" not in text


def test_equal_runs_and_seeds_give_equal_pages(tmp_path: Path, written: tuple[Path, Path]) -> None:
    clips = find_clips(tmp_path / "run", VARIANTS, 0, 7)
    again = write_study(clips, tmp_path / "again.html", seed=7, pairs="full")
    assert again[0].read_bytes() == written[0].read_bytes()
    other = write_study(clips, tmp_path / "other.html", seed=8, pairs="full")
    assert other[0].read_bytes() != written[0].read_bytes()


def test_what_is_missing_is_told_at_once(tmp_path: Path) -> None:
    run = write_run(tmp_path / "run")
    with pytest.raises(UserError) as caught:
        find_clips(run, ("full", "no_global", "no_initial", "full"), 0, 0)
    said = str(caught.value)
    assert "'no_global'" in said and "'no_initial'" in said and "'full' several times" in said
    for scene in PROMPTS:
        (run / "no_dynamic" / scene / "preview.mp4").unlink()
    with pytest.raises(UserError, match="full has 2, no_dynamic has 0"):
        find_clips(run, VARIANTS, 0, 0)


def test_a_scene_with_another_prompt_is_not_the_same_scene(tmp_path: Path) -> None:
    run = write_run(tmp_path / "run")
    (run / "full" / "S1-run0" / "prompt.txt").write_text("A cat.")
    with pytest.raises(UserError, match="S1-run0 has another prompt"):
        find_clips(run, VARIANTS, 0, 0)


def test_the_analysis_gives_means_over_participants_with_student_s_intervals(
    tmp_path: Path, written: tuple[Path, Path]
) -> None:
    raw = json.loads(written[1].read_text())
    key = read_key(written[1])
    answers = read_answers(write_answers(tmp_path, raw, 4), key)
    found = ratings_of(answers, key)["full"]["quality"]
    # Two said 5 and two said 4: mean 4.5, deviation sqrt(1/3), t(3) = 3.1824.
    assert (found.mean, found.participants) == (4.5, 4)
    assert found.std == pytest.approx(math.sqrt(1 / 3))
    half = 3.182446305 * math.sqrt(1 / 3) / 2
    assert (found.low, found.high) == pytest.approx((4.5 - half, 4.5 + half))
    preferred = {p.question: p for p in preferences_of(answers, key)}
    assert (preferred["quality"].wins, preferred["quality"].losses) == (8, 0)
    assert preferred["alignment"].same == 8 and math.isnan(preferred["alignment"].low)


def test_intervals_are_the_textbook_s() -> None:
    assert wilson(8, 10) == pytest.approx((0.4901625, 0.9433178), abs=1e-6)
    one = estimate([3.0])
    assert one.mean == 3.0 and math.isnan(one.low) and one.to_json()["interval"] is None


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"study": "other"}, "it answers study 'other'"),
        ({"consent": False}, "it holds no consent"),
        ({"ratings": []}, "4 of 4 clips are not rated"),
        ({"pairs": [{"first": "x", "second": "y"}]}, "pairs/0 was not shown"),
        ({"format": "else"}, "it is no file of answers"),
    ],
)
def test_answers_that_cannot_count_are_refused(
    change: dict, message: str, tmp_path: Path, written: tuple[Path, Path]
) -> None:
    raw = json.loads(written[1].read_text())
    path = tmp_path / "answers.json"
    path.write_text(json.dumps(synthetic_answers(raw, 1) | change))
    with pytest.raises(UserError, match=re.escape(message)):
        read_answers([path], read_key(written[1]))


def test_a_participant_counts_once_and_ratings_have_five_points(
    tmp_path: Path, written: tuple[Path, Path]
) -> None:
    raw = json.loads(written[1].read_text())
    first, second = write_answers(tmp_path, raw, 2)
    second.write_text(first.read_text())
    broken = synthetic_answers(raw, 5)
    broken["ratings"][0]["quality"] = 6
    third = tmp_path / "third.json"
    third.write_text(json.dumps(broken))
    with pytest.raises(UserError) as caught:
        read_answers([first, second, third], read_key(written[1]))
    assert "has answered in" in str(caught.value) and "is 6, not 1 to 5" in str(caught.value)


def test_the_command_writes_and_analyses(tmp_path: Path) -> None:
    def command(*arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-m", "esg", "study", *arguments],
            capture_output=True, text=True, cwd=ROOT, check=False,
        )  # fmt: skip

    run = write_run(tmp_path / "run")
    page = tmp_path / "study.html"
    done = command(str(run), "--variants", "full,no_dynamic", "--out", str(page))
    assert done.returncode == 0 and "4 clips of 2 scenes in 2 variants" in done.stdout, done.stderr
    key = tmp_path / "study.key.json"
    files = write_answers(tmp_path, json.loads(key.read_text()), 3)
    told = command("--analyse", *map(str, files), "--key", str(key))
    assert told.returncode == 0 and "3 participants" in told.stdout, told.stderr
    assert PAPER["no_dynamic"][1] in told.stdout
    wrong = command(str(run), "--variants", "full,absent", "--pairs", "x", "--out", str(page))
    assert wrong.returncode == 2 and "'absent'" in wrong.stderr and "--pairs 'x'" in wrong.stderr
