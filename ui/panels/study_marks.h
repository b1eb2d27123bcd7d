#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace asos::ui {

/// A method's colour in plots: sRGB, 0xRRGGBB. The colours stay apart for the colour-blind.
[[nodiscard]] std::uint32_t method_colour(const std::string& method);

/// The corners of a method's mark, a convex polygon about the origin with a radius of about 1, y
/// down. Each method has another shape.
[[nodiscard]] std::vector<glm::vec2> method_mark(const std::string& method);

/// A method's name on the window's buttons: "Adaptive Sobol" for "sobol-adaptive".
[[nodiscard]] std::string method_title(const std::string& method);
/// The same in the name of one of its curves, which begins with the method's own.
[[nodiscard]] std::string curve_title(const std::string& curve, const std::string& method);

}  // namespace asos::ui
