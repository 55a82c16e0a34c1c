# Files that become part of the program, so that it finds them wherever it is installed: shaders, typefaces, lessons.
#
#   odontoscope_embed(OUT FUNCTION FILES...)
#
# sets OUT to a source that defines `std::span<const odontoscope::EmbeddedFile> odontoscope::FUNCTION()` (recon/core/embedded_file.h): the FILES in their order, by
# their names without folders. Whoever calls FUNCTION declares it in a header.
#
# This file is also the script that writes that source: cmake -DOUTPUT=... -DFUNCTION=... -DFILES=... -P embed.cmake
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(ODONTOSCOPE_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(odontoscope_embed out function)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
    add_custom_command(
      OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -DOUTPUT=${source} -DFUNCTION=${function} "-DFILES=${ARGN}" -P ${ODONTOSCOPE_EMBED_SCRIPT}
      DEPENDS ${ARGN} ${ODONTOSCOPE_EMBED_SCRIPT}
      COMMENT "Embedding ${function}"
      VERBATIM)
    set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    set(${out} ${source} PARENT_SCOPE)
  endfunction()
  return()
endif()

set(text "#include \"recon/core/embedded_file.h\"\n\nnamespace odontoscope {\n\nstd::span<const EmbeddedFile> ${FUNCTION}();\n\n")
string(APPEND text "std::span<const EmbeddedFile> ${FUNCTION}() {\n  static constexpr EmbeddedFile all[] = {\n")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  file(SIZE ${file} size)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
  string(REGEX REPLACE "(................................................................................)" "\\1\"\n\"" bytes "${bytes}")   # in pieces that every compiler takes
  string(APPEND text "    {\"${name}\", {\"${bytes}\", ${size}}},\n")
endforeach()
string(APPEND text "  };\n  return all;\n}\n\n}  // namespace odontoscope\n")
file(WRITE ${OUTPUT} "${text}")
