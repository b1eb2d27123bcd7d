#include "renderer/film/image_io.h"
#include "tests/ui/ui_rig.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

// Film strips of the window to look at: window_strips FOLDER [MODELS]. Drags EPS from 1/8 to
// 1/1000, and MAX from 0 to 6, on built-in scenes and on models of the folder MODELS (its
// scenes/NAME/NAME.glb), with the split map shown. Each picture shows the window 100 ms after the
// pointer moved; the last ones follow the end of the drag. The status line has the time. Writes
// SCENE-eps.png and SCENE-max.png.

namespace asos::test {
using namespace ui;
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 window_size{800, 500};
constexpr int columns = 4;
constexpr double follow_seconds = 0.1;

/// Pictures of the window at half its size, in rows.
class Strip {
 public:
  void add(const std::vector<glm::u8vec3>& pixels) { shots_.push_back(pixels); }
  void write(const std::string& file) const {
    const glm::ivec2 shot = window_size / 2;
    const int rows = (static_cast<int>(shots_.size()) + columns - 1) / columns;
    RgbImage image{columns * shot.x, rows * shot.y, {}, {}};
    image.rgb.assign(3u * static_cast<std::size_t>(image.width * image.height), 0);
    for (std::size_t i = 0; i < shots_.size(); ++i) {
      const glm::ivec2 corner =
          shot * glm::ivec2(static_cast<int>(i) % columns, static_cast<int>(i) / columns);
      for (int y = 0; y < shot.y; ++y)
        for (int x = 0; x < shot.x; ++x) {
          const glm::ivec3 mean = sum_of_four(shots_[i], {2 * x, 2 * y}) / 4;
          const auto to = 3 * static_cast<std::size_t>((corner.y + y) * image.width + corner.x + x);
          for (int c = 0; c < 3; ++c)
            image.rgb[to + static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(mean[c]);
        }
    }
    if (const Result<void> written = write_png(file, image); !written)
      throw std::runtime_error(written.error().message());
    std::printf("%s\n", file.c_str());
    std::fflush(stdout);
  }

 private:
  static glm::ivec3 sum_of_four(const std::vector<glm::u8vec3>& pixels, glm::ivec2 at) {
    glm::ivec3 sum(0);
    for (int k = 0; k < 4; ++k)
      sum += glm::ivec3(
          pixels[static_cast<std::size_t>((at.y + k / 2) * window_size.x + at.x + k % 2)]);
    return sum;
  }
  std::vector<std::vector<glm::u8vec3>> shots_;
};

/// A window that runs in real time.
class Recorder {
 public:
  explicit Recorder(const std::string& source)
      : rig_(LoadFunction{}, window_size, 1.0f, UiRig::Skies::usual) {
    rig_.settings() = {};
    rig_.state().show_panel = false;
    rig_.state().display.show_legend = false;
    rig_.scene().open(source);
    wait(900.0, [&] { return finished(); });
    if (!finished()) throw std::runtime_error(source + " is not finished");
    // Opening a scene turns the split map off.
    rig_.state().display.show_split_map = true;
  }

  /// Drags a slider of the bar through these fractions of its width.
  void drag(const std::string& slider, const std::vector<float>& shares) {
    start_ = Clock::now();
    const Controls::Placed at = rig_.control(slider);
    const auto place = [&](float share) {
      return glm::vec2(glm::mix(at.lo.x, at.hi.x, share), at.centre().y);
    };
    rig_.move_to(place(shares.front()));
    rig_.press(MouseButton::left);
    for (const float share : shares) {
      rig_.input().add(MouseMoved{place(share)});
      wait(follow_seconds, [] { return false; });
      shoot("100 ms after the move");
    }
    rig_.release(MouseButton::left);
    const Clock::time_point end = Clock::now();
    for (const double seconds : {0.5, 2.0, 8.0, 60.0}) {
      wait(seconds - std::chrono::duration<double>(Clock::now() - end).count(),
           [&] { return finished(); });
      const double after = std::chrono::duration<double>(Clock::now() - end).count();
      shoot(fmt::format("{:.1f} s after the drag{}", after, finished() ? ", finished" : ""));
      if (finished()) break;
    }
  }
  void write(const std::string& file) const { strip_.write(file); }

 private:
  [[nodiscard]] bool finished() {
    return rig_.scene() && !rig_.scene().loading() && rig_.render().progress().finished &&
           rig_.input().empty();
  }
  void wait(double seconds, const std::function<bool()>& done) {
    const Clock::time_point begin = Clock::now();
    do rig_.frame_at(std::chrono::duration<double>(Clock::now() - start_).count());
    while (!done() && std::chrono::duration<double>(Clock::now() - begin).count() < seconds);
  }
  void shoot(const std::string& when) {
    const AsosSettings& asos = rig_.settings().asos;
    UiState& state = rig_.state();
    state.message =
        fmt::format("{:.2f} s   EPS 1/{:.0f}   MAX {}   {:.1f} % split   {}",
                    std::chrono::duration<double>(Clock::now() - start_).count(), 1.0 / asos.eps,
                    asos.max_level, 100.0 * rig_.render().split_share(), when);
    state.message_until_seconds = 1e9;
    std::printf("%s\n", state.message.c_str());
    strip_.add(rig_.pixels());
    state.message.clear();
  }

  UiRig rig_;
  Strip strip_;
  Clock::time_point start_ = Clock::now();
};

void record(const std::string& folder, const std::string& name, const std::string& source) {
  {
    Recorder eps(source);
    std::vector<float> shares;
    for (const double part : {8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1000.0})
      shares.push_back(Controls::log_share(1.0 / part, 1.0));
    eps.drag("EPS in bar", shares);
    eps.write((fs::path(folder) / (name + "-eps.png")).string());
  }
  Recorder max(source);
  std::vector<float> shares;
  for (int level = 0; level <= 6; ++level)
    shares.push_back(static_cast<float>(level) / static_cast<float>(max_level_limit));
  max.drag("MAX in bar", shares);
  max.write((fs::path(folder) / (name + "-max.png")).string());
}

}  // namespace
}  // namespace asos::test

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fputs("usage: window_strips FOLDER [MODELS]\n", stderr);
    return 2;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    for (const char* name : {"fence", "office"})
      asos::test::record(argv[1], name, std::string("builtin:") + name);
    for (const char* model : {"Fox", "ToyCar"}) {
      if (argc < 3) break;
      std::filesystem::path file =
          std::filesystem::path(argv[2]) / "scenes" / model / (std::string(model) + ".glb");
      if (!std::filesystem::exists(file)) file.replace_extension(".gltf");
      asos::test::record(argv[1], model, file.string());
    }
    return testing::UnitTest::GetInstance()->ad_hoc_test_result().Failed() ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "window_strips: %s\n", error.what());
    return 1;
  }
}
