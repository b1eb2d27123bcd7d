#pragma once

#include "tests/bench/bench_support.h"

namespace asos::bench {

/// Tells where the squared error and the samples of an ASOS picture are: by what became of its
/// pixels (Outcome), and by what their samples met. `snapshot` is what `film` was rendered from.
void print_causes(const Snapshot& snapshot, const Film& film, const Film& reference);

}  // namespace asos::bench
