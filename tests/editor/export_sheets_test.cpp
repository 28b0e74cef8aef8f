// What the export dialog offers for flipbooks.
#include "export_dialog_fixture.h"
#include "tests/export/small_smoke.h"

#include "ui/export/preview_canvas.h"
#include "ui/panels/curve_editor.h"

#include "core/export/engines/engine_remarks.h"
#include "core/export/sheets/packing.h"
#include "core/export/sheets/sheet_playback.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QUndoStack>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEndMs = 60000; ///< what is done by then on a busy machine

}

class ExportSheetsTest : public ExportDialogFixture {
    Q_OBJECT

private slots:
    void anEngineBringsItsPassesAndFiles()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        auto* engine = child<QComboBox>(u"export.engine"_q);
        QCOMPARE(m_dialog->plan().flipbook.engine, Engine::Generic);
        QVERIFY(m_dialog->plan().passes == PassSet{Pass::Colour});
        engine->setCurrentIndex(engine->findText(u"Unreal Engine"_q));
        const ExportPlan unreal = m_dialog->plan();
        QCOMPARE(unreal.flipbook.engine, Engine::Unreal);
        QVERIFY(unreal.passes == passesFor(Engine::Unreal));
        QCOMPARE(unreal.style.vectors, VectorSigns::Unreal);
        QVERIFY(child<QLabel>(u"export.files"_q)->text().contains(u"5 more"_q));
        child<QCheckBox>(u"export.sixWay"_q)->setChecked(false);
        QVERIFY(!m_dialog->plan().passes.has(Pass::SixWayA));
        QVERIFY(m_dialog->plan().passes.has(Pass::Motion));
        // What it cannot read cannot be exported, and the dialog says why.
        QVERIFY(child<QPushButton>(u"export.begin"_q)->isEnabled());
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(2);
        QVERIFY(!child<QPushButton>(u"export.begin"_q)->isEnabled());
        QVERIFY(child<QLabel>(u"export.files"_q)->text().contains(u"PNG"_q));
        m_dialog->setKind(ExportKind::Sequence);
        QVERIFY(child<QPushButton>(u"export.begin"_q)->isEnabled());
        QVERIFY(!engine->isVisible());
    }

    /// What one layer cannot be asked, and what shares of layers have not, is out of reach.
    void layersHaveSheetsOfTheirOwn()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        auto* layers = child<QComboBox>(u"export.layers"_q);
        auto* motion = child<QCheckBox>(u"export.motion"_q);
        QVERIFY(!layers->isEnabled());
        QVERIFY(!m_dialog->plan().layers);
        Scene scene = m_document->scene();
        scene.layers[0].name = "Smoke";
        scene.layers.push_back(scene.layers[0]);
        scene.layers[1].name = "Flames";
        m_document->replaceScene(scene, 0, u"layers"_q);
        QTRY_VERIFY(layers->isEnabled());
        motion->setChecked(true);
        layers->setCurrentIndex(static_cast<int>(LayerOutput::Alone));
        QCOMPARE(m_dialog->plan().layers.value(), LayerOutput::Alone);
        QVERIFY(m_dialog->plan().passes.has(Pass::Motion));
        layers->setCurrentIndex(static_cast<int>(LayerOutput::Stacked));
        QCOMPARE(m_dialog->plan().layers.value(), LayerOutput::Stacked);
        QVERIFY(m_dialog->plan().passes == PassSet{Pass::Colour});
        QVERIFY(!motion->isEnabled());
        QVERIFY(child<QPushButton>(u"export.begin"_q)->isEnabled());
        const auto* files = child<QLabel>(u"export.files"_q);
        QVERIFY2(files->text().contains(u"_smoke.png"_q), qPrintable(files->text()));
        // Who cannot draw them over one another says so.
        auto* engine = child<QComboBox>(u"export.engine"_q);
        engine->setCurrentIndex(engine->findText(u"Defold"_q));
        QVERIFY(!child<QPushButton>(u"export.begin"_q)->isEnabled());
        QVERIFY2(files->text().contains(u"Defold"_q), qPrintable(files->text()));
        layers->setCurrentIndex(static_cast<int>(LayerOutput::Together));
        QVERIFY(!m_dialog->plan().layers);
        QVERIFY(motion->isEnabled());
        QVERIFY(child<QPushButton>(u"export.begin"_q)->isEnabled());
    }

    /// Where there is room for them, and something to mask.
    void layersOfAnExrHaveMasks()
    {
        m_dialog->setKind(ExportKind::Sequence);
        auto* masks = child<QCheckBox>(u"export.masks"_q);
        auto* format = child<QComboBox>(u"export.format"_q);
        QVERIFY(!masks->isEnabled());
        format->setCurrentIndex(format->findText(u"EXR"_q, Qt::MatchContains));
        QVERIFY(!masks->isEnabled());
        Scene scene = m_document->scene();
        scene.layers.push_back(scene.layers[0]);
        m_document->replaceScene(scene, 0, u"layers"_q);
        QTRY_VERIFY(masks->isEnabled());
        QVERIFY(m_dialog->plan().passes == PassSet{Pass::Colour});
        masks->setChecked(true);
        QVERIFY((m_dialog->plan().passes == PassSet{Pass::Colour, Pass::LayerMasks}));
        QVERIFY(child<QPushButton>(u"export.begin"_q)->isEnabled());
        format->setCurrentIndex(0);
        QVERIFY(!masks->isEnabled());
        QVERIFY(m_dialog->plan().passes == PassSet{Pass::Colour});
        // Of a sheet they are a file more; sheets of layers have none.
        m_dialog->setKind(ExportKind::Flipbook);
        format->setCurrentIndex(format->findText(u"EXR"_q, Qt::MatchContains));
        const auto* files = child<QLabel>(u"export.files"_q);
        QVERIFY2(files->text().contains(u"2 more files"_q), qPrintable(files->text()));
        auto* layers = child<QComboBox>(u"export.layers"_q);
        layers->setCurrentIndex(static_cast<int>(LayerOutput::Alone));
        QVERIFY(!masks->isEnabled());
        QVERIFY(!m_dialog->plan().passes.has(Pass::LayerMasks));
    }

    void aSpeedThatAnEngineCannotKeepIsSaid()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        auto* engine = child<QComboBox>(u"export.engine"_q);
        const auto* files = child<QLabel>(u"export.files"_q);
        engine->setCurrentIndex(engine->findText(u"Godot 4"_q));
        QVERIFY(!files->text().contains(u"frames a second"_q));
        engine->setCurrentIndex(engine->findText(u"Effekseer"_q));
        QVERIFY(!engineRemarks(m_document->effect(), flipbookOf(m_dialog->plan()))
                     .empty()); // 64 cells of 100 frames: 19.2 a second
        QVERIFY2(files->text().contains(u"Effekseer plays this sheet in 3.2 s"_q), qPrintable(files->text()));
    }

    void rareChoicesOfAFlipbookAreFoldedAway()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        auto* trim = child<QCheckBox>(u"export.trim"_q);
        auto* curve = child<CurveArea>(u"export.retime"_q);
        QVERIFY(!trim->isVisible());
        const ExportPlan plain = m_dialog->plan();
        QVERIFY(!plain.flipbook.trim && !plain.flipbook.powerOfTwo && !plain.flipbook.retime
            && plain.flipbook.packs.empty());
        child<QToolButton>(u"export.more"_q)->click();
        QVERIFY(trim->isVisible() && !curve->isVisible());
        trim->click();
        child<QCheckBox>(u"export.powerOfTwo"_q)->click();
        child<QCheckBox>(u"export.retimes"_q)->click();
        QVERIFY(curve->isVisible());
        QTest::mouseClick(curve, Qt::LeftButton, {}, curve->toScreen({0.25F, 0.75F}).toPoint());
        const ExportPlan plan = m_dialog->plan();
        QVERIFY(plan.flipbook.trim && plan.flipbook.powerOfTwo);
        QCOMPARE(plan.flipbook.retime->count, 3);
        QVERIFY(std::abs(plan.flipbook.retime->at(0.25F) - 0.75F) < 0.05F);
        child<QToolButton>(u"export.more"_q)->click();
        QVERIFY(!trim->isVisible());
        QVERIFY(m_dialog->plan().flipbook.trim); // out of sight is not out of the plan
    }

    void aLoopIsNotTrimmed()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        auto* trim = child<QCheckBox>(u"export.trim"_q);
        trim->setChecked(true);
        m_document->edit(knownParameter("timeline.loop"), true);
        QVERIFY(!trim->isEnabled());
        QVERIFY(!m_dialog->plan().flipbook.trim);
        m_document->edit(knownParameter("timeline.loop"), false);
        QVERIFY(m_dialog->plan().flipbook.trim);
    }

    void sidesOfPowersOfTwoAreTold()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        setWidth(100);
        m_document->edit(knownParameter("output.height"), 60);
        child<QCheckBox>(u"export.powerOfTwo"_q)->setChecked(true);
        const auto* files = child<QLabel>(u"export.files"_q);
        QVERIFY2(files->text().contains(u"1024 × 512"_q), qPrintable(files->text()));
        child<QSpinBox>(u"export.columns"_q)->setValue(6);
        QVERIFY2(files->text().contains(u"powers of two"_q), qPrintable(files->text()));
        QVERIFY(!child<QPushButton>(u"export.begin"_q)->isEnabled());
    }

    void packedPicturesAreChosenByTheirChannels()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        setWidth(256);
        m_document->edit(knownParameter("output.height"), 256);
        child<QToolButton>(u"export.more"_q)->click();
        auto* add = child<QPushButton>(u"export.addPack"_q);
        add->click();
        QVERIFY(fitsItsWidth());
        QCOMPARE(m_dialog->plan().flipbook.packs.size(), std::size_t{1});
        QVERIFY(m_dialog->plan().flipbook.packs[0] == parsePack("masks1=shadow,temperature,alpha").value());
        child<QLineEdit>(u"export.pack1.name"_q)->setText(u"own"_q);
        child<QComboBox>(u"export.pack1.channel1"_q)->setCurrentIndex(0);
        child<QComboBox>(u"export.pack1.channel2"_q)->setCurrentText(u"motion.r"_q);
        child<QComboBox>(u"export.pack1.size"_q)->setCurrentIndex(1);
        QVERIFY(m_dialog->plan().flipbook.packs[0] == parsePack("own=shadow,0,motion.r@1/2").value());
        // A sheet of 2048 x 2048 is 4 MiB as BC7, and one of 1024 x 1024 another.
        QVERIFY2(child<QLabel>(u"export.files"_q)->text().contains(u"5.0 MiB"_q),
            qPrintable(child<QLabel>(u"export.files"_q)->text()));
        child<QLineEdit>(u"export.pack1.name"_q)->setText(u"motion"_q);
        QVERIFY(child<QLabel>(u"export.files"_q)->text().contains(u"name of a pass"_q));
        QVERIFY(!child<QPushButton>(u"export.begin"_q)->isEnabled());
        child<QLineEdit>(u"export.pack1.name"_q)->setText(u"own"_q);
        QVERIFY(child<QPushButton>(u"export.begin"_q)->isEnabled());
        for (int i = 0; i < 4; ++i) {
            add->click();
        }
        QVERIFY(!add->isEnabled());
        child<QPushButton>(u"export.pack2.remove"_q)->click();
        add->click();
        QVERIFY(child<QPushButton>(u"export.begin"_q)->isEnabled()); // all five have names of their own
        QCOMPARE(m_dialog->plan().flipbook.packs.size(), std::size_t{5});
    }

    void thePreviewPlaysTheCellsWhileItIsOpen()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        for (const QString& box : {u"export.columns"_q, u"export.rows"_q}) {
            child<QSpinBox>(box)->setValue(2);
        }
        setWidth(64);
        m_document->edit(knownParameter("emitter.count"), 500);
        m_document->edit(knownParameter("output.height"), 64);
        auto* canvas = child<PreviewCanvas>(u"export.preview.canvas"_q);
        QVERIFY(!canvas->isVisible());
        auto* plays = child<QCheckBox>(u"export.plays"_q);
        plays->click();
        QVERIFY(canvas->isVisible());
        QTRY_COMPARE(canvas->image().width(), 64);
        // Motion vectors are played where they are written.
        auto* blending = child<QComboBox>(u"export.preview.blending"_q);
        QCOMPARE(blending->count(), 2);
        child<QCheckBox>(u"export.motion"_q)->click();
        QCOMPARE(blending->count(), 3);
        QCOMPARE(blending->currentIndex(), static_cast<int>(CellBlending::Motion));
        // Another effect is rendered anew; a closed preview is not.
        setWidth(48);
        QTRY_COMPARE(canvas->image().width(), 48);
        plays->click();
        QVERIFY(!canvas->isVisible());
        setWidth(32);
        QCOMPARE(canvas->image().width(), 48);
        plays->click();
        QTRY_COMPARE(canvas->image().width(), 32);
    }

    void memoryOnTheGraphicsCardIsTold()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        setWidth(256);
        m_document->edit(knownParameter("output.height"), 256);
        const QString before = child<QLabel>(u"export.files"_q)->text();
        QVERIFY2(before.contains(u"4.0 MiB"_q) && before.contains(u"16.0 MiB"_q), qPrintable(before));
        child<QCheckBox>(u"export.motion"_q)->click();
        QVERIFY(child<QLabel>(u"export.files"_q)->text().contains(u"8.0 MiB"_q));
        // Of layers that have sheets of their own all of them count.
        Scene scene = m_document->scene();
        scene.layers.resize(3, scene.layers[0]);
        m_document->replaceScene(scene, 0, u"layers"_q);
        auto* layers = child<QComboBox>(u"export.layers"_q);
        QTRY_VERIFY(layers->isEnabled());
        QVERIFY(child<QLabel>(u"export.files"_q)->text().contains(u"8.0 MiB"_q));
        layers->setCurrentIndex(static_cast<int>(LayerOutput::Alone));
        QVERIFY(child<QLabel>(u"export.files"_q)->text().contains(u"24.0 MiB"_q));
    }

    void aSheetIsFoundForABudgetOfMemory()
    {
        auto* find = findableSheet();
        const Effect before = m_document->effect();
        const ExportPlan plain = m_dialog->plan();
        find->click();
        QCOMPARE(find->text(), u"Cancel"_q);
        QTRY_VERIFY_WITH_TIMEOUT(find->text() == u"Optimise"_q, kEndMs);
        const QString said = child<QLabel>(u"export.findSheet.state"_q)->text();
        QVERIFY2(said.contains(u"dB"_q), qPrintable(said));
        const ExportPlan plan = m_dialog->plan();
        const Output cell = m_document->effect().output;
        QVERIFY2(said.startsWith(u"%1 × %2 cells of %3 × %4 pixels"_q.arg(plan.flipbook.columns)
                                     .arg(plan.flipbook.rows)
                                     .arg(cell.width)
                                     .arg(cell.height)),
            qPrintable(said));
        QVERIFY(memoryOf(flipbookOf(plan), cell.width, cell.height).compressed <= 104'858
            && cell.width < before.output.width);
        // A larger budget is not bound by what the smaller one has left of the cells.
        child<QDoubleSpinBox>(u"export.budget"_q)->setValue(100.0);
        find->click();
        QTRY_VERIFY_WITH_TIMEOUT(find->text() == u"Optimise"_q, kEndMs);
        QCOMPARE(m_document->effect().output.width, before.output.width);
        m_document->undoStack()->undo();
        m_document->undoStack()->undo();
        QVERIFY(m_document->effect() == before);
    }

    void aSearchForASheetEndsWhereItsFlipbookBecomesAnother()
    {
        auto* find = findableSheet();
        const auto* state = child<QLabel>(u"export.findSheet.state"_q);
        for (const auto& change : {std::function<void()>([&] { find->click(); }),
                 std::function<void()>([&] { m_document->edit(knownParameter("motion.gravity"), 1.0F); }),
                 std::function<void()>([&] { child<QSpinBox>(u"export.last"_q)->setValue(60); }),
                 std::function<void()>([&] { child<QToolButton>(u"export.more"_q)->click(); })}) {
            find->click();
            QCOMPARE(find->text(), u"Cancel"_q);
            const Output before = m_document->effect().output;
            change();
            QCOMPARE(find->text(), u"Optimise"_q);
            QVERIFY2(state->text().startsWith(u"Cancelled"_q), qPrintable(state->text()));
            QVERIFY(m_document->effect().output == before);
        }
    }

    void aGridThatItsFramesDoNotFillIsReplacedByOneThatTheyDo()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        auto* offer = child<QPushButton>(u"export.offer"_q);
        QVERIFY(!offer->isVisible());
        for (const int frames : {1, 2, 3, 10, 48, 60, 63}) {
            child<QSpinBox>(u"export.columns"_q)->setValue(8);
            child<QSpinBox>(u"export.rows"_q)->setValue(8);
            child<QSpinBox>(u"export.last"_q)->setValue(frames - 1);
            QVERIFY(offer->isVisible() && !child<QPushButton>(u"export.begin"_q)->isEnabled());
            offer->click();
            QVERIFY(!offer->isVisible() && child<QPushButton>(u"export.begin"_q)->isEnabled());
            const ExportPlan plan = m_dialog->plan();
            QVERIFY(plan.flipbook.columns * plan.flipbook.rows <= frames
                && plan.flipbook.columns * plan.flipbook.rows > frames - 8);
        }
        QCOMPARE((gridWithin(60, 8, 8)), (std::array{7, 8}));
        QCOMPARE((gridWithin(60, 8, 8, true)), (std::array{4, 8}));
        QCOMPARE((gridWithin(1000, 16, 4)), (std::array{16, 4}));
    }

    void framesThatCloseTheLoopAreOffered()
    {
        m_document->edit(
            {{&knownParameter("timeline.loop"), true}, {&knownParameter("timeline.length"), 90}}, u"loop"_q);
        m_dialog->setKind(ExportKind::Flipbook);
        child<QSpinBox>(u"export.last"_q)->setValue(63);
        auto* offer = child<QPushButton>(u"export.offer"_q);
        QVERIFY(offer->isVisible());
        QVERIFY2(child<QLabel>(u"export.files"_q)->text().contains(u"played once"_q),
            qPrintable(child<QLabel>(u"export.files"_q)->text()));
        QVERIFY(child<QPushButton>(u"export.begin"_q)->isEnabled());
        offer->click();
        QCOMPARE(child<QSpinBox>(u"export.last"_q)->value(), 89);
        QVERIFY(!offer->isVisible());
    }

    void cellsAreCalledCells()
    {
        const auto* label = child<QLabel>(u"output.width.label"_q);
        m_dialog->setKind(ExportKind::Flipbook);
        QVERIFY(label->text().contains(u"Cell width"_q));
        m_dialog->setKind(ExportKind::Sequence);
        QVERIFY(!label->text().contains(u"Cell"_q));
    }

private:
    /// A flipbook of smoke that is simulated at once, with the button that looks for its sheet, for 0.1 MB.
    QPushButton* findableSheet()
    {
        Effect effect = smallSmoke();
        effect.output.width = 192;
        effect.output.height = 128;
        m_document->replaceEffect(effect, u"small"_q);
        m_dialog->setKind(ExportKind::Flipbook);
        child<QToolButton>(u"export.more"_q)->click();
        child<QSpinBox>(u"export.last"_q)->setValue(63);
        child<QDoubleSpinBox>(u"export.budget"_q)->setValue(0.1);
        return child<QPushButton>(u"export.findSheet"_q);
    }
};

FUMAGE_TEST_MAIN(ExportSheetsTest)
#include "export_sheets_test.moc"
