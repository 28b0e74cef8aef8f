/* A game without pictures: an emitter that goes in a circle, a wind that rises, and what the smoke has become at the end. */
#include <fumage/fumage.h>

#include <stdio.h>

static int failed(const fumage_smoke* smoke)
{
    fprintf(stderr, "%s\n", fumage_error(smoke));
    return 1;
}

int main(int count, char** arguments)
{
    /* 20000 particles in air of 20 cells: what a game has time for. The preset's own air and number are for pictures. */
    const char* const settings[] = {"emitter.count=20000", "air.resolution=20", NULL};
    const fumage_options options = {60, 0, 0, 0.0};
    const float corners[4][3] = {{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}};
    const float up[3] = {0, 1, 0};
    fumage_smoke* smoke = fumage_create_from_name_with(count > 1 ? arguments[1] : "chimney", settings, &options);
    if (fumage_error(smoke) != NULL) {
        const int result = failed(smoke);
        fumage_destroy(smoke);
        return result;
    }
    for (int step = 0; step < 240; ++step) {
        if (step % 30 == 0 && fumage_set_emitter(smoke, corners[step / 30 % 4], up, NULL) != 0) {
            return failed(smoke);
        }
        if (step == 120 && fumage_set(smoke, "wind.strength", "2.5") != 0) {
            return failed(smoke);
        }
        if (fumage_step(smoke, 1.0 / 60.0) < 0) {
            return failed(smoke);
        }
    }
    const size_t slots = fumage_slots(smoke);
    const float* x = fumage_x(smoke);
    const float* y = fumage_y(smoke);
    const float* radius = fumage_radius(smoke);
    const float eye[3] = {0, 3, 12};
    const float* colour = fumage_lit_colour(smoke, eye);
    if (colour == NULL) {
        return failed(smoke);
    }
    double mass = 0.0, right = 0.0, height = 0.0, green = 0.0;
    for (size_t slot = 0; slot < slots; ++slot) {
        const double part = (double)colour[4 * slot + 3] * radius[slot] * radius[slot];
        mass += part;
        right += part * x[slot];
        height += part * y[slot];
        green += part * colour[4 * slot + 1];
    }
    printf("Fumage %s: %zu particles, in the middle at x %.2f, y %.2f m", fumage_version(), fumage_living(smoke), right / mass, height / mass);
    printf(", %.2f of light\n", green / mass);
    fumage_destroy(smoke);
    return mass > 0.0 && height > 0.0 && green > 0.0 ? 0 : 1;
}
