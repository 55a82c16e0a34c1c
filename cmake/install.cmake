# Installing the library (`recon`), so that another program can find_package(odontoscope). The engine is the program's alone.
include(CMakePackageConfigHelpers)

get_property(all_rooms GLOBAL PROPERTY ODONTOSCOPE_ROOMS)
set(library_rooms "")
foreach(room IN LISTS all_rooms)
  get_target_property(folder ${room} SOURCE_DIR)
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE folder)
  if(folder MATCHES "^recon/")
    list(APPEND library_rooms ${room})
  endif()
endforeach()

add_library(odontoscope_reconstruction INTERFACE)
add_library(odontoscope::reconstruction ALIAS odontoscope_reconstruction)
set_target_properties(odontoscope_reconstruction PROPERTIES EXPORT_NAME reconstruction)
target_link_libraries(odontoscope_reconstruction INTERFACE ${library_rooms})

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/odontoscope)
install(TARGETS ${library_rooms} odontoscope_reconstruction EXPORT odontoscope-targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT odontoscope-targets NAMESPACE odontoscope:: DESTINATION ${config_folder})
install(DIRECTORY recon DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/odontoscope FILES_MATCHING PATTERN "*.h")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/odontoscope)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/odontoscope-config.cmake.in
  ${PROJECT_BINARY_DIR}/odontoscope-config.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/odontoscope-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/odontoscope-config.cmake ${PROJECT_BINARY_DIR}/odontoscope-config-version.cmake
        DESTINATION ${config_folder})
