// The cost of a pyray's in-out test beside a ray's, for each of the primitives of GI'93, table 3:
// `bench_primitives`. The last column is what this program does instead for curved faces, which is
// to find their outline in the pyray's square.

#include "renderer/study/primitive_costs.h"

#include <cstdio>

int main() {
  std::printf("nanoseconds      ray     cone   factor  published  in square\n");
  for (const asos::PrimitiveCost& cost : asos::primitive_costs(15)) {
    std::printf("%-9s %8.1f %8.1f %8.2f %10.2f", cost.name, cost.ray_ns, cost.cone_ns,
                cost.factor(), cost.published);
    if (cost.square_ns > 0.0) std::printf(" %10.1f", cost.square_ns);
    std::printf("\n");
  }
  return 0;
}
