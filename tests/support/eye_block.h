#pragma once

#include "renderer/asos/error_terms.h"
#include "renderer/asos/eye_caster.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/selected_lights.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/view_context.h"
#include "renderer/shadows/shadow_context.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace asos::test {

/// A block of 4 x 4 pixels at a picture's centre, sampled at the pixels' centres, for tests of
/// error terms.
class EyeBlock {
 public:
  static constexpr int side = 4, picture = 16;

  EyeBlock(std::shared_ptr<const RenderScene> scene, const Camera& camera,
           RenderSettings settings = {})
      : scene_(std::move(scene)),
        settings_(settings),
        view_(camera, picture, picture, radius_around_origin(scene_->world().bounds)),
        shader_(shader_of(*scene_, settings_, view_)),
        frame_(view_.frame(first, first, side, side)),
        eye_{scene_.get(),
             &settings_,
             ViewContext::camera(view_, shader_),
             &frame_,
             {first, first, side, side}},
        shadow_scene_{scene_->world(), scene_->features(), scene_->rays()},
        groups_(shadow_scene_) {
    eye_.error_budget = ErrorBudget::of(settings_);
    eye_.work = &work_;
    eye_.counts = &counts_;
    samples_ = std::make_unique<EyeSamples>(eye_);
    std::vector<glm::vec2> centres;
    for (int i = 0; i < side * side; ++i)
      centres.emplace_back((glm::vec2(i % side, i / side) + 0.5f) / static_cast<float>(side));
    samples_->probe(centres);
    groups_.reset(shader_.lights().size());
    for (SampleId i = 0; i < centres.size(); ++i) {
      if (!samples_->hit(i).valid()) continue;
      const SurfacePoint point = samples_->point(i);
      groups_.add(samples_->hit(i), point.position, point.geometric_normal,
                  samples_->patch(i, 1.0));
    }
    shadows_.scene = &shadow_scene_;
    shadows_.rules.error_budget = eye_.error_budget;
    shadows_.lights = shader_.lights().size();
    shadows_.frame = &frame_;
    shadows_.view = samples_.get();
    shadows_.groups = &groups_;
    shadows_.work = &work_.shadows;
    selected_lights_ = std::make_unique<SelectedLights>(eye_, *samples_);
    terms_ = std::make_unique<ErrorTerms>(eye_, *samples_, *selected_lights_, shadows_);
    terms_->learn_normals(side);
  }

  [[nodiscard]] const EyeContext& eye() const { return eye_; }
  [[nodiscard]] const ErrorTerms& terms() const { return *terms_; }
  [[nodiscard]] EyeSamples& samples() { return *samples_; }
  [[nodiscard]] SelectedLights& selected_lights() { return *selected_lights_; }
  [[nodiscard]] const ShadowContext& shadows() const { return shadows_; }
  [[nodiscard]] RenderStatistics& counts() { return counts_; }
  /// The whole of pixel (x, y), or a square at its centre with this fraction of its side.
  [[nodiscard]] Leaf leaf(int x, int y, float part = 1.0f) const {
    constexpr float pixel = 1.0f / side;
    const glm::vec2 centre = (glm::vec2(x, y) + 0.5f) * pixel;
    const float width = part * pixel;
    const LeafRegion region{{centre.x - 0.5f * width, centre.y - 0.5f * width, width}, {}};
    const auto number = static_cast<std::uint32_t>(y * side + x);
    Leaf leaf;
    samples_->show({number, number, static_cast<double>(part * part), region}, leaf);
    return leaf;
  }

 private:
  static constexpr int first = (picture - side) / 2;

  std::shared_ptr<const RenderScene> scene_;
  RenderSettings settings_;
  View view_;
  Shader shader_;
  Frame frame_;
  EyeContext eye_;
  RenderStatistics counts_;
  EyeWorkspace work_;
  ShadowScene shadow_scene_;
  ShadowGroups groups_;
  ShadowContext shadows_;
  std::unique_ptr<EyeSamples> samples_;
  std::unique_ptr<SelectedLights> selected_lights_;
  std::unique_ptr<ErrorTerms> terms_;
};

}  // namespace asos::test
