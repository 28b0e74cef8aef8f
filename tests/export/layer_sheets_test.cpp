// Sheets of layers: contributions add up to the sheet of all, stacked ones make it when they are drawn over one
// another, and of one layer they are the sheet as it always was.
#include "tests/export/layered_fire.h"
#include "tests/helpers.h"

#include "core/base/text.h"
#include "core/export/engines/engine_files.h"
#include "core/export/jobs/jobs.h"
#include "core/export/manifest/verify.h"
#include "core/export/plan.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/image_io/exr_file.h"
#include "core/image_io/picture_pixels.h"
#include "core/rendering/view_transform.h"
#include "core/scene/scene.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <set>

using namespace fumage;
using namespace fumage::tests;

namespace {

FlipbookOptions optionsFor(std::optional<LayerOutput> layers, ImageFormat format = ImageFormat::Png8)
{
    FlipbookOptions options;
    options.output = "boom";
    options.columns = 2;
    options.rows = 2;
    options.frames = {12, 27, 1};
    options.format = format;
    options.layers = layers;
    return options;
}

/// The files of a flipbook, in their order.
std::vector<FlipbookFile> filesMade(const Scene& scene, const FlipbookOptions& options)
{
    Result<std::vector<FlipbookFile>> made = encodeFlipbook(scene, options);
    if (!made) {
        qFatal("%s", made.error().text().c_str());
    }
    return std::move(made).value();
}

/// Numbers of all pixels of a picture, RGBA, in [0, 1] unless they are floats.
using Numbers = std::vector<double>;

Numbers numbersOf(const FlipbookFile& file)
{
    Numbers numbers;
    if (file.path.extension() == ".exr") {
        const ExrNumbers exr = readExr(file.bytes).value();
        numbers.resize(exr.channels.front().values.size() * 4);
        for (const ExrNumbers::Channel& channel : exr.channels) {
            const std::size_t at = std::string_view("RGBA").find(channel.name);
            for (std::size_t i = 0; i < channel.values.size(); ++i) {
                numbers[i * 4 + at] = static_cast<double>(channel.values[i]);
            }
        }
        return numbers;
    }
    const RgbaPixels pixels = readPixels(file.bytes).value();
    for (const std::uint16_t value : pixels.values) {
        numbers.push_back(static_cast<double>(value) / 65535.0);
    }
    return numbers;
}

/// The pictures of the colours among files: one a sheet.
std::vector<Numbers> coloursOf(const std::vector<FlipbookFile>& files)
{
    std::vector<Numbers> colours;
    for (const FlipbookFile& file : files) {
        if (file.path.extension() != ".json" && file.path.stem().string().find("_alpha") == std::string::npos) {
            colours.push_back(numbersOf(file));
        }
    }
    return colours;
}

double linear(double stored)
{
    return static_cast<double>(linearFromSrgb(static_cast<float>(stored)));
}

/// What a straight picture shows over black.
Numbers overBlack(Numbers straight, bool isLinear)
{
    for (std::size_t i = 0; i < straight.size(); i += 4) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            double& value = straight[i + channel];
            value = (isLinear ? linear(value) : value) * straight[i + 3];
        }
    }
    return straight;
}

/// Premultiplied pictures one over the other, the first at the bottom, over something behind.
/// @param most what the numbers of a screen are clipped to after each layer
Numbers drawn(const std::vector<Numbers>& layers, double behind, bool isLinear, double most)
{
    Numbers picture(layers.front().size(), behind);
    for (const Numbers& layer : layers) {
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const double colour = i % 4 == 3 || !isLinear ? layer[i] : linear(layer[i]);
            picture[i] = std::min(most, colour + (1.0 - layer[i - i % 4 + 3]) * picture[i]);
        }
    }
    return picture;
}

double mostBetween(const Numbers& a, const Numbers& b)
{
    double most = a.size() == b.size() ? 0.0 : 1e9;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        most = std::max(most, std::abs(a[i] - b[i]));
    }
    return most;
}

double fullOfFormat(ImageFormat format)
{
    return static_cast<double>(fullOf(format));
}

std::vector<std::string> wordsOf(const std::vector<std::string>& names)
{
    Scene scene;
    scene.layers.resize(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        scene.layers[i].name = names[i];
    }
    std::vector<std::string> words;
    for (const WrittenLayer& layer : writtenLayers(scene)) {
        words.push_back(layer.word);
    }
    return words;
}

} // namespace

class LayerSheetsTest : public QObject {
    Q_OBJECT

private slots:
    void namesBecomeWords()
    {
        const std::vector<std::string> words = wordsOf({"Flames", "flames", "", "  Hot / cold\\..", "a_motion",
            "\xe7\x83\x9f", "\xff", "\u202eabc", "flames-2", std::string(300, 'x'), "CON", "É", "é"});
        const std::vector<std::string> expected{"flames", "flames-2", "layer-3", "hot-cold", "a-motion",
            "\xe7\x83\x9f-6", "layer-7", "abc", "flames-2-9", std::string(48, 'x'), "con", "É-12", "é-13"};
        QCOMPARE(words, expected);
    }

    void noTwoFilesHaveOneName()
    {
        Scene scene = smallSmoke();
        scene.layers.assign(6, scene.layers[0]);
        const std::vector<std::string> names{"a", "A", "a motion", "motion", "", "a_motion"};
        for (std::size_t i = 0; i < names.size(); ++i) {
            scene.layers[i].name = names[i];
        }
        FlipbookOptions options = optionsFor(LayerOutput::Alone);
        options.passes.add(Pass::Motion);
        const std::vector<std::filesystem::path> files = filesOf(scene, options);
        std::set<std::string> all;
        for (const std::filesystem::path& file : files) {
            QVERIFY2(all.insert(inSmallLetters(file.string())).second, file.c_str());
        }
        QCOMPARE(files.size(), std::size_t{18});
    }

    void contributionsAddUpByteByByte_data()
    {
        QTest::addColumn<int>("format");
        QTest::newRow("png") << static_cast<int>(ImageFormat::Png8);
        QTest::newRow("png16") << static_cast<int>(ImageFormat::Png16);
        QTest::newRow("tga") << static_cast<int>(ImageFormat::Tga);
    }
    void contributionsAddUpByteByByte()
    {
        QFETCH(int, format);
        const auto as = static_cast<ImageFormat>(format);
        const double full = fullOfFormat(as);
        const Numbers whole = overBlack(coloursOf(filesMade(fire(), optionsFor({}, as)))[0], false);
        const std::vector<Numbers> layers = coloursOf(filesMade(fire(), optionsFor(LayerOutput::Contribution, as)));
        QCOMPARE(layers.size(), std::size_t{3});
        for (std::size_t i = 0; i < whole.size(); ++i) {
            double sum = 0.0;
            for (const Numbers& layer : layers) {
                sum += std::round(layer[i] * full);
            }
            QVERIFY(std::abs(sum - whole[i] * full) <= 0.52); // the numbers here are floats
        }
        for (const Numbers& layer : layers) {
            QVERIFY(*std::ranges::max_element(layer) > 0.1);
        }
    }

    void lightOfContributionsAddsUp()
    {
        FlipbookOptions options = optionsFor(LayerOutput::Contribution, ImageFormat::Png16);
        options.blending = BlendSpace::Linear;
        const Numbers whole = overBlack(coloursOf(filesMade(fire(), optionsFor({}, ImageFormat::Png16)))[0], true);
        Numbers sum(whole.size(), 0.0);
        for (const Numbers& layer : coloursOf(filesMade(fire(), options))) {
            for (std::size_t i = 0; i < sum.size(); ++i) {
                sum[i] += i % 4 == 3 ? layer[i] : linear(layer[i]);
            }
        }
        QVERIFY(near(mostBetween(sum, whole), 0.0, 5e-5)); // a step of 16 bits, near white
    }

    void contributionsAddUpExactlyInFloat()
    {
        const auto files = [](std::optional<LayerOutput> layers) {
            return coloursOf(filesMade(fire(), optionsFor(layers, ImageFormat::ExrFloat)));
        };
        const Numbers whole = files({})[0];
        std::vector<float> sum(whole.size(), 0.0F);
        for (const Numbers& layer : files(LayerOutput::Contribution)) {
            for (std::size_t i = 0; i < sum.size(); ++i) {
                sum[i] += static_cast<float>(layer[i]);
            }
        }
        for (std::size_t i = 0; i < sum.size(); ++i) {
            QCOMPARE(static_cast<double>(sum[i]), whole[i]);
        }
    }

    void stackedLayersMakeThePicture_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<bool>("linear");
        QTest::addColumn<double>("within");
        // Half a step, and of the bottom's alpha as much again.
        const auto add = [](const char* name, ImageFormat format, bool linear, double within) {
            QTest::newRow(name) << static_cast<int>(format) << linear << within;
        };
        add("png", ImageFormat::Png8, false, 1.01 / 255.0);
        add("png16", ImageFormat::Png16, false, 1.01 / 65535.0);
        add("png, as light", ImageFormat::Png8, true, 2.0 / 255.0); // steps of sRGB are larger near white
        add("png16, as light", ImageFormat::Png16, true, 2.0 / 65535.0);
        add("exr32", ImageFormat::ExrFloat, false, 1e-5);
    }
    void stackedLayersMakeThePicture()
    {
        QFETCH(int, format);
        QFETCH(bool, linear);
        QFETCH(double, within);
        const auto as = static_cast<ImageFormat>(format);
        FlipbookOptions options = optionsFor(LayerOutput::Stacked, as);
        options.blending = linear ? BlendSpace::Linear : BlendSpace::Encoded;
        const Numbers straight = coloursOf(filesMade(fire(), optionsFor({}, as)))[0];
        const Numbers whole = holdsFloats(as) ? straight : overBlack(straight, linear);
        const std::vector<Numbers> layers = coloursOf(filesMade(fire(), options));
        const double most = holdsFloats(as) ? 1e9 : 1.0;
        for (const double behind : {0.0, 0.35, 1.0}) {
            Numbers expected = whole;
            for (std::size_t i = 0; i < expected.size(); ++i) {
                expected[i] += (1.0 - whole[i - i % 4 + 3]) * behind;
            }
            QVERIFY(near(mostBetween(drawn(layers, behind, linear, most), expected), 0.0, within * (1.0 + behind)));
        }
        // In the other order it is another picture: the order matters, and the layers lie in one another.
        std::vector<Numbers> turned(layers.rbegin(), layers.rend());
        QVERIFY(mostBetween(drawn(turned, 0.0, linear, most), whole) > 0.02);
    }

    /// A layer alone looks as if the others were clear: in their light, but behind nothing.
    void aLayerAloneIsHiddenByNothing()
    {
        Scene scene = fire();
        for (Layer& layer : scene.layers) {
            layer.glow.fireLight = 0.0F;
            layer.look.overlap = 0.0F;
        }
        scene.wind.strength = 0.0F; // which goes by the first layer
        scene.light.shadow = 0.0F;
        scene.light.occlusion = 0.0F;
        const std::vector<Numbers> alone = coloursOf(filesMade(scene, optionsFor(LayerOutput::Alone)));
        for (std::size_t k = 0; k < scene.layers.size(); ++k) {
            Scene one = scene;
            for (std::size_t i = 0; i < one.layers.size(); ++i) {
                one.layers[i].visible = i == k;
            }
            QVERIFY(near(mostBetween(alone[k], coloursOf(filesMade(one, optionsFor({})))[0]), 0.0, 1.01 / 255.0));
        }
    }

    void ofOneLayerItIsTheSheetAsItWas_data()
    {
        QTest::addColumn<int>("layers");
        QTest::addColumn<int>("format");
        for (const LayerOutput layers :
            {LayerOutput::Together, LayerOutput::Alone, LayerOutput::Contribution, LayerOutput::Stacked}) {
            for (const ImageFormat format : kAllImageFormats) {
                QTest::addRow("%s %s", nameOf(layers).data(), nameOf(format).data())
                    << static_cast<int>(layers) << static_cast<int>(format);
            }
        }
    }
    void ofOneLayerItIsTheSheetAsItWas()
    {
        QFETCH(int, layers);
        QFETCH(int, format);
        for (const Background background : {Background::Transparent, Background::Colour}) {
            Effect effect = smallSmoke();
            effect.output.background = background;
            effect.glow.emission = 3.0F;
            const auto as = static_cast<ImageFormat>(format);
            const std::vector<FlipbookFile> whole = filesMade(effect, optionsFor({}, as));
            const std::vector<FlipbookFile> layer = filesMade(effect, optionsFor(static_cast<LayerOutput>(layers), as));
            QVERIFY(whole[0].bytes == layer[0].bytes);
        }
    }

    void allSheetsAreWrittenWithTheirSideCars()
    {
        const QTemporaryDir folder;
        ExportPlan plan;
        plan.kind = ExportKind::Flipbook;
        plan.output = folder.path().toStdString() + "/boom.png";
        plan.frames = {12, 27, 1};
        plan.flipbook.columns = plan.flipbook.rows = 2;
        plan.layers = LayerOutput::Stacked;
        plan.recording.manifest = manifestBeside(plan.output);
        const auto done = runExport(fire(), plan);
        QVERIFY2(done.ok(), done ? "" : done.error().text().c_str());
        QStringList there = QDir(folder.path()).entryList(QDir::Files);
        QStringList expected{QStringLiteral("boom.manifest.json")};
        for (const std::filesystem::path& file : filesOf(fire(), plan)) {
            expected << QString::fromStdString(file.filename().string());
        }
        there.sort();
        expected.sort();
        QCOMPARE(there, expected);
        QCOMPARE(done.value()->files, 6);
        QCOMPARE(done.value()->picture.filename().string(), std::string("boom_smoke.png"));
        QFile file(folder.filePath(QStringLiteral("boom_red-ash.flipbook.json")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(json[QStringLiteral("picture")].toString(), QStringLiteral("boom_red-ash.png"));
        QCOMPARE(json[QStringLiteral("alpha")].toString(), QStringLiteral("premultiplied"));
        const QJsonObject layer = json[QStringLiteral("layer")].toObject();
        QCOMPARE(layer[QStringLiteral("name")].toString(), QStringLiteral("Red ash"));
        QCOMPARE(layer[QStringLiteral("number")].toInt(), 3);
        QCOMPARE(layer[QStringLiteral("of")].toInt(), 3);
        QCOMPARE(layer[QStringLiteral("as")].toString(), QStringLiteral("stacked"));
        QCOMPARE(layer[QStringLiteral("space")].toString(), QStringLiteral("encoded"));
        // And any machine makes them again.
        const Result<std::vector<CheckedFile>> again =
            renderAgain(openManifests(folder.path().toStdString()).value(), {0, 99, 1});
        QVERIFY(again.ok());
        QCOMPARE(again.value().size(), std::size_t{6});
        QVERIFY(
            std::ranges::all_of(again.value(), [](const CheckedFile& each) { return each.state == FileState::Same; }));
    }

    void jobsSeeWhichFilesLayersHave()
    {
        ExportJob job{"a", {}, {}};
        job.preset.scene = fire();
        job.plan.kind = ExportKind::Flipbook;
        job.plan.output = "/tmp/boom.png";
        job.plan.layers = LayerOutput::Alone;
        ExportJob other = job;
        other.name += "b";
        other.plan.layers.reset();
        other.plan.output = "/tmp/boom_flames.png";
        JobFiles files;
        QVERIFY(files.add(job).ok());
        QVERIFY(!files.add(other).ok());
        other.plan.output = "/tmp/boom.png";
        QVERIFY(files.add(other).ok());
    }

    void whatSharesCannotHoldIsRefused()
    {
        const auto refusal = [](const FlipbookOptions& options) {
            const auto made = encodeFlipbook(fire(), options);
            return made ? std::nullopt : std::optional(made.error().code);
        };
        const std::optional<ErrorCode> none;
        for (const LayerOutput layers : {LayerOutput::Contribution, LayerOutput::Stacked}) {
            FlipbookOptions options = optionsFor(layers);
            options.passes.add(Pass::Motion);
            QVERIFY(refusal(options) == ErrorCode::OutOfRange);
            options = optionsFor(layers);
            options.packs = {parsePack("masks=alpha").value()};
            QVERIFY(refusal(options) == ErrorCode::OutOfRange);
            options = optionsFor(layers);
            options.engine = Engine::Defold;
            QVERIFY(refusal(options) == ErrorCode::OutOfRange);
            options = optionsFor(layers);
            options.passes.add(Pass::Alpha);
            QVERIFY(refusal(options) == (layers == LayerOutput::Stacked ? ErrorCode::OutOfRange : none));
        }
        FlipbookOptions all = optionsFor(LayerOutput::Alone);
        all.passes.add(Pass::Motion);
        QVERIFY(refusal(all) == none);
        // Many layers need much memory: that is said before it is asked for.
        Scene many = fire();
        many.output.width = many.output.height = 2048;
        many.layers.resize(64, many.layers[0]);
        const auto made = encodeFlipbook(many, optionsFor(LayerOutput::Stacked));
        QVERIFY(!made.ok());
        QCOMPARE(made.error().code, ErrorCode::TooLarge);
    }

    /// One scene, script or page for all sheets; names of layers are not code.
    void enginesDrawLayersOverOneAnother()
    {
        Scene scene = fire();
        scene.layers[1].name = "\"+F();//<b>\n{{columns}}";
        for (const Engine engine : kAllEngines) {
            FlipbookOptions options = optionsFor(LayerOutput::Stacked);
            options.engine = engine;
            const auto made = encodeFlipbook(scene, options);
            QCOMPARE(made.ok(), engine == Engine::Generic || stacksLayers(engine));
            if (!made) {
                QCOMPARE(made.error().code, ErrorCode::OutOfRange);
                continue;
            }
            std::vector<std::filesystem::path> named;
            std::string text;
            for (const FlipbookFile& file : made.value()) {
                named.push_back(file.path);
                const bool isShared = file.path.stem().string() == "boom";
                text.append(
                    isShared ? reinterpret_cast<const char*>(file.bytes.data()) : "", isShared ? file.bytes.size() : 0);
            }
            QVERIFY(named == filesOf(scene, options));
            if (engine == Engine::Generic) {
                continue;
            }
            QVERIFY(text.find(scene.layers[1].name) == std::string::npos);
            QVERIFY(text.find("\"+F()") == std::string::npos);
            QVERIFY(text.find("+F();//<b>") == std::string::npos);
            for (const std::string word : {"smoke", "f-b-columns", "red-ash"}) {
                QVERIFY2(
                    engine == Engine::Web || text.find("boom_" + word + ".png") != std::string::npos, text.c_str());
            }
        }
    }

    /// Effekseer draws alpha * colour over what is behind, and in no other way: its sheets are straight.
    void straightSheetsMakeThePictureToo()
    {
        for (const ImageFormat format : {ImageFormat::Png8, ImageFormat::Png16}) {
            FlipbookOptions options = optionsFor(LayerOutput::Stacked, format);
            options.engine = Engine::Effekseer;
            const std::vector<FlipbookFile> files = filesMade(fire(), options);
            std::vector<Numbers> layers;
            for (const FlipbookFile& file : files) {
                if (file.path.extension() == ".png") {
                    layers.push_back(overBlack(numbersOf(file), false)); // what a screen adds: alpha * colour
                }
            }
            QCOMPARE(layers.size(), std::size_t{3});
            const Numbers whole = overBlack(coloursOf(filesMade(fire(), optionsFor({}, format)))[0], false);
            const std::vector<Numbers> all{whole};
            for (const double behind : {0.0, 0.5, 1.0}) {
                const Numbers picture = drawn(layers, behind, false, 1.0);
                const Numbers expected = drawn(all, behind, false, 1.0);
                const double within = 1.01 / fullOfFormat(format) * (1.0 + behind); // as of premultiplied ones
                QVERIFY2(mostBetween(picture, expected) <= within,
                    qPrintable(QString::number(mostBetween(picture, expected) * fullOfFormat(format))));
            }
        }
        // Where nothing is, the colour goes on: filtering brings no dark rims.
        FlipbookOptions options = optionsFor(LayerOutput::Stacked);
        options.engine = Engine::Effekseer;
        const Numbers smoke = numbersOf(filesMade(fire(), options)[0]);
        bool isThere = false;
        for (std::size_t i = 0; i < smoke.size(); i += 4) {
            isThere = isThere || smoke[i + 3] == 0.0;
            QVERIFY(smoke[i + 3] > 0.0 || smoke[i] > 0.0);
        }
        QVERIFY(isThere);
    }

    /// A mask a layer: how much of each is seen.
    void masksAddUpToTheAlpha()
    {
        FlipbookOptions options = optionsFor(LayerOutput::Contribution);
        options.passes = {Pass::Alpha};
        const std::vector<FlipbookFile> masks = filesMade(fire(), options);
        QCOMPARE(masks.size(), std::size_t{6});
        QCOMPARE(masks[0].path.filename().string(), std::string("boom_smoke_alpha.png"));
        options.layers.reset();
        const Numbers whole = numbersOf(filesMade(fire(), options)[0]);
        Numbers sum(whole.size(), 0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const Numbers mask = numbersOf(masks[2 * k]);
            std::transform(sum.begin(), sum.end(), mask.begin(), sum.begin(), std::plus<>());
        }
        for (std::size_t i = 0; i < whole.size(); i += 4) {
            QVERIFY(near(sum[i], whole[i], 2.01 / 255.0)); // each is rounded by itself
        }
    }
};

QTEST_APPLESS_MAIN(LayerSheetsTest)
#include "layer_sheets_test.moc"
