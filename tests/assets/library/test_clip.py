"""The open_clip path, on a stand-in for the library: loading, embedding, and a separate index."""

from __future__ import annotations

from pathlib import Path
import sys
import types
from typing import Any

import numpy as np
import pytest

from esg.assets.library.catalogue import catalogue
from esg.assets.library.embed import embed, embedder
from esg.assets.library.index import texts_hash
from esg.outcomes import UserError


class Features:
    """As much of a tensor as is needed."""

    def __init__(self, values: Any) -> None:
        self.values = np.asarray(values, float)

    def detach(self) -> Features:
        return self

    cpu = detach

    def numpy(self) -> Any:
        return self.values


class Grad:
    def __enter__(self) -> None: ...
    def __exit__(self, *_: object) -> None: ...


@pytest.fixture
def loaded(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[Any]:
    from esg.assets.library import clip

    calls: list[Any] = []

    class Towers:
        def eval(self) -> None:
            calls.append("eval")

        def encode_text(self, tokens: list[str]) -> Features:
            return Features([[len(t), 1.0] for t in tokens])

        def encode_image(self, batch: list[Any]) -> Features:
            return Features([[float(np.mean(i)), 2.0] for i in batch])

    def create(model: str, pretrained: str) -> tuple[Towers, None, Any]:
        calls.append((model, pretrained))
        return Towers(), None, np.asarray

    stub = types.ModuleType("open_clip")
    vars(stub).update(create_model_and_transforms=create, get_tokenizer=lambda _: list)
    torch = types.ModuleType("torch")
    vars(torch).update(no_grad=Grad, stack=list)
    monkeypatch.setitem(sys.modules, "open_clip", stub)
    monkeypatch.setitem(sys.modules, "torch", torch)
    weights = tmp_path / "small.safetensors"
    weights.write_bytes(b"weights")
    monkeypatch.setenv("ESG_EMBEDDER", "clip")
    monkeypatch.setenv("ESG_CLIP_MODEL", "ViT-S-16")
    monkeypatch.setenv("ESG_CLIP_PRETRAINED", str(weights))
    clip._towers.cache_clear()
    return calls


def test_local_weights_are_loaded_once_and_give_unit_vectors(
    loaded: list[Any], tmp_path: Path
) -> None:
    from esg.assets.library.clip import embed_images

    out = embed(["car", "wheelie bin"])
    np.testing.assert_allclose(np.linalg.norm(out, axis=1), 1.0, rtol=1e-6)
    assert out.dtype == np.float32 and not np.allclose(out[0], out[1])
    embed(["dog"])
    pictures = embed_images([np.zeros((4, 4, 3), np.uint8), np.full((4, 4, 3), 200, np.uint8)])
    assert pictures.shape == (2, 2)
    assert loaded == [("ViT-S-16", str(tmp_path / "small.safetensors")), "eval"]


def test_vectors_of_another_embedder_are_never_mixed(
    loaded: list[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    entries = catalogue()[:3]
    with_clip = texts_hash(entries)
    monkeypatch.setenv("ESG_CLIP_MODEL", "ViT-B-32")
    other = texts_hash(entries)
    monkeypatch.delenv("ESG_EMBEDDER")
    assert len({with_clip, other, texts_hash(entries)}) == 3


def test_bad_settings_are_one_message(loaded: list[Any], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_CLIP_PRETRAINED", "/nowhere/weights.pt")
    with pytest.raises(UserError, match="no such file"):
        embed(["x"])
    monkeypatch.setenv("ESG_EMBEDDER", "bert")
    with pytest.raises(UserError, match="minilm or clip"):
        embedder()


def test_without_the_extra_it_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    from esg.assets.library import clip

    monkeypatch.setitem(sys.modules, "open_clip", None)
    clip._towers.cache_clear()
    with pytest.raises(UserError, match="clip"):
        clip._towers("ViT-B-32", "tag")
