#pragma once

#include <cstdint>
#include <optional>
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
  /// The edits of an opened scene at one time.
  struct Edits {
    std::uint64_t scene = 0;             // OpenScene::times_opened
    std::uint64_t lights = 0, dfrs = 0;  // revisions
    const void* sky = nullptr;
  };
  [[nodiscard]] static Edits edits_of(const Previewer& previewer);
  /// The edits that the rendered picture has; none: it lacks the newest.
  [[nodiscard]] static std::optional<Edits> in_picture(const Previewer& previewer);

  /// Call once a frame. Values that a scene was opened with are not edits.
  void update(const Previewer& previewer);
  /// Call when a picture with these edits was saved. Later edits stay unsaved.
  void note_saved(const Edits& edits);
  /// Call when the scene was saved with these lights and DFRs.
  void note_exported(const Edits& edits);

  /// The edits that closing the scene loses, one per line; empty: none.
  [[nodiscard]] std::vector<std::string> edits(const Previewer& previewer) const;
  /// The work that closing the window loses, one per line; empty: none.
  [[nodiscard]] std::vector<std::string> lines(const Previewer& previewer, const Frames& frames,
                                               const PictureJob& saving) const;

 private:
  Edits saved_;
};

}  // namespace asos::ui
