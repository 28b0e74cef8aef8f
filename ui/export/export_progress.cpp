#include "ui/export/export_progress.h"

#include "ui/document/text.h"

#include <QDir>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace fumage::ui {

ExportProgress::ExportProgress(const ExportQueue& queue, QWidget* parent)
    : QWidget(parent)
    , m_queue(queue)
    , m_bar(new QProgressBar(this))
    , m_state(new QLabel(this))
    , m_fit(new QPushButton(tr("Fit the camera"), this))
{
    m_bar->setObjectName(QStringLiteral("export.progress"));
    m_bar->hide();
    m_state->setObjectName(QStringLiteral("export.state"));
    m_state->setWordWrap(true);
    m_state->setTextFormat(Qt::PlainText);
    m_state->hide();
    m_fit->setObjectName(QStringLiteral("export.fitNow"));
    m_fit->setToolTip(tr("Exports again, from where all smoke is seen"));
    m_fit->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_bar);
    layout->addWidget(m_state);
    layout->addWidget(m_fit, 0, Qt::AlignLeft);
    connect(m_fit, &QPushButton::clicked, this, &ExportProgress::fitRequested);
    connect(&queue, &ExportQueue::changed, this, [this](quint64 id) {
        if (const QueuedExport* one = followed(); one != nullptr && id == m_id) {
            show(*one);
            emit changed();
        }
    });
    connect(&queue, &QAbstractItemModel::rowsRemoved, this, [this] {
        if (m_id != 0 && followed() == nullptr) { // somebody has taken it out of the queue
            follow(0);
        }
    });
}

void ExportProgress::follow(quint64 id)
{
    m_id = id;
    if (const QueuedExport* one = followed()) {
        show(*one);
    } else {
        say({});
    }
    emit changed();
}

void ExportProgress::show(const QueuedExport& one)
{
    if (one.state == ExportState::Done) {
        const QString file =
            tr("Done: %1").arg(QDir::toNativeSeparators(fromPath(firstFile(one.job->preset.scene, one.job->plan))));
        say(one.remark.isEmpty() ? file : file + QLatin1Char('\n') + one.remark);
        m_fit->setVisible(
            !one.remark.isEmpty() && !one.job->plan.fitCamera); // what is remarked is smoke that is cut off
    } else {
        say(one.told);
    }
    m_bar->setVisible(one.isActive());
    m_bar->setRange(0, one.total);
    m_bar->setValue(one.done);
}

void ExportProgress::say(const QString& text)
{
    m_bar->hide();
    m_fit->hide();
    m_state->setText(text);
    m_state->setVisible(!text.isEmpty());
}

} // namespace fumage::ui
