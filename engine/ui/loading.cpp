#include "engine/ui/loading.h"

namespace odontoscope {

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
