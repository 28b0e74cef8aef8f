// Sheets of layers that are looked at together: what each holds, and whether they make the sheet of all.
#include "tests/export/layered_fire.h"
#include "tests/helpers.h"

#include "core/export/plan.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/layer_check.h"
#include "core/preset/preset_file.h"
#include "core/system/file.h"

#include <QFile>
#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Sheets of layers in a folder, as an export leaves them.
class Exported {
public:
    explicit Exported(LayerOutput layers, ImageFormat format = ImageFormat::Png8, const Scene& scene = fire())
    {
        plan.kind = ExportKind::Flipbook;
        plan.output = path(format == ImageFormat::Png8 ? "boom.png" : "boom.exr");
        plan.frames = {12, 27, 1};
        plan.flipbook.columns = plan.flipbook.rows = 2;
        plan.format = format;
        plan.layers = layers;
        plan.project.emplace();
        plan.recording.manifest = path("boom.manifest.json");
        const auto made = runExport(scene, plan);
        if (!made) {
            qFatal("%s", made.error().text().c_str());
        }
    }

    [[nodiscard]] std::filesystem::path path(const char* name) const
    {
        return m_folder.filePath(QString::fromUtf8(name)).toStdString();
    }
    [[nodiscard]] LayeredSheets found(const char* name = "boom.manifest.json") const
    {
        const Result<std::optional<LayeredSheets>> found = findLayeredSheets(path(name));
        if (!found || !found.value()) {
            qFatal("%s", found ? "not layered" : found.error().text().c_str());
        }
        return *found.value();
    }

    ExportPlan plan;

private:
    QTemporaryDir m_folder;
};

} // namespace

class LayerCheckTest : public QObject {
    Q_OBJECT

private slots:
    void sheetsMakeTheSheetOfAll_data()
    {
        QTest::addColumn<int>("layers");
        QTest::addColumn<int>("format");
        QTest::addColumn<double>("least"); // dB; what half a step of 8 bits leaves is 59
        for (const LayerOutput layers : {LayerOutput::Contribution, LayerOutput::Stacked}) {
            const std::string name(nameOf(layers));
            QTest::addRow("%s png", name.c_str())
                << static_cast<int>(layers) << static_cast<int>(ImageFormat::Png8) << 52.0;
            QTest::addRow("%s exr", name.c_str())
                << static_cast<int>(layers) << static_cast<int>(ImageFormat::ExrHalf) << 65.0;
            QTest::addRow("%s exr32", name.c_str())
                << static_cast<int>(layers) << static_cast<int>(ImageFormat::ExrFloat)
                << (layers == LayerOutput::Contribution ? 99.0 : 90.0);
        }
    }
    void sheetsMakeTheSheetOfAll()
    {
        QFETCH(int, layers);
        QFETCH(int, format);
        QFETCH(double, least);
        const Exported exported(static_cast<LayerOutput>(layers), static_cast<ImageFormat>(format));
        const Result<LayeredScore> score = scoreLayers(exported.found());
        QVERIFY2(score.ok(), score ? "" : score.error().text().c_str());
        QVERIFY2(score.value().decibels.value() >= least, qPrintable(QString::number(*score.value().decibels)));
        QCOMPARE(score.value().sheets.size(), std::size_t{3});
        QCOMPARE(score.value().sheets[2].layer, std::string("Red ash"));
        for (const LayerSheetScore& sheet : score.value().sheets) {
            QVERIFY(sheet.seen > 0.01 && sheet.seen < 1.0);
            QCOMPARE(sheet.empty, 0);
        }
    }

    void blendingAsLightMakesItToo()
    {
        Exported exported(LayerOutput::Stacked);
        exported.plan.blending = BlendSpace::Linear;
        QVERIFY(runExport(fire(), exported.plan).ok());
        const LayeredSheets found = exported.found();
        QVERIFY(found.options.blending == BlendSpace::Linear);
        QVERIFY(scoreLayers(found).value().decibels.value() > 50.0);
        // Taken for what they are not, they do not.
        LayeredSheets wrong = found;
        wrong.options.blending = BlendSpace::Encoded;
        QVERIFY(scoreLayers(wrong).value().decibels.value() < 40.0);
    }

    void anyOfTheSheetsNamesThemAll()
    {
        const Exported exported(LayerOutput::Contribution);
        const LayeredSheets byManifest = exported.found();
        for (const char* name : {"boom_smoke.png", "boom_flames.png", "boom_red-ash.png"}) {
            const LayeredSheets found = exported.found(name);
            QCOMPARE(found.options.output.filename().string(), std::string("boom.png"));
            QVERIFY(formatPreset(Preset{.scene = found.scene}) == formatPreset(Preset{.scene = byManifest.scene}));
            QVERIFY(scoreLayers(found).value().decibels == scoreLayers(byManifest).value().decibels);
        }
        const std::filesystem::path renamed = exported.path("other.png");
        std::filesystem::copy_file(exported.path("boom_smoke.png"), renamed);
        QCOMPARE(findLayeredSheets(renamed).error().code, ErrorCode::OutOfRange);
    }

    /// They are not covered by one another: it is no fault that they make no picture.
    void layersAloneMakeNoPicture()
    {
        const Exported exported(LayerOutput::Alone);
        const Result<LayeredScore> score = scoreLayers(exported.found());
        QVERIFY(score.ok());
        QVERIFY(!score.value().decibels);
        QCOMPARE(score.value().sheets.size(), std::size_t{3});
    }

    void aSheetOfAnotherExportIsHeard()
    {
        const Exported exported(LayerOutput::Contribution);
        QFile::remove(QString::fromStdString(exported.path("boom_smoke.png").string()));
        std::filesystem::copy_file(exported.path("boom_flames.png"), exported.path("boom_smoke.png"));
        QVERIFY(scoreLayers(exported.found()).value().decibels.value() < 35.0);
    }

    void whatIsSeenIsCounted()
    {
        Scene scene = fire();
        scene.layers[1].look.opacity = 0.0F;
        Scene near = scene;
        near.camera.distance = 1.0F; // smoke reaches the borders
        near.camera.target = {0.0F, 0.5F, 0.0F};
        const Exported exported(LayerOutput::Alone, ImageFormat::ExrFloat, scene);
        const LayeredScore score = scoreLayers(exported.found()).value();
        QCOMPARE(score.sheets[1].empty, 4);
        QVERIFY(near.camera.distance < scene.camera.distance);
        QCOMPARE(score.sheets[1].seen, 0.0);
        QCOMPARE(score.sheets[0].empty, 0);
        const Exported close(LayerOutput::Alone, ImageFormat::ExrFloat, near);
        const LayeredScore closer = scoreLayers(close.found()).value();
        QVERIFY(closer.sheets[0].edgeAlpha > score.sheets[0].edgeAlpha);
        QVERIFY(closer.sheets[0].seen > score.sheets[0].seen);
    }

    void whatIsMissingIsNamed()
    {
        const Exported exported(LayerOutput::Stacked);
        const LayeredSheets found = exported.found();
        QFile::remove(QString::fromStdString(exported.path("boom_flames.png").string()));
        const auto missing = scoreLayers(found);
        QCOMPARE(missing.error().code, ErrorCode::FileNotFound);
        QVERIFY(missing.error().text().find("Flames") != std::string::npos);
        Exported smaller(LayerOutput::Stacked);
        std::filesystem::copy_file(smaller.path("boom_flames.png"), exported.path("boom_flames.png"));
        QVERIFY(scoreLayers(found).ok());
        Scene other = fire();
        other.output.width = 20;
        const Exported narrow(LayerOutput::Stacked, ImageFormat::Png8, other);
        QFile::remove(QString::fromStdString(exported.path("boom_flames.png").string()));
        std::filesystem::copy_file(narrow.path("boom_flames.png"), exported.path("boom_flames.png"));
        const auto misfit = scoreLayers(found);
        QCOMPARE(misfit.error().code, ErrorCode::OutOfRange);
        QVERIFY2(misfit.error().text().find("40 x 48") != std::string::npos, misfit.error().text().c_str());
    }

    void whatIsNotLayeredIsSaid()
    {
        const QTemporaryDir folder;
        ExportPlan plan;
        plan.kind = ExportKind::Flipbook;
        plan.output = folder.filePath(QStringLiteral("one.png")).toStdString();
        plan.frames = {12, 27, 1};
        plan.flipbook.columns = plan.flipbook.rows = 2;
        plan.project.emplace();
        plan.recording.manifest = folder.filePath(QStringLiteral("one.manifest.json")).toStdString();
        QVERIFY(runExport(fire(), plan).ok());
        QCOMPARE(findLayeredSheets(plan.recording.manifest).error().code, ErrorCode::OutOfRange);
        QVERIFY(!findLayeredSheets(plan.output).value());
        QCOMPARE(findLayeredSheets(folder.filePath(QStringLiteral("no.manifest.json")).toStdString()).error().code,
            ErrorCode::FileNotFound);
        // Sheets without colour make nothing.
        plan.layers = LayerOutput::Contribution;
        plan.passes = {Pass::Alpha};
        QVERIFY(runExport(fire(), plan).ok());
        const LayeredSheets found = *findLayeredSheets(plan.recording.manifest).value();
        QCOMPARE(scoreLayers(found).error().code, ErrorCode::OutOfRange);
    }
};

QTEST_APPLESS_MAIN(LayerCheckTest)
#include "layer_check_test.moc"
