#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <numbers>

// The values that the editor of defocusing ratios (CGF'98 section 5.1) plots, and the effect of
// dragging its points.

namespace asos::ui {

/// The colours whose curves an edit changes.
enum class DfrChannel { all, red, green, blue };

/// The pyray's angle that figure 7 and the plot are about: 2 degrees.
inline constexpr double plotted_pyray_rad = std::numbers::pi / 90.0;
inline constexpr double most_plotted_exponent = 1000.0;

/// Where a curve is half-way from DFRMIN to DFRMAX, in degrees from 0 (N = 0) to 90.
[[nodiscard]] double halfway_deg(double exponent);
/// Its inverse, 0 to most_plotted_exponent.
[[nodiscard]] double exponent_of_halfway(double angle_deg);

[[nodiscard]] bool alike(const Dfr& dfr);
/// The first of the curves that the channel stands for.
[[nodiscard]] const DfrCurve& curve_of(const Dfr& dfr, DfrChannel channel);
void set_curves(Dfr& dfr, DfrChannel channel, double DfrCurve::*member, double value);

/// The end of an axis from 0 % that holds the widening of the plotted pyray at all angles: 1, 2 or
/// 5 times a power of ten, at least 10.
[[nodiscard]] double widening_axis(const Dfr& dfr);

/// Radiance that a pyray sees of a white bar on black by way of the mirror, 0 to 1, linear, by
/// colour. The bar is mirrored_bar_width pyrays wide, and `place` is how far from its middle the
/// pyray looks, in widths of a pyray that is not widened. Weighted as the renderer weighs a blurred
/// reflection: the pyray's box convolved with what widens it.
inline constexpr double mirrored_bar_width = 12.0;
[[nodiscard]] glm::vec3 mirrored_bar(const Dfr& dfr, double incidence_rad, double place);

}  // namespace asos::ui
