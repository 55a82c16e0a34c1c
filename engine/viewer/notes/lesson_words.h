#pragma once
// The lessons that come with the program, in the reader's language.

#include "engine/language/language.h"
#include "engine/navigate/notes.h"

namespace odontoscope {

/// All that is read in it. Names that answers are compared with, and of the canals to ride, stay.
Lesson translated(Lesson lesson, const Language& language);

}  // namespace odontoscope
