"""Request files: stages by hand, answers that are late, doubled, cut off, malformed or foreign."""

from __future__ import annotations

from collections.abc import Callable
import contextlib
import json
from pathlib import Path
from typing import Any

import pytest

from esg.commands.draft import draft as draft_command
from esg.commands.drafting import Drafting
from esg.draft.llm.drafter import draft_llm, draft_llm_batch
from esg.draft.llm.gathering import Gathered, gather, replaying
from esg.draft.llm.requestfiles import answer_files
from esg.draft.llm.scripted import ScriptedModel
from esg.draft.llm.settings import LlmSettings
from esg.graph import canonical_json, verify
from esg.outcomes import Outcome, UserError

CHAIN = "A car collides with a trashbin, knocking the trashbin to collide with a picnic table."
STATIC = "A table with a vase."
BALL = "A ball hits a box."
PROMPTS = (CHAIN, STATIC, BALL)
MODEL = "scripted-2026"

Answer = Callable[[dict[str, Any]], str]


def by(model: ScriptedModel) -> Answer:
    """Answers requests as a model does."""

    def answer(request: dict[str, Any]) -> str:
        talk = [(m["role"], m["content"]) for m in request["body"]["messages"]]
        assert talk[0][0] == "system"
        stage = request["body"]["response_format"]["json_schema"]["name"]
        return model.answer(stage, talk[1:], request["body"]["seed"])

    return answer


PERFECT = by(ScriptedModel(0.0, 0.0))


def requests(folder: Path) -> list[dict[str, Any]]:
    lines = (folder / "requests.jsonl").read_text(encoding="utf-8").splitlines()
    return [json.loads(line) for line in lines]


def line(request: dict[str, Any], text: Any, **more: Any) -> str:
    """An answer in the form of the batch interface."""
    choice = {"message": {"role": "assistant", "content": text}, "finish_reason": "stop", **more}
    usage = {"prompt_tokens": 11, "completion_tokens": 7}
    body = {"model": MODEL, "choices": [choice], "usage": usage}
    row = {"custom_id": request["custom_id"], "response": {"status_code": 200, "body": body}}
    return json.dumps(row) + "\n"


def respond(folder: Path, name: str, answer: Answer = PERFECT) -> None:
    """Answers all open requests in a new file."""
    text = "".join(line(r, answer(r)) for r in requests(folder))
    (folder / name).write_text(text, encoding="utf-8")


def finish(
    folder: Path, prompts: tuple[str, ...] = PROMPTS, answer: Answer = PERFECT, **more: Any
) -> Gathered:
    """Asks and answers until nothing waits."""
    for k in range(12):
        found = gather(prompts, folder, **more)
        if not found.requests:
            return found
        respond(folder, f"answers-{k}.jsonl", answer)
    raise AssertionError("it never ends")


def files(folder: Path) -> dict[str, bytes]:
    return {p.name: p.read_bytes() for p in sorted(folder.iterdir())}


def test_stages_follow_one_another(tmp_path: Path) -> None:
    """Write the requests of all scenes, then the next stage's, until all are drafted."""
    found = gather(PROMPTS, tmp_path)
    first = requests(tmp_path)
    assert found.waiting == len(first) == 3 and not found.problems
    assert {r["custom_id"].split("-")[:2][0] for r in first} == {"scene"}
    for r in first:
        assert r["method"] == "POST" and r["url"] == "/v1/chat/completions"
        assert len(r["custom_id"]) <= 64
        assert [m["role"] for m in r["body"]["messages"]] == ["system", "user"]
        assert r["body"]["response_format"]["type"] == "json_schema"
    respond(tmp_path, "one.jsonl")
    found = gather(PROMPTS, tmp_path)
    # The static scene is drafted; the others wait for their timelines.
    assert [d.waiting for d in found.drafts] == [True, False, True]
    assert {r["custom_id"].partition("-")[0] for r in requests(tmp_path)} == {"timeline"}
    respond(tmp_path, "two.jsonl")
    found = gather(PROMPTS, tmp_path)
    assert found.requests == 0 and requests(tmp_path) == [] and not found.problems
    for made in found.drafts:
        assert made.outcome is Outcome.SOLVED and made.document is not None
        assert verify(made.document) == ()
        assert made.document.provenance[0].config["model"] == MODEL
    assert [d.input_tokens for d in found.drafts] == [22, 11, 22]


def test_drafts_are_those_of_a_server(tmp_path: Path) -> None:
    """Draft by files what the same fallible model drafts when it is asked directly."""
    config = LlmSettings(model=MODEL, max_rounds=8)
    found = finish(tmp_path, answer=by(ScriptedModel(0.3, 0.1)), settings=config)
    assert sum(made.rounds for made in found.drafts) >= 1
    for made, prompt in zip(found.drafts, PROMPTS, strict=True):
        asked = draft_llm_batch([prompt], settings=config, client=ScriptedModel(0.3, 0.1))[0]
        assert made.rounds == asked.rounds and made.repairs == asked.repairs
        assert made.document is not None and asked.document is not None
        told = {"provenance": ()}  # it counts other tokens
        assert made.document.model_copy(update=told) == asked.document.model_copy(update=told)


def test_a_rerun_writes_the_same_bytes(tmp_path: Path) -> None:
    """Change no file without new answers, at any stage."""
    model = by(ScriptedModel(0.5, 0.2))
    for k in range(12):
        found = gather(PROMPTS, tmp_path)
        before = files(tmp_path)
        gather(PROMPTS, tmp_path)
        assert files(tmp_path) == before
        if not found.requests:
            break
        respond(tmp_path, f"answers-{k}.jsonl", model)
    assert found.requests == 0 and k >= 2


def test_answers_may_come_in_any_files_and_order(tmp_path: Path) -> None:
    """Give the same cassette for answers in one file, or in many files, backwards."""
    one, many = tmp_path / "one", tmp_path / "many"
    finish(one)
    for _ in range(3):
        if not gather(PROMPTS, many).requests:
            break
        for r in reversed(requests(many)):
            (many / f"zz-{r['custom_id']}.jsonl").write_text(line(r, PERFECT(r)))
    assert (one / "cassette.jsonl").read_bytes() == (many / "cassette.jsonl").read_bytes()


def test_half_of_the_answers(tmp_path: Path) -> None:
    """Go on with the scenes that are answered, and keep the others' requests open."""
    gather(PROMPTS, tmp_path)
    opened = requests(tmp_path)
    (tmp_path / "a.jsonl").write_text(line(opened[0], PERFECT(opened[0])))
    found = gather(PROMPTS, tmp_path)
    names = {r["custom_id"] for r in requests(tmp_path)}
    assert {r["custom_id"] for r in opened[1:]} <= names and opened[0]["custom_id"] not in names
    assert found.waiting >= 2


@pytest.mark.parametrize(
    ("spoil", "kind", "is_open"),
    [
        (lambda text: text[: len(text) // 2], "unreadable", True),
        (lambda text: "[1, 2]\n", "unreadable", True),
        (lambda text: text.replace('"custom_id"', '"id"'), "unreadable", True),
        (lambda text: text.replace('"status_code": 200', '"status_code": 429'), "failed", True),
        (lambda text: text.replace('"response"', '"error": "quota", "response"'), "failed", True),
        (lambda text: text.replace('"choices"', '"chosen"'), "empty", True),
        (lambda text: text.replace('"custom_id": "scene', '"custom_id": "other'), "foreign", True),
        (lambda text: text + text, "doubled", False),
        (lambda text: text.replace('"stop"', '"length"'), "cut_off", False),
        (lambda text: "\xff\xfe" + text, "unreadable", True),
    ],
)
def test_bad_answers_are_told(
    tmp_path: Path, spoil: Callable[[str], str], kind: str, is_open: bool
) -> None:
    """Name file, line and request of a bad answer with a remedy, and mix nothing up."""
    gather((BALL,), tmp_path)
    request = requests(tmp_path)[0]
    text = spoil(line(request, PERFECT(request)))
    (tmp_path / "bad.jsonl").write_bytes(text.encode("latin-1"))
    found = gather((BALL,), tmp_path)
    (problem,) = found.problems
    assert problem.kind == kind and problem.file == "bad.jsonl"
    assert problem.line == (2 if kind == "doubled" else 1)
    assert problem.remedy and problem.message and str(problem).startswith("bad.jsonl, line ")
    told = [json.loads(x) for x in (tmp_path / "problems.jsonl").read_text().splitlines()]
    assert [p["kind"] for p in told] == [kind]
    names = [r["custom_id"] for r in requests(tmp_path)]
    assert (request["custom_id"] in names) is is_open
    # A good answer beside it is taken, and the scene is finished.
    if is_open:
        (tmp_path / "good.jsonl").write_text(line(request, PERFECT(request)))
    assert finish(tmp_path, (BALL,)).drafts[0].outcome is Outcome.SOLVED


def test_of_two_answers_the_first_is_used(tmp_path: Path) -> None:
    """Use the first of two different answers, whatever the second says."""
    gather((BALL,), tmp_path)
    request = requests(tmp_path)[0]
    good = PERFECT(request)
    other = json.dumps(json.loads(good[good.find("{") : good.rfind("}") + 1]) | {"spatial": {}})
    (tmp_path / "a.jsonl").write_text(line(request, good))
    (tmp_path / "b.jsonl").write_text(line(request, other))
    found = gather((BALL,), tmp_path)
    assert [p.kind for p in found.problems] == ["doubled"]
    assert "another answer" in found.problems[0].message
    assert found.problems[0].file == "b.jsonl"
    assert found.drafts[0].calls[0].text == good


def test_an_answer_cut_off_is_asked_for_once_more_and_briefer(tmp_path: Path) -> None:
    """Ask anew, in the next round, for what stopped at the limit of its length."""
    gather((BALL,), tmp_path)
    request = requests(tmp_path)[0]
    (tmp_path / "a.jsonl").write_text(line(request, PERFECT(request)[:200], finish_reason="length"))
    found = gather((BALL,), tmp_path)
    assert [p.kind for p in found.problems] == ["cut_off"]
    (again,) = requests(tmp_path)
    assert again["custom_id"].startswith("scene-r1-")
    assert "be briefer" in again["body"]["messages"][-1]["content"]


def test_late_answers_are_told(tmp_path: Path) -> None:
    """Leave out an answer to a request whose scene is no longer asked for."""
    gather(PROMPTS, tmp_path)
    respond(tmp_path, "all.jsonl")
    found = gather((BALL,), tmp_path)
    assert [p.kind for p in found.problems] == ["late", "late"]
    assert all(p.file == "all.jsonl" and p.custom_id for p in found.problems)
    assert len(found.drafts) == 1 and found.requests == 1


def test_answers_of_another_folder_are_foreign(tmp_path: Path) -> None:
    """Take no answer to a request that this folder never asked."""
    here, there = tmp_path / "here", tmp_path / "there"
    gather((BALL,), here)
    gather((CHAIN,), there)
    respond(there, "a.jsonl")
    (here / "a.jsonl").write_bytes((there / "a.jsonl").read_bytes())
    found = gather((BALL,), here)
    assert [p.kind for p in found.problems] == ["foreign"] and found.requests == 1


def test_equal_scenes_share_their_requests(tmp_path: Path) -> None:
    """Ask once for equal prompts of one seed, and anew for another seed."""
    assert gather((BALL, BALL), tmp_path / "a", seed=[3, 3]).requests == 1
    assert gather((BALL, BALL), tmp_path / "b", seed=[3, 4]).requests == 2


def test_a_repair_round_is_another_request(tmp_path: Path) -> None:
    """Tell a broken rule with its place and remedy, in a request of the next round."""
    gather((BALL,), tmp_path)

    def heavy(request: dict[str, Any]) -> str:
        text = PERFECT(request)
        tree = json.loads(text[text.find("{") : text.rfind("}") + 1])
        if request["custom_id"].startswith("scene-r0"):
            tree["assets"]["assets"][1]["mass_kg"] = -1.0
        return json.dumps(tree)

    respond(tmp_path, "1.jsonl", heavy)
    gather((BALL,), tmp_path)
    respond(tmp_path, "2.jsonl", heavy)
    found = gather((BALL,), tmp_path)
    (request,) = requests(tmp_path)
    assert request["custom_id"].startswith("scene-r1-")
    told = request["body"]["messages"][-1]["content"]
    assert "/asset_requirement/" in told and "UNIT_MASS" in told and found.waiting == 1
    respond(tmp_path, "3.jsonl")
    assert finish(tmp_path, (BALL,)).drafts[0].rounds == 1


def test_answers_become_a_cassette(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Replay a folder's answers without a server, with the model's own name and tokens."""
    found = finish(tmp_path)
    with replaying(tmp_path):
        doc = draft_llm(CHAIN)
        with pytest.raises(UserError, match="holds no reply"):
            draft_llm("A dog runs.")
    made = found.drafts[0].document
    assert made is not None and canonical_json(doc) == canonical_json(made)
    records = [json.loads(x) for x in (tmp_path / "cassette.jsonl").read_text().splitlines()]
    assert {r["reply"]["model"] for r in records} == {MODEL}
    assert all(r["reply"]["input_tokens"] == 11 for r in records)


def test_no_key_is_written(tmp_path: Path) -> None:
    """Scrub the key from whatever comes back."""
    secret = "sk-very-secret-0123456789"
    config = LlmSettings(api_key=secret)  # type: ignore[arg-type]  # pydantic takes a text

    def leaking(request: dict[str, Any]) -> str:
        text = PERFECT(request)
        tree = json.loads(text[text.find("{") : text.rfind("}") + 1])
        if "expansion" in tree:
            tree["expansion"]["expanded_description"] += f" {secret}"
        return json.dumps(tree)

    finish(tmp_path, answer=leaking, settings=config)
    own = set(files(tmp_path)) - {p.name for p in answer_files(tmp_path)}
    assert "cassette.jsonl" in own
    for name in own:
        assert secret.encode() not in (tmp_path / name).read_bytes()


def test_a_damaged_ledger_is_told(tmp_path: Path) -> None:
    """Say what to do when the list of what was asked is not what was written."""
    gather((BALL,), tmp_path)
    (tmp_path / "asked.jsonl").write_text("no json\n")
    with pytest.raises(UserError, match=r"asked\.jsonl cannot be read"):
        gather((BALL,), tmp_path)


def test_rules_ask_no_model(tmp_path: Path) -> None:
    """Refuse request files for a drafter that asks nobody."""
    with pytest.raises(UserError, match="--drafter llm or auto"):
        draft_command(BALL, drafting=Drafting("rules", tmp_path))
    with pytest.raises(UserError, match="either a prompt or --prompts"):
        draft_command()


def test_draft_a_file_of_prompts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Exit with 3 while scenes wait, then write a document a prompt and what became of each."""
    prompts, batch, out = tmp_path / "p.txt", tmp_path / "batch", tmp_path / "out"
    prompts.write_text("\n".join(PROMPTS) + "\n")
    drafting = Drafting("llm", batch)
    for k, waiting in enumerate((3, 2)):
        assert draft_command(prompts=prompts, out=out, drafting=drafting, json=True) == 3
        told = json.loads(capsys.readouterr().out)
        assert told["waiting"] == told["waiting_for"]["waiting"] == waiting
        assert told["waiting_for"]["requests"] == waiting
        respond(batch, f"{k}.jsonl")
    assert draft_command(prompts=prompts, out=out, drafting=drafting) == 0
    assert "3 of 3 prompts drafted" in capsys.readouterr().out
    rows = [json.loads(x) for x in (out / "drafts.jsonl").read_text().splitlines()]
    assert [r["prompt"] for r in rows] == list(PROMPTS)
    assert {r["outcome"] for r in rows} == {"solved"} and rows[0]["models"] == [MODEL]
    for row in rows:
        assert verify(json.loads((out / row["document"]).read_bytes())) == ()


def test_auto_falls_back_on_the_rules(tmp_path: Path) -> None:
    """Draft by the rules what the model could not, and say so; `llm` fails there."""
    prompts, batch, out = tmp_path / "p.txt", tmp_path / "batch", tmp_path / "out"
    prompts.write_text(BALL + "\n")
    for k in range(12):
        draft_command(prompts=prompts, out=out, drafting=Drafting("auto", batch))
        if not requests(batch):
            break
        respond(batch, f"{k}.jsonl", lambda request: "no idea")
    row = json.loads((out / "drafts.jsonl").read_text())
    assert row["outcome"] == "solved" and row["drafter"] == "rules"
    assert "unusable" in row["model_failed"]
    assert draft_command(prompts=prompts, out=out, drafting=Drafting("llm", batch)) == 3


@pytest.mark.parametrize("at", range(5))
def test_interrupted_anywhere_it_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, at: int
) -> None:
    """Leave whole files behind when a write is interrupted, and end as if nothing had happened."""
    from esg.draft.llm import requestfiles

    model = by(ScriptedModel(0.4, 0.1))
    whole, broken = tmp_path / "whole", tmp_path / "broken"
    finish(whole, answer=model, settings=LlmSettings(max_rounds=8))
    real = requestfiles.write_whole

    def interrupted(count: list[int]) -> Callable[[Path, str], None]:
        def write(path: Path, text: str) -> None:
            count[0] += 1
            if count[0] == at + 1:
                raise KeyboardInterrupt
            real(path, text)

        return write

    for k in range(12):
        monkeypatch.setattr(requestfiles, "write_whole", interrupted([0]))
        with contextlib.suppress(KeyboardInterrupt):
            gather(PROMPTS, broken, settings=LlmSettings(max_rounds=8))
        monkeypatch.setattr(requestfiles, "write_whole", real)
        for path in broken.glob("*.jsonl"):
            for text in path.read_text().splitlines():
                json.loads(text)
        if not gather(PROMPTS, broken, settings=LlmSettings(max_rounds=8)).requests:
            break
        respond(broken, f"answers-{k}.jsonl", model)
    names = ("requests.jsonl", "asked.jsonl", "cassette.jsonl", "problems.jsonl")
    assert {n: files(broken)[n] for n in names} == {n: files(whole)[n] for n in names}


def test_another_model_drafts_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Keep drafts of the rules whatever the model is, and no other model's for an llm's."""
    from esg.pipeline import SceneRequest
    from esg.stages import configuration

    def told(drafter: str) -> dict[str, Any]:
        return configuration("draft", SceneRequest(BALL, drafter=drafter))

    rules, first = told("rules"), told("llm")
    monkeypatch.setenv("ESG_LLM_BASE_URL", "http://localhost:1/v1")
    monkeypatch.setenv("ESG_LLM_MODEL", "a")
    second = told("llm")
    monkeypatch.setenv("ESG_LLM_MODEL", "b")
    assert first != second != told("llm") and told("rules") == rules
    finish(tmp_path / "x", (BALL,))
    with replaying(tmp_path / "x"):
        third = told("llm")
        (tmp_path / "x" / "cassette.jsonl").write_text("")
        assert told("llm") != third


def test_auto_shows_what_the_rules_read_otherwise(tmp_path: Path) -> None:
    """Warn in a batch, too, of a hit that only the model has."""
    prompts, batch, out = tmp_path / "p.txt", tmp_path / "batch", tmp_path / "out"
    prompts.write_text("A ball rolls past a box.\n")

    def hitting(request: dict[str, Any]) -> str:
        text = PERFECT(request)
        tree = json.loads(text[text.find("{") : text.rfind("}") + 1])
        for event in tree.get("events", ()):
            if event["event"] == "Miss":
                event["event"] = "Collision"
        return json.dumps(tree)

    for k in range(3):
        draft_command(prompts=prompts, out=out, drafting=Drafting("auto", batch))
        if requests(batch):
            respond(batch, f"{k}.jsonl", hitting)
    row = json.loads((out / "drafts.jsonl").read_text())
    warnings = json.loads((out / row["document"]).read_bytes())["coverage"]["warnings"]
    assert any('a hit of "ball" and "box"; the rules read none' in w for w in warnings)
