#include "engine/headset_viewer/headset_loop.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <thread>
#include <utility>
#include <variant>

#include "engine/headset_viewer/headset_comparison.h"
#include "engine/headset_viewer/headset_texture.h"
#include "engine/viewer/compare/compare_mode.h"

namespace odontoscope {

namespace {

constexpr auto rest = std::chrono::milliseconds(10);
/// For a runtime that was asked to end the session.
constexpr auto timeout = std::chrono::seconds(3);
/// While a model loads.
constexpr auto between_looks = std::chrono::milliseconds(500);

bool is_escape(const Event& event) {
  const auto* key = std::get_if<KeyChanged>(&event);
  return key && key->down && key->key == Key::escape;
}

/// Draws the viewer's own frame, which also takes what was loaded.
void draw_viewer(Viewer& viewer, Window& window) {
  const PixelSize size = window.size();
  if (size.width < 1 || size.height < 1) return;  // put away as an icon
  viewer.draw({size, window.scale(), 0.01}, {0, 0, 0, size});
  window.show();
}

/// The viewer's own frames, until there is something to show. false: there never will be.
bool wait_for_model(Viewer& viewer, Window& window, const std::stop_token& stop) {
  do {
    for (const Event& event : window.events(0)) viewer.handle(event);
    draw_viewer(viewer, window);
    if (window.closing() || stop.stop_requested()) return false;
    std::this_thread::sleep_for(rest);
  } while (viewer.loading());
  return viewer.state().shown != nullptr;
}

/// "Molar in the headset, 25 times enlarged - Esc ends it".
std::string title_of(const Visit& visit, const Viewer& viewer, HeadsetState state) {
  const char* doing = state == HeadsetState::focused ? "in the headset" : "waiting for the headset";
  const std::string where = visit.cavity ? "inside" : fmt::format("{:.3g} times enlarged", visit.stage.magnification);
  return fmt::format("{} {}, {} - Esc ends it", viewer.state().shown->title, doing, where);
}

class HeadsetVisit {
 public:
  HeadsetVisit(Viewer& viewer, Window& window, const ShaderLibrary& shaders, const HeadsetVisitOptions& options)
      : viewer_(viewer),
        window_(window),
        shaders_(shaders),
        options_(options),
        gl_(window.context().gl()),
        headset_(open_headset(gl_, options.headset)),
        texture_(gl_, shaders) {
    say(fmt::format("In the headset: {}.", headset_->in_words()));
    put_on_stage();
  }

  void run(const std::stop_token& stop) {
    for (HeadsetState state = headset_->poll(); state != HeadsetState::over; state = headset_->poll()) {
      if (wants_to_leave() || visit_.leaving || stop.stop_requested()) leave();
      if (left_ && Clock::now() - *left_ > timeout) {
        say("The headset's runtime does not let go; leaving without it.");
        return;
      }
      take_new_model();
      tell_controllers(state);
      if (state == HeadsetState::waiting)
        std::this_thread::sleep_for(rest);
      else
        headset_->frame([this](const HeadsetFrame& frame) { return draw(frame); });
      show(state);
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// What the viewer shows, for a person who has yet to be placed before it.
  void put_on_stage() {
    loaded_ = viewer_.state().shown;
    scene_ = viewer_.state().scene;
    comparison_.emplace(loaded_, viewer_.mode<CompareMode>().state());
    shows_db_ = false;
    visit_ = {};
    cavities_ = {};
    painter_.reset();  // first, so that two models need not fit beside each other
    painter_ = std::make_unique<EyePainter>(gl_, shaders_, loaded_->model, options_.quality, loaded_->values);
    if (loaded_->greys && scene_.volume.transfer.empty())
      scene_.volume.transfer = transfer_of(TransferPreset::tooth, loaded_->greys->air, loaded_->greys->dentine);
    if (loaded_->flight) cavities_ = loaded_->flight->cavities;
    say(cavities_.empty() ? "This model has no cavity to enter."
                          : std::string("Point at a cavity, such as the pulp, and pull the trigger to be inside."));
  }

  /// Takes the window's events: files dropped on it are opened, Escape and closing end the visit.
  bool wants_to_leave() {
    bool wants = window_.closing();
    for (const Event& event : window_.events(0)) {
      if (is_escape(event)) wants = true;
      if (!std::holds_alternative<FilesDropped>(event)) continue;
      viewer_.handle(event);
      dropped_ = true;
    }
    return wants;
  }

  void leave() {
    if (left_) return;
    headset_->leave();
    left_ = Clock::now();
  }

  /// While a model loads the window shows how far it is, seldom enough that the headset does not suffer.
  void take_new_model() {
    if (!dropped_ && !viewer_.loading()) return;
    if (!dropped_ && Clock::now() - seen_to_ < between_looks) return;
    dropped_ = false;
    const std::string trouble_before = viewer_.state().trouble;
    draw_viewer(viewer_, window_);
    seen_to_ = Clock::now();
    if (viewer_.state().trouble != trouble_before) say(viewer_.state().trouble);
    if (viewer_.state().shown != loaded_) put_on_stage();
  }

  void say(const std::string& words) const {
    if (options_.say) options_.say(words);
  }

  void tell_controllers(HeadsetState state) {
    if (state != HeadsetState::focused) return;
    const std::string now = headset_->controllers();
    if (now == controllers_) return;
    controllers_ = now;
    say(fmt::format("In the hands: {}.", controllers_));
  }

  Depths draw(const HeadsetFrame& frame) {
    Depths depths;
    choose_model();
    const VisitWorld world{shows_db_ ? comparison_->made()->model : loaded_->model,
                           shows_db_ ? *comparison_->made()->pickable : *loaded_->pickable, scene_, cavities_};
    visit_ = advance_visit(std::move(visit_), frame.input, world, options_.comfort, frame.seconds);
    constexpr double pulse_seconds = 0.04;
    for (std::size_t i = 0; i < 2; ++i)
      if (visit_.hands.pulse[i] > 0) headset_->pulse(i, visit_.hands.pulse[i], pulse_seconds);
    texture_.update(visit_, frame.input, world,
                    {loaded_->title, comparison_->possible(), comparison_->in_words(), loaded_->certificate.headline,
                     mark_of(loaded_->certificate.verdict), loaded_->values && loaded_->greys},
                    frame.seconds);
    if (frame.draw) {
      depths = painter_->draw(
          visit_, frame.input, world, frame.eyes, frame.targets,
          [this](const EyeView& eye, const Target& target) { texture_.draw(eye, target); }, frame.hidden, frame.beat);
      const PixelSize size = window_.size();
      const bool open = size.width > 0 && size.height > 0 && !viewer_.loading();
      if (open) EyePainter::mirror(gl_, frame.targets.front(), {0, 0, 0, size});
      mirrored_ = open;
    }
    if (options_.watch) options_.watch(frame, visit_);
    return depths;
  }

  /// DB where it is wanted and made; from inside it is not seen.
  void choose_model() {
    comparison_->update(visit_.chosen.db);
    const bool db = visit_.chosen.db && !visit_.cavity && comparison_->made();
    if (db != shows_db_) painter_->take(db ? comparison_->made()->model : loaded_->model);
    shows_db_ = db;
  }

  void show(HeadsetState state) {
    if (mirrored_) window_.show();
    mirrored_ = false;
    if (std::string title = title_of(visit_, viewer_, state); title != title_)
      window_.set_title(title_ = std::move(title));
  }

  Viewer& viewer_;
  Window& window_;
  const ShaderLibrary& shaders_;
  const HeadsetVisitOptions& options_;
  const Gl& gl_;
  std::unique_ptr<Headset> headset_;
  HeadsetTexture texture_;
  std::shared_ptr<const LoadedModel> loaded_;
  Scene scene_;
  std::unique_ptr<EyePainter> painter_;
  std::optional<HeadsetComparison> comparison_;
  bool shows_db_ = false;
  std::span<const FlightSpace> cavities_;
  Visit visit_;
  bool mirrored_ = false, dropped_ = false;
  std::optional<Clock::time_point> left_;
  Clock::time_point seen_to_;
  std::string title_, controllers_;
};

}  // namespace

bool visit_in_headset(Viewer& viewer, Window& window, const ShaderLibrary& shaders, const std::stop_token& stop,
                      const HeadsetVisitOptions& options) {
  if (!wait_for_model(viewer, window, stop)) return true;
  bool well = true;
  window.set_paced(false);
  try {
    HeadsetVisit(viewer, window, shaders, options).run(stop);
  } catch (const GraphicsError& error) {
    well = false;
    viewer.state().trouble = error.what();
  }
  window.set_paced(true);
  window.set_title(viewer.title());
  return well;
}

}  // namespace odontoscope
