#include "renderer/files/followed_links.h"
#include "renderer/files/leftovers.h"
#include "renderer/film/image_io.h"
#include "renderer/film/part_file.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace asos {
namespace fs = std::filesystem;
namespace {

constexpr const char* mark = ".asos-part-";

Error system_error(const std::string& path, const char* what, int code) {
  return {path, fmt::format("{} ({})", what, std::generic_category().message(code))};
}

}  // namespace

void PartFile::Drop::operator()(std::FILE* file) const {
  std::fclose(file);
  if (!name.empty()) std::remove(name.c_str());
}

Result<PartFile> PartFile::create(const std::string& path) {
  // The temporary name is unique to this process and call.
  static std::atomic<unsigned> serial{0};
  PartFile part;
  const fs::path place = followed_links(path);
  part.path_ = place.string();
  std::error_code ignored;
  const fs::file_status status = fs::status(place, ignored);
  const bool replaced = !fs::exists(status) || fs::is_regular_file(status);
  if (replaced) {
    remove_leftovers(place.parent_path(), place.filename().string() + mark);
    part.beside_ = fmt::format("{}{}{}-{}", part.path_, mark, ::getpid(), serial++);
  }
  std::FILE* file = replaced ? std::fopen(part.beside_.c_str(), "wbx") : std::tmpfile();
  if (!file) return unexpected(system_error(path, "cannot be written", errno));
  part.file_ = std::unique_ptr<std::FILE, Drop>(file, Drop{part.beside_});
  return part;
}

Error PartFile::write_error() const {
  return system_error(path_, "could not be written to the end", errno);
}

Result<void> PartFile::copy_through() {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> place(std::fopen(path_.c_str(), "wb"),
                                                              std::fclose);
  if (!place) return unexpected(system_error(path_, "cannot be written", errno));
  std::rewind(file_.get());
  std::array<char, 65536> bytes;
  while (const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file_.get()))
    if (std::fwrite(bytes.data(), 1, count, place.get()) != count) return unexpected(write_error());
  if (std::ferror(file_.get()) != 0 || std::fflush(place.get()) != 0)
    return unexpected(write_error());
  return {};
}

Result<void> PartFile::commit() {
  if (std::fflush(file_.get()) != 0 || std::ferror(file_.get()) != 0)
    return unexpected(write_error());
  if (beside_.empty()) return copy_through();
  if (std::fclose(file_.release()) != 0) {
    const Error error = write_error();
    std::remove(beside_.c_str());
    return unexpected(error);
  }
  if (std::rename(beside_.c_str(), path_.c_str()) != 0) {
    const int code = errno;
    std::remove(beside_.c_str());
    return unexpected(system_error(path_, "cannot be replaced", code));
  }
  return {};
}

Result<void> write_file_atomically(const std::string& path,
                                   const std::vector<std::uint8_t>& bytes) {
  Result<PartFile> file = PartFile::create(path);
  if (!file) return unexpected(file.error());
  if (std::fwrite(bytes.data(), 1, bytes.size(), file->stream()) != bytes.size())
    return unexpected(file->write_error());
  return file->commit();
}

}  // namespace asos
