#include "renderer/film/image_io.h"
#include "tests/ui/ui_rig.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

// Pictures of the window to look at, rendered in memory: window_pages FOLDER [MODELS]. Writes
// index.html with the window at its first start, in both themes, at 200 %, 420 pixels wide, at each
// card of the tour, and with the explanations open; and with models of the folder MODELS (its
// scenes/NAME/NAME.glb) as they open. Without MODELS, as in the test, the scene is rendered
// coarsely: this shows the window as well, in a third of the time. window_pages --manual FOLDER
// writes window.png, which README.md shows. Fails if a picture is empty.

namespace asos::test {
using namespace ui;
namespace {

namespace fs = std::filesystem;

class Pages {
 public:
  /// `coarse`: renders the scenes coarsely.
  Pages(fs::path folder, bool coarse) : folder_(std::move(folder)), coarse_(coarse) {
    fs::create_directories(folder_);
  }

  /// A window after opening and using a scene, and its picture.
  struct Page {
    std::string name, caption, source;
    glm::ivec2 size{1283, 600};
    float scale = 1.0f;
    std::function<void(UiRig&)> use;
    int max_level = 2;
  };
  void add(const Page& page) {
    UiRig rig(LoadFunction{}, page.size, page.scale, UiRig::Skies::usual);
    RenderSettings& settings = rig.settings();
    settings = {};
    settings.threads = 2;
    settings.asos.max_level = coarse_ ? 0 : page.max_level;
    if (coarse_) settings.asos.leaf = LeafKind::point;
    rig.scene().open(page.source);
    wait(rig, page.source);
    if (page.use) page.use(rig);
    wait(rig, page.source);
    // Move to where no tooltip appears.
    rig.move_to({-1e5f, -1e5f});
    for (int i = 0; i < 4; ++i) rig.frame();
    save(page, rig.pixels());
  }
  void finish() {
    std::ofstream(folder_ / "index.html")
        << "<!doctype html><meta charset=\"utf-8\"><title>The window</title>\n"
           "<style>body{font:15px sans-serif;margin:24px;background:#777}figure{margin:0 0 32px}"
           "img{max-width:100%}</style>\n"
        << html_;
  }

 private:
  static void wait(UiRig& rig, const std::string& source) {
    if (!rig.frames_until(
            [&] {
              return rig.scene() && !rig.scene().loading() && rig.render().progress().finished &&
                     rig.input().empty();
            },
            300.0))
      throw std::runtime_error(source + " is not shown");
  }
  void save(const Page& page, const std::vector<glm::u8vec3>& pixels) {
    std::set<int> colours;
    RgbImage image{page.size.x, page.size.y, {}, {}};
    for (const glm::u8vec3 c : pixels) {
      image.rgb.insert(image.rgb.end(), {c.x, c.y, c.z});
      colours.insert((c.x << 16) + (c.y << 8) + c.z);
    }
    constexpr std::size_t least = 100;
    if (colours.size() < least) throw std::runtime_error(page.name + " shows next to nothing");
    const std::string file = page.name + ".png";
    if (const Result<void> written = write_png((folder_ / file).string(), image); !written)
      throw std::runtime_error(written.error().message());
    html_ += fmt::format("<figure><figcaption>{}</figcaption><img src=\"{}\"></figure>\n",
                         page.caption, file);
    std::printf("%s\n", (folder_ / file).c_str());
    std::fflush(stdout);
  }

  fs::path folder_;
  bool coarse_;
  std::string html_;
};

void card(UiRig& rig, int number) {
  rig.state().tour_asked = true;
  rig.frame();
  // The first card has chosen its pixel, and maybe a better one; some pictures have none.
  (void)rig.frames_until([&] { return rig.state().tour.found.has_value(); }, 5.0);
  show_card(rig.state(), rig.previewer(), number, 0.0);
  // Waits until the pixel's splitting is shown completely.
  for (int i = 0; i < 300 && rig.state().shown_level; ++i) rig.frame();
}

void own_pages(Pages& pages, const std::string& source) {
  pages.add(
      {"first-start", "First start", source, {1283, 600}, 1.0f, [](UiRig& rig) { card(rig, 0); }});
  pages.add({"dark", "Dark", source, {1283, 900}, 1.0f, {}});
  pages.add({"light", "Light", source, {1283, 900}, 1.0f, [](UiRig& rig) {
               rig.state().look.theme = theme::Look::light;
             }});
  pages.add({"double", "On a screen of 200 %", source, {1800, 1200}, 2.0f, {}});
  pages.add({"narrow", "420 pixels wide", source, {420, 760}, 1.0f, {}});
  pages.add({"narrow-double",
             "420 pixels wide on a screen of 200 %",
             source,
             {420, 760},
             2.0f,
             [](UiRig& rig) { card(rig, 0); }});
}

void more_pages(Pages& pages, const std::string& source) {
  for (int i = 1; i < Tour::cards; ++i)
    pages.add({fmt::format("tour-{}", i + 1),
               fmt::format("Card {} of the tour", i + 1),
               source,
               {1283, 600},
               1.0f,
               [i](UiRig& rig) { card(rig, i); }});
  for (const float scale : {1.0f, 2.0f}) {
    for (int i = 0; i < Tour::cards; ++i)
      pages.add({fmt::format("narrow-tour-{}-{:.0f}", i + 1, scale),
                 fmt::format("Card {} in 420 pixels, {:.0f} %", i + 1, 100.0f * scale),
                 source,
                 {420, 760},
                 scale,
                 [i](UiRig& rig) { card(rig, i); }});
  }
  pages.add({"large", "1920 x 1080", "builtin:boxes", {1920, 1080}, 1.0f, {}});
  pages.add({"grid",
             "Grid and axes behind what stands before them",
             "builtin:boxes",
             {1283, 600},
             1.0f,
             [](UiRig& rig) { rig.state().display.show_grid = true; }});
  for (const auto look : {theme::Look::dark, theme::Look::light}) {
    const std::string name = look == theme::Look::dark ? "dark" : "light";
    pages.add(
        {"why-" + name, "The split map's answer", source, {1283, 800}, 1.0f, [look](UiRig& rig) {
           rig.state().look.theme = look;
           rig.key(Key::m);
           rig.key(Key::c);
           for (int i = 0; i < 3; ++i) rig.frame();
           rig.click("Why is this pixel like this?");
           if (!rig.frames_until([&] { return rig.controls().contains("Verdict"); }))
             throw std::runtime_error("the pixel is not explained");
         }});
    pages.add({"help-" + name, "A section's help", source, {1283, 600}, 1.0f, [look](UiRig& rig) {
                 rig.state().look.theme = look;
                 for (int i = 0; i < 3; ++i) rig.frame();
                 rig.click("Help/Antialiasing");
               }});
    pages.add(
        {"panel-" + name, "The whole panel", source, {760, 3000}, 1.0f, [look](UiRig& rig) {
           rig.state().look.theme = look;
           for (int i = 0; i < 3; ++i) rig.frame();
           for (const char* section : {"section/Refinement", "section/Sky", "section/Compare"})
             rig.click(section);
         }});
  }
}

// The picture of README.md: the split map over the left half of a finished picture.
void write_manual_picture(const std::string& folder) {
  Pages pages(folder, false);
  Pages::Page page{"window", "The window", "builtin:office", {1280, 720}, 1.0f, [](UiRig& rig) {
                     rig.key(Key::s);
                     rig.frame();
                     UiState& state = rig.state();
                     state.frames.comparison = Comparison::wipe;
                     state.display.show_split_map = true;
                     state.message.clear();
                     state.said.clear();
                   }};
  page.max_level = 4;
  pages.add(page);
}

int write_pages(const std::string& folder, const std::string& models) {
  Pages pages(folder, models.empty());
  own_pages(pages, "builtin:boxes");
  if (!models.empty()) {
    more_pages(pages, "builtin:office");
    for (const char* model :
         {"Fox", "ToyCar", "Bike", "HotelRoom", "MetalRoughSpheresNoTextures"}) {
      fs::path file = fs::path(models) / "scenes" / model / (std::string(model) + ".glb");
      if (!fs::exists(file)) file.replace_extension(".gltf");
      if (!fs::exists(file)) throw std::runtime_error(file.string() + " is not there");
      pages.add({model, model, file.string(), {1283, 600}, 1.0f, {}});
    }
  }
  pages.finish();
  return 0;
}

}  // namespace
}  // namespace asos::test

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fputs("usage: window_pages FOLDER [MODELS], or window_pages --manual FOLDER\n", stderr);
    return 2;
  }
  try {
    if (std::string(argv[1]) == "--manual") {
      asos::test::write_manual_picture(argc > 2 ? argv[2] : ".");
      return 0;
    }
    const int code = asos::test::write_pages(argv[1], argc > 2 ? argv[2] : "");
    // Failed expectations outside a test are only printed, so return them as the exit code.
    const bool failed = testing::UnitTest::GetInstance()->ad_hoc_test_result().Failed();
    return failed ? 1 : code;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "window_pages: %s\n", error.what());
    return 1;
  }
}
