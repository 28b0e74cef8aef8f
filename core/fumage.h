/* Smoke for programs in C, or in any language that can call it; a program in C++ has more of it in live/live_scene.h.
 *
 * A smoke has the layers of its preset, which share one air and one light: functions without a layer are about all of
 * them, or where they have numbers of particles, about the first. Functions with "layer" in their names are about one,
 * by its number from 0 on. A preset of one layer needs no others than the first.
 *
 * A handle is one smoke that steps with a game. It may be used by one thread at a time; different handles by different
 * ones. Units are metres, seconds and linear colours, y is up. No exception leaves any function. What fails says so by
 * its result, and fumage_error() says why; the smoke is then as it was. */
#ifndef FUMAGE_FUMAGE_H
#define FUMAGE_FUMAGE_H

#include <stddef.h>
#include <stdint.h>

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
    int most_particles; /* alive at once in all layers, 1 to 4000000, for which births are thinned, in each layer by the
                           same share; 0: as many as the preset has */
    int most_steps_at_once; /* in one fumage_step(), time beyond them is let go; 0: 8 */
    double budget_ms; /* that a step may take, kept by thinning births, with which two runs differ; see
                         fumage_is_over_budget(); 0: none */
} fumage_options;

/* "0.1.0". */
FUMAGE_API const char* fumage_version(void);

/* Starts a smoke from the text of a preset, JSON as the editor writes it. options may be NULL.
 * Always gives a handle, to be given back to fumage_destroy(): if fumage_error() has something to say of it, it does
 * nothing else. NULL: out of memory. */
FUMAGE_API fumage_smoke* fumage_create_from_json(const char* json, const fumage_options* options);

/* The same from a built-in preset ("campfire"), one of the user's folder, or a file. */
FUMAGE_API fumage_smoke* fumage_create_from_name(const char* name, const fumage_options* options);

/* The same two, with parameters that are set before the smoke starts, also those that are fixed afterwards: texts as
 * "air.resolution=24", "air.enabled=off" or "emitter.count=20000", the last followed by NULL; settings may itself be
 * NULL. A layer's name, or its number from 1, before a slash sets a parameter of that layer, as in
 * "embers/emitter.count=200"; without one it is the first. "trail/from=debris" lets a layer be born on the particles of
 * another. Values out of their range are brought into it. */
FUMAGE_API fumage_smoke* fumage_create_from_json_with(
    const char* json, const char* const* settings, const fumage_options* options);
FUMAGE_API fumage_smoke* fumage_create_from_name_with(
    const char* name, const char* const* settings, const fumage_options* options);

/* How many threads all smokes of the process use inside, 1 or more; 0: as many as the machine has. Results are the
 * same. Not while another thread is in a function of this library. Gives 0 or -1. */
FUMAGE_API int fumage_limit_threads(int threads);

/* Ends a smoke; NULL is allowed. */
FUMAGE_API void fumage_destroy(fumage_smoke* smoke);

/* What the last call that could fail has to say, in English, UTF-8; NULL where it was well. Valid until the next call
 * with this handle. */
FUMAGE_API const char* fumage_error(const fumage_smoke* smoke);

/* Lets time pass, in seconds, 0 or more. Gives how many steps were made of it, or -1. */
FUMAGE_API int fumage_step(fumage_smoke* smoke, double seconds);

/* Sets a parameter from the next step on, by the key and the text that `fumage-cli parameters` tells: ("wind.strength",
 * "1.5"), or of another layer than the first ("flames/motion.drag", "2"); what is of the surroundings, as wind, air and
 * light, is set for all. Gives 0, 1 where the value was brought into its range, or -1. */
FUMAGE_API int fumage_set(fumage_smoke* smoke, const char* key, const char* value);

/* Moves the emitter: it goes there in a straight line during the next step. normal has any length but 0; velocity is
 * what particles take along at birth. Each is three numbers. NULL leaves position and normal as they are, and is no
 * velocity. Of several layers it is the first one's, and all others are carried along and turned with it as the parts
 * of a torch are: each keeps its place beside the first that the preset says. Gives 0 or -1. */
FUMAGE_API int fumage_set_emitter(
    fumage_smoke* smoke, const float* position, const float* normal, const float* velocity);

/* The same at once: nothing is born on the way. */
FUMAGE_API int fumage_place_emitter(
    fumage_smoke* smoke, const float* position, const float* normal, const float* velocity);

/* The share of particles that are born in all layers, 0 (none: the smoke goes out) to 1. */
FUMAGE_API void fumage_set_share(fumage_smoke* smoke, float share);

/* The share of particles that are born now in the first layer: of fumage_set_share(), fumage_set_layer_share(), and of
 * what the budget and most_particles leave. 0 for a handle that did not start. */
FUMAGE_API float fumage_share(const fumage_smoke* smoke);

/* 1 where the budget cannot be kept however few particles are born, as where air alone takes longer: coarser air
 * (air.resolution) or none would help. Else 0. */
FUMAGE_API int fumage_is_over_budget(const fumage_smoke* smoke);

/* A preset of bursts bursts again, in all layers. */
FUMAGE_API void fumage_burst(fumage_smoke* smoke);

/* Particles that live in the first layer. */
FUMAGE_API size_t fumage_living(const fumage_smoke* smoke);

/* Slots of the arrays below, which are those of the first layer: more than live, those that nobody lives in have radius
 * 0. Stays the same for a handle. 0 where the layer is muted: it is not to be drawn, and its arrays are NULL. */
FUMAGE_API size_t fumage_slots(const fumage_smoke* smoke);

/* One number a slot, valid until the next call with this handle but for these; NULL for a handle that did not start.
 * Metres. */
FUMAGE_API const float* fumage_x(fumage_smoke* smoke);
FUMAGE_API const float* fumage_y(fumage_smoke* smoke);
FUMAGE_API const float* fumage_z(fumage_smoke* smoke);
FUMAGE_API const float* fumage_radius(fumage_smoke* smoke);

/* Four numbers a slot: linear red, green and blue before light, and opacity in the middle, 0 to 1. */
FUMAGE_API const float* fumage_colour(fumage_smoke* smoke);

/* Four numbers a slot: linear red, green and blue in the light of sun, sky, ground and fire, with the shadow of all
 * layers and what the particle glows itself, which may be more than 1; not multiplied by the opacity, which is the
 * fourth and that of fumage_colour(). All 0 where nobody is seen.
 *
 * eye is where the camera is, three numbers, metres: towards the sun smoke is brighter (light.anisotropy). NULL: as
 * bright from everywhere. Found when asked for: on the first call after a step, and again for another eye, into the
 * same memory. It costs more than a step does, by the cells of light.resolution too, of which 16 to 32 are for games.
 *
 * NULL with a fumage_error(): the eye, or a particle, is nowhere, or memory has ended. Unlike the others it may fail,
 * so where it is well, it takes the last error away. */
FUMAGE_API const float* fumage_lit_colour(fumage_smoke* smoke, const float* eye);

/* Three numbers a slot: the way out of the smoke, of length 1, for light of one's own. All 0 where nobody is seen, and
 * where no way leads out: all around is as dense, or nothing throws shadow (light.shadow and light.occlusion 0).
 * Finds fumage_lit_colour() with it where nobody has asked for that since the last step: ask for that first. Fails as
 * it does. */
FUMAGE_API const float* fumage_normal(fumage_smoke* smoke);

/* One number a slot: seconds since birth, those of the game times timeline.time_scale, and the share of its life that
 * has passed, 0 to 1. */
FUMAGE_API const float* fumage_age(fumage_smoke* smoke);
FUMAGE_API const float* fumage_life(fumage_smoke* smoke);

/* Velocity without the turbulence that carries particles, m/s; times timeline.time_scale it is that in the game. */
FUMAGE_API const float* fumage_velocity_x(fumage_smoke* smoke);
FUMAGE_API const float* fumage_velocity_y(fumage_smoke* smoke);
FUMAGE_API const float* fumage_velocity_z(fumage_smoke* smoke);

/* The number of each slot's particle, its own as long as it lives and never given again; FUMAGE_NOBODY where nobody
 * lives. */
#define FUMAGE_NOBODY UINT64_MAX
FUMAGE_API const uint64_t* fumage_id(fumage_smoke* smoke);

/* Markers: moments of the preset's timeline that have names, in the order of their times, for a game that counts its
 * own time since the smoke started. */

/* How many there are; 0 for a handle that did not start. */
FUMAGE_API int fumage_markers(const fumage_smoke* smoke);

/* The name of a marker by its number from 0, UTF-8; valid until the next fumage_set(). NULL where there is no marker of
 * the number: fumage_error() says so. */
FUMAGE_API const char* fumage_marker_name(fumage_smoke* smoke, int marker);

/* When it is, seconds since the beginning of the timeline. Or -1. */
FUMAGE_API double fumage_marker_seconds(fumage_smoke* smoke, int marker);

/* Layers.
 *
 * All that follow may fail: where there is no layer of the number they give -1, 0 or NULL, as each says, and
 * fumage_error() says why; where it is well, they take the last error away. A muted layer has a number too, but no
 * slots. */

/* How many layers there are, muted ones too; 0 for a handle that did not start. */
FUMAGE_API int fumage_layers(const fumage_smoke* smoke);

/* The name of a layer, UTF-8, which may be empty; valid until the next fumage_set(). Or NULL. */
FUMAGE_API const char* fumage_layer_name(fumage_smoke* smoke, int layer);

/* The number, from 0, of the layer of a name, or of a number that is counted from 1 in a text ("2" is layer 1), as in
 * the keys of fumage_set(). Where no layer has the name, the one whose name it is but for capital letters, A to Z. -1
 * where there is none, or several have the name. */
FUMAGE_API int fumage_find_layer(fumage_smoke* smoke, const char* name);

/* As fumage_set_emitter() and fumage_place_emitter(), of one layer alone. A layer that is born on another takes of it
 * the normal, and the place that its vortex, rings and pull go by. Gives 0 or -1. */
FUMAGE_API int fumage_set_layer_emitter(
    fumage_smoke* smoke, int layer, const float* position, const float* normal, const float* velocity);
FUMAGE_API int fumage_place_layer_emitter(
    fumage_smoke* smoke, int layer, const float* position, const float* normal, const float* velocity);

/* The share of particles that are born in a layer, beside that of fumage_set_share(). Gives 0 or -1. */
FUMAGE_API int fumage_set_layer_share(fumage_smoke* smoke, int layer, float share);

/* The share of particles that are born in a layer now, as fumage_share(). Or 0. */
FUMAGE_API float fumage_layer_share(fumage_smoke* smoke, int layer);

/* A layer of bursts bursts again. Gives 0 or -1. */
FUMAGE_API int fumage_burst_layer(fumage_smoke* smoke, int layer);

/* As the functions without a layer: particles that live, slots, and one array of each slot. Or 0, or NULL. */
FUMAGE_API size_t fumage_layer_living(fumage_smoke* smoke, int layer);
FUMAGE_API size_t fumage_layer_slots(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_x(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_y(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_z(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_radius(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_colour(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_lit_colour(fumage_smoke* smoke, int layer, const float* eye);
FUMAGE_API const float* fumage_layer_normal(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_age(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_life(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_velocity_x(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_velocity_y(fumage_smoke* smoke, int layer);
FUMAGE_API const float* fumage_layer_velocity_z(fumage_smoke* smoke, int layer);
FUMAGE_API const uint64_t* fumage_layer_id(fumage_smoke* smoke, int layer);

#ifdef __cplusplus
}
#endif

#endif
