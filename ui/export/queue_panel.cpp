#include "ui/export/queue_panel.h"

#include "ui/document/text.h"
#include "ui/export/queue_delegate.h"
#include "ui/export/show_folder.h"
#include "ui/theme/icons.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

QueuePanel::QueuePanel(ExportQueue& queue, AskForFile askForFile, QWidget* parent)
    : QWidget(parent)
    , m_queue(queue)
    , m_askForFile(std::move(askForFile))
    , m_list(new QListView(this))
    , m_left(new QLabel(this))
    , m_notice(makeNotice())
{
    setObjectName(QStringLiteral("queuePanel"));
    m_list->setObjectName(QStringLiteral("queue.list"));
    m_list->setAccessibleName(tr("Exports"));
    m_list->setModel(&queue);
    m_list->setItemDelegate(new QueueDelegate(m_list));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(m_notice);
    layout->addWidget(m_list, 1);
    buildActions();
    const auto followQueue = [this] { follow(); };
    connect(&queue, &QAbstractItemModel::rowsInserted, this, followQueue);
    connect(&queue, &QAbstractItemModel::rowsRemoved, this, followQueue);
    connect(&queue, &QAbstractItemModel::rowsMoved, this, followQueue);
    connect(&queue, &QAbstractItemModel::dataChanged, this, followQueue);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &QueuePanel::follow);
}

QWidget* QueuePanel::makeNotice()
{
    auto* notice = new QWidget(this);
    notice->setObjectName(QStringLiteral("queue.notice"));
    m_left->setObjectName(QStringLiteral("queue.left"));
    m_left->setWordWrap(true);
    auto* start = new QPushButton(tr("Start"), notice);
    start->setObjectName(QStringLiteral("queue.startLeft"));
    auto* remove = new QPushButton(tr("Remove"), notice);
    remove->setObjectName(QStringLiteral("queue.removeLeft"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    buttons->addStretch();
    buttons->addWidget(remove);
    buttons->addWidget(start);
    auto* layout = new QVBoxLayout(notice);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_left);
    layout->addLayout(buttons);
    connect(start, &QPushButton::clicked, &m_queue, &ExportQueue::startHeld);
    connect(remove, &QPushButton::clicked, &m_queue, &ExportQueue::removeHeld);
    return notice;
}

QAction* QueuePanel::addAction(
    const char* name, const QString& icon, const QString& text, const std::function<void(int row)>& act)
{
    auto* action = new QAction(text, this);
    action->setObjectName(QLatin1String(name));
    if (!icon.isEmpty()) {
        action->setIcon(themedIcon(icon));
    }
    connect(action, &QAction::triggered, this, [this, act] { act(row()); });
    return action;
}

void QueuePanel::buildActions()
{
    m_start = addAction("queue.start", QStringLiteral("play"), tr("Start"), [this](int row) { m_queue.start(row); });
    m_up = addAction("queue.up", QStringLiteral("up"), tr("Earlier"), [this](int row) { move(row, row - 1); });
    m_down = addAction("queue.down", QStringLiteral("down"), tr("Later"), [this](int row) { move(row, row + 2); });
    m_rename = addAction("queue.rename", {}, tr("Rename"), [this](int row) { m_list->edit(m_queue.index(row)); });
    m_stop = addAction("queue.stop", QStringLiteral("cancel"), tr("Cancel"), [this](int row) { cancelOrRemove(row); });
    m_verify =
        addAction("queue.verify", QStringLiteral("verify"), tr("Verify"), [this](int row) { m_queue.verify(row); });
    m_verify->setToolTip(tr("Verify: look whether the files are as they were written, where an export has a manifest"));
    m_folder =
        addAction("queue.folder", QStringLiteral("open"), tr("Show in folder"), [this](int row) { showInFolder(row); });
    m_again = addAction("queue.again", QStringLiteral("export"), tr("Export again, with the smoke as it is now"),
        [this](int row) { emit againRequested(m_queue.at(row).job->plan); });
    m_clear = addAction("queue.clear", {}, tr("Remove what has ended"), [this](int) { m_queue.removeEnded(); });
    m_save = addAction("queue.save", QStringLiteral("save"), tr("Save the list…"), [this](int) { saveList(); });
    m_save->setToolTip(tr("Save what is not done as a list, which fumage-cli render --jobs does without a display"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    for (QAction* action : {m_start, m_stop, m_up, m_down, m_verify, m_folder, m_again, m_save}) {
        if (action == m_verify) {
            buttons->addStretch();
        }
        auto* button = new QToolButton(this);
        button->setObjectName(action->objectName() + QStringLiteral(".button"));
        button->setDefaultAction(action);
        button->setAccessibleName(action->text());
        buttons->addWidget(button);
    }
    static_cast<QVBoxLayout*>(layout())->addLayout(buttons);
}

int QueuePanel::row() const
{
    const QModelIndex current = m_list->currentIndex();
    return current.isValid() ? current.row() : -1;
}

void QueuePanel::move(int from, int before)
{
    m_queue.moveRow({}, from, {}, before);
}

void QueuePanel::cancelOrRemove(int row)
{
    if (m_queue.at(row).isActive() || m_queue.at(row).isChecked()) {
        m_queue.cancel(row);
    } else {
        m_queue.remove(row);
    }
}

void QueuePanel::showInFolder(int row) const
{
    showFolderOf(m_queue.at(row).job->plan);
}

void QueuePanel::saveList()
{
    const QString file = m_askForFile(this,
        {.purpose = FileQuestion::Purpose::Save,
            .title = tr("Save the list of exports"),
            .start = QStringLiteral("exports.json"),
            .ending = QStringLiteral("json")});
    if (file.isEmpty()) {
        return;
    }
    if (const Status status = writeList(file, m_queue.unfinishedJobs(), FileAccess::Usual); !status) {
        emit failed(translated(status.error()));
    }
}

void QueuePanel::follow()
{
    if (!isVisible()) { // showEvent() catches up
        return;
    }
    if (const int held = m_queue.held(); held > 0) {
        m_left->setText(tr("Not finished when the program ended: %1").arg(held));
    }
    m_notice->setVisible(m_queue.held() > 0);
    const int chosen = row();
    const bool isThere = chosen >= 0 && chosen < m_queue.rowCount();
    const ExportState state = isThere ? m_queue.at(chosen).state : ExportState::Done;
    const bool isAtWork = isThere && (m_queue.at(chosen).isActive() || m_queue.at(chosen).isChecked());
    m_start->setEnabled(
        isThere && (state == ExportState::Held || state == ExportState::Failed || state == ExportState::Cancelled));
    m_stop->setEnabled(isThere);
    m_stop->setText(isThere && !isAtWork ? tr("Remove") : tr("Cancel"));
    m_verify->setEnabled(isThere && m_queue.at(chosen).canBeChecked());
    m_up->setEnabled(isThere && chosen > 0);
    m_down->setEnabled(isThere && chosen + 1 < m_queue.rowCount());
    for (QAction* action : {m_rename, m_folder, m_again}) {
        action->setEnabled(isThere);
    }
    m_save->setEnabled(m_queue.active() + m_queue.held() > 0);
    m_clear->setEnabled(m_queue.rowCount() > m_queue.active() + m_queue.held());
}

void QueuePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    follow();
}

bool QueuePanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_list && event->type() == QEvent::KeyPress
        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete && m_stop->isEnabled()) {
        m_stop->trigger();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void QueuePanel::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    menu.addActions({m_start, m_rename, m_up, m_down, m_stop});
    menu.addSeparator();
    menu.addActions({m_verify, m_folder, m_again});
    menu.addSeparator();
    menu.addActions({m_clear, m_save});
    menu.exec(event->globalPos());
}

} // namespace fumage::ui
