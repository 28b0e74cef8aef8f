#include "ui/viewport/work_line.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace fumage::ui {

namespace {

constexpr int kDelayMs = 300; ///< shorter waits are not worth a word
constexpr int kLingerMs = 120;

} // namespace

WorkLine::WorkLine(QWidget* parent)
    : QFrame(parent)
    , m_label(new QLabel(this))
    , m_button(new QToolButton(this))
{
    setObjectName(QStringLiteral("workLine"));
    setAccessibleName(tr("Work in progress"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    m_label->setObjectName(QStringLiteral("workLine.text"));
    m_label->setTextFormat(Qt::PlainText);
    m_button->setObjectName(QStringLiteral("workLine.button"));
    m_button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_button->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the viewport
    auto* layout = new QHBoxLayout(this);
    constexpr int kMargin = 6;
    layout->setContentsMargins(kMargin, kMargin / 2, kMargin / 2, kMargin / 2);
    layout->addWidget(m_label);
    layout->addWidget(m_button);
    m_delay.setSingleShot(true);
    m_delay.setInterval(kDelayMs);
    m_linger.setSingleShot(true);
    m_linger.setInterval(kLingerMs);
    connect(&m_delay, &QTimer::timeout, this, &WorkLine::appear);
    connect(&m_linger, &QTimer::timeout, this, &WorkLine::settle);
    connect(m_button, &QToolButton::clicked, this, &WorkLine::press);
    hide();
}

void WorkLine::follow(Phase phase, double share)
{
    if (phase == Phase::Idle) {
        m_delay.stop();
        m_phase = phase;
        m_linger.start();
        return;
    }
    if (m_stopped) {
        return; // a preview takes no time that is worth a word
    }
    m_linger.stop();
    if (phase != m_phase) {
        m_sincePhase.start();
        m_firstShare = std::max(0.0, share);
    }
    m_phase = phase;
    m_share = share;
    if (isHidden() && !m_delay.isActive()) {
        m_delay.start();
    }
    if (!isHidden()) {
        say();
    }
}

void WorkLine::showStopped(bool stopped)
{
    if (stopped != m_stopped) {
        m_stopped = stopped;
        settle();
    }
}

void WorkLine::appear()
{
    say();
    show();
    raise();
    emit shownChanged();
}

/// Nothing is waited for any more: it goes, or offers to go on.
void WorkLine::settle()
{
    m_phase = Phase::Idle;
    m_delay.stop();
    m_linger.stop();
    if (m_stopped) {
        appear();
    } else if (!isHidden()) {
        hide();
        emit shownChanged();
    }
}

void WorkLine::press()
{
    if (m_stopped) {
        emit resumed();
    } else {
        emit stopped();
    }
}

QString WorkLine::text() const
{
    return m_label->text();
}

void WorkLine::say()
{
    constexpr double kMsASecond = 1000.0;
    constexpr double kTelling = 0.02; // of the work: what has been seen of it before says nothing
    const double done = m_share - m_firstShare;
    const double seconds = m_sincePhase.isValid() ? static_cast<double>(m_sincePhase.elapsed()) / kMsASecond : 0.0;
    const double left = done > kTelling ? seconds * (1.0 - m_share) / done : -1.0;
    m_label->setText(m_stopped ? tr("Stopped: a preview is shown") : textFor(m_phase, m_share, left));
    m_button->setText(m_stopped ? tr("Go on") : tr("Stop"));
    m_button->setAccessibleName(m_button->text());
    m_button->setToolTip(m_stopped ? tr("Make the picture after all")
                                   : tr("Give this up; a preview stays, and playing goes on with it"));
    adjustSize();
}

QString WorkLine::textFor(Phase phase, double share, double secondsLeft)
{
    QString what;
    switch (phase) {
    case Phase::Idle: return {};
    case Phase::Air: what = tr("Baking air"); break;
    case Phase::Steps: what = tr("Simulating particles"); break;
    case Phase::Light: what = tr("Lighting"); break;
    case Phase::Paint: what = tr("Painting"); break;
    }
    if (share < 0.0) {
        return what + QStringLiteral(" …");
    }
    constexpr double kPercent = 100.0;
    const int percent = static_cast<int>(kPercent * std::clamp(share, 0.0, 1.0));
    if (secondsLeft < 0.0) {
        return tr("%1 %2 %").arg(what).arg(percent);
    }
    constexpr double kSecondsAMinute = 60.0;
    if (secondsLeft > 2.0 * kSecondsAMinute) {
        return tr("%1 %2 %, about %3 min").arg(what).arg(percent).arg(std::lround(secondsLeft / kSecondsAMinute));
    }
    return tr("%1 %2 %, about %3 s").arg(what).arg(percent).arg(std::max(1L, std::lround(secondsLeft)));
}

} // namespace fumage::ui
