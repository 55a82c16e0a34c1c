# Every package that the project uses, found here and nowhere else. None is bundled; third_party/README.md lists them
# with their Debian names and what each is for.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.5 REQUIRED QUIET)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.9 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(TinyGLTF REQUIRED)
# GDCM's own package file asks for VTK, of which nothing is used here.
find_path(ODONTOSCOPE_GDCM_INCLUDE gdcmImage.h PATH_SUFFIXES gdcm-3.0 REQUIRED)
set(ODONTOSCOPE_GDCM "")
foreach(library gdcmMSFF gdcmDSED gdcmCommon)
  find_library(ODONTOSCOPE_${library} ${library} REQUIRED)
  list(APPEND ODONTOSCOPE_GDCM ${ODONTOSCOPE_${library}})
endforeach()
find_package(meshoptimizer REQUIRED)
find_package(pugixml REQUIRED)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
# libzip's own package file asks for its command line tools, too.
find_path(ODONTOSCOPE_ZIP_INCLUDE zip.h REQUIRED)
find_library(ODONTOSCOPE_ZIP zip REQUIRED)
