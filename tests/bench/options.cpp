#include "tests/bench/options.h"

#include "renderer/settings/value_text.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace asos::bench {

struct Options::Impl {
  CLI::App app;
};

Options::Options(const char* description) : impl_(std::make_unique<Impl>()) {
  impl_->app.description(description);
}

Options::~Options() = default;

void Options::flag(const char* name, bool& value, const char* help) {
  impl_->app.add_flag(name, value, help);
}

void Options::number(const char* name, int& value, int lo, int hi, const char* help) {
  impl_->app.add_option(name, value, help)->check(CLI::Range(lo, hi))->capture_default_str();
}

void Options::text(const char* name, std::string& value, const char* help) {
  impl_->app.add_option(name, value, help)->required(value.empty())->capture_default_str();
}

void Options::texts(const char* name, std::vector<std::string>& values, const char* help) {
  impl_->app.add_option(name, values, help);
}

void Options::choice(const char* name, std::string& value, const std::vector<std::string>& known) {
  impl_->app.add_option(name, value)->check(CLI::IsMember(known))->capture_default_str();
}

void Options::choices(const char* name, std::vector<std::string>& values,
                      const std::vector<std::string>& known) {
  impl_->app.add_option(name, values)->check(CLI::IsMember(known));
}

void Options::parsed(const char* name, const char* help,
                     std::function<Result<void>(const std::string&)> read) {
  impl_->app.add_option_function<std::string>(
      name,
      [name = std::string(name), read = std::move(read)](const std::string& text) {
        const auto done = read(text);
        if (!done) throw CLI::ValidationError(name, done.error().message());
      },
      help);
}

void Options::size(PictureSize& size) {
  parsed("--size", "WxH, pixels", [&size](const std::string& text) {
    return parse_size(text, 32768).map([&](PictureSize read) { size = read; });
  });
}

void Options::camera(CameraChoice& choice) {
  parsed("--look-at", "ex,ey,ez,tx,ty,tz: eye and target", [&choice](const std::string& text) {
    return parse_look_at(text).map([&](const auto& read) { choice.look_at = read; });
  });
  impl_->app.add_option("--fov", choice.fov_y_deg, "vertical field of view, degrees");
}

void Options::exposure(ExposureChoice& choice) {
  const auto add = [&](const char* name, double& value, double lo, double hi, const char* help) {
    impl_->app.add_option(name, value, help)->check(CLI::Range(lo, hi));
  };
  add("--f-stop", choice.f_stop, Lens::smallest_f_stop, Lens::largest_f_stop, "f-number");
  add("--focus", choice.focus, 1e-6, 1e15, "distance of the focus plane");
  number("--animation", choice.animation, 0, 10'000, "number of the animation");
  add("--time", choice.seconds, 0.0, 1e6, "seconds of the animation");
  add("--shutter", choice.shutter_seconds, 0.0, ShutterSettings::longest,
      "seconds that the shutter is open");
}

std::optional<int> Options::end(int argc, char** argv) {
  try {
    impl_->app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return impl_->app.exit(error);
  }
  return std::nullopt;
}

}  // namespace asos::bench
