# SPDX-License-Identifier: GPL-3.0-or-later
# Additions for the Windows program, which app/package/windows builds.

# slidercrank.exe opens no console. A command prompt does not wait for such a program, does not see its exit status and cannot
# interrupt it. Therefore slidercrank.com, which Windows prefers when `slidercrank` is typed, is a copy whose header requests
# a console.
set_target_properties(slidercrank PROPERTIES WIN32_EXECUTABLE ON)
set(console $<TARGET_FILE_DIR:slidercrank>/slidercrank.com)
add_custom_command(TARGET slidercrank POST_BUILD VERBATIM
    COMMAND ${CMAKE_OBJCOPY} --subsystem console $<TARGET_FILE:slidercrank> ${console})
install(PROGRAMS ${console} DESTINATION ${CMAKE_INSTALL_BINDIR})

if(NOT QT6_IS_SHARED_LIBS_BUILD)
    qt_import_plugins(slidercrank INCLUDE
        Qt6::QWindowsIntegrationPlugin Qt6::QOffscreenIntegrationPlugin Qt6::QSvgPlugin Qt6::QSvgIconPlugin)
endif()

# Qt's own Spanish translation, which on Debian is a package of its own.
find_file(QT_IN_SPANISH qtbase_es.qm PATHS /usr/share/qt6/translations NO_CMAKE_FIND_ROOT_PATH REQUIRED)
cmake_path(GET QT_IN_SPANISH PARENT_PATH folder)
file(CONFIGURE OUTPUT qt.conf CONTENT "[Paths]\nTranslations=:/translations\n")
qt_add_resources(slidercrank qt_in_spanish PREFIX /translations BASE ${folder} FILES ${QT_IN_SPANISH})
qt_add_resources(slidercrank qt_conf PREFIX /qt/etc BASE ${CMAKE_CURRENT_BINARY_DIR}
    FILES ${CMAKE_CURRENT_BINARY_DIR}/qt.conf)

# Icons (first the program's, then that of scene files) and the version information that Explorer shows.
find_program(RSVG_CONVERT rsvg-convert REQUIRED)
find_program(ICOTOOL icotool REQUIRED)
foreach(name IN ITEMS slidercrank slidercrank-scene)
    set(svg ${PROJECT_SOURCE_DIR}/resources/${name}.svg)
    set(icon ${CMAKE_CURRENT_BINARY_DIR}/${name}.ico)
    set(commands)
    set(pngs)
    foreach(size IN ITEMS 16 20 24 32 40 48 64 256)
        set(png ${CMAKE_CURRENT_BINARY_DIR}/${name}-${size}.png)
        list(APPEND commands COMMAND ${RSVG_CONVERT} --width ${size} --height ${size} --output ${png} ${svg})
        list(APPEND pngs ${png})
    endforeach()
    list(TRANSFORM pngs REPLACE "(.*-256.png)" "--raw=\\1")
    add_custom_command(OUTPUT ${icon} DEPENDS ${svg} VERBATIM ${commands}
        COMMAND ${ICOTOOL} --create --output ${icon} ${pngs})
    list(APPEND icons ${icon})
endforeach()
string(REPLACE . , numbers ${PROJECT_VERSION},0)
file(CONFIGURE OUTPUT slidercrank.rc CONTENT [[
1 ICON "slidercrank.ico"
2 ICON "slidercrank-scene.ico"
1 VERSIONINFO
FILEVERSION @numbers@
PRODUCTVERSION @numbers@
BEGIN
    BLOCK "StringFileInfo"
    BEGIN
        BLOCK "040904B0"
        BEGIN
            VALUE "FileDescription", "Slider-Crank"
            VALUE "FileVersion", "@PROJECT_VERSION@"
            VALUE "InternalName", "slidercrank"
            VALUE "LegalCopyright", "2026 the authors of slidercrank, GPL 3 or later"
            VALUE "OriginalFilename", "slidercrank.exe"
            VALUE "ProductName", "Slider-Crank"
            VALUE "ProductVersion", "@PROJECT_VERSION@"
        END
    END
    BLOCK "VarFileInfo"
    BEGIN
        VALUE "Translation", 0x409, 1200
    END
END
]] @ONLY)
set(resource ${CMAKE_CURRENT_BINARY_DIR}/slidercrank.rc)
target_sources(slidercrank PRIVATE ${resource})
set_source_files_properties(${resource} TARGET_DIRECTORY slidercrank PROPERTIES
    OBJECT_DEPENDS "${icons}"
    COMPILE_OPTIONS -I${CMAKE_CURRENT_BINARY_DIR})
