#include "tests/app/page_sources.h"
#include "tests/app/run_asos.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace asos {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::AsosRun;
using test::contains;
using test::content_of;
using test::run_asos;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// A study of one or two seconds: two methods on tiny pictures of boxes.
std::vector<std::string> tiny_study(const std::string& folder,
                                    const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"report", "builtin:boxes", "-o",         folder,     "--size",
                                 "16x12",  "--methods",     "asos,sobol", "--budget", "0.2"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Makes one report for all the tests that only read it.
class FinishedReport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder;
    const AsosRun outcome = run_asos(tiny_study(folder_->path().string(), {"--repetitions", "2"}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "report.html"));
    EXPECT_EQ(outcome.err, "");
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static fs::path path(const std::string& name) { return folder_->path() / name; }

 private:
  static test::TemporaryFolder* folder_;
};
test::TemporaryFolder* FinishedReport::folder_ = nullptr;

TEST_F(FinishedReport, TheCsvHasItsColumnsAndALineForEachRun) {
  const auto lines = lines_of(content_of(path("points.csv")));
  ASSERT_EQ(lines.size(), 1u + 2u * (9u + 5u));
  EXPECT_EQ(lines[0],
            "scene,method,setting,repetition,seconds,rmse,mae,p99,p999,max,rmse_display,perceptual,"
            "rays,pyrays,memory_mb");
  for (const std::string& line : lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 14);
  EXPECT_TRUE(lines[1].starts_with("builtin:boxes,asos,MAX 4 EPS 1/8,1,")) << lines[1];
}

TEST_F(FinishedReport, TheCsvOfProgressHasALineForEachPicture) {
  const auto lines = lines_of(content_of(path("progress.csv")));
  EXPECT_EQ(lines[0], "scene,method,setting,picture,seconds,rmse");
  const json scene = json::parse(content_of(path("report.json"))).at("scenes").at(0);
  const json& curves = scene.at("while_rendering");
  ASSERT_EQ(curves.size(), 2u);
  std::size_t pictures = 0, finished = 0;
  for (const json& curve : curves) {
    EXPECT_TRUE(curve.at("finished").get<bool>());
    const json& points = curve.at("points");
    ASSERT_GE(points.size(), 1u);
    for (std::size_t i = 1; i < points.size(); ++i)
      EXPECT_GE(points[i].at("seconds"), points[i - 1].at("seconds"));
    // The last point is the finished picture of that setting.
    for (const json& point : scene.at("points")) {
      if (point.at("method") != curve.at("method") || point.at("setting") != curve.at("setting"))
        continue;
      EXPECT_EQ(points.back().at("rmse"), point.at("rmse")) << curve.at("method");
      ++finished;
    }
    pictures += points.size();
  }
  EXPECT_EQ(lines.size(), 1u + pictures);
  EXPECT_EQ(finished, curves.size()) << "each has its setting among the points";
  EXPECT_TRUE(lines[1].starts_with("builtin:boxes,asos,MAX 4 EPS 1/256,1,")) << lines[1];
  for (const json& row : scene.at("asos_while_rendering"))
    EXPECT_NEAR(row.at("error_ratio").get<double>(),
                row.at("asos_rmse").get<double>() / row.at("sobol_rmse").get<double>(), 1e-9);
}

TEST_F(FinishedReport, TheJsonHasItsFields) {
  const json report = json::parse(content_of(path("report.json")));
  for (const char* key : {"machine", "build", "commit"})
    EXPECT_FALSE(report.at(key).get<std::string>().empty()) << key;
  EXPECT_EQ(report.at("settings").at("width"), 16);
  EXPECT_EQ(report.at("settings").at("repetitions"), 2);
  for (const json& row : report.at("equal_error")) {
    EXPECT_EQ(row.at("scene"), "builtin:boxes");
    EXPECT_EQ(row.at("method"), "sobol");
    EXPECT_GT(row.at("rmse").get<double>(), 0.0);
    EXPECT_GT(row.at("speedup").get<double>(), 0.0);
  }
  EXPECT_TRUE(report.at("equal_time").is_array());
  for (const json& slope : report.at("slopes")) EXPECT_TRUE(slope.at("slope").is_number());
  const json& scene = report.at("scenes").at(0);
  const double floor = scene.at("reference").at("floor").get<double>();
  EXPECT_GT(floor, 0.0);
  std::size_t pixels = 0;
  for (const json& region : scene.at("points").at(0).at("regions"))
    pixels += region.at("pixels").get<std::size_t>();
  EXPECT_EQ(pixels, 16u * 12u);
  for (const json& point : scene.at("points")) {
    EXPECT_EQ(point.at("under_floor").get<bool>(), point.at("rmse").get<double>() < floor);
    EXPECT_TRUE(point.at("same_picture").get<bool>());
  }
}

TEST_F(FinishedReport, ThePageNeedsNothingElse) {
  const std::string page = content_of(path("report.html"));
  EXPECT_EQ(count_of(page, "http"), 0u) << "a link, or something fetched";
  EXPECT_EQ(count_of(page, "url("), 0u);
  // Three plots; the reference; two pictures with their errors; three maps.
  EXPECT_EQ(asos::test::embedded_images(page), 3u + 1u + 4u + 3u);
  EXPECT_EQ(count_of(page, "data-label="), 1u + 4u + 3u);
  EXPECT_TRUE(contains(page, "data-pictures=\"pictures1\""));
  EXPECT_TRUE(contains(page, "id=\"pictures1\""));
}

TEST_F(FinishedReport, ThePageOpensWithWhatWasComparedAndWhereAsosLoses) {
  const std::string page = content_of(path("report.html"));
  const std::size_t compared = page.find("Compared:");
  const std::size_t losses = page.find("Where ASOS does not win");
  const std::size_t scene = page.find("id=\"scene1\"");
  ASSERT_NE(compared, std::string::npos);
  ASSERT_NE(losses, std::string::npos);
  EXPECT_LT(compared, losses);
  EXPECT_LT(losses, scene);
}

TEST_F(FinishedReport, EveryLossIsListedInWords) {
  const json report = json::parse(content_of(path("report.json")));
  const std::string page = content_of(path("report.html"));
  std::size_t losses = 0;
  for (const json& row : report.at("equal_error"))
    losses += row.at("speedup").get<double>() < 1.05 && row.at("reading") != "unreached" &&
                      row.at("reading") != "levelled"
                  ? 1
                  : 0;
  for (const json& row : report.at("equal_time"))
    losses += row.at("error_ratio").get<double>() < 1.05 ? 1 : 0;
  const std::size_t listed = count_of(page, "<td class=\"t loss\">even:") +
                             count_of(page, "<td class=\"t loss\">slower:") +
                             count_of(page, "<td class=\"t loss\">less accurate:");
  EXPECT_EQ(listed, losses);
}

TEST_F(FinishedReport, ThePlotsAndPicturesAreFiles) {
  for (const char* name :
       {"plots/1-boxes-rmse.svg", "plots/1-boxes-rmse.png", "plots/1-boxes-perceptual.svg",
        "plots/1-boxes-progress.svg", "plots/1-boxes-progress.png",
        "pictures/1-boxes-reference.png", "pictures/1-boxes-asos.png",
        "pictures/1-boxes-sobol-errors.png", "pictures/1-boxes-split-causes.png"})
    EXPECT_GT(fs::file_size(path(name)), 100u) << name;
}

/// The scenes of report.json without all values that depend on run times.
json results_without_times(const fs::path& folder) {
  json scenes = json::parse(content_of(folder / "report.json")).at("scenes");
  for (json& scene : scenes) {
    for (json& point : scene.at("points"))
      for (const char* key : {"seconds", "spread", "wall_seconds", "memory_mb", "best"})
        point.erase(key);
    scene.erase("asos_while_rendering");
    for (json& curve : scene.at("while_rendering"))
      curve.at("points") = curve.at("points").back().at("rmse");
  }
  return scenes;
}

TEST(ReportCommand, MergedJobsGiveTheSameReportAsASingleRun) {
  const test::TemporaryFolder single;
  const test::TemporaryFolder odd;
  const test::TemporaryFolder even;
  const test::TemporaryFolder merged;
  // A picture so small that the reference ends by its noise, not by time.
  const std::vector<std::string> study{
      "report",     "builtin:boxes", "--size", "8x6",           "--methods",
      "asos,sobol", "--budget",      "500",    "--repetitions", "1"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = study;
    words.insert(words.end(), more.begin(), more.end());
    return run_asos(words);
  };
  const AsosRun whole = with({"-o", single.path().string()});
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const AsosRun list = with({"--list-jobs"});
  ASSERT_EQ(list.exit_code, 0);
  const std::size_t jobs = lines_of(list.out).size();
  ASSERT_EQ(jobs, 1u + 14u + 2u + 18u);
  for (std::size_t k = jobs; k-- > 0;) {
    const AsosRun one =
        with({"-o", (k % 2 ? odd : even).path().string(), "--job", std::to_string(k)});
    ASSERT_EQ(one.exit_code, 0) << one.err;
  }
  const AsosRun merge = run_asos({"report", "-o", merged.path().string(), "--merge",
                                  odd.path().string(), even.path().string()});
  ASSERT_EQ(merge.exit_code, 0) << merge.err;
  EXPECT_EQ(results_without_times(merged.path()), results_without_times(single.path()));
}

TEST(ReportCommand, ALookTravelsWithItsJobs) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  const std::vector<std::string> look{"--sky",         "0.5,0.6,1:0.9,0.9,0.9",
                                      "--reflections", "2",
                                      "--dfr",         "0.05,1,32",
                                      "--tr",          "2",
                                      "--camera",      "0",
                                      "--fov",         "40",
                                      "--needs",       "all"};
  const auto with_job = [&](std::vector<std::string> words, const char* job) {
    words.insert(words.begin(), {"--job", job});
    return run_asos(tiny_study(path, words));
  };
  const AsosRun listed = run_asos(tiny_study(path, [&] {
    auto words = look;
    words.push_back("--list-jobs");
    return words;
  }()));
  EXPECT_TRUE(contains(listed.out,
                       "1\tbuiltin:boxes camera 0 fov 40 sky 0.5,0.6,1:0.9,0.9,0.9 bounces 2 DFR "
                       "0.05,1,32 asos MAX 4 EPS 1/8 TR 2 repetition 1\n"))
      << listed.out;
  for (const char* job : {"0", "1", "2"}) {
    const AsosRun run = with_job(look, job);
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  // The plan read back gives the same list of jobs, so only jobs are missing.
  const AsosRun merge = run_asos({"report", "--merge", path, "-o", path});
  EXPECT_EQ(merge.exit_code, 1);
  EXPECT_TRUE(contains(merge.err, "has not been run")) << merge.err;
  // A job with another look is rejected.
  ASSERT_EQ(with_job({"--reflections", "2"}, "2").exit_code, 0);
  EXPECT_TRUE(contains(run_asos({"report", "--merge", path, "-o", path}).err, "another study"));
}

TEST(ReportCommand, AMissingJobIsNamed) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  ASSERT_EQ(run_asos(tiny_study(path, {"--job", "0"})).exit_code, 0);
  const AsosRun merge = run_asos({"report", "--merge", path, "-o", path});
  EXPECT_EQ(merge.exit_code, 1);
  EXPECT_TRUE(contains(merge.err, "job 1 (builtin:boxes asos MAX 4 EPS 1/8 repetition 1)"));
  EXPECT_FALSE(fs::exists(folder.path() / "report.html"));
}

TEST(ReportCommand, WhatTakesTooLongIsGivenUpAndNamed) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  const std::vector<std::string> alone{"--repetitions", "1", "--longest", "1e-9"};
  const AsosRun outcome = run_asos(tiny_study(path, alone));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = json::parse(content_of(folder.path() / "report.json"));
  const auto& scene = report["scenes"][0];
  EXPECT_TRUE(scene["points"].empty());
  EXPECT_TRUE(scene["while_rendering"].empty()) << "no picture had to finish";
  ASSERT_EQ(scene["given_up"].size(), 14u);  // EPS 1/8 to 1/2048, and five settings of sobol
  EXPECT_EQ(scene["given_up"][0], "asos MAX 4 EPS 1/8");
  EXPECT_EQ(report["settings"]["longest_seconds"], 1e-9);
  const std::string page = content_of(folder.path() / "report.html");
  EXPECT_TRUE(contains(page, "given up after")) << page.substr(0, 2000);
  EXPECT_TRUE(contains(page, "sobol 256 spp"));
}

TEST(ReportCommand, ANewReportRemovesThePicturesOfTheOneBefore) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  fs::create_directories(folder.path() / "jobs");
  const std::string old = folder.write("jobs/99-7.exr", "old");
  const std::string other = folder.write("jobs/notes-7.exr", "kept");
  const std::string dashed = folder.write("jobs/9-7-1.exr", "kept");
  ASSERT_EQ(run_asos(tiny_study(path, {"--repetitions", "1"})).exit_code, 0);
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(other));
  EXPECT_TRUE(fs::exists(dashed));
}

TEST(ReportCommand, JobsOfAnotherStudyAreRefused) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path().string();
  ASSERT_EQ(run_asos(tiny_study(path, {"--job", "0"})).exit_code, 0);
  ASSERT_EQ(run_asos(tiny_study(path, {"--job", "1", "--repetitions", "7"})).exit_code, 0);
  const AsosRun merge = run_asos({"report", "--merge", path, "-o", path});
  EXPECT_EQ(merge.exit_code, 1);
  EXPECT_TRUE(contains(merge.err, "jobs/1.json"));
  EXPECT_TRUE(contains(merge.err, "another study"));
  // A job file that is not JSON.
  std::ofstream(folder.path() / "jobs" / "1.json") << "nonsense";
  EXPECT_TRUE(contains(run_asos({"report", "--merge", path, "-o", path}).err, "jobs/1.json"));
}

TEST(ReportCommand, ListsItsJobsAndRunsNone) {
  const test::TemporaryFolder folder;
  const AsosRun outcome = run_asos(tiny_study(folder.file("new"), {"--list-jobs"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.out.starts_with("0\tbuiltin:boxes regions\n")) << outcome.out;
  EXPECT_EQ(lines_of(outcome.out).size(), 1u + 3u * 14u + 2u + 18u);
  EXPECT_FALSE(fs::exists(folder.file("new")));
}

TEST(ReportCommand, RefusesCommandLinesThatMakeNoSense) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"report", "-o", "x"}, "SCENE"},
      {{"report", "builtin:boxes"}, "-o"},
      {{"report", "builtin:boxes", "-o", "x", "--methods", "asos,magic"}, "magic"},
      {{"report", "builtin:boxes", "-o", "x", "--size", "0x5"}, "--size"},
      {{"report", "builtin:boxes", "-o", "x", "--budget", "nan"}, "--budget"},
      {{"report", "builtin:boxes", "-o", "x", "--repetitions", "0"}, "--repetitions"},
      {{"report", "builtin:boxes", "-o", "x", "--tr", "9"}, "--tr"},
      {{"report", "builtin:boxes", "-o", "x", "--dfr", "2,1,1"}, "--dfr"},
      {{"report", "builtin:boxes", "-o", "x", "--suite", "book"}, "book"},
      {{"report", "builtin:boxes", "-o", "x", "--job", "100000"}, "--job"},
      {{"report", "builtin:boxes", "-o", "x", "--merge", "y"}, "--merge"},
  };
  for (const auto& [words, part] : cases) {
    const AsosRun outcome = run_asos(words);
    EXPECT_EQ(outcome.exit_code, 2) << words.back() << ": " << outcome.err;
    EXPECT_TRUE(contains(outcome.err, part));
  }
  EXPECT_FALSE(fs::exists("x"));
}

TEST(ReportCommand, SaysWhatIsWrongWithItsInput) {
  const test::TemporaryFolder folder;
  const AsosRun unknown = run_asos({"report", "builtin:boxen", "-o", folder.file("a")});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_TRUE(contains(unknown.err, "builtin:boxes"));

  const std::string empty =
      folder.write("empty.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{}], "scene": 0})");
  const AsosRun nothing = run_asos({"report", empty, "-o", folder.file("b"), "--size", "16x12"});
  EXPECT_EQ(nothing.exit_code, 1);
  EXPECT_TRUE(contains(nothing.err, "empty"));

  const AsosRun sky = run_asos(tiny_study(folder.file("s"), {"--sky", folder.file("no.hdr")}));
  EXPECT_EQ(sky.exit_code, 1);
  EXPECT_TRUE(contains(sky.err, "no.hdr"));
  EXPECT_FALSE(fs::exists(folder.file("s")));

  const std::string file = folder.write("file", "");
  const AsosRun unwritable = run_asos(tiny_study(file));
  EXPECT_EQ(unwritable.exit_code, 1);
  EXPECT_TRUE(contains(unwritable.err, file));

  const AsosRun nowhere =
      run_asos({"report", "--merge", folder.file("none"), "-o", folder.file("c")});
  EXPECT_EQ(nowhere.exit_code, 1);
  EXPECT_TRUE(contains(nowhere.err, folder.file("none")));
}

TEST(ReportCommand, SaysAtTheStartThatGnuplotIsMissing) {
  const test::TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const AsosRun outcome = run_asos(tiny_study(folder.file("report")));
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "gnuplot-nox"));
  EXPECT_FALSE(fs::exists(folder.file("report"))) << "found out before anything was rendered";
}

TEST(ReportCommand, NamesThePlotThatGnuplotDoesNotDraw) {
  const test::TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  const std::pair<std::string, std::string> ends[] = {
      {"echo 'no \033[2Jfont' >&2; exit 3", "gnuplot failed: no \\x1b[2Jfont"},
      {"kill -9 $$", "gnuplot failed and does not say why"},
      {"exit 0", "does not say why; the disk may be full"},
      {"echo '<svg>' >\"${1%.gp}.svg\"", "gnuplot did not write the plot to its end"},
  };
  for (const auto& [does, said] : ends) {
    const std::string program =
        folder.write("gnuplot", "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\n" + does + "\n");
    fs::permissions(program, fs::perms::owner_all);
    setenv("PATH", (folder.path().string() + ":" + path).c_str(), 1);
    const AsosRun outcome = run_asos({"report", "builtin:boxes", "-o", folder.file("report"),
                                      "--size", "12x8", "--methods", "asos", "--budget", "0.02"});
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(outcome.exit_code, 1) << does;
    EXPECT_TRUE(contains(outcome.err, "plots/1-boxes-rmse")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, said)) << outcome.err;
    EXPECT_FALSE(fs::exists(folder.file("report/report.html"))) << does;
    fs::remove_all(folder.file("report"));
  }
}

}  // namespace
}  // namespace asos
