# tests/check_schema.py itself: sound files pass, and each kind of fault is found. Real files are held by the tools' own tests.
load helper

check() { run /usr/bin/python3 "$TOP/tests/check_schema.py" "$BATS_TEST_TMPDIR/description.json" "$BATS_TEST_TMPDIR/file"; }

describe() { cat >"$BATS_TEST_TMPDIR/description.json"; }

describe_tsv() {
  describe <<'END'
{"schema": "slidezone-example 1", "kind": "tsv", "meaning": "an example", "columns": [
  {"name": "run", "type": "whole", "meaning": "its number"},
  {"name": "status", "type": "choice", "choices": ["slid", "stable"], "meaning": "how it ended"},
  {"name": "reach_m", "type": "real", "unit": "m", "missing": "nan", "meaning": "how far"}]}
END
}

# table LINE ...: a table with provenance and header, then the lines, in which blanks stand for tabs.
table() {
  { printf '# schema: slidezone-example 1\n# tool: example 0.1.0\n'; printf '%s\n' 'run status reach_m' "$@" | tr ' ' '\t'; } \
    >"$BATS_TEST_TMPDIR/file"
}

@test "TSV: a sound table passes, also concatenated" {
  describe_tsv
  table '1 slid 0.5' '2 stable nan'
  cat "$BATS_TEST_TMPDIR/file" "$BATS_TEST_TMPDIR/file" >"$BATS_TEST_TMPDIR/twice"
  mv "$BATS_TEST_TMPDIR/twice" "$BATS_TEST_TMPDIR/file"
  check
  assert_success
  assert_output ""
}

@test "TSV: wrong fields are faults with their line" {
  describe_tsv
  local row
  for row in '-1 slid 0.5' '01 slid 0.5' '1 gone 0.5' '1 slid inf' '1 slid 1e999' '1 slid nan ' '1 slid' '1 slid unbounded'; do
    table '1 slid 2' "$row"
    check
    assert_failure 1
    assert_output --partial "file:5: "
  done
}

@test "TSV: another schema, no provenance, another order of columns are faults" {
  describe_tsv
  table '1 slid 2'
  sed -i 's/example 1/example 2/' "$BATS_TEST_TMPDIR/file"
  check
  assert_failure 1
  printf 'run\tstatus\treach_m\n' >"$BATS_TEST_TMPDIR/file"
  check
  assert_failure 1
  table '1 slid 2'
  sed -i 's/^run\tstatus/status\trun/' "$BATS_TEST_TMPDIR/file"
  check
  assert_failure 1
  assert_output --partial "expected ['run', 'status', 'reach_m']"
}

@test "a description with a misspelt key is refused" {
  describe <<<'{"schema": "x 1", "kind": "tsv", "colums": []}'
  : >"$BATS_TEST_TMPDIR/file"
  check
  assert_failure 2
}

@test "every schema that the sources name has a description, in a file of its name" {
  local schema
  while read -r schema; do
    run grep -l "\"schema\": \"$schema\"" "$TOP"/data-schemas/*.json
    assert_output "$TOP/data-schemas/$(sed 's/^slidezone-//; s/ .*//' <<<"$schema").json"
  done < <(grep -rhoE '"slidezone-[a-z-]+ [0-9]+"' "$TOP/lib" "$TOP/tools" | tr -d '"' | sort -u)
}

describe_toml() {
  describe <<'END'
{"$schema": "https://json-schema.org/draft/2020-12/schema", "type": "object", "additionalProperties": false,
 "properties": {"height": {"type": "string"}}}
END
}

@test "TOML: a JSON Schema decides" {
  describe_toml
  echo 'height = "5 m"' >"$BATS_TEST_TMPDIR/file"
  check
  assert_success
  echo 'heigth = "5 m"' >"$BATS_TEST_TMPDIR/file"
  check
  assert_failure 1
  assert_output --partial "heigth"
}

# fields: one real file of rfgen, then the description of it with a change.
fields() {
  rfgen "$TOP/pipelines/demo/scene.toml" -n 2 -o "$BATS_TEST_TMPDIR/file"
  cp "$TOP/data-schemas/fields.json" "$BATS_TEST_TMPDIR/description.json"
}

@test "HDF5: a file of rfgen obeys its description" {
  fields
  check
  assert_success
  assert_output ""
}

@test "HDF5: another type, shape, name or schema is a fault" {
  fields
  local change
  for change in 's|"path": "/realization", "type": "whole"|"path": "/realization", "type": "real"|' \
    's|"own cells_y", |"samples", |' 's|"path": "/floored"|"path": "/flored"|' 's|slidezone-fields 1|slidezone-fields 2|'; do
    sed "$change" "$TOP/data-schemas/fields.json" >"$BATS_TEST_TMPDIR/description.json"
    run ! cmp -s "$TOP/data-schemas/fields.json" "$BATS_TEST_TMPDIR/description.json"
    check
    assert_failure 1
  done
}

@test "HDF5: what is not HDF5 is a fault" {
  fields
  echo text >"$BATS_TEST_TMPDIR/file"
  check
  assert_failure 1
  assert_output --partial "h5dump cannot read it"
}
