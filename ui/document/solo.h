#pragma once

#include "ui/document/document.h"

#include <cstdint>
#include <string>

namespace fumage::ui {

/// Which layers of a document are looked at alone. That is of the view: no file, no export and no undo step knows of
/// it, and another document begins without.
///
/// Follows layers through the list wherever they go, by their names and seeds.
class Solo : public QObject {
    Q_OBJECT

public:
    /// Hears of changes of the document before those who are made after it.
    explicit Solo(const Document& document, QObject* parent = nullptr);

    [[nodiscard]] bool isOn() const { return !m_keys.empty(); }
    [[nodiscard]] bool contains(std::size_t layer) const;
    /// In their order; empty: all are looked at.
    [[nodiscard]] std::vector<std::size_t> layers() const;

    void set(const std::vector<std::size_t>& layers, bool solo);
    /// This layer and no other; all again where it is so already.
    void toggleAlone(std::size_t layer);
    void end();

signals:
    /// By hand; what the document does to its layers, it says itself.
    void changed();

private:
    /// What a layer is known by.
    struct Key {
        std::string name;
        std::uint32_t seed = 0;
        std::size_t place = 0;
    };
    [[nodiscard]] Key keyOf(std::size_t layer) const;
    void follow();

    const Document& m_document;
    std::vector<Key> m_keys; ///< of the layers that are solo, in their order
    std::size_t m_layers = 0; ///< of the document, when they were found last
};

} // namespace fumage::ui
