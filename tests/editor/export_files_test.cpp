// Names and formats of what is exported, and what the export dialog remembers.
#include "export_dialog_fixture.h"
#include "tests/export/small_smoke.h"

#include "ui/panels/parameter_row.h"

#include "core/export/jobs/job_file.h"
#include "core/export/sheets/packing.h"
#include "core/preset/preset_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <map>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEndMs = 60000; ///< what is done by then on a busy machine

}

class ExportFilesTest : public ExportDialogFixture {
    Q_OBJECT

private slots:
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

    void numbersAreShownWithTheDigitsThatTheyHave()
    {
        auto& outliers = *child<QDoubleSpinBox>(u"export.outliers"_q);
        for (const auto& [percent, text] :
            std::map<double, QString>{{0.0, u"0 %"_q}, {0.75, u"0.75 %"_q}, {5.0, u"5 %"_q}}) {
            outliers.setValue(percent);
            QCOMPARE(outliers.text(), text);
        }
        auto& voxel = *child<QDoubleSpinBox>(u"export.voxel"_q);
        voxel.setValue(0.02);
        QCOMPARE(voxel.text(), u"0.02 m"_q);
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
};

FUMAGE_TEST_MAIN(ExportFilesTest)
#include "export_files_test.moc"
