#include "tests/bench/error_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace asos::bench {
namespace {

/// The kind of surface in a pixel; if several apply, the last one.
enum class Look { plain, shiny, textured, see_through };
constexpr int look_count = 4;
constexpr std::array<const char*, look_count> look_names{"plain", "shiny", "textured",
                                                         "see-through"};

// roughness limit of highlights that are at most a few degrees wide
constexpr float shiny_roughness = 0.35f;

Look look_of(const Material& m) {
  if (m.alpha_mode != AlphaMode::opaque || m.transmission > 0.0f) return Look::see_through;
  if (m.base_color_texture.used() || m.normal_texture.used() || m.emissive_texture.used() ||
      m.metallic_roughness_texture.used())
    return Look::textured;
  return m.roughness < shiny_roughness ? Look::shiny : Look::plain;
}

Look look_of(const World& world, const PixelTrace& trace) {
  Look look = Look::plain;
  for (const TracedCell& cell : trace.cells) {
    for (const TracedSample& sample : cell.samples)
      if (sample.triangle != Hit::none)
        look = std::max(look, look_of(world.material_of(sample.triangle)));
  }
  return look;
}

struct Share {
  std::size_t pixels = 0;
  std::size_t samples = 0;
  double error = 0.0;

  void add(std::size_t more_samples, double more_error) {
    ++pixels;
    samples += more_samples;
    error += more_error;
  }
};

void print_share(const char* first, const char* second, const Share& share, const Share& all) {
  const auto percent = [](double part, double whole) {
    return whole > 0.0 ? 100.0 * part / whole : 0.0;
  };
  fmt::print("  {:<12}{:<12}{:>9.2f}{:>9.1f}{:>9.1f}{:>11.1f}\n", first, second,
             percent(static_cast<double>(share.pixels), static_cast<double>(all.pixels)),
             percent(share.error, all.error),
             percent(static_cast<double>(share.samples), static_cast<double>(all.samples)),
             static_cast<double>(share.samples) / static_cast<double>(share.pixels));
}

}  // namespace

void print_causes(const Snapshot& snapshot, const Film& film, const Film& reference) {
  std::array<std::array<Share, look_count>, outcome_count> shares{};
  Share all;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const PixelTrace trace = trace_of(snapshot, i);
    const double error = squared_error(film.radiance[i], reference.radiance[i], true);
    const auto outcome = static_cast<std::size_t>(outcome_of(trace));
    const auto look = static_cast<std::size_t>(look_of(snapshot.scene->world(), trace));
    shares[outcome][look].add(samples_of(trace), error);
    all.add(samples_of(trace), error);
  }
  fmt::print("causes at MAX {}, EPS {:.4f}; percent of the pixels, the squared error, the leaves\n",
             snapshot.settings.asos.max_level, snapshot.settings.asos.eps);
  fmt::print("  {:<24}{:>9}{:>9}{:>9}{:>11}\n", "", "pixels", "error", "leaves", "leaves/pix");
  for (int o = 0; o < outcome_count; ++o) {
    for (int l = 0; l < look_count; ++l) {
      const Share& share = shares[static_cast<std::size_t>(o)][static_cast<std::size_t>(l)];
      if (share.pixels > 0)
        print_share(name_of(static_cast<Outcome>(o)), look_names[static_cast<std::size_t>(l)],
                    share, all);
    }
  }
  std::size_t most = 0;
  double sum = 0.0;
  for (const std::size_t i : worst_pixels(film, reference)) {
    if (sum >= 0.9 * all.error) break;
    sum += squared_error(film.radiance[i], reference.radiance[i], true);
    ++most;
  }
  fmt::print("  {} pixels ({:.2f} %) carry 90 % of the squared error\n", most,
             100.0 * static_cast<double>(most) / static_cast<double>(all.pixels));
  std::fflush(stdout);
}

}  // namespace asos::bench
