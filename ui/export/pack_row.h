#pragma once

#include "core/export/sheets/packing.h"

#include <QWidget>

#include <array>

class QComboBox;
class QLineEdit;

namespace fumage::ui {

/// One packed picture: its name, what stands in its channels, and how large it is.
class PackRow : public QWidget {
    Q_OBJECT

public:
    /// @param number of the row, from 1: part of the names of its widgets, and of the first name of the picture
    PackRow(int number, QWidget* parent);

    /// Channels that are left open before others are 0.
    [[nodiscard]] PackedPicture pack() const;
    /// Shows one that is remembered.
    void take(const PackedPicture& pack);

signals:
    void changed();
    void removed();

private:
    void fillChannels();

    QLineEdit* m_name;
    std::array<QComboBox*, 4> m_channels{};
    QComboBox* m_size;
};

} // namespace fumage::ui
