#include "renderer/features/alpha_contour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asos {
namespace {

// Each halving of an arc leaves a quarter of its deviation.
constexpr int most_halvings = 12;
// With more contour cells, a texture is noise and gets no outline.
constexpr std::size_t endless_cells = std::size_t{1} << 22;

std::int64_t floor_division(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

/// The curve v00 + b x + c y + d x y = 0 in a unit cell. With X = c + d x and Y = b + d y it is the
/// hyperbola X Y = b c - d v00. On a branch neither X nor Y changes its sign.
struct Hyperbola {
  double b, c, d;

  explicit Hyperbola(const std::array<double, 4>& v)
      : b(v[1] - v[0]), c(v[2] - v[0]), d(v[0] - v[1] - v[2] + v[3]) {}

  /// Returns whether d is 0 up to rounding; if byte values differ, it is larger.
  [[nodiscard]] bool straight() const {
    return std::abs(d) <= 1e-6 * (std::abs(b) + std::abs(c) + std::abs(d));
  }
  /// Returns the point of the branch between p and q that is farthest from their chord. There the
  /// branch is parallel to the chord; X and Y are their geometric means.
  [[nodiscard]] glm::dvec2 farthest(glm::dvec2 p, glm::dvec2 q) const {
    const auto mean = [](double from, double to) {
      return std::copysign(std::sqrt(std::max(0.0, from * to)), from + to);
    };
    const glm::dvec2 between((mean(c + d * p.x, c + d * q.x) - c) / d,
                             (mean(b + d * p.y, b + d * q.y) - b) / d);
    // Rounding may place it next to the branch, but not beyond its ends.
    return glm::clamp(between, glm::min(p, q), glm::max(p, q));
  }
};

double distance_from_chord(glm::dvec2 p, glm::dvec2 q, glm::dvec2 at) {
  const glm::dvec2 chord = q - p, off = at - p;
  const double length = glm::length(chord);
  return length > 0.0 ? std::abs(chord.x * off.y - chord.y * off.x) / length : glm::length(off);
}

/// Collects the pieces of one cell; points are in units of the cell.
struct PieceList {
  const ContourCell& cell;
  std::vector<ContourPiece>& pieces;
  double tolerance;

  // A cell's ends are whole numbers, so 0 and 1 map to them exactly.
  [[nodiscard]] glm::dvec2 placed(glm::dvec2 p) const {
    return {p.x == 1.0 ? cell.hi.x : cell.lo.x + p.x * (cell.hi.x - cell.lo.x),
            p.y == 1.0 ? cell.hi.y : cell.lo.y + p.y * (cell.hi.y - cell.lo.y)};
  }
  void add(glm::dvec2 p, glm::dvec2 q) {
    const ContourPiece piece{placed(p), placed(q)};
    if (piece.from != piece.to) pieces.push_back(piece);
  }
  void add_arc(const Hyperbola& curve, glm::dvec2 p, glm::dvec2 q, int halvings) {
    const glm::dvec2 middle = curve.farthest(p, q);
    if (halvings == 0 || distance_from_chord(p, q, middle) <= tolerance || middle == p ||
        middle == q) {
      add(p, q);
      return;
    }
    add_arc(curve, p, middle, halvings - 1);
    add_arc(curve, middle, q, halvings - 1);
  }
};

}  // namespace

glm::dvec2 texel_place(const Image& image, glm::dvec2 uv) {
  return uv * glm::dvec2(image.width, image.height) - 0.5;
}

std::int64_t AlphaContour::Axis::period() const {
  switch (wrap) {
    case Wrap::repeat:
      return size;
    case Wrap::mirrored_repeat:
      return 2 * size;
    case Wrap::clamp_to_edge:
      break;
  }
  return size + 1;
}

std::int64_t AlphaContour::Axis::cell_at(double x) const {
  const auto cell = static_cast<std::int64_t>(std::floor(x));
  return wrap == Wrap::clamp_to_edge ? std::clamp<std::int64_t>(cell, -1, size - 1) : cell;
}

std::int64_t AlphaContour::Axis::in_period(std::int64_t cell) const {
  if (wrap == Wrap::clamp_to_edge) return cell + 1;
  return cell - period() * floor_division(cell, period());
}

std::int64_t AlphaContour::Axis::texel(std::int64_t i) const {
  if (wrap == Wrap::clamp_to_edge) return std::clamp<std::int64_t>(i, 0, size - 1);
  const std::int64_t within = i - period() * floor_division(i, period());
  return within < size ? within : 2 * size - 1 - within;
}

// Beyond the edge of a clamped texture, everything is as at the edge.
glm::dvec2 AlphaContour::Axis::extent(std::int64_t cell, double x0, double x1) const {
  glm::dvec2 range(static_cast<double>(cell), static_cast<double>(cell + 1));
  if (wrap != Wrap::clamp_to_edge) return range;
  if (cell == -1) range.x = std::min(range.x, std::floor(x0) - 1.0);
  if (cell == size - 1) range.y = std::max(range.y, std::ceil(x1) + 1.0);
  return range;
}

AlphaContour::AlphaContour(const Image& image, const Texture& sampler, float factor, float cutoff)
    : image_(&image),
      across_{sampler.wrap_u, image.width},
      down_{sampler.wrap_v, image.height},
      nearest_(sampler.filter == Filter::nearest) {
  for (std::size_t byte = 0; byte < value_of_.size(); ++byte) {
    const float alpha = factor * static_cast<float>(static_cast<double>(byte) / 255.0);
    value_of_[byte] = static_cast<double>(alpha) - static_cast<double>(cutoff);
  }
  // Alpha lies between 0 and 1. With a lower cut-off nothing is cut out, and with a higher one
  // everything is.
  if (cutoff > 0.0f && cutoff <= 1.0f) find_mixed_cells();
}

double AlphaContour::value(std::int64_t x, std::int64_t y) const {
  const std::int64_t texel = down_.texel(y) * across_.size + across_.texel(x);
  return value_of_[image_->rgba.data()[4 * static_cast<std::size_t>(texel) + 3]];
}

bool AlphaContour::keeps(glm::dvec2 place) const {
  if (nearest_) place += 0.5;
  const glm::dvec2 corner = glm::floor(place);
  const auto x = static_cast<std::int64_t>(corner.x), y = static_cast<std::int64_t>(corner.y);
  const glm::dvec2 f = nearest_ ? glm::dvec2(0.0) : place - corner;
  const double above = glm::mix(value(x, y), value(x + 1, y), f.x);
  const double below = glm::mix(value(x, y + 1), value(x + 1, y + 1), f.x);
  return !(glm::mix(above, below, f.y) < 0.0);
}

void AlphaContour::find_mixed_cells() {
  const std::int64_t first = across_.wrap == Wrap::clamp_to_edge ? -1 : 0;
  const std::int64_t top = down_.wrap == Wrap::clamp_to_edge ? -1 : 0;
  std::array<std::uint8_t, 256> keeps{};
  for (std::size_t byte = 0; byte < keeps.size(); ++byte) keeps[byte] = value_of_[byte] >= 0.0;
  // Byte offsets, in a row of the image, of the alphas of a period.
  std::vector<std::size_t> places;
  for (std::int64_t x = first; x <= first + across_.period(); ++x)
    places.push_back(4 * static_cast<std::size_t>(across_.texel(x)) + 3);
  const auto row_at = [&](std::int64_t y) {
    return image_->rgba.data() + 4 * static_cast<std::size_t>(down_.texel(y) * across_.size);
  };
  first_of_row_.push_back(0);
  for (std::int64_t y = top; y < top + down_.period() && !endless_; ++y) {
    const std::uint8_t* const above = row_at(y);
    const std::uint8_t* const below = row_at(y + 1);
    int left = keeps[above[places[0]]] + keeps[below[places[0]]];
    for (std::size_t i = 1; i < places.size(); ++i) {
      const int right = keeps[above[places[i]]] + keeps[below[places[i]]];
      if (left + right != 0 && left + right != 4)
        columns_.push_back(static_cast<std::int32_t>(first + static_cast<std::int64_t>(i) - 1));
      left = right;
    }
    first_of_row_.push_back(static_cast<std::uint32_t>(columns_.size()));
    endless_ = columns_.size() > endless_cells;
  }
}

AlphaContour::Rows AlphaContour::rows(double y0, double y1) const {
  return {down_.cell_at(y0), down_.cell_at(y1) + 1};
}

std::size_t AlphaContour::most_cells(std::int64_t row, double x0, double x1) const {
  const auto in_period = static_cast<std::size_t>(down_.in_period(row));
  const std::size_t of_tile = first_of_row_[in_period + 1] - first_of_row_[in_period];
  const std::int64_t from = across_.cell_at(x0), to = across_.cell_at(x1);
  const std::int64_t tiles =
      across_.wrap == Wrap::clamp_to_edge
          ? 1
          : floor_division(to, across_.period()) - floor_division(from, across_.period()) + 1;
  const auto cells = static_cast<std::size_t>(to - from + 1);
  return of_tile == 0 ? 0 : std::min(cells, static_cast<std::size_t>(tiles) * (of_tile + 1));
}

void AlphaContour::find_cells(std::int64_t row, double x0, double x1, double y0, double y1,
                              std::vector<ContourCell>& cells) const {
  if (empty()) return;
  const auto in_period = static_cast<std::size_t>(down_.in_period(row));
  const auto begin = columns_.begin() + first_of_row_[in_period];
  const auto end = columns_.begin() + first_of_row_[in_period + 1];
  if (begin == end) return;
  const glm::dvec2 high = down_.extent(row, y0, y1);
  const std::int64_t from = across_.cell_at(x0), to = across_.cell_at(x1);
  const auto add_tile = [&](std::int64_t shift) {
    auto next = std::lower_bound(begin, end, from - shift);
    for (; next != end && *next + shift <= to; ++next) {
      const std::int64_t x = *next + shift;
      const glm::dvec2 wide = across_.extent(x, x0, x1);
      cells.push_back(
          {{wide.x, high.x},
           {wide.y, high.y},
           {value(x, row), value(x + 1, row), value(x, row + 1), value(x + 1, row + 1)}});
    }
  };
  if (across_.wrap == Wrap::clamp_to_edge) return add_tile(0);
  const std::int64_t step = across_.period();
  for (std::int64_t shift = step * floor_division(from, step); shift <= to; shift += step)
    add_tile(shift);
}

void AlphaContour::find_pieces(const ContourCell& cell, double tolerance,
                               std::vector<ContourPiece>& pieces) const {
  const auto& v = cell.value;
  const auto inside = [&](int i) { return v[static_cast<std::size_t>(i)] >= 0.0; };
  // Returns where the curve crosses the side between two corners.
  const auto crossing = [&](std::size_t i, std::size_t k) {
    return nearest_ ? 0.5 : v[i] / (v[i] - v[k]);
  };
  const auto top = [&] { return glm::dvec2(crossing(0, 1), 0.0); };
  const auto bottom = [&] { return glm::dvec2(crossing(2, 3), 1.0); };
  const auto left = [&] { return glm::dvec2(0.0, crossing(0, 2)); };
  const auto right = [&] { return glm::dvec2(1.0, crossing(1, 3)); };

  PieceList list{cell, pieces, tolerance};
  const Hyperbola curve(v);
  const auto add = [&](glm::dvec2 p, glm::dvec2 q) {
    if (nearest_ && p.x != q.x && p.y != q.y) {
      // Pass around a texel's corner.
      list.add(p, glm::dvec2(0.5));
      list.add(glm::dvec2(0.5), q);
    } else if (nearest_ || curve.straight()) {
      list.add(p, q);
    } else {
      list.add_arc(curve, p, q, most_halvings);
    }
  };
  const int corners = inside(0) | inside(1) << 1 | inside(2) << 2 | inside(3) << 3;
  switch (std::min(corners, 15 - corners)) {
    case 1:
      return add(left(), top());
    case 2:
      return add(top(), right());
    case 3:
      return add(left(), right());
    case 4:
      return add(left(), bottom());
    case 5:
      return add(top(), bottom());
    case 7:
      return add(right(), bottom());
    case 6:
      break;
    default:
      return;
  }
  // Diagonal corners are alike, so there are two arcs. Each cuts off a corner that differs from the
  // saddle in between.
  const double saddle = (v[0] * v[3] - v[1] * v[2]) / (v[0] - v[1] - v[2] + v[3]);
  if ((saddle >= 0.0) == inside(0)) {
    add(top(), right());
    add(left(), bottom());
  } else {
    add(left(), top());
    add(right(), bottom());
  }
}

}  // namespace asos
