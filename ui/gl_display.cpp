#include "ui/gl_display.h"

#include "ui/error_map.h"
#include "ui/shader_sources.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asos::ui {

using namespace gl;

namespace {

// Side of the cells that are uploaded as a whole, in pixels. A burst of small tiles then takes few
// calls, and one tile does not upload the whole picture.
constexpr int cell_side = 64;

// Colour of the hatching where the split map has no final pixel.
constexpr glm::u8vec4 hatching{96, 96, 96, 255};
constexpr int hatching_pitch = 12;

constexpr glm::u8vec3 wireframe_colour{255, 150, 40};
constexpr float wireframe_opacity = 0.85f;

// The picture's brightness in place of its error until there is a reference.
constexpr float brightness_without_reference = 0.35f;

bool on_hatching(int x, int y) {
  return (x + y) % hatching_pitch == 0;
}

/// Blends pixels that surfaces do not fully cover with a checkerboard.
glm::vec3 before_checkers(const Film& film, std::size_t i) {
  const glm::vec3 radiance = film.radiance[i];
  if (film.coverage.empty() || !(film.coverage[i] < 1.0f)) return radiance;
  constexpr std::size_t side = 8;  // of a square, in pixels
  const auto width = static_cast<std::size_t>(film.width);
  const bool pale = (i % width / side + i / width / side) % 2 == 0;
  return radiance + (1.0f - film.coverage[i]) * glm::vec3(pale ? 0.4f : 0.25f);
}

}  // namespace

Result<GlDisplay> GlDisplay::make() {
  Result<Program> picture = make_program(shader_source::display_vert, shader_source::display_frag);
  if (!picture) return unexpected(picture.error());
  Result<Program> overlay = make_program(shader_source::display_vert, shader_source::overlay_frag);
  if (!overlay) return unexpected(overlay.error());
  return GlDisplay(std::move(*picture), std::move(*overlay));
}

GlDisplay::GlDisplay(Program picture, Program overlay)
    : picture_program_(std::move(picture)),
      overlay_program_(std::move(overlay)),
      no_attributes_(make_vertex_array()) {}

void GlDisplay::update(const Film& film, std::span<const PixelRect> changed,
                       const DisplaySettings& display, std::uint64_t map_revision) {
  const PixelRect whole{0, 0, film.width, film.height};
  if (whole.empty()) return;

  // Layers whose size, exposure or split map scale has changed are converted as a whole.
  const bool resized = film.width != width_ || film.height != height_;
  const bool exposed = display.transform() != shown_;
  const bool rescaled = map_revision != map_revision_ || display.split_colours != split_colours_;
  if (exposed) {
    shown_ = display.transform();
    // Tone curves mix the channels, so the table replaces only the last step, the sRGB encoding.
    tone_ = ToneTable(shown_.tone == ToneCurve::none ? shown_.exposure_ev : 0.0f);
  }
  map_revision_ = map_revision;
  split_colours_ = display.split_colours;
  if (resized) {
    width_ = film.width;
    height_ = film.height;
    picture_.resize(width_, height_);
    overlay_.resize(width_, height_);
  }
  const bool all_picture = resized || exposed, all_overlay = resized || rescaled;
  if (all_picture || all_overlay) convert(film, whole, all_picture, all_overlay);

  for (const PixelRect& rect : changed) {
    const PixelRect inside = intersection(rect, whole);
    if (!inside.empty()) convert(film, inside, !all_picture, !all_overlay);
  }
  picture_.upload();
  if (display.show_split_map) overlay_.upload();
}

glm::u8vec3 GlDisplay::bytes_of(const Film& film, std::size_t i) const {
  const glm::vec3 radiance = before_checkers(film, i);
  if (film.unlit.empty() || !(film.unlit[i].w > 0.0f)) return bytes_of(radiance);
  return display_bytes(tone_mapped(radiance, film.unlit[i], shown_), 0.0f);
}

void GlDisplay::convert(const Film& film, const PixelRect& rect, bool picture, bool overlay) {
  if (overlay) convert_overlay(film, rect);
  if (!picture) return;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    const std::size_t row = film.index(rect.x, y);
    for (std::size_t i = row; i < row + static_cast<std::size_t>(rect.width); ++i)
      picture_.at(i) = glm::u8vec4(bytes_of(film, i), 255);
  }
  picture_.mark(rect);
}

void GlDisplay::convert_overlay(const Film& film, const PixelRect& rect) {
  // Split pixels hide the picture, so that their colours match the legend; the others only dim it.
  const SplitMapKey key{split_colours_};
  const std::size_t last = key.last();
  std::array<glm::u8vec4, 256> colours;
  for (std::size_t i = 0; i <= last; ++i)
    colours[i] = glm::u8vec4(key.colour(static_cast<std::uint8_t>(i)), i > 0 ? 255 : 0);
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    const std::size_t row = film.index(rect.x, y);
    for (std::size_t i = row; i < row + static_cast<std::size_t>(rect.width); ++i) {
      overlay_.at(i) = colours[std::min<std::size_t>(key.value(film, i), last)];
      const int x = rect.x + static_cast<int>(i - row);
      if (!film.unfinished.empty() && film.unfinished[i] && on_hatching(x, y))
        overlay_.at(i) = hatching;
    }
  }
  overlay_.mark(rect);
}

void GlDisplay::update_compared(const Film& film, std::span<const PixelRect> changed,
                                Frames& frames) {
  const std::optional<int> index = frames.compared();
  if (film.width <= 0 || (!index && frames.comparison != Comparison::error)) {
    compared_ = {};
    return;
  }
  const glm::ivec2 size(film.width, film.height);
  const Film* other = index ? &frames.at_size(*index, size) : nullptr;
  const Compared wanted{
      index == Frames::the_reference ? frames.reference.revision : frames.revision,
      index,
      frames.comparison,
      frames.scale_stops,
      shown_,
      size};
  const PixelRect whole{0, 0, size.x, size.y};
  if (wanted != compared_) {
    if (wanted.size != compared_.size) compared_layer_.resize(size.x, size.y);
    compared_ = wanted;
    convert_compared(film, other, whole);
  } else {
    for (const PixelRect& rect : changed) {
      const PixelRect inside = intersection(rect, whole);
      if (!inside.empty()) convert_compared(film, other, inside);
    }
  }
  compared_layer_.upload();
}

glm::u8vec3 GlDisplay::compared_colour(const Film& film, const Film* other, std::size_t i) const {
  if (!other) return glm::u8vec3(brightness_without_reference * glm::vec3(bytes_of(film, i)));
  if (compared_.comparison == Comparison::error)
    return heat_colour(ErrorScale::share(error_steps(film, *other, i, compared_.shown)));
  if (compared_.comparison == Comparison::difference)
    return heat_colour(std::exp2(-compared_.scale_stops) *
                       difference_of(*other, film, i, compared_.shown));
  return bytes_of(*other, i);
}

void GlDisplay::convert_compared(const Film& film, const Film* other, const PixelRect& rect) {
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    const std::size_t row = film.index(rect.x, y);
    for (std::size_t i = row; i < row + static_cast<std::size_t>(rect.width); ++i)
      compared_layer_.at(i) = glm::u8vec4(compared_colour(film, other, i), 255);
  }
  compared_layer_.mark(rect);
}

void GlDisplay::show_wireframe(const SurfacePicture* surfaces, std::uint64_t revision) {
  shows_wireframe_ = surfaces && surfaces->film.width == width_ && surfaces->film.height == height_;
  if (!shows_wireframe_) {
    wireframe_revision_ = 0;
    return;
  }
  if (std::exchange(wireframe_revision_, revision) == revision) return;
  wireframe_.resize(width_, height_);
  for (std::size_t i = 0; i < surfaces->wireframe.size(); ++i) {
    const float opacity = wireframe_opacity * surfaces->wireframe[i];
    wireframe_.at(i) = glm::u8vec4(wireframe_colour, std::lround(255.0f * opacity));
  }
  wireframe_.upload();
}

void GlDisplay::draw(const PictureView& view, const Target& target, const DisplaySettings& display,
                     const Frames& frames) const {
  const PixelRect& area = target.area;
  if (area.empty() || width_ <= 0 || view.scale() <= 0.0f) return;

  // Clip coordinates of the picture within the area; OpenGL's y axis points up.
  const glm::vec2 size(static_cast<float>(area.width), static_cast<float>(area.height));
  const glm::vec2 picture(static_cast<float>(width_), static_cast<float>(height_));
  const glm::vec2 lo = view.offset() / size, hi = (view.offset() + picture * view.scale()) / size;
  const glm::vec4 clip_rect(2.0f * lo.x - 1.0f, 1.0f - 2.0f * lo.y, 2.0f * hi.x - 1.0f,
                            1.0f - 2.0f * hi.y);
  const bool magnified = view.scale() >= 1.0f;

  glViewport(area.x, target.framebuffer_height - area.y - area.height, area.width, area.height);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  draw_layer(picture_program_, picture_, clip_rect, magnified);
  if (display.show_split_map) draw_over(overlay_, display.split_dimming, clip_rect, magnified);
  if (shows_wireframe_) draw_over(wireframe_, 0.0f, clip_rect, magnified);
  if (compared_ == Compared{} || (frames.comparison != Comparison::wipe && !frames.cover_picture()))
    return;
  if (frames.comparison == Comparison::wipe) {
    const float left = view.offset().x + frames.wipe * picture.x * view.scale();
    const int first = std::clamp(static_cast<int>(std::round(left)), 0, area.width);
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x + first, target.framebuffer_height - area.y - area.height, area.width - first,
              area.height);
  }
  draw_layer(picture_program_, compared_layer_, clip_rect, magnified);
  glDisable(GL_SCISSOR_TEST);
}

void GlDisplay::draw_over(const Layer& layer, float dimming, const glm::vec4& clip_rect,
                          bool magnified) const {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glUseProgram(overlay_program_.name());
  glUniform1f(glGetUniformLocation(overlay_program_.name(), "dimming"), dimming);
  draw_layer(overlay_program_, layer, clip_rect, magnified);
  glDisable(GL_BLEND);
}

void GlDisplay::draw_layer(const Program& program, const Layer& layer, const glm::vec4& clip_rect,
                           bool magnified) const {
  glUseProgram(program.name());
  glUniform4f(glGetUniformLocation(program.name(), "rect"), clip_rect.x, clip_rect.y, clip_rect.z,
              clip_rect.w);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, layer.texture().name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, magnified ? GL_NEAREST : GL_LINEAR);
  glBindVertexArray(no_attributes_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
}

std::vector<std::uint8_t> GlDisplay::seen_rgb(const DisplaySettings& display) const {
  const std::size_t count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    glm::vec3 seen(picture_.at(i));
    if (display.show_split_map) {
      const glm::u8vec4 over = overlay_.at(i);
      const float hidden = over.a > 0 ? 1.0f : display.split_dimming;
      seen = glm::mix(seen, glm::vec3(over), hidden) + 0.5f;
    }
    if (shows_wireframe_) {
      const glm::u8vec4 line = wireframe_.at(i);
      seen = glm::mix(seen, glm::vec3(line), static_cast<float>(line.a) / 255.0f) + 0.5f;
    }
    for (int channel = 0; channel < 3; ++channel) {
      rgb.push_back(static_cast<std::uint8_t>(seen[channel]));
    }
  }
  return rgb;
}

void GlDisplay::Layer::resize(int width, int height) {
  width_ = width;
  height_ = height;
  columns_ = (width + cell_side - 1) / cell_side;
  const int rows = (height + cell_side - 1) / cell_side;
  pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                 glm::u8vec4(0, 0, 0, 255));
  stale_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows), 1);
  texture_ = make_rgba8_texture(width, height);
}

void GlDisplay::Layer::mark(const PixelRect& rect) {
  for (int row = rect.y / cell_side; row <= (rect.y + rect.height - 1) / cell_side; ++row) {
    for (int column = rect.x / cell_side; column <= (rect.x + rect.width - 1) / cell_side;
         ++column) {
      stale_[static_cast<std::size_t>(row * columns_ + column)] = 1;
    }
  }
}

// Uploads neighbouring stale cells of a row in one call.
void GlDisplay::Layer::upload() {
  if (columns_ == 0) return;
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glPixelStorei(GL_UNPACK_ROW_LENGTH, width_);
  const int rows = static_cast<int>(stale_.size()) / columns_;
  for (int row = 0; row < rows; ++row) {
    std::uint8_t* stale = &stale_[static_cast<std::size_t>(row * columns_)];
    for (int begin = 0; begin < columns_; ++begin) {
      if (!stale[begin]) continue;
      int end = begin;
      while (end < columns_ && stale[end]) stale[end++] = 0;
      const PixelRect part =
          intersection({begin * cell_side, row * cell_side, (end - begin) * cell_side, cell_side},
                       {0, 0, width_, height_});
      glTexSubImage2D(GL_TEXTURE_2D, 0, part.x, part.y, part.width, part.height, GL_RGBA,
                      GL_UNSIGNED_BYTE,
                      &pixels_[static_cast<std::size_t>(part.y) * static_cast<std::size_t>(width_) +
                               static_cast<std::size_t>(part.x)]);
      begin = end;
    }
  }
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

}  // namespace asos::ui
