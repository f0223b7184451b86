"""The `esg` command. Commands live in `esg.commands`; this file only ties them together."""

from __future__ import annotations

import os
import sys

from esg import __version__
from esg.outcomes import UserError


def build_app():  # the return type would import cyclopts for nothing
    """The command-line application."""
    from cyclopts import App

    from esg.commands import COMMANDS

    app = App(
        name="esg",
        version=__version__,
        help="Text to physically consistent dynamic 3D scenes, at dataset scale.",
        help_format="plaintext",
        suppress_keyboard_interrupt=False,  # `main` says what is kept
    )
    for name, (where, help_line) in COMMANDS.items():
        app.command(where, name=name, help=help_line)
    return app


def main() -> None:
    """Runs one command and exits with its code: 0 good, 1 error, 2 usage, 3 some scenes failed."""
    from esg.commands.console import emit, quiet_native_output

    quiet_native_output()
    as_json = "--json" in sys.argv[1:]
    try:
        code = build_app()(result_action="return_value")
        sys.stdout.flush()
    except UserError as error:
        if as_json:
            emit({"error": str(error), "exit_code": error.exit_code})
        print(f"esg: {error}", file=sys.stderr)
        code = error.exit_code
    except KeyboardInterrupt:
        print("esg: interrupted; finished stages are kept, run the same command again to go on",
              file=sys.stderr)  # fmt: skip
        code = 130
    except BrokenPipeError:
        # The reader (head, less) has closed: nothing more to tell it.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        code = 1
    sys.exit(code if isinstance(code, int) else 0)


if __name__ == "__main__":
    main()
