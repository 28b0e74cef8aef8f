#include "core/effect/tracks.h"

#include <algorithm>

namespace fumage {

const Track* Tracks::find(const Parameter& parameter) const
{
    const auto at = std::find_if(
        m_tracks.begin(), m_tracks.end(), [&](const Track& track) { return track.parameter == &parameter; });
    return at == m_tracks.end() ? nullptr : &*at;
}

void Tracks::set(Track track)
{
    const auto at = std::find_if(m_tracks.begin(), m_tracks.end(),
        [&](const Track& each) { return each.parameter >= track.parameter; }); // rows lie in the order of the table
    const bool isThere = at != m_tracks.end() && at->parameter == track.parameter;
    if (track.keys.empty()) {
        if (isThere) {
            m_tracks.erase(at);
        }
    } else if (isThere) {
        *at = std::move(track);
    } else {
        m_tracks.insert(at, std::move(track));
    }
}

void Tracks::add(const Tracks& others)
{
    for (const Track& track : others.m_tracks) {
        set(track);
    }
}

void Tracks::read(Animates when, double seconds, Effect& out) const
{
    for (const Track& track : m_tracks) {
        if (track.parameter->animates == when) {
            track.parameter->set(out, track.at(std::max(0.0, seconds)));
        }
    }
}

bool Tracks::any(Animates when) const
{
    return std::any_of(
        m_tracks.begin(), m_tracks.end(), [&](const Track& track) { return track.parameter->animates == when; });
}

} // namespace fumage
