#include "ui/folder_listing.h"

#include "renderer/gltf/converted.h"

#include <algorithm>
#include <cctype>
#include <system_error>

namespace asos::ui {

namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_picture(const fs::path& file) {
  const std::string ending = lower(file.extension().string());
  return ending == ".png" || ending == ".exr";
}

bool is_sky(const fs::path& file) {
  const std::string ending = lower(file.extension().string());
  return ending == ".hdr" || ending == ".exr";
}

// Compares numbers by value and letters alphabetically: "2" comes before "10".
bool by_name(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (digit(a[i]) && digit(b[k])) {
      std::size_t i_end = i, k_end = k;
      while (i_end < a.size() && digit(a[i_end])) ++i_end;
      while (k_end < b.size() && digit(b[k_end])) ++k_end;
      while (i + 1 < i_end && a[i] == '0') ++i;
      while (k + 1 < k_end && b[k] == '0') ++k;
      if (i_end - i != k_end - k) return i_end - i < k_end - k;
      const int order = a.compare(i, i_end - i, b, k, k_end - k);
      if (order != 0) return order < 0;
      i = i_end;
      k = k_end;
      continue;
    }
    const int x = std::tolower(static_cast<unsigned char>(a[i]));
    const int y = std::tolower(static_cast<unsigned char>(b[k]));
    if (x != y) return x < y;
    ++i;
    ++k;
  }
  if (a.size() - i != b.size() - k) return a.size() - i < b.size() - k;
  return a < b;
}

std::vector<std::string> models_in(const fs::path& folder) {
  std::vector<std::string> models;
  for (const FolderEntry& entry : FolderListing::of(folder).entries)
    if (!entry.is_folder && is_model(entry.name)) models.push_back((folder / entry.name).string());
  return models;
}

std::vector<std::string> models_beside(const fs::path& folder) {
  std::vector<std::string> models;
  const fs::path parent = folder.parent_path();
  if (parent == folder) return models;
  for (const FolderEntry& entry : FolderListing::of(parent).entries) {
    if (!entry.is_folder) continue;
    for (std::string& model : models_in(parent / entry.name)) models.push_back(std::move(model));
  }
  return models;
}

}  // namespace

bool is_model(const fs::path& file) {
  const std::string ending = lower(file.extension().string());
  return ending == ".gltf" || ending == ".glb" || gltf::is_convertible(file.string());
}

FolderListing FolderListing::of(const fs::path& folder, Kind kind) {
  FolderListing listing;
  listing.kind = kind;
  listing.folder = folder;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    FolderEntry entry;
    entry.name = at->path().filename().string();
    if (entry.name.starts_with(".")) continue;
    // Entries that vanish meanwhile or cannot be read are left out.
    std::error_code ignored;
    entry.is_folder = at->is_directory(ignored);
    if (!entry.is_folder) {
      if (!at->is_regular_file(ignored)) continue;
      const bool listed =
          kind == Kind::skies ? is_sky(at->path()) : is_model(at->path()) || is_picture(at->path());
      if (!listed) continue;
      entry.bytes = at->file_size(ignored);
      entry.written = at->last_write_time(ignored);
    }
    if (listing.entries.size() >= most) {
      listing.error = "Too many files to list: type a path";
      break;
    }
    listing.entries.push_back(std::move(entry));
  }
  if (error) listing.error = error.message();
  std::sort(listing.entries.begin(), listing.entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) {
              return a.is_folder != b.is_folder ? a.is_folder : by_name(a.name, b.name);
            });
  return listing;
}

std::vector<std::size_t> FolderListing::matching(const std::string& filter) const {
  const std::string wanted = lower(filter);
  std::vector<std::size_t> first, others;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t at = lower(entries[i].name).find(wanted);
    if (at == 0) first.push_back(i);
    if (at != 0 && at != std::string::npos) others.push_back(i);
  }
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

std::string completed(const FolderListing& listing, const std::vector<std::size_t>& matching,
                      const std::string& typed) {
  std::string common;
  bool any = false;
  for (const std::size_t i : matching) {
    const std::string& name = listing.entries[i].name;
    if (!lower(name).starts_with(lower(typed))) continue;
    if (!any) {
      common = name;
      any = true;
      continue;
    }
    std::size_t same = 0;
    while (same < std::min(common.size(), name.size()) &&
           lower(common.substr(same, 1)) == lower(name.substr(same, 1)))
      ++same;
    common.resize(same);
  }
  return common.size() >= typed.size() && any ? common : typed;
}

std::optional<NextModel> next_model(const std::string& file, int step) {
  std::error_code error;
  const fs::path path = fs::absolute(file, error).lexically_normal();
  if (error || !fs::is_regular_file(path, error)) return std::nullopt;
  std::vector<std::string> models = models_in(path.parent_path());
  if (models.size() < 2) models = models_beside(path.parent_path());
  const auto at = std::find(models.begin(), models.end(), path.string());
  if (at == models.end() || models.size() < 2) return std::nullopt;
  const auto count = static_cast<std::ptrdiff_t>(models.size());
  const std::ptrdiff_t next = (((at - models.begin()) + step) % count + count) % count;
  return NextModel{models[static_cast<std::size_t>(next)], static_cast<std::size_t>(next) + 1,
                   models.size()};
}

}  // namespace asos::ui
