# Files that become part of the program: an assembler puts their bytes between two symbols each, and a
# table names them. Debian has the library that draws the plots, with its licence.
enable_language(ASM)
find_file(MAQUETTE_CHART_LIBRARY chart.min.js PATHS /usr/share/javascript/chart.js NO_DEFAULT_PATH REQUIRED)
find_file(MAQUETTE_CHART_LICENCE copyright PATHS /usr/share/doc/libjs-chart.js NO_DEFAULT_PATH REQUIRED)

# add_assets(TARGET [NAME FILE]...) makes `assets()` of the target.
function(add_assets target)
  set(folder ${CMAKE_BINARY_DIR}/generated/assets)
  set(code ".section .rodata\n")
  set(declarations)
  set(rows)
  set(files)
  while(ARGN)
    list(POP_FRONT ARGN name file)
    string(MAKE_C_IDENTIFIER maquette_asset_${name} symbol)
    string(APPEND code ".globl ${symbol}, ${symbol}_end\n${symbol}:\n.incbin \"${file}\"\n${symbol}_end:\n.byte 0\n")
    string(APPEND declarations "extern const char ${symbol}[];\nextern const char ${symbol}_end[];\n")
    string(APPEND rows "      {\"${name}\", {${symbol}, static_cast<std::size_t>(${symbol}_end - ${symbol})}},\n")
    list(APPEND files ${file})
  endwhile()
  string(APPEND code ".section .note.GNU-stack,\"\",@progbits\n")
  file(CONFIGURE OUTPUT ${folder}/assets.S CONTENT "${code}")
  file(CONFIGURE OUTPUT ${folder}/asset_table.cpp CONTENT
"#include <cstddef>

#include \"sim/page/assets.hpp\"

extern \"C\" {
${declarations}}

const std::vector<maquette::sim::Asset>& maquette::sim::assets() {
  static const std::vector<Asset> all{
${rows}  };
  return all;
}
")
  set_source_files_properties(${folder}/assets.S PROPERTIES OBJECT_DEPENDS "${files}")
  target_sources(${target} PRIVATE ${folder}/assets.S ${folder}/asset_table.cpp)
endfunction()

file(GLOB scripts CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/script/*.js)
set(page_assets chart_library.js ${MAQUETTE_CHART_LIBRARY} chart_licence.txt ${MAQUETTE_CHART_LICENCE}
                style.css ${CMAKE_CURRENT_LIST_DIR}/style.css)
foreach(script IN LISTS scripts)
  cmake_path(GET script FILENAME name)
  list(APPEND page_assets ${name} ${script})
endforeach()
add_assets(maquette_sim_page ${page_assets})
