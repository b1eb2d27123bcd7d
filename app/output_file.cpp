#include "app/output_file.h"

#include "renderer/files/followed_links.h"
#include "renderer/files/leftovers.h"
#include "renderer/sampling/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace asos {
namespace fs = std::filesystem;
namespace {

tl::unexpected<Error> fail(const std::string& path, const std::string& reason) {
  return tl::unexpected(Error{path, "cannot be written: " + reason});
}

std::string reason_of_errno() {
  return std::strerror(errno);
}

// Prefix of the temporary files for `target`. It is the same in every run, so that a later run
// finds the leftovers of a killed one. A hash keeps it short for long names.
std::string part_prefix(const fs::path& target) {
  std::uint64_t hash = 0;
  for (const char c : target.filename().string())
    hash = mix_bits(hash ^ static_cast<unsigned char>(c));
  return fmt::format(".asos-part-{:016x}-", hash);
}

// Creates the file, empty. Opening it is the only test that works on every file system.
bool can_create(const fs::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  return file >= 0 && ::close(file) == 0;
}

}  // namespace

Result<OutputFile> OutputFile::plan(const std::string& path) {
  OutputFile file;
  file.path_ = path;
  // Uses the unresolved path: a pipe behind a link has no other name.
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return fail(path, "it is a directory");
  if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0) return fail(path, reason_of_errno());
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    file.target_ = path;
    return file;
  }

  file.target_ = fs::weakly_canonical(fs::absolute(followed_links(path), error), error);
  if (path.empty() || error || !file.target_.has_filename())
    return fail(path, "this is not the name of a file");
  file.temporary_ = file.target_;
  const std::string prefix = part_prefix(file.target_);
  remove_leftovers(file.target_.parent_path(), prefix);
  file.temporary_.replace_filename(
      fmt::format("{}{}{}", prefix, ::getpid(), file.target_.extension().string()));
  const bool created = can_create(file.temporary_);
  const std::string reason = reason_of_errno();
  fs::remove(file.temporary_, error);  // it may exist although closing failed
  if (!created) return fail(path, reason);
  return file;
}

Result<void> OutputFile::commit(
    const std::function<Result<void>(const std::string& path)>& write) const {
  if (temporary_.empty()) return write(target_.string());
  std::error_code error;
  if (Result<void> written = write(temporary_.string()); !written) {
    fs::remove(temporary_, error);
    // The error names the temporary file, which the user does not know.
    return tl::unexpected(Error{path_, written.error().reason});
  }
  fs::rename(temporary_, target_, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary_, error);
    return fail(path_, reason);
  }
  return {};
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(followed_links(a), error), error) ==
         fs::weakly_canonical(fs::absolute(followed_links(b), error), error);
}

bool has_extension(const std::string& path, std::string_view extension) {
  const std::string found = fs::path(path).extension().string();
  return std::equal(
      found.begin(), found.end(), extension.begin(), extension.end(),
      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

}  // namespace asos
