#pragma once

#include "renderer/pyray/tracer.h"
#include "renderer/shadows/shadow_context.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace asos {

/// Scratch memory for the shadow pyrays and the reflected pyrays of leaves, by number of bounces.
/// Holds no result.
struct EyeWorkspace {
  ShadowWorkspace shadows;

  [[nodiscard]] Tracer& mirror_tracer(int bounce) {
    while (mirrors_.size() <= static_cast<std::size_t>(bounce))
      mirrors_.push_back(std::make_unique<Tracer>());
    return *mirrors_[static_cast<std::size_t>(bounce)];
  }

 private:
  std::vector<std::unique_ptr<Tracer>> mirrors_;
};

}  // namespace asos
