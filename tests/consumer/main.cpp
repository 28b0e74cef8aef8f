#include <fumage/preset/library.h>
#include <fumage/rendering/renderer.h>
#include <fumage/simulation/simulator.h>
#include <fumage/version.h>

#include <iostream>

#if FUMAGE_VERSION_MAJOR * 10000 + FUMAGE_VERSION_MINOR * 100 + FUMAGE_VERSION_PATCH < 1
#error "the version is not told"
#endif

int main()
{
    const fumage::SampledEffect effect =
        fumage::sampled(fumage::loadPreset(std::string("thesis-2012")).value().preset.scene.effect());
    fumage::Simulator simulator(effect);
    fumage::Renderer renderer;
    fumage::Image image;
    std::cout << "Fumage " << FUMAGE_VERSION << '\n';
    return renderer.render(*simulator.frame(10).value(), effect, 64, 64, image).ok() ? 0 : 1;
}
