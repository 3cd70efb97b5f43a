# SPDX-License-Identifier: GPL-3.0-or-later
# The program for a browser, as app/package/browser builds it: slidercrank.js and slidercrank.wasm.
qt_add_executable(slidercrank browser.cpp)
target_link_libraries(slidercrank PRIVATE ui_window)
target_compile_definitions(slidercrank PRIVATE SLIDERCRANK_VERSION="${PROJECT_VERSION}")
# The linker's optimizer would insert functions that are called in one place into their caller: 4 kB of text shaping became 36 kB.
# Chromium optimizes a large function after a few hundred calls, and where there are two processors the program waits for
# that: the window appeared half a second later.
set(largest_inlined 50) # expressions
target_link_options(slidercrank PRIVATE -O2 -sBINARYEN_EXTRA_PASSES=one-caller-inline-max-function-size=${largest_inlined})
qt_import_plugins(slidercrank INCLUDE Qt6::QWasmIntegrationPlugin Qt6::QSvgPlugin Qt6::QSvgIconPlugin)
