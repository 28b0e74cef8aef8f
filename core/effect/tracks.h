#pragma once

#include "core/effect/track.h"

#include <span>
#include <vector>

namespace fumage {

/// What changes over time of a layer, or of what all layers share: one track a parameter at most.
class Tracks {
public:
    /// In the order of the table.
    [[nodiscard]] std::span<const Track> all() const { return m_tracks; }
    [[nodiscard]] bool empty() const { return m_tracks.empty(); }
    /// @return the track of a parameter; null: it does not change
    [[nodiscard]] const Track* find(const Parameter& parameter) const;
    /// Puts a track in, in place of one of the same parameter; one without keys takes it out.
    /// @param track that checkTrack() finds nothing wrong with
    void set(Track track);
    /// Adds those of others, in place of those of the same parameters.
    void add(const Tracks& others);

    /// Writes the values at a time of all that are read in one way.
    /// @param seconds since frame 0; times before it are read as 0
    void read(Animates when, double seconds, Effect& out) const;
    /// Whether anything changes that is read in one way.
    [[nodiscard]] bool any(Animates when) const;

    friend bool operator==(const Tracks&, const Tracks&) = default;

private:
    std::vector<Track> m_tracks;
};

} // namespace fumage
