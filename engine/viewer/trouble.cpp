#include "engine/viewer/trouble.h"

#include <exception>
#include <new>

#include "recon/core/error.h"

namespace odontoscope {

std::string words_for_current_exception() {
  try {
    throw;
  } catch (const Error& error) {
    return error.what();
  } catch (const std::bad_alloc&) {
    return "This machine has not enough memory for that. Make it smaller: fewer slices, or a larger smallest contour.";
  } catch (const std::exception& error) {
    return InternalError(error.what()).what();
  }
}

}  // namespace odontoscope
