// What version 1 of the format has left behind: presets, and what they stand in. It opens for ever.

#include "core/system/file.h"
#include "core/effect/parameter_table.h"
#include "core/effect/assignment.h"
#include "core/effect/value.h"
#include "core/export/jobs/job_file.h"
#include "core/export/manifest/manifest.h"
#include "core/preset/json_tree.h"
#include "core/preset/preset_file.h"

#include <QDir>
#include <QtTest/QtTest>

using namespace fumage;

namespace {

const std::string kVersion1 = FUMAGE_VERSION_1;

PresetReading readingOf(const std::string& file)
{
    Result<PresetReading> reading = readPresetFile(kVersion1 + file);
    if (!reading) {
        qFatal("%s", reading.error().text().c_str());
    }
    return std::move(reading).value();
}

/// Writes a value as its row does now, once without what is only spacing.
std::string packed(std::string text)
{
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    return text;
}

const Parameter* rowOf(const std::string& key)
{
    const Parameter* parameter = findParameter(key);
    return parameter != nullptr ? parameter : findFormerParameter(key);
}

} // namespace

class MigrationTest : public QObject {
    Q_OBJECT

private slots:
    void presetsKeepEveryValue_data()
    {
        QTest::addColumn<QString>("file");
        for (const QString& file : QDir(QString::fromStdString(kVersion1 + "presets")).entryList(QDir::Files)) {
            QTest::newRow(qPrintable(file)) << file;
        }
    }
    void presetsKeepEveryValue()
    {
        QFETCH(QString, file);
        const std::string path = "presets/" + file.toStdString();
        const PresetReading reading = readingOf(path);
        QVERIFY(reading.warnings.empty());
        QVERIFY(reading.preset.unknown.empty());
        const std::string text = readFile(kVersion1 + path, kMaxPresetBytes).value();
        const Result<JsonNode> root = parseJson(text);
        QVERIFY(root.ok());
        QCOMPARE(root.value().find("version")->number, 1.0);
        QCOMPARE(reading.preset.name, root.value().find("name")->string);
        QCOMPARE(reading.preset.description, root.value().find("description")->string);
        int values = 0;
        for (std::size_t group = 0; group < root.value().items.size(); ++group) {
            const JsonNode& members = root.value().items[group];
            for (std::size_t i = 0; members.type == JsonNode::Type::Object && i < members.items.size(); ++i) {
                const Parameter* parameter = rowOf(root.value().keys[group] + "." + members.keys[i]);
                QVERIFY(parameter != nullptr);
                QCOMPARE(packed(formatJson(*parameter, parameter->get(reading.preset.scene.effect()))),
                    packed(text.substr(members.items[i].begin, members.items[i].end - members.items[i].begin)));
                ++values;
            }
        }
        QCOMPARE(values, 152);
        const Effect& effect = reading.preset.scene.effect();
        QCOMPARE(effect.air.buoyancy, effect.motion.buoyancy);
        QCOMPARE(effect.air.cooling, effect.motion.cooling);
        QCOMPARE(effect.air.drag, effect.motion.drag);
    }

    void everyFormerKeyIsReadAndAssigned()
    {
        int former = 0;
        for (const Parameter& parameter : parameterTable()) {
            if (parameter.formerly.empty()) {
                continue;
            }
            ++former;
            Effect other;
            const Value value = parameter.kind == Kind::Choice ? Value(1)
                : parameter.kind == Kind::Vector               ? Value(glm::vec3(0.5F, 1.25F, 2.0F))
                                                               : Value(0.75F);
            if (parameter.kind == Kind::Gradient) {
                other.glow.emissionGradient = Gradient{{0.0F, glm::vec3(0.25F)}};
            } else {
                setClamped(other, parameter, value);
            }
            const std::string text = formatJson(parameter, parameter.get(other));
            const std::string key(parameter.formerly);
            const std::size_t dot = key.find('.');
            const Result<PresetReading> read = parsePreset(R"({"format": "fumage-preset", "version": 1, )"
                + quoteJson(key.substr(0, dot)) + ": {" + quoteJson(key.substr(dot + 1)) + ": " + text + "}}");
            QVERIFY2(read.ok(), key.c_str());
            QVERIFY2(read.value().preset.unknown.empty(), key.c_str());
            QVERIFY2(parameter.get(read.value().preset.scene.effect()) == parameter.get(other), key.c_str());
            Effect assigned;
            QVERIFY2(applyAssignment(assigned,
                         key + "=" + (parameter.kind == Kind::Choice ? std::string(parameter.choices[1]) : text))
                         .ok(),
                key.c_str());
            QVERIFY2(parameter.get(assigned) == parameter.get(other), key.c_str());
        }
        QVERIFY(former > 15);
    }

    void presetsInPicturesAreRead_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("PNG") << "files/picture.png";
        QTest::newRow("EXR") << "files/picture.exr";
    }
    void presetsInPicturesAreRead()
    {
        QFETCH(QString, file);
        const PresetReading reading = readingOf(file.toStdString());
        QVERIFY(reading.warnings.empty());
        QCOMPARE(reading.frame, std::optional(3));
        QCOMPARE(reading.preset.scene.layers[0].emitter.count, 300);
        // All else is the preset that they were made of.
        Effect made = readingOf(file.endsWith("png") ? "presets/campfire.json" : "presets/thesis-2012.json")
                          .preset.scene.effect();
        made.emitter.count = 300;
        made.noise.slices = 4;
        made.noise.resolution = 16;
        made.air.resolution = reading.preset.scene.air.resolution;
        made.output.width = made.output.height = 16;
        for (const Parameter* parameter : differences(made, reading.preset.scene.effect())) {
            QFAIL(std::string(parameter->key).c_str());
        }
    }

    void jobListsAreRead()
    {
        const Result<JobsReading> jobs = readJobsFile(kVersion1 + "files/jobs.json");
        QVERIFY2(jobs.ok(), jobs ? "" : jobs.error().text().c_str());
        QCOMPARE(jobs.value().jobs.size(), std::size_t(1));
        QVERIFY(jobs.value().jobs.front().preset.scene.effect()
            == readingOf("presets/campfire.json").preset.scene.effect());
    }

    void manifestsAreRead()
    {
        const std::string path = kVersion1 + "files/picture.manifest.json";
        const Result<Manifest> manifest = parseManifest(readFile(path, kMaxPresetBytes).value(), path);
        QVERIFY2(manifest.ok(), manifest ? "" : manifest.error().text().c_str());
        QVERIFY(manifest.value().job.scene == readingOf("files/picture.png").preset.scene.effect());
    }

    void whatVersion1DoesNotKnowIsKept()
    {
        const Result<PresetReading> read =
            parsePreset(R"({"format": "fumage-preset", "version": 1, "later": [1], "motion": {"gusto": 2}, )"
                        R"("air": {"mist": 3}, "light": {"emission": 4, "laser": 5}})");
        QVERIFY(read.ok());
        QCOMPARE(read.value().preset.scene.layers[0].glow.emission, 4.0F);
        QCOMPARE(read.value().preset.unknown.size(), std::size_t(4));
        const std::string text = formatPreset(read.value().preset);
        const Result<PresetReading> again = parsePreset(text);
        QVERIFY(again.ok());
        QCOMPARE(again.value().preset.unknown.size(), std::size_t(4));
        QCOMPARE(formatPreset(again.value().preset), text);
    }

    void errorsNameWhereTheyAreInTheFile()
    {
        const std::string json =
            "{\n \"format\": \"fumage-preset\",\n \"version\": 1,\n \"motion\": {\n  \"wind\": \"fast\"\n }\n}";
        const Result<PresetReading> read = parsePreset(json, "old.json");
        QVERIFY(!read.ok());
        QVERIFY2(
            read.error().text().find("old.json, line 5, column 11") != std::string::npos, read.error().text().c_str());
    }

    void aNewerVersionIsRefusedWithBothNumbers()
    {
        const Result<PresetReading> read = parsePreset(R"({"format": "fumage-preset", "version": 3})");
        QVERIFY(!read.ok());
        QVERIFY(read.error().text().find("version 3") != std::string::npos);
        QVERIFY(read.error().text().find("up to 2") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(MigrationTest)
#include "migration_test.moc"
