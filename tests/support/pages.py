"""Pages of README and manual: their blocks of code and commands, the scripts that write them."""

import importlib.util
import os
import re
import runpy
import subprocess
import sys
import textwrap

from granular_fronts import errors
from projects import ROOT

# Scripts of the manual import each other.
sys.path.append(str(ROOT / "docs"))

README, EXTENDING = ROOT / "README.md", ROOT / "docs" / "develop.md"
PLACE = re.compile(r"(?:#|\.\.) (\S+\.\w+)(?:, (above|below) (.+))?\n")
FENCE = re.compile(r"^( *)```(\S*)[^\n]*\n(.*?)^\1```", re.MULTILINE | re.DOTALL)


def load_script(name):
    """Import a script of the manual."""
    spec = importlib.util.spec_from_file_location(name, ROOT / "docs" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def blocks(document, language):
    """Fenced blocks of a language, those inside lists included."""
    return [block for name, block in all_blocks(document) if name == language]


def all_blocks(document):
    """Language and text of every fenced block."""
    found = FENCE.findall(document.read_text(encoding="utf-8"))
    return [(language, textwrap.dedent(block)) for _, language, block in found]


def placed_blocks(subject, page=EXTENDING):
    """File, side, line and text of each block under a heading of a page."""
    sections = page.read_text(encoding="utf-8").split("\n## ")
    [section] = [section for section in sections if section.startswith(subject)]
    for _, _, block in FENCE.findall(section):
        if match := PLACE.match(block := textwrap.dedent(block)):
            yield *match.groups(), block[match.end() :]


def carry_out(project, subject, but=None, page=EXTENDING):
    """Change a project as a page says; the files that were changed."""
    changed = set()
    for name, side, line, text in placed_blocks(subject, page):
        if name == but:
            continue
        file = project / name
        file.parent.mkdir(exist_ok=True)
        lines = file.read_text(encoding="utf-8").splitlines(True) if file.exists() else []
        at = len(lines)
        if side:
            [at] = [n for n, found in enumerate(lines) if found.strip().startswith(line)]
            at += side == "below"
        file.write_text("".join([*lines[:at], text, *lines[at:]]), encoding="utf-8")
        changed.add(name)
    return changed


def commands(document):
    return [line for block in blocks(document, "sh") for line in block.splitlines()]


def commands_in_lines(document):
    """Commands inside sentences, without those that leave a name to the reader."""
    text = FENCE.sub("", document.read_text(encoding="utf-8"))
    found = re.findall(r"`((?:make|snakemake|python) [^`]+)`", text)
    return [command for command in found if not re.search("…|[A-Z]{4}", command)]


def run(command, folder=ROOT, **environment):
    environment = {**os.environ, "PYTHONPATH": f"{folder}/src:{folder}/workflow/lib", **environment}
    return subprocess.run(
        command, cwd=folder, capture_output=True, text=True, env=environment, check=False
    )


def run_module(monkeypatch, module, *words):
    """What `python -m` of a module ends with, None if it ends well; in this process."""
    monkeypatch.setattr(sys, "argv", [module, *map(str, words)])
    monkeypatch.setattr(errors, "end_with_reader", lambda: None)
    try:
        runpy.run_module(module, run_name="__main__")
    except SystemExit as end:
        return end.code
