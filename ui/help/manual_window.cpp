#include "ui/help/manual_window.h"

#include "ui/help/manual_view.h"
#include "ui/theme/icons.h"
#include "ui/widgets/plain_text.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kPageRole = Qt::UserRole;
constexpr int kAnchorRole = Qt::UserRole + 1;

/// An entry of the contents.
void setPlace(QTreeWidgetItem& item, int page, const QString& text, const QString& anchor)
{
    item.setText(0, text);
    item.setData(0, kPageRole, page);
    item.setData(0, kAnchorRole, anchor);
}

} // namespace

ManualWindow::ManualWindow(Manual manual, QWidget* parent)
    : QDialog(parent)
    , m_manual(std::move(manual))
    , m_back(makeIconButton(this, QStringLiteral("manual.back"), QStringLiteral("back"), tr("Back (Alt+Left)")))
    , m_forward(
          makeIconButton(this, QStringLiteral("manual.forward"), QStringLiteral("forward"), tr("Forward (Alt+Right)")))
    , m_search(new QLineEdit(this))
    , m_side(new QStackedWidget(this))
    , m_contents(new QTreeWidget(this))
    , m_found(new QListWidget(this))
    , m_view(new ManualView(this))
    , m_note(new QLabel(this))
{
    setObjectName(QStringLiteral("manualWindow"));
    setWindowTitle(tr("Manual"));
    build();
    addShortcuts();
    fillContents();
    connect(m_back, &QToolButton::clicked, this, [this] { goBy(-1); });
    connect(m_forward, &QToolButton::clicked, this, [this] { goBy(1); });
    connect(m_search, &QLineEdit::textChanged, this, &ManualWindow::search);
    connect(m_search, &QLineEdit::returnPressed, this, &ManualWindow::nextHit);
    const auto open = [this](const QTreeWidgetItem* item) {
        if (item != nullptr) {
            go({item->data(0, kPageRole).toInt(), item->data(0, kAnchorRole).toString()});
        }
    };
    connect(m_contents, &QTreeWidget::currentItemChanged, this, open);
    connect(m_contents, &QTreeWidget::itemClicked, this, open); // one comes back to where one has scrolled away from
    connect(m_found, &QListWidget::currentRowChanged, this, &ManualWindow::openHit);
    connect(m_found, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { openHit(m_found->row(item)); });
    connect(m_view, &QTextBrowser::anchorClicked, this, &ManualWindow::follow);
}

void ManualWindow::build()
{
    m_contents->setObjectName(QStringLiteral("manual.contents"));
    m_contents->setAccessibleName(tr("Contents of the manual"));
    m_contents->setHeaderHidden(true);
    m_found->setObjectName(QStringLiteral("manual.hits"));
    m_found->setAccessibleName(tr("Found in the manual"));
    m_found->setWordWrap(true);
    m_note->setObjectName(QStringLiteral("manual.note"));
    m_note->setAccessibleName(tr("Message"));
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);
    m_note->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_note->hide();
    m_side->addWidget(m_contents);
    m_side->addWidget(m_found);

    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view, 1);
    column->addWidget(m_note);
    auto* split = new QSplitter(this);
    split->setObjectName(QStringLiteral("manual.split"));
    split->addWidget(m_side);
    split->addWidget(right);
    split->setChildrenCollapsible(false);
    split->setStretchFactor(1, 1);
    constexpr int kContents = 260;
    constexpr int kPage = 680;
    split->setSizes({kContents, kPage});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->addWidget(makeBar());
    layout->addWidget(split, 1);
    resize(kContents + kPage, kPage);
}

QWidget* ManualWindow::makeBar()
{
    m_search->setObjectName(QStringLiteral("manual.search"));
    m_search->setAccessibleName(tr("Search the manual"));
    m_search->setPlaceholderText(tr("Search the manual (Ctrl+F)"));
    m_search->setClearButtonEnabled(true);
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_back);
    row->addWidget(m_forward);
    row->addWidget(m_search, 1);
    for (QToolButton* button : {m_back, m_forward}) {
        button->setAutoRaise(true);
        button->setEnabled(false);
    }
    return bar;
}

void ManualWindow::addShortcuts()
{
    const auto add = [this](const QList<QKeySequence>& keys, const std::function<void()>& act) {
        auto* shortcut = new QShortcut(this);
        shortcut->setKeys(keys);
        connect(shortcut, &QShortcut::activated, this, act);
    };
    add({QKeySequence(Qt::CTRL | Qt::Key_F)}, [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    add({QKeySequence(Qt::ALT | Qt::Key_Left)}, [this] { goBy(-1); });
    add({QKeySequence(Qt::ALT | Qt::Key_Right)}, [this] { goBy(1); });
    // The plus of some layouts is above the equals sign.
    add({QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)}, [this] { m_view->zoomBy(1); });
    add({QKeySequence(Qt::CTRL | Qt::Key_Minus)}, [this] { m_view->zoomBy(-1); });
    add({QKeySequence(Qt::CTRL | Qt::Key_0)}, [this] { m_view->resetZoom(); });
}

void ManualWindow::fillContents()
{
    constexpr int kDeepest = 3; // level of headings
    for (int page = 0; page < m_manual.pages().size(); ++page) {
        const ManualPage& read = m_manual.pages()[page];
        auto* item = new QTreeWidgetItem(m_contents);
        setPlace(*item, page, read.title, {});
        bool isFirst = true; // that is the title
        for (const ManualHeading& heading : read.headings) {
            if (!isFirst && heading.level <= kDeepest) {
                setPlace(*new QTreeWidgetItem(item), page, heading.text, heading.anchor);
            }
            isFirst = false;
        }
    }
}

void ManualWindow::showAt(const QString& anchor)
{
    const std::optional<ManualPlace> found = anchor.isEmpty() ? std::nullopt : m_manual.find(anchor);
    m_search->clear();
    go(found.value_or(ManualPlace()));
    if (!found && !anchor.isEmpty()) {
        m_note->setText(tr("The manual has nothing about “%1”.").arg(anchor));
        m_note->show();
    }
}

void ManualWindow::go(const ManualPlace& place)
{
    if (m_at < 0 || !(m_way[m_at] == place)) {
        constexpr qsizetype kMaxWay = 200; // places that are kept
        m_way = m_way.mid(std::max<qsizetype>(0, m_at + 1 - kMaxWay), std::min<qsizetype>(m_at + 1, kMaxWay));
        m_way += place;
        m_at = static_cast<int>(m_way.size()) - 1;
    }
    showPlace();
}

void ManualWindow::goBy(int steps)
{
    const int next = m_at + steps;
    if (next >= 0 && next < m_way.size()) {
        m_at = next;
        showPlace();
    }
}

void ManualWindow::showPlace()
{
    const ManualPlace& now = m_way[m_at];
    if (now.page != m_shownPage) {
        m_view->showPage(m_manual, now.page);
        m_shownPage = now.page;
    }
    m_note->hide();
    if (!m_view->goTo(now.anchor)) {
        m_note->setText(tr("This page has no place “%1”.").arg(now.anchor));
        m_note->show();
    }
    m_view->mark(std::nullopt, {});
    m_back->setEnabled(m_at > 0);
    m_forward->setEnabled(m_at + 1 < m_way.size());
    const ManualPage& page = m_manual.pages()[now.page];
    setWindowTitle(tr("%1 — Manual").arg(plainTitle(page.title)));
    const QSignalBlocker blocker(m_contents);
    QTreeWidgetItem* item = m_contents->topLevelItem(now.page);
    const int position = m_view->positionOf(now.anchor); // a heading may have several anchors
    for (int i = 0; position >= 0 && i < item->childCount(); ++i) {
        if (m_view->positionOf(item->child(i)->data(0, kAnchorRole).toString()) == position) {
            item = item->child(i);
            break;
        }
    }
    m_contents->setCurrentItem(item);
}

void ManualWindow::follow(const QUrl& link)
{
    if (const std::optional<ManualPlace> place = m_manual.follow(m_shownPage, link.toString(QUrl::FullyEncoded))) {
        go(*place);
        return;
    }
    m_note->setText(tr("This leads out of the manual, and is not opened: %1").arg(link.toDisplayString()));
    m_note->show();
}

void ManualWindow::search(const QString& words)
{
    const bool isSearched = wordsPattern(words).has_value();
    m_hits = searchManual(m_manual.pages(), words);
    const QSignalBlocker blocker(m_found);
    m_found->clear();
    for (const ManualHit& hit : std::as_const(m_hits)) {
        const ManualPage& page = m_manual.pages()[hit.page];
        const QString heading = hit.heading < 1 ? QString() : page.headings[hit.heading].text;
        const QString place = heading.isEmpty() ? page.title : tr("%1: %2").arg(page.title, heading);
        m_found->addItem(hit.line == heading || hit.line.isEmpty() ? place : place + QLatin1Char('\n') + hit.line);
    }
    m_side->setCurrentWidget(isSearched ? static_cast<QWidget*>(m_found) : m_contents);
    m_note->setVisible(isSearched && m_hits.isEmpty());
    m_note->setText(tr("No results for “%1”. Try a part of a word, or another word.").arg(words));
    if (!isSearched) {
        m_view->mark(std::nullopt, {});
    }
}

void ManualWindow::openHit(int row)
{
    if (row < 0 || row >= m_hits.size()) {
        return;
    }
    const ManualHit& hit = m_hits[row];
    const ManualPage& page = m_manual.pages()[hit.page];
    const QString anchor = hit.heading < 0 ? QString() : page.headings[hit.heading].anchor;
    go({hit.page, anchor});
    m_view->mark(wordsPattern(m_search->text()), anchor);
}

void ManualWindow::nextHit()
{
    if (!m_hits.isEmpty()) {
        m_found->setCurrentRow((m_found->currentRow() + 1) % static_cast<int>(m_hits.size()));
    }
}

} // namespace fumage::ui
