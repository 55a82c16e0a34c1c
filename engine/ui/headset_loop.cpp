#include "engine/ui/headset_loop.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <utility>
#include <variant>

#include "engine/ui/headset_lab.h"
#include "engine/ui/headset_sheet.h"

namespace odontoscope {

namespace {

constexpr auto rest = std::chrono::milliseconds(10);

/// The viewer's own frames, until there is something to show. false: there never will be.
bool wait_for_model(Viewer& viewer, Window& window, const std::stop_token& stop) {
  do {
    for (const Event& event : window.events(0)) viewer.handle(event);
    const PixelSize size = window.size();
    if (size.width > 0 && size.height > 0) {
      viewer.draw({size, window.scale(), 0.01}, {0, 0, 0, size});
      window.show();
    }
    if (window.closing() || stop.stop_requested()) return false;
    std::this_thread::sleep_for(rest);
  } while (viewer.loading());
  return viewer.state().shown != nullptr;
}

bool pressed_escape(const std::vector<Event>& events) {
  for (const Event& event : events)
    if (const auto* key = std::get_if<KeyChanged>(&event); key && key->down && key->key == Key::escape) return true;
  return false;
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
      : viewer_(viewer), window_(window), options_(options), loaded_(viewer.state().shown), scene_(viewer.state().scene),
        gl_(window.context().gl()), headset_(open_headset(gl_, options.headset)), painter_(gl_, shaders, loaded_->model, options.quality), sheet_(gl_, shaders), lab_(loaded_, viewer.state().lab) {
    if (loaded_->flight) cavities_ = loaded_->flight->cavities;
    say(fmt::format("In the headset: {}.", headset_->in_words()));
    say(cavities_.empty() ? "This model has no cavity to enter." : std::string("Point at a cavity, such as the pulp, and pull the trigger to be inside."));
  }

  void run(const std::stop_token& stop) {
    bool leaving = false;
    for (HeadsetState state = headset_->poll(); state != HeadsetState::over; state = headset_->poll()) {
      if (!leaving && (pressed_escape(window_.events(0)) || window_.closing() || visit_.leaving || stop.stop_requested())) {
        headset_->leave();
        leaving = true;
        continue;
      }
      tell_controllers(state);
      if (state == HeadsetState::waiting) std::this_thread::sleep_for(rest);
      else headset_->frame([this](const HeadsetFrame& frame) { draw(frame); });
      show(state);
    }
  }

 private:
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

  void draw(const HeadsetFrame& frame) {
    choose_model();
    const VisitWorld world{shows_db_ ? lab_.made()->model : loaded_->model, shows_db_ ? *lab_.made()->pickable : *loaded_->pickable, scene_, cavities_};
    visit_ = stepped(std::move(visit_), frame.input, world, options_.comfort, frame.seconds);
    constexpr double pulse_seconds = 0.04;
    for (std::size_t i = 0; i < 2; ++i)
      if (visit_.pulse[i] > 0) headset_->pulse(i, visit_.pulse[i], pulse_seconds);
    sheet_.update(visit_, frame.input, world, {loaded_->title, lab_.possible(), lab_.in_words()}, frame.seconds);
    if (frame.draw) {
      painter_.draw(visit_, frame.input, world, frame.eyes, frame.targets, [this](const EyeView& eye, const Target& target) { sheet_.draw(eye, target); });
      const PixelSize size = window_.size();
      if (size.width > 0 && size.height > 0) EyePainter::mirror(gl_, frame.targets.front(), {0, 0, 0, size});
    }
    drawn_ = frame.draw;
    if (options_.watch) options_.watch(frame, visit_);
  }

  /// DB where it is wanted and made; from inside it is not seen.
  void choose_model() {
    lab_.tend(visit_.db);
    const bool db = visit_.db && !visit_.cavity && lab_.made();
    if (db != shows_db_) painter_.take(db ? lab_.made()->model : loaded_->model);
    shows_db_ = db;
  }

  void show(HeadsetState state) {
    if (drawn_) window_.show();
    drawn_ = false;
    if (std::string title = title_of(visit_, viewer_, state); title != title_) window_.set_title(title_ = std::move(title));
  }

  Viewer& viewer_;
  Window& window_;
  const HeadsetVisitOptions& options_;
  std::shared_ptr<const LoadedModel> loaded_;
  Scene scene_;
  const Gl& gl_;
  std::unique_ptr<Headset> headset_;
  EyePainter painter_;
  HeadsetSheet sheet_;
  HeadsetLab lab_;
  bool shows_db_ = false;
  std::span<const FlightSpace> cavities_;
  Visit visit_;
  bool drawn_ = false;
  std::string title_, controllers_;
};

}  // namespace

bool visit_in_headset(Viewer& viewer, Window& window, const ShaderLibrary& shaders, const std::stop_token& stop, const HeadsetVisitOptions& options) {
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
