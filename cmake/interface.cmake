# The viewer's interface: Dear ImGui, and its typeface.
find_package(PkgConfig REQUIRED)
pkg_check_modules(ODONTOSCOPE_IMGUI REQUIRED IMPORTED_TARGET imgui)

include(cmake/typeface.cmake)
if(NOT ODONTOSCOPE_FONT OR NOT ODONTOSCOPE_FONT_BOLD)
  message(FATAL_ERROR "No typeface was found (Debian: fonts-inter)")
endif()
