# Reads CTest's LastTest.log and prints how many tests failed, how many there are and how many were
# skipped: GoogleTest's single ones where a suite tells of them; a script, and a suite that ended before
# it could say which failed, count as one.
/^[0-9]+\/[0-9]+ Testing: / { cases = bad = 0 }
/^\[ RUN      \] / { ++cases }
/^\[  FAILED  \] .* \([0-9]+ ms\)$/ { ++bad }
/^\[  SKIPPED \] .* \([0-9]+ ms\)$/ { ++skipped }
/^Test (Passed|Failed)\.$/ {
  total += cases ? cases : 1
  if ($2 == "Failed.") failed += bad ? bad : 1
}
END { print failed + 0, total + 0, skipped + 0 }
