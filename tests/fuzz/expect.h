#pragma once

#include <cstdio>
#include <cstdlib>

/// Ends the fuzzer with the line that found the fault.
#define FUMAGE_EXPECT(condition)                                                                                       \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                                       \
            std::abort();                                                                                              \
        }                                                                                                              \
    } while (false)
