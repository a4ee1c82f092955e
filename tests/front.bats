# The front door: what stands at the top level, and `make setup` against stand-ins for dpkg-query, apt-get, sudo and id.
load helper

# stub NAME: an executable of that name, first in PATH, whose body is read from stdin.
stub() {
  { echo '#!/bin/sh'; cat; } >"$stubs/$1"
  chmod +x "$stubs/$1"
}

setup() {
  stubs=$BATS_TEST_TMPDIR/stubs
  make_path=$stubs:$PATH
  calls=$BATS_TEST_TMPDIR/calls
  export calls
  mkdir "$stubs"
  : >"$calls"
  stub apt-get <<<'echo "apt-get $*" >>"$calls"'
  stub sudo <<<'echo sudo >>"$calls"; exec "$@"'
  installed_are gcc make
  user_is 0
}

installed_are() { printf 'printf "installed %%s\\n" %s\n' "$*" | stub dpkg-query; }
user_is() { stub id <<<"echo $1"; }
without_sudo() {  # a PATH that holds the stand-ins and what make needs, but no sudo
  make_path=$stubs
  rm "$stubs/sudo"
  local program
  for program in bash sh make env sed nproc; do ln -s "$(command -v "$program")" "$stubs/$program"; done
}

run_make() { PATH=$make_path run make --no-print-directory -C "$TOP" PACKAGES="make gcc bats cmake" "$@"; }

@test "the top level holds what README names and nothing else" {
  run git -C "$TOP" ls-tree --name-only HEAD
  assert_success
  run grep -v '^\.' <<<"$output"
  assert_output "$(printf '%s\n' CMakeLists.txt LICENSE Makefile README.md bench data-schemas lib pipelines tests tools)"
}

@test "README shows every tool and names no file that is not there" {
  cd "$TOP"
  local tool file
  for tool in tools/*.cpp; do
    run grep -c "^| \`$(basename "$tool" .cpp)\` |" README.md
    assert_output 1
  done
  for file in $(grep -oE '(pipelines|data-schemas|tests|lib|tools)/[A-Za-z0-9_./-]*[A-Za-z0-9_/]' README.md | grep -v /out/ | sort -u); do
    assert_exists "$file"
  done
}

@test "links of every README lead to files" {
  cd "$TOP"
  local readme link
  for readme in README.md pipelines/*/README.md; do
    for link in $(grep -oE '\]\([^)]*\)' "$readme" | tr -d ']()' | sed 's/#.*//' | grep -v '^http'); do assert_exists "$(dirname "$readme")/$link"; done
  done
}

@test "the pipe in README runs as pasted" {
  cd "$BATS_TEST_TMPDIR"
  ln -s "$SLIDEZONE_BUILD" build
  ln -s "$TOP/pipelines" pipelines
  awk '/^```sh$/ { block = ""; is_in = 1; next } /^```$/ { is_in = 0; if (block ~ /rfgen/) printf "%s", block } is_in { block = block $0 "\n" }' \
    "$TOP/README.md" >pasted
  assert_file_contains pasted 'rfmap .* mpmrun .*; done . mcstats'
  run --separate-stderr bash -eu -o pipefail pasted
  assert_success
  assert_line --regexp '^runs.total.3.'
}

@test "an installation puts every tool and its man page below PREFIX" {
  local tool name
  run cmake --install "$SLIDEZONE_BUILD" --prefix "$BATS_TEST_TMPDIR/prefix"
  assert_success
  for tool in "$TOP"/tools/*.cpp; do
    name=$(basename "$tool" .cpp)
    run "$BATS_TEST_TMPDIR/prefix/bin/$name" --version
    assert_success
    run grep -c "^$name .*- " "$BATS_TEST_TMPDIR/prefix/share/man/man1/$name.1"
    assert_output 1
  done
}

@test "nothing missing: apt-get is not called" {
  installed_are make gcc bats cmake
  run_make setup
  assert_success
  assert_output ""
  assert_equal "$(<"$calls")" ""
}

@test "as root, exactly what is missing is installed after an update" {
  run_make setup
  assert_success
  assert_output --partial "bats cmake"
  run cat "$calls"
  assert_line --index 0 --regexp '^apt-get .*update$'
  assert_line --index 1 --regexp '^apt-get .*install .* bats cmake$'
  assert_equal "${#lines[@]}" 2
}

@test "a package that was removed but left its settings is missing" {
  stub dpkg-query <<<'printf "installed %s\n" make gcc bats; echo "config-files cmake"'
  run_make setup
  assert_success
  run tail -n 1 "$calls"
  assert_output --regexp 'install .* cmake$'
}

@test "as a user, the same through sudo" {
  user_is 1000
  run_make setup
  assert_success
  run cat "$calls"
  assert_line --index 0 sudo
  assert_line --index 3 --regexp '^apt-get .*install .* bats cmake$'
}

@test "as a user without sudo: a message that says what to do" {
  user_is 1000
  without_sudo
  run_make setup
  assert_failure
  assert_output --partial "neither root nor sudo"
  assert_output --partial "apt-get install --no-install-recommends bats cmake"
  assert_equal "$(<"$calls")" ""
}

@test "an installation that fails stops make and says what to do" {
  stub apt-get <<<'echo "E: no network" >&2; exit 100'
  run_make setup
  assert_failure
  assert_output --partial "E: no network"
  assert_output --partial "could not be installed; as root, run 'apt-get install"
}

@test "make alone installs nothing and points to make setup" {
  run_make BUILD="$BATS_TEST_TMPDIR/build"
  assert_failure
  assert_output --partial "not installed: bats cmake; 'make setup' installs them"
  assert_equal "$(<"$calls")" ""
  assert_not_exist "$BATS_TEST_TMPDIR/build"
}

@test "make demo takes the tools of the build folder that it is given" {
  PATH=$make_path run make --no-print-directory -C "$TOP" PACKAGES=make BUILD=elsewhere MAKE=echo --dry-run demo
  assert_success
  for pipeline in benchmark demo; do assert_line --regexp "^echo .*pipelines/$pipeline .* BUILD='$TOP/elsewhere'\$"; done
}
