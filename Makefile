# slidezone: `make` builds, `make demo` shows, `make check` tests. Both of the latter install what is missing first.
#
#   make                       build everything: the tools into build/bin, their man pages, the tests
#   make tools                 build the tools alone
#   make setup                 install the Debian packages that are missing, as root or through sudo
#   make demo                  set up, build, run the benchmark and a small study, draw the pictures
#   make check                 set up, build, run all tests but the slow ones
#   make check-slow            set up, build, run the slow tests
#   make bench                 set up, build, print what a run costs: by instruction set, size and feature; starts, fields
#   make install PREFIX=DIR    build and install tools and man pages (default /usr/local; DESTDIR is honoured)
#   make clean                 remove what was built and what the demo made
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.NOTPARALLEL:
MAKEFLAGS += --no-builtin-rules --warn-undefined-variables

BUILD := build
PREFIX := /usr/local
DESTDIR :=
JOBS := $(shell nproc)

# What building, testing and the demo need, and what the slow tests and the benchmarks need on top.
PACKAGES := g++ cmake make pkg-config libeigen3-dev libfftw3-dev libgsl-dev libhdf5-dev libcli11-dev libtomlplusplus-dev libudunits2-dev \
            librandom123-dev libxxhash-dev libgtest-dev bats bats-assert bats-support bats-file python3-jsonschema hdf5-tools \
            gnuplot-nox bsdextrautils help2man
PACKAGES_SLOW := time python3-vtk9 r-base-core r-cran-nortest r-cran-boot pandoc chromium poppler-utils r-cran-gstat

PACKAGES_BENCH := libbenchmark-dev

.PHONY: all tools setup demo check check-slow bench install clean

# CMake's own makefiles are not clean under our flags.
cmake := env -u MAKEFLAGS -u MAKELEVEL cmake

all: $(BUILD)/CMakeCache.txt
	$(cmake) --build $(BUILD) --parallel $(JOBS)

tools: $(BUILD)/CMakeCache.txt
	$(cmake) --build $(BUILD) --parallel $(JOBS) --target tools

$(BUILD)/CMakeCache.txt: CMakeLists.txt
	$(if $(missing),$(error not installed: $(missing); 'make setup' installs them))
	$(cmake) -S . -B $(BUILD) -DCMAKE_INSTALL_PREFIX=$(PREFIX)

# ---- setup --------------------------------------------------------------------------------------------------------------

packages = $(PACKAGES)
check-slow: packages = $(PACKAGES) $(PACKAGES_SLOW)
bench: packages = $(PACKAGES) $(PACKAGES_BENCH)

# Missing packages; none where there is no dpkg to ask, for then CMake will tell.
installed = $(shell dpkg-query --show --showformat '$${db:Status-Status} $${Package}\n' 2>/dev/null | sed -n 's/^installed //p')
missing = $(if $(shell command -v dpkg-query),$(filter-out $(installed),$(packages)))

is_root = $(filter 0,$(shell id -u))
sudo = $(if $(is_root),,$(shell command -v sudo))
apt_get = $(sudo) env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Acquire::Retries=3
by_hand = apt-get install --no-install-recommends $(missing)

setup:
	$(if $(missing),$(install_missing),@:)

define install_missing
@$(if $(or $(is_root),$(sudo)),,$(error not installed: $(missing); neither root nor sudo is at hand: as root, run '$(by_hand)'))\
echo "Installing $(words $(missing)) Debian packages and what they need: $(missing)"
@{ $(apt_get) update && $(apt_get) install --yes --no-install-recommends $(missing) >/dev/null; } || \
  { echo "These packages could not be installed; as root, run '$(by_hand)'" >&2; exit 1; }
endef

# ---- the main jobs ------------------------------------------------------------------------------------------------------

with_build = BUILD='$(abspath $(BUILD))'

demo: setup tools
	@echo "Failing the benchmark slope once, at full resolution"
	@$(MAKE) --no-print-directory --directory pipelines/benchmark --jobs=$(JOBS) $(with_build)
	@echo && echo "Failing a small one 24 times, with random strength"
	@$(MAKE) --no-print-directory --directory pipelines/demo --jobs=$(JOBS) $(with_build)

check: setup all
	ctest --test-dir $(BUILD) --output-on-failure --no-tests=error --parallel $(JOBS) --label-exclude slow

check-slow: setup all
	ctest --test-dir $(BUILD) --output-on-failure --no-tests=error --parallel $(JOBS) --label-regex slow

# CMake looks for the benchmark library anew: it may just have been installed.
bench: setup tools
	$(cmake) -S . -B $(BUILD) >/dev/null
	$(cmake) --build $(BUILD) --parallel $(JOBS) --target bench_kernel
	$(BUILD)/bench/kernel pipelines/benchmark/scene.toml
	bench/tools $(BUILD)/bin

install: all
	$(cmake) --install $(BUILD) --prefix $(PREFIX)

clean:
	rm -rf $(BUILD) pipelines/*/out
