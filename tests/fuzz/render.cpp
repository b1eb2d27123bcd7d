#include "renderer/comparison/method.h"
#include "renderer/gltf/load.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/prepared/with_lines.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/session/film_render.h"
#include "renderer/shading/environments.h"
#include "renderer/shading/sky.h"
#include "renderer/shading/sky_choice.h"
#include "tests/fuzz/gltf_mutator.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <cmath>
#include <random>
#include <string_view>

// Any loadable scene renders with all features on: to finite pixels, which do not depend on forced
// features, and which are the same in a crop of the picture.

namespace asos::fuzz {
namespace {

constexpr int side = 16;

/// The number "asos_fuzz" in the file's asset, which selects render settings; 0 if it is missing.
unsigned chosen_by(std::string_view file) {
  const std::size_t at = file.find("\"asos_fuzz\":");
  unsigned number = 0;
  for (std::size_t i = at == std::string_view::npos ? file.size() : at + 12;
       i < file.size() && file[i] >= '0' && file[i] <= '9'; ++i)
    number = number * 10 + static_cast<unsigned>(file[i] - '0');
  return number;
}

class Choice {
 public:
  explicit Choice(unsigned number) : usual_(number == 0), random_(number) {}
  /// A choice from 0 to count - 1; 0 by default.
  int of(int count) {
    return usual_ ? 0 : static_cast<int>(random_() % static_cast<unsigned>(count));
  }
  template <typename Enum>
  Enum any(Enum last) {
    return static_cast<Enum>(of(static_cast<int>(last) + 1));
  }

 private:
  bool usual_;
  std::mt19937 random_;
};

RenderSettings settings_of(Choice& choice) {
  RenderSettings s;
  s.width = s.height = side;
  s.threads = 1;
  s.method = choice.of(3) == 0 ? choice.any(last_method) : Method::asos;
  s.filter_width = choice.of(4) == 1 ? 2.0 : 1.0;
  s.asos.max_level = 2 - choice.of(3);
  s.asos.eps = choice.of(2) == 0 ? 1.0 / 256.0 : 0.0;
  s.asos.leaf = choice.any(LeafKind::point);
  s.asos.rule = choice.any(StoppingRule::published);
  s.asos.detect = choice.any(Detection::cone);
  s.asos.fat = 16 >> choice.of(4);
  s.asos.jitter = choice.of(2) == 1;
  s.sampling.spp = 4;
  s.sampling.depth = 2;
  s.texture.filter = choice.any(TextureFilter::point);
  s.texture.resolution = 1 + choice.of(2);
  s.shadow.quality = choice.any(ShadowQuality::extended_adaptive);
  s.shadow.light_rule = choice.any(LightRule::published);
  s.mirror.bounces = 2 - choice.of(3);
  s.mirror.roughest = choice.of(2) == 0 ? 1.0 : usual_roughest_mirror;
  s.mirror.curved = choice.any(CurvedMirror::adaptive);
  if (choice.of(4) == 1) {
    const DfrCurve curve{0.05, 0.8, 16.0};
    s.mirror.dfr = Dfr{{curve, curve, curve}, 0.2};
  }
  s.cull = choice.of(2) == 0;
  s.seed = choice.of(3);
  if (choice.of(2) == 0)
    s.sky = std::make_shared<const Sky>(glm::vec3(0.2f, 0.4f, 1.0f), glm::vec3(0.9f));
  if (choice.of(4) == 1) {
    const std::size_t any =
        static_cast<std::size_t>(choice.of(static_cast<int>(environments.size())));
    SkyChoice chosen;
    chosen.environment = environments[any].value;
    const auto made = make_sky(chosen);
    require(made.has_value(), "environments need no file");
    s.sky = *made;
  }
  s.shadow.sky = choice.of(4) == 1;
  s.shadow.bounces = choice.of(8) == 1 ? 1 : 0;
  if (choice.of(2) == 1) s.line_width = RenderSettings::max_line_width / (1 << choice.of(8));
  return s;
}

/// Later settings use their own random numbers, so that existing files of the corpus render as
/// before.
void add_later_settings(RenderSettings& s, unsigned number) {
  Choice choice(number == 0 ? 0 : number ^ 0x5eed0000u);
  if (choice.of(3) == 1) s.background.kind = choice.any(BackgroundKind::transparent);
  if (choice.of(3) == 1) s.ground = choice.any(Ground::mirror);
  if (choice.of(3) == 1) s.mirror.widest_angle_deg = 1.0;
}

Camera camera_of(const World& world, Choice& choice) {
  const int chosen = choice.of(3);
  if (chosen == 0 && !world.cameras.empty()) return world.cameras.front();
  Camera camera = default_camera(world, 1.0);
  // The camera is among the surfaces instead of in front of them.
  if (chosen == 2) {
    const glm::dvec3 middle = 0.5 * (glm::dvec3(world.bounds.lo) + glm::dvec3(world.bounds.hi));
    if (!world.bounds.empty()) camera.world_from_camera[3] = glm::dvec4(middle, 1.0);
  }
  return camera;
}

Film render(const std::shared_ptr<const RenderScene>& scene, const Camera& camera,
            const RenderSettings& settings) {
  Snapshot snapshot{scene, camera, settings};
  snapshot.progressive = false;
  FilmRender render;
  auto result = render.render(std::move(snapshot), {}, {});
  require(result.has_value(), "a picture is rendered to its end");
  for (const glm::vec3& pixel : result->film.radiance)
    for (int c = 0; c < 3; ++c)
      require(pixel[c] >= 0.0f && std::isfinite(pixel[c]), "pixels are finite and not negative");
  for (const float covered : result->film.coverage)
    require(covered >= 0.0f && covered <= 1.0f, "surfaces cover a part of a pixel");
  return std::move(result->film);
}

void require_same_part(const Film& whole, const Film& part, PixelRect rect) {
  for (int y = 0; y < rect.height; ++y)
    for (int x = 0; x < rect.width; ++x)
      require(
          part.radiance[part.index(x, y)] == whole.radiance[whole.index(rect.x + x, rect.y + y)],
          "a crop equals that part of the picture");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const unsigned number = chosen_by({reinterpret_cast<const char*>(data), size});
  Choice choice(number);
  RenderSettings settings = settings_of(choice);
  add_later_settings(settings, number);
  require(validated(settings).has_value(), "the settings are those of a person");
  auto loaded = load_scene(input_file("scene.glb", data, size),
                           {.max_triangles = 20'000, .keep_posable = true});
  if (loaded && loaded->rig) {
    constexpr std::array seconds{0.5, 0.0, 0.3, 1e9};
    loaded = loaded->rig->pose(ClipTime{0, seconds[static_cast<std::size_t>(choice.of(4))]});
  }
  if (!loaded) return 0;
  const auto bare = prepare(*loaded);
  if (!bare) return 0;
  const Camera camera = camera_of((*bare)->world(), choice);
  const auto grounded = with_ground(*bare, settings.ground);
  if (!grounded) return 0;
  const auto scene = with_lines(*grounded, line_picture(camera, settings));
  if (!scene) return 0;
  if (!check_method(**scene, settings)) settings.method = Method::asos;
  const Film film = render(*scene, camera, settings);
  const int also = choice.of(4);
  if (also == 1) {
    const auto forced = prepare(*loaded, RenderFeatures::all());
    require(forced.has_value(), "what is forced on refuses nothing");
    const auto stands = with_ground(*forced, settings.ground);
    require(stands.has_value(), "what is forced on refuses no ground");
    const auto drawn = with_lines(*stands, line_picture(camera, settings));
    require(drawn.has_value(), "what is forced on refuses no lines");
    require(render(*drawn, camera, settings).radiance == film.radiance,
            "what is forced on changes no pixel");
  }
  if (also == 2) {
    settings.crop = {5, 3, 7, 9};
    require_same_part(film, render(*scene, camera, settings), settings.crop);
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most_bytes, unsigned int seed) {
  const std::string_view file(reinterpret_cast<const char*>(data), size);
  return mutated(mutated_gltf(file, seed), data, size, most_bytes);
}

}  // namespace asos::fuzz
