# The typeface that is embedded in what we make: Inter as Debian 12 has it (fonts-inter 4.0~beta7), known by its bytes, so that pictures do not
# depend on the machine that built the program.
option(ODONTOSCOPE_OTHER_TYPEFACE "Take whatever Inter, Open Sans or DejaVu is found: texts in pictures then look different" OFF)
set(folders PATHS /usr/share/fonts /usr/local/share/fonts
    PATH_SUFFIXES opentype/inter truetype/inter truetype/open-sans truetype/dejavu inter open-sans dejavu)
set(regular_names Inter-Regular.otf)
set(bold_names Inter-SemiBold.otf)
if(ODONTOSCOPE_OTHER_TYPEFACE)
  list(APPEND regular_names Inter-Regular.ttf OpenSans-Regular.ttf DejaVuSans.ttf)
  list(APPEND bold_names Inter-SemiBold.ttf OpenSans-Semibold.ttf DejaVuSans-Bold.ttf)
endif()
find_file(ODONTOSCOPE_FONT NAMES ${regular_names} ${folders})
find_file(ODONTOSCOPE_FONT_BOLD NAMES ${bold_names} ${folders})

function(odontoscope_require_typeface file sha256)
  if(ODONTOSCOPE_OTHER_TYPEFACE OR NOT EXISTS "${file}")
    return()
  endif()
  file(SHA256 ${file} found)
  if(NOT found STREQUAL sha256)
    message(FATAL_ERROR "${file} is not the one of Debian 12 (fonts-inter 4.0~beta7): pictures would look different. "
                        "Install that one, or configure with -DODONTOSCOPE_OTHER_TYPEFACE=ON to take it as it is.")
  endif()
endfunction()
odontoscope_require_typeface("${ODONTOSCOPE_FONT}" a7e791e8f5a0fb02b65663f7fca73e1d1ca9543f772ad480cbd76f4e3fe3f8cc)
odontoscope_require_typeface("${ODONTOSCOPE_FONT_BOLD}" 8c1990b6012254ea2b487161697d107357dd0ee55811cfd91c8c11227bbef457)
