#include "renderer/scene/gltf/warnings.h"

#include "renderer/files/printable.h"

#include <fmt/format.h>

#include <utility>

namespace asos::gltf {

namespace {
constexpr std::size_t most_warnings = 100;
}

void Warnings::add(const std::string& from_file) {
  std::string text = printable(from_file);
  if (seen_.contains(text)) return;
  if (texts_.size() >= most_warnings) {
    ++dropped_;
    return;
  }
  seen_.insert(text);
  texts_.push_back(std::move(text));
}

void Warnings::add_loss(const std::string& text) {
  if (first_loss_.empty()) first_loss_ = text;
  add(text);
}

std::vector<std::string> Warnings::take() {
  if (dropped_ > 0) texts_.push_back(fmt::format("and {} more", dropped_));
  dropped_ = 0;
  seen_.clear();
  return std::exchange(texts_, {});
}

}  // namespace asos::gltf
