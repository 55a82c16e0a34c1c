#include "engine/app/command_line.h"

int main(int argc, char** argv) { return odontoscope::app::run(argc, argv); }
