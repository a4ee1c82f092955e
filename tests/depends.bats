# Who includes whom: lib/DEPENDS against the sources, and the checker against made-up trees with one fault each.
load helper

check() { run /usr/bin/python3 "$TOP/tests/check_depends.py" "$1"; }

# A tree of one module `low` and one module `high` that may include it.
setup() {
  tree=$BATS_TEST_TMPDIR/tree
  mkdir -p "$tree"/lib/{low,high} "$tree/tools"
  printf '%s\n' 'low:' 'high: low' 'tools: high' >"$tree/lib/DEPENDS"
  echo '#include <vector>' >"$tree/lib/low/a.hpp"
  echo '#include "low/a.hpp"' >"$tree/lib/high/b.cpp"
}

@test "the sources obey lib/DEPENDS" {
  check "$TOP"
  assert_success
  assert_output ""
}

@test "a sound tree passes" {
  check "$tree"
  assert_success
}

@test "an include against the order is a fault with its place" {
  echo '#include "high/c.hpp"' >>"$tree/lib/low/a.hpp"
  touch "$tree/lib/high/c.hpp"
  check "$tree"
  assert_failure 1
  assert_output --partial "lib/low/a.hpp:2: low may not include \"high/c.hpp\""
}

@test "a tool may include only what its line names" {
  echo '#include "low/a.hpp"' >"$tree/tools/tool.cpp"
  check "$tree"
  assert_failure 1
  assert_output --partial "tools may not include \"low/a.hpp\""
}

@test "an include not written from lib/ is a fault" {
  echo '#include "low/b.hpp"' >>"$tree/lib/low/a.hpp"
  check "$tree"
  assert_failure 1
  assert_output --partial "is not a file of lib/"
}

@test "a module without a line is a fault" {
  mkdir "$tree/lib/new" && touch "$tree/lib/new/a.cpp"
  check "$tree"
  assert_failure 1
  assert_output --partial "module 'new' is not in lib/DEPENDS"
}

@test "a cycle in lib/DEPENDS is a fault" {
  sed -i 's/^low:/low: high/' "$tree/lib/DEPENDS"
  check "$tree"
  assert_failure 1
  assert_output --partial "low names high, which does not stand above it"
}

@test "CLI11 stays out of the modules" {
  echo '#include <CLI/CLI.hpp>' | tee -a "$tree/lib/low/a.hpp" >"$tree/tools/tool.cpp"
  check "$tree"
  assert_failure 1
  assert_line --partial "lib/low/a.hpp:2: only tools/"
  refute_output --partial "tools/tool.cpp"
}

@test "a tree without sources is a fault, not a pass" {
  rm "$tree"/lib/*/*.?pp
  check "$tree"
  assert_failure 1
}

@test "code for one instruction set shares no function with that for another" {
  # A function that two of them define would be linked once, perhaps the one that this processor cannot run.
  mapfile -t objects < <(find "$SLIDEZONE_BUILD" -path '*sweeps_*' -name '*.o')
  assert_equal "${#objects[@]}" 7
  run nm --defined-only "${objects[@]}"
  assert_success
  refute_line --regexp ' [WVu] '
}
