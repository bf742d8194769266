"""Pages of the command line: usage, options, examples and exit codes, from the parsers themselves."""

import argparse
import html
import re
from collections.abc import Iterator, Sequence

from trimmer.command_line import main as command_line
from trimmer.command_line.command import Command, Example
from trimmer.command_line.main import installed_commands

CODE = re.compile(r"(\d+) ([^;.]+)")
GROUPS = {"positional arguments": "Arguments", "options": "Options"}
"""Titles in place of those of argparse."""


def command_pages() -> dict[str, tuple[str, str]]:
    """Return title and Markdown of each page by its name; ``index`` lists the commands."""
    commands = installed_commands()
    parsers = _parsers(command_line._parser(commands))
    pages = {each.name: (f"trimmer {each.name}", _page(each, parsers[each.name])) for each in commands}
    return {"index": ("Overview", _overview(commands)), **pages}


def _parsers(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    (choices,) = (
        action.choices for action in parser._actions if isinstance(action, argparse._SubParsersAction)
    )
    return dict(choices)


def _overview(commands: Sequence[Command]) -> str:
    rows = [f"| [`trimmer {each.name}`]({each.name}.md) | {each.help} |" for each in commands]
    codes = [f"| {code} | {meaning} |" for code, meaning in CODE.findall(command_line.EXIT_CODES)]
    return "\n".join(
        [
            "# Command line\n",
            "`trimmer COMMAND --help` prints what these pages hold.\n",
            "| command | what it does |\n| --- | --- |",
            *rows,
            "\n## Rules for all commands\n",
            "- An option that would have no effect is an error, and so is a single value given twice.",
            "- `-` is standard input where a file is read; pipes and `/dev/stdout` are streams.",
            "- A file is replaced only if it is empty or of the kind that is written, or with `--overwrite`.",
            "- `--json` prints one object in SI units; [its keys](../../json.md).",
            "- Messages go to standard error, results to standard output.",
            "\n## Exit codes\n",
            "| code | meaning |\n| --- | --- |",
            *codes,
            "",
        ]
    )


def _page(command: Command, parser: argparse.ArgumentParser) -> str:
    parts = [f"# trimmer {command.name}", _sentence(parser.description or command.help)]
    parts += [f'```text title="Usage"\n{_usage(parser)}\n```', *_examples(command.examples)]
    for group in parser._action_groups:
        rows = [_row(action, parser) for action in group._group_actions if action.help != argparse.SUPPRESS]
        if rows:
            title = GROUPS.get(group.title or "", group.title)
            parts.append(
                f"## {title}\n\n| {title or 'option'} | meaning |\n| --- | --- |\n" + "\n".join(rows)
            )
    parts.append("Exit codes are those of [all commands](index.md#exit-codes).")
    return "\n\n".join(parts) + "\n"


def _usage(parser: argparse.ArgumentParser) -> str:
    return parser.format_usage().removeprefix("usage: ").rstrip()


def _examples(examples: Sequence[Example]) -> Iterator[str]:
    if examples:
        yield "## Examples"
    for example in examples:
        yield f"{_sentence(example.purpose)}\n\n```sh\n{example.words}\n```"


def _row(action: argparse.Action, parser: argparse.ArgumentParser) -> str:
    told = parser._get_formatter()._expand_help(action) if action.help else ""
    return f"| {_names(action, parser)} | {_cell(told)} |"


def _names(action: argparse.Action, parser: argparse.ArgumentParser) -> str:
    value = "" if action.nargs == 0 else parser._get_formatter()._format_args(action, _placeholder(action))
    if not action.option_strings:
        return f"<code>{_cell(value)}</code>"
    return ", ".join(f"<code>{_cell(f'{name} {value}'.strip())}</code>" for name in action.option_strings)


def _placeholder(action: argparse.Action) -> str:
    if action.choices is not None:
        return "{" + ",".join(map(str, action.choices)) + "}"
    return action.dest.upper() if action.option_strings else action.dest


def _cell(text: str) -> str:
    return html.escape(text, quote=False).replace("|", "&#124;").replace("*", "&#42;").replace("\n", " ")


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}".rstrip(".") + "."
