#include "ui/export/export_formats.h"

#include "core/export/output_name.h"
#include "ui/document/text.h"

#include <algorithm>
#include <array>

#include <QCoreApplication>

namespace fumage::ui {

namespace {

/// The first of some formats whose files end so.
template <class Formats>
std::optional<int> withEnding(std::string_view ending, const Formats& formats)
{
    const auto found = std::ranges::find(formats, ending, [](auto format) { return fileEnding(format); });
    return found == std::ranges::end(formats) ? std::nullopt : std::optional(static_cast<int>(*found));
}

} // namespace

QString kindName(ExportKind kind)
{
    switch (kind) {
    case ExportKind::Sequence: return QCoreApplication::translate("Exports", "Image sequence");
    case ExportKind::Flipbook: return QCoreApplication::translate("Exports", "Flipbook");
    case ExportKind::Video: return QCoreApplication::translate("Exports", "Video");
    case ExportKind::Picture: return QCoreApplication::translate("Exports", "Single picture");
    case ExportKind::NoiseTexture: return QCoreApplication::translate("Exports", "Noise texture");
    case ExportKind::Particles: return QCoreApplication::translate("Exports", "Particles");
    case ExportKind::Volumes: return QCoreApplication::translate("Exports", "Volumes");
    case ExportKind::Air: return QCoreApplication::translate("Exports", "Air as a vector field");
    }
    return {};
}

QStringList formatsOf(ExportKind kind)
{
    switch (kind) {
    case ExportKind::Particles:
        return {QCoreApplication::translate("Exports", "CSV, one particle a line"),
            QCoreApplication::translate("Exports", "PLY, binary points"),
            QCoreApplication::translate("Exports", "Point cache for Unity, binary")};
    case ExportKind::Volumes: return {QCoreApplication::translate("Exports", "OpenVDB, half floats")};
    case ExportKind::Air:
        return {QCoreApplication::translate("Exports", "FGA for Unreal"),
            QCoreApplication::translate("Exports", "Volume File for Unity")};
    case ExportKind::Video:
        return {QCoreApplication::translate("Exports", "MP4 (H.264), on the background colour"),
            QCoreApplication::translate("Exports", "WebM (VP9), transparent"),
            QCoreApplication::translate("Exports", "QuickTime (ProRes 4444), transparent"),
            QCoreApplication::translate("Exports", "GIF, on the background colour"),
            QCoreApplication::translate("Exports", "APNG, transparent")};
    default:
        return {QCoreApplication::translate("Exports", "PNG, 8 bits"),
            QCoreApplication::translate("Exports", "PNG, 16 bits"),
            QCoreApplication::translate("Exports", "OpenEXR, half floats, linear"),
            QCoreApplication::translate("Exports", "OpenEXR, floats, linear"),
            QCoreApplication::translate("Exports", "TGA, 8 bits")};
    }
}

std::size_t placeOfFormat(ExportKind kind)
{
    return static_cast<std::size_t>(isImage(kind) ? ExportKind::Sequence : kind);
}

int formatOf(const ExportPlan& plan)
{
    switch (plan.kind) {
    case ExportKind::Particles: return static_cast<int>(plan.particles);
    case ExportKind::Video: return static_cast<int>(plan.video.format);
    case ExportKind::Air: return static_cast<int>(plan.air);
    case ExportKind::Volumes: return 0; // there is one
    default: return static_cast<int>(plan.format);
    }
}

void setFormat(ExportPlan& plan, int format)
{
    switch (plan.kind) {
    case ExportKind::Particles: plan.particles = static_cast<ParticleFormat>(format); break;
    case ExportKind::Video: plan.video.format = static_cast<VideoFormat>(format); break;
    case ExportKind::Air: plan.air = static_cast<AirFormat>(format); break;
    case ExportKind::Volumes: break;
    default: plan.format = static_cast<ImageFormat>(format); break;
    }
}

std::optional<int> formatNamedBy(const QString& path, ExportKind kind)
{
    const std::string ending = endingOf(toPath(path));
    switch (kind) {
    case ExportKind::Particles: return withEnding(ending, kAllParticleFormats);
    case ExportKind::Volumes: return ending == kVdbEnding ? std::optional(0) : std::nullopt;
    case ExportKind::Air: return withEnding(ending, kAllAirFormats);
    case ExportKind::Video: return withEnding(ending, kAllVideoFormats);
    default: return withEnding(ending, std::array{ImageFormat::Png8, ImageFormat::ExrHalf, ImageFormat::Tga});
    }
}

QString withEndingOf(const ExportPlan& plan, const QString& path)
{
    constexpr std::array kWithFormats{
        ExportKind::Picture, ExportKind::Particles, ExportKind::Volumes, ExportKind::Air, ExportKind::Video};
    if (std::ranges::none_of(kWithFormats, [&](ExportKind kind) { return formatNamedBy(path, kind).has_value(); })) {
        return path;
    }
    return path.left(path.lastIndexOf(QLatin1Char('.'))) + toQString(fileEnding(plan));
}

} // namespace fumage::ui
