#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace asos::ui {

class PictureJob;
class Previewer;
struct Frames;

/// Knows what of a person's work would be lost if the window closed. Edits of lights, of mirrors'
/// blur and of the sky count until a picture is saved, which holds them. One thread.
class UnsavedWork {
 public:
  /// Call once a frame: what a scene came with is no edit.
  void update(const Previewer& previewer);
  /// A picture was saved, with the edits as they are.
  void note_saved(const Previewer& previewer);
  /// The scene was saved with its lights and DFRs.
  void note_exported(const Previewer& previewer);

  /// The edits that end with the scene, a line each; empty: none.
  [[nodiscard]] std::vector<std::string> edits(const Previewer& previewer) const;
  /// The work that closing the window would lose, one line each; empty: none.
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
