#include "ui/presets/shipped_thumbnails.h"

#include "core/preset/preset_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QHash>

namespace fumage::ui {

namespace {

constexpr QLatin1String kFolder(":/thumbnails/");

/// The files, by the contents of their presets.
const QHash<QString, QString>& shippedFiles()
{
    static const QHash<QString, QString> files = [] {
        QHash<QString, QString> found;
        const QStringList names = QDir(kFolder).entryList();
        for (const QString& name : names) {
            found.insert(name.section(QLatin1Char('.'), 1, 1), kFolder + name);
        }
        return found;
    }();
    return files;
}

} // namespace

QString contentsOf(const Scene& scene)
{
    constexpr qsizetype kDigits = 16;
    Preset preset;
    preset.scene = scene;
    const QByteArray text = QByteArray::fromStdString(formatPreset(preset));
    return QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex()).left(kDigits);
}

QString shippedThumbnailFile(const QString& id, const Scene& scene)
{
    return id + QLatin1Char('.') + contentsOf(scene) + QStringLiteral(".jpg");
}

bool isThumbnailShipped(const Scene& scene)
{
    return shippedFiles().contains(contentsOf(scene));
}

QImage shippedThumbnail(const Scene& scene, int edge)
{
    const QString file = shippedFiles().value(contentsOf(scene));
    const QImage image = file.isEmpty() ? QImage() : QImage(file);
    return image.isNull() ? image
                          : image.scaled(edge, edge, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                                .convertToFormat(QImage::Format_RGB32);
}

} // namespace fumage::ui
