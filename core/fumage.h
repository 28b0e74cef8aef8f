/* Smoke for programs in C, or in any language that can call it; a program in C++ has more of it in live/live_simulation.h.
 *
 * A handle is one smoke that steps with a game. It may be used by one thread at a time; different handles by different ones. Units are metres, seconds and
 * linear colours, y is up. No exception leaves any function. What fails says so by its result, and fumage_error() says why; the smoke is then as it was. */
#ifndef FUMAGE_FUMAGE_H
#define FUMAGE_FUMAGE_H

#include <stddef.h>

#if defined(_WIN32) && defined(FUMAGE_BUILDS_LIBRARY)
#define FUMAGE_API __declspec(dllexport)
#elif defined(_WIN32)
#define FUMAGE_API __declspec(dllimport)
#else
#define FUMAGE_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* One smoke. */
typedef struct fumage_smoke fumage_smoke;

/* What is fixed when a smoke starts; all zero for what the preset says. */
typedef struct fumage_options {
    int steps_per_second; /* 1 to 240, best as many as the game has; 0: those of the preset */
    int most_particles; /* alive at once, 1 to 4000000; 0: as many as the preset has */
    int most_steps_at_once; /* in one fumage_step(), time beyond them is let go; 0: 8 */
    double budget_ms; /* that a step may take, kept by thinning births, with which two runs differ; 0: none */
} fumage_options;

/* "0.1.0". */
FUMAGE_API const char* fumage_version(void);

/* Starts a smoke from the text of a preset, JSON as the editor writes it. options may be NULL.
 * Always gives a handle, to be given back to fumage_destroy(): if fumage_error() has something to say of it, it does nothing else. NULL: out of memory. */
FUMAGE_API fumage_smoke* fumage_create_from_json(const char* json, const fumage_options* options);

/* The same from a built-in preset ("campfire"), one of the user's folder, or a file. */
FUMAGE_API fumage_smoke* fumage_create_from_name(const char* name, const fumage_options* options);

/* Ends a smoke; NULL is allowed. */
FUMAGE_API void fumage_destroy(fumage_smoke* smoke);

/* What the last call that could fail has to say, in English, UTF-8; NULL where it was well. Valid until the next call with this handle. */
FUMAGE_API const char* fumage_error(const fumage_smoke* smoke);

/* Lets time pass, in seconds. Gives how many steps were made of it, or -1. */
FUMAGE_API int fumage_step(fumage_smoke* smoke, double seconds);

/* Sets a parameter from the next step on, by the key and the text that `fumage-cli parameters` tells: ("motion.wind", "1.5").
 * Gives 0, 1 where the value was brought into its range, or -1. */
FUMAGE_API int fumage_set(fumage_smoke* smoke, const char* key, const char* value);

/* Moves the emitter: it goes there in a straight line during the next step. normal has any length but 0; velocity is what particles take along at birth,
 * NULL for none. Each is three numbers. Gives 0 or -1. */
FUMAGE_API int fumage_set_emitter(fumage_smoke* smoke, const float* position, const float* normal, const float* velocity);

/* The same at once: nothing is born on the way. */
FUMAGE_API int fumage_place_emitter(fumage_smoke* smoke, const float* position, const float* normal, const float* velocity);

/* The share of particles that are born, 0 (none: the smoke goes out) to 1. */
FUMAGE_API void fumage_set_share(fumage_smoke* smoke, float share);

/* A preset of bursts bursts again. */
FUMAGE_API void fumage_burst(fumage_smoke* smoke);

/* Particles that live. */
FUMAGE_API size_t fumage_living(const fumage_smoke* smoke);

/* Slots of the arrays below: more than live, those that nobody lives in have radius 0. Stays the same for a handle. */
FUMAGE_API size_t fumage_slots(const fumage_smoke* smoke);

/* One number a slot, valid until the next call with this handle but for these; NULL for a handle that did not start. Metres. */
FUMAGE_API const float* fumage_x(fumage_smoke* smoke);
FUMAGE_API const float* fumage_y(fumage_smoke* smoke);
FUMAGE_API const float* fumage_z(fumage_smoke* smoke);
FUMAGE_API const float* fumage_radius(fumage_smoke* smoke);

/* Four numbers a slot: linear red, green and blue before light, and opacity in the middle, 0 to 1. */
FUMAGE_API const float* fumage_colour(fumage_smoke* smoke);

#ifdef __cplusplus
}
#endif

#endif
