#pragma once

#include "renderer/result.h"
#include "ui/edit_history.h"
#include "ui/equal_time.h"
#include "ui/error_map.h"
#include "ui/file_watch.h"
#include "ui/gl_display.h"
#include "ui/input.h"
#include "ui/layer_viewer.h"
#include "ui/max_effect.h"
#include "ui/metered_exposure.h"
#include "ui/panels/controls.h"
#include "ui/panels/grid_overlay.h"
#include "ui/panels/overlays.h"
#include "ui/panels/scroll_anchor.h"
#include "ui/picture_clipboard.h"
#include "ui/picture_saver.h"
#include "ui/previewer.h"
#include "ui/scene_export.h"
#include "ui/selection_outline.h"
#include "ui/shown_progress.h"
#include "ui/split_check.h"
#include "ui/split_forecast.h"
#include "ui/split_pixel.h"
#include "ui/stored_settings.h"
#include "ui/surface_viewer.h"
#include "ui/theme.h"
#include "ui/ui_state.h"
#include "ui/unsaved_work.h"
#include "ui/view_study.h"
#include "ui/window_layout.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>

struct ImGuiContext;

namespace asos::ui {

/// The sizes of the window that a frame is drawn into, and its time.
struct FrameInput {
  glm::ivec2 window_size{0};       ///< the units of the mouse
  glm::ivec2 framebuffer_size{0};  ///< pixels
  float content_scale = 1.0f;      ///< scale of text relative to a screen at scale 1
  double time_seconds = 0.0;       ///< never falls
  bool shown = true;               ///< false: everything but the drawing, for tests
};

/// The content of the window: picture, panel and dialogs, drawn into the current OpenGL context.
/// The window and the tests run the same code. Not thread-safe. Only one at a time, because it owns
/// Dear ImGui's context.
class WindowContent {
 public:
  /// Needs a current OpenGL 3.3 context with loaded functions (ui/gl/gl.h) for its whole lifetime.
  /// `previewer` must outlive it.
  [[nodiscard]] static Result<std::unique_ptr<WindowContent>> make(Previewer& previewer);
  ~WindowContent();
  WindowContent(const WindowContent&) = delete;
  WindowContent& operator=(const WindowContent&) = delete;

  [[nodiscard]] InputQueue& input() { return input_; }

  /// Draws one frame. A frame without area only updates the previewer.
  void draw(const FrameInput& in);

  /// Seconds from the last frame until the next one is due without any event; none: only after
  /// input, or when the previewer wakes.
  [[nodiscard]] std::optional<double> seconds_to_redraw() const;

  /// Opens a file that was dropped on the window: a sky, a scene or a saved picture.
  void open_dropped(const std::string& path);

  [[nodiscard]] UiState& state() { return state_; }
  /// The part of the state that is stored between runs.
  [[nodiscard]] StoredSettings stored_settings() const;
  void apply(const StoredSettings& stored);
  [[nodiscard]] const Controls& controls() const { return controls_; }
  [[nodiscard]] const ViewStudy& study() const { return study_; }
  [[nodiscard]] const SurfaceViewer& surfaces() const { return surfaces_; }
  [[nodiscard]] const LayerViewer& layers() const { return layers_; }
  [[nodiscard]] const PictureJob& picture_job() const { return saver_.job(); }
  /// The area of the framebuffer that shows the picture, from the top left.
  [[nodiscard]] PixelRect picture_rect() const { return picture_rect_; }
  [[nodiscard]] const WindowLayout& layout() const { return layout_; }

 private:
  WindowContent(Previewer& previewer, GlDisplay display, ImGuiContext* context);
  void take_outcomes();
  void begin_frame(const FrameInput& in);
  [[nodiscard]] bool awaits_search();
  void lay_out(const FrameInput& in);
  void panel_window(const WindowRect& rect);
  void update_display();
  void present(const FrameInput& in);
  void focus_panel();
  void dialogs(const WindowRect& picture);
  void keep_saving();
  void save_window(const FrameInput& in);
  void keep_exporting();
  void keep_copying();
  [[nodiscard]] std::uint32_t activity() const;
  void take_back();
  void keep_history(double now_seconds);
  void explain_a_pixel();
  void explain_max();
  [[nodiscard]] std::string hovered_layer() const;
  void follow_files(double now_seconds);
  void say(std::string message);
  void settle();
  [[nodiscard]] std::optional<TimeEstimate> estimate() const;
  [[nodiscard]] bool marks_splits() const;
  [[nodiscard]] bool wants_reference() const;

  Previewer& previewer_;
  GlDisplay display_;
  GridOverlay grid_;
  ImGuiContext* context_;
  InputQueue input_;
  UiState state_;
  Controls controls_;
  ScrollAnchor scroll_anchor_;
  ViewStudy study_;
  EditHistory history_;
  PixelInspector inspector_;
  SplitPixelSearch split_search_;
  SkyReader sky_reader_;
  MeteredExposure metered_exposure_;
  SplitForecast forecast_;
  ShownProgress progress_;
  SplitCheck check_;
  MaxExplainer max_;
  SurfaceViewer surfaces_;
  SelectionOutline outline_;
  LayerViewer layers_;
  ErrorReference error_reference_;
  EqualTimeJob equal_time_;
  FileWatch watch_;
  PictureSaver saver_;
  SceneExportJob scene_export_;
  UnsavedWork::Edits exported_;  // the edits that scene_export_ writes
  ClipboardJob clipboard_;
  UnsavedWork unsaved_;
  std::uint64_t restarts_seen_ = 0;
  bool before_shown_ = false;
  DisplaySettings shown_display_;     // settings of the displayed picture
  std::uint64_t surfaces_shown_ = 0;  // revision of the displayed property; 0: picture
  std::uint64_t layer_shown_ = 0;     // revision of the shown layer; 0: none
  bool touring_ = false;              // in the frame before
  std::uint32_t shown_activity_ = 0;  // activities when the frame was laid out
  std::uint64_t scenes_seen_ = 0;
  std::string source_seen_;
  PixelRect picture_rect_;
  WindowLayout layout_;
  std::optional<theme::Appearance> applied_;  // appearance that the fonts were built for
  double time_seconds_ = 0.0;
  int frames_without_input_ = 0;  // until the search field takes keys
  int settling_frames_ = 0;       // frames that Dear ImGui still needs to settle after a change
};

}  // namespace asos::ui
