#include "tests/helpers.h"

#include "core/system/file.h"
#include "core/effect/parameter_table.h"
#include "core/effect/value.h"
#include "core/noise/texture.h"
#include "core/preset/json_tree.h"
#include "core/preset/library.h"
#include "core/preset/schema.h"
#include "core/preset/preset_file.h"

#include <QTemporaryDir>

#include <ctime>
#include <functional>

using namespace fumage;

namespace {

const std::string kHead = R"({"format": "fumage-preset", "version": 1, )";

ErrorCode codeOf(const std::string& json)
{
    const Result<PresetReading> reading = parsePreset(json);
    return reading ? ErrorCode::Cancelled : reading.error().code;
}

Preset presetOf(const Effect& effect)
{
    Preset preset;
    preset.name = "A \"name\" with \u00e5";
    preset.description = "two\nlines";
    Effect clamped;
    for (const Parameter& p : parameterTable()) {
        setClamped(clamped, p, p.get(effect));
    }
    preset.scene = clamped;
    return preset;
}

} // namespace

class PresetTest : public QObject {
    Q_OBJECT

private slots:
    void writingAndReadingKeepsEverything()
    {
        const Preset preset = presetOf(tests::everythingOn());
        const std::string json = formatPreset(preset);
        const Result<PresetReading> reading = parsePreset(json);
        QVERIFY2(reading.ok(), reading ? "" : reading.error().text().c_str());
        QVERIFY(reading.value().warnings.empty());
        QCOMPARE(reading.value().preset.name, preset.name);
        QCOMPARE(reading.value().preset.description, preset.description);
        QVERIFY(reading.value().preset.scene.effect() == preset.scene.effect());
        QCOMPARE(formatPreset(reading.value().preset), json);
    }

    void unknownMembersAreKeptAndNamed()
    {
        const std::string json = kHead + R"("motion": {"wnd": [1, {"a": "b"}]}, "future": {"x": 1}})";
        const Result<PresetReading> reading = parsePreset(json, "my.json");
        QVERIFY(reading.ok());
        QVERIFY(reading.value().warnings[0].text().find("motion.wnd") != std::string::npos);
        QVERIFY(reading.value().warnings[0].text().find("wind.strength") != std::string::npos);
        QVERIFY(reading.value().warnings[0].text().find("my.json, line 1") != std::string::npos);
        const std::string again = formatPreset(reading.value().preset);
        const Result<PresetReading> second = parsePreset(again);
        QVERIFY(second.ok());
        QCOMPARE(second.value().preset.unknown.size(), std::size_t(2));
        QCOMPARE(second.value().preset.unknown[0].json, std::string(R"([1, {"a": "b"}])"));
        QCOMPARE(formatPreset(second.value().preset), again);
    }

    void aHostileFileIsReadInTimeLinearInItsSize_data()
    {
        QTest::addColumn<QByteArray>("json");
        const auto row = [](const char* name, const std::string& before, const std::function<std::string(int)>& each,
                             const std::string& after) {
            std::string text = before;
            for (int i = 0; text.size() + after.size() + 32 < kMaxPresetBytes; ++i) {
                text += i == 0 ? "" : ",";
                text += each(i);
            }
            QTest::newRow(name) << QByteArray::fromStdString(text + after);
        };
        const auto key = [](int i) { return "\"u" + std::to_string(i) + "\":0"; };
        row("unknown keys at the top", kHead, key, "}");
        row("unknown keys in a group", kHead + "\"motion\": {", key, "}}");
        row(
            "unknown objects", kHead, [](int i) { return "\n\"wind" + std::to_string(i) + "\":{}"; }, "}");
        row("keys of an unknown object", kHead + "\"x\": {", key, "}}");
        row(
            "a long list", kHead + "\"x\": [", [](int) { return "1"; }, "]}");
        row(
            "a long curve", kHead + "\"life\": {\"size\": [", [](int) { return "[0,0]"; }, "]}}");
        row(
            "quotes in a text", kHead + "\"name\": \"", [](int) { return "\\\"\\\\"; }, "\"}");
    }
    void aHostileFileIsReadInTimeLinearInItsSize()
    {
        QFETCH(QByteArray, json);
        const std::clock_t start = std::clock();
        const Result<PresetReading> reading = parsePreset(json.toStdString());
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        QVERIFY(!reading || reading.value().warnings.size() < 25);
        // Time of the processor, 0.1 s when optimised; the square of the size costs a minute.
        constexpr double kMaxSeconds = 3.0;
        QVERIFY2(seconds < kMaxSeconds, QByteArray::number(seconds).constData());
    }

    void manyWarningsAreCounted()
    {
        std::string json = kHead;
        for (int i = 0; i < 100; ++i) {
            json += "\"u" + std::to_string(i) + "\": 1, ";
        }
        const std::vector<Message> warnings = parsePreset(json + "\"motion\": {}}", "x.json").value().warnings;
        QCOMPARE(warnings.size(), std::size_t(22));
        QVERIFY(warnings[19].text().find("\"u19\"") != std::string::npos);
        QCOMPARE(warnings[20].text(), std::string("x.json: and 80 more warnings"));
        QVERIFY(warnings[21].text().find("not in the preset") != std::string::npos);
    }

    void outOfRangeIsClampedWithAWarning()
    {
        const Result<PresetReading> reading = parsePreset(kHead + R"("motion": {"randomness": 5}})");
        QVERIFY(reading.ok());
        QCOMPARE(reading.value().preset.scene.layers[0].motion.randomness, 1.0F);
        QVERIFY(reading.value().warnings[0].text().find("motion.randomness") != std::string::npos);
        for (const char* seed : {"-5", "1e11"}) {
            const Result<PresetReading> seeded = parsePreset(kHead + "\"emitter\": {\"seed\": " + seed + "}}");
            QVERIFY(seeded.value().warnings[0].text().find("emitter.seed was out of range") != std::string::npos);
        }
    }

    void aReferenceToTheSchemaIsKeptWithoutAWarning()
    {
        const Result<PresetReading> reading =
            parsePreset(formatPreset({}).replace(0, 1, "{\"$schema\": \"preset.schema.json\","));
        QVERIFY(reading.ok() && reading.value().warnings.empty());
        QVERIFY(formatPreset(reading.value().preset).find(R"("$schema": "preset.schema.json")") != std::string::npos);
    }

    void missingParametersAreToldInOneLine()
    {
        const Result<PresetReading> reading = parsePreset(kHead + R"("name": "x"})");
        QCOMPARE(reading.value().warnings.size(), std::size_t(1));
        QVERIFY(reading.value().preset.scene.effect() == Effect{});
    }

    void badInputIsRefused_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const std::string& json, ErrorCode code) {
            QTest::newRow(name) << QByteArray::fromStdString(json) << int(code);
        };
        row("empty", "", ErrorCode::Syntax);
        row("not JSON", "hello", ErrorCode::Syntax);
        row("truncated", formatPreset({}).substr(0, 700), ErrorCode::Syntax);
        row("trailing rubbish", formatPreset({}) + "}", ErrorCode::Syntax);
        row("key twice", kHead + R"("motion": {"wind": 1, "wind": 2}})", ErrorCode::Syntax);
        row("array", "[1]", ErrorCode::WrongType);
        row("other JSON", R"({"hello": 1})", ErrorCode::WrongType);
        row("group is a number", kHead + R"("motion": 3})", ErrorCode::WrongType);
        row("text for a number", kHead + R"("motion": {"wind": "fast"}})", ErrorCode::WrongType);
        row("number for a flag", kHead + R"("timeline": {"loop": 1}})", ErrorCode::WrongType);
        row("fraction for a whole number", kHead + R"("emitter": {"count": 10.5}})", ErrorCode::WrongType);
        row("two numbers for a vector", kHead + R"("emitter": {"normal": [0, 1]}})", ErrorCode::WrongType);
        row("nested vector", kHead + R"("emitter": {"normal": [[0, 1, 0]]}})", ErrorCode::WrongType);
        row("empty curve", kHead + R"("life": {"size": []}})", ErrorCode::WrongType);
        row("seventeen points",
            kHead
                + R"("life": {"size": [[0,0],[0,0],[0,0],[0,0],[0,0],[0,0],[0,0],[0,0],)"
                  R"([0,0],[0,0],[0,0],[0,0],[0,0],[0,0],[0,0],[0,0],[0,0]]}})",
            ErrorCode::WrongType);
        row("unknown choice", kHead + R"("emitter": {"shape": "cube"}})", ErrorCode::UnknownName);
        row("NaN", kHead + R"("motion": {"wind": NaN}})", ErrorCode::NotFinite);
        row("infinity", kHead + R"("motion": {"wind": Infinity}})", ErrorCode::NotFinite);
        row("1e999", kHead + R"("motion": {"wind": 1e999}})", ErrorCode::NotFinite);
        row("too large for a float", kHead + R"("motion": {"wind": 1e200}})", ErrorCode::NotFinite);
        row("version 3", R"({"format": "fumage-preset", "version": 3})", ErrorCode::WrongVersion);
        row("no layers", R"({"format": "fumage-preset", "version": 2, "layers": []})", ErrorCode::OutOfRange);
        row("layers are an object", R"({"format": "fumage-preset", "version": 2, "layers": {}})", ErrorCode::WrongType);
        row("a layer is a number", R"({"format": "fumage-preset", "version": 2, "layers": [1]})", ErrorCode::WrongType);
        row("the scene is a list", R"({"format": "fumage-preset", "version": 2, "scene": []})", ErrorCode::WrongType);
        row("a group of the scene is a number", R"({"format": "fumage-preset", "version": 2, "scene": {"air": 1}})",
            ErrorCode::WrongType);
        row("version 0", R"({"format": "fumage-preset", "version": 0})", ErrorCode::WrongVersion);
        row("version missing", R"({"format": "fumage-preset"})", ErrorCode::WrongVersion);
        row("version is text", R"({"format": "fumage-preset", "version": "1"})", ErrorCode::WrongVersion);
        row("not UTF-8", kHead + "\"name\": \"\xff\xfe\"}", ErrorCode::NotUtf8);
        row("a zero byte and rubbish behind the end", formatPreset({}) + std::string("\0rubbish", 8),
            ErrorCode::Syntax);
        row("a zero byte in the middle", kHead + std::string("\0", 1) + "\"name\": \"x\"}", ErrorCode::Syntax);
        row("deep", std::string(1000, '['), ErrorCode::TooDeep);
        row(
            "deep objects",
            [] {
                std::string s;
                for (int i = 0; i < 1000; ++i) {
                    s += "{\"a\":";
                }
                return s;
            }(),
            ErrorCode::TooDeep);
        row("10 MB of brackets", std::string(10'000'000, '['), ErrorCode::TooLarge);
    }
    void badInputIsRefused()
    {
        QFETCH(QByteArray, json);
        QFETCH(int, code);
        QCOMPARE(int(codeOf(json.toStdString())), code);
    }

    void utf16IsNamed()
    {
        const QString json = QString::fromStdString(formatPreset({}));
        const std::string plain(reinterpret_cast<const char*>(json.utf16()), static_cast<std::size_t>(json.size()) * 2);
        std::string swapped = plain;
        for (std::size_t i = 0; i < swapped.size(); i += 2) {
            std::swap(swapped[i], swapped[i + 1]);
        }
        for (const std::string& text : {plain, swapped, "\xFF\xFE" + plain, "\xFE\xFF" + swapped}) {
            const Error error = parsePreset(text).error();
            QCOMPARE(error.code, ErrorCode::NotUtf8);
            QVERIFY2(error.text().find("UTF-16") != std::string::npos, error.text().c_str());
        }
        QVERIFY(parsePreset("\xEF\xBB\xBF" + formatPreset({})).ok());
    }

    void utf32IsNamed()
    {
        std::string little;
        std::string big;
        for (const char letter : formatPreset({})) {
            little += std::string(1, letter) + std::string(3, '\0');
            big += std::string(3, '\0') + std::string(1, letter);
        }
        for (const std::string& text :
            {little, big, std::string("\xFF\xFE\0\0", 4) + little, std::string("\0\0\xFE\xFF", 4) + big}) {
            const Error error = parsePreset(text).error();
            QCOMPARE(error.code, ErrorCode::NotUtf8);
            QVERIFY2(error.text().find("UTF-32") != std::string::npos, error.text().c_str());
        }
    }

    void whatWasFoundIsQuotedOnce()
    {
        for (const Parameter& parameter : parameterTable()) {
            if (parameter.kind == Kind::Choice) {
                continue;
            }
            const std::string name(parameter.name());
            const Error error = parsePreset(R"({"format": "fumage-preset", "version": 1, ")"
                + std::string(parameter.group()) + R"(": {")" + name + R"(": "5"}})")
                                    .error();
            QCOMPARE(error.code, ErrorCode::WrongType);
            QVERIFY2(error.text().find("found \"5\"") != std::string::npos, error.text().c_str());
        }
    }

    void everyPrefixOfAPresetIsAnError()
    {
        const std::string json = formatPreset({});
        for (std::size_t i = 0; i + 2 < json.size(); ++i) {
            const Result<PresetReading> reading = parsePreset(json.substr(0, i));
            QVERIFY(!reading.ok());
            QVERIFY(!reading.error().message.empty());
        }
    }

    void errorsHaveLineAndColumn()
    {
        const std::string json = "{\n  \"format\": \"fumage-preset\",\n  \"version\": 1,\n  \"motion\": {\n    "
                                 "\"\u00e5\": 1, \"wind\": \"fast\"\n  }\n}";
        QCOMPARE(parsePreset(json, "x.json").error().place.text(), std::string("x.json, line 5, column 21"));
        QCOMPARE(parsePreset("{\n  \"format\": tru\n}", "x.json").error().place.text(),
            std::string("x.json, line 2, column 16"));
    }

    void placesOfValuesAreTheirFirstCharacter()
    {
        const std::string text = "{\"a\": -1.5e3, \"b\\\"\": \"x\\\\\", \"c\": [true,null , 7]}";
        const JsonNode root = parseJson(text).value();
        const auto textOf = [&](const JsonNode& node) { return text.substr(node.begin, node.end - node.begin); };
        QCOMPARE(textOf(root), text);
        QCOMPARE(textOf(*root.find("a")), std::string("-1.5e3"));
        QCOMPARE(textOf(*root.find("b\"")), std::string("\"x\\\\\""));
        QCOMPARE(textOf(root.find("c")->items[0]), std::string("true"));
        QCOMPARE(textOf(root.find("c")->items[1]), std::string("null"));
        QCOMPARE(textOf(root.find("c")->items[2]), std::string("7"));
    }

    void builtinPresetsAreCanonicalAndClean()
    {
        const std::vector<LibraryEntry> entries = builtinPresets();
        QVERIFY(entries.size() >= 12);
        for (const LibraryEntry& entry : entries) {
            const Result<PresetReading> reading = loadPreset(entry);
            QVERIFY2(reading.ok(), entry.id.c_str());
            QVERIFY2(reading.value().warnings.empty(),
                reading.value().warnings.empty() ? "" : reading.value().warnings.front().text().c_str());
            QVERIFY(!reading.value().preset.name.empty() && !reading.value().preset.description.empty());
        }
    }

    void theDefaultPresetIsANewDocument()
    {
        const Preset preset = newPreset();
        QVERIFY(preset.scene.effect() == loadPreset(std::string("default")).value().preset.scene.effect());
        QVERIFY(preset.scene.air.enabled);
        QVERIFY(preset.name.empty() && preset.description.empty());
    }

    void theThesisPresetIsTheSource()
    {
        const Effect e = loadPreset(std::string("thesis-2012")).value().preset.scene.effect();
        QCOMPARE(e.emitter.shape, EmitterShape::Rectangle);
        QCOMPARE(e.emitter.speed, 1.0F);
        QCOMPARE(e.emitter.velocityRandomness, 1.0F);
        QCOMPARE(e.emitter.count, 5000);
        QCOMPARE(e.motion.randomness, 1.0F);
        QCOMPARE(e.motion.rotation, 0.0F);
        QCOMPARE(e.life.initialAlpha, 0.1F);
        QCOMPARE(e.look.opacity, 1.0F); // what is seen of a particle is A(t) of eq. XIII
        QCOMPARE(e.noise.basis, NoiseBasis::Lattice);
        for (const float zero : {e.emitter.spread, e.motion.drag, e.motion.buoyancy, e.motion.pull, e.wind.gust,
                 e.turbulence.strength, e.vortex.strength, e.rings.strength, e.look.roll, e.life.lifetimeVariance,
                 e.look.sizeVariance, e.look.spin, e.look.spinVariance, e.look.stretch, e.look.erosion, e.look.dilution,
                 e.glow.emission, e.noise.warp}) {
            QCOMPARE(zero, 0.0F);
        }
        const NoiseTile tile = bakeNoise(e.noise, 128, 0.0F).value();
        const tests::Moments greys = tests::Moments::of(tile.values);
        QVERIFY(
            std::sqrt(greys.variance) > 0.2 && std::sqrt(greys.variance) < 0.35); // of 0.5 in a tile of black and white
        QVERIFY(!e.emitter.subframe);
        QCOMPARE(e.look.mask, MaskShape::Square);
    }

    void unknownNamesAreAnsweredWithTheNearest()
    {
        const Error error = loadPreset(std::string("campfir")).error();
        QCOMPARE(error.code, ErrorCode::UnknownName);
        QVERIFY(error.remedy.text().find("campfire") != std::string::npos);
    }

    void savingToAnUnwritablePlaceKeepsWhatIsThere()
    {
        const QTemporaryDir folder;
        const std::string path = folder.path().toStdString() + "/p.json";
        QVERIFY(writePresetFile(path, Preset{}).ok());
        QVERIFY(readPresetFile(path).ok());
        QCOMPARE(writePresetFile(folder.path().toStdString() + "/none/p.json", Preset{}).error().code,
            ErrorCode::FileNotFound);
    }

    void userPresetsAreFoundInTheirFolder()
    {
        const QTemporaryDir folder;
        const std::string presets = folder.path().toStdString() + "/fumage/presets";
        std::filesystem::create_directories(presets);
        QVERIFY(writePresetFile(presets + "/mine.json", Preset{}).ok());
        qputenv("XDG_DATA_HOME", folder.path().toUtf8());
        QCOMPARE(userPresetFolder(), std::filesystem::path(presets));
        QCOMPARE(presetsIn(userPresetFolder()).size(), std::size_t(1));
        QVERIFY(loadPreset(std::string("mine")).ok());
        qputenv("XDG_DATA_HOME", "relative");
        qputenv("HOME", folder.path().toUtf8());
        QCOMPARE(
            userPresetFolder(), std::filesystem::path(folder.path().toStdString()) / ".local/share/fumage/presets");
        qputenv("HOME", "");
        QVERIFY(userPresetFolder().empty());
        QVERIFY(presetsIn(userPresetFolder()).empty());
        qunsetenv("XDG_DATA_HOME");
    }

    void schemaIsJson() { QVERIFY(parseJson(presetSchema()).ok()); }
};

QTEST_GUILESS_MAIN(PresetTest)
#include "preset_test.moc"
