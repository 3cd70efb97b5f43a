# SPDX-License-Identifier: GPL-3.0-or-later
# Toolchain to cross-compile programs for 64-bit Windows on Debian, linked statically (app/package/windows).
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
cmake_path(SET libraries NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../build/windows/libraries)
set(CMAKE_EXE_LINKER_FLAGS_INIT
    "-static -Wl,--whole-archive,${libraries}/lib/libmathematics.a,--no-whole-archive")
set(CMAKE_EXE_LINKER_FLAGS_RELEASE_INIT -s)

# Programs that run during the build come from Debian, libraries and headers from the cross-compiled folder.
set(CMAKE_FIND_ROOT_PATH ${libraries} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(QT_HOST_PATH /usr)
set(QT_HOST_PATH_CMAKE_DIR /usr/lib/x86_64-linux-gnu/cmake)
