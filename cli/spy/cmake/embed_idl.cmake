# The text of the IDL files (FILES, a list) as a C++ source (OUTPUT): recordings carry the types of what is in them.
file(WRITE ${OUTPUT} "// Made from idl/ by embed_idl.cmake.\n#include \"idl_text.hpp\"\n\nnamespace skein::spy_tool {\n\nconst char* const kIdlText =\n")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  file(APPEND ${OUTPUT} "R\"IDL(${text})IDL\"\n")
endforeach()
file(APPEND ${OUTPUT} ";\n\n}  // namespace skein::spy_tool\n")
