// The list of layers, and what is done in it: each one undo step.
#include "layers_fixture.h"

#include "ui/document/layer_clipboard.h"
#include "ui/document/layer_edits.h"

#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"

#include <QMenu>
#include <QMimeData>
#include <QToolButton>

using namespace fumage;
using namespace fumage::tests;

class LayerListTest : public LayersFixture {
    Q_OBJECT

private slots:
    /// Each is one undo step, which takes back all that it did, and edits the layer that it is about.
    void eachChangeIsAStep_data()
    {
        QTest::addColumn<int>("change");
        QTest::addColumn<QStringList>("expected");
        QTest::addColumn<int>("edited");
        QTest::newRow("add") << 0 << QStringList{u"flames"_q, u"Layer 4"_q, u"smoke"_q, u"embers"_q} << 1;
        QTest::newRow("duplicate") << 1 << QStringList{u"flames"_q, u"smoke"_q, u"smoke 2"_q, u"embers"_q} << 2;
        QTest::newRow("delete") << 2 << QStringList{u"flames"_q, u"embers"_q} << 0;
        QTest::newRow("move") << 3 << QStringList{u"smoke"_q, u"embers"_q, u"flames"_q} << 2;
        QTest::newRow("rename") << 4 << QStringList{u"flames"_q, u"steam"_q, u"embers"_q} << 1;
        QTest::newRow("mute") << 5 << QStringList{u"flames"_q, u"smoke"_q, u"embers"_q} << 1;
        QTest::newRow("lock") << 6 << QStringList{u"flames"_q, u"smoke"_q, u"embers"_q} << 1;
        QTest::newRow("tag") << 7 << QStringList{u"flames"_q, u"smoke"_q, u"embers"_q} << 1;
        QTest::newRow("layers of another")
            << 8 << QStringList{u"flames"_q, u"smoke 2"_q, u"ash"_q, u"smoke"_q, u"embers"_q} << 2;
        QTest::newRow("duplicate two") << 9
                                       << QStringList{u"flames"_q, u"smoke"_q, u"embers"_q, u"flames 2"_q,
                                              u"embers 2"_q}
                                       << 4;
        QTest::newRow("delete two") << 10 << QStringList{u"embers"_q} << 0;
        QTest::newRow("move two") << 11 << QStringList{u"smoke"_q, u"flames"_q, u"embers"_q} << 1;
        QTest::newRow("mute two") << 12 << QStringList{u"flames"_q, u"smoke"_q, u"embers"_q} << 0;
        QTest::newRow("lock two") << 13 << QStringList{u"flames"_q, u"smoke"_q, u"embers"_q} << 0;
    }
    void eachChangeIsAStep()
    {
        QFETCH(int, change);
        QFETCH(QStringList, expected);
        QFETCH(int, edited);
        const Scene before = m_document.scene();
        Preset other;
        other.scene.layers.resize(2);
        other.scene.layers[0].name = "smoke";
        other.scene.layers[1].name = "ash";
        switch (change) {
        case 0: addLayer(m_document); break;
        case 1: duplicateLayers(m_document, {1}); break;
        case 2: removeLayers(m_document, {1}); break;
        case 3: moveLayers(m_document, {0}, 3); break;
        case 4: renameLayer(m_document, 1, u" steam "_q); break;
        case 5: setLayersVisible(m_document, {1}, false); break;
        case 6: setLayersLocked(m_document, {1}, true); break;
        case 7: setLayersTag(m_document, {1}, ColourTag::Green); break;
        case 8: QCOMPARE(addLayersOf(m_document, other, u"other"_q), std::size_t{0}); break;
        case 9: duplicateLayers(m_document, {0, 2}); break;
        case 10: removeLayers(m_document, {0, 1}); break;
        case 11: moveLayers(m_document, {0, 2}, 2); break;
        case 12: setLayersVisible(m_document, {0, 2}, false); break;
        default: setLayersLocked(m_document, {0, 2}, true);
        }
        QCOMPARE(names(m_document), expected);
        QCOMPARE(static_cast<int>(m_document.layer()), edited);
        QCOMPARE(m_document.undoStack()->count(), 1);
        const Scene after = m_document.scene();
        QVERIFY(!(after == before));
        m_document.undoStack()->undo();
        QVERIFY(m_document.scene() == before);
        m_document.undoStack()->redo();
        QVERIFY(m_document.scene() == after);
        QCOMPARE(static_cast<int>(m_document.layer()), edited);
        // No two layers have one seed: they would move alike.
        for (std::size_t i = 0; i < after.layers.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                QVERIFY(after.layers[i].emitter.seed != after.layers[j].emitter.seed);
            }
        }
    }

    void undoChoosesTheLayerThatItTouches()
    {
        m_document.selectLayer(2);
        m_document.edit(knownParameter("motion.gravity"), 4.0F);
        m_document.selectLayer(0);
        QCOMPARE(m_document.effect().motion.gravity, 0.0F);
        m_document.edit(knownParameter("wind.strength"), 2.0F); // of the scene
        QCOMPARE(m_document.scene().wind.strength, 2.0F);
        m_document.undoStack()->undo();
        QCOMPARE(static_cast<int>(m_document.layer()), 0);
        m_document.undoStack()->undo();
        QCOMPARE(static_cast<int>(m_document.layer()), 2);
        QCOMPARE(m_document.effect().motion.gravity, 0.0F);
        QVERIFY(!m_document.isModified());
    }

    void aLockedLayerStaysAsItIs()
    {
        setLayersLocked(m_document, {0}, true);
        const Scene locked = m_document.scene();
        QSignalSpy changed(&m_document, &Document::effectChanged);
        m_document.edit(knownParameter("motion.gravity"), 4.0F);
        QVERIFY(m_document.scene() == locked);
        QCOMPARE(changed.size(), 1); // whoever asked shows again what is there
        Effect other = m_document.effect();
        other.motion.gravity = 4.0F;
        m_document.replaceEffect(other, u"other"_q);
        QVERIFY(m_document.scene() == locked);
        m_document.edit(knownParameter("wind.strength"), 2.0F); // which all layers share
        QCOMPARE(m_document.scene().wind.strength, 2.0F);
        m_document.selectLayer(1);
        m_document.edit(knownParameter("motion.gravity"), 4.0F);
        QCOMPARE(m_document.effect().motion.gravity, 4.0F);
    }

    void theLastLayerStays()
    {
        removeLayers(m_document, {0, 1, 2}); // none would be left
        QCOMPARE(m_document.undoStack()->count(), 0);
        removeLayers(m_document, {0});
        removeLayers(m_document, {0});
        removeLayers(m_document, {0});
        QCOMPARE(names(m_document), QStringList{u"embers"_q});
    }

    void noMoreThanThereMayBe()
    {
        for (std::size_t i = 0; i < 2 * kMaxLayers; ++i) {
            addLayer(m_document);
            duplicateLayers(m_document, {0, m_document.scene().layers.size() - 1});
        }
        QCOMPARE(m_document.scene().layers.size(), kMaxLayers);
        Preset other;
        other.scene.layers.resize(2);
        QCOMPARE(addLayersOf(m_document, other, u"other"_q), std::size_t{2});
    }

    void theListShowsAndChangesThem()
    {
        Solo solo(m_document);
        LayerList list(m_document, solo);
        list.show();
        LayerView& view = list.view();
        QAbstractItemModel& model = *view.model();
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.index(1, 0).data().toString(), u"smoke"_q);
        view.setCurrentIndex(model.index(2, 0));
        QCOMPARE(static_cast<int>(m_document.layer()), 2);
        m_document.selectLayer(1);
        QCOMPARE(view.currentIndex().row(), 1);
        QVERIFY(model.setData(model.index(1, 0), Qt::Unchecked, Qt::CheckStateRole));
        QVERIFY(!m_document.scene().layers[1].visible);
        QVERIFY(model.setData(model.index(1, 0), u"<b>mist</b>"_q, Qt::EditRole));
        QCOMPARE(model.index(1, 0).data().toString(), u"<b>mist</b>"_q);
        QVERIFY(!model.index(1, 0).data(Qt::ToolTipRole).toString().contains(u"<b>mist"_q));
        const std::unique_ptr<QMimeData> dragged(model.mimeData({model.index(0, 0)}));
        model.dropMimeData(dragged.get(), Qt::MoveAction, 3, 0, {});
        QCOMPARE(names(m_document).last(), u"flames"_q);
        list.findChild<QToolButton*>(u"layers.add"_q)->menu()->actions().first()->trigger();
        QCOMPARE(model.rowCount(), 4);
        list.findChild<QToolButton*>(u"layers.delete"_q)->click();
        QCOMPARE(model.rowCount(), 3);
    }

    void filesHaveAllOfThem()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"scene.json"_q);
        setLayersVisible(m_document, {1}, false);
        QVERIFY(m_document.save(path).ok());
        QVERIFY(readPresetFile(path.toStdString()).value().preset.scene == m_document.scene());
        m_document.selectLayer(2);
        Document other;
        other.load(readPresetFile(path.toStdString()).value().preset, path);
        QCOMPARE(names(other), names(m_document));
    }

    // --- several ----------------------------------------------------------------------------------------------------

    void shiftAndControlChooseSeveral()
    {
        Solo solo(m_document);
        LayerList list(m_document, solo);
        list.show();
        LayerView& view = list.view();
        const auto click = [&](int row, Qt::KeyboardModifiers modifiers) {
            const QRect place = view.visualRect(view.model()->index(row, 0));
            QTest::mouseClick(view.viewport(), Qt::LeftButton, modifiers, place.center());
        };
        click(0, {});
        click(2, Qt::ShiftModifier);
        QCOMPARE(m_document.selection(), LayerSelection(2, {0, 1}));
        click(1, Qt::ControlModifier);
        QCOMPARE(m_document.selection().all(), (LayerPlaces{0, 2}));
        view.model()->setData(view.model()->index(0, 0), Qt::Unchecked, Qt::CheckStateRole);
        QVERIFY(!m_document.scene().layers[0].visible && !m_document.scene().layers[2].visible);
        QVERIFY(m_document.scene().layers[1].visible);
        QCOMPARE(m_document.selection().all(), (LayerPlaces{0, 2}));
        // One that is not among them stands for itself.
        view.model()->setData(view.model()->index(1, 0), Qt::Unchecked, Qt::CheckStateRole);
        QCOMPARE(m_document.selection(), LayerSelection(1));
        m_document.undoStack()->undo();
        QCOMPARE(m_document.selection().all(), (LayerPlaces{0, 2}));
        QTest::keyClick(&view, Qt::Key_Delete);
        QCOMPARE(names(m_document), QStringList{u"smoke"_q});
        m_document.undoStack()->undo();
        QCOMPARE(m_document.selection().all(), (LayerPlaces{0, 2}));
        QCOMPARE(view.selectionModel()->selectedIndexes().size(), 2);
        // None chosen is the one that is edited.
        click(1, {});
        click(1, Qt::ControlModifier);
        QCOMPARE(m_document.selection(), LayerSelection(1));
        QCOMPARE(view.selectionModel()->selectedIndexes().size(), 1);
    }

    /// Choosing is no change of the smoke.
    void whatIsChosenChangesNoPicture()
    {
        QSignalSpy changed(&m_document, &Document::effectChanged);
        m_document.selectLayers({0, {2}});
        QCOMPARE(changed.size(), 0);
        m_document.selectLayers(1);
        QCOMPARE(changed.size(), 1);
        QVERIFY(!changed[0][0].value<EffectChange>().isOfScene);
        QCOMPARE(m_document.undoStack()->count(), 0);
        m_document.edit(knownParameter("motion.gravity"), 4.0F);
        QVERIFY(changed[1][0].value<EffectChange>().isOfScene);
    }

    // --- what layers cost -------------------------------------------------------------------------------------------

    void rowsSayHowManyParticlesThereAre()
    {
        Solo solo(m_document);
        LayerList list(m_document, solo);
        LayerModel& model = list.view().layers();
        const auto shown = [&](int row) { return model.index(row, 0).data(LayerModel::Particles).toString(); };
        const auto tip = [&](int row) { return model.index(row, 0).data(Qt::ToolTipRole).toString(); };
        m_document.selectLayer(1);
        m_document.edit(knownParameter("emitter.count"), 12345);
        QCOMPARE(shown(1), QLocale().toString(12345));
        m_document.edit(knownParameter("output.quality"), static_cast<int>(Quality::Draft));
        QCOMPARE(shown(1), QLocale().toString(12345 / 4)); // those that are simulated
        QVERIFY(!tip(1).contains(u'%'));
        for (int i = 0; i < 50; ++i) {
            model.noteWork({300.0, 100.0, 0.0});
            model.noteWork({0.0, 0.0, 0.0}); // a picture that was there already
        }
        QVERIFY2(tip(0).contains(u"75 %"_q) && tip(1).contains(u"25 %"_q), qPrintable(tip(0) + tip(1)));
        setLayersVisible(m_document, {1}, false);
        QVERIFY(tip(1).contains(u"Muted"_q) && !tip(1).contains(u'%'));
        removeLayers(m_document, {1, 2});
        QCOMPARE(shown(0), QString()); // a layer alone has the readout
    }

    // --- solo -------------------------------------------------------------------------------------------------------

    void soloIsOfTheViewAlone()
    {
        Solo solo(m_document);
        QSignalSpy changed(&solo, &Solo::changed);
        const std::string before = formatPreset(m_document.preset());
        solo.set({2, 0}, true);
        QCOMPARE(solo.layers(), (LayerPlaces{0, 2}));
        QVERIFY(solo.isOn() && solo.contains(2) && !solo.contains(1));
        QCOMPARE(formatPreset(m_document.preset()), before);
        QCOMPARE(m_document.undoStack()->count(), 0);
        solo.toggleAlone(1);
        QCOMPARE(solo.layers(), LayerPlaces{1});
        solo.toggleAlone(1);
        QVERIFY(!solo.isOn());
        solo.set({1}, true);
        QCOMPARE(changed.size(), 4);
        m_document.load(m_document.preset(), {});
        QVERIFY(!solo.isOn());
        QCOMPARE(changed.size(), 5);
    }

    void soloFollowsItsLayer()
    {
        Solo solo(m_document);
        solo.set({2}, true);
        moveLayers(m_document, {2}, 0);
        QCOMPARE(solo.layers(), LayerPlaces{0});
        addLayer(m_document); // after it
        renameLayer(m_document, 0, u"sparks"_q);
        QCOMPARE(solo.layers(), LayerPlaces{0});
        m_document.edit(knownParameter("emitter.seed"), 99U);
        QCOMPARE(solo.layers(), LayerPlaces{0});
        duplicateLayers(m_document, {0});
        moveLayers(m_document, {0}, m_document.scene().layers.size());
        QCOMPARE(layerLabel(m_document.scene(), solo.layers().at(0)), u"sparks"_q);
        while (m_document.undoStack()->canUndo()) {
            m_document.undoStack()->undo();
        }
        QCOMPARE(solo.layers(), LayerPlaces{2});
        removeLayers(m_document, {2});
        QVERIFY(!solo.isOn());
    }

    /// Whatever is done to layers, none is left that a file could not hold.
    void parentsSurviveWhatIsDoneToLayers()
    {
        const auto from = [&](std::size_t layer) {
            return QString::fromStdString(m_document.scene().layers[layer].from);
        };
        const auto name = [&](std::size_t layer) { return layerLabel(m_document.scene(), layer); };
        const auto isWhole = [&] {
            const Result<PresetReading> read = parsePreset(formatPreset(m_document.preset()));
            return read.ok() && read.value().preset.scene == m_document.scene();
        };
        setLayersParent(m_document, {1}, 0);
        setLayersParent(m_document, {2}, 1);
        QCOMPARE(m_document.undoStack()->count(), 2);
        QCOMPARE(from(1), name(0));
        QCOMPARE(from(2), name(1));
        QVERIFY(isWhole());
        setLayersParent(m_document, {0}, 2); // a ring
        setLayersParent(m_document, {1}, 1);
        QCOMPARE(m_document.undoStack()->count(), 2);
        renameLayer(m_document, 0, u"debris"_q);
        QCOMPARE(from(1), u"debris"_q);
        renameLayer(m_document, 1, u"debris"_q); // is taken
        QCOMPARE(from(2), name(1));
        QVERIFY(name(1) != name(0) && isWhole());
        moveLayers(m_document, {0}, 3);
        QCOMPARE(parentOf(m_document.scene(), 0), std::optional<std::size_t>(2));
        moveLayers(m_document, {2}, 0);
        duplicateLayers(m_document, {1, 2}); // with the parent of the second, and without that of the first
        QCOMPARE(parentOf(m_document.scene(), 3), std::optional<std::size_t>(0));
        QCOMPARE(parentOf(m_document.scene(), 4), std::optional<std::size_t>(3));
        QVERIFY(isWhole());
        const std::unique_ptr<QMimeData> copied(copiedLayers(m_document.preset(), {2}));
        const Result<PresetReading> alone = layersOf(*copied, "");
        QVERIFY2(alone.ok(), alone ? "" : alone.error().text().c_str());
        QVERIFY(alone.value().preset.scene.layers[0].from.empty());
        removeLayers(m_document, {0});
        QVERIFY(from(0).isEmpty() && isWhole());
        renameLayer(m_document, 0, {});
        QVERIFY(from(1).isEmpty() && isWhole());
        setLayersParent(m_document, {1}, 0); // one without a name gets that which it is shown by
        QVERIFY(!from(1).isEmpty() && isWhole());
        while (m_document.undoStack()->canUndo()) {
            m_document.undoStack()->undo();
            QVERIFY(isWhole());
        }
    }

    void theButtonsInFrontOfANameLeaveTheChoiceAlone()
    {
        Solo solo(m_document);
        LayerList list(m_document, solo);
        list.show();
        LayerView& view = list.view();
        const auto click = [&](int row, LayerDelegate::Button button, Qt::KeyboardModifiers modifiers = {}) {
            const QRect place = LayerDelegate::placeOf(button, view.visualRect(view.model()->index(row, 0)));
            QTest::mouseClick(view.viewport(), Qt::LeftButton, modifiers, place.center());
        };
        click(2, LayerDelegate::Button::Solo);
        QCOMPARE(solo.layers(), LayerPlaces{2});
        click(1, LayerDelegate::Button::Eye, Qt::AltModifier);
        QCOMPARE(solo.layers(), LayerPlaces{1});
        click(1, LayerDelegate::Button::Eye, Qt::AltModifier);
        QVERIFY(!solo.isOn());
        QCOMPARE(m_document.layer(), std::size_t{0});
        QCOMPARE(m_document.undoStack()->count(), 0);
        click(1, LayerDelegate::Button::Eye);
        QVERIFY(!m_document.scene().layers[1].visible);
        QCOMPARE(m_document.undoStack()->count(), 1);
        QTest::keyClick(&view, Qt::Key_Space);
        QVERIFY(m_document.scene().layers[1].visible);
        // A layer alone has no solo: what stands there is its name.
        removeLayers(m_document, {1, 2});
        click(0, LayerDelegate::Button::Solo);
        QVERIFY(!solo.isOn());
    }
};

FUMAGE_TEST_MAIN(LayerListTest)
#include "layer_list_test.moc"
