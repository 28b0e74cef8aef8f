#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"
#include "ui/presets/thumbnailer.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <cstddef>
#include <vector>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace fumage::ui {

/// Nine neighbours of the smoke, the present one in the middle: click to adopt one, and they become its neighbours;
/// back through the ones that were adopted. The answer to parameters that are hard to manipulate one by one.
class VariationsPanel : public QWidget {
    Q_OBJECT

public:
    VariationsPanel(Document& document, Locks& locks, QWidget* parent = nullptr);

    static constexpr int kCells = 9;
    static constexpr int kMiddle = 4;

    /// The effect of a cell; that in the middle is the document's.
    [[nodiscard]] const Effect& effectOf(int cell) const { return m_effects[static_cast<std::size_t>(cell)]; }

    QSize sizeHint() const override { return {380, 460}; }
    /// With the smallest pictures, however large they are: the panel can be made narrower again.
    QSize minimumSizeHint() const override;

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QGridLayout* makeGrid();
    [[nodiscard]] QHBoxLayout* makeBar();
    void connectParts();
    void throwDice();
    void fill();
    void adopt(int cell);
    void goBack();
    void follow();
    /// The layer that is edited, without its key frames.
    [[nodiscard]] Effect edited() const;
    /// @param attempt 0, or how many candidates for this cell have shown nothing
    void propose(int cell, int attempt);
    void receive(const QString& name, const QImage& image);
    [[nodiscard]] int thumbnailEdge() const;

    Document& m_document;
    Locks& m_locks;
    Thumbnailer m_thumbnailer;
    std::array<QToolButton*, kCells> m_cells{};
    std::array<Effect, kCells> m_effects;
    std::vector<Scene> m_lineage; ///< what was adopted from, oldest first
    QSlider* m_amount;
    QToolButton* m_back;
    QLabel* m_locked;
    QTimer m_settle; ///< the smoke is changing: wait until it is still
    Scene m_seen; ///< the smoke as it was when it changed last
    std::size_t m_seenLayer = 0; ///< the one that was edited then
    int m_edge = 0; ///< of a picture, in pixels of the desktop
    quint32 m_seed = 1;
    quint64 m_generation = 0;
};

} // namespace fumage::ui
