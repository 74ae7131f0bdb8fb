# Linux on x86-64 with musl in place of the GNU C library. Programs run where Debian's package musl is installed.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CROSSCOMPILING_EMULATOR env)
set(host x86_64-linux-musl)
set(wheel musllinux_1_2_x86_64)
set(target x86_64-linux-musl)
include(${CMAKE_CURRENT_LIST_DIR}/parts/zig.cmake)
