"""Reading a command line: every mistake in it told at once, in this project's own words."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Literal, get_args, get_origin

from esg.api.inputs import listed
from esg.outcomes import UserError

if TYPE_CHECKING:
    from cyclopts import App
    from cyclopts.argument import Argument
    from cyclopts.exceptions import CycloptsError, UnknownOptionError

MAX_MISTAKES = 20


def parse(app: App, tokens: Sequence[str]) -> Callable[[], Any]:
    """The call that a command line asks for.

    The parser stops at its first mistake; here what was wrong is set aside and the rest is read
    again, until all mistakes are known.

    Args:
        app: The application.
        tokens: Arguments of the process, without its name.

    Raises:
        UserError: With one line a mistake.
    """
    from cyclopts.exceptions import CycloptsError, UnknownOptionError, UnusedCliTokensError

    left, problems = _without_fractions(app, list(tokens))
    command, unknown = "", False
    complained: set[str] = set()
    while len(problems) < MAX_MISTAKES:
        try:
            function, bound, _ = app.parse_args(left, exit_on_error=False, print_error=False)
        except CycloptsError as error:
            command = " ".join(error.command_chain or ())
            # What follows an unknown option may be its value: no second complaint about it.
            if not (unknown and isinstance(error, UnusedCliTokensError)):
                text = _message(error, complained)
                problems += [text] if text else []
            unknown |= isinstance(error, UnknownOptionError)
            repaired = _repaired(left, error)
            if repaired is None:
                break
            left = repaired
        else:
            if not problems:
                return lambda: function(*bound.args, **bound.kwargs)
            command = command or " ".join(app.parse_commands(left)[0])
            break
    raise UserError(f"{listed(problems)}\n`{f'esg {command}'.rstrip()} --help` lists what it takes")


def _without_fractions(app: App, tokens: list[str]) -> tuple[list[str], list[str]]:
    """A command line without the fractions given for whole numbers, and what is wrong with them.

    The parser itself would round `--seed 1.5`.

    Args:
        app: The application.
        tokens: The command line.
    """
    command = app.parse_commands(tokens)[1][-1]
    if not getattr(command.default_command, "__module__", "").startswith("esg."):
        return tokens, []  # no command, or the parser's own --help and --version
    names = {
        name
        for argument in command.assemble_argument_collection()
        if int in (argument.hint, *get_args(argument.hint))
        for name in argument.names
    }
    left, problems, k = list[str](), list[str](), 0
    while k < len(tokens) and tokens[k] != "--":
        name, given, value = tokens[k].partition("=")
        size = 1 if given else 2
        if not given:
            value = tokens[k + 1] if k + 1 < len(tokens) else ""
        if name in names and "." in value and not value.startswith("--"):
            problems.append(f"{name} {value}: {_WANTED[int]}")
            k += size
        else:
            left.append(tokens[k])
            k += 1
    return left + tokens[k:], problems


def _message(error: CycloptsError, complained: set[str]) -> str:
    """What was wrong, what was given and what would do; nothing if that was said before.

    Args:
        error: Of the parser.
        complained: Names of the parameters that were complained about; this one's is added.
    """
    from cyclopts.exceptions import (
        CoercionError,
        MissingArgumentError,
        RepeatArgumentError,
        UnknownCommandError,
        UnknownOptionError,
        UnusedCliTokensError,
    )

    if isinstance(error, UnknownCommandError):
        return _unknown_command(error)
    if isinstance(error, UnusedCliTokensError):
        extra = " ".join(repr(t) for t in error.unused_tokens or ())
        return f"{extra}: one argument too many; put quotes around a text with spaces"
    if isinstance(error, UnknownOptionError):
        return _unknown_option(error)
    argument = error.argument
    name = argument.name if argument is not None else ""
    if isinstance(error, MissingArgumentError) and argument is not None:
        if name in complained:
            return ""
        if error.keyword is not None:
            complained.add(name)
            return f"{error.keyword}: give a value"
        if argument.field_info.is_positional:
            name = name.removeprefix("--").upper()
        return f"{name} is missing"
    complained.add(name)
    if isinstance(error, RepeatArgumentError):
        return f"{error.token.keyword or name} is given more than once"
    if isinstance(error, CoercionError) and error.token is not None:
        given = f"{error.token.keyword or name} {error.token.value}"
        if get_origin(error.target_type) is Literal:
            return f"{given}: choose {', '.join(get_args(error.target_type))}"
        for kind, wanted in _WANTED.items():
            if error.target_type is kind:
                return f"{given}: {wanted}"
    return str(error).strip().removesuffix(".")


_WANTED = {int: "give a whole number", float: "give a number", bool: "takes no value"}


def _unknown_option(error: UnknownOptionError) -> str:
    import difflib

    given = error.token.keyword or error.token.value
    if " " in given:
        return f"{given!r} starts with a dash and is read as an option; put -- before it"
    names = [n for a in error.argument_collection if a.parse for n in a.names]
    # Without the dashes, which make all of them alike.
    near = difflib.get_close_matches(given.lstrip("-"), [n.lstrip("-") for n in names], n=1)
    near = [n for n in names if n.lstrip("-") in near]
    return f"there is no option {given}" + (f"; did you mean {near[0]}?" if near else "")


def _unknown_command(error: CycloptsError) -> str:
    import difflib

    given = (error.unused_tokens or [""])[0]
    names = [n for n in (error.app or ()) if not n.startswith("-")]
    near = difflib.get_close_matches(given, names, n=1, cutoff=0.6)
    hint = f"did you mean {near[0]}? " if near else ""
    return f"there is no command {given!r}; {hint}choose one of {', '.join(names)}"


def _repaired(tokens: list[str], error: CycloptsError) -> list[str] | None:
    """A command line that goes beyond an error; None if there is none.

    What was wrong is left out, what was missing gets any value.
    """
    from cyclopts.exceptions import (
        CoercionError,
        MissingArgumentError,
        RepeatArgumentError,
        UnknownOptionError,
        UnusedCliTokensError,
    )

    if isinstance(error, UnusedCliTokensError):
        left = list(tokens)
        for token in reversed(error.unused_tokens or []):
            if token in left:
                del left[len(left) - 1 - left[::-1].index(token)]
        return left if len(left) < len(tokens) else None
    if isinstance(error, MissingArgumentError):
        if error.keyword:
            return _drop(tokens, error.keyword, None)
        if error.argument is None:
            return None
        place = len(error.command_chain or ())
        return [*tokens[:place], *_any_value(error.argument), *tokens[place:]]
    if isinstance(error, UnknownOptionError):
        given = error.token.keyword or error.token.value
        # A text that starts with a dash stands where a text belongs.
        if " " in given and given in tokens:
            return ["text" if t == given else t for t in tokens]
        return _drop(tokens, given, None)
    if isinstance(error, CoercionError | RepeatArgumentError) and error.token is not None:
        return _drop(tokens, error.token.keyword, error.token.value)
    return None


def _any_value(argument: Argument) -> list[str]:
    """Tokens that give a required parameter some value."""
    hint = argument.hint
    return [argument.name, str(get_args(hint)[0]) if get_origin(hint) is Literal else "1"]


def _drop(tokens: list[str], keyword: str | None, value: str | None) -> list[str] | None:
    """Leaves out the last `keyword value` or `keyword=value`, or a bare value."""
    for k in reversed(range(len(tokens))):
        token = tokens[k]
        if keyword is None:
            if token == value:
                return tokens[:k] + tokens[k + 1 :]
        elif token == keyword:
            count = 2 if value is not None and tokens[k + 1 : k + 2] == [value] else 1
            return tokens[:k] + tokens[k + count :]
        elif token.startswith(f"{keyword}="):
            return tokens[:k] + tokens[k + 1 :]
    return None
