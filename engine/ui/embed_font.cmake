# Writes a font file as a C++ array.
file(READ ${FONT} bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
file(WRITE ${OUTPUT} "#include \"engine/ui/fonts.h\"\n\nnamespace odontoscope {\n\nnamespace {\nconstexpr unsigned char bytes[] = {\n${bytes}};\n}\n\nstd::span<const unsigned char> ${NAME}() { return bytes; }\n\n}  // namespace odontoscope\n")
