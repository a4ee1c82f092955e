# What every bats file of this folder loads: assertions of bats, the tools under test in PATH, numbers compared as numbers.
#
# Environment (set by ctest; the defaults serve `bats tests/mpmrun.bats` in a built checkout):
#   SLIDEZONE_BIN    folder of the tools' executables
#   SLIDEZONE_BUILD  the build folder
# TOP is the top level of the checkout.
bats_require_minimum_version 1.5.0
BATS_LIB_PATH=${BATS_LIB_PATH:-/usr/lib/bats}
bats_load_library bats-support
bats_load_library bats-assert
bats_load_library bats-file

TOP=$(cd "$BATS_TEST_DIRNAME/.." && pwd)
SLIDEZONE_BUILD=${SLIDEZONE_BUILD:-$TOP/build}
SLIDEZONE_BIN=${SLIDEZONE_BIN:-$SLIDEZONE_BUILD/bin}
PATH=$SLIDEZONE_BIN:$PATH
export LC_ALL=C NO_COLOR=1
unset MAKEFLAGS MFLAGS MAKELEVEL  # of a make that runs the tests: a make under test must not inherit them

# assert_finite VALUE: a finite decimal number. awk alone would take "nan", "inf" and "" for numbers.
assert_finite() {
  [[ $1 =~ ^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]{1,3})?$ ]] || fail "expected a finite number, found '$1'"
}

# assert_near VALUE EXPECTED TOLERANCE: |VALUE - EXPECTED| <= TOLERANCE (absolute).
assert_near() {
  local number
  for number in "$@"; do assert_finite "$number"; done
  awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(d <= t + 0) }' ||
    fail "expected $2 within $3, found $1"
}

# assert_between VALUE LOW HIGH: LOW <= VALUE <= HIGH.
assert_between() {
  local number
  for number in "$@"; do assert_finite "$number"; done
  awk -v a="$1" -v low="$2" -v high="$3" 'BEGIN { exit !(a + 0 >= low + 0 && a + 0 <= high + 0) }' ||
    fail "expected a number from $2 to $3, found $1"
}

# tsv_value COLUMN [ROW] <TABLE: the field of a row (counted from 1) below the named column.
tsv_value() {
  awk -F '\t' -v column="$1" -v wanted="${2:-1}" '
    /^#/ { next }
    !field { for (i = 1; i <= NF; ++i) if ($i == column) field = i; if (!field) exit; next }
    ++row == wanted { print $field; is_found = 1; exit }
    END { exit !is_found }' || fail "no row ${2:-1} with a column '$1'"
}

# check_help TOOL: what every tool says of itself, on stdout alone.
check_help() {
  run --separate-stderr "$1" --help
  assert_success
  assert_output --regexp "Example: ([a-z].* )?$1 "
  assert_output --partial "Exit codes:"
  refute_output --regexp $'\n  -[^\n ]*( [^\n ]+)* (Excludes|Needs): [^\n ]+ [A-Z]' # help2man wants two blanks before what an option does
  assert_equal "$stderr" ""
  run --separate-stderr "$1" --version
  assert_success
  assert_output --regexp "^$1 [0-9]+\.[0-9]+\.[0-9]+$"
  assert_equal "$stderr" ""
}

# assert_schema NAME FILE: FILE obeys data-schemas/NAME.json (or .schema.json, for a scene).
assert_schema() {
  local description=$TOP/data-schemas/$1.json
  [[ -e $description ]] || description=$TOP/data-schemas/$1.schema.json
  run /usr/bin/python3 "$TOP/tests/check_schema.py" "$description" "$2"
  assert_success
}
