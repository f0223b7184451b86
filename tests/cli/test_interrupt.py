"""Ctrl-C is no defect, wherever it falls."""

from __future__ import annotations

import pytest

from esg import cli


def caught(inside: BaseException, outside: Exception) -> Exception:
    """An error that a library raises because of another."""
    try:
        try:
            raise inside
        except BaseException as error:
            raise outside from error
    except Exception as error:
        return error


@pytest.mark.parametrize(
    ("module", "extra"), [("openai.types", "[llm]"), ("torch", "[clip]"), ("onnxruntime", "")]
)
def test_a_package_that_is_not_there_is_named(
    module: str,
    extra: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def app() -> object:
        raise ModuleNotFoundError(f"No module named {module!r}", name=module)

    monkeypatch.setattr("sys.argv", ["esg", "doctor"])
    monkeypatch.setattr(cli, "build_app", app)
    monkeypatch.setattr("esg.commands.console.quiet_native_output", lambda: None)
    with pytest.raises(SystemExit) as ended:
        cli.main()
    told = capsys.readouterr().err
    assert ended.value.code == 2
    assert module.partition(".")[0] in told and f'"esg-scenes{extra}"' in told


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (caught(KeyboardInterrupt(), RuntimeError("model not written")), 130),
        (ValueError("Error calling function `_ser_model`: KeyboardInterrupt:"), 130),
        (caught(KeyError("x"), RuntimeError("broken")), 1),
        (ModuleNotFoundError("No module named 'esg.x'", name="esg.x"), 1),
    ],
)
def test_an_interrupt_inside_a_library_is_told_as_one(
    error: Exception, code: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Pydantic turns a Ctrl-C that falls into a serializer into an error of its own."""

    def app() -> object:
        raise error

    monkeypatch.setattr("sys.argv", ["esg", "doctor"])
    monkeypatch.setattr(cli, "build_app", app)
    monkeypatch.setattr("esg.commands.console.quiet_native_output", lambda: None)
    with pytest.raises(SystemExit) as ended:
        cli.main()
    assert ended.value.code == code
    assert ("defect" in capsys.readouterr().err) is (code == 1)
