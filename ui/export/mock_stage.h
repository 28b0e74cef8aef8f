#pragma once

#include "ui/export/sheet_frame.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>

namespace fumage::ui {

/// A ground under a sky on which a flipbook plays as an engine plays it: one sprite that faces the viewer. Plays only
/// while it is seen.
class MockStage : public QWidget {
    Q_OBJECT

public:
    enum class Sky {
        Day,
        Evening,
        Night,
    };

    explicit MockStage(QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    void setSky(Sky sky);
    /// Plays a sheet from its first cell, with vectors where it has them. @param sheet null: the ground is empty
    void play(std::shared_ptr<const SheetPreview> sheet);
    /// Stands on the empty ground.
    void say(const QString& text);
    [[nodiscard]] bool isPlaying() const { return m_tick.isActive(); }
    /// What is shown of the sheet now; null: nothing.
    [[nodiscard]] const QImage& shown() const { return m_shown; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void wake();
    void step();
    void paintGround(QPainter& painter, int horizon) const;
    void paintGrid(QPainter& painter, int horizon, const QColor& colour) const;
    void paintSmoke(QPainter& painter, int horizon) const;

    Sky m_sky = Sky::Day;
    std::shared_ptr<const SheetPreview> m_sheet;
    SheetFrame m_frame;
    QImage m_shown;
    QString m_text;
    QTimer m_tick;
    QElapsedTimer m_clock; ///< since the first cell
};

} // namespace fumage::ui
