#include "engine/viewer/loading.h"

#include <filesystem>

namespace odontoscope {

std::string name_of(const std::string& file) {
  return file.empty() ? "the sample molar" : std::filesystem::path(file).filename().string();
}

std::string name_of(const LoadRequest& request) { return request.lesson ? "the lesson" : name_of(request.file); }

LoadJob::LoadJob(Loader loader, const LoadRequest& request, bool with_draft, std::shared_ptr<Slot> slot)
    : Job([loader = std::move(loader), wanted = request, with_draft, slot](const Progress& progress) mutable {
        if (with_draft)
          wanted.show_meanwhile = [slot](LoadedModel draft) {
            const std::lock_guard lock(slot->mutex);
            slot->draft = std::make_shared<const LoadedModel>(std::move(draft));
          };
        return loader(wanted, progress);
      }),
      request_(request),
      slot_(std::move(slot)) {}

std::shared_ptr<const LoadedModel> LoadJob::take_draft() {
  const std::lock_guard lock(slot_->mutex);
  return std::exchange(slot_->draft, nullptr);
}

}  // namespace odontoscope
