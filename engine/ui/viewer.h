#pragma once
// The viewer: events and time in, pictures out. A window's loop and a test without a display drive the very same
// object.

#include <exception>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/comparison/db_worker.h"
#include "engine/language/language.h"
#include "engine/navigate/section_handle.h"
#include "engine/navigate/transition.h"
#include "engine/picture/image.h"
#include "engine/render/renderer.h"
#include "engine/ui/first_hints.h"
#include "engine/ui/interface.h"
#include "engine/ui/interface_pass.h"
#include "engine/ui/lesson_mode.h"
#include "engine/ui/loading.h"
#include "engine/ui/viewer_state.h"
#include "engine/view/input.h"

namespace odontoscope {

struct ViewerOptions {
  Loader load = {};
  /// Must a person say first where its surface lies? By what the request says and the file's name; must be quick.
  std::function<bool(const LoadRequest&)> wants_level = [](const LoadRequest&) { return false; };
  /// Empty: such a question is asked without a picture.
  Previewer preview = {};
  Settings settings = {};
  /// That it speaks, until another is chosen in its panel.
  Language language = {};
  /// Where pictures and scenes are saved; empty: the current folder.
  std::filesystem::path folder = {};
  Clipboard clipboard = {};
  /// Samples a pixel along one axis for a picture that stands still. While it moves, one, if this machine is too slow
  /// for more and `coarse_when_slow`; without that, pictures depend on nothing but the state.
  int side = 2;
  bool coarse_when_slow = true;
  /// Show what the loader has meanwhile, where nothing else is to be seen. What comes then depends on how fast the
  /// machine is.
  bool with_drafts = false;
};

class Viewer {
 public:
  /// The context of `gl` is current now and at every call, and outlives this. Throws GraphicsError, InternalError.
  Viewer(const Gl& gl, const ShaderLibrary& shaders, ViewerOptions options);
  /// Stops a running load and finishes writing pictures.
  ~Viewer();

  /// Begins to load; the model that is shown stays until the new one is ready.
  void open(LoadRequest request);
  /// Kept until the next frame.
  void handle(const Event& event) { events_.push_back(event); }
  /// Does what was asked for since the last frame, and draws.
  void draw(const FrameInput& input, const Target& target);

  /// How long the next frame may wait for an event; 0 while something moves.
  double wait_timeout() const;
  bool loading() const { return job_ != nullptr; }
  /// What the last load ended with, if it failed; the person has been told.
  const std::exception_ptr& failure() const { return failure_; }
  Pointer pointer() const { return pointer_; }
  std::string title() const;
  /// Nothing would be lost by closing; otherwise the person is asked, and ViewerState::close follows once they agree.
  bool may_close();
  /// The part of the picture that the panel leaves, and the views in it, as last drawn.
  const std::vector<ViewPane>& panes() const { return panes_; }

  /// Structures' names beside the tooth: from outside, and not beside DB's surface.
  /// Not while they would answer a question, and not over a lesson's own pins.
  bool names_shown() const {
    return state_.settings.names && state_.shown && !state_.fly.on && !state_.lab.on && !lesson_.asked(state_.notes) &&
           !pins_shown();
  }

  /// What F12 saves, as it is now: the model by the settings for pictures, without the interface. Precondition: a model
  /// is shown. Throws GraphicsError.
  Image picture();
  /// Its scene, with size and samples: `render --scene` draws the same picture.
  Scene scene_of_picture() const;

  const LessonMode& lesson() const { return lesson_; }
  const FirstHints& hints() const { return hints_; }
  const Interface& interface() const { return interface_; }
  ViewerState& state() { return state_; }
  const ViewerState& state() const { return state_; }

 private:
  bool pins_shown() const;
  /// The section's handle: not over a lesson's pins, nor over what is asked about.
  bool handle_shown() const { return state_.scene.section && !lesson_.asked(state_.notes) && !pins_shown(); }

  // viewer_load.cpp: models; viewer_volume.cpp: what is asked about one
  void take_finished_load();
  void take_draft();
  void give_up_loading();
  void ask_about(LoadRequest request);
  void update_question();
  /// Measures, off the frame's thread, how the model lies to its data once somebody wants to see it.
  void update_deviations();
  void show(std::shared_ptr<const LoadedModel> shown);

  // viewer.cpp: a frame
  void follow_language();
  void advance(double seconds);
  void perform(Action action);
  void lay_out(const FrameInput& input);
  void make_overlays();
  /// What the cap shows, in the graphics processor's memory; null: the material.
  const GpuValueGrid* cap_values();
  /// The grey values as a volume to cast rays through; null: they are not shown.
  GpuVolume* volume();
  /// Both of these: false, and told, where there is no room for them.
  bool upload_values();
  void draw_model(const FrameInput& input, const Target& target);
  void draw_interface(const FrameInput& input, const Target& target);
  void choose(Tool tool);
  void toggle_section();
  void escape();
  void go_to(const Camera& camera, double seconds = transition_seconds);
  void lead_to(const glm::dvec3& place);
  /// Looks from where an X-ray tube would stand, from as far as now.
  void swing_tube(double degrees);
  /// Goes so far back that the film's edge is in the picture, too.
  void show_film();
  void notice(std::string words, bool bad = false, double seconds = Notice{}.seconds_left);

  // viewer_lab.cpp: DB mode
  bool perform_in_lab(Action action);
  void enter_lab();
  void leave_lab();
  /// Passes what is wanted on to the worker and takes what it made.
  void update_lab();
  void lay_out_lab(const Area& whole);
  bool on_split_line(double x, double y) const;
  void lead_to_artefact(std::size_t artefact);
  /// Shows again what was hidden for it.
  void put_artefact_away();
  void step_artefact(int by);
  void begin_lesson();
  void go_to_step(std::size_t step);
  void draw_pane(const ViewPane& pane, PixelSize size, int side);
  const Model& model_of(const ViewPane& pane) const { return pane.db ? state_.lab.made->model : state_.shown->model; }
  const Pickable& pickable_of(const ViewPane& pane) const {
    return pane.db ? *state_.lab.made->pickable : *state_.shown->pickable;
  }

  // viewer_fly.cpp: flying
  bool flight_possible() const;
  bool perform_in_flight(Action action);
  /// And do `then` once there, if anything.
  void enter_cavity(std::size_t cavity, std::function<void()> then = {});
  void enter_outdoors();
  void arrive(std::optional<std::size_t> cavity, const Flight& flight);
  void leave_flight();
  void end_flight();
  void pass_wall();
  void darken_then(std::function<void()> at_dark);
  void advance_flight(double seconds);
  void see_from_flight();
  void look_by(double across, double down);
  void on_flight_key(const KeyChanged& key);
  void on_gamepad(const GamepadChanged& gamepad);
  FlightWish flight_wish() const;
  FlightRules flight_rules() const;
  const Walls& walls_now() const;
  bool flight_moves() const;

  // viewer_ride.cpp: along canals, and where one is
  bool perform_on_ride(Action action);
  void begin_ride(std::size_t line);
  /// Where the ball fits through; empty, and told why, if there is nothing to ride.
  Track rideable_track(std::size_t cavity, std::size_t line);
  void start_ride(std::size_t line, Track track);
  void advance_ride(const FlightWish& wish, double seconds);
  void leave_ride();
  void draw_inset(const Target& target);

  // viewer_canals.cpp: canals pointed at from outside
  std::optional<CanalPick> canal_at(const ViewPane& pane, double x, double y) const;
  /// In flight: on the small picture of the tooth.
  std::optional<CanalPick> canal_in_small_picture(double x, double y) const;
  /// Into its cavity if one is not there, and along it.
  void ride_canal(std::size_t cavity, std::size_t line);
  void enter_here();

  /// What a question or a note would be told of this place.
  std::optional<PointedAt> pointed_at(const ViewPane& pane, double x, double y) const;

  // viewer_notes.cpp: a teacher's notes
  void update_notes();
  bool perform_on_notes(Action action);
  void write_note();
  void save_notes();
  bool open_lesson(LoadRequest& request);
  void take_lesson(Lesson lesson);
  LessonNote view_now();
  void save_marks();
  bool point_for_lesson(const ViewPane& pane, double x, double y);
  void point_at_middle();
  bool ride_for_note(const LessonNote& note);
  void go_to_note(std::size_t number);
  void show_note_outside(const LessonNote& note);
  /// At once what a lesson's looks were on their way to.
  void settle_looks();
  bool notes_at_risk() const;
  void answer_about_notes();

  // viewer_gestures.cpp: mouse and keys
  void react(const Event& event);
  void on_move(const MouseMoved& move);
  void on_button(const MouseButtonChanged& button);
  void on_scroll(const Scrolled& scroll);
  void on_key(const KeyChanged& key);
  void on_text(const TextTyped& text);
  bool on_panel_key(const KeyChanged& key);
  bool answer_by_enter();
  /// Something has to be read or answered first.
  bool dialog_open() const;
  void on_drop(const FilesDropped& drop);
  void on_press(const MouseButtonChanged& button);
  void on_click(double x, double y);
  void measure_at(const Pickable& pickable, const Hit& hit);
  const ViewPane* pane_at(double x, double y) const;
  void set_camera(const Camera& camera);
  std::optional<Hit> hit_at(const ViewPane& pane, double x, double y) const;
  /// The surface under a pixel, or the plane through the camera's target.
  glm::dvec3 anchor_at(const ViewPane& pane, double x, double y) const;
  void show_hovered();

  // viewer_files.cpp: pictures and scenes
  std::filesystem::path new_file(const std::string& stem, const std::string& ending);
  void take_picture();
  /// In the window's context, which waits for it.
  void take_picture_here();
  void save_scene();
  void take_written();

  struct Drag {
    enum class What { orbit, pan, section, split, look };
    What what = What::orbit;
    MouseButton button = MouseButton::left;
    double x = 0, y = 0;  // where the hand is
    double start_x = 0, start_y = 0;
    bool moved = false;  // far enough to be no click
    glm::dvec3 anchor{0};
    SectionGrip grip = SectionGrip::slide;
    std::size_t pane = 0;  // that it began in
  };
  struct Click {
    double x = 0, y = 0, when = -1e9;
  };
  /// What the kept picture of the model shows; if nothing differs it is shown again.
  struct DrawnModel {
    std::shared_ptr<const LoadedModel> shown;
    Scene scene;
    std::vector<ViewPane> panes;
    std::shared_ptr<const ComparisonResult> db;
    std::optional<std::size_t> artefact;
    PixelSize size;
    int side = 0;
    bool operator==(const DrawnModel&) const = default;
  };

  const Gl* gl_;
  ShaderLibrary shaders_;
  ViewerOptions options_;
  ViewerState state_;
  Interface interface_;
  InterfacePass interface_pass_;
  Renderer renderer_;
  GpuModel gpu_model_;
  GpuOverlay gpu_overlay_;
  OverlayChoice overlays_made_;
  std::optional<GpuValueGrid> gpu_values_;  // once they are shown
  std::optional<GpuVolume> gpu_volume_;     // of them
  Framebuffer picture_;
  DrawnModel drawn_;
  double fine_picture_seconds_ = 0.5;  // about what one takes; a slow machine's guess until one was drawn
  double still_since_ = 0;

  LessonMode lesson_;
  FirstHints hints_;
  std::vector<Event> events_;
  std::vector<ViewPane> panes_;
  Area viewport_;  // all of them together
  float scale_ = 1;
  double now_ = 0;
  int frames_to_settle_ = 3;  // panels need a frame or two to follow an event
  double mouse_x_ = -1, mouse_y_ = -1;
  std::optional<Drag> drag_;
  Click last_click_;
  std::optional<Action> hovered_compass_;
  std::optional<SectionGrip> hovered_grip_;
  Pointer pointer_ = Pointer::arrow;
  std::optional<Transition> transition_;
  std::optional<LookTransition> look_transition_;
  std::unique_ptr<LoadJob> job_;
  std::exception_ptr failure_;
  std::vector<std::unique_ptr<LoadJob>> stopped_jobs_;  // until they have noticed
  std::unique_ptr<Job<VolumePreview>> preview_job_;
  std::vector<std::unique_ptr<Job<VolumePreview>>> stopped_previews_;
  std::unique_ptr<Job<LoadedModel>> deviation_job_;
  std::shared_ptr<const LoadedModel> deviations_of_;  // that the job is about
  std::unique_ptr<DbWorker> lab_worker_;
  std::vector<std::unique_ptr<DbWorker>> left_workers_;  // until they have noticed
  std::optional<ComparisonOptions> lab_asked_;                  // of the worker
  GpuModel lab_gpu_model_;
  GpuOverlay lab_gpu_overlay_;
  std::shared_ptr<const ComparisonResult> lab_edges_of_;  // that the overlay was made from,
  std::optional<std::size_t> lab_edges_near_;      // and of which artefact; none: all
  Framebuffer other_half_;                         // of a split view
  std::optional<Camera> draft_camera_;             // while a draft is shown: that it began with
  bool sample_shown_ = false, lesson_after_load_ = false, artefact_when_made_ = false;
  struct Fade {
    double seconds = 0;
    bool done = false;  // what the dark is for
    std::function<void()> at_dark;
  };
  std::optional<Fade> fade_;
  Framebuffer inset_;  // the tooth from outside, drawn once
  std::shared_ptr<const LoadedModel> inset_of_;
  NamedView inset_from_ = NamedView::buccal;
  int tabs_ = 0;         // asked for: controls on, or back
  char last_place_ = 0;  // of the key pressed last, for keyboards without Latin letters
  std::set<int> held_;   // keys, while one flies; see viewer_fly.cpp
  GamepadChanged gamepad_;
  std::optional<Camera> camera_before_dive_;
  std::string file_shown_;  // that the model came from; empty: the sample, or nobody can open it again by name alone
  std::optional<Lesson> lesson_to_load_;
  bool notes_may_go_ = false;                      // the person said so of those that are there
  std::mutex one_picture_;                         // is drawn at a time
  std::vector<std::future<std::string>> writing_;  // each ends with words for a notice, or throws
  std::set<std::filesystem::path> names_given_;    // to files that may not be there yet
};

}  // namespace odontoscope
