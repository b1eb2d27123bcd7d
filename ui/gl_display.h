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

/// Shows a film in the current OpenGL context: display bytes and split map as two RGBA8 textures.
/// Tone mapping runs on the processor for changed pixels only, and only cells that changed are
/// uploaded. One thread, one context.
class GlDisplay {
 public:
  /// The error holds the driver's message.
  [[nodiscard]] static Result<GlDisplay> make();

  /// Brings the textures up to date with `film`, of which `changed` is what differs from the last
  /// call. Another size, exposure, `map_revision` or choice of the split map's colours renews
  /// everything that depends on it.
  void update(const Film& film, std::span<const PixelRect> changed, const DisplaySettings& display,
              std::uint64_t map_revision);
  /// The same for what is compared with `film`; after `update`. A stored frame of another size is
  /// resampled.
  void update_compared(const Film& film, std::span<const PixelRect> changed, Frames& frames);

  /// Draws the wireframe of `surfaces` over the picture from now on, where it has the picture's
  /// size; null: none. `revision` grows with each new picture of surfaces.
  void show_wireframe(const SurfacePicture* surfaces, std::uint64_t revision);
  /// The same for the error of each pixel against `reference`, of the film's size or null: none is
  /// shown. `revision` counts the references.
  void update_error(const Film& film, std::span<const PixelRect> changed, const Film* reference,
                    std::uint64_t revision);

  /// Where to draw: `area` in framebuffer pixels from the top left of a framebuffer that is
  /// `framebuffer_height` high.
  struct Target {
    PixelRect area;
    int framebuffer_height = 0;
  };
  /// Draws the picture, and the split map over it where `display` shows it. Nothing is drawn
  /// outside the area, nor in it before the first update.
  void draw(const PictureView& view, const Target& target, const DisplaySettings& display,
            const Frames& frames) const;

  /// The picture as it is shown, row-major RGB bytes from the top left: the screenshot.
  [[nodiscard]] std::vector<std::uint8_t> seen_rgb(const DisplaySettings& display) const;
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  /// One texture with its copy in memory, and which cells of it are out of date.
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
  /// Blends a layer over what is there; where its alpha is 0 it darkens that by `dimming`.
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
    int chosen = -1;
    bool difference = false;
    float scale_stops = 0.0f;
    DisplayTransform shown;
    glm::ivec2 size{0};
    bool operator==(const Compared&) const = default;
  };
  /// The bytes that show a radiance.
  [[nodiscard]] glm::u8vec3 bytes_of(glm::vec3 radiance) const {
    return tone_.bytes(shown_.tone == ToneCurve::none ? radiance : tone_mapped(radiance, shown_));
  }
  [[nodiscard]] glm::u8vec3 bytes_of(const Film& film, std::size_t i) const;
  void convert_compared(const Film& film, const Film& stored, const PixelRect& rect);
  Compared compared_;
  Layer compared_layer_;
  Layer wireframe_;
  std::uint64_t wireframe_revision_ = 0;
  bool shows_wireframe_ = false;

  struct ErrorShown {
    std::uint64_t revision = 0;
    DisplayTransform shown;
    glm::ivec2 size{0};
    bool operator==(const ErrorShown&) const = default;
  };
  void convert_error(const Film& film, const Film& reference, const PixelRect& rect);
  std::optional<ErrorShown> error_;  // none: not shown
  Layer error_layer_;
};

}  // namespace asos::ui
