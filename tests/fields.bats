# pipelines/fields: the gallery of models, each held against theory.
load helper

@test "every model is drawn and agrees with theory; the pictures are there" {
  run make -C "$TOP/pipelines/fields" OUT="$BATS_TEST_TMPDIR/out" TOOLS="$SLIDEZONE_BIN" --no-print-directory
  assert_success
  assert_equal "$(grep -c ' all [0-9]* rows agree$' <<<"$output")" "$(find "$TOP/pipelines/fields/variants" -name '*.sed' | wc -l)"
  local picture
  for picture in gallery check; do
    assert_equal "$(head -c 4 "$BATS_TEST_TMPDIR/out/$picture.png" | tail -c 3)" PNG
    assert_file_contains "$BATS_TEST_TMPDIR/out/$picture.svg" '</svg>'
  done
  assert_schema field-check "$BATS_TEST_TMPDIR/out/16-correlated.tsv"
}

@test "a model that disagrees fails the target" {
  cp -r "$TOP/pipelines/"{fields,plots,rules.mk} "$BATS_TEST_TMPDIR"
  cd "$BATS_TEST_TMPDIR/fields"
  rm -rf out variants/0[2-9]* variants/1*
  printf '# Cut off\n%s\n' 's/^cell = "0.1 m"/&\nmethod = "Karhunen-Loeve"\nvariance_kept = 0.5/' >variants/02-cut-off.sed
  run make TOOLS="$SLIDEZONE_BIN" --no-print-directory
  assert_failure 2
  assert_output --regexp '02-cut-off +[0-9]+ of 19 rows disagree'
}

@test "the fields of any scene are held against theory and drawn" {
  cd "$BATS_TEST_TMPDIR"
  run make -C "$TOP/pipelines/fields" SCENE="$TOP/tests/scenes/varied.toml" N=100 OUT="$PWD/out" TOOLS="$SLIDEZONE_BIN" --no-print-directory
  assert_success
  assert_output --regexp '^all [0-9]+ rows agree$'
  assert_schema field-check out/varied/check.tsv
  assert_equal "$(head -c 4 out/varied/check.png | tail -c 3)" PNG
  # A panel of correlations and one of values for each of the eight fields, and one of cross-correlations.
  assert_equal "$(grep -c '>cohesion.clay: ' out/varied/check.svg)" 2
  assert_equal "$(grep -o '>[a-z_.]*: correlation of the Gaussian field<' out/varied/check.svg | sort -u | wc -l)" 8
  assert_file_contains out/varied/check.svg '>Cross-correlations of the Gaussian fields<'
}

@test "a scene whose fields disagree fails the target" {
  cd "$BATS_TEST_TMPDIR"
  sed 's/^autocorrelation = .*/method = "Karhunen-Loeve"\nvariance_kept = 0.5/' "$TOP/pipelines/demo/scene.toml" >cut.toml
  run make -C "$TOP/pipelines/fields" SCENE="$PWD/cut.toml" N=100 OUT="$PWD/out" TOOLS="$SLIDEZONE_BIN" --no-print-directory
  assert_failure 2
  assert_output --regexp '[0-9]+ of 18 rows disagree'
}
