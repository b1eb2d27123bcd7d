#pragma once

#include "renderer/pyray/partition_pieces.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace asos {

/// Joins pieces that end a little (a 64th of a cell) before another to it, by pieces of their own:
/// no line is moved. By the nodes and the edges that the pieces make now. Whether there were any.
[[nodiscard]] bool close_gaps(std::vector<PartitionPiece>& pieces,
                              std::span<const glm::dvec2> nodes,
                              std::span<const PartitionEdge> edges);

}  // namespace asos
