"""Text and image embeddings by an open_clip model (`clip` extra), instead of MiniLM.

`ESG_EMBEDDER=clip` selects it, `ESG_CLIP_MODEL` the architecture (default ViT-B-32) and
`ESG_CLIP_PRETRAINED` a tag of the hub or a local .pt or .safetensors file. The gate was tuned on
MiniLM: with CLIP the ranking is comparable, the threshold is not.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.outcomes import UserError

MODEL = "ViT-B-32"
PRETRAINED = "laion2b_s34b_b79k"


def clip_name() -> str:
    """Architecture and weights as chosen by the environment; part of an index's hash."""
    return f"{_model_name()}:{_weights()}"


def _model_name() -> str:
    return os.environ.get("ESG_CLIP_MODEL") or MODEL


def _weights() -> str:
    chosen = os.environ.get("ESG_CLIP_PRETRAINED") or PRETRAINED
    looks_like_file = chosen.endswith((".pt", ".pth", ".bin", ".safetensors")) or os.sep in chosen
    if looks_like_file and not Path(chosen).is_file():
        raise UserError(f"ESG_CLIP_PRETRAINED={chosen!r}: no such file")
    return chosen


@lru_cache(maxsize=1)
def _towers(model: str, weights: str) -> tuple[Any, Any, Any]:
    try:
        import open_clip  # type: ignore[import-not-found]  # optional extra
    except ImportError:
        raise UserError(
            "ESG_EMBEDDER=clip needs the `clip` extra: pip install 'esg-scenes[clip]'"
        ) from None
    try:
        towers, _, transform = open_clip.create_model_and_transforms(model, pretrained=weights)
    except Exception as error:  # an unknown name, no network, a damaged file
        raise UserError(
            f"open_clip cannot load {model!r} with {weights!r} ({type(error).__name__}: {error}); "
            "give ESG_CLIP_PRETRAINED a local file"
        ) from None
    towers.eval()
    return towers, transform, open_clip.get_tokenizer(model)


def _unit(features: Any) -> NDArray[np.float32]:
    out = np.asarray(features.detach().cpu().numpy(), np.float32)
    return out / np.linalg.norm(out, axis=1, keepdims=True)


def embed_texts(texts: Sequence[str]) -> NDArray[np.float32]:
    """Unit embeddings of texts, shape [n, width of the model]."""
    import torch  # type: ignore[import-not-found]  # comes with the extra

    towers, _, tokenizer = _towers(_model_name(), _weights())
    with torch.no_grad():
        return _unit(towers.encode_text(tokenizer([f"a photo of a {t}" for t in texts])))


def embed_images(images: Sequence[NDArray[np.uint8]]) -> NDArray[np.float32]:
    """Unit embeddings of RGB images, each of shape [height, width, 3]."""
    from PIL import Image
    import torch  # type: ignore[import-not-found]

    towers, transform, _ = _towers(_model_name(), _weights())
    batch = torch.stack([transform(Image.fromarray(i)) for i in images])
    with torch.no_grad():
        return _unit(towers.encode_image(batch))
