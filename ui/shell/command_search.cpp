#include "ui/shell/command_search.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"

#include "core/effect/parameter_table.h"

#include <algorithm>

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kWordsRole = Qt::UserRole; ///< what an item is found by

} // namespace

CommandSearch::CommandSearch(ActionSet& actions, QWidget* parent)
    : QDialog(parent)
    , m_actions(actions)
    , m_search(new QLineEdit(this))
    , m_list(new QListWidget(this))
    , m_nothing(new QLabel(this))
{
    setObjectName(QStringLiteral("commandSearch"));
    setWindowTitle(tr("Search commands"));
    m_search->setObjectName(QStringLiteral("commandSearch.text"));
    m_search->setAccessibleName(tr("Search commands"));
    m_search->setPlaceholderText(tr("A command, a choice, a parameter or a preset"));
    m_search->installEventFilter(this);
    m_list->setObjectName(QStringLiteral("commandSearch.list"));
    m_list->setAccessibleName(tr("Commands"));
    m_nothing->setObjectName(QStringLiteral("commandSearch.nothing"));
    m_nothing->setProperty("role", QStringLiteral("secondary"));
    m_nothing->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->addWidget(m_search);
    layout->addWidget(m_nothing);
    layout->addWidget(m_list);
    constexpr QSize kUsual(520, 420);
    resize(kUsual);
    fill();
    filter({});
    connect(m_search, &QLineEdit::textChanged, this, &CommandSearch::filter);
    connect(m_search, &QLineEdit::returnPressed, this, &CommandSearch::choose);
    connect(m_list, &QListWidget::itemClicked, this, &CommandSearch::choose);
}

QListWidgetItem* CommandSearch::add(const QString& text, const QString& words, std::function<void()> act)
{
    auto* item = new QListWidgetItem(text, m_list);
    item->setData(kWordsRole, words.isEmpty() ? text : words);
    m_acts.push_back(std::move(act));
    return item;
}

void CommandSearch::fill()
{
    addCommands();
    addParameters();
    addPresets();
}

void CommandSearch::addCommands()
{
    for (const ActionSpec& spec : actionSpecs()) {
        QAction& action = m_actions.get(spec.id);
        if (!action.isEnabled()) {
            continue;
        }
        if (spec.kind == ActionKind::Submenu) {
            for (QAction* choice : m_actions.submenu(spec.id).actions()) {
                add(fullName(spec) + QStringLiteral(": ") + choice->text().remove(QLatin1Char('&')), {}, [choice] { choice->trigger(); });
            }
            continue;
        }
        const QString keys = action.shortcut().toString(QKeySequence::NativeText);
        const QString text = fullName(spec) + (keys.isEmpty() ? QString() : QStringLiteral("    ") + keys);
        // Also by the English words, as parameters are.
        const QString words = spec.words[0] == '\0'
            ? QString()
            : QStringLiteral("%1 %2 %3").arg(text, actionText(spec.words), QLatin1String(spec.words));
        add(text, words, [&action] { action.trigger(); })->setIcon(action.icon());
    }
}

void CommandSearch::addParameters()
{
    for (const Parameter& parameter : parameterTable()) {
        add(fullLabelOf(parameter), searchTextOf(parameter), [this, key = toQString(parameter.key)] { emit parameterChosen(key); })->setToolTip(toolTipOf(parameter));
    }
}

void CommandSearch::addPresets()
{
    for (const auto& shelf : {builtinPresets(), presetsIn(userPresetFolder())}) {
        for (const LibraryEntry& entry : shelf) {
            add(tr("Preset: %1").arg(toQString(entry.id)), {}, [this, entry] { emit presetChosen(entry); });
        }
    }
}

void CommandSearch::filter(const QString& text)
{
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    int first = -1;
    for (int i = 0; i < m_list->count(); ++i) {
        const QString known = m_list->item(i)->data(kWordsRole).toString();
        const bool found = std::all_of(words.begin(), words.end(), [&](const QString& word) { return known.contains(word, Qt::CaseInsensitive); });
        m_list->item(i)->setHidden(!found);
        first = found && first < 0 ? i : first;
    }
    m_list->setCurrentRow(first);
    m_nothing->setVisible(first < 0);
    m_nothing->setText(tr("Nothing is found by “%1”. Try a part of a word, or another word.").arg(text));
}

void CommandSearch::choose()
{
    const QListWidgetItem* item = m_list->currentItem();
    if (item == nullptr || item->isHidden()) {
        return;
    }
    accept();
    m_acts[static_cast<std::size_t>(m_list->row(item))]();
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
