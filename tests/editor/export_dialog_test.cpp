// The export dialog itself.
#include "export_dialog_fixture.h"

#include "ui/document/key_edits.h"
#include "ui/document/marker_edits.h"
#include "ui/panels/number_field.h"

#include "core/export/engines/engine_remarks.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>

using namespace fumage;
using namespace fumage::tests;

class ExportDialogTest : public ExportDialogFixture {
    Q_OBJECT

private slots:
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

    void nothingIsCutOffAtItsSide() { QVERIFY(fitsItsWidth()); }

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

    void theSeamlessLoopIsASwitchOfTheDialog()
    {
        QTest::mouseClick(child<QCheckBox>(u"timeline.loop.box"_q), Qt::LeftButton, {}, {8, 8});
        QVERIFY(m_document->effect().timeline.loop);
        m_dialog->setKind(ExportKind::NoiseTexture);
        QVERIFY(!child<QCheckBox>(u"timeline.loop.box"_q)->isVisible());
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
};

FUMAGE_TEST_MAIN(ExportDialogTest)
#include "export_dialog_test.moc"
