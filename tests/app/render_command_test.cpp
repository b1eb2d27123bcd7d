#include "renderer/film/image_io.h"
#include "renderer/gltf/load.h"
#include "renderer/picture/picture_description.h"
#include "renderer/work_counts.h"
#include "tests/app/run_asos.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace asos {
namespace {

using nlohmann::json;
using test::AsosRun;
using test::run_asos;
using test::operator+;

class RenderCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  // Renders a small picture of boxes to `name`; `words` are further arguments.
  void render(const std::string& name, const std::vector<std::string>& words) {
    const std::vector<std::string> first{"render",   "builtin:boxes", "-o",
                                         path(name), "--size",        "96x54"};
    const AsosRun outcome = run_asos(first + words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    ASSERT_EQ(outcome.err, "");
  }

  json stats(const std::string& name) const { return json::parse(std::ifstream(path(name))); }

  Film film(const std::string& name) const {
    Result<ExrImage> image = read_exr(path(name));
    if (!image) {
      ADD_FAILURE() << image.error().message();
      return {};
    }
    return image->film;
  }

  test::TemporaryFolder folder_;
};

bool same_bits(const Film& a, const Film& b) {
  return a.width == b.width && a.height == b.height && a.radiance.size() == b.radiance.size() &&
         std::memcmp(a.radiance.data(), b.radiance.data(), a.radiance.size() * sizeof(glm::vec3)) ==
             0;
}

/// A model without lights, which gets the default lighting and a ground.
void write_dark_model(const std::string& file) {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 1, 1}, {-1, 1, 1}};
  mesh.normals.assign(4, glm::vec3(0, 1, 0));
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  mesh.material = 0;
  scene.materials.emplace_back();
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({"board", 0, glm::dmat4(1.0)});
  ASSERT_TRUE(export_gltf(scene, file));
}

TEST_F(RenderCommand, BuildsAModelOnItsGroundOnce) {
  write_dark_model(path("model.glb"));
  for (const char* method : {"sobol", "asos"}) {
    const std::uint64_t builds = WorkDone::of(Work::geometries);
    const std::uint64_t searches = WorkDone::of(Work::boundary_searches);
    const AsosRun outcome =
        run_asos({"render", path("model.glb"), "-o", path("a.png"), "--size", "32x18", "--method",
                  method, "--spp", "1", "--max", "1", "--stats", path("a.json")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(WorkDone::of(Work::geometries), builds + 1) << method;
    const bool edges = std::string(method) == "asos";
    EXPECT_EQ(WorkDone::of(Work::boundary_searches), searches + (edges ? 1 : 0));
    std::size_t left_out = 0;
    const json written = stats("a.json");
    for (const json& feature : written.at("left_out"))
      left_out += feature.at("feature") == "edges" ? 1 : 0;
    EXPECT_EQ(left_out, edges ? 0u : 1u);
  }
}

TEST_F(RenderCommand, WritesEveryStatisticWithItsType) {
  render("a.png", {"--stats", path("a.json"), "--max", "2", "--threads", "2"});
  const json s = stats("a.json");
  using Type = json::value_t;
  const std::map<std::string, std::set<Type>> expected{
      {"scene", {Type::string}},
      {"triangles", {Type::number_unsigned}},
      {"warnings", {Type::array}},
      {"warning_count", {Type::number_unsigned}},
      {"feature_edges", {Type::object}},
      {"width", {Type::number_unsigned}},
      {"height", {Type::number_unsigned}},
      {"crop", {Type::null}},
      {"camera", {Type::string}},
      {"exposure", {Type::number_float}},
      {"method", {Type::string}},
      {"max_level", {Type::number_unsigned}},
      {"eps", {Type::number_float}},
      {"leaf", {Type::string}},
      {"rule", {Type::string}},
      {"detect", {Type::string}},
      {"fat", {Type::number_unsigned}},
      {"texture_filter", {Type::string}},
      {"texture_resolution", {Type::number_unsigned}},
      {"sky", {Type::string}},
      {"judged_tone", {Type::string}},
      {"refine_shading", {Type::boolean}},
      {"cull", {Type::boolean}},
      {"shadows", {Type::boolean}},
      {"shadow_quality", {Type::string}},
      {"shadow_divisions", {Type::number_unsigned}},
      {"light_rule", {Type::string}},
      {"filter_width", {Type::number_float}},
      {"jitter", {Type::boolean}},
      {"spp", {Type::number_unsigned}},
      {"contrast", {Type::number_float}},
      {"depth", {Type::number_unsigned}},
      {"spheres", {Type::boolean}},
      {"contrast_scale", {Type::number_float}},
      {"seed", {Type::number_unsigned}},
      {"needs", {Type::string}},
      {"threads", {Type::number_unsigned}},
      {"load_seconds", {Type::number_float}},
      {"build_seconds", {Type::number_float}},
      {"render_seconds", {Type::number_float}},
      {"memory_mb", {Type::number_float}},
      {"rays", {Type::object}},
      {"samples_by_path", {Type::object}},
      {"shadow_pyrays", {Type::number_unsigned}},
      {"lights", {Type::array}},
      {"pyrays_by_level", {Type::array}},
      {"split_pixels", {Type::number_unsigned}},
      {"pixels_by_cause", {Type::object}},
      {"dfr", {Type::null}},
      {"reflections", {Type::number_unsigned, Type::number_integer}},
      {"roughest_mirror", {Type::number_float}},
      {"curved_mirror", {Type::string}},
      {"mirror_angle", {Type::number_float}},
      {"uneven_pixels", {Type::number_unsigned}},
      {"saturated_pixels", {Type::number_unsigned}},
      {"missed_splits", {Type::number_unsigned}},
      {"unresolved_area", {Type::number_float}},
      {"rejected_samples", {Type::number_unsigned}},
      {"cut_stacks", {Type::number_unsigned}},
      {"left_out", {Type::array}},
  };
  EXPECT_EQ(s.size(), expected.size());
  for (const auto& [key, types] : expected) {
    ASSERT_TRUE(s.contains(key)) << key;
    EXPECT_TRUE(types.contains(s[key].type())) << key << " is " << s[key].type_name();
  }
  for (const char* key :
       {"open", "silhouette_candidates", "crease", "seam", "intersection", "cut_out"})
    EXPECT_TRUE(s["feature_edges"].at(key).is_number_unsigned()) << key;
  for (const char* key : {"eye", "shadow", "reflection"})
    EXPECT_TRUE(s["rays"].at(key).is_number_unsigned()) << key;
  EXPECT_EQ(s["scene"], "builtin:boxes");
  EXPECT_EQ(s["width"], 96);
  EXPECT_EQ(s["height"], 54);
  EXPECT_EQ(s["method"], "asos");
  EXPECT_EQ(s["max_level"], 2);
  EXPECT_EQ(s["threads"], 2);
  EXPECT_EQ(s["pyrays_by_level"].size(), 9u);
  EXPECT_EQ(s["pyrays_by_level"][3], 0);
  EXPECT_GT(s["triangles"], 100);
  EXPECT_GE(s["rays"]["eye"].get<int>(), 96 * 54);
  EXPECT_GT(s["split_pixels"], 0);
  EXPECT_GT(s["memory_mb"], 1.0);
  EXPECT_EQ(s["rejected_samples"], 0);
  std::uint64_t with_cause = 0, rays = 0;
  for (const auto& [cause, pixels] : s["pixels_by_cause"].items())
    with_cause += pixels.get<std::uint64_t>();
  EXPECT_EQ(s["pixels_by_cause"].size(), 11u);
  EXPECT_GE(with_cause, s["split_pixels"].get<std::uint64_t>());
  EXPECT_GT(s["pixels_by_cause"]["outline"], 0);
  ASSERT_FALSE(s["lights"].empty());
  for (const json& light : s["lights"]) {
    EXPECT_TRUE(light.at("name").is_string());
    EXPECT_TRUE(light.at("type").is_string());
    EXPECT_TRUE(light.at("shadow_pyrays").is_number_unsigned());
    rays += light.at("shadow_rays").get<std::uint64_t>();
  }
  EXPECT_EQ(rays, s["rays"]["shadow"].get<std::uint64_t>());
}

TEST_F(RenderCommand, PicturesCarryTheirSettings) {
  const std::vector<std::string> words{"--max", "1", "--eps", "0.25", "--exposure", "0.5"};
  render("a.png", words);
  render("a.exr", words);
  const Result<RgbImage> png = read_png(path("a.png"));
  const Result<ExrImage> exr = read_exr(path("a.exr"));
  ASSERT_TRUE(png);
  ASSERT_TRUE(exr);
  EXPECT_EQ(png->width, 96);
  EXPECT_EQ(png->height, 54);
  for (const ImageText& text : {png->text, exr->attributes}) {
    const std::map<std::string, std::string> found(text.begin(), text.end());
    EXPECT_TRUE(found.contains("Software"));
    const json picture = json::parse(found.at("asos.picture"));
    EXPECT_EQ(picture["scene"], "builtin:boxes");
    EXPECT_EQ(picture["settings"]["eps"], 0.25);
    EXPECT_EQ(picture["settings"]["max_level"], 1);
    EXPECT_EQ(picture["display"]["exposure_ev"], 0.5);
    const json statistics = json::parse(found.at("asos.statistics"));
    EXPECT_GT(statistics["rays"]["eye"], 0);
    EXPECT_GT(statistics["render_seconds"], 0.0);
  }
}

TEST_F(RenderCommand, ThePngShowsTheExrsRadiance) {
  render("a.png", {"--exposure", "1", "--tone", "none"});
  render("a.exr", {});
  const Result<RgbImage> png = read_png(path("a.png"));
  ASSERT_TRUE(png);
  const Film exr = film("a.exr");
  ASSERT_EQ(exr.radiance.size() * 3, png->rgb.size());
  std::set<std::uint8_t> values;
  for (std::size_t i = 0; i < exr.radiance.size(); ++i) {
    const glm::u8vec3 shown = display_bytes(exr.radiance[i], 1.0f);
    ASSERT_EQ(shown, glm::u8vec3(png->rgb[3 * i], png->rgb[3 * i + 1], png->rgb[3 * i + 2])) << i;
    values.insert(shown.g);
  }
  EXPECT_GT(values.size(), 20u);  // the picture is not uniform
}

// A tone curve applies to the PNG only, the file stores it, and --from reproduces the picture.
TEST_F(RenderCommand, AToneCurveTravelsWithThePicture) {
  for (const NamedTone& tone : tone_names) {
    render("plain.exr", {"--tone", tone.name});
    const Film radiance = film("plain.exr");
    render("a.png", {"--exposure", "1", "--tone", tone.name});
    const Result<RgbImage> png = read_png(path("a.png"));
    ASSERT_TRUE(png);
    for (std::size_t i = 0; i < radiance.radiance.size(); ++i) {
      ASSERT_EQ(display_bytes(radiance.radiance[i], {1.0f, tone.value}),
                glm::u8vec3(png->rgb[3 * i], png->rgb[3 * i + 1], png->rgb[3 * i + 2]))
          << tone.name << " " << i;
    }
    const auto said = read_description(path("a.png"));
    EXPECT_EQ(said->display.tone, tone.value);
    EXPECT_EQ(said->settings.judged_tone, tone.value) << "EPS limits the displayed error";
    render("again.png", {"--from", path("a.png")});
    EXPECT_EQ(description_text(*read_description(path("again.png"))), description_text(*said));
    render("samples.png", {"--method", "sobol", "--spp", "4", "--tone", tone.name});
    EXPECT_EQ(read_description(path("samples.png"))->settings.judged_tone, ToneCurve::none);
  }
}

TEST_F(RenderCommand, ACropIsThatPartOfTheWholePicture) {
  for (const char* method :
       {"asos", "uniform", "stochastic", "sobol", "sobol-adaptive", "whitted", "mitchell",
        "ray-bound", "average", "beam", "cone", "covers", "mask"}) {
    const std::vector<std::string> words{"--method", method, "--spp", "4"};
    render("whole.exr", words);
    // The crop is not aligned to blocks and reaches the picture's lower right corner.
    render("part.exr", words + std::vector<std::string>{"--crop", "51,13,45,41"});
    const Film whole = film("whole.exr");
    const Film part = film("part.exr");
    ASSERT_EQ(part.width, 45);
    ASSERT_EQ(part.height, 41);
    for (int y = 0; y < part.height; ++y)
      ASSERT_EQ(std::memcmp(&part.radiance[part.index(0, y)],
                            &whole.radiance[whole.index(51, 13 + y)], 45 * sizeof(glm::vec3)),
                0)
          << method << " row " << y;
  }
}

TEST_F(RenderCommand, TheNumberOfThreadsDoesNotShow) {
  for (const char* method :
       {"asos", "uniform", "stochastic", "sobol", "sobol-adaptive", "whitted", "mitchell",
        "ray-bound", "average", "beam", "cone", "covers", "mask"}) {
    const std::vector<std::string> words{"--method", method, "--spp", "4", "--jitter"};
    render("one.exr",
           words + std::vector<std::string>{"--threads", "1", "--stats", path("1.json")});
    render("two.exr",
           words + std::vector<std::string>{"--threads", "2", "--stats", path("2.json")});
    EXPECT_TRUE(same_bits(film("one.exr"), film("two.exr"))) << method;
    for (const char* key : {"rays", "pyrays_by_level", "split_pixels", "unresolved_area"})
      EXPECT_EQ(stats("1.json")[key], stats("2.json")[key]) << method << " " << key;
  }
}

TEST_F(RenderCommand, TheSplitMapShowsTheSplitPixels) {
  render("a.png", {"--split-map", path("map.png"), "--stats", path("a.json"), "--max", "3"});
  const Result<RgbImage> map = read_png(path("map.png"));
  ASSERT_TRUE(map);
  ASSERT_EQ(map->width, 96);
  std::set<std::array<std::uint8_t, 3>> known{
      {0, 0, 0},
      {exact_colour.r, exact_colour.g, exact_colour.b},
      {sampled_colour.r, sampled_colour.g, sampled_colour.b}};
  for (int level = 1; level <= 3; ++level) {
    const glm::u8vec3 c = split_colour(level);
    known.insert({c.r, c.g, c.b});
  }
  int split = 0;
  for (std::size_t i = 0; i < map->rgb.size(); i += 3) {
    const std::array<std::uint8_t, 3> colour{map->rgb[i], map->rgb[i + 1], map->rgb[i + 2]};
    ASSERT_TRUE(known.contains(colour)) << "pixel " << i / 3;
    if (colour != std::array<std::uint8_t, 3>{0, 0, 0}) ++split;
  }
  EXPECT_GT(split, 0);
  EXPECT_LT(split, 96 * 54);
  EXPECT_EQ(read_description(path("map.png")).value().display.split_colours,
            SplitMapColours::level);
}

// The statistics count the pixels of each cause, and each cause has its own colour in the map.
TEST_F(RenderCommand, TheSplitMapByCauseShowsWhatTheStatisticsCount) {
  render("a.png", {"--split-map", path("map.png"), "--split-map-by", "cause", "--stats",
                   path("a.json"), "--max", "2"});
  const Result<RgbImage> map = read_png(path("map.png"));
  ASSERT_TRUE(map);
  std::map<std::array<std::uint8_t, 3>, std::uint64_t> pixels;
  for (std::size_t i = 0; i < map->rgb.size(); i += 3)
    ++pixels[{map->rgb[i], map->rgb[i + 1], map->rgb[i + 2]}];
  const json by_cause = stats("a.json")["pixels_by_cause"];
  std::uint64_t with_cause = 0;
  int causes = 0;
  for (std::size_t i = 1; i < split_cause_count; ++i) {
    const glm::u8vec3 c = split_cause_colour(static_cast<SplitCause>(i));
    const std::uint64_t shown = pixels[{c.r, c.g, c.b}];
    EXPECT_EQ(shown, by_cause[split_cause_names[i]]) << split_cause_names[i];
    with_cause += shown;
    causes += shown > 0;
  }
  EXPECT_GT(causes, 2);
  EXPECT_EQ((pixels[{0, 0, 0}]), 96u * 54u - with_cause);
  EXPECT_EQ(read_description(path("map.png")).value().display.split_colours,
            SplitMapColours::cause);
}

TEST_F(RenderCommand, TheCameraMoves) {
  render("file.exr", {});
  render("above.exr", {"--look-at", "0,30,0,0,0,0", "--fov", "30"});
  EXPECT_FALSE(same_bits(film("file.exr"), film("above.exr")));
}

// Each frame is a complete picture, however the frames are divided among jobs.
TEST_F(RenderCommand, FramesOfATurnAreRenderedOneByOne) {
  const std::vector<std::string> small{"--max", "1", "--quiet"};
  render("turn.exr", small + std::vector<std::string>{"--frames", "11"});
  render("again.exr", small + std::vector<std::string>{"--frames", "4-5/11"});
  render("still.exr", small);
  EXPECT_TRUE(same_bits(film("turn-00.exr"), film("still.exr")));
  EXPECT_TRUE(same_bits(film("turn-05.exr"), film("again-05.exr")));
  EXPECT_FALSE(same_bits(film("turn-05.exr"), film("turn-04.exr")));
  EXPECT_TRUE(std::filesystem::exists(path("turn-10.exr")));
  EXPECT_FALSE(std::filesystem::exists(path("turn-11.exr")));
  EXPECT_FALSE(std::filesystem::exists(path("turn.exr")));
  const AsosRun wrong =
      run_asos({"render", "builtin:boxes", "-o", path("x.png"), "--frames", "5/5"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("--frames"), std::string::npos);
}

TEST_F(RenderCommand, QuietSaysNothingAndLoudSaysWhatWasWritten) {
  const std::vector<std::string> words{"render",      "builtin:boxes", "-o",
                                       path("a.png"), "--size",        "16x9"};
  EXPECT_NE(run_asos(words).out.find("Wrote " + path("a.png")), std::string::npos);
  const AsosRun quiet = run_asos(words + std::vector<std::string>{"--quiet"});
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(RenderCommand, PathsMayHoldSpacesAndAnyLetters) {
  render("naïve picture ö 日本.png", {"--stats", path("die Zahlen ü.json")});
  EXPECT_TRUE(read_png(path("naïve picture ö 日本.png")));
  EXPECT_EQ(stats("die Zahlen ü.json")["scene"], "builtin:boxes");
}

TEST_F(RenderCommand, ALimitOfTimeThatIsNotReachedChangesNothing) {
  render("direct.exr", {"--stats", path("direct.json")});
  render("limited.exr", {"--stats", path("limited.json"), "--time-limit", "1000"});
  EXPECT_TRUE(same_bits(film("direct.exr"), film("limited.exr")));
  const json direct = stats("direct.json"), limited = stats("limited.json");
  EXPECT_FALSE(direct.contains("time_limit"));
  EXPECT_EQ(limited["time_limit"], (json{{"seconds", 1000.0}, {"finished", true}}));
  EXPECT_EQ(direct["rays"], limited["rays"]);
  EXPECT_EQ(direct["pyrays_by_level"], limited["pyrays_by_level"]);
}

TEST_F(RenderCommand, ALimitOfTimeGivesAWholePictureAndSaysHowGood) {
  for (const std::string limit : {"0", "0.3"}) {
    const AsosRun outcome =
        run_asos({"render", "builtin:boxes", "-o", path("soon.exr"), "--size", "640x360", "--max",
                  "8", "--threads", "1", "--stats", path("soon.json"), "--time-limit", limit});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(", stopped by --time-limit: "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(" everywhere, "), std::string::npos) << outcome.out;
    const json told = stats("soon.json")["time_limit"];
    EXPECT_FALSE(told["finished"]);
    EXPECT_NE(outcome.out.find(told["reached"].get<std::string>()), std::string::npos);
    // The boxes are in front of a bright sky: no pixel of a complete picture is black.
    const Film picture = film("soon.exr");
    ASSERT_EQ(picture.radiance.size(), 640u * 360u);
    const auto black = std::count(picture.radiance.begin(), picture.radiance.end(), glm::vec3(0));
    EXPECT_EQ(black, 0) << limit;
  }
}

TEST_F(RenderCommand, RefusesLimitsOfTimeThatAreNone) {
  for (const std::string wrong : {"-1", "soon", "nan", "1e9"}) {
    const AsosRun outcome =
        run_asos({"render", "builtin:boxes", "-o", path("x.png"), "--time-limit", wrong});
    EXPECT_EQ(outcome.exit_code, 2) << wrong;
    EXPECT_NE(outcome.err.find("--time-limit"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace asos
