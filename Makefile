# The everyday commands. `make help` lists them.

JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
SOAK_SCALE ?= 10000
FUZZ_SECONDS ?= 600
FUZZ_JOBS ?= 2

# Expanded when a recipe runs, that is, after ninja may have been installed.
export CMAKE_GENERATOR ?= $(if $(shell command -v ninja),Ninja,Unix Makefiles)

TAUTLINE = build/release/apps/cli/tautline
WASM = build/wasm/apps/wasm/tautline.js
SOURCES = $(shell find tautline apps bench docs examples fuzz tests -name '*.h' -o -name '*.cc' 2>/dev/null)
BUILD = cmake --build --parallel $(JOBS) --preset

.PHONY: help
help:  ## list the commands
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' Makefile | expand -t 14

.PHONY: demo
demo: packages-demo  ## build the program, plan on a real map, draw demo.svg and demo.png
	cmake --preset release -DTAUTLINE_BUILD_TESTS=OFF
	$(BUILD) release --target tautline_cli
	$(TAUTLINE) plan scenes/willow_demo.yaml --svg demo.svg --png demo.png --verify

.PHONY: test
test: release-with-tests  ## build everything and run all tests
	ctest --preset release

.PHONY: soak
soak: release-with-tests  ## the random tests of engine and planner, SOAK_SCALE percent as long: 100,000 scenes
	TAUTLINE_TEST_SCALE=$(SOAK_SCALE) ctest --preset release -R '^(scene|homotopy|cable|tether)/' --timeout 86400

.PHONY: wasm
wasm: packages-wasm  ## compile the core for browsers, compare it with the program on every scene
	cmake --preset release
	$(BUILD) release --target tautline_cli
	cmake --preset wasm
	$(BUILD) wasm
	python3 -B tests/run_wasm.py $(TAUTLINE) $(WASM)
	python3 -B tests/run_wasm_page.py $(WASM)

.PHONY: asan tsan
asan: packages-ci  ## run the tests under the address and undefined-behaviour sanitizers
tsan: packages-test  ## run the tests under the thread sanitizer
asan tsan:
	cmake --preset $@
	$(BUILD) $@
	ctest --preset $@

.PHONY: format format-check
format: packages-ci  ## format all sources
	@clang-format-14 -i $(SOURCES)
format-check: packages-ci  ## fail if a source is not formatted
	@clang-format-14 --dry-run --Werror $(SOURCES)

# Every check costs 3 % of a run, since clang-tidy matches it against all headers of the system.
comma := ,
empty :=
QUICK_CHECKS = $(subst $(empty) ,$(comma),$(strip -* \
  bugprone-narrowing-conversions bugprone-use-after-move misc-unused-parameters misc-unused-using-decls \
  modernize-use-emplace performance-for-range-copy performance-inefficient-vector-operation \
  performance-no-automatic-move performance-unnecessary-copy-initialization performance-unnecessary-value-param \
  readability-function-size readability-identifier-naming readability-inconsistent-declaration-parameter-name \
  readability-redundant-member-init readability-redundant-string-init))

.PHONY: tidy tidy-deep
tidy: packages-ci  ## run clang-tidy over all sources but the tests, with the checks that have found something
tidy: TIDY_CHECKS = '-checks=$(QUICK_CHECKS)'
tidy-deep: packages-ci  ## the same with all checks of .clang-tidy, which takes three times as long
tidy tidy-deep:
	cmake --preset release
	run-clang-tidy-14 -quiet -j $(JOBS) -p build/release $(TIDY_CHECKS) '^$(CURDIR)/(tautline|apps|docs|examples)/(?!.*_test\.cc$$).*\.cc$$'

.PHONY: fuzz
fuzz: packages-ci  ## run each fuzz target for FUZZ_SECONDS, FUZZ_JOBS at a time
	cmake --preset asan
	$(BUILD) asan --target fuzzers
	tools/run_fuzzers.sh build/asan/fuzz $(FUZZ_SECONDS) $(FUZZ_JOBS)

.PHONY: bench
bench: packages-bench  ## run the benchmarks (FILTER=REGEX: some of them) and write docs/performance.md
	cmake --preset release -DTAUTLINE_BUILD_BENCH=ON
	$(BUILD) release --target bench
	bench/run.sh build/release '$(FILTER)'

.PHONY: install
install: packages-demo  ## install the program and the library to PREFIX
	cmake --preset release -DTAUTLINE_BUILD_TESTS=OFF
	$(BUILD) release
	cmake --install build/release --prefix $(PREFIX)

.PHONY: deb
deb: packages-package  ## build the Debian packages tautline, libtautline-env1 and libtautline-dev in build/deb, and lint them
	tools/build_deb.sh build/deb $(JOBS)

.PHONY: api
api: packages-ci  ## write the reference of the headers to build/api/html; a declaration without a comment is an error
	cmake --preset release
	mkdir -p build/api
	doxygen build/release/Doxyfile

.PHONY: clean
clean:  ## remove what the other commands made
	rm -rf build demo.svg demo.png

.PHONY: release-with-tests
release-with-tests: packages-test
	cmake --preset release
	$(BUILD) release

.PHONY: packages-demo packages-test packages-bench packages-ci packages-package packages-wasm
packages-demo packages-test packages-bench packages-ci packages-package packages-wasm: packages-%:
	@tools/install_packages.sh $*
