"""The `esg` command. Commands live in `esg.commands`; this file only ties them together."""

from __future__ import annotations

import atexit
import gc
import os
import signal
import sys

from esg import __version__
from esg.outcomes import UserError

GC_THRESHOLD = 100_000
"""Objects made between two searches for garbage. Importing the libraries of a scene makes millions
that stay: Python's 700 cost a fifth of it."""


EXTRAS = {
    "cma": "baselines", "coacd": "convex", "dask": "dask", "distributed": "dask",
    "open_clip": "clip", "openai": "llm", "opentelemetry": "observe",
    "prefect_dask": "dask", "prefect_ray": "ray",
    "pydantic_ai": "llm", "ray": "ray", "torch": "clip",
}  # fmt: skip
"""Packages that are not always installed, and the extra that brings them."""


def missing(module: str) -> str:
    """What to install when a package is not there; nothing if it is one of our own."""
    package = module.partition(".")[0]
    if package in ("", "esg", "tasks", "flows"):
        return ""
    extra = f"[{EXTRAS[package]}]" if package in EXTRAS else ""
    return f'this needs the package {package}: pip install "esg-scenes{extra}"'


def interrupted(error: BaseException | None) -> bool:
    """Whether an error is Ctrl-C that a library caught and raised as one of its own."""
    while error is not None:
        if isinstance(error, KeyboardInterrupt) or "KeyboardInterrupt" in str(error):
            return True
        error = error.__cause__ or error.__context__
    return False


def _remedy(error: OSError) -> str:
    """What the system says, and what to do about it where that is known."""
    from pathlib import Path

    from esg.files import explained

    error = explained(error, Path(error.filename or "output"))
    return error.strerror or str(error)


def build_app():  # the return type would import cyclopts for nothing
    """The command-line application."""
    from cyclopts import App

    from esg.commands import COMMANDS

    app = App(
        name="esg",
        version=__version__,
        help="Text to physically consistent dynamic 3D scenes, at dataset scale.",
        help_format="plaintext",
    )
    for name, (where, help_line) in COMMANDS.items():
        app.command(where, name=name, help=help_line)
    app.register_install_completion_command(help="Complete words in this shell from now on.")
    return app


def main() -> None:
    """Runs one command and exits with its code: 0 good, 1 error, 2 usage, 3 some scenes failed."""
    from esg.commands.console import fail, flush, quiet_native_output, silence
    from esg.commands.parsing import parse
    from esg.commands.stopping import answer_signals, heard, stopped
    from esg.telemetry.watching import watched
    from esg.up.client import delegated

    gc.set_threshold(GC_THRESHOLD, 20, 20)
    try:
        code = delegated(sys.argv[1:])
        if code is None:
            from esg.up.apart import apart

            code = apart(main, sys.argv[1:])
        if code is not None:
            sys.exit(code)
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)
    quiet_native_output()
    arguments = sys.argv[1:]
    as_json = "--json" in arguments
    answer_signals(as_json)
    try:
        call = parse(build_app(), arguments)
        with watched(arguments):
            code = call()
        flush()
    except UserError as error:
        code = fail(str(error), error.exit_code, as_json)
    except KeyboardInterrupt:
        code = stopped(as_json)
    except BrokenPipeError:
        silence()  # the reader (head, less) has closed: nothing more to tell it
        code = 1
    except OSError as error:
        if os.environ.get("ESG_DEBUG"):
            raise
        if error.filename is None:
            silence()  # the output itself cannot be written
        told = f"{error.filename or 'output'}: {_remedy(error)}"
        code = fail(told, 1, as_json and error.filename is not None)
    except Exception as error:
        if interrupted(error) or heard():
            sys.exit(stopped(as_json))
        if os.environ.get("ESG_DEBUG"):
            raise
        if isinstance(error, ModuleNotFoundError) and (told := missing(error.name or "")):
            sys.exit(fail(told, 2, as_json))
        what = " ".join(f"{type(error).__name__}: {error}".split())
        code = fail(f"a defect of this software: {what}; ESG_DEBUG=1 shows where", 1, as_json)
    sys.exit(code if isinstance(code, int) else 0)


def run() -> None:
    """The console script: `main`, and an end that does not take the libraries apart.

    What is imported and cached goes with the process; Python would free it object by object, which
    takes longer than a search.
    """
    code = [1]
    atexit.register(_leave, code)  # the first to be registered is the last to be called
    try:
        main()
    except SystemExit as error:
        code[0] = error.code if isinstance(error.code, int) else int(error.code is not None)
        raise


def _leave(code: list[int]) -> None:
    from esg.commands.console import silence

    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except (AttributeError, OSError, ValueError):
            silence()
    os._exit(code[0])


if __name__ == "__main__":
    run()
