// The files of one export against its manifest, whatever else lies in the folder.
#include "tests/export/small_smoke.h"
#include "tests/helpers.h"

#include "core/export/plan_check.h"

#include <QTemporaryDir>

#include <map>

using namespace fumage;
using namespace fumage::tests;

namespace {

using Found = std::map<FileState, std::vector<std::string>>;

ExportPlan recorded(ExportPlan plan)
{
    plan.recording.manifest = manifestBeside(plan.output);
    if (const auto done = runExport(smallSmoke(), plan); !done) {
        qFatal("%s", done.error().text().c_str());
    }
    return plan;
}

Found checked(const ExportPlan& plan)
{
    const Result<std::vector<CheckedFile>> files = checkExport(smallSmoke(), plan);
    if (!files) {
        qFatal("%s", files.error().text().c_str());
    }
    Found found;
    for (const CheckedFile& file : files.value()) {
        found[file.state].push_back(file.file);
    }
    return found;
}

} // namespace

class PlanCheckTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void filesOfEveryKindAreAsTheyWereWritten()
    {
        const ExportPlan frames = recorded({.output = at("röd/a_##.png"), .frames = {1, 5, 2}});
        const ExportPlan one = recorded({.kind = ExportKind::Picture,
            .output = at("one.exr"),
            .frames = {4, 9, 1},
            .format = ImageFormat::ExrHalf});
        const ExportPlan book = recorded({.kind = ExportKind::Flipbook,
            .output = at("book.png"),
            .frames = {0, 3, 1},
            .flipbook = {.columns = 2, .rows = 2}});
        QCOMPARE(manifestOf(frames).filename().string(), std::string("a.1-5x2.manifest.json"));
        QCOMPARE(manifestOf(one).filename().string(), std::string("one.4-4.manifest.json"));
        QCOMPARE(manifestOf(book).filename().string(), std::string("book.manifest.json"));
        QVERIFY((checked(frames) == Found{{FileState::Same, {"a_01.png", "a_03.png", "a_05.png"}}}));
        QVERIFY((checked(one) == Found{{FileState::Same, {"one.exr"}}}));
        QVERIFY((checked(book) == Found{{FileState::Same, {"book.flipbook.json", "book.png"}}}));
    }

    void whatHasChangedIsNamed()
    {
        const ExportPlan plan = recorded({.output = at("a_##.png"), .frames = {0, 40, 10}});
        std::filesystem::copy_file(at("a_00.png"), at("a_10.png"), std::filesystem::copy_options::overwrite_existing);
        std::filesystem::remove(at("a_20.png"));
        std::filesystem::resize_file(at("a_30.png"), std::filesystem::file_size(at("a_30.png")) / 2);
        QVERIFY((checked(plan)
            == Found{{FileState::Same, {"a_00.png", "a_40.png"}}, {FileState::Different, {"a_10.png"}},
                {FileState::Missing, {"a_20.png"}}, {FileState::Broken, {"a_30.png"}}}));
    }

    void theManifestOfAnotherExportSaysNothingOfThis()
    {
        const ExportPlan first = recorded({.output = at("a_##.png"), .frames = {0, 1, 1}});
        const ExportPlan second =
            recorded({.output = at("a_##.exr"), .frames = {0, 1, 1}, .format = ImageFormat::ExrHalf});
        QCOMPARE(manifestOf(first), manifestOf(second));
        QVERIFY((checked(first)[FileState::Extra] == std::vector<std::string>{"a_00.png", "a_01.png"}));
        QVERIFY(!checked(second).contains(FileState::Extra));
    }

    void aManifestThatIsGoneIsAnError()
    {
        const ExportPlan plan = recorded({.output = at("a_##.png"), .frames = {0, 1, 1}});
        std::filesystem::remove(manifestOf(plan));
        const Result<std::vector<CheckedFile>> files = checkExport(smallSmoke(), plan);
        QVERIFY(!files.ok());
        QCOMPARE(files.error().code, ErrorCode::FileNotFound);
    }

    void whatHasNoManifestWritesNone()
    {
        ExportPlan plan{.output = at("a.mp4")};
        QVERIFY(manifestOf(plan).empty());
        plan.recording.manifest = at("a.manifest.json");
        QVERIFY(!manifestOf(plan).empty());
        plan.kind = ExportKind::Video;
        QVERIFY(manifestOf(plan).empty());
    }

private:
    [[nodiscard]] std::filesystem::path at(const std::string& name) const
    {
        return std::filesystem::path(m_folder->path().toStdString()) / name;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(PlanCheckTest)
#include "plan_check_test.moc"
