"""What the studio answers, and whom."""

from __future__ import annotations

from collections.abc import Iterator
import json
from pathlib import Path
import time
from typing import Any

from fastapi.testclient import TestClient
import pytest

from esg.studio.jobs import Jobs
from esg.studio.server import STATIC, build
from tests.studio.fakes import Pool

PROMPT = "A ball rolls into a box."


@pytest.fixture
def pool() -> Pool:
    return Pool()


@pytest.fixture
def client(tmp_path: Path, pool: Pool) -> Iterator[TestClient]:
    jobs = Jobs(tmp_path, lambda: pool)  # type: ignore[arg-type, return-value]  # stands for one
    with TestClient(build(jobs), base_url="http://127.0.0.1:8766") as found:
        yield found


def wait(client: TestClient, number: int) -> dict[str, Any]:
    for _ in range(1000):
        job = next(j for j in client.get("/api/jobs").json() if j["id"] == number)
        if job["status"] not in ("waiting", "running"):
            return job
        time.sleep(0.005)
    raise AssertionError("it never ended")


def test_the_page_runs_nothing_but_its_own_files(client: TestClient) -> None:
    page = client.get("/")
    policy = page.headers["content-security-policy"]
    assert "script-src 'self';" in policy and "unsafe" not in policy
    assert page.headers["x-frame-options"] == "SAMEORIGIN"
    for name in ("studio.js", "studio.css"):
        assert f"/static/{name}" in page.text
        assert client.get(f"/static/{name}").content == (STATIC / name).read_bytes()
    for name in ("../server.py", "..%2fserver.py", "nothing.js", "studio"):
        assert client.get(f"/static/{name}").status_code in (404, 405)


def test_only_this_machine_and_only_the_page_may_ask(client: TestClient) -> None:
    ask = {"prompt": PROMPT}
    assert client.get("/", headers={"host": "evil.example"}).status_code == 421
    evil = {"origin": "http://evil.example"}
    assert client.post("/api/jobs", json=ask, headers=evil).status_code == 403
    assert client.delete("/api/jobs/1", headers=evil).status_code == 403
    form = {"content-type": "text/plain"}
    assert client.post("/api/jobs", content=json.dumps(ask), headers=form).status_code == 415
    big = {"content-type": "application/json", "content-length": "3000000"}
    assert client.post("/api/jobs", content="{}", headers=big).status_code == 413
    own = {"origin": "http://127.0.0.1:8766"}
    assert client.post("/api/jobs", json=ask, headers=own).status_code == 201


def test_mistakes_are_told_all_at_once(client: TestClient) -> None:
    for body, words in (
        ({"prompt": "", "seed": -1}, ("2 problems", "prompt is empty", "seed -1")),
        ({"prompt": "x" * 20_000}, ("20000 characters",)),
        ({"prompt": PROMPT, "seed": "many"}, ("whole number",)),
        ({"prompt": 7}, ("prompt must be text",)),
        ({"prompt": PROMPT, "document": "{"}, ("the graph does not hold",)),
        ({"prompt": PROMPT, "knobs": {"a": "b"}}, ("knobs must be numbers",)),
    ):
        answer = client.post("/api/jobs", json=body)
        assert answer.status_code == 400, body
        for word in words:
            assert word in answer.json()["error"]
    assert client.post("/api/jobs", json=[1]).status_code == 422
    assert client.get("/api/jobs").json() == []


def test_words_are_read_and_graphs_checked(client: TestClient) -> None:
    told = client.post("/api/read", json={"prompt": PROMPT}).json()
    assert "".join(p["text"] for p in told["pieces"]) == PROMPT
    assert client.post("/api/check", json={"document": told["document"]}).json()["ok"]
    broken = told["document"].replace('"ball_1"', '"bell_1"', 1)
    found = client.post("/api/check", json={"document": broken}).json()
    assert not found["ok"] and all(v["message"] and v["pointer"] for v in found["violations"])


def test_sliders_and_edits_become_the_graph_that_is_solved(client: TestClient, pool: Pool) -> None:
    told = client.post("/api/read", json={"prompt": PROMPT}).json()
    knob = next(k["id"] for k in told["knobs"] if k["id"].startswith("mass/ball"))
    edited = told["document"].replace('"label": "box"', '"label": "red box"')
    for more in ({}, {"knobs": {knob: 2.5}}, {"document": edited}):
        wait(client, client.post("/api/jobs", json={"prompt": PROMPT, **more}).json()["id"])
    drafted, turned, changed = (r.document for r in pool.asked)
    assert drafted == ""
    assert json.loads(turned)["asset_requirement"][knob[5:]]["expected_mass_kg"] == 2.5
    assert "red box" in changed


def test_files_leave_as_attachments_and_nothing_else(client: TestClient, tmp_path: Path) -> None:
    number = client.post("/api/jobs", json={"prompt": PROMPT}).json()["id"]
    assert wait(client, number)["folder"] == "scene-1"
    answer = client.get(f"/scenes/{number}/files/prompt.txt")
    assert answer.text == PROMPT + "\n"
    assert answer.headers["content-disposition"].startswith("attachment")
    assert "sandbox" in answer.headers["content-security-policy"]
    (tmp_path / "secret.txt").write_text("secret")
    (tmp_path / "scene-1" / "link.txt").symlink_to(tmp_path / "secret.txt")
    for name in ("..%2fsecret.txt", "%2e%2e/secret.txt", "link.txt", "nothing"):
        assert client.get(f"/scenes/{number}/files/{name}").text != "secret"
        assert client.get(f"/scenes/{number}/files/{name}").status_code in (400, 404)
    (tmp_path / "scene-1" / "link.txt").unlink()
    assert client.get("/scenes/99/").status_code == 400
    assert "choose" in client.get(f"/scenes/{number}/export/exe").json()["error"]
