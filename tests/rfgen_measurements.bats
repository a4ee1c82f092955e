# rfgen: samples that honour measurements.
load helper
load fields

@test "samples honour the measurements that the scene names" {
  mkdir scene
  sed 's/^cell = "0.1 m"/&\nmeasurements = "borings.tsv"/' "$scene" >scene/scene.toml
  printf '%s\t%s\t%s\t%s\n' x_m depth_m value_kPa error_kPa 5.05 0.55 31.5 0 5.05 2.05 12.25 0 22.05 1 18 2 >scene/borings.tsv
  assert_schema measurements scene/borings.tsv
  rfgen scene/scene.toml -n 3 -o fields.h5
  assert_schema fields fields.h5
  local index
  for index in 0 1 2; do # cells: x 5.05 m is column 50; 5 m - 0.55 m = 4.45 m is row 44, 2.95 m row 29
    assert_near "$(h5_numbers fields.h5 /cohesion -s "$index,44,50" -c 1,1,1)" 31500 1e-4
    assert_near "$(h5_numbers fields.h5 /cohesion -s "$index,29,50" -c 1,1,1)" 12250 1e-4
  done
  # The third has an error of 2 kPa: there the spread falls from 5 kPa to some sqrt(1/(1/25 + 1/4)) = 1.9 kPa, and the mean goes to
  # some 20 - 2 x 25/29 = 18.3 kPa. Four standard errors, and 0.2 kPa for the lognormal's bend. 2.95 m - 1 m is row 19.
  rfgen scene/scene.toml -n 100 -o many.h5
  h5_numbers many.h5 /cohesion -s 0,19,220 -c 100,1,1 |
    awk '{ s += $1; q += $1 * $1 } END { print s / NR, sqrt(q / NR - (s / NR) ^ 2) }' >moments
  read -r mean sd <moments
  assert_near "$mean" 18300 1000
  assert_between "$sd" 1200 2600
}

@test "measurements that cannot be met exit 65, a missing table 66" {
  sed 's/^cell = "0.1 m"/&\nmeasurements = "borings.tsv"/' "$scene" >scene.toml
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 66
  assert_output --partial "borings.tsv: cannot be opened"
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 5.05 0.55 31.5 5.07 0.57 30 >borings.tsv
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "borings.tsv:3: found 3e+04, but borings.tsv:2 gives the same cell 3.15e+04"
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 5.05 6 31.5 >borings.tsv
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "borings.tsv:2: point 1 at (5.05 m, -1 m) lies outside the mesh"
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 5.05 1 -31.5 >borings.tsv
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "borings.tsv:2: found -3.15e+04, which no sample can honour: values of this field are held between 4000 and inf"
  assert_not_exist fields.h5
}

# refused_borings MESSAGE TABLE: of scene.toml, with that text in its table of measurements.
refused_borings() {
  printf "$2" >borings.tsv
  run rfgen scene.toml -n 1 -o fields.h5
  assert_failure 65
  assert_output --partial "$1"
  assert_not_exist fields.h5
}

@test "tables of measurements that would be misread are refused" {
  sed 's/^cell = "0.1 m"/&\nmeasurements = "borings.tsv"/' "$scene" >scene.toml
  refused_borings "borings.tsv:1: found the column 'error', expected 'error_kPa'" 'x_m\tdepth_m\tvalue_kPa\terror\n5\t1\t25\t2\n'
  refused_borings "borings.tsv:1: found the column 'error_Pa', expected 'error_kPa'" 'x_m\tdepth_m\tvalue_kPa\terror_Pa\n5\t1\t25\t2\n'
  refused_borings "borings.tsv: found no measurement in the soils" 'x_m\tdepth_m\tvalue_kPa\n'
  refused_borings "borings.tsv:2: found 1.2e+05, a value that the marginal distribution has less than once" 'x_m\tdepth_m\tvalue_kPa\n5\t1\t120\n'
  sed -i 's/^cov = .*/cov = 0.5/' scene.toml
  refused_borings "borings.tsv:2: found 3500, which no sample can honour: values of this field are held between 4000 and inf" 'x_m\tdepth_m\tvalue_kPa\n5\t1\t3.5\n'
  refused_borings "borings.tsv:2: column 'value_kPa': found 'nan', expected a finite number" 'x_m\tdepth_m\tvalue_kPa\n5\t1\tnan\n'
  refute_output --partial "borings.tsv:2: borings.tsv:2"
}

@test "measurements may end their lines as Windows does" {
  sed 's/^cell = "0.1 m"/&\nmeasurements = "borings.tsv"/' "$scene" >scene.toml
  printf 'x_m\tdepth_m\tvalue_kPa\r\n5.05\t0.55\t31.5\r\n' >borings.tsv
  rfgen scene.toml -n 1 -o fields.h5
  assert_near "$(h5_numbers fields.h5 /cohesion -s 0,44,50 -c 1,1,1)" 31500 1e-4
}

@test "a field honours the measurements in its own soils, and says how many" {
  # The clay lies below 1 m: of three depths one is in it, two in the fill above. Cells of 0.25 m.
  sed 's/^\[field.cohesion\]\|^\[soil.field.cohesion\]/&\nmeasurements = "boring.tsv"/' "$TOP/tests/scenes/varied.toml" >scene.toml
  printf '%s\t%s\t%s\n' x_m depth_m value_kPa 1.1 0.1 4 1.1 0.6 3.5 1.1 1.4 6 >boring.tsv
  run rfgen scene.toml --explain
  assert_line "measurements honoured: 2"
  assert_line "measurements honoured: 1"
}

@test "measurements of any parameter are read in its unit" {
  sed '/^\[field.friction_angle\]/a measurements = "angles.tsv"' "$TOP/tests/scenes/varied.toml" >scene.toml
  printf '%s\t%s\t%s\t%s\n' x_m depth_m value_deg error_deg 1.1 0.6 33 0 >angles.tsv
  assert_schema measurements angles.tsv
  rfgen scene.toml -n 2 -o fields.h5
  assert_schema fields fields.h5
  assert_near "$(h5_numbers fields.h5 /friction_angle -s 1,5,4 -c 1,1,1)" 0.575958653158 1e-9
}
