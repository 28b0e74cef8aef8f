// What the table of export options promises: one text for lists of jobs, manifests and the command line.
#include "tests/export/small_smoke.h"
#include "tests/helpers.h"

#include "core/export/export_option_table.h"
#include "core/export/jobs/job_file.h"
#include "core/export/manifest/manifest_settings.h"
#include "core/export/manifest/recorded.h"
#include "core/export/sheets/sheet_note.h"
#include "core/export/shown.h"

#include <set>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A text of an option that is not the one of a new plan.
std::string otherText(const ExportOption& option, const ExportPlan& plan)
{
    const std::string now = option.text(plan).value_or(std::string());
    const auto isOther = [&](const std::string& text) { return text != now; };
    if (option.choices != nullptr) {
        const std::vector<std::string> all = option.choices();
        return *std::ranges::find_if(all, isOther);
    }
    switch (option.form) {
    case OptionForm::Flag: return now == "true" ? "false" : "true";
    case OptionForm::Whole: return std::to_string(static_cast<int>(option.low) + 3);
    case OptionForm::Number: return "0.25";
    case OptionForm::Points: return "[[0, 0], [0.5, 0.75], [1, 1]]";
    case OptionForm::List: return "masks=shadow,0,motion.r@1/4";
    case OptionForm::Path: return "/nowhere/röd";
    case OptionForm::Text: break;
    }
    return option.key == "frame_rate" ? "24000/1001" : "colour,motion";
}

ExportPlan planOf(ExportKind kind)
{
    ExportPlan plan;
    plan.kind = kind;
    plan.output = "a.png";
    plan.project = Preset();
    return plan;
}

/// Every kind with every option that it asks for.
void forAll(const std::function<void(const ExportOption&, const ExportPlan&)>& look)
{
    for (std::size_t kind = 0; kind < kExportKinds; ++kind) {
        const ExportPlan plan = planOf(static_cast<ExportKind>(kind));
        for (const ExportOption& option : exportOptions()) {
            if (option.applies(plan)) {
                look(option, plan);
            }
        }
    }
}

} // namespace

class ExportOptionTest : public QObject {
    Q_OBJECT

private slots:
    void namesAreNamesOfOne()
    {
        std::set<std::string> names;
        for (const ExportOption& option : exportOptions()) {
            QVERIFY2(names.insert(std::string(option.key)).second, option.key.data());
            QVERIFY2(names.insert(flagOf(option)).second, option.key.data());
            QCOMPARE(&exportOption(option.key), &option);
        }
        QCOMPARE(flagOf(exportOption("power_of_two")), std::string("--power-of-two"));
    }

    void everyOptionIsAskedForBySomeKind()
    {
        std::set<std::string_view> asked;
        forAll([&](const ExportOption& option, const ExportPlan&) { asked.insert(option.key); });
        QCOMPARE(asked.size(), exportOptions().size());
    }

    void whatIsReadIsWritten()
    {
        forAll([](const ExportOption& option, ExportPlan plan) {
            const std::string text = otherText(option, plan);
            QVERIFY2(option.read(text, plan), option.key.data());
            QVERIFY2(option.text(plan) == text, option.key.data());
        });
    }

    void allChoicesAreTaken()
    {
        forAll([](const ExportOption& option, ExportPlan plan) {
            for (const std::string& text : option.choices != nullptr ? option.choices() : std::vector<std::string>()) {
                QVERIFY2(option.read(text, plan) && option.text(plan) == text, text.c_str());
            }
            if (option.choices != nullptr) {
                QCOMPARE(option.read("no such name", plan).error().code, ErrorCode::UnknownName);
            }
        });
    }

    void numbersBeyondTheirBoundsAreRefused()
    {
        forAll([](const ExportOption& option, ExportPlan plan) {
            if (option.form != OptionForm::Whole && option.form != OptionForm::Number) {
                return;
            }
            const std::string before = option.text(plan).value_or(std::string());
            const std::string above = QString::number(option.high * 2 + 1).toStdString();
            const std::string below = QString::number(option.low - 1).toStdString();
            for (const std::string& text : {above, below, std::string("nan"), std::string("one"), std::string()}) {
                QVERIFY2(!option.read(text, plan), (std::string(option.key) + " takes " + text).c_str());
            }
            QCOMPARE(option.text(plan).value_or(std::string()), before);
        });
    }

    void listsOfJobsKeepEveryOption()
    {
        forAll([](const ExportOption& option, ExportPlan plan) {
            const std::string text = otherText(option, plan);
            QVERIFY(option.read(text, plan));
            const std::optional<ExportPlan> again = parsePlan(formatPlan(plan));
            QVERIFY2(again, option.key.data());
            QVERIFY2(option.text(*again) == text, option.key.data());
        });
    }

    void manifestsKeepEverySetting()
    {
        for (const ExportKind kind : {ExportKind::Sequence, ExportKind::Flipbook}) {
            for (const ExportOption& option : exportOptions()) {
                ExportPlan plan = planOf(kind);
                if (option.setting.empty() || !option.applies(plan)) {
                    continue;
                }
                const std::map<std::string, std::string> usual = settingsOf(plan);
                const std::string text = otherText(option, plan);
                QVERIFY(option.read(text, plan));
                const std::map<std::string, std::string> settings = settingsOf(plan);
                QVERIFY2(settings != usual, option.key.data()); // a manifest tells the two apart
                ExportPlan again = planOf(kind);
                QVERIFY2(readSettings(settings, again), option.key.data());
                QVERIFY2(option.text(again) == text, option.key.data());
                QVERIFY(settingsOf(again) == settings);
            }
        }
    }

    /// A sheet that is opened and made again is made with all that it was made with.
    void picturesKeepEverySettingOfTheirSheet()
    {
        for (const ExportOption& option : exportOptions()) {
            ExportPlan plan = planOf(ExportKind::Flipbook);
            if (option.setting.empty() || !option.applies(plan)) {
                continue;
            }
            const std::string text = otherText(option, plan);
            QVERIFY(option.read(text, plan));
            const std::optional<FlipbookOptions> sheet = readSheetNote(sheetNoteOf(flipbookOf(plan)));
            QVERIFY2(sheet, option.key.data());
            ExportPlan again;
            takeSheet(*sheet, again);
            QVERIFY2(option.text(again) == text, option.key.data());
        }
    }

    void manifestsThatLackASettingMeanWhatTheTableSays()
    {
        const std::map<std::string, std::string> whole = settingsOf(planOf(ExportKind::Flipbook));
        for (const ExportOption& option : exportOptions()) {
            std::map<std::string, std::string> settings = whole;
            if (settings.erase(std::string(option.setting)) == 0) {
                continue;
            }
            for (const bool isEmpty : {false, true}) {
                if (isEmpty) {
                    settings[std::string(option.setting)]; // a setting without a text says no more
                }
                ExportPlan plan = planOf(ExportKind::Flipbook);
                QCOMPARE(readSettings(settings, plan).ok(), option.unsaid.has_value());
                QVERIFY(!option.unsaid || option.text(plan).value_or(std::string()) == *option.unsaid);
            }
        }
    }
};

QTEST_GUILESS_MAIN(ExportOptionTest)
#include "export_option_test.moc"
