#include "ui/frames.h"

#include "renderer/geometry/largest.h"
#include "ui/resampled.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos::ui {

bool Frames::store(const Film& film, std::string name, std::string summary) {
  if (stored.size() >= most || film.width <= 0) return false;
  const auto taken = [&](const std::string& wanted) {
    return std::any_of(stored.begin(), stored.end(), [&](const StoredFrame& frame) {
      return frame.name == wanted && frame.file == shown_file;
    });
  };
  std::string free = name;
  for (int number = 2; taken(free); ++number) free = fmt::format("{} ({})", name, number);
  stored.push_back({std::move(free), std::move(summary), film, shown_file});
  chosen = static_cast<int>(stored.size()) - 1;
  ++revision;
  return true;
}

void Frames::flip_to(int index) {
  if (index < 0 || index >= static_cast<int>(stored.size())) return;
  flipped = !(comparison == Comparison::flip && flipped && compared() == index);
  comparison = Comparison::flip;
  with = CompareWith::snapshot;
  chosen = index;
}

void Frames::remove(int index) {
  if (index < 0 || index >= static_cast<int>(stored.size())) return;
  stored.erase(stored.begin() + index);
  chosen = std::clamp(chosen, 0, std::max(0, static_cast<int>(stored.size()) - 1));
  if (stored.empty() && with != CompareWith::reference) comparison = Comparison::none;
  sized_.reset();
  ++revision;
}

std::optional<int> Frames::compared() const {
  if (comparison == Comparison::none) return std::nullopt;
  if (with == CompareWith::reference)
    return reference.film ? std::optional(the_reference) : std::nullopt;
  const bool any = chosen >= 0 && chosen < static_cast<int>(stored.size());
  return any ? std::optional(chosen) : std::nullopt;
}

const Film& Frames::film(int index) const {
  return index == the_reference ? *reference.film : stored[static_cast<std::size_t>(index)].film;
}

std::string Frames::compared_title() const {
  const std::optional<int> index = compared();
  if (index == the_reference) return fmt::format("Reference, {} spp", reference.samples);
  return index ? title(stored[static_cast<std::size_t>(*index)]) : std::string();
}

const Film& Frames::at_size(int index, glm::ivec2 size) {
  const Film& whole = film(index);
  if (glm::ivec2(whole.width, whole.height) == size) return whole;
  const std::uint64_t now = index == the_reference ? reference.revision : revision;
  if (!sized_ || sized_->revision != now || sized_->index != index || sized_->size != size)
    sized_ = Sized{now, index, size, resampled(whole, size)};
  return sized_->film;
}

float difference_of(glm::vec3 a, glm::vec3 b, const DisplayTransform& display) {
  return largest(glm::abs(display_rgb(a, display) - display_rgb(b, display)));
}

float difference_of(const Film& a, const Film& b, std::size_t pixel,
                    const DisplayTransform& display) {
  return largest(glm::abs(display_rgb(a, pixel, display) - display_rgb(b, pixel, display)));
}

}  // namespace asos::ui
