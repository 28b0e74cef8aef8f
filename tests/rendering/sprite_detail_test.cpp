#include "tests/helpers.h"

#include "core/lighting/detail_field.h"

#include <array>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kEdge = 200;

/// A puff in air, whose particles show detail.
Effect detailed()
{
    Effect effect = thesisEffect(12000);
    effect.air.enabled = true;
    effect.air.resolution = 16;
    effect.look.detail = 1.0F;
    effect.look.detailSize = 0.4F;
    effect.look.detailLife = 0.5F;
    effect.look.detailEdge = 1.0F;
    return effect;
}

/// What is drawn of a frame.
class Drawing {
public:
    explicit Drawing(const Effect& effect, int edge = kEdge, int frame = 17)
        : m_effect(sampled(effect))
        , m_frame(frameOf(effect, frame))
        , m_edge(edge)
    {
    }

    const SpriteBatch& as(PhaseMix mix)
    {
        m_renderer.setPhaseMix(mix);
        const View view = makeView(m_effect->camera, 0.0F, m_edge, m_edge);
        if (!m_renderer.prepare(*m_frame, m_effect, view)) {
            qFatal("no sprites");
        }
        return m_renderer.batch();
    }
    [[nodiscard]] float weight(std::size_t phase) const { return (*m_renderer.detail()->phases)[phase].weight; }

private:
    SampledEffect m_effect;
    std::shared_ptr<const Frame> m_frame;
    Renderer m_renderer;
    int m_edge;
};

template <class Visit>
void forShown(const SpriteBatch& batch, const Visit& visit)
{
    for (std::size_t i = 0; i < batch.sprites.size(); ++i) {
        if (batch.depth[i] != SpriteBatch::kHidden) {
            visit(batch.sprites[i], batch.details[i]);
        }
    }
}

/// All that is drawn, as bits; what hidden sprites hold is of no account.
AlignedArray<float> bitsOf(const SpriteBatch& batch)
{
    AlignedArray<float> out;
    forShown(batch, [&](const Sprite& sprite, const SpriteDetail& detail) {
        out.insert(out.end(), {sprite.opacity, sprite.direct[0], sprite.ambient[2]});
        for (std::size_t which = 0; which < 2; ++which) {
            if (detail.shown[which] == 0) {
                continue;
            }
            const SpriteDetail::Phase& phase = detail.phases[which];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                out.insert(out.end(), {phase.at[axis], phase.u[axis], phase.v[axis]});
            }
            out.insert(out.end(),
                {static_cast<float>(phase.light), phase.relief, phase.weight, detail.strength, detail.perMean,
                    detail.gain, detail.around, detail.screenRelief});
        }
    });
    return out;
}

} // namespace

class SpriteDetailTest : public QObject {
    Q_OBJECT

private slots:
    /// Where both phases are there, a blend shows both of them, and a picture that moves one in each sprite, the first
    /// in as many as the square of its weight.
    void movingPicturesShowOnePhase()
    {
        Drawing drawing(detailed(), 800); // no sprite so small that it shows its centre alone
        int both = 0;
        int shown = 0;
        forShown(drawing.as(PhaseMix::Blend), [&](const Sprite&, const SpriteDetail& detail) {
            both += detail.shown[0] & detail.shown[1];
            shown += detail.shown[0] | detail.shown[1];
        });
        QVERIFY(shown > 1000 && both > shown / 2);
        int one = 0;
        int first = 0;
        forShown(drawing.as(PhaseMix::Choose), [&](const Sprite&, const SpriteDetail& detail) {
            QVERIFY((detail.shown[0] & detail.shown[1]) == 0);
            if (detail.shown[0] != 0) {
                ++one;
                first += detail.phases[0].weight == drawing.weight(0) ? 1 : 0;
            }
        });
        QVERIFY(one > shown / 2);
        QVERIFY(drawing.weight(0) != drawing.weight(1));
        const double share = static_cast<double>(drawing.weight(0)) * static_cast<double>(drawing.weight(0));
        QVERIFY(near(static_cast<double>(first) / one, share, 0.15)); // coarse noise over few waves decides
    }

    /// At the step at which a phase begins it is not seen yet, and no sprite of a picture that moves chooses it, also
    /// not where the noise that decides goes a little beyond its ends.
    void aPhaseThatIsNotSeenIsNotChosen()
    {
        int begun = 0;
        for (int frame = 10; frame < 30; ++frame) {
            Drawing drawing(detailed(), 800, frame);
            std::array<int, 2> chosen{};
            forShown(drawing.as(PhaseMix::Choose), [&](const Sprite& sprite, const SpriteDetail& detail) {
                QVERIFY(std::isfinite(detail.gain) && std::isfinite(sprite.opacity));
                if (detail.shown[0] != 0) {
                    ++chosen[detail.phases[0].weight == drawing.weight(0) ? 0 : 1];
                }
            });
            for (std::size_t phase = 0; phase < chosen.size(); ++phase) {
                if (drawing.weight(phase) < kMinPhaseWeight) {
                    ++begun;
                    QCOMPARE(chosen[phase], 0);
                    QVERIFY(chosen[1 - phase] > 100);
                }
            }
        }
        QVERIFY(begun > 1);
    }

    void whatMovedLeavesNoTrace()
    {
        Drawing drawing(detailed());
        const AlignedArray<float> before = bitsOf(drawing.as(PhaseMix::Blend));
        QVERIFY(!sameBits(bitsOf(drawing.as(PhaseMix::Choose)), before));
        QVERIFY(sameBits(bitsOf(drawing.as(PhaseMix::Blend)), before));
    }

    /// From afar each sprite shows a sample of the detail: some are denser, some thinner, and together they are as
    /// dense as before.
    void pointsKeepTheMass()
    {
        Drawing drawing(detailed(), 48);
        std::vector<float> before;
        forShown(drawing.as(PhaseMix::Blend),
            [&](const Sprite& sprite, const SpriteDetail&) { before.push_back(sprite.opacity); });
        std::size_t i = 0;
        int changed = 0;
        double sum = 0.0;
        double was = 0.0;
        forShown(drawing.as(PhaseMix::Choose), [&](const Sprite& sprite, const SpriteDetail& detail) {
            QVERIFY(sprite.halfWidth >= 3.0F || detail.shown[0] == 0);
            changed += sprite.opacity != before[i] ? 1 : 0;
            sum += static_cast<double>(sprite.opacity);
            was += static_cast<double>(before[i++]);
        });
        QVERIFY(changed > static_cast<int>(before.size() / 4));
        QVERIFY(near(sum / was, 1.0, 0.1));
    }

    void everyInstructionSetGivesTheSameBits()
    {
        const SimdGuard guard;
        for (const PhaseMix mix : {PhaseMix::Blend, PhaseMix::Choose}) {
            for (const int edge : {kEdge, 48}) {
                Drawing drawing(detailed(), edge);
                const AlignedArray<float> best = bitsOf(drawing.as(mix));
                for (const std::string& target : availableSimdTargets()) {
                    QVERIFY(forceSimdTarget(target).ok());
                    QVERIFY2(sameBits(bitsOf(drawing.as(mix)), best), target.c_str());
                }
            }
        }
    }
};

QTEST_APPLESS_MAIN(SpriteDetailTest)
#include "sprite_detail_test.moc"
