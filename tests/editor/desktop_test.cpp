// What the desktop knows the program by: one name in its entry, its windows, its metainfo and its Flatpak.
#include "ui/shell/application.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

namespace {

/// @param path in the source tree
QString text(const QString& path)
{
    QFile file(QStringLiteral(FUMAGE_SOURCE_DIR "/") + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The first thing in a file that a pattern catches; empty: there is none.
QString found(const QString& path, const QString& pattern)
{
    return QRegularExpression(pattern, QRegularExpression::MultilineOption).match(text(path)).captured(1);
}

const QString kManifest = QStringLiteral("cmake/flatpak/io.github.fumage.Fumage.yaml");
const QString kMetainfo = QStringLiteral("resources/desktop/io.github.fumage.Fumage.metainfo.xml");

} // namespace

class DesktopTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { qunsetenv("FLATPAK_ID"); }

    void itsWindowsAreThoseOfTheEntryThatIsInstalled()
    {
        qunsetenv("FLATPAK_ID");
        const QString entry = fumage::ui::desktopFileName() + QStringLiteral(".desktop");
        QVERIFY(!text(QStringLiteral("resources/desktop/") + entry).isEmpty());
        QCOMPARE(found(kMetainfo, QStringLiteral("<launchable type=\"desktop-id\">(.*)</launchable>")), entry);
        QCOMPARE(found(kManifest, QStringLiteral("^rename-desktop-file: (.*)$")), entry);
        // Of another Flatpak that has started it.
        qputenv("FLATPAK_ID", "org.example.Terminal");
        QCOMPARE(fumage::ui::desktopFileName() + QStringLiteral(".desktop"), entry);
    }

    void inTheFlatpakTheyAreThoseOfItsEntry()
    {
        const QString id = found(kManifest, QStringLiteral("^id: (.*)$"));
        QVERIFY(!id.isEmpty());
        qputenv("FLATPAK_ID", id.toUtf8());
        QCOMPARE(fumage::ui::desktopFileName(), id);
        QCOMPARE(found(kMetainfo, QStringLiteral("<id>(.*)</id>")), id);
    }

    void onX11TheEntryNamesTheClassOfItsWindows()
    {
        // Qt takes the name of the application for it, whatever the entry is called.
        QCOMPARE(found(QStringLiteral("resources/desktop/fumage.desktop"), QStringLiteral("^StartupWMClass=(.*)$")),
            QStringLiteral("Fumage"));
    }
};

QTEST_GUILESS_MAIN(DesktopTest)
#include "desktop_test.moc"
