#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace asos::ui {

/// A method's colour in plots: sRGB, 0xRRGGBB. Colour-blind users can distinguish the colours.
[[nodiscard]] std::uint32_t method_colour(const std::string& method);

/// The corners of a method's mark: a convex polygon about the origin with a radius of about 1, y
/// down. Each method has a different shape.
[[nodiscard]] std::vector<glm::vec2> method_mark(const std::string& method);

/// A method's title on buttons: "Adaptive Sobol" for "sobol-adaptive".
[[nodiscard]] std::string method_title(const std::string& method);
/// The title of a curve, whose name begins with the method's name.
[[nodiscard]] std::string curve_title(const std::string& curve, const std::string& method);

}  // namespace asos::ui
