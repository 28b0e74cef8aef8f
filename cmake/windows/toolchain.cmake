# Cross-building for Windows with Debian's mingw-w64 (posix threads: the standard library's), against what parts.sh and qt.sh have built; programs run under Wine.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
get_filename_component(FUMAGE_WINDOWS_PARTS ${CMAKE_CURRENT_LIST_DIR}/../../build/windows-parts ABSOLUTE)
get_filename_component(FUMAGE_WINDOWS_QT ${CMAKE_CURRENT_LIST_DIR}/../../build/windows-qt ABSOLUTE)
set(CMAKE_FIND_ROOT_PATH ${FUMAGE_WINDOWS_PARTS} ${FUMAGE_WINDOWS_QT} /usr/x86_64-w64-mingw32)
set(CMAKE_CROSSCOMPILING_EMULATOR bash;${CMAKE_CURRENT_LIST_DIR}/wine.sh)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# Windows aligns stacks to 16 bytes, and GCC then spills registers of 32 and 64 bytes as if they lay on multiples of their size (its bug 54412): the first
# kernel would end the program. The assembler writes every aligned move as the unaligned one, which takes no longer where the address is aligned.
set(CMAKE_C_FLAGS_INIT "-Wa,-muse-unaligned-vector-move")
set(CMAKE_CXX_FLAGS_INIT "-Wa,-muse-unaligned-vector-move")
# One file for each program: the compiler's own libraries go into it.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static")
