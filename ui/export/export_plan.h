#pragma once

#include "core/export/flipbook.h"

#include <QString>

namespace fumage::ui {

/// What can be written.
enum class ExportKind {
    Sequence, ///< a picture for every frame of a range
    Flipbook, ///< frames of a range side by side in one picture
    Picture, ///< one frame
    NoiseTexture, ///< one tile, as particles read it
    Particles, ///< where they are at one frame
};

enum class ParticleFormat {
    Csv,
    Ply,
};

/// All that decides what an export writes, but for the effect.
struct ExportPlan {
    ExportKind kind = ExportKind::Sequence;
    ImageFormat format = ImageFormat::Png8;
    ParticleFormat particles = ParticleFormat::Csv;
    QString path; ///< with # for the frame number in a sequence
    FrameRange frames;
    int columns = 8; ///< of a flipbook
    int rows = 8;
};

/// The ending of the files that a plan writes, with its dot.
[[nodiscard]] QString endingOf(const ExportPlan& plan);

/// The files of a plan, first and last.
[[nodiscard]] QString firstFileOf(const ExportPlan& plan);
[[nodiscard]] QString lastFileOf(const ExportPlan& plan);

/// Writes everything. On the calling thread.
/// @param progress called after each file or cell
/// @return what the artist should know of the result; empty: nothing
[[nodiscard]] Result<QString> runExport(const Effect& effect, const ExportPlan& plan, const SequenceProgress& progress, const std::stop_token& stop);

} // namespace fumage::ui
