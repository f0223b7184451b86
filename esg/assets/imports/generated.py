"""Generated assets: a mesh made to order, finished like an import, kept by content.

A generated mesh lies in the library folder `generated`, which has no index: it is found again by
the same words, size, mass, seed and provider, and never competes in retrieval, so that what was
generated for one scene does not change another.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
import tempfile

from esg.assets.imports.providers import GenerationError, Generator
from esg.assets.library.retrieve import Decision
from esg.graph.models import AssetConfiguration, AssetRequirement

LIBRARY = "generated"
GENERATED_VERSION = 1


def prompt_of(requirement: AssetRequirement) -> str:
    """The words given to a generator: what it is, its looks, its colour and material."""
    noun = requirement.asset_category.replace("_", " ")
    words = [w for w in (requirement.color, requirement.material) if w and w not in noun]
    text = " ".join((*words, noun))
    description = requirement.asset_description.strip()
    return f"{text}: {description}" if description and description.lower() != noun else text


def _key(prompt: str, requirement: AssetRequirement, seed: int, provider: str) -> str:
    parts = (
        GENERATED_VERSION,
        provider,
        prompt,
        seed,
        [round(float(v), 3) for v in requirement.expected_dimensions_cm],
        round(float(requirement.expected_mass_kg), 5),
        requirement.material,
    )
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:24]


def _import(
    data: bytes, key: str, prompt: str, requirement: AssetRequirement, provider: str, folder: Path
) -> None:
    """Post-processing shared with imports: scale, ground, front, thinning, proxies, mass."""
    from esg.assets.imports.importer import IMPORT_VERSION, convert, write_file
    from esg.assets.imports.sources import Source

    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / "generated.glb"
        path.write_bytes(data)
        source = Source(
            key=key,
            name=requirement.asset_category.replace("_", " "),
            path=path,
            dimensions_cm=requirement.expected_dimensions_cm,
            description=prompt,
            mass_kg=requirement.expected_mass_kg,
            material=requirement.material or "",
            license="generated",
            creator=provider,
            origin="made from the scene's words",
        )
        try:
            record, _ = convert(source)
        except Exception as error:  # a container may be whole and its mesh still unusable
            raise GenerationError(
                f"the mesh is unusable ({type(error).__name__}: {error})"
            ) from None
    record["source_hash"] = f"{IMPORT_VERSION}:{key}"
    mesh = record.pop("glb")
    try:
        (folder / "assets").mkdir(parents=True, exist_ok=True)
        (folder / "meshes").mkdir(exist_ok=True)
        write_file(folder / "meshes" / f"{record['mesh_sha256']}.glb", mesh)
        write_file(folder / "assets" / f"{key}.json", json.dumps(record, indent=1).encode())
    except OSError as error:
        raise GenerationError(f"cannot keep it: {error.filename}: {error.strerror}") from None


def generate_asset(
    key: str, requirement: AssetRequirement, decision: Decision, generator: Generator, seed: int
) -> AssetConfiguration:
    """The configuration of a mesh made for a requirement.

    Args:
        key: Asset id in the document.
        requirement: What is needed.
        decision: The closed gate, whose candidates stay recorded.
        generator: Who makes it.
        seed: Seed of the generation.

    Raises:
        GenerationError: If there is no usable mesh.
    """
    from esg.assets.imports.imported import configure_imported
    from esg.assets.imports.store import as_entry, find_record, library_root

    prompt = prompt_of(requirement)
    asset = _key(prompt, requirement, seed, generator.name)
    found = find_record(f"{LIBRARY}/{asset}")
    if found is None:
        data = generator.generate(prompt, seed)
        _import(data, asset, prompt, requirement, generator.name, library_root() / LIBRARY)
        found = find_record(f"{LIBRARY}/{asset}")
        assert found is not None
    entry = as_entry(found[1], LIBRARY)
    chosen = Decision(entry, decision.confidence, decision.runners_up)
    made = configure_imported(key, requirement, chosen)
    return made.model_copy(update={"source": "generated"})
