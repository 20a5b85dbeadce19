"""What a rule is rebuilt for: the files that its script imports, found by reading alone."""

import ast
import json
import re
import subprocess
import sys

import pytest

import granular_fronts
from granular_fronts.numerics.imports import import_closure, module_files, named_in
from projects import ROOT

FOLDER = ROOT / "workflow/scripts"
SOURCES = [ROOT / "src", ROOT / "workflow/lib", FOLDER, FOLDER / "figures"]
SOURCES += sorted((ROOT / "projects").glob("*/"))
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
        parsed = set()
        for node in ast.walk(ast.parse(file.read_bytes())):
            if isinstance(node, ast.Import | ast.ImportFrom):
                module = f"{node.module}." if isinstance(node, ast.ImportFrom) else ""
                parsed |= {f"{module}{alias.name}" for alias in node.names}
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


def test_every_rule_stands_on_the_imports_of_its_script():
    rules = sorted([*(ROOT / "workflow/rules").glob("*.smk"), *ROOT.glob("projects/*/rules.smk")])
    for file in rules:
        parts = re.split(r"^(?=(?:use )?rule )", file.read_text(), flags=re.MULTILINE)
        for rule in (one for one in parts if "script:" in one):
            script = re.search(r"/?(\w+)\.py\"", rule[rule.index("script:") :])[1]
            # What a study or a chunk imports depends on its wildcards.
            if script not in ("study", "solve_chunk"):
                assert re.search(rf"(=code|digest_of)\(\s*(\*\()?\"{script}\"", rule), (
                    file,
                    script,
                )


def test_no_module_takes_a_public_name_that_is_imported_when_it_is_used():
    """Such a name is found in no import statement."""
    public = {f"granular_fronts.{name}" for name in granular_fronts.__all__}
    for name, file in FILES.items():
        if name.startswith("test_"):
            continue
        assert not public & named_in(file), name
        assert "import granular_fronts as" not in file.read_text(), name
