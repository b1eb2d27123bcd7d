#include "app/report/job_record.h"

#include "app/output_file.h"
#include "renderer/files/read_file.h"
#include "renderer/film/image_io.h"
#include "renderer/settings/names.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace asos {
namespace fs = std::filesystem;
namespace {

using json = nlohmann::ordered_json;

template <typename T>
json json_or_null(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

template <typename T>
std::optional<T> value_or_none(const json& j) {
  if (j.is_null()) return std::nullopt;
  return j.get<T>();
}

json plan_dfr_json(const std::optional<Dfr>& dfr) {
  if (!dfr) return nullptr;
  json j{{"perturbation", dfr->perturbation}, {"rgb", json::array()}};
  for (const DfrCurve& c : dfr->rgb) j["rgb"].push_back({c.min, c.max, c.exponent});
  return j;
}

std::optional<Dfr> plan_dfr_of(const json& j) {
  if (j.is_null()) return std::nullopt;
  Dfr dfr;
  dfr.perturbation = j.at("perturbation").get<double>();
  for (std::size_t i = 0; i < dfr.rgb.size(); ++i) {
    const auto curve = j.at("rgb").at(i).get<std::array<double, 3>>();
    dfr.rgb[i] = {curve[0], curve[1], curve[2]};
  }
  return dfr;
}

json moment_json(const std::optional<StudyMoment>& moment) {
  if (!moment) return nullptr;
  return {{"animation", json_or_null(moment->animation)}, {"seconds", moment->seconds}};
}

/// Does not read the sky: a report that is assembled from jobs does not need it.
StudyLook plan_look_of(const json& j) {
  StudyLook look;
  look.camera = {value_or_none<int>(j.at("camera")),
                 value_or_none<std::array<double, 6>>(j.at("look_at")),
                 value_or_none<double>(j.at("fov"))};
  if (const json& moment = j.value("moment", json()); !moment.is_null())
    look.moment = StudyMoment{value_or_none<std::string>(moment.at("animation")),
                              moment.at("seconds").get<double>()};
  look.sky = j.at("sky").get<std::string>();
  look.reflections = j.at("reflections").get<int>();
  look.roughest_mirror = j.at("roughest_mirror").get<double>();
  look.dfr = plan_dfr_of(j.at("dfr"));
  return look;
}

StudyPlan plan_of(const json& j) {
  StudyPlan plan;
  plan.scenes = j.at("scenes").get<std::vector<std::string>>();
  plan.methods = j.at("methods").get<std::vector<std::string>>();
  plan.width = j.at("width").get<int>();
  plan.height = j.at("height").get<int>();
  plan.repetitions = j.at("repetitions").get<int>();
  plan.budget_seconds = j.at("budget_seconds").get<double>();
  plan.patient = j.value("patient", true);
  plan.longest_seconds = j.at("longest_seconds").get<double>();
  plan.threads = j.at("threads").get<int>();
  plan.paper = j.at("paper").get<bool>();
  plan.look = plan_look_of(j);
  plan.texture_resolution = j.at("texture_resolution").get<int>();
  plan.render_features = j.at("needs") == "all" ? FeatureChoice::all : FeatureChoice::scene;
  return plan;
}

Machine machine_of(const json& j) {
  const auto text = [&j](const char* key) { return j.at(key).get<std::string>(); };
  return {text("processor"), j.at("cores").get<int>(), j.at("memory_gb").get<double>(),
          text("system"),    text("version"),          text("commit"),
          text("compiler")};
}

JobRecord record_of(const json& j, const Job& job) {
  JobRecord record;
  record.job = job;
  record.machine = machine_of(j.at("machine"));
  record.when = j.at("when").get<std::string>();
  record.finished = j.at("finished").get<bool>();
  record.cost = {j.at("wall_seconds").get<double>(), j.at("cpu_seconds").get<double>(),
                 j.at("memory_mb").get<double>()};
  record.rays = j.at("rays").get<std::uint64_t>();
  record.pyrays = j.at("pyrays").get<std::uint64_t>();
  record.rejected_samples = j.at("rejected_samples").get<std::uint64_t>();
  record.picture_hash = j.at("picture_hash").get<std::string>();
  if (job.kind == JobKind::regions) {
    const json& scene = j.at("scene");
    record.scene = {scene.at("triangles").get<std::uint64_t>(), scene.at("memory_mb").get<double>(),
                    scene.at("lights").get<std::size_t>(),
                    scene.at("left_out").get<std::vector<std::string>>()};
  }
  if (job.kind == JobKind::progress) record.moments = j.at("moments").get<std::vector<double>>();
  return record;
}

Result<json> read_json(const std::string& path) {
  constexpr std::uint64_t most_bytes = std::uint64_t{64} << 20;
  const auto file = read_file(path, {most_bytes});
  if (!file) return tl::unexpected(Error{path, file.error()});
  json j = json::parse(file->begin(), file->end(), nullptr, false);
  if (j.is_discarded()) return tl::unexpected(Error{path, "is no JSON"});
  return j;
}

/// The job files of a folder, sorted by number.
Result<std::vector<std::pair<std::size_t, std::string>>> job_files_in(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    return tl::unexpected(Error{folder, "there is no such folder"});
  const std::string inner = jobs_folder(folder);
  const std::string from = fs::is_directory(inner, error) ? inner : folder;
  std::vector<std::pair<std::size_t, std::string>> files;
  for (const auto& entry : fs::directory_iterator(from, error)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ".json" || stem.size() > 9 || stem.empty() ||
        !std::all_of(stem.begin(), stem.end(), [](char c) { return c >= '0' && c <= '9'; }))
      continue;
    files.emplace_back(std::stoul(stem), entry.path().string());
  }
  if (error) return tl::unexpected(Error{from, error.message()});
  if (files.empty()) return tl::unexpected(Error{folder, "holds no job files (jobs/K.json)"});
  std::sort(files.begin(), files.end());
  return files;
}

/// Adds a file's record to `all`, or returns an error.
Result<void> add_record(JobRecords& all, std::size_t id, const std::string& path) {
  const Result<json> j = read_json(path);
  if (!j) return tl::unexpected(j.error());
  // nlohmann's accessors throw for missing values and for those of another type.
  try {
    const StudyPlan plan = plan_of(j->at("plan"));
    if (all.jobs.empty()) {
      auto jobs = make_jobs(plan);
      if (!jobs) return tl::unexpected(Error{path, jobs.error().message()});
      all.plan = plan;
      all.jobs = *std::move(jobs);
    }
    if (!(plan == all.plan))
      return tl::unexpected(Error{path, "is of another study than the files before it"});
    if (id >= all.jobs.size() || j->at("title").get<std::string>() != all.jobs[id].title())
      return tl::unexpected(Error{path, "is of another version of the program: no such job"});
    JobRecord record = record_of(*j, all.jobs[id]);
    record.folder = fs::path(path).parent_path().string();
    all.records.push_back(std::move(record));
  } catch (const json::exception& error) {
    return tl::unexpected(Error{path, fmt::format("is no job file: {}", error.what())});
  }
  return {};
}

}  // namespace

json plan_json(const StudyPlan& plan) {
  return {{"scenes", plan.scenes},
          {"methods", plan.methods.empty() ? default_methods() : plan.methods},
          {"width", plan.width},
          {"height", plan.height},
          {"repetitions", plan.repetitions},
          {"budget_seconds", plan.budget_seconds},
          {"patient", plan.patient},
          {"longest_seconds", plan.longest_seconds},
          {"threads", plan.threads},
          {"paper", plan.paper},
          {"camera", json_or_null(plan.look.camera.index)},
          {"look_at", json_or_null(plan.look.camera.look_at)},
          {"fov", json_or_null(plan.look.camera.fov_y_deg)},
          {"moment", moment_json(plan.look.moment)},
          {"sky", plan.look.sky},
          {"reflections", plan.look.reflections},
          {"roughest_mirror", plan.look.roughest_mirror},
          {"dfr", plan_dfr_json(plan.look.dfr)},
          {"texture_resolution", plan.texture_resolution},
          {"needs", name_in(needs_names, plan.render_features)}};
}

json machine_json(const Machine& machine) {
  return {{"processor", machine.processor}, {"cores", machine.cores},
          {"memory_gb", machine.memory_gb}, {"system", machine.system},
          {"version", machine.version},     {"commit", machine.commit},
          {"compiler", machine.compiler}};
}

std::string jobs_folder(const std::string& report_folder) {
  return (fs::path(report_folder) / "jobs").string();
}

std::string job_file(const std::string& folder, std::size_t id, const std::string& ending) {
  return (fs::path(folder) / fmt::format("{}{}", id, ending)).string();
}

std::string moment_ending(std::size_t number) {
  return fmt::format("-{}.exr", number + 1);
}

Result<void> write_record(const StudyPlan& plan, const JobRecord& record) {
  json j{{"id", record.job.id},
         {"title", record.job.title()},
         {"plan", plan_json(plan)},
         {"machine", machine_json(record.machine)},
         {"when", record.when},
         {"finished", record.finished},
         {"wall_seconds", record.cost.wall_seconds},
         {"cpu_seconds", record.cost.cpu_seconds},
         {"memory_mb", record.cost.memory_mb},
         {"rays", record.rays},
         {"pyrays", record.pyrays},
         {"rejected_samples", record.rejected_samples},
         {"picture_hash", record.picture_hash}};
  if (record.job.kind == JobKind::regions)
    j["scene"] = {{"triangles", record.scene.triangles},
                  {"memory_mb", record.scene.memory_mb},
                  {"lights", record.scene.lights},
                  {"left_out", record.scene.left_out}};
  if (record.job.kind == JobKind::progress) j["moments"] = record.moments;
  const std::string text = j.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
  return write_file_atomically(job_file(record.folder, record.job.id, ".json"),
                               {text.begin(), text.end()});
}

Result<JobRecords> read_records(const std::vector<std::string>& folders) {
  JobRecords all;
  for (const std::string& folder : folders) {
    const auto files = job_files_in(folder);
    if (!files) return tl::unexpected(files.error());
    for (const auto& [id, path] : *files)
      if (const auto added = add_record(all, id, path); !added)
        return tl::unexpected(added.error());
  }
  std::stable_sort(all.records.begin(), all.records.end(),
                   [](const JobRecord& a, const JobRecord& b) { return a.job.id < b.job.id; });
  const auto twice =
      std::adjacent_find(all.records.begin(), all.records.end(),
                         [](const auto& a, const auto& b) { return a.job.id == b.job.id; });
  if (twice != all.records.end())
    return tl::unexpected(
        Error{fmt::format("job {}", twice->job.id),
              fmt::format("is in {} as well as in {}", twice->folder, std::next(twice)->folder)});
  return all;
}

Result<void> write_regions(const std::string& path, const RegionMap& map) {
  RgbImage image{map.width, map.height, {}, {}};
  for (std::size_t i = 0; i < map.region.size(); ++i) {
    image.rgb.push_back(static_cast<std::uint8_t>(map.region[i]));
    image.rgb.push_back(map.split_value[i]);
    image.rgb.push_back(static_cast<std::uint8_t>(map.cause[i]));
  }
  return write_png(path, image);
}

Result<RegionMap> read_regions(const std::string& path) {
  const Result<RgbImage> image = read_png(path);
  if (!image) return tl::unexpected(image.error());
  RegionMap map{image->width, image->height, {}, {}, {}};
  for (std::size_t i = 0; i + 2 < image->rgb.size(); i += 3) {
    if (image->rgb[i] >= region_count || image->rgb[i + 2] >= split_cause_count)
      return tl::unexpected(Error{path, "is no map of regions"});
    map.region.push_back(static_cast<Region>(image->rgb[i]));
    map.split_value.push_back(image->rgb[i + 1]);
    map.cause.push_back(static_cast<SplitCause>(image->rgb[i + 2]));
  }
  return map;
}

}  // namespace asos
