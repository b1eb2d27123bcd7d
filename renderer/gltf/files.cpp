#include "renderer/gltf/files.h"

#include "renderer/gltf/data_uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace asos::gltf {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t largest_outside_file = std::uint64_t{8} << 30;
// Largest number of folder entries to read for a search that ignores case, and of names to follow
// at the same time.
constexpr std::size_t most_entries_listed = 1'000'000;
constexpr std::size_t most_names_followed = 64;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && colon < uri.find_first_of("/\\?#");
}

/// A possible file name for a URI.
struct Spelling {
  std::string relative;
  std::string remark;  ///< empty: the standard meaning of the URI
};

/// Returns the possible names, the most likely first.
std::vector<Spelling> spellings_of(std::string_view uri) {
  std::vector<Spelling> all{{percent_decoded(uri), {}}};
  if (uri.find('%') != std::string_view::npos) all.push_back({std::string(uri), {}});
  const std::size_t end = uri.find_first_of("?#");
  if (end != std::string_view::npos && end > 0)
    all.push_back({percent_decoded(uri.substr(0, end)),
                   fmt::format("'{}' is ignored: it is no part of a file's name",
                               shown_uri(uri.substr(end)))});
  const std::size_t with_backslashes = all.size();
  for (std::size_t i = 0; i < with_backslashes; ++i) {
    Spelling spelling = all[i];
    if (spelling.relative.find('\\') == std::string::npos) continue;
    std::replace(spelling.relative.begin(), spelling.relative.end(), '\\', '/');
    spelling.remark += (spelling.remark.empty() ? "" : "; ") +
                       std::string("backslashes are read as slashes, which glTF asks for");
    all.push_back(std::move(spelling));
  }
  return all;
}

}  // namespace

/// Returns a folder with links resolved; each is resolved once.
const fs::path& ModelFiles::canonical_folder(const fs::path& relative) {
  const auto [known, is_new] = folders_known_.try_emplace(relative);
  std::error_code error;
  if (is_new) known->second = fs::weakly_canonical(folders_.model / relative, error);
  return known->second;
}

/// Returns the place of a relative path. Faults: it leads out of the asset folders. Dot segments
/// are removed first, as in RFC 3986 (5.2.4), so that "sub/../t.png" needs no folder "sub".
Checked<ModelFiles::Place> ModelFiles::inside(const std::string& relative) {
  if (relative.empty()) return fault("it is empty");
  if (relative.find('\0') != std::string::npos) return fault("it contains a zero byte");
  if (fs::path(relative).is_absolute()) return fault("it is an absolute path");
  Place place;
  UriFile& file = place.file;
  file.relative = fs::path(relative).lexically_normal();
  std::error_code error;
  file.path = canonical_folder(file.relative.parent_path()) / file.relative.filename();
  const fs::file_status status = fs::symlink_status(file.path, error);
  place.exists = fs::exists(status);
  const bool plain = fs::is_regular_file(status) || status.type() == fs::file_type::not_found;
  if (!plain || file.relative.filename() == ".." || !file.relative.has_filename()) {
    error.clear();
    file.path = fs::weakly_canonical(folders_.model / file.relative, error);
    if (error) return fault(fmt::format("it cannot be found ({})", error.message()));
    place.exists = fs::exists(file.path, error);
  }
  if (folders_.contain(file.path)) return place;
  const bool named = folders_.contain((folders_.model / file.relative).lexically_normal());
  return fault(
      fmt::format("{} leads out of the asset root '{}'; another one can be chosen "
                  "(--asset-root)",
                  named ? "a symbolic link" : "it", folders_.root.string()));
}

/// Returns the names in a folder; incomplete beyond most_entries_listed.
const ModelFiles::FoldedNames& ModelFiles::names_in(const fs::path& folder) {
  const auto [known, is_new] = listed_.try_emplace(folder);
  if (!is_new) return known->second;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (++entries_listed_ > most_entries_listed) break;
    const std::string name = entry->path().filename().string();
    known->second.emplace(lower_case(name), name);
  }
  return known->second;
}

/// Returns the only file whose name equals `relative` up to the case of ASCII letters; nullopt:
/// there is none. Faults: there are several.
Checked<std::optional<UriFile>> ModelFiles::other_case(const std::string& relative) {
  std::vector<fs::path> found{fs::path()};
  for (const fs::path& step : fs::path(relative).lexically_normal()) {
    if (step.empty()) return std::optional<UriFile>();
    std::vector<fs::path> longer;
    for (const fs::path& path : found) {
      if (step == ".." || step == ".") {
        longer.push_back(path / step);
        continue;
      }
      const fs::path& folder = canonical_folder(path);
      if (!folders_.contain(folder)) continue;
      const auto [first, last] = names_in(folder).equal_range(lower_case(step.string()));
      for (auto name = first; name != last && longer.size() < most_names_followed; ++name)
        longer.push_back(path / name->second);
    }
    found = std::move(longer);
  }
  if (found.size() > 1)
    return fault(fmt::format("no file has this name; {} have it in other case", found.size()));
  if (found.empty()) return std::optional<UriFile>();
  Checked<Place> place = inside(found.front().string());
  if (!place) return fault(place.error());
  UriFile& file = place->file;
  file.remark = fmt::format("'{}' is opened, whose name differs in case", file.relative.string());
  return std::optional(std::move(file));
}

Checked<UriFile> ModelFiles::find(std::string_view uri) {
  if (is_data_uri(uri) || has_scheme(uri))
    return fault(fmt::format("'{}' is not a local file", shown_uri(uri)));
  const auto refused = [&](const std::string& why) {
    return fault(fmt::format("'{}' is refused: {}", shown_uri(uri), why));
  };
  const std::vector<Spelling> spellings = spellings_of(uri);
  std::string refusal;
  std::optional<UriFile> missing;
  for (const Spelling& spelling : spellings) {
    Checked<Place> place = inside(spelling.relative);
    if (!place && refusal.empty()) refusal = place.error();
    if (!place) continue;
    if (place->exists) {
      place->file.remark = spelling.remark;
      return std::move(place->file);
    }
    if (!missing) missing = std::move(place->file);
  }
  if (!refusal.empty()) return refused(refusal);
  for (const Spelling& spelling : spellings) {
    Checked<std::optional<UriFile>> file = other_case(spelling.relative);
    if (!file) return fault(fmt::format("'{}' cannot be read: {}", shown_uri(uri), file.error()));
    if (!*file) continue;
    if (!spelling.remark.empty()) (*file)->remark += "; " + spelling.remark;
    return std::move(**file);
  }
  return std::move(*missing);
}

Checked<UriBytes> ModelFiles::read(std::string_view uri) {
  if (is_data_uri(uri)) return read_data_uri(uri);
  Checked<UriFile> file = find(uri);
  if (!file) return fault(file.error());
  Checked<FileBytes> bytes = read_file(file->path, {largest_outside_file});
  if (!bytes) return fault(fmt::format("'{}' cannot be read: {}", shown_uri(uri), bytes.error()));
  return UriBytes{std::move(*bytes), std::move(file->remark)};
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

bool is_data_uri(std::string_view uri) {
  return lower_case(uri.substr(0, 5)) == "data:";
}

std::string percent_decoded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 &&
        hex_digit(text[i + 2]) >= 0) {
      out.push_back(static_cast<char>(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2])));
      i += 2;
    } else {
      out.push_back(text[i]);
    }
  }
  return out;
}

std::string shown_uri(std::string_view uri) {
  if (is_data_uri(uri)) return "data URI";
  if (uri.size() <= 120) return std::string(uri);
  return std::string(uri.substr(0, 117)) + "...";
}

}  // namespace asos::gltf
