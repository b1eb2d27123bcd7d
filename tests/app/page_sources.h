#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace asos::test {

/// Expects that a page embeds everything it shows, and counts its images. Links within the page
/// (#...) are allowed.
inline std::size_t embedded_images(const std::string& page) {
  std::size_t embedded = 0;
  for (const std::string_view name : {" src=\"", " href=\""}) {
    for (std::size_t at = page.find(name); at != std::string::npos; at = page.find(name, at + 1)) {
      const std::string_view source = std::string_view(page).substr(at + name.size(), 30);
      if (source.starts_with('#')) continue;
      EXPECT_TRUE(source.starts_with("data:image/")) << name << source;
      ++embedded;
    }
  }
  return embedded;
}

}  // namespace asos::test
