// Flipbooks that are read back from their files.
#include "tests/helpers.h"
#include "tests/export/small_smoke.h"

#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/sheet_reader.h"

#include <QFile>
#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr std::int64_t kMaxPixels = 1 << 22;

} // namespace

class SheetReaderTest : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void whatIsReadIsWhatThePreviewHasShown_data()
    {
        QTest::addColumn<int>("engine");
        QTest::newRow("colours and vectors to the right") << static_cast<int>(Engine::Unity);
        QTest::newRow("vectors to the left") << static_cast<int>(Engine::Unreal);
        QTest::newRow("colours alone") << static_cast<int>(Engine::Effekseer);
    }
    void whatIsReadIsWhatThePreviewHasShown()
    {
        QFETCH(int, engine);
        const ExportPlan plan = planFor(static_cast<Engine>(engine));
        const auto read = written(plan);
        QVERIFY2(read.ok(), read ? "" : read.error().text().c_str());
        const auto preview = previewFlipbook(smallSmoke(), plan, 320, kMaxPixels);
        QVERIFY(preview.ok());
        QCOMPARE(read.value()->sheet.grid.cells, 6);
        QCOMPARE(read.value()->sheet.grid.columns, 3);
        QCOMPARE(read.value()->sheet.grid.loops, preview.value()->sheet.grid.loops);
        QVERIFY(near(read.value()->cellsPerSecond, preview.value()->cellsPerSecond, 1e-6));
        QCOMPARE(read.value()->playback->hasMotion(), plan.passes.has(Pass::Motion));
        QVERIFY(read.value()->isWhole);
        for (const double cell : {0.0, 1.5, 4.25}) {
            Image here;
            Image there;
            read.value()->playback->picture(cell, false, CellBlending::Motion, here);
            preview.value()->playback->picture(cell, false, CellBlending::Motion, there);
            QCOMPARE(here.pixels.size(), there.pixels.size());
            for (std::size_t i = 0; i < here.pixels.size(); ++i) {
                QVERIFY2(near(here.pixels[i], there.pixels[i], 1e-3F), qPrintable(QString::number(i)));
            }
        }
    }

    void aDescriptionThatIsWrongIsRefused_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("no JSON") << QByteArray("{") << QByteArray("");
        QTest::newRow("of something else") << QByteArray("fumage-flipbook") << QByteArray("fumage-job");
        QTest::newRow("no columns") << QByteArray("\"columns\": 3") << QByteArray("\"columns\": 0");
        QTest::newRow("half a row") << QByteArray("\"rows\": 2") << QByteArray("\"rows\": 2.5");
        QTest::newRow("another size") << QByteArray("\"rows\": 2") << QByteArray("\"rows\": 3");
        QTest::newRow("no speed") << QByteArray("\"cells_per_second\": ") << QByteArray("\"cells_per_second\": -");
        QTest::newRow("a file elsewhere") << QByteArray("\"file\": \"") << QByteArray("\"file\": \"../");
        QTest::newRow("no colours") << QByteArray("\"pass\": \"colour\"") << QByteArray("\"pass\": \"alpha\"");
    }
    void aDescriptionThatIsWrongIsRefused()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        const ExportPlan plan = planFor(Engine::Generic);
        QVERIFY(written(plan).ok());
        QFile file(QString::fromStdString(descriptionOf(plan.output).string()));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray text = file.readAll();
        QVERIFY(text.contains(from));
        text.replace(text.indexOf(from), from.size(), to);
        QVERIFY(file.resize(0) && file.seek(0));
        file.write(text);
        file.close();
        const auto read = readFlipbook(descriptionOf(plan.output), kMaxPixels);
        QVERIFY(!read.ok());
        QVERIFY(!read.error().text().empty());
    }

    void aPictureThatIsGoneOrBrokenIsAnError()
    {
        const ExportPlan plan = planFor(Engine::Generic);
        QVERIFY(written(plan).ok());
        QFile picture(QString::fromStdString(plan.output.string()));
        QVERIFY(picture.resize(picture.size() / 2));
        QVERIFY(!readFlipbook(descriptionOf(plan.output), kMaxPixels).ok());
        QVERIFY(picture.remove());
        const auto read = readFlipbook(descriptionOf(plan.output), kMaxPixels);
        QVERIFY(!read.ok() && read.error().code == ErrorCode::FileNotFound);
        QVERIFY(!readFlipbook(m_folder.filePath(QStringLiteral("none.json")).toStdString(), kMaxPixels).ok());
    }

    void aSheetThatIsTooLargeIsNotRead()
    {
        const ExportPlan plan = planFor(Engine::Generic);
        const int pixels = 3 * 24 * 2 * 24;
        QVERIFY(written(plan).ok());
        QVERIFY(readFlipbook(descriptionOf(plan.output), pixels).ok());
        const auto read = readFlipbook(descriptionOf(plan.output), pixels - 1);
        QVERIFY(!read.ok() && read.error().code == ErrorCode::TooLarge);
    }

private:
    [[nodiscard]] ExportPlan planFor(Engine engine) const
    {
        ExportPlan plan;
        plan.kind = ExportKind::Flipbook;
        plan.output = m_folder.filePath(QStringLiteral("sheet_3x2.png")).toStdString();
        plan.flipbook.engine = engine;
        plan.flipbook.columns = 3;
        plan.flipbook.rows = 2;
        plan.passes = passesFor(engine);
        plan.style = styleFor(engine, plan.format);
        plan.frames = {10, 20, 2};
        return plan;
    }

    [[nodiscard]] static Result<std::shared_ptr<const SheetPreview>> written(const ExportPlan& plan)
    {
        const auto made = runExport(smallSmoke(), plan);
        if (!made) {
            return made.error();
        }
        return readFlipbook(descriptionOf(plan.output), kMaxPixels);
    }

    QTemporaryDir m_folder;
};

QTEST_APPLESS_MAIN(SheetReaderTest)
#include "sheet_reader_test.moc"
