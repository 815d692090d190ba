# Rooms: a folder of sources is a target that can include only its own headers and those of the rooms
# that it names. The include path of a room is a mirror of it in the build folder, made of links, so that
# a header of any other room is not found. Rooms that no SystemC may reach find files in the place of
# SystemC's headers that say so.

set(rooms_mirror ${CMAKE_BINARY_DIR}/rooms)
set(no_systemc ${CMAKE_BINARY_DIR}/no_systemc)
foreach(header systemc systemc.h tlm tlm.h)
  file(CONFIGURE OUTPUT ${no_systemc}/${header} CONTENT "#error this room must not see SystemC\n")
endforeach()

# Links the headers of a folder of the sources into the mirror of a room.
function(mirror_headers mirror folder)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR} ${CMAKE_SOURCE_DIR}/${folder}/*.hpp)
  file(MAKE_DIRECTORY ${mirror}/${folder})
  foreach(header IN LISTS headers)
    file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${header} ${mirror}/${header} SYMBOLIC)
  endforeach()
endfunction()

# Installs a room for programs of others: its library, and its headers by their path in the project.
function(install_room target name)
  foreach(folder IN LISTS ARGN)
    file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.hpp)
    install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/maquette/${folder} COMPONENT development)
  endforeach()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  set_target_properties(${target}_headers PROPERTIES EXPORT_NAME ${name}_headers)
  target_include_directories(${target}_headers INTERFACE
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/maquette>)
  install(TARGETS ${target} ${target}_headers EXPORT maquette
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
endfunction()

# add_room(FOLDER [WITH FOLDER...] [ROOMS FOLDER...] [HEADERS_OF FOLDER...] [LIBRARIES TARGET...]
#          [WITHOUT_SYSTEMC] [MODULE] [INSTALLED])
# makes the target maquette_FOLDER (alias maquette::FOLDER, / as _) of the sources in FOLDER and in the
# folders WITH it. ROOMS are linked, of HEADERS_OF only the headers are seen (they hold plain data). A
# MODULE is loaded at run time and linked by nobody. What is INSTALLED is there for programs of others,
# without the options of our own compilations.
function(add_room folder)
  cmake_parse_arguments(room "WITHOUT_SYSTEMC;MODULE;INSTALLED" "" "WITH;ROOMS;HEADERS_OF;LIBRARIES" ${ARGN})
  string(REPLACE / _ name ${folder})
  set(target maquette_${name})
  set(mirror ${rooms_mirror}/${name})
  file(REMOVE_RECURSE ${mirror})
  set(sources)
  foreach(part IN ITEMS ${folder} LISTS room_WITH)
    mirror_headers(${mirror} ${part})
    file(GLOB part_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${part}/*.cpp)
    list(APPEND sources ${part_sources})
  endforeach()

  add_library(${target}_headers INTERFACE)
  target_include_directories(${target}_headers INTERFACE $<BUILD_INTERFACE:${mirror}>)
  target_compile_features(${target}_headers INTERFACE cxx_std_17)
  foreach(other IN LISTS room_ROOMS room_HEADERS_OF)
    string(REPLACE / _ other ${other})
    target_link_libraries(${target}_headers INTERFACE maquette_${other}_headers)
  endforeach()

  if(sources)
    set(type STATIC)
    if(room_MODULE)
      set(type MODULE)
    endif()
    add_library(${target} ${type} ${sources})
    set(access PUBLIC)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:maquette_options>)
    # Messages name a source by its path in the project, wherever it was built; the last map that fits holds.
    target_compile_options(${target} PRIVATE -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=
                                             -fmacro-prefix-map=${mirror}/=)
    if(room_WITHOUT_SYSTEMC)
      target_include_directories(${target} BEFORE PRIVATE ${no_systemc})
    endif()
  else()
    add_library(${target} INTERFACE)
    set(access INTERFACE)
  endif()
  if(NOT room_MODULE)
    add_library(maquette::${name} ALIAS ${target})
  endif()
  target_link_libraries(${target} ${access} ${target}_headers ${room_LIBRARIES})
  foreach(other IN LISTS room_ROOMS)
    string(REPLACE / _ other ${other})
    target_link_libraries(${target} ${access} maquette_${other})
  endforeach()
  if(room_INSTALLED)
    install_room(${target} ${name} ${folder} ${room_WITH})
  endif()
endfunction()
