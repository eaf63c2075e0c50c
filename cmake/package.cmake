# The Debian package: cmake --build --preset release --target package. What it installs also goes to
# another place by cmake --install.
set(contact "The maintainers of Promenade <maintainers@users.noreply.h-seed-0f811ca1.example>")
set(package_files ${PROJECT_SOURCE_DIR}/cmake/package)
set(documents share/doc/promenade)

install(TARGETS promenade RUNTIME DESTINATION bin)
install(FILES ${package_files}/promenade.desktop DESTINATION share/applications)
install(FILES ${package_files}/promenade.svg DESTINATION share/icons/hicolor/scalable/apps)
install(DIRECTORY configs DESTINATION share/promenade)
# The links between the documents hold: they lie to each other as they do in the source.
install(FILES README.md ${package_files}/copyright DESTINATION ${documents})
install(DIRECTORY docs DESTINATION ${documents})
file(GLOB measurements CONFIGURE_DEPENDS results/*.md)
install(FILES ${measurements} DESTINATION ${documents}/results)

set(made ${PROJECT_BINARY_DIR}/package)
install(CODE "
  set(PROGRAM \"$<TARGET_FILE:promenade>\")
  set(SOURCE \"${PROJECT_SOURCE_DIR}\")
  set(VERSION \"${PROJECT_VERSION}\")
  set(CONTACT \"${contact}\")
  set(INTO \"${made}\")")
install(SCRIPT ${package_files}/documents.cmake)
install(FILES ${made}/changelog.gz ${made}/changelog.Debian.gz DESTINATION ${documents})
install(FILES ${made}/promenade.1.gz DESTINATION share/man/man1)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME promenade)
set(CPACK_PACKAGE_CONTACT "${contact}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "user studies of motion-style interfaces")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Promenade runs studies of the controls with which people say that a walk
should be sad, brisk, or like that one: maps, lists of labels, sliders. A
walking figure answers at once; every click and every joint distance goes to
one SQLite file, and a report with figures, tables and tests comes from it.
A study is one text file. Simulated participants, motion sets that the
program makes itself and the published studies of the field come with it.")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# Libraries by dpkg-shlibdeps; the rest is what the program starts (gnuplot), reads (fonts), or what
# its libraries open by name: drivers of OpenGL, and for GLFW the parts of X that know of several
# displays, of their rates and of cursors. Without these it would still start, and know less.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-ipafont-gothic, fonts-noto-core, \
gnuplot-nox | gnuplot-qt | gnuplot-x11, libgl1-mesa-dri, \
libxcursor1, libxi6, libxinerama1, libxrandr2, libxrender1, libxxf86vm1, xdg-utils")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "r-base-core, r-cran-lme4, r-cran-ordinal, xvfb")

# In a folder of its own: beside the build, CMake would make a target `package` that first builds
# everything, the tests too. Ours needs the program alone.
set(CPACK_OUTPUT_CONFIG_FILE ${made}/CPackConfig.cmake)
set(CPACK_SOURCE_OUTPUT_CONFIG_FILE ${made}/CPackSourceConfig.cmake)
include(CPack)
add_custom_target(package
  COMMAND ${CMAKE_CPACK_COMMAND} --config ${CPACK_OUTPUT_CONFIG_FILE}
  DEPENDS promenade
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  USES_TERMINAL VERBATIM
  COMMENT "Packing promenade for Debian")
