// Masks of layers: channels of an EXR that add up to its alpha, to the bit.
#include "tests/export/layered_fire.h"
#include "tests/helpers.h"

#include "core/export/layer_masks.h"
#include "core/export/manifest/verify.h"
#include "core/export/plan.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/image_io/exr_file.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <cstring>
#include <map>
#include <random>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kFrame = 20;

using Channels = std::map<std::string, std::vector<float>>;

Channels channelsIn(std::span<const std::byte> file)
{
    Channels channels;
    const ExrNumbers numbers = readExr(file).value();
    for (const ExrNumbers::Channel& channel : numbers.channels) {
        channels[channel.name] = channel.values;
    }
    return channels;
}

SequenceOptions framesOptions(ImageFormat format)
{
    SequenceOptions options;
    options.frames = {kFrame, kFrame, 1};
    options.format = format;
    options.passes = {Pass::Colour, Pass::LayerMasks};
    return options;
}

std::vector<std::byte> frameOf(const Scene& scene, const SequenceOptions& options, int frame = kFrame)
{
    Result<std::vector<std::byte>> made = encodeFrame(scene, frame, options);
    if (!made) {
        qFatal("%s", made.error().text().c_str());
    }
    return std::move(made).value();
}

FlipbookOptions sheetOptions(ImageFormat format, PassSet passes = {Pass::Colour, Pass::LayerMasks})
{
    FlipbookOptions options;
    options.output = "boom";
    options.columns = 2;
    options.rows = 2;
    options.frames = {12, 27, 1};
    options.format = format;
    options.passes = passes;
    return options;
}

std::vector<std::string> namesOfMasks(const Channels& channels)
{
    std::vector<std::string> names;
    for (const auto& [name, values] : channels) {
        if (name.starts_with("mask_")) {
            names.push_back(name);
        }
    }
    return names;
}

/// The sum of all masks in some order, in float.
std::vector<float> sumOf(const Channels& channels, std::vector<std::string> order)
{
    std::vector<float> sum(channels.at(order.front()).size(), 0.0F);
    for (const std::string& name : order) {
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += channels.at(name)[i];
        }
    }
    return sum;
}

bool addUpTo(const std::vector<float>& alpha, const Channels& channels)
{
    std::vector<std::string> order = namesOfMasks(channels);
    const std::vector<float> forwards = sumOf(channels, order);
    std::reverse(order.begin(), order.end());
    return forwards == alpha && sumOf(channels, order) == alpha
        && std::ranges::any_of(alpha, [](float value) { return value > 0.1F; });
}

std::optional<ErrorCode> refusalOf(const Scene& scene, const FlipbookOptions& options)
{
    const auto made = encodeFlipbook(scene, options);
    return made ? std::nullopt : std::optional(made.error().code);
}

} // namespace

class LayerMasksTest : public QObject {
    Q_OBJECT

private slots:
    void masksOfAFrameAddUpToItsAlpha_data()
    {
        QTest::addColumn<int>("supersample");
        QTest::addColumn<bool>("half");
        for (const int supersample : {1, 2, 3}) {
            QTest::addRow("floats, %d x", supersample) << supersample << false;
            QTest::addRow("halves, %d x", supersample) << supersample << true;
        }
    }
    void masksOfAFrameAddUpToItsAlpha()
    {
        QFETCH(int, supersample);
        QFETCH(bool, half);
        Scene scene = fire();
        scene.output.supersample = supersample;
        const Channels channels =
            channelsIn(frameOf(scene, framesOptions(half ? ImageFormat::ExrHalf : ImageFormat::ExrFloat)));
        const std::vector<std::string> expected{"mask_flames.Y", "mask_red-ash.Y", "mask_smoke.Y"};
        QVERIFY(namesOfMasks(channels) == expected);
        QVERIFY(addUpTo(channels.at("A"), channels));
        for (const std::string& name : expected) {
            const std::vector<float>& mask = channels.at(name);
            QVERIFY(std::ranges::all_of(mask, [](float value) { return value >= 0.0F; }));
            QVERIFY(std::ranges::any_of(mask, [](float value) { return value > 0.01F; }));
        }
    }

    /// As is every sum of some of them, so that it does not matter in which numbers somebody adds.
    void masksOfHalvesAreHalves()
    {
        std::mt19937 random(3);
        PassSheet sheet;
        sheet.grid = {1, 1, 64, 64};
        Image& colour = sheet.targets.of(PassTarget::Colour);
        colour.resize(64, 64);
        sheet.masks.resize(5);
        for (LayerMask& mask : sheet.masks) {
            mask.values.resize(64 * 64);
        }
        for (std::size_t i = 0; i < 64 * 64; ++i) {
            // Of all sizes, with 24 bits, and parts of it that are whole in its ulps.
            const auto bits = static_cast<std::int32_t>((1U << 23U) | (random() & 0x7fffffU));
            const float ulp = std::ldexp(1.0F, -24 - static_cast<int>(i % 20));
            std::int32_t left = bits;
            for (std::size_t k = 0; k < 5; ++k) {
                const std::int32_t part =
                    k == 4 ? left : static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(left + 1));
                sheet.masks[k].values[i] = static_cast<float>(part) * ulp;
                left -= part;
            }
            colour.pixels[i * 4 + 3] = static_cast<float>(bits) * ulp;
        }
        const Result<std::vector<std::byte>> alpha = encodeExr({64, 64, {{{}, "RGBA", colour.pixels}}, true, {}});
        const Channels file = channelsIn(encodeMasks(
            [&] {
                PassSheet named = sheet;
                for (std::size_t k = 0; k < 5; ++k) {
                    named.masks[k].target = "mask_" + std::to_string(k);
                }
                return named;
            }(),
            ImageFormat::ExrHalf, {})
                                             .value());
        const std::vector<float> whole = channelsIn(alpha.value()).at("A");
        QVERIFY(addUpTo(whole, file));
        const std::vector<LayerMask> stored = storedMasks(sheet, ImageFormat::ExrHalf);
        for (std::size_t k = 0; k < 5; ++k) {
            const std::vector<float>& read = file.at("mask_" + std::to_string(k) + ".Y");
            QVERIFY(std::equal(read.begin(), read.end(), stored[k].values.begin(), stored[k].values.end()));
            for (std::size_t i = 0; i < read.size(); ++i) { // and next to what they were
                QVERIFY(std::abs(read[i] - sheet.masks[k].values[i])
                    <= std::max(colour.pixels[i * 4 + 3] * 0x1p-10F, 0x1p-24F));
            }
        }
    }

    void ofOneLayerItIsTheAlpha()
    {
        for (const ImageFormat format : {ImageFormat::ExrFloat, ImageFormat::ExrHalf}) {
            const Channels channels = channelsIn(frameOf(smallSmoke(), framesOptions(format)));
            QVERIFY(namesOfMasks(channels) == std::vector<std::string>{"mask_layer-1.Y"});
            QVERIFY(channels.at("mask_layer-1.Y") == channels.at("A"));
        }
    }

    void aLayerThatIsMutedHasNone()
    {
        Scene scene = fire();
        scene.layers[1].visible = false;
        const Channels channels = channelsIn(frameOf(scene, framesOptions(ImageFormat::ExrFloat)));
        QVERIFY((namesOfMasks(channels) == std::vector<std::string>{"mask_red-ash.Y", "mask_smoke.Y"}));
        QVERIFY(addUpTo(channels.at("A"), channels));
    }

    /// The picture is the one without them, and they are the alphas of contributions.
    void theyAreWhatTheLayersGive()
    {
        const Scene scene = fire();
        SequenceOptions options = framesOptions(ImageFormat::ExrFloat);
        const Channels with = channelsIn(frameOf(scene, options));
        options.passes = {Pass::Colour};
        for (const auto& [name, values] : channelsIn(frameOf(scene, options))) {
            QVERIFY(with.at(name) == values);
        }
        FlipbookOptions sheet = sheetOptions(ImageFormat::ExrFloat);
        const Channels masks = channelsIn(encodeFlipbook(scene, sheet).value()[1].bytes);
        sheet.passes = {Pass::Alpha};
        sheet.layers = LayerOutput::Contribution;
        const std::vector<FlipbookFile> shares = encodeFlipbook(scene, sheet).value();
        for (const auto& [file, mask] :
            {std::pair{0, "mask_smoke.Y"}, std::pair{2, "mask_flames.Y"}, std::pair{4, "mask_red-ash.Y"}}) {
            QVERIFY(channelsIn(shares[static_cast<std::size_t>(file)].bytes).at("Y") == masks.at(mask));
        }
    }

    void framesOfAPartOfARangeAreThoseOfTheWhole()
    {
        const Scene scene = fire();
        SequenceOptions options = framesOptions(ImageFormat::ExrHalf);
        options.passes.add(Pass::Motion);
        std::map<int, std::vector<std::byte>> whole;
        const auto framesIn = [&](FrameRange range, std::map<int, std::vector<std::byte>>& to) {
            options.frames = range;
            return encodeFrames(scene, options, [&](int frame, std::span<const std::byte> bytes) -> Status {
                to[frame].assign(bytes.begin(), bytes.end());
                return Done{};
            });
        };
        QVERIFY(framesIn({18, 23, 1}, whole).ok());
        std::map<int, std::vector<std::byte>> parts;
        QVERIFY(framesIn({18, 20, 1}, parts).ok());
        QVERIFY(framesIn({21, 23, 1}, parts).ok());
        QVERIFY(parts == whole);
        for (const int threads : {1, 3}) {
            const ThreadLimit limit(threads);
            QVERIFY(frameOf(scene, options, 20) == whole.at(20));
        }
    }

    void sheetsHaveThemInAFileOfTheirOwn()
    {
        const Scene scene = fire();
        for (const ImageFormat format : {ImageFormat::ExrFloat, ImageFormat::ExrHalf}) {
            const FlipbookOptions options = sheetOptions(format);
            const std::vector<FlipbookFile> files = encodeFlipbook(scene, options).value();
            QCOMPARE(files.size(), std::size_t{3});
            QCOMPARE(files[1].path.string(), std::string("boom_layer_masks.exr"));
            QVERIFY(addUpTo(channelsIn(files[0].bytes).at("A"), channelsIn(files[1].bytes)));
            const QByteArray text(
                reinterpret_cast<const char*>(files[2].bytes.data()), static_cast<qsizetype>(files[2].bytes.size()));
            const QJsonObject masks =
                QJsonDocument::fromJson(text).object()[QStringLiteral("pictures")].toArray()[1].toObject();
            QCOMPARE(masks[QStringLiteral("pass")].toString(), QStringLiteral("layer-masks"));
            QCOMPARE(masks[QStringLiteral("file")].toString(), QStringLiteral("boom_layer_masks.exr"));
            QCOMPARE(masks[QStringLiteral("channels")].toArray()[2].toString(), QStringLiteral("mask_red-ash.Y"));
            QCOMPARE(masks[QStringLiteral("layers")].toArray()[2].toString(), QStringLiteral("Red ash"));
        }
        // Alone, and with a cell that is not filled.
        FlipbookOptions alone = sheetOptions(ImageFormat::ExrFloat, {Pass::LayerMasks});
        QCOMPARE(encodeFlipbook(scene, alone).value()[0].path.string(), std::string("boom_layer_masks.exr"));
    }

    void manifestsMakeThemAgain()
    {
        const QTemporaryDir folder;
        ExportPlan plan;
        plan.format = ImageFormat::ExrHalf;
        plan.passes = {Pass::Colour, Pass::LayerMasks};
        plan.frames = {12, 15, 1};
        for (const ExportKind kind : {ExportKind::Sequence, ExportKind::Flipbook}) {
            const std::string name = folder.path().toStdString() + "/" + std::string(nameOf(kind));
            plan.kind = kind;
            plan.output = name + (kind == ExportKind::Sequence ? "_##.exr" : ".exr");
            plan.flipbook.columns = plan.flipbook.rows = 2;
            plan.recording.manifest = name + ".manifest.json";
            QVERIFY(runExport(fire(), plan).ok());
        }
        const auto again = renderAgain(openManifests(folder.path().toStdString()).value(), {0, 99, 1});
        QVERIFY(again.ok());
        QCOMPARE(again.value().size(), std::size_t{7});
        QVERIFY(
            std::ranges::all_of(again.value(), [](const CheckedFile& each) { return each.state == FileState::Same; }));
    }

    void whatCannotHoldThemIsRefused()
    {
        const std::optional<ErrorCode> none;
        QVERIFY(refusalOf(fire(), sheetOptions(ImageFormat::ExrFloat)) == none);
        QVERIFY(refusalOf(fire(), sheetOptions(ImageFormat::Png16)) == ErrorCode::OutOfRange);
        QVERIFY(refusalOf(fire(), sheetOptions(ImageFormat::Tga)) == ErrorCode::OutOfRange);
        for (const LayerOutput layers : {LayerOutput::Alone, LayerOutput::Contribution, LayerOutput::Stacked}) {
            FlipbookOptions options = sheetOptions(ImageFormat::ExrFloat);
            options.layers = layers;
            QVERIFY(refusalOf(fire(), options) == ErrorCode::OutOfRange);
        }
        QVERIFY(!parsePack("some=layer-masks").ok());
        QVERIFY(!parsePasses("all").value().has(Pass::LayerMasks));
        QVERIFY(!encodeFrame(fire(), kFrame, framesOptions(ImageFormat::Png8)).ok());
        // Nobody reads more numbers than this; it is said before there is any work.
        Scene many = fire();
        many.layers.resize(64, many.layers[0]);
        many.output.width = many.output.height = 2048;
        const auto frame = encodeFrame(many, kFrame, framesOptions(ImageFormat::ExrHalf));
        QVERIFY(!frame.ok());
        QCOMPARE(frame.error().code, ErrorCode::TooLarge);
        QVERIFY(refusalOf(many, sheetOptions(ImageFormat::ExrHalf)) == ErrorCode::TooLarge);
    }
};

QTEST_APPLESS_MAIN(LayerMasksTest)
#include "layer_masks_test.moc"
