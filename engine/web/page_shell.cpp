#include <span>

#include "engine/web/page.h"
#include "recon/core/embedded_file.h"

namespace odontoscope {

std::span<const EmbeddedFile> shell_files();  // page.html and why_not.txt, of which one is empty

EmbeddedPage embedded_page() { return {shell_files()[0].bytes, shell_files()[1].bytes}; }

}  // namespace odontoscope
