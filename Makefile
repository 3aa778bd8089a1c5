# The everyday commands. `make help` lists them.

JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
SOAK_SCALE ?= 10000
FUZZ_SECONDS ?= 60

# Expanded when a recipe runs, that is, after ninja may have been installed.
export CMAKE_GENERATOR ?= $(if $(shell command -v ninja),Ninja,Unix Makefiles)

TAUTLINE = build/release/apps/cli/tautline
SOURCES = $(shell find tautline apps bench fuzz tests -name '*.h' -o -name '*.cc' 2>/dev/null)
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
	TAUTLINE_TEST_SCALE=$(SOAK_SCALE) ctest --preset release -R '^(homotopy|tether)/' --timeout 86400

.PHONY: asan tsan
asan: packages-test  ## run the tests under the address and undefined-behaviour sanitizers
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

.PHONY: tidy
tidy: packages-ci  ## run clang-tidy over all sources but the tests
	cmake --preset release
	run-clang-tidy-14 -quiet -j $(JOBS) -p build/release '/(tautline|apps)/(?!.*_test\.cc$$).*\.cc$$'

.PHONY: fuzz
fuzz: packages-ci  ## run each fuzz target for FUZZ_SECONDS
	cmake --preset fuzz
	$(BUILD) fuzz
	tools/run_fuzzers.sh build/fuzz/fuzz $(FUZZ_SECONDS)

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

.PHONY: clean
clean:  ## remove what the other commands made
	rm -rf build demo.svg demo.png

.PHONY: release-with-tests
release-with-tests: packages-test
	cmake --preset release
	$(BUILD) release

.PHONY: packages-demo packages-test packages-bench packages-ci
packages-demo packages-test packages-bench packages-ci: packages-%:
	@tools/install_packages.sh $*
