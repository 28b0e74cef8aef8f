#pragma once

#include "core/rendering/framing.h"

#include <cstdint>
#include <vector>

namespace fumage {

/// Where in pictures of one size smoke is seen, and how much of it: over all of them, and where in each.
class SmokeTally {
public:
    /// @param alpha what is less than this is not seen
    SmokeTally(int width, int height, float alpha);

    /// Takes in a picture. Each pixel weighs what is seen of it: its alpha, or the strongest of its premultiplied
    /// colours where that is more, as it is with light that is added; 1 at most, in steps of 1/65535, so that sums have
    /// no order.
    /// @param image of this size
    /// About 2 KB of memory.
    void add(const Image& image);

    [[nodiscard]] PictureReach whole() const { return {.left = 0, .right = m_width, .top = 0, .bottom = m_height}; }
    /// Where smoke is seen in one of the pictures, within a rectangle.
    /// @param index below how many were added
    [[nodiscard]] PictureReach reachIn(std::size_t index, const PictureReach& within) const;
    /// Of all pictures together, in 1/65535, row-major, origin top-left.
    [[nodiscard]] const std::vector<std::uint64_t>& weights() const { return m_weights; }

private:
    /// Pixels side by side that are seen.
    struct Run {
        int row;
        int begin;
        int end;
    };
    int m_width;
    int m_height;
    float m_alpha;
    std::vector<std::uint64_t> m_weights;
    std::vector<std::vector<Run>> m_runs; ///< of each picture
};

/// A rectangle without outliers.
struct OutlierCut {
    PictureReach reach;
    double lost = 0.0; ///< share of the smoke that is outside
};

/// Finds the rectangle that smoke fills when a small share of it may be outside.
///
/// Strips of lines are cut off a side, each time the one that makes the rectangle smallest for what it costs: the
/// largest (lines / lines of the picture) / (weight), which is all that is empty, then a stray spark and the void
/// before it, then the thin rim of the smoke. It ends before the one that would cost more than is left, so that what a
/// larger share leaves is within what a smaller one does.
/// @param window where smoke counts
/// @param share  of the smoke in the window that may be cut, 0 to most
/// @param most   no strip is looked at that goes beyond this share, whatever the other is
/// @return       empty where there is no smoke; of share 0 the box of what is seen
/// O((width + height)^2).
[[nodiscard]] OutlierCut cutOutliers(const SmokeTally& tally, const PictureReach& window, double share, double most);

/// How much smoke lies how far from the eye.
class DepthTally {
public:
    DepthTally();

    /// @param depth  m, more than 0
    /// @param weight 0 or more
    void add(float depth, double weight);
    /// Moves depths to where all but a share of what was added lies at either end.
    /// @param share 0 to less than 1/2
    /// @return      the range as it is where nothing was added
    [[nodiscard]] DepthRange without(const DepthRange& range, double share) const;

private:
    std::vector<double> m_weights; ///< by depth, in steps of 1/64
    double m_total = 0.0;
};

} // namespace fumage
