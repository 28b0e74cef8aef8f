#include "editor_helpers.h"

#include "ui/document/layer_edits.h"
#include "ui/panels/layer_list.h"

#include "core/effect/known_parameter.h"
#include "core/preset/library.h"
#include "core/scene/scene.h"
#include "core/simulation/scene_simulator.h"

#include <QMenu>
#include <QToolButton>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr const Parameter& kPosition = knownParameter("emitter.position");

Track wayFrom(const glm::vec3& place)
{
    return Track{&kPosition, {{0.0, place}, {1.0, place + glm::vec3(1.0F, 0.0F, 0.0F)}}};
}

} // namespace

class LayerTemplatesTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        Preset preset;
        preset.scene.layers[0].emitter.position = kPlace;
        m_document.load(preset, {});
    }

    void eachAddsWhatIsSeenInOneStep_data() { templates(); }
    void eachAddsWhatIsSeenInOneStep()
    {
        QFETCH(int, row);
        const LayerTemplate from = layerTemplates()[static_cast<std::size_t>(row)];
        LayerList list(m_document, m_solo);
        actionOf(list, from).trigger();
        const Scene scene = m_document.scene();
        QCOMPARE(scene.layers.size(), from.layers.size() + 1);
        QCOMPARE(m_document.undoStack()->count(), 1);
        QCOMPARE(m_document.selection().all().size(), from.layers.size());
        for (std::size_t i = 1; i < scene.layers.size(); ++i) {
            QVERIFY(scene.layers[i].visible && !scene.layers[i].name.empty());
            QVERIFY2(isBorn(scene, i), scene.layers[i].name.c_str());
        }
        if (from.layers.size() == 1) {
            QCOMPARE(layerLabel(scene, 1), from.name);
        }
        m_document.undoStack()->undo();
        QCOMPARE(m_document.scene().layers.size(), std::size_t{1});
    }

    void eachStandsToTheEmitterAsInItsPreset_data() { templates(); }
    void eachStandsToTheEmitterAsInItsPreset()
    {
        QFETCH(int, row);
        const LayerTemplate from = layerTemplates()[static_cast<std::size_t>(row)];
        const Scene source = loadPreset(std::string(from.preset)).value().preset.scene;
        const Scene added = layersOf(from, m_document).value().preset.scene;
        for (std::size_t i = 0; i < from.layers.size(); ++i) {
            const auto there = std::find_if(source.layers.begin(), source.layers.end(),
                [&](const Layer& layer) { return layer.name == from.layers[i]; });
            QVERIFY2(there != source.layers.end(), from.layers[i]);
            const glm::vec3 expected = there->emitter.position - source.layers.front().emitter.position + kPlace;
            QVERIFY(glm::length(added.layers[i].emitter.position - expected) < 1e-6F);
            QCOMPARE(parentOf(added, i).has_value(),
                parentOf(source, static_cast<std::size_t>(there - source.layers.begin())).has_value());
        }
    }

    void eachGoesTheWayOfTheEmitter_data() { templates(); }
    void eachGoesTheWayOfTheEmitter()
    {
        QFETCH(int, row);
        const LayerTemplate from = layerTemplates()[static_cast<std::size_t>(row)];
        Preset preset = m_document.preset();
        preset.scene.layers[0].tracks.set(wayFrom(kPlace));
        m_document.load(preset, {});
        const Scene added = layersOf(from, m_document).value().preset.scene;
        for (std::size_t i = 0; i < added.layers.size(); ++i) {
            const Track* way = added.layers[i].tracks.find(kPosition);
            QCOMPARE(way != nullptr, !parentOf(added, i).has_value());
            if (way != nullptr) {
                const glm::vec3 begin = std::get<glm::vec3>(way->at(0.0));
                QVERIFY(glm::length(begin - added.layers[i].emitter.position) < 1e-6F);
                QVERIFY(glm::length(std::get<glm::vec3>(way->at(1.0)) - begin - glm::vec3(1.0F, 0.0F, 0.0F)) < 1e-6F);
            }
        }
    }

    void theFirstOfTheMenuIsAPlainLayer()
    {
        LayerList list(m_document, m_solo);
        menuOf(list).actions().first()->trigger();
        QCOMPARE(m_document.scene().layers.size(), std::size_t{2});
        QVERIFY(m_document.scene().layers[1].look == Look());
        QVERIFY(m_document.scene().layers[1].emitter.position == kPlace);
    }

    /// As its number was the name that one saw.
    void theLayerThatWasAloneKeepsItsNameWhereItIsMoved()
    {
        LayerList list(m_document, m_solo);
        const QString alone = layerLabel(m_document.scene(), 0);
        for (QAction* action : {menuOf(list).actions().first(), menuOf(list).actions().last()}) {
            m_document.load(Preset(), {});
            action->trigger();
            moveLayers(m_document, {0}, 2);
            QCOMPARE(layerLabel(m_document.scene(), 1), alone);
            QVERIFY(layerLabel(m_document.scene(), 0) != alone);
        }
    }

    void whatDoesNotFitIsSaid()
    {
        Preset preset = m_document.preset();
        preset.scene.layers.resize(kMaxLayers - 1);
        m_document.load(preset, {});
        LayerList list(m_document, m_solo);
        QStringList said;
        connect(&list.transfer(), &LayerTransfer::news, this, [&](const QString& text) { said += text; });
        for (const LayerTemplate& from : layerTemplates()) {
            if (from.layers.size() > 1) {
                actionOf(list, from).trigger();
                break;
            }
        }
        QCOMPARE(m_document.scene().layers.size(), kMaxLayers);
        QCOMPARE(said.size(), 1);
        QVERIFY(!list.findChild<QToolButton*>(u"layers.add"_q)->isEnabled());
    }

private:
    static constexpr glm::vec3 kPlace{1.0F, 2.0F, -3.0F};

    static void templates()
    {
        QTest::addColumn<int>("row");
        int row = 0;
        for (const LayerTemplate& from : layerTemplates()) {
            QTest::newRow(from.name.toUtf8().constData()) << row++;
        }
    }

    static QMenu& menuOf(const LayerList& list) { return *list.findChild<QToolButton*>(u"layers.add"_q)->menu(); }

    static QAction& actionOf(const LayerList& list, const LayerTemplate& from)
    {
        const QList<QAction*> actions = menuOf(list).actions();
        return **std::find_if(
            actions.begin(), actions.end(), [&](const QAction* action) { return action->text() == from.name; });
    }

    /// Whether a layer of a scene has particles at some frame of its timeline.
    static bool isBorn(const Scene& scene, std::size_t layer)
    {
        SceneSimulator simulator(sampledLayers(scene));
        for (int frame = 0; frame < scene.timeline.length; frame += 8) {
            const Result<SceneFrame> drawn = simulator.frame(frame);
            if (!drawn) {
                return false;
            }
            const auto& births = drawn.value().layers[layer]->particles.birthStep;
            if (std::any_of(
                    births.begin(), births.end(), [](std::int32_t step) { return step != Particles::kUnborn; })) {
                return true;
            }
        }
        return false;
    }

    Document m_document;
    Solo m_solo{m_document};
};

FUMAGE_TEST_MAIN(LayerTemplatesTest)
#include "layer_templates_test.moc"
