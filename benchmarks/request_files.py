"""A split of the corpus through request files: killed at every stage, answers partly bad.

    python -m benchmarks.request_files                  # the test third, in a temporary folder
    python -m benchmarks.request_files --split dev --files plain

`esg draft --prompts … --llm-batch …` runs in processes of its own, which are killed after a random
time, twice a stage, before one may finish. A scripted model answers; of its answers some are cut
off, doubled, failed, for another request, or missing. In the end every draft has to be the one that
the same model gives when it is asked directly.
"""

from __future__ import annotations

import argparse
from collections import Counter
import json
import os
from pathlib import Path
import random
import signal
import subprocess
import sys
import tempfile
import time
from typing import Any

from benchmarks.drafting.corpus import FILES, load
from benchmarks.lib.drafting_ablation import FAULT_RATE, RELAPSE_RATE
from esg.draft.llm.drafter import draft_llm_batch
from esg.draft.llm.scripted import ScriptedModel
from esg.draft.llm.settings import LlmSettings
from esg.graph import canonical_json

ROUNDS = 8
KILLS = 2
"""Runs of a stage that are killed before one may finish."""
WAIT_S = (1.0, 6.0)
BAD = {"cut off": 0.03, "doubled": 0.03, "foreign": 0.03, "failed": 0.03, "missing": 0.08}
"""Shares of the answers that are spoiled."""
MOST_STAGES = 60


def main(argv: list[str] | None = None) -> int:
    """Prints what happened; exit code 1 if a draft is not what it should be."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--split", default="test")
    parser.add_argument("--files", nargs="+", choices=FILES, default=FILES)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args(argv)
    prompts = [row["prompt"] for row in load(args.split, args.files)]
    with tempfile.TemporaryDirectory() as name:
        found = _through_files(Path(name), prompts, random.Random(args.seed))
    settings = LlmSettings(max_rounds=ROUNDS, cassette=None, cache=None)
    model = ScriptedModel(FAULT_RATE, RELAPSE_RATE)
    direct = draft_llm_batch(prompts, settings=settings, client=model)
    same = sum(
        doc == (None if made.document is None else _plain(canonical_json(made.document)))
        for doc, made in zip(found["documents"], direct, strict=True)
    )
    told = ", ".join(f"{n} {kind}" for kind, n in sorted(found["spoiled"].items()))
    print(
        f"{len(prompts)} prompts in {found['stages']} stages, killed {found['kills']} times, "
        f"answers spoiled: {told}; {same} drafts as asked directly"
    )
    return 0 if same == len(prompts) else 1


def _through_files(place: Path, prompts: list[str], rng: random.Random) -> dict[str, Any]:
    """Drafts through a folder of request files; documents in the order of the prompts."""
    batch, out, source = place / "batch", place / "out", place / "prompts.jsonl"
    source.write_text("".join(json.dumps({"prompt": p, "seed": 0}) + "\n" for p in prompts))
    command = [sys.executable, "-m", "esg", "draft", "--prompts", str(source), "--drafter", "llm",
               "--llm-batch", str(batch), "--out", str(out), "--json"]  # fmt: skip
    env = {**os.environ, "ESG_LLM_MAX_ROUNDS": str(ROUNDS)}
    spoiled, kills, stage = Counter[str](), 0, 0
    for stage in range(1, MOST_STAGES):
        for _ in range(KILLS):
            process = subprocess.Popen(
                command, env=env, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
            )
            time.sleep(rng.uniform(*WAIT_S))
            if process.poll() is None:
                process.send_signal(signal.SIGKILL)
                kills += 1
            process.wait()
        done = subprocess.run(command, env=env, capture_output=True, text=True, check=False)
        told = json.loads(done.stdout)
        print(f"stage {stage}: {told['drafted']} drafted, {told['waiting']} waiting", flush=True)
        if not told["waiting"]:
            break
        _answer(batch, stage, rng, spoiled)
    rows = [json.loads(line) for line in (out / "drafts.jsonl").read_text().splitlines()]
    documents = [
        _plain((out / r["document"]).read_bytes()) if r["document"] else None for r in rows
    ]
    return {"documents": documents, "stages": stage, "kills": kills, "spoiled": spoiled}


def _answer(batch: Path, stage: int, rng: random.Random, spoiled: Counter[str]) -> None:
    """Answers the open requests, in any order, some of them badly."""
    model, out = ScriptedModel(FAULT_RATE, RELAPSE_RATE), list[str]()
    for line in (batch / "requests.jsonl").read_text().splitlines():
        request = json.loads(line)
        body, name = request["body"], request["custom_id"]
        talk = [(m["role"], m["content"]) for m in body["messages"][1:]]
        text = model.answer(name.partition("-")[0], talk, body["seed"])
        reply = {"model": "scripted", "choices": [{"message": {"content": text}}]}
        answer = json.dumps({"custom_id": name, "response": {"status_code": 200, "body": reply}})
        kind = rng.choices([*BAD, ""], [*BAD.values(), 1.0 - sum(BAD.values())])[0]
        spoiled.update([kind] if kind else [])
        out.append(_spoiled(answer, kind))
    rng.shuffle(out)
    (batch / f"answers-{stage}.jsonl").write_text("".join(out))


def _spoiled(answer: str, kind: str) -> str:
    forms = {
        "": answer + "\n",
        "cut off": answer[: len(answer) // 2] + "\n",
        "doubled": (answer + "\n") * 2,
        "foreign": answer.replace('"custom_id": "', '"custom_id": "x') + "\n",
        "failed": answer.replace('"status_code": 200', '"status_code": 500') + "\n",
        "missing": "",
    }
    return forms[kind]


def _plain(data: bytes) -> dict[str, Any]:
    """A document without its provenance, which counts tokens and replies."""
    tree = json.loads(data)
    del tree["provenance"]
    return tree


if __name__ == "__main__":
    sys.exit(main())
