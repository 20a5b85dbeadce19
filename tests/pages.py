"""Blocks of code in README and manual, and the commands among them."""

import os
import re
import subprocess
import textwrap

from projects import ROOT

README, EXTENDING = ROOT / "README.md", ROOT / "docs" / "extending.md"


def blocks(document, language):
    """Fenced blocks of a language, those inside lists included."""
    text = document.read_text(encoding="utf-8")
    found = re.findall(rf"^( *)```{language}\n(.*?)^\1```", text, re.MULTILINE | re.DOTALL)
    return [textwrap.dedent(block) for _, block in found]


def named_blocks(document):
    """Blocks that begin with the name of a file, by that name, without it."""
    found = {}
    for language in ("python", "yaml", "rst"):
        for block in blocks(document, language):
            if match := re.match(r"(?:#|\.\.) (\S+\.\w+)\n", block):
                found[match.group(1)] = block[match.end() :]
    return found


def commands(document):
    return [line for block in blocks(document, "sh") for line in block.splitlines()]


def run(command, folder=ROOT, **environment):
    environment = {**os.environ, "PYTHONPATH": str(folder / "src"), **environment}
    return subprocess.run(
        command, cwd=folder, capture_output=True, text=True, env=environment, check=False
    )
