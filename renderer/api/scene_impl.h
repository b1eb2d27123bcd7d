#pragma once

#include "asos/scene.h"
#include "renderer/prepared/render_scene.h"

#include <memory>

namespace asos::api {

struct Scene::Impl {
  std::shared_ptr<const RenderScene> scene;
  bool relit = false;  ///< its lights are the caller's, whatever the sky is
  /// The scene comes from a file, so saved pictures contain a description to render them again.
  bool from_file = false;
};

}  // namespace asos::api
