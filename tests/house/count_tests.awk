# Reads CTest's LastTest.log and prints the numbers of failed, of all and of skipped tests. Counts
# GoogleTest's single tests if a suite reports them. A script counts as one, and so does a suite
# that ended before it reported its failures.
/^[0-9]+\/[0-9]+ Testing: / { cases = bad = 0 }
/^\[ RUN      \] / { ++cases }
/^\[  FAILED  \] .* \([0-9]+ ms\)$/ { ++bad }
/^\[  SKIPPED \] .* \([0-9]+ ms\)$/ { ++skipped }
/^Test (Passed|Failed)\.$/ {
  total += cases ? cases : 1
  if ($2 == "Failed.") failed += bad ? bad : 1
}
END { print failed + 0, total + 0, skipped + 0 }
