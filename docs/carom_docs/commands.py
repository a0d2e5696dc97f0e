"""The command reference, from what ``--help`` prints."""

from __future__ import annotations

from typing import Any


def markdown() -> str:
    """Give a section for each command: what it does, how it is called, its options, examples."""
    import typer

    from carom.cli.app import app

    group: Any = typer.main.get_command(app)
    context = group.make_context("carom", ["--help"], resilient_parsing=True)
    names = group.list_commands(context)
    return "\n\n".join(_section(group.get_command(context, name), name, context) for name in names)


def _section(command: Any, name: str, parent: Any) -> str:
    context = command.context_class(command, info_name=name, parent=parent)
    described = " ".join(part.strip() if part.strip() else "\n\n" for part in command.help.splitlines())
    records = [record for option in command.get_params(context) if (record := option.get_help_record(context))]
    rows = [f"| {_code(names)} | {_cell(meaning)} |" for names, meaning in records]
    examples = [line.strip() for line in command.epilog.splitlines() if line.startswith("  ")]
    usage = " ".join([context.command_path, *command.collect_usage_pieces(context)])
    return "\n".join(
        [
            f"## carom {name}",
            "",
            described.replace(" \n\n ", "\n\n"),
            "",
            "```text",
            usage,
            "```",
            "",
            "| argument or option | meaning |",
            "|---|---|",
            *rows,
            "",
            "For example:",
            "",
            "```console",
            *(f"$ {example}" for example in examples),
            "```",
        ]
    )


def _code(text: str) -> str:
    return "`" + text.replace("|", "\\|") + "`"


def _cell(text: str) -> str:
    return " ".join(text.replace("|", "\\|").replace("*", "\\*").split())
