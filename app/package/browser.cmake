# SPDX-License-Identifier: GPL-3.0-or-later
# The program for a browser, as app/package/browser builds it: slidercrank.js and slidercrank.wasm.
qt_add_executable(slidercrank browser.cpp)
target_link_libraries(slidercrank PRIVATE ui_window)
target_compile_definitions(slidercrank PRIVATE SLIDERCRANK_VERSION="${PROJECT_VERSION}")
target_link_options(slidercrank PRIVATE -O2)
qt_import_plugins(slidercrank INCLUDE Qt6::QWasmIntegrationPlugin Qt6::QSvgPlugin Qt6::QSvgIconPlugin)
