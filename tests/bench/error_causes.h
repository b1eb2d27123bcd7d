#pragma once

#include "tests/bench/bench_support.h"

namespace asos::bench {

/// Prints the distribution of the squared error and the samples of an ASOS picture: by the outcome
/// of its pixels (Outcome), and by the surfaces that their samples hit. `snapshot` is the input of
/// `film`.
void print_causes(const Snapshot& snapshot, const Film& film, const Film& reference);

}  // namespace asos::bench
