# A Debian package and an archive of the program: `cpack` in the build folder (docs/packages.md). The library is not in them: cmake --install.
set(package ${CMAKE_CURRENT_LIST_DIR}/package)
set(desktop ${PROJECT_SOURCE_DIR}/assets/desktop)
set(made ${PROJECT_BINARY_DIR}/package)
set(CPACK_PACKAGE_CONTACT "The Odontoscope authors <odontoscope@localhost>" CACHE STRING "Maintainer of the Debian package: NAME <ADDRESS>")
configure_file(${desktop}/odontoscope.1 ${made}/odontoscope.1 @ONLY)
find_program(ODONTOSCOPE_GZIP gzip)
if(ODONTOSCOPE_GZIP)
  execute_process(COMMAND ${ODONTOSCOPE_GZIP} -9nc ${made}/odontoscope.1 OUTPUT_FILE ${made}/odontoscope.1.gz)
  string(TIMESTAMP package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)   # heeds SOURCE_DATE_EPOCH
  configure_file(${package}/changelog ${made}/changelog @ONLY)
  execute_process(COMMAND ${ODONTOSCOPE_GZIP} -9nc ${made}/changelog OUTPUT_FILE ${made}/changelog.gz)
  install(FILES ${made}/odontoscope.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${made}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/odontoscope COMPONENT program)
endif()
install(FILES ${package}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/odontoscope COMPONENT program)
install(FILES ${desktop}/odontoscope.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
install(FILES ${desktop}/odontoscope.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
install(FILES ${desktop}/odontoscope-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME odontoscope.xml COMPONENT program)

set(CPACK_GENERATOR "DEB;TGZ")
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_PROJECT_CONFIG_FILE ${package}/by_generator.cmake)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_NAME odontoscope)
set(CPACK_PACKAGE_VENDOR "Odontoscope")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Certified solid models of teeth from contours or CT volumes")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Contours drawn slice by slice, or a CT volume, become a tetrahedral solid
whose surface is proven to be a closed, oriented manifold, with the pulp as
a true cavity. It is looked at in a window, drawn without a display, shown
in a page for any browser, and written for printers, solvers and viewers.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Opened at run time, so that their absence is no reason not to start.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libegl1, libegl-mesa0, libgl1-mesa-dri, libosmesa6")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, chromium")   # films; pictures of pages
set(CPACK_PACKAGE_FILE_NAME "odontoscope-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
include(CPack)
