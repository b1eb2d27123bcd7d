#include "renderer/shading/normal_rows.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace asos {
namespace {

// A texel's mean is that of 2 x 2 places, or of 4 x 4 places if its normals differ.
constexpr std::array<float, 1> few{0.25f};
constexpr std::array<float, 2> many{0.125f, 0.375f};  // distances from the centre, in texels
// Cosine to the texel's own normal above which normals count as equal.
constexpr float even = 1.0f - 1e-3f;
// Bent texels that are refined at once.
constexpr std::size_t chunk = 64;

// Loops over separate components, without aliases: the compiler vectorizes them.

void mix(const float* __restrict a, const float* __restrict b, float t, std::size_t count,
         float* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = (1.0f - t) * a[i] + t * b[i];
}

struct VectorRow {
  const float* x;
  const float* y;
  const float* z;
};

/// Adds the unit vectors of mixtures of two rows.
void add_units(VectorRow from, VectorRow to, float t, std::size_t count, float* __restrict sum_x,
               float* __restrict sum_y, float* __restrict sum_z) {
  const float* __restrict ax = from.x;
  const float* __restrict ay = from.y;
  const float* __restrict az = from.z;
  const float* __restrict bx = to.x;
  const float* __restrict by = to.y;
  const float* __restrict bz = to.z;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = (1.0f - t) * ax[i] + t * bx[i];
    const float y = (1.0f - t) * ay[i] + t * by[i];
    const float z = (1.0f - t) * az[i] + t * bz[i];
    const float scale = 1.0f / std::sqrt(std::max(x * x + y * y + z * z, 1e-30f));
    sum_x[i] += scale * x;
    sum_y[i] += scale * y;
    sum_z[i] += scale * z;
  }
}

/// Finds how far the sums of a row's normals are from the texels' own: below 0 if they are not
/// even.
void find_bend(VectorRow sums, VectorRow own, std::size_t count, float* __restrict bend) {
  constexpr float places = 4.0f;
  constexpr float least = even * even * places * places;
  for (std::size_t i = 0; i < count; ++i) {
    const float cosine = sums.x[i] * own.x[i] + sums.y[i] * own.y[i] + sums.z[i] * own.z[i];
    const float square = own.x[i] * own.x[i] + own.y[i] * own.y[i] + own.z[i] * own.z[i];
    bend[i] = cosine * std::abs(cosine) - least * square;
  }
}

void write_row(VectorRow sums, std::size_t count, float* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) {
    const float x = 0.25f * sums.x[i], y = 0.25f * sums.y[i], z = 0.25f * sums.z[i];
    out[4 * i] = 0.5f + 0.5f * x;
    out[4 * i + 1] = 0.5f + 0.5f * y;
    out[4 * i + 2] = 0.5f + 0.5f * z;
    out[4 * i + 3] = std::max(0.0f, 1.0f - (x * x + y * y + z * z));
  }
}

template <typename Vectors>
VectorRow row_of(const Vectors& vectors, std::size_t first) {
  return {&vectors[0][first], &vectors[1][first], &vectors[2][first]};
}

/// Neighbourhoods of 3 x 3 texels.
using Values = std::array<std::array<float, chunk>, 3>;
struct Neighbourhoods {
  std::array<std::array<Values, 3>, 3> rows;
  std::array<Values, 3> between;
  Values sums;
};

}  // namespace

NormalRows::NormalRows(const Image& image)
    : texels_(image, Encoding::linear), width_(static_cast<std::size_t>(image.width)) {
  const auto resize = [](Vectors& row, std::size_t size) {
    for (std::vector<float>& component : row) component.resize(size);
  };
  for (auto& known : maps_) resize(known.values, width_ + 2);
  for (auto& known : rows_) known.values.resize(4 * width_);
  resize(between_, width_ + 2);
  resize(means_, width_);
  bend_.resize(width_);
}

const float* NormalRows::row(int y) {
  KnownRow<std::vector<float>>& known = rows_[static_cast<std::size_t>(y) % rows_.size()];
  if (known.y == y) return known.values.data();
  known.y = y;
  find_means(y);
  write_row(row_of(means_, 0), width_, known.values.data());
  return known.values.data();
}

// Returns the map's row, from -1 to 1.
const NormalRows::Vectors& NormalRows::map(int y) {
  y = std::clamp(y, 0, texels_.height - 1);
  KnownRow<Vectors>& known = maps_[static_cast<std::size_t>(y) % maps_.size()];
  if (known.y == y) return known.values;
  known.y = y;
  auto& [a, b, c] = known.values;
  for (int x = 0; x < texels_.width; ++x) {
    const glm::vec4 texel = texels_.at(x, y);
    const std::size_t at = static_cast<std::size_t>(x) + 1;
    a[at] = 2.0f * texel.x - 1.0f;
    b[at] = 2.0f * texel.y - 1.0f;
    c[at] = 2.0f * texel.z - 1.0f;
  }
  for (std::vector<float>& component : known.values) {
    component.front() = component[1];
    component.back() = component[width_];
  }
  return known.values;
}

// Finds the sums of the normals of a row's texels at four places.
void NormalRows::find_means(int y) {
  const Vectors& above = map(y - 1);
  const Vectors& here = map(y);
  const Vectors& below = map(y + 1);
  for (std::vector<float>& component : means_) std::fill(component.begin(), component.end(), 0.0f);
  for (const Vectors* other : {&above, &below}) {
    for (std::size_t c = 0; c < 3; ++c)
      mix(here[c].data(), (*other)[c].data(), few[0], width_ + 2, between_[c].data());
    for (const std::size_t neighbour : {0, 2})
      add_units(row_of(between_, 1), row_of(between_, neighbour), few[0], width_, means_[0].data(),
                means_[1].data(), means_[2].data());
  }
  find_bend(row_of(means_, 0), row_of(here, 1), width_, bend_.data());
  bent_.clear();
  for (std::size_t i = 0; i < width_; ++i)
    if (!(bend_[i] >= 0.0f)) bent_.push_back(i);
  if (!bent_.empty()) refine_bent(above, here, below);
}

// Finds the sums of texels with different normals again, from more places.
void NormalRows::refine_bent(const Vectors& above, const Vectors& here, const Vectors& below) {
  Neighbourhoods n;
  for (std::size_t first = 0; first < bent_.size(); first += chunk) {
    const std::size_t count = std::min(chunk, bent_.size() - first);
    const std::span<const std::size_t> texels(&bent_[first], count);
    const std::array<const Vectors*, 3> rows{&above, &here, &below};
    for (std::size_t v = 0; v < 3; ++v)
      for (std::size_t u = 0; u < 3; ++u)
        for (std::size_t c = 0; c < 3; ++c)
          for (std::size_t i = 0; i < count; ++i) n.rows[v][u][c][i] = (*rows[v])[c][texels[i] + u];
    n.sums = {};
    for (const std::size_t v : {0, 2}) {
      for (const float down : many) {
        for (std::size_t u = 0; u < 3; ++u)
          for (std::size_t c = 0; c < 3; ++c)
            mix(n.rows[1][u][c].data(), n.rows[v][u][c].data(), down, count,
                n.between[u][c].data());
        for (const std::size_t u : {0, 2})
          for (const float across : many)
            add_units(row_of(n.between[1], 0), row_of(n.between[u], 0), across, count,
                      n.sums[0].data(), n.sums[1].data(), n.sums[2].data());
      }
    }
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < count; ++i) means_[c][texels[i]] = 0.25f * n.sums[c][i];
  }
}

}  // namespace asos
