"""The attack that taught this project distrust, repeated: what a stranger's file makes commands do.

What `tests/security` opens within Python is opened here through the command line, by this checkout
or by an earlier one.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
import contextlib
from dataclasses import dataclass
import json
from pathlib import Path
import resource
import shutil
import zipfile

from benchmarks.faults import tampering
from benchmarks.faults.ground import MEMORY_BYTES, PATIENCE_S, ROOT, UGLY, esg, forked

PROMPT = "A bowling ball rolls into a pin."
LOOKING = (
    ["report", "scene", "--out", "page.html"],
    ["render", "scene", "--size", "32x32", "--fps", "2", "--out", "pictures"],
    ["export", "scene", "--to", "glb", "--out", "model"],
)
OPENING = (*LOOKING, ["replay", "scene"])


@dataclass(frozen=True)
class Place:
    """Where an attack happens.

    Args:
        folder: Its commands run here; `scene` is the folder that came from a stranger.
        marker: Exists if the stranger's code ran.
        secret: A file of the user that nobody shall see.
    """

    folder: Path
    marker: Path
    secret: Path

    @property
    def scene(self) -> Path:
        """The scene folder."""
        return self.folder / "scene"


@dataclass(frozen=True)
class Attack:
    """What a stranger does, and what the user then opens.

    Args:
        tamper: Changes the scene folder, or writes other files.
        commands: That the user runs.
    """

    tamper: Callable[[Place], object]
    commands: Sequence[Sequence[str]] = OPENING


def _model(lie: Callable[[dict[str, object]], None]) -> Callable[[Place], object]:
    def tamper(place: Place) -> None:
        document, binary = tampering.box()
        lie(document)
        for path in (place.scene / "meshes").glob("*.glb"):
            path.write_bytes(tampering.glb(document, binary))

    return tamper


def _recording(place: Place) -> None:
    with zipfile.ZipFile(place.scene / "rollout.npz", "w") as archive:
        archive.writestr("time.npy", tampering.array_of((10**12,), b"\0" * 80))


def _bomb(place: Place) -> None:
    packed = zipfile.ZipFile(place.scene / "rollout.npz", "w", zipfile.ZIP_DEFLATED)
    with packed as archive, archive.open("time.npy", "w", force_zip64=True) as entry:
        entry.write(tampering.array_of((2**29,), b""))
        for _ in range(2**12):
            entry.write(bytes(2**20))


def _long_program(place: Place) -> None:
    path = place.scene / "manifest.json"
    manifest = json.loads(path.read_bytes())
    manifest["program"]["duration"] = 1e9
    path.write_text(json.dumps(manifest))
    for name in ("rollout.npz", "rollout.mcap"):
        (place.scene / name).unlink()


def _aliases(place: Place) -> None:
    rows = ["a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    rows += [f"a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * 9)}]" for k in range(1, 10)]
    (place.folder / "x.yaml").write_text("\n".join((*rows, "suite, x", "scenes: *a9")))


def _shared_names(place: Place) -> None:
    scene = "{{id: '{}', prompt: A ball rolls., events: []}}"
    text = "\n  - ".join(("suite, x\nscenes:", scene.format("A/1"), scene.format("A?1")))
    (place.folder / "x.yaml").write_text(text)


def _many_keys(place: Place) -> None:
    path = place.scene / "esg.json"
    document = json.loads(path.read_bytes()) | {f"key_\x1b[31m{k}": k for k in range(50_000)}
    path.write_text(json.dumps(document))


def _deep_document(place: Place) -> None:
    (place.scene / "esg.json").write_text('{"a": ' + "[" * 200_000 + "]" * 200_000 + "}")


def _cut_cache(pattern: str) -> Callable[[Place], object]:
    def tamper(place: Place) -> None:
        found = list((place.folder / "cache" / "classes").glob(pattern))
        assert found, pattern
        for path in found:
            path.write_bytes(path.read_bytes()[: path.stat().st_size // 3])

    return tamper


def _plain(function: Callable[[Path, Path], None], to: str) -> Callable[[Place], object]:
    def tamper(place: Place) -> None:
        function(place.scene, getattr(place, to))

    return tamper


def _named(function: Callable[..., object]) -> str:
    return function.__name__.strip("_").replace("_", " ")


BENCH = (["bench", "x.yaml", "--runs", "1", "--out", "o"],)
ATTACKS: dict[str, Attack] = {
    **{
        f"class, {_named(f)}": Attack(_plain(f, "marker")) for f in tampering.TAMPERED
    },
    **{f"folder, {_named(f)}": Attack(_plain(f, "secret")) for f in tampering.ODD},
    **{
        f"model, {_named(lie)}": Attack(_model(lie), LOOKING)
        for lie in tampering.LIES
    },
    "recording, declares 8 TB": Attack(_recording),
    "recording, unpacks to 4 GiB": Attack(_bomb),
    "manifest, plays for 30 years": Attack(_long_program),
    "suite, 550 bytes of aliases": Attack(_aliases, BENCH),
    "suite, ids that share a folder": Attack(_shared_names, BENCH),
    "document, 50,000 unknown keys": Attack(_many_keys, (["check", "scene/esg.json"],)),
    "document, 200,000 levels": Attack(_deep_document, (["check", "scene/esg.json"],)),
    "cache, a library cut off": Attack(_cut_cache("*.so"), (["replay", "scene"],)),
    "cache, the runtime cut off": Attack(_cut_cache("*/runtime.o"), (["replay", "scene"],)),
}  # fmt: skip
"""All of it by name."""


def made_by(checkout: Path, folder: Path) -> Path:
    """A folder with a scene and a cache as a checkout makes them.

    Raises:
        RuntimeError: If it cannot.
    """
    folder.mkdir(parents=True)
    more = {"PYTHONPATH": str(checkout), "ESG_UP": "0"}
    ended = esg(["generate", PROMPT, "--out", "out"], folder, folder / "cache", 600.0, **more)
    if ended.code != 0:
        raise RuntimeError(f"{checkout}: {ended.err or ended.out}")
    (scene,) = (p.parent for p in (folder / "out").glob("*/prompt.txt"))
    scene.rename(folder / "scene")
    return folder


def attacked(name: str, made: Path, folder: Path, checkout: Path = ROOT) -> list[str]:
    """What an attack achieves, a line for every command that it reaches.

    Args:
        name: Of `ATTACKS`.
        made: Of `made_by`.
        folder: Where it happens; anew every time.
        checkout: Whose commands open the files.
    """
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(made, folder, symlinks=True)
    (folder / "home").mkdir()
    place = Place(folder, folder / "ran", folder / "home" / "key.txt")
    place.secret.write_text(tampering.SECRET)
    (place.scene / "SHA256SUMS").unlink(missing_ok=True)  # as whoever changes files would
    attack = ATTACKS[name]
    attack.tamper(place)
    found: list[str] = []
    for line in attack.commands:
        if checkout == ROOT:
            ended = forked(line, folder, folder / "cache", ESG_UP="0")
        else:
            more = {"PYTHONPATH": str(checkout), "ESG_UP": "0"}
            with _bounded():
                ended = esg(line, folder, folder / "cache", PATIENCE_S, **more)
        end = ""
        if place.marker.exists():
            end = "ran its code"
            place.marker.unlink()
        elif _leaked(place) or tampering.SECRET in ended.out + ended.err:
            end = "leaked a file"
        elif ended.code is None:
            end = "hung"
        elif ended.code < 0:
            end = "killed by a signal"
        elif "MemoryError" in ended.err or "bad_alloc" in ended.err:
            end = "wanted over 2 GiB"
        elif UGLY.search(ended.out + ended.err):
            end = "a traceback"
        elif "\x1b[31m" in ended.out + ended.err:
            end = "steered the terminal"
        found += [f"{line[0]}: {end}"] if end else []
    return found


def _leaked(place: Place) -> bool:
    made = [place.folder / "page.html", *(place.folder / "pictures").rglob("*"),
            *(place.folder / "model").rglob("*")]  # fmt: skip
    key = tampering.SECRET.encode()
    return any(p.is_file() and not p.is_symlink() and key in p.read_bytes() for p in made)


@contextlib.contextmanager
def _bounded() -> Generator[None]:
    """Commands that begin in the body may allocate 2 GiB."""
    before = resource.getrlimit(resource.RLIMIT_DATA)
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY_BYTES, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_DATA, before)
