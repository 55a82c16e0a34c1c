# Read by cpack for each generator: the archive unpacks into a folder of its own, the Debian package into /usr.
if(NOT CPACK_GENERATOR STREQUAL DEB)
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
endif()
