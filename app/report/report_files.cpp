#include "app/report/report_files.h"

#include "app/output_file.h"
#include "app/printed_json.h"
#include "app/report/html_page.h"
#include "app/report/job_record.h"
#include "app/report/report_data.h"
#include "renderer/film/image_io.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace asos {
namespace fs = std::filesystem;
namespace {

std::string path_in(const std::string& folder, const char* name) {
  return (fs::path(folder) / name).string();
}

bool is_number(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_job_file(const fs::path& path) {
  const std::string stem = path.stem().string();
  const std::string ending = path.extension().string();
  if (is_number(stem)) return ending == ".json" || ending == ".exr" || ending == ".png";
  const std::size_t dash = stem.find('-');
  return dash != std::string::npos && ending == ".exr" && is_number(stem.substr(0, dash)) &&
         is_number(stem.substr(dash + 1));
}

}  // namespace

std::string plain_name(const std::string& scene, std::size_t number) {
  std::string name = fmt::format("{}-", number);
  const std::string stem =
      scene.starts_with("builtin:") ? scene.substr(8) : fs::path(scene).stem().string();
  for (const char c : stem) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
  return name;
}

Result<void> write_text(const std::string& folder, const char* name, const std::string& text) {
  return write_file_atomically(path_in(folder, name), {text.begin(), text.end()});
}

Result<void> make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path))
    return tl::unexpected(
        Error{path, "cannot be made: " + (error ? error.message() : "it is no folder")});
  // Opening a file is the only test that works on every file system.
  const auto file = OutputFile::plan(path_in(path, "report.html"));
  if (!file) return tl::unexpected(file.error());
  return {};
}

Result<void> clear_jobs(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (is_job_file(entry.path())) old.push_back(entry.path());
  for (const fs::path& path : old)
    if (!error) fs::remove(path, error);
  if (error) return tl::unexpected(Error{folder, "cannot be cleared: " + error.message()});
  return {};
}

Result<void> write_report(const StudyReport& report, const std::string& folder) {
  const std::string plots = path_in(folder, "plots");
  const std::string pictures = path_in(folder, "pictures");
  for (const std::string& inner : {plots, pictures})
    if (const auto made = make_folder(inner); !made) return made;
  std::vector<SceneFigures> figures;
  for (const SceneReport& scene : report.scenes) {
    const std::string name = plain_name(scene.study.scene, figures.size() + 1);
    auto drawn = draw_plots(scene, plots, name);
    if (!drawn) return tl::unexpected(drawn.error());
    auto written = write_pictures(scene, pictures, name);
    if (!written) return tl::unexpected(written.error());
    figures.push_back({*std::move(drawn), *std::move(written)});
  }
  const auto page = html_page(report, figures);
  if (!page) return tl::unexpected(page.error());
  const std::string json = json_text(report_json(report));
  return write_text(folder, "points.csv", points_csv(report))
      .and_then([&] { return write_text(folder, "progress.csv", progress_csv(report)); })
      .and_then([&] { return write_text(folder, "report.json", json); })
      .and_then([&] { return write_text(folder, "report.html", *page); });
}

}  // namespace asos
