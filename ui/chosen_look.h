#pragma once

namespace asos::ui {

/// The parts of a scene's look that the command line sets. They stay for every scene opened later;
/// the other parts follow each scene (default_look, default_background). If the sky is set, the
/// ground stays, too.
struct ChosenLook {
  bool sky = false;
  bool ground = false;
  bool background = false;
};

}  // namespace asos::ui
