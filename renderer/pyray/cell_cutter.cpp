#include "renderer/pyray/cell_cutter.h"

#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

float tolerance(const CellToCut& cell, const SubdivisionRules& rules) {
  if (rules.limits.tolerance > 0.0f) return rules.limits.tolerance * cell.root_side;
  const float finest = cell.root_side * std::ldexp(1.0f, -rules.error_budget.max_level);
  return SearchTuning::chain_tolerance * finest * std::min(1.0f, finest / cell.square.side);
}

// Returns the number of parts up to which a cut pays. A few parts pay at any level: each gets a
// sample, even where MAX allows one for the whole cell. More parts pay only if they replace several
// levels of children: at most half as many as there are finest cells.
std::size_t most_parts(const CellToCut& cell, const SubdivisionRules& rules) {
  const int below = rules.error_budget.max_level - cell.level;
  return static_cast<std::size_t>(
      std::max(rules.limits.least_parts, std::min(64, (1 << 2 * below) / 2)));
}

}  // namespace

CellCut CellCutter::cut(const CellToCut& cell, std::span<const std::uint32_t> visible,
                        const SubdivisionRules& rules, HitLists& lists) {
  CellCut result;
  result.boundaries = visible.size();
  hidden_.clear();
  // Resolve groups of boundaries into edges.
  const bool groups = std::any_of(visible.begin(), visible.end(),
                                  [&](std::uint32_t i) { return !lists.entry(i).is_segment(); });
  if (groups && !resolve(cell, visible, rules, lists)) return result;
  result.along = groups ? std::span<const std::uint32_t>(resolved_) : visible;
  result.hidden = hidden_;
  segments_.clear();
  for (const std::uint32_t i : result.along) segments_.push_back(lists.segment(i));

  // Join many edges to few chains.
  std::span<const Segment> boundaries = segments_;
  const auto most_segments = static_cast<std::size_t>(rules.limits.most_boundaries);
  const auto most_pieces = static_cast<std::size_t>(rules.limits.most_pieces);
  if (boundaries.size() > most_segments) {
    // Few pieces keep their shape, since a thin shape between two chains would be lost.
    const bool long_chains = segments_.size() > most_pieces;
    boundaries = chains_.simplify(segments_, long_chains ? tolerance(cell, rules) : 0.0f);
    result.boundaries = chains_.chain_count();
    if (boundaries.size() > most_pieces || result.boundaries > most_segments) return result;
  }

  // Cut.
  result.parts = partition_.cut(cell.square, boundaries, most_parts(cell, rules));
  result.borders = partition_.borders();
  return result;
}

// Resolves visible groups into segments. Returns false if there are too many.
bool CellCutter::resolve(const CellToCut& cell, std::span<const std::uint32_t> visible,
                         const SubdivisionRules& rules, HitLists& lists) {
  // Give up with many unresolved groups that are no chains: a plain outline has few, so the cell is
  // saturated.
  const auto groups = std::count_if(visible.begin(), visible.end(), [&](std::uint32_t i) {
    return !lists.entry(i).is_segment() && !lists.entry(i).is_chain();
  });
  if (groups > rules.limits.most_groups) return false;
  found_.clear();
  for (const std::uint32_t i : visible)
    if (!lists.resolve(i, cell.square, tolerance(cell, rules), SearchTuning::most_pieces_resolved,
                       found_))
      return false;
  resolved_.clear();
  for (const std::uint32_t i : found_)
    (lists.hidden(i, cell.square, cell.hiding) ? hidden_ : resolved_).push_back(i);
  return true;
}

}  // namespace asos
