# What `cmake --install` lays down: the program with its data, and the models for programs of others
# (component development). `cpack -G DEB` packs the program.

# The program finds the rest from where it stands, wherever the whole is moved.
install(TARGETS maquette RUNTIME DESTINATION bin COMPONENT program)
install(TARGETS maquette_sim_picture_module LIBRARY DESTINATION lib/maquette COMPONENT program)
install(DIRECTORY models/machines models/arithmetic models/program DESTINATION share/maquette/models COMPONENT program
        FILES_MATCHING PATTERN *.yaml)
install(DIRECTORY scenes DESTINATION share/maquette COMPONENT program FILES_MATCHING PATTERN *.yaml)
install(FILES sim/stability/exact_roots.txt DESTINATION share/maquette/stability COMPONENT program)

# find_package(maquette) gives maquette::models and maquette::firmware.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/maquette)
install(EXPORT maquette NAMESPACE maquette:: FILE maquetteTargets.cmake DESTINATION ${package_folder}
        COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/maquetteConfig.cmake.in
                              ${CMAKE_BINARY_DIR}/generated/maquetteConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/maquetteConfigVersion.cmake
                                 COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/maquetteConfig.cmake
              ${CMAKE_BINARY_DIR}/generated/maquetteConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The maquette authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of the ray-casting machine that CCETT built in 1984")
set(CPACK_COMPONENTS_ALL program)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME maquette)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
