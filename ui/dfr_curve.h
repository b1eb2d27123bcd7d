#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <numbers>

// Values that the editor of defocusing ratios (CGF'98 section 5.1) plots, and the edits that
// dragging its points makes.

namespace asos::ui {

/// The colour channels that an edit changes.
enum class DfrChannel { all, red, green, blue };

/// Angle of the plotted pyray: 2 degrees, as in figure 7.
inline constexpr double plotted_pyray_rad = std::numbers::pi / 90.0;
inline constexpr double most_plotted_exponent = 1000.0;

/// Angle of incidence where a curve is half-way from DFRMIN to DFRMAX, in degrees from 0 (N = 0) to
/// 90.
[[nodiscard]] double halfway_deg(double exponent);
/// Returns the exponent whose half-way angle is `angle_deg`: 0 to most_plotted_exponent.
[[nodiscard]] double exponent_of_halfway(double angle_deg);

[[nodiscard]] bool alike(const Dfr& dfr);
/// Returns the curve of the channel; for `all`, that of red.
[[nodiscard]] const DfrCurve& curve_of(const Dfr& dfr, DfrChannel channel);
void set_curves(Dfr& dfr, DfrChannel channel, double DfrCurve::*member, double value);

/// Upper end of the axis for the plotted pyray's widening, in percent: 1, 2 or 5 times a power of
/// ten, at least 10. It holds the widening at every angle.
[[nodiscard]] double widening_axis(const Dfr& dfr);

/// Radiance that a pyray sees in the mirror of a white bar on black, 0 to 1, linear, per colour.
/// The bar is mirrored_bar_width pyrays wide. `place`: distance of the pyray from the bar's centre,
/// in widths of an unwidened pyray. The filter is that of the renderer's blurred reflections: the
/// pyray's box convolved with the box that widens it.
inline constexpr double mirrored_bar_width = 12.0;
[[nodiscard]] glm::vec3 mirrored_bar(const Dfr& dfr, double incidence_rad, double place);

}  // namespace asos::ui
