# pipelines/accuracy: the quick form makes whole tables, and errors fall with what should make them fall.
load helper

setup_file() {
  export OUT=$BATS_FILE_TMPDIR/out
  make --no-print-directory -C "$TOP/pipelines/accuracy" quick OUT="$OUT" BUILD="$SLIDEZONE_BUILD" >"$BATS_FILE_TMPDIR/log"
}

# value TABLE COLUMN CONDITION ...: the value of the only row whose columns are as the conditions COLUMN=VALUE say.
value() {
  local table=$OUT/quick/$1.tsv column=$2
  shift 2
  python3 - "$table" "$column" "$@" <<'END'
import csv, sys
table, column, *conditions = sys.argv[1:]
wanted = dict(condition.split("=") for condition in conditions)
rows = [row for row in csv.DictReader(open(table), delimiter="\t") if wanted.items() <= row.items()]
assert len(rows) == 1, f"{len(rows)} rows with {wanted}"
print(rows[0][column])
END
}

# assert_less A B: both are finite, and A < B.
assert_less() {
  assert_finite "$1"
  assert_finite "$2"
  awk -v a="$1" -v b="$2" 'BEGIN { exit !(a + 0 < b + 0) }' || fail "expected $1 to be less than $2"
}

@test "every row has every column, and every table a picture" {
  for table in realization field study two_level study_precision; do
    run awk -F '\t' 'NR == 1 { columns = NF } NF != columns || /\t\t|^\t|\t$/ { print FILENAME ": " $0 } END { exit NR < 3 }' "$OUT/quick/$table.tsv"
    assert_success
    refute_output
  done
  for picture in realization field study; do
    for format in png svg; do assert_file_not_empty "$OUT/quick/accuracy_$picture.$format"; done
  done
}

@test "one realization: smaller cells bring the surface nearer to the finest, and cost more" {
  assert_less "$(value realization surface_error_percent series=cell cell_m=0.2)" "$(value realization surface_error_percent series=cell cell_m=0.4)"
  assert_less "$(value realization time_s series=cell cell_m=0.4)" "$(value realization time_s series=cell cell_m=0.2)"
}

@test "one realization: single precision is as near to the finest as double" {
  for error in influence_error_percent runout_error_percent surface_error_percent energy_error_percent; do
    # A run of 15 s moved R by 0.03 % at most; the table has a digit or two after the point.
    assert_near "$(value realization $error series=precision precision=single)" "$(value realization $error series=precision precision=double)" 0.11
  done
}

@test "fields: the covariance gets better with the mesh; Cholesky's field is the separable one, for more time and memory" {
  assert_less "$(value field error method=separable cell_m=0.25)" "$(value field error method=separable cell_m=0.5)"
  # One field of the same normals, up to rounding; the table has four digits.
  assert_near "$(value field error method=Cholesky cell_m=0.25)" "$(value field error method=separable cell_m=0.25)" 1.1e-4
  for cost in time_s memory_mib; do
    assert_less "$(value field $cost method=separable cell_m=0.25)" "$(value field $cost method=Cholesky cell_m=0.25)"
  done
}

@test "studies: more runs bring less error, and a coarse run costs less than a fine one" {
  for quantity in influence_m runout_m; do
    for statistic in mean sd; do
      assert_less "$(value study error_1000_percent cell_m=0.2 quantity=$quantity statistic=$statistic)" \
        "$(value study error_100_percent cell_m=0.2 quantity=$quantity statistic=$statistic)"
    done
    assert_between "$(value two_level correlation quantity=$quantity statistic=mean)" -1 1
    assert_less "$(value two_level cost_ratio quantity=$quantity statistic=mean)" 1
  done
}

@test "studies: single precision changes no statistic by a tenth of the standard error of the mean" {
  for quantity in influence_m runout_m; do
    error=$(value study_precision standard_error_of_mean_m quantity=$quantity)
    assert_finite "$error"
    for statistic in mean sd 10_percent 1_percent; do
      assert_near "$(value study_precision ${statistic}_difference_m quantity=$quantity)" 0 "$(awk -v e="$error" 'BEGIN { print e / 10 }')"
    done
  done
}
