# Builders, random stacks and the oracle, shared by tests and benchmarks. Include it and link odontoscope_test_support.
include_guard(GLOBAL)
set(here ${CMAKE_CURRENT_LIST_DIR})
add_library(odontoscope_test_support STATIC
  ${here}/shapes.cpp ${here}/random_stacks.cpp ${here}/voxel_outlines.cpp ${here}/variants.cpp ${here}/plane_check.cpp
  ${here}/stack_text.cpp ${here}/shrink.cpp ${here}/refusal_check.cpp
  ${here}/oracle.cpp ${here}/oracle_solid.cpp ${here}/oracle_surface.cpp ${here}/oracle_section.cpp ${here}/oracle_topology.cpp ${here}/slab_cells.cpp
  ${here}/cube_solids.cpp)
target_link_libraries(odontoscope_test_support
  PUBLIC odontoscope_core odontoscope_mesh odontoscope_input
  PRIVATE odontoscope_options CGAL::CGAL nlohmann_json::nlohmann_json)
# Strange stacks: apart, since label maps are made into contours by the library's own code and so need its volumes.
add_library(odontoscope_test_strange STATIC EXCLUDE_FROM_ALL
  ${here}/strange_stacks.cpp ${here}/strange_outlines.cpp ${here}/strange_numbers.cpp ${here}/strange_crowds.cpp ${here}/strange_labels.cpp
  ${here}/strange_attacks.cpp ${here}/strange_ploys.cpp ${here}/strange_trifles.cpp ${here}/strange_assaults.cpp)
target_link_libraries(odontoscope_test_strange PUBLIC odontoscope_test_support odontoscope_volume PRIVATE odontoscope_options)
