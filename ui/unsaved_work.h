#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace asos::ui {

class PictureJob;
class Previewer;
struct Frames;

/// Determines which of the user's work would be lost by closing the window. Saving a
/// picture keeps edits of lights, defocusing ratios (DFRs) and sky, because its metadata hold
/// them. Exporting the scene keeps edits of lights and DFRs. Not thread-safe.
class UnsavedWork {
 public:
  /// Call once a frame. Values that a scene was opened with are not edits.
  void update(const Previewer& previewer);
  /// Call when a picture with the current edits was saved.
  void note_saved(const Previewer& previewer);
  /// Call when the scene was saved with its lights and DFRs.
  void note_exported(const Previewer& previewer);

  /// The edits that closing the scene loses, one per line; empty: none.
  [[nodiscard]] std::vector<std::string> edits(const Previewer& previewer) const;
  /// The work that closing the window loses, one per line; empty: none.
  [[nodiscard]] std::vector<std::string> lines(const Previewer& previewer, const Frames& frames,
                                               const PictureJob& saving) const;

 private:
  struct Edits {
    std::uint64_t lights = 0;  // revisions
    std::uint64_t dfrs = 0;
    const void* sky = nullptr;
  };
  [[nodiscard]] static Edits edits_of(const Previewer& previewer);

  std::uint64_t scene_ = 0;
  Edits saved_;
};

}  // namespace asos::ui
