# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what a desktop by the freedesktop.org standards reads: icons, menu entries, the file type of scenes.
set(resources ${PROJECT_SOURCE_DIR}/resources)
set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
install(FILES ${resources}/slidercrank.svg DESTINATION ${icons}/scalable/apps)
install(FILES ${resources}/slidercrank-scene.svg DESTINATION ${icons}/scalable/mimetypes
    RENAME application-x-slidercrank-scene.svg)
install(FILES ${resources}/slidercrank.desktop ${resources}/slidercrank-reference.desktop
    DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${resources}/slidercrank-scene.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${resources}/local.slidercrank.slidercrank.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${resources}/slidercrank.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME slidercrank)

# Bitmap icons for desktops that do not draw scalable ones.
find_program(RSVG_CONVERT rsvg-convert)
if(RSVG_CONVERT)
    foreach(size IN ITEMS 16 22 24 32 48 64 128 256)
        set(png ${CMAKE_CURRENT_BINARY_DIR}/${size}.png)
        add_custom_command(OUTPUT ${png} DEPENDS ${resources}/slidercrank.svg VERBATIM
            COMMAND ${RSVG_CONVERT} --width ${size} --height ${size} --output ${png} ${resources}/slidercrank.svg)
        list(APPEND pngs ${png})
        install(FILES ${png} DESTINATION ${icons}/${size}x${size}/apps RENAME slidercrank.png)
    endforeach()
    add_custom_target(slidercrank_icons ALL DEPENDS ${pngs})
endif()
