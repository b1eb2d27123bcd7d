#pragma once

#include "asos/picture.h"
#include "renderer/session/render_session.h"

namespace asos::api {

struct Picture::Impl {
  RenderResult result;
  Snapshot snapshot;  ///< that it is of
  bool finished = true;
  bool from_file = false;  ///< its scene; see Scene::Impl
  ToneCurve tone = ToneCurve::neutral;
};

}  // namespace asos::api
