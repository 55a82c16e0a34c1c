# The viewer's interface: Dear ImGui, and the typeface that is embedded in the program so that it looks alike everywhere.
find_package(PkgConfig REQUIRED)
pkg_check_modules(ODONTOSCOPE_IMGUI REQUIRED IMPORTED_TARGET imgui)

# Other typefaces will do where Inter is missing.
find_file(ODONTOSCOPE_FONT NAMES Inter-Regular.otf Inter-Regular.ttf OpenSans-Regular.ttf DejaVuSans.ttf REQUIRED
  PATHS /usr/share/fonts /usr/local/share/fonts
  PATH_SUFFIXES opentype/inter truetype/inter truetype/open-sans truetype/dejavu inter open-sans dejavu)
find_file(ODONTOSCOPE_FONT_BOLD NAMES Inter-SemiBold.otf Inter-SemiBold.ttf OpenSans-Semibold.ttf DejaVuSans-Bold.ttf REQUIRED
  PATHS /usr/share/fonts /usr/local/share/fonts
  PATH_SUFFIXES opentype/inter truetype/inter truetype/open-sans truetype/dejavu inter open-sans dejavu)
