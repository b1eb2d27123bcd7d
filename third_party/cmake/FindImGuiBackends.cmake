# Finds the sources of Dear ImGui's backends, which Debian installs as documentation.
# Defines ImGuiBackends_OPENGL3_SOURCE, the path of imgui_impl_opengl3.cpp.
#
# The copy of that backend in libimgui.a has its own loader, which opens libGL and cannot draw into
# an OSMesa context. The backend is therefore compiled again with our own function table.

find_path(ImGuiBackends_DIR imgui_impl_opengl3.cpp
  PATHS /usr/share/doc/libimgui-dev/examples/backends
  NO_DEFAULT_PATH)
mark_as_advanced(ImGuiBackends_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ImGuiBackends
  REQUIRED_VARS ImGuiBackends_DIR
  REASON_FAILURE_MESSAGE "\
the backends' sources belong to the package libimgui-dev but lie below /usr/share/doc, which this \
system leaves out when it installs packages. Reinstall the package with that path included: \
sudo apt-get install --reinstall -o Dpkg::Options::=--path-include=/usr/share/doc/libimgui-dev/* \
libimgui-dev (third_party/setup does this)")

if(ImGuiBackends_FOUND)
  set(ImGuiBackends_OPENGL3_SOURCE "${ImGuiBackends_DIR}/imgui_impl_opengl3.cpp")
endif()
