#!/usr/bin/env bash
# ./check counts single tests: those of a suite, skipped and failed ones, a suite that ended early,
# and a script. Usage: count_tests_test.sh SOURCE_DIR
set -euo pipefail
found=$(awk -f "$1/tests/house/count_tests.awk" <<'LOG'
1/4 Testing: film.Film
[ RUN      ] Film.Holds
[       OK ] Film.Holds (1 ms)
[ RUN      ] Film.IsShown
[       OK ] Film.IsShown (2 ms)
[ RUN      ] Film.OfAModel
film_test.cpp:7: Skipped
no models: set ASOS_SHARED
[  SKIPPED ] Film.OfAModel (0 ms)
[  PASSED  ] 2 tests.
[  SKIPPED ] Film.OfAModel
Test Passed.
2/4 Testing: film.Tone
[ RUN      ] Tone.IsNeutral
[  FAILED  ] Tone.IsNeutral (3 ms)
[ RUN      ] Tone.IsNone
[       OK ] Tone.IsNone (1 ms)
[  FAILED  ] Tone.IsNeutral
Test Failed.
3/4 Testing: film.Png
[ RUN      ] Png.EndsEarly
Test Failed.
4/4 Testing: house.format
Test Passed.
LOG
)
[[ $found == '2 7 1' ]] || {
  echo "failed, all and skipped were counted as $found instead of 2 7 1"
  exit 1
}
