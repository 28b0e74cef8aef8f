#include "ui/presets/thumbnail_store.h"

#include "core/preset/preset_file.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

namespace fumage::ui {

QDir ThumbnailStore::usualFolder()
{
    return QDir(
        QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + QStringLiteral("/fumage/thumbnails"));
}

QString ThumbnailStore::pathOf(const Scene& scene, int edge) const
{
    Preset preset;
    preset.scene = scene;
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(QByteArray::fromStdString(formatPreset(preset)));
    hash.addData(QByteArray::number(edge));
    hash.addData(
        QByteArray::number(QFileInfo(QCoreApplication::applicationFilePath()).lastModified().toMSecsSinceEpoch()));
    return m_folder.filePath(QString::fromLatin1(hash.result().toHex()) + QStringLiteral(".png"));
}

QImage ThumbnailStore::find(const Scene& scene, int edge) const
{
    const QString path = pathOf(scene, edge);
    QImage image(path);
    if (image.size() != QSize(edge, edge)) {
        return {};
    }
    QFile file(path);
    if (file.open(QIODevice::ReadWrite)) {
        file.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime); // was looked at
    }
    return image.convertToFormat(QImage::Format_RGB32);
}

void ThumbnailStore::put(const Scene& scene, int edge, const QImage& image) const
{
    QSaveFile file(pathOf(scene, edge));
    if (m_folder.mkpath(QStringLiteral(".")) && file.open(QIODevice::WriteOnly) && image.save(&file, "PNG")) {
        file.commit();
    }
}

void ThumbnailStore::prune() const
{
    constexpr int kKept = 400;
    const QFileInfoList newestFirst = m_folder.entryInfoList({QStringLiteral("*.png")}, QDir::Files, QDir::Time);
    for (const QFileInfo& file : newestFirst.mid(kKept)) {
        QFile::remove(file.filePath());
    }
}

} // namespace fumage::ui
