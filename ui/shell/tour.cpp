#include "ui/shell/tour.h"

#include "ui/widgets/in_sight.h"

#include <algorithm>
#include <utility>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kGap = 8; // pixels between a control and the bubble

/// Where the bubble lies: beside a control where there is room, else over it.
QRect placeBeside(const QRect& control, QSize bubble, const QRect& window)
{
    const QPoint middle = control.center() - QPoint(bubble.width() / 2, bubble.height() / 2);
    const QPoint places[] = {{control.left() - kGap - bubble.width(), middle.y()}, {control.right() + kGap, middle.y()},
        {middle.x(), control.top() - kGap - bubble.height()}, {middle.x(), control.bottom() + kGap}};
    const auto fits = [&](const QPoint& place) { return window.contains(QRect(place, bubble)); };
    if (control.width() > 2 * bubble.width() && control.height() > 2 * bubble.height()) {
        return {{middle.x(), control.top() + kGap}, bubble};
    }
    const auto* found = std::ranges::find_if(places, fits);
    const QPoint place = found != std::end(places) ? *found : places[3];
    const QPoint last = window.bottomRight() - QPoint(bubble.width(), bubble.height());
    return {{std::clamp(place.x(), 0, std::max(0, last.x())), std::clamp(place.y(), 0, std::max(0, last.y()))}, bubble};
}

} // namespace

Tour* Tour::start(QMainWindow& window, std::vector<TourStep> steps)
{
    delete window.findChild<Tour*>();
    auto* tour = new Tour(window, std::move(steps));
    const int first = tour->stepFrom(-1, 1);
    if (first < 0) {
        delete tour;
        return nullptr;
    }
    tour->showStep(first);
    return tour;
}

Tour::Tour(QMainWindow& window, std::vector<TourStep> steps)
    : QFrame(&window)
    , m_window(window)
    , m_steps(std::move(steps))
    , m_text(new QLabel(this))
    , m_back(new QPushButton(tr("Back"), this))
    , m_next(new QPushButton(tr("Next"), this))
    , m_done(new QPushButton(tr("Done"), this))
    , m_escape(new QShortcut(Qt::Key_Escape, this, this, &Tour::end))
{
    setObjectName(QStringLiteral("tour"));
    setAccessibleName(tr("Tour"));
    setAutoFillBackground(true);
    setFrameShape(StyledPanel);
    setFocusPolicy(Qt::StrongFocus);
    m_text->setObjectName(QStringLiteral("tour.text"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    constexpr int kWidth = 300;
    m_text->setFixedWidth(kWidth);
    auto* row = new QHBoxLayout;
    row->addStretch();
    const std::pair<QPushButton*, const char*> buttons[] = {
        {m_back, "tour.back"}, {m_next, "tour.next"}, {m_done, "tour.done"}};
    for (const auto& [button, name] : buttons) {
        button->setObjectName(QLatin1String(name));
        button->setAccessibleName(button->text());
        button->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the bubble
        button->installEventFilter(this);
        row->addWidget(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text);
    layout->addLayout(row);
    installEventFilter(this);
    window.installEventFilter(this);
    connect(m_back, &QPushButton::clicked, this, &Tour::back);
    connect(m_next, &QPushButton::clicked, this, &Tour::next);
    connect(m_done, &QPushButton::clicked, this, &Tour::end);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, const QWidget* now) {
        m_escape->setEnabled(qobject_cast<const QLineEdit*>(now) == nullptr
            && qobject_cast<const QAbstractSpinBox*>(now) == nullptr); // there it takes back what was typed
    });
}

QWidget* Tour::shownTarget(int step) const
{
    QWidget* target = m_steps[static_cast<std::size_t>(step)].find();
    const bool isSeen = target != nullptr && target->window() == &m_window && isInSight(*target);
    return isSeen ? target : nullptr;
}

int Tour::stepFrom(int step, int direction) const
{
    const int count = static_cast<int>(m_steps.size());
    for (int other = step + direction; other >= 0 && other < count; other += direction) {
        if (shownTarget(other) != nullptr) {
            return other;
        }
    }
    return -1;
}

void Tour::next()
{
    if (const int step = stepFrom(m_step, 1); step >= 0) {
        showStep(step);
    } else {
        end();
    }
}

void Tour::back()
{
    if (const int step = stepFrom(m_step, -1); step >= 0) {
        showStep(step);
    }
}

void Tour::end()
{
    hide();
    deleteLater();
    if (m_window.centralWidget() != nullptr) {
        m_window.centralWidget()->setFocus();
    }
}

void Tour::showStep(int step)
{
    if (m_target) {
        m_target->removeEventFilter(this);
    }
    m_step = step;
    m_target = shownTarget(step);
    m_target->installEventFilter(this);
    m_text->setText(m_steps[static_cast<std::size_t>(step)].text);
    setAccessibleDescription(m_text->text());
    m_back->setEnabled(stepFrom(step, -1) >= 0);
    m_next->setEnabled(stepFrom(step, 1) >= 0);
    show();
    place();
    setFocus();
}

void Tour::place()
{
    if (m_target) {
        adjustSize();
        const QRect control(m_target->mapTo(&m_window, QPoint()), m_target->size());
        setGeometry(placeBeside(control, size(), m_window.rect()));
        raise();
    }
}

bool Tour::eventFilter(QObject* watched, QEvent* event)
{
    const bool isOwn = watched == this || watched->parent() == this;
    if (isOwn && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
        const int key = static_cast<const QKeyEvent&>(*event).key();
        const bool goesOn =
            key == Qt::Key_Right || (watched == this && (key == Qt::Key_Return || key == Qt::Key_Space));
        if (goesOn || key == Qt::Key_Left) {
            event->accept(); // or it would step the frames
            if (event->type() == QEvent::KeyPress) {
                goesOn ? next() : back();
            }
            return true;
        }
    } else if (!isOwn && (event->type() == QEvent::Resize || event->type() == QEvent::Move)) {
        QMetaObject::invokeMethod(this, &Tour::place, Qt::QueuedConnection); // once the layout is done
    } else if (watched == m_target && event->type() == QEvent::Hide && isVisible()) {
        const auto leave = [this] {
            if (shownTarget(m_step) == nullptr) {
                next();
            }
        };
        QMetaObject::invokeMethod(this, leave, Qt::QueuedConnection);
    }
    return false;
}

} // namespace fumage::ui
