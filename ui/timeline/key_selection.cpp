#include "ui/timeline/key_selection.h"

#include "ui/timeline/key_drag.h"

#include <algorithm>

namespace fumage::ui {

KeySelection::KeySelection(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::effectChanged, this, &KeySelection::sync);
    connect(&document, &Document::selectionChanged, this, &KeySelection::sync);
    sync();
}

const Track* KeySelection::track(const Parameter& parameter) const
{
    const auto at = std::find_if(
        m_tracks.begin(), m_tracks.end(), [&](const Track& track) { return track.parameter == &parameter; });
    return at == m_tracks.end() ? nullptr : &*at;
}

bool KeySelection::isThere(const KeyPlace& key) const
{
    const Track* track = this->track(*key.parameter);
    return track != nullptr && keyIndex(*track, key.seconds) < track->keys.size();
}

bool KeySelection::contains(const KeyPlace& key) const
{
    return std::find(m_keys.begin(), m_keys.end(), key) != m_keys.end();
}

void KeySelection::select(const std::vector<KeyPlace>& keys)
{
    std::vector<KeyPlace> once;
    std::vector<const Parameter*> shown;
    for (const KeyPlace& key : keys) {
        if (!isThere(key)) { // of a locked layer nothing has moved
            continue;
        }
        if (std::find(once.begin(), once.end(), key) == once.end()) {
            once.push_back(key);
        }
        if (std::find(shown.begin(), shown.end(), key.parameter) == shown.end()) {
            shown.push_back(key.parameter);
        }
    }
    const bool areShown =
        std::all_of(shown.begin(), shown.end(), [this](const Parameter* parameter) { return isShown(*parameter); });
    if (once == m_keys && areShown) {
        return;
    }
    m_keys = std::move(once);
    if (!m_keys.empty()) { // who selects keys of some of the curves wants to see the others still
        m_shown = areShown ? this->shown() : shown;
    }
    emit changed();
}

void KeySelection::press(const KeyPlace& key, Qt::KeyboardModifiers modifiers)
{
    const bool toggles = modifiers.testFlag(Qt::ControlModifier);
    std::vector<KeyPlace> keys = m_keys;
    if (contains(key)) {
        if (toggles) {
            std::erase(keys, key);
        }
    } else {
        if (!toggles && !modifiers.testFlag(Qt::ShiftModifier)) {
            keys.clear();
        }
        keys.push_back(key);
    }
    select(keys);
}

std::vector<const Parameter*> KeySelection::shown() const
{
    std::vector<const Parameter*> shown;
    for (const Track& track : m_tracks) {
        if (std::find(m_shown.begin(), m_shown.end(), track.parameter) != m_shown.end()) {
            shown.push_back(track.parameter);
        }
    }
    if (shown.empty() && !m_tracks.empty()) {
        shown.push_back(m_tracks.front().parameter);
    }
    return shown;
}

bool KeySelection::isShown(const Parameter& parameter) const
{
    const std::vector<const Parameter*> all = shown();
    return std::find(all.begin(), all.end(), &parameter) != all.end();
}

void KeySelection::show(const Parameter& parameter, bool toggles)
{
    std::vector<const Parameter*> now;
    if (toggles) {
        now = shown();
        if (isShown(parameter) && now.size() > 1) {
            std::erase(now, &parameter);
        } else if (!isShown(parameter)) {
            now.push_back(&parameter);
        }
    } else {
        now = {&parameter};
    }
    if (now != m_shown) {
        m_shown = std::move(now);
        emit changed();
    }
}

void KeySelection::sync()
{
    const Tracks tracks = m_document.scene().allTracks(m_document.layer());
    std::vector<Track> now(tracks.all().begin(), tracks.all().end());
    if (now == m_tracks) {
        return;
    }
    m_tracks = std::move(now);
    std::erase_if(m_keys, [this](const KeyPlace& key) { return !isThere(key); });
    emit tracksChanged();
}

} // namespace fumage::ui
