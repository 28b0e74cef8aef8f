#include "ui/document/own_file.h"

#include "ui/document/text.h"

#include "core/system/file.h"

#include <QFile>
#include <QUuid>

namespace fumage::ui {

namespace {

const QString kFile = QStringLiteral(".json");
const QString kLock = QStringLiteral(".lock");

/// A lock whose program is gone can be had; that of a running one cannot.
/// @param name without ending
std::unique_ptr<FileLock> lockOf(const QString& name)
{
    return FileLock::tryTake(toPath(name + kLock));
}

/// Programs that were killed while they took a file away leave what lay beside it.
void clearCompanions(const QDir& folder)
{
    for (const QString& name : folder.entryList({QLatin1Char('*') + kFile + QStringLiteral(".*")}, QDir::Files)) {
        const QString owner = folder.filePath(name.left(name.lastIndexOf(kFile)));
        if (!QFile::exists(owner + kFile) && lockOf(owner)) {
            QFile::remove(folder.filePath(name));
        }
    }
}

/// Programs that were killed with nothing to keep leave their lock alone.
void clearLocks(const QDir& folder)
{
    for (const QString& name : folder.entryList({QLatin1Char('*') + kLock}, QDir::Files)) {
        static_cast<void>(lockOf(folder.filePath(name).chopped(kLock.size()))); // goes with its owner, who ends here
    }
}

} // namespace

OwnFile makeOwnFile(const QDir& folder)
{
    folder.mkpath(QStringLiteral("."));
    QFile::setPermissions(folder.path(), QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
    const QString name = folder.filePath(QUuid::createUuid().toString(QUuid::WithoutBraces));
    return {name + kFile, lockOf(name)};
}

std::vector<OwnFile> takeOrphans(const QDir& folder)
{
    clearLeftovers(toPath(folder.path()));
    clearCompanions(folder);
    clearLocks(folder);
    std::vector<OwnFile> orphans;
    for (const QString& name : folder.entryList({QLatin1Char('*') + kFile}, QDir::Files, QDir::Time)) {
        const QString path = folder.filePath(name);
        if (std::unique_ptr<FileLock> lock = lockOf(path.chopped(kFile.size()))) {
            orphans.push_back({path, std::move(lock)});
        }
    }
    return orphans;
}

} // namespace fumage::ui
