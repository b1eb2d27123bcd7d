#pragma once

#include "renderer/settings/settings.h"

namespace asos::test {

/// Settings of a picture of this size.
inline RenderSettings make_settings(int width, int height, Method method = Method::asos) {
  return {.width = width, .height = height, .method = method};
}

/// Settings of a picture by a method that takes `spp` samples per pixel.
inline RenderSettings make_settings(int width, int height, Method method, int spp) {
  RenderSettings settings = make_settings(width, height, method);
  settings.sampling.spp = spp;
  return settings;
}

}  // namespace asos::test
