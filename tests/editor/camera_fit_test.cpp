// The camera is moved once, as a view of its own, for the effect as it is when the search ends.
#include "editor_helpers.h"
#include "picture_helpers.h"

#include "ui/document/key_edits.h"
#include "ui/viewport/camera_fit.h"

#include "core/effect/known_parameter.h"
#include "core/export/fit_camera.h"

#include <QSignalSpy>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kPatienceMs = 60000;

Effect shortEffect()
{
    Effect effect = smallEffect();
    effect.timeline.length = 20;
    effect.camera.distance = 1.0F;
    return effect;
}

Preset presetOf(const Effect& effect)
{
    Preset preset;
    preset.scene = effect;
    return preset;
}

Camera fitted(const Effect& effect)
{
    return fitCamera(effect, {0, effect.timeline.length - 1, 1}).value();
}

} // namespace

class CameraFitTest : public QObject {
    Q_OBJECT

private slots:
    void theCameraIsMovedInOneView()
    {
        Document document;
        document.load(presetOf(shortEffect()), {});
        const Effect before = document.effect();
        CameraFit fit(document);
        QSignalSpy ended(&fit, &CameraFit::ended);
        QSignalSpy news(&fit, &CameraFit::news);
        fit.start();
        QVERIFY(fit.isRunning());
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatienceMs);
        QVERIFY(!fit.isRunning());
        QVERIFY(document.effect().camera == fitted(before));
        QVERIFY(document.effect().camera != before.camera);
        QVERIFY(news.size() > 2);
        QVERIFY(!document.undoStack()->canUndo());
        document.previousView();
        QVERIFY(document.effect() == before);
    }

    void aChangeMeanwhileIsFittedToo()
    {
        Document document;
        document.load(presetOf(shortEffect()), {});
        CameraFit fit(document);
        QSignalSpy ended(&fit, &CameraFit::ended);
        fit.start();
        document.edit(knownParameter("camera.yaw"), 90.0F);
        document.edit(knownParameter("look.size"), 0.7F);
        const Effect wanted = document.effect();
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatienceMs);
        QVERIFY(document.effect().camera == fitted(wanted));
        QCOMPARE(document.effect().camera.yaw, 90.0F);
    }

    void whatChangesOverTimeIsFittedWhileItPlays()
    {
        Document document;
        document.load(presetOf(shortEffect()), {});
        addKey(document, knownParameter("glow.emission"));
        CameraFit fit(document);
        QSignalSpy ended(&fit, &CameraFit::ended);
        QTimer frames;
        int frame = 0;
        connect(&frames, &QTimer::timeout, &document, [&] { document.setSeconds(++frame / 30.0); });
        frames.start(0);
        fit.start();
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatienceMs);
        QVERIFY(frame > 1);
        QVERIFY(document.effect().camera == fitted(shortEffect()));
    }

    void outliersMayBeLeftOutside()
    {
        Document document;
        document.load(presetOf(shortEffect()), {});
        CameraFit fit(document);
        QSignalSpy ended(&fit, &CameraFit::ended);
        QSignalSpy news(&fit, &CameraFit::news);
        fit.start(2.0F);
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatienceMs);
        const Effect effect = shortEffect();
        const FrameRange all{0, effect.timeline.length - 1, 1};
        QVERIFY(document.effect().camera == fitCamera(effect, all, 2.0F).value());
        QVERIFY(document.effect().camera.distance < fitted(effect).distance);
        QVERIFY(news.last().first().toString().contains(u"outliers"_q));
    }

    void anotherDocumentKeepsItsCamera()
    {
        Document document;
        document.load(presetOf(shortEffect()), {});
        CameraFit fit(document);
        QSignalSpy ended(&fit, &CameraFit::ended);
        fit.start();
        Effect other = shortEffect();
        other.camera.distance = 7.0F;
        document.load(presetOf(other), {});
        QCOMPARE(ended.size(), 1);
        QVERIFY(!fit.isRunning());
        QVERIFY(document.effect() == other);
    }

    void whereNothingIsToBeSeenTheCameraStays()
    {
        Effect effect = shortEffect();
        effect.look.opacity = 0.0F;
        Document document;
        document.load(presetOf(effect), {});
        CameraFit fit(document);
        QSignalSpy ended(&fit, &CameraFit::ended);
        QSignalSpy news(&fit, &CameraFit::news);
        fit.start();
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatienceMs);
        QVERIFY(document.effect() == effect);
        QVERIFY(news.last().first().toString().contains(u"smoke"_q));
    }

    void itEndsWithItsOwner()
    {
        Document document;
        Effect effect = shortEffect();
        effect.emitter.count = 200000;
        document.load(presetOf(effect), {});
        CameraFit(document).start();
        QVERIFY(document.effect() == effect);
    }
};

QTEST_MAIN(CameraFitTest)
#include "camera_fit_test.moc"
