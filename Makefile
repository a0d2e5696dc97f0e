# Every command that a person or CI runs; `make help` lists them.

PYTHON ?= python3
VENV := .venv
POOLTOOL := .venv-pooltool
BIN := $(VENV)/bin
CARGO := cargo
TEST_PROFILE := optimised-test

RUST := $(shell find crates \( -name '*.rs' -o -name '*.json' -o -name Cargo.toml \) -not -path '*/target/*')
SCENARIOS := $(wildcard scenarios/*)

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
PAGE_ENGINE := web/engine/carom_wasm.js
PAGE := $(shell find web -type f -not -path '*/node_modules/*' -not -path 'web/dist*' -not -path 'web/engine/*' 2>/dev/null)

BUILT_PAGE := web/dist/carom-studio.html
PACKAGED := python/carom/studio/page/index.html
node_is_new = node -e 'const [a, b] = process.versions.node.split("."); process.exit(a < 20 || (a == 20 && b < 19) ? 1 : 0)'
HAS_NODE := $(shell $(node_is_new) 2>/dev/null && echo yes)

.PHONY: help build run page package-page studio tour test-page check-engine test built-tests test-rust test-python lint lint-rust lint-python format docs licences
.PHONY: pictures third-party bench bench-gas bench-page bench-pooltool campaign campaign-gas digests checkpoint wheel wheel-check floors clean

help: ## List these commands
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-14s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

build: $(VENV)/.built $(if $(HAS_NODE),$(PACKAGED)) ## Build the engine and set up .venv with the package and its tools
	@$(if $(HAS_NODE),,echo "Without Node.js 20.19 or newer, https://nodejs.org, carom studio and run.player() have no page")

run: build ## Run the exercise both ways into out/midterm/
	@mkdir -p out/midterm
	$(BIN)/carom run midterm --out out/midterm/exact --overwrite
	$(BIN)/carom run midterm --method stepped --dt 0.03 --out out/midterm/stepped --overwrite

page: $(BUILT_PAGE) ## Build the page of the studio into web/dist/, and as one file, web/dist/carom-studio.html

package-page: $(PACKAGED) ## Put the built page into the package, where wheels take it from

studio: build ## Open the studio in the browser
	$(BIN)/carom studio

test-page: page ## Run the page's tests in Chromium, and check its format, lints and types
	@$(need_chromium)
	cd web && npm run --silent check
	cd web && npm run --silent test

tour: page ## Take the pictures of the studio for the docs anew
	@$(need_chromium)
	cd web && node build/tour.mjs

check-engine: ## Check the engine while you work on it: format, lints, laws, scenarios, digests
	@$(need_rust)
	$(CARGO) fmt --all --check
	$(CARGO) clippy --locked -p carom --all-targets -- -D warnings
	$(CARGO) test --locked --quiet -p carom --lib --test arrows --test scenario --test digests
	$(CARGO) test --locked --quiet -p carom --test engine -- laws references closed_forms

# What keeps one core busy, as linking the package does, goes on beside something else.
test: ## Run every test and lint, and build the site
	@$(MAKE) --no-print-directory --jobs=2 build page built-tests
	@$(MAKE) --no-print-directory test-rust test-python test-page
	@$(MAKE) --no-print-directory --jobs=2 lint-rust docs
	@$(MAKE) --no-print-directory lint

built-tests: ## Build the engine's tests
	@$(need_rust)
	$(CARGO) test --locked --profile $(TEST_PROFILE) -p carom --no-run

test-rust: built-tests ## Run the engine's tests, the golden digests in an unoptimised build too
	$(CARGO) test --locked --profile $(TEST_PROFILE) -p carom
	$(CARGO) test --locked -p carom --test digests

test-python: build ## Run the package's tests
	@$(want_octave)
	$(BIN)/python -m pytest --numprocesses=auto

lint: lint-rust lint-python licences ## Check format, lints, types, stubs, project files and licences

lint-rust: ## Check the engine's format and lints
	@$(need_rust)
	$(CARGO) fmt --all --check
	$(CARGO) clippy --locked --workspace --all-targets -- -D warnings

lint-python: build ## Check the package's format, lints, types and stubs, and the files about the project
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/python -m mypy.stubtest carom._engine
	$(BIN)/deptry python
	$(BIN)/validate-pyproject pyproject.toml
	$(BIN)/check-jsonschema --builtin-schema vendor.citation-file-format CITATION.cff
	$(BIN)/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml

format: $(VENV)/.tools ## Format the code, and mend what the linter can mend
	@$(need_rust)
	$(CARGO) fmt --all
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

docs: build ## Build the site into site/, warnings as errors, and check its links
	$(BIN)/python -m pip install --quiet --group docs
	rm -rf site
	$(BIN)/python -m sphinx -W --keep-going -n -q -b html docs site
	$(BIN)/python docs/carom_docs/links.py site

pictures: build ## Draw the pictures of the README anew
	$(BIN)/python docs/carom_docs/front.py

licences: build web/node_modules/.package-lock.json ## Check the licences of all that is shipped, and THIRD-PARTY.txt
	@$(need_rust)
	$(BIN)/python -m doctest tests/packaging/licences.py
	$(BIN)/python tests/packaging/licences.py

third-party: build web/node_modules/.package-lock.json ## Write THIRD-PARTY.txt anew, after a change of a lock file
	@$(need_rust)
	$(BIN)/python tests/packaging/licences.py --write

bench: build ## Measure the engine, the package, and python-billiards beside it
	$(CARGO) bench --locked -p carom
	$(BIN)/python -m pip install --quiet --group bench
	$(BIN)/python benches/python.py

bench-gas: ## Measure gases of a thousand to a million discs, or one: make bench-gas GAS="0.5 10000 5e6"
	@$(need_rust)
	$(CARGO) run --locked --release -p carom --example gas -- $(GAS)

bench-page: build page ## Measure the page in Chromium, and the native engine beside it
	@$(need_chromium)
	$(BIN)/python benches/page.py

bench-pooltool: build $(POOLTOOL)/.built ## Play the same shots with pooltool 0.6.0, in a virtual environment of its own
	$(BIN)/python benches/pooltool/compare.py

campaign: ## Play a million random shots and hold them to what no run may break: make campaign SHOTS=... SEED=...
	@$(need_rust)
	$(CARGO) run --locked --release -p carom --example shots -- $(or $(SHOTS),1000000) $(or $(SEED),7)

campaign-gas: ## Hold gases to theory, in long runs: make campaign-gas PART=truth|dense|billion|million|cost|memory SCALE=0.1
	@$(need_rust)
	$(CARGO) run --locked --release -p carom --example gas_campaign -- $(or $(PART),all) $(or $(SCALE),1)

digests: ## Mint the golden digests of the scenarios anew: make digests REASON="..."
	@$(need_rust)
	CAROM_MINT_DIGESTS="$(REASON)" $(CARGO) test --locked --profile $(TEST_PROFILE) -p carom --test digests

checkpoint: ## Write the committed checkpoint anew, after a change of its format or of the physics: make checkpoint REASON="..."
	@$(need_rust)
	CAROM_MINT_CHECKPOINT="$(REASON)" $(CARGO) test --locked --profile $(TEST_PROFILE) -p carom --test observe -- golden_checkpoint

wheel: $(VENV)/.tools $(PACKAGED) ## Build a wheel and a source archive into dist/
	@$(need_rust)
	@# The archive leaves other members of the workspace out, so its Cargo.lock is longer than it need be: not --locked.
	rm -f dist/carom-*
	$(BIN)/maturin build --release --sdist --out dist

wheel-check: wheel ## Check both, and try them in fresh environments: make wheel-check PYTHONS="python3.10 ..."
	$(BIN)/python -m pip install --quiet --group dist
	$(BIN)/twine check --strict dist/carom-*
	$(BIN)/check-wheel-contents dist
	$(BIN)/python tests/packaging/contents.py dist
	PYTHONS="$(PYTHONS)" tests/packaging/check.sh dist

floors: wheel ## Run the package's tests with the oldest supported Python packages (FLOOR_PYTHON=python3.10)
	tests/packaging/floors.sh $(FLOOR_PYTHON) dist

clean: ## Remove everything that was built
	rm -rf target web/node_modules web/engine web/dist web/dist-player python/carom/studio/page $(VENV) $(POOLTOOL) out dist site docs/pictures docs/reference/api .pytest_cache .ruff_cache .mypy_cache .hypothesis
	rm -f python/carom/_engine*.so python/carom/studio/player.html
	find python tests -name __pycache__ -type d -prune -exec rm -rf {} +

FLOOR_PYTHON ?= python3.10

need_rust = command -v $(CARGO) >/dev/null \
	|| { echo "Carom's engine is built with Rust 1.89 or newer: https://rustup.rs says how to get it"; exit 1; }
need_python = $(PYTHON) -c 'import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 10))' 2>/dev/null \
	|| { echo "Carom needs Python 3.10 or newer with venv (on Debian: python3-venv); name one with make PYTHON=..."; exit 1; }

need_node = $(node_is_new) 2>/dev/null \
	|| { echo "The page is built with Node.js 20.19 or newer and its npm: https://nodejs.org says how to get it"; exit 1; }
need_wasm = rustc --print target-libdir --target wasm32-unknown-unknown 2>/dev/null | xargs ls >/dev/null 2>&1 \
	|| rustup target add wasm32-unknown-unknown \
	|| { echo "The page needs Rust's target wasm32-unknown-unknown: rustup target add wasm32-unknown-unknown"; exit 1; }
# The page is tested in Chromium. Only root, as in a container, gets it installed; others are told.
need_chromium = command -v chromium >/dev/null \
	|| { [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null \
		&& { apt-get update -qq; apt-get install -qq --no-install-recommends chromium >/dev/null; }; } \
	|| { echo "The page is tested in Chromium; on Debian: apt-get install chromium"; exit 1; }

# The MATLAB example is run by Octave. Only root, as in a container, gets it installed; others are told.
want_octave = command -v octave-cli >/dev/null \
	|| { [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null \
		&& { apt-get update -qq; apt-get install -qq --no-install-recommends octave >/dev/null; }; } \
	|| echo "Without Octave the MATLAB example is not tested; on Debian: apt-get install octave"

$(VENV)/.tools: pyproject.toml
	@$(need_python)
	@# An installation that was broken off is begun anew: pip takes what it left for whole.
	@if test -e $(VENV)/.unfinished; then rm -rf $(VENV); fi
	@mkdir -p $(VENV) && touch $(VENV)/.unfinished
	test -x $(BIN)/pip || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade 'pip>=25.1'
	$(BIN)/python -m pip install --quiet --group dev
	@rm $(VENV)/.unfinished
	@touch $@

$(VENV)/.built: $(VENV)/.tools $(RUST) Cargo.toml Cargo.lock $(SCENARIOS)
	@$(need_rust)
	VIRTUAL_ENV="$(CURDIR)/$(VENV)" $(BIN)/maturin develop --release --locked --extras all
	@touch $@

$(BUILT_PAGE): $(PAGE_ENGINE) web/node_modules/.package-lock.json $(PAGE) $(SCENARIOS) THIRD-PARTY.txt
	cd web && npm run --silent build

$(PACKAGED): $(BUILT_PAGE)
	rm -rf python/carom/studio/page
	mkdir python/carom/studio/page
	cp web/dist-player/player.html python/carom/studio/
	cp -r web/dist/assets web/dist/index.html python/carom/studio/page/

web/node_modules/.package-lock.json: web/package-lock.json
	@$(need_node)
	cd web && npm ci --silent
	@touch $@

$(PAGE_ENGINE): $(RUST) Cargo.toml Cargo.lock
	@$(need_rust)
	@$(need_wasm)
	$(CARGO) build --locked --profile page -p carom-wasm --target wasm32-unknown-unknown
	$(CARGO) run --locked --quiet -p carom-wasm --example bindgen -- target/wasm32-unknown-unknown/page/carom_wasm.wasm web/engine

# pooltool pins a panda3d that no registry has, so nothing here is resolved: the file names every package.
$(POOLTOOL)/.built: benches/pooltool/requirements.txt
	@$(need_python)
	rm -rf $(POOLTOOL)
	$(PYTHON) -m venv $(POOLTOOL)
	$(POOLTOOL)/bin/python -m pip install --quiet --no-deps --requirement $<
	@touch $@
