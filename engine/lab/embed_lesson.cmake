# Writes the lesson's text as a C++ string, in pieces that every compiler takes.
file(READ ${TEXT} bytes HEX)
string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
string(REGEX REPLACE "(................................................................................)" "\\1\"\n\"" bytes "${bytes}")
file(WRITE ${OUTPUT} "#include \"engine/lab/lesson.h\"\n\nnamespace odontoscope {\n\nstd::string_view lesson_text() { return \"${bytes}\"; }\n\n}  // namespace odontoscope\n")
