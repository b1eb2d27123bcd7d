#include "renderer/study/floor_bound.h"
#include "renderer/study/reference.h"
#include "renderer/study/timed_render.h"
#include "tests/ui/panels_fixture.h"
#include "ui/panels/study_export.h"
#include "ui/panels/study_marks.h"
#include "ui/panels/study_plot.h"
#include "ui/theme.h"
#include "ui/view_study.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

/// Waits for at most a minute.
bool eventually(const std::function<bool()>& done) {
  const auto start = std::chrono::steady_clock::now();
  while (!done()) {
    if (std::chrono::steady_clock::now() - start > std::chrono::minutes(1)) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

class ViewStudyTest : public testing::Test {
 protected:
  ViewStudyTest() {
    subject.scene = prepare(test::grating()).value();
    subject.camera = subject.scene->world().cameras.front();
    subject.plan.scenes = {"grating"};
    subject.plan.methods = {"asos", "average", "stochastic"};
    subject.plan.width = 16;
    subject.plan.height = 12;
    subject.plan.repetitions = 2;
    subject.plan.budget_seconds = 0.05;
    subject.plan.threads = 2;
  }
  /// A plan so large that no test waits for its end.
  [[nodiscard]] ViewStudy::Subject endless() const {
    ViewStudy::Subject large = subject;
    large.plan.width = large.plan.height = 512;
    large.plan.repetitions = 99;
    return large;
  }
  [[nodiscard]] Film render(const Job& job) const {
    return timed_render({subject.scene, subject.camera, job.rung.settings, false})->film;
  }
  /// The reference of both halves of the first passes.
  [[nodiscard]] Reference reference(const std::vector<Job>& jobs, int passes) const {
    Reference made;
    std::vector<Film> halves;
    for (const Job& job : jobs) {
      if (job.kind != JobKind::reference || job.pass >= passes) continue;
      halves.push_back(render(job));
      if (halves.size() < 2) continue;
      made.add(halves[0], halves[1], reference_samples(job.pass));
      halves.clear();
    }
    return made;
  }

  ViewStudy::Subject subject;
  ViewStudy study;
};

TEST_F(ViewStudyTest, FindsWhatTheJobsOfItsPlanGive) {
  ASSERT_TRUE(study.start(subject).has_value());
  ASSERT_TRUE(eventually([&] { return !study.busy(); }));
  const ViewStudy::State state = study.state();
  EXPECT_EQ(state.phase, ViewStudy::Phase::finished);
  ASSERT_GE(state.passes, 1);

  const std::vector<Job> jobs = make_jobs(subject.plan).value();
  const Reference truth = reference(jobs, state.passes);
  EXPECT_EQ(state.study.noise, truth.noise());
  ASSERT_EQ(state.study.points.size(), 9u + 1u + 5u);
  EXPECT_EQ(state.points, 2u * state.study.points.size() + 3u)
      << "one render of each method is watched";
  EXPECT_EQ(state.points_run, state.points);
  std::size_t next = 0;
  for (const Job& job : jobs) {
    if (job.kind != JobKind::point || job.repetition > 1) continue;
    const StudyPoint& point = state.study.points[next++];
    EXPECT_EQ(point.rung.setting, job.rung.setting);
    EXPECT_EQ(point.measures.rmse, measure(render(job), truth.film()).rmse) << job.title();
    EXPECT_EQ(point.costs.size(), 2u);
    EXPECT_TRUE(point.same_picture);
  }
  ASSERT_EQ(state.study.while_rendering.size(), 3u);
  for (const RenderCurve& curve : state.study.while_rendering) {
    EXPECT_TRUE(curve.finished);
    ASSERT_FALSE(curve.points.empty());
    const auto finished = std::find_if(
        state.study.points.begin(), state.study.points.end(), [&](const StudyPoint& point) {
          return point.rung.method == curve.method && point.rung.setting == curve.setting;
        });
    ASSERT_NE(finished, state.study.points.end());
    EXPECT_EQ(curve.points.back().error, finished->measures.rmse) << curve.method;
  }
  SceneStudy again = state.study;
  analyse(again);
  ASSERT_FALSE(again.equal_error.empty());
  ASSERT_EQ(again.equal_error.size(), state.study.equal_error.size());
  for (std::size_t i = 0; i < again.equal_error.size(); ++i)
    EXPECT_EQ(again.equal_error[i].speedup, state.study.equal_error[i].speedup);
}

// The time per sample is so long that the full size would take far too long.
TEST(StudyInTime, SizeFollowsFromTheScenesCost) {
  StudyPlan plan{.methods = {"asos", "sobol"}, .width = 1280, .height = 640, .repetitions = 3};
  const StudyPlan cheap = ViewStudy::plan_in_time(plan, 1e-9, 60.0);
  EXPECT_EQ(cheap.width, 1280);
  const StudyPlan dear = ViewStudy::plan_in_time(plan, 1e-6, 60.0);
  EXPECT_EQ(dear.repetitions, 1);
  EXPECT_NEAR(dear.width, 2 * dear.height, 2);
  // 16 times the 256 samples of the finest setting, 341 of Sobol, and nine settings of ASOS
  const double samples = 16 * 256 + 341 + 9 * 24;
  EXPECT_NEAR(1e-6 * dear.width * dear.height * samples, 45.0, 1.0);
  EXPECT_EQ(ViewStudy::plan_in_time(plan, 1.0, 60.0).width, 32) << "the minimum size";
}

TEST_F(ViewStudyTest, EndsInTimeWithAVerdict) {
  ViewStudy::Subject large = endless();
  large.seconds = 2.0;
  ASSERT_TRUE(study.start(large).has_value());
  ASSERT_TRUE(eventually([&] { return !study.busy(); }));
  const ViewStudy::State state = study.state();
  EXPECT_EQ(state.phase, ViewStudy::Phase::finished);
  EXPECT_EQ(state.points_run, state.points) << "given up or measured";
  ASSERT_FALSE(state.study.points.empty());
  EXPECT_LE(state.study.points[0].rung.settings.width, 512);
}

// Until they are known, their search shares the processors.
TEST_F(ViewStudyTest, RendersOnceTheBoundariesAreKnown) {
  ViewStudy::Subject fresh = endless();
  fresh.scene = prepare(load_scene("builtin:mixed").value()).value();
  fresh.camera = fresh.scene->world().cameras.front();
  ASSERT_TRUE(study.start(fresh).has_value());
  ASSERT_TRUE(eventually([&] { return !study.state().doing.empty(); }));
  EXPECT_TRUE(fresh.scene->geometry->boundaries.known());
}

TEST_F(ViewStudyTest, StopsAndKeepsWhatItFound) {
  ASSERT_TRUE(study.start(endless()).has_value());
  ASSERT_TRUE(eventually([&] { return study.state().points_run > 0; }));
  EXPECT_FALSE(study.start(subject).has_value()) << "one at a time";
  study.stop();
  ASSERT_TRUE(eventually([&] { return !study.busy(); }));
  const ViewStudy::State state = study.state();
  EXPECT_EQ(state.phase, ViewStudy::Phase::stopped);
  EXPECT_LT(state.points_run, state.points);
  EXPECT_EQ(state.study.points.size(), std::min<std::size_t>(state.points_run, 16));
  EXPECT_TRUE(study.start(subject).has_value());
}

TEST_F(ViewStudyTest, RestsWhileDisturbedAndRunsEachJobOnce) {
  study.update(true);
  ASSERT_TRUE(study.start(subject).has_value());
  ASSERT_TRUE(eventually([&] { return study.state().resting; }));
  EXPECT_EQ(study.state().passes, 0);
  for (int i = 0; i < 20; ++i) {
    study.update(i % 2 == 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  study.update(false);
  ASSERT_TRUE(eventually([&] { return !study.busy(); }));
  EXPECT_EQ(study.state().phase, ViewStudy::Phase::finished);
  for (const StudyPoint& point : study.state().study.points)
    EXPECT_EQ(point.costs.size(), 2u) << point.rung.setting;
}

TEST_F(ViewStudyTest, EndsWhileItRests) {
  study.update(true);
  ASSERT_TRUE(study.start(subject).has_value());
  ASSERT_TRUE(eventually([&] { return study.state().resting; }));
  study.clear();
  EXPECT_EQ(study.scene(), nullptr);
  EXPECT_EQ(study.state().phase, ViewStudy::Phase::none);
  EXPECT_TRUE(eventually([&] { return !study.busy(); }));
}

TEST_F(ViewStudyTest, SaysWhatItCannotDo) {
  ViewStudy::Subject wrong = subject;
  wrong.scene = nullptr;
  EXPECT_FALSE(study.start(wrong).has_value());
  wrong = subject;
  wrong.plan.methods = {"asos", "guessing"};
  const auto started = study.start(wrong);
  ASSERT_FALSE(started.has_value());
  EXPECT_NE(started.error().message().find("guessing"), std::string::npos);
  EXPECT_FALSE(study.busy());
}

TEST(StudyPlot, AxesHoldWholeDecades) {
  const LogAxis axis = axis_over({0.02, 3.0, 0.0, std::nan("")});
  EXPECT_EQ(axis.first_decade, -2);
  EXPECT_EQ(axis.decades, 3);
  EXPECT_DOUBLE_EQ(axis.share(0.01), 0.0);
  EXPECT_DOUBLE_EQ(axis.share(1.0), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(axis.share(10.0), 1.0);
  EXPECT_EQ(axis_over({0.1}).decades, 1) << "a decade alone has no length";
  EXPECT_EQ(axis_over({}).decades, 1);
}

TEST(StudyPlot, ShowsPointsByCurveAndLeavesOutWhatHasNoLogarithm) {
  SceneStudy study;
  const auto add = [&](const char* method, const char* curve, double seconds, double rmse) {
    StudyPoint point{.rung = {.method = method, .curve = curve},
                     .costs = {{seconds, seconds, 0.0}},
                     .measures = {.rmse = rmse}};
    study.points.push_back(point);
  };
  add("asos", "asos EPS 0", 0.02, 0.01);
  add("sobol", "sobol", 0.01, 0.05);
  add("asos", "asos EPS 0", 0.04, 0.002);
  add("asos", "asos EPS 0", 0.08, 0.0);
  study.floor = 0.0005;
  const StudyPlot plot = plot_of(study);
  ASSERT_EQ(plot.lines.size(), 2u);
  EXPECT_EQ(plot.lines[0].curve, "asos EPS 0");
  EXPECT_EQ(plot.lines[0].marks.size(), 2u);
  EXPECT_EQ(plot.lines[1].marks.size(), 1u);
  EXPECT_EQ(plot.rmse.first_decade, -4) << "the floor is on the axis";
  EXPECT_EQ(plot.rmse.decades, 3);
  for (const std::string& method : default_methods())
    EXPECT_TRUE(method == "average" || method_colour(method) != theme::plot_text) << method;
}

// CIELAB of a colour for normal sight, or for one kind of colour blindness (Machado, Oliveira and
// Fernandes 2009, severity 1).
glm::dvec3 lab_of(std::uint32_t rgb, const glm::dmat3& sight) {
  const auto linear = [&](int shift) {
    const double c = static_cast<double>(rgb >> shift & 255u) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const glm::dvec3 seen =
      glm::clamp(glm::dvec3(linear(16), linear(8), linear(0)) * sight, 0.0, 1.0);
  const glm::dmat3 to_xyz(0.4339, 0.3763, 0.1899, 0.2126, 0.7152, 0.0722, 0.0177, 0.1095, 0.8728);
  const auto curve = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const glm::dvec3 xyz = seen * to_xyz;
  const glm::dvec3 f(curve(xyz.x), curve(xyz.y), curve(xyz.z));
  return {116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z)};
}

TEST(StudyMarks, DifferForEveryoneByColourAndShape) {
  const glm::dmat3 sights[] = {
      glm::dmat3(1.0),
      {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998},
      {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881},
      {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
       0.303900}};
  const std::vector<std::string> all = ladder_methods();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_NE(method_mark(all[i]), method_mark(all[j])) << all[i] << all[j];
  const std::vector<std::string> methods = default_methods();
  ASSERT_GE(methods.size(), 10u);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (const glm::dmat3& sight : sights) {
        const glm::dvec3 a = lab_of(method_colour(methods[i]), sight);
        const glm::dvec3 b = lab_of(method_colour(methods[j]), sight);
        EXPECT_GT(glm::distance(a, b), 28.0) << methods[i] << ' ' << methods[j];
      }
    }
  }
}

TEST(StudyMarks, NamesAreTheButtons) {
  EXPECT_EQ(method_title("sobol-adaptive"), "Adaptive Sobol");
  EXPECT_EQ(curve_title("whitted spheres", "whitted"), "Whitted spheres");
  EXPECT_EQ(method_title("guessing"), "guessing");
}

SceneStudy small_study() {
  SceneStudy study{.scene = "a, b"};
  StudyPoint point;
  point.rung.method = point.rung.curve = "sobol";
  point.rung.setting = "16 spp";
  point.costs = {{0.5, 0.25, 0.0}};
  point.measures.rmse = 0.01;
  point.rays = 7;
  study.points = {point};
  study.while_rendering = {{"asos", "EPS 1/256", true, {{0.5, 0.002}}}};
  study.floor = 0.003;
  return study;
}

TEST(StudyExport, WritesAllPointsAsCsv) {
  EXPECT_EQ(study_csv(small_study()),
            "scene,picture,method,setting,cpu_seconds,rmse,below_noise_floor,noise_floor,rays\n"
            "\"a, b\",finished,Sobol,16 spp,0.25,0.01,0,0.003,7\n"
            "\"a, b\",while rendering,ASOS,EPS 1/256,0.5,0.002,1,0.003,\n");
}

TEST(StudyExport, DrawsThePlotAsSvg) {
  const std::string svg = plot_svg(plot_of(small_study()), "a & b");
  EXPECT_TRUE(svg.starts_with("<svg xmlns=")) << svg;
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  const std::string colour = fmt::format("#{:06x}", method_colour("sobol"));
  for (const std::string& part :
       {std::string(">a &amp; b<"), std::string(">Sobol<"), std::string(">noise floor<"), colour,
        std::string(">RMSE, linear")})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
}

// Two curves of a method had the same colour and mark.
TEST(StudyPlot, ASecondCurveOfAMethodIsDashed) {
  SceneStudy study = small_study();
  StudyPoint point = study.points.front();
  for (const char* curve : {"whitted", "whitted spheres"}) {
    point.rung.method = "whitted";
    point.rung.curve = curve;
    for (const double seconds : {0.5, 1.0}) {
      point.costs = {{seconds, seconds, 0.0}};
      study.points.push_back(point);
    }
  }
  const StudyPlot plot = plot_of(study);
  ASSERT_EQ(plot.lines.size(), 3u);
  EXPECT_FALSE(plot.lines[0].dashed);
  EXPECT_FALSE(plot.lines[1].dashed);
  EXPECT_TRUE(plot.lines[2].dashed);
  EXPECT_EQ(legend_words(plot.lines[1]), "Whitted");
  EXPECT_EQ(legend_words(plot.lines[2]), "Whitted spheres (dashed)");
  EXPECT_NE(plot_svg(plot, "").find("stroke-width=\"2\" stroke-dasharray"), std::string::npos);
}

TEST(StudyExport, SaysWhatCannotBeWritten) {
  const auto saved = save_study_text("/no/such/folder", "fence", "csv", "text");
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().message(), "/no/such/folder/fence-study-001.csv: cannot be written");
}

TEST(StudyPlot, ShowsPicturesWhileTheyRender) {
  SceneStudy study{
      .floor = 0.0005,
      .while_rendering = {{"asos", "MAX 4 EPS 1/256", true, {{0.01, 0.1}, {0.02, 0.0004}}},
                          {"sobol", "256 spp", true, {{0.01, 0.2}, {0.02, 0.0}}}}};
  EXPECT_TRUE(plot_of(study).lines.empty());
  const StudyPlot plot = plot_of(study, StudyCurves::while_rendering);
  ASSERT_EQ(plot.lines.size(), 2u);
  EXPECT_EQ(plot.lines[0].curve, "asos MAX 4 EPS 1/256");
  EXPECT_EQ(plot.lines[0].method, "asos");
  ASSERT_EQ(plot.lines[0].marks.size(), 2u);
  EXPECT_FALSE(plot.lines[0].marks[0].under_floor);
  EXPECT_TRUE(plot.lines[0].marks[1].under_floor);
  EXPECT_EQ(plot.lines[1].marks.size(), 1u);
}

class StudyPanelTest : public PanelsTest {
 protected:
  StudyPanelTest() {
    for (const char* other : {"Antialiasing", "Shadows", "Display", "Camera", "Statistics"})
      rig.click(std::string("section/") + other);
    rig.click_each({"section/Error vs. time"});
    StudyChoice& choice = rig.state().study;
    choice.rivals = {"average"};
    choice.automatic = false;
    choice.budget_seconds = 1;
    choice.repetitions = 1;
    rig.frame();
    rig.click("Resolution/1/4");
  }
  void open(const std::string& source) {
    ASSERT_TRUE(rig.opens(source));
    rig.frame();
  }
  [[nodiscard]] ViewStudy::State state() { return rig.content().study().state(); }
  [[nodiscard]] double bound_of(const char* method) {
    const auto bound = bound_at_floor(state().study, method);
    return bound ? bound->factor : 0.0;
  }
  /// Number of pixels with the method's colour.
  [[nodiscard]] int pixels_in_plot(const char* method) {
    rig.frame();
    const Controls::Placed plot = rig.control("Study plot");
    const std::uint32_t rgb = method_colour(method);
    const glm::u8vec3 colour(rgb >> 16, rgb >> 8 & 255u, rgb & 255u);
    const std::vector<glm::u8vec3> pixels = rig.pixels();
    int coloured = 0;
    for (int y = static_cast<int>(plot.lo.y); y < static_cast<int>(plot.hi.y); ++y)
      for (int x = static_cast<int>(plot.lo.x); x < static_cast<int>(plot.hi.x); ++x)
        coloured += pixels[static_cast<std::size_t>(y * rig.size().x + x)] == colour;
    return coloured;
  }
  [[nodiscard]] bool shown(const std::string& name) {
    rig.frame();
    return rig.controls().contains(name);
  }
};

TEST_F(StudyPanelTest, RunsAStudyOfTheViewAndPlotsIt) {
  rig.set_pixel_size(1);
  EXPECT_TRUE(rig.settle());
  open("grating");
  EXPECT_FALSE(shown("Study plot"));
  rig.click("Measure");
  EXPECT_TRUE(rig.content().study().busy());
  EXPECT_TRUE(shown("Stop measuring"));
  ASSERT_TRUE(rig.frames_until([&] { return !rig.content().study().busy(); }));
  const ViewStudy::State found = state();
  EXPECT_EQ(found.phase, ViewStudy::Phase::finished);
  ASSERT_EQ(found.study.points.size(), 9u + 1u);
  const RenderSettings& settings = found.study.points[0].rung.settings;
  EXPECT_EQ(settings.width, rig.render().settings().width / 4);
  EXPECT_EQ(settings.height, rig.render().settings().height / 4);
  // All settings of ASOS may be exact here, below the noise floor: then only a bound is known.
  EXPECT_EQ(shown("Slower/average"), !found.study.equal_error.empty() || bound_of("average") > 1.0);

  EXPECT_GT(pixels_in_plot("asos"), 50) << "marks and lines of asos, one error at all settings";
  const int finished = pixels_in_plot("average");
  ASSERT_EQ(found.study.while_rendering.size(), 2u);
  rig.click("Curves/While rendering");
  EXPECT_EQ(rig.state().study.curves, StudyCurves::while_rendering);
  EXPECT_GT(pixels_in_plot("average"), 2 * finished) << "a curve instead of a single point";
  rig.click("Curves/Finished");
  EXPECT_EQ(pixels_in_plot("average"), finished);

  rig.click_each({"Copy plot"});
  EXPECT_EQ(rig.state().message, "Copied the plot as SVG");
  rig.click("Enlarge plot");
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_GT(rig.control("Close plot").lo.y, 0.85f * static_cast<float>(rig.size().y))
      << "the plot fills the window";
}

TEST(StudyPanel, RoundsLowerBoundsDown) {
  EXPECT_EQ(over_words(12.96), "over 12");
  EXPECT_EQ(over_words(128.6), "over 128");
  EXPECT_EQ(over_words(3.49), "over 3.4");
  EXPECT_EQ(over_words(1.02), "over 1");
}

// It took the place of a verdict on the scenes that ASOS renders best.
TEST_F(StudyPanelTest, GivesALowerBoundWhereAsosIsExact) {
  // Two triangles are exact: every setting of ASOS is below the reference's noise.
  rig.click("Measure");
  ASSERT_TRUE(rig.frames_until([&] { return !rig.content().study().busy(); }));
  ASSERT_TRUE(state().study.equal_error.empty());
  const double bound = bound_of("average");
  EXPECT_GT(bound, 0.0);
  EXPECT_EQ(shown("Slower/average"), bound > 1.0);
  EXPECT_EQ(shown("Nothing to compare"), bound <= 1.0);
  if (bound > 1.0) {
    EXPECT_EQ(rig.control("Slower/average").words, over_words(bound));
  }
}

TEST_F(StudyPanelTest, TheButtonStops) {
  rig.state().study.repetitions = 9;
  rig.click("Resolution/Full");
  rig.click_each({"Measure"});
  rig.click("Stop measuring");
  ASSERT_TRUE(rig.frames_until([&] { return !rig.content().study().busy(); }));
  EXPECT_EQ(state().phase, ViewStudy::Phase::stopped);
  EXPECT_TRUE(shown("Measure"));
}

TEST_F(StudyPanelTest, AnotherSceneEndsTheStudyOfTheOneBefore) {
  rig.state().study.repetitions = 9;
  rig.click("Resolution/Full");
  rig.click("Measure");
  ASSERT_NE(rig.content().study().scene(), nullptr);
  open("point light");
  EXPECT_EQ(rig.content().study().scene(), nullptr);
  EXPECT_EQ(state().phase, ViewStudy::Phase::none);
  EXPECT_TRUE(rig.frames_until([&] { return !rig.content().study().busy(); }));
}

TEST_F(StudyPanelTest, TheCameraMovesWhileAStudyRuns) {
  rig.state().study.repetitions = 9;
  rig.click("Resolution/Full");
  rig.click("Measure");
  const glm::dmat4 before = rig.camera().camera().world_from_camera;
  rig.drag({200, 200}, {260, 180});
  EXPECT_NE(rig.camera().camera().world_from_camera, before);
  EXPECT_TRUE(rig.settle()) << "the window renders to the end";
  EXPECT_TRUE(rig.content().study().busy());
}

TEST_F(StudyPanelTest, ItsControlsChooseWhatIsMeasured) {
  const StudyChoice& choice = rig.state().study;
  rig.click("Study/sobol");
  EXPECT_TRUE(choice.rivals.contains("sobol"));
  rig.click("Study/average");
  EXPECT_FALSE(choice.rivals.contains("average"));
  rig.click("Resolution/1/2");
  EXPECT_EQ(choice.reduction, 2);
  slide("Reference time", 0.1f, 2.0f);
  EXPECT_EQ(choice.budget_seconds, 600);
  RenderSettings shown{.width = 641,
                       .height = 3,
                       .texture = {.resolution = 3},
                       .mirror = {.bounces = 2},
                       .threads = 5};
  const StudyPlan plan = plan_of(choice, "scene", shown);
  EXPECT_EQ(plan.methods, (std::vector<std::string>{"asos", "sobol"}));
  EXPECT_EQ(plan.width, 320);
  EXPECT_EQ(plan.height, 1);
  EXPECT_EQ(plan.threads, 5);
  EXPECT_EQ(plan.look.reflections, 2);
  EXPECT_EQ(plan.texture_resolution, 3);
  for (const char* name : {"Study/sobol", "Resolution/Full", "Resolution/1/2", "Resolution/1/4",
                           "Reference time", "Repetitions", "Measure"})
    EXPECT_TRUE(rig.control(name).has_tooltip) << name;
}

}  // namespace
}  // namespace asos
