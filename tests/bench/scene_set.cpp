#include "tests/bench/scene_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace asos::bench {

void SceneSet::add_to(Options& options, const char* cached) {
  options.size(size);
  options.parsed("--cache", cached, [this](const std::string& text) -> Result<void> {
    cache = text;
    return {};
  });
  options.texts("SCENE", names);
}

std::string SceneSet::path_of(const std::string& name) const {
  std::string file = name;
  std::replace_if(
      file.begin(), file.end(), [](char c) { return c == '/' || c == ':'; }, '_');
  return fmt::format("{}/{}-{}x{}-{}{}", *cache, file, size.width, size.height, samples,
                     sky_shadows ? "-sky" : "");
}

Result<HalvedReference> SceneSet::reference_of(const std::string& name,
                                               const Snapshot& snapshot) const {
  if (!cache) return HalvedReference::rendered(snapshot, samples);
  return HalvedReference::kept(path_of(name), snapshot, samples);
}

Result<Snapshot> SceneSet::open(const std::string& source) const {
  return open_scene(source).map([&](SharedScene scene) {
    Snapshot snapshot = snapshot_of(std::move(scene), size.width, size.height);
    snapshot.settings.shadow.sky = sky_shadows;
    return snapshot;
  });
}

int SceneSet::measure(const std::function<Result<void>(const NamedScene&)>& measure_one) const {
  std::error_code failed;
  if (cache) std::filesystem::create_directories(*cache, failed);
  if (failed) return fail({*cache, failed.message()});
  int code = 0;
  for (const NamedScene& scene : chosen_scenes(names))
    if (const auto done = measure_one(scene); !done) code = fail(done.error());
  return code;
}

void print_median(const std::string& what, std::vector<SceneValue> values, const std::string& then,
                  std::size_t count, bool largest) {
  std::erase_if(values, [](const SceneValue& one) { return std::isnan(one.value); });
  if (values.empty()) return;
  std::sort(values.begin(), values.end(), [&](const SceneValue& a, const SceneValue& b) {
    return largest ? a.value > b.value : a.value < b.value;
  });
  std::vector<double> all;
  for (const SceneValue& one : values) all.push_back(one.value);
  fmt::print("{}: median {:.2f}{}", what, median(all), then);
  for (std::size_t k = 0; k < std::min(count, values.size()); ++k)
    fmt::print("{} {} {:.2f}", k > 0 ? "," : "", values[k].scene, values[k].value);
  fmt::print("\n");
}

}  // namespace asos::bench
