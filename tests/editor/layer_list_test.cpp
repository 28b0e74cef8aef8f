#include "editor_helpers.h"

#include "ui/document/layer_edits.h"
#include "ui/panels/layer_list.h"

#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"

#include <QListView>
#include <QMimeData>
#include <QToolButton>

using namespace fumage;
using namespace fumage::tests;

namespace {

QStringList names(const Document& document)
{
    QStringList all;
    for (std::size_t i = 0; i < document.scene().layers.size(); ++i) {
        all += layerLabel(document.scene(), i);
    }
    return all;
}

} // namespace

class LayerListTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        Preset preset;
        for (const char* name : {"flames", "smoke", "embers"}) {
            Layer layer;
            layer.name = name;
            layer.emitter.seed = static_cast<std::uint32_t>(preset.scene.layers.size());
            preset.scene.layers.push_back(layer);
        }
        preset.scene.layers.erase(preset.scene.layers.begin());
        m_document.load(preset, {});
    }

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
    }
    void eachChangeIsAStep()
    {
        QFETCH(int, change);
        QFETCH(QStringList, expected);
        QFETCH(int, edited);
        const Scene before = m_document.scene();
        Scene other;
        other.layers.resize(2);
        other.layers[0].name = "smoke";
        other.layers[1].name = "ash";
        switch (change) {
        case 0: addLayer(m_document); break;
        case 1: duplicateLayer(m_document, 1); break;
        case 2: removeLayer(m_document, 1); break;
        case 3: moveLayer(m_document, 0, 2); break;
        case 4: renameLayer(m_document, 1, u" steam "_q); break;
        case 5: setLayerVisible(m_document, 1, false); break;
        case 6: setLayerLocked(m_document, 1, true); break;
        case 7: setLayerTag(m_document, 1, ColourTag::Green); break;
        default: addLayersOf(m_document, other, u"other"_q);
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
        setLayerLocked(m_document, 0, true);
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
        removeLayer(m_document, 0);
        removeLayer(m_document, 0);
        removeLayer(m_document, 0);
        QCOMPARE(names(m_document), QStringList{u"embers"_q});
    }

    void noMoreThanThereMayBe()
    {
        for (std::size_t i = 0; i < 2 * kMaxLayers; ++i) {
            addLayer(m_document);
            duplicateLayer(m_document, 0);
        }
        QCOMPARE(m_document.scene().layers.size(), kMaxLayers);
    }

    void theListShowsAndChangesThem()
    {
        LayerList list(m_document);
        list.show();
        auto& view = *list.findChild<QListView*>(u"layers"_q);
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
        list.findChild<QToolButton*>(u"layers.add"_q)->click();
        QCOMPARE(model.rowCount(), 4);
        list.findChild<QToolButton*>(u"layers.delete"_q)->click();
        QCOMPARE(model.rowCount(), 3);
    }

    void filesHaveAllOfThem()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"scene.json"_q);
        setLayerVisible(m_document, 1, false);
        QVERIFY(m_document.save(path).ok());
        QVERIFY(readPresetFile(path.toStdString()).value().preset.scene == m_document.scene());
        m_document.selectLayer(2);
        Document other;
        other.load(readPresetFile(path.toStdString()).value().preset, path);
        QCOMPARE(names(other), names(m_document));
    }

private:
    Document m_document;
};

FUMAGE_TEST_MAIN(LayerListTest)
#include "layer_list_test.moc"
