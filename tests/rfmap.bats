# rfmap: random field samples at material points.
load helper
load fields

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  rfgen "$TOP/pipelines/demo/scene.toml" -n 2 -o fields.h5
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  scene=$TOP/pipelines/demo/scene.toml
  fields=$BATS_FILE_TMPDIR/fields.h5
}

# ---- contract ----

@test "--help and --version go to stdout" { check_help rfmap; }

@test "wrong command lines exit 64" {
  for arguments in "" "$scene" "$scene $fields --outptu x"; do
    # shellcheck disable=SC2086
    run rfmap $arguments
    assert_failure 64
    assert_output --regexp '^rfmap: '
  done
}

@test "missing inputs exit 66" {
  run rfmap missing.toml "$fields"
  assert_failure 66
  run rfmap "$scene" missing.h5
  assert_failure 66
  assert_output --partial "rfmap: missing.h5: "
}

@test "a broken scene or fields file exits 65, names it, and leaves nothing" {
  sed 's/^cov = .*/cov = -1/' "$scene" >broken.toml
  run rfmap broken.toml "$fields" -o points.h5
  assert_failure 65
  assert_output --regexp "^rfmap: broken.toml:[0-9]+:7: 'cov' wants"
  head -c 50000 "$fields" >short.h5
  : >empty.h5
  for file in short.h5 empty.h5 "$scene"; do
    run rfmap "$scene" "$file" -o points.h5
    assert_failure 65
    assert_output --partial "rfmap: $file: "
  done
  assert_not_exist points.h5
}

@test "a points file is no fields file" {
  rfmap "$scene" "$fields" -o points.h5
  run rfmap "$scene" points.h5 -o other.h5
  assert_failure 65
  assert_output "rfmap: points.h5: found schema 'slidezone-points 1', expected 'slidezone-fields 1'"
}

@test "fields of another mesh are refused, and both are named" {
  sed 's/^cell = "0.1 m"/cell = "0.2 m"/' "$scene" >coarse.toml
  run rfmap coarse.toml "$fields" -o points.h5
  assert_failure 65
  assert_output --partial "$fields: found a field of 250 x 50 cells of 0.1 m x 0.1 m, but coarse.toml describes one of 125 x 25 cells of 0.2 m x 0.2 m"
  assert_not_exist points.h5
}

@test "an output that cannot be created exits 73; a full disk 74; nothing is left" {
  run rfmap "$scene" "$fields" -o missing/points.h5
  assert_failure 73
  run rfmap "$scene" "$fields" -o /dev/full
  assert_failure 74
  run bash -c "rfmap '$scene' '$fields' >/dev/full"
  assert_failure 74
  assert_equal "$(ls)" ""
}

@test "a terminal is refused with 64" {
  run script --quiet --return --command "rfmap '$scene' '$fields'" /dev/null
  assert_failure 64
  assert_output --partial "stdout is a terminal"
}

@test "equal inputs give equal bytes, through a pipe or a file" {
  rfmap "$scene" "$fields" -o a.h5
  rfmap "$scene" "$fields" -o b.h5
  rfgen "$scene" -n 2 | rfmap "$scene" - >c.h5
  cmp a.h5 b.h5
  cmp a.h5 c.h5
}

@test "the file obeys its description" {
  rfmap "$scene" "$fields" -o a.h5
  assert_schema points a.h5
}

@test "memory does not grow with the number of samples" {
  rfgen "$scene" -n 1000 -o many.h5
  run bash -c "ulimit -d 40000; rfmap '$scene' many.h5 >/dev/null" # 100 MB of numbers, 40 MB of data
  assert_success
}

# ---- mapping ----

@test "each point takes the value of the cell that contains it" {
  rfmap "$scene" "$fields" -o points.h5
  h5_numbers "$fields" /cohesion -s 1,0,0 -c 1,50,250 >field
  paste <(h5_numbers points.h5 /x) <(h5_numbers points.h5 /y) <(h5_numbers points.h5 /cohesion -s 1,0 -c 1,2800) >points
  run awk 'NR == FNR { field[NR - 1] = $1; next }
    { cell = int($2 / 0.1) * 250 + int($1 / 0.1); if ($3 != field[cell]) ++wrong; ++points }
    END { print points, wrong + 0 }' field points
  assert_output "$(h5_numbers points.h5 /x | wc -l) 0"
}

@test "with linear interpolation a point takes a value between the centres of cells" {
  # Points every 0.2 m, at 0.1 m and so on: on corners of cells of 0.1 m, each the mean of four cells.
  sed 's/^cell = "0.1 m"/&\ninterpolation = "linear"/' "$scene" >linear.toml
  rfmap linear.toml "$fields" -o points.h5
  h5_numbers "$fields" /cohesion -s 1,0,0 -c 1,50,250 >field
  paste <(h5_numbers points.h5 /x) <(h5_numbers points.h5 /y) <(h5_numbers points.h5 /cohesion -s 1,0 -c 1,2800) >points
  run awk 'NR == FNR { field[NR - 1] = $1; next }
    { cell = int($2 / 0.1 - 0.5) * 250 + int($1 / 0.1 - 0.5)
      mean = (field[cell] + field[cell + 1] + field[cell + 250] + field[cell + 251]) / 4
      if ($3 - mean > 1e-6 || mean - $3 > 1e-6) ++wrong; ++points }
    END { print points, wrong + 0 }' field points
  assert_output "2800 0"
}

@test "cells longer than half a scale of fluctuation get a warning" {
  run --separate-stderr bash -c "rfmap '$scene' '$fields' | cksum"
  assert_equal "$stderr" ""
  sed 's/^cell = "0.1 m"/cell = ["0.1 m", "0.6 m"]/' "$scene" >coarse.toml
  rfgen coarse.toml -n 1 -o coarse.h5
  run rfmap coarse.toml coarse.h5 -o points.h5
  assert_success
  assert_output --partial "rfmap: warning: the cells of the field cohesion, 0.1 m x 0.6 m, are longer than half its scales of fluctuation, 1 m and 1 m"
  assert_schema points points.h5
}

@test "with bedding it is the scales along x and y that cells are held against" {
  # Upright bedding: 0.5 m along x and 8 m along y.
  sed 's/^horizontal_scale = .*/horizontal_scale = "8 m"\nbedding_angle = "90 deg"/; s/^vertical_scale = .*/vertical_scale = "0.5 m"/; s/^cell = "0.1 m"/cell = ["0.5 m", "1 m"]/' "$scene" >upright.toml
  rfgen upright.toml -n 1 -o upright.h5
  run rfmap upright.toml upright.h5 -o points.h5
  assert_success
  assert_output --partial "rfmap: warning: the cells of the field cohesion, 0.5 m x 1 m, are longer than half its scales of fluctuation, 0.5 m and 8 m along x and y"
  sed 's/^cell = \["0.5 m", "1 m"\]/cell = ["0.25 m", "1 m"]/' upright.toml >fine.toml
  rfgen fine.toml -n 1 -o fine.h5
  run rfmap fine.toml fine.h5 -o points.h5
  assert_success
  refute_output --partial "warning"
}

@test "fields of another scene of the same mesh are taken, with a note" {
  sed 's/^end = .*/end = "14 s"/' "$scene" >changed.toml
  run rfmap changed.toml "$fields" -o points.h5
  assert_success
  assert_output --regexp '^rfmap: note: .*fields.h5 was made from another scene than changed.toml, or before it was changed$'
  run mpmrun changed.toml --points points.h5 --explain # the fields are no fresher for having been mapped by this scene
  assert_line 'mpmrun: note: points.h5 was made from another scene than changed.toml, or before it was changed'
  run rfmap "$scene" "$fields" -o points.h5
  assert_output ""
  run mpmrun changed.toml --points points.h5 --explain
  assert_line 'mpmrun: note: points.h5 was made from another scene than changed.toml, or before it was changed'
}

@test "points stand at the residual strength of their own soil, and are counted" {
  two_soils >layers.toml
  rfgen layers.toml -n 1 | rfmap layers.toml - -o points.h5
  paste <(h5_numbers points.h5 /y) <(h5_numbers points.h5 /cohesion) |
    awk '$1 > 2 { if ($2 < 18000) ++below; floored += $2 == 18000 }
      $1 < 2 { if ($2 < 12000) ++below; floored += $2 == 12000 }
      END { print below + 0, floored }' >counts
  read -r below floored <counts
  assert_equal "$below" 0
  assert_between "$floored" 100 3000
  assert_equal "$(h5_numbers points.h5 /floored)" "$floored"
}

@test "all fields are mapped at once, each to the points whose soil has it" {
  local varied=$TOP/tests/scenes/varied.toml
  sed 's/^mean = "2 kPa"/mean = "5 kPa"/' "$varied" >wide.toml # the residual cohesion, so that some exceed the peak
  rfgen wide.toml -o fields.h5
  rfmap wide.toml fields.h5 -o points.h5
  assert_schema points points.h5
  assert_equal "$(h5ls points.h5 | awk '{ print $1 }' | tr '\n' ' ')" "block cohesion floored friction_angle realization residual_cohesion unit_weight x y youngs_modulus "
  h5_numbers fields.h5 /cohesion -s 0,0,0 -c 1,8,24 >of_fill
  h5_numbers fields.h5 /cohesion.clay -s 0,0,0 -c 1,8,24 >of_clay
  paste <(h5_numbers points.h5 /x) <(h5_numbers points.h5 /y) <(h5_numbers points.h5 /cohesion -s 0,0 -c 1,156) \
    <(h5_numbers points.h5 /residual_cohesion -s 0,0 -c 1,156) >points
  run awk 'FILENAME == "of_fill" { fill[n++] = $1; next } FILENAME == "of_clay" { clay[m++] = $1; next }
    { cell = int($2 / 0.25) * 24 + int($1 / 0.25); is_fill = $2 > 1; ++soil[is_fill]
      if ($3 != (is_fill ? fill[cell] : clay[cell])) ++wrong
      if (is_fill ? $4 != $3 : $4 > $3) ++wrong # the fill has no residual cohesion in the scene: it follows the peak
      floored += !is_fill && $4 == $3 }
    END { print soil[0], soil[1], wrong + 0, floored }' of_fill of_clay points
  assert_output --regexp '^[0-9]+ [0-9]+ 0 [1-9][0-9]*$'
  assert_between "$(h5_numbers points.h5 /floored -s 0 -c 1)" "$(cut -d' ' -f4 <<<"$output")" 156
}
