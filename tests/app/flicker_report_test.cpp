#include "app/report/flicker_files.h"
#include "app/report/flicker_study.h"
#include "app/report/pictures.h"
#include "tests/app/page_sources.h"
#include "tests/app/run_asos.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace asos::test::flicker_report_test {
namespace {

using nlohmann::json;

/// A point with this flicker and no other errors.
FlickerPoint point(const std::string& method, const std::string& setting, double seconds,
                   float flicker) {
  FlickerPoint p{.rung = {.method = method, .setting = setting, .curve = method},
                 .frame_seconds = {seconds, seconds}};
  Film grey(1, 1);
  grey.radiance[0] = glm::vec3(0.5f);
  for (const float error : {flicker, -flicker}) {
    Film film(1, 1);
    film.radiance[0] = glm::vec3(0.5f + error);
    p.meter.add(film, grey);
  }
  return p;
}

TEST(CompareFlicker, ReadsRivalsInTheTimeOfAsos) {
  FlickerStudy study{.floor = 0.002};
  study.points = {
      point("asos", "MAX 3 EPS 1/256", 2.0, 0.01f), point("asos", "MAX 4 EPS 1/256", 8.0, 0.001f),
      point("sobol", "4 spp", 1.0, 0.2f),           point("sobol", "16 spp", 4.0, 0.05f),
      point("slow", "1 spp", 3.0, 0.04f),           point("exact", "1 spp", 1.0, 0.0005f)};
  compare_flicker(study);
  EXPECT_TRUE(study.points[1].under_floor);
  EXPECT_FALSE(study.points[0].under_floor);
  ASSERT_EQ(study.equal_time.size(), 4u) << "an exact method is below the noise floor, so unknown";
  const FlickerAtEqualTime& sobol = study.equal_time[0];
  EXPECT_EQ(sobol.method, "sobol");
  EXPECT_NEAR(sobol.rival_flicker, 0.1, 1e-6) << "half way, both axes logarithmic";
  EXPECT_NEAR(sobol.ratio(), 10.0, 1e-4);
  EXPECT_EQ(sobol.reading, Reading::measured);
  EXPECT_FALSE(sobol.at_least);
  EXPECT_TRUE(study.equal_time[1].at_least);
  EXPECT_EQ(study.equal_time[1].asos_flicker, 0.002);
  EXPECT_EQ(study.equal_time[1].reading, Reading::extrapolated);
  EXPECT_NEAR(study.equal_time[1].rival_flicker, 0.025, 1e-6);
  EXPECT_EQ(study.equal_time[2].method, "slow");
  EXPECT_EQ(study.equal_time[2].reading, Reading::cheapest);
  EXPECT_NEAR(study.equal_time[2].rival_flicker, 0.04, 1e-7);
}

TEST(ShownPoints, AreTheOnesNearestInTime) {
  FlickerStudy study;
  study.points = {point("asos", "MAX 2 EPS 1/256", 1.0, 0.01f),
                  point("asos", "MAX 4 EPS 1/256", 2.0, 0.01f), point("sobol", "4 spp", 0.5, 0.2f),
                  point("sobol", "16 spp", 3.0, 0.05f)};
  study.points[0].rung.settings.asos.max_level = 2;  // the other one has the default MAX and EPS
  const auto shown = alike_in_time(study.points);
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_EQ(shown[0], &study.points[1]);
  EXPECT_EQ(shown[1], &study.points[3]);
}

std::vector<std::string> lines_of_file(const std::filesystem::path& path) {
  std::istringstream text(content_of(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

TEST(FlickerReport, OfABuiltinSceneIsWhole) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "pole").string();
  const AsosRun run =
      run_asos({"report", "--animation", "builtin:walking-pole", "-o", out, "--size", "32x18",
                "--frames", "3-5/24", "--methods", "asos,sobol", "--budget", "0.3"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "report.html"));
  const auto lines = lines_of_file(folder.path() / "pole" / "flicker.csv");
  ASSERT_GE(lines.size(), 5u);
  EXPECT_TRUE(lines[0].starts_with("scene,animation,method,setting,first_frame,frames,"));
  EXPECT_TRUE(lines[1].starts_with("builtin:walking-pole,walk,asos,MAX 4 EPS 1/8,3,3,24,"))
      << lines[1];

  const json study = json::parse(content_of(folder.path() / "pole" / "flicker.json")).at(0);
  EXPECT_EQ(study.at("animation"), "walk");
  EXPECT_GT(study.at("reference").at("samples"), 0);
  for (const json& p : study.at("points")) {
    const double rmse = p.at("rmse"), flicker = p.at("flicker"), steady = p.at("steady");
    if (flicker > 0.0 && steady > 0.0) {
      EXPECT_NEAR(rmse * rmse, flicker * flicker + steady * steady, 1e-9);
    }
    EXPECT_GT(p.at("seconds").get<double>(), 0.0);
  }

  // The page embeds all its images: two plots, the reference's strip, and three pictures per
  // method.
  const std::string page = content_of(folder.path() / "pole" / "report.html");
  EXPECT_FALSE(contains(page, "http"));
  EXPECT_EQ(embedded_images(page), 2u + 1u + 2u * 3u);
}

TEST(FlickerReport, OfWhatDoesNotMoveEndsWithTheReason) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "r").string();
  const auto refused = [&](std::vector<std::string> words, int code, const std::string& reason) {
    words.insert(words.end(), {"-o", out, "--size", "16x12"});
    const AsosRun run = run_asos(words);
    EXPECT_EQ(run.exit_code, code) << run.err;
    EXPECT_TRUE(contains(run.err, reason)) << run.err;
  };
  refused({"report", "--animation", "builtin:boxes"}, 1, "builtin:boxes: has no animations");
  refused({"report", "builtin:walking-pole", "--animation", "run"}, 1, "no animation \"run\"");
  refused({"report", "builtin:walking-pole", "--frames", "2/24"}, 1, "two frames at least");
  refused({"report", "builtin:walking-pole", "--frames", "2-3/24", "--time", "1"}, 2, "--time");
  refused({"report", "builtin:walking-pole", "--frames", "2-3/24", "--job", "1"}, 2, "--job");
  refused({"report", "builtin:walking-pole", "--frames", "a"}, 2, "--frames");
}

TEST(ReportOfAMoment, IsOfThatMoment) {
  const TemporaryFolder folder;
  std::vector<std::string> words{
      "report", "builtin:walking-pole", "--time", "2.5", "--size", "16x9", "--methods",
      "sobol",  "--repetitions",        "1"};
  const AsosRun jobs = run_asos([&] {
    auto more = words;
    more.push_back("--list-jobs");
    return more;
  }());
  ASSERT_EQ(jobs.exit_code, 0) << jobs.err;
  EXPECT_TRUE(contains(jobs.out, "builtin:walking-pole at 2.5 s regions")) << jobs.out;
  // A job renders different pictures at two times of the animation, and equal ones at the same
  // time.
  const auto hash_at = [&](const std::string& seconds, const std::string& name) {
    auto more = words;
    more[3] = seconds;
    const std::filesystem::path out = folder.path() / name;
    more.insert(more.end(), {"--job", "3", "-o", out.string()});
    const AsosRun run = run_asos(more);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return json::parse(content_of(out / "jobs" / "3.json")).at("picture_hash").get<std::string>();
  };
  const std::string here = hash_at("2.5", "a");
  EXPECT_EQ(hash_at("2.5", "b"), here);
  EXPECT_NE(hash_at("7.5", "c"), here);
}

}  // namespace
}  // namespace asos::test::flicker_report_test
