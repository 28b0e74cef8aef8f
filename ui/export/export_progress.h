#pragma once

#include "ui/export/export_queue.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace fumage::ui {

/// How far one export of the queue is, and what became of it.
class ExportProgress : public QWidget {
    Q_OBJECT

public:
    ExportProgress(const ExportQueue& queue, QWidget* parent);

    /// From now on says how far this one is.
    /// @param id 0: nothing more of any
    void follow(quint64 id);
    /// The one that is followed; null: none, or it is gone.
    [[nodiscard]] const QueuedExport* followed() const { return m_queue.find(m_id); }
    /// Says what keeps an export from being begun.
    void say(const QString& text);

signals:
    /// Its state, or how far it is.
    void changed();
    /// Smoke was cut off: the camera is to be fitted to it.
    void fitRequested();

private:
    void show(const QueuedExport& one);

    const ExportQueue& m_queue;
    quint64 m_id = 0;
    QProgressBar* m_bar;
    QLabel* m_state;
    QPushButton* m_fit;
};

} // namespace fumage::ui
