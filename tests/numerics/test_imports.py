"""What a rule is rebuilt for: the files that its script imports, found by reading alone."""

import ast
import json
import re
import subprocess
import sys

import pytest
from projects import ROOT

import granular_fronts
from granular_fronts.numerics.imports import import_closure, module_files, named_in

FOLDER = ROOT / "workflow/scripts"
SOURCES = [ROOT / "src", ROOT / "workflow/lib", FOLDER, *FOLDER.glob("*/")]
FILES = module_files(*SOURCES)
SCRIPTS = sorted(file.stem for file in [*FOLDER.glob("*.py"), *FOLDER.glob("*/*.py")])

LIST_WHAT_IS_LOADED = """
import json, sys
from importlib import import_module

names, watched = map(set, json.load(sys.stdin))
loaded = {}
for name in sorted(names):
    for known in watched & set(sys.modules):
        del sys.modules[known]
    import_module(name)
    loaded[name] = sorted(watched & set(sys.modules))
print(json.dumps(loaded))
"""


@pytest.mark.slow
def test_all_that_python_loads_is_found_by_reading():
    """A fresh process imports scripts and parts of them, one after the other and nothing else."""
    by_string = [name for name in FILES if re.match(r"problems\.|granular_fronts\.\w+$", name)]
    run = subprocess.run(
        [sys.executable, "-c", LIST_WHAT_IS_LOADED],
        input=json.dumps([SCRIPTS + by_string, list(FILES)]),
        capture_output=True,
        text=True,
        check=False,
        env={"PYTHONPATH": ":".join(map(str, SOURCES))},
    )
    assert run.returncode == 0, run.stderr
    loaded = json.loads(run.stdout)
    assert set(SCRIPTS) < set(loaded)
    for name, modules in loaded.items():
        missed = set(modules) - import_closure([name], FILES)
        assert not missed, f"{name} imports {sorted(missed)}"


def test_the_same_imports_are_read_as_python_parses():
    for name, file in FILES.items():
        nodes = list(ast.walk(ast.parse(file.read_bytes())))
        parsed = {
            alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names
        }
        for node in nodes:
            if isinstance(node, ast.ImportFrom):
                parsed |= {f"{node.module}.{alias.name}" for alias in node.names}
        assert parsed <= named_in(file), name


def test_imports_inside_functions_and_packages_above_are_found(tmp_path):
    (tmp_path / "package").mkdir()
    for name, text in {
        "package/__init__": "import beside\n",
        "package/kernel": "import numpy\n",
        "beside": "import alone\n",
        "alone": "",
        "apart": "",
        "script": "def step():\n    from package import (\n        kernel as fast,\n    )\n",
    }.items():
        (tmp_path / f"{name}.py").write_text(text)
    found = import_closure(["script"], module_files(tmp_path))
    assert found == {"script", "package", "package.kernel", "beside", "alone"}


def test_unknown_module_is_refused():
    with pytest.raises(ValueError, match="no module measure_nothing: correct the rule"):
        import_closure(["measure_nothing"], FILES)


LOOPS = (
    'code=lambda wildcards: digest_of("study", f"granular_fronts.{STUDIES[wildcards.study][0]}")',
    'code=code("figure_step", script_of(figure)), script=script_of(figure)',
    "code=code(solving)",
    '**table_params(table), script=script_file(TABLES[table]["script"])',
)
"""Parameters of rules that a loop makes: their code is that of the script that they name."""


def test_every_rule_stands_on_the_imports_of_its_script():
    text = "\n".join(file.read_text() for file in sorted((ROOT / "workflow/rules").glob("*.smk")))
    parts = re.split(r"^(?= *(?:rule |rule:|checkpoint ))", text, flags=re.MULTILINE)
    rules = [re.sub(r"\(\s+", "(", re.sub(r",\s+", ", ", rule)) for rule in parts]
    by_loop = dict.fromkeys(LOOPS, 0)
    for rule in (rule for rule in rules if "script:" in rule):
        if looped := [asked for asked in LOOPS if asked in rule]:
            by_loop[looped[0]] += 1
            continue
        script = re.search(r"/scripts/(?:\w+/)?(\w+)\.py", rule)[1]
        by_string = "import_module(" in FILES[script].read_text()
        asked = f'code=code("{script}", ' if by_string else f'code=code("{script}")'
        if script == "solve_chunk":  # What it imports depends on the campaign.
            asked = f'code=campaign_code("{script}")'
        assert asked in rule, script
    assert set(by_loop.values()) == {1}


def test_no_module_takes_a_public_name_that_is_imported_when_it_is_used():
    """Such a name is found in no import statement."""
    public = {f"granular_fronts.{name}" for name in granular_fronts.__all__}
    for name, file in FILES.items():
        assert not public & named_in(file), name
        assert "import granular_fronts as" not in file.read_text(), name
