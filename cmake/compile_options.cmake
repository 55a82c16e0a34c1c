# Options shared by every target of ours; third-party headers are SYSTEM and stay out of the warnings.
add_library(odontoscope_options INTERFACE)
# Exact predicates rely on IEEE arithmetic as written: no fused multiply-add, no fast-math.
target_compile_options(odontoscope_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                       -ffp-contract=off)
if(ODONTOSCOPE_WARNINGS_AS_ERRORS)
  target_compile_options(odontoscope_options INTERFACE -Werror)
endif()
if(ODONTOSCOPE_SANITIZE)
  add_compile_options(-fsanitize=${ODONTOSCOPE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ODONTOSCOPE_SANITIZE})
endif()

# A room of the house: one folder, one library, linked only against the rooms that data flows in from.
# LIGHT: nothing in it computes for long, so that a release need not spend time on more than -O1.
# APART: its files are compiled one by one where those of other rooms are compiled together (CMAKE_UNITY_BUILD).
function(odontoscope_room name)
  cmake_parse_arguments(ROOM "LIGHT;APART" "" "SOURCES;ROOMS;PACKAGES;PRIVATE_PACKAGES" ${ARGN})
  add_library(odontoscope_${name} STATIC ${ROOM_SOURCES})
  add_library(odontoscope::${name} ALIAS odontoscope_${name})
  set_target_properties(odontoscope_${name} PROPERTIES EXPORT_NAME ${name})
  if(NOT EMSCRIPTEN)   # of which shared modules are linked: Python's
    set_target_properties(odontoscope_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  target_compile_features(odontoscope_${name} PUBLIC cxx_std_20)
  target_include_directories(odontoscope_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/odontoscope>)
  target_link_libraries(odontoscope_${name} PRIVATE $<BUILD_INTERFACE:odontoscope_options>)
  if(ROOM_APART)
    set_target_properties(odontoscope_${name} PROPERTIES UNITY_BUILD OFF)
  endif()
  if(ROOM_LIGHT)
    target_compile_options(odontoscope_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  foreach(room IN LISTS ROOM_ROOMS)
    target_link_libraries(odontoscope_${name} PUBLIC odontoscope_${room})
  endforeach()
  target_link_libraries(odontoscope_${name} PUBLIC ${ROOM_PACKAGES} PRIVATE ${ROOM_PRIVATE_PACKAGES})
  set_property(GLOBAL APPEND PROPERTY ODONTOSCOPE_ROOMS odontoscope_${name})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE ";" " " links "${ROOM_ROOMS}")
  set_property(GLOBAL APPEND PROPERTY ODONTOSCOPE_ROOM_LINKS "${folder}: ${links}")   # for tests/house
endfunction()
