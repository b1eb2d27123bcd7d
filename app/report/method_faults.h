#pragma once

#include "renderer/result.h"

#include <array>
#include <string>
#include <vector>

namespace asos {

/// A part of `builtin:cards` on which methods fail that only track covered fractions of a pixel
/// (CGF'98 sections 2.7 and 2.8).
struct FaultSubject {
  const char* name;
  const char* right;  ///< what a correct picture has there
};

inline constexpr std::array fault_subjects{
    FaultSubject{"a card exactly behind another", "nothing of the rear card"},
    FaultSubject{"two cards side by side", "nothing of the wall between them"},
    FaultSubject{"wires of a tenth of a pixel", "a tenth of their brightness"},
    FaultSubject{"a thin bar and its shadow", "an even bar, an even shadow"},
    FaultSubject{"wires that move", "a tenth of their brightness in each picture"},
};

/// A method's errors on the subjects.
struct MethodFaults {
  std::string method;
  /// Of each subject: the root mean square difference from the reference, in linear radiance where
  /// white is 1. The moving wires are compared in eight pictures, one pixel of motion in all, with
  /// exact ones (beam).
  std::array<double, fault_subjects.size()> errors{};
};

/// Renders `builtin:cards` by asos, sobol with 16 samples, cone, covers and mask at 160x90, and the
/// reference by 256 Sobol samples. Takes a few seconds. Errors: those of preparing the scene.
[[nodiscard]] Result<std::vector<MethodFaults>> method_faults();

}  // namespace asos
