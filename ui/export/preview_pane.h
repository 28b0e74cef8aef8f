#pragma once

#include "ui/export/preview_job.h"
#include "ui/export/sheet_frame.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;

namespace fumage::ui {

class PreviewCanvas;

/// Plays a flipbook as an engine will, before it is written; opened by a switch. Renders and plays only while it is
/// seen.
class PreviewPane : public QWidget {
    Q_OBJECT

public:
    /// @param shelf see ExportTask
    explicit PreviewPane(std::shared_ptr<AirCache> shelf, QWidget* parent = nullptr);

    /// What is to be written; renders anew where that makes another flipbook.
    void follow(const Scene& scene, const ExportPlan& plan);

signals:
    /// It was opened or closed.
    void resized();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void buildBody();
    void connectJob();
    [[nodiscard]] bool isPlaying() const { return isVisible() && m_body->isVisible(); }
    void wake();
    void rest();
    void render();
    void take(const std::shared_ptr<const SheetPreview>& preview);
    void play();
    void followMotion();

    struct Wanted {
        Scene scene;
        ExportPlan plan;
    };
    std::optional<Wanted> m_wanted;
    bool m_isStale = true; ///< what is wanted is not what plays
    std::shared_ptr<const SheetPreview> m_preview;
    PreviewJob m_job;
    QTimer m_settle; ///< while fields are being typed into
    QTimer m_tick;
    QElapsedTimer m_clock; ///< since the first cell
    SheetFrame m_frame;
    QWidget* m_body;
    PreviewCanvas* m_canvas;
    QComboBox* m_blending;
    QComboBox* m_backdrop;
    QLabel* m_state;
};

} // namespace fumage::ui
