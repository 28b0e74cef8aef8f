#pragma once

#include "core/scene/scene.h"

#include <QDir>
#include <QImage>

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
    /// Removes those that were not looked at for longest, down to a number that a large library needs.
    void prune() const;

    /// In the user's cache.
    [[nodiscard]] static QDir usualFolder();

private:
    [[nodiscard]] QString pathOf(const Scene& scene, int edge) const;

    QDir m_folder;
};

} // namespace fumage::ui
