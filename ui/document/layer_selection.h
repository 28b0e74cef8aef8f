#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace fumage::ui {

/// Layers that are chosen: one that is edited, and others that what is done in the list is done to, too.
class LayerSelection {
public:
    LayerSelection(std::size_t active = 0) // NOLINT(google-explicit-constructor): one layer is a selection
        : m_active(active)
        , m_all{active}
    {
    }
    LayerSelection(std::size_t active, std::vector<std::size_t> others)
        : m_active(active)
        , m_all(std::move(others))
    {
        m_all.push_back(active);
        std::sort(m_all.begin(), m_all.end());
        m_all.erase(std::unique(m_all.begin(), m_all.end()), m_all.end());
    }

    /// The one that is edited.
    [[nodiscard]] std::size_t active() const { return m_active; }
    /// In their order, with the active one.
    [[nodiscard]] const std::vector<std::size_t>& all() const { return m_all; }
    [[nodiscard]] bool contains(std::size_t layer) const
    {
        return std::binary_search(m_all.begin(), m_all.end(), layer);
    }

    friend bool operator==(const LayerSelection&, const LayerSelection&) = default;

private:
    std::size_t m_active;
    std::vector<std::size_t> m_all;
};

} // namespace fumage::ui
