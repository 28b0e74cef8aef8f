// Layers by the clipboard and by drops, within a document and between two.
#include "layers_fixture.h"

#include "ui/document/layer_edits.h"
#include "ui/panels/paste_dialog.h"

#include "core/effect/known_parameter.h"
#include "core/preset/preset_file.h"

#include <QCheckBox>
#include <QClipboard>
#include <QMimeData>

using namespace fumage;
using namespace fumage::tests;

class LayerTransferTest : public LayersFixture {
    Q_OBJECT

private slots:
    /// The text is a preset, which anything that reads presets takes.
    void layersAreCopiedAsTheTextOfAPreset()
    {
        Solo solo(m_document);
        LayerList list(m_document, solo);
        const Scene before = m_document.scene();
        list.transfer().copy({0, 2});
        const Result<PresetReading> reading = parsePreset(QApplication::clipboard()->text().toStdString());
        QVERIFY(reading.ok() && reading.value().warnings.empty());
        QCOMPARE(reading.value().preset.scene.layers.size(), std::size_t{2});
        QVERIFY(reading.value().preset.scene.layers[0] == before.layers[0]);
        QVERIFY(reading.value().preset.scene.layers[1] == before.layers[2]);
        QVERIFY(m_document.scene() == before);
        // In another document, or in this one once more.
        m_document.selectLayer(1);
        list.transfer().paste();
        QCOMPARE(names(m_document), (QStringList{u"flames"_q, u"smoke"_q, u"flames 2"_q, u"embers 2"_q, u"embers"_q}));
        QCOMPARE(m_document.selection().all(), (LayerPlaces{2, 3}));
        QCOMPARE(m_document.undoStack()->count(), 1);
        list.transfer().cut({2, 3});
        QVERIFY(m_document.undoStack()->undoText().startsWith(u"Cut"_q));
        QVERIFY(m_document.scene() == before);
    }

    void textThatIsNoLayerIsSaidAndChangesNothing_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("words") << u"nothing of the kind"_q;
        QTest::newRow("other JSON") << u"{\"layers\": []}"_q;
        QTest::newRow("half of it") << u"{\"format\": \"fumage-preset\", \"version\": 2, \"layers\": [{"_q;
        QTest::newRow("too much") << QString(2 << 20, u'x');
    }
    void textThatIsNoLayerIsSaidAndChangesNothing()
    {
        QFETCH(QString, text);
        Solo solo(m_document);
        LayerList list(m_document, solo);
        QSignalSpy failed(&list.transfer(), &LayerTransfer::refused);
        const Scene before = m_document.scene();
        QApplication::clipboard()->setText(text);
        list.transfer().paste();
        list.transfer().pasteParameters({0});
        QCOMPARE(failed.size(), 2);
        QVERIFY(m_document.scene() == before);
        QCOMPARE(m_document.undoStack()->count(), 0);
    }

    /// Of newer versions, and of others: what is not known here goes with its layer wherever that goes.
    void whatIsUnknownOfLayersIsPastedAndDuplicatedWithThem()
    {
        std::string text = formatPreset(m_document.preset());
        text.insert(text.find("\"name\": \"smoke\""), "\"flavour\": \"vanilla\", ");
        m_document.load(parsePreset(text).value().preset, {});
        const auto owners = [](const Document& document) { // as a file would say
            const Preset saved = parsePreset(formatPreset(document.preset())).value().preset;
            QStringList all;
            for (const UnknownMember& member : saved.unknown) {
                all += toQString(saved.scene.layers[member.layer].name);
            }
            return all;
        };
        QCOMPARE(owners(m_document), QStringList{u"smoke"_q});
        Solo solo(m_document);
        LayerList list(m_document, solo);
        list.transfer().copy({0, 1});
        list.transfer().paste();
        QCOMPARE(names(m_document), (QStringList{u"flames"_q, u"flames 2"_q, u"smoke 2"_q, u"smoke"_q, u"embers"_q}));
        QCOMPARE(owners(m_document), (QStringList{u"smoke 2"_q, u"smoke"_q}));
        m_document.undoStack()->undo();
        QCOMPARE(owners(m_document), QStringList{u"smoke"_q});
        m_document.undoStack()->redo();
        QCOMPARE(owners(m_document), (QStringList{u"smoke 2"_q, u"smoke"_q}));
        duplicateLayers(m_document, {0, 3});
        QCOMPARE(owners(m_document), (QStringList{u"smoke 2"_q, u"smoke"_q, u"smoke 3"_q}));
        m_document.undoStack()->undo();
        // What is cut and pasted says it once.
        list.transfer().cut({3});
        QCOMPARE(owners(m_document), QStringList{u"smoke 2"_q});
        list.transfer().paste();
        QCOMPARE(owners(m_document).count(u"smoke"_q), 1);
        QCOMPARE(owners(m_document).size(), 2);
        // And into another document.
        Document other;
        Solo otherSolo(other);
        LayerList(other, otherSolo).transfer().paste();
        QCOMPARE(owners(other), QStringList{u"smoke"_q});
    }

    void noMoreIsPastedThanThereMayBe()
    {
        Solo solo(m_document);
        LayerList list(m_document, solo);
        QSignalSpy said(&list.transfer(), &LayerTransfer::news);
        while (m_document.scene().layers.size() + 2 <= kMaxLayers) {
            list.transfer().copy({0, 1});
            list.transfer().paste();
        }
        QCOMPARE(said.size(), 0);
        list.transfer().copy({0, 1, 2});
        list.transfer().paste();
        QCOMPARE(m_document.scene().layers.size(), kMaxLayers);
        QCOMPARE(said.size(), 1);
        QVERIFY(said[0][0].toString().contains(u"2 were left out"_q));
    }

    void parametersOfGroupsArePastedToAllThatAreChosen()
    {
        Solo solo(m_document);
        LayerList list(m_document, solo);
        m_document.edit(knownParameter("motion.gravity"), 4.0F);
        m_document.edit(knownParameter("look.size"), 0.7F);
        m_document.edit(knownParameter("emitter.speed"), 3.0F);
        list.transfer().copy({0});
        setLayersLocked(m_document, {2}, true);
        const Scene before = m_document.scene();
        m_document.selectLayers({1, {2}});
        list.transfer().pasteParameters({1, 2});
        auto* dialog = list.findChild<PasteDialog*>();
        QVERIFY(dialog != nullptr);
        QCOMPARE(dialog->groups(), layerGroups());
        for (const std::string_view group : layerGroups()) {
            dialog->findChild<QCheckBox*>(u"paste."_q + toQString(group))
                ->setChecked(group == "motion" || group == "emitter");
        }
        dialog->accept();
        const Scene& after = m_document.scene();
        QCOMPARE(after.layers[1].motion.gravity, 4.0F);
        QCOMPARE(after.layers[1].emitter.speed, 3.0F);
        QCOMPARE(after.layers[1].emitter.seed, before.layers[1].emitter.seed); // or both would move alike
        QCOMPARE(after.layers[1].look.size, before.layers[1].look.size);
        QVERIFY(after.layers[2] == before.layers[2]); // it is locked
        QVERIFY(after.layers[0] == before.layers[0]);
        m_document.undoStack()->undo();
        QVERIFY(m_document.scene() == before);
        // What was chosen is offered again.
        QTRY_VERIFY(list.findChild<PasteDialog*>() == nullptr);
        list.transfer().pasteParameters({1});
        QCOMPARE(list.findChild<PasteDialog*>()->groups(), (std::vector<std::string_view>{"emitter", "motion"}));
        list.findChild<PasteDialog*>()->reject();
        QVERIFY(m_document.scene() == before);
    }

    void rowsAreMovedAndThoseOfAnotherWindowAdded()
    {
        Solo solo(m_document);
        LayerList list(m_document, solo);
        QAbstractItemModel& model = *list.view().model();
        const std::unique_ptr<QMimeData> own(model.mimeData({model.index(2, 0), model.index(0, 0)}));
        QVERIFY(!own->hasText()); // a field would take it
        model.dropMimeData(own.get(), Qt::MoveAction, 1, 0, {});
        QCOMPARE(names(m_document), (QStringList{u"flames"_q, u"embers"_q, u"smoke"_q}));
        Document second;
        second.load(m_document.preset(), {});
        Solo otherSolo(second);
        LayerList other(second, otherSolo);
        QVERIFY(other.view().model()->canDropMimeData(own.get(), Qt::CopyAction, 1, 0, {}));
        other.view().model()->dropMimeData(own.get(), Qt::CopyAction, 1, 0, {});
        QTRY_COMPARE(names(second), (QStringList{u"flames"_q, u"flames 2"_q, u"embers 2"_q, u"embers"_q, u"smoke"_q}));
        QCOMPARE(second.undoStack()->count(), 1);
    }

    void filesAreAddedWhereTheyAreDropped()
    {
        const QTemporaryDir folder;
        Preset preset;
        preset.scene.layers.resize(2);
        preset.scene.layers[1].name = "ash";
        QVERIFY(writePresetFile((folder.path() + u"/dust.json"_q).toStdString(), preset).ok());
        Solo solo(m_document);
        LayerList list(m_document, solo);
        QSignalSpy failed(&list.transfer(), &LayerTransfer::refused);
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(folder.filePath(u"dust.json"_q)),
            QUrl::fromLocalFile(folder.filePath(u"nowhere.json"_q))});
        QVERIFY(list.view().model()->dropMimeData(&data, Qt::CopyAction, 1, 0, {}));
        QTRY_COMPARE(names(m_document), (QStringList{u"flames"_q, u"dust"_q, u"ash"_q, u"smoke"_q, u"embers"_q}));
        QCOMPARE(m_document.undoStack()->count(), 1);
        QCOMPARE(failed.size(), 1);
    }
};

FUMAGE_TEST_MAIN(LayerTransferTest)
#include "layer_transfer_test.moc"
