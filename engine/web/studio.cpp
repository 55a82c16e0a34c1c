#include "engine/web/studio.h"

#include <span>

#include "recon/core/embedded_file.h"

namespace odontoscope {

#ifdef ODONTOSCOPE_HAS_STUDIO
std::span<const EmbeddedFile> studio_files();

std::string_view studio_page() { return studio_files().front().bytes; }
#else
std::string_view studio_page() { return {}; }
#endif

}  // namespace odontoscope
