#pragma once

#include "ui/export/export_job.h"

#include <QWidget>

class QLabel;
class QProgressBar;

namespace fumage::ui {

/// How far an export has come, and what became of the last one.
class ExportProgress : public QWidget {
    Q_OBJECT

public:
    ExportProgress(const ExportJob& job, QWidget* parent);

    /// Says nothing more of the last export.
    void forget() { say({}); }

private:
    void begin();
    void follow(int done, int total, double secondsLeft);
    void end(const QString& outcome);
    void say(const QString& text);

    QProgressBar* m_bar;
    QLabel* m_state;
};

} // namespace fumage::ui
