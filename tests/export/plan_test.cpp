// What a plan says is what lies on the disk: names, formats and contents.
#include "tests/helpers.h"
#include "tests/png_file.h"

#include "core/system/file.h"
#include "core/export/output_name.h"
#include "core/export/plan.h"
#include "core/noise/texture.h"

#include <QDir>
#include <QTemporaryDir>

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A grey picture file, rows from the top.
struct Grey {
    int width = 0;
    int height = 0;
    int bits = 0;
    std::vector<float> values;
};

Grey readGreyPng(const std::string& path)
{
    const PngFile png(path);
    return {png.width, png.height, png.bits,
        png.colourType == PNG_COLOR_TYPE_GRAY ? std::vector<float>(png.samples.begin(), png.samples.end())
                                              : std::vector<float>()};
}

Grey readGreyExr(const std::string& path)
{
    Imf::InputFile file(path.c_str());
    const Imath::Box2i box = file.header().dataWindow();
    Grey grey{box.max.x + 1, box.max.y + 1, 32, {}};
    grey.values.resize(static_cast<std::size_t>(grey.width * grey.height));
    Imf::FrameBuffer buffer;
    buffer.insert("Y",
        Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(grey.values.data()), sizeof(float),
            sizeof(float) * static_cast<std::size_t>(grey.width)));
    file.setFrameBuffer(buffer);
    file.readPixels(box.min.y, box.max.y);
    return grey;
}

Effect smallEffect()
{
    Effect effect = everythingOn();
    effect.emitter.count = 200;
    effect.output.width = 24;
    effect.output.height = 16;
    return effect;
}

} // namespace

class PlanTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void aPlanNamesTheFilesThatItWrites_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("output");
        QTest::addColumn<QStringList>("files"); // first and last, and what lies beside
        const auto add = [](const char* name, ExportKind kind, const char* output, const QStringList& files) {
            QTest::newRow(name) << static_cast<int>(kind) << QString::fromLatin1(output) << files;
        };
        add("sequence", ExportKind::Sequence, "a_##.png", {"a_03.png", "a_07.png", "a_05.png"});
        add("sequence without numbers and ending", ExportKind::Sequence, "a",
            {"a_0003.png", "a_0007.png", "a_0005.png"});
        add("flipbook", ExportKind::Flipbook, "book", {"book.png", "book.png", "book.flipbook.json"});
        add("picture", ExportKind::Picture, "a", {"a.png", "a.png"});
        add("picture with number signs", ExportKind::Picture, "a_###", {"a_###.png", "a_###.png"});
        add("noise", ExportKind::NoiseTexture, "n.png", {"n.png", "n.png"});
        add("noise as it is named", ExportKind::NoiseTexture, "n", {"n", "n"});
        add("particles", ExportKind::Particles, "p_##.csv", {"p_03.csv", "p_07.csv", "p_05.csv"});
        add("volumes without numbers and ending", ExportKind::Volumes, "v", {"v_0003.vdb", "v_0007.vdb", "v_0005.vdb"});
        add("air", ExportKind::Air, "air_##.fga", {"air_03.fga", "air_07.fga", "air_05.fga"});
    }
    void aPlanNamesTheFilesThatItWrites()
    {
        QFETCH(int, kind);
        QFETCH(QString, output);
        QFETCH(QStringList, files);
        ExportPlan plan = planFor(static_cast<ExportKind>(kind), output);
        plan.frames = {3, 8, 2};
        plan.flipbook.columns = 3;
        plan.flipbook.rows = 1;
        QCOMPARE(firstFile(Scene(), plan).string(), pathOf(files[0]));
        QCOMPARE(lastFile(Scene(), plan).string(), pathOf(files[1]));
        Effect effect = smallEffect();
        if (plan.kind == ExportKind::Air) {
            effect.air.enabled = true;
            effect.air.resolution = 16;
        }
        const Result<std::optional<Flipbook>> done = runExport(effect, plan);
        QVERIFY2(done.ok(), done.ok() ? "" : done.error().text().c_str());
        QCOMPARE(done.value().has_value(), plan.kind == ExportKind::Flipbook);
        files.removeDuplicates();
        files.sort();
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files, QDir::Name), files);
    }

    void theEndingChoosesTheFormat()
    {
        QCOMPARE(formatOf("a/b.png"), ImageFormat::Png8);
        QCOMPARE(formatOf("b.png", true), ImageFormat::Png16);
        QCOMPARE(formatOf("b.exr"), ImageFormat::ExrHalf);
        QCOMPARE(formatOf("b.exr", true), ImageFormat::ExrFloat);
        QCOMPARE(formatOf("exr"), ImageFormat::Png8);
        QCOMPARE(formatOf(""), ImageFormat::Png8);
        for (const ImageFormat format : {ImageFormat::Png8, ImageFormat::ExrHalf}) {
            QCOMPARE(formatOf(withEnding("a", fileEnding(format))), format);
        }
        QCOMPARE(withEnding("a.b/c.csv", fileEnding(ParticleFormat::Csv)).string(), std::string("a.b/c.csv"));
        QCOMPARE(withEnding("a.b/c", fileEnding(ParticleFormat::Ply)).string(), std::string("a.b/c.ply"));
    }

    void anExportedNoiseTextureHoldsTheBakedValuesUpright_data()
    {
        QTest::addColumn<int>("format");
        QTest::newRow("8 bits") << static_cast<int>(ImageFormat::Png8);
        QTest::newRow("16 bits") << static_cast<int>(ImageFormat::Png16);
        QTest::newRow("floats") << static_cast<int>(ImageFormat::ExrFloat);
    }
    void anExportedNoiseTextureHoldsTheBakedValuesUpright()
    {
        QFETCH(int, format);
        Effect effect = smallEffect();
        effect.noise.resolution = 48;
        ExportPlan plan = planFor(ExportKind::NoiseTexture, u"noise"_qs);
        plan.format = static_cast<ImageFormat>(format);
        plan.noise.depth = 0.25F;
        QVERIFY(runExport(effect, plan).ok());
        const bool png = plan.format != ImageFormat::ExrFloat;
        const Grey grey = png ? readGreyPng(plan.output.string()) : readGreyExr(plan.output.string());
        const float full = png ? std::ldexp(1.0F, grey.bits) - 1.0F : 1.0F;

        const NoiseTile tile = bakeNoise(effect.noise, 48, 0.25F).value();
        QVERIFY(grey.width == 48 && grey.height == 48 && grey.values.size() == tile.values.size());
        int upsideDown = 0;
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 48; ++x) {
                // The tile's first row is its lowest, the picture's its highest.
                const float seen = grey.values[static_cast<std::size_t>(y * 48 + x)];
                const auto expected = [&](int row) {
                    return png ? std::floor(tile.at(x, row) * full + 0.5F) : tile.at(x, row);
                };
                QVERIFY(seen == expected(47 - y));
                upsideDown += seen == expected(y) ? 1 : 0;
            }
        }
        QVERIFY(upsideDown < 48 * 48 / 4); // a tile that looks the same either way would show nothing
    }

    void aNoiseTextureHasTheSizeThatIsAskedFor()
    {
        ExportPlan plan = planFor(ExportKind::NoiseTexture, u"noise.png"_qs);
        plan.noise.size = 20;
        QVERIFY(runExport(smallEffect(), plan).ok());
        QCOMPARE(readGreyPng(plan.output.string()).width, 20);
        plan.noise.size = kMaxTextureSize + 1;
        QCOMPARE(runExport(smallEffect(), plan).error().code, ErrorCode::TooLarge);
    }

    void sheetsMayHaveSidesThatArePowersOfTwo_data()
    {
        QTest::addColumn<int>("edge");
        QTest::addColumn<int>("nearest");
        // The limit between two powers is their geometric mean: 181.02 between 128 and 256.
        for (const auto& [edge, nearest] : std::map<int, int>{{1, 1}, {2, 2}, {3, 4}, {5, 4}, {6, 8}, {128, 128},
                 {181, 128}, {182, 256}, {256, 256}, {8192, 8192}}) {
            QTest::newRow(std::to_string(edge).c_str()) << edge << nearest;
        }
    }
    void sheetsMayHaveSidesThatArePowersOfTwo()
    {
        QFETCH(int, edge);
        QFETCH(int, nearest);
        Effect effect;
        effect.output.width = edge;
        effect.output.height = 16;
        ExportPlan plan = planFor(ExportKind::Flipbook, u"a.png"_qs);
        QCOMPARE(outputFor(effect, plan).value().width, edge);
        plan.flipbook.powerOfTwo = true;
        QCOMPARE(outputFor(effect, plan).value().width, nearest);
        QCOMPARE(outputFor(effect, plan).value().height, 16);
        plan.flipbook.rows = 6;
        QCOMPARE(outputFor(effect, plan).error().code, ErrorCode::OutOfRange);
        plan.kind = ExportKind::Sequence; // which has no sheet
        QCOMPARE(outputFor(effect, plan).value().width, edge);
    }

    void aSheetOfPowersOfTwoIsToldToEngines()
    {
        Effect effect = smallEffect();
        effect.output.width = 20;
        effect.output.height = 12;
        ExportPlan plan = planFor(ExportKind::Flipbook, u"a.png"_qs);
        plan.frames = {0, 7, 1};
        plan.flipbook.columns = 4;
        plan.flipbook.rows = 2;
        plan.flipbook.engine = Engine::Pixi;
        plan.flipbook.powerOfTwo = true;
        plan.fitCamera = true;
        const auto done = runExport(effect, plan);
        QVERIFY2(done.ok(), done.ok() ? "" : done.error().text().c_str());
        const std::string atlas = readFile(pathOf(u"a.atlas.json"_qs), 100'000).value();
        QVERIFY2(atlas.find("\"w\": 64,\n      \"h\": 32") != std::string::npos, atlas.c_str()); // 4 x 16 and 2 x 16
        const std::string sidecar = readFile(done.value()->description, 100'000).value();
        QVERIFY(sidecar.find("\"cell_width\": 16") != std::string::npos);
        QVERIFY(!done.value()->cutOff); // the camera was fitted to the cells as they are
    }

    void exportedParticlesAreThoseOfTheFrame()
    {
        const Effect effect = smallEffect();
        const auto frame = frameOf(effect, 6);
        ExportPlan plan = planFor(ExportKind::Particles, u"p.csv"_qs);
        plan.frames = {6, 6, 1};
        QVERIFY(runExport(effect, plan).ok());
        constexpr std::size_t kMax = 1U << 20U;
        QVERIFY(readFile(plan.output, kMax).value() == dumpCsv(*frame, sampled(effect)));
        plan.particles = ParticleFormat::Ply;
        plan.output = pathOf(u"p.ply"_qs);
        QVERIFY(runExport(effect, plan).ok());
        QVERIFY(readFile(plan.output, kMax).value() == dumpPly(LayerOf(*frame, effect).span()));
        plan.up = UpAxis::Z;
        QVERIFY(runExport(effect, plan).ok());
        QVERIFY(readFile(plan.output, kMax).value() == dumpPly(LayerOf(*frame, effect).span(), UpAxis::Z));
    }

    void exportedVolumesAreThoseOfTheFrame()
    {
        const Effect effect = smallEffect();
        ExportPlan plan = planFor(ExportKind::Volumes, u"v.vdb"_qs);
        plan.frames = {6, 6, 1};
        plan.volume.voxel = 0.125F;
        const auto bytes = [&](UpAxis up) {
            return encodeVdb(volumeOf(*frameOf(effect, 6), sampled(effect), 0.125F).value(), up);
        };
        constexpr std::size_t kMax = 1U << 24U;
        QVERIFY(runExport(effect, plan).ok());
        QVERIFY(readFile(plan.output, kMax).value() == bytes(UpAxis::Z));
        plan.up = UpAxis::Y;
        QVERIFY(runExport(effect, plan).ok());
        QVERIFY(readFile(plan.output, kMax).value() == bytes(UpAxis::Y));
        plan.volume.cells = kMaxVolumeCells + 1;
        QCOMPARE(runExport(effect, plan).error().code, ErrorCode::OutOfRange);
    }

    void airIsExportedOnlyOfSmokeThatItCarries()
    {
        const auto done = runExport(smallEffect(), planFor(ExportKind::Air, u"a.fga"_qs));
        QVERIFY(!done.ok());
        QCOMPARE(done.error().code, ErrorCode::OutOfRange);
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }

    void thePresetIsNeverOverwritten()
    {
        for (const ExportKind kind : {ExportKind::Sequence, ExportKind::Flipbook, ExportKind::Picture,
                 ExportKind::NoiseTexture, ExportKind::Particles, ExportKind::Volumes}) {
            ExportPlan plan = planFor(kind, u"a.png"_qs);
            plan.frames = {3, 5, 1};
            plan.flipbook.columns = 3;
            plan.flipbook.rows = 1;
            plan.source = lastFile(Scene(), plan);
            QVERIFY(writeFileAtomically(plan.source, std::string_view("precious")).ok());
            const auto done = runExport(smallEffect(), plan);
            QVERIFY(!done.ok());
            QCOMPARE(done.error().code, ErrorCode::WouldOverwrite);
            QCOMPARE(readFile(plan.source, 100).value(), std::string("precious"));
            plan.source = pathOf(u"another.json"_qs);
            QVERIFY(writeFileAtomically(plan.source, std::string_view("precious")).ok());
            QVERIFY(runExport(smallEffect(), plan).ok());
        }
    }

    void bytesAreThoseOfTheFile()
    {
        for (const ExportKind kind : {ExportKind::Sequence, ExportKind::Picture, ExportKind::NoiseTexture}) {
            ExportPlan plan = planFor(kind, u"a.png"_qs);
            plan.frames = {3, 3, 1};
            QVERIFY(runExport(smallEffect(), plan).ok());
            const std::vector<std::byte> bytes = exportBytes(smallEffect(), plan).value();
            constexpr std::size_t kMax = 1U << 24U;
            const std::string file = readFile(firstFile(Scene(), plan), kMax).value();
            QVERIFY(bytes.size() == file.size() && std::memcmp(bytes.data(), file.data(), file.size()) == 0);
        }
        ExportPlan several = planFor(ExportKind::Sequence, u"a.png"_qs);
        several.frames = {3, 4, 1};
        QCOMPARE(exportBytes(smallEffect(), several).error().code, ErrorCode::OutOfRange);
        for (const ExportKind kind : {ExportKind::Particles, ExportKind::Volumes, ExportKind::Air}) {
            QCOMPARE(exportBytes(smallEffect(), planFor(kind, u"a"_qs)).error().code, ErrorCode::OutOfRange);
        }
    }

    void namesOfOutputsMayBeGivenInManyWays()
    {
        const std::vector<std::string_view> endings{".png", ".exr"};
        const OutputNames names{endings, "smoke"};
        const auto pathOfName = [&](const std::string& name) { return outputPath(name, names).value().string(); };
        QCOMPARE(pathOfName(""), std::string("smoke.png"));
        QCOMPARE(pathOfName("none/"), std::string("none/smoke.png"));
        QCOMPARE(pathOfName(m_folder->path().toStdString()), pathOf(u"smoke.png"_qs));
        for (const std::string same : {"a/x_%04d.png", "x%d", "50%d#.png", "x.%04d", "x", "x.PNG", "x.####", "100%",
                 "%", "%x.exr", "a%d/b", ".hidden"}) {
            QCOMPARE(pathOfName(same), same);
        }
        for (const std::string wrong : {"x.jpg", "x.png.gz", "x.p", "v1.2"}) {
            QCOMPARE(outputPath(wrong, names).error().code, ErrorCode::UnknownName);
        }
        QCOMPARE(outputPath("/dev/null", names).error().code, ErrorCode::NotAFile);
    }

    void signsInNamesAreLettersButWhereTheNumberStands_data()
    {
        QTest::addColumn<QString>("name"); // without ending
        QTest::addColumn<QString>("numbered"); // for frame 7 of several
        const auto row = [](const char* name, const char* numbered) {
            QTest::newRow(name) << QString::fromLatin1(name) << QString::fromLatin1(numbered);
        };
        row("100%dust", "100%dust_0007");
        row("50%done", "50%done_0007");
        row("shot#3_####", "shot#3_0007");
        row("#1", "#1_0007");
        row("a_#", "a_#_0007");
        row("a##b###", "a##b007");
        row("a###b#", "a007b#");
        row("##_a_##_#", "##_a_07_#");
        row("x_%04d", "x_0007");
        row("x_%02d_y", "x_07_y");
        row("%03d_%04d", "%03d_0007");
        row("%04d_##", "%04d_07");
        row("%d", "%d_0007");
        row("%4d", "%4d_0007");
        row("%00d", "%00d_0007");
        row("%0", "%0_0007");
        row("100%", "100%_0007");
        row("%s%n%%", "%s%n%%_0007");
        row("smoke-#2-50%d", "smoke-#2-50%d_0007");
    }
    void signsInNamesAreLettersButWhereTheNumberStands()
    {
        QFETCH(QString, name);
        QFETCH(QString, numbered);
        for (std::size_t i = 0; i < kExportKinds; ++i) {
            ExportPlan plan = planFor(static_cast<ExportKind>(i), name);
            plan.frames = {7, 9, 1};
            plan.output = plan.output.parent_path() / (name.toStdString() + std::string(fileEnding(plan)));
            const QString wanted = isNumbered(plan.kind) ? numbered : name;
            QCOMPARE(QString::fromStdString(firstFile(Scene(), plan).filename().string()),
                wanted + QString::fromStdString(std::string(fileEnding(plan))));
            if (isNumbered(plan.kind)) {
                QVERIFY(lastFile(Scene(), plan) != firstFile(Scene(), plan));
            }
        }
    }

    void whatIsEndedEarlyLeavesNothing()
    {
        std::stop_source stop;
        stop.request_stop();
        for (const Engine engine : kAllEngines) {
            ExportPlan plan = planFor(ExportKind::Flipbook, u"a.png"_qs);
            plan.flipbook.engine = engine;
            plan.passes = passesFor(engine);
            plan.flipbook.columns = plan.flipbook.rows = 1;
            QCOMPARE(runExport(smallEffect(), plan, stop.get_token()).error().code, ErrorCode::Cancelled);
            QVERIFY(std::filesystem::is_empty(plan.output.parent_path()));
        }
    }

    void everyKindClearsAwayWhatKilledProgramsLeft()
    {
        Effect effect = smallEffect();
        effect.air.enabled = true;
        effect.air.resolution = 16;
        for (std::size_t i = 0; i < kExportKinds; ++i) {
            ExportPlan plan = planFor(static_cast<ExportKind>(i), u"a%1"_qs.arg(i));
            plan.flipbook.columns = plan.flipbook.rows = 1;
            const std::filesystem::path left = plan.output.parent_path() / ".fumage-999999999-0";
            QVERIFY(writeFileAtomically(left, std::string_view("half")).ok());
            static_cast<void>(runExport(effect, plan)); // not all kinds can be done here
            QVERIFY2(!std::filesystem::exists(left), nameOf(plan.kind).data());
        }
    }

    void everyKindCanBeCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        for (const ExportKind kind : {ExportKind::Sequence, ExportKind::Flipbook, ExportKind::Picture,
                 ExportKind::NoiseTexture, ExportKind::Particles, ExportKind::Volumes}) {
            ExportPlan plan = planFor(kind, u"a"_qs);
            plan.frames = {5, 100, 1};
            const auto done = runExport(smallEffect(), plan, stop.get_token());
            QVERIFY(!done.ok());
            QCOMPARE(done.error().code, ErrorCode::Cancelled);
        }
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }

private:
    [[nodiscard]] std::string pathOf(const QString& name) const { return m_folder->filePath(name).toStdString(); }

    [[nodiscard]] ExportPlan planFor(ExportKind kind, const QString& output) const
    {
        ExportPlan plan;
        plan.kind = kind;
        plan.output = pathOf(output);
        return plan;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(PlanTest)
#include "plan_test.moc"
