#include "core/rendering/image.h"

#include "core/base/parallel.h"

namespace fumage {

Image downsample(const Image& image, int factor, const std::stop_token& stop)
{
    Image out;
    out.resize(image.width / factor, image.height / factor);
    const float share = 1.0F / static_cast<float>(factor * factor);
    parallelFor(static_cast<std::size_t>(out.height), [&](std::size_t y) {
        const int width = stop.stop_requested() ? 0 : out.width;
        float* to = out.row(static_cast<int>(y));
        for (int x = 0; x < width; ++x, to += 4) {
            for (int channel = 0; channel < 4; ++channel) {
                float sum = 0.0F;
                for (int j = 0; j < factor; ++j) {
                    const float* from =
                        image.row(static_cast<int>(y) * factor + j) + static_cast<std::size_t>(x * factor) * 4;
                    for (int i = 0; i < factor; ++i) {
                        sum += from[i * 4 + channel];
                    }
                }
                to[channel] = sum * share;
            }
        }
    });
    return out;
}

} // namespace fumage
