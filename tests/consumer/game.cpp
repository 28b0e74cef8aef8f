// A game with SDL: smoke that follows the pointer with all its layers, in a wind that the arrow keys make.
//   game [preset [frames picture.bmp]]    with frames no hand is needed: the emitter goes in a circle, and the last
//   picture is kept
#include <fumage/live/live_scene.h>
#include <fumage/preset/library.h>
#include <fumage/rendering/renderer.h>

#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

constexpr int kEdge = 480; // pixels of the window

/// A screen's curve, nearly.
static const auto byteOf = [](float linear) {
    return static_cast<Uint8>(255.0F * std::sqrt(std::clamp(linear, 0.0F, 1.0F)));
};

/// A soft disc, as the sprites are without their noise.
static SDL_Texture* softDisc(SDL_Renderer* renderer)
{
    constexpr int kSize = 64;
    SDL_Surface* disc = SDL_CreateRGBSurfaceWithFormat(0, kSize, kSize, 32, SDL_PIXELFORMAT_RGBA32);
    for (int i = 0; i < kSize * kSize; ++i) {
        const float x = (static_cast<float>(i % kSize) + 0.5F) * 2.0F / kSize - 1.0F;
        const float y = (static_cast<float>(i / kSize) + 0.5F) * 2.0F / kSize - 1.0F;
        const float inside = std::max(0.0F, 1.0F - x * x - y * y);
        static_cast<SDL_Color*>(disc->pixels)[i] = {255, 255, 255, static_cast<Uint8>(255.0F * inside * inside)};
    }
    return SDL_CreateTextureFromSurface(renderer, disc);
}

/// Two triangles a sprite, the farthest of all layers first.
static std::vector<SDL_Vertex> trianglesOf(const fumage::Renderer& renderer, std::size_t layers)
{
    std::vector<std::pair<float, const fumage::Sprite*>> order;
    for (std::size_t layer = 0; layer < layers; ++layer) {
        const fumage::SpriteBatch& batch = renderer.batch(layer);
        for (std::size_t i = 0; i < batch.sprites.size(); ++i) {
            if (batch.depth[i] != fumage::SpriteBatch::kHidden) {
                order.emplace_back(batch.depth[i], &batch.sprites[i]);
            }
        }
    }
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<SDL_Vertex> out;
    for (const auto& [depth, sprite] : order) {
        const fumage::Sprite& s = *sprite;
        const auto light = [&](int channel) { return byteOf(s.direct[channel] + s.ambient[channel]); };
        const SDL_Color colour{light(0), light(1), light(2), static_cast<Uint8>(255.0F * s.opacity)};
        for (const int corner : {0, 1, 2, 2, 1, 3}) {
            const SDL_FPoint at{static_cast<float>(corner % 2), static_cast<float>(corner / 2)};
            out.push_back(
                {{s.x + (2.0F * at.x - 1.0F) * s.halfWidth, s.y + (2.0F * at.y - 1.0F) * s.halfHeight}, colour, at});
        }
    }
    return out;
}

int main(int count, char** arguments)
{
    const auto preset = fumage::loadPreset(std::string(count > 1 ? arguments[1] : "chimney"));
    fumage::Scene scene = preset ? preset.value().preset.scene : fumage::Scene();
    scene.air.resolution = std::min(scene.air.resolution, 24); // coarse, as a game has time for
    auto started = preset ? fumage::LiveScene::start(scene, {.stepsPerSecond = 60, .budgetMs = 8.0}) : preset.error();
    SDL_Window* window = nullptr;
    if (!started || SDL_Init(SDL_INIT_VIDEO) != 0
        || (window = SDL_CreateWindow("Smoke", 0, 0, kEdge, kEdge, 0)) == nullptr) {
        std::cerr << (started ? SDL_GetError() : started.error().text()) << '\n';
        return 1;
    }
    const int frames = count > 3 ? std::atoi(arguments[2]) : 0;
    SDL_Renderer* const screen = SDL_CreateSoftwareRenderer(SDL_GetWindowSurface(window));
    SDL_SetRenderDrawColor(screen, 40, 60, 90, 255);
    SDL_Texture* const disc = softDisc(screen);
    fumage::LiveScene& smoke = started.value();
    fumage::Renderer renderer;
    const fumage::View view = fumage::makeView(scene.camera, 0.0F, kEdge, kEdge);
    const fumage::Projected foot = fumage::project(view, scene.layers.front().emitter.position);
    bool goesOn = true;
    for (int frame = 1; goesOn; ++frame) {
        goesOn = frame != frames;
        SDL_Point pointer{static_cast<int>(foot.x + 0.2 * kEdge * std::sin(0.05 * frame)), static_cast<int>(foot.y)};
        for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
            goesOn = goesOn && event.type != SDL_QUIT;
            const SDL_Keycode key = event.type == SDL_KEYDOWN ? event.key.keysym.sym : SDLK_UNKNOWN;
            scene.wind.strength += 0.5F * static_cast<float>((key == SDLK_RIGHT ? 1 : 0) - (key == SDLK_LEFT ? 1 : 0));
        }
        if (frames == 0) {
            SDL_GetMouseState(&pointer.x, &pointer.y);
            SDL_Delay(16);
        }
        const glm::vec3 aside = view.right * static_cast<float>(pointer.x - kEdge / 2)
            - view.up * static_cast<float>(pointer.y - kEdge / 2);
        (void)smoke.setScene(scene);
        (void)smoke.setEmitters({view.eye + foot.depth * (view.forward + aside / view.focal),
            scene.layers.front().emitter.normal, glm::vec3(0.0F)});
        (void)smoke.step(1.0 / 60.0);
        (void)renderer.prepare(smoke.frames(), view);
        const std::vector<SDL_Vertex> triangles = trianglesOf(renderer, smoke.frames().size());
        SDL_RenderClear(screen);
        SDL_RenderGeometry(screen, disc, triangles.data(), static_cast<int>(triangles.size()), nullptr, 0);
        SDL_RenderPresent(screen);
        SDL_UpdateWindowSurface(window);
    }
    return frames == 0 || SDL_SaveBMP(SDL_GetWindowSurface(window), arguments[3]) == 0 ? 0 : 1;
}
