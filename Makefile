# Every command that a person or CI runs; `make help` lists them.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
CARGO := cargo
TEST_PROFILE := optimised-test

RUST := $(shell find crates \( -name '*.rs' -o -name '*.json' -o -name Cargo.toml \) -not -path '*/target/*')
SCENARIOS := $(wildcard scenarios/*)

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help build run check-engine test test-rust test-python lint lint-rust lint-python format bench digests wheel wheel-check floors clean

help: ## List these commands
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-12s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

build: $(VENV)/.built ## Build the engine and set up .venv with the package and its tools

run: build ## Run the exercise both ways into out/midterm/
	@mkdir -p out/midterm
	$(BIN)/carom run midterm --out out/midterm/exact --overwrite
	$(BIN)/carom run midterm --method stepped --dt 0.03 --out out/midterm/stepped --overwrite

check-engine: ## Check the engine while you work on it: format, lints, laws, scenarios, digests
	@$(need_rust)
	$(CARGO) fmt --all --check
	$(CARGO) clippy --locked -p carom --all-targets -- -D warnings
	$(CARGO) test --locked --quiet -p carom --lib --test arrows --test scenario --test digests
	$(CARGO) test --locked --quiet -p carom --test engine -- laws references closed_forms

test: test-rust test-python lint ## Run every test and lint

test-rust: ## Run the engine's tests, the golden digests in an unoptimised build too
	@$(need_rust)
	$(CARGO) test --locked --profile $(TEST_PROFILE) --workspace --exclude carom-python
	$(CARGO) test --locked -p carom --test digests

test-python: build ## Run the package's tests
	$(BIN)/python -m pytest

lint: lint-rust lint-python ## Check format, lints, types and stubs

lint-rust: ## Check format and lints of the Rust code
	@$(need_rust)
	$(CARGO) fmt --all --check
	$(CARGO) clippy --locked --workspace --all-targets -- -D warnings

lint-python: build ## Check format, lints, types and stubs of the Python code
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/python -m mypy.stubtest carom._engine

format: $(VENV)/.tools ## Format the code, and mend what the linter can mend
	@$(need_rust)
	$(CARGO) fmt --all
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

bench: build ## Measure the engine, the package, and python-billiards beside it
	$(CARGO) bench --locked -p carom
	$(BIN)/python -m pip install --quiet --group bench
	$(BIN)/python benches/python.py

digests: ## Mint the golden digests of the scenarios anew: make digests REASON="..."
	@$(need_rust)
	CAROM_MINT_DIGESTS="$(REASON)" $(CARGO) test --locked --profile $(TEST_PROFILE) -p carom --test digests

wheel: $(VENV)/.tools ## Build a wheel and a source archive into dist/
	@$(need_rust)
	@# The archive leaves other members of the workspace out, so its Cargo.lock is longer than it need be: not --locked.
	$(BIN)/maturin build --release --sdist --out dist

wheel-check: wheel ## Install the wheel, and one built from the source archive, into fresh environments and try them
	tests/packaging/check.sh $(BIN)/python dist

floors: wheel ## Run the package's tests with the oldest supported Python packages (FLOOR_PYTHON=python3.10)
	tests/packaging/floors.sh $(FLOOR_PYTHON) dist

clean: ## Remove everything that was built
	rm -rf target $(VENV) out dist .pytest_cache .ruff_cache .mypy_cache .hypothesis
	rm -f python/carom/_engine*.so
	find python tests -name __pycache__ -type d -prune -exec rm -rf {} +

FLOOR_PYTHON ?= python3.10

need_rust = command -v $(CARGO) >/dev/null \
	|| { echo "Carom's engine is built with Rust 1.88 or newer: https://rustup.rs says how to get it"; exit 1; }
need_python = $(PYTHON) -c 'import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 10))' 2>/dev/null \
	|| { echo "Carom needs Python 3.10 or newer with venv (on Debian: python3-venv); name one with make PYTHON=..."; exit 1; }

$(VENV)/.tools: pyproject.toml
	@$(need_python)
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade 'pip>=25.1'
	$(BIN)/python -m pip install --quiet --group dev
	@touch $@

$(VENV)/.built: $(VENV)/.tools $(RUST) Cargo.toml Cargo.lock $(SCENARIOS)
	@$(need_rust)
	VIRTUAL_ENV=$(abspath $(VENV)) $(BIN)/maturin develop --release --locked --extras all
	@touch $@
