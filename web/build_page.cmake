# Bundles the page: page.html in WORK, only if that went well; and shell/page.html with shell/why_not.txt, of which one is empty. Never fails: without
# Node.js or its packages why_not.txt says what is missing, and `odontoscope web` tells it.
#   cmake -DNODE=... -DNPM=... -DENABLED=ON -DSOURCE=web folder -DWORK=build folder -P build_page.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../cmake/npm.cmake)
set(oldest_node 18)

# Only where it changes, so that nothing is compiled again without need.
function(put file text)
  file(CONFIGURE OUTPUT ${WORK}/shell/${file} CONTENT "${text}" @ONLY)
endfunction()

function(give_up why)
  message(STATUS "No web page: ${why}")
  file(REMOVE ${WORK}/page.html)
  put(page.html "")
  put(why_not.txt "${why}")
endfunction()

if(NOT ENABLED)
  give_up("ODONTOSCOPE_WEB was off")
  file(WRITE ${WORK}/page.html "")   # nothing to try again
  return()
endif()
if(NOT NODE OR NOT NPM)
  give_up("Node.js with npm was not found")
  return()
endif()
execute_process(COMMAND ${NODE} --version OUTPUT_VARIABLE version ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REGEX MATCH "[0-9]+" major "${version}")
if(NOT major OR major LESS oldest_node)
  give_up("Node.js is ${version}, and ${oldest_node} is the oldest that will do")
  return()
endif()

npm_install(${SOURCE} ${WORK} ${NPM} failure)
if(failure)
  give_up("${failure}")
  return()
endif()

execute_process(COMMAND ${NODE} ${SOURCE}/build.mjs ${WORK} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT code EQUAL 0)
  file(REMOVE ${WORK}/page.html)
  message(FATAL_ERROR "web/build.mjs failed:\n${said}")   # a mistake in web/, which must not pass for a missing package
endif()
file(MAKE_DIRECTORY ${WORK}/shell)
file(COPY_FILE ${WORK}/page.html ${WORK}/shell/page.html ONLY_IF_DIFFERENT)
put(why_not.txt "")
