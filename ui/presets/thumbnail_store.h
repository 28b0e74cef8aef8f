#pragma once

#include "core/scene/scene.h"

#include <QDir>
#include <QFileInfo>
#include <QImage>

#include <limits>
#include <vector>

namespace fumage::ui {

/// Small pictures of effects, kept on disk from one start to the next. What is asked for is found by its content: an
/// effect that is changed, another size or another build of the program are other pictures. Several programs may use
/// one folder at a time.
class ThumbnailStore {
public:
    /// @param folder made when something is put in
    explicit ThumbnailStore(const QDir& folder)
        : m_folder(folder)
    {
    }

    /// @return null: there is none
    [[nodiscard]] QImage find(const Scene& scene, int edge) const;
    /// A picture that cannot be kept is rendered again next time: nobody needs to know.
    void put(const Scene& scene, int edge, const QImage& image) const;
    /// The same of what moves: pictures of one size, side by side in one file.
    /// @return empty: there is none
    [[nodiscard]] std::vector<QImage> findLoop(const Scene& scene, int edge, int frames) const;
    void putLoop(const Scene& scene, int edge, const std::vector<QImage>& loop) const;
    /// Removes those that were not looked at for longest, down to a number that a large library needs.
    /// @param mostBytes that all of them may take on the disk
    void prune(qint64 mostBytes = std::numeric_limits<qint64>::max()) const;
    /// What they take on the disk, bytes. O(files)
    [[nodiscard]] qint64 size() const;
    /// Removes all of them; they are rendered again when they are seen.
    void clear() const;

    /// In the user's cache.
    [[nodiscard]] static QDir usualFolder();

private:
    [[nodiscard]] QFileInfoList newestFirst() const;
    /// @param frames of a loop; 1: of a picture that stands still
    [[nodiscard]] QString pathOf(const Scene& scene, int edge, int frames = 1) const;
    /// @param size that it must have @return null: there is none
    [[nodiscard]] static QImage read(const QString& path, const QSize& size);
    void write(const QString& path, const QImage& image) const;

    QDir m_folder;
};

} // namespace fumage::ui
