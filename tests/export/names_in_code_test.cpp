// Names of files, folders, presets and markers in what is written for engines and farms: the languages' own readers
// find the very names, and nothing else.

#include "tests/effects.h"
#include "tests/export/hostile_names.h"

#include "core/system/file.h"
#include "core/system/path.h"
#include "core/export/engines/engine_files.h"
#include "core/export/farm/farm.h"
#include "core/export/templates/language.h"

#include <QDir>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest/QtTest>

#include <set>

using namespace fumage;
using namespace fumage::tests;

namespace {

struct Reader {
    Language language;
    const char* name;
};
constexpr std::array kReaders{Reader{Language::CSharp, "csharp"}, Reader{Language::Python, "python"},
    Reader{Language::Json, "json"}, Reader{Language::JavaScript, "javascript"}, Reader{Language::Godot, "godot"},
    Reader{Language::Protobuf, "protobuf"}, Reader{Language::Xml, "xml"}, Reader{Language::Html, "html"},
    Reader{Language::Shell, "shell"}};

/// What a language makes of a name that it cannot hold as it is.
QString held(Language language, const std::string& name)
{
    const bool isMarkup = language == Language::Xml || language == Language::Html;
    std::u32string all = U"x"; // before it a mark of the byte order stays
    for (const char32_t c : QString::fromStdString("x" + name).mid(1).toStdU32String()) {
        const bool isControl = (c < 0x20 && c != '\t' && c != '\n') || (c >= 0x7F && c < 0xA0);
        const bool isNone = (c & 0xFFFEU) == 0xFFFE || (c >= 0xFDD0 && c <= 0xFDEF);
        all += isMarkup && (isControl || isNone) ? char32_t(0xFFFD) : c;
    }
    return QString::fromStdU32String(all).mid(1);
}

std::vector<SheetEvent> eventsNamed(const std::string& name)
{
    return {{name, 0.25, 3}, {name, 0.5, 7}};
}

/// A sheet whose pictures have a name, without its pixels.
std::vector<std::string> textsFor(Engine engine, const std::string& name, const std::vector<SheetEvent>& events)
{
    static const Effect effect = thesisEffect(10);
    EngineSheet sheet{effect, 4, 2, 15.0, false, styleFor(engine, ImageFormat::Png8), {}, {}};
    for (const Pass pass : {Pass::Colour, Pass::SixWayA, Pass::SixWayB, Pass::Motion}) {
        const std::string ending =
            pass == Pass::Colour ? ".png" : std::string("_").append(fileNameOf(pass)).append(".png");
        sheet.pictures.push_back({pass, pathFrom(name + ending), {}, pass == Pass::Colour, pass == Pass::Motion});
    }
    sheet.events = events;
    return makeEngineFiles(engine, sheet);
}

/// The same of one with markers, which have that name, too.
std::vector<std::string> textsFor(Engine engine, const std::string& name)
{
    return textsFor(engine, name, eventsNamed(name));
}

FarmJob jobNamed(const std::string& name)
{
    FarmJob job;
    job.folder = pathFrom("/mnt/" + name);
    job.name = name;
    job.output = name + "_####.exr";
    job.frames = {10, 31, 2};
    job.perTask = 4;
    job.joinWords = {"join", "./" + name + ".fumage.json", "--output", "./" + name + ".mp4"};
    return job;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// A name that stands as it is where it is written, and differs where it is shown and where it names things in
/// programs.
const std::string kPlain = "S~NTINEL";

/// What a text with the plain name in it is with another, if each place goes through the language.
std::string withName(std::string text, Language language, const std::string& name)
{
    replaceAll(text, identifierOf(kPlain), "\x01");
    replaceAll(text, labelOf(kPlain), "\x02");
    replaceAll(text, kPlain, "\x03");
    replaceAll(text, "\x03", written(language, name)); // names have \x01 to \x03, too; what is written of them has not
    replaceAll(text, "\x02", written(language, labelOf(name)));
    replaceAll(text, "\x01", identifierOf(name));
    return text;
}

Language languageOf(Engine engine)
{
    switch (engine) {
    case Engine::Unity: return Language::CSharp;
    case Engine::Unreal: return Language::Python;
    case Engine::Effekseer: return Language::Xml;
    case Engine::Defold: return Language::Protobuf;
    case Engine::Web: return Language::Html;
    case Engine::Generic:
    case Engine::Pixi: // JSON of a library
    case Engine::Godot:
    case Engine::Godot3: break;
    }
    return Language::Godot;
}

bool run(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    const bool done = process.waitForFinished(120'000) && process.exitCode() == 0;
    if (!done) {
        qWarning("%s", process.readAllStandardError().left(2000).constData());
    }
    return done;
}

} // namespace

class NamesInCodeTest : public QObject {
    Q_OBJECT

private slots:
    void everyLanguageReadsTheVeryName()
    {
        const QTemporaryDir folder;
        const std::vector<std::string> names = hostileNames();
        for (const Reader& reader : kReaders) {
            std::string lines;
            for (const std::string& name : names) {
                lines += written(reader.language, name) + "\n";
            }
            QCOMPARE(static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')), names.size());
            QVERIFY(writeFileAtomically(folder.filePath(QString(reader.name) + ".txt").toStdString(), lines).ok());
        }
        QVERIFY(run("python3", {FUMAGE_READ_NAMES, folder.path()}));
        for (const Reader& reader : kReaders) {
            QFile file(folder.filePath(QString(reader.name) + ".hex"));
            if (!file.open(QFile::ReadOnly)) {
                qWarning("%s has no reader here", reader.name); // compilers that the tests do without
                continue;
            }
            const QList<QByteArray> read = file.readAll().split('\n');
            QCOMPARE(static_cast<std::size_t>(read.size()), names.size() + 1);
            for (std::size_t i = 0; i < names.size(); ++i) {
                const bool keepsBytes = reader.language == Language::Shell;
                const QByteArray wanted =
                    keepsBytes ? QByteArray::fromStdString(names[i]) : held(reader.language, names[i]).toUtf8();
                const QByteArray found = QByteArray::fromHex(read[static_cast<qsizetype>(i)]);
                const bool isGodots = reader.language == Language::Godot
                    && found.contains("\xEF\xBF\xBD"); // it has no escape for what is not seen
                QVERIFY2(isGodots || found == wanted,
                    (std::string(reader.name) + ": " + written(reader.language, names[i]) + " is read as "
                        + found.toHex(' ').toStdString())
                        .c_str());
            }
        }
    }

    void namesStandInScriptsAsTheirLanguageWritesThem_data()
    {
        QTest::addColumn<int>("engine");
        for (const Engine engine : kAllEngines) {
            if (engine != Engine::Generic && engine != Engine::Pixi) {
                QTest::newRow(std::string(nameOf(engine)).c_str()) << static_cast<int>(engine);
            }
        }
    }
    void namesStandInScriptsAsTheirLanguageWritesThem()
    {
        QFETCH(int, engine);
        const auto which = static_cast<Engine>(engine);
        const std::vector<std::string> plain = textsFor(which, kPlain);
        QVERIFY(plain.front().find(kPlain) != std::string::npos);
        const std::string without = textsFor(which, kPlain, {}).front();
        QCOMPARE(without != plain.front(), which != Engine::Effekseer && which != Engine::Defold);
        for (const std::string& name : hostileNames()) {
            const std::vector<std::string> texts = textsFor(which, name);
            QCOMPARE(texts.size(), plain.size());
            for (std::size_t i = 0; i < texts.size(); ++i) {
                QCOMPARE(texts[i], withName(plain[i], languageOf(which), name));
            }
        }
    }

    void compilersReadEveryScript()
    {
        const QTemporaryDir folder;
        QStringList scripts[2];
        for (const std::string& name : hostileNames()) {
            for (const Engine engine : {Engine::Unity, Engine::Unreal}) {
                QStringList& list = scripts[engine == Engine::Unity ? 0 : 1];
                list << folder.filePath(QString::number(list.size()) + (engine == Engine::Unity ? ".cs" : ".py"));
                QVERIFY(writeFileAtomically(list.back().toStdString(), textsFor(engine, name).front()).ok());
            }
        }
        const QString check = "import ast, sys\n"
                              "shapes = {tuple(type(each).__name__ for each in ast.parse(open(file, "
                              "encoding='utf-8').read()).body) for file in sys.argv[1:]}\n"
                              "assert len(shapes) == 1, shapes\n";
        QVERIFY(run("python3", QStringList{"-c", check} + scripts[1]));
        if (QStandardPaths::findExecutable("mcs").isEmpty()) {
            QSKIP("there is no C# compiler");
        }
        QVERIFY(run("mcs", QStringList{"--parse", "-define:UNITY_EDITOR"} + scripts[0]));
    }

    void farmsGetTheVeryNames_data()
    {
        QTest::addColumn<int>("farm");
        for (const Farm farm : kAllFarms) {
            QTest::newRow(std::string(nameOf(farm)).c_str()) << static_cast<int>(farm);
        }
    }
    /// Words of a shell do not stand in a text as a part of it: bash says what they are.
    void farmsGetTheVeryNames()
    {
        QFETCH(int, farm);
        const auto which = static_cast<Farm>(farm);
        const QTemporaryDir folder;
        const FarmFiles plain = makeFarmFiles(which, jobNamed(kPlain)).value();
        std::size_t made = 0;
        QStringList scripts;
        for (const std::string& name : hostileNames()) {
            if (name.size() > 100) {
                continue; // farms show the first hundred bytes
            }
            const Result<FarmFiles> files = makeFarmFiles(which, jobNamed(name));
            if (!files) {
                QVERIFY2(which == Farm::Deadline || which == Farm::OpenJd, files.error().text().c_str());
                continue;
            }
            ++made;
            for (std::size_t i = 0; i < files.value().files.size(); ++i) {
                const std::string& text = files.value().files[i].contents;
                const std::string& before = plain.files[i].contents;
                if (before.starts_with("#!")) {
                    QCOMPARE(
                        std::count(text.begin(), text.end(), '\n'), std::count(before.begin(), before.end(), '\n'));
                    scripts << folder.filePath(QString::number(scripts.size()) + ".sh");
                    QVERIFY(writeFileAtomically(scripts.back().toStdString(), text).ok());
                } else if (which != Farm::Deadline) {
                    QCOMPARE(
                        text, withName(before, which == Farm::OpenJd ? Language::Json : Language::JavaScript, name));
                } else {
                    QCOMPARE(
                        std::count(text.begin(), text.end(), '\n'), std::count(before.begin(), before.end(), '\n'));
                    QVERIFY2(text.find("StartupDirectory=/mnt/" + name + "\n") != std::string::npos
                            || text.find("OutputDirectory0=/mnt/" + name + "\n") != std::string::npos,
                        text.c_str());
                }
            }
        }
        QVERIFY2(made > 40, std::to_string(made).c_str());
        if (!scripts.isEmpty()) {
            QVERIFY(run("bash",
                QStringList{"-c",
                    "for script; do source /dev/stdin <<< \"unread() { $(< \"$script\")\n}\" || exit 1; done", "bash"}
                    + scripts));
        }
    }

    void namesOfProgramsDiffer()
    {
        std::vector<std::string> names = hostileNames();
        names.insert(names.end(), {"fire ball", "fire_ball", "fire-ball", "1", "sheet_1", "\u70df", "\u4e91", "class"});
        std::set<std::string> seen;
        for (const std::string& name : std::set<std::string>(names.begin(), names.end())) {
            const std::string id = identifierOf(name);
            QVERIFY2(seen.insert(id).second, id.c_str());
            QVERIFY(std::all_of(id.begin(), id.end(), [](unsigned char c) {
                return c < 128 && (std::isalnum(c) != 0 || c == '_');
            }) && std::isalpha(static_cast<unsigned char>(id[0])) != 0);
        }
        QCOMPARE(identifierOf("smoke_4x2"), std::string("smoke_4x2"));
    }
};

QTEST_GUILESS_MAIN(NamesInCodeTest)
#include "names_in_code_test.moc"
