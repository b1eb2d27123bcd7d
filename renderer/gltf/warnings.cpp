#include "renderer/gltf/warnings.h"

#include "renderer/files/printable.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>
#include <utility>

namespace asos::gltf {

namespace {
constexpr std::size_t most_warnings = 100;
constexpr std::size_t longest_remark = 500;
}  // namespace

std::string shortened(const std::string& text) {
  constexpr std::string_view gap = "...";
  if (text.size() <= longest_remark) return text;
  // Do not cut a character in two.
  const auto goes_on = [&](std::size_t at) {
    return (static_cast<std::uint8_t>(text[at]) & 0xc0) == 0x80;
  };
  std::size_t head = (longest_remark - gap.size()) / 2;
  std::size_t tail = text.size() - head;
  while (head > 0 && goes_on(head)) --head;
  while (tail < text.size() && goes_on(tail)) ++tail;
  return text.substr(0, head).append(gap).append(text, tail, std::string::npos);
}

void Warnings::add(const std::string& from_file) {
  // Skip the same text for each of a million entries.
  if (!from_file.empty() && from_file == last_) return;
  last_ = from_file;
  std::string text = printable(shortened(from_file));
  if (seen_.contains(text)) return;
  if (texts_.size() >= most_warnings) {
    ++dropped_;
    return;
  }
  seen_.insert(text);
  texts_.push_back(std::move(text));
}

void Warnings::add_loss(const std::string& text) {
  if (first_loss_.empty()) first_loss_ = shortened(text);
  add(text);
}

std::vector<std::string> Warnings::take() {
  if (dropped_ > 0) texts_.push_back(fmt::format("and {} more", dropped_));
  dropped_ = 0;
  seen_.clear();
  return std::exchange(texts_, {});
}

}  // namespace asos::gltf
