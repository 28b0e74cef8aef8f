#pragma once

#include "core/export/plan.h"

#include <QStringList>

#include <optional>

namespace fumage::ui {

/// A kind in words.
[[nodiscard]] QString kindName(ExportKind kind);

/// The formats of a kind in words, in the order of ImageFormat, VideoFormat, ParticleFormat or AirFormat.
[[nodiscard]] QStringList formatsOf(ExportKind kind);

/// The format that the ending of a path asks for, as an ImageFormat, VideoFormat, ParticleFormat or AirFormat; nothing
/// where it asks for none of this kind.
[[nodiscard]] std::optional<int> formatNamedBy(const QString& path, ExportKind kind);

/// The same path for another format: its ending goes, where it is one that exports have, and the plan's comes.
[[nodiscard]] QString withEndingOf(const ExportPlan& plan, const QString& path);

/// Where the format of a kind is remembered, below kExportKinds: all images share one.
[[nodiscard]] std::size_t placeOfFormat(ExportKind kind);
/// Which of formatsOf() its kind a plan has.
[[nodiscard]] int formatOf(const ExportPlan& plan);
void setFormat(ExportPlan& plan, int format);

} // namespace fumage::ui
