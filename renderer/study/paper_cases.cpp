#include "renderer/study/paper_cases.h"

namespace asos {

StudyScene scene_of(const PaperCase& row) {
  StudyScene scene{row.source, {}};
  if (row.bounces > 0) scene.look.reflections = row.bounces;
  if (row.blur_exponent > 0.0) {
    const DfrCurve curve{0.05, 1.0, row.blur_exponent};
    scene.look.dfr = Dfr{{curve, curve, curve}, 0.0};
  }
  return scene;
}

LadderStep asos_rung(const PaperCase& row, const std::string& method, const RenderSettings& base) {
  RenderSettings settings = base;
  settings.texture.resolution = row.texture_resolution;
  return asos_rung(method, settings, row.max_level, row.eps);
}

}  // namespace asos
