#include "ui/export/export_queue.h"

#include "ui/document/text.h"
#include "ui/export/file_conflict.h"
#include "ui/widgets/plain_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fumage::ui {

namespace {

/// More of those that are done are forgotten, the oldest first.
constexpr int kMaxEnded = 100;

} // namespace

ExportQueue::ExportQueue(const QDir& folder, std::shared_ptr<AirCache> shelf, QObject* parent)
    : QAbstractListModel(parent)
    , m_folder(folder)
    , m_shelf(std::move(shelf))
    , m_file(folder)
    , m_starts([this] {
        return jobsThat([](const QueuedExport& one) { return one.isActive() && one.state != ExportState::Starting; });
    })
{
    connect(&m_file, &QueueFile::failed, this, &ExportQueue::notKept);
    connect(&m_worker, &ExportWorker::progressed, this, [this](int done, int total, double secondsLeft) {
        const QString files = tr("%1 of %2").arg(done).arg(total);
        follow(done, total, secondsLeft < 0.0 ? files : tr("%1, %2 s left").arg(files).arg(std::ceil(secondsLeft)));
    });
    connect(&m_worker, &ExportWorker::preparing, this, [this](const QString& what) { follow(0, 0, what); });
    connect(
        &m_worker, &ExportWorker::finished, this, [this](const QString& remark) { end(ExportState::Done, remark); });
    connect(&m_worker, &ExportWorker::cancelled, this, [this] { end(ExportState::Cancelled, {}); });
    connect(&m_starts, &StartCheck::answered, this, &ExportQueue::takeAnswer);
    connect(&m_check, &ExportCheck::marked, this, &ExportQueue::takeMark);
    connect(
        &m_worker, &ExportWorker::failed, this, [this](const QString& message) { end(ExportState::Failed, message); });
}

ExportQueue::~ExportQueue() = default;

int ExportQueue::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_exports.size());
}

QVariant ExportQueue::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const QueuedExport& one = at(index.row());
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole: return toQString(one.job->name);
    case Qt::ToolTipRole: return plainToolTip(tipOf(one));
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1, %2").arg(toQString(one.job->name), wholeTextOf(one, QStringLiteral(", ")));
    case StateRole: return static_cast<int>(one.state);
    case ShareRole: return shareOf(one);
    case CheckRole: return static_cast<int>(one.check.state);
    case ToldRole: return lineOf(one);
    case PlaceRole: return placeOf(one.job->plan);
    default: return {};
    }
}

bool ExportQueue::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const QString name = value.toString().simplified();
    if (role != Qt::EditRole || name.isEmpty() || !checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return false;
    }
    QueuedExport& one = m_exports[static_cast<std::size_t>(index.row())];
    auto renamed = std::make_shared<ExportJob>(*one.job);
    renamed->name = shortened(name, 200).toStdString();
    one.job = std::move(renamed);
    emit dataChanged(index, index);
    emit changed(one.id);
    keep();
    return true;
}

Qt::ItemFlags ExportQueue::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags usual = QAbstractListModel::flags(index);
    return index.isValid() ? usual | Qt::ItemIsEditable | Qt::ItemIsDragEnabled | Qt::ItemNeverHasChildren
                           : usual | Qt::ItemIsDropEnabled;
}

bool ExportQueue::moveRows(const QModelIndex& source, int row, int count, const QModelIndex& target, int before)
{
    const bool isThere = row >= 0 && count == 1 && row < rowCount() && before >= 0 && before <= rowCount();
    if (!isThere || !beginMoveRows(source, row, row, target, before)) {
        return false;
    }
    const auto from = m_exports.begin() + row;
    if (before > row) {
        std::rotate(from, from + 1, m_exports.begin() + before);
    } else {
        std::rotate(m_exports.begin() + before, from, from + 1);
    }
    endMoveRows();
    keep();
    return true;
}

const QueuedExport* ExportQueue::find(quint64 id) const
{
    const int row = rowOf(id);
    return row < 0 ? nullptr : &at(row);
}

int ExportQueue::rowOf(quint64 id) const
{
    const auto found =
        std::find_if(m_exports.begin(), m_exports.end(), [&](const QueuedExport& one) { return one.id == id; });
    return found == m_exports.end() ? -1 : static_cast<int>(found - m_exports.begin());
}

int ExportQueue::running() const
{
    const auto found = std::find_if(
        m_exports.begin(), m_exports.end(), [](const QueuedExport& one) { return one.state == ExportState::Running; });
    return found == m_exports.end() ? -1 : static_cast<int>(found - m_exports.begin());
}

int ExportQueue::active() const
{
    return static_cast<int>(
        std::count_if(m_exports.begin(), m_exports.end(), [](const QueuedExport& one) { return one.isActive(); }));
}

int ExportQueue::held() const
{
    return static_cast<int>(std::count_if(
        m_exports.begin(), m_exports.end(), [](const QueuedExport& one) { return one.state == ExportState::Held; }));
}

template <class IsMeant>
ExportJobs ExportQueue::jobsThat(const IsMeant& areMeant) const
{
    ExportJobs jobs;
    for (const QueuedExport& one : m_exports) {
        if (areMeant(one)) {
            jobs.push_back(one.job);
        }
    }
    return jobs;
}

ExportJobs ExportQueue::activeJobs() const
{
    return jobsThat([](const QueuedExport& one) { return one.isActive(); });
}

ExportJobs ExportQueue::unfinishedJobs() const
{
    return jobsThat([](const QueuedExport& one) { return one.isUnfinished(); });
}

Result<quint64> ExportQueue::add(ExportJob job)
{
    if (unfinishedJobs().size() >= kMaxJobs) {
        return Error{ErrorCode::TooLarge, makeMessage("%1 exports are waiting already", kMaxJobs), {},
            makeMessage("Wait until some are done, or remove some")};
    }
    append(std::make_shared<const ExportJob>(std::move(job)), ExportState::Waiting);
    const quint64 id = m_lastId;
    forgetOldest();
    emit changed(id);
    goOn();
    keep();
    return id;
}

void ExportQueue::forgetOldest()
{
    auto ended =
        std::count_if(m_exports.begin(), m_exports.end(), [](const QueuedExport& one) { return !one.isUnfinished(); });
    removeAll([&](const QueuedExport& one) { return !one.isUnfinished() && ended-- > kMaxEnded; });
}

void ExportQueue::append(std::shared_ptr<const ExportJob> job, ExportState state)
{
    beginInsertRows({}, rowCount(), rowCount());
    m_exports.push_back({.id = ++m_lastId, .job = std::move(job), .state = state, .told = usualText(state)});
    endInsertRows();
}

void ExportQueue::start(int row)
{
    const ExportState state = at(row).state;
    if (state != ExportState::Held && state != ExportState::Failed && state != ExportState::Cancelled) {
        return;
    }
    setState(row, ExportState::Starting);
    m_starts.start(at(row).id, at(row).job);
    keep();
}

void ExportQueue::takeAnswer(quint64 id, const Status& apart)
{
    const int row = rowOf(id);
    if (row < 0 || at(row).state != ExportState::Starting) {
        return;
    }
    setState(row, apart ? ExportState::Waiting : ExportState::Failed,
        apart ? QString() : fumage::ui::translated(apart.error()));
    goOn();
    keep();
    if (active() == 0) {
        emit emptied();
    }
}

void ExportQueue::startHeld()
{
    for (int row = 0; row < rowCount(); ++row) {
        if (at(row).state == ExportState::Held) {
            start(row);
        }
    }
}

void ExportQueue::cancel(int row)
{
    switch (at(row).state) {
    case ExportState::Running: m_worker.cancel(); break; // and it says so when it has ended
    case ExportState::Starting:
    case ExportState::Waiting:
    case ExportState::Held:
        m_starts.giveUp(at(row).id);
        setState(row, ExportState::Cancelled);
        keep();
        break;
    case ExportState::Done: m_check.giveUp(at(row).id); break;
    default: break;
    }
}

template <class IsMeant>
void ExportQueue::removeAll(const IsMeant& isMeant)
{
    for (int row = 0; row < rowCount();) {
        if (at(row).state == ExportState::Running || !isMeant(at(row))) {
            ++row;
            continue;
        }
        m_check.giveUp(at(row).id);
        m_starts.giveUp(at(row).id);
        beginRemoveRows({}, row, row);
        m_exports.erase(m_exports.begin() + row);
        endRemoveRows();
    }
}

void ExportQueue::remove(int row)
{
    removeAll([id = at(row).id](const QueuedExport& one) { return one.id == id; });
    keep();
}

void ExportQueue::removeEnded()
{
    removeAll([](const QueuedExport& one) { return !one.isUnfinished(); });
}

void ExportQueue::removeHeld()
{
    removeAll([](const QueuedExport& one) { return one.state == ExportState::Held; });
    keep();
}

void ExportQueue::stopAll()
{
    removeAll([](const QueuedExport& one) {
        return one.state == ExportState::Starting || one.state == ExportState::Waiting;
    });
    m_worker.cancel();
    if (const int row = running(); row >= 0) {
        setState(row, ExportState::Cancelled); // the program may end before its thread has: nothing is to be left of it
                                               // on the disk
    }
    keep();
}

QStringList ExportQueue::takeLeftovers()
{
    QueueFile::Leftovers left = QueueFile::find(m_folder);
    std::vector<OwnFile> taken;
    m_crowdedOut = 0;
    for (QueueFile::LeftList& list : left.lists) {
        if (unfinishedJobs().size() + list.jobs.size() > kMaxJobs) {
            m_crowdedOut += static_cast<int>(list.jobs.size()); // their file stays, for whoever starts next
            continue;
        }
        for (const std::shared_ptr<const ExportJob>& job : list.jobs) {
            append(job, ExportState::Held);
        }
        taken.push_back(std::move(list.file));
    }
    if (!taken.empty()) {
        m_file.takeOver(unfinishedJobs(), std::move(taken));
    }
    return left.unreadable;
}

void ExportQueue::goOn()
{
    if (m_worker.isRunning()) {
        return;
    }
    const auto next = std::find_if(
        m_exports.begin(), m_exports.end(), [](const QueuedExport& one) { return one.state == ExportState::Waiting; });
    if (next == m_exports.end()) {
        return;
    }
    next->done = next->total = 0;
    const std::shared_ptr<const ExportJob> job = next->job;
    setState(static_cast<int>(next - m_exports.begin()), ExportState::Running);
    dropMarks(job->plan);
    m_worker.start(job, m_shelf);
}

void ExportQueue::setState(int row, ExportState state, const QString& told)
{
    QueuedExport& one = m_exports[static_cast<std::size_t>(row)];
    one.state = state;
    one.told = told.isEmpty() ? usualText(state) : told;
    emit dataChanged(index(row), index(row));
    emit changed(one.id);
}

void ExportQueue::follow(int done, int total, const QString& told)
{
    const int row = running();
    if (row < 0) {
        return;
    }
    QueuedExport& one = m_exports[static_cast<std::size_t>(row)];
    one.done = done;
    one.total = total;
    setState(row, ExportState::Running, told);
}

void ExportQueue::end(ExportState state, const QString& told)
{
    const int row = running();
    const quint64 id = row < 0 ? 0 : at(row).id;
    if (row >= 0) {
        m_exports[static_cast<std::size_t>(row)].remark = state == ExportState::Done ? told : QString();
        setState(row, state, told);
        dropMarks(at(row).job->plan); // of files that were looked at while they were written
    }
    goOn();
    keep();
    if (id != 0) {
        emit ended(id);
    }
    if (active() == 0) {
        emit emptied();
    }
}

void ExportQueue::verify(int row)
{
    if (at(row).canBeChecked()) {
        m_check.start(at(row).id, at(row).job);
    }
}

void ExportQueue::takeMark(quint64 id, const CheckMark& mark)
{
    if (const int row = rowOf(id); row >= 0) {
        m_exports[static_cast<std::size_t>(row)].check = mark;
        emit dataChanged(index(row), index(row));
    }
}

void ExportQueue::dropMarks(const ExportPlan& written)
{
    for (int row = 0; row < rowCount(); ++row) {
        if (at(row).check.state != CheckState::None && mayShareFiles(at(row).job->plan, written)) {
            m_check.giveUp(at(row).id);
            takeMark(at(row).id, {});
        }
    }
}

void ExportQueue::keep()
{
    m_file.keep(unfinishedJobs());
}

} // namespace fumage::ui
