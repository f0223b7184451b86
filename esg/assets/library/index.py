"""The embedding index of the active library: unit vectors of names and descriptions.

Vectors of the embedded catalogue are stored in the package beside a hash of the texts they stand
for; a stale or missing file is recomputed (seconds), never trusted.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
import hashlib
from importlib.resources import files
import io
from pathlib import Path
from zipfile import BadZipFile
import zlib

import numpy as np
from numpy.typing import NDArray

from esg.assets.library.catalogue import Entry, catalogue

INDEX_FILE = "catalogue_index.npz"


def texts_of(entry: Entry) -> tuple[str, ...]:
    """Texts under which an entry can be found: its name, each synonym, and its description."""
    name = entry.name.replace("_", " ")
    return (name, *entry.synonyms, f"{name}: {entry.description}")


def texts_hash(entries: tuple[Entry, ...]) -> str:
    """Content hash of all texts in order, and of the embedder if it is not the default one."""
    from esg.assets.library.embed import embedder

    digest = hashlib.sha256()
    if embedder() == "clip":
        from esg.assets.library.clip import clip_name

        digest.update(clip_name().encode())
    for entry in entries:
        digest.update("\n".join(texts_of(entry)).encode() + b"\0")
    return digest.hexdigest()


@dataclass(frozen=True)
class Index:
    """Vectors of all texts and the entry each belongs to.

    Args:
        entries: The library.
        vectors: Unit vectors, shape [texts, 384], float32.
        owner: Index into `entries` of each text, shape [texts].
        fingerprint: Hash of the library's texts.
    """

    entries: tuple[Entry, ...]
    vectors: NDArray[np.float32]
    owner: NDArray[np.int32]
    fingerprint: str

    @cached_property
    def _places(self) -> dict[str, int]:
        """Where among all texts a name or synonym stands first."""
        flat = [text for entry in self.entries for text in texts_of(entry)]
        return {text: at for at, text in reversed(list(enumerate(flat)))}

    def scores(self, query: NDArray[np.float32]) -> NDArray[np.float32]:
        """Best cosine of a query vector [384] over each entry's texts, shape [entries]."""
        cosine = self.vectors @ query
        best = np.full(len(self.entries), -1.0, np.float32)
        np.maximum.at(best, self.owner, cosine)
        return best

    def vector(self, text: str) -> NDArray[np.float32]:
        """Unit vector of a text, shape [384].

        Names and synonyms of the library have theirs in the index, rounded as it is stored: most
        nouns are found without the model, which takes half a second to load.
        """
        at = self._places.get(text)
        if at is not None:
            return self.vectors[at]
        from esg.assets.library.embed import embed

        return embed([text])[0]

    def scores_of(self, entry: int, query: NDArray[np.float32]) -> NDArray[np.float32]:
        """Cosines of a query with the texts of one entry, shape [texts of it]."""
        first, last = np.searchsorted(self.owner, (entry, entry + 1))
        return self.vectors[first:last] @ query


def owners(entries: tuple[Entry, ...]) -> NDArray[np.int32]:
    """Entry index of each text."""
    return np.repeat(np.arange(len(entries), dtype=np.int32), [len(texts_of(e)) for e in entries])


def compute_vectors(entries: tuple[Entry, ...]) -> NDArray[np.float32]:
    """Embeds all texts of a library, rounded to float16 as stored."""
    from esg.assets.library.embed import embed

    flat = [t for e in entries for t in texts_of(e)]
    return embed(flat).astype(np.float16).astype(np.float32)


def pack(entries: tuple[Entry, ...]) -> bytes:
    """The stored form: hash and float16 vectors."""
    buffer = io.BytesIO()
    vectors = compute_vectors(entries).astype(np.float16)
    np.savez_compressed(buffer, vectors=vectors, hash=np.array(texts_hash(entries)))
    return buffer.getvalue()


def unpack(data: bytes, entries: tuple[Entry, ...]) -> NDArray[np.float32] | None:
    """Stored vectors, or None if they stand for other texts or are damaged: they are made again."""
    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as archive:
            if str(archive["hash"]) != texts_hash(entries):
                return None
            vectors = archive["vectors"].astype(np.float32)
    except (OSError, ValueError, KeyError, TypeError, EOFError, BadZipFile, zlib.error):
        return None
    whole = vectors.ndim == 2 and len(vectors) == len(owners(entries))
    return vectors if whole and np.isfinite(vectors).all() else None


@lru_cache(maxsize=1)
def embedded_index() -> Index:
    """Index of the embedded library."""
    entries = catalogue()
    resource = files("esg.assets.data").joinpath(INDEX_FILE)
    vectors = unpack(resource.read_bytes(), entries) if resource.is_file() else None
    if vectors is None:
        vectors = compute_vectors(entries)
    return Index(entries, vectors, owners(entries), texts_hash(entries)[:16])


def main() -> None:
    """Recomputes the stored index: `python -m esg.assets.library.index`."""
    target = Path(str(files("esg.assets.data"))) / INDEX_FILE
    target.write_bytes(pack(catalogue()))
    print(f"wrote {target}")


if __name__ == "__main__":
    main()
