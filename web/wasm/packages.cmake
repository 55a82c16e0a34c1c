# What cmake/packages.cmake finds, for WebAssembly: headers that need no library are those installed on this machine, by links to just them
# in the build folder; what must be compiled is compiled from Debian's source packages, which web/wasm/fetch_sources unpacks into
# ODONTOSCOPE_WASM_SOURCES. TBB and std::stop_token are the few lines of web/wasm/stand_ins, for one thread, and of
# stand_ins_threads.
option(ODONTOSCOPE_WASM_THREADS "For pages that are isolated: several threads" OFF)
set(ODONTOSCOPE_WASM_SOURCES ${PROJECT_BINARY_DIR}/../sources CACHE PATH "Where web/wasm/fetch_sources unpacked Debian's source packages")
foreach(package gmp meshoptimizer pugixml libzip zlib tetgen gdcm openjpeg2)
  file(GLOB ${package}_source LIST_DIRECTORIES true ${ODONTOSCOPE_WASM_SOURCES}/${package}-*)
  list(LENGTH ${package}_source found)
  if(NOT found EQUAL 1)
    message(FATAL_ERROR "${ODONTOSCOPE_WASM_SOURCES} holds ${found} folders ${package}-*, not one. Run web/wasm/build, which fetches them")
  endif()
endforeach()

set(wasm_headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${wasm_headers})
foreach(name CGAL mpfr.h boost fmt nlohmann CLI glm tiny_gltf.h stb_image.h stb_image_write.h)
  find_path(folder_of_${name} ${name} PATHS /usr/include /usr/local/include PATH_SUFFIXES stb NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED NO_CACHE)
  file(CREATE_LINK ${folder_of_${name}}/${name} ${wasm_headers}/${name} SYMBOLIC)
endforeach()

function(headers_alone target)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} INTERFACE ${wasm_headers})
  target_compile_definitions(${target} INTERFACE ${ARGN})
endfunction()

# GMP by its own configure and make (build_gmp); the rest by the few files that are used.
add_library(gmp STATIC IMPORTED GLOBAL)
set_target_properties(gmp PROPERTIES IMPORTED_LOCATION ${ODONTOSCOPE_WASM_SOURCES}/gmp/.libs/libgmp.a)
target_include_directories(gmp INTERFACE ${ODONTOSCOPE_WASM_SOURCES}/gmp)
# WebAssembly rounds to nearest alone: CGAL then widens each interval by a step.
set(one_thread CGAL_HAS_NO_THREADS)
if(ODONTOSCOPE_WASM_THREADS)
  set(one_thread "")
endif()
headers_alone(CGAL::CGAL CGAL_ALWAYS_ROUND_TO_NEAREST CGAL_USE_GMP=1 ${one_thread} CGAL_DISABLE_ROUNDING_MATH_CHECK)
target_link_libraries(CGAL::CGAL INTERFACE gmp)
headers_alone(fmt::fmt FMT_HEADER_ONLY)
headers_alone(nlohmann_json::nlohmann_json)
headers_alone(CLI11::CLI11)
headers_alone(glm::glm)
headers_alone(TinyGLTF::TinyGLTF TINYGLTF_NO_STB_IMAGE TINYGLTF_NO_STB_IMAGE_WRITE)
if(ODONTOSCOPE_WASM_THREADS)
  find_program(ODONTOSCOPE_WASM_PYTHON NAMES python3 NO_CMAKE_FIND_ROOT_PATH REQUIRED)   # emscripten is written in it
  set_property(GLOBAL PROPERTY RULE_LAUNCH_COMPILE "${ODONTOSCOPE_WASM_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/catch_by_thread.py")
  add_compile_options(-pthread)
  include_directories(BEFORE SYSTEM ${CMAKE_CURRENT_LIST_DIR}/stand_ins_threads)
  add_library(tbb STATIC ${CMAKE_CURRENT_LIST_DIR}/stand_ins_threads/pool.cpp)
  target_compile_options(tbb PRIVATE -fwasm-exceptions)
  add_library(TBB::tbb ALIAS tbb)
else()
  add_library(TBB::tbb INTERFACE IMPORTED GLOBAL)
endif()

function(compiled target folder)
  add_library(${target} STATIC ${ARGN})
  target_include_directories(${target} SYSTEM PUBLIC ${folder})
  target_compile_options(${target} PRIVATE -w)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
endfunction()
set(meshoptimizer ${meshoptimizer_source}/src)
compiled(meshoptimizer ${meshoptimizer} ${meshoptimizer}/allocator.cpp ${meshoptimizer}/indexcodec.cpp ${meshoptimizer}/vertexcodec.cpp
         ${meshoptimizer}/vertexfilter.cpp ${meshoptimizer}/simplifier.cpp ${meshoptimizer}/vcacheoptimizer.cpp ${meshoptimizer}/vfetchoptimizer.cpp
         ${meshoptimizer}/indexgenerator.cpp)
add_library(meshoptimizer::meshoptimizer ALIAS meshoptimizer)
compiled(pugixml ${pugixml_source}/src ${pugixml_source}/src/pugixml.cpp)
add_library(pugixml::pugixml ALIAS pugixml)
set(zlib_files adler32 compress crc32 deflate gzclose gzlib gzread gzwrite infback inffast inflate inftrees trees uncompr zutil)
list(TRANSFORM zlib_files REPLACE "(.+)" "${zlib_source}/\\1.c")
compiled(zlib ${zlib_source} ${zlib_files})
target_compile_definitions(zlib PRIVATE HAVE_UNISTD_H)
add_library(ZLIB::ZLIB ALIAS zlib)

include(${CMAKE_CURRENT_LIST_DIR}/libzip.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/decoder.cmake)
set(ODONTOSCOPE_ZIP libzip)

compiled(tetgen ${tetgen_source} ${tetgen_source}/tetgen.cxx ${tetgen_source}/predicates.cxx)
target_compile_definitions(tetgen PRIVATE TETLIBRARY)
set(ODONTOSCOPE_TETGEN ON)
set(ODONTOSCOPE_TETGEN_INCLUDE ${tetgen_source})
set(ODONTOSCOPE_TETGEN_LIBRARY tetgen)

set(ODONTOSCOPE_GDCM "")
set(ODONTOSCOPE_GDCM_INCLUDE "")
add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)

set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")   # -O3 takes longer to compile, and is no faster here
add_compile_options(-fwasm-exceptions -Wno-constant-conversion)
include_directories(SYSTEM ${CMAKE_CURRENT_LIST_DIR}/stand_ins)
