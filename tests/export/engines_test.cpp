// What is written for engines: all of it, readable by their languages, and true of the sheet. tests/clients plays it in
// the engines that run here.

#include "tests/helpers.h"

#include "core/system/file.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/engines/engine_files.h"
#include "core/export/sheets/flipbook.h"

#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// All that a name of a file may hold to break a language that it is written into.
constexpr const char* kHostileName = "a\"b'c\\{{columns}}<&>\n\xC3\xA9 \";DROP";

/// A small flipbook for an engine in a folder of its own.
struct Sheet {
    QTemporaryDir folder;
    FlipbookOptions options;
    Effect effect = thesisEffect(300);

    explicit Sheet(Engine engine, const std::string& name = "smoke_4x2")
    {
        effect.output.width = 24;
        effect.output.height = 16;
        effect.timeline.frameRate = 30;
        options.output = folder.path().toStdString() + "/" + name + ".png";
        options.columns = 4;
        options.rows = 2;
        options.frames = {0, 15, 1};
        options.engine = engine;
        options.passes = passesFor(engine);
        options.style = styleFor(engine, options.format);
    }
    void write() const
    {
        const Result<Flipbook> done = renderFlipbook(effect, options);
        if (!done) {
            qFatal("%s", done.error().text().c_str());
        }
    }
    [[nodiscard]] std::string text(const std::string& file) const
    {
        return readFile(folder.path().toStdString() + "/" + file, 100'000'000).value();
    }
};

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class EnginesTest : public QObject {
    Q_OBJECT

private slots:
    void everyFileIsNamedBeforeAndWritten_data()
    {
        QTest::addColumn<int>("engine");
        for (const Engine engine : kAllEngines) {
            QTest::newRow(std::string(nameOf(engine)).c_str()) << static_cast<int>(engine);
        }
    }
    void everyFileIsNamedBeforeAndWritten()
    {
        QFETCH(int, engine);
        for (const std::string& name : {std::string("smoke_4x2"), std::string(kHostileName)}) {
            const Sheet sheet(static_cast<Engine>(engine), name);
            sheet.write();
            QStringList named;
            for (const std::filesystem::path& file : filesOf(Scene(), sheet.options)) {
                named << QString::fromStdString(file.string());
            }
            QStringList there;
            for (QDirIterator at(sheet.folder.path(), QDir::Files, QDirIterator::Subdirectories); at.hasNext();) {
                there << at.next();
            }
            named.sort();
            there.sort();
            QCOMPARE(there, named);
            for (const QString& file : there) {
                if (!file.endsWith(QStringLiteral(".png")) && name == "smoke_4x2") {
                    const std::string text = readFile(file.toStdString(), 100'000'000).value();
                    QVERIFY2(!contains(text, "{{") && !contains(text, "}}") && !contains(text, "nan")
                            && !contains(text, "inf,"),
                        qPrintable(file));
                }
            }
        }
    }

    void cellsForPixiLieWhereTheyAre()
    {
        for (const std::string& name : {std::string("smoke_4x2"), std::string(kHostileName)}) {
            const Sheet sheet(Engine::Pixi, name);
            sheet.write();
            QJsonParseError error;
            const QJsonObject json =
                QJsonDocument::fromJson(QByteArray::fromStdString(sheet.text(name + ".atlas.json")), &error).object();
            QVERIFY2(error.error == QJsonParseError::NoError, qPrintable(error.errorString()));
            QCOMPARE(json["meta"].toObject()["image"].toString().toStdString(), name + ".png");
            const QJsonArray order = json["animations"].toObject()[QString::fromStdString(name)].toArray();
            QCOMPARE(order.size(), 8);
            const QJsonObject sixth = json["frames"].toObject()[order[5].toString()].toObject()["frame"].toObject();
            QCOMPARE(sixth["x"].toInt(), 24);
            QCOMPARE(sixth["y"].toInt(), 16);
            QCOMPARE(sixth["w"].toInt(), 24);
            QCOMPARE(sixth["h"].toInt(), 16);
        }
    }

    void effekseersProjectIsXmlThatPlaysAtTheRightSpeed()
    {
        for (const std::string& name : {std::string("smoke_4x2"), std::string(kHostileName)}) {
            const Sheet sheet(Engine::Effekseer, name);
            sheet.write();
            QXmlStreamReader xml(QByteArray::fromStdString(sheet.text(name + ".efkproj")));
            QMap<QString, QString> values;
            while (!xml.atEnd()) {
                if (xml.readNext() == QXmlStreamReader::StartElement) {
                    const QString key = xml.name().toString();
                    if (key == QStringLiteral("FrameLength")) {
                        xml.readNextStartElement();
                        values[key] = xml.readElementText();
                    } else if (key == QStringLiteral("ColorTexture") || key == QStringLiteral("FrameCountX")
                        || key == QStringLiteral("LoopType")) {
                        values[key] = xml.readElementText();
                    }
                }
            }
            QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
            QCOMPARE(values[QStringLiteral("ColorTexture")].toStdString(), name + ".png");
            QCOMPARE(values[QStringLiteral("FrameCountX")], QStringLiteral("4"));
            QCOMPARE(values[QStringLiteral("FrameLength")],
                QStringLiteral("4")); // 8 cells of 16 frames of 1/30 s: 4/60 s each
            QCOMPARE(values[QStringLiteral("LoopType")], QStringLiteral("0"));
        }
    }

    /// What Effekseer's loader reads without asking whether it is there (Core.LoadFromXml of 1.7 and 1.8), and what it
    /// takes for granted.
    void effekseersProjectHasAllThatItsLoaderReads()
    {
        const Sheet sheet(Engine::Effekseer);
        sheet.write();
        const std::string text = sheet.text("smoke_4x2.efkproj");
        QVERIFY(text.starts_with(
            "<?xml ")); // the document has two children, this and the project; with another it is not loaded
        QXmlStreamReader xml(QByteArray::fromStdString(text));
        QMap<QString, QString> top;
        QVERIFY(xml.readNextStartElement() && xml.name() == QStringLiteral("EffekseerProject"));
        while (xml.readNextStartElement()) {
            const QString key = xml.name().toString();
            top[key] = key == QStringLiteral("Root") ? QString() : xml.readElementText();
            if (key == QStringLiteral("Root")) {
                xml.skipCurrentElement();
            }
        }
        QVERIFY(!xml.hasError());
        QVERIFY(top.contains(QStringLiteral("Root"))); // else nothing is loaded
        QCOMPARE(top[QStringLiteral("StartFrame")], QStringLiteral("0")); // the editor's timeline, in sixtieths
        QCOMPARE(top[QStringLiteral("EndFrame")], QStringLiteral("32")); // 8 cells of 4
        QCOMPARE(top[QStringLiteral("IsLoop")], QStringLiteral("True")); // as bool.Parse() reads it
        QCOMPARE(top[QStringLiteral("Version")],
            QStringLiteral("3")); // below it the texture is taken from where it stood before version 3
        while (!xml.atEnd()) {
            QVERIFY(xml.readNext() != QXmlStreamReader::Comment);
        }
    }

    /// A node a layer, the first at the bottom of the picture: Effekseer draws nodes in the order of its tree.
    void whatHasNoPassIsRefusedForEveryEngine()
    {
        for (const Engine engine : kAllEngines) {
            for (std::size_t layers = 0; layers < kLayerOutputs; ++layers) {
                Sheet sheet(engine);
                sheet.options.layers = static_cast<LayerOutput>(layers);
                sheet.options.passes = PassSet();
                const std::vector<std::filesystem::path> files = filesOf(sheet.effect, sheet.options);
                QVERIFY(std::ranges::none_of(files, [](const auto& file) { return file.extension() == ".png"; }));
                QVERIFY(!renderFlipbook(sheet.effect, sheet.options).ok());
                QVERIFY(QDir(sheet.folder.path()).isEmpty());
            }
        }
    }
    void effekseersProjectHasANodeALayer()
    {
        Sheet sheet(Engine::Effekseer);
        Scene scene = sheet.effect;
        scene.layers.resize(3, scene.layers[0]);
        scene.layers[0].name = "Smoke";
        scene.layers[1].name = kHostileName;
        scene.layers[2].visible = false;
        scene.layers.push_back(scene.layers[0]);
        scene.layers[3].name.clear();
        sheet.options.layers = LayerOutput::Stacked;
        const Result<Flipbook> done = renderFlipbook(scene, sheet.options);
        QVERIFY2(done.ok(), done ? "" : done.error().text().c_str());
        QXmlStreamReader xml(QByteArray::fromStdString(sheet.text("smoke_4x2.efkproj")));
        QStringList names;
        QStringList textures;
        QStringList blending;
        QMap<QString, int> counts;
        while (!xml.atEnd()) {
            if (xml.readNext() == QXmlStreamReader::StartElement) {
                const QString key = xml.name().toString();
                ++counts[key];
                if (key == QStringLiteral("Name")) {
                    names << xml.readElementText();
                } else if (key == QStringLiteral("ColorTexture")) {
                    textures << xml.readElementText();
                } else if (key == QStringLiteral("AlphaBlend")) {
                    blending << xml.readElementText();
                }
            }
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QCOMPARE(counts[QStringLiteral("Node")], 3);
        QCOMPARE(counts[QStringLiteral("Children")], 1); // they are beside one another
        QCOMPARE(names.size(), 4);
        QCOMPARE(names[0], QStringLiteral("Root"));
        QCOMPARE(names[1], QStringLiteral("Smoke"));
        QVERIFY2(names[2].contains(QStringLiteral("<&>")), qPrintable(names[2])); // as it is, and no element
        QCOMPARE(names[3], QStringLiteral("smoke_4x2_layer-4"));
        std::vector<std::string> expected;
        for (const FlipbookOptions& each : sheetsOf(scene, sheet.options)) {
            expected.push_back(picturesOf(each).front().filename().string());
        }
        QCOMPARE(textures.size(), 3);
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(textures[i].toStdString(), expected[static_cast<std::size_t>(i)]);
            QVERIFY(QFile::exists(sheet.folder.filePath(textures[i])));
            QCOMPARE(blending[i], QStringLiteral("1")); // alpha * colour over what is behind
        }
        for (const char* part : {"UVAnimation", "FrameLength", "Location", "Scale", "Sprite", "Life"}) {
            QCOMPARE(counts[QString::fromUtf8(part)], 3);
        }
        const QJsonObject sideCar =
            QJsonDocument::fromJson(QByteArray::fromStdString(sheet.text("smoke_4x2_smoke.flipbook.json"))).object();
        QCOMPARE(sideCar[QStringLiteral("alpha")].toString(), QStringLiteral("straight"));
        QVERIFY(sideCar[QStringLiteral("layer")].toObject()[QStringLiteral("blending")].toString().contains(
            QStringLiteral("alpha * colour")));
    }

    void unitysScriptSpeaksToAllPipelines()
    {
        const Sheet sheet(Engine::Unity);
        sheet.write();
        const std::string script = sheet.text("Editor/smoke_4x2.cs");
        for (const char* word : {"\"_FLIPBOOKBLENDING_ON\"", "\"_REQUIRE_UV2\"", "\"HDRP/Unlit\"",
                 "\"Universal Render Pipeline/Particles/Unlit\"", "\"Particles/Standard Unlit\"",
                 "Lightmap Remap Ranges"}) {
            QVERIFY2(contains(script, word), word);
        }
    }

    void unrealsTexturesEndAtTheirEdges()
    {
        Sheet sheet(Engine::Unreal);
        sheet.write();
        const std::string script = sheet.text("smoke_4x2_unreal.py");
        QVERIFY(contains(script, "\"address_x\", unreal.TextureAddress.TA_CLAMP")
            && contains(script, "\"address_y\", unreal.TextureAddress.TA_CLAMP"));
        QVERIFY(contains(script, "log_warning") && contains(script, "4 x 2"));
        sheet.options.rows = 4;
        sheet.write();
        QVERIFY(!contains(sheet.text("smoke_4x2_unreal.py"), "log_warning"));
    }

    void normalsLeadAsEachEngineHasThem()
    {
        for (const Engine engine : kAllEngines) {
            Sheet sheet(engine);
            sheet.options.passes = {Pass::Colour, Pass::Normal};
            sheet.write();
            const QJsonObject json =
                QJsonDocument::fromJson(QByteArray::fromStdString(sheet.text("smoke_4x2.flipbook.json"))).object();
            const QJsonObject normal = json["pictures"].toArray()[1].toObject();
            const bool isDown = engine == Engine::Unreal;
            QCOMPARE(normal["green"].toString(), isDown ? QStringLiteral("directx") : QStringLiteral("opengl"));
            QCOMPARE(
                normal["channels"].toArray()[1].toString(), isDown ? QStringLiteral("down") : QStringLiteral("up"));
        }
    }

    void fireKeepsItsColoursInLightMaps()
    {
        for (const float emission : {0.0F, 4.0F}) {
            for (const Engine engine : {Engine::Unity, Engine::Godot}) {
                Sheet sheet(engine);
                sheet.options.passes = {Pass::Colour, Pass::SixWayA, Pass::SixWayB};
                sheet.effect.glow.emission = emission;
                sheet.write();
                const QJsonArray pictures =
                    QJsonDocument::fromJson(QByteArray::fromStdString(sheet.text("smoke_4x2.flipbook.json")))
                        .object()["pictures"]
                        .toArray();
                const QJsonObject glow = pictures[2].toObject()["emissive"].toObject();
                QCOMPARE(glow["gradient"].toArray().size(), kGlowKeys);
                QCOMPARE(glow["scale"].toDouble() > 0.0, emission > 0.0F);
                const bool glows = emission > 0.0F;
                if (engine == Engine::Unity) {
                    const QString script = QString::fromStdString(sheet.text("Editor/smoke_4x2.cs"));
                    QCOMPARE(script.count(QStringLiteral("new GradientColorKey(")), glows ? kGlowKeys : 0);
                } else {
                    QCOMPARE(contains(sheet.text("smoke_4x2.tscn"), "GradientTexture1D"), glows);
                    QCOMPARE(contains(sheet.text("smoke_4x2.gdshader"), "glow"), glows);
                }
            }
        }
    }

    void aSceneSaysHowManyResourcesItHas()
    {
        for (const Engine engine : {Engine::Godot, Engine::Godot3}) {
            Sheet sheet(engine);
            if (engine == Engine::Godot) {
                sheet.options.passes = {Pass::Colour, Pass::SixWayA, Pass::SixWayB};
                sheet.effect.glow.emission = 4.0F;
            }
            sheet.write();
            const QString scene = QString::fromStdString(sheet.text("smoke_4x2.tscn"));
            const auto resources =
                scene.count(QStringLiteral("[ext_resource ")) + scene.count(QStringLiteral("[sub_resource "));
            QVERIFY2(scene.startsWith(QStringLiteral("[gd_scene load_steps=%1 ").arg(resources + 1)),
                qPrintable(scene.left(80))); // and the scene itself
        }
    }

    void unrealsScriptIsPython()
    {
        for (const std::string& name : {std::string("smoke_4x2"), std::string(kHostileName)}) {
            const Sheet sheet(Engine::Unreal, name);
            sheet.write();
            QProcess python;
            python.start(QStringLiteral("python3"),
                {QStringLiteral("-c"),
                    QStringLiteral("import runpy, sys; print(len(runpy.run_path(sys.argv[1])['TEXTURES']))"),
                    sheet.folder.filePath(QString::fromStdString(name + "_unreal.py"))});
            QVERIFY(python.waitForFinished());
            QCOMPARE(python.readAllStandardOutput().trimmed(), QByteArray("4"));
            QCOMPARE(python.readAllStandardError(), QByteArray());
        }
    }

    void godotsSceneHasSizeAndPlaceOfTheSmoke()
    {
        Sheet sheet(Engine::Godot);
        // A camera 10 m away with a focal length of half the sensor sees 2 x 10 m in the shorter side.
        sheet.effect.camera =
            Camera{.target = {1.0F, 4.0F, 0.0F}, .distance = 10.0F, .pitch = 0.0F, .focalLength = 18.0F};
        sheet.effect.emitter.position = {0.0F, 1.0F, 0.0F};
        sheet.effect.timeline.loop = false;
        sheet.write();
        const std::string scene = sheet.text("smoke_4x2.tscn");
        QVERIFY2(contains(scene, "size = Vector2(30, 20)"), scene.c_str());
        QVERIFY2(contains(scene, "0, 0, 1, 1, 3, 0)"), scene.c_str());
        QVERIFY2(contains(scene, "one_shot = true"), scene.c_str());
        QVERIFY2(contains(scene, "path=\"smoke_4x2_motion.png\""), scene.c_str());
        const std::string shader = sheet.text("smoke_4x2.gdshader");
        QVERIFY(contains(shader, "unshaded") && contains(shader, "vec2(4.0, 2.0)") && !contains(shader, "void light"));
        QVERIFY(contains(sheet.text("smoke_4x2_motion.png.import"), "mipmaps/generate=false"));
    }

    void godotsLightReadsTheChannelsOfItsLayout()
    {
        Sheet sheet(Engine::Godot);
        sheet.options.passes = {Pass::Colour, Pass::SixWayA, Pass::SixWayB};
        sheet.options.style.layout = SixWayLayout::EmberGen;
        sheet.write();
        const std::string shader = sheet.text("smoke_4x2.gdshader");
        QVERIFY2(contains(shader, "LIGHT.x >= 0.0 ? a.b : a.g"), shader.c_str());
        QVERIFY2(contains(shader, "LIGHT.y >= 0.0 ? a.r : b.r"), shader.c_str());
        QVERIFY2(contains(shader, "LIGHT.z >= 0.0 ? b.b : b.g"), shader.c_str());
        QVERIFY(!contains(shader, "glow") && !contains(shader, "motion_scale"));
    }

    void thePageHoldsThePicturesThemselves()
    {
        const Sheet sheet(Engine::Web);
        sheet.write();
        const QByteArray page = QByteArray::fromStdString(sheet.text("smoke_4x2.html"));
        for (const char* file : {"smoke_4x2.png", "smoke_4x2_motion.png"}) {
            const QByteArray picture = QByteArray::fromStdString(sheet.text(file));
            QVERIFY2(page.contains("\"data:image/png;base64," + picture.toBase64() + "\""), file);
        }
    }

    void enginesThatImportTexturesTakeTga_data()
    {
        QTest::addColumn<int>("engine");
        QTest::addColumn<bool>("takes");
        for (const Engine engine : kAllEngines) {
            const bool imports = engine == Engine::Generic || engine == Engine::Unity || engine == Engine::Unreal
                || engine == Engine::Godot || engine == Engine::Godot3;
            QTest::newRow(std::string(nameOf(engine)).c_str()) << static_cast<int>(engine) << imports;
        }
    }
    void enginesThatImportTexturesTakeTga()
    {
        QFETCH(int, engine);
        QFETCH(bool, takes);
        Sheet sheet(static_cast<Engine>(engine));
        sheet.options.format = ImageFormat::Tga;
        sheet.options.output = sheet.folder.path().toStdString() + "/smoke_4x2.tga";
        QCOMPARE(renderFlipbook(sheet.effect, sheet.options).ok(), takes);
        QCOMPARE(QDir(sheet.folder.path()).exists(QStringLiteral("smoke_4x2.tga")), takes);
    }

    void whatAnEngineCannotReadIsRefused()
    {
        Sheet sheet(Engine::Godot);
        sheet.options.format = ImageFormat::ExrHalf;
        const Result<Flipbook> exr = renderFlipbook(sheet.effect, sheet.options);
        QVERIFY(!exr.ok());
        QVERIFY2(
            contains(exr.error().text(), "Godot 4") && contains(exr.error().text(), "PNG"), exr.error().text().c_str());
        sheet.options.format = ImageFormat::Png8;
        sheet.options.passes = {Pass::Motion};
        QVERIFY(!renderFlipbook(sheet.effect, sheet.options).ok());
        QVERIFY(QDir(sheet.folder.path()).isEmpty());
    }
};

QTEST_GUILESS_MAIN(EnginesTest)
#include "engines_test.moc"
