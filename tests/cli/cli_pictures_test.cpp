// Commands take pictures for the presets that they carry, and know which frame or which sheet they show.

#include "tests/cli/run.h"

#include "core/preset/preset_file.h"
#include "core/system/file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <QtTest/QtTest>

using namespace fumage;
using namespace fumage::tests;

namespace {

const QStringList kFew{"--set", "emitter.count=200", "--set", "noise.slices=4", "--set", "noise.resolution=16", "--set",
    "timeline.length=20", "--set", "air.resolution=16"};

std::string bytesOf(const QTemporaryDir& folder, const QString& name)
{
    return readFile(folder.filePath(name).toStdString(), std::size_t{1} << 26U).value();
}

QStringList namesIn(const QTemporaryDir& folder, const QString& within)
{
    return QDir(folder.filePath(within)).entryList(QDir::Files, QDir::Name);
}

/// Width and height of a PNG.
std::pair<int, int> sizeOf(const std::string& png)
{
    const auto wordAt = [&](std::size_t at) {
        int word = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            word = 256 * word + static_cast<unsigned char>(png.at(at + i));
        }
        return word;
    };
    return {wordAt(16), wordAt(20)};
}

} // namespace

class CliPicturesTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        const auto make = [&](const QStringList& arguments) { QCOMPARE(runIn(*m_folder, arguments + kFew).code, 0); };
        for (const QString ending : {"png", "exr"}) {
            make({"render", "plume", "--frame", "7", "--size", "24", "-o", "one." + ending});
            make({"flipbook", "plume", "--frames", "2-9:2", "--grid", "2x2", "--size", "16", "--passes", "colour,alpha",
                "-o", "sheet." + ending});
        }
    }

    void aPictureIsRenderedAgainAsItsFrame()
    {
        for (const QString ending : {"png", "exr"}) {
            const Outcome large = runIn(*m_folder, {"render", "one." + ending, "--size", "48", "--output", "big.png"});
            QVERIFY2(large.code == 0 && large.error.trimmed().endsWith("wrote big.png"), large.error.constData());
            QCOMPARE(sizeOf(bytesOf(*m_folder, "big.png")), (std::pair{48, 48}));
            QCOMPARE(runIn(*m_folder, {"render", "one." + ending, "-o", "again/a." + ending}).code, 0);
            QVERIFY(bytesOf(*m_folder, "again/a." + ending) == bytesOf(*m_folder, "one." + ending));
            QCOMPARE(runIn(*m_folder, {"render", "one." + ending, "--frames", "3-4", "-o", "some/a_##.png"}).code, 0);
        }
        QCOMPARE(namesIn(*m_folder, "again"), (QStringList{"a.exr", "a.png"}));
        QCOMPARE(namesIn(*m_folder, "some"), (QStringList{"a_03.png", "a_04.png"}));
    }

    void aSheetIsMadeAgain()
    {
        for (const QString sheet : {"sheet.png", "sheet_alpha.png", "sheet.exr"}) {
            const QString ending = sheet.right(4);
            const Outcome again = runIn(*m_folder, {"render", sheet, "-o", "again/sheet" + ending});
            QVERIFY2(again.code == 0
                    && again.error.contains("a sheet of 2 x 2 cells, which is made again; --frames renders frames"),
                again.error.constData());
            for (const QString& name : {"sheet" + ending, "sheet_alpha" + ending}) {
                QVERIFY(bytesOf(*m_folder, "again/" + name) == bytesOf(*m_folder, name));
            }
        }
        // --size is that of the picture, as of any that is rendered.
        QCOMPARE(runIn(*m_folder, {"render", "sheet.png", "--size", "64", "-o", "big.png"}).code, 0);
        QCOMPARE(sizeOf(bytesOf(*m_folder, "big.png")), (std::pair{64, 64}));
        const Outcome odd = runIn(*m_folder, {"render", "sheet.png", "--size", "65", "-o", "odd.png"});
        QVERIFY2(odd.code == 3 && odd.error.contains("Choose multiples of 2 and 2"), odd.error.constData());
        QCOMPARE(runIn(*m_folder, {"render", "sheet.png", "--frames", "3", "--size", "16", "-o", "frame.png"}).code, 0);
        QCOMPARE(sizeOf(bytesOf(*m_folder, "frame.png")), (std::pair{16, 16}));
    }

    void everyCommandThatTakesAPresetTakesAPicture_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("picture");
        QTest::addColumn<QStringList>("files");
        QTest::addColumn<QString>("says");
        const auto row = [](const QStringList& arguments, const char* picture, const QStringList& files,
                             const char* says = "") {
            QTest::newRow(qPrintable(arguments.join(' ') + ' ' + picture))
                << arguments << QString(picture) << files << QString(says);
        };
        for (const char* picture : {"one.png", "one.exr"}) {
            row({"render", "-o", "out/"}, picture, {QString(picture).left(3) + ".png"});
            row({"render", "-o", "out/a_###.png"}, picture, {"a_007.png"});
            row({"render", "--frame", "3", "-o", "out/a.png"}, picture, {"a.png"});
            row({"dump", "-o", "out/a_##.csv"}, picture, {"a_07.csv"});
            row({"dump", "--frame", "3", "-o", "out/a_##.csv"}, picture, {"a_03.csv"});
            row({"volume", "--cells", "8", "-o", "out/a_##.vdb"}, picture, {"a_07.vdb"});
            row({"air", "-o", "out/a_##.fga"}, picture, {"a_07.fga"});
            row({"flipbook", "--grid", "5x4", "-o", "out/a.png"}, picture,
                {"a.flipbook.json", "a.png"}); // of all 20 frames
            row({"bake-noise", "--size", "8", "-o", "out/a.png"}, picture, {"a.png"});
            row({"farm", "--for", "flamenco", "-o", "out/a_##.exr"}, picture, {"a.flamenco.js", "a.fumage.json"},
                "20 frames");
            row({"fit"}, picture, {}, "--set camera.");
            row({"check-sheet", "--grid", "2", "--lit", "1"}, picture, {}, "one");
            row({"info"}, picture, {}, "shows       frame 7");
            row({"validate"}, picture, {}, "valid");
        }
        row({"dump", "-o", "out/a_##.csv"}, "sheet.png", {"a_02.csv"}); // the first of its frames
        row({"volume", "--cells", "8", "-o", "out/a_##.vdb"}, "sheet.png", {"a_02.vdb"});
        row({"air", "-o", "out/a_##.fga"}, "sheet.png", {"a_02.fga"});
        row({"flipbook", "-o", "out/a.png"}, "sheet.png", {"a.flipbook.json", "a.png"});
        row({"check-sheet", "--lit", "1"}, "sheet.png", {}, "sheet");
        row({"info"}, "sheet.png", {}, "shows       a sheet of 2 x 2 cells, frames 2-9:2");
        row({"info"}, "sheet_alpha.exr", {}, "shows       a sheet of 2 x 2 cells, frames 2-9:2");
    }
    void everyCommandThatTakesAPresetTakesAPicture()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, picture);
        QFETCH(QStringList, files);
        QFETCH(QString, says);
        arguments.insert(1, picture);
        const Outcome outcome = runIn(*m_folder, arguments);
        QVERIFY2(outcome.code == 0, outcome.error.constData());
        QCOMPARE(namesIn(*m_folder, "out"), files);
        QVERIFY2((outcome.out + outcome.error).contains(says.toUtf8()), (outcome.out + outcome.error).constData());
    }

    void aFlipbookOfASheetHasItsCells()
    {
        QCOMPARE(
            runIn(*m_folder, {"flipbook", "sheet.png", "--passes", "colour,alpha", "-o", "again/sheet.png"}).code, 0);
        QVERIFY(bytesOf(*m_folder, "again/sheet.png") == bytesOf(*m_folder, "sheet.png"));
        QCOMPARE(runIn(*m_folder, {"flipbook", "sheet.png", "--grid", "1x2", "-o", "other.png"}).code, 0);
        QCOMPARE(sizeOf(bytesOf(*m_folder, "other.png")), (std::pair{16, 32}));
    }

    /// By their manifest, or by one of them; what belongs to presets is not asked of files.
    void sheetsOfLayersAreCheckedTogether()
    {
        const QStringList preset{"flipbook", "bonfire", "--set", "air.enabled=false", "--set", "emitter.count=200",
            "--frames", "0-3", "--grid", "2", "--size", "24"};
        const Outcome made =
            runIn(*m_folder, preset + QStringList{"--layers-as", "contribution", "--manifest", "-o", "out/fire.png"});
        QVERIFY2(made.code == 0, made.error.constData());
        const Outcome all = runIn(*m_folder, {"check-sheet", "out/fire.manifest.json"});
        QVERIFY2(all.code == 0, all.error.constData());
        QVERIFY2(all.out.contains("added up they are the sheet of all layers to "), all.out.constData());
        QVERIFY2(!all.error.contains("are not the sheet"), all.error.constData());
        QString sheet;
        for (const QString& name : namesIn(*m_folder, "out")) {
            sheet = name.endsWith(".png") ? name : sheet;
        }
        QVERIFY2(all.out.contains(sheet.toUtf8()), all.out.constData());
        const Outcome asJson = runIn(*m_folder, {"check-sheet", "--json", "out/" + sheet});
        QVERIFY2(asJson.code == 0, asJson.error.constData());
        const QJsonObject answer = QJsonDocument::fromJson(asJson.out).array()[0].toObject();
        QCOMPARE(answer["layers_as"].toString(), QString("contribution"));
        QVERIFY(answer["decibels"].toDouble() > 50.0);
        QVERIFY(answer["sheets"].toArray().size() > 1);
        for (const QStringList& option : {QStringList{"--grid", "4"}, QStringList{"--animate", "emitter.rate=0:1"},
                 QStringList{"--marker", "Boom=1"}}) {
            const Outcome mixed = runIn(*m_folder, QStringList{"check-sheet", "out/fire.manifest.json"} + option);
            QVERIFY2(mixed.code == 3 && mixed.error.contains("as they are"), mixed.error.constData());
        }
        QVERIFY(QFile::remove(m_folder->filePath("out/" + sheet)));
        const Outcome missing = runIn(*m_folder, {"check-sheet", "out/fire.manifest.json"});
        QVERIFY2(missing.code == 1 && missing.error.contains("is missing"), missing.error.constData());
        const Outcome plain = runIn(*m_folder, preset + QStringList{"--manifest", "-o", "out/one.png"});
        QVERIFY2(plain.code == 0, plain.error.constData());
        const Outcome single = runIn(*m_folder, {"check-sheet", "out/one.manifest.json"});
        QVERIFY2(single.code == 3 && single.error.contains("no sheets of layers"), single.error.constData());
    }

    void presetsLeaveTheFilesOfOneAnotherAlone()
    {
        const QTemporaryDir folder;
        for (const char* name : {"/fire.json", "/fire_motion.json"}) {
            QVERIFY(writePresetFile(folder.path().toStdString() + name, Preset()).ok());
        }
        const Outcome outcome = runIn(folder,
            QStringList{
                "flipbook", "fire.json", "fire_motion.json", "--grid", "2", "--passes", "colour,motion", "-o", "out/"}
                + kSmall);
        QCOMPARE(outcome.code, 3);
        QVERIFY2(outcome.error.contains("\"fire_motion\" would write over a file of \"fire\""), outcome.error);
        QCOMPARE(namesIn(folder, "out"), (QStringList{"fire.flipbook.json", "fire.png", "fire_motion.png"}));
    }

    /// A preset's name may say where the number goes, and --manifest may name one for all.
    void dataOfPresetsIsKeptApartAsPicturesAre_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("file");
        QTest::newRow("particles") << QStringList{"dump", "--format", "csv"} << "fire_03.csv";
        QTest::newRow("volumes") << QStringList{"volume", "--cells", "8"} << "fire_03.vdb";
        QTest::newRow("air") << QStringList{"air"} << "fire_03.fga";
    }
    void dataOfPresetsIsKeptApartAsPicturesAre()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, file);
        const QTemporaryDir folder;
        for (const char* name : {"/fire_##.json", "/fire_03.json", "/other.json"}) {
            Preset preset;
            preset.scene.air.enabled = true;
            QVERIFY(writePresetFile(folder.path().toStdString() + name, preset).ok());
        }
        arguments += QStringList{"--frame", "3", "-o", "out/"} + kFew;
        const Outcome numbered = runIn(folder, arguments + QStringList{"fire_##.json", "fire_03.json"});
        QCOMPARE(numbered.code, 3);
        QVERIFY2(numbered.error.contains("\"fire_03\" would write over a file of \"fire_##\""), numbered.error);
        QCOMPARE(namesIn(folder, "out"), QStringList{file});
        const Outcome recorded =
            runIn(folder, arguments + QStringList{"fire_03.json", "other.json", "--manifest=out/all.json"});
        QCOMPARE(recorded.code, 3);
        QVERIFY2(recorded.error.contains("\"other\" would write over a file of \"fire_03\""), recorded.error);
        QCOMPARE(namesIn(folder, "out"), (QStringList{"all.3-3.manifest.json", file}));
        const Outcome apart = runIn(folder, arguments + QStringList{"fire_03.json", "other.json", "--manifest"});
        QVERIFY2(apart.code == 0, apart.error);
    }

    void jobsTakeWhatThePictureShows()
    {
        const std::string list =
            R"({"format": "fumage-jobs", "version": 1, "jobs": [{"preset": "one.png", "output": "out/a.png"}, )"
            R"({"preset": "one.exr", "output": "out/b.png", "kind": "picture"},
            {"preset": "one.png", "output": "out/c_##.csv", "kind": "particles"},
            {"preset": "sheet.png", "output": "out/d.png", "kind": "flipbook"}]})";
        QVERIFY(writeFileAtomically(m_folder->filePath("list.json").toStdString(), list).ok());
        QCOMPARE(runIn(*m_folder, {"render", "--jobs", "list.json"}).code, 0);
        QCOMPARE(namesIn(*m_folder, "out"), (QStringList{"a.png", "b.png", "c_07.csv", "d.flipbook.json", "d.png"}));
        QVERIFY(bytesOf(*m_folder, "out/a.png") == bytesOf(*m_folder, "one.png"));
        QCOMPARE(sizeOf(bytesOf(*m_folder, "out/d.png")), (std::pair{32, 32}));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(CliPicturesTest)
#include "cli_pictures_test.moc"
