#include "editor_helpers.h"

#include "tests/parameter_rows.h"

#include "ui/document/document.h"
#include "ui/document/layer_clipboard.h"
#include "ui/document/layer_edits.h"

#include "core/effect/known_parameter.h"
#include "core/effect/value.h"
#include "core/effect/variation.h"
#include "core/preset/library.h"
#include "core/preset/preset_file.h"

using namespace fumage;
using namespace fumage::tests;

namespace {

EffectChange changeOf(const QList<QVariant>& arguments)
{
    return arguments[0].value<EffectChange>();
}

QStringList keysOf(const EffectChange& change)
{
    QStringList keys;
    for (const Parameter* parameter : change.parameters) {
        keys += toQString(parameter->key);
    }
    return keys;
}

} // namespace

class DocumentTest : public QObject {
    Q_OBJECT

private slots:
    void unsavedWorkOfAFileCanBeUndone()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"mine.json"_q);
        Preset saved;
        saved.scene.layers[0].motion.gravity = 1.0F;
        QVERIFY(writePresetFile(path.toStdString(), saved).ok());
        Preset work = saved;
        work.scene.layers[0].motion.gravity = 6.5F;
        Document document;
        document.loadUnsaved(work, path);
        QCOMPARE(document.effect().motion.gravity, 6.5F);
        QVERIFY(document.isModified());
        QCOMPARE(document.filePath(), path);
        document.undoStack()->undo();
        QCOMPARE(document.effect().motion.gravity, 1.0F);
        QVERIFY(!document.isModified());
        // Without its file there is nothing to go back to.
        document.loadUnsaved(work, folder.filePath(u"gone.json"_q));
        QVERIFY(document.isModified());
        QCOMPARE(document.undoStack()->count(), 0);
    }

    void historyTellsTheNewValue()
    {
        Document document;
        const auto last = [&] { return document.undoStack()->text(document.undoStack()->count() - 1); };
        const Gesture drag = document.beginGesture();
        document.edit(knownParameter("motion.gravity"), 2.0F, drag);
        document.edit(knownParameter("motion.gravity"), 3.5F, drag);
        QCOMPARE(document.undoStack()->count(), 1);
        QCOMPARE(last(), u"Motion: Gravity 3.5 m/s\u00b2"_q);
        document.edit(knownParameter("timeline.loop"), true);
        QVERIFY(last().endsWith(u" on"_q));
        document.edit(knownParameter("camera.mode"), static_cast<int>(CameraMode::Fixed));
        QVERIFY(last().endsWith(u" Fixed"_q));
        document.edit(knownParameter("camera.target"), glm::vec3(1.0F, 2.0F, 0.5F));
        QVERIFY(last().endsWith(u" 1, 2, 0.5"_q));
        document.edit(knownParameter("look.colour"), glm::vec3(0.1F));
        QCOMPARE(last(), u"Look: Colour #595959"_q);
        document.reset(knownParameter("look.colour"));
        QCOMPARE(last(), u"Reset Look: Colour"_q);
    }

    void aDragIsOneUndoStep()
    {
        Document document;
        const Parameter& gravity = knownParameter("motion.gravity");
        const Gesture gesture = document.beginGesture();
        for (int i = 1; i <= 20; ++i) {
            document.edit(gravity, static_cast<float>(i), gesture);
        }
        QCOMPARE(document.undoStack()->count(), 1);
        QCOMPARE(document.effect().motion.gravity, 20.0F);
        document.undoStack()->undo();
        QCOMPARE(document.effect().motion.gravity, Effect().motion.gravity);
        document.undoStack()->redo();
        QCOMPARE(document.effect().motion.gravity, 20.0F);
    }

    void twoDragsAreTwoUndoSteps()
    {
        Document document;
        const Parameter& gravity = knownParameter("motion.gravity");
        document.edit(gravity, 1.0F, document.beginGesture());
        document.edit(gravity, 2.0F, document.beginGesture());
        QCOMPARE(document.undoStack()->count(), 2);
    }

    void aDragBackToWhereItBeganLeavesNoTrace()
    {
        Document document;
        const Parameter& gravity = knownParameter("motion.gravity");
        const Gesture gesture = document.beginGesture();
        document.edit(gravity, 3.0F, gesture);
        document.edit(gravity, Effect().motion.gravity, gesture);
        QCOMPARE(document.undoStack()->count(), 0);
        QVERIFY(!document.isModified());
    }

    void anEditThatChangesNothingIsNoStep()
    {
        Document document;
        QSignalSpy changes(&document, &Document::effectChanged);
        document.edit(knownParameter("motion.gravity"), Effect().motion.gravity);
        QCOMPARE(document.undoStack()->count(), 0);
        QCOMPARE(changes.size(), 0);
    }

    void valuesAreClampedToTheirHardRange()
    {
        Document document;
        document.edit(knownParameter("noise.octaves"), 99);
        QCOMPARE(document.effect().noise.octaves, static_cast<int>(knownParameter("noise.octaves").hard.high));
    }

    void severalParametersInOneGestureAreOneStep()
    {
        Document document;
        const Gesture gesture = document.beginGesture();
        document.edit(
            {{&knownParameter("camera.yaw"), 10.0F}, {&knownParameter("camera.pitch"), 20.0F}}, u"Orbit"_q, gesture);
        document.edit(
            {{&knownParameter("camera.yaw"), 15.0F}, {&knownParameter("camera.distance"), 9.0F}}, u"Orbit"_q, gesture);
        QCOMPARE(document.undoStack()->count(), 1);
        document.undoStack()->undo();
        QVERIFY(document.effect() == Effect());
    }

    void aChangeSaysWhichParametersItTouchedAndFromWhereOnTheWorkIsStale()
    {
        Document document;
        QSignalSpy changes(&document, &Document::effectChanged);
        document.edit(knownParameter("look.opacity"), 5.0F);
        document.edit(knownParameter("noise.sharpness"), 5.0F);
        document.edit(knownParameter("wind.strength"), 5.0F);
        QCOMPARE(changes.size(), 3);
        QCOMPARE(changeOf(changes[0]).stale, DirtyStage::Shade);
        QCOMPARE(changeOf(changes[1]).stale, DirtyStage::Noise);
        QCOMPARE(changeOf(changes[2]).stale, DirtyStage::Air);
        QCOMPARE(keysOf(changeOf(changes[2])), QStringList{u"wind.strength"_q});
    }

    void whatALayerIsBornOnMakesWorkStale()
    {
        Document document;
        addLayer(document);
        document.selectLayer(0);
        setLayersVisible(document, {0}, false);
        QSignalSpy changes(&document, &Document::effectChanged);
        const auto stale = [&] { return changeOf(changes.back()).stale; };
        document.edit(knownParameter("motion.gravity"), 3.0F);
        QCOMPARE(stale(), DirtyStage::Shade); // nobody sees it
        setLayersParent(document, {1}, 0);
        QCOMPARE(stale(), DirtyStage::Air);
        document.selectLayer(0);
        document.edit(knownParameter("motion.gravity"), 4.0F);
        QCOMPARE(stale(), DirtyStage::Simulate); // others are born on it
        setLayersParent(document, {1}, std::nullopt);
        QCOMPARE(stale(), DirtyStage::Air);
    }

    void undoAndRedoSayTheSameAsTheEdit()
    {
        Document document;
        document.edit({{findParameter("look.opacity"), 5.0F}, {findParameter("wind.strength"), 5.0F}}, u"Both"_q);
        Effect other = document.effect();
        other.motion.gravity = 4.0F;
        document.replaceEffect(other, u"Replace"_q);
        QSignalSpy changes(&document, &Document::effectChanged);
        document.undoStack()->undo();
        document.undoStack()->undo();
        document.undoStack()->redo();
        QCOMPARE(changes.size(), 3);
        QCOMPARE(keysOf(changeOf(changes[0])), QStringList{u"motion.gravity"_q});
        for (const int i : {1, 2}) {
            QCOMPARE(keysOf(changeOf(changes[i])), QStringList({u"look.opacity"_q, u"wind.strength"_q}));
            QCOMPARE(changeOf(changes[i]).stale, DirtyStage::Air);
        }
    }

    void loadingChangesEveryParameter()
    {
        Document document;
        QSignalSpy changes(&document, &Document::effectChanged);
        document.load(Preset(), {});
        QCOMPARE(changes.size(), 1);
        QCOMPARE(changeOf(changes[0]).parameters.size(), parameterTable().size());
    }

    void resetGoesBackToThePreset()
    {
        Document document;
        Preset preset;
        preset.scene.layers[0].motion.gravity = 4.0F;
        document.load(preset, {});
        document.edit(knownParameter("motion.gravity"), 7.0F);
        document.reset(knownParameter("motion.gravity"));
        QCOMPARE(document.effect().motion.gravity, 4.0F);
        QCOMPARE(document.undoStack()->count(), 2);
    }

    void savingMakesTheDocumentClean()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(u"smoke.json"_q);
        Document document;
        document.edit(knownParameter("motion.gravity"), 7.0F);
        QVERIFY(document.isModified());
        QVERIFY(document.save(path).ok());
        QVERIFY(!document.isModified());
        QCOMPARE(document.displayName(), u"smoke"_q);
        const Result<PresetReading> reading = readPresetFile(path.toStdString());
        QVERIFY(reading.ok());
        QVERIFY(reading.value().preset.scene.effect() == document.effect());
        document.undoStack()->undo();
        QVERIFY(document.isModified());
    }

    void savingWhereItCannotBeSavedChangesNothing()
    {
        Document document;
        document.edit(knownParameter("motion.gravity"), 7.0F);
        const Status status = document.save(u"/nowhere/at/all/smoke.json"_q);
        QVERIFY(!status.ok());
        QVERIFY(toQString(status.error().text()).contains(u"/nowhere/at/all"_q));
        QVERIFY(document.isModified());
        QVERIFY(document.filePath().isEmpty());
    }

    void unknownMembersOfAFileAreKept()
    {
        QTemporaryDir folder;
        const std::string json = formatPreset(Preset());
        std::string more = json;
        more.insert(more.find("\"emitter\""), "\"flavour\": \"vanilla\",\n  ");
        const Result<PresetReading> reading = parsePreset(more);
        QVERIFY(reading.ok());
        Document document;
        document.load(reading.value().preset, {});
        QVERIFY(document.save(folder.filePath(u"a.json"_q)).ok());
        QFile file(folder.filePath(u"a.json"_q));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\"flavour\": \"vanilla\""));
    }

    void whatIsUnknownGoesWithItsLayer()
    {
        Preset preset;
        preset.scene.layers.resize(3);
        for (std::size_t i = 0; i < 3; ++i) {
            preset.scene.layers[i].name = std::string(1, "abc"[i]);
            preset.scene.layers[i].emitter.seed = static_cast<std::uint32_t>(i) + 1;
        }
        std::string more = formatPreset(preset);
        more.insert(more.find("\"name\": \"b\""), "\"flavour\": \"vanilla\", ");
        Document document;
        document.load(parsePreset(more).value().preset, {});
        const auto owner = [&] { // as a file would say
            const Preset saved = parsePreset(formatPreset(document.preset())).value().preset;
            return saved.unknown.empty() ? std::string("none") : saved.scene.layers[saved.unknown[0].layer].name;
        };
        QCOMPARE(owner(), std::string("b"));
        moveLayers(document, {0}, 3); // b, c, a
        QCOMPARE(owner(), std::string("b"));
        removeLayers(document, {2});
        QCOMPARE(owner(), std::string("b"));
        removeLayers(document, {0});
        QCOMPARE(owner(), std::string("none"));
        addLayer(document);
        QCOMPARE(owner(), std::string("none"));
        document.undoStack()->undo();
        document.undoStack()->undo();
        QCOMPARE(owner(), std::string("b"));
        renameLayer(document, 0, u"other"_q);
        QCOMPARE(owner(), std::string("other"));
        document.undoStack()->setIndex(0);
        QCOMPARE(owner(), std::string("b"));
    }

    void pastedParametersHaveTheKeyFramesThatTheyHadThere()
    {
        const Parameter& emission = knownParameter("glow.emission");
        Preset preset;
        preset.scene.layers.resize(2);
        preset.scene.layers[0].tracks.set({&emission, {{0.0, 1.0F}, {1.0, 2.0F}}});
        preset.scene.layers[1].tracks.set({&knownParameter("motion.gravity"), {{0.0, 1.0F}, {1.0, 2.0F}}});
        preset.scene.layers[1].tracks.set({&knownParameter("look.size"), {{0.0, 0.1F}, {1.0, 0.2F}}});
        Document document;
        document.load(preset, {});
        pasteGroups(document, {1}, preset.scene.layers[0], {"glow", "motion"}, u"a"_q);
        const Tracks& tracks = document.scene().layers[1].tracks;
        QVERIFY(tracks.find(emission) != nullptr);
        QVERIFY(*tracks.find(emission) == *preset.scene.layers[0].tracks.find(emission));
        QVERIFY(tracks.find(knownParameter("motion.gravity")) == nullptr); // it would hide what was pasted
        QVERIFY(tracks.find(knownParameter("look.size")) != nullptr); // is of another group
        document.undoStack()->undo();
        QVERIFY(document.scene() == preset.scene);
    }

    void everyParameterSurvivesEditUndoAndRedo_data() { addParameterRows(); }
    void everyParameterSurvivesEditUndoAndRedo()
    {
        QFETCH(QString, key);
        const Parameter& parameter = *findParameter(key.toStdString());
        // Another value of the same parameter from among the built-in presets, or from a variation.
        Effect other = vary(Effect(), 0.3F, 5, [](const Parameter&) { return true; });
        for (const LibraryEntry& entry : builtinPresets()) {
            const Effect effect = loadPreset(entry).value().preset.scene.effect();
            if (!(parameter.get(effect) == parameter.get(Effect()))) {
                other = effect;
            }
        }
        Document document;
        document.edit(parameter, parameter.get(other));
        QVERIFY(parameter.get(document.effect()) == clampValue(parameter, parameter.get(other)).value);
        while (document.undoStack()->canUndo()) {
            document.undoStack()->undo();
        }
        QVERIFY(document.effect() == Effect());
        while (document.undoStack()->canRedo()) {
            document.undoStack()->redo();
        }
        QVERIFY(parameter.get(document.effect()) == parameter.get(other));
    }

    void documentNamesMakeFileNames()
    {
        QCOMPARE(fileNameOf(u"Smoke 2"_q), u"Smoke 2"_q);
        QCOMPARE(fileNameOf(u"../../etc/passwd"_q), u"-.-..-etc-passwd"_q);
        QCOMPARE(fileNameOf(u"a\nb"_q), u"a-b"_q);
        QVERIFY(fileNameOf(QString(100000, QChar(0x6c34))).toUtf8().size() < 250);
    }
};

FUMAGE_TEST_MAIN(DocumentTest)
#include "document_test.moc"
