// Whole windows, driven as a person would: on a screen, with mouse and keyboard.
#include "editor_helpers.h"

#include "ui/noise_preview/noise_pane.h"
#include "ui/panels/effect_panel.h"
#include "ui/panels/number_field.h"
#include "ui/panels/number_slider.h"
#include "ui/presets/preset_browser.h"
#include "ui/presets/variations_panel.h"
#include "ui/export/export_job.h"
#include "ui/shell/main_window.h"
#include "ui/viewport/viewport.h"

#include "core/preset/library.h"

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QStyle>
#include <QTabBar>
#include <QStyleOptionSlider>
#include <QToolButton>

#include <cstdio>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// Smoke that a slow machine shows in a moment.
Preset smallPreset()
{
    Preset preset;
    preset.name = "Small";
    preset.effect.emitter.count = 1500;
    preset.effect.look.size = 0.5F;
    preset.effect.turbulence.octaves = 2;
    preset.effect.light.resolution = 24;
    preset.effect.noise.resolution = 32;
    preset.effect.noise.slices = 8;
    preset.effect.motion.wind = 0.8F;
    preset.effect.timeline.length = 60;
    return preset;
}

/// Answers the next message box as soon as it is there.
template <class Answer>
void answerNext(const char* boxName, const Answer& answer)
{
    auto* timer = new QTimer(qApp);
    timer->setInterval(10);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, boxName, answer] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (box != nullptr && box->objectName() == QLatin1String(boxName)) {
            timer->stop();
            timer->deleteLater();
            answer(*box);
        }
    });
    timer->start();
}

void pressButton(QMessageBox& box, QMessageBox::StandardButton button)
{
    QTest::mouseClick(box.button(button), Qt::LeftButton);
}

} // namespace

class WindowTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_session = std::make_unique<Session>();
        m_window = m_session->openWindow();
        m_window->player().pause();
        m_window->document().load(smallPreset(), {});
        m_window->player().setFrame(30);
        QVERIFY(QTest::qWaitForWindowActive(m_window));
        QTRY_VERIFY(m_window->viewport().isSettled());
    }
    void cleanup()
    {
        m_session.reset();
        QDir(m_folder.path()).removeRecursively();
        QDir().mkpath(m_folder.path());
    }

    void theWindowHasAnOpenGlViewport()
    {
        // Unless there is none, or only the processor's, which a plain widget beats.
        const QString wish = qEnvironmentVariable("FUMAGE_OPENGL");
        const bool expected = wish.isEmpty() ? m_session->glSupport() == GlSupport::Hardware : wish != u"none"_q;
        QCOMPARE(qobject_cast<QOpenGLWidget*>(m_window->viewport().surface()) != nullptr, expected);
    }

    void theWindowFitsASmallScreen()
    {
        // 1920 x 1080 at 200 %
        const QSize least = m_window->minimumSizeHint();
        QString parts;
        for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
            if (widget->minimumSizeHint().width() > 150 && widget->parentWidget() != nullptr && !widget->objectName().isEmpty() && !widget->objectName().contains(u"."_q)) {
                parts += QStringLiteral(" %1:%2").arg(widget->objectName()).arg(widget->minimumSizeHint().width());
            }
        }
        QVERIFY2(least.width() <= 960 && least.height() <= 520, qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height()) + parts));
    }

    // --- the sliders of the design card ------------------------------------------------------------------------------

    void aSliderIsDraggedTypedWheeledResetUndoneAndRedone_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("part"); // of the editor: its slider and field
        QTest::addColumn<QString>("typed");
        QTest::newRow("emitter normal") << u"emitter.normal"_q << u"emitter.normal.pitch"_q << u"40"_q;
        QTest::newRow("wind angle") << u"motion.wind_angle"_q << u"motion.wind_angle"_q << u"120°"_q;
        QTest::newRow("gravity") << u"motion.gravity"_q << u"motion.gravity"_q << u"1,5 m/s²"_q;
        QTest::newRow("fade rate") << u"life.fade_rate"_q << u"life.fade_rate"_q << u"0.06"_q;
        QTest::newRow("noise octaves") << u"noise.octaves"_q << u"noise.octaves"_q << u"2"_q;
        QTest::newRow("sharpness") << u"noise.sharpness"_q << u"noise.sharpness"_q << u"4"_q;
    }
    void aSliderIsDraggedTypedWheeledResetUndoneAndRedone()
    {
        QFETCH(QString, key);
        QFETCH(QString, part);
        QFETCH(QString, typed);
        const Parameter& parameter = *findParameter(key.toStdString());
        Document& document = m_window->document();
        auto* panel = m_window->findChild<EffectPanel*>();
        panel->showParameter(key);
        auto* slider = panel->findChild<NumberSlider*>(part + u".slider"_q);
        auto* field = panel->findChild<NumberField*>(part + u".field"_q);
        QVERIFY(slider != nullptr && field != nullptr && slider->isVisible());
        const Value before = parameter.get(document.effect());
        const QImage first = settled();
        const QImage firstTexture = texture();
        const std::string firstJson = formatPreset(document.preset());

        // Dragged.
        const QPoint handle = handleOf(*slider);
        const int way = handle.x() > slider->width() / 2 ? -30 : 30;
        dragMouse(*slider, handle, handle + QPoint(way, 0));
        const Value dragged = parameter.get(document.effect());
        QVERIFY(!(dragged == before));
        QCOMPARE(document.undoStack()->count(), 1);
        const QImage second = settled();
        QVERIFY(second != first);
        if (parameter.stage == Stage::Noise) {
            QTRY_VERIFY(texture() != firstTexture);
        }
        QVERIFY(formatPreset(document.preset()) != firstJson);

        // Undone and redone, to the same pictures.
        trigger("edit.undo");
        QVERIFY(parameter.get(document.effect()) == before);
        QCOMPARE(settled(), first);
        QCOMPARE(formatPreset(document.preset()), firstJson);
        trigger("edit.redo");
        QVERIFY(parameter.get(document.effect()) == dragged);
        QCOMPARE(settled(), second);
        trigger("edit.undo");

        // Typed, with unit and decimal comma.
        QTest::mouseClick(field, Qt::LeftButton);
        QTRY_VERIFY(field->hasFocus());
        QTest::keyClicks(field, typed);
        QTest::keyClick(field, Qt::Key_Return);
        const Value written = parameter.get(document.effect());
        QVERIFY(!(written == before));
        QCOMPARE(document.undoStack()->count(), 1);

        // The wheel, with the focus: one burst, one step.
        turnWheel(*field, -2);
        QVERIFY(!(parameter.get(document.effect()) == written));
        QCOMPARE(document.undoStack()->count(), 2);

        // Reset by a double click on the label.
        auto* label = panel->findChild<QLabel*>(key + u".label"_q);
        QTest::mouseDClick(label, Qt::LeftButton);
        QVERIFY(parameter.get(document.effect()) == before);
        QCOMPARE(settled(), first);
    }

    // --- files --------------------------------------------------------------------------------------------------------

    void whatIsSavedIsWhatIsLoaded()
    {
        const QString path = m_folder.filePath(u"mine.json"_q);
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        QVERIFY(m_window->document().save(path).ok());
        const Effect saved = m_window->document().effect();
        m_window->document().load(Preset(), {});
        QVERIFY(m_window->files().openFile(path));
        QVERIFY(m_window->document().effect() == saved);
        QVERIFY(m_window->windowTitle().contains(u"mine"_q));
        QVERIFY(!m_window->isWindowModified());
        auto* recent = m_window->findChild<QMenu*>(u"recentMenu"_q);
        QVERIFY(!recent->actions().isEmpty());
        QCOMPARE(recent->actions().first()->data().toString(), path);
        m_window->document().load(Preset(), {});
        recent->actions().first()->trigger();
        QVERIFY(m_window->document().effect() == saved);
    }

    void unsavedChangesAreAskedAbout()
    {
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        QVERIFY(m_window->isWindowModified());
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Cancel); });
        trigger("file.new");
        QCOMPARE(m_window->document().effect().motion.gravity, 2.0F);
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Cancel); });
        QVERIFY(!m_window->close());
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Discard); });
        trigger("file.new");
        QVERIFY(m_window->document().effect() == Effect());
    }

    void savingFromTheQuestionKeepsTheWork()
    {
        const QString path = m_folder.filePath(u"kept.json"_q);
        QVERIFY(m_window->document().save(path).ok());
        m_window->document().edit(*findParameter("motion.gravity"), 3.0F);
        answerNext("unsavedBox", [](QMessageBox& box) { pressButton(box, QMessageBox::Save); });
        trigger("file.new");
        QCOMPARE(readPresetFile(path.toStdString()).value().preset.effect.motion.gravity, 3.0F);
    }

    void aBrokenFileIsToldAboutAndCostsNothing()
    {
        const QString path = m_folder.filePath(u"broken.json"_q);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\n  \"format\": \"fumage-preset\",\n  \"version\": oops }");
        file.close();
        const Effect before = m_window->document().effect();
        QString told;
        answerNext("errorBox", [&told](QMessageBox& box) {
            told = box.text() + u" "_q + box.informativeText();
            pressButton(box, QMessageBox::Ok);
        });
        QVERIFY(!m_window->files().openFile(path));
        QVERIFY2(told.contains(u"line 3"_q), qPrintable(told));
        QVERIFY(m_window->document().effect() == before);
    }

    void aFolderThatCannotBeWrittenToIsToldAbout()
    {
        const QString path = u"/proc/smoke.json"_q; // not even root writes here
        m_window->document().load(smallPreset(), path);
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        QString told;
        answerNext("errorBox", [&told](QMessageBox& box) {
            told = box.text() + u" "_q + box.informativeText();
            pressButton(box, QMessageBox::Ok);
        });
        QVERIFY(!m_window->files().save());
        QVERIFY2(told.contains(u"/proc"_q), qPrintable(told));
        QVERIFY(m_window->document().isModified());
    }

    void aPresetIsCopiedAndPasted()
    {
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        const Effect copied = m_window->document().effect();
        trigger("edit.copyPreset");
        m_window->document().load(smallPreset(), {});
        trigger("edit.pastePreset");
        QVERIFY(m_window->document().effect() == copied);
        trigger("edit.undo");
        QVERIFY(m_window->document().effect() == smallPreset().effect);
    }

    void severalWindowsHaveDocumentsOfTheirOwn()
    {
        trigger("file.newWindow");
        MainWindow* second = nullptr;
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            auto* window = qobject_cast<MainWindow*>(widget);
            second = window != nullptr && window != m_window ? window : second;
        }
        QVERIFY(second != nullptr);
        second->document().edit(*findParameter("motion.gravity"), 5.0F);
        QVERIFY(m_window->document().effect() == smallPreset().effect);
        QVERIFY(!m_window->isWindowModified());
    }

    // --- viewport -----------------------------------------------------------------------------------------------------

    void whatIsDrawnOverTheSmokeIsRemembered()
    {
        const auto isShown = [](MainWindow& window, const char* action) { return window.actions().get(action).isChecked(); };
        QVERIFY(isShown(*m_window, "view.grid") && !isShown(*m_window, "view.tracks") && !isShown(*m_window, "view.frame"));
        trigger("view.grid");
        trigger("view.tracks");
        trigger("view.frame");
        m_window->close();
        MainWindow* next = m_session->openWindow();
        QVERIFY(!isShown(*next, "view.grid") && isShown(*next, "view.tracks") && isShown(*next, "view.readout"));
        QVERIFY(!isShown(*next, "view.frame")); // belongs to the export dialog
        QVERIFY(!next->viewport().overlays().testFlag(Overlay::Grid) && next->viewport().overlays().testFlag(Overlay::Tracks));
        next->actions().get("view.grid").trigger();
        next->actions().get("view.tracks").trigger();
        next->close();
        m_window = m_session->openWindow();
        QVERIFY(isShown(*m_window, "view.grid") && !isShown(*m_window, "view.tracks"));
    }

    void theWindArrowIsDragged()
    {
        Viewport& viewport = m_window->viewport();
        m_window->document().edit(*findParameter("camera.pitch"), 35.0F);
        const QImage before = settled();
        const QPoint from = handleOnScreen(GizmoId::Wind);
        const int steps = m_window->document().undoStack()->count();
        dragMouse(*viewport.surface(), from, from + QPoint(-60, 50));
        QVERIFY(m_window->document().effect().motion.windAngle != 0.0F);
        QCOMPARE(m_window->document().undoStack()->count(), steps + 1);
        QVERIFY(settled() != before);
        trigger("edit.undo");
        QCOMPARE(m_window->document().effect().motion.windAngle, 0.0F);
        QCOMPARE(settled(), before);
    }

    void theEmitterNormalIsDraggedAndThePanelFollows()
    {
        auto* panel = m_window->findChild<EffectPanel*>();
        auto* x = panel->findChild<NumberField*>(u"emitter.normal.x"_q);
        const QPoint from = handleOnScreen(GizmoId::EmitterNormal);
        dragMouse(*m_window->viewport().surface(), from, from + QPoint(40, 20));
        QVERIFY(m_window->document().effect().emitter.normal.x > 0.2F);
        QCOMPARE(x->value(), std::round(static_cast<double>(m_window->document().effect().emitter.normal.x) * 1e4) / 1e4);
        QCOMPARE(m_window->document().undoStack()->count(), 1);
    }

    void theCameraOrbitsPansAndZooms()
    {
        QWidget& surface = *m_window->viewport().surface();
        const QPoint corner(30, 30);
        const Camera before = m_window->document().effect().camera;
        dragMouse(surface, corner, corner + QPoint(80, 40), Qt::MiddleButton);
        QVERIFY(m_window->document().effect().camera.yaw != before.yaw);
        dragMouse(surface, corner, corner + QPoint(80, 40), Qt::MiddleButton, Qt::ShiftModifier);
        QVERIFY(!(m_window->document().effect().camera.target == before.target));
        turnWheel(surface, 2);
        turnWheel(surface, 1);
        QVERIFY(m_window->document().effect().camera.distance < before.distance);
        QCOMPARE(m_window->document().undoStack()->count(), 3);
        trigger("view.front");
        QCOMPARE(m_window->document().effect().camera.yaw, 0.0F);
    }

    void scrubbingBackAndForthGivesTheSamePictures()
    {
        Player& player = m_window->player();
        QHash<int, QImage> pictures;
        for (const int frame : {5, 40, 12}) {
            player.setFrame(frame);
            pictures.insert(frame, settled());
        }
        QVERIFY(pictures[5] != pictures[40]);
        // Another revision and back again, so that nothing comes out of the cache.
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F);
        settled();
        trigger("edit.undo");
        for (const int frame : {12, 5, 40, 5}) {
            player.setFrame(frame);
            QCOMPARE(settled(), pictures[frame]);
        }
    }

    void playingShowsEveryFrameAndKeepsThePictures()
    {
        Player& player = m_window->player();
        player.setRange(0, 9);
        player.setFrame(0);
        settled();
        QSet<int> shown;
        connect(&m_window->viewport(), &Viewport::pictureShown, this, [&](const PicturePtr& picture) { shown += picture->frame; });
        QTest::keyClick(m_window, Qt::Key_Space);
        QVERIFY(player.isPlaying());
        QTRY_COMPARE(shown.size(), 10);
        QTest::keyClick(m_window, Qt::Key_Space);
        QVERIFY(!player.isPlaying());
        QVERIFY(m_window->viewport().cachedFrames().size() >= 10);
    }

    void aHiddenWindowDoesNotWork()
    {
        m_window->player().play();
        QTRY_VERIFY(m_window->player().frame() != 30);
        m_window->hide();
        const int frame = m_window->player().frame();
        // Many turns of the event loop, in which a player that ran would have gone on.
        QTimer timer;
        QSignalSpy turns(&timer, &QTimer::timeout);
        timer.start(5);
        QTRY_VERIFY(turns.size() > 40);
        QCOMPARE(m_window->player().frame(), frame);
        m_window->show();
        QTRY_VERIFY(m_window->player().frame() != frame);
    }

    void aAndBAreSeenSideBySide()
    {
        Viewport& viewport = m_window->viewport();
        trigger("compare.remember");
        m_window->document().edit(*findParameter("look.colour"), glm::vec3(1.0F, 0.1F, 0.1F));
        const QImage a = settled();
        m_window->actions().get("compare.split").setChecked(true);
        QCOMPARE(viewport.compare(), Viewport::Compare::Split);
        QTRY_VERIFY(viewport.otherPicture() && viewport.otherPicture()->complete);
        QVERIFY(viewport.otherPicture()->image != a);
        // Both halves move together.
        const QImage b = viewport.otherPicture()->image;
        m_window->document().edit(*findParameter("camera.yaw"), 50.0F);
        QTRY_VERIFY(viewport.otherPicture()->image != b);
        m_window->actions().get("compare.split").setChecked(false);
        trigger("compare.adopt");
        QVERIFY(m_window->document().effect() == smallPreset().effect);
    }

    void bIsSeenWhileItsKeyIsHeld()
    {
        Viewport& viewport = m_window->viewport();
        QWidget* surface = viewport.surface();
        surface->setFocus();
        QTest::keyClick(surface, Qt::Key_B); // a tap stays
        QCOMPARE(viewport.compare(), Viewport::Compare::Other);
        QTest::keyClick(surface, Qt::Key_B);
        QCOMPARE(viewport.compare(), Viewport::Compare::Off);
        QTest::keyPress(surface, Qt::Key_B);
        QCOMPARE(viewport.compare(), Viewport::Compare::Other);
        QElapsedTimer held;
        held.start();
        QTRY_VERIFY(held.elapsed() > 400);
        QTest::keyRelease(surface, Qt::Key_B);
        QCOMPARE(viewport.compare(), Viewport::Compare::Off);
    }

    // --- presets and variations ---------------------------------------------------------------------------------------

    void aPresetOfTheBrowserIsOpened()
    {
        auto* browser = m_window->findChild<PresetBrowser*>();
        PresetList& list = browser->list();
        QTRY_VERIFY(list.count() >= 14);
        QListWidgetItem* campfire = nullptr;
        for (int i = 0; i < list.count(); ++i) {
            campfire = list.idOf(list.item(i)) == u"campfire"_q ? list.item(i) : campfire;
        }
        QVERIFY(campfire != nullptr);
        emit list.itemActivated(campfire);
        QVERIFY(m_window->document().effect() == loadPreset("campfire").value().preset.effect);
        QVERIFY(m_window->document().filePath().isEmpty());
    }

    void aVariationIsAdoptedAndUndone()
    {
        trigger("edit.variations");
        auto* variations = m_window->findChild<VariationsPanel*>();
        QTRY_VERIFY(variations->isVisible());
        auto* cell = variations->findChild<QToolButton*>(u"variation.2"_q);
        QTRY_VERIFY(!cell->icon().isNull());
        const Effect chosen = variations->effectOf(2);
        QVERIFY(!(chosen == smallPreset().effect));
        QTest::mouseClick(cell, Qt::LeftButton);
        QVERIFY(m_window->document().effect() == chosen);
        trigger("edit.undo");
        QVERIFY(m_window->document().effect() == smallPreset().effect);
        trigger("edit.redo");
        auto* back = variations->findChild<QToolButton*>(u"variations.back"_q);
        QTRY_VERIFY(back->isEnabled());
        QTest::mouseClick(back, Qt::LeftButton);
        QVERIFY(m_window->document().effect() == smallPreset().effect);
    }

    // --- export -------------------------------------------------------------------------------------------------------

    void aSequenceIsExportedWhileOneWorks()
    {
        QDialog* dialog = openExport();
        set<QComboBox>(*dialog, u"export.kind"_q)->setCurrentIndex(0);
        const QString path = m_folder.filePath(u"out/smoke_##.png"_q);
        auto* field = set<QLineEdit>(*dialog, u"export.path"_q);
        field->selectAll();
        QTest::keyClicks(field, path);
        set<QSpinBox>(*dialog, u"export.first"_q)->setValue(3);
        set<QSpinBox>(*dialog, u"export.last"_q)->setValue(6);
        QSignalSpy finished(&m_window->exportJob(), &ExportJob::finished);
        QTest::mouseClick(set<QPushButton>(*dialog, u"export.begin"_q), Qt::LeftButton);
        m_window->document().edit(*findParameter("motion.gravity"), 2.0F); // does not touch what is being written
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, 60000);
        QCOMPARE(QDir(m_folder.filePath(u"out"_q)).entryList({u"*.png"_q}), (QStringList{u"smoke_03.png"_q, u"smoke_04.png"_q, u"smoke_05.png"_q, u"smoke_06.png"_q}));
        const QImage image(m_folder.filePath(u"out/smoke_03.png"_q));
        QCOMPARE(image.size(), QSize(128, 128));
        QVERIFY(image.hasAlphaChannel());
    }

    void aFlipbookIsExported()
    {
        QDialog* dialog = openExport();
        auto* begin = set<QPushButton>(*dialog, u"export.begin"_q);
        auto* kind = set<QComboBox>(*dialog, u"export.kind"_q);
        QVERIFY(!set<QSpinBox>(*dialog, u"export.columns"_q)->isVisible());
        kind->setCurrentIndex(kind->findText(u"Flipbook"_q));
        QVERIFY(set<QSpinBox>(*dialog, u"export.columns"_q)->isVisible());
        QVERIFY(set<QLineEdit>(*dialog, u"export.path"_q)->text().endsWith(u"-8x8.png"_q));
        auto* field = set<QLineEdit>(*dialog, u"export.path"_q);
        field->selectAll();
        QTest::keyClicks(field, m_folder.filePath(u"book.png"_q));
        set<QSpinBox>(*dialog, u"export.first"_q)->setValue(0);
        set<QSpinBox>(*dialog, u"export.last"_q)->setValue(9);
        QVERIFY(!begin->isEnabled()); // ten frames do not fill 64 cells
        QVERIFY(set<QLabel>(*dialog, u"export.files"_q)->text().contains(u"64"_q));
        set<QSpinBox>(*dialog, u"export.columns"_q)->setValue(4);
        set<QSpinBox>(*dialog, u"export.rows"_q)->setValue(2);
        QVERIFY(begin->isEnabled());
        m_window->document().edit(*findParameter("camera.distance"), 2.0F);
        QSignalSpy finished(&m_window->exportJob(), &ExportJob::finished);
        QTest::mouseClick(begin, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, 60000);
        QCOMPARE(QImage(m_folder.filePath(u"book.png"_q)).size(), QSize(4 * 128, 2 * 128));
        QVERIFY(QFile::exists(m_folder.filePath(u"book.flipbook.json"_q)));
        QVERIFY(set<QLabel>(*dialog, u"export.state"_q)->text().contains(u"cut off"_q)); // the camera is in the smoke
    }

    void anExportIsCancelled()
    {
        QDialog* dialog = openExport();
        auto* field = set<QLineEdit>(*dialog, u"export.path"_q);
        field->selectAll();
        QTest::keyClicks(field, m_folder.filePath(u"long/smoke_####.png"_q));
        set<QSpinBox>(*dialog, u"export.last"_q)->setValue(5000);
        QSignalSpy cancelled(&m_window->exportJob(), &ExportJob::cancelled);
        QTest::mouseClick(set<QPushButton>(*dialog, u"export.begin"_q), Qt::LeftButton);
        auto* cancel = set<QPushButton>(*dialog, u"export.cancel"_q);
        QTRY_VERIFY(!QDir(m_folder.filePath(u"long"_q)).isEmpty());
        QTest::mouseClick(cancel, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(cancelled.size(), 1, 60000);
        // What is there is whole.
        for (const QFileInfo& file : QDir(m_folder.filePath(u"long"_q)).entryInfoList(QDir::Files | QDir::Hidden)) {
            QVERIFY2(!QImage(file.filePath()).isNull(), qPrintable(file.filePath()));
        }
    }

    void anExportThatFailsSaysWhy()
    {
        QDialog* dialog = openExport();
        auto* field = set<QLineEdit>(*dialog, u"export.path"_q);
        field->selectAll();
        QTest::keyClicks(field, u"/proc/smoke_##.png"_q);
        QSignalSpy failed(&m_window->exportJob(), &ExportJob::failed);
        QTest::mouseClick(set<QPushButton>(*dialog, u"export.begin"_q), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, 60000);
        QVERIFY(set<QLabel>(*dialog, u"export.state"_q)->text().contains(u"/proc"_q));
    }

    // --- recovery -----------------------------------------------------------------------------------------------------

    void whatWasNotSavedIsThereAgainAfterAKill()
    {
        QProcess victim;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("FUMAGE_TEST_VICTIM"), QStringLiteral("1"));
        victim.setProcessEnvironment(environment);
        victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        victim.start(QCoreApplication::applicationFilePath());
        QVERIFY(victim.waitForReadyRead(20000)); // it says so when its copy is on the disk
        victim.kill();
        QVERIFY(victim.waitForFinished());
        QCOMPARE(victim.exitStatus(), QProcess::CrashExit);

        m_session->start({});
        MainWindow* recovered = nullptr;
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            auto* window = qobject_cast<MainWindow*>(widget);
            recovered = window != nullptr && window != m_window ? window : recovered;
        }
        QVERIFY(recovered != nullptr);
        QCOMPARE(recovered->document().effect().motion.gravity, 6.5F);
        QCOMPARE(recovered->document().filePath(), u"/somewhere/mine.json"_q);
        QVERIFY(recovered->isWindowModified());
        QVERIFY(Recovery::take(QDir(Settings::recoveryFolder())).empty());
    }

    // --- keyboard -----------------------------------------------------------------------------------------------------

    void theKeyboardAloneIsEnough()
    {
        // Search a parameter, go to it, type a value, undo: no mouse.
        QTest::keyClick(m_window, Qt::Key_F, Qt::ControlModifier);
        auto* search = m_window->findChild<QLineEdit*>(u"parameterSearch"_q);
        QTRY_VERIFY(search->hasFocus());
        QTest::keyClicks(search, u"fade rate"_q);
        auto* field = m_window->findChild<EffectPanel*>()->findChild<NumberField*>(u"life.fade_rate.field"_q);
        for (int i = 0; i < 6 && !field->hasFocus(); ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        QVERIFY(field->hasFocus());
        QTest::keyClicks(field, u"0.08"_q);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_window->document().effect().life.fadeRate, 0.08F);
        QTest::keyClick(field, Qt::Key_Up);
        QVERIFY(m_window->document().effect().life.fadeRate > 0.08F);
    }

    void plainKeysBelongToTheTimelineUnlessAWidgetNeedsThem()
    {
        m_window->viewport().surface()->setFocus();
        QTest::keyClick(m_window->viewport().surface(), Qt::Key_Right);
        QCOMPARE(m_window->player().frame(), 31);
        QTest::keyClick(m_window->viewport().surface(), Qt::Key_Left);
        QCOMPARE(m_window->player().frame(), 30);
        QTest::keyClick(m_window->viewport().surface(), Qt::Key_End);
        QCOMPARE(m_window->player().frame(), 59);
        QTest::keyClick(m_window->viewport().surface(), Qt::Key_Home);
        QCOMPARE(m_window->player().frame(), 0);
        auto* slider = m_window->findChild<EffectPanel*>()->findChild<NumberSlider*>(u"emitter.speed.slider"_q);
        slider->setFocus();
        const float before = m_window->document().effect().emitter.speed;
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(m_window->player().frame(), 0);
        QVERIFY(m_window->document().effect().emitter.speed > before);
    }

    void aCommandIsFoundAndDone()
    {
        QTest::keyClick(m_window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(m_window->findChild<QDialog*>(u"commandSearch"_q) != nullptr);
        auto* text = m_window->findChild<QLineEdit*>(u"commandSearch.text"_q);
        QTest::keyClicks(text, u"ground grid"_q);
        const bool before = m_window->viewport().overlays().testFlag(Overlay::Grid);
        QTest::keyClick(text, Qt::Key_Return);
        QCOMPARE(m_window->viewport().overlays().testFlag(Overlay::Grid), !before);
    }

    void everyActionHasATextAndNoShortcutIsTakenTwice()
    {
        QSet<QKeySequence> taken;
        for (const ActionSpec& spec : actionSpecs()) {
            QAction& action = m_window->actions().get(spec.id);
            QVERIFY(!action.text().isEmpty());
            for (const QKeySequence& keys : action.shortcuts()) {
                QVERIFY2(!keys.isEmpty() && !taken.contains(keys), spec.id);
                taken += keys;
            }
        }
    }

    void everythingThatCanBeReachedHasAName()
    {
        for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
            // Tabs have their texts, and the field of a spin box speaks for the box.
            const bool isPart = qobject_cast<const QTabBar*>(widget) != nullptr || qobject_cast<const QAbstractSpinBox*>(widget->parent()) != nullptr;
            if (widget->focusPolicy() & Qt::TabFocus && widget->isVisible() && !isPart) {
                const auto* button = qobject_cast<const QAbstractButton*>(widget);
                const bool named = !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty()) || !widget->toolTip().isEmpty();
                QVERIFY2(named, qPrintable(widget->objectName() + u" "_q + QString::fromLatin1(widget->metaObject()->className())));
            }
        }
    }

private:
    QImage settled()
    {
        Viewport& viewport = m_window->viewport();
        if (!QTest::qWaitFor([&] { return viewport.isSettled(); }, 20000)) {
            qWarning("the picture did not settle");
            return {};
        }
        return viewport.picture()->image;
    }

    QImage texture()
    {
        const NoisePicturePtr& picture = m_window->noisePane().picture();
        return picture ? picture->image : QImage();
    }

    void trigger(const char* action) { m_window->actions().get(action).trigger(); }

    QPoint handleOnScreen(GizmoId id)
    {
        const View view = m_window->viewport().view();
        for (const Gizmo& gizmo : gizmosOf(m_window->document().effect(), view)) {
            if (gizmo.id == id) {
                const Projected at = project(view, gizmo.to);
                return {qRound(at.x), qRound(at.y)};
            }
        }
        return {};
    }

    static QPoint handleOf(const NumberSlider& slider)
    {
        QStyleOptionSlider option;
        option.initFrom(&slider);
        option.orientation = Qt::Horizontal;
        option.minimum = slider.minimum();
        option.maximum = slider.maximum();
        option.sliderPosition = slider.sliderPosition();
        option.sliderValue = slider.value();
        return slider.style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider).center();
    }

    QDialog* openExport()
    {
        m_window->document().edit({{findParameter("output.width"), 128}, {findParameter("output.height"), 128}}, u"Size"_q);
        trigger("file.export");
        return m_window->findChild<QDialog*>(u"exportDialog"_q);
    }

    template <class Widget>
    static Widget* set(const QWidget& parent, const QString& name)
    {
        auto* widget = parent.findChild<Widget*>(name);
        Q_ASSERT(widget != nullptr);
        return widget;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Session> m_session;
    MainWindow* m_window = nullptr;
};

/// The program that is killed while it has unsaved work.
static int runVictim(int argc, char** argv)
{
    QApplication application(argc, argv);
    Session session;
    MainWindow* window = session.openWindow();
    window->document().load(smallPreset(), u"/somewhere/mine.json"_q);
    window->document().edit(*findParameter("motion.gravity"), 6.5F);
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &timer, [] {
        if (!QDir(Settings::recoveryFolder()).entryList({u"*.json"_q}).isEmpty()) {
            std::puts("saved");
            std::fflush(stdout);
        }
    });
    timer.start(20);
    return QApplication::exec();
}

int main(int argc, char** argv)
{
    return qEnvironmentVariableIsSet("FUMAGE_TEST_VICTIM") ? runVictim(argc, argv) : runTest<WindowTest>(argc, argv);
}
#include "window_test.moc"
