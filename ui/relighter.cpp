#include "ui/relighter.h"

#include <utility>

namespace asos::ui {

Relighter::Relighter(std::function<void()> wake) : job_(relit, std::move(wake), Overtaken::kept) {}

void Relighter::start_from(const SceneLook& look) {
  lights_asked_for_ = lights_of_scene_ = look.lights_revision;
  dfrs_asked_for_ = look.dfrs_revision;
}

void Relighter::start_over(std::uint64_t lights_revision, std::uint64_t dfrs_revision) {
  lights_asked_for_ = lights_of_scene_ = lights_revision;
  dfrs_asked_for_ = dfrs_revision;
}

bool Relighter::pending(const SceneLook& look) const {
  return !asked_for(look) || job_.pending();
}

bool Relighter::asked_for(const SceneLook& look) const {
  return lights_asked_for_ == look.lights_revision && dfrs_asked_for_ == look.dfrs_revision;
}

Relighter::Relit Relighter::relit(const Request& request) {
  Relit result{request.scene, request.scene, request.lights_revision};
  if (request.lights) result.scene = with_lights(request.scene, *request.lights);
  if (result.scene && (*result.scene)->dfrs() != request.dfrs)
    result.scene = with_dfrs(*result.scene, request.dfrs);
  return result;
}

void Relighter::update(OpenScene& scene, const SceneLook& look) {
  if (std::optional<Relit> done = job_.take_outcome()) {
    // Another scene may have been opened meanwhile.
    const bool current = scene.is(*done->from);
    if (current && done->scene) {
      scene.relight(std::move(*done->scene));
      lights_of_scene_ = done->lights_revision;
    }
    if (current && !done->scene) scene.report(done->scene.error());
  }
  if (!scene || asked_for(look)) return;
  lights_asked_for_ = look.lights_revision;
  dfrs_asked_for_ = look.dfrs_revision;
  Request request{scene.shared(), std::nullopt, look.lights_revision, look.dfrs};
  if (lights_of_scene_ != look.lights_revision) request.lights = lights_on(look.lights);
  job_.ask(std::move(request));
}

}  // namespace asos::ui
