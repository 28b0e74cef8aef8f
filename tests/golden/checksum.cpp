#include "tests/golden/checksum.h"

#include "core/base/sha256.h"
#include "core/preset/library.h"
#include "core/rendering/scene_renderer.h"

#include <algorithm>
#include <fstream>
#include <span>

namespace fumage::tests {

Scene goldenScene(const std::string& id)
{
    return goldenScene(loadPreset(LibraryEntry{id, {}}).value().preset.scene);
}

Scene goldenScene(const Scene& preset)
{
    constexpr int kEdge = 96;
    constexpr int kGoldenParticles = 20000;
    Scene scene = preset;
    for (Layer& layer : scene.layers) {
        layer.emitter.count = std::min(layer.emitter.count, kGoldenParticles);
    }
    scene.output.width = kEdge;
    scene.output.height = kEdge;
    return scene;
}

Result<Image> goldenPicture(const Scene& scene)
{
    SceneRenderer renderer(scene);
    Image image;
    const Status status = renderer.render(kGoldenFrame, scene.output.width, scene.output.height, image);
    return status ? Result<Image>(std::move(image)) : status.error();
}

std::string goldenLine(const std::string& id, const Image& image)
{
    constexpr std::size_t kDigits = 24;
    return id + " " + sha256Of(std::as_bytes(std::span(image.pixels))).substr(0, kDigits);
}

std::map<std::string, std::string> goldenLines(const std::string& path)
{
    std::map<std::string, std::string> lines;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        lines.emplace(line.substr(0, line.find(' ')), line);
    }
    return lines;
}

} // namespace fumage::tests
