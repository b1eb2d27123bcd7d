#include "ui/tone_table.h"

#include "renderer/film/film.h"

#include <bit>
#include <limits>

namespace asos::ui {

namespace {

// Positive floats sort like their bit patterns. Buckets are made of the exponent with six bits of
// mantissa, so that few bytes share one.
constexpr int bucket_shift = 17;
constexpr std::uint32_t infinity_bits = 0x7f800000u;

int shown(float radiance, float exposure_ev) {
  return display_bytes(glm::vec3(radiance), exposure_ev).x;
}

}  // namespace

ToneTable::ToneTable(float exposure_ev) : exposure_ev_(exposure_ev) {
  least_[0] = 0.0f;
  std::uint32_t lo = 0;
  for (int b = 1; b <= 255; ++b) {
    // Bisect between a radiance shown below b and infinity; white may be unreachable.
    std::uint32_t hi = infinity_bits;
    while (hi - lo > 1) {
      const std::uint32_t middle = lo + (hi - lo) / 2;
      (shown(std::bit_cast<float>(middle), exposure_ev) >= b ? hi : lo) = middle;
    }
    least_[static_cast<std::size_t>(b)] = std::bit_cast<float>(hi);
  }
  least_[256] = std::numeric_limits<float>::infinity();

  guess_.resize((infinity_bits >> bucket_shift) + 1);
  std::size_t b = 0;
  for (std::uint32_t bucket = 0; bucket < guess_.size(); ++bucket) {
    const float start = std::bit_cast<float>(bucket << bucket_shift);
    while (b < 255 && start >= least_[b + 1]) ++b;
    guess_[bucket] = static_cast<std::uint8_t>(b);
  }
}

std::uint8_t ToneTable::byte(float radiance) const {
  // Zero, negative and non-finite radiance is handled by the function itself.
  if (!(radiance > 0.0f && radiance < std::numeric_limits<float>::infinity())) {
    return static_cast<std::uint8_t>(shown(radiance, exposure_ev_));
  }
  std::size_t b = guess_[std::bit_cast<std::uint32_t>(radiance) >> bucket_shift];
  while (b < 255 && radiance >= least_[b + 1]) ++b;
  return static_cast<std::uint8_t>(b);
}

}  // namespace asos::ui
