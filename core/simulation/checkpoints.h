#pragma once

#include "core/simulation/frame.h"

#include <map>
#include <memory>

namespace fumage {

/// Frames that are kept so that a jump need not start a lifetime earlier. They change only the time that a frame takes.
class Checkpoints {
public:
    /// @param bytes that the kept frames may take together; 0 keeps none
    explicit Checkpoints(std::size_t bytes)
        : m_bytes(bytes)
    {
    }

    /// Keeps the frame if it lies far enough from the others; where memory is short, the frame farthest from it goes.
    /// @param spacing frames between checkpoints, 1 or more
    void offer(const std::shared_ptr<const Frame>& frame, int spacing);

    /// @return the last frame at or before a number, or nullptr
    [[nodiscard]] std::shared_ptr<const Frame> nearestBefore(int number) const;

private:
    std::size_t m_bytes;
    std::map<int, std::shared_ptr<const Frame>> m_frames;
};

} // namespace fumage
