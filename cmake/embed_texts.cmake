# cuesta_embed_texts(OUTPUT file.cpp HEADER header.h TYPE type FUNCTION function FILES a.toml ...)
# Writes a source file in which `std::span<const TYPE> FUNCTION()` gives {name, text} of each file, sorted by name:
# the program then needs no path to find them. Made again when a file changes.
function(cuesta_embed_texts)
  cmake_parse_arguments(ARG "" "OUTPUT;HEADER;TYPE;FUNCTION" "FILES" ${ARGN})
  list(SORT ARG_FILES)
  set(rows "")
  foreach(file IN LISTS ARG_FILES)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    cmake_path(GET file STEM name)
    file(READ "${file}" text)
    string(APPEND rows "    {\"${name}\", R\"_text_(${text})_text_\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT "${ARG_OUTPUT}" CONTENT "#include \"${ARG_HEADER}\"

namespace cuesta {
namespace {

constexpr ${ARG_TYPE} kTexts[] = {
${rows}};

}  // namespace

std::span<const ${ARG_TYPE}> ${ARG_FUNCTION}() { return kTexts; }

}  // namespace cuesta
" @ONLY)
endfunction()
