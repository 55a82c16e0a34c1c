#pragma once
// What a comparison needs to run, at the desk and in the headset.

#include <exception>
#include <memory>
#include <string>

#include "engine/comparison/db_worker.h"
#include "engine/viewer/loading.h"

namespace odontoscope {

/// DB needs two slices of contours: a mesh from elsewhere has none.
bool comparison_possible(const LoadedModel& shown);

/// On the model's contours, which it keeps.
std::unique_ptr<DbWorker> worker_for(std::shared_ptr<const LoadedModel> shown);

/// Why DB could not be made.
std::string words_for(const std::exception_ptr& trouble);

}  // namespace odontoscope
