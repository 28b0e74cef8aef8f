// Panels in their window: what the sliders, the browser and the variations do to document and picture.
#include "window_fixture.h"
#include "library_helpers.h"

#include "ui/document/key_edits.h"
#include "ui/noise_preview/noise_pane.h"
#include "ui/panels/effect_panel.h"
#include "ui/panels/number_field.h"
#include "ui/panels/number_slider.h"
#include "ui/presets/preset_browser.h"
#include "ui/presets/variations_panel.h"
#include "ui/timeline/emission_strip.h"

#include "core/effect/known_parameter.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"

#include <QDockWidget>
#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QToolButton>

using namespace fumage;
using namespace fumage::tests;

class WindowPanelsTest : public WindowFixture {
    Q_OBJECT

private slots:
    // --- the sliders of the design card ------------------------------------------------------------------------------

    void aSliderIsDraggedTypedWheeledResetUndoneAndRedone_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("part"); // of the editor: its slider and field
        QTest::addColumn<QString>("typed");
        QTest::newRow("emitter normal") << u"emitter.normal"_q << u"emitter.normal.pitch"_q << u"40"_q;
        QTest::newRow("wind angle") << u"wind.angle"_q << u"wind.angle"_q << u"120°"_q;
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
        if (parameter.dirties == DirtyStage::Noise) {
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

        // The wheel, with the focus, which Return has taken: one burst, one step.
        field->setFocus();
        QTRY_VERIFY(field->hasFocus());
        turnWheel(*field, -2);
        QVERIFY(!(parameter.get(document.effect()) == written));
        QCOMPARE(document.undoStack()->count(), 2);

        // Reset by a double click on the label.
        auto* label = panel->findChild<QLabel*>(key + u".label"_q);
        QTest::mouseDClick(label, Qt::LeftButton);
        QVERIFY(parameter.get(document.effect()) == before);
        QCOMPARE(settled(), first);
    }

    void allParametersAreResetWithTheirKeyFrames()
    {
        Document& document = m_window->document();
        const Scene before = document.scene();
        document.edit(knownParameter("motion.gravity"), 2.0F);
        addKey(document, knownParameter("glow.emission"));
        addKey(document, knownParameter("wind.strength"));
        trigger("edit.resetAll");
        QVERIFY(document.scene() == before);
        trigger("edit.undo");
        QVERIFY(document.track(knownParameter("glow.emission")) != nullptr);
    }

    /// A strip of the emission chooses its layer, and takes no focus for that.
    void whatIsTypedIsOfTheLayerThatItWasTypedFor()
    {
        Document& document = m_window->document();
        Scene scene = document.scene();
        scene.layers.push_back(scene.layers[0]);
        scene.layers[1].name = "other";
        ++scene.layers[1].emitter.seed;
        document.replaceScene(scene, 0, u"two"_q);
        auto* strip = childOf<EmissionStrip>(*m_window, u"emissionStrip"_q);
        QTRY_VERIFY(strip->isVisible());
        auto* field = childOf<NumberField>(*m_window, u"emitter.speed.field"_q);
        const float before = scene.layers[1].emitter.speed;
        QTest::mouseClick(field, Qt::LeftButton);
        QTRY_VERIFY(field->hasFocus());
        QTest::keyClicks(field, u"3.5"_q);
        QTest::mouseClick(strip, Qt::LeftButton, {}, {strip->width() / 2, strip->height() * 3 / 4});
        QCOMPARE(document.layer(), std::size_t{1});
        field->clearFocus();
        QCOMPARE(document.scene().layers[0].emitter.speed, 3.5F);
        QCOMPARE(document.scene().layers[1].emitter.speed, before);
    }

    // --- presets and variations ---

    void aPresetOfTheBrowserIsOpened()
    {
        auto* browser = m_window->findChild<PresetBrowser*>();
        PresetList& list = browser->list();
        QTRY_COMPARE(list.count(), sizeOfLibrary());
        QListWidgetItem* campfire = nullptr;
        for (int i = 0; i < list.count(); ++i) {
            campfire = list.idOf(list.item(i)) == u"campfire"_q ? list.item(i) : campfire;
        }
        QVERIFY(campfire != nullptr);
        emit list.itemActivated(campfire);
        QVERIFY(m_window->document().effect() == loadPreset("campfire").value().preset.scene.effect());
        QVERIFY(m_window->document().filePath().isEmpty());
    }

    void wildVariationsShowSomething()
    {
        // Of the first eight at this amount four are empty or full.
        trigger("edit.variations");
        auto* variations = m_window->findChild<VariationsPanel*>();
        QTRY_VERIFY(variations->isVisible());
        constexpr int kPatienceMs = 60000;
        QList<QToolButton*> cells;
        QList<qint64> subtle;
        for (int i = 0; i < VariationsPanel::kCells; ++i) {
            cells += childOf<QToolButton>(*variations, u"variation.%1"_q.arg(i));
            QTRY_VERIFY_WITH_TIMEOUT(!cells[i]->icon().isNull(), kPatienceMs);
            subtle += cells[i]->icon().cacheKey();
        }
        childOf<QSlider>(*variations, u"variations.amount"_q)->setValue(40);
        for (int i = 0; i < VariationsPanel::kCells; ++i) {
            QTRY_VERIFY_WITH_TIMEOUT(cells[i]->icon().cacheKey() != subtle[i], kPatienceMs);
            QVERIFY(showsSomething(cells[i]->icon().pixmap(cells[i]->iconSize()).toImage()));
        }
    }

    void aPictureIsToldFromAnEmptyOne()
    {
        QImage image(64, 64, QImage::Format_RGB32);
        image.fill(QColor(30, 32, 36));
        QVERIFY(!showsSomething(image));
        image.fill(Qt::white);
        QVERIFY(!showsSomething(image));
        QPainter(&image).fillRect(20, 20, 24, 24, Qt::gray);
        QVERIFY(showsSomething(image));
        QVERIFY(!showsSomething(QImage()));
    }

    void picturesOfVariationsAreAsLargeAsThePanelAllows()
    {
        trigger("edit.variations");
        auto* variations = m_window->findChild<VariationsPanel*>();
        QTRY_VERIFY(variations->isVisible());
        auto* dock = childOf<QDockWidget>(*m_window, u"dock.variations"_q);
        const auto* cell = childOf<QToolButton>(*variations, u"variation.0"_q);
        const int before = cell->iconSize().width();
        dock->setFloating(true);
        dock->resize(760, 860);
        QTRY_VERIFY(cell->iconSize().width() > before + 80);
        QVERIFY(cell->geometry().right() < variations->width());
        // And become small again: how large they are is no reason for the panel to be so wide.
        dock->resize(360, 860);
        QTRY_VERIFY(dock->width() <= 400);
        QTRY_VERIFY(cell->iconSize().width() < before + 40);
    }

    void variationsFollowTheSmokeWhileKeyFramesArePlayed()
    {
        Document& document = m_window->document();
        addKey(document, knownParameter("glow.emission"));
        trigger("edit.variations");
        auto* variations = m_window->findChild<VariationsPanel*>();
        QTRY_VERIFY(variations->isVisible());
        QTimer frames;
        int frame = 0;
        connect(&frames, &QTimer::timeout, &document, [&] { document.setSeconds(++frame / 30.0); });
        frames.start(10);
        document.edit(knownParameter("motion.gravity"), 2.0F);
        QTRY_COMPARE(variations->effectOf(VariationsPanel::kMiddle).motion.gravity, 2.0F);
    }

    void aVariationIsAdoptedAndUndone()
    {
        trigger("edit.variations");
        auto* variations = m_window->findChild<VariationsPanel*>();
        QTRY_VERIFY(variations->isVisible());
        auto* cell = variations->findChild<QToolButton*>(u"variation.2"_q);
        QTRY_VERIFY(!cell->icon().isNull());
        const Effect chosen = variations->effectOf(2);
        QVERIFY(!(chosen == smallPreset().scene.effect()));
        QTest::mouseClick(cell, Qt::LeftButton);
        QVERIFY(m_window->document().effect() == chosen);
        trigger("edit.undo");
        QVERIFY(m_window->document().effect() == smallPreset().scene.effect());
        trigger("edit.redo");
        auto* back = variations->findChild<QToolButton*>(u"variations.back"_q);
        QTRY_VERIFY(back->isEnabled());
        QTest::mouseClick(back, Qt::LeftButton);
        QVERIFY(m_window->document().effect() == smallPreset().scene.effect());
    }

private:
    QImage texture()
    {
        const NoisePicturePtr& picture = m_window->noisePane().picture();
        return picture ? picture->image : QImage();
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
};

FUMAGE_TEST_MAIN(WindowPanelsTest)
#include "window_panels_test.moc"
