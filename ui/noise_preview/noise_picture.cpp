#include "ui/noise_preview/noise_picture.h"

#include "core/lighting/sprite_mask.h"

#include <algorithm>
#include <cmath>

namespace fumage::ui {

namespace {

void applyMask(const Look& look, NoiseTile& tile)
{
    const auto edge = static_cast<float>(tile.size);
    for (int y = 0; y < tile.size; ++y) {
        for (int x = 0; x < tile.size; ++x) {
            float& value = tile.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.size)
                + static_cast<std::size_t>(x)];
            const float grey = 1.0F - look.texture + look.texture * value;
            value = grey
                * maskAt(look, (static_cast<float>(x) + 0.5F) / edge * 2.0F - 1.0F,
                    (static_cast<float>(y) + 0.5F) / edge * 2.0F - 1.0F);
        }
    }
}

/// Octave sums lie about 0; shown about middle grey.
void centre(NoiseTile& tile)
{
    for (float& value : tile.values) {
        value = std::clamp(0.5F + 0.5F * value, 0.0F, 1.0F);
    }
}

Result<NoiseTile> bake(const NoiseRequest& request, const std::stop_token& stop)
{
    Noise noise = request.noise;
    if (request.plain) {
        noise.smooth = 0.0F;
        noise.sharpness = 1.0F;
    }
    if (request.channel != NoiseChannel::Fractal) {
        return bakeNoise(noise, request.size, request.depth, stop);
    }
    Result<NoiseTile> tile = bakeFractal(noise, request.size, request.depth, stop);
    if (tile) {
        centre(tile.value());
    }
    return tile;
}

void measure(NoisePicture& picture)
{
    double sum = 0.0;
    double squares = 0.0;
    const auto bins = static_cast<float>(picture.histogram.size());
    for (const float value : picture.tile.values) {
        sum += static_cast<double>(value);
        squares += static_cast<double>(value) * static_cast<double>(value);
        ++picture.histogram[static_cast<std::size_t>(std::clamp(value * bins, 0.0F, bins - 1.0F))];
    }
    const auto count = static_cast<double>(picture.tile.values.size());
    picture.mean = sum / count;
    picture.deviation = std::sqrt(std::max(0.0, squares / count - picture.mean * picture.mean));
}

QImage toImage(const NoiseTile& tile)
{
    QImage image(tile.size, tile.size, QImage::Format_Grayscale8);
    if (image.isNull()) {
        throw std::bad_alloc();
    }
    for (int y = 0; y < tile.size; ++y) {
        // Rows of the tile go up, those of the screen down.
        uchar* row = image.scanLine(tile.size - 1 - y);
        for (int x = 0; x < tile.size; ++x) {
            row[x] = static_cast<uchar>(std::lround(tile.at(x, y) * 255.0F));
        }
    }
    return image;
}

} // namespace

NoisePicturePtr makeNoisePicture(const NoiseRequest& request, const std::stop_token& stop)
{
    Result<NoiseTile> tile = bake(request, stop);
    if (!tile) {
        return nullptr;
    }
    auto picture = std::make_shared<NoisePicture>();
    picture->tile = std::move(tile).value();
    if (request.channel == NoiseChannel::Alpha) {
        applyMask(request.look, picture->tile);
    }
    measure(*picture);
    picture->image = toImage(picture->tile);
    picture->serial = request.serial;
    return picture;
}

NoiseWorker::NoiseWorker(QObject* parent)
    : QObject(parent)
    , m_job(
          [this](const NoiseRequest& request, const std::stop_token& stop) {
              if (NoisePicturePtr picture = makeNoisePicture(request, stop)) {
                  QMetaObject::invokeMethod(
                      this, [this, picture = std::move(picture)] { emit ready(picture); }, Qt::QueuedConnection);
              }
          },
          [this](const NoiseRequest&, const Error& why) {
              QMetaObject::invokeMethod(
                  this, [this, why] { why.code == ErrorCode::OutOfMemory ? emit exhausted() : emit failed(why); },
                  Qt::QueuedConnection);
          })
{
}

} // namespace fumage::ui
