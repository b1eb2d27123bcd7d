#pragma once

namespace asos::ui {

/// The parts of a scene's look that were asked for, and stay for scenes that are opened. The others
/// follow the scene: see default_look and default_background. The ground stays with a sky.
struct ChosenLook {
  bool sky = false;
  bool ground = false;
  bool background = false;
};

}  // namespace asos::ui
