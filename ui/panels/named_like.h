#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace asos::ui {

/// Whether the name contains the letters, ignoring case.
[[nodiscard]] inline bool named_like(const std::string& name, const std::string& letters) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  return letters.empty() ||
         std::search(name.begin(), name.end(), letters.begin(), letters.end(), same) != name.end();
}

}  // namespace asos::ui
