"""A command line with mistakes: all of them at once, each with its value and what would do."""

from __future__ import annotations

import json
from pathlib import Path
import subprocess
import sys

import pytest

from esg.api.inputs import Mistakes, checked, clean_prompt, in_range
from esg.cli import build_app
from esg.commands.parsing import parse
from esg.outcomes import UserError
from tests.cli.test_cli import ROOT, esg


@pytest.mark.parametrize(
    ("line", "lines"),
    [
        (["paint"], ["there is no command 'paint'; choose one of draft,"]),
        (["drfat", "x"], ["did you mean draft?"]),
        (["generate"], ["PROMPT is missing"]),
        (["generate", "--seed"], ["--seed: give a value", "PROMPT is missing"]),
        (["draft", "a", "b"], ["'b': one argument too many"]),
        (["draft", "-5 degree slope"], ["'-5 degree slope' starts with a dash", "put -- before it"]),
        (
            ["generate", "--seed=x", "--drafter", "foo", "--bar"],
            ["--seed x: give a whole number", "--drafter foo: choose rules, llm, auto",
             "option --bar", "PROMPT is missing"],
        ),
        (["export", "--to", "b"], ["--to b: choose unreal, usd,", "SCENE is missing"]),
        (
            ["dataset", "--runner", "z", "--seed", "q", "--json"],
            ["--out is missing", "--runner z: choose process", "--seed q: give"],
        ),
        (["db", "prune", "--db", "x", "--keep-days", "z"], ["--keep-days z: give a number"]),
        (["draft", "x", "--seed", "3", "--seed", "4"], ["--seed is given more than once"]),
        (["draft", "x", "--seed", "1.5"], ["--seed 1.5: give a whole number"]),
        (["draft", "x", "--seed", "--a.b"], ["--seed: give a value", "there is no option --a.b"]),
        (
            ["render", "--cameras=1.0", "--seed", "2.", "--fps", "z"],
            ["--cameras 1.0: give a whole", "--seed 2.: give", "--fps z: give a number",
             "SCENE is missing"],
        ),
        (["serve", "--empty-suite", "--once"], ["there is no option --empty-suite"]),
        (["draft", "x", "--json=maybe"], ["--json maybe: takes no value"]),
    ],
)  # fmt: skip
def test_every_mistake_of_a_line_is_told(line: list[str], lines: list[str]) -> None:
    with pytest.raises(UserError) as error:
        parse(build_app(), line)
    text = str(error.value)
    assert [words for words in lines if words not in text] == []
    problems = [p for p in text.splitlines()[:-1] if p.startswith("  ")]
    assert len(problems or [text]) <= len(lines)
    assert text.endswith("--help` lists what it takes")
    assert error.value.exit_code == 2


def test_numbers_with_a_point_stay_where_they_belong() -> None:
    parse(build_app(), ["replay", "x", "--dt", "0.004"])
    parse(build_app(), ["draft", "--seed", "2", "--", "--a ball of 1.5 kg"])
    with pytest.raises(UserError, match=r"--hz 240\.5: give a whole number"):
        parse(build_app(), ["replay", "0.5", "--hz", "240.5"])


def test_a_good_line_calls_its_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert parse(build_app(), ["--version"])() is None
    assert capsys.readouterr().out.strip()[:1].isdigit()


def test_json_is_printed_for_a_line_that_cannot_be_read(tmp_path: Path) -> None:
    done = esg("generate", "--seed", "x", "--json", cwd=tmp_path)
    document = json.loads(done.stdout)
    assert done.returncode == document["exit_code"] == 2
    assert "--seed x" in document["error"]
    assert "PROMPT is missing" in document["error"]
    assert "─" not in done.stderr  # no box of the parser's


def test_checks_tell_all_mistakes_and_flatten_nested_ones() -> None:
    assert checked(lambda: 1, lambda: "b") == [1, "b"]
    with pytest.raises(Mistakes) as error:
        checked(
            lambda: clean_prompt(" "),
            lambda: checked(
                lambda: in_range("--runs", 0, 1, 5), lambda: in_range("--fps", float("nan"), 1, 2)
            ),
        )
    assert len(error.value.mistakes) == 3
    assert str(error.value).startswith("3 problems\n  the prompt is empty")
    assert "--runs 0: choose 1 to 5" in str(error.value)


def test_the_machine_s_fault_keeps_its_code_unless_the_user_erred_too() -> None:
    def broken() -> None:
        raise UserError("no disk", exit_code=1)

    with pytest.raises(UserError) as error:
        checked(broken)
    assert error.value.exit_code == 1
    with pytest.raises(UserError) as error:
        checked(broken, lambda: clean_prompt(""))
    assert error.value.exit_code == 2


@pytest.mark.parametrize("text", ["a \udcff", "a\x07ball", "a\x9bball"])
def test_prompts_that_are_no_text_are_refused_with_the_place(text: str) -> None:
    with pytest.raises(UserError, match=r"\(character [23]\)"):
        clean_prompt(text)
    assert clean_prompt(" Café 🚗\n\t") == "Café 🚗"


def test_several_bad_options_are_told_together(tmp_path: Path) -> None:
    done = esg("bench", "missing.yaml", "--runs", "0", "--seed", "-1", "--device", "tpu",
               "--workers", "999", "--json", "/dev/null/x.json", cwd=tmp_path)  # fmt: skip
    assert done.returncode == 2
    for words in ("missing.yaml", "--runs 0", "--seed -1", "'tpu'", "--workers 999", "--json"):
        assert words in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_defect_is_one_line_and_json() -> None:
    code = (
        "import sys; sys.argv = ['esg', 'check', 'x.json', '--json']\n"
        "import esg.graph\n"
        "def broken(file): raise KeyError('oops')\n"
        "esg.graph.check_file = broken\n"
        "from esg.cli import main; main()\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 1
    assert json.loads(done.stdout)["exit_code"] == 1
    assert "KeyError: 'oops'" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
def test_a_full_disk_is_told_and_is_no_defect(tmp_path: Path) -> None:
    done = run_shell("check missing.json > /dev/full", tmp_path)
    assert done.returncode == 1
    assert "No space left" in done.stderr
    assert "defect" not in done.stderr
    assert "Exception ignored" not in done.stderr


def test_closed_streams_change_nothing_but_what_is_seen(tmp_path: Path) -> None:
    assert run_shell("check missing.json >&-", tmp_path).returncode == 2
    done = run_shell("check missing.json 2>&-", tmp_path)
    assert done.returncode == 2
    assert "missing.json" in done.stdout


def run_shell(line: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    """Runs `esg LINE` in a shell, with its redirections."""
    return subprocess.run(
        ["sh", "-c", f'"$0" -c "import sys; sys.path.insert(0, sys.argv.pop(1)); '
         f'from esg.cli import main; main()" "$1" {line}', sys.executable, str(ROOT)],
        capture_output=True, text=True, cwd=cwd, timeout=60, check=False,
    )  # fmt: skip


@pytest.mark.parametrize(("given", "guess"), [("--engine", ""), ("--sed", "--seed"), ("-o", "")])
def test_an_option_is_guessed_by_its_letters_alone(given: str, guess: str) -> None:
    """Two dashes make all options alike: --engine is no misspelt --render."""
    with pytest.raises(UserError) as error:
        parse(build_app(), ["generate", "x", given, "3"])
    assert ("did you mean" in str(error.value)) is bool(guess)
    assert guess in str(error.value)
