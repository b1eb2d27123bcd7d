#include "ui/panels/section_help.h"

#include "ui/panels/sketch.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asos::ui {

namespace {

using Ink = Sketch::Ink;

constexpr std::array sketched{
    SketchedPixel{0, 0},
    SketchedPixel{1, 0},
    SketchedPixel{5, 3},
};

// Sketches a pixel without an edge, one that an edge cuts, and one split by many edges.
void antialiasing(const Sketch& s) {
  float left = 1.0f;
  for (const SketchedPixel& pixel : sketched) {
    const glm::vec2 lo(left, 1.0f);
    const auto at = [&](float x, float y) { return lo + glm::vec2(x, y); };
    // Strips that meet in one corner, or a single large part.
    for (int i = 0; i < pixel.edges / 2; ++i) {
      const float y = 0.6f + 1.2f * static_cast<float>(i);
      s.shape({at(3.9f, 0.1f), at(0.0f, y), at(0.0f, y + 0.6f)}, Ink::warm, 0.6f);
    }
    if (pixel.edges % 2 == 1)
      s.shape(
          {at(0.0f, 3.2f), at(4.0f, pixel.edges > 1 ? 2.6f : 1.2f), at(4.0f, 4.0f), at(0.0f, 4.0f)},
          Ink::warm, 0.6f);
    s.split_square(lo, 4.0f, at(3.5f, 0.4f), pixel.levels);
    // Draw a sample in each part of an unsplit pixel.
    if (pixel.levels == 0) s.disc(at(1.4f, pixel.edges > 0 ? 1.1f : 2.0f), 0.2f, Ink::plain);
    if (pixel.levels == 0 && pixel.edges > 0) s.disc(at(2.3f, 3.0f), 0.2f, Ink::plain);
    left += 5.0f;
  }
}

// Sketches three passes, each finer than the last.
void refinement(const Sketch& s) {
  for (int pass = 0; pass < 3; ++pass) {
    const glm::vec2 lo(1.0f + 5.0f * static_cast<float>(pass), 1.0f);
    const int cells = 2 << pass;
    const float side = 4.0f / static_cast<float>(cells);
    for (int y = 0; y < cells; ++y) {
      for (int x = 0; x < cells; ++x) {
        const glm::vec2 cell = lo + side * glm::vec2(x, y);
        const bool inside = glm::distance(cell + 0.5f * side, lo + 2.0f) < 1.6f;
        s.filled(cell, cell + side, inside ? Ink::accent : Ink::faint);
      }
    }
  }
}

void animation(const Sketch& s) {
  for (int i = 0; i < 5; ++i) {
    const float x = 2.0f + 2.9f * static_cast<float>(i);
    s.disc({x, 3.2f - 1.8f * std::sin(0.9f * static_cast<float>(i))}, 0.6f, Ink::accent,
           0.25f + 0.15f * static_cast<float>(i));
    s.line({x, 5.2f}, {x, 5.6f}, Ink::dim);
  }
  s.line({1.2f, 5.4f}, {14.8f, 5.4f}, Ink::dim);
}

void scenes(const Sketch& s) {
  for (int i = 0; i < 3; ++i) {
    const glm::vec2 lo(3.0f + 2.6f * static_cast<float>(i), 0.8f + 0.7f * static_cast<float>(i));
    s.filled(lo, lo + glm::vec2(4.6f, 3.0f), Ink::faint);
    s.box(lo, lo + glm::vec2(4.6f, 3.0f), i == 2 ? Ink::accent : Ink::dim);
  }
}

void variants(const Sketch& s) {
  s.disc({3.5f, 3.0f}, 1.7f, Ink::accent);
  s.disc({8.0f, 3.0f}, 1.7f, Ink::warm);
  s.disc({12.5f, 3.0f}, 1.7f, Ink::plain, 0.6f);
}

void warnings(const Sketch& s) {
  s.shape({{8.0f, 0.8f}, {10.8f, 5.2f}, {5.2f, 5.2f}}, Ink::warm, 0.8f);
  s.filled({7.8f, 2.2f}, {8.2f, 3.8f}, Ink::faint);
  s.disc({8.0f, 4.5f}, 0.25f, Ink::faint);
}

void lights(const Sketch& s) {
  s.disc({4.0f, 1.4f}, 0.6f, Ink::warm);
  for (const float x : {2.0f, 4.5f, 7.0f, 9.5f}) s.line({4.2f, 1.9f}, {x, 5.0f}, Ink::dim);
  s.filled({10.5f, 0.9f}, {14.5f, 1.3f}, Ink::warm);
  for (const float x : {10.0f, 12.5f, 15.0f}) s.line({12.5f, 1.4f}, {x, 5.0f}, Ink::dim);
  s.line({1.0f, 5.0f}, {15.0f, 5.0f});
}

void shadows(const Sketch& s) {
  s.filled({2.0f, 0.6f}, {5.0f, 0.9f}, Ink::warm);
  s.line({2.0f, 0.9f}, {11.6f, 5.2f}, Ink::dim);
  s.line({5.0f, 0.9f}, {8.4f, 5.2f}, Ink::dim);
  s.disc({6.6f, 2.9f}, 0.8f, Ink::accent);
  s.line({1.0f, 5.2f}, {15.0f, 5.2f});
  s.filled({6.2f, 5.2f}, {8.4f, 5.5f}, Ink::dim);
  s.filled({8.4f, 5.2f}, {11.6f, 5.5f}, Ink::faint);
}

void reflections(const Sketch& s) {
  s.line({1.0f, 5.2f}, {15.0f, 5.2f});
  s.shape({{1.5f, 0.8f}, {7.4f, 5.2f}, {8.6f, 5.2f}}, Ink::accent, 0.3f);
  s.shape({{7.4f, 5.2f}, {8.6f, 5.2f}, {15.4f, 1.6f}, {12.0f, 0.4f}}, Ink::accent, 0.2f);
  s.disc({1.5f, 0.8f}, 0.3f, Ink::plain);
}

void sky(const Sketch& s) {
  for (int i = 0; i < 12; ++i) {
    const float turn = std::numbers::pi_v<float> * (static_cast<float>(i) + 0.5f) / 12.0f;
    const glm::vec2 way(std::cos(turn), -std::sin(turn));
    s.line(glm::vec2(8.0f, 5.2f) + 4.6f * way, glm::vec2(8.0f, 5.2f) + 1.8f * way, Ink::accent);
  }
  s.disc({8.0f, 5.0f}, 0.9f, Ink::warm);
  s.line({1.0f, 5.6f}, {15.0f, 5.6f});
}

void compare(const Sketch& s) {
  s.box({3.0f, 0.8f}, {13.0f, 5.2f}, Ink::dim);
  s.disc({8.0f, 3.0f}, 1.7f, Ink::accent);
  s.filled({8.0f, 0.9f}, {12.9f, 5.1f}, Ink::faint, 0.75f);
  s.line({8.0f, 0.4f}, {8.0f, 5.6f});
  s.words({5.0f, 1.5f}, "now");
  s.words({11.0f, 1.5f}, "A");
}

void display(const Sketch& s) {
  for (int i = 0; i < 28; ++i) {
    const float x = 1.0f + 0.5f * static_cast<float>(i);
    s.filled({x, 4.2f}, {x + 0.5f, 5.4f}, Ink::plain, static_cast<float>(i) / 27.0f);
  }
  glm::vec2 before(1.0f, 3.8f);
  for (int i = 1; i <= 28; ++i) {
    const float share = static_cast<float>(i) / 28.0f;
    const glm::vec2 now(1.0f + 14.0f * share, 3.8f - 3.0f * share / (0.35f + 0.65f * share));
    s.line(before, now, Ink::accent);
    before = now;
  }
}

void camera(const Sketch& s) {
  s.disc({1.6f, 3.0f}, 0.4f, Ink::plain);
  s.line({2.0f, 3.0f}, {11.0f, 0.6f}, Ink::dim);
  s.line({2.0f, 3.0f}, {11.0f, 5.4f}, Ink::dim);
  s.box({10.0f, 2.0f}, {12.0f, 4.0f}, Ink::accent);
  s.disc({11.0f, 3.0f}, 0.25f, Ink::warm);
}

// Sketches a lens and the rays of two points: one focused on the sensor, and one behind it.
void lens(const Sketch& s) {
  s.line({8.0f, 0.8f}, {8.0f, 5.2f}, Ink::accent);
  s.line({12.0f, 0.6f}, {12.0f, 5.4f}, Ink::dim);
  for (const float y : {0.9f, 5.1f}) {
    s.line({8.0f, y}, {12.0f, 3.0f});
    s.line({8.0f, y}, {15.0f, 3.0f}, Ink::warm);
    s.line({8.0f, y}, {2.0f, 3.0f});
  }
  s.disc({2.0f, 3.0f}, 0.3f, Ink::plain);
}

void statistics(const Sketch& s) {
  constexpr std::array shares{0.35f, 0.9f, 0.55f, 0.2f, 0.7f};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const float x = 2.2f + 2.5f * static_cast<float>(i);
    s.filled({x, 5.2f - 4.2f * shares[i]}, {x + 1.6f, 5.2f}, Ink::accent);
  }
  s.line({1.4f, 5.2f}, {14.6f, 5.2f});
}

void study(const Sketch& s) {
  s.line({2.0f, 0.6f}, {2.0f, 5.2f}, Ink::dim);
  s.line({2.0f, 5.2f}, {14.6f, 5.2f}, Ink::dim);
  s.line({3.0f, 1.0f}, {13.6f, 3.4f}, Ink::warm);
  s.line({3.6f, 1.0f}, {11.0f, 4.9f}, Ink::accent);
  s.words({13.0f, 4.6f}, "time");
  s.words({3.6f, 4.6f}, "error");
}

void scene(const Sketch& s) {
  s.box({6.6f, 0.6f}, {9.4f, 1.8f}, Ink::accent);
  for (const float x : {2.0f, 6.6f, 11.2f}) {
    s.line({8.0f, 1.8f}, {x + 1.4f, 3.8f}, Ink::dim);
    s.box({x, 3.8f}, {x + 2.8f, 5.0f});
  }
}

void left_out(const Sketch& s) {
  for (const float x : {2.0f, 6.6f, 11.2f}) s.box({x, 1.8f}, {x + 2.8f, 4.2f}, Ink::dim);
  s.line({6.2f, 4.6f}, {9.8f, 1.4f}, Ink::warm);
}

void window(const Sketch& s) {
  s.filled({2.0f, 0.8f}, {7.6f, 5.2f}, Ink::faint);
  s.filled({8.4f, 0.8f}, {14.0f, 5.2f}, Ink::plain, 0.9f);
  s.words({4.8f, 3.0f}, "Aa", Ink::plain);
  s.words({11.2f, 3.0f}, "Aa", Ink::faint);
}

struct Help {
  std::string_view section;
  const char* text;
  void (*draw)(const Sketch&);
};

constexpr Help helps[] = {
    {"Antialiasing",
     "Pixels are split only where object edges cross them. EPS: allowed error. MAX: maximum depth.",
     antialiasing},
    {"Advanced (papers)",
     "Details of splitting, filters and culling. The defaults suit nearly all pictures.",
     antialiasing},
    {"Refinement", "The picture is refined in passes. Pause it, or stop it by time or quality.",
     refinement},
    {"Animation", "Plays the file's animation. Paused frames are refined to full quality.",
     animation},
    {"Scenes", "The file has several scenes. Choosing one loads it.", scenes},
    {"Variants", "Material variants of the file. Choosing one reloads the file.", variants},
    {"Warnings", "Problems in the file that affect the picture.", warnings},
    {"Lights",
     "Lights of the file, emissive faces, and lights you add. Click a gizmo or a name to edit one.",
     lights},
    {"Shadows",
     "Shadows are split at their edges, as pixels are. Lights with a size cast soft shadows.",
     shadows},
    {"Reflections",
     "Reflections are split at edges, too. The DFR curve sets the blur by viewing angle.",
     reflections},
    {"Sky",
     "The sky lights the scene and appears in mirrors. It is a colour, a gradient or a picture.",
     sky},
    {"Compare", "Compare with a kept picture, another method in the same CPU time, or a reference.",
     compare},
    {"Display", "Display settings never restart the render, except the tone curve.", display},
    {"Camera",
     "Position of the camera and its orbit centre. Drag to orbit; double-click a point to orbit "
     "around it.",
     camera},
    {"Lens",
     "Depth of field: surfaces nearer or farther than the focus are blurred. A lower f-stop blurs "
     "more.",
     lens},
    {"Statistics", "Rays and splitting of the finished pixels. Point at a row for its meaning.",
     statistics},
    {"Error vs. time",
     "Renders the view by several methods and settings, and measures their errors. Lower left is "
     "better.",
     study},
    {"Scene", "Contents of the file: triangles, objects, lights, edges and memory.", scene},
    {"Objects",
     "Materials with their extensions, and their objects. Choose an object to hide or isolate it.",
     scene},
    {"Surfaces",
     "Material properties without lighting, at the nearest surface. The wireframe shows triangles.",
     variants},
    {"Skipped work",
     "Work that this scene does not need. Each row gives the reason and the savings.", left_out},
    {"Window", "Theme and text size, remembered by the program.", window},
};

const Help* help_of(std::string_view section) {
  const auto at = std::find_if(std::begin(helps), std::end(helps),
                               [&](const Help& help) { return help.section == section; });
  return at == std::end(helps) ? nullptr : at;
}

}  // namespace

std::span<const SketchedPixel> sketched_pixels() {
  return sketched;
}

bool has_section_help(std::string_view section) {
  return help_of(section) != nullptr;
}

void section_help(std::string_view section) {
  const Help* help = help_of(section);
  if (!help) return;
  constexpr float width_em = 20.0f;
  const float width = width_em * ImGui::GetFontSize();
  help->draw(Sketch(width));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  ImGui::TextUnformatted(help->text);
  ImGui::PopTextWrapPos();
}

}  // namespace asos::ui
