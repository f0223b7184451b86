"""The real open_clip package behind ESG_EMBEDDER=clip, with a tiny model trained here for seconds.

Skipped without the `clip` extra. Only the model is small: it is saved as a checkpoint, loaded from
that file as `ESG_CLIP_PRETRAINED`, and indexes and searches the whole library.
"""

from __future__ import annotations

from collections.abc import Iterator
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from esg.assets.library import clip
from esg.assets.library.catalogue import catalogue
from esg.assets.library.embed import embed
from esg.assets.library.index import Index, compute_vectors, owners, texts_hash
from esg.assets.library.retrieve import rank
from esg.outcomes import UserError

pytest.importorskip("open_clip")
pytestmark = pytest.mark.slow

NAME = "esg-test-tiny"
CONFIG = {
    "embed_dim": 64,
    "vision_cfg": {"image_size": 32, "layers": 2, "width": 64, "head_width": 32, "patch_size": 8},
    "text_cfg": {
        "context_length": 77,
        "vocab_size": 49408,
        "width": 64,
        "heads": 2,
        "layers": 2,
    },
}
COLORS = {"tomato": (200, 40, 30), "lawn": (40, 160, 60), "ocean": (30, 60, 190)}


def square(color: tuple[int, int, int], rng: np.random.Generator) -> Any:
    """A noisy square of one colour, shape [48, 48, 3]."""
    noise = rng.integers(-25, 26, (48, 48, 3))
    return np.clip(np.array(color) + noise, 0, 255).astype(np.uint8)


@pytest.fixture(scope="module")
def weights(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A checkpoint of a tiny model that has learned three words from coloured squares."""
    import open_clip
    from PIL import Image
    import torch

    folder = tmp_path_factory.mktemp("clip")
    (folder / f"{NAME}.json").write_text(json.dumps(CONFIG))
    open_clip.add_model_config(folder / f"{NAME}.json")
    torch.manual_seed(0)
    model, _, transform = open_clip.create_model_and_transforms(NAME)
    tokens = open_clip.get_tokenizer(NAME)([f"a photo of a {w}" for w in COLORS])
    rng = np.random.default_rng(0)
    optimizer = torch.optim.AdamW(model.parameters(), lr=1e-3)
    model.train()
    for _ in range(40):
        images = torch.stack([transform(Image.fromarray(square(c, rng))) for c in COLORS.values()])
        picture, text, scale = model(images, tokens)
        logits = scale * picture @ text.T
        target = torch.arange(len(COLORS))
        loss = torch.nn.functional.cross_entropy(logits, target)
        loss = loss + torch.nn.functional.cross_entropy(logits.T, target)
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
    path = folder / "tiny.pt"
    torch.save(model.state_dict(), path)
    return path


@pytest.fixture
def chosen(weights: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setenv("ESG_EMBEDDER", "clip")
    monkeypatch.setenv("ESG_CLIP_MODEL", NAME)
    monkeypatch.setenv("ESG_CLIP_PRETRAINED", str(weights))
    clip._towers.cache_clear()
    yield
    clip._towers.cache_clear()


@pytest.mark.usefixtures("chosen")
def test_local_checkpoint_is_loaded_and_embeds() -> None:
    vectors = embed(["traffic cone", "traffic cone", "sofa"])
    assert vectors.shape == (3, 64) and vectors.dtype == np.float32
    np.testing.assert_allclose(np.linalg.norm(vectors, axis=1), 1, rtol=1e-5)
    np.testing.assert_allclose(vectors[0], vectors[1], atol=1e-6)
    assert vectors[0] @ vectors[2] < 0.9999


@pytest.mark.usefixtures("chosen")
def test_pictures_find_the_words_that_were_learned() -> None:
    rng = np.random.default_rng(7)
    pictures = clip.embed_images([square(c, rng) for c in COLORS.values()])
    words = clip.embed_texts(list(COLORS))
    assert (np.argmax(pictures @ words.T, axis=1) == np.arange(len(COLORS))).all()


@pytest.mark.usefixtures("chosen")
def test_library_is_indexed_and_searched() -> None:
    entries = catalogue()[:60]
    index = Index(entries, compute_vectors(entries), owners(entries), texts_hash(entries)[:16])
    assert index.vectors.shape[1] == 64
    for entry in entries[::7]:
        best = rank(entry.name.replace("_", " "), index=index)[0]
        assert best.asset_name == entry.name
        assert best.semantic > 0.999


@pytest.mark.usefixtures("chosen")
def test_index_hash_names_the_model(monkeypatch: pytest.MonkeyPatch) -> None:
    ours = texts_hash(catalogue())
    monkeypatch.setenv("ESG_EMBEDDER", "minilm")
    assert texts_hash(catalogue()) != ours


def test_damaged_checkpoint_is_one_clear_error(
    weights: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = tmp_path / "broken.pt"
    broken.write_bytes(weights.read_bytes()[:2000])
    monkeypatch.setenv("ESG_EMBEDDER", "clip")
    monkeypatch.setenv("ESG_CLIP_MODEL", NAME)
    monkeypatch.setenv("ESG_CLIP_PRETRAINED", str(broken))
    clip._towers.cache_clear()
    with pytest.raises(UserError, match="open_clip cannot load"):
        embed(["cone"])
    monkeypatch.setenv("ESG_CLIP_MODEL", "no-such-tower")
    monkeypatch.setenv("ESG_CLIP_PRETRAINED", str(weights))
    with pytest.raises(UserError, match="no-such-tower"):
        embed(["cone"])
    clip._towers.cache_clear()
