# Installs Odontoscope into a fresh prefix and builds and runs examples/library against it, as another program would.
#   cmake -DBUILD=build folder -DSOURCE=repository -DWORK=scratch folder -DCOMPILER=c++ -P library_test.cmake
function(must)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${code}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
# A header that was not installed must not be found in the source tree instead.
file(COPY ${SOURCE}/examples/library DESTINATION ${WORK})
must(${CMAKE_COMMAND} -S ${WORK}/library -B ${WORK}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
     -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${WORK}/prefix)
must(${CMAKE_COMMAND} --build ${WORK}/build)
must(${WORK}/build/two_canals ${WORK}/two_canals.stl)
if(NOT output MATCHES "external surface of genus 0" OR NOT output MATCHES "cavity of genus 0")
  message(FATAL_ERROR "the example made another shape:\n${output}")
endif()
must(${WORK}/prefix/bin/odontoscope check ${WORK}/two_canals.stl)
file(REMOVE_RECURSE ${WORK})
