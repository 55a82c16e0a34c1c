# Every package that the project uses, found here and nowhere else. None is bundled; third_party/README.md lists them
# with their Debian names and what each is for.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.5 REQUIRED QUIET)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.9 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(TinyGLTF REQUIRED)
set(ODONTOSCOPE_ITK_COMPONENTS ITKCommon ITKIOImageBase ITKIONRRD ITKIONIFTI ITKIOMeta ITKIOGDCM)
find_package(ITK 5.2 REQUIRED COMPONENTS ${ODONTOSCOPE_ITK_COMPONENTS})
find_package(meshoptimizer REQUIRED)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
