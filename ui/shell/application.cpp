#include "ui/shell/application.h"

#include "ui/theme/icons.h"
#include "ui/theme/language.h"
#include "ui/shell/end_signals.h"
#include "ui/shell/guarded_application.h"
#include "ui/shell/help.h"
#include "ui/shell/portable.h"
#include "ui/shell/session.h"
#include "ui/shell/system_start.h"

#include "core/base/caught.h"
#include "core/base/heap.h"
#include "core/version.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>

#include <QCommandLineParser>
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

namespace {

constexpr int kFailure = 1;
constexpr int kTryAgain = 75; ///< as fumage-cli: it may work another time

/// Says why the program ends, where it is to be seen; without memory, should there be none.
/// @return exit code
int sayCaught() noexcept
{
    try {
        const Error why = caughtError();
        sayAtEnd(("fumage: " + why.text() + '\n').c_str());
        return why.code == ErrorCode::OutOfMemory ? kTryAgain : kFailure;
    } catch (...) {
        sayAtEnd("fumage: there is not enough memory\n");
        return kTryAgain;
    }
}

/// An exception that nobody catches: in a thread of a library, or while another is on its way.
[[noreturn]] void endByException() noexcept
{
    try {
        if (const std::exception_ptr thrown = std::current_exception()) {
            std::rethrow_exception(thrown);
        }
    } catch (...) {
        std::_Exit(sayCaught());
    }
    sayAtEnd("fumage: something failed inside Fumage\n");
    std::_Exit(kFailure);
}

/// What Qt says before it would abort: that there is no display behind DISPLAY, above all.
void endByQt(QtMsgType type, const QMessageLogContext&, const QString& message)
{
    std::fprintf(stderr, "%s\n", qPrintable(message));
    if (type == QtFatalMsg) {
        sayAtEnd("fumage: no window can be opened. Start it on a desktop, or use fumage-cli, which needs no display\n");
        std::_Exit(kFailure);
    }
}

bool asksForText(const QStringList& words)
{
    for (const char* word : {"-h", "--help", "--help-all", "-v", "--version"}) {
        if (words.contains(QLatin1String(word))) {
            return true;
        }
    }
    return false;
}

/// @return nothing: go on; else the exit code
std::optional<int> checkDisplay(int argc, char** argv)
{
    QStringList words;
    for (int i = 1; i < argc; ++i) {
        words += QString::fromLocal8Bit(argv[i]);
    }
    if (hasDisplay(words)) {
        return std::nullopt;
    }
    if (asksForText(words)) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        return std::nullopt;
    }
    sayAtEnd("fumage: there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set). Start it on a desktop, or "
             "use fumage-cli, which needs none\n");
    return kFailure;
}

void applyOpenGlChoice(OpenGlChoice choice)
{
    if (choice != OpenGlChoice::Automatic && !qEnvironmentVariableIsSet("FUMAGE_OPENGL")) {
        qputenv("FUMAGE_OPENGL", choice == OpenGlChoice::Never ? "none" : "any");
    }
}

int run(int argc, char** argv)
{
    QSurfaceFormat format;
    constexpr int kMajor = 3;
    constexpr int kMinor = 3;
    format.setVersion(kMajor, kMinor);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapInterval(0); // the player keeps the time
    QSurfaceFormat::setDefaultFormat(format);
    qInstallMessageHandler(endByQt);
    GuardedApplication application(argc, argv);
    qInstallMessageHandler(nullptr);
    QApplication::setApplicationName(QStringLiteral("Fumage"));
    QApplication::setApplicationVersion(QStringLiteral(FUMAGE_VERSION));
    QApplication::setDesktopFileName(desktopFileName());
    QApplication::setWindowIcon(themedIcon(QStringLiteral("fumage")));

    usePortableFolder();
    applyLanguage(application, Settings().language());
    applyOpenGlChoice(Settings().openGl());

    QCommandLineParser parser;
    parser.setApplicationDescription(QCoreApplication::translate("main", "An editor for smoke."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("files"),
        QCoreApplication::translate("main", "Presets to open, each in a window of its own."),
        QStringLiteral("[files...]"));
    const QCommandLineOption keys(
        QStringLiteral("keys"), QCoreApplication::translate("main", "Prints the keyboard shortcuts."));
    parser.addOption(keys);
    parser.process(application);
    if (parser.isSet(keys)) {
        std::fputs(shortcutLines().toUtf8().constData(), stdout);
        return EXIT_SUCCESS;
    }

    Session session;
    std::optional<int> ended;
    const EndSignals signalled([&session, &ended](int number) {
        session.leaveWork();
        constexpr int kSignalled = 128; // as shells count
        ended = kSignalled + number;
        QApplication::exit(*ended);
    });
    QObject::connect(&application, &QGuiApplication::commitDataRequest, &session, &Session::keepWork);
    QObject::connect(&application, &QCoreApplication::aboutToQuit, &session, &Session::end);
    session.start(parser.positionalArguments());
    // A signal may come while a file that is opened has a question, whose loop of events it ends and not this one.
    return ended ? *ended : QApplication::exec();
}

} // namespace

int runEditor(int argc, char** argv)
{
    keepHeapSmall();
    prepareSystem();
    // Nothing is caught here: then nothing is unwound either, and a window that is half built, without memory, is not
    // torn down.
    std::set_terminate(endByException);
    const std::optional<int> end = checkDisplay(argc, argv);
    return end ? *end : run(argc, argv);
}

QString desktopFileName()
{
    // The id of another Flatpak is there too, where one starts this program.
    const QString id = QStringLiteral("io.github.fumage.Fumage");
    return qEnvironmentVariable("FLATPAK_ID") == id ? id : QStringLiteral("fumage");
}

} // namespace fumage::ui
