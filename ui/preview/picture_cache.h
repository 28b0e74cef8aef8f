#pragma once

#include "ui/preview/picture.h"

#include <QList>

#include <map>

namespace fumage::ui {

/// Whether one picture of a frame gives up less than another of the same revision: nothing, or at least no particles,
/// or fewer of them, or fewer pixels.
[[nodiscard]] bool isBetter(const Picture& picture, const Picture& other);

/// The pictures of an effect by frame, the best of each, as many as there is room for.
class PictureCache {
public:
    explicit PictureCache(qint64 bytes)
        : m_room(bytes)
    {
    }

    /// Null where there is none.
    [[nodiscard]] PicturePtr find(int frame) const;
    /// In order.
    [[nodiscard]] QList<int> frames() const;

    /// Keeps a picture in place of a worse one of its frame. Where there is no room for it, what is there stays: a loop
    /// that is longer than the cache would push out each frame just before it is shown again.
    void keep(const PicturePtr& picture);
    void clear();
    /// Forgets what it has.
    void setRoom(qint64 bytes);

private:
    qint64 m_room; ///< bytes that are left
    std::map<int, PicturePtr> m_pictures;
};

} // namespace fumage::ui
