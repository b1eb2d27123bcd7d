#pragma once

#include "renderer/result.h"

#include <memory>

namespace asos::test {

/// An OpenGL 3.3 core context in memory. It is current on the calling thread, with its functions
/// loaded, until it is destroyed.
class OsmesaContext {
 public:
  [[nodiscard]] static Result<std::unique_ptr<OsmesaContext>> make(int width, int height);
  ~OsmesaContext();
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  /// Changes the framebuffer's size.
  [[nodiscard]] bool resize(int width, int height);

 private:
  OsmesaContext();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace asos::test
