#pragma once

#include "renderer/pyray/partition_pieces.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace asos {

/// Connects pieces that end slightly (a 64th of a cell) before another, by additional pieces, so
/// that no line moves. `nodes` and `edges` are those of the given pieces. Returns whether there
/// were any gaps.
[[nodiscard]] bool close_gaps(std::vector<PartitionPiece>& pieces,
                              std::span<const glm::dvec2> nodes,
                              std::span<const PartitionEdge> edges);

}  // namespace asos
