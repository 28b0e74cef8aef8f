// What everyone may take for granted of the presets that come along.
#include "tests/helpers.h"
#include "tests/png_file.h"

#include "core/export/sheets/cell_frames.h"
#include "core/export/sheets/flipbook.h"
#include "core/preset/library.h"
#include "core/simulation/scene_simulator.h"

#include <QTemporaryDir>

using namespace fumage;

namespace {

constexpr int kCell = 64; // pixels

/// Of a cell's width or of its height, whichever is the larger share, that has smoke in one cell or another.
double usedOfCells(const tests::PngFile& sheet)
{
    constexpr int kAlpha = 3;
    int left = kCell, right = 0, top = kCell, bottom = 0;
    for (int y = 0; y < sheet.height; ++y) {
        for (int x = 0; x < sheet.width; ++x) {
            if (sheet.at(x, y, kAlpha) > 0) {
                left = std::min(left, x % kCell);
                right = std::max(right, x % kCell + 1);
                top = std::min(top, y % kCell);
                bottom = std::max(bottom, y % kCell + 1);
            }
        }
    }
    return static_cast<double>(std::max(right - left, bottom - top)) / kCell;
}

} // namespace

class BuiltinTest : public QObject {
    Q_OBJECT

private slots:
    void halfOfThemLoop()
    {
        const std::vector<LibraryEntry> presets = builtinPresets();
        const auto loops = [](const LibraryEntry& entry) {
            return loadPreset(entry).value().preset.scene.timeline.loop;
        };
        QVERIFY(std::ranges::count_if(presets, loops) >= 8);
    }

    void whatBurstsIsGoneBeforeTheLastFrameAndTheLastCellOfASheet_data()
    {
        QTest::addColumn<std::string>("name");
        for (const LibraryEntry& entry : builtinPresets()) {
            const Effect effect = loadPreset(entry).value().preset.scene.effect();
            if (effect.emitter.mode == EmissionMode::Burst && !effect.timeline.loop) {
                QTest::newRow(entry.id.c_str()) << entry.id;
            }
        }
    }

    void whatBurstsIsGoneBeforeTheLastFrameAndTheLastCellOfASheet()
    {
        QFETCH(std::string, name);
        Scene scene = loadPreset(name).value().preset.scene;
        scene.air.resolution = kMinAirResolution;
        for (Layer& layer : scene.layers) {
            layer.emitter.count = std::min(layer.emitter.count, 2000);
        }
        FlipbookOptions flipbook;
        flipbook.columns = flipbook.rows = 8;
        flipbook.frames = {0, scene.timeline.length - 1, 1};
        const int last = frameOfCell(flipbook, 8 * 8 - 1);
        SceneSimulator simulator(sampledLayers(scene));
        const auto living = [&](int number) {
            int sum = 0;
            const SceneFrame frame = simulator.frame(number).value();
            for (const std::shared_ptr<const Frame>& layer : frame.layers) {
                sum += tests::livingCount(*layer);
            }
            return sum;
        };
        QVERIFY(living(last / 2) > 1000);
        QCOMPARE(living(last), 0);
        QCOMPARE(living(scene.timeline.length - 1), 0);
    }

    void eachGivesAWholeFlipbook_data()
    {
        QTest::addColumn<std::string>("name");
        for (const LibraryEntry& entry : builtinPresets()) {
            QTest::newRow(entry.id.c_str()) << entry.id;
        }
    }

    void eachGivesAWholeFlipbook()
    {
        QFETCH(std::string, name);
        const QTemporaryDir folder;
        Scene scene = loadPreset(name).value().preset.scene;
        for (Layer& layer : scene.layers) {
            layer.emitter.count = (layer.emitter.count + 3) / 4; // reach as far, and are simulated sooner
        }
        scene.output.width = scene.output.height = kCell;
        scene.output.background = Background::Transparent;
        FlipbookOptions flipbook;
        flipbook.output = folder.path().toStdString() + "/a.png";
        flipbook.columns = 4;
        flipbook.rows = 3;
        flipbook.frames = {0, scene.timeline.length - 1, 1};
        const Flipbook book = renderFlipbook(scene, flipbook).value();
        QVERIFY2(book.edgeAlpha < 1.0F / 255.0F, qPrintable(QString::number(static_cast<double>(book.edgeAlpha))));
        const tests::PngFile sheet(book.picture.string());
        QCOMPARE(sheet.channels, 4);
        const double used = usedOfCells(sheet);
        QVERIFY2(used >= 0.6, qPrintable(QString::number(used)));
    }
};

QTEST_GUILESS_MAIN(BuiltinTest)
#include "builtin_test.moc"
