#pragma once

#include "renderer/study/analysis.h"

#include <optional>
#include <string>

namespace asos {

/// A lower bound of a rival's time over that of ASOS at equal error, where the error of ASOS is
/// below the noise floor. The error itself is not measured. The floor is its upper bound, and the
/// rival's time to reach the floor is a lower bound of its time to reach that error.
struct FloorBound {
  std::string setting;         ///< ASOS's quickest setting below the floor
  double asos_seconds = 0.0;   ///< its time
  double rival_seconds = 0.0;  ///< the rival's time to reach the floor
  double factor = 0.0;         ///< the rival's time over that of ASOS
  /// measured; unreached: the rival does not reach the floor, and its longest time is used.
  Reading reading = Reading::measured;
};

/// Returns the bound for a rival in an analysed study. Returns nothing if no setting of ASOS is
/// below the floor, the rival was not measured, or its quickest setting is below the floor, too.
[[nodiscard]] std::optional<FloorBound> bound_at_floor(const SceneStudy& study,
                                                       const std::string& rival);

}  // namespace asos
