#include "ui/shell/command_search.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"

#include "core/effect/shown_table.h"

#include <algorithm>

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPointer>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kPlaceRole = Qt::UserRole; ///< among all commands, in the order in which they were added

/// A text of a menu as it is read there: the sign before a letter names a key, two are the sign itself.
QString asRead(const QString& text)
{
    QString read;
    for (qsizetype i = 0; i < text.size(); ++i) {
        i += text[i] == QLatin1Char('&') && i + 1 < text.size() ? 1 : 0;
        read += text[i];
    }
    return read;
}

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

QListWidgetItem* CommandSearch::add(const QString& text, const SearchTexts& texts, std::function<void()> act)
{
    auto* item = new QListWidgetItem(text, m_list);
    item->setData(kPlaceRole, static_cast<int>(m_acts.size()));
    m_index.add(texts);
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
        const SearchTexts texts{plainText(spec.text), toQString(spec.words), plainText(spec.menu), {}};
        if (spec.kind == ActionKind::Submenu) {
            for (QAction* choice : m_actions.submenu(spec.id).actions()) {
                const QString name = asRead(choice->text());
                // It goes where the menu is filled anew, as that of recent files is when another window saves.
                add(fullName(spec) + QStringLiteral(": ") + name, {name, texts.synonyms, texts.name, texts.group},
                    [choice = QPointer<QAction>(choice)] {
                        if (choice) {
                            choice->trigger();
                        }
                    });
            }
            continue;
        }
        const QString keys = action.shortcut().toString(QKeySequence::NativeText);
        add(fullName(spec) + (keys.isEmpty() ? QString() : QStringLiteral("    ") + keys), texts,
            [&action] { action.trigger(); });
    }
}

void CommandSearch::addParameters()
{
    for (const Parameter* parameter : shownParameters()) {
        add(fullLabelOf(*parameter), searchTextsOf(*parameter), [this, key = toQString(parameter->key)] {
            emit parameterChosen(key);
        })->setToolTip(toolTipOf(*parameter));
    }
}

void CommandSearch::addPresets()
{
    for (const auto& shelf : {builtinPresets(), presetsIn(userPresetFolder())}) {
        for (const LibraryEntry& entry : shelf) {
            add(tr("Preset: %1").arg(toQString(entry.id)), {toQString(entry.id), {}, tr("Presets"), {}},
                [this, entry] { emit presetChosen(entry); });
        }
    }
}

void CommandSearch::filter(const QString& text)
{
    const bool isSearched = !text.trimmed().isEmpty();
    const std::vector<double> scores = m_index.scores(text);
    std::vector<QListWidgetItem*> items;
    while (m_list->count() > 0) {
        items.push_back(m_list->takeItem(m_list->count() - 1));
    }
    const auto place = [](const QListWidgetItem* item) {
        return static_cast<std::size_t>(item->data(kPlaceRole).toInt());
    };
    const auto isBetter = [&](const QListWidgetItem* a, const QListWidgetItem* b) {
        const auto [left, right] = isSearched ? std::pair(scores[place(a)], scores[place(b)]) : std::pair(0.0, 0.0);
        return left != right ? left > right : place(a) < place(b);
    };
    std::sort(items.begin(), items.end(), isBetter);
    int first = -1;
    for (QListWidgetItem* item : items) {
        m_list->addItem(item);
        const bool found = !isSearched || scores[place(item)] > 0.0;
        item->setHidden(!found);
        first = found && first < 0 ? m_list->row(item) : first;
    }
    m_list->setCurrentRow(first);
    m_nothing->setVisible(first < 0);
    m_nothing->setText(tr("No results for “%1”. Try a part of a word, or another word.").arg(text));
}

void CommandSearch::choose()
{
    const QListWidgetItem* item = m_list->currentItem();
    if (item == nullptr || item->isHidden()) {
        return;
    }
    accept();
    m_acts[static_cast<std::size_t>(item->data(kPlaceRole).toInt())]();
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
