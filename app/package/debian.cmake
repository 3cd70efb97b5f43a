# SPDX-License-Identifier: GPL-3.0-or-later
# Describes the Debian package. `cpack -G DEB` in the folder of a Release build makes it (app/package/deb does that).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ${PROJECT_NAME})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "slidercrank maintainers <slidercrank@slidercrank.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "motion of a slider-crank, computed and compared with a simulation")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Set the lengths, the offset and the crank speed of a slider-crank, and watch
it move while positions, velocities and accelerations are plotted. The motion
is computed exactly, and by the Newton-Raphson method with the 12 coordinates
of multibody dynamics.
.
The results of another simulation, saved as CSV, are drawn over the plots. The
program reports how far they differ from the model, and finds the mechanism
that produced them. Everything can also be done from the command line.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6svg6 (<< 6.7.2-5~) | qt6-svg-plugins") # a plugin, loaded at run time for the window's icon
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-dejavu-core | fonts-noto-core, qt6-translations-l10n, qt6-wayland")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg")

# Manual pages and changelogs are compressed on Debian.
find_program(GZIP gzip REQUIRED)
function(install_compressed file destination)
    get_filename_component(name ${file} NAME)
    set(compressed ${CMAKE_CURRENT_BINARY_DIR}/${name}.gz)
    execute_process(COMMAND ${GZIP} --best --no-name --stdout ${file} OUTPUT_FILE ${compressed} COMMAND_ERROR_IS_FATAL ANY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    install(FILES ${compressed} DESTINATION ${destination})
endfunction()

install(FILES ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${PROJECT_NAME})
install_compressed(${CMAKE_CURRENT_LIST_DIR}/changelog ${CMAKE_INSTALL_DATADIR}/doc/${PROJECT_NAME})

# The program writes its manual page itself.
set(manual ${CMAKE_CURRENT_BINARY_DIR}/slidercrank.1.gz)
add_custom_command(OUTPUT ${manual} DEPENDS slidercrank VERBATIM
    COMMAND sh -c "LC_ALL=C.UTF-8 \"$1\" help --man-page | \"$2\" --best --no-name > \"$3\"" sh
        $<TARGET_FILE:slidercrank> ${GZIP} ${manual})
add_custom_target(slidercrank_manual ALL DEPENDS ${manual})
install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

include(CPack)
