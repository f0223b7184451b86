"""Data inside the page: quantization, contacts, meshes, escaping, determinism."""

from __future__ import annotations

import base64
from dataclasses import replace
import gzip
import hashlib
from html.parser import HTMLParser
import json
from pathlib import Path
import re
import struct
from typing import Any

import numpy as np
import pytest

from esg.engines.scene import Wheel
from esg.report.binary import Chunk
from esg.report.meshes import MeshLibrary, mesh_chunk
from esg.report.page import STATIC, embed_json, write_report
from esg.report.payload import (
    contacts_of,
    continuous,
    frames_at,
    index_entry,
    scene_chunk,
)
from esg.report.replays import Replayed, replays_of
from esg.report.run import SceneEntry, load_run, read_scene
from esg.report.words import pieces
from tests.report import folders

ROOT = Path(__file__).parents[2]


def pieces_of(scene: SceneEntry) -> list[dict[str, Any]]:
    return pieces(scene.prompt, scene.document, scene.statements)


def decode(text: str) -> dict[str, Any]:
    """What the page's script does, in Python."""
    raw = gzip.decompress(base64.b64decode(text))
    (length,) = struct.unpack_from("<I", raw)
    head = json.loads(raw[4 : 4 + length])
    head["data"] = {}
    for entry in head["arrays"]:
        dtype = {"u2": "<u2", "u4": "<u4"}[entry["type"]]
        count = int(np.prod(entry["shape"]))
        array = np.frombuffer(raw, dtype, count, 4 + length + entry["offset"])
        if "low" in entry:
            codes = array.reshape(entry["shape"][::-1]).T.astype(np.int64)
            if entry["delta"]:
                codes = np.cumsum(codes, axis=0) & 0xFFFF
            array = np.array(entry["low"]) + np.array(entry["step"]) * codes
        head["data"][entry["name"]] = array
    return head


@pytest.mark.parametrize("delta", [False, True])
def test_quantized_values_come_back_within_half_a_step(delta: bool) -> None:
    """Over 60 m the error stays under a millimetre, falling values and constants included."""
    rng = np.random.default_rng(1)
    values = np.column_stack(
        [rng.uniform(-30, 30, 500), np.linspace(5, -7, 500), np.full(500, 3.25)]
    )
    chunk = Chunk()
    chunk.quantized("x", values, delta=delta)
    back = decode(chunk.text())["data"]["x"]
    half = np.ptp(values, axis=0) / 65535 / 2
    assert (np.abs(back - values) <= half + 1e-9).all()


def test_arrays_start_at_multiples_of_four() -> None:
    """A browser's typed arrays need it."""
    chunk = Chunk({"text": "é" * 3})
    chunk.integers("a", np.arange(3), "u2")
    chunk.integers("b", np.arange(5), "u4")
    raw = gzip.decompress(base64.b64decode(chunk.text()))
    (length,) = struct.unpack_from("<I", raw)
    assert (4 + length) % 4 == 0
    found = decode(chunk.text())
    assert [a["offset"] % 4 for a in found["arrays"]] == [0, 0]
    assert found["data"]["b"].tolist() == [0, 1, 2, 3, 4]


def test_frames_are_the_nearest_to_a_steady_rate() -> None:
    """240 steps a second give every fourth; a slow recording keeps every frame; the last stays."""
    assert frames_at(np.arange(241) / 240, 60.0) == list(range(0, 241, 4))
    assert frames_at(np.arange(11) / 10, 60.0) == list(range(11))
    assert frames_at(np.array([0.0, 0.1, 0.105]), 10.0) == [0, 1, 2]


def test_quaternions_never_jump_to_their_opposite() -> None:
    """q and -q are one turn: interpolating between them must not spin the body."""
    q = np.tile([0.0, 0.0, 0.6, 0.8], (4, 1, 1)).reshape(4, 1, 4)
    q[1::2] *= -1
    assert np.allclose(continuous(q), q[0])


def test_the_strongest_contacts_are_kept_and_the_ground_is_not() -> None:
    """Within a twentieth of a second one contact a pair is enough."""
    rollout = folders.rollout()
    c = rollout.contacts
    n = 4
    log = replace(
        c,
        world=np.zeros(n, np.int32),
        frame=np.arange(n, dtype=np.int32),
        a=np.zeros(n, np.int32),
        b=np.array([1, 1, -1, 1], np.int32),
        time=np.array([0.501, 0.502, 0.503, 0.8]),
        impulse=np.array([1.0, 3.0, 9.0, 1e-4]),
        depth=np.zeros(n),
        point=np.zeros((n, 3)),
        normal=np.tile([0.0, 0.0, 1.0], (n, 1)),
    )
    found = contacts_of(replace(rollout, contacts=log))
    assert [(c[0], c[3]) for c in found] == [(0.502, 3.0)]


def test_a_scene_chunk_carries_motion_events_and_sources(tmp_path: Path) -> None:
    """Position, speed and clock of what moves; start poses of what does not."""
    scene = read_scene(folders.write_scene(tmp_path / "drop"))
    chunk = decode(scene_chunk(scene, replays_of(scene.folder, scene.metrics), MeshLibrary()))
    (replay,) = chunk["replays"]
    assert replay["moving"] == [0]
    assert replay["engine"] == "physx"
    rollout = folders.rollout()
    frames = frames_at(rollout.time, 60.0)
    height = chunk["data"]["position0"][:, 2]
    assert np.allclose(height, rollout.position[0, frames, 0, 2], atol=1e-4)
    speed = np.abs(rollout.linear_velocity[0, frames, 0, 2])
    assert np.allclose(chunk["data"]["speed0"][:, 0], speed, atol=1e-3)
    assert replay["contacts"][0][3] == 4.9
    assert "class AScene" in chunk["texts"]["EsgScene.h"]
    assert chunk["document"]["dynamics_result"]["history"] == [1.0, 0.1, 0.01]


SAID = "A 🔴 ball on the table flies straight up."
"""With a character that two units of UTF-16 make up: places count characters."""


def said() -> list[dict[str, Any]]:
    return [
        folders.statement(SAID, "on the table", "broken", "carried in 0% of 95%", share=0.0),
        folders.statement(SAID, "the table", "kept", share=1.0),
        folders.statement(SAID, "straight up", "not_represented", "no path"),
    ]


def test_words_say_what_became_of_them_the_worst_first(tmp_path: Path) -> None:
    scene = read_scene(folders.write_scene(tmp_path / "a", SAID, outcome="partial", said=said()))
    found = pieces_of(scene)
    assert "".join(p["text"] for p in found) == SAID
    assert [(p["text"], p["fate"]) for p in found] == [
        ("A 🔴 ball ", ""), ("on the table", "broken"), (" flies ", ""),
        ("straight up", "not_represented"), (".", ""),
    ]  # fmt: skip
    assert found[1]["notes"] == ["supported by: broken: carried in 0% of 95% (measured: share 0)"]
    entry = index_entry(scene, 0, "a")
    assert (entry["kept"], entry["statements"]) == (1, 3)
    assert [r["words"] for r in entry["not_kept"]] == ["on the table", "straight up"]
    chunk = decode(scene_chunk(scene, [], MeshLibrary()))
    assert chunk["words"] == found and len(chunk["statements"]) == 3


def test_pieces_end_where_another_fate_begins(tmp_path: Path) -> None:
    """A lost word inside a kept statement shows, and neighbours of one kind stay apart."""
    rows = [
        folders.statement(SAID, "ball on the table", "kept", share=1.0),
        folders.statement(SAID, "on", "broken", "in the air"),
    ]
    scene = read_scene(folders.write_scene(tmp_path / "a", SAID, said=rows))
    assert [(p["text"], p["fate"]) for p in pieces_of(scene)] == [
        ("A 🔴 ", ""), ("ball ", "kept"), ("on", "broken"), (" the table", "kept"),
        (" flies straight up.", ""),
    ]  # fmt: skip


def test_a_scene_without_a_verdict_shows_what_its_draft_could_not_hold(tmp_path: Path) -> None:
    made = folders.write_scene(tmp_path / "a", SAID, outcome="crashed", said=said())
    scene = read_scene(made)
    assert not scene.metrics and not scene.problems
    assert {r["status"] for r in scene.statements} == {"not_represented"}
    assert "straight up" in [r["words"] for r in scene.not_kept]


def test_a_scene_recorded_before_statements_has_none(tmp_path: Path) -> None:
    made = folders.write_scene(tmp_path / "a")
    path = made / "metrics.json"
    old = json.loads(path.read_text())
    del old["statements"], old["not_kept"]
    path.write_text(json.dumps(old))
    scene = read_scene(made)
    assert (scene.statements, scene.not_kept, scene.problems) == ([], [], ())


@pytest.mark.parametrize("plausible", [True, False])
def test_plausibility_is_told_on_the_card_and_check_by_check_on_the_page(
    tmp_path: Path, plausible: bool
) -> None:
    made = folders.write_scene(tmp_path / "a", completed=plausible)
    scene = read_scene(made)
    entry = index_entry(scene, 1, "a")
    assert entry["plausible"] is plausible
    assert ("speed 99 m/s" in entry["implausible"]) is not plausible
    (check,) = decode(scene_chunk(scene, [], MeshLibrary()))["metrics"]["plausibility"]["checks"]
    assert (check["name"], check["ok"], check["limit"]) == ("speed", plausible, 47.3)
    path = made / "metrics.json"
    older = json.loads(path.read_text())
    del older["plausibility"]
    path.write_text(json.dumps(older))
    assert read_scene(made).plausible is None and not read_scene(made).problems


def test_a_suite_s_statements_stand_apart_from_the_prompt_s(tmp_path: Path) -> None:
    made = folders.write_scene(tmp_path / "a", SAID, said=said())
    path = made / "metrics.json"
    metrics = json.loads(path.read_text())
    asked = {"id": "s1", "says": "rolls", "kept": False, "measured": {"ratio": 0.1}, "reason": "r"}
    metrics["verdict"]["statements"] = [asked]
    path.write_text(json.dumps(metrics))
    scene = read_scene(made)
    assert scene.asked == [{**asked, "status": "broken"}] and len(scene.statements) == 3
    assert decode(scene_chunk(scene, [], MeshLibrary()))["asked"] == scene.asked
    path.write_text(json.dumps({**metrics, "judged_against": "timeline"}))
    assert read_scene(made).asked == []


def test_statements_of_another_shape_are_damage(tmp_path: Path) -> None:
    made = folders.write_scene(tmp_path / "a", SAID, said=said())
    path = made / "metrics.json"
    wrong = json.loads(path.read_text())
    wrong["statements"][1]["measured"] = {"share": "all"}
    path.write_text(json.dumps(wrong))
    (problem,) = read_scene(made).problems
    assert "/statements/1/measured/share" in problem


def test_a_replay_that_diverged_is_shown_as_far_as_it_went(tmp_path: Path) -> None:
    """Positions, turns, speeds and impulses that are no numbers break nothing."""
    scene = read_scene(folders.write_scene(tmp_path / "drop"))
    rollout = folders.rollout()
    for array in (rollout.position, rollout.quaternion, rollout.linear_velocity):
        array[0, 100:] = np.nan
    rollout.position[0, 200:] = np.inf
    contacts = replace(rollout.contacts, impulse=np.array([np.nan]))
    broken = replace(rollout, contacts=contacts, valid=np.array([False]))
    replay = Replayed(folders.scene(), broken, "program")
    chunk = decode(scene_chunk(scene, [replay], MeshLibrary()))
    assert chunk["replays"][0]["valid"] is False
    assert chunk["replays"][0]["contacts"] == []
    assert np.isfinite(chunk["data"]["position0"]).all()
    assert chunk["data"]["position0"][0, 2] == pytest.approx(2.0, abs=1e-3)


def test_scenes_of_several_folders_keep_their_place(tmp_path: Path) -> None:
    """Equal names in different folders stay apart: each is known by its path."""
    for suite in ("a", "b"):
        folders.write_scene(tmp_path / suite / "S1-run0")
    page = write_report(load_run(tmp_path), tmp_path / "r.html").read_text(encoding="utf-8")
    index = re.search(r'id="index">(.*?)</script>', page)
    assert index
    assert [s["id"] for s in json.loads(index[1])["scenes"]] == ["a/S1-run0", "b/S1-run0"]


def test_equal_meshes_travel_once(tmp_path: Path) -> None:
    """Two scenes with the same box share its chunk."""
    library = MeshLibrary()
    for name in ("a", "b"):
        library.add(folders.scene().bodies[1], tmp_path / name)
    assert len(library.chunks) == 1


def test_a_mesh_keeps_its_shape_and_colours() -> None:
    """A unit cube of a known colour: eight corners, twelve triangles, its box."""
    import trimesh
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    cube = trimesh.creation.box(extents=(1, 2, 3))
    material = PBRMaterial(baseColorFactor=[255, 0, 51, 255])
    cube.visual = TextureVisuals(material=material)
    data = trimesh.Scene(cube).export(file_type="glb")
    mesh = decode(mesh_chunk(data))
    # A factor of glTF is linear light, a colour of the page sRGB.
    assert mesh["colors"] == [[1.0, 0.0, pytest.approx(0.485, abs=1e-3), 1.0]]
    assert mesh["counts"] == [36]
    assert len(mesh["data"]["vertices"]) == 8
    # glTF is Y up; the page is Z up again: (x, -z, y).
    assert np.allclose(np.ptp(mesh["data"]["vertices"], axis=0), [1, 3, 2], atol=1e-4)


HOSTILE = [
    "</script><script>document.title='owned'</script>",
    "<img src=x onerror=\"document.title='owned'\">",
    "\"quotes\" 'and' `ticks` & &lt;entities&gt; <!-- comment",
    "line\u2028separator and \u202eright to left and 🎳",
]


PAGE_ELEMENTS = set(
    ["html", "head", "meta", "link", "title", "style", "body", "div", "noscript", "script"]
)


class Elements(HTMLParser):
    """Which elements a parser sees, and whether any carries an event handler."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.handlers: list[str] = []
        self.title = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.handlers += [name for name, _ in attrs if name.startswith("on")]

    def handle_data(self, data: str) -> None:
        if self.tags[-1:] == ["title"]:
            self.title += data.removesuffix("\n") if not self.title else ""


@pytest.mark.parametrize("prompt", HOSTILE)
def test_no_text_of_a_scene_becomes_markup(tmp_path: Path, prompt: str) -> None:
    """Nothing of a prompt, a reason or a title stands in the file as it was typed."""
    folders.write_scene(tmp_path / "run" / "s", prompt, reason=prompt, label=prompt)
    page = write_report(load_run(tmp_path / "run"), tmp_path / "r.html", title=prompt)
    text = page.read_text(encoding="utf-8")
    found = Elements()
    found.feed(text)
    assert found.title == prompt
    assert set(found.tags) == PAGE_ELEMENTS
    assert found.handlers == []
    index = re.search(r'id="index">(.*?)</script>', text)
    assert index
    assert json.loads(index[1])["scenes"][0]["prompt"] == prompt


def test_json_between_script_tags_cannot_end_them() -> None:
    """No angle bracket and no ampersand survives, and the value does."""
    value = {"a": "</script><!--&\u2028"}
    text = embed_json(value)
    assert not set("<>&\u2028") & set(text)
    assert json.loads(text) == value


def test_the_same_run_gives_the_same_bytes(tmp_path: Path) -> None:
    """No clock, no order of a set, no compression date."""
    folders.write_scene(tmp_path / "run" / "a")
    folders.write_scene(tmp_path / "run" / "b", outcome="invalid_draft")
    run = load_run(tmp_path / "run")
    first = write_report(run, tmp_path / "1.html").read_bytes()
    assert write_report(run, tmp_path / "2.html").read_bytes() == first


def test_overlays_of_other_engines_follow_the_recorded_replay(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The recorded engine is not run again; others are run and judged."""
    scene = read_scene(folders.write_scene(tmp_path / "drop"))
    asked = []

    def fake(folder: Path, manifest: Any, engine: str) -> Replayed:
        asked.append(engine)
        return Replayed(manifest.scene, folders.rollout(engine=engine), "program")

    monkeypatch.setattr("esg.report.replays._replay", fake)
    monkeypatch.setattr("esg.report.replays._judged", lambda _, replay: replay)
    found = replays_of(scene.folder, scene.metrics, ("physx", "rapier", "newton"))
    assert asked == ["rapier", "newton"]
    assert [r.rollout.engine for r in found] == ["physx", "rapier", "newton"]


def test_the_bundle_is_made_from_the_sources_in_the_repository() -> None:
    """A change of web/ without a new build is caught; no address is in the lock file."""
    web = ROOT / "web"
    if not web.is_dir():
        pytest.skip("installed without the sources of the bundle")
    names = ["build.mjs", "package-lock.json", "package.json"]
    names += [f"src/{p.name}" for p in sorted((web / "src").iterdir())]
    digest = hashlib.sha256()
    for name in names:
        digest.update(name.encode() + b"\0" + (web / name).read_bytes())
    stored = (STATIC / "SOURCES.sha256.txt").read_text().strip()
    assert digest.hexdigest() == stored, "run `npm ci --ignore-scripts && npm run build` in web/"
    assert "resolved" not in (web / "package-lock.json").read_text()


def test_licenses_of_every_bundled_library_are_kept() -> None:
    """Name, version and full text."""
    text = (STATIC / "LICENSES.txt").read_text()
    for name in ("three", "@dagrejs/dagre"):
        assert re.search(rf"^{name} \d+\.\d+\.\d+ \(MIT\)$", text, re.M)
    assert text.count("Permission is hereby granted") == 2


def test_wheels_travel_apart_with_their_angles(tmp_path: Path) -> None:
    """Their parts are no part of the body's; a scene without wheels says nothing of them."""
    import trimesh

    scene = trimesh.Scene()
    scene.add_geometry(trimesh.creation.box((4, 1, 2)), node_name="part_000")
    place = trimesh.transformations.translation_matrix((1.0, 0.0, 0.5))
    scene.graph.update(frame_to="wheel_front", matrix=place)
    tyre = trimesh.creation.cylinder(0.3, 0.1)
    scene.add_geometry(tyre, node_name="part_001", parent_node_name="wheel_front")
    data = scene.export(file_type="glb")
    mesh = decode(mesh_chunk(data, ["wheel_front"]))
    pieces = dict(zip(mesh["wheels"], mesh["counts"], strict=True))
    assert pieces == {"": 36, "wheel_front": 3 * len(tyre.faces)}
    assert "wheels" not in decode(mesh_chunk(data)) and len(decode(mesh_chunk(data))["counts"]) == 1

    plain = read_scene(folders.write_scene(tmp_path / "plain"))
    still = decode(scene_chunk(plain, replays_of(plain.folder, plain.metrics), MeshLibrary()))
    assert "wheels0" not in still["data"] and "wheels" not in still["bodies"][0]
    wheel = Wheel("wheel_front", (1.0, 0.0, -0.3), 0.5)
    sim = folders.scene()
    sim = sim.with_bodies((replace(sim.bodies[0], wheels=(wheel,)), sim.bodies[1]))
    rollout = folders.rollout()
    position = rollout.position.copy()
    position[0, :, 0] = np.array([0.0, 0.0, 1.0]) + rollout.time[:, None] * [2.0, 0.0, 0.0]
    replay = Replayed(sim, replace(rollout, position=position), "class")
    chunk = decode(scene_chunk(plain, [replay], MeshLibrary()))
    assert chunk["bodies"][0]["wheels"] == [["wheel_front", 1.0, 0.0, -0.3]]
    assert "wheels" not in chunk["bodies"][1]
    assert chunk["data"]["wheels0"].ravel() == pytest.approx(
        4.0 * chunk["data"]["time0"].ravel(), abs=1e-3
    )
