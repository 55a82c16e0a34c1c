# The typeface that is embedded in what we make, so that it looks alike everywhere.
# Other typefaces will do where Inter is missing.
find_file(ODONTOSCOPE_FONT NAMES Inter-Regular.otf Inter-Regular.ttf OpenSans-Regular.ttf DejaVuSans.ttf
  PATHS /usr/share/fonts /usr/local/share/fonts
  PATH_SUFFIXES opentype/inter truetype/inter truetype/open-sans truetype/dejavu inter open-sans dejavu)
find_file(ODONTOSCOPE_FONT_BOLD NAMES Inter-SemiBold.otf Inter-SemiBold.ttf OpenSans-Semibold.ttf DejaVuSans-Bold.ttf
  PATHS /usr/share/fonts /usr/local/share/fonts
  PATH_SUFFIXES opentype/inter truetype/inter truetype/open-sans truetype/dejavu inter open-sans dejavu)
