// The command line as its users meet it: usage, bad values and files, answers.

#include "tests/cli/refusals.h"
#include "tests/helpers.h"
#include "tests/pictures.h"

#include "core/system/file.h"
#include "core/effect/parameter_table.h"
#include "core/preset/preset_file.h"
#include "core/scene/key_assignment.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

using namespace fumage;
using namespace fumage::tests;

class CliTest : public QObject {
    Q_OBJECT

private slots:
    /// What a table says is what is said.
    void keyFramesAreReadFromATable()
    {
        const QTemporaryDir folder;
        const auto write = [&](const char* name, const QByteArray& bytes) {
            QFile file(folder.filePath(QString::fromLatin1(name)));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        };
        write("way.csv", "seconds,x,y,z\n0,0,0,0\n0.5,1,0.5,0\n");
        write("bad.csv", "seconds,x,y,z\n0,0,0\n");
        const auto dump = [&](const QString& keys) {
            return run(QStringList{"dump", "default", "-f", "12", "--animate", "emitter.position=" + keys, "-o", "-"}
                + kSmall.mid(2));
        };
        const Outcome said = dump("0:0,0,0;0.5:1,0.5,0");
        const Outcome read = dump("@" + folder.filePath("way.csv"));
        QVERIFY2(read.code == 0 && said.code == 0, read.error.constData());
        QCOMPARE(read.out, said.out);
        const Outcome bad = dump("@" + folder.filePath("bad.csv"));
        QVERIFY2(bad.code == 3 && bad.error.contains("line 2"), bad.error.constData());
        const Outcome missing = dump("@" + folder.filePath("nothing.csv"));
        QVERIFY2(missing.code == 1 && missing.error.contains("nothing.csv"), missing.error.constData());
    }

    void helpNamesEveryCommand()
    {
        const Outcome help = run({"--help"});
        QCOMPARE(help.code, 0);
        for (const char* command : {"render", "flipbook", "video", "check-sheet", "fit", "bake-noise", "dump", "volume",
                 "air", "validate", "info", "presets", "parameters", "schema", "verify", "farm", "join"}) {
            QVERIFY2(help.out.contains(command), command);
            QCOMPARE(run({command, "--help"}).code, 0);
        }
        QVERIFY(help.out.contains("Exit codes"));
    }

    void wrongUsageIsTwo()
    {
        QCOMPARE(run({}).code, 2);
        QCOMPARE(run({"rendr"}).code, 2);
        QCOMPARE(run({"render"}).code, 2);
        QCOMPARE(run({"render", "default", "--colour", "red"}).code, 2);
        QCOMPARE(run({"flipbook", "default", "--grid", "4", "--optimise", "4MB"}).code, 2);
    }

    void badValuesAreThree_data()
    {
        const RefusalRows row;
        row("unknown preset", {"render", "campfir"}, "campfire");
        row("unknown key", {"render", "default", "--set", "motion.wnd=1"}, "wind.strength");
        row("no equals sign", {"render", "default", "--set", "wind.strength"}, "key=value");
        row("NaN", {"render", "default", "--set", "wind.strength=nan"}, "wind.strength");
        row("frames", {"render", "default", "--frames", "9-2"}, "9-2");
        row("size", {"render", "default", "--size", "0x9"}, "0x9");
        row("huge size", {"render", "default", "--size", "99999"}, "8192");
        row("quality", {"render", "default", "--quality", "best"}, "output.quality");
        row("grid", {"flipbook", "default", "--grid", "8x99"}, "8x99");
        row("pass", {"flipbook", "default", "--passes", "colour,sixway"}, "six-way");
        row("no pass", {"flipbook", "default", "--passes", ","}, "--passes");
        row("grid that is no power of two", {"flipbook", "default", "--grid", "6x5", "--power-of-two"}, "6 x 5 cells");
        row("budget without a unit", {"flipbook", "default", "--optimise", "4"},
            "--optimise: the budget \"4\" is not understood");
        row("budget that fits nothing", {"flipbook", "thesis-2012", "--optimise", "0.1KB", "-f", "0-9"},
            "no sheet fits into 102 bytes");
        row("curve that is none", {"flipbook", "default", "--retime", "fast"}, "--retime: expected a list");
        row("curve beyond the end", {"flipbook", "default", "--retime", "[[0,0],[1,2]]"}, "between 0 and 1");
        row("trimmed loop", {"flipbook", "thesis-2012", "--set", "timeline.loop=true", "--trim"}, "loop");
        row("packed channel", {"flipbook", "default", "--pack", "masks=shadw"},
            "--pack: there is no channel \"shadw\". Did you mean \"shadow\"?");
        row("packed without channels", {"flipbook", "default", "--pack", "masks"}, "masks=shadow");
        row("packed under the name of a pass", {"flipbook", "default", "--pack", "motion=alpha"}, "name of a pass");
        row("neither pass nor packed", {"flipbook", "default", "--passes", "none", "-f", "0-63"}, "no pass");
        row("signs of vectors", {"flipbook", "default", "--vectors", "godot"}, "unreal");
        row("too few frames", {"flipbook", "default", "--frames", "0-9"}, "64 cells");
        row("simd", {"--simd", "mmx", "render", "default"}, "mmx");
        row("format", {"render", "default", "--format", "gif"}, "gif");
        row("frame", {"dump", "default", "--frame=-1"}, "-1");
        row("frame in words", {"dump", "default", "--frame", "ten"}, "ten");
        row("supersample", {"render", "default", "--supersample", "0"}, "from 1 to 4");
        row("size 0", {"render", "default", "--size", "0"}, "0");
        row("threads", {"--threads", "0x2", "render", "default"}, "0x2");
        row("size of noise", {"bake-noise", "default", "--size", "4097", "-o", "a.png"}, "4096");
        row("marker without a time", {"render", "default", "--marker", "Boom"}, "--marker Boom: invalid marker");
        row("marker at no time", {"render", "default", "--marker", "Boom=nan"}, "the time of a marker is no number");
        row("marker before the beginning", {"render", "default", "--marker", "Boom=-1"}, "lies at -1 s");
        row("depth that is no number", {"bake-noise", "default", "--depth", "nan", "-o", "a.png"}, "nan");
        row("depth beyond the end", {"bake-noise", "default", "--depth", "1.5", "-o", "a.png"}, "1.5");
    }
    void badValuesAreThree() { isRefusedAsTheRowSays(); }

    void badFilesAreRefusedWithOneMessage_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("brackets") << QByteArray(10'000'000, '[');
        QTest::newRow("binary") << QByteArray("\x00\xff\x12", 3);
        QTest::newRow("not UTF-8") << QByteArray("{\"format\": \"\xc3\x28\"}");
        QTest::newRow("truncated") << QByteArray::fromStdString(formatPreset({}).substr(0, 999));
        QTest::newRow("1e999") << QByteArray(R"({"format": "fumage-preset", "version": 1, "motion": {"wind": 1e999}})");
        QTest::newRow("version") << QByteArray(R"({"format": "fumage-preset", "version": 99})");
    }
    void badFilesAreRefusedWithOneMessage()
    {
        QFETCH(QByteArray, json);
        const QTemporaryDir folder;
        const QString preset = folder.path() + "/bad.json";
        const QString picture = folder.path() + "/kept.png";
        QVERIFY(writeFileAtomically(preset.toStdString(), json.toStdString()).ok());
        QVERIFY(writeFileAtomically(picture.toStdString(), std::string_view("precious")).ok());
        const Outcome outcome = run({"render", preset, "-f", "0", "-o", picture});
        QCOMPARE(outcome.code, 3);
        QCOMPARE(outcome.error.count('\n'), 1);
        QVERIFY(outcome.error.contains("bad.json"));
        QCOMPARE(readFile(picture.toStdString(), 100).value(), std::string("precious"));
    }

    void zerosBeforeANumberChangeNothing()
    {
        const QStringList small{"--set", "emitter.count=50"};
        const QByteArray thirty = run(QStringList{"dump", "default", "--frame", "30"} + small).out;
        QVERIFY(thirty.count('\n') > 10);
        QCOMPARE(run(QStringList{"dump", "default", "--frame", "0030"} + small).out, thirty);
        QCOMPARE(run(QStringList{"dump", "default", "--frame", "0019"} + small).code, 0);
        const auto noise = [](const char* size) {
            return run({"bake-noise", "default", "--size", size, "-o", "-"}).out;
        };
        QVERIFY(!noise("010").isEmpty() && noise("010") == noise("10"));
    }

    void clampedSeedsAreSaid()
    {
        const QTemporaryDir folder;
        const QString preset = folder.path() + "/seed.json";
        QVERIFY(writeFileAtomically(preset.toStdString(),
            QByteArray(R"({"format": "fumage-preset", "version": 1, "emitter": {"seed": -5}})").toStdString())
                    .ok());
        QCOMPARE(run({"validate", "--strict", preset}).code, 3);
        QVERIFY(run({"dump", "default", "--set", "emitter.count=5", "--set", "emitter.seed=1e11"})
                    .error.contains("emitter.seed=1e11: out of range"));
    }

    void whatIsSetAndHasNoEffectIsSaid()
    {
        const QByteArray said = run({"dump", "steam", "--set", "emitter.count=5", "--set", "air.enabled=true", "--set",
                                        "motion.buoyancy=2", "--set", "air.resolution=16"})
                                    .error;
        QVERIFY2(said.contains("motion.buoyancy=2: has no effect while air.enabled is true"), said.constData());
        QVERIFY(!said.contains("air.resolution=16"));
        const auto inherits = [](const QString& layer) {
            return run({"dump", "blast", "--layers", layer, "--set", layer + "/emitter.inherit=0.5", "--set",
                           "1/emitter.count=5", "--set", "2/emitter.count=5", "--set", "Trails/emitter.count=5"})
                .error.contains("inherit=0.5: has no effect on a layer that is born on no other");
        };
        QVERIFY(inherits(QStringLiteral("Debris")));
        QVERIFY(!inherits(QStringLiteral("Trails")));
    }

    void layersAreNamedOnTheCommandLine()
    {
        const QStringList dump{"dump", "bonfire", "--set", "1/emitter.count=5", "--set", "embers/emitter.count=7",
            "--set", "air.enabled=false"};
        const Outcome embers = run(dump + QStringList{"--layers", "Embers"});
        QVERIFY2(embers.code == 0, embers.error.constData());
        QCOMPARE(run(dump + QStringList{"--mute", "flames"}).out, embers.out);
        QVERIFY(!embers.error.contains("no layer is left"));
        for (const QString option : {"--layers", "--mute"}) { // as of a variable that is not set
            const Outcome nothing = run(dump + QStringList{option, ""});
            QCOMPARE(nothing.code, 3);
            QVERIFY2(nothing.error.contains(option.toUtf8() + ": no layer is named"), nothing.error.constData());
        }
        const Outcome none = run(dump + QStringList{"--layers", "1", "--mute", "FLAMES"});
        QVERIFY2(none.code == 0 && none.error.contains("--mute FLAMES: no layer is left"), none.error.constData());
    }

    void aPictureIsTakenFromItsFile()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("logo.png"));
        // bright on the right alone
        const std::vector<std::byte> png = pngOf(2, 1, [](int x, int) {
            return x == 0 ? std::array<std::uint8_t, 4>{0, 0, 0, 255} : std::array<std::uint8_t, 4>{255, 255, 255, 255};
        });
        QVERIFY(writeFileAtomically(file.toStdString(), std::span<const std::byte>(png)).ok());
        QStringList dump{"dump", "thesis-2012", "--frame", "0"};
        for (const QString& set : {QStringLiteral("shape=picture"), "picture=" + file, QStringLiteral("mode=burst"),
                 QStringLiteral("burst_duration=0"), QStringLiteral("count=40"), QStringLiteral("position=0,0,0"),
                 QStringLiteral("normal=0,1,0"), QStringLiteral("speed=0")}) {
            dump += {"--set", "emitter." + set};
        }
        const Outcome born = run(dump);
        QVERIFY2(born.code == 0, born.error.constData());
        const QList<QByteArray> lines = born.out.trimmed().split('\n');
        QCOMPARE(lines.size(), 41);
        for (const QByteArray& line : lines.mid(1)) {
            QVERIFY2(line.split(',').at(1).toDouble() >= 0.0, line.constData());
        }
        QVERIFY(run({"dump", "default", "--set", "emitter.picture=" + file})
                    .error.contains("has no effect while emitter.shape is disc"));
        QVERIFY(writeFileAtomically(file.toStdString(), std::string_view("no picture")).ok());
        const Outcome refused = run(dump);
        QCOMPARE(refused.code, 3);
        QVERIFY2(refused.error.contains("logo.png") && refused.error.contains("at most 512 pixels an edge"),
            refused.error.constData());
    }

    void keysOfVersion1AreStillTaken()
    {
        const QStringList few{
            "dump", "default", "--frame", "3", "--set", "emitter.count=20", "--set", "air.resolution=16"};
        const QByteArray old = run(few + QStringList{"--set", "motion.wind=2"}).out;
        QVERIFY(!old.isEmpty());
        QCOMPARE(old, run(few + QStringList{"--set", "wind.strength=2"}).out);
        QVERIFY(old != run(few).out);
    }

    void namesOfPresetsSteerNoTerminal()
    {
        const QTemporaryDir folder;
        const QString presets = folder.path() + "/fumage/presets";
        QVERIFY(QDir().mkpath(presets));
        Preset preset;
        preset.name = "\x1b[31mred";
        preset.description = "\x1b]0;title\x07\u009b1m";
        QVERIFY(writePresetFile((presets + "/a\x1b[1m.json").toStdString(), preset).ok());
        QVERIFY(writeFileAtomically((presets + "/\x1b[2m.json").toStdString(), std::string_view("{\"\x1b[2m")).ok());
        const QString command = "XDG_DATA_HOME='" + folder.path() + "' \"$0\" \"$@\"";
        for (const QStringList& arguments : {QStringList{"presets"}, QStringList{"info", presets + "/a\x1b[1m.json"},
                 QStringList{"validate", presets + "/a\x1b[1m.json", presets + "/\x1b[2m.json"}}) {
            const Outcome outcome = run(arguments, command);
            QVERIFY(outcome.out.contains("?["));
            for (const QByteArray& text : {outcome.out, outcome.error}) {
                QVERIFY2(
                    !text.contains('\x1b') && !text.contains('\x07') && !text.contains("\u009b"), text.constData());
            }
        }
    }

    void presetsShowIsCanonical()
    {
        const QTemporaryDir folder;
        const Outcome shown = run({"presets", "--show", "default"});
        QCOMPARE(shown.code, 0);
        const QString copy = folder.path() + "/copy.json";
        QVERIFY(writeFileAtomically(copy.toStdString(), shown.out.toStdString()).ok());
        QCOMPARE(run({"presets", "--show", copy}).out, shown.out);
        QCOMPARE(run({"validate", "--strict", copy}).code, 0);
    }

    void builtinPresetFilesAreCanonical()
    {
        const QDir presets(FUMAGE_SOURCE_DIR "/resources/presets");
        for (const QString& name : presets.entryList({"*.json"})) {
            QFile file(presets.filePath(name));
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(run({"presets", "--show", presets.filePath(name)}).out, file.readAll());
        }
    }

    void parametersAreListedAsMarkdown()
    {
        const Outcome outcome = run({"parameters", "--markdown"});
        QCOMPARE(outcome.code, 0);
        QFile reference(FUMAGE_SOURCE_DIR "/resources/parameters.md");
        QVERIFY(reference.open(QIODevice::ReadOnly));
        QCOMPARE(outcome.out, reference.readAll());
    }

    void answersCanBeReadByPrograms()
    {
        const auto answer = [](const QStringList& arguments) { return QJsonDocument::fromJson(run(arguments).out); };
        const auto hasOne = [](const QJsonArray& all, const auto& isIt) {
            return std::any_of(all.begin(), all.end(), isIt);
        };
        const QJsonArray presets = answer({"presets", "--json"}).array();
        QVERIFY(presets.size() >= 16);
        QVERIFY(hasOne(presets, [](const QJsonValue& one) {
            return one["id"].toString() == "campfire" && one["builtin"].toBool() && one["loop"].toBool();
        }));
        const QJsonObject info = answer({"info", "default", "--json"}).object();
        QCOMPARE(info["frames"].toInt(), Effect().timeline.length);
        QVERIFY(info["changed"].toObject()["air.enabled"].toBool());
        QCOMPARE(answer({"info", "dust", "--json"})["changed"]["emitter.mode"].toString(), QString("burst"));
        QVERIFY(!answer({"info", "--json"})["instructionSets"].toArray().isEmpty());
        const QJsonArray parameters = answer({"parameters", "--json"}).array();
        QCOMPARE(static_cast<std::size_t>(parameters.size()), parameterTable().size());
        QVERIFY(hasOne(parameters, [](const QJsonValue& one) {
            return one["key"].toString() == "wind.strength" && one["maximum"].toDouble() > 0.0;
        }));
    }

    void infoTellsOfMarkersAndKeyFrames()
    {
        Preset preset;
        preset.scene.layers.resize(2);
        preset.scene.markers = {{"Boom", 0.5}, {"Hit", 1.25}};
        QVERIFY(animateScene(preset.scene, "camera.yaw=0:0; 1:90").ok());
        QVERIFY(animateScene(preset.scene, "2/emitter.rate=0:0; 1:1; 2:0").ok());
        const QTemporaryDir folder;
        const QString file = folder.path() + "/marked.json";
        QVERIFY(writePresetFile(file.toStdString(), preset).ok());
        const QByteArray text = run({"info", file}).out;
        QVERIFY2(text.contains("markers     0.5 s  Boom\n            1.25 s  Hit\n"), text.constData());
        QVERIFY2(text.contains("key frames  2 parameters change over time: camera.yaw (2), 2/emitter.rate (3)\n"),
            text.constData());
        const QJsonObject json = QJsonDocument::fromJson(run({"info", file, "--json"}).out).object();
        QCOMPARE(json["markers"].toArray().size(), 2);
        QCOMPARE(json["markers"].toArray()[1].toObject()["name"].toString(), QString("Hit"));
        QCOMPARE(json["markers"].toArray()[1].toObject()["seconds"].toDouble(), 1.25);
        QCOMPARE(json["animated"].toArray().size(), 2);
        QCOMPARE(json["animated"].toArray()[1].toObject()["key"].toString(), QString("2/emitter.rate"));
        QCOMPARE(json["animated"].toArray()[1].toObject()["keyFrames"].toInt(), 3);
        const QByteArray plain = run({"info", "default"}).out;
        QVERIFY(!plain.contains("markers") && !plain.contains("key frames"));
    }

    void markersOfTheCommandLineAreEvents()
    {
        const QTemporaryDir folder;
        const QString picture = folder.filePath(QStringLiteral("a.png"));
        const auto events = [&](const QStringList& options) {
            const Outcome outcome = run(QStringList{"flipbook", "thesis-2012", "--set", "emitter.count=50", "--frames",
                                            "0-3", "--grid", "2x2", "--size", "16", "-o", picture}
                + options);
            const std::string text = readFile(folder.filePath("a.flipbook.json").toStdString(), 100'000).value();
            return outcome.code == 0 ? QJsonDocument::fromJson(QByteArray::fromStdString(text))["events"].toArray()
                                     : QJsonArray{outcome.code};
        };
        const QJsonArray both = events({"--marker", "Begin=0", "--marker", "Gone=0", "--marker", "Gone="});
        QCOMPARE(both.size(), 1);
        QCOMPARE(both[0].toObject()["name"].toString(), QString("Begin"));
        QCOMPARE(both[0].toObject()["cell"].toInt(-1), 0);
        QVERIFY(events({}).isEmpty());
    }

    void slipsInTheNameOfACommandAreAnswered()
    {
        const Outcome slip = run({"rendr", "default"});
        QCOMPARE(slip.code, 2);
        QVERIFY2(slip.error.contains("Did you mean \"render\"?"), slip.error.constData());
        QCOMPARE(run({"help"}).out, run({"--help"}).out);
        QCOMPARE(run({"help", "render"}).out, run({"render", "--help"}).out);
        QCOMPARE(run({"-V"}).out, run({"--version"}).out);
        QVERIFY(!run({"render", "--help"}).out.contains("KEY=VALUE ..."));
    }
};

QTEST_GUILESS_MAIN(CliTest)
#include "cli_test.moc"
