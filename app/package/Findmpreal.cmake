# SPDX-License-Identifier: GPL-3.0-or-later
# Many-digit numbers: the header mpreal.h with MPFR and GMP, or, in a page for the browser, a header with Boost alone. Defines the
# target mpreal::mpreal and MPFR_VERSION.
include(FindPackageHandleStandardArgs)
add_library(mpreal::mpreal INTERFACE IMPORTED)
if(EMSCRIPTEN)
    set(MPREAL_INCLUDE_DIR ${CMAKE_CURRENT_LIST_DIR}/browser_libraries)
    target_link_libraries(mpreal::mpreal INTERFACE Boost::headers)
    find_package_handle_standard_args(mpreal REQUIRED_VARS MPREAL_INCLUDE_DIR)
else()
    find_path(MPREAL_INCLUDE_DIR mpreal.h)
    find_path(MPFR_INCLUDE_DIR mpfr.h)
    find_library(MPFR_LIBRARY mpfr)
    find_library(GMP_LIBRARY gmp)
    find_package_handle_standard_args(mpreal
        REQUIRED_VARS MPREAL_INCLUDE_DIR MPFR_INCLUDE_DIR MPFR_LIBRARY GMP_LIBRARY)
    file(STRINGS ${MPFR_INCLUDE_DIR}/mpfr.h MPFR_VERSION REGEX "define MPFR_VERSION_STRING")
    string(REGEX MATCH "[0-9.]+" MPFR_VERSION "${MPFR_VERSION}")
    target_link_libraries(mpreal::mpreal INTERFACE ${MPFR_LIBRARY} ${GMP_LIBRARY})
endif()
target_include_directories(mpreal::mpreal SYSTEM INTERFACE ${MPREAL_INCLUDE_DIR} ${MPFR_INCLUDE_DIR})
