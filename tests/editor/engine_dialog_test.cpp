// The short way into an engine.
#include "editor_helpers.h"
#include "tests/export/small_smoke.h"

#include "ui/export/engine_dialog.h"
#include "ui/export/mock_stage.h"

#include "core/export/loop.h"

#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QUndoStack>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEndMs = 60000; ///< what is done by then on a busy machine

/// Eight frames of a little smoke in small pictures.
Preset littleSmoke()
{
    Preset preset;
    preset.name = "Little smoke";
    preset.scene = smallSmoke();
    preset.scene.timeline.length = 8;
    preset.scene.output.width = 32;
    preset.scene.output.height = 32;
    return preset;
}

} // namespace

class EngineDialogTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_home = std::make_unique<QTemporaryDir>();
        m_answer = 0;
        m_chosenFolder.clear();
        m_document = std::make_unique<Document>();
        m_document->load(littleSmoke(), {});
        m_queue = std::make_unique<ExportQueue>(QDir(m_home->filePath(u"queue"_q)));
        m_dialog = std::make_unique<EngineDialog>(
            *m_document, *m_queue, [this](QWidget*, const FileQuestion&) { return m_chosenFolder; },
            [this](QWidget*, const ChoiceQuestion&) { return m_answer; }, nullptr);
        m_dialog->take({Engine::Unity, kUsualSheetEdge, m_home->filePath(u"out"_q)});
        m_dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get()));
    }
    void cleanup()
    {
        m_dialog.reset();
        m_queue.reset();
        m_document.reset();
    }

    void oneClickEndsWithTheSheetPlaying_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("file");
        QTest::newRow("Unity") << u"unity"_q << u"Editor/little-smoke_2x4.cs"_q;
        QTest::newRow("Unreal") << u"unreal"_q << u"little-smoke_2x2_unreal.py"_q;
        QTest::newRow("Godot") << u"godot"_q << u"little-smoke_2x4.tscn"_q;
        QTest::newRow("web") << u"web"_q << u"little-smoke_2x4.html"_q;
        QTest::newRow("Effekseer") << u"effekseer"_q << u"little-smoke_2x4.efkproj"_q;
    }
    void oneClickEndsWithTheSheetPlaying()
    {
        QFETCH(QString, name);
        QFETCH(QString, file);
        QSignalSpy added(m_dialog.get(), &EngineDialog::added);
        QSignalSpy chosen(m_dialog.get(), &EngineDialog::chosen);
        QVERIFY(!m_dialog->stage().isPlaying());
        press(u"engine."_q + name);
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->stage().isPlaying(), kEndMs);
        QVERIFY(!m_dialog->stage().shown().isNull());
        QCOMPARE(m_dialog->stage().shown().width(), m_dialog->stage().shown().height());
        QVERIFY2(QFile::exists(QDir(m_home->filePath(u"out"_q)).filePath(file)), qPrintable(file));
        QCOMPARE(added.size(), 1);
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(toQString(nameOf(m_dialog->choice().engine)), name);
        QCOMPARE(stepsShown(), 3);
        press(u"engine.copy"_q);
        QVERIFY(QFile::exists(QGuiApplication::clipboard()->text()));
        QVERIFY(part<QPushButton>(u"engine.show"_q).isEnabled());
        m_queue->removeEnded(); // the files are there still
        QVERIFY(part<QPushButton>(u"engine.show"_q).isEnabled() && m_dialog->stage().isPlaying());
        m_dialog->hide();
        QVERIFY(!m_dialog->stage().isPlaying());
    }

    void thePlanIsWhatTheEngineIsBestGiven()
    {
        for (const Engine engine : kOfferedEngines) {
            const ExportPlan plan = recommendedPlan(engine, *m_document, u"/somewhere"_q);
            QCOMPARE(plan.kind, ExportKind::Flipbook);
            QCOMPARE(plan.flipbook.engine, engine);
            QVERIFY(plan.passes == passesFor(engine));
            QCOMPARE(plan.style.vectors, styleFor(engine, plan.format).vectors);
            QVERIFY(plan.fitCamera);
            QVERIFY(plan.flipbook.columns * plan.flipbook.rows <= plan.frames.count());
            QVERIFY(engine != Engine::Unreal || plan.flipbook.columns == plan.flipbook.rows);
            QCOMPARE(engineSteps(plan).size(), 3);
            QVERIFY(!engineTitle(engine).isEmpty());
        }
    }

    void aLoopIsClosed()
    {
        Preset preset = littleSmoke();
        preset.scene.timeline.loop = true;
        preset.scene.timeline.length = 150;
        m_document->load(preset, {});
        const ExportPlan plan = recommendedPlan(Engine::Unity, *m_document, u"/somewhere"_q);
        QVERIFY(turnOf(preset.scene.timeline, plan.frames).has_value());
        QVERIFY(plan.frames.count() >= plan.flipbook.columns * plan.flipbook.rows);
    }

    void largeCellsBecomeSmallerAsOneStepThatCanBeUndone()
    {
        Preset preset = littleSmoke();
        preset.scene.output.width = 2048;
        preset.scene.output.height = 1024;
        m_document->load(preset, {});
        m_dialog->take({Engine::Unity, 1024, m_home->filePath(u"out"_q)});
        QSignalSpy wanted(m_dialog.get(), &EngineDialog::optionsRequested);
        press(u"engine.options"_q);
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(m_document->scene().output.width, 512); // two of them beside each other, four below
        QCOMPARE(m_document->scene().output.height, 256);
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QCOMPARE(m_document->scene().output.width, 2048);
    }

    void cellsThatFitStayAsTheyAre()
    {
        QSignalSpy wanted(m_dialog.get(), &EngineDialog::optionsRequested);
        press(u"engine.options"_q);
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void anotherEngineIsOneClickBack()
    {
        press(u"engine.web"_q);
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->stage().isPlaying(), kEndMs);
        press(u"engine.back"_q);
        QCOMPARE(pages().currentIndex(), 0);
        QVERIFY(!m_dialog->stage().isPlaying());
        QVERIFY(part<QPushButton>(u"engine.web"_q).isDefault());
        press(u"engine.effekseer"_q); // its picture has the same name: it is saved beside the first
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->stage().isPlaying(), kEndMs);
        QVERIFY(QFile::exists(m_home->filePath(u"out/little-smoke_2x4-2.efkproj"_q)));
    }

    void aFileThatIsNotToBeOverwrittenLeavesTheChoice()
    {
        press(u"engine.web"_q);
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->stage().isPlaying(), kEndMs);
        press(u"engine.back"_q);
        m_answer = 2; // cancel
        QSignalSpy ended(m_dialog.get(), &EngineDialog::entryEnded);
        press(u"engine.web"_q);
        QTRY_COMPARE(ended.size(), 1);
        QCOMPARE(pages().currentIndex(), 0);
        QVERIFY(part<QPushButton>(u"engine.web"_q).isEnabled());
        QCOMPARE(m_queue->rowCount(), 1);
    }

    void aFolderThatCannotBeWrittenIsSaid()
    {
        part<QLineEdit>(u"engine.folder"_q).setText(u"/proc/nowhere"_q);
        press(u"engine.web"_q);
        QTRY_VERIFY_WITH_TIMEOUT(m_queue->rowCount() == 1 && m_queue->at(0).state == ExportState::Failed, kEndMs);
        QVERIFY(part<QLabel>(u"export.state"_q).text().contains(u"/proc"_q));
        QVERIFY(!m_dialog->stage().isPlaying());
        QVERIFY(!part<QPushButton>(u"engine.show"_q).isEnabled());
    }

    void theFolderIsChosenInADialog()
    {
        press(u"engine.choose"_q);
        QCOMPARE(m_dialog->choice().folder, m_home->filePath(u"out"_q)); // none was chosen
        m_chosenFolder = m_home->filePath(u"other"_q);
        press(u"engine.choose"_q);
        QCOMPARE(m_dialog->choice().folder, m_chosenFolder);
        part<QLineEdit>(u"engine.folder"_q).setText(u"not absolute"_q);
        QCOMPARE(m_dialog->choice().folder, usualEngineFolder());
    }

    void whatIsRememberedIsTakenAsFarAsItIsKnown()
    {
        const EngineChoice choice{Engine::Godot, 4096, u"/home/me/smoke"_q};
        const EngineChoice again = engineChoiceOf(textsOf(choice));
        QCOMPARE(again.engine, choice.engine);
        QCOMPARE(again.edge, choice.edge);
        QCOMPARE(again.folder, choice.folder);
        for (const QStringList& broken : {QStringList{}, QStringList{u"source"_q, u"99999999999"_q, u"rel"_q},
                 QStringList{u"pixi"_q, u"-1"_q, QString()}}) {
            const EngineChoice usual = engineChoiceOf(broken);
            QCOMPARE(usual.engine, Engine::Unity);
            QCOMPARE(usual.edge, kUsualSheetEdge);
            QVERIFY(usual.folder.isEmpty());
        }
    }

    void anExportThatIsCancelledShowsNoSheet()
    {
        Preset preset = littleSmoke();
        preset.scene.layers[0].emitter.count = 200000;
        preset.scene.timeline.length = 4000;
        m_document->load(preset, {});
        press(u"engine.effekseer"_q);
        auto& cancel = part<QPushButton>(u"engine.cancel"_q);
        QTRY_VERIFY_WITH_TIMEOUT(cancel.isVisible(), kEndMs);
        cancel.click();
        QTRY_COMPARE_WITH_TIMEOUT(m_queue->at(0).state, ExportState::Cancelled, kEndMs);
        QVERIFY(!m_dialog->stage().isPlaying());
        QVERIFY(!cancel.isVisible());
    }

private:
    template <class Widget>
    [[nodiscard]] Widget& part(const QString& name) const
    {
        return *childOf<Widget>(*m_dialog, name);
    }
    [[nodiscard]] QStackedWidget& pages() const { return *m_dialog->findChild<QStackedWidget*>(); }
    void press(const QString& name) { QTest::mouseClick(&part<QPushButton>(name), Qt::LeftButton); }
    [[nodiscard]] int stepsShown() const
    {
        return static_cast<int>(part<QLabel>(u"engine.steps"_q).text().split(u"\n\n"_q).size());
    }

    std::unique_ptr<QTemporaryDir> m_home;
    QString m_chosenFolder;
    int m_answer = 0;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<ExportQueue> m_queue;
    std::unique_ptr<EngineDialog> m_dialog;
};

FUMAGE_TEST_MAIN(EngineDialogTest)
#include "engine_dialog_test.moc"
