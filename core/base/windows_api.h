#pragma once

// What *_windows.cpp include of Windows: without its macros min and max, and without what is rarely used.
// Windows 10 of 1607 and later is compiled for; what older ones lack is tried and has a second way.
#ifndef _WIN32_WINNT
#define _WIN32_WINNT 0x0A00
#endif
#ifndef NTDDI_VERSION
#define NTDDI_VERSION 0x0A000003
#endif
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
