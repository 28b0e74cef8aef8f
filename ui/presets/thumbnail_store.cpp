#include "ui/presets/thumbnail_store.h"

#include "core/preset/preset_file.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QPainter>
#include <QSaveFile>
#include <QStandardPaths>

namespace fumage::ui {

QDir ThumbnailStore::usualFolder()
{
    return QDir(
        QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + QStringLiteral("/fumage/thumbnails"));
}

QString ThumbnailStore::pathOf(const Scene& scene, int edge, int frames) const
{
    Preset preset;
    preset.scene = scene;
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(QByteArray::fromStdString(formatPreset(preset)));
    hash.addData(QByteArray::number(edge));
    if (frames > 1) {
        hash.addData("x" + QByteArray::number(frames));
    }
    hash.addData(
        QByteArray::number(QFileInfo(QCoreApplication::applicationFilePath()).lastModified().toMSecsSinceEpoch()));
    return m_folder.filePath(QString::fromLatin1(hash.result().toHex()) + QStringLiteral(".png"));
}

QImage ThumbnailStore::find(const Scene& scene, int edge) const
{
    return read(pathOf(scene, edge), {edge, edge});
}

QImage ThumbnailStore::read(const QString& path, const QSize& size)
{
    QImage image(path);
    if (image.size() != size) {
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
    write(pathOf(scene, edge), image);
}

void ThumbnailStore::write(const QString& path, const QImage& image) const
{
    QSaveFile file(path);
    if (m_folder.mkpath(QStringLiteral(".")) && file.open(QIODevice::WriteOnly) && image.save(&file, "PNG")) {
        file.commit();
    }
}

std::vector<QImage> ThumbnailStore::findLoop(const Scene& scene, int edge, int frames) const
{
    const QImage strip = read(pathOf(scene, edge, frames), {edge * frames, edge});
    std::vector<QImage> loop;
    for (int i = 0; i < frames && !strip.isNull(); ++i) {
        loop.push_back(strip.copy(i * edge, 0, edge, edge));
    }
    return loop;
}

void ThumbnailStore::putLoop(const Scene& scene, int edge, const std::vector<QImage>& loop) const
{
    const auto frames = static_cast<int>(loop.size());
    QImage strip(edge * frames, edge, QImage::Format_RGB32);
    QPainter painter(&strip);
    for (int i = 0; i < frames; ++i) {
        painter.drawImage(i * edge, 0, loop[static_cast<std::size_t>(i)]);
    }
    painter.end();
    write(pathOf(scene, edge, frames), strip);
}

QFileInfoList ThumbnailStore::newestFirst() const
{
    QDir folder = m_folder;
    folder.refresh(); // others write into it, too
    return folder.entryInfoList({QStringLiteral("*.png")}, QDir::Files, QDir::Time);
}

void ThumbnailStore::prune(qint64 mostBytes) const
{
    constexpr int kKept = 400;
    int files = 0;
    qint64 bytes = 0;
    for (const QFileInfo& file : newestFirst()) {
        bytes += file.size();
        if (++files > kKept || bytes > mostBytes) {
            QFile::remove(file.filePath());
        }
    }
}

qint64 ThumbnailStore::size() const
{
    qint64 bytes = 0;
    for (const QFileInfo& file : newestFirst()) {
        bytes += file.size();
    }
    return bytes;
}

void ThumbnailStore::clear() const
{
    for (const QFileInfo& file : newestFirst()) {
        QFile::remove(file.filePath());
    }
}

} // namespace fumage::ui
