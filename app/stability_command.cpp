#include "app/stability_command.h"

#include "app/command.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/output_file.h"
#include "app/progress_bar.h"
#include "app/stability_page.h"
#include "renderer/stability/case.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace asos {
namespace {

namespace fs = std::filesystem;

constexpr const char* stability_footer =
    "Renders small scenes with extreme numbers: scales from 1e-12 to 1e12, slivers, grazing "
    "views,\nlights in awkward places, settings beyond their range. Each is compared with a closed "
    "form, an\ninvariance or a converged value, within a bound with a stated reason. DIR gets "
    "stability.html\nand stability.csv, one line per case.\n\nExamples:\n  asos stability -o "
    "stability\n  asos stability -o stability --quick\n\nExit codes: 0 all cases hold, 1 a bound "
    "is broken or a file cannot be written, 2 bad command\nline, 130 interrupted.";

/// The output files, checked to be writable.
struct StabilityFiles {
  OutputFile page;
  OutputFile table;
};

Result<StabilityFiles> plan_files(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return tl::unexpected(Error{folder, "cannot be made: " + error.message()});
  const auto page = OutputFile::plan((fs::path(folder) / "stability.html").string());
  if (!page) return tl::unexpected(page.error());
  const auto table = OutputFile::plan((fs::path(folder) / "stability.csv").string());
  if (!table) return tl::unexpected(table.error());
  return StabilityFiles{*page, *table};
}

Result<void> commit(const OutputFile& file, const std::string& text) {
  return file.commit([&](const std::string& path) -> Result<void> {
    std::ofstream stream(path, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) return tl::unexpected(Error{path, std::strerror(errno)});
    return {};
  });
}

}  // namespace

int run_stability(const StabilityArguments& arguments, const std::vector<stability::Case>& cases,
                  const Streams& streams) {
  const InterruptGuard interrupt;
  const auto files = plan_files(arguments.folder);
  if (!files) return fail(streams, files.error());

  ProgressBar bar(streams.err, streams.err_is_terminal);
  std::vector<stability::Finding> findings;
  std::size_t broken = 0;
  double seconds = 0.0;
  for (const stability::Case& item : cases) {
    if (interrupt.interrupted()) {
      bar.wipe();
      streams.err << "asos: interrupted, nothing was written\n";
      return exit_interrupted;
    }
    bar.say(fmt::format("{:3} of {}, {} broken: {}", findings.size() + 1, cases.size(), broken,
                        item.name));
    findings.push_back(stability::run_case(item));
    seconds += findings.back().seconds;
    if (!stability::holds(findings.back())) ++broken;
  }
  bar.wipe();

  // Write and print the results
  if (const auto done = commit(files->table, stability_csv(findings)); !done)
    return fail(streams, done.error());
  if (const auto done = commit(files->page, stability_page(findings, arguments.quick)); !done)
    return fail(streams, done.error());
  for (const stability::Finding& finding : findings) {
    if (!stability::holds(finding))
      streams.out << fmt::format("Broken: {}: {}\n", finding.group, finding.name);
  }
  streams.out << fmt::format("{} cases, {} broken, {:.1f} s. The page: {}\n", findings.size(),
                             broken, seconds, printable(files->page.path()));
  return broken > 0 ? exit_bad_input : exit_ok;
}

Command add_stability_command(CLI::App& program) {
  const auto arguments = std::make_shared<StabilityArguments>();
  CLI::App* parser =
      program.add_subcommand("stability", "Check numerical accuracy on extreme cases");
  parser->add_option("-o,--output", arguments->folder, "Folder for the results")
      ->type_name("DIR")
      ->required();
  parser->add_flag("--quick", arguments->quick, "Only cases that take less than a minute together");
  parser->footer(stability_footer);
  return {parser, [arguments](const Streams& streams) {
            return run_stability(*arguments, stability::all_cases(arguments->quick), streams);
          }};
}

}  // namespace asos
