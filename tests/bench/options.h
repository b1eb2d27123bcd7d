#pragma once

#include "app/camera_choice.h"
#include "renderer/result.h"
#include "tests/bench/bench_support.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asos::bench {

/// A benchmark's command line. Hides CLI11, which takes longer to compile than the benchmarks.
class Options {
 public:
  explicit Options(const char* description);
  ~Options();
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;

  /// Names that begin with a dash are options, others are arguments. Bound variables must outlive
  /// `end`.
  void flag(const char* name, bool& value, const char* help = "");
  void number(const char* name, int& value, int lo, int hi, const char* help = "");
  void text(const char* name, std::string& value, const char* help = "");
  void texts(const char* name, std::vector<std::string>& values, const char* help = "");
  void choice(const char* name, std::string& value, const std::vector<std::string>& known);
  void choices(const char* name, std::vector<std::string>& values,
               const std::vector<std::string>& known);
  /// `read` returns an error for texts that it cannot parse.
  void parsed(const char* name, const char* help,
              std::function<Result<void>(const std::string&)> read);
  /// --size WxH.
  void size(PictureSize& size);
  /// --look-at and --fov.
  void camera(CameraChoice& choice);
  /// --f-stop, --focus, --animation, --time and --shutter.
  void exposure(ExposureChoice& choice);

  /// Parses the command line. Returns an exit code if the program is to end, as after --help.
  [[nodiscard]] std::optional<int> end(int argc, char** argv);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace asos::bench
