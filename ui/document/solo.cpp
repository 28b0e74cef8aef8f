#include "ui/document/solo.h"

#include <algorithm>
#include <optional>

namespace fumage::ui {

namespace {

std::size_t distance(std::size_t one, std::size_t other)
{
    return one > other ? one - other : other - one;
}

} // namespace

Solo::Solo(const Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::loaded, this, &Solo::end);
    connect(&document, &Document::effectChanged, this, &Solo::follow);
}

Solo::Key Solo::keyOf(std::size_t layer) const
{
    const Layer& known = m_document.scene().layers[layer];
    return {known.name, known.emitter.seed, layer};
}

bool Solo::contains(std::size_t layer) const
{
    return std::any_of(m_keys.begin(), m_keys.end(), [&](const Key& key) { return key.place == layer; });
}

std::vector<std::size_t> Solo::layers() const
{
    std::vector<std::size_t> all;
    for (const Key& key : m_keys) {
        all.push_back(key.place);
    }
    return all;
}

void Solo::set(const std::vector<std::size_t>& layers, bool solo)
{
    m_layers = m_document.scene().layers.size();
    for (const std::size_t layer : layers) {
        if (solo && !contains(layer)) {
            m_keys.push_back(keyOf(layer));
        } else if (!solo) {
            std::erase_if(m_keys, [&](const Key& key) { return key.place == layer; });
        }
    }
    std::sort(m_keys.begin(), m_keys.end(), [](const Key& a, const Key& b) { return a.place < b.place; });
    emit changed();
}

void Solo::toggleAlone(std::size_t layer)
{
    const bool isAlone = m_keys.size() == 1 && contains(layer);
    m_keys.clear();
    set({layer}, !isAlone);
}

void Solo::end()
{
    if (isOn()) {
        m_keys.clear();
        emit changed();
    }
}

/// A layer is where its name and seed are, the nearest of several; where they are nowhere it was renamed or seeded anew
/// in its place, or else it is gone.
void Solo::follow()
{
    const std::vector<Layer>& layers = m_document.scene().layers;
    const auto find = [&](const Key& key) {
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < layers.size(); ++i) {
            const bool isIt = layers[i].name == key.name && layers[i].emitter.seed == key.seed;
            if (isIt && (!found || distance(i, key.place) < distance(*found, key.place))) {
                found = i;
            }
        }
        return found || layers.size() != m_layers ? found : std::optional(key.place);
    };
    std::vector<Key> kept;
    for (const Key& key : m_keys) {
        if (const std::optional<std::size_t> place = find(key)) {
            kept.push_back(keyOf(*place));
        }
    }
    m_keys = std::move(kept);
    std::sort(m_keys.begin(), m_keys.end(), [](const Key& a, const Key& b) { return a.place < b.place; });
    m_layers = layers.size();
}

} // namespace fumage::ui
