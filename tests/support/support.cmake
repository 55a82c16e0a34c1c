# Builders, random stacks and the oracle, shared by tests and benchmarks. Include it and link odontoscope_test_support.
include_guard(GLOBAL)
set(here ${CMAKE_CURRENT_LIST_DIR})
add_library(odontoscope_test_support STATIC
  ${here}/shapes.cpp ${here}/random_stacks.cpp ${here}/voxel_outlines.cpp ${here}/variants.cpp ${here}/plane_check.cpp
  ${here}/stack_text.cpp ${here}/shrink.cpp
  ${here}/oracle.cpp ${here}/oracle_solid.cpp ${here}/oracle_surface.cpp ${here}/oracle_section.cpp)
target_link_libraries(odontoscope_test_support
  PUBLIC odontoscope_core odontoscope_mesh odontoscope_input
  PRIVATE odontoscope_options CGAL::CGAL nlohmann_json::nlohmann_json)
