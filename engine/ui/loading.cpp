#include "engine/ui/loading.h"

namespace odontoscope {

LoadJob::LoadJob(Loader loader, const LoadRequest& request)
    : Job([loader = std::move(loader), request](const Progress& progress) { return loader(request, progress); }), request_(request) {}

}  // namespace odontoscope
