# npm_install(SOURCE WORK NPM outcome)
#
# What SOURCE/package-lock.json names, in WORK/node_modules; anew only when that file changed. `outcome` is empty, or why it failed, with npm's own
# words told. For scripts (cmake -P): nothing is fetched while CMake configures.
function(npm_install source work npm outcome)
  set(longest 300)   # seconds
  set(${outcome} "" PARENT_SCOPE)
  file(SHA256 ${source}/package-lock.json wanted)
  set(installed "")
  if(EXISTS ${work}/installed)
    file(READ ${work}/installed installed)
  endif()
  if(installed STREQUAL wanted)
    return()
  endif()
  file(MAKE_DIRECTORY ${work})
  file(REMOVE ${work}/installed)
  file(COPY ${source}/package.json ${source}/package-lock.json DESTINATION ${work})
  execute_process(COMMAND ${npm} ci --ignore-scripts --omit=peer --no-audit --no-fund --no-update-notifier --fetch-retries=1
                  WORKING_DIRECTORY ${work} TIMEOUT ${longest} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(code EQUAL 0)
    file(WRITE ${work}/installed "${wanted}")
    return()
  endif()
  message(STATUS "${said}")
  cmake_path(GET source FILENAME folder)
  set(${outcome} "npm could not install the packages of ${folder}/package-lock.json" PARENT_SCOPE)
endfunction()
