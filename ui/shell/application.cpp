#include "ui/shell/application.h"

#include "ui/face/language.h"
#include "ui/shell/guarded_application.h"
#include "ui/shell/session.h"

#include "core/version.h"

#include <csignal>

#include <QCommandLineParser>
#include <QIcon>
#include <QSurfaceFormat>

/// What Qt's parser says, and has no catalogue for in every language of ours: ours has it.
[[maybe_unused]] static constexpr const char* kSaidByQt[] = {
    QT_TRANSLATE_NOOP("QCommandLineParser", "Usage: %1"),
    QT_TRANSLATE_NOOP("QCommandLineParser", "[options]"),
    QT_TRANSLATE_NOOP("QCommandLineParser", "Options:"),
    QT_TRANSLATE_NOOP("QCommandLineParser", "Arguments:"),
    QT_TRANSLATE_NOOP("QCommandLineParser", "Displays help on commandline options."),
    QT_TRANSLATE_NOOP("QCommandLineParser", "Displays help including Qt specific options."),
    QT_TRANSLATE_NOOP("QCommandLineParser", "Displays version information."),
    QT_TRANSLATE_NOOP("QCommandLineParser", "Unknown option '%1'."),
    QT_TRANSLATE_NOOP("QCommandLineParser", "Unknown options: %1."),
    QT_TRANSLATE_NOOP("QCommandLineParser", "Missing value after '%1'."),
    QT_TRANSLATE_NOOP("QCommandLineParser", "Unexpected value after '%1'."),
};

namespace fumage::ui {

int runEditor(int argc, char** argv)
{
    QSurfaceFormat format;
    constexpr int kMajor = 3;
    constexpr int kMinor = 3;
    format.setVersion(kMajor, kMinor);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapInterval(0); // the player keeps the time
    QSurfaceFormat::setDefaultFormat(format);
#ifdef SIGXFSZ // Windows has no such limit
    std::signal(SIGXFSZ, SIG_IGN); // writing says it too, and then the user hears of it
#endif
    GuardedApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("Fumage"));
    QApplication::setApplicationVersion(QStringLiteral(FUMAGE_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("fumage"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/fumage.svg")));

    applyLanguage(application, Settings().language());

    QCommandLineParser parser;
    parser.setApplicationDescription(QCoreApplication::translate("main", "An editor for smoke."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("files"), QCoreApplication::translate("main", "Presets to open, each in a window of its own."), QStringLiteral("[files...]"));
    parser.process(application);

    Session session;
    session.start(parser.positionalArguments());
    return QApplication::exec();
}

} // namespace fumage::ui
