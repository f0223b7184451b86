"""The benchmark of single scenes compares checkouts, with two tiny ones in place of this."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks import single
from benchmarks.single import Checkout, Cost, line, measured, other_files

_CLI = """
import json, pathlib, sys, time
arguments = sys.argv[1:]
seed = arguments[arguments.index("--seed") + 1]
folder = pathlib.Path("scenes") / ("ball-" + seed)
folder.mkdir(parents=True)
end = time.process_time() + BURNT
while time.process_time() < end: pass
(folder / "log.jsonl").write_text(str(BURNT))
(folder / "esg.json").write_text(arguments[1] + TEXT)
print(json.dumps({"folder": str(folder), "stages": [{"stage": "record", "seconds": BURNT}]}))
sys.exit(CODE)
"""

_LATER = """
import os
(folder / ".finishing").write_text(json.dumps({"pid": os.getpid()}))
pid = os.fork()
if pid == 0:
    for number in range(3): os.close(number)
    (folder / ".finishing").write_text(json.dumps({"pid": os.getpid()}))
    time.sleep(0.5)
    (folder / "SHA256SUMS").write_text("")
    (folder / ".finishing").unlink()
    os._exit(0)
while str(pid) not in (folder / ".finishing").read_text(): time.sleep(0.01)
"""


def _checkout(root: Path, burnt: float, text: str = "", code: int = 0) -> Checkout:
    head = f"BURNT = {burnt}\nTEXT = {text!r}\nCODE = {code}\n"
    (root / "tree" / "esg").mkdir(parents=True)
    (root / "tree" / "esg" / "__init__.py").write_text("")
    (root / "tree" / "esg" / "cli.py").write_text(head + _CLI)
    (root / "work").mkdir()
    return Checkout(root / "tree", root / "work")


def test_costs_are_those_of_each_checkout_and_times_are_not_compared(tmp_path: Path) -> None:
    ours, theirs = (
        _checkout(tmp_path / "a", 0.0, code=3),  # a scene that failed has a folder, too
        _checkout(tmp_path / "b", 0.6),
    )
    costs, unlike = measured([ours, theirs], "A ball.", [5, 6])
    assert unlike == {5: [], 6: []}
    assert all(b.core_seconds - a.core_seconds > 0.3 for a, b in zip(*costs, strict=True))
    assert all(c.seconds > 0.5 and c.stages == {"record": 0.6} for c in costs[1])


def test_files_that_differ_are_told(tmp_path: Path) -> None:
    found = [_checkout(tmp_path / "a", 0.0), _checkout(tmp_path / "b", 0.0, text="!")]
    costs, unlike = measured(found, "A ball.", [5])
    assert unlike == {5: ["esg.json"]}
    (costs[0][0].folder / "extra.png").write_bytes(b"")
    assert other_files(costs[0][0].folder, costs[1][0].folder) == ["esg.json", "extra.png"]


def test_a_command_that_fails_ends_the_measurement(tmp_path: Path) -> None:
    with pytest.raises(single.subprocess.CalledProcessError):
        _checkout(tmp_path / "a", 0.0, code=1).made("A ball.", 5)


def test_a_line_has_minimum_and_median() -> None:
    costs = [Cost(s, 3 * s, 2 * s, Path(), {}) for s in (3.0, 1.0, 2.0)]
    assert line("here", costs).split() == ["here", "1.00", "2.00", "3.00", "6.00", "2.00", "4.00"]


def test_a_folder_is_waited_for_until_it_is_complete(tmp_path: Path) -> None:
    """Time to the answer and until the folder is complete are two, what it takes counts."""
    ours = _checkout(tmp_path / "a", 0.0)
    cli = tmp_path / "a" / "tree" / "esg" / "cli.py"
    cli.write_text(cli.read_text().replace("print(json", _LATER + "print(json").replace(
        '"folder": str(folder)', '"folder": str(folder), "finishing": ["preview.png"]'))  # fmt: skip
    cost = ours.made("A ball.", 5)
    assert (cost.folder / "SHA256SUMS").exists()
    assert cost.whole_s - cost.seconds > 0.1


def test_a_folder_that_is_never_completed_is_told(tmp_path: Path) -> None:
    (tmp_path / ".finishing").write_text('{"pid": 4194305}')  # larger than any
    with pytest.raises(TimeoutError, match="never completed"):
        single.finished(tmp_path)
