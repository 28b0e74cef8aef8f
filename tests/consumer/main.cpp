#include "core/preset/library.h"
#include "core/rendering/renderer.h"
#include "core/simulation/simulator.h"

int main()
{
    fumage::Effect effect = fumage::loadPreset(std::string("thesis-2012")).value().preset.effect;
    fumage::Simulator simulator(effect);
    fumage::Renderer renderer;
    fumage::Image image;
    return renderer.render(*simulator.frame(10).value(), effect, 64, 64, image).ok() ? 0 : 1;
}
