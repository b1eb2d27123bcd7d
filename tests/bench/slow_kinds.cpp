// Time and error of ASOS beside 64 Sobol samples for kinds of models that ASOS is slow at: an
// avatar with cards of hair, a planetarium of emissive spheres, brushed metal, a glass ball through
// a lens, and a frosted pane. Processor time of one thread, without the search for edges, which has
// a column of its own. Errors are root mean squares of radiance clipped to 0..1, against many Sobol
// samples.
//
//   bench slow-kinds [--size WxH] [--reference N] [KIND...]

#include "renderer/scene/tessellate.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"
#include "tests/support/instanced_scene.h"
#include "tests/support/tiny_image.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::slow_kinds {

using test::ball_mesh;
using test::make_image;
using test::Texel;

glm::dmat4 placed(glm::dvec3 at, glm::dvec3 size) {
  return glm::scale(glm::translate(glm::dmat4(1.0), at), size);
}

/// A scene by its parts.
class Builder {
 public:
  Builder(glm::dvec3 eye, glm::dvec3 target) {
    scene_.source = "slow kind";
    Camera& camera = scene_.cameras.emplace_back();
    camera.world_from_camera = glm::inverse(glm::lookAt(eye, target, glm::dvec3(0, 1, 0)));
    camera.fov_y_rad = 0.6;
  }

  int material(const Material& material) {
    scene_.materials.push_back(material);
    return static_cast<int>(scene_.materials.size()) - 1;
  }
  int matte(glm::vec3 colour) {
    Material m;
    m.metallic = 0.0f;
    m.roughness = 0.8f;
    m.base_color = glm::vec4(colour, 1.0f);
    return material(m);
  }
  int texture(const Image& image) {
    scene_.images.push_back(image);
    Texture texture;
    texture.image = static_cast<int>(scene_.images.size()) - 1;
    scene_.textures.push_back(texture);
    return static_cast<int>(scene_.textures.size()) - 1;
  }
  int ball(int material, std::uint32_t rings = 48) {
    Mesh mesh = ball_mesh(rings, true, material);
    for (const glm::vec3 p : mesh.positions)
      mesh.texcoords[0].emplace_back(0.5f + 0.5f * p.x, 0.5f - 0.5f * p.y);
    return add(std::move(mesh));
  }
  /// A square from -1 to 1 in z = 0.
  int card(int material) {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.material = material;
    return add(std::move(mesh));
  }
  /// A box from -1 to 1.
  int box(int material) {
    Shape shape;
    shape.type = Shape::Type::box;
    shape.size = glm::dvec3(2.0);
    Mesh mesh = tessellated(shape);
    mesh.material = material;
    return add(std::move(mesh));
  }
  void place(int mesh, const glm::dmat4& at) {
    scene_.instances.push_back({fmt::format("thing {}", scene_.instances.size()), mesh, at});
  }
  [[nodiscard]] Scene take() { return std::move(scene_); }
  [[nodiscard]] Camera& camera() { return scene_.cameras.front(); }

 private:
  int add(Mesh mesh) {
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
  }
  Scene scene_;
};

std::uint8_t level(double value) {
  return static_cast<std::uint8_t>(std::clamp(255.0 * value, 0.0, 255.0));
}

Scene avatar() {
  Builder b({0, 1.2, 4.2}, {0, 1.1, 0});
  const auto waves = [](int x, int y, double by) {
    return 0.5 + 0.25 * std::sin(by * x + 0.3 * y) + 0.25 * std::sin(0.7 * by * y - 0.2 * x);
  };
  Material skin;
  skin.metallic = 0.0f;
  skin.base_color_texture.texture = b.texture(make_image(256, 256, [&](int x, int y) {
    const double v = waves(x, y, 0.9);
    return Texel{level(0.6 + 0.2 * v), level(0.4 + 0.2 * v), level(0.3 + 0.2 * v), 255};
  }));
  skin.metallic_roughness_texture.texture = b.texture(make_image(256, 256, [&](int x, int y) {
    return Texel{0, level(0.3 + 0.5 * waves(x, y, 0.4)), 0, 255};
  }));
  Material hair = skin;
  hair.metallic_roughness_texture = {};
  hair.roughness = 0.4f;
  hair.alpha_mode = AlphaMode::mask;
  hair.double_sided = true;
  hair.base_color_texture.texture = b.texture(make_image(64, 256, [&](int x, int y) {
    const bool strand = std::fmod(x + 1.5 * std::sin(0.05 * y + x / 4), 4.0) < 2.0 + 1.5 * y / 256;
    return Texel{60, 40, 25, level(strand ? 1.0 : 0.0)};
  }));
  const int head = b.ball(b.material(skin)), card = b.card(b.material(hair));
  b.place(head, placed({0, 1.65, 0}, {0.45, 0.55, 0.5}));
  b.place(head, placed({0, 0.4, 0}, {0.75, 0.9, 0.4}));
  for (int i = 0; i < 120; ++i) {
    const double turn = 0.8 + 0.041 * i, up = 0.15 * std::sin(2.3 * i);
    const glm::dvec3 at(0.55 * std::sin(turn), 1.75 + up, 0.55 * std::cos(turn));
    b.place(card, glm::rotate(placed(at, glm::dvec3(1.0)), turn, glm::dvec3(0, 1, 0)) *
                      glm::scale(glm::dmat4(1.0), {0.06, 0.35, 1.0}));
  }
  return b.take();
}

Scene planetarium() {
  Builder b({0, 1.5, 8}, {0, 0, 0});
  const int grey = b.matte({0.5f, 0.5f, 0.55f});
  b.place(b.box(grey), placed({0, -1.6, 0}, {5, 0.1, 5}));
  b.place(b.ball(grey), placed({0, 0, 0}, glm::dvec3(0.6)));
  for (int i = 0; i < 60; ++i) {
    Material star;
    star.base_color = {0, 0, 0, 1};
    star.metallic = 0.0f;
    star.emissive = {1.0f - 0.01f * static_cast<float>(i), 0.7f,
                     0.3f + 0.01f * static_cast<float>(i)};
    star.emissive_strength = 2.0f + static_cast<float>(i % 5);
    const double turn = 2.4 * i, far = 1.0 + 0.06 * i;
    b.place(b.ball(b.material(star), 12),
            placed({far * std::cos(turn), std::sin(1.7 * i), far * std::sin(turn)},
                   glm::dvec3(0.05 + 0.02 * (i % 6))));
  }
  return b.take();
}

Scene brushed() {
  Builder b({1.2, 1.2, 3.6}, {0, 0, 0});
  const auto metal = [&](float roughness, float strength) {
    Material m;
    m.base_color = {0.8f, 0.78f, 0.75f, 1.0f};
    m.roughness = roughness;
    m.anisotropy.strength = strength;
    m.anisotropy.rotation_rad = 0.5f;
    return b.material(m);
  };
  b.place(b.box(metal(0.3f, 0.8f)), placed({0, -0.6, 0}, {1.2, 0.15, 0.8}));
  const int post = b.box(metal(0.4f, 0.6f)), knob = b.ball(metal(0.25f, 0.9f));
  b.place(knob, placed({0, 0.2, 0}, glm::dvec3(0.5)));
  for (const double x : {-0.9, 0.9}) {
    b.place(post, placed({x, 0, 0.3}, {0.12, 0.5, 0.12}));
    b.place(knob, placed({x, 0.7, 0.3}, glm::dvec3(0.2)));
  }
  return b.take();
}

/// Boxes on a floor, behind glass.
void add_view(Builder& b) {
  b.place(b.box(b.matte({0.6f, 0.6f, 0.6f})), placed({0, -0.6, 0}, {4, 0.1, 4}));
  for (int i = 0; i < 5; ++i) {
    const float at = static_cast<float>(i) / 4.0f;
    b.place(b.box(b.matte({at, 0.8f - 0.7f * at, 0.4f})),
            placed({-1.6 + 0.8 * i, -0.1, -1.0 - 0.3 * (i % 2)}, {0.2, 0.4, 0.2}));
  }
}

Material glass(float roughness) {
  Material m;
  m.metallic = 0.0f;
  m.roughness = roughness;
  m.transmission = 1.0f;
  m.volume.thickness = 1.0f;
  return m;
}

Scene glass_ball() {
  Builder b({0.4, 0.6, 3}, {0, 0, 0});
  b.camera().lens.radius = 0.0069;  // f/2.8
  add_view(b);
  b.place(b.ball(b.material(glass(0.0f)), 64), placed({0, 0, 0}, glm::dvec3(0.5)));
  return b.take();
}

Scene frosted_pane() {
  Builder b({0.4, 0.6, 3.4}, {0, 0, 0});
  add_view(b);
  b.place(b.box(b.material(glass(0.4f))), placed({0, 0.2, 0.6}, {1.0, 0.7, 0.05}));
  return b.take();
}

struct Kind {
  const char* name;
  Scene (*make)();
};
constexpr Kind kinds[]{{"avatar", avatar},
                       {"planetarium", planetarium},
                       {"brushed", brushed},
                       {"glass-ball", glass_ball},
                       {"frosted-pane", frosted_pane}};

int measure(const Kind& kind, PictureSize size, int reference) {
  const auto scene = prepare(kind.make()).and_then(as_rendered);
  if (!scene) return fail(scene.error());
  if (const auto whole = with_boundaries(*scene); !whole) return fail(whole.error());
  Snapshot snapshot = snapshot_of(*scene, size.width, size.height);
  snapshot.settings.threads = 1;
  const auto by = [&](Method method, int samples, int seed, Times& times) {
    snapshot.settings.method = method;
    snapshot.settings.sampling.spp = samples;
    snapshot.settings.seed = seed;
    return times.render(snapshot).film;
  };
  Times asos, sobol, many;
  const Film truth = by(Method::sobol, reference, 7, many);
  const double of_asos = picture_error(by(Method::asos, 64, 0, asos), truth).shown;
  const double of_sobol = picture_error(by(Method::sobol, 64, 0, sobol), truth).shown;
  const double a = asos.medians().cpu, s = sobol.medians().cpu;
  fmt::print("{:<13} {:8.2f} {:8.2f} {:8.2f} {:6.1f} {:10.5f} {:10.5f}\n", kind.name,
             (*scene)->geometry->boundaries.seconds(), a, s, a / s, of_asos, of_sobol);
  std::fflush(stdout);
  return 0;
}

int run(int argc, char** argv) {
  PictureSize size{160, 90};
  int reference = 1024;
  std::vector<std::string> chosen;
  Options options("Kinds of models that ASOS is slow at, beside 64 Sobol samples");
  options.size(size);
  options.number("--reference", reference, 64, 1 << 20);
  options.texts("KIND", chosen);
  if (const auto code = options.end(argc, argv)) return *code;
  fmt::print("{:<13} {:>8} {:>8} {:>8} {:>6} {:>10} {:>10}\n", "", "edges s", "asos s", "64 spp s",
             "ratio", "asos rmse", "64 spp");
  for (const Kind& kind : kinds) {
    if (!chosen.empty() && std::ranges::find(chosen, kind.name) == chosen.end()) continue;
    if (const int code = measure(kind, size, reference)) return code;
  }
  return 0;
}

}  // namespace asos::bench::slow_kinds
