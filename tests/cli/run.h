#pragma once

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

namespace fumage::tests {

struct Outcome {
    int code = -1;
    QByteArray out;
    QByteArray error;
};

inline Outcome run(const QStringList& arguments, const QString& wrapper = {})
{
    QProcess process;
    if (wrapper.isEmpty()) {
        process.start(FUMAGE_CLI, arguments);
    } else {
        process.start("bash", QStringList{"-c", wrapper, FUMAGE_CLI} + arguments);
    }
    process.waitForFinished(120000);
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardOutput(),
        process.readAllStandardError()};
}

inline Outcome runIn(const QTemporaryDir& folder, const QStringList& arguments)
{
    return run(arguments, "cd '" + folder.path() + "' && \"$0\" \"$@\"");
}

inline const QStringList kSmall{
    "--size", "48", "--set", "emitter.count=500", "--set", "noise.slices=4", "--set", "noise.resolution=16"};

/// Hash of everything in a folder.
inline QByteArray contents(const QString& folder)
{
    QByteArray all;
    const QDir dir(folder);
    for (const QString& name : dir.entryList(QDir::Files, QDir::Name)) {
        QFile file(dir.filePath(name));
        if (file.open(QIODevice::ReadOnly)) {
            all += name.toUtf8() + file.readAll();
        }
    }
    return all;
}

} // namespace fumage::tests
