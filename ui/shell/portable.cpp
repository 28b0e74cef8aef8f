#include "ui/shell/portable.h"

#include "ui/document/text.h"

#include "core/system/environment.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>
#include <QTemporaryFile>

namespace fumage::ui {

namespace {

/// Whether files can be made in a folder: what it says of itself is not enough where access lists decide.
bool takesFiles(const QString& folder)
{
    return QTemporaryFile(folder + QStringLiteral("/.fumage-XXXXXX")).open();
}

QString findPortableFolder()
{
    const QFileInfo folder(QCoreApplication::applicationDirPath() + QStringLiteral("/fumage-data"));
    return folder.isDir() && takesFiles(folder.absoluteFilePath()) ? folder.absoluteFilePath() : QString();
}

} // namespace

QString portableFolder()
{
    static const QString kFolder = findPortableFolder();
    return kFolder;
}

void usePortableFolder()
{
    const QString folder = portableFolder();
    if (!folder.isEmpty()) {
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
        setUserDataFolder(toPath(folder));
    }
}

} // namespace fumage::ui
