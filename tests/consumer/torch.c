/* A torch that is carried along a way: flames, their smoke, and embers that are born on the flames. Three layers of one
 * preset, which share one air and one light, and are drawn one after another here: into rows of letters. */
#include <fumage/fumage.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { columns = 72, rows = 22, steps = 240 };

/* What is not said here is as in the editor's default. Lengths are metres; a torch burns on 16 cells of air. */
static const char* const preset =
    "{\"format\": \"fumage-preset\", \"version\": 2, \"name\": \"Torch\","
    " \"scene\": {\"air\": {\"enabled\": true, \"resolution\": 16, \"buoyancy\": 6, \"cooling\": 2, \"ground\": false},"
    "  \"wind\": {\"strength\": 0}, \"light\": {\"resolution\": 16}},"
    " \"layers\": ["
    "  {\"name\": \"flames\", \"emitter\": {\"count\": 3000, \"radius\": 0.06, \"speed\": 0.8, \"seed\": 1},"
    "   \"life\": {\"initial_alpha\": 0.1, \"fade_rate\": 0.2}, \"look\": {\"size\": 0.08},"
    "   \"glow\": {\"emission\": 8, \"emission_cooling\": 0.5, \"flame_opacity\": 0.4}},"
    "  {\"name\": \"smoke\", \"emitter\": {\"count\": 4000, \"position\": [0, 0.25, 0], \"radius\": 0.08, \"seed\": 2},"
    "   \"source\": {\"feeds\": false}, \"life\": {\"initial_alpha\": 0.1, \"fade_rate\": 0.05},"
    "   \"look\": {\"size\": 0.15, \"opacity\": 0.5}},"
    "  {\"name\": \"embers\", \"from\": \"flames\", \"emitter\": {\"count\": 150, \"inherit\": 0.8, \"seed\": 3},"
    "   \"motion\": {\"coupling\": \"dragged\", \"gravity\": 0.4, \"drag\": 2},"
    "   \"look\": {\"size\": 0.02}, \"glow\": {\"emission\": 16}}]}";

static int failed(fumage_smoke* smoke)
{
    fprintf(stderr, "%s\n", fumage_error(smoke));
    fumage_destroy(smoke);
    return 1;
}

/* Puts the particles of a layer that are bright, or dense, enough into the picture, as a letter. */
static int draw(fumage_smoke* smoke, const char* name, char letter, char picture[rows][columns + 1])
{
    const int layer = fumage_find_layer(smoke, name);
    const float eye[3] = {0, 1, 8};
    const float* colour = layer < 0 ? NULL : fumage_layer_lit_colour(smoke, layer, eye);
    if (colour == NULL) {
        return -1;
    }
    const float* x = fumage_layer_x(smoke, layer);
    const float* y = fumage_layer_y(smoke, layer);
    for (size_t slot = 0; slot < fumage_layer_slots(smoke, layer); ++slot) {
        const int column = (int)floorf(x[slot] * 12.0F + 10.0F);
        const int row = rows - 1 - (int)floorf(y[slot] * 8.0F + 2.0F);
        if (colour[4 * slot + 3] > 0.0F && column >= 0 && column < columns && row >= 0 && row < rows) {
            picture[row][column] = letter;
        }
    }
    return 0;
}

int main(void)
{
    const fumage_options options = {60, 0, 0, 0.0};
    char picture[rows][columns + 1];
    fumage_smoke* smoke = fumage_create_from_json(preset, &options);
    if (fumage_error(smoke) != NULL) {
        return failed(smoke);
    }
    const int embers = fumage_find_layer(smoke, "embers");
    if (embers < 0 || fumage_set_layer_share(smoke, embers, 0.3F) != 0) {
        return failed(smoke);
    }
    for (int step = 0; step < steps; ++step) {
        /* Carried along by a hand that goes up and down and holds it aslant; all three layers go with it. */
        const float time = (float)step / 60.0F;
        const float place[3] = {time, 0.1F * sinf(6.0F * time), 0};
        const float aslant[3] = {0.2F, 1, 0};
        const float velocity[3] = {1, 0, 0};
        if (fumage_set_emitter(smoke, place, aslant, velocity) != 0) {
            return failed(smoke);
        }
        /* Somebody shakes it: all of its embers, and more smoke. */
        if (step == steps / 2
            && (fumage_set_layer_share(smoke, embers, 1.0F) != 0
                || fumage_set(smoke, "smoke/look.opacity", "0.9") < 0)) {
            return failed(smoke);
        }
        if (fumage_step(smoke, 1.0 / 60.0) < 0) {
            return failed(smoke);
        }
    }
    for (int row = 0; row < rows; ++row) {
        memset(picture[row], ' ', columns);
        picture[row][columns] = '\0';
    }
    if (draw(smoke, "smoke", '.', picture) != 0 || draw(smoke, "flames", '#', picture) != 0
        || draw(smoke, "embers", '*', picture) != 0) {
        return failed(smoke);
    }
    for (int row = 0; row < rows; ++row) {
        puts(picture[row]);
    }
    for (int layer = 0; layer < fumage_layers(smoke); ++layer) {
        printf("%s: %zu particles\n", fumage_layer_name(smoke, layer), fumage_layer_living(smoke, layer));
        if (fumage_layer_living(smoke, layer) == 0) {
            return 1;
        }
    }
    fumage_destroy(smoke);
    return 0;
}
