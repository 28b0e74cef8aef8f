#include "core/export/sheet.h"

#include "core/simulation/simulator.h"

namespace fumage {

namespace {

void place(const Image& cell, Image& sheet, const SheetCell& at)
{
    for (int y = 0; y < cell.height; ++y) {
        std::copy_n(cell.row(y), static_cast<std::size_t>(cell.width) * 4, sheet.row(at.top + y) + static_cast<std::size_t>(at.left) * 4);
    }
}

/// Hands out each frame with those beside it, and simulates none twice.
class Neighbours {
public:
    Neighbours(const SampledEffect& effect, const std::vector<int>& frames, bool wanted)
        : m_simulator(effect)
        , m_frames(frames)
        , m_wanted(wanted)
    {
    }

    /// @param cell the next one
    [[nodiscard]] Result<FrameAmongOthers> at(std::size_t cell, const std::stop_token& stop, const Progress& progress)
    {
        m_previous = m_wanted ? std::move(m_now) : nullptr;
        m_now = std::move(m_next);
        if (!m_now) {
            if (Status status = fetch(m_frames[cell], m_now, stop, progress); !status) {
                return status.error();
            }
        }
        const int after = numberAfter(cell);
        if (m_wanted) {
            if (Status status = fetch(after, m_next, stop, progress); !status) {
                return status.error();
            }
        }
        return FrameAmongOthers{m_now.get(), m_previous.get(), m_next.get(), cell == 0 ? 1 : m_frames[cell] - m_frames[cell - 1], after - m_frames[cell]};
    }

private:
    [[nodiscard]] int numberAfter(std::size_t cell) const
    {
        if (cell + 1 < m_frames.size()) {
            return m_frames[cell + 1];
        }
        return m_frames[cell] + (cell > 0 ? m_frames[cell] - m_frames[cell - 1] : 1);
    }
    [[nodiscard]] Status fetch(int number, std::shared_ptr<const Frame>& to, const std::stop_token& stop, const Progress& progress)
    {
        Result<std::shared_ptr<const Frame>> frame = m_simulator.frame(number, stop, progress);
        if (!frame) {
            return frame.error();
        }
        to = std::move(frame).value();
        return Done{};
    }

    Simulator m_simulator;
    const std::vector<int>& m_frames;
    bool m_wanted;
    std::shared_ptr<const Frame> m_previous;
    std::shared_ptr<const Frame> m_now;
    std::shared_ptr<const Frame> m_next;
};

} // namespace

Status renderSheet(const Effect& effect, const std::vector<int>& frames, int columns, PassSet passes, PassSheet& sheet, const CellWatch& watch, const Progress& progress, const std::stop_token& stop)
{
    const SampledEffect smoke = sampled(effect);
    const int cells = static_cast<int>(frames.size());
    const int rows = (cells + columns - 1) / columns;
    sheet.grid = {columns, cells, effect.output.width, effect.output.height};
    for (std::size_t i = 0; i < kPassLayers; ++i) {
        if (needsLayer(passes, static_cast<PassLayer>(i))) {
            sheet.layers.layers[i].resize(sheet.grid.cellWidth * columns, sheet.grid.cellHeight * rows);
        }
    }
    Neighbours neighbours(smoke, frames, passes.has(Pass::Motion));
    PassRenderer renderer;
    PassImages cell;
    for (int number = 0; number < cells; ++number) {
        const Result<FrameAmongOthers> frame = neighbours.at(static_cast<std::size_t>(number), stop, progress);
        if (!frame) {
            return frame.error();
        }
        if (Status status = renderer.render(frame.value(), smoke, sheet.grid.cellWidth, sheet.grid.cellHeight, passes, cell, stop); !status) {
            return status;
        }
        if (watch) {
            watch(cell, *frame.value().now, renderer.appearance());
        }
        for (std::size_t i = 0; i < kPassLayers; ++i) {
            place(cell.layers[i], sheet.layers.layers[i], sheet.grid.cell(number));
        }
        progress(Work::Frames, number + 1, cells);
    }
    return Done{};
}

} // namespace fumage
