#pragma once

#include "asos/error.h"
#include "asos/settings.h"
#include "asos/types.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asos::api {

struct LayerInfo {
  std::string name = {};  ///< one of `layer_list`
  int channels = 1;
  std::string unit = {};   ///< "linear radiance", "m", "1" (a ratio), ...
  std::string about = {};  ///< a sentence for the user
  bool ids = false;        ///< its values are numbers of objects or materials
};

/// Returns all layers. Every picture has "beauty", "level", "cause", "rays" and "time", and "alpha"
/// with a transparent background; Settings::layers asks for others. Any thread.
[[nodiscard]] ASOS_API std::vector<LayerInfo> layer_list();

/// One value, or several, for each pixel.
struct Layer {
  LayerInfo info = {};
  int width = 0;
  int height = 0;
  std::vector<float> values = {};  ///< channels * width * height, row by row from the top left
};

/// A layer's values where the picture stores them.
struct LayerView {
  LayerInfo info = {};
  int width = 0;
  int height = 0;
  std::span<const float> values = {};  ///< as in Layer
};

/// A part of a pixel that shows one object or material.
struct IdShare {
  std::uint32_t pixel = 0;  ///< y * width + x
  std::int32_t id = -1;     ///< index of its name in `Picture::id_names`; -1: the background
  float share = 0.0f;       ///< of the pixel's area, above 0 to 1
};

struct SaveOptions {
  float exposure_ev = 0.0f;       ///< stops; .png only
  std::optional<Tone> tone = {};  ///< of .png files; none: the settings' own
};

/// What a map of the splits shows.
enum class SplitMapKind { level, cause, rays, time };

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
  /// Copies a layer. A layer of ids has the id with the largest share of each pixel; -1: the
  /// background. Fails with `invalid_argument` where there is none of this name.
  [[nodiscard]] Result<Layer> layer(const std::string& name) const;
  /// Returns a layer without a copy, valid as long as a handle of the picture exists. Fails with
  /// `invalid_argument` as `layer` does, and for "level", "cause" and ids, which are not stored as
  /// floats.
  [[nodiscard]] Result<LayerView> view(const std::string& name) const;
  /// Returns all shares of a layer of ids ("object" or "material"), pixel by pixel, the largest
  /// first. Fails with `invalid_argument` where there is no such layer.
  [[nodiscard]] Result<std::vector<IdShare>> id_shares(const std::string& name) const;
  /// Returns the names of its ids; some may be empty. Fails as `id_shares` does.
  [[nodiscard]] Result<std::vector<std::string>> id_names(const std::string& name) const;
  /// Predicts layer "level" for another EPS (0 to 1) and MAX (0 to 8), from what this render found:
  /// 20 ns a pixel. Fails with `invalid_argument` for values out of range, and for pictures by
  /// other methods than ASOS.
  [[nodiscard]] Result<Layer> predicted_level(double eps, int max_level) const;

  /// Writes display values (.png) or linear radiance (.exr), by the path's extension. The file is
  /// replaced once it is complete. For a scene from a file, the picture contains its settings and
  /// `asos render --from` renders it again. Fails with `cannot_write`, or with `invalid_argument`
  /// for another extension.
  /// An .exr contains the layers of Settings::layers, too; ids as Cryptomatte.
  [[nodiscard]] Result<void> save(const std::string& path, const SaveOptions& options = {}) const;
  /// Writes a map of the splits as the window shows it (.png). Fails as `save` does.
  [[nodiscard]] Result<void> save_split_map(const std::string& path,
                                            SplitMapKind kind = SplitMapKind::level) const;

  [[nodiscard]] const Impl& impl() const { return *impl_; }  ///< for the library itself

 private:
  std::shared_ptr<const Impl> impl_;
};

/// How far two pictures differ. Values are linear and clipped to 0 to 1, as a display does it,
/// where nothing else is said. A pixel's own error is the root mean square of its channels.
struct Difference {
  double rmse = 0.0;     ///< root mean square over pixels and channels
  double psnr_db = 0.0;  ///< for a peak of 1; infinite for equal pictures
  double mean_absolute = 0.0;
  double p99 = 0.0;           ///< 99th percentile of the pixels' errors
  double worst = 0.0;         ///< the largest pixel's error
  double rmse_display = 0.0;  ///< root mean square after the sRGB curve
  double delta_e = 0.0;       ///< mean CIEDE2000
};

/// Compares a picture with a reference, such as one of many samples. Any thread. Fails with
/// `invalid_argument` where their sizes differ.
[[nodiscard]] ASOS_API Result<Difference> compare(const Picture& picture, const Picture& reference);

/// Returns the name of a number of layer "cause": why the pixel is split. Empty: no such number.
/// Any thread.
[[nodiscard]] ASOS_API std::string cause_name(int cause);

}  // namespace asos::api
