# cmake -DSTYLE=style.css -DSCRIPT=script.js -DOUTPUT=assets.cpp -P embed.cmake
# Raw string literals, in pieces: the standard promises only 65536 characters a literal.
function(literal file result)
  file(READ "${file}" text)
  string(LENGTH "${text}" length)
  set(pieces "")
  set(start 0)
  while(start LESS length)
    string(SUBSTRING "${text}" ${start} 12000 piece)
    string(APPEND pieces "\n    R\"cuesta(${piece})cuesta\"")
    math(EXPR start "${start} + 12000")
  endwhile()
  set(${result} "${pieces}" PARENT_SCOPE)
endfunction()

literal("${STYLE}" style)
literal("${SCRIPT}" script)
file(WRITE "${OUTPUT}" "#include \"reports/html/assets.h\"

namespace cuesta::html {

const std::string_view kStyleSheet =${style};
const std::string_view kScript =${script};

}  // namespace cuesta::html
")
