#include "renderer/film/image_io.h"
#include "renderer/film/split_map.h"
#include "tests/app/run_asos.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace asos {
namespace {

using nlohmann::json;
using test::AsosRun;
using test::run_asos;
using test::operator+;

json trace(const std::vector<std::string>& words) {
  const AsosRun outcome =
      run_asos(std::vector<std::string>{"trace"} + words + std::vector<std::string>{"--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return json::parse(outcome.out);
}

glm::vec3 colour_of(const json& c) {
  return {c.at(0).get<float>(), c.at(1).get<float>(), c.at(2).get<float>()};
}

std::string argument_of(const glm::ivec2& pixel) {
  return std::to_string(pixel.x) + "," + std::to_string(pixel.y);
}

glm::u8vec3 map_colour(const json& told) {
  const std::string cause = told.at("cause");
  const auto at = std::find(split_cause_names.begin(), split_cause_names.end(), cause);
  Film film(1, 1);
  film.split_level = {told.at("level").get<std::uint8_t>()};
  film.cause = {static_cast<SplitCause>(at - split_cause_names.begin())};
  film.samples = {told.value("samples", std::uint16_t{0})};
  return SplitMapKey{}.colour(SplitMapKey{}.value(film, 0));
}

// Checks consistency: weights, colour, and four children per split.
void check_consistent(const json& trace) {
  double weight = 0.0;
  glm::dvec3 colour(0.0);
  std::map<int, int> cells, splits;
  for (const json& cell : trace.at("cells")) {
    const int level = cell.at("level");
    ++cells[level];
    splits[level] += cell.at("fate") == "split" || cell.at("fate") == "uneven";
    for (const json& s : cell.at("samples")) {
      weight += s.at("weight").get<double>();
      colour += s.at("weight").get<double>() * glm::dvec3(colour_of(s.at("radiance")));
      EXPECT_FALSE(s.at("object").get<std::string>().empty());
      EXPECT_EQ(s.at("triangle").is_null(), s.at("object") == "background");
    }
  }
  EXPECT_NEAR(weight, 1.0, 1e-6);
  const glm::vec3 whole = colour_of(trace.at("radiance"));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(colour[k], static_cast<double>(whole[k]), 1e-6);
  EXPECT_EQ(cells[0], 1);
  for (const auto& [level, count] : splits) EXPECT_EQ(cells[level + 1], 4 * count);
}

TEST(TraceCommand, ThePixelIsTheRenderedOne) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "a.exr").string();
  const std::vector<glm::ivec2> pixels{{0, 0}, {60, 30}, {48, 27}, {61, 20}, {100, 56}};
  for (const std::vector<std::string>& how :
       {std::vector<std::string>{},
        {"--method", "asos-published", "--eps", "0.0625"},
        {"--look-at", "4,3,6,0,1,0", "--fov", "30", "--max", "4", "--fat", "4", "--no-shadows"},
        {"--rule", "published", "--detect", "cone", "--leaf", "point", "--jitter"}}) {
    const auto words = std::vector<std::string>{"builtin:boxes", "--size", "101x57"} + how;
    const std::string map_path = (folder.path() / "map.png").string();
    const AsosRun rendered =
        run_asos(std::vector<std::string>{"render", "-o", path, "--split-map", map_path} + words);
    ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
    const Film film = read_exr(path).value().film;
    const RgbImage map = read_png(map_path).value();
    for (const glm::ivec2 pixel : pixels) {
      SCOPED_TRACE(argument_of(pixel) + testing::PrintToString(how));
      const json told = trace(words + std::vector<std::string>{"--pixel", argument_of(pixel)});
      EXPECT_EQ(colour_of(told.at("radiance")), film.radiance[film.index(pixel.x, pixel.y)]);
      EXPECT_EQ(told.at("pixel"), json({pixel.x, pixel.y}));
      const std::size_t i = 3 * film.index(pixel.x, pixel.y);
      EXPECT_EQ(map_colour(told), glm::u8vec3(map.rgb[i], map.rgb[i + 1], map.rgb[i + 2]));
      check_consistent(told);
    }
  }
}

// The table of the published method, level by level, for pixels in one row of the boxes.
TEST(TraceCommand, TheTableIsThePapers) {
  std::size_t rows = 0;
  for (int x = 20; x < 76; x += 2) {
    const json told = trace({"builtin:boxes", "--size", "96x54", "--max", "4", "--pixel",
                             argument_of({x, 27}), "--method", "asos-published", "--eps", "0.01"});
    EXPECT_EQ(told.at("settings").at("rule"), "published");
    EXPECT_EQ(told.at("settings").at("detect"), "cone");
    EXPECT_EQ(told.at("settings").at("leaf"), "point");
    int level = 0;
    for (const json& row : told.at("levels")) {
      EXPECT_EQ(row.at("level"), level);
      const int cells = 1 << (2 * level++);
      EXPECT_EQ(row.at("cells"), cells);
      EXPECT_EQ(row.at("unresolved_area"), row.at("marginal").get<double>() / cells);
      for (const json& object : row.at("objects")) {
        ++rows;
        const int in = object.at("in"), out = object.at("out"), larger = object.at("larger");
        EXPECT_LE(in + out, row.at("marginal").get<int>());
        const bool clusters = object.at("object") == "small edges, not resolved";
        EXPECT_EQ(larger, clusters ? in + out : std::max(in, out));
        EXPECT_EQ(object.at("share"), static_cast<double>(larger) / cells);
        EXPECT_EQ(object.at("change"),
                  object.at("share").get<double>() / (object.at("one_edge") ? 2.0 : 1.0));
      }
    }
  }
  EXPECT_GT(rows, 20u);
}

// Each pyray that a leaf started names a leaf of its parent; includes mirrors in mirrors.
TEST(TraceCommand, PyraysOfMirrorsAndLightsAreTold) {
  std::size_t mirrored_twice = 0, shadows = 0;
  for (const glm::ivec2 pixel : {glm::ivec2{54, 20}, glm::ivec2{54, 30}, glm::ivec2{72, 35}}) {
    const std::vector<std::string> words{"trace",  "builtin:glass", "--size",
                                         "120x68", "--pixel",       argument_of(pixel)};
    const json told = trace(std::vector<std::string>(words.begin() + 1, words.end()));
    const json& pyrays = told.at("pyrays");
    for (std::size_t i = 0; i < pyrays.size(); ++i) {
      const json& p = pyrays[i];
      const bool nested = !p.at("parent").is_null();
      ASSERT_TRUE(!nested || p.at("parent").get<std::size_t>() < i);
      const json& parent = nested ? pyrays[p.at("parent").get<std::size_t>()] : told;
      bool is_there = false;
      for (const json& cell : parent.at("cells"))
        for (const json& s : cell.at("samples"))
          is_there |= s.at("at") == p.at("from") && s.at("weight") == p.at("weight");
      EXPECT_TRUE(is_there) << i << ": no leaf of its parent started it";
      EXPECT_FALSE(p.at("cells").empty());
      if (p.at("kind") == "shadow") {
        ++shadows;
        EXPECT_FALSE(p.at("light").get<std::string>().empty());
      } else {
        EXPECT_EQ(p.at("kind"), "mirror");
        EXPECT_TRUE(p.at("light").is_null());
        mirrored_twice += p.at("bounces") == 1;
      }
    }
    const AsosRun text = run_asos(words);
    EXPECT_TRUE(test::contains(text.out, "pyray  from")) << argument_of(pixel);
  }
  EXPECT_GT(mirrored_twice, 0u);
  EXPECT_GT(shadows, 0u);
}

TEST(TraceCommand, TextIsNoWiderThanAScreen) {
  bool cut = false;
  for (int x = 20; x < 76; x += 4) {
    const AsosRun told =
        run_asos({"trace", "builtin:boxes", "--size", "96x54", "--pixel", argument_of({x, 27})});
    ASSERT_EQ(told.exit_code, 0) << told.err;
    EXPECT_TRUE(test::contains(told.out, "builtin:boxes at 96x54"));
    EXPECT_TRUE(test::contains(told.out, "sample"));
    std::istringstream lines(told.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
    cut = cut || (told.out.find(" cut") != std::string::npos &&
                  told.out.find("ground") != std::string::npos);
  }
  EXPECT_TRUE(cut);
}

TEST(TraceCommand, WhatMakesNoSenseIsRefused) {
  const std::vector<std::string> boxes{"trace", "builtin:boxes", "--size", "64x36"};
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{}, "--pixel is required"},
      {{"--pixel", "64,0"}, "--pixel: 64,0 lies outside the picture of 64x36 pixels"},
      {{"--pixel", "0,36"}, "--pixel: 0,36 lies outside the picture of 64x36 pixels"},
      {{"--pixel=-1,0"}, "--pixel: \"-1,0\": x and y count from 0"},
      {{"--pixel", "12"}, "--pixel: \"12\": not a pixel such as 160,90 (x,y)"},
      {{"--pixel", "1.5,2"}, "not a pixel"},
      {{"--pixel", "1,2", "--method", "stochastic"}, "--method: only asos and asos-published"},
      {{"--pixel", "1,2", "--fat", "3"}, "--fat"},
      {{"--pixel", "1,2", "--crop", "0,0,8,8"}, "--crop"},
  };
  for (const auto& [words, message] : cases) {
    const AsosRun outcome = run_asos(boxes + words);
    EXPECT_EQ(outcome.exit_code, 2) << message << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(test::contains(outcome.err, message));
  }
  const AsosRun lost = run_asos({"trace", "builtin:boxes", "--pixel", "1,1", "--camera", "99"});
  EXPECT_EQ(lost.exit_code, 1);
  EXPECT_TRUE(test::contains(lost.err, "--camera 99"));
}

}  // namespace
}  // namespace asos
