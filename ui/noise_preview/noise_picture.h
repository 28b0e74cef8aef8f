#pragma once

#include "ui/concurrency/latest_only_worker.h"

#include "core/noise/texture.h"

#include <QImage>
#include <QObject>

#include <array>
#include <memory>

namespace fumage::ui {

/// What the noise pane shows of a tile.
enum class NoiseChannel {
    Texture, ///< the grey values that particles read
    Fractal, ///< the sum of octaves before sharpness, coverage and warp
    Alpha, ///< the texture under the mask of a particle: its transparency
};

struct NoiseRequest {
    Noise noise;
    Look look; ///< for the mask
    float depth = 0.0F; ///< slice, in [0, 1)
    int size = 256; ///< pixels of the tile
    NoiseChannel channel = NoiseChannel::Texture;
    bool plain = false; ///< without smoothing and sharpness
    quint64 serial = 0;

    /// Whether two requests ask for the same tile.
    [[nodiscard]] bool asksAs(const NoiseRequest& other) const
    {
        const bool sameMask = channel != NoiseChannel::Alpha || look == other.look;
        return noise == other.noise && depth == other.depth && size == other.size && channel == other.channel
            && plain == other.plain && sameMask;
    }
};

/// A baked tile with all that the pane shows of it.
struct NoisePicture {
    NoiseTile tile; ///< values in [0, 1]
    QImage image; ///< grey
    std::array<int, 64> histogram{}; ///< pixels in each 64th of [0, 1]
    double mean = 0.0;
    double deviation = 0.0;
    quint64 serial = 0;
};
using NoisePicturePtr = std::shared_ptr<const NoisePicture>;

/// @return nothing where it was stopped
[[nodiscard]] NoisePicturePtr makeNoisePicture(const NoiseRequest& request, const std::stop_token& stop);

/// Bakes tiles on a thread of its own; the newest request is the one that counts.
class NoiseWorker : public QObject {
    Q_OBJECT

public:
    explicit NoiseWorker(QObject* parent = nullptr);

    void request(const NoiseRequest& request) { m_job.post(request); }

signals:
    void ready(fumage::ui::NoisePicturePtr picture);
    /// Memory ran out: the picture that was being made does not come.
    void exhausted();
    /// The picture cannot be made.
    void failed(const fumage::Error& why);

private:
    LatestOnlyWorker<NoiseRequest> m_job;
};

} // namespace fumage::ui
