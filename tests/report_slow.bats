# make report of a study on a tiny scene: one file that needs nothing else, rendered by a headless browser, printed to PDF. Slow: its packages.
load helper

setup() {
  cd "$BATS_TEST_TMPDIR"
  cp "$TOP/tests/scenes/tiny.toml" scene.toml
  printf 'name\tside\tdistance_m\nhut\ttoe\t1\nmast\tcrest\t3\n' >structures.tsv
  printf '%s\n' 'SCENE := scene.toml' "include $TOP/pipelines/study.mk" >Makefile
}

report() { run make --no-print-directory -j2 TOOLS="${TOOLS:-$SLIDEZONE_BIN}" report "$@"; }

# browser OPTION...: headless, without any network: every name is unknown to it.
browser() {
  chromium --headless --no-sandbox --disable-gpu --user-data-dir="$PWD/profile" --host-resolver-rules='MAP * ~NOTFOUND' "$@" 2>browser.log
}

# words FILE: the text of an HTML file, on one line.
words() { tr '\n' ' ' <"$1" | sed 's/<[^>]*>/ /g; s/&lt;/</g; s/&gt;/>/g' | tr -s ' '; }

@test "one file with pictures, tables, scene and commands, and nothing outside it" {
  sed -i '1i # The strength is calibrated on nothing: this is a test.\n' scene.toml
  report N=4
  assert_success
  assert_line --index -1 --regexp '^Report: .*out/report.html$'
  assert_equal "$(grep -o '<svg' out/report.html | wc -l)" 5
  run grep -nE '(src|href)="?(http|//|file|/)|url\((http|//)|<script|<link' out/report.html
  assert_failure 1
  words out/report.html >words
  for text in 'Tiny: 2 m slope' 'Of 4 random realizations, drawn plain' 'left the grid' 'hut' '1.0 m from the toe' \
    'The strength is calibrated on nothing' 'make -j8 N=4 SCENE=scene.toml OUT=out report' 'Probability of failure' 'Lilliefors'; do
    assert_file_contains words "$text"
  done
  cp out/report.html first.html
  rm out/report.html
  report N=4
  cmp first.html out/report.html
}

@test "a browser without a network renders it, and prints it to a clean PDF" {
  report N=4
  browser --dump-dom "file://$PWD/out/report.html" >dom
  assert_equal "$(grep -o '<svg' dom | wc -l)" 5
  assert_equal "$(grep -o '<table' dom | wc -l)" 6
  browser --window-size=1000,6000 --screenshot=page.png "file://$PWD/out/report.html"
  assert_equal "$(head -c 8 page.png | od -An -tx1 | xargs)" "89 50 4e 47 0d 0a 1a 0a"
  assert [ "$(stat -c %s page.png)" -gt 100000 ]  # a blank page of this size has 20 kB
  browser --no-pdf-header-footer --print-to-pdf=report.pdf "file://$PWD/out/report.html"
  run pdfinfo report.pdf
  assert_output --regexp 'Pages: +[5-9]'
  pdftotext -layout report.pdf text
  for heading in 'How the runs ended' 'Hazard classes' 'Structures' 'Pictures' 'What was calibrated' 'The scene'; do assert_file_contains text "$heading"; done
  assert_file_contains text 'Zones on the section'
  assert_file_contains text 'beyond all runs'  # of a picture: text stays text
  run grep -c 'file://' text
  assert_output 0
}

@test "runs that diverged or left the grid stand in it by number, with the warnings" {
  mkdir bin
  for tool in rfgen rfmap mcstats zoning; do ln -s "$SLIDEZONE_BIN/$tool" bin; done
  cat >bin/mpmrun <<END
#!/bin/bash
"$SLIDEZONE_BIN/mpmrun" "\$@"
case "\$*" in
  *'--sample 2 '*'-o out/rows/'*) sed -i -E 's/^2\t\w+\t[^\t]*\t[^\t]*/2\tdiverged\tnan\tnan/' "\${@: -1}" ;;
  *'--sample 4 '*'-o out/rows/'*) sed -i -E 's/^4\t\w+/4\tleft_domain/' "\${@: -1}" ;;
esac
END
  chmod +x bin/mpmrun
  TOOLS=$PWD/bin report N=5
  assert_success
  browser --dump-dom "file://$PWD/out/report.html" >dom
  words dom >words
  assert_file_contains words 'their reach is a lower bound 1 4 diverged: failed, without a result 1 2 '
  assert_file_contains words '1 of the runs diverged: means leave them out'
}

@test "a deterministic scene has a report too, and without pandoc there is a message" {
  sed -i '/^\[field/,$d' scene.toml
  report
  assert_success
  assert_file_contains out/report.html 'With one strength everywhere'
  assert_equal "$(grep -o '<svg' out/report.html | wc -l)" 1
  mkdir bin
  ln -s /usr/bin/* bin
  rm bin/pandoc
  rm out/report.html
  PATH=$PWD/bin run make TOOLS="$SLIDEZONE_BIN" report
  assert_failure
  assert_output --partial "'make report' wants pandoc, which is not installed"
}
