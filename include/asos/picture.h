#pragma once

#include "asos/error.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace asos::api {

struct LayerInfo {
  std::string name = {};  ///< "beauty", "alpha", "level", "cause", "rays" or "time"
  int channels = 1;
  std::string unit = {};  ///< "radiance", "share of the pixel", "level", "number", "rays" or "s"
};

/// One value, or several, for each pixel.
struct Layer {
  LayerInfo info = {};
  int width = 0;
  int height = 0;
  std::vector<float> values = {};  ///< channels * width * height, row by row from the top left
};

struct SaveOptions {
  float exposure_ev = 0.0f;  ///< stops; .png only
};

/// A rendered picture, or the crop's part of it: an immutable handle that is cheap to copy. All
/// members may be called from any thread at once. A handle that was moved from may only be
/// destroyed or assigned.
class ASOS_API Picture {
 public:
  struct Impl;
  explicit Picture(std::shared_ptr<const Impl> impl);  ///< made by `render` and `Session`
  Picture(const Picture&);
  Picture(Picture&&) noexcept;
  Picture& operator=(const Picture&);
  Picture& operator=(Picture&&) noexcept;
  ~Picture();

  [[nodiscard]] int width() const;   ///< pixels
  [[nodiscard]] int height() const;  ///< pixels
  /// Whether every pixel is final; false after a time limit, or while a session renders.
  [[nodiscard]] bool finished() const;
  [[nodiscard]] double seconds() const;      ///< of rendering, without preparation
  [[nodiscard]] std::uint64_t rays() const;  ///< of all kinds

  /// The layers that the picture has.
  [[nodiscard]] std::vector<LayerInfo> layers() const;
  /// Copies a layer. Fails with `invalid_argument` where there is none of this name.
  [[nodiscard]] Result<Layer> layer(const std::string& name) const;

  /// Writes display values (.png) or linear radiance (.exr), by the path's extension. The file is
  /// replaced once it is complete. For a scene from a file, the picture contains its settings and
  /// `asos render --from` renders it again. Fails with `cannot_write`, or with `invalid_argument`
  /// for another extension.
  [[nodiscard]] Result<void> save(const std::string& path, const SaveOptions& options = {}) const;

 private:
  std::shared_ptr<const Impl> impl_;
};

/// Returns the name of a number of layer "cause": why the pixel is split. Empty: no such number.
/// Any thread.
[[nodiscard]] ASOS_API std::string cause_name(int cause);

}  // namespace asos::api
