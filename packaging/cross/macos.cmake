# macOS on 64-bit ARM.
set(CMAKE_SYSTEM_NAME Darwin)
set(CMAKE_SYSTEM_PROCESSOR arm64)
set(CMAKE_INSTALL_NAME_TOOL true)  # paths are right from the start
set(CMAKE_USER_MAKE_RULES_OVERRIDE ${CMAKE_CURRENT_LIST_DIR}/parts/zig-macos.cmake)
set(host aarch64-apple-darwin)
set(target aarch64-macos)
include(${CMAKE_CURRENT_LIST_DIR}/parts/zig.cmake)
