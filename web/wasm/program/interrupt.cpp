// In place of engine/app/interrupt.cpp: there are no signals and no second thread. Whoever runs the module ends its
// worker instead.
#include "engine/app/interrupt.h"

namespace odontoscope::app {

Interrupts::Interrupts() = default;
Interrupts::~Interrupts() = default;
void Interrupts::listen() {}

}  // namespace odontoscope::app
