#include "app/report/report_data.h"

#include "app/report/html_page.h"
#include "app/report/method_faults.h"
#include "app/report/pictures.h"
#include "app/report/plots.h"
#include "app/report/subdivision_tables.h"
#include "renderer/study/ladders.h"
#include "tests/app/run_asos.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>

namespace asos {
namespace {

using test::contains;

StudyPoint point(const std::string& method, const std::string& setting, double seconds,
                 double rmse) {
  return {.rung = {.method = method, .setting = setting, .curve = method},
          .costs = {{seconds, seconds, 1.0}},
          .measures = {.rmse = rmse}};
}

/// Times of the paper's suite for the office. ASOS: 2 s and 3 s; stochastic sampling: 6 s with 16
/// samples, 24 s with 64.
StudyReport paper_report() {
  StudyReport report{.plan = {.paper = true}};
  report.machines.push_back({});
  SceneReport office;
  office.study.scene = "builtin:office";
  office.study.points = {
      point("asos", "MAX 2 EPS 1/8", 2, 0.02), point("asos", "MAX 3 EPS 1/8", 3, 0.01),
      point("stochastic", "16 spp", 6, 0.02), point("stochastic", "64 spp", 24, 0.01)};
  analyse(office.study);
  report.scenes.push_back(office);
  return report;
}

TEST(Anchor, HasTheProgramsDefaults) {
  SceneStudy study;
  for (const char* method : {"sobol", "asos"}) {
    const auto ladder = ladder_of(method, {});
    ASSERT_TRUE(ladder);
    for (const LadderStep& step : *ladder) study.points.emplace_back().rung = step;
  }
  const StudyPoint* anchor = anchor_of(study.points);
  ASSERT_NE(anchor, nullptr);
  EXPECT_EQ(anchor->rung.method, "asos");
  EXPECT_EQ(anchor->rung.settings.asos.eps, AsosSettings{}.eps);
  EXPECT_EQ(anchor->rung.settings.asos.max_level, AsosSettings{}.max_level);
}

// The plot of RMSE shows ASOS's bias as a horizontal line, if it was measured.
TEST(Plots, ShowAsosOwnBias) {
  const test::TemporaryFolder folder;
  SceneReport scene = paper_report().scenes.front();
  ASSERT_TRUE(scene.study.bias);
  const auto plots = draw_plots(scene, folder.path().string(), "office");
  ASSERT_TRUE(plots) << plots.error().message();
  const std::string rmse = test::content_of(folder.path() / "office-rmse.gp");
  EXPECT_TRUE(contains(rmse, "\n0.01 with lines dt 4")) << rmse;
  EXPECT_TRUE(contains(rmse, "title \"ASOS's own bias, at most\""));
  scene.study.bias.reset();
  ASSERT_TRUE(draw_plots(scene, folder.path().string(), "office"));
  EXPECT_FALSE(contains(test::content_of(folder.path() / "office-rmse.gp"), "bias"));
}

TEST(Plots, NameTheRendersThatEndedEarly) {
  const test::TemporaryFolder folder;
  SceneReport scene = paper_report().scenes.front();
  const auto note_of = [&](bool finished) {
    scene.study.while_rendering = {{"sobol", "256 spp", finished, {{0.5, 0.25}, {1.0, 0.125}}}};
    const auto plots = draw_plots(scene, folder.path().string(), "office");
    return plots && plots->size() == 2 ? plots->back().note : "not drawn";
  };
  EXPECT_TRUE(contains(note_of(false), "sobol 256 spp ended early"));
  EXPECT_FALSE(contains(note_of(true), "sobol"));
}

TEST(PaperRows, StandBesideThePublishedRatios) {
  const auto rows = paper_rows(paper_report());
  ASSERT_GE(rows.size(), 2u);
  EXPECT_NEAR(rows[0].published_ratio(), 73.70 / 23.65, 1e-12);
  EXPECT_NEAR(rows[0].ratio(), 3.0, 1e-12);
  EXPECT_NEAR(rows[1].published_ratio(), 383.10 / 27.71, 1e-12);
  EXPECT_NEAR(rows[1].ratio(), 8.0, 1e-12);
}

TEST(PaperRows, SayWhatTheSameErrorTakes) {
  const auto rows = paper_rows(paper_report());
  // Stochastic sampling reaches an error of 0.02 with 16 samples, in 6 s.
  ASSERT_TRUE(rows[0].equal_error);
  EXPECT_NEAR(rows[0].equal_error->speedup, 3.0, 1e-9);
  EXPECT_TRUE(paper_rows({}).empty());
}

TEST(PaperRows, AreTheCasesOfTable2WithTheirPublishedTimes) {
  // CGF'98 table 2: figure, times of ASOS and stochastic sampling (0: n/a); last: section 7.4.
  struct Published {
    const char* figure;
    double asos, stochastic;
  };
  const std::array<Published, 11> table{{{"10", 23.65, 73.70},
                                         {"11", 27.71, 383.10},
                                         {"12", 35.98, 0.0},
                                         {"14", 158.01, 0.0},
                                         {"15", 353.55, 539.42},
                                         {"16", 49.19, 308.26},
                                         {"17", 92.25, 0.0},
                                         {"18", 182.83, 0.0},
                                         {"19", 225.90, 0.0},
                                         {"20", 28.74, 0.0},
                                         {"21", 2.48, 0.0}}};
  ASSERT_EQ(paper_cases.size(), table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_STREQ(paper_cases[i].figure, table[i].figure);
    EXPECT_EQ(paper_cases[i].asos_minutes, table[i].asos) << table[i].figure;
    EXPECT_EQ(paper_cases[i].rival_minutes, table[i].stochastic) << table[i].figure;
  }
}

TEST(HtmlPaper, CountsWinsInWordsAndHasGi93sTables) {
  const std::string text = html_paper(paper_report());
  EXPECT_TRUE(contains(text, "faster here in <strong>2</strong>"));
  EXPECT_TRUE(contains(text, "by the published ratio or more in <strong>0</strong>"));
  EXPECT_TRUE(contains(text, "23.65 / 73.70"));
  EXPECT_TRUE(contains(text, "<th>covers</th><th>mask</th>"));
  for (const char* primitive : {"sphere", "polygon", "disk", "box", "cone", "cylinder"})
    EXPECT_TRUE(contains(text, "<tr><td class=\"t\">" + std::string(primitive) + "</td>"));
}

// The papers' criticism of other methods, measured: errors of asos, sobol, cone, covers and mask.
TEST(MethodFaults, AreThoseThatThePapersDescribe) {
  const auto faults = method_faults();
  ASSERT_TRUE(faults) << faults.error().message();
  ASSERT_EQ(faults->size(), 5u);
  const auto error = [&](const char* method, std::size_t subject) {
    for (const MethodFaults& of : *faults)
      if (of.method == method) return of.errors[subject];
    ADD_FAILURE() << method;
    return 0.0;
  };
  for (const std::size_t subject : {0u, 1u})  // cards behind each other and side by side
    for (const char* fractions : {"cone", "covers"})
      EXPECT_GT(error(fractions, subject), 5.0 * error("asos", subject)) << fractions << subject;
  for (std::size_t subject = 0; subject < fault_subjects.size(); ++subject)
    for (const char* other : {"sobol", "cone", "covers", "mask"})
      EXPECT_LT(error("asos", subject), error(other, subject)) << other << ' ' << subject;
  EXPECT_GT(error("mask", 4), 3.0 * error("asos", 4)) << "wires between the points of masks";
}

TEST(SubdivisionTables, CountAsPublished) {
  const auto tables = subdivision_tables();
  ASSERT_TRUE(tables) << tables.error().message();
  ASSERT_EQ(tables->size(), 2u);
  for (const SubdivisionTable& table : *tables) {
    ASSERT_EQ(table.measured.size(), table.published.size()) << table.title;
    for (std::size_t i = 0; i < table.published.size(); ++i) {
      const SubdivisionRow& published = table.published[i];
      const SubdivisionRow& measured = table.measured[i];
      EXPECT_EQ(measured.level, published.level) << table.title;
      EXPECT_EQ(measured.marginal, published.marginal) << table.title;
      EXPECT_EQ(measured.in, published.in) << table.title;
      EXPECT_EQ(measured.out, published.out) << table.title;
      EXPECT_NEAR(measured.change, published.change, 0.5e-4) << table.title;
    }
  }
}

TEST(PointsCsv, QuotesWhatNeedsIt) {
  StudyReport report = paper_report();
  report.scenes[0].study.scene = "a, \"b\".glb";
  EXPECT_TRUE(
      contains(points_csv(report), "\n\"a, \"\"b\"\".glb\",asos,MAX 2 EPS 1/8,1,2.000000,"));
}

TEST(ProgressCsv, HasALineForEachPicture) {
  StudyReport report = paper_report();
  report.scenes[0].study.while_rendering = {
      {"asos", "MAX 4 EPS 1/256", true, {{0.5, 0.25}, {1.0, 0.125}}}};
  EXPECT_EQ(progress_csv(report),
            "scene,method,setting,picture,seconds,rmse\n"
            "builtin:office,asos,MAX 4 EPS 1/256,1,0.500000,2.500000e-01\n"
            "builtin:office,asos,MAX 4 EPS 1/256,2,1.000000,1.250000e-01\n");
}

TEST(HtmlScene, SaysHowAsosDoesWhileItRenders) {
  SceneReport scene = paper_report().scenes[0];
  scene.regions.region.resize(1);
  scene.study.at_moments = {{"1 spp", 0.5, 0.1, 0.05, 0.5, false},
                            {"4 spp", 2.0, 0.05, 0.1, 2.0, false},
                            {"64 spp", 8.0, 0.01, 0.001, 0.1, true}};
  Embedder embed;
  const std::string text = html_scene(scene, {}, 1, embed);
  EXPECT_TRUE(contains(text, "<td class=\"win\">0.50</td>"));
  EXPECT_TRUE(contains(text, "<td class=\"loss\">2.00 worse</td>"));
  EXPECT_TRUE(contains(text, "<td class=\"under\">under the floor</td>"));
}

TEST(HtmlSummary, NamesTheWinnerAndTheLoser) {
  StudyReport report = paper_report();
  SceneStudy& study = report.scenes[0].study;
  study.points = {point("asos", "MAX 2", 2, 0.02), point("uniform", "1 spp", 3, 0.05),
                  point("uniform", "4 spp", 12, 0.01), point("sobol", "1 spp", 0.5, 0.05),
                  point("sobol", "4 spp", 1.9, 0.01)};
  analyse(study);
  const std::string text = html_summary(report);
  EXPECT_TRUE(contains(text, "<strong>faster</strong> than uniform"));
  EXPECT_TRUE(contains(text, "<strong>slower</strong> than sobol"));
  EXPECT_TRUE(contains(text, "ASOS loses"));
  EXPECT_TRUE(contains(text, "<td class=\"t loss\">slower:"));
  EXPECT_TRUE(contains(text, "there is no ASOS picture at all"))
      << "sobol is quicker than all others";
}

TEST(HtmlSummary, EscapesWhatAPathIsMadeOf) {
  StudyReport report = paper_report();
  report.scenes[0].study.scene = "<b>&.glb";
  EXPECT_TRUE(contains(html_summary(report), "&lt;b&gt;&amp;.glb"));
  EXPECT_EQ(html_summary(report).find("<b>&"), std::string::npos);
}

TEST(HtmlText, WritesNumbersForAPerson) {
  EXPECT_EQ(seconds_text(0.01234), "12.3 ms");
  EXPECT_EQ(seconds_text(12.34), "12.3 s");
  EXPECT_EQ(seconds_text(250.0), "4 min 10 s");
  EXPECT_EQ(factor_text(0.454), "0.45");
  EXPECT_EQ(factor_text(12.34), "12.3");
  EXPECT_EQ(count_text(1234567), "1\u202f234\u202f567");
  EXPECT_EQ(list_text({"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(outcome_of(1.04), Outcome::even);
  EXPECT_EQ(outcome_of(0.9), Outcome::loss);
}

TEST(ErrorColour, GrowsBrighter) {
  double last = -1.0;
  for (int i = 0; i <= 20; ++i) {
    const glm::u8vec3 c = error_colour(i / 20.0);
    const double brightness = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
    EXPECT_GT(brightness, last) << i;
    last = brightness;
  }
  EXPECT_EQ(error_colour(7.0), error_colour(1.0));
}

}  // namespace
}  // namespace asos
