#pragma once

#include "renderer/pyray/cell_cutter.h"
#include "renderer/pyray/subdivision_state.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Resolves the cells of a level that need no split: those that are uniform, cut along their
/// boundaries, or saturated with boundaries. The others get a sample at their centre. Samples of a
/// whole level go in packets. Reuses its memory; one object per thread.
class CellResolver {
 public:
  /// Passes leaves to the caster. Erases the cells that became leaves from the level.
  void resolve(CellLevel& level, SubdivisionState& state);

 private:
  // A slice of one of the arrays that plans share.
  struct Slice {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  // Samples that a cell needs, and its fate once they are taken.
  struct Plan {
    enum class Kind : std::uint8_t { uniform, cut, middle, saturated };
    Kind kind = Kind::middle;
    std::uint32_t cell = 0;
    Slice points;
    std::uint32_t first_part = 0;      // of as many parts as points
    Slice hidden;                      // entries that count as hidden
    Slice visible;                     // entries that are visible; only for observers
    SampleId own_samples = no_sample;  // represents the caster's own samples
    BoundaryKinds boundaries;
  };

  void plan(std::uint32_t cell_index, bool with_own_sample);
  [[nodiscard]] bool plan_cut(std::uint32_t cell_index, const CellOccluder& hiding,
                              std::size_t& boundaries);
  [[nodiscard]] bool plan_saturated(std::uint32_t cell_index, std::size_t boundaries);
  [[nodiscard]] bool better_sampled(const Cell& cell, std::size_t parts) const;
  Plan& add_plan(Plan::Kind kind, std::uint32_t cell_index, std::span<const glm::vec2> points);
  void keep_for_observers(const Cell& cell, Plan& plan, std::span<const std::uint32_t> visible);
  void carry_out();
  void finish_uniform(Cell& cell, const Plan& plan, SampleId first);
  void finish_cut(Cell& cell, const Plan& plan, SampleId first);
  void finish_saturated(Cell& cell, const Plan& plan, SampleId first);
  [[nodiscard]] bool stay_hidden(const Cell& cell, const Plan& plan, SampleId first) const;
  TracedCell* trace(const Cell& cell, const Plan& plan, CellFate fate) const;

  CellLevel* level_ = nullptr;
  SubdivisionState* state_ = nullptr;
  CellCutter cutter_;
  BoundarySearch::List visible_;  // of the current cell
  std::vector<Plan> plans_;
  std::vector<glm::vec2> points_;
  std::vector<CellPart> parts_;
  std::vector<BorderEdge> borders_;  // of the parts
  std::vector<std::uint32_t> hidden_;
  std::vector<std::uint32_t> drawn_;
};

}  // namespace asos
