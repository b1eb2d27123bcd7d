#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <stop_token>
#include <vector>

namespace asos {

/// Returns, for each vertex, the first one at the same place, which may be itself. 0 and -0 are
/// equal; a vertex at NaN is at no other's place. Parallel; throws SearchStopped once `stop` is
/// requested.
[[nodiscard]] std::vector<std::uint32_t> welded_vertices(const std::vector<glm::vec3>& positions,
                                                         const std::stop_token& stop = {});

}  // namespace asos
