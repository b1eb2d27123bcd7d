#pragma once

#include <map>
#include <sstream>
#include <string>

namespace asos::test {

/// The parts of the window's state that controls change.
enum class Part {
  settings,
  display,
  lights,
  mirrors,
  camera,
  turntable,
  view,
  choice,
  check,
  limits,
  sky,
  frames,
  study,
  window,
  tour,
  files,
  message,
  picture,
  save
};

/// The controls that change each part, separated by commas; of a name with a slash, the beginning.
struct ControlsOfPart {
  Part part;
  const char* names;
};
inline constexpr ControlsOfPart controls_of_parts[] = {
    {Part::view,
     "Method,Curved mirrors,Preset,Material,Browse...,Soft shadows,View,Blades,"
     "Show,Method in bar,Layers in bar,Tab,Search,Find object,Help,Open...,"
     "File name,Scene file,Cancel,Up,Folder,Quit,Sky path"},
    {Part::settings,
     "EPS,MAX,Cell shading,Stop when,Edge test,Refine shading,Pixel filter,"
     "Jitter unresolved cells,Samples,Seed,Texture filter,TR,Bounces,Max. roughness,"
     "Divergence,Back-face culling,Shadows,Indirect light (1 bounce),Divisions,"
     "Light rule,EPS in bar,MAX in bar,Tolerance (EPS)"},
    {Part::turntable, "Turntable,Turn time"},
    {Part::limits,
     "Pause,Resume,Refine a part first,Stop,Restart,Continue,Time limit,"
     "Quality goal"},
    {Part::mirrors,
     "DFR,DFRMIN,DFRMAX,N,DFRMIN point,DFRMAX point,N point,Variation,"
     "Blur curve (DFR) instead of roughness,Reset/Mirrors"},
    {Part::choice,
     "DFR of,Light,Show gizmos,Light arrow,Keep total power,Wireframe,"
     "Click to focus,Click the picture...,Object,Why is this pixel like this?,"
     "Watch file,Show edges,Close inspector,Pyray,Back"},
    {Part::sky,
     "Sky,Zenith,Horizon,Sky colour,Brightness,Environment,Background,Ground,"
     "Upper,Lower,Load sky,Turn,Ambient occlusion"},
    {Part::check,
     "Other method,Render and compare,Check splits,Threshold,Show missed,"
     "Show unneeded"},
    {Part::display,
     "Exposure,Auto exposure,Tone,Dimming,Legends,Axes,Scale bar,Reset/Window,"
     "Grid,Exposure in bar,Map by"},
    {Part::camera,
     "Axis,Axes turn,Frame all,Reset view,Front,Right,Top,Projection,"
     "Field of view,Depth of field,Aperture,Blade turn,Auto focus,Focus"},
    {Part::lights,
     "Reset/Settings,Reset/Lights,Light on,Add light,Remove light,Light from face,"
     "Type,Colour,Intensity,Radius,Length,Width,Height,Sun's angle,Cone,"
     "Inner cone,Shape,Position,Azimuth,Elevation,Roll,Two-sided,Casts shadows,"
     "Mark"},
    {Part::frames,
     "Keep snapshot,Delete snapshot,Snapshot,With,Shown as,Show other,Wipe,"
     "Wipe line,Scale"},
    {Part::study, "Study,Budget,Resolution,Reference time,Repetitions"},
    {Part::window, "Theme,Picture bar,Text size"},
    {Part::picture, "Layer,Before,Now,-,Zoom,+"},
    {Part::message,
     "Hide,Isolate,Show all,Compare now,Save picture,Copy picture,Copy errors,"
     "Copy options,Copy as glTF,Copy,Close,Copy warnings"},
    {Part::tour, "Tour,Next,Previous,Close tour,Done,Replay"},
    {Part::files, "Show on the fence scene,Reload,Open,Entry,Built-in,Recent"},
    {Part::save,
     "Save as...,Content,Format,Layers in file,Size,Frames,Frame rate,Movie format,"
     "Width (px),Height (px),Save,Save scene...,Save scene"},
};

/// The part that each control changes, by the control's name or its beginning up to a slash.
inline const std::map<std::string, Part> parts = [] {
  std::map<std::string, Part> all;
  for (const ControlsOfPart& row : controls_of_parts) {
    std::istringstream names(row.names);
    for (std::string name; std::getline(names, name, ',');) all.emplace(name, row.part);
  }
  return all;
}();

}  // namespace asos::test
