#include "ui/shell/command_search.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"

#include "core/effect/parameter_table.h"

#include <algorithm>

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kActionRole = Qt::UserRole;
constexpr int kParameterRole = Qt::UserRole + 1;

} // namespace

CommandSearch::CommandSearch(ActionSet& actions, QWidget* parent)
    : QDialog(parent)
    , m_actions(actions)
    , m_search(new QLineEdit(this))
    , m_list(new QListWidget(this))
{
    setObjectName(QStringLiteral("commandSearch"));
    setWindowTitle(tr("Search commands"));
    m_search->setObjectName(QStringLiteral("commandSearch.text"));
    m_search->setAccessibleName(tr("Search commands"));
    m_search->setPlaceholderText(tr("A command or a parameter"));
    m_search->installEventFilter(this);
    m_list->setObjectName(QStringLiteral("commandSearch.list"));
    m_list->setAccessibleName(tr("Commands"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->addWidget(m_search);
    layout->addWidget(m_list);
    constexpr QSize kUsual(520, 420);
    resize(kUsual);
    fill();
    filter({});
    connect(m_search, &QLineEdit::textChanged, this, &CommandSearch::filter);
    connect(m_search, &QLineEdit::returnPressed, this, &CommandSearch::choose);
    connect(m_list, &QListWidget::itemClicked, this, &CommandSearch::choose);
}

void CommandSearch::fill()
{
    for (const ActionSpec& spec : actionSpecs()) {
        const QAction& action = m_actions.get(spec.id);
        if (!action.isEnabled() || spec.kind == ActionKind::Submenu) {
            continue;
        }
        const QString keys = action.shortcut().toString(QKeySequence::NativeText);
        auto* item = new QListWidgetItem(action.icon(), fullName(spec) + (keys.isEmpty() ? QString() : QStringLiteral("    ") + keys), m_list);
        item->setData(kActionRole, QLatin1String(spec.id));
    }
    for (const Parameter& parameter : parameterTable()) {
        auto* item = new QListWidgetItem(fullLabelOf(parameter), m_list);
        item->setToolTip(toolTipOf(parameter));
        item->setData(kParameterRole, toQString(parameter.key));
    }
}

void CommandSearch::filter(const QString& text)
{
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    int first = -1;
    for (int i = 0; i < m_list->count(); ++i) {
        const QString name = m_list->item(i)->text();
        const bool found = std::all_of(words.begin(), words.end(), [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
        m_list->item(i)->setHidden(!found);
        first = found && first < 0 ? i : first;
    }
    m_list->setCurrentRow(first);
}

void CommandSearch::choose()
{
    const QListWidgetItem* item = m_list->currentItem();
    if (item == nullptr || item->isHidden()) {
        return;
    }
    accept();
    const QString action = item->data(kActionRole).toString();
    if (action.isEmpty()) {
        emit parameterChosen(item->data(kParameterRole).toString());
    } else {
        m_actions.get(action.toLatin1().constData()).trigger();
    }
}

bool CommandSearch::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<const QKeyEvent&>(*event).key();
        if (key == Qt::Key_Up || key == Qt::Key_Down) {
            const int way = key == Qt::Key_Down ? 1 : -1;
            for (int row = m_list->currentRow() + way; row >= 0 && row < m_list->count(); row += way) {
                if (!m_list->item(row)->isHidden()) {
                    m_list->setCurrentRow(row);
                    break;
                }
            }
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace fumage::ui
