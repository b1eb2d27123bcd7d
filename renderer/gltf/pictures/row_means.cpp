#include "renderer/gltf/pictures/row_means.h"

#include "renderer/gltf/pictures/picture.h"
#include "renderer/load_progress.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace asos {

RowMeans::RowMeans(int width, int height, int shrink) : width_(width), shrink_(shrink) {
  image_.width = shrunk(width, shrink);
  image_.height = shrunk(height, shrink);
  const auto row = 4 * static_cast<std::size_t>(image_.width);
  image_.rgba = SharedBytes(SharedBytes::Bytes(row * static_cast<std::size_t>(image_.height)));
  if (shrink == 1) return;
  sums_.resize(row);
  pixels_.resize(4 * static_cast<std::size_t>(width));
}

std::span<std::uint8_t> RowMeans::next() {
  stop_point();
  if (shrink_ > 1 || row_ >= image_.height) return pixels_;
  const auto row = 4 * static_cast<std::size_t>(width_);
  return std::span(image_.rgba.own()).subspan(static_cast<std::size_t>(row_) * row, row);
}

void RowMeans::add() {
  if (row_ >= image_.height) return;
  if (shrink_ == 1) {
    ++row_;
    return;
  }
  const std::vector<std::uint8_t>& rgba = pixels_;
  for (int x = 0; x < image_.width; ++x) {
    const auto begin = 4 * static_cast<std::size_t>(x) * static_cast<std::size_t>(shrink_);
    const std::size_t end = std::min(begin + 4 * static_cast<std::size_t>(shrink_), rgba.size());
    std::uint32_t* const sums = &sums_[4 * static_cast<std::size_t>(x)];
    for (std::size_t i = begin; i < end; i += 4)
      for (std::size_t c = 0; c < 4; ++c) sums[c] += rgba[i + c];
  }
  if (++rows_summed_ == shrink_) put_row();
}

void RowMeans::put_row() {
  SharedBytes::Bytes& out = image_.rgba.own();
  const std::size_t row = static_cast<std::size_t>(row_++) * sums_.size();
  for (int x = 0; x < image_.width; ++x) {
    const int columns = std::min(shrink_, width_ - x * shrink_);
    const auto count = static_cast<std::uint32_t>(columns * rows_summed_);
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t at = 4 * static_cast<std::size_t>(x) + c;
      const std::uint64_t rounded = std::uint64_t{sums_[at]} + count / 2;
      out[row + at] = static_cast<std::uint8_t>(rounded / count);
    }
  }
  std::fill(sums_.begin(), sums_.end(), 0u);
  rows_summed_ = 0;
}

Image RowMeans::take() {
  if (rows_summed_ > 0) put_row();
  return std::move(image_);
}

}  // namespace asos
