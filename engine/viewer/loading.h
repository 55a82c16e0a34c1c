#pragma once
// A model in the making, off the frame's thread: how far it is, how to stop it, and what came of it.

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <glm/vec3.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "engine/measure/pick.h"
#include "engine/navigate/flight_spaces.h"
#include "engine/scene/deviation.h"
#include "engine/scene/overlay.h"
#include "engine/scene/scene.h"
#include "engine/scene/value_grid.h"
#include "engine/scene/volume_preview.h"
#include "engine/viewer/certificate.h"
#include "recon/core/progress.h"

namespace odontoscope {

/// What a person said of a volume: where its surface lies.
struct VolumeChoice {
  std::optional<double> iso = {};         // the grey value at the surface; or
  std::vector<std::int64_t> labels = {};  // of a label map, each a structure of its own
  double min_area_pixels = 0;             // smaller contours are noise
};

struct LoadedModel;

struct LoadRequest {
  std::string file = {};  // empty: the sample molar
  std::optional<VolumeChoice> volume = {};
  std::string series = {};  // of several in DICOM: its number, from 1 on
  bool from_command_line = false;
  std::optional<std::size_t> lesson = {};  // of built_in_lessons(): instead of a file
  /// For the loader, on its thread: something true to look at until the model is there. Empty: nobody looks.
  std::function<void(LoadedModel)> show_meanwhile = {};
};

/// "molar.json", or what stands for a file.
std::string name_of(const std::string& file);
std::string name_of(const LoadRequest& request);

/// What is known of a volume's grey values besides the grid of them.
struct GreyValues {
  double air = 0, dentine = 1;        // as recon/radiograph/grey_anchors.h finds them
  double dentine_attenuation = 0.25;  // of X-rays, 1/mm
  std::vector<double> isos;           // at which the model's surfaces were taken
  double low = 0, high = 1;           // of the bars
  std::vector<float> bars;            // a histogram's, 0 to 1
};

/// All that the viewer knows of what it shows.
struct LoadedModel {
  std::string title;
  std::string tooth = {};  // "lower left first molar: FDI 36, Universal 19"; empty: not known
  Model model;
  OverlaySource overlays;
  std::shared_ptr<const ValueGrid> values;          // of the volume that the model came from; null: there is none
  std::optional<GreyValues> greys = {};             // with `values`
  std::vector<IsoOf> isos = {};                     // of them, at which surfaces of `model` were taken
  std::optional<DeviationSummary> deviations = {};  // of these surfaces from them; none: nobody asked yet
  std::shared_ptr<const Pickable> pickable;         // never null
  std::shared_ptr<const FlightSpaces> flight;       // null: it has no cavity to fly in
  Scene scene;                                      // a good first look
  Certificate certificate;
  std::size_t triangles = 0;
  /// What the person said about `scene` and the viewer therefore leaves as it is; the rest follows window and settings.
  struct {
    bool camera = false, background = false, back_faces = false, looks = false;
  } given;
};

/// Runs on a thread of its own. Throws what readers and the engine throw; Cancelled after a stop was requested.
using Loader = std::function<LoadedModel(const LoadRequest&, const Progress&)>;

/// Work on a thread of its own: how far it is, how to stop it, and what came of it.
template <class Result>
class Job {
 public:
  explicit Job(std::function<Result(const Progress&)> work) {
    std::promise<Result> promise;
    result_ = promise.get_future();
    thread_ = std::jthread([this, work = std::move(work), promise = std::move(promise)](std::stop_token stop) mutable {
      const auto report = [this](std::string_view name, double fraction) {
        const std::lock_guard lock(mutex_);
        stage_ = {std::string(name), fraction};
      };
      try {
        promise.set_value(work({report, stop}));
      } catch (...) {
        promise.set_exception(std::current_exception());
      }
    });
  }
  /// Stops the work and waits until it has noticed.
  ~Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  struct Stage {
    std::string name;
    double fraction = 0;
  };
  Stage stage() const {
    const std::lock_guard lock(mutex_);
    return stage_;
  }
  void cancel() { thread_.request_stop(); }
  bool cancelling() const { return thread_.get_stop_token().stop_requested(); }
  bool finished() const {
    return result_.valid() && result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  /// Precondition: finished, and not taken before. Throws what the work threw.
  Result take() { return result_.get(); }

 private:
  mutable std::mutex mutex_;
  Stage stage_;
  std::future<Result> result_;
  std::jthread thread_;  // last: it uses the others
};

class LoadJob : public Job<LoadedModel> {
 public:
  LoadJob(Loader loader, const LoadRequest& request, bool with_draft = false)
      : LoadJob(std::move(loader), request, with_draft, std::make_shared<Slot>()) {}
  const LoadRequest& request() const { return request_; }
  /// What the loader gave to be shown meanwhile, once; null: nothing yet, or no more.
  std::shared_ptr<const LoadedModel> take_draft();

 private:
  struct Slot {
    std::mutex mutex;
    std::shared_ptr<const LoadedModel> draft;
  };
  LoadJob(Loader loader, const LoadRequest& request, bool with_draft, std::shared_ptr<Slot> slot);

  LoadRequest request_;
  std::shared_ptr<Slot> slot_;
};

/// Reads a volume to be asked about. Throws as the loader does.
using Previewer = std::function<VolumePreview(const LoadRequest&, const Progress&)>;

}  // namespace odontoscope
