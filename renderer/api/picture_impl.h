#pragma once

#include "asos/picture.h"
#include "renderer/session/render_session.h"

namespace asos::api {

struct Picture::Impl {
  RenderResult result;
  Snapshot snapshot;  ///< the input of the render
  bool finished = true;
  bool from_file = false;  ///< the scene is: see Scene::Impl
  ToneCurve tone = ToneCurve::neutral;
};

}  // namespace asos::api
