#include "ui/panels/file_browser.h"

#include "renderer/files/printable.h"
#include "ui/theme.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <system_error>
#include <utility>

namespace asos::ui {

namespace {

namespace fs = std::filesystem;

std::string size_words(std::uintmax_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size < 1e3) return fmt::format("{} B", bytes);
  if (size < 1e6) return fmt::format("{:.0f} kB", size / 1e3);
  if (size < 1e9) return fmt::format("{:.1f} MB", size / 1e6);
  return fmt::format("{:.1f} GB", size / 1e9);
}

std::string date_words(fs::file_time_type written) {
  using std::chrono::system_clock;
  const auto time = std::chrono::time_point_cast<system_clock::duration>(
      std::chrono::file_clock::to_sys(written));
  const std::time_t seconds = system_clock::to_time_t(time);
  std::tm local{};
  if (!localtime_r(&seconds, &local)) return "";
  return fmt::format("{:%Y-%m-%d %H:%M}", local);
}

fs::path home_expanded(const std::string& typed) {
  const char* home = std::getenv("HOME");
  if (!typed.starts_with("~/") || !home) return typed;
  return fs::path(home) / typed.substr(2);
}

bool is_path(const std::string& typed) {
  return typed.find('/') != std::string::npos;
}

// Handles Tab and the arrow keys while text is typed into the field.
int on_key(ImGuiInputTextCallbackData* data) {
  auto& browser = *static_cast<FileBrowser*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory) {
    browser.move_choice(data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
  } else if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
    browser.typed.assign(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    browser.complete();
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, browser.typed.c_str());
  }
  return 0;
}

// `chosen`: the entry is highlighted; dim text would be unreadable there.
void entry_columns(const FolderEntry& entry, float width, bool chosen) {
  if (entry.is_folder) return;
  const float em = ImGui::GetFontSize();
  const std::string date = date_words(entry.written), size = size_words(entry.bytes);
  const float date_width = 9.0f * em, size_width = 5.0f * em;
  if (width < 24.0f * em) return;
  ImGui::SameLine(width - date_width - ImGui::CalcTextSize(size.c_str()).x - 0.05f * size_width);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(chosen ? theme::text : theme::dim_text));
  ImGui::TextUnformatted(size.c_str());
  ImGui::SameLine(width - date_width + em);
  ImGui::TextUnformatted(date.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

void FileBrowser::begin(const fs::path& first) {
  std::error_code error;
  if (folder.empty() || !fs::is_directory(folder, error)) folder = first;
  enter(fs::absolute(folder, error).lexically_normal());
}

fs::path FileBrowser::shown_folder() const {
  if (!is_path(typed)) return folder;
  const fs::path path = home_expanded(typed);
  return (path.is_absolute() ? path : folder / path).parent_path();
}

std::string FileBrowser::filter() const {
  return is_path(typed) ? fs::path(typed).filename().string() : typed;
}

void FileBrowser::follow() {
  const fs::path shown = shown_folder();
  if (listing.folder != shown) {
    listing = FolderListing::of(shown, listing.kind);
    chosen = 0;
  }
}

void FileBrowser::enter(const fs::path& into) {
  folder = into.has_filename() || into == into.root_path() ? into : into.parent_path();
  typed.clear();
  chosen = 0;
  listing = FolderListing::of(folder, listing.kind);
  scroll_to_chosen = focus = true;
}

void FileBrowser::complete() {
  follow();
  const std::string typed_name = filter();
  const std::vector<std::size_t> matching = listing.matching(typed_name);
  std::string name = completed(listing, matching, typed_name);
  const auto whole =
      std::find_if(listing.entries.begin(), listing.entries.end(),
                   [&](const FolderEntry& e) { return e.is_folder && e.name == name; });
  const bool only = std::count_if(matching.begin(), matching.end(), [&](std::size_t i) {
                      return listing.entries[i].name.starts_with(name);
                    }) == 1;
  if (whole != listing.entries.end() && only) name += '/';
  typed = typed.substr(0, typed.size() - typed_name.size()) + name;
  follow();
}

void FileBrowser::move_choice(int by) {
  const auto count = static_cast<int>(listing.matching(filter()).size());
  chosen = std::clamp(chosen + by, 0, std::max(0, count - 1));
  scroll_to_chosen = true;
}

std::string FileBrowser::no_match_words() const {
  return typed.starts_with("builtin:") ? "Enter opens the built-in scene" : "No match";
}

std::string FileBrowser::take_entered() {
  follow();
  if (typed.starts_with("builtin:")) return typed;
  std::error_code error;
  const fs::path path = home_expanded(typed);
  const fs::path asked = path.is_absolute() ? path : folder / path;
  if (!typed.empty() && fs::is_regular_file(asked, error)) return asked.string();
  if (is_path(typed) && fs::is_directory(asked, error)) {
    enter(asked.lexically_normal());
    return "";
  }
  const std::vector<std::size_t> matching = listing.matching(filter());
  if (matching.empty() || chosen >= static_cast<int>(matching.size())) return typed;
  const FolderEntry& entry = listing.entries[matching[static_cast<std::size_t>(chosen)]];
  const fs::path full = listing.folder / entry.name;
  if (!entry.is_folder) return full.string();
  enter(full);
  return "";
}

std::string browse_files(Controls& controls, FileBrowser& browser, float height) {
  const float em = ImGui::GetFontSize();
  std::string opened;
  browser.follow();
  if (controls.button("Up", "Parent folder.")) browser.enter(browser.shown_folder().parent_path());
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(printable(browser.shown_folder().string()).c_str());
  controls.placed("Looked through", nullptr);
  if (std::exchange(browser.focus, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  const std::string before = browser.typed;
  const bool entered = ImGui::InputTextWithHint(
      "##path", "type to filter, or a path", &browser.typed,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCompletion |
          ImGuiInputTextFlags_CallbackHistory,
      on_key, &browser);
  controls.placed("Path",
                  "Filter, or a path of a scene or saved picture, or builtin:NAME. Tab completes, "
                  "Enter opens.");
  if (browser.typed != before) browser.chosen = 0;
  if (entered) opened = browser.take_entered();
  browser.follow();

  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyle().Colors[ImGuiCol_FrameBg]);
  ImGui::BeginChild("entries", {0.0f, height}, false);
  ImGui::PopStyleColor();
  const std::vector<std::size_t> matching = browser.listing.matching(browser.filter());
  const float width = ImGui::GetContentRegionAvail().x;
  std::filesystem::path into;
  for (std::size_t row = 0; row < matching.size(); ++row) {
    const FolderEntry& entry = browser.listing.entries[matching[row]];
    const bool chosen = static_cast<int>(row) == browser.chosen;
    const std::string words = printable(entry.name) + (entry.is_folder ? "/" : "");
    ImGui::PushID(static_cast<int>(row));
    ImGui::PushStyleColor(ImGuiCol_Header, theme::packed(theme::accent));
    if (ImGui::Selectable(words.c_str(), chosen, ImGuiSelectableFlags_DontClosePopups)) {
      if (entry.is_folder)
        into = browser.listing.folder / entry.name;
      else
        opened = (browser.listing.folder / entry.name).string();
    }
    ImGui::PopStyleColor();
    ImGui::PopID();
    if (chosen && std::exchange(browser.scroll_to_chosen, false)) ImGui::SetScrollHereY();
    controls.placed((entry.is_folder ? "Folder/" : "Entry/") + entry.name,
                    entry.is_folder ? "Open this folder." : "Open this file.",
                    Controls::Use::edits);
    entry_columns(entry, width, chosen);
  }
  if (!browser.listing.error.empty()) ImGui::TextDisabled("%s", browser.listing.error.c_str());
  if (browser.listing.error.empty() && browser.listing.entries.empty())
    ImGui::TextDisabled("No scenes in this folder");
  if (matching.empty() && !browser.listing.entries.empty()) {
    controls.dim_text("No match", browser.no_match_words());
  }
  ImGui::EndChild();
  if (!into.empty()) browser.enter(into);
  ImGui::Dummy({0.0f, 0.2f * em});
  return opened;
}

}  // namespace asos::ui
