#include "ui/panels/editor_factory.h"
#include "ui/panels/key_mark.h"
#include "ui/panels/parameter_row.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/widgets/gesture.h"
#include "ui/theme/icons.h"
#include "ui/widgets/message_box.h"

#include "core/effect/value.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QStyle>
#include <QToolButton>

namespace fumage::ui {

namespace {

/// Editors that need the whole width stand below their label.
bool isTall(const Parameter& parameter)
{
    return parameter.kind == Kind::Curve || parameter.kind == Kind::Gradient || parameter.kind == Kind::Direction;
}

} // namespace

ParameterRow::ParameterRow(const Parameter& parameter, Document& document, Locks& locks, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_locks(locks)
    , m_name(labelOf(parameter))
    , m_label(new QLabel(m_name, this))
    , m_editor(makeEditor(parameter, this))
{
    setObjectName(toQString(parameter.key) + QStringLiteral(".row"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_label->setObjectName(toQString(parameter.key) + QStringLiteral(".label"));
    m_label->setProperty("role", QStringLiteral("parameter"));
    m_label->setToolTip(toolTipOf(parameter));
    m_label->setBuddy(m_editor);
    m_label->installEventFilter(this);
    auto* layout = new QBoxLayout(isTall(parameter) ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight, this);
    layout->setContentsMargins(0, 1, 0, 1);
    layout->setSpacing(4);
    if (canAnimate(parameter)) {
        m_key = new KeyMark(parameter, document, this);
    }
    if (isTall(parameter)) {
        auto* heading = new QHBoxLayout;
        heading->addWidget(m_label, 1);
        if (m_key != nullptr) {
            heading->addWidget(m_key);
        }
        layout->addLayout(heading);
        layout->addWidget(m_editor, 1);
    } else {
        m_label->setFixedWidth(kLabelWidth);
        layout->addWidget(m_label);
        layout->addWidget(m_editor, 1);
        if (m_key != nullptr) {
            layout->addWidget(m_key);
        }
    }
    connect(m_editor, &ParameterEditor::edited, this, &ParameterRow::edit);
    connect(&m_locks, &Locks::changed, this, &ParameterRow::showState);
}

void ParameterRow::edit(const Value& value, bool finished)
{
    if (m_gesture.id == 0) {
        m_gesture = m_document.beginGesture();
        m_before = stored().get(m_document.effect());
        const Track* track = m_document.track(stored());
        m_trackBefore = track != nullptr ? std::optional(*track) : std::nullopt;
    }
    if (m_isTakenBack) {
        takeBack();
    } else {
        m_document.edit(parameter(), value, m_gesture);
    }
    if (finished) {
        m_gesture = {};
        m_isTakenBack = false;
        // What the document made of it: clamped perhaps, or unchanged.
        m_hasShown = false;
        sync();
    }
}

void ParameterRow::takeBack()
{
    if (m_document.track(stored()) != nullptr) { // a key of the old value is one more than there was
        replaceTracks(m_document, {m_trackBefore.value_or(Track{&stored(), {}})}, {}, m_gesture);
    } else {
        m_document.edit(stored(), m_before, m_gesture);
    }
}

bool ParameterRow::event(QEvent* event)
{
    // The release that follows ends the gesture where it began, which leaves no step.
    if (event->type() == DragCancel::type() && m_gesture.id != 0) {
        m_isTakenBack = true;
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void ParameterRow::sync()
{
    const Value value = parameter().get(m_document.effect());
    if (!m_hasShown || !(value == m_shown)) {
        m_shown = value;
        m_hasShown = true;
        m_editor->setValue(value);
    }
    if (m_key != nullptr) {
        m_key->sync();
    }
    showState();
}

void ParameterRow::showState()
{
    const State state{differsFromReference(m_document, parameter()), m_locks.contains(stored())};
    if (state == m_state) {
        return;
    }
    m_state = state;
    showName();
    showLock(state.locked);
    m_label->setProperty("changed", state.changed);
    m_label->style()->unpolish(m_label);
    m_label->style()->polish(m_label);
}

void ParameterRow::setName(const QString& name)
{
    m_name = name.isEmpty() ? labelOf(parameter()) : name;
    showName();
}

void ParameterRow::showName()
{
    m_label->setText((m_state.changed ? QStringLiteral("• ") : QString()) + m_name);
}

void ParameterRow::showLock(bool locked)
{
    // Few parameters are ever locked: the mark is made when it is needed.
    if (m_lock == nullptr && locked) {
        m_lock = makeIconButton(m_label, m_editor->objectName() + QStringLiteral(".locked"), QStringLiteral("lock"),
            tr("Locked against randomising; press to unlock"));
        constexpr QSize kMark(12, 12);
        m_lock->setIconSize(kMark);
        auto* inside = new QHBoxLayout(m_label);
        inside->setContentsMargins(0, 0, 2, 0);
        inside->addStretch();
        inside->addWidget(m_lock);
        connect(m_lock, &QToolButton::clicked, this, [this] { m_locks.set(stored(), false); });
    }
    if (m_lock != nullptr) {
        m_lock->setVisible(locked);
    }
}

void ParameterRow::prefixNames(const QString& prefix)
{
    const QString key = toQString(parameter().key);
    for (QWidget* part : findChildren<QWidget*>()) {
        if (part->objectName().startsWith(key)) {
            part->setObjectName(prefix + part->objectName());
        }
    }
    setObjectName(prefix + objectName());
}

bool ParameterRow::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_label && event->type() == QEvent::MouseButtonDblClick) {
        m_document.reset(parameter());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ParameterRow::copy(bool asAssignment) const
{
    const QString text = toQString(formatText(parameter(), parameter().get(m_document.effect())));
    QApplication::clipboard()->setText(
        asAssignment ? QStringLiteral("--set '%1=%2'").arg(toQString(parameter().key), text) : text);
}

void ParameterRow::paste()
{
    const Result<Clamped> value = parseValue(parameter(), QApplication::clipboard()->text().trimmed().toStdString());
    if (value) {
        m_document.edit(parameter(), value.value().value);
    } else {
        MessageBox::warn(this, tr("Paste"), translated(value.error()));
    }
}

void ParameterRow::addKeyActions(QMenu& menu)
{
    const KeyState state = keyState(m_document, stored());
    const bool isFree = m_document.canEdit(stored());
    menu.addAction(tr("Set a key frame here"), this, [this] { addKey(m_document, stored()); })
        ->setEnabled(isFree && state != KeyState::Here);
    menu.addAction(tr("Remove the key frame here"), this, [this] { removeKey(m_document, stored()); })
        ->setEnabled(isFree && state == KeyState::Here);
    menu.addAction(tr("Remove all key frames"), this, [this] { removeAllKeys(m_document, stored()); })
        ->setEnabled(isFree && state != KeyState::None);
    menu.addSeparator();
}

void ParameterRow::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("parameterMenu"));
    m_editor->addActions(menu, event->globalPos());
    QAction* reset = menu.addAction(tr("Reset"), this, [this] { m_document.reset(parameter()); });
    reset->setEnabled(isChanged());
    menu.addAction(tr("Reset to the default"), this, [this] { m_document.edit(stored(), stored().get(Effect())); });
    menu.addSeparator();
    if (m_key != nullptr) {
        addKeyActions(menu);
    }
    menu.addAction(tr("Copy"), this, [this] { copy(false); });
    menu.addAction(tr("Paste"), this, &ParameterRow::paste)
        ->setEnabled(!QApplication::clipboard()->text().trimmed().isEmpty());
    menu.addAction(tr("Copy as --set"), this, [this] { copy(true); });
    menu.addSeparator();
    QAction* lock = menu.addAction(tr("Lock against randomising"));
    lock->setCheckable(true);
    lock->setChecked(m_locks.contains(stored()));
    connect(lock, &QAction::toggled, this, [this](bool on) { m_locks.set(stored(), on); });
    menu.exec(event->globalPos());
}

} // namespace fumage::ui
