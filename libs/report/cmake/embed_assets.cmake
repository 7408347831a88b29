# Writes OUTPUT, a C++ source that defines the assets of report as string_views.
# Usage: cmake -DCSS=… -DJS=… -DOUTPUT=… -P embed_assets.cmake
# The text is written as the values of its bytes: a string literal may be at most 64 KiB.
function(embed file name result)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  string(REGEX REPLACE "(('[^']*',){24})" "\\1\n    " bytes "${bytes}")
  set(${result}
    "namespace {\nconstexpr char k${name}Bytes[] = {\n    ${bytes}};\n}  // namespace\n\nextern const std::string_view kReport${name}(k${name}Bytes, sizeof(k${name}Bytes));\n\n"
    PARENT_SCOPE)
endfunction()

embed(${CSS} Css css)
embed(${JS} Js js)
file(WRITE ${OUTPUT}
  "// Made by embed_assets.cmake from libs/report/assets; do not edit.\n#include \"page/assets.hpp\"\n\nnamespace skein::report {\n\n${css}${js}}  // namespace skein::report\n")
