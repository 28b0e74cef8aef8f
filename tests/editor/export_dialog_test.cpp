#include "editor_helpers.h"
#include "tests/export/small_smoke.h"

#include "ui/document/key_edits.h"
#include "ui/document/marker_edits.h"
#include "ui/export/export_dialog.h"
#include "ui/export/preview_canvas.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/number_field.h"
#include "ui/panels/parameter_row.h"

#include "core/effect/known_parameter.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/jobs/job_file.h"
#include "core/export/engines/engine_remarks.h"
#include "core/export/sheets/packing.h"
#include "core/export/sheets/sheet_playback.h"
#include "core/preset/preset_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QToolButton>
#include <QUndoStack>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEndMs = 60000; ///< what is done by then on a busy machine

}

class ExportDialogTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_answer = 0;
        m_document = std::make_unique<Document>();
        m_player = std::make_unique<Player>();
        m_player->setTimeline(100, 30);
        m_locks = std::make_unique<Locks>();
        m_queue = std::make_unique<ExportQueue>(QDir(m_folder.filePath(u"queue"_q)));
        m_dialog = std::make_unique<ExportDialog>(
            *m_document, *m_player, *m_locks, *m_queue, askInDialog,
            [this](QWidget*, const ChoiceQuestion&) { return m_answer; }, nullptr);
        m_dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get()));
    }
    void cleanup()
    {
        m_dialog.reset();
        m_queue.reset();
    }

    void whileLayersAreSoloItSaysThatAllAreExported()
    {
        Scene scene = m_document->scene();
        scene.layers.resize(3);
        scene.layers[2].visible = false;
        m_document->replaceScene(scene, 0, u"layers"_q);
        Solo solo(*m_document);
        m_dialog->setSolo(solo);
        const auto* remark = child<QLabel>(u"export.solo"_q);
        QVERIFY(!remark->isVisible());
        solo.set({1}, true);
        QVERIFY(remark->isVisible());
        QVERIFY2(remark->text().contains(u"exported: 2"_q), qPrintable(remark->text()));
        solo.end();
        QVERIFY(!remark->isVisible());
        m_dialog.reset(); // before the solo, which it hears
    }

    void nothingIsCutOffAtItsSide()
    {
        const auto* scroll = child<QScrollArea>(u"export.scroll"_q);
        const int needed = scroll->widget()->minimumSizeHint().width();
        QVERIFY2(scroll->viewport()->width() >= needed,
            qPrintable(QStringLiteral("%1 of %2 pixels").arg(scroll->viewport()->width()).arg(needed)));
    }

    void aHiddenDialogDoesNotFollowTheDocument()
    {
        m_dialog->setKind(ExportKind::Flipbook);
        setWidth(100);
        const auto* files = child<QLabel>(u"export.files"_q);
        const auto* field = child<NumberField>(u"output.width.field"_q);
        QVERIFY(files->text().contains(u"800"_q));
        m_dialog->hide();
        const QStringList before{files->text(), field->text()};
        setWidth(50);
        QCOMPARE((QStringList{files->text(), field->text()}), before);
        m_dialog->show();
        QVERIFY(files->text().contains(u"400"_q));
        QCOMPARE(field->text(), u"50"_q + before[1].mid(3));
    }

    /// The file that is offered tells when the plan is looked at again.
    void playingKeyFramesDoesNotPlanAnew()
    {
        addKey(*m_document, knownParameter("glow.emission"));
        auto* path = child<QLineEdit>(u"export.path"_q);
        const QString offered = path->text();
        const auto isPlannedBy = [&](const auto& change) {
            const QSignalBlocker blocker(path); // which looks at the plan, too
            path->setText(u"untouched"_q);
            const QSignalSpy changes(m_document.get(), &Document::effectChanged);
            change();
            return !changes.isEmpty() && path->text() == offered;
        };
        QVERIFY(!isPlannedBy([&] { m_document->setSeconds(1.0); }));
        QCOMPARE(m_document->seconds(), 1.0);
        QVERIFY(isPlannedBy([&] { addMarkerHere(*m_document); }));
        QVERIFY(!isPlannedBy([&] { m_document->setSeconds(2.0); }));
        QVERIFY(isPlannedBy([&] { m_document->edit(knownParameter("motion.gravity"), 7.0F); }));
        // A colour with key frames is shown here, as it is at the time that is shown.
        addKey(*m_document, knownParameter("output.background_colour"));
        QVERIFY(isPlannedBy([&] { m_document->setSeconds(3.0); }));
    }

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

    void framesAndFlipbooksHaveAManifestWhereThatIsAskedFor()
    {
        const auto* manifest = child<QCheckBox>(u"export.manifest"_q);
        const auto nameFor = [this](ExportKind kind) {
            m_dialog->setKind(kind);
            return manifestOf(m_dialog->plan()).filename().string();
        };
        QVERIFY(!manifest->isChecked());
        QVERIFY(nameFor(ExportKind::Sequence).empty());
        child<QCheckBox>(u"export.manifest"_q)->click();
        child<QSpinBox>(u"export.first"_q)->setValue(3);
        child<QSpinBox>(u"export.last"_q)->setValue(90);
        QCOMPARE(nameFor(ExportKind::Sequence), std::string("untitled.3-90.manifest.json"));
        QVERIFY(manifest->isVisible());
        QCOMPARE(nameFor(ExportKind::Flipbook), std::string("untitled_8x8.manifest.json"));
        QVERIFY(manifest->isVisible());
        for (const ExportKind kind : {ExportKind::Video, ExportKind::NoiseTexture, ExportKind::Particles,
                 ExportKind::Volumes, ExportKind::Air}) {
            QVERIFY(nameFor(kind).empty());
            QVERIFY(!manifest->isVisible());
        }
        // It is remembered, as all that was chosen.
        m_dialog->close();
        m_dialog->show();
        QVERIFY(!nameFor(ExportKind::Flipbook).empty());
        QVERIFY(manifest->isChecked());
    }

    void aManifestIsNumberedOnWithItsFiles()
    {
        m_dialog->setKind(ExportKind::Sequence);
        child<QCheckBox>(u"export.manifest"_q)->click();
        const ExportPlan next = numberedOn({{}, {}, m_dialog->plan()});
        QCOMPARE(next.recording.manifest.filename().string(), std::string("untitled-2.manifest.json"));
        child<QCheckBox>(u"export.manifest"_q)->click();
        QVERIFY(manifestOf(numberedOn({{}, {}, m_dialog->plan()})).empty());
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
        nothingIsCutOffAtItsSide();
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

    void theFileIsSuggestedUntilOneIsTyped()
    {
        auto* path = child<QLineEdit>(u"export.path"_q);
        QVERIFY(path->text().endsWith(u"_####.png"_q));
        m_dialog->setKind(ExportKind::Flipbook);
        QVERIFY(path->text().endsWith(u"_8x8.png"_q));
        child<QSpinBox>(u"export.columns"_q)->setValue(4);
        QVERIFY(path->text().endsWith(u"_4x8.png"_q));
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(2);
        QVERIFY(path->text().endsWith(u"_4x8.exr"_q));
        typePath(u"mine"_q);
        child<QSpinBox>(u"export.columns"_q)->setValue(2);
        QCOMPARE(path->text(), u"mine"_q);
        m_dialog->setKind(ExportKind::Particles);
        QVERIFY(path->text().endsWith(u"_####.csv"_q));
    }

    void thePlanIsWhatTheFieldsSay()
    {
        m_dialog->setKind(ExportKind::Particles);
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(1);
        child<QSpinBox>(u"export.first"_q)->setValue(12);
        typePath(u"/tmp/a.b"_q);
        const ExportPlan plan = m_dialog->plan();
        QCOMPARE(plan.kind, ExportKind::Particles);
        QCOMPARE(plan.particles, ParticleFormat::Ply);
        QCOMPARE(plan.frames.first, 12);
        QCOMPARE(plan.output.string(), std::string("/tmp/a.b.ply"));
        QVERIFY(child<QLabel>(u"export.files"_q)->text().contains(u"a.b_0099.ply"_q));
        child<QSpinBox>(u"export.last"_q)->setValue(12);
        QCOMPARE(child<QLabel>(u"export.files"_q)->text(), u"a.b.ply"_q);
    }

    void volumesHaveCellsAndAnAxisThatPointsUp()
    {
        m_dialog->setKind(ExportKind::Volumes);
        auto* cells = child<QSpinBox>(u"export.cells"_q);
        auto* up = child<QComboBox>(u"export.up"_q);
        QVERIFY(cells->isVisible() && up->isVisible() && !child<QSpinBox>(u"export.noiseSize"_q)->isVisible());
        QVERIFY(m_dialog->plan().volume.cells == VolumeSequenceOptions().longest && !m_dialog->plan().up);
        cells->setValue(64);
        up->setCurrentIndex(2);
        auto* density = child<QComboBox>(u"export.density"_q);
        QVERIFY(density->isVisible() && m_dialog->plan().volume.density == DensityGrids::Together);
        density->setCurrentIndex(1);
        typePath(u"v_##"_q);
        const ExportPlan plan = m_dialog->plan();
        QVERIFY(plan.volume.density == DensityGrids::Layers);
        QVERIFY(plan.kind == ExportKind::Volumes && plan.volume.cells == 64 && plan.up == UpAxis::Z);
        QCOMPARE(plan.output.string(), std::string("v_##.vdb"));
        QVERIFY(child<QLabel>(u"export.files"_q)->text().contains(u"v_99.vdb"_q));
        m_dialog->setKind(ExportKind::Particles);
        QVERIFY(up->isVisible() && !cells->isVisible());
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(2); // Unity's has axes of its own
        QVERIFY(!up->isVisible());
    }

    void airIsExportedOnlyWhereItCarriesTheSmoke()
    {
        m_document->edit(knownParameter("air.enabled"), false);
        m_dialog->setKind(ExportKind::Air);
        const auto* begin = child<QPushButton>(u"export.begin"_q);
        QVERIFY(!begin->isEnabled());
        QVERIFY(child<QLabel>(u"export.files"_q)->text().contains(u"No air"_q));
        m_document->edit(knownParameter("air.enabled"), true);
        QVERIFY(begin->isEnabled());
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(1);
        QCOMPARE(m_dialog->plan().air, AirFormat::Vf);
        typePath(u"a.fga"_q);
        QCOMPARE(m_dialog->plan().air, AirFormat::Fga);
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

    void aVideoIsWhatItsNameSays()
    {
        m_dialog->setKind(ExportKind::Video);
        auto* format = child<QComboBox>(u"export.format"_q);
        auto* path = child<QLineEdit>(u"export.path"_q);
        QVERIFY(path->text().endsWith(u".mp4"_q));
        const auto hasColourBehind = [&] {
            const auto rows = m_dialog->findChildren<ParameterRow*>();
            return std::ranges::any_of(rows, [](const ParameterRow* row) {
                return row->parameter().key == "output.background_colour" && !row->isHidden();
            });
        };
        QVERIFY(hasColourBehind()); // an MP4 has no transparency, whatever the background is
        format->setCurrentIndex(1);
        QVERIFY(path->text().endsWith(u".webm"_q));
        QVERIFY(!hasColourBehind());
        typePath(u"/tmp/smoke.GIF"_q);
        QCOMPARE(m_dialog->plan().video.format, VideoFormat::Gif);
        QCOMPARE(m_dialog->plan().output.string(), std::string("/tmp/smoke.GIF"));
        QVERIFY(child<QSpinBox>(u"export.last"_q)->isEnabled());
        QVERIFY(child<QCheckBox>(u"export.carries"_q)->isHidden());
    }

    void theFileOfTheDocumentIsNotOverwritten()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"mine.csv"_q);
        QVERIFY(m_document->save(file).ok());
        m_dialog->setKind(ExportKind::Particles);
        typePath(file);
        child<QSpinBox>(u"export.last"_q)->setValue(0);
        m_answer = 1; // Overwrite
        QTest::mouseClick(child<QPushButton>(u"export.begin"_q), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->rowCount(), 1, kEndMs);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->at(0).state, ExportState::Failed, kEndMs);
        QVERIFY(readPresetFile(file.toStdString()).ok());
    }

    void theSeamlessLoopIsASwitchOfTheDialog()
    {
        QTest::mouseClick(child<QCheckBox>(u"timeline.loop.box"_q), Qt::LeftButton, {}, {8, 8});
        QVERIFY(m_document->effect().timeline.loop);
        m_dialog->setKind(ExportKind::NoiseTexture);
        QVERIFY(!child<QCheckBox>(u"timeline.loop.box"_q)->isVisible());
    }

    void anEndingThatIsTypedNamesTheFormat()
    {
        typePath(u"f_####.exr"_q);
        QCOMPARE(m_dialog->plan().format, ImageFormat::ExrHalf);
        QCOMPARE(m_dialog->plan().output.string(), std::string("f_####.exr"));
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(3); // floats
        typePath(u"g_####.exr"_q);
        QCOMPARE(m_dialog->plan().format, ImageFormat::ExrFloat);
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(1);
        QCOMPARE(child<QLineEdit>(u"export.path"_q)->text(), u"g_####.png"_q);
        QVERIFY(child<QCheckBox>(u"export.carries"_q)->isVisible());
        typePath(u"h.tga"_q);
        QCOMPARE(m_dialog->plan().format, ImageFormat::Tga);
        QVERIFY(!child<QCheckBox>(u"export.carries"_q)->isVisible()); // there is no room for a preset in it
        m_dialog->setKind(ExportKind::Particles);
        typePath(u"p.ply"_q);
        QCOMPARE(m_dialog->plan().particles, ParticleFormat::Ply);
    }

    void theFormatOfPicturesIsKeptFromKindToKind()
    {
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(3);
        for (const ExportKind kind : {ExportKind::Flipbook, ExportKind::Video, ExportKind::Particles,
                 ExportKind::NoiseTexture, ExportKind::Picture}) {
            m_dialog->setKind(kind);
        }
        QCOMPARE(m_dialog->plan().format, ImageFormat::ExrFloat);
    }

    void theNoiseTextureHasASizeOfItsOwn()
    {
        auto* size = child<QSpinBox>(u"export.noiseSize"_q);
        QVERIFY(!size->isVisible());
        m_dialog->setKind(ExportKind::NoiseTexture);
        QVERIFY(size->isVisible());
        QCOMPARE(m_dialog->plan().noise.size, 0); // the effect's
        size->setValue(512);
        QCOMPARE(m_dialog->plan().noise.size, 512);
    }

    void returnBeginsAnExportOrDoesNothing()
    {
        typePath(u"  "_q); // nothing can be begun
        QTest::keyClick(child<QLineEdit>(u"export.path"_q), Qt::Key_Return);
        QCOMPARE(m_queue->rowCount(), 0);
        for (const QPushButton* button : m_dialog->findChildren<QPushButton*>()) {
            QCOMPARE(button->autoDefault(), button->objectName() == u"export.begin"_q);
        }
    }

    void theMessageOfTheExportBeforeIsForgotten()
    {
        typePath(u"/proc/nowhere/smoke.png"_q);
        QTest::mouseClick(child<QPushButton>(u"export.begin"_q), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->rowCount(), 1, kEndMs);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->at(0).state, ExportState::Failed, kEndMs);
        QVERIFY(child<QLabel>(u"export.state"_q)->isVisible());
        m_dialog->hide();
        m_dialog->show();
        QVERIFY(child<QLabel>(u"export.state"_q)->text().isEmpty());
    }

    void aSmallScreenHoldsTheDialogAndItsButtons()
    {
        // What is above the buttons gives way and can be scrolled.
        m_dialog->setMaximumHeight(320);
        QTRY_COMPARE(m_dialog->height(), 320);
        for (const char* name : {"export.begin", "export.close"}) {
            const auto* button = child<QPushButton>(QLatin1String(name));
            QVERIFY2(button->mapTo(m_dialog.get(), button->rect().bottomRight()).y() < 320, name);
        }
        const auto* scroll = child<QScrollArea>(u"export.scroll"_q);
        QVERIFY(scroll->verticalScrollBar()->maximum() > 0);
    }

    void theDialogIsAsHighAsItsContents()
    {
        QCOMPARE(child<QScrollArea>(u"export.scroll"_q)->verticalScrollBar()->maximum(), 0);
    }

    void aSinglePictureIsTheFrameOnTheScreen()
    {
        m_player->setFrame(56);
        m_dialog->setKind(ExportKind::Picture);
        auto* frame = child<QSpinBox>(u"export.frame"_q);
        const auto* shown = child<QLabel>(u"export.frame.shown"_q);
        QVERIFY(frame->isVisible() && !child<QSpinBox>(u"export.last"_q)->isVisible());
        QCOMPARE(m_dialog->plan().frames.first, 56);
        QVERIFY(shown->text().contains(u"on the screen"_q));
        m_player->setFrame(57);
        QCOMPARE(m_dialog->plan().frames.first, 57);
        frame->setValue(12);
        QCOMPARE(m_dialog->plan().frames.first, 12);
        QVERIFY2(shown->text().contains(u"57"_q), qPrintable(shown->text()));
        m_dialog->close();
        m_player->setFrame(58);
        m_dialog->show();
        QCOMPARE(m_dialog->plan().frames.first, 58);
        m_dialog->setKind(ExportKind::Sequence);
        QCOMPARE(m_dialog->plan().frames.last, 99);
    }

    void whatWasChosenIsThereInTheNextProgram()
    {
        // A choice of each kind of field.
        m_dialog->setKind(ExportKind::Video);
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(3);
        child<QComboBox>(u"export.rate"_q)->setCurrentIndex(1);
        child<QComboBox>(u"export.repeat"_q)->setCurrentIndex(2);
        m_dialog->setKind(ExportKind::Volumes);
        child<QSpinBox>(u"export.cells"_q)->setValue(77);
        child<QDoubleSpinBox>(u"export.voxel"_q)->setValue(0.02);
        child<QComboBox>(u"export.up"_q)->setCurrentIndex(1);
        m_dialog->setKind(ExportKind::NoiseTexture);
        child<QSpinBox>(u"export.noiseSize"_q)->setValue(96);
        m_dialog->setKind(ExportKind::Particles);
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(2);
        m_dialog->setKind(ExportKind::Air);
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(1);
        m_dialog->setKind(ExportKind::Flipbook);
        child<QComboBox>(u"export.format"_q)->setCurrentIndex(1);
        child<QComboBox>(u"export.engine"_q)->setCurrentText(u"Unity"_q);
        child<QCheckBox>(u"export.sixWay"_q)->click();
        child<QSpinBox>(u"export.columns"_q)->setValue(4);
        child<QSpinBox>(u"export.rows"_q)->setValue(5);
        for (const char* box :
            {"export.trim", "export.powerOfTwo", "export.retimes", "export.fit", "export.carries", "export.manifest"}) {
            child<QCheckBox>(QLatin1String(box))->click();
        }
        child<QDoubleSpinBox>(u"export.outliers"_q)->setValue(0.75);
        child<QPushButton>(u"export.addPack"_q)->click();
        child<QComboBox>(u"export.pack1.size"_q)->setCurrentIndex(2);
        child<QComboBox>(u"export.pack1.channel3"_q)->setCurrentText(u"motion.r"_q);
        const QStringList before = remembered(*m_dialog);
        ExportDialog again(
            *m_document, *m_player, *m_locks, *m_queue, askInDialog, [](QWidget*, const ChoiceQuestion&) { return 0; },
            nullptr);
        QVERIFY(remembered(again) != before);
        std::vector<ExportPlan> plans;
        for (const QString& text : before) {
            plans.push_back(parsePlan(text.toStdString()).value());
        }
        again.take(plans);
        QCOMPARE(remembered(again), before);
        QCOMPARE(again.plan().flipbook.engine, Engine::Unity);
        QVERIFY(!again.plan().passes.has(Pass::SixWayA) && again.plan().passes.has(Pass::Motion));
    }

    void aTextThatIsNoneOfItsChoicesIsLeftAlone()
    {
        for (const char* text :
            {"", "[]", "nonsense", "{\"kind\": 3}", "{\"kind\": \"flipbook\", \"columns\": -5, \"later\": [1]}"}) {
            if (const std::optional<ExportPlan> plan = parsePlan(text)) {
                m_dialog->take(std::array{*plan});
                QCOMPARE(m_dialog->plan().flipbook.columns, ExportPlan().flipbook.columns);
            }
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

    void theButtonsStayWhereTheyAreFromKindToKind()
    {
        const auto placeOf = [this](const QString& name) {
            const auto* button = child<QPushButton>(name);
            return button->mapToGlobal(QPoint());
        };
        QTest::qWait(0);
        const QPoint begin = placeOf(u"export.begin"_q);
        const QPoint close = placeOf(u"export.close"_q);
        const QSize size = m_dialog->size();
        for (std::size_t kind = 0; kind < kExportKinds; ++kind) {
            m_dialog->setKind(static_cast<ExportKind>(kind));
            QCoreApplication::processEvents();
            QCOMPARE(m_dialog->size(), size);
            QCOMPARE(placeOf(u"export.begin"_q), begin);
            QCOMPARE(placeOf(u"export.close"_q), close);
            QCOMPARE(child<QScrollArea>(u"export.scroll"_q)->verticalScrollBar()->maximum(), 0);
        }
    }

    void onlyWhatHasTransparencyAsksForATransparentBackground()
    {
        m_dialog->setKind(ExportKind::Video);
        const auto isShown = [this](const QString& name) { return child<QWidget>(name + u".row"_q)->isVisible(); };
        for (const VideoFormat format : kAllVideoFormats) {
            child<QComboBox>(u"export.format"_q)->setCurrentIndex(static_cast<int>(format));
            QCOMPARE(isShown(u"output.background"_q), hasAlpha(format));
            QCOMPARE(isShown(u"output.background_colour"_q), !hasAlpha(format));
            QCOMPARE(child<QComboBox>(u"export.repeat"_q)->isVisible(), saysHowOften(format));
        }
        for (const ExportKind kind : {ExportKind::Sequence, ExportKind::Flipbook, ExportKind::Picture}) {
            m_dialog->setKind(kind);
            QVERIFY(isShown(u"output.background"_q));
        }
    }

    void whatBecameOfAnExportIsForgottenWithItsKind()
    {
        typePath(u"/proc/nowhere/smoke.png"_q);
        QTest::mouseClick(child<QPushButton>(u"export.begin"_q), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->rowCount(), 1, kEndMs);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->at(0).state, ExportState::Failed, kEndMs);
        QVERIFY(!child<QLabel>(u"export.state"_q)->text().isEmpty());
        m_dialog->setKind(ExportKind::Picture);
        QVERIFY(child<QLabel>(u"export.state"_q)->text().isEmpty());
    }

    void anExportThatIsTakenOutOfTheQueueIsForgotten()
    {
        m_document->replaceEffect(smallSmoke(), u"small"_q);
        m_dialog->setKind(ExportKind::NoiseTexture);
        typePath(m_folder.filePath(u"taken.png"_q));
        QTest::mouseClick(child<QPushButton>(u"export.begin"_q), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->rowCount(), 1, kEndMs);
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->at(0).state, ExportState::Done, kEndMs);
        QVERIFY(child<QPushButton>(u"export.show"_q)->isVisible());
        m_queue->removeEnded(); // as the panel of the queue does, while the dialog is open
        QVERIFY(!child<QPushButton>(u"export.show"_q)->isVisible()); // nothing is left that it could show
        QVERIFY(!child<QPushButton>(u"export.cancel"_q)->isVisible());
        QVERIFY(child<QLabel>(u"export.state"_q)->text().isEmpty());
    }

    void cellsAreCalledCells()
    {
        const auto* label = child<QLabel>(u"output.width.label"_q);
        m_dialog->setKind(ExportKind::Flipbook);
        QVERIFY(label->text().contains(u"Cell width"_q));
        m_dialog->setKind(ExportKind::Sequence);
        QVERIFY(!label->text().contains(u"Cell"_q));
    }

    void whatCannotBeWrittenCannotBeBegun()
    {
        const auto* begin = child<QPushButton>(u"export.begin"_q);
        QVERIFY(begin->isEnabled());
        typePath(u"  "_q);
        QVERIFY(!begin->isEnabled());
        typePath(u"a"_q);
        QVERIFY(begin->isEnabled());
        child<QSpinBox>(u"export.first"_q)->setValue(50);
        child<QSpinBox>(u"export.last"_q)->setValue(49);
        QVERIFY(!begin->isEnabled());
    }

private:
    /// What a program remembers of a dialog.
    static QStringList remembered(const ExportDialog& dialog)
    {
        QStringList texts;
        for (ExportPlan plan : dialog.choices()) {
            plan.frames = {};
            texts << QString::fromStdString(formatPlan(plan));
        }
        return texts;
    }

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

    void setWidth(int pixels) { m_document->edit(knownParameter("output.width"), pixels); }

    void typePath(const QString& text)
    {
        auto* path = child<QLineEdit>(u"export.path"_q);
        path->selectAll();
        QTest::keyClicks(path, text);
    }

    template <class Widget>
    Widget* child(const QString& name)
    {
        auto* widget = m_dialog->findChild<Widget*>(name);
        Q_ASSERT(widget != nullptr);
        return widget;
    }

    int m_answer = 0; ///< to what is asked
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Player> m_player;
    std::unique_ptr<Locks> m_locks;
    QTemporaryDir m_folder;
    std::unique_ptr<ExportQueue> m_queue;
    std::unique_ptr<ExportDialog> m_dialog;
};

FUMAGE_TEST_MAIN(ExportDialogTest)
#include "export_dialog_test.moc"
