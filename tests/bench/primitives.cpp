// Cost of a pyray's in-out test relative to a ray's, for the primitives of GI'93, table 3. The last
// column is this program's method for curved faces: finding their outline in the pyray's square.
//
//   bench primitives

#include "renderer/study/primitive_costs.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

namespace asos::bench::primitives {

int run(int argc, char** argv) {
  Options options("A pyray's in-out test beside a ray's, by primitives");
  if (const auto code = options.end(argc, argv)) return *code;
  fmt::print("nanoseconds      ray     cone   factor  published  in square\n");
  for (const PrimitiveCost& cost : primitive_costs(15)) {
    fmt::print("{:<9} {:8.1f} {:8.1f} {:8.2f} {:10.2f}", cost.name, cost.ray_ns, cost.cone_ns,
               cost.factor(), cost.published);
    if (cost.square_ns > 0.0) fmt::print(" {:10.1f}", cost.square_ns);
    fmt::print("\n");
  }
  return 0;
}

}  // namespace asos::bench::primitives
