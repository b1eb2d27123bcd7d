// Fits renderer/shading/ltc_table.cpp: fit_ltc FILE writes it and says how good the fit is. What is
// minimised is half of the integral of |lobe - fit| over all directions, both with the integral 1,
// and to a part the root of that of the squares. By no more than the first, as a share of the
// lobe's norm, is any light off that is equally bright all over: it is in the table.

#include "renderer/shading/ltc_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <optional>
#include <vector>

namespace asos {
namespace {

using std::numbers::pi;

constexpr int n_cosines = static_cast<int>(ltc_cosines);
constexpr int n_roughnesses = static_cast<int>(ltc_roughnesses);
/// A dielectric's: what the lobe times (1 - v.h)^5 is seen beside.
constexpr double least_f0 = 0.04;

/// Parameters as in LtcEntry, with the logarithms of width and stretch.
using Parameters = std::array<double, 4>;

/// One direction of the quadrature: x leads where the view is mirrored to, z along the normal. The
/// other side of the plane of view is the same.
struct Direction {
  double x, y, z;
  double weight;
  std::array<double, 2> value;  ///< of the lobe times the cosine, and with (1 - v.h)^5
};

struct Situation {
  double alpha, cosine, sine;
  std::vector<Direction> directions;
  std::array<double, 2> norm{0.0, 0.0};
};

double radical_inverse(std::uint32_t bits) {
  bits = (bits << 16u) | (bits >> 16u);
  bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xAAAAAAAAu) >> 1u);
  bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xCCCCCCCCu) >> 2u);
  bits = ((bits & 0x0F0F0F0Fu) << 4u) | ((bits & 0xF0F0F0F0u) >> 4u);
  bits = ((bits & 0x00FF00FFu) << 8u) | ((bits & 0xFF00FF00u) >> 8u);
  return (bits + 0.5) * 0x1p-32;
}

/// A visible normal of the GGX distribution (Heitz 2018), seen from (-sine, 0, cosine); of y >= 0.
std::array<double, 3> visible_normal(const Situation& at, double u, double v) {
  const double length = std::hypot(at.alpha * at.sine, at.cosine);
  const double vx = -at.alpha * at.sine / length;
  const double vz = at.cosine / length;
  const double r = std::sqrt(u);
  const double angle = pi * (v - 0.5);
  const double p1 = r * std::cos(angle);
  const double lift = 0.5 * (1.0 + vz);
  const double p2 = (1.0 - lift) * std::sqrt(1.0 - p1 * p1) + lift * r * std::sin(angle);
  const double p3 = std::sqrt(std::max(0.0, 1.0 - p1 * p1 - p2 * p2));
  const double x = at.alpha * (vx * p3 + vz * p2);
  const double y = at.alpha * p1;
  const double z = std::max(1e-12, vz * p3 - vx * p2);
  const double all = std::sqrt(x * x + y * y + z * z);
  return {x / all, y / all, z / all};
}

/// The value of a direction, and its weight among `count` of which three in four are mirrored at
/// visible normals and the others lie by the cosine.
void weigh(const Situation& at, int count, Direction& d) {
  const double hx = d.x - at.sine;
  const double hz = d.z + at.cosine;
  const double length = std::sqrt(hx * hx + d.y * d.y + hz * hz);
  const double n_h = hz / length;
  const double v_h = std::clamp((at.cosine * hz - at.sine * hx) / length, 0.0, 1.0);
  const double a2 = at.alpha * at.alpha;
  const double b = (hx * hx + d.y * d.y) / (length * length) + n_h * n_h * a2;
  const double distribution = a2 / (pi * b * b);
  const auto root = [a2](double cosine) { return std::sqrt(cosine * cosine * (1.0 - a2) + a2); };
  const double pdf = 0.75 * 0.5 * distribution / (at.cosine + root(at.cosine)) + 0.25 * d.z / pi;
  d.weight = 1.0 / (pdf * count);
  const double lobe = distribution * 0.5 / (d.z * root(at.cosine) + at.cosine * root(d.z));
  const double m = 1.0 - v_h;
  d.value = {lobe * d.z, lobe * d.z * m * m * m * m * m};
}

Situation situation(double roughness, double cosine, int count) {
  Situation at;
  at.alpha = roughness * roughness;
  at.cosine = cosine;
  at.sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  for (int i = 0; i < count; ++i) {
    const double u = (i + 0.5) / count;
    const double v = radical_inverse(static_cast<std::uint32_t>(i));
    Direction d{};
    if (u < 0.75) {
      const auto h = visible_normal(at, u / 0.75, v);
      const double v_h = at.cosine * h[2] - at.sine * h[0];
      d.x = 2.0 * v_h * h[0] + at.sine;
      d.y = 2.0 * v_h * h[1];
      d.z = 2.0 * v_h * h[2] - at.cosine;
    } else {
      const double r2 = (u - 0.75) / 0.25;
      d.x = std::sqrt(r2) * std::cos(pi * v);
      d.y = std::sqrt(r2) * std::sin(pi * v);
      d.z = std::sqrt(1.0 - r2);
    }
    if (!(d.z > 0.0)) continue;
    weigh(at, count, d);
    for (std::size_t k : {0u, 1u}) at.norm[k] += d.weight * d.value[k];
    at.directions.push_back(d);
  }
  return at;
}

/// Of a lobe and its fit, both with the integral 1.
struct Distance {
  double half_l1 = 0.0;  ///< half of the integral of |lobe - fit|
  double l2 = 0.0;       ///< root of that of (lobe - fit)^2, over that of lobe^2
};

Distance distance(const Situation& at, std::size_t part, const Parameters& p) {
  const double tilt = at.alpha * p[0];
  const double axis_x = at.sine * std::cos(tilt) + at.cosine * std::sin(tilt);
  const double axis_z = at.cosine * std::cos(tilt) - at.sine * std::sin(tilt);
  const double up = at.alpha / std::exp(p[1]);
  const double across = 1.0 / std::exp(p[2]);
  const double lean = p[3] / at.cosine;
  // What of the transformed cosine lies above the horizon.
  const double nx = -axis_x - lean * axis_z;
  const double nz = axis_z / up;
  const double above = 0.5 * (1.0 + nz / std::hypot(nx, nz));
  if (!(above > 0.02)) return {10.0, 10.0};
  const double scale = across * up / (pi * above);
  double sum = 0.0;
  double seen = 0.0;
  double squares = 0.0;
  double own_squares = 0.0;
  for (const Direction& d : at.directions) {
    const double x = axis_z * d.x - axis_x * d.z;
    const double y = across * d.y;
    const double z = up * (axis_x * d.x + axis_z * d.z + lean * x);
    const double length2 = x * x + y * y + z * z;
    const double fit = z > 0.0 ? scale * z / (length2 * length2) : 0.0;
    const double own = d.value[part] / at.norm[part];
    sum += d.weight * std::abs(own - fit);
    squares += d.weight * (own - fit) * (own - fit);
    own_squares += d.weight * own * own;
    seen += d.weight * fit;
  }
  // What the directions do not see of the fit lies between them, where the lobe has nothing.
  return {0.5 * (sum + std::abs(1.0 - seen)), std::sqrt(squares / own_squares)};
}

/// Nelder and Mead's simplex (1965).
template <class F>
Parameters minimise(const F& f, const Parameters& start, const Parameters& steps, int rounds) {
  struct Corner {
    Parameters at;
    double value;
  };
  std::vector<Corner> simplex{{start, f(start)}};
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (steps[i] == 0.0) continue;
    Parameters at = start;
    at[i] += steps[i];
    simplex.push_back({at, f(at)});
  }
  const auto better = [](const Corner& a, const Corner& b) { return a.value < b.value; };
  for (int round = 0; round < rounds; ++round) {
    std::sort(simplex.begin(), simplex.end(), better);
    if (simplex.back().value - simplex.front().value < 1e-6) break;
    Parameters middle{};
    for (std::size_t k = 0; k + 1 < simplex.size(); ++k) {
      for (std::size_t i = 0; i < middle.size(); ++i)
        middle[i] += simplex[k].at[i] / static_cast<double>(simplex.size() - 1);
    }
    Corner& worst = simplex.back();
    const auto along = [&](double t) {
      Parameters at;
      for (std::size_t i = 0; i < at.size(); ++i) at[i] = middle[i] + t * (worst.at[i] - middle[i]);
      return Corner{at, f(at)};
    };
    const Corner mirrored = along(-1.0);
    if (mirrored.value < simplex.front().value) {
      const Corner farther = along(-2.0);
      worst = better(farther, mirrored) ? farther : mirrored;
    } else if (mirrored.value < simplex[simplex.size() - 2].value) {
      worst = mirrored;
    } else {
      const Corner nearer = along(mirrored.value < worst.value ? -0.5 : 0.5);
      if (nearer.value < std::min(mirrored.value, worst.value)) {
        worst = nearer;
        continue;
      }
      for (std::size_t k = 1; k < simplex.size(); ++k) {
        for (std::size_t i = 0; i < start.size(); ++i)
          simplex[k].at[i] = 0.5 * (simplex[k].at[i] + simplex[0].at[i]);
        simplex[k].value = f(simplex[k].at);
      }
    }
  }
  return std::min_element(simplex.begin(), simplex.end(), better)->at;
}

double table_roughness(double i) {
  return 0.1 + 0.9 * i / (n_roughnesses - 1);
}
double table_cosine(double i) {
  const double t = i / (n_cosines - 1);
  return ltc_least_cosine + (1.0 - ltc_least_cosine) * t * t * (3.0 - 2.0 * t);
}

/// Of what a dielectric mirrors all around; of the lobe without Fresnel a metal's.
double share_of(const Situation& at, std::size_t part) {
  return part == 0 ? 1.0 : at.norm[1] / (at.norm[1] + least_f0 * at.norm[0]);
}

struct Fitted {
  Parameters parameters{};
  double norm = 0.0;
  double error = 0.0;
  bool done = false;
};

class Fit {
 public:
  Fit() : cells_(static_cast<std::size_t>(n_cosines * n_roughnesses)) {}

  Fitted& at(int roughness, int cosine) {
    return cells_[static_cast<std::size_t>(roughness * n_cosines + cosine)];
  }

  /// All entries, from rough to smooth and from above to grazing or back, each from its
  /// neighbours; the table is interpolated, so that an entry like its neighbours' mean is preferred
  /// where it is as good.
  void sweep(std::size_t part, bool back) {
    for (int r = n_roughnesses - 1; r >= 0; --r) {
      for (int k = 0; k < n_cosines; ++k) {
        const int c = back ? k : n_cosines - 1 - k;
        fit(part, back ? n_roughnesses - 1 - r : r, c);
      }
    }
  }

  [[nodiscard]] Parameters between(double roughness, double cosine) {
    const int r = std::min(static_cast<int>(roughness), n_roughnesses - 2);
    const int c = std::min(static_cast<int>(cosine), n_cosines - 2);
    Parameters mean{};
    for (int i = 0; i < 4; ++i) {
      const double wr = i / 2 ? roughness - r : 1.0 - (roughness - r);
      const double wc = i % 2 ? cosine - c : 1.0 - (cosine - c);
      const Parameters& p = at(r + i / 2, c + i % 2).parameters;
      mean[0] += wr * wc * p[0];
      mean[1] += wr * wc * std::exp(p[1]);
      mean[2] += wr * wc * std::exp(p[2]);
      mean[3] += wr * wc * p[3];
    }
    mean[1] = std::log(mean[1]);
    mean[2] = std::log(mean[2]);
    return mean;
  }

 private:
  void fit(std::size_t part, int r, int c) {
    // With too few directions at a grazing angle a fit would hide between them.
    const double cosine = table_cosine(c);
    const Situation here = situation(table_roughness(r), cosine, cosine < 0.3 ? 5000 : 1500);
    const bool upright = c == n_cosines - 1;
    Parameters mean{};
    int neighbours = 0;
    const auto neighbour = [&](int i, int k) {
      if (i < 0 || k < 0 || i >= n_roughnesses || k >= n_cosines || !at(i, k).done) return;
      ++neighbours;
      for (std::size_t j = 0; j < mean.size(); ++j) mean[j] += at(i, k).parameters[j];
    };
    neighbour(r - 1, c);
    neighbour(r + 1, c);
    neighbour(r, c - 1);
    neighbour(r, c + 1);
    const bool alone = neighbours == 0;
    for (double& m : mean) m /= std::max(1, neighbours);
    std::vector<Parameters> starts;
    if (!alone) starts.push_back(mean);
    starts.push_back(at(r, c).done ? at(r, c).parameters
                                   : Parameters{0.0, std::log(0.5), std::log(cosine), 0.0});

    const double share = std::max(least_share, share_of(here, part));
    const auto badness = [&](const Parameters& p) {
      const Distance off = distance(here, part, p);
      double sum = share * (off.half_l1 + peak_weight * off.l2);
      for (std::size_t i = 0; i < p.size() && !alone; ++i)
        sum += smoothness * (p[i] - mean[i]) * (p[i] - mean[i]);
      return sum;
    };
    Fitted& best = at(r, c);
    double least = 1e9;
    for (Parameters start : starts) {
      if (upright) start[0] = start[3] = start[2] = 0.0;
      const double free = upright ? 0.0 : 0.1;
      Parameters found = minimise(badness, start, {free, 0.1, free, free}, 120);
      found = minimise(badness, found, {0.3 * free, 0.03, 0.3 * free, 0.3 * free}, 120);
      const double value = badness(found);
      if (value < least) {
        least = value;
        best.parameters = found;
      }
    }
    best.done = true;
  }

  /// The mean alone would let go of a narrow peak on a broad lobe, which a small light shows.
  static constexpr double peak_weight = 0.15;
  static constexpr double smoothness = 5e-4;
  static constexpr double least_share = 0.05;
  std::vector<Fitted> cells_;
};

/// The final norms and errors; says the mean and the worst by roughness and angle of view, both in
/// the middle between the table's places and as shares of what a dielectric mirrors.
void judge(Fit& fit, std::size_t part) {
  for (int r = 0; r < n_roughnesses; ++r) {
    for (int c = 0; c < n_cosines; ++c) {
      Fitted& cell = fit.at(r, c);
      const Situation here = situation(table_roughness(r), table_cosine(c), 20000);
      cell.norm = here.norm[part];
      cell.error = distance(here, part, cell.parameters).half_l1;
    }
  }
  double worst_excess = 0.0;
  constexpr std::array<double, 6> bounds{1.01, 0.5, 0.34, 0.17, 0.05, 0.0};
  for (std::size_t band = 1; band < bounds.size(); ++band) {
    double sum = 0.0;
    double shared = 0.0;
    double worst = 0.0;
    double worst_shared = 0.0;
    int count = 0;
    for (int r = 1; r < n_roughnesses; ++r) {
      for (int c = 1; c < n_cosines; ++c) {
        const double cosine = table_cosine(c - 0.5);
        if (cosine < bounds[band] || cosine >= bounds[band - 1]) continue;
        const Situation here = situation(table_roughness(r - 0.5), cosine, 5000);
        const double error = distance(here, part, fit.between(r - 0.5, c - 0.5)).half_l1;
        double corners = 0.0;
        for (int i = 0; i < 4; ++i) corners += 0.25 * fit.at(r - i / 2, c - i % 2).error;
        const double share = share_of(here, part);
        worst_excess = std::max(worst_excess, share * (error - corners));
        sum += error;
        shared += error * share;
        worst = std::max(worst, error);
        worst_shared = std::max(worst_shared, error * share);
        ++count;
      }
    }
    std::printf(
        "part %zu, n.v from %.2f: mean %.4f worst %.4f, of all that is mirrored %.4f %.4f\n", part,
        bounds[band], sum / count, worst, shared / count, worst_shared);
  }
  std::printf("part %zu: interpolation adds at most %.4f of all that is mirrored\n", part,
              worst_excess);
}

void write(std::FILE* file, Fit& fit, std::size_t part, const char* name) {
  std::fprintf(file, "const LtcTable %s = {{\n", name);
  for (int r = 0; r < n_roughnesses; ++r) {
    for (int c = 0; c < n_cosines; ++c) {
      const Fitted& cell = fit.at(r, c);
      const Parameters& p = cell.parameters;
      const auto number = [&](double v, const char* end) { std::fprintf(file, "%.6ef%s", v, end); };
      std::fputs("{", file);
      const double norm = part == 0 ? cell.norm : std::pow(cell.norm, 0.2);
      for (const double v : {p[0], std::exp(p[1]), std::exp(p[2]), p[3], norm}) number(v, ", ");
      std::fprintf(file, "%.3ef},\n", cell.error);
    }
  }
  std::fputs("}};\n", file);
}

}  // namespace
}  // namespace asos

int main(int argc, char** argv) {
  using namespace asos;
  if (argc != 2) return std::fputs("usage: fit_ltc FILE\n", stderr), 2;
  std::array<Fit, 2> fits;
  for (std::size_t part : {0u, 1u}) {
    fits[part].sweep(part, false);
    fits[part].sweep(part, true);
    fits[part].sweep(part, false);
    judge(fits[part], part);
  }
  std::FILE* file = std::fopen(argv[1], "w");
  if (!file) return std::fputs("cannot write the file\n", stderr), 1;
  std::fputs(
      "// Written by tests/tools/fit_ltc.cpp.\n\n#include \"renderer/shading/ltc_table.h\"\n\n"
      "// clang-format off\nnamespace asos {\n\n",
      file);
  write(file, fits[0], 0, "ltc_of_lobe");
  std::fputs("\n", file);
  write(file, fits[1], 1, "ltc_of_fresnel");
  std::fputs("\n}  // namespace asos\n", file);
  return std::fclose(file) == 0 ? 0 : 1;
}
