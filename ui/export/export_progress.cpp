#include "ui/export/export_progress.h"

#include <cmath>

#include <QDir>
#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

namespace fumage::ui {

ExportProgress::ExportProgress(const ExportJob& job, QWidget* parent)
    : QWidget(parent)
    , m_bar(new QProgressBar(this))
    , m_state(new QLabel(this))
{
    m_bar->setObjectName(QStringLiteral("export.progress"));
    m_bar->hide();
    m_state->setObjectName(QStringLiteral("export.state"));
    m_state->setWordWrap(true);
    m_state->setTextFormat(Qt::PlainText);
    m_state->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_bar);
    layout->addWidget(m_state);
    connect(&job, &ExportJob::started, this, &ExportProgress::begin);
    connect(&job, &ExportJob::progressed, this, &ExportProgress::follow);
    connect(&job, &ExportJob::preparing, this, &ExportProgress::say);
    connect(&job, &ExportJob::finished, this, [this](const QString& firstFile, const QString& remark) {
        const QString done = tr("Done: %1").arg(QDir::toNativeSeparators(firstFile));
        end(remark.isEmpty() ? done : done + QLatin1Char('\n') + remark);
    });
    connect(&job, &ExportJob::cancelled, this, [this] { end(tr("Cancelled. Files that were complete are kept.")); });
    connect(&job, &ExportJob::failed, this, &ExportProgress::end);
    if (job.isRunning()) {
        begin();
    }
}

void ExportProgress::begin()
{
    m_bar->setRange(0, 0);
    m_bar->show();
    say({});
}

void ExportProgress::follow(int done, int total, double secondsLeft)
{
    m_bar->setRange(0, total);
    m_bar->setValue(done);
    say(tr("%1 of %2, %3 s left").arg(done).arg(total).arg(std::ceil(secondsLeft)));
}

void ExportProgress::end(const QString& outcome)
{
    m_bar->hide();
    say(outcome);
}

void ExportProgress::say(const QString& text)
{
    m_state->setText(text);
    m_state->setVisible(!text.isEmpty());
}

} // namespace fumage::ui
