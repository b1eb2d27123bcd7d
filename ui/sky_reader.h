#pragma once

#include "renderer/result.h"
#include "renderer/shading/sky.h"
#include "ui/latest_job.h"

#include <memory>
#include <optional>
#include <string>

namespace asos {

/// Reads pictures of skies on a thread of its own; a newer request replaces an older one.
class SkyReader {
 public:
  using Outcome = Result<std::shared_ptr<const Sky>>;

  SkyReader()
      : job_([](const std::string& path) { return read_sky(path); }, {}, Overtaken::dropped) {}

  void read(std::string path) { job_.ask(std::move(path)); }
  /// The outcome of the newest request, once.
  [[nodiscard]] std::optional<Outcome> take_outcome() { return job_.take_outcome(); }
  [[nodiscard]] bool busy() const { return job_.pending(); }

 private:
  LatestJob<std::string, Outcome> job_;
};

}  // namespace asos
