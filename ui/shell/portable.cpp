#include "ui/shell/portable.h"

#include "ui/document/text.h"

#include "core/system/environment.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>

namespace fumage::ui {

QString portableFolder()
{
    const QFileInfo folder(QCoreApplication::applicationDirPath() + QStringLiteral("/fumage-data"));
    return folder.isDir() ? folder.absoluteFilePath() : QString();
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
