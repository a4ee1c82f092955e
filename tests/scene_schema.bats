# data-schemas/scene.schema.json and the reader of scenes, held against each other by tests/scene_schema.py.
load helper

compare() {
  run python3 "$TOP/tests/scene_schema.py" "$1" "$SLIDEZONE_BUILD/tests/read_scene"
  assert_success
  assert_output ""
}

@test "shipped scenes pass schema and reader" { compare good; }

@test "bad scenes are refused by both, at the right place with the right words" { compare bad; }

@test "every rule of the schema refuses some bad scene" { compare rules; }

@test "what the schema refuses, the reader refuses" { compare agree; }
