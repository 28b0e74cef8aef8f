// What an export needs of the air is baked once, and not at all where it is there already.
#include "tests/helpers.h"

#include "core/export/plan.h"
#include "core/simulation/air_cache.h"

#include <QStandardPaths>
#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kFrames = 12;

Effect carriedSmoke()
{
    Effect effect;
    effect.emitter.count = 300;
    effect.timeline.length = kFrames;
    effect.output.width = effect.output.height = 32;
    effect.air.enabled = true;
    effect.air.resolution = 16;
    return effect;
}

/// What was heard of baking.
struct Baking {
    bool wasHeard = false;
    int looks = 0; ///< at frames, of a fit or a trim
    int looksAtLast = 0; ///< when it was heard last

    [[nodiscard]] Progress listener()
    {
        return [this](ProgressPhase work, int /*done*/, int /*total*/) {
            if (work == ProgressPhase::Fitting) {
                ++looks;
            } else if (work == ProgressPhase::Air) {
                wasHeard = true;
                looksAtLast = looks;
            }
        };
    }
};

} // namespace

class SharedAirTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }

    void allThatNeedsAirTakesWhatIsBaked_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("output");
        const auto add = [](const char* name, ExportKind kind, const char* output) {
            QTest::newRow(name) << static_cast<int>(kind) << QString::fromUtf8(output);
        };
        add("pictures", ExportKind::Sequence, "f_##.png");
        add("passes", ExportKind::Sequence, "p_##.exr");
        add("a picture", ExportKind::Picture, "a.png");
        add("a flipbook", ExportKind::Flipbook, "b.png");
        add("particles", ExportKind::Particles, "p_##.csv");
        add("volumes", ExportKind::Volumes, "v_##.vdb");
        add("the air itself", ExportKind::Air, "a_##.fga");
        add("a video", ExportKind::Video, "v.mp4");
    }
    void allThatNeedsAirTakesWhatIsBaked()
    {
        QFETCH(int, kind);
        QFETCH(QString, output);
        ExportPlan plan;
        plan.kind = static_cast<ExportKind>(kind);
        plan.output = m_folder.filePath(output).toStdString();
        plan.frames = {0, kFrames - 1, 1};
        plan.fitCamera = true;
        plan.flipbook.trim = true;
        plan.flipbook.columns = plan.flipbook.rows = 2;
        if (output.endsWith(u".exr"_qs)) {
            plan.format = ImageFormat::ExrHalf;
            plan.passes = {Pass::Colour, Pass::Normal};
        }

        if (plan.kind == ExportKind::Video && QStandardPaths::findExecutable(u"ffmpeg"_qs).isEmpty()) {
            QSKIP("ffmpeg is not installed");
        }

        Baking alone;
        const auto first = runExport(carriedSmoke(), plan, alone.listener());
        QVERIFY2(first.ok(), first.ok() ? "" : first.error().text().c_str());
        QVERIFY(alone.wasHeard);
        QVERIFY(alone.looksAtLast < kFrames); // once all frames were seen, all is baked

        const auto shelf = std::make_shared<AirCache>();
        const SampledEffect smoke = sampled(carriedSmoke());
        const std::shared_ptr<BakedAir> air = shelf->airOf(smoke);
        QVERIFY(air->bake(1000).ok());
        Baking shared;
        const auto done = runExport(carriedSmoke(), plan, {shared.listener(), shelf});
        QVERIFY2(done.ok(), done.ok() ? "" : done.error().text().c_str());
        QVERIFY(!shared.wasHeard);
        QVERIFY(shelf->airOf(smoke) == air);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(SharedAirTest)
#include "shared_air_test.moc"
