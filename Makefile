# Two commands: `make` rebuilds every figure, table and the report; `make test` checks the project.

PYTHON ?= python3
BIN := .venv/bin
# Twice quiet leaves the errors: warnings here concern a machine's own settings, not of the project.
PIP := PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_ROOT_USER_ACTION=ignore $(BIN)/python -m pip --quiet --quiet

# Elsewhere than into .venv these would install, or nothing at all.
unexport PIP_TARGET PIP_PREFIX PIP_ROOT PIP_PYTHON PIP_DRY_RUN
export PIP_USER := 0

# The workflow compiles its kernels into this folder; the tests find them there.
export NUMBA_CACHE_DIR := $(CURDIR)/.numba_cache

# Tests run side by side, those of one file one after the other, each process on one core.
SIDE_BY_SIDE := --numprocesses auto --dist loadfile
test slow nightly: export OPENBLAS_NUM_THREADS := 1
# Their many processes start faster from bytecode, also where the surroundings forbid to write it.
test slow nightly: export PYTHONDONTWRITEBYTECODE :=

# Runs a command and shows what it says only if it fails.
quietly = @output=$$($(1) 2>&1) || { printf '%s\n' "$$output" >&2; exit 1; }

# Says what is missing where there is no uv.
need_uv = command -v uv >/dev/null || { \
    echo "Remaking $@ needs uv: https://docs.astral.sh/uv." >&2; exit 1; }

.PHONY: all help test slow nightly lint readme docs clean

all: .venv/installed ## Rebuild every figure, table and the report in results/.
	@echo "Rebuilding every figure, table and the report in results/."
	@$(BIN)/snakemake -c2

help: ## Print these targets, and those of the workflow where it is installed.
	@echo "make TARGET, where TARGET is one of"
	@awk -F ':.*## ' '/^[a-z.-]+:.*## / { printf "  %-15s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))
	@if test -x $(BIN)/snakemake; then \
	    echo "source .venv/bin/activate; snakemake -c2 TARGET, where TARGET is one of"; \
	    $(BIN)/snakemake --list-target-rules 2>/dev/null | grep ' ('; \
	else echo "The targets of the workflow are shown once make has installed it."; fi

test: lint ## Check style and types, and run the fast tests.
	@echo "Running the fast tests (others: make slow, make nightly)."
	@$(BIN)/pytest $(SIDE_BY_SIDE)

slow: .venv/installed ## Run the slow tests, which belong to every push.
	@echo "Running the slow tests."
	@$(BIN)/pytest $(SIDE_BY_SIDE) -m slow

nightly: .venv/installed ## Run the tests that are too heavy for every push, one after the other.
	@echo "Running the nightly tests."
	@$(BIN)/pytest -rs -m nightly

lint: .venv/installed ## Check the style, the workflow's rules and the types.
	@echo "Checking style, the workflow's rules and types."
	$(call quietly,$(BIN)/ruff check .)
	$(call quietly,$(BIN)/ruff format --check .)
	$(call quietly,$(BIN)/snakefmt --check Snakefile workflow/rules)
	$(call quietly,$(BIN)/python -m mypy)

# An installation keeps a copy of what it was made from: time stamps say nothing.
.PHONY: $(shell cat environment.txt pyproject.toml | cmp -s - .venv/installed || echo .venv/installed)
.venv/installed:
	@case "$(CURDIR)" in *[" :"]*) echo "Python makes no environment whose path holds a colon, and Snakemake starts no job from one with a blank: move $(CURDIR)." >&2; exit 1;; esac
	@command -v $(PYTHON) >/dev/null || { \
	    echo "There is no $(PYTHON) here: please install Python 3.11 or newer." >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and \
	    "Python 3.11 or newer is needed, but $(PYTHON) is %d.%d: please name a newer one, for example make PYTHON=python3.12." \
	    % sys.version_info[:2])'
	@echo "Installing the pinned packages of environment.txt into .venv."
	@$(PYTHON) -m venv --clear .venv
	@$(PIP) install --require-hashes -r environment.txt
	@$(PIP) install --no-deps --no-build-isolation -e .
	@cat environment.txt pyproject.toml > $@

# Made again only when they are asked for by name, so that uv is needed for nothing else.
ifneq ($(filter %environment.txt,$(MAKECMDGOALS)),)
.PHONY: environment.txt docs/environment.txt
endif
PIN = uv pip compile --quiet --universal --python-version 3.11 --generate-hashes \
    --no-emit-index-url --no-emit-find-links --no-annotate --custom-compile-command "make $@"
environment.txt: ## Pin every dependency again.
	@$(call need_uv)
	@echo "Pinning every dependency of pyproject.toml in environment.txt."
	@$(PIN) --all-extras --output-file $@ pyproject.toml

docs/environment.txt: ## Pin again what builds the manual.
	@$(call need_uv)
	@echo "Pinning what builds the manual in docs/environment.txt."
	@$(PIN) --group docs --constraint environment.txt --output-file $@

readme: .venv/installed ## Bring the numbers of README and manual up to date.
	@echo "Bringing the numbers of README and manual up to date."
	@$(BIN)/snakemake -c2
	@$(BIN)/python docs/measured.py

docs: .venv/docs-installed ## Build the manual from pages, docstrings and results.
	@echo "Building the manual in docs/_build/html."
	$(call quietly,$(BIN)/sphinx-build -E -W --keep-going -b html docs docs/_build/html)

.PHONY: $(shell cmp -s docs/environment.txt .venv/docs-installed || echo .venv/docs-installed)
.venv/docs-installed: .venv/installed
	@echo "Installing the packages that build the manual."
	@$(PIP) install --require-hashes --no-deps -r docs/environment.txt
	@cp docs/environment.txt $@

clean: ## Remove results and caches; .venv stays.
	@echo "Removing results and caches; .venv stays."
	@rm -rf results docs/_build docs/generated .snakemake .numba_cache \
	    .pytest_cache .ruff_cache .mypy_cache .hypothesis
