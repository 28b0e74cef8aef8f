#include "ui/preview/picture_cache.h"

#include <tuple>

namespace fumage::ui {

namespace {

qint64 bytesOf(const Picture& picture)
{
    const std::size_t sprites = picture.sprites ? picture.sprites->sprites.size() * sizeof(Sprite) : 0;
    return picture.image.sizeInBytes() + static_cast<qint64>(sprites);
}

/// Pictures that are compared are made for one size of the screen.
std::tuple<bool, bool, int, int> gradeOf(const Picture& picture)
{
    return {picture.complete, !picture.thinned, picture.thinned ? picture.particles : 0, picture.image.width()};
}

} // namespace

bool isBetter(const Picture& picture, const Picture& other)
{
    return gradeOf(picture) > gradeOf(other);
}

PicturePtr PictureCache::find(int frame) const
{
    const auto found = m_pictures.find(frame);
    return found == m_pictures.end() ? nullptr : found->second;
}

QList<int> PictureCache::frames() const
{
    QList<int> frames;
    for (const auto& [frame, picture] : m_pictures) {
        frames.append(frame);
    }
    return frames;
}

void PictureCache::keep(const PicturePtr& picture)
{
    const PicturePtr known = find(picture->frame);
    if (known && isBetter(*known, *picture)) {
        return;
    }
    const qint64 room = m_room + (known ? bytesOf(*known) : 0) - bytesOf(*picture);
    if (room >= 0) {
        m_room = room;
        m_pictures[picture->frame] = picture;
    }
}

void PictureCache::clear()
{
    for (const auto& [frame, picture] : m_pictures) {
        m_room += bytesOf(*picture);
    }
    m_pictures.clear();
}

void PictureCache::setRoom(qint64 bytes)
{
    m_pictures.clear();
    m_room = bytes;
}

} // namespace fumage::ui
