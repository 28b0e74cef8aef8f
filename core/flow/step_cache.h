#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>

namespace fumage {

/// What is kept of some steps within an amount of memory: the one farthest from the newest goes first.
template <class T>
class StepCache {
public:
    /// @param most of them, 1 or more
    explicit StepCache(std::size_t most)
        : m_most(most)
    {
    }

    void keep(std::int64_t step, std::shared_ptr<const T> what)
    {
        m_steps.insert_or_assign(step, std::move(what));
        while (m_steps.size() > m_most) {
            const bool firstIsFarther = step - m_steps.begin()->first > m_steps.rbegin()->first - step;
            m_steps.erase(firstIsFarther ? m_steps.begin() : std::prev(m_steps.end()));
        }
    }

    /// @return nullptr where it is not kept
    [[nodiscard]] std::shared_ptr<const T> find(std::int64_t step) const
    {
        const auto at = m_steps.find(step);
        return at == m_steps.end() ? nullptr : at->second;
    }

    [[nodiscard]] std::size_t count() const { return m_steps.size(); }
    [[nodiscard]] std::size_t most() const { return m_most; }

private:
    std::size_t m_most;
    std::map<std::int64_t, std::shared_ptr<const T>> m_steps;
};

/// What is kept of every n-th step, n as small as memory allows: where there are too many, every second goes and n
/// doubles.
template <class T>
class SpacedSteps {
public:
    /// @param most of them, 1 or more
    explicit SpacedSteps(std::size_t most)
        : m_most(most)
    {
    }

    [[nodiscard]] bool wants(std::int64_t step) const { return step % m_spacing == 0 && !m_steps.contains(step); }

    void keep(std::int64_t step, T what)
    {
        m_steps.emplace(step, std::move(what));
        while (m_steps.size() > m_most) {
            m_spacing *= 2;
            std::erase_if(m_steps, [this](const auto& each) { return each.first % m_spacing != 0; });
        }
    }

    /// @return the last at or before a step, or nullptr
    [[nodiscard]] const std::pair<const std::int64_t, T>* lastBefore(std::int64_t step) const
    {
        const auto after = m_steps.upper_bound(step);
        return after == m_steps.begin() ? nullptr : &*std::prev(after);
    }

    [[nodiscard]] std::size_t count() const { return m_steps.size(); }

private:
    static constexpr std::int64_t kClosest = 16;

    std::size_t m_most;
    std::int64_t m_spacing = kClosest;
    std::map<std::int64_t, T> m_steps;
};

} // namespace fumage
