#include "engine/viewer/compare/comparison_run.h"

#include <new>

namespace odontoscope {

bool comparison_possible(const LoadedModel& shown) { return shown.overlays.contours.slices.size() >= 2; }

std::unique_ptr<DbWorker> worker_for(std::shared_ptr<const LoadedModel> shown) {
  const ContourStack* contours = &shown->overlays.contours;
  return std::make_unique<DbWorker>(std::shared_ptr<const ContourStack>(std::move(shown), contours));
}

std::string words_for(const std::exception_ptr& trouble) {
  try {
    std::rethrow_exception(trouble);
  } catch (const std::bad_alloc&) {
    return "This machine has not enough memory for that. Choose a coarser grid.";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace odontoscope
