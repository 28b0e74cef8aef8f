#include "ui/shell/comparison.h"

#include "ui/shell/action_table.h"
#include "ui/viewport/viewport.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QWindow>

namespace fumage::ui {

Comparison::Comparison(Document& document, Viewport& viewport, const ActionSet& actions)
    : m_document(document)
    , m_viewport(viewport)
    , m_split(actions.get("compare.split"))
    , m_hold(actions.get("compare.hold"))
    , m_other(document.scene())
{
    actions.on("compare.remember", this, &Comparison::setReference);
    actions.on("compare.adopt", this, [this] { m_document.replaceScene(m_other, 0, tr("Replace A with B")); });
    connect(&m_document, &Document::loaded, this, &Comparison::setReference);
    connect(&m_split, &QAction::toggled, this, &Comparison::show);
    connect(&m_hold, &QAction::toggled, this, &Comparison::show);
    m_hold.setAutoRepeat(false);
    m_hold.installEventFilter(this);
    // The release of a key that is down when another window gets the keyboard is told to nobody here.
    connect(qApp, &QGuiApplication::focusWindowChanged, this, [this](const QWindow* window) {
        if (m_heldIn && m_heldIn != window) {
            m_hold.setChecked(false);
            endHold();
        }
    });
}

void Comparison::setReference()
{
    m_other = m_document.scene();
    show();
}

void Comparison::show()
{
    const Viewport::Compare split = m_split.isChecked() ? Viewport::Compare::Split : Viewport::Compare::Off;
    m_viewport.setCompare(m_hold.isChecked() ? Viewport::Compare::Other : split, m_other);
}

void Comparison::beginHold()
{
    // Widgets may keep the release of a key to themselves, whichever has the focus by then: their window sees it before
    // them.
    m_heldIn = QGuiApplication::focusWindow();
    if (m_heldIn) {
        m_heldIn->installEventFilter(this);
        m_sincePress.start();
    }
}

void Comparison::endHold()
{
    m_heldIn->removeEventFilter(this);
    m_heldIn = nullptr;
}

bool Comparison::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_hold && event->type() == QEvent::Shortcut && !m_hold.isChecked()) {
        beginHold();
    } else if (watched == m_heldIn && event->type() == QEvent::KeyRelease) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (key.key() == m_hold.shortcut()[0].key() && !key.isAutoRepeat()) {
            endHold();
            if (m_sincePress.hasExpired(kTapMs)) {
                m_hold.setChecked(false);
            }
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace fumage::ui
