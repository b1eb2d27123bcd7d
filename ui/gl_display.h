#pragma once

#include "renderer/film/film.h"
#include "renderer/result.h"
#include "renderer/samples/surface_view.h"
#include "ui/display_settings.h"
#include "ui/frames.h"
#include "ui/gl/gl_objects.h"
#include "ui/picture_view.h"
#include "ui/tone_table.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos::ui {

/// Shows a film in the current OpenGL context, with its display bytes and its split map as two
/// RGBA8 textures. Tone mapping runs on the CPU for changed pixels only, and only changed cells are
/// uploaded. One thread, one context.
class GlDisplay {
 public:
  /// The error is the driver's message.
  [[nodiscard]] static Result<GlDisplay> make();

  /// Updates the textures from `film`; `changed` are the areas that differ from the last call.
  /// Another size, exposure, `map_revision` or set of split colours updates everything that depends
  /// on it.
  void update(const Film& film, std::span<const PixelRect> changed, const DisplaySettings& display,
              std::uint64_t map_revision);
  /// Updates the comparison with `film`; call after `update`. A picture of another size is
  /// resampled. The error dims the picture until there is a reference.
  void update_compared(const Film& film, std::span<const PixelRect> changed, Frames& frames);

  /// From now on draws the wireframe of `surfaces` over the picture, if it has the picture's size;
  /// null: none. `revision` grows with each new picture of surfaces.
  void show_wireframe(const SurfacePicture* surfaces, std::uint64_t revision);

  /// Where to draw: `area` is in framebuffer pixels from the top left of a framebuffer of
  /// `framebuffer_height` pixels.
  struct Target {
    PixelRect area;
    int framebuffer_height = 0;
  };
  /// Draws the picture, with the split map over it if `display` shows it. Draws nothing outside the
  /// area, and nothing at all before the first update.
  void draw(const PictureView& view, const Target& target, const DisplaySettings& display,
            const Frames& frames) const;

  /// The displayed picture as row-major RGB bytes from the top left, for screenshots.
  [[nodiscard]] std::vector<std::uint8_t> seen_rgb(const DisplaySettings& display) const;
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  /// A texture with its copy in memory and flags for the cells to upload.
  class Layer {
   public:
    void resize(int width, int height);
    void mark(const PixelRect& rect);
    void upload();
    [[nodiscard]] glm::u8vec4& at(std::size_t index) { return pixels_[index]; }
    [[nodiscard]] glm::u8vec4 at(std::size_t index) const { return pixels_[index]; }
    [[nodiscard]] const gl::Texture& texture() const { return texture_; }

   private:
    int width_ = 0, height_ = 0;
    int columns_ = 0;  // of cells
    std::vector<glm::u8vec4> pixels_;
    std::vector<std::uint8_t> stale_;  // by cell
    gl::Texture texture_;
  };

  GlDisplay(gl::Program picture, gl::Program overlay);
  void convert(const Film& film, const PixelRect& rect, bool picture, bool overlay);
  void convert_overlay(const Film& film, const PixelRect& rect);
  /// Blends a layer over the framebuffer. Where the layer's alpha is 0 it darkens by `dimming`.
  void draw_over(const Layer& layer, float dimming, const glm::vec4& clip_rect,
                 bool magnified) const;
  void draw_layer(const gl::Program& program, const Layer& layer, const glm::vec4& clip_rect,
                  bool magnified) const;

  gl::Program picture_program_;
  gl::Program overlay_program_;
  gl::VertexArray no_attributes_;
  int width_ = 0;
  int height_ = 0;
  std::uint64_t map_revision_ = 0;
  SplitMapColours split_colours_ = SplitMapColours::level;
  DisplayTransform shown_;
  ToneTable tone_;
  Layer picture_;
  Layer overlay_;

  // The inputs that the compared layer was made from.
  struct Compared {
    std::uint64_t revision = 0;
    std::optional<int> index;  ///< see Frames::compared
    Comparison comparison = Comparison::none;
    float scale_stops = 0.0f;
    DisplayTransform shown;
    glm::ivec2 size{0};
    bool operator==(const Compared&) const = default;
  };
  /// The display bytes of a radiance.
  [[nodiscard]] glm::u8vec3 bytes_of(glm::vec3 radiance) const {
    return tone_.bytes(shown_.tone == ToneCurve::none ? radiance : tone_mapped(radiance, shown_));
  }
  [[nodiscard]] glm::u8vec3 bytes_of(const Film& film, std::size_t i) const;
  /// `other`: null: it is not known yet.
  [[nodiscard]] glm::u8vec3 compared_colour(const Film& film, const Film* other,
                                            std::size_t i) const;
  void convert_compared(const Film& film, const Film* other, const PixelRect& rect);
  Compared compared_;
  Layer compared_layer_;
  Layer wireframe_;
  std::uint64_t wireframe_revision_ = 0;
  bool shows_wireframe_ = false;
};

}  // namespace asos::ui
