#pragma once

#include "renderer/result.h"
#include "renderer/shading/sky.h"
#include "renderer/shading/sky_warning.h"
#include "ui/latest_job.h"

#include <memory>
#include <optional>
#include <string>

namespace asos::ui {

/// Reads sky images on its own thread; a newer request replaces an older one.
class SkyReader {
 public:
  struct Outcome {
    Result<std::shared_ptr<const Sky>> sky;
    std::string remark;  ///< see sky_warning
  };

  SkyReader()
      : job_(
            [](const std::string& path) {
              return Outcome{read_sky(path), sky_warning(path)};
            },
            {}, Overtaken::dropped) {}

  void read(std::string path) { job_.ask(std::move(path)); }
  /// Returns the outcome of the newest request, once.
  [[nodiscard]] std::optional<Outcome> take_outcome() { return job_.take_outcome(); }
  [[nodiscard]] bool busy() const { return job_.pending(); }

 private:
  LatestJob<std::string, Outcome> job_;
};

}  // namespace asos::ui
